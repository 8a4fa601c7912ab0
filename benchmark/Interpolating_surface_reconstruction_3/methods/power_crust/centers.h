// Copyright (c) 2026  The authors of Interpolating_surface_reconstruction_3.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s) : The authors of Interpolating_surface_reconstruction_3

#ifndef ISR_BENCHMARK_METHODS_POWER_CRUST_CENTERS_H
#define ISR_BENCHMARK_METHODS_POWER_CRUST_CENTERS_H

#include "../../models/model_files.h"

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

namespace isr_benchmark {
namespace power_crust {

// Centers of spheres through the vertices of a cell. Poles of regular samples lie close together, and
// cells of samples on a circle or of such poles are nearly flat: rounding would throw their centers
// anywhere. Intervals are enough for most cells, others are computed exactly.
class Centers
{
public:
  Centers() : m_precision(Exact::FT::get_relative_precision_of_to_double())
  {
    Exact::FT::set_relative_precision_of_to_double(1e-9);
  }
  ~Centers() { Exact::FT::set_relative_precision_of_to_double(m_precision); }
  Centers(const Centers&) = delete;
  Centers& operator=(const Centers&) = delete;

  template <typename CellHandle>
  Point circumcenter(CellHandle cell) const
  {
    return rounded(Exact().construct_circumcenter_3_object()(at(cell, 0), at(cell, 1), at(cell, 2), at(cell, 3)));
  }

  template <typename CellHandle>
  Point weighted_circumcenter(CellHandle cell) const
  {
    return rounded(
      Exact().construct_weighted_circumcenter_3_object()(at(cell, 0), at(cell, 1), at(cell, 2), at(cell, 3)));
  }

private:
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

  template <typename CellHandle>
  static auto at(CellHandle cell, int i)
  {
    return CGAL::Cartesian_converter<Kernel, Exact>()(cell->vertex(i)->point());
  }

  static Point rounded(const Exact::Point_3& p)
  {
    return Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  double m_precision;
};

} // namespace power_crust
} // namespace isr_benchmark

#endif // ISR_BENCHMARK_METHODS_POWER_CRUST_CENTERS_H

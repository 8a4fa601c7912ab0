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

#ifndef ISR_BENCHMARK_METHODS_LIS_H
#define ISR_BENCHMARK_METHODS_LIS_H

#include "../models/oriented_points.h"
#include "Method.h"

#include <CGAL/lis_reconstruction.h>

#include <cstddef>

namespace isr_benchmark {

class Lis : public Method
{
public:
  explicit Lis(bool keep_boundaries = false) : m_keep_boundaries(keep_boundaries) { }

  std::string key() const override { return "lis"; }
  std::string title() const override { return "LIS"; }
  std::string description() const override
  {
    return "CGAL::lis_reconstruction() with its defaults; normals as given, else those of a "
           "surface by CTC, which is part of its time";
  }
  bool is_ours() const override { return true; }
  bool uses_threads() const override { return true; }

  Reconstruction operator()(const Model& model, std::size_t threads) const override
  {
    const auto common = CGAL::parameters::keep_boundaries(m_keep_boundaries);
    return with_threads(threads, [&](auto tag) {
      Reconstruction result;
      if (model.normals.empty()) {
        CGAL::lis_reconstruction<decltype(tag)>(model.points, result.vertices, result.triangles, common);
        return result;
      }
      CGAL::lis_reconstruction<decltype(tag)>(oriented_points(model), result.vertices, result.triangles,
                                              CGAL::parameters::combine(common, oriented_point_parameters()));
      return result;
    });
  }

private:
  bool m_keep_boundaries;
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_METHODS_LIS_H

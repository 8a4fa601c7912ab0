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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABELLED_SURFACE_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABELLED_SURFACE_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/label_minimum_cut.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelling_repair.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Changes labels where the surface between them is no manifold, and nowhere else, whatever that loses; it may remain so
// at some points. `cancellation_point()` is called again and again and may throw.
template <typename CancellationPoint>
void repair_labels(const Cell_complex& cells, Oriented_labelling& labelling, CancellationPoint& cancellation_point)
{
  Labelling_repair<Oriented_labelling> repair(
    cells, labelling, [](Point_index) { return true; }, (std::numeric_limits<double>::max)(), true, cancellation_point);
  repair(cancellation_point);
  repair.untangle(cancellation_point);
}

// Changes labels until the surface between them is a manifold at nearly all points, whatever that loses.
// `cancellation_point()` is called again and again and may throw.
template <typename CancellationPoint>
Labelling_repair<Oriented_labelling> make_nearly_manifold(const Cell_complex& cells, Oriented_labelling& labelling,
                                                          CancellationPoint& cancellation_point)
{
  Labelling_repair<Oriented_labelling> repair(
    cells, labelling, [](Point_index) { return true; }, (std::numeric_limits<double>::max)(), true, cancellation_point);
  repair(cancellation_point);
  Label_minimum_cut cut(cells, labelling);
  cut(repair, cancellation_point);
  repair.untangle(cancellation_point);
  return repair;
}

// The same at all points. It may leave some out, but only those at which nothing else helps.
template <typename CancellationPoint>
void make_manifold(const Cell_complex& cells, Oriented_labelling& labelling, CancellationPoint& cancellation_point)
{
  make_nearly_manifold(cells, labelling, cancellation_point).enforce(cancellation_point);
}

// The surface between inside and outside, counterclockwise as seen from the outside.
// `cancellation_point()` is called again and again and may throw.
template <typename CancellationPoint>
std::vector<std::array<Point_index, 3> > facets_between_labels(const Cell_complex& cells,
                                                               const Oriented_labelling& labelling,
                                                               CancellationPoint& cancellation_point)
{
  std::vector<std::array<Point_index, 3> > triangles;
  for (std::size_t c = 0; c != cells.size(); ++c)
    for (std::size_t i = 0; i != 4; ++i) {
      cancellation_point();
      const auto cell = static_cast<Cell_complex::Cell_index>(c);
      if (!labelling.label(cell) || !labelling.is_surface(cell, i))
        continue;
      std::array<Point_index, 3> t = Cell_complex::facet(cells[c], i);
      if (i % 2 != 0)
        std::swap(t[1], t[2]);
      triangles.push_back(t);
    }
  return triangles;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABELLED_SURFACE_H

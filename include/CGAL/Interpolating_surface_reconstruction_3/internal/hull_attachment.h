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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_HULL_ATTACHMENT_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_HULL_ATTACHMENT_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/hull_facets.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Attaches the convex hull of all points if the surface has no triangle: of a few points, such as the corners of a
// tetrahedron, no star may be closed, and no two stars may agree. Points inside of the hull are left to the insertion of
// points. Nothing is attached to points in one plane. Returns whether it has attached anything; loops and fans are left to
// the closing of holes. Ends early if cancelled.
template <typename Builder, typename Progress, typename OnVerdict>
bool attach_hull_if_empty(const std::vector<Local_point>& points, Builder& builder, Progress& progress,
                          const OnVerdict& on_verdict)
{
  const std::vector<Point_index> open_points = builder.open_points();
  const auto is_bare = [&](Point_index p) { return builder.corners(p).empty(); };
  if (open_points.size() != points.size() || !std::all_of(open_points.begin(), open_points.end(), is_bare))
    return false;
  bool is_changed = false;
  Cancellation_point<Progress> cancellation_point(progress);
  try {
    std::vector<Point_index> all(points.size());
    std::iota(all.begin(), all.end(), Point_index(0));
    const Cell_complex cells(points, std::move(all), cancellation_point);
    for (const std::array<Point_index, 3>& t : hull_facets(cells)) {
      cancellation_point();
      const Triangle_verdict verdict = builder.try_add(t[0], t[1], t[2]);
      is_changed = is_changed || verdict == Triangle_verdict::ADDED;
      on_verdict(t, verdict);
    }
  } catch (const Cancelled&) {
  }
  return is_changed;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_HULL_ATTACHMENT_H

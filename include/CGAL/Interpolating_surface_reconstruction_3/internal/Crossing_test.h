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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CROSSING_TEST_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CROSSING_TEST_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_intersection.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Whether a few triangles can be attached without crossing the surface near them. Surface_crossings finds all crossings
// of many triangles.
template <typename Builder>
class Crossing_test
{
public:
  using Triangle = typename Builder::Triangle;

  Crossing_test(const std::vector<Local_point>& points, const Point_octree_3& octree, const Builder& builder)
    : m_points(points), m_octree(octree), m_builder(builder)
  { }

  // Whether one of the triangles is degenerate or crosses another one, or one of the surface with `stays(triangle)` that
  // has a vertex in their box; also if there are so many points in it that this would take long.
  template <typename Triangles, typename Stays>
  bool operator()(const Triangles& triangles, const Stays& stays)
  {
    for (auto t = triangles.begin(); t != triangles.end(); ++t)
      if (is_collinear(*t) || std::any_of(triangles.begin(), t, [&](const Triangle& s) { return do_cross(s, *t); }))
        return true;
    Local_box box;
    for (const Triangle& t : triangles)
      for (Point_index p : t)
        box.include(m_points[p]);
    const auto is_crossing = [&](const Triangle& t) {
      return stays(t) && !is_collinear(t) &&
             std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& s) { return do_cross(s, t); });
    };
    bool result = false;
    std::size_t points = 0;
    m_octree.for_each_leaf_overlapping(box, m_stack, [&](const Point_octree_3::Node& leaf) {
      for (Point_index p = leaf.begin; p != leaf.end && !result; ++p)
        if (box.contains(m_points[p])) {
          result = ++points > MAXIMUM_POINTS;
          m_builder.for_each_triangle_at(p, [&](const Triangle& t) {
            // Once: at its smallest vertex in the box.
            if (result ||
                std::any_of(t.begin(), t.end(), [&](Point_index q) { return q < p && box.contains(m_points[q]); }))
              return;
            ++m_tests;
            result = is_crossing(t);
          });
        }
      return !result;
    });
    return result;
  }

  // Microseconds that the tests since the last call may have taken.
  std::size_t take_microseconds() { return MICROSECONDS_PER_TEST * std::exchange(m_tests, 0); }

private:
  // The box has few but on a lid over other parts of the surface.
  static constexpr std::size_t MAXIMUM_POINTS = 256;

  // Of some pairs of triangles, whose rounded coordinates may not tell whether they cross.
  static constexpr std::size_t MICROSECONDS_PER_TEST = 4;

  bool do_cross(const Triangle& s, const Triangle& t) const
  {
    return do_triangles_cross(s, t, [&](Point_index p) { return exact_point(m_points[p]); });
  }

  // As only predicates that are not exact take for a triangle, or with rounded positions.
  bool is_collinear(const Triangle& t) const
  {
    return collinear(exact_point(m_points[t[0]]), exact_point(m_points[t[1]]), exact_point(m_points[t[2]]));
  }

  const std::vector<Local_point>& m_points;
  const Point_octree_3& m_octree;
  const Builder& m_builder;
  std::vector<std::uint32_t> m_stack;
  std::size_t m_tests = 0; // triangles of the surface that were looked at
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CROSSING_TEST_H

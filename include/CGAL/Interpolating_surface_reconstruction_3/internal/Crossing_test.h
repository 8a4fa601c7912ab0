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
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Whether a few triangles can be attached without crossing the surface. Surface_crossings finds all crossings of many
// triangles. Of each node of the octree, the longest edge at its points is kept, so that no triangle near is missed.
template <typename Builder>
class Crossing_test
{
public:
  using Triangle = typename Builder::Triangle;

  Crossing_test(const std::vector<Local_point>& points, const Point_octree_3& octree, const Builder& builder)
    : m_points(points), m_octree(octree), m_builder(builder)
  { }

  // Forgets the surface, which may have changed.
  void reset() { m_reaches.clear(); }

  // Must know of the triangles that are attached after a test.
  void attach(const Triangle& t)
  {
    if (m_reaches.empty())
      return;
    for (std::size_t i = 0; i != 3; ++i) {
      const Local_point& p = m_points[t[i]];
      reach_from(m_octree.leaf_of(t[i]),
                 (std::max)(distance(p, m_points[t[(i + 1) % 3]]), distance(p, m_points[t[(i + 2) % 3]])));
    }
  }

  // Whether one of the triangles is degenerate or crosses another one, or one of the surface with `stays(triangle)`; also
  // if so many points may have triangles there that this would take long.
  template <typename Triangles, typename Stays>
  bool operator()(const Triangles& triangles, const Stays& stays)
  {
    for (auto t = triangles.begin(); t != triangles.end(); ++t)
      if (is_collinear(*t) || std::any_of(triangles.begin(), t, [&](const Triangle& s) { return do_cross(s, *t); }))
        return true;
    Local_box box;
    m_boxes.clear();
    for (const Triangle& t : triangles) {
      m_boxes.push_back(box_of(t));
      box.include(m_boxes.back());
    }
    bool result = false;
    std::size_t points = 0;
    for_each_point_near(box, [&](Point_index p) {
      result = ++points > MAXIMUM_POINTS;
      m_builder.for_each_triangle_at(p, [&](const Triangle& t) {
        // Once: at its smallest vertex.
        if (!result && p < t[1] && p < t[2] && stays(t))
          result = crosses(t, triangles);
      });
      return !result;
    });
    return result;
  }

  // Of a pair of triangles, whose rounded coordinates may not tell whether they cross.
  static constexpr std::size_t MICROSECONDS_PER_PAIR = 4;

  // The number of pairs of triangles that were looked at since the last call.
  std::size_t take_pairs() { return std::exchange(m_pairs, 0); }

private:
  // There are few but on a lid over other parts of the surface.
  static constexpr std::size_t MAXIMUM_POINTS = 1024;

  // Of sums and differences of local coordinates, which are not larger than one.
  static constexpr double ROUNDING = 4. * (std::numeric_limits<double>::epsilon)();

  // Whether the triangle of the surface crosses one of those whose boxes are known.
  template <typename Triangles>
  bool crosses(const Triangle& t, const Triangles& triangles)
  {
    const Local_box box = box_of(t);
    auto box_of_other = m_boxes.begin();
    bool is_first = true;
    for (const Triangle& s : triangles)
      if ((box_of_other++)->overlaps(box)) {
        ++m_pairs;
        if (std::exchange(is_first, false) && is_collinear(t))
          return false;
        if (do_cross(s, t))
          return true;
      }
    return false;
  }

  // Calls visit(p) for the points that may have triangles whose boxes overlap the box, until it returns false.
  template <typename Visit>
  void for_each_point_near(const Local_box& box, const Visit& visit)
  {
    if (m_reaches.empty())
      find_reaches();
    m_octree.for_each_leaf(
      m_stack, [&](std::uint32_t i) { return m_octree.node(i).box.overlaps(box.enlarged(m_reaches[i])); },
      [&](std::uint32_t i) {
        const Local_box enlarged = box.enlarged(m_reaches[i]);
        for (Point_index p = m_octree.node(i).begin; p != m_octree.node(i).end; ++p)
          if (enlarged.contains(m_points[p]) && !visit(p))
            return false;
        return true;
      });
  }

  void find_reaches()
  {
    m_reaches.assign(m_octree.nodes().size(), 0.);
    for (std::uint32_t leaf : m_octree.leaves()) {
      double longest = 0.;
      for (Point_index p = m_octree.node(leaf).begin; p != m_octree.node(leaf).end; ++p)
        m_builder.for_each_triangle_at(p, [&](const Triangle& t) {
          longest =
            (std::max)({ longest, distance(m_points[p], m_points[t[1]]), distance(m_points[p], m_points[t[2]]) });
        });
      reach_from(leaf, longest);
    }
  }

  void reach_from(std::uint32_t leaf, double reach)
  {
    for (std::uint32_t i = leaf; m_reaches[i] < reach; i = m_octree.node(i).parent)
      m_reaches[i] = reach;
  }

  // Along an axis.
  static double distance(const Local_point& p, const Local_point& q)
  {
    const Local_vector d = q - p;
    return (std::max)({ std::abs(d.x()), std::abs(d.y()), std::abs(d.z()) }) + ROUNDING;
  }

  Local_box box_of(const Triangle& t) const
  {
    Local_box result;
    for (Point_index p : t)
      result.include(m_points[p]);
    return result;
  }

  bool do_cross(const Triangle& s, const Triangle& t) const
  {
    return do_triangles_cross(s, t, [&](Point_index p) { return exact_point(m_points[p]); });
  }

  // Also as rounding has made it.
  bool is_collinear(const Triangle& t) const
  {
    return is_degenerate(t, [&](Point_index p) { return exact_point(m_points[p]); });
  }

  const std::vector<Local_point>& m_points;
  const Point_octree_3& m_octree;
  const Builder& m_builder;
  std::vector<double> m_reaches; // of the nodes, if they have been found
  std::vector<std::uint32_t> m_stack;
  std::vector<Local_box> m_boxes; // of the triangles to be attached
  std::size_t m_pairs = 0;        // of triangles that were looked at
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CROSSING_TEST_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STEEP_SEARCH_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STEEP_SEARCH_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Looks for points that are steep over or below a plane: half a right angle or more, as seen from a point of it. Boxes of
// the octree that are flat or far are left out. One object serves one thread.
class Steep_search
{
public:
  Steep_search(const std::vector<Local_point>& points, const Point_octree_3& octree)
    : m_points(points), m_octree(octree)
  { }

  // Whether there is one within the radius of p, for the plane through p with the unit normal.
  bool operator()(Point_index p, const Local_vector& normal, double squared_radius)
  {
    m_nodes.assign(1, 0);
    while (!m_nodes.empty()) {
      const Point_octree_3::Node& n = m_octree.node(m_nodes.back());
      m_nodes.pop_back();
      if (!may_have_any(n.box, m_points[p], normal, squared_radius))
        continue;
      for (std::uint32_t c = 0; c != n.number_of_children; ++c)
        m_nodes.push_back(n.first_child + c);
      if (n.number_of_children == 0 && has_any(n, p, normal, squared_radius))
        return true;
    }
    return false;
  }

private:
  static bool is_steep(double height, double squared_distance) { return 2. * height * height >= squared_distance; }

  // Whether the box is near enough, and its nearest point would be steep if it were as high as the highest one.
  static bool may_have_any(const Local_box& box, const Local_point& p, const Local_vector& normal,
                           double squared_radius)
  {
    double low = 0., high = 0.;
    for (int a = 0; a != 3; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      const double at_low = normal[a] * (box.low[axis] - p[a]), at_high = normal[a] * (box.high[axis] - p[a]);
      low += (std::min)(at_low, at_high);
      high += (std::max)(at_low, at_high);
    }
    const double squared_distance = box.squared_distance(p);
    return squared_distance <= squared_radius && is_steep((std::max)(high, -low), squared_distance);
  }

  bool has_any(const Point_octree_3::Node& leaf, Point_index p, const Local_vector& normal, double squared_radius) const
  {
    for (Point_index q = leaf.begin; q != leaf.end; ++q) {
      const Local_vector v = m_points[q] - m_points[p];
      const double squared_distance = v.squared_length();
      if (q != p && squared_distance <= squared_radius && is_steep(normal * v, squared_distance))
        return true;
    }
    return false;
  }

  const std::vector<Local_point>& m_points;
  const Point_octree_3& m_octree;
  std::vector<std::uint32_t> m_nodes; // still to be looked at
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STEEP_SEARCH_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_NEAREST_SEARCH_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_NEAREST_SEARCH_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The nearest neighbors of a single point, nearest boxes of the octree first. The time does not depend
// on how many points there are at about the same distance. One object serves one thread.
class Nearest_search
{
public:
  // A squared distance and an index; among points at the same distance the smaller index is nearer.
  using Neighbor = std::pair<double, Point_index>;

  Nearest_search(const std::vector<Local_point>& points, const Point_octree_3& octree)
    : m_points(points), m_octree(octree)
  { }

  // The neighbors of p within the radius by increasing distance, at most `size` of them.
  const std::vector<Neighbor>& operator()(Point_index p, std::size_t size, double squared_radius)
  {
    m_nearest.clear();
    m_nodes.clear();
    m_center = p;
    if (size != 0)
      push(0);
    while (!m_nodes.empty()) {
      std::pop_heap(m_nodes.begin(), m_nodes.end(), is_farther);
      const Found_node next = m_nodes.back();
      m_nodes.pop_back();
      if (next.squared_distance > squared_radius || (m_nearest.size() == size && is_behind(next)))
        break;
      visit(m_octree.node(next.node), size, squared_radius);
    }
    std::sort_heap(m_nearest.begin(), m_nearest.end());
    return m_nearest;
  }

private:
  struct Found_node
  {
    double squared_distance;
    Point_index begin;
    std::uint32_t node;
  };

  static bool is_farther(const Found_node& a, const Found_node& b)
  {
    return a.squared_distance > b.squared_distance || (a.squared_distance == b.squared_distance && a.begin > b.begin);
  }

  // Whether all points of a node come after the neighbors found.
  bool is_behind(const Found_node& n) const { return Neighbor(n.squared_distance, n.begin) > m_nearest.front(); }

  void push(std::uint32_t i)
  {
    const Point_octree_3::Node& n = m_octree.node(i);
    m_nodes.push_back(Found_node{ n.box.squared_distance(m_points[m_center]), n.begin, i });
    std::push_heap(m_nodes.begin(), m_nodes.end(), is_farther);
  }

  void visit(const Point_octree_3::Node& n, std::size_t size, double squared_radius)
  {
    for (std::uint32_t c = 0; c != n.number_of_children; ++c)
      push(n.first_child + c);
    if (n.number_of_children != 0)
      return;
    for (Point_index i = n.begin; i != n.end; ++i) {
      const Neighbor neighbor((m_points[i] - m_points[m_center]).squared_length(), i);
      if (i == m_center || neighbor.first > squared_radius)
        continue;
      if (m_nearest.size() == size) {
        if (neighbor > m_nearest.front())
          continue;
        std::pop_heap(m_nearest.begin(), m_nearest.end());
        m_nearest.pop_back();
      }
      m_nearest.push_back(neighbor);
      std::push_heap(m_nearest.begin(), m_nearest.end());
    }
  }

  const std::vector<Local_point>& m_points;
  const Point_octree_3& m_octree;
  Point_index m_center = 0;
  std::vector<Neighbor> m_nearest; // a heap with the farthest in front
  std::vector<Found_node> m_nodes; // a heap with the nearest in front
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_NEAREST_SEARCH_H

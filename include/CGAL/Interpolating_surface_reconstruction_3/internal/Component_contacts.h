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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_COMPONENT_CONTACTS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_COMPONENT_CONTACTS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Nearest_search.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The components of a surface, each with its longest edge, and where they are nearer to each other than their points.
class Component_contacts
{
public:
  using Triangle = std::array<Point_index, 3>;

  Component_contacts(const std::vector<Local_point>& points, const std::vector<Triangle>& triangles)
    : m_points(points), m_sets(points.size()), m_longest_edges(points.size(), 0.)
  {
    for (const Triangle& t : triangles) {
      m_sets.unite(t[0], t[1], false);
      m_sets.unite(t[0], t[2], false);
    }
    for (const Triangle& t : triangles) {
      double& longest = m_longest_edges[component(t[0])];
      if (longest == 0.)
        ++m_size;
      for (std::size_t i = 0; i != 3; ++i)
        longest = (std::max)(longest, distance(t[i], t[(i + 1) % 3]));
    }
  }

  // The number of components; points without triangles are none.
  std::size_t size() const { return m_size; }

  Point_index component(Point_index p) const { return m_sets.find(p).root; }

  bool is_on_surface(Point_index p) const { return m_longest_edges[component(p)] > 0.; }

  // That with the most of the points.
  Point_index largest_component(const std::vector<Point_index>& points) const
  {
    std::vector<std::size_t> sizes(m_points.size(), 0);
    for (Point_index p : points)
      ++sizes[component(p)];
    return static_cast<Point_index>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  }

  // Whether two points of different components are no farther from each other than the ends of an edge of each.
  bool are_near(Point_index p, Point_index q) const
  {
    return distance(p, q) <= (std::min)(m_longest_edges[component(p)], m_longest_edges[component(q)]);
  }

  // Finds the points near another component, but for those of the largest component, and what they are near to.
  // `cancellation_point()` is called again and again and may throw.
  template <typename CancellationPoint>
  void find(const Point_octree_3& octree, CancellationPoint& cancellation_point)
  {
    m_near.clear();
    m_groups = Parity_union_find(m_points.size());
    std::vector<Point_index> all(m_points.size());
    std::iota(all.begin(), all.end(), Point_index(0));
    const Point_index largest = largest_component(all);
    Nearest_search search(m_points, octree);
    for (Point_index p = 0; p != m_points.size(); ++p) {
      if (component(p) == largest || !is_on_surface(p))
        continue;
      const Point_index q = nearest_of_others(p, search, cancellation_point);
      if (q == NO_POINT)
        continue;
      m_near.push_back(p);
      m_near.push_back(q);
      m_groups.unite(component(p), component(q), false);
    }
    std::sort(m_near.begin(), m_near.end());
    m_near.erase(std::unique(m_near.begin(), m_near.end()), m_near.end());
  }

  // Those found, increasing.
  const std::vector<Point_index>& near() const { return m_near; }

  // All points of components that are near to each other, increasing.
  std::vector<std::vector<Point_index> > groups() const
  {
    constexpr std::size_t UNWANTED = static_cast<std::size_t>(-1), UNSEEN = UNWANTED - 1;
    const auto group = [&](Point_index p) { return m_groups.find(component(p)).root; };
    std::vector<std::size_t> positions(m_points.size(), UNWANTED);
    for (Point_index p : m_near)
      positions[group(p)] = UNSEEN;
    std::vector<std::vector<Point_index> > result;
    for (Point_index p = 0; p != m_points.size(); ++p) {
      std::size_t& position = positions[group(p)];
      if (position == UNWANTED)
        continue;
      if (position == UNSEEN) {
        position = result.size();
        result.emplace_back();
      }
      result[position].push_back(p);
    }
    return result;
  }

private:
  // Neighbors among which a point of another component is looked for: at first, at most, and from one to the next.
  static constexpr std::size_t FIRST_NEIGHBORS = 16, MAXIMUM_NEIGHBORS = 1024, NEIGHBORS_RATIO = 4;

  // As they are found.
  static constexpr std::size_t NEIGHBORS_PER_MICROSECOND = 2;

  double distance(Point_index p, Point_index q) const
  {
    return std::sqrt((m_points[q] - m_points[p]).squared_length());
  }

  // The nearest point that is near and belongs to another component, if there is one.
  template <typename CancellationPoint>
  Point_index nearest_of_others(Point_index p, Nearest_search& search, CancellationPoint& cancellation_point) const
  {
    const double radius = m_longest_edges[component(p)];
    for (std::size_t size = FIRST_NEIGHBORS; size <= MAXIMUM_NEIGHBORS; size *= NEIGHBORS_RATIO) {
      cancellation_point(size / NEIGHBORS_PER_MICROSECOND);
      const std::vector<Nearest_search::Neighbor>& nearest = search(p, size, radius * radius);
      for (const Nearest_search::Neighbor& n : nearest)
        if (component(n.second) != component(p) && are_near(p, n.second))
          return n.second;
      if (nearest.size() < size)
        break;
    }
    return NO_POINT;
  }

  const std::vector<Local_point>& m_points;
  Parity_union_find m_sets;            // of points
  std::vector<double> m_longest_edges; // of the component of each root; 0 without triangles
  std::size_t m_size = 0;
  std::vector<Point_index> m_near;
  Parity_union_find m_groups{ 0 }; // of roots
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_COMPONENT_CONTACTS_H

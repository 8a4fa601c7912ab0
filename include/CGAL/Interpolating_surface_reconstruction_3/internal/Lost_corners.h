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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LOST_CORNERS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LOST_CORNERS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Corner_test.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Steep_search.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The lost corners of an oriented surface, see Corner_test. They are followed along their short edges: three straight
// chains side by side are no corners but rows, as scanners make them. Others may be found to be alone: there is nothing
// that the surface could turn to at such a corner, as on the ground in a scan.
class Lost_corners
{
public:
  using Triangle = std::array<Point_index, 3>;

  Lost_corners(const std::vector<Local_point>& points, const std::vector<Triangle>& triangles)
    : m_points(points), m_triangles(triangles), m_tests(points.begin(), points.end()), m_chains(points.size()),
      m_is_by_right(points.size(), 0)
  {
    for (const Triangle& t : triangles)
      for (std::size_t i = 0; i != 3; ++i)
        m_tests[t[i]].add_facet(points[t[(i + 1) % 3]], points[t[(i + 2) % 3]]);
    follow_short_edges();
    find_rows();
  }

  // From now on, those that are alone are no corners. `cancellation_point()` is called again and again and may throw.
  template <typename CancellationPoint>
  void find_alone(const Point_octree_3& octree, CancellationPoint& cancellation_point)
  {
    Steep_search has_steep_point(m_points, octree);
    for (Point_index p = 0; p != m_points.size(); ++p)
      if (is_corner(p)) {
        cancellation_point();
        const Corner_test& test = m_tests[p];
        m_is_by_right[p] = has_steep_point(p, test.normal(), test.squared_length_of_longest_gained()) ? 0 : 1;
      }
  }

  // In order.
  std::vector<Point_index> corners() const
  {
    std::vector<Point_index> result;
    for (Point_index p = 0; p != m_points.size(); ++p)
      if (is_corner(p))
        result.push_back(p);
    return result;
  }

  bool is_lost(Point_index p) const { return m_tests[p].is_lost(); }

  // Whether the surface is right there, although it looks like a lost corner: in a row, or alone.
  bool is_by_right(Point_index p) const { return m_is_by_right[p] != 0; }

  bool is_corner(Point_index p) const { return is_lost(p) && !is_by_right(p); }

private:
  using Chain = std::vector<Point_index>;

  // A chain whose points are no farther from the line between its ends, in parts of its length, is straight.
  static constexpr double STRAIGHT_WIDTH = .1;

  // Of five degrees.
  static constexpr double PARALLEL_COSINE = .9962;

  double squared_length(Point_index p, Point_index q) const { return (m_points[q] - m_points[p]).squared_length(); }

  // Calls visit(p, q) for the edges between lost corners.
  template <typename Visit>
  void for_each_edge(const Visit& visit) const
  {
    for (const Triangle& t : m_triangles)
      for (std::size_t i = 0; i != 3; ++i)
        if (is_lost(t[i]) && is_lost(t[(i + 1) % 3]))
          visit(t[i], t[(i + 1) % 3]);
  }

  // Those that are shorter than the mean of the longest and the shortest edge of either end.
  void follow_short_edges()
  {
    const auto is_short = [&](Point_index p, double squared) {
      return squared * squared < m_tests[p].squared_length_of_shortest() * m_tests[p].squared_length_of_longest();
    };
    for_each_edge([&](Point_index p, Point_index q) {
      const double squared = squared_length(p, q);
      if (is_short(p, squared) && is_short(q, squared))
        m_chains.unite(p, q, false);
    });
  }

  void find_rows()
  {
    const std::vector<Local_vector> directions = directions_of_straight_chains();
    std::vector<std::pair<Point_index, Point_index> > parallel;
    for_each_edge([&](Point_index p, Point_index q) {
      const Point_index a = m_chains.find(p).root, b = m_chains.find(q).root;
      if (a != b && std::abs(directions[a] * directions[b]) > PARALLEL_COSINE) {
        parallel.emplace_back(a, b);
        parallel.emplace_back(b, a);
      }
    });
    std::sort(parallel.begin(), parallel.end());
    parallel.erase(std::unique(parallel.begin(), parallel.end()), parallel.end());
    std::vector<std::size_t> number(m_points.size(), 0);
    for (const auto& pair : parallel)
      ++number[pair.first];
    std::vector<unsigned char> is_row(m_points.size(), 0);
    for (const auto& pair : parallel)
      if (number[pair.first] >= 2)
        is_row[pair.first] = is_row[pair.second] = 1;
    for (Point_index p = 0; p != m_points.size(); ++p)
      m_is_by_right[p] = is_row[m_chains.find(p).root];
  }

  // For the root of each straight chain; others are zero.
  std::vector<Local_vector> directions_of_straight_chains() const
  {
    std::vector<Chain> chains(m_points.size());
    for (Point_index p = 0; p != m_points.size(); ++p)
      if (is_lost(p))
        chains[m_chains.find(p).root].push_back(p);
    std::vector<Local_vector> result;
    result.reserve(chains.size());
    for (const Chain& chain : chains)
      result.push_back(direction_if_straight(chain));
    return result;
  }

  Local_vector direction_if_straight(const Chain& chain) const
  {
    const Local_vector none(0, 0, 0);
    if (chain.size() < 2)
      return none;
    const Point_index first = farthest_from(chain.front(), chain), last = farthest_from(first, chain);
    const double length = std::sqrt(squared_length(first, last));
    const Local_vector direction = (m_points[last] - m_points[first]) / length;
    const bool is_straight = std::all_of(chain.begin(), chain.end(), [&](Point_index p) {
      const Local_vector aside = cross_product(direction, m_points[p] - m_points[first]);
      return aside.squared_length() <= STRAIGHT_WIDTH * STRAIGHT_WIDTH * length * length;
    });
    return is_straight ? direction : none;
  }

  Point_index farthest_from(Point_index p, const Chain& chain) const
  {
    return *std::max_element(chain.begin(), chain.end(),
                             [&](Point_index a, Point_index b) { return squared_length(p, a) < squared_length(p, b); });
  }

  const std::vector<Local_point>& m_points;
  const std::vector<Triangle>& m_triangles;
  std::vector<Corner_test> m_tests; // of points
  Parity_union_find m_chains;       // of points
  std::vector<unsigned char> m_is_by_right;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LOST_CORNERS_H

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
// chains side by side are no corners but rows, as scanners make them.
class Lost_corners
{
public:
  using Triangle = std::array<Point_index, 3>;

  Lost_corners(const std::vector<Local_point>& points, const std::vector<Triangle>& triangles)
    : m_points(points), m_triangles(triangles), m_chains(points.size()), m_is_in_row(points.size(), 0)
  {
    std::vector<Corner_test> tests(points.begin(), points.end());
    for (const Triangle& t : triangles)
      for (std::size_t i = 0; i != 3; ++i)
        tests[t[i]].add_facet(points[t[(i + 1) % 3]], points[t[(i + 2) % 3]]);
    m_is_lost.reserve(tests.size());
    for (const Corner_test& test : tests)
      m_is_lost.push_back(test.is_lost() ? 1 : 0);
    follow_short_edges(tests);
    find_rows();
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

  bool is_lost(Point_index p) const { return m_is_lost[p] != 0; }
  bool is_in_row(Point_index p) const { return m_is_in_row[p] != 0; }
  bool is_corner(Point_index p) const { return is_lost(p) && !is_in_row(p); }

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
  void follow_short_edges(const std::vector<Corner_test>& tests)
  {
    const auto is_short = [&](Point_index p, double squared) {
      return squared * squared < tests[p].squared_length_of_shortest() * tests[p].squared_length_of_longest();
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
      m_is_in_row[p] = is_row[m_chains.find(p).root];
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
  Parity_union_find m_chains; // of points
  std::vector<unsigned char> m_is_lost, m_is_in_row;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LOST_CORNERS_H

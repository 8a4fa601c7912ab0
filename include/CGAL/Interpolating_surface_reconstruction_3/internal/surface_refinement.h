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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_REFINEMENT_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_REFINEMENT_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Linear_pieces.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Splits the edges of a triangulated surface until none is longer than a bound, and moves the new
// vertices onto a surface. Neighboring triangles split a common edge at the same vertex, so that the
// surface stays the manifold that it is.
class Surface_refinement
{
public:
  using Triangle = std::array<Point_index, 3>;

  // New vertices get the numbers from `positions.size()` on.
  Surface_refinement(const std::vector<Local_point>& positions, std::vector<Triangle>& triangles,
                     std::vector<Local_point>& added)
    : m_positions(positions), m_triangles(triangles), m_added(added)
  { }

  // `move(x)` is the place of a new vertex in the middle x of an edge; it is called concurrently.
  // `keep_going(fraction)` is asked before each round. Throws if there would be too many triangles.
  template <typename ConcurrencyTag, typename Move, typename KeepGoing>
  void operator()(double maximum_length, const Move& move, const KeepGoing& keep_going)
  {
    check_size(maximum_length);
    const double first = longest_edge();
    for (double longest = first; longest > maximum_length; longest = longest_edge()) {
      if (!keep_going(std::log(first / longest) / std::log(first / maximum_length)))
        return;
      collect_long_edges(maximum_length);
      add_vertices<ConcurrencyTag>(move);
      split_triangles();
    }
  }

private:
  using Edge = std::pair<Point_index, Point_index>; // increasing

  static constexpr std::size_t EDGES_PER_BLOCK = 256;
  static constexpr double MAXIMUM_TRIANGLES = 1e9; // of 32-bit indices

  const Local_point& position(Point_index p) const
  {
    return p < m_positions.size() ? m_positions[p] : m_added[p - m_positions.size()];
  }

  double length(Point_index p, Point_index q) const { return std::sqrt((position(q) - position(p)).squared_length()); }
  static Edge edge(Point_index p, Point_index q) { return Edge((std::min)(p, q), (std::max)(p, q)); }

  double longest_edge() const
  {
    double result = 0.;
    for (const Triangle& t : m_triangles)
      for (std::size_t i = 0; i != 3; ++i)
        result = (std::max)(result, length(t[i], t[(i + 1) % 3]));
    return result;
  }

  // Halving all edges makes four triangles of one.
  void check_size(double maximum_length) const
  {
    double expected = 0.;
    for (const Triangle& t : m_triangles) {
      double longest = 0.;
      for (std::size_t i = 0; i != 3; ++i)
        longest = (std::max)(longest, length(t[i], t[(i + 1) % 3]));
      const double rounds = std::ceil(std::log2((std::max)(longest / maximum_length, 1.)));
      expected += std::pow(4., rounds);
    }
    if (!(expected <= MAXIMUM_TRIANGLES))
      throw std::invalid_argument("grid_spacing: about " + std::to_string(expected) + " triangles would be needed");
  }

  void collect_long_edges(double maximum_length)
  {
    m_edges.clear();
    for (const Triangle& t : m_triangles)
      for (std::size_t i = 0; i != 3; ++i)
        if (length(t[i], t[(i + 1) % 3]) > maximum_length)
          m_edges.push_back(edge(t[i], t[(i + 1) % 3]));
    std::sort(m_edges.begin(), m_edges.end());
    m_edges.erase(std::unique(m_edges.begin(), m_edges.end()), m_edges.end());
  }

  template <typename ConcurrencyTag, typename Move>
  void add_vertices(const Move& move)
  {
    m_first = static_cast<Point_index>(m_positions.size() + m_added.size());
    std::vector<Local_point> vertices(m_edges.size());
    for_each_block<ConcurrencyTag>(m_edges.size(), EDGES_PER_BLOCK, [&](std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e != end; ++e)
        vertices[e] = move(CGAL::midpoint(position(m_edges[e].first), position(m_edges[e].second)));
    });
    m_added.insert(m_added.end(), vertices.begin(), vertices.end());
  }

  // The vertex in the middle of an edge, or NO_POINT if it is short.
  Point_index middle(Point_index p, Point_index q) const
  {
    const auto it = std::lower_bound(m_edges.begin(), m_edges.end(), edge(p, q));
    return it != m_edges.end() && *it == edge(p, q) ? m_first + static_cast<Point_index>(it - m_edges.begin())
                                                    : NO_POINT;
  }

  void split_triangles()
  {
    std::vector<Triangle> result;
    result.reserve(4 * m_triangles.size());
    for (Triangle t : m_triangles) {
      Triangle m = { { middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0]) } };
      const auto splits = 3 - std::count(m.begin(), m.end(), NO_POINT);
      // turned so that, of one or two middles, the first is there and the last is not
      while (splits != 0 && splits != 3 && !(m[0] != NO_POINT && m[2] == NO_POINT)) {
        std::rotate(t.begin(), t.begin() + 1, t.end());
        std::rotate(m.begin(), m.begin() + 1, m.end());
      }
      if (splits == 0)
        result.push_back(t);
      else if (splits == 1)
        result.insert(result.end(), { { { t[0], m[0], t[2] } }, { { m[0], t[1], t[2] } } });
      else if (splits == 3)
        result.insert(result.end(),
                      { { { t[0], m[0], m[2] } }, { { m[0], t[1], m[1] } }, { { m[2], m[1], t[2] } }, m });
      else
        split_at_two_edges(t, m, result);
    }
    m_triangles.swap(result);
  }

  // The quadrangle that remains is split at its shorter diagonal.
  void split_at_two_edges(const Triangle& t, const Triangle& m, std::vector<Triangle>& result) const
  {
    result.push_back({ { m[0], t[1], m[1] } });
    if (length(t[0], m[1]) < length(m[0], t[2]))
      result.insert(result.end(), { { { t[0], m[0], m[1] } }, { { t[0], m[1], t[2] } } });
    else
      result.insert(result.end(), { { { t[0], m[0], t[2] } }, { { m[0], m[1], t[2] } } });
  }

  const std::vector<Local_point>& m_positions;
  std::vector<Triangle>& m_triangles;
  std::vector<Local_point>& m_added;
  std::vector<Edge> m_edges; // that are split in this round
  Point_index m_first = 0;   // vertex on the first of them
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_REFINEMENT_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BOUNDARY_OPENING_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BOUNDARY_OPENING_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Removes the triangles of a closed surface that span openings of the sampled surface: those whose
// longest edge is long beside the edges around its vertices, and their neighbors of the same kind.
class Boundary_opening
{
public:
  using Triangle = std::array<Point_index, 3>;

  // Closed, oriented.
  Boundary_opening(const std::vector<Local_point>& positions, const std::vector<Local_vector>& normals,
                   const std::vector<Triangle>& triangles)
    : m_positions(positions), m_normals(normals), m_triangles(triangles), m_is_removed(triangles.size(), 0)
  { }

  // The triangles that remain: a manifold with boundary.
  std::vector<Triangle> operator()()
  {
    find_neighbors();
    compute_radii();
    grow_openings();
    remove_second_fans();
    std::vector<Triangle> result;
    for (std::size_t t = 0; t != m_triangles.size(); ++t)
      if (!m_is_removed[t])
        result.push_back(m_triangles[t]);
    return result;
  }

private:
  // An opening has a triangle that is far larger than the spacing. The others of it are larger than those
  // of a grid, whose edges are up to the square root of 2 times the median.
  static constexpr double SEED_SCORE = 4., GROWTH_SCORE = 1.5;

  double length(Point_index p, Point_index q) const
  {
    return std::sqrt((m_positions[q] - m_positions[p]).squared_length());
  }

  // Neighbor i shares the edge from vertex i to the next.
  void find_neighbors()
  {
    struct Side
    {
      Point_index low, high;
      std::size_t triangle, index;
      bool operator<(const Side& other) const { return low < other.low || (low == other.low && high < other.high); }
    };
    std::vector<Side> sides;
    sides.reserve(3 * m_triangles.size());
    for (std::size_t t = 0; t != m_triangles.size(); ++t)
      for (std::size_t i = 0; i != 3; ++i) {
        const Point_index p = m_triangles[t][i], q = m_triangles[t][(i + 1) % 3];
        sides.push_back(Side{ (std::min)(p, q), (std::max)(p, q), t, i });
      }
    std::sort(sides.begin(), sides.end());
    m_neighbors.resize(m_triangles.size());
    for (std::size_t s = 0; s + 1 < sides.size(); s += 2) {
      m_neighbors[sides[s].triangle][sides[s].index] = sides[s + 1].triangle;
      m_neighbors[sides[s + 1].triangle][sides[s + 1].index] = sides[s].triangle;
    }
  }

  // The median length of the edges at each vertex.
  void compute_radii()
  {
    std::vector<std::size_t> begin(m_positions.size() + 1, 0);
    for (const Triangle& t : m_triangles)
      for (Point_index p : t)
        ++begin[p + 1];
    for (std::size_t p = 0; p != m_positions.size(); ++p)
      begin[p + 1] += begin[p];
    std::vector<double> lengths(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (const Triangle& t : m_triangles)
      for (std::size_t i = 0; i != 3; ++i)
        lengths[next[t[i]]++] = length(t[i], t[(i + 1) % 3]);
    m_radii.assign(m_positions.size(), 0.);
    for (std::size_t p = 0; p != m_positions.size(); ++p)
      if (begin[p] != begin[p + 1]) {
        const auto first = lengths.begin() + std::ptrdiff_t(begin[p]),
                   last = lengths.begin() + std::ptrdiff_t(begin[p + 1]);
        const auto median = first + (last - first) / 2;
        std::nth_element(first, median, last);
        m_radii[p] = *median;
      }
  }

  double score(std::size_t t) const
  {
    const Triangle& v = m_triangles[t];
    const double longest = (std::max)({ length(v[0], v[1]), length(v[1], v[2]), length(v[2], v[0]) });
    return longest / (std::max)({ m_radii[v[0]], m_radii[v[1]], m_radii[v[2]] });
  }

  bool faces_against_normals(std::size_t t) const
  {
    const Triangle& v = m_triangles[t];
    const Local_vector n = cross_product(m_positions[v[1]] - m_positions[v[0]], m_positions[v[2]] - m_positions[v[0]]);
    return n * (m_normals[v[0]] + m_normals[v[1]] + m_normals[v[2]]) < 0.;
  }

  void grow_openings()
  {
    std::vector<std::size_t> stack;
    const auto remove = [&](std::size_t t) {
      m_is_removed[t] = 1;
      stack.push_back(t);
    };
    for (std::size_t t = 0; t != m_triangles.size(); ++t)
      if (score(t) > SEED_SCORE)
        remove(t);
    while (!stack.empty()) {
      const std::size_t t = stack.back();
      stack.pop_back();
      for (std::size_t n : m_neighbors[t])
        if (!m_is_removed[n] && (score(n) > GROWTH_SCORE || faces_against_normals(n)))
          remove(n);
    }
  }

  // Of the fans that remain at a vertex, the largest stays. That may open other fans, until none is left.
  void remove_second_fans()
  {
    std::vector<std::size_t> begin(m_positions.size() + 1, 0);
    for (const Triangle& t : m_triangles)
      for (Point_index p : t)
        ++begin[p + 1];
    for (std::size_t p = 0; p != m_positions.size(); ++p)
      begin[p + 1] += begin[p];
    std::vector<std::size_t> triangles_at(begin.back()), next(begin.begin(), begin.end() - 1);
    for (std::size_t t = 0; t != m_triangles.size(); ++t)
      for (Point_index p : m_triangles[t])
        triangles_at[next[p]++] = t;
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (Point_index p = 0; p != m_positions.size(); ++p) {
        std::vector<std::vector<std::size_t> > fans;
        for (std::size_t k = begin[p]; k != begin[p + 1]; ++k)
          if (!m_is_removed[triangles_at[k]] && !contains(fans, triangles_at[k]))
            fans.push_back(fan(p, triangles_at[k]));
        const auto largest =
          std::max_element(fans.begin(), fans.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
        for (auto it = fans.begin(); it != fans.end(); ++it)
          if (it != largest) {
            is_changed = true;
            for (std::size_t t : *it)
              m_is_removed[t] = 1;
          }
      }
    }
  }

  static bool contains(const std::vector<std::vector<std::size_t> >& fans, std::size_t t)
  {
    return std::any_of(fans.begin(), fans.end(),
                       [&](const auto& fan) { return std::find(fan.begin(), fan.end(), t) != fan.end(); });
  }

  // The triangles at p that are connected to t by edges at p.
  std::vector<std::size_t> fan(Point_index p, std::size_t t) const
  {
    std::vector<std::size_t> result(1, t);
    for (std::size_t k = 0; k != result.size(); ++k)
      for (std::size_t i = 0; i != 3; ++i) {
        const Triangle& v = m_triangles[result[k]];
        const std::size_t n = m_neighbors[result[k]][i];
        if ((v[i] == p || v[(i + 1) % 3] == p) && !m_is_removed[n] &&
            std::find(result.begin(), result.end(), n) == result.end())
          result.push_back(n);
      }
    return result;
  }

  const std::vector<Local_point>& m_positions;
  const std::vector<Local_vector>& m_normals;
  const std::vector<Triangle>& m_triangles;
  std::vector<std::array<std::size_t, 3> > m_neighbors;
  std::vector<double> m_radii;
  std::vector<unsigned char> m_is_removed;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BOUNDARY_OPENING_H

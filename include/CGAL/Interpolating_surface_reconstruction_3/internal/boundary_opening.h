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

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Edge_spacings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_measures.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_neighbors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Removes the triangles of a closed surface that span openings of the sampled surface. A region of triangles
// that share edges longer than the spacing of their samples is an opening if the triangles around it alone explain
// the normals of its samples much better: the normal of a sample at an opening is that of the surface beside it,
// while a long triangle of a sparsely sampled part has a share in the normals of its samples.
class Boundary_opening
{
public:
  using Triangle = std::array<Point_index, 3>;

  // Closed, oriented.
  Boundary_opening(const std::vector<Local_point>& positions, const std::vector<Local_vector>& normals,
                   const std::vector<Triangle>& triangles)
    : m_positions(positions), m_normals(normals), m_triangles(triangles),
      m_neighbors(neighbors_of_closed_surface(triangles)), m_spacings(positions), m_is_seen(triangles.size(), 0),
      m_is_removed(triangles.size(), 0)
  { }

  // The triangles that remain: a manifold with boundary.
  std::vector<Triangle> operator()()
  {
    if (m_neighbors.empty())
      return m_triangles;
    find_spacings();
    sum_up_normals();
    for (std::size_t t = 0; t != m_triangles.size(); ++t)
      if (!m_is_seen[t] && has_edge_longer_than(t, Edge_spacings::FAR_LONGER))
        open_region(region_of(t));
    remove_second_fans();
    std::vector<Triangle> result;
    for (std::size_t t = 0; t != m_triangles.size(); ++t)
      if (!m_is_removed[t])
        result.push_back(m_triangles[t]);
    return result;
  }

private:
  // In triangles, those of an octagon: smaller openings cannot be told from a few long triangles.
  static constexpr std::size_t MINIMUM_SIZE = 6;

  // The deviation of the normals without a region that contradicts them, over that with it.
  static constexpr double CONTRADICTION = .5;

  // The deviation of a normal from that of no triangle: a sample is not to lose all of its triangles.
  static constexpr double LARGEST_DEVIATION = 2.;

  // Of the cosine of an angle.
  static constexpr double ROUNDING = 1e-9;

  void find_spacings()
  {
    std::vector<std::size_t> begin(m_positions.size() + 1, 0);
    for (const Triangle& t : m_triangles)
      for (Point_index p : t)
        ++begin[p + 1];
    for (std::size_t p = 0; p != m_positions.size(); ++p)
      begin[p + 1] += begin[p];
    std::vector<Point_index> neighbors(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (const Triangle& t : m_triangles)
      for (std::size_t i = 0; i != 3; ++i)
        neighbors[next[t[i]]++] = t[(i + 1) % 3];
    for (Point_index p = 0; p != m_positions.size(); ++p)
      m_spacings.set(p, neighbors.begin() + std::ptrdiff_t(begin[p]), neighbors.begin() + std::ptrdiff_t(begin[p + 1]));
  }

  bool is_longer_than(std::size_t t, std::size_t i, double times) const
  {
    return m_spacings.is_longer(m_triangles[t][i], m_triangles[t][(i + 1) % 3], times);
  }

  bool has_edge_longer_than(std::size_t t, double times) const
  {
    return is_longer_than(t, 0, times) || is_longer_than(t, 1, times) || is_longer_than(t, 2, times);
  }

  Local_vector normal(std::size_t t) const
  {
    const Triangle& v = m_triangles[t];
    return cross_product(m_positions[v[1]] - m_positions[v[0]], m_positions[v[2]] - m_positions[v[0]]);
  }

  // How the normals of triangles make that of a vertex: normals of samples may come from either.
  enum Weighting : std::size_t
  {
    BY_ANGLE,
    BY_AREA,
    NUMBER_OF_WEIGHTINGS
  };

  // The normal as it counts at vertex i.
  Local_vector normal_at(std::size_t t, std::size_t i, Weighting weighting) const
  {
    const Local_vector n = normal(t);
    if (weighting == BY_AREA)
      return n;
    const Triangle& v = m_triangles[t];
    const double length = std::sqrt(n.squared_length());
    if (!(length > 0.))
      return Local_vector(0, 0, 0);
    const Local_vector a = m_positions[v[(i + 1) % 3]] - m_positions[v[i]],
                       b = m_positions[v[(i + 2) % 3]] - m_positions[v[i]];
    return std::acos(cosine(a, b)) / length * n;
  }

  void sum_up_normals()
  {
    for (Weighting weighting : { BY_ANGLE, BY_AREA }) {
      std::vector<Local_vector>& sums = m_sums[weighting];
      sums.assign(m_positions.size(), Local_vector(0, 0, 0));
      for (std::size_t t = 0; t != m_triangles.size(); ++t)
        for (std::size_t i = 0; i != 3; ++i)
          sums[m_triangles[t][i]] = sums[m_triangles[t][i]] + normal_at(t, i, weighting);
    }
  }

  bool faces_against_normals(std::size_t t) const
  {
    const Triangle& v = m_triangles[t];
    return normal(t) * (m_normals[v[0]] + m_normals[v[1]] + m_normals[v[2]]) < 0.;
  }

  // The triangles connected to t across long edges, and those beside them that face against the normals.
  std::vector<std::size_t> region_of(std::size_t t)
  {
    std::vector<std::size_t> region(1, t);
    m_is_seen[t] = 1;
    for (std::size_t k = 0; k != region.size(); ++k)
      for (std::size_t i = 0; i != 3; ++i) {
        const std::size_t n = m_neighbors[region[k]][i];
        if (!m_is_seen[n] && (is_longer_than(region[k], i, Edge_spacings::LONGER) || faces_against_normals(n))) {
          m_is_seen[n] = 1;
          region.push_back(n);
        }
      }
    return region;
  }

  void open_region(const std::vector<std::size_t>& region)
  {
    if (region.size() >= MINIMUM_SIZE && contradicts_normals(region, BY_ANGLE) && contradicts_normals(region, BY_AREA))
      for (std::size_t t : region)
        m_is_removed[t] = 1;
  }

  // Whether the other triangles alone explain the normals of its samples much better, and those of most.
  bool contradicts_normals(const std::vector<std::size_t>& region, Weighting weighting) const
  {
    std::vector<std::pair<Point_index, Local_vector> > parts;
    for (std::size_t t : region)
      for (std::size_t i = 0; i != 3; ++i)
        parts.emplace_back(m_triangles[t][i], normal_at(t, i, weighting));
    std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    double with_region = 0., without_region = 0.;
    std::size_t samples = 0, better = 0;
    for (auto it = parts.begin(); it != parts.end();) {
      const Point_index p = it->first;
      const Local_vector& sum = m_sums[weighting][p];
      Local_vector rest = sum;
      for (; it != parts.end() && it->first == p; ++it)
        rest = rest - it->second;
      const double with = deviation(p, sum), without = deviation(p, rest, sum);
      with_region += with;
      without_region += without;
      ++samples;
      better += without <= with + ROUNDING ? 1u : 0u;
    }
    // in a plane both are zero but for rounding
    return 2 * better >= samples && without_region <= CONTRADICTION * with_region + ROUNDING * double(samples);
  }

  // One minus the cosine of the angle between the normal of a sample and one made of triangles.
  double deviation(Point_index p, const Local_vector& n, const Local_vector& sum) const
  {
    return n.squared_length() > ROUNDING * ROUNDING * sum.squared_length() ? 1. - cosine(m_normals[p], n)
                                                                           : LARGEST_DEVIATION;
  }

  double deviation(Point_index p, const Local_vector& n) const { return deviation(p, n, n); }

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
  const Triangle_neighbors m_neighbors;
  Edge_spacings m_spacings;
  std::array<std::vector<Local_vector>, NUMBER_OF_WEIGHTINGS> m_sums; // of the normals at each vertex
  std::vector<unsigned char> m_is_seen, m_is_removed;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BOUNDARY_OPENING_H

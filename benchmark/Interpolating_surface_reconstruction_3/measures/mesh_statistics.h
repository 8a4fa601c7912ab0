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

#ifndef ISR_BENCHMARK_MEASURES_MESH_STATISTICS_H
#define ISR_BENCHMARK_MEASURES_MESH_STATISTICS_H

#include "../models/model_files.h"

#include <CGAL/Origin.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace isr_benchmark {

// Topology of a triangle soup. Nothing is assumed about it but that its indices are valid.
struct Mesh_statistics
{
  std::size_t triangles = 0;
  std::size_t used_points = 0;     // distinct positions that are vertices
  std::size_t distinct_points = 0; // distinct positions of the input
  std::size_t components = 0;      // sets of triangles connected through edges
  std::size_t closed_components = 0;
  std::size_t outward_components = 0; // closed ones with positive signed volume
  std::size_t boundary_edges = 0;
  std::size_t boundary_loops = 0;
  std::size_t nonmanifold_edges = 0;    // with more than two triangles
  std::size_t nonmanifold_vertices = 0; // with more than one fan of triangles
  std::size_t degenerate_triangles = 0; // collinear or with a repeated vertex
  bool is_oriented = true;              // no edge is traversed twice in one direction
  long euler_characteristic = 0;

  bool is_closed() const { return triangles != 0 && boundary_edges == 0; }
  bool is_manifold() const { return nonmanifold_edges == 0 && nonmanifold_vertices == 0; }
};

class Union_find
{
public:
  explicit Union_find(std::size_t n) : m_parents(n) { std::iota(m_parents.begin(), m_parents.end(), std::size_t(0)); }

  std::size_t find(std::size_t i)
  {
    while (m_parents[i] != i) {
      m_parents[i] = m_parents[m_parents[i]];
      i = m_parents[i];
    }
    return i;
  }

  void unite(std::size_t i, std::size_t j) { m_parents[(std::max)(find(i), find(j))] = (std::min)(find(i), find(j)); }

private:
  std::vector<std::size_t> m_parents;
};

class Mesh_statistician
{
public:
  Mesh_statistician(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
    : m_points(points), m_triangles(triangles), m_components(triangles.size()), m_fans(3 * triangles.size())
  { }

  Mesh_statistics operator()()
  {
    m_result.triangles = m_triangles.size();
    count_points();
    collect_edges();
    for_each_edge([&](std::size_t begin, std::size_t end) { join_around_edge(begin, end); });
    for_each_edge([&](std::size_t begin, std::size_t end) { classify_edge(begin, end); });
    count_boundary_loops();
    count_vertices();
    count_components();
    for (const Triangle& t : m_triangles)
      if (CGAL::collinear(m_points[t[0]], m_points[t[1]], m_points[t[2]]))
        ++m_result.degenerate_triangles;
    return m_result;
  }

private:
  // One side of a triangle, from the corner with the smaller vertex to that with the larger.
  struct Side
  {
    std::array<std::size_t, 2> vertices;
    std::array<std::size_t, 2> corners;
    bool is_reversed;
    std::size_t triangle() const { return corners[0] / 3; }
  };

  void count_points()
  {
    std::vector<std::size_t> order(m_points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return m_points[i] < m_points[j]; });
    std::vector<char> is_used(m_points.size(), 0);
    for (const Triangle& t : m_triangles)
      for (std::size_t v : t)
        is_used[v] = 1;
    for (std::size_t i = 0; i != order.size();) {
      bool any = false;
      const std::size_t first = order[i];
      for (; i != order.size() && m_points[order[i]] == m_points[first]; ++i)
        any = any || is_used[order[i]];
      ++m_result.distinct_points;
      m_result.used_points += any ? 1u : 0u;
    }
  }

  void collect_edges()
  {
    m_sides.reserve(3 * m_triangles.size());
    for (std::size_t t = 0; t != m_triangles.size(); ++t)
      for (std::size_t i = 0; i != 3; ++i) {
        const std::size_t j = i == 2 ? 0 : i + 1;
        const std::size_t u = m_triangles[t][i], v = m_triangles[t][j];
        if (u < v)
          m_sides.push_back(Side{ { u, v }, { 3 * t + i, 3 * t + j }, false });
        else
          m_sides.push_back(Side{ { v, u }, { 3 * t + j, 3 * t + i }, true });
      }
    std::sort(m_sides.begin(), m_sides.end(), [](const Side& a, const Side& b) { return a.vertices < b.vertices; });
  }

  template <typename Visit>
  void for_each_edge(Visit visit)
  {
    for (std::size_t begin = 0; begin != m_sides.size();) {
      std::size_t end = begin + 1;
      while (end != m_sides.size() && m_sides[end].vertices == m_sides[begin].vertices)
        ++end;
      visit(begin, end);
      begin = end;
    }
  }

  void join_around_edge(std::size_t begin, std::size_t end)
  {
    for (std::size_t i = begin + 1; i != end; ++i) {
      m_components.unite(m_sides[begin].triangle(), m_sides[i].triangle());
      for (std::size_t k = 0; k != 2; ++k)
        m_fans.unite(m_sides[begin].corners[k], m_sides[i].corners[k]);
    }
  }

  void classify_edge(std::size_t begin, std::size_t end)
  {
    ++m_edges;
    std::size_t reversed = 0;
    for (std::size_t i = begin; i != end; ++i)
      reversed += m_sides[i].is_reversed ? 1u : 0u;
    if (reversed > 1 || end - begin - reversed > 1)
      m_result.is_oriented = false;
    if (end - begin == 1)
      m_boundary.push_back(begin);
    if (end - begin > 2)
      ++m_result.nonmanifold_edges;
  }

  // A loop passes from edge to edge through the fan at their common vertex.
  void count_boundary_loops()
  {
    m_result.boundary_edges = m_boundary.size();
    Union_find loops(3 * m_triangles.size());
    for (std::size_t side : m_boundary)
      loops.unite(m_fans.find(m_sides[side].corners[0]), m_fans.find(m_sides[side].corners[1]));
    std::vector<std::size_t> roots;
    for (std::size_t side : m_boundary)
      roots.push_back(loops.find(m_fans.find(m_sides[side].corners[0])));
    m_result.boundary_loops = number_of_distinct(roots);
  }

  void count_vertices()
  {
    std::vector<std::size_t> fans(m_points.size(), 0);
    for (std::size_t corner = 0; corner != 3 * m_triangles.size(); ++corner)
      if (m_fans.find(corner) == corner)
        ++fans[m_triangles[corner / 3][corner % 3]];
    std::size_t vertices = 0;
    for (std::size_t n : fans) {
      vertices += n > 0 ? 1u : 0u;
      m_result.nonmanifold_vertices += n > 1 ? 1u : 0u;
    }
    m_result.euler_characteristic = static_cast<long>(vertices + m_triangles.size()) - static_cast<long>(m_edges);
  }

  void count_components()
  {
    std::vector<char> is_open(m_triangles.size(), 0);
    for (std::size_t side : m_boundary)
      is_open[m_components.find(m_sides[side].triangle())] = 1;
    // relative to a point of the cloud, so that a far origin does not drown the volume
    std::vector<double> volumes(m_triangles.size(), 0.);
    for (std::size_t t = 0; t != m_triangles.size(); ++t) {
      const Point& origin = m_points[m_triangles[m_components.find(t)][0]];
      volumes[m_components.find(t)] +=
        CGAL::determinant(m_points[m_triangles[t][0]] - origin, m_points[m_triangles[t][1]] - origin,
                          m_points[m_triangles[t][2]] - origin);
    }
    for (std::size_t t = 0; t != m_triangles.size(); ++t)
      if (m_components.find(t) == t) {
        ++m_result.components;
        m_result.closed_components += is_open[t] ? 0u : 1u;
        m_result.outward_components += !is_open[t] && volumes[t] > 0. ? 1u : 0u;
      }
  }

  static std::size_t number_of_distinct(std::vector<std::size_t>& values)
  {
    std::sort(values.begin(), values.end());
    return static_cast<std::size_t>(std::unique(values.begin(), values.end()) - values.begin());
  }

  const std::vector<Point>& m_points;
  const std::vector<Triangle>& m_triangles;
  Union_find m_components; // of triangles
  Union_find m_fans;       // of corners; corner i of triangle t is 3 t + i
  std::vector<Side> m_sides;
  std::vector<std::size_t> m_boundary; // sides alone at their edge
  std::size_t m_edges = 0;
  Mesh_statistics m_result;
};

// Whether `found` has the topology of `reference`, or, where the reference is open and `found`
// closed, that of the reference with a disc in each of its boundary loops.
inline bool has_same_topology(const Mesh_statistics& found, const Mesh_statistics& reference)
{
  if (!found.is_manifold() || found.components != reference.components)
    return false;
  if (found.is_closed())
    return found.euler_characteristic == reference.euler_characteristic + static_cast<long>(reference.boundary_loops);
  return found.boundary_loops == reference.boundary_loops &&
         found.euler_characteristic == reference.euler_characteristic;
}

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MEASURES_MESH_STATISTICS_H

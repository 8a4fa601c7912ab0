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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_VALIDATION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_VALIDATION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {
namespace validation {

// Checks of index triples by definition, for tests and expensive assertions. They share no code with
// the stages that they check and assume nothing about the triples but valid indices.

using Index_triple = std::array<std::size_t, 3>;

// Whether all indices are below `number_of_points` and the three of a triangle are distinct.
inline bool are_indices_valid(const std::vector<Index_triple>& triangles, std::size_t number_of_points)
{
  return std::all_of(triangles.begin(), triangles.end(), [&](const Index_triple& t) {
    return t[0] < number_of_points && t[1] < number_of_points && t[2] < number_of_points && t[0] != t[1] &&
           t[1] != t[2] && t[2] != t[0];
  });
}

template <typename PointRange, typename Traits>
bool has_degenerate_triangle(const PointRange& points, const std::vector<Index_triple>& triangles, const Traits& traits)
{
  const auto collinear = traits.collinear_3_object();
  return std::any_of(triangles.begin(), triangles.end(),
                     [&](const Index_triple& t) { return collinear(points[t[0]], points[t[1]], points[t[2]]); });
}

// A side of a triangle; `vertices` in increasing order.
struct Triangle_side
{
  std::array<std::size_t, 2> vertices;
  std::size_t triangle;
  bool is_reversed; // the triangle traverses it from the larger vertex to the smaller

  bool is_same_edge(const Triangle_side& other) const { return vertices == other.vertices; }
};

// The sides of all triangles, those at one edge next to each other.
inline std::vector<Triangle_side> sorted_sides(const std::vector<Index_triple>& triangles)
{
  std::vector<Triangle_side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t != triangles.size(); ++t)
    for (std::size_t i = 0; i != 3; ++i) {
      const std::size_t u = triangles[t][i], v = triangles[t][i == 2 ? 0 : i + 1];
      sides.push_back(Triangle_side{ { (std::min)(u, v), (std::max)(u, v) }, t, v < u });
    }
  std::sort(sides.begin(), sides.end(), [](const Triangle_side& a, const Triangle_side& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.triangle < b.triangle;
  });
  return sides;
}

// Calls visit(begin, end) with the sides at each edge.
template <typename Visit>
void for_each_edge(const std::vector<Triangle_side>& sides, Visit visit)
{
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end = std::find_if(begin, sides.end(), [&](const Triangle_side& s) { return !s.is_same_edge(*begin); });
    visit(begin, end);
    begin = end;
  }
}

// Whether no edge has more than two triangles.
inline bool is_edge_manifold(const std::vector<Index_triple>& triangles)
{
  bool result = true;
  for_each_edge(sorted_sides(triangles), [&](auto begin, auto end) { result = result && end - begin <= 2; });
  return result;
}

// Whether no two triangles traverse an edge in the same direction.
inline bool is_consistently_oriented(const std::vector<Index_triple>& triangles)
{
  bool result = true;
  for_each_edge(sorted_sides(triangles), [&](auto begin, auto end) {
    const auto reversed = std::count_if(begin, end, [](const Triangle_side& s) { return s.is_reversed; });
    result = result && reversed <= 1 && (end - begin) - reversed <= 1;
  });
  return result;
}

// The edges of a single triangle, in the direction in which it traverses them.
inline std::vector<std::array<std::size_t, 2> > boundary_edges(const std::vector<Index_triple>& triangles)
{
  std::vector<std::array<std::size_t, 2> > result;
  for_each_edge(sorted_sides(triangles), [&](auto begin, auto end) {
    if (end - begin != 1)
      return;
    const auto& v = begin->vertices;
    result.push_back(begin->is_reversed ? std::array<std::size_t, 2>{ v[1], v[0] } : v);
  });
  return result;
}

inline std::vector<std::size_t> used_points(const std::vector<Index_triple>& triangles)
{
  std::vector<std::size_t> result;
  for (const Index_triple& t : triangles)
    result.insert(result.end(), t.begin(), t.end());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

inline long euler_characteristic(const std::vector<Index_triple>& triangles)
{
  long edges = 0;
  for_each_edge(sorted_sides(triangles), [&](auto, auto) { ++edges; });
  return static_cast<long>(used_points(triangles).size() + triangles.size()) - edges;
}

// Disjoint sets of the numbers below n.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t n) : m_parents(n)
  {
    std::iota(m_parents.begin(), m_parents.end(), std::size_t(0));
  }

  std::size_t find(std::size_t i)
  {
    while (m_parents[i] != i) {
      m_parents[i] = m_parents[m_parents[i]];
      i = m_parents[i];
    }
    return i;
  }

  void unite(std::size_t i, std::size_t j) { m_parents[find(i)] = find(j); }

private:
  std::vector<std::size_t> m_parents;
};

// The number of the component of each triangle; components are connected through edges.
inline std::vector<std::size_t> component_of_triangles(const std::vector<Index_triple>& triangles)
{
  Disjoint_sets sets(triangles.size());
  for_each_edge(sorted_sides(triangles), [&](auto begin, auto end) {
    for (auto side = begin + 1; side < end; ++side)
      sets.unite(begin->triangle, side->triangle);
  });
  const std::size_t unset = triangles.size();
  std::vector<std::size_t> number_of_root(triangles.size(), unset), result;
  std::size_t next = 0;
  for (std::size_t t = 0; t != triangles.size(); ++t) {
    std::size_t& number = number_of_root[sets.find(t)];
    if (number == unset)
      number = next++;
    result.push_back(number);
  }
  return result;
}

inline std::size_t number_of_components(const std::vector<Index_triple>& triangles)
{
  const std::vector<std::size_t> components = component_of_triangles(triangles);
  return components.empty() ? 0 : 1 + *std::max_element(components.begin(), components.end());
}

// Corner i of triangle t has the number 3 t + i; the sets are the fans of triangles that a walk
// across edges reaches around a vertex.
inline Disjoint_sets fans_of_corners(const std::vector<Index_triple>& triangles)
{
  Disjoint_sets fans(3 * triangles.size());
  const auto corner = [&](std::size_t triangle, std::size_t vertex) {
    const Index_triple& t = triangles[triangle];
    return 3 * triangle + (t[0] == vertex ? 0u : t[1] == vertex ? 1u : 2u);
  };
  for_each_edge(sorted_sides(triangles), [&](auto begin, auto end) {
    for (auto side = begin + 1; side < end; ++side)
      for (std::size_t v : begin->vertices)
        fans.unite(corner(begin->triangle, v), corner(side->triangle, v));
  });
  return fans;
}

// Whether the triangles at each vertex form one fan, and at most two share an edge.
inline bool is_vertex_manifold(const std::vector<Index_triple>& triangles)
{
  Disjoint_sets fans = fans_of_corners(triangles);
  std::vector<std::size_t> vertices;
  for (std::size_t corner = 0; corner != 3 * triangles.size(); ++corner)
    if (fans.find(corner) == corner)
      vertices.push_back(triangles[corner / 3][corner % 3]);
  std::sort(vertices.begin(), vertices.end());
  return std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end() && is_edge_manifold(triangles);
}

// Boundary edges that follow one another around a vertex belong to one loop. Requires a manifold.
inline std::size_t number_of_boundary_loops(const std::vector<Index_triple>& triangles)
{
  const std::vector<std::array<std::size_t, 2> > edges = boundary_edges(triangles);
  const std::vector<std::size_t> vertices = used_points(triangles);
  const auto position = [&](std::size_t v) {
    return static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
  };
  Disjoint_sets loops(vertices.size());
  for (const auto& edge : edges)
    loops.unite(position(edge[0]), position(edge[1]));
  std::vector<std::size_t> roots;
  for (const auto& edge : edges)
    roots.push_back(loops.find(position(edge[0])));
  std::sort(roots.begin(), roots.end());
  return static_cast<std::size_t>(std::unique(roots.begin(), roots.end()) - roots.begin());
}

// What every reconstruction guarantees: valid indices, an oriented 2-manifold, no collinear triangle.
template <typename PointRange, typename Traits>
bool is_oriented_manifold(const PointRange& points, const std::vector<Index_triple>& triangles, const Traits& traits)
{
  return are_indices_valid(triangles, points.size()) && is_vertex_manifold(triangles) &&
         is_consistently_oriented(triangles) && !has_degenerate_triangle(points, triangles, traits);
}

} // namespace validation
} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_VALIDATION_H

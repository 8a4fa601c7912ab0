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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_MARCHING_TETRAHEDRA_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_MARCHING_TETRAHEDRA_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Tetrahedra_contour.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The zero set of a function on a regular grid, followed from cubes where it is known to be. A cube is
// cut into six tetrahedra along its diagonal; those of adjacent cubes fit together, so that the
// surface is a closed manifold.
template <typename Function>
class Marching_tetrahedra
{
public:
  using Coordinates = std::array<double, 3>;
  using Triangle = Tetrahedra_contour::Triangle;

  // `function(x)` is negative inside.
  Marching_tetrahedra(const Function& function, const Coordinates& origin, double step, std::size_t maximum_cells)
    : m_function(function), m_origin(origin), m_step(step), m_maximum_cells(maximum_cells)
  { }

  // The surface may pass through the cube of x or through one beside it.
  void add_seed(const Coordinates& x)
  {
    Index cube;
    for (std::size_t a = 0; a != 3; ++a)
      cube[a] = static_cast<std::int32_t>(std::floor((x[a] - m_origin[a]) / m_step));
    visit(cube);
    visit_neighbors(cube);
  }

  void operator()()
  {
    for (std::size_t k = 0; k != m_cubes.size(); ++k) {
      const Index cube = m_cubes[k];
      std::array<Corner, 8> corners;
      std::size_t inside = 0;
      for (unsigned int i = 0; i != 8; ++i) {
        corners[i] = corner(moved(cube, i));
        inside += m_values[corners[i]] < 0. ? 1u : 0u;
      }
      if (inside == 0 || inside == 8)
        continue;
      cut_cube(corners);
      visit_neighbors(cube);
    }
    place_vertices();
  }

  const std::vector<Coordinates>& vertices() const { return m_vertices; }
  const std::vector<Triangle>& triangles() const { return m_contour.triangles(); }
  std::size_t number_of_visited_cubes() const { return m_cubes.size(); }

private:
  using Corner = Tetrahedra_contour::Corner;
  using Index = std::array<std::int32_t, 3>;

  struct Hash
  {
    std::size_t operator()(const Index& i) const
    {
      std::uint64_t h = 0;
      for (std::int32_t c : i)
        h = (h ^ static_cast<std::uint32_t>(c)) * 0x9E3779B97F4A7C15u, h ^= h >> 29;
      return static_cast<std::size_t>(h);
    }
  };

  // Of the corners of a cube, bit a of the number is the step along axis a.
  static Index moved(const Index& i, unsigned int corner)
  {
    return Index{ { i[0] + std::int32_t(corner & 1u), i[1] + std::int32_t(corner >> 1 & 1u),
                    i[2] + std::int32_t(corner >> 2) } };
  }

  Coordinates coordinates(const Index& i) const
  {
    return Coordinates{ { m_origin[0] + i[0] * m_step, m_origin[1] + i[1] * m_step, m_origin[2] + i[2] * m_step } };
  }

  Corner corner(const Index& i)
  {
    const auto it = m_corner_at.emplace(i, static_cast<Corner>(m_points.size()));
    if (it.second) {
      m_points.push_back(coordinates(i));
      m_values.push_back(m_function(m_points.back()));
    }
    return it.first->second;
  }

  void visit(const Index& cube)
  {
    if (!m_is_visited.insert(cube).second)
      return;
    if (m_cubes.size() == m_maximum_cells)
      throw std::invalid_argument("step: more than " + std::to_string(m_maximum_cells) + " cells would be needed");
    m_cubes.push_back(cube);
  }

  void visit_neighbors(const Index& cube)
  {
    for (std::size_t a = 0; a != 3; ++a)
      for (std::int32_t by : { -1, 1 }) {
        Index neighbor = cube;
        neighbor[a] += by;
        visit(neighbor);
      }
  }

  // One tetrahedron for each order of the axes: from corner 0 along the axes to corner 7.
  void cut_cube(const std::array<Corner, 8>& corners)
  {
    static constexpr unsigned int orders[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 1, 0 }, { 2, 1 }, { 0, 2 } };
    for (std::size_t k = 0; k != 6; ++k) {
      const unsigned int first = 1u << orders[k][0], second = first | 1u << orders[k][1];
      // the first three are even permutations, and positively oriented
      m_contour.add({ { corners[0], corners[first], corners[second], corners[7] } }, m_values, k < 3);
    }
  }

  // The function is taken for linear along an edge.
  void place_vertices()
  {
    for (const Tetrahedra_contour::Edge& edge : m_contour.vertices()) {
      const Coordinates &x = m_points[edge.first], &y = m_points[edge.second];
      const double t = m_values[edge.first] / (m_values[edge.first] - m_values[edge.second]);
      m_vertices.push_back({ { x[0] + t * (y[0] - x[0]), x[1] + t * (y[1] - x[1]), x[2] + t * (y[2] - x[2]) } });
    }
  }

  const Function& m_function;
  const Coordinates m_origin;
  const double m_step;
  const std::size_t m_maximum_cells;
  std::vector<Index> m_cubes; // in the order of their visit
  std::unordered_set<Index, Hash> m_is_visited;
  std::unordered_map<Index, Corner, Hash> m_corner_at;
  std::vector<Coordinates> m_points; // of the corners
  std::vector<double> m_values;
  Tetrahedra_contour m_contour;
  std::vector<Coordinates> m_vertices;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_MARCHING_TETRAHEDRA_H

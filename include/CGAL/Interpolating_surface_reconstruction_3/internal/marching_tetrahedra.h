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
  using Triangle = std::array<std::size_t, 3>;

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
      std::array<double, 8> values;
      std::size_t inside = 0;
      for (unsigned int corner = 0; corner != 8; ++corner) {
        values[corner] = value(moved(cube, corner));
        inside += values[corner] < 0. ? 1u : 0u;
      }
      if (inside == 0 || inside == 8)
        continue;
      cut_cube(cube, values);
      visit_neighbors(cube);
    }
  }

  const std::vector<Coordinates>& vertices() const { return m_vertices; }
  const std::vector<Triangle>& triangles() const { return m_triangles; }

private:
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

  double value(const Index& i)
  {
    const auto it = m_values.emplace(i, 0.);
    if (it.second)
      it.first->second = m_function(coordinates(i));
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
  void cut_cube(const Index& cube, const std::array<double, 8>& values)
  {
    static constexpr unsigned int orders[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 1, 0 }, { 2, 1 }, { 0, 2 } };
    for (std::size_t k = 0; k != 6; ++k) {
      const unsigned int first = 1u << orders[k][0], second = first | 1u << orders[k][1];
      // the first three are even permutations, and positively oriented
      cut_tetrahedron(cube, values, { { 0u, first, second, 7u } }, k < 3);
    }
  }

  void cut_tetrahedron(const Index& cube, const std::array<double, 8>& values, std::array<unsigned int, 4> v,
                       bool is_positive)
  {
    // those inside first; every swap changes the orientation
    std::size_t inside = 0;
    for (std::size_t i = 0; i != 4; ++i)
      if (values[v[i]] < 0.) {
        if (i != inside) {
          std::swap(v[i], v[inside]);
          is_positive = !is_positive;
        }
        ++inside;
      }
    const auto at = [&](std::size_t i, std::size_t j) { return vertex(cube, values, v[i], v[j]); };
    if (inside == 1)
      add(at(0, 1), at(0, 2), at(0, 3), is_positive);
    else if (inside == 3)
      add(at(0, 3), at(1, 3), at(2, 3), is_positive);
    else if (inside == 2) {
      const std::size_t a = at(0, 2), b = at(0, 3), c = at(1, 3), d = at(1, 2);
      add(a, b, c, is_positive);
      add(a, c, d, is_positive);
    }
  }

  void add(std::size_t a, std::size_t b, std::size_t c, bool is_positive)
  {
    m_triangles.push_back(is_positive ? Triangle{ { a, b, c } } : Triangle{ { a, c, b } });
  }

  // On the edge from corner p to corner q, one of which has all the bits of the other.
  std::size_t vertex(const Index& cube, const std::array<double, 8>& values, unsigned int p, unsigned int q)
  {
    const unsigned int low = (std::min)(p, q), high = (std::max)(p, q);
    const auto it = m_vertex_on[high ^ low].emplace(moved(cube, low), m_vertices.size());
    if (it.second) {
      const double t = values[low] / (values[low] - values[high]);
      const Coordinates x = coordinates(moved(cube, low)), y = coordinates(moved(cube, high));
      m_vertices.push_back({ { x[0] + t * (y[0] - x[0]), x[1] + t * (y[1] - x[1]), x[2] + t * (y[2] - x[2]) } });
    }
    return it.first->second;
  }

  const Function& m_function;
  const Coordinates m_origin;
  const double m_step;
  const std::size_t m_maximum_cells;
  std::vector<Index> m_cubes; // in the order of their visit
  std::unordered_set<Index, Hash> m_is_visited;
  std::unordered_map<Index, double, Hash> m_values;                        // at the corners
  std::array<std::unordered_map<Index, std::size_t, Hash>, 8> m_vertex_on; // of the edges, by direction
  std::vector<Coordinates> m_vertices;
  std::vector<Triangle> m_triangles;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_MARCHING_TETRAHEDRA_H

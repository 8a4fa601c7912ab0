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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TETRAHEDRA_CONTOUR_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TETRAHEDRA_CONTOUR_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The zero set of a function in the tetrahedra of a complex, by the signs at their corners. If the
// tetrahedra fit together and fill a ball, it is a manifold, closed if all signs on the boundary of the
// ball are the same; and it does not cross itself if its vertices stay in the interior of their edges.
class Tetrahedra_contour
{
public:
  using Corner = std::uint32_t;
  using Triangle = std::array<std::size_t, 3>;
  using Edge = std::pair<Corner, Corner>; // from the inside to the outside

  // A value below zero is inside. Positive tetrahedra have Orientation_3 positive.
  void add(std::array<Corner, 4> v, const std::vector<double>& values, bool is_positive)
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
    const auto at = [&](std::size_t i, std::size_t j) { return vertex(v[i], v[j]); };
    if (inside == 1)
      add_triangle(at(0, 1), at(0, 2), at(0, 3), is_positive);
    else if (inside == 3)
      add_triangle(at(0, 3), at(1, 3), at(2, 3), is_positive);
    else if (inside == 2) {
      const std::size_t a = at(0, 2), b = at(0, 3), c = at(1, 3), d = at(1, 2);
      add_triangle(a, b, c, is_positive);
      add_triangle(a, c, d, is_positive);
    }
  }

  // The edges that the vertices lie on.
  const std::vector<Edge>& vertices() const { return m_vertices; }
  const std::vector<Triangle>& triangles() const { return m_triangles; }

private:
  std::size_t vertex(Corner inside, Corner outside)
  {
    const auto it = m_vertex_on.emplace(std::uint64_t(inside) << 32 | outside, m_vertices.size());
    if (it.second)
      m_vertices.emplace_back(inside, outside);
    return it.first->second;
  }

  void add_triangle(std::size_t a, std::size_t b, std::size_t c, bool is_positive)
  {
    m_triangles.push_back(is_positive ? Triangle{ { a, b, c } } : Triangle{ { a, c, b } });
  }

  std::unordered_map<std::uint64_t, std::size_t> m_vertex_on;
  std::vector<Edge> m_vertices;
  std::vector<Triangle> m_triangles;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TETRAHEDRA_CONTOUR_H

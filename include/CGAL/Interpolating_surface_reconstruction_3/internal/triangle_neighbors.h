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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TRIANGLE_NEIGHBORS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TRIANGLE_NEIGHBORS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Of each triangle; neighbor i shares the edge from vertex i to the next.
using Triangle_neighbors = std::vector<std::array<std::uint32_t, 3> >;

// The neighbors of the triangles of a closed manifold; there are none if an edge has one triangle only.
inline Triangle_neighbors neighbors_of_closed_surface(const std::vector<std::array<Point_index, 3> >& triangles)
{
  struct Side
  {
    Point_index low, high;
    std::uint32_t triangle, index;
    bool operator<(const Side& other) const { return low < other.low || (low == other.low && high < other.high); }
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t != triangles.size(); ++t)
    for (std::uint32_t i = 0; i != 3; ++i) {
      const Point_index p = triangles[t][i], q = triangles[t][(i + 1) % 3];
      sides.push_back(Side{ (std::min)(p, q), (std::max)(p, q), t, i });
    }
  std::sort(sides.begin(), sides.end());
  Triangle_neighbors neighbors(triangles.size());
  for (std::size_t s = 0; s != sides.size(); s += 2) {
    if (s + 1 == sides.size() || sides[s] < sides[s + 1])
      return {};
    neighbors[sides[s].triangle][sides[s].index] = sides[s + 1].triangle;
    neighbors[sides[s + 1].triangle][sides[s + 1].index] = sides[s].triangle;
  }
  return neighbors;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TRIANGLE_NEIGHBORS_H

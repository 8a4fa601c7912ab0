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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TRIANGLE_INTERSECTION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TRIANGLE_INTERSECTION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/enum.h>
#include <CGAL/intersections.h>

#include <array>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// A position in a kernel with exact predicates.
inline Exact_predicates_inexact_constructions_kernel::Point_3 exact_point(const Local_point& p)
{
  return { p.x(), p.y(), p.z() };
}

// Whether a triangle is degenerate, as only predicates that are not exact take for one of a surface.
template <typename Index, typename PointOf>
bool is_degenerate(const std::array<Index, 3>& t, const PointOf& point)
{
  return collinear(point(t[0]), point(t[1]), point(t[2]));
}

// Whether two triangles of a mesh, none of them degenerate, meet in more than their common vertices and
// edges. `point(v)` is the position of a vertex in a kernel with exact predicates.
template <typename Index, typename PointOf>
bool do_triangles_cross(const std::array<Index, 3>& s, const std::array<Index, 3>& t, const PointOf& point)
{
  using Kernel = typename Kernel_traits<std::decay_t<decltype(point(s[0]))> >::Kernel;
  using Triangle = typename Kernel::Triangle_3;
  using Segment = typename Kernel::Segment_3;
  std::size_t shared = 0, i = 0, j = 0; // the last common vertex is corner i of s and corner j of t
  std::size_t sum_i = 0, sum_j = 0;
  for (std::size_t a = 0; a != 3; ++a)
    for (std::size_t b = 0; b != 3; ++b)
      if (s[a] == t[b]) {
        ++shared;
        sum_i += i = a;
        sum_j += j = b;
      }
  const auto triangle = [&](const std::array<Index, 3>& u) { return Triangle(point(u[0]), point(u[1]), point(u[2])); };
  const auto opposite_edge = [&](const std::array<Index, 3>& u, std::size_t k) {
    return Segment(point(u[(k + 1) % 3]), point(u[(k + 2) % 3]));
  };
  if (shared == 0)
    return do_intersect(triangle(s), triangle(t));
  if (shared == 1)
    return do_intersect(triangle(s), opposite_edge(t, j)) || do_intersect(triangle(t), opposite_edge(s, i));
  if (shared == 3)
    return true;
  // With a common edge, they cross if they overlap in one plane; the corners off the edge are 3 minus the others.
  const auto& a = point(s[(4 - sum_i) % 3]);
  const auto& b = point(s[(5 - sum_i) % 3]);
  const auto& c = point(s[3 - sum_i]);
  const auto& d = point(t[3 - sum_j]);
  return coplanar(a, b, c, d) && coplanar_orientation(a, b, c, d) == POSITIVE;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TRIANGLE_INTERSECTION_H

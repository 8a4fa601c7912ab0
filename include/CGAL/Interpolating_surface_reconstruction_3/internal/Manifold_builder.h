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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_MANIFOLD_BUILDER_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_MANIFOLD_BUILDER_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/star_compatibility.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Surface_triangles.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The only owner of triangles, and the gate that keeps them an orientable 2-manifold: at most two
// triangles an edge, no fan at a vertex besides a closed one, consistent orientation.
template <typename Predicates>
class Manifold_builder : public Surface_triangles
{
public:
  Manifold_builder(Star_compatibility& compatibility, const Predicates& predicates)
    : Surface_triangles(compatibility), m_predicates(predicates)
  { }

  const Predicates& predicates() const { return m_predicates; }

  // Attaches the triangle (p, q, r) if the surface stays a manifold.
  Triangle_verdict try_add(Point_index p, Point_index q, Point_index r)
  {
    const Triangle_verdict verdict = check(p, q, r);
    if (verdict == Triangle_verdict::ADDED)
      add(p, q, r);
    return verdict;
  }

private:
  // A vertex takes no more triangles than these, so that the time for all triangles is linear in their
  // number. A star has less than a tenth of it.
  static constexpr std::size_t MAXIMUM_DEGREE = 1024;

  Triangle_verdict check(Point_index p, Point_index q, Point_index r)
  {
    if (!is_open(p) || !is_open(q) || !is_open(r))
      return Triangle_verdict::VERTEX_FULL;
    if (find_triangle(p, q, r) != NO_TRIANGLE)
      return Triangle_verdict::DUPLICATE;
    if (m_predicates.is_degenerate(p, q, r))
      return Triangle_verdict::DEGENERATE;
    if (number_of_triangles(p, q) == 2 || number_of_triangles(q, r) == 2 || number_of_triangles(r, p) == 2)
      return Triangle_verdict::EDGE_FULL;
    if (corners(p).size() >= MAXIMUM_DEGREE || corners(q).size() >= MAXIMUM_DEGREE ||
        corners(r).size() >= MAXIMUM_DEGREE)
      return Triangle_verdict::VERTEX_FULL;
    if (is_vertex_full(p, q, r) || is_vertex_full(q, r, p) || is_vertex_full(r, p, q))
      return Triangle_verdict::VERTEX_FULL;
    if (is_folded(p, q, r) || is_folded(q, r, p) || is_folded(r, p, q))
      return Triangle_verdict::FOLDED;
    return is_orientable(adjacent_triangles(p, q, r)) ? Triangle_verdict::ADDED : Triangle_verdict::NOT_ORIENTABLE;
  }

  // Whether p has a closed fan, or the link edge (q, r) closes a fan of p while p has other triangles.
  bool is_vertex_full(Point_index p, Point_index q, Point_index r) const
  {
    if (is_fan_closed(p))
      return true;
    if (number_of_triangles(p, q) == 0 || number_of_triangles(p, r) == 0)
      return false;
    const Fan fan = fan_from(p, q);
    return fan.size != 0 && fan.end == r && fan.size != corners(p).size();
  }

  // Whether the triangle (p, q, r) lies on the triangle at its edge (p, q).
  bool is_folded(Point_index p, Point_index q, Point_index r) const
  {
    const Point_index opposite = opposite_vertex(p, q);
    return opposite != NO_POINT && m_predicates.is_folded(p, q, r, opposite);
  }

  bool is_orientable(const std::array<Adjacent, 3>& adjacent)
  {
    std::array<Parity_union_find::Oriented_root, 3> roots;
    for (std::size_t i = 0; i != 3; ++i) {
      if (adjacent[i].triangle == NO_TRIANGLE)
        continue;
      roots[i] = orientation(adjacent[i].triangle);
      roots[i].is_flipped = roots[i].is_flipped != adjacent[i].is_flipped;
      for (std::size_t j = 0; j != i; ++j)
        if (adjacent[j].triangle != NO_TRIANGLE && roots[i].root == roots[j].root &&
            roots[i].is_flipped != roots[j].is_flipped)
          return false;
    }
    return true;
  }

  const Predicates& m_predicates;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_MANIFOLD_BUILDER_H

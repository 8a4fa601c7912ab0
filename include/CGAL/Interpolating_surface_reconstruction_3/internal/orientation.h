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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ORIENTATION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ORIENTATION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/determinant.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Decides which way each connected component of a surface faces: along the given normals if there
// are any, else outward. The sign of the volume of a closed component is exact: where the bound on
// the rounding error does not certify it, it is computed with rational numbers.
template <typename Builder>
class Surface_orientation
{
public:
  using Triangle = typename Builder::Triangle;

  Surface_orientation(const std::vector<Local_point>& points, Builder& builder)
    : m_points(points), m_builder(builder), m_components(points.size()), m_facing(points.size())
  {
    find_components();
  }

  // `normal_of(p)` is the given normal at p.
  template <typename NormalOf>
  void align_with_normals(const NormalOf& normal_of)
  {
    for_each_triangle([&](const Triangle& t, Facing& facing) {
      const Local_vector n = cross_product(m_points[t[1]] - m_points[t[0]], m_points[t[2]] - m_points[t[0]]);
      for (Point_index p : t)
        facing.sum += n * normal_of(p);
    });
  }

  // A component with a boundary has no outside: it faces away from the side to which it is bent, or
  // either way if it is flat. Ends early if go_further() is false.
  template <typename GoFurther>
  void face_outward(const GoFurther& go_further)
  {
    for_each_triangle([&](const Triangle& t, Facing& facing) {
      if (facing.reference == NO_POINT)
        facing.reference = t[0];
      const Local_point& o = m_points[facing.reference];
      const Local_vector u = m_points[t[0]] - o, v = m_points[t[1]] - o, w = m_points[t[2]] - o;
      const double volume = cross_product(u, v) * w;
      facing.sum += volume;
      facing.error += ROUNDING * std::sqrt(u.squared_length() * v.squared_length() * w.squared_length());
    });
    if (go_further())
      decide_exactly(go_further);
  }

  void face_outward()
  {
    face_outward([] { return true; });
  }

  // Calls visit(triangle) for every triangle, oriented.
  template <typename Visit>
  void for_each_oriented_triangle(Visit visit)
  {
    for_each_triangle([&](const Triangle& t, const Facing& facing) {
      visit(facing.sum < 0. ? Triangle{ { t[0], t[2], t[1] } } : t);
    });
  }

  std::size_t number_of_triangles() const { return m_number_of_triangles; }

private:
  struct Facing
  {
    double sum = 0., error = 0.;
    Point_index reference = NO_POINT;
    bool has_boundary = false;
    std::size_t exact = 0; // position among the exact volumes, counted from 1
  };

  // Rounding error of a 3 x 3 determinant relative to the lengths of its rows, with a margin that
  // covers the accumulation over as many triangles as there are.
  static constexpr double ROUNDING = 1e-14;

  static constexpr std::size_t TRIANGLES_PER_POLL = 4096;

  void find_components()
  {
    m_builder.for_each_triangle([&](const Triangle& t, Parity_union_find::Element) {
      m_components.unite(t[0], t[1], false);
      m_components.unite(t[0], t[2], false);
      ++m_number_of_triangles;
    });
  }

  // The triangles as their connected part orients them.
  template <typename Visit>
  void for_each_triangle(Visit visit)
  {
    m_builder.for_each_triangle([&](const Triangle& t, Parity_union_find::Element e) {
      const bool is_flipped = m_builder.orientations().find(e).is_flipped;
      visit(is_flipped ? Triangle{ { t[0], t[2], t[1] } } : t, m_facing[m_components.find(t[0]).root]);
    });
  }

  template <typename GoFurther>
  void decide_exactly(const GoFurther& go_further)
  {
    mark_boundaries();
    std::vector<Exact_rational> volumes;
    for (Facing& facing : m_facing)
      if (facing.reference != NO_POINT && !facing.has_boundary && std::abs(facing.sum) <= facing.error) {
        volumes.emplace_back(0);
        facing.exact = volumes.size();
      }
    if (volumes.empty())
      return;
    std::size_t triangles = 0;
    for_each_triangle([&](const Triangle& t, const Facing& facing) {
      if (facing.exact != 0 && (triangles++ % TRIANGLES_PER_POLL != 0 || go_further()))
        volumes[facing.exact - 1] += exact_volume(t, facing.reference);
    });
    for (Facing& facing : m_facing)
      if (facing.exact != 0)
        facing.sum = CGAL::sign(volumes[facing.exact - 1]) == NEGATIVE ? -1. : 1.;
  }

  // Points on a boundary are open.
  void mark_boundaries()
  {
    for (Point_index p : m_builder.open_points())
      if (!m_builder.corners(p).empty() && m_builder.number_of_boundary_edges(p) != 0)
        m_facing[m_components.find(p).root].has_boundary = true;
  }

  Exact_rational exact_volume(const Triangle& t, Point_index reference) const
  {
    std::array<std::array<Exact_rational, 3>, 3> rows;
    for (std::size_t i = 0; i != 3; ++i)
      for (std::size_t a = 0; a != 3; ++a)
        rows[i][a] = Exact_rational(m_points[t[i]][int(a)]) - Exact_rational(m_points[reference][int(a)]);
    return CGAL::determinant(rows[0][0], rows[0][1], rows[0][2], rows[1][0], rows[1][1], rows[1][2], rows[2][0],
                             rows[2][1], rows[2][2]);
  }

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  Parity_union_find m_components;
  std::vector<Facing> m_facing; // of the representatives
  std::size_t m_number_of_triangles = 0;
};

// The triangles of the surface. Their components face along `normals` of the points, or outward if there are none. Ends
// early if go_further() is false.
template <typename Builder, typename GoFurther>
std::vector<std::array<Point_index, 3> > oriented_triangles(const std::vector<Local_point>& points,
                                                            const std::vector<Local_vector>& normals, Builder& builder,
                                                            const GoFurther& go_further)
{
  Surface_orientation<Builder> orientation(points, builder);
  if (normals.empty())
    orientation.face_outward(go_further);
  else
    orientation.align_with_normals([&](Point_index p) { return normals[p]; });
  std::vector<std::array<Point_index, 3> > result;
  orientation.for_each_oriented_triangle([&](const typename Builder::Triangle& t) { result.push_back(t); });
  return result;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ORIENTATION_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STAR_DIAGONALS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STAR_DIAGONALS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Clipped_polygon.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Tangent_projection.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_measures.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Point_star.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Decides the diagonals of the quadrangles around a point p whose four points are nearly cocircular.
// Their tangent planes would decide differently, and the charts would not be compatible. Therefore
// the choice between the diagonals pr and qs of the quadrangle p, q, r, s is made by a measure of
// the four points in space that is the same seen from each of them: of the two pairs of triangles, the
// one whose larger circumscribed circle is smaller.
template <std::size_t MaximumSize>
class Star_diagonals
{
public:
  using Vector_3 = Star_neighborhood::Vector_3;

  // `polygon` is the restricted Voronoi cell in the frame of the projection, and `squared_radius` that of its
  // farthest vertex.
  Star_diagonals(const Star_neighborhood& neighborhood, const Tangent_projection<MaximumSize>& projection,
                 const Clipped_polygon& polygon, double squared_radius)
    : m_neighborhood(neighborhood), m_projection(projection), m_polygon(polygon)
  {
    find_near_misses(squared_radius);
  }

  // Fills the link with the makers of the polygon's edges, but for the diagonals that change.
  void settle(std::vector<std::uint32_t>& link) const
  {
    link_with_additional_diagonals(link);
    remove_diagonals(link);
  }

private:
  // A neighbor that nearly cuts off a vertex of the polygon: the value at the vertex of the linear
  // function that is 1 on its bisector.
  struct Near_miss
  {
    std::uint32_t neighbor;
    double value;
  };

  // A quadrangle is worth a look if the fourth point would have to come closer by this part of its
  // distance. The choice hardly matters between .2 and .6: farther points do not win.
  static constexpr double NEAR = .4;

  // Of circles, as a part.
  static constexpr double ROUNDING = 1e-9;

  void find_near_misses(double squared_radius)
  {
    for (std::size_t i = 0; i != m_polygon.size(); ++i)
      m_near_misses[i] = Near_miss{ Point_star::GAP, 1. - NEAR };
    const double reach = 2. * squared_radius / ((1. - NEAR) * (1. - NEAR));
    std::bitset<MaximumSize> has_edge;
    for (std::size_t i = 0; i != m_polygon.size(); ++i)
      if (m_polygon.maker(i) != Point_star::GAP)
        has_edge.set(m_polygon.maker(i));
    Clipped_polygon::Values values;
    for (std::size_t i = 0; i != m_projection.size() && m_projection.half_square(i) < reach; ++i) {
      if (has_edge[i])
        continue;
      const double largest = m_polygon.evaluate(m_projection.x(i), m_projection.y(i), values);
      if (!(largest > (1. - NEAR) * m_projection.half_square(i)))
        continue;
      const auto vertex = static_cast<std::size_t>(
        std::find(values.begin(), values.begin() + m_polygon.size(), largest) - values.begin());
      const double value = largest / m_projection.half_square(i);
      if (value > m_near_misses[vertex].value)
        m_near_misses[vertex] = Near_miss{ static_cast<std::uint32_t>(i), value };
    }
  }

  void link_with_additional_diagonals(std::vector<std::uint32_t>& link) const
  {
    for (std::size_t i = 0; i != m_polygon.size(); ++i) {
      const std::uint32_t q = m_polygon.maker(i == 0 ? m_polygon.size() - 1 : i - 1), r = m_near_misses[i].neighbor,
                          s = m_polygon.maker(i);
      if (r != Point_star::GAP && q != Point_star::GAP && s != Point_star::GAP && is_between(q, r, s) &&
          is_own_diagonal_better(q, r, s))
        link.push_back(r);
      if (s != Point_star::GAP || link.empty() || link.back() != Point_star::GAP)
        link.push_back(s);
    }
    if (link.size() > 1 && link.front() == Point_star::GAP && link.back() == Point_star::GAP)
      link.pop_back();
  }

  // Whether r is seen between q and s. Rounding may ascribe a near miss to the other end of a tiny edge.
  bool is_between(std::uint32_t q, std::uint32_t r, std::uint32_t s) const
  {
    return x(q) * y(r) > y(q) * x(r) && x(r) * y(s) > y(r) * x(s);
  }

  void remove_diagonals(std::vector<std::uint32_t>& link) const
  {
    for (std::size_t i = 0; i != link.size() && link.size() > 3;) {
      const std::uint32_t q = link[i == 0 ? link.size() - 1 : i - 1], r = link[i],
                          s = link[i + 1 == link.size() ? 0 : i + 1];
      if (q != Point_star::GAP && r != Point_star::GAP && s != Point_star::GAP && is_dispensable(q, r, s) &&
          !is_own_diagonal_better(q, r, s))
        link.erase(link.begin() + std::ptrdiff_t(i));
      else
        ++i;
    }
  }

  // Whether the quadrangle is convex in the tangent plane, and r nearly misses the vertex of the
  // polygon that q and s would make without it.
  bool is_dispensable(std::uint32_t q, std::uint32_t r, std::uint32_t s) const
  {
    const double qx = x(q), qy = y(q), rx = x(r), ry = y(r), sx = x(s), sy = y(s);
    const double determinant = qx * sy - qy * sx;
    if (determinant <= 0. || (sx - qx) * (ry - qy) - (sy - qy) * (rx - qx) >= 0.)
      return false;
    const double cq = half_square(q), cs = half_square(s);
    const double vx = (cq * sy - cs * qy) / determinant, vy = (qx * cs - sx * cq) / determinant;
    return rx * vx + ry * vy < half_square(r) * (1. + NEAR);
  }

  double x(std::uint32_t i) const { return m_projection.x(i); }
  double y(std::uint32_t i) const { return m_projection.y(i); }
  double half_square(std::uint32_t i) const { return m_projection.half_square(i); }

  // Of the diagonals from the point to r and from q to s.
  bool is_own_diagonal_better(std::uint32_t q_index, std::uint32_t r_index, std::uint32_t s_index) const
  {
    const Vector_3 p(0, 0, 0);
    const Vector_3 &q = m_neighborhood[q_index], &r = m_neighborhood[r_index], &s = m_neighborhood[s_index];
    const double own = (std::max)(squared_circumdiameter(p, q, r), squared_circumdiameter(p, r, s)),
                 other = (std::max)(squared_circumdiameter(p, q, s), squared_circumdiameter(q, r, s));
    const bool is_tie = own >= (1. - ROUNDING) * other && other >= (1. - ROUNDING) * own;
    return is_tie ? is_less((std::max)(p, r, is_less), (std::max)(q, s, is_less)) : own < other;
  }

  // All stars see the same order of the points, so that cocircular ones, such as those of a grid, get the same
  // diagonals everywhere. The one that spares the last point is that of the symbolic perturbation of
  // Delaunay_triangulation_3.
  static bool is_less(const Vector_3& a, const Vector_3& b)
  {
    return a.x() != b.x() ? a.x() < b.x() : a.y() != b.y() ? a.y() < b.y() : a.z() < b.z();
  }

  const Star_neighborhood& m_neighborhood;
  const Tangent_projection<MaximumSize>& m_projection;
  const Clipped_polygon& m_polygon;
  std::array<Near_miss, Clipped_polygon::CAPACITY> m_near_misses;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STAR_DIAGONALS_H

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
// one whose larger circumscribed circle is smaller. Five and more points that are cocircular up to rounding are
// triangulated together, in an order that is the same, too.
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
    for (std::size_t i = 0; i != m_polygon.size(); ++i) {
      m_near_misses[i] = Near_miss{ Point_star::GAP, 1. - NEAR };
      m_has_ties[i] = false;
    }
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
      m_has_ties[vertex] = m_has_ties[vertex] || value > 1. - ROUNDING;
      if (value > m_near_misses[vertex].value)
        m_near_misses[vertex] = Near_miss{ static_cast<std::uint32_t>(i), value };
    }
  }

  void link_with_additional_diagonals(std::vector<std::uint32_t>& link) const
  {
    std::size_t begin = 0; // of vertices that do not coincide with the one before
    while (begin != m_polygon.size() && does_coincide_with_last(begin))
      ++begin;
    for (std::size_t k = 0; k != m_polygon.size();) {
      const std::size_t i = (begin + k) % m_polygon.size();
      std::size_t size = 1; // of vertices at the same place
      bool has_ties = m_has_ties[i];
      while (k + size != m_polygon.size() && does_coincide_with_last((i + size) % m_polygon.size()))
        has_ties = m_has_ties[(i + size++) % m_polygon.size()] || has_ties;
      if (!((has_ties || size > 1) && link_with_cocircular(i, size, link)))
        for (std::size_t j = 0; j != size; ++j)
          link_with_vertex((i + j) % m_polygon.size(), link);
      k += size;
    }
    if (link.size() > 1 && link.front() == Point_star::GAP && link.back() == Point_star::GAP)
      link.pop_back();
  }

  std::uint32_t maker_before(std::size_t i) const { return m_polygon.maker(i == 0 ? m_polygon.size() - 1 : i - 1); }

  // Adds what is seen beyond the vertex of the polygon and its next edge.
  void link_with_vertex(std::size_t i, std::vector<std::uint32_t>& link) const
  {
    const std::uint32_t q = maker_before(i), r = m_near_misses[i].neighbor, s = m_polygon.maker(i);
    if (r != Point_star::GAP && q != Point_star::GAP && s != Point_star::GAP && is_between(q, r, s) &&
        is_own_diagonal_better(q, r, s))
      link.push_back(r);
    if (s != Point_star::GAP || link.empty() || link.back() != Point_star::GAP)
      link.push_back(s);
  }

  // Whether rounding alone tells a vertex of the polygon from the one before.
  bool does_coincide_with_last(std::size_t i) const
  {
    const std::size_t last = i == 0 ? m_polygon.size() - 1 : i - 1;
    const double dx = m_polygon.x(i) - m_polygon.x(last), dy = m_polygon.y(i) - m_polygon.y(last);
    return dx * dx + dy * dy <=
           ROUNDING * ROUNDING * (m_polygon.x(i) * m_polygon.x(i) + m_polygon.y(i) * m_polygon.y(i));
  }

  // Adds what is seen beyond the vertices from i on, which coincide, if five points or more are on the circle around
  // them, and the edge after them.
  bool link_with_cocircular(std::size_t i, std::size_t size, std::vector<std::uint32_t>& link) const
  {
    const std::uint32_t first = maker_before(i), last = m_polygon.maker((i + size - 1) % m_polygon.size());
    if (first == Point_star::GAP || last == Point_star::GAP || first == last)
      return false;
    const double vx = m_polygon.x(i), vy = m_polygon.y(i);
    std::vector<std::uint32_t> circle; // but for the point itself
    for (std::uint32_t r = 0; r != m_projection.size(); ++r) {
      const bool is_end = r == first || r == last;
      if (is_end ||
          (std::abs(x(r) * vx + y(r) * vy - half_square(r)) <= ROUNDING * half_square(r) && is_between(first, r, last)))
        circle.push_back(r);
    }
    if (circle.size() < 4)
      return false;
    std::sort(circle.begin(), circle.end(),
              [&](std::uint32_t a, std::uint32_t b) { return x(a) * y(b) > y(a) * x(b); });
    append_neighbors(circle, link);
    return true;
  }

  // Triangulates the convex polygon of the point and the others around the circle by cutting off the last point in the
  // order of all stars, and again, as long as it has four. Adds the neighbors of the point but for the first: an end of
  // the arc of the others that is cut off gives way to the next one before it in the order.
  void append_neighbors(const std::vector<std::uint32_t>& others, std::vector<std::uint32_t>& link) const
  {
    const auto is_less = [&](std::uint32_t a, std::uint32_t b) {
      return is_lexicographically_less(m_neighborhood[a], m_neighborhood[b]);
    };
    std::array<std::uint32_t, 2> least; // are never cut off
    std::partial_sort_copy(others.begin(), others.end(), least.begin(), least.end(), is_less);
    const auto stays = [&](std::uint32_t r) {
      return !is_less(least[1], r) || is_lexicographically_less(m_neighborhood[r], Vector_3(0, 0, 0));
    };
    std::vector<std::uint32_t> end(1, others.back()); // backwards
    for (auto it = others.rbegin(); !stays(end.back()); ++it)
      if (is_less(*it, end.back()))
        end.push_back(*it);
    std::uint32_t begin = others.front();
    for (auto it = others.begin(); !stays(begin); ++it)
      if (is_less(*it, begin)) {
        begin = *it;
        link.push_back(begin);
      }
    // What is left of the polygon has one more triangle at the point, with both of its neighbors.
    link.insert(link.end(), end.rbegin(), end.rend());
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
    return is_first_diagonal_better(p, q, r, s);
  }

  const Star_neighborhood& m_neighborhood;
  const Tangent_projection<MaximumSize>& m_projection;
  const Clipped_polygon& m_polygon;
  std::array<Near_miss, Clipped_polygon::CAPACITY> m_near_misses; // of each vertex, the nearest one
  std::array<bool, Clipped_polygon::CAPACITY> m_has_ties;         // whether that is due to rounding
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STAR_DIAGONALS_H

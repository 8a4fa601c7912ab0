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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_DIAGONAL_EXCHANGE_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_DIAGONAL_EXCHANGE_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Crossing_test.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/flatness.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Exchanges diagonals of the quadrangles that two triangles make where the other diagonal is better. Labels and loops are
// chosen by bending alone, so where they decided, it must be better in every respect: the larger of the two circles
// through three points becomes smaller, as where stars decide (Star_diagonals), and the surface bends less at the edges
// of the quadrangle, or as little. Stars decide by circles alone and cut off creases: everywhere, a diagonal becomes a
// crease if the surface bends less by a larger factor than that by which the squares of the circles grow.
template <typename Builder>
class Diagonal_exchange
{
public:
  using Triangle = typename Builder::Triangle;

  Diagonal_exchange(const std::vector<Local_point>& points, const Point_octree_3& octree, Builder& builder)
    : m_points(points), m_builder(builder), m_crosses(points, octree, builder)
  { }

  // Ends early if cancelled.
  template <typename Progress>
  void operator()(Progress& progress)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    try {
      for (Point_index p = 0; p != m_builder.number_of_points(); ++p) {
        cancellation_point();
        push_creases(p);
        if (m_builder.is_open(p))
          push_undecided(p);
      }
      for (std::size_t k = MAXIMUM_LOOKS * m_queue.size(); k != 0 && !m_queue.empty(); --k) {
        cancellation_point(1 + Crossing_test<Builder>::MICROSECONDS_PER_PAIR * m_crosses.take_pairs());
        const Exchange exchange = m_queue.top();
        m_queue.pop();
        if (evaluate(exchange.p, exchange.q) == exchange) // as it was when it was pushed
          try_exchange(exchange);
      }
    } catch (const Cancelled&) {
    }
  }

private:
  // Of the diagonal pq for rs, and by which share the product of the bending and the square of the larger circle falls.
  struct Exchange
  {
    double gain;
    Point_index p, q, r, s;

    auto rank() const { return std::make_tuple(-gain, p, q, r, s); }
    bool operator<(const Exchange& other) const { return other.rank() < rank(); }
    bool operator==(const Exchange& other) const { return rank() == other.rank(); }
  };

  using Neighbors = std::array<Point_index, 2>;

  // Of 30 degrees. Of a smooth surface even coarse samples bend less at most edges.
  static constexpr double SQUARED_COSINE_OF_CREASE = 0.75;

  // Of the squares of circles for a crease. A surface hardly ever bends less by more than half.
  static constexpr double MAXIMUM_GROWTH = 2.;

  // For a crease. Where the two diagonals are about as good, that of the stars stays.
  static constexpr double LEAST_GAIN = 0.1;

  // At the edges, on the average: nearly equal circles of rounded points could lead round and round.
  static constexpr std::size_t MAXIMUM_LOOKS = 16;

  void push(Point_index p, Point_index q)
  {
    if (const std::optional<Exchange> exchange = evaluate((std::min)(p, q), (std::max)(p, q)))
      m_queue.push(*exchange);
  }

  // The edges from p to points after it whose quadrangle has a crease along the other diagonal.
  void push_creases(Point_index p)
  {
    if (m_builder.is_open(p))
      push_creases_of_triangles(p);
    else
      push_creases_of_star(p);
  }

  // At most points: the star is closed, and its triangles are those of the surface.
  void push_creases_of_star(Point_index p)
  {
    const Star_table& stars = m_builder.compatibility().stars();
    Point_index before = stars.neighbor(stars.end(p) - 1);
    for (Star_table::Slot s = stars.begin(p); s != stars.end(p); ++s) {
      const Point_index q = stars.neighbor(s);
      if (p < q && is_crease(before, stars.neighbor(stars.next(p, s)), p, q))
        push(p, q);
      before = q;
    }
  }

  void push_creases_of_triangles(Point_index p)
  {
    m_builder.for_each_triangle_at(p, [&](const Triangle& t) {
      for (Point_index q : { t[1], t[2] }) {
        const Neighbors opposite = opposite_vertices(p, q);
        if (p < q && opposite[1] != NO_POINT && is_crease(opposite[0], opposite[1], p, q))
          push(p, q);
      }
    });
  }

  // The edges of triangles at p that its star has not.
  void push_undecided(Point_index p)
  {
    m_builder.for_each_triangle_at(p, [&](const Triangle& t) {
      if (is_decided(p, t[1], t[2]))
        return;
      push(p, t[1]);
      push(p, t[2]);
    });
  }

  bool is_decided(Point_index p, Point_index q, Point_index r) const
  {
    return m_builder.compatibility().stars().view(p, q, r) != Star_table::View::ABSENT;
  }

  // Whether the surface would bend so much at the edge pq of triangles with r and with s.
  bool is_crease(Point_index p, Point_index q, Point_index r, Point_index s) const
  {
    const Local_vector edge = m_points[q] - m_points[p];
    const Local_vector n = cross_product(edge, m_points[r] - m_points[p]),
                       m = cross_product(m_points[s] - m_points[p], edge);
    const double product = n * m;
    return product <= 0. || product * product < SQUARED_COSINE_OF_CREASE * n.squared_length() * m.squared_length();
  }

  // The exchange of the edge pq of the surface; none if it had better stay.
  std::optional<Exchange> evaluate(Point_index p, Point_index q) const
  {
    const Neighbors opposite = opposite_vertices(p, q);
    const Point_index r = (std::min)(opposite[0], opposite[1]), s = (std::max)(opposite[0], opposite[1]);
    if (s == NO_POINT || r == s || is_edge(r, s))
      return std::nullopt;
    const Local_point &a = m_points[p], &b = m_points[q], &c = m_points[r], &d = m_points[s];
    const double circles = (std::max)(squared_circumdiameter(c, d, a), squared_circumdiameter(c, d, b)) /
                           (std::max)(squared_circumdiameter(a, b, c), squared_circumdiameter(a, b, d));
    const bool may_be_crease = circles < MAXIMUM_GROWTH && is_crease(r, s, p, q),
               has_smaller_circles = is_first_diagonal_better(c, a, d, b);
    if (!may_be_crease && !has_smaller_circles)
      return std::nullopt;
    const Bending bending = bending_around(p, q, r, s);
    const double gain = 1. - circles * (bending.is_present() ? bending.after / bending.before : 1.);
    if ((may_be_crease && bending.after < bending.before && gain > LEAST_GAIN) ||
        (has_smaller_circles && !bending.grows()))
      return Exchange{ gain, p, q, r, s };
    return std::nullopt;
  }

  // Third vertices of the first two triangles at the edge, NO_POINT in place of those that are missing.
  Neighbors opposite_vertices(Point_index p, Point_index q) const
  {
    Neighbors result{ { NO_POINT, NO_POINT } };
    m_builder.for_each_triangle_at(p, [&](const Triangle& t) {
      if (t[1] == q || t[2] == q)
        result[result[0] == NO_POINT ? 0 : 1] = t[1] == q ? t[2] : t[1];
    });
    return result;
  }

  bool is_edge(Point_index p, Point_index q) const { return opposite_vertices(p, q)[0] != NO_POINT; }

  // Sums over the edges of a quadrangle and its diagonal: lengths times angles before and after an exchange.
  struct Bending
  {
    double before, after, lengths;

    bool is_present() const { return before > ROUNDING_OF_SIX_DIGITS * lengths; }
    bool grows() const { return after > before + ROUNDING_OF_SIX_DIGITS * lengths; }
  };

  // Of the exchange of pq for rs.
  Bending bending_around(Point_index p, Point_index q, Point_index r, Point_index s) const
  {
    Bending result{ bending(p, q, r, s), bending(r, s, p, q), length(p, q) + length(r, s) };
    for (const Neighbors& ends : { Neighbors{ { p, q } }, Neighbors{ { q, p } } })
      for (const Neighbors& sides : { Neighbors{ { r, s } }, Neighbors{ { s, r } } }) {
        const Neighbors opposite = opposite_vertices(ends[0], sides[0]);
        result.lengths += length(ends[0], sides[0]);
        const Point_index beyond = opposite[0] == ends[1] ? opposite[1] : opposite[0];
        if (beyond == NO_POINT)
          continue;
        result.before += bending(ends[0], sides[0], ends[1], beyond);
        result.after += bending(ends[0], sides[0], sides[1], beyond);
      }
    return result;
  }

  double bending(Point_index p, Point_index q, Point_index r, Point_index s) const
  {
    const Local_vector edge = m_points[q] - m_points[p], u = m_points[r] - m_points[p], v = m_points[s] - m_points[p];
    const Local_vector n = cross_product(edge, u), m = cross_product(v, edge);
    return std::sqrt(edge.squared_length()) * std::atan2(std::sqrt(cross_product(n, m).squared_length()), n * m);
  }

  double length(Point_index p, Point_index q) const { return std::sqrt((m_points[q] - m_points[p]).squared_length()); }

  void try_exchange(const Exchange& exchange)
  {
    const auto [gain, p, q, r, s] = exchange;
    if (crosses_surface(exchange))
      return;
    for (Point_index v : { p, q, r, s })
      m_builder.open(v);
    const auto old_first = m_builder.remove(m_builder.find_triangle(p, q, r)),
               old_second = m_builder.remove(m_builder.find_triangle(p, q, s));
    if (m_builder.try_add(r, s, p) == Triangle_verdict::ADDED) {
      if (m_builder.try_add(s, r, q) == Triangle_verdict::ADDED) {
        m_crosses.attach(Triangle{ { r, s, p } });
        m_crosses.attach(Triangle{ { s, r, q } });
        for (Point_index v : { p, q })
          for (Point_index w : { r, s })
            push(v, w);
        return;
      }
      m_builder.remove(m_builder.find_triangle(r, s, p));
    }
    m_builder.restore(old_first);
    m_builder.restore(old_second);
  }

  bool crosses_surface(const Exchange& exchange)
  {
    const auto [gain, p, q, r, s] = exchange;
    const std::array<Triangle, 2> added{ Triangle{ { r, s, p } }, Triangle{ { s, r, q } } };
    return m_crosses(added, [p = p, q = q](const Triangle& t) {
      const auto has = [&](Point_index v) { return std::find(t.begin(), t.end(), v) != t.end(); };
      return !(has(p) && has(q));
    });
  }

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  Crossing_test<Builder> m_crosses;
  std::priority_queue<Exchange> m_queue;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_DIAGONAL_EXCHANGE_H

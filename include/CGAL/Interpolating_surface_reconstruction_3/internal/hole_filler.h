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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_HOLE_FILLER_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_HOLE_FILLER_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_loops.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_exchange.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Closes a boundary loop by triangles between its points. Among all triangulations of the loop it
// takes the one that is the most planar and regular: it minimizes the sum of what the cosine of each
// supplementary angle (thesis 4.2.2), those with the surface around it too, lacks to 1, and of
// what each triangle lacks to the regularity 1.5 of Eq. 3.1. No triangulation may use an edge that
// the surface has elsewhere. The optimization is that of Barequet and Sharir, Filling gaps in the
// boundary of a polyhedron, 1995.
template <typename Builder>
class Hole_filler
{
public:
  Hole_filler(const std::vector<Local_point>& points, Builder& builder) : m_points(points), m_builder(builder) { }

  // Fills the loop; leaves the surface as it was and returns false if there is no way to.
  template <typename OnVerdict, typename CancellationPoint = No_cancellation>
  bool operator()(const Boundary_loop& loop, OnVerdict on_verdict,
                  CancellationPoint&& cancellation_point = CancellationPoint())
  {
    return prepare(loop, cancellation_point) && attach_all(m_builder, m_fill, on_verdict);
  }

  // The same, but refuses a filling that does not fulfil the minimum planarity criterion (Eq. 4.1).
  template <typename OnVerdict>
  bool fill_if_planar(const Boundary_loop& loop, OnVerdict on_verdict)
  {
    No_cancellation cancellation_point; // they are short
    return prepare(loop, cancellation_point) && is_planar() && attach_all(m_builder, m_fill, on_verdict);
  }

private:
  using Triangle = typename Builder::Triangle;

  // The optimal triangulation takes time cubic in the length of the loop; longer loops are shortened
  // by cutting off the ear with the shortest chord first.
  static constexpr std::size_t MAXIMUM_OPTIMAL_SIZE = 96;

  static constexpr double IMPOSSIBLE = std::numeric_limits<double>::infinity();

  struct Entry
  {
    double cost;
    std::size_t split;
  };

  Entry& entry(std::size_t i, std::size_t j) { return m_table[i * m_loop.size() + j]; }

  // Chooses the triangles that fill the loop.
  template <typename CancellationPoint>
  bool prepare(const Boundary_loop& loop, CancellationPoint& cancellation_point)
  {
    if (loop.size() < 3)
      return false;
    m_loop = loop;
    m_outer.clear();
    for (std::size_t i = 0; i != loop.size(); ++i)
      m_outer.push_back(m_builder.opposite_vertex(loop[i], loop[(i + 1) % loop.size()]));
    m_fill.clear();
    cut_short_ears(cancellation_point);
    return triangulate(cancellation_point);
  }

  // Optimal triangulations of the sub-polygons i, i + 1, ..., j of the loop.
  template <typename CancellationPoint>
  bool triangulate(CancellationPoint& cancellation_point)
  {
    const std::size_t n = m_loop.size();
    if (n < 3)
      return n == 0;
    m_table.assign(n * n, Entry{ 0., 0 });
    for (std::size_t length = 2; length != n; ++length)
      for (std::size_t i = 0; i + length < n; ++i) {
        cancellation_point(length);
        optimize(i, i + length);
      }
    if (entry(0, n - 1).cost == IMPOSSIBLE)
      return false;
    collect(0, n - 1);
    return true;
  }

  void optimize(std::size_t i, std::size_t j)
  {
    Entry best{ IMPOSSIBLE, 0 };
    const bool is_closing_edge = i == 0 && j == m_loop.size() - 1;
    if (is_closing_edge || is_free_chord(m_loop[i], m_loop[j]))
      for (std::size_t m = i + 1; m != j; ++m) {
        const double parts = entry(i, m).cost + entry(m, j).cost;
        if (parts >= best.cost)
          continue;
        const double cost = parts + cost_of(i, m, j, is_closing_edge);
        if (cost < best.cost)
          best = Entry{ cost, m };
      }
    entry(i, j) = best;
  }

  bool is_free_chord(Point_index p, Point_index q) const { return p != q && m_builder.number_of_triangles(p, q) == 0; }

  double cost_of(std::size_t i, std::size_t m, std::size_t j, bool is_closing_edge)
  {
    const Point_index p = m_loop[i], q = m_loop[m], r = m_loop[j];
    if (p == q || q == r || r == p || m_builder.predicates().is_degenerate(p, q, r))
      return IMPOSSIBLE;
    double cost = MAXIMUM_REGULARITY - regularity(m_points[p], m_points[q], m_points[r]);
    cost += bending(p, q, r, m == i + 1 ? m_outer[i] : m_loop[entry(i, m).split]);
    cost += bending(q, r, p, j == m + 1 ? m_outer[m] : m_loop[entry(m, j).split]);
    if (is_closing_edge)
      cost += bending(r, p, q, m_outer[j]);
    return cost;
  }

  // What the triangles (p, q, r) and (q, p, opposite) lack to be coplanar.
  double bending(Point_index p, Point_index q, Point_index r, Point_index opposite) const
  {
    if (opposite == r || opposite == NO_POINT || m_builder.predicates().is_folded(p, q, r, opposite))
      return IMPOSSIBLE;
    return 1. - cosine_of_supplementary_angle(m_points[p], m_points[q], m_points[r], m_points[opposite]);
  }

  // Whether Eq. 4.1 holds for all triangles of the filling.
  bool is_planar() const
  {
    return std::all_of(m_fill.begin(), m_fill.end(), [&](const Triangle& t) {
      return fulfils_minimum_planarity(cosine_beyond(t, 0), cosine_beyond(t, 1), cosine_beyond(t, 2));
    });
  }

  // Cosine of the supplementary angle at the edge of a triangle of the filling that begins at vertex i.
  double cosine_beyond(const Triangle& t, std::size_t i) const
  {
    const Point_index p = t[i], q = t[(i + 1) % 3], r = t[(i + 2) % 3];
    Point_index opposite = m_builder.opposite_vertex(p, q);
    for (const Triangle& other : m_fill)
      if (other != t && std::count(other.begin(), other.end(), p) + std::count(other.begin(), other.end(), q) == 2)
        opposite = other[0] != p && other[0] != q ? other[0] : other[1] != p && other[1] != q ? other[1] : other[2];
    return opposite == NO_POINT
             ? MISSING_NEIGHBOR_COSINE
             : cosine_of_supplementary_angle(m_points[p], m_points[q], m_points[r], m_points[opposite]);
  }

  void collect(std::size_t begin, std::size_t end)
  {
    std::vector<std::array<std::size_t, 2> > stack{ { { begin, end } } };
    while (!stack.empty()) {
      const std::size_t i = stack.back()[0], j = stack.back()[1];
      stack.pop_back();
      if (j - i < 2)
        continue;
      const std::size_t m = entry(i, j).split;
      m_fill.push_back(Triangle{ { m_loop[i], m_loop[m], m_loop[j] } });
      stack.push_back({ { i, m } });
      stack.push_back({ { m, j } });
    }
  }

  // A point of the loop between its neighbors, as positions in the loop; it may be cut off if it is an ear.
  struct Ear
  {
    double squared_chord;
    std::size_t at, before, after;
    // the ear with the shortest chord comes first
    bool operator<(const Ear& other) const
    {
      return squared_chord > other.squared_chord || (squared_chord == other.squared_chord && at > other.at);
    }
  };

  template <typename CancellationPoint>
  void cut_short_ears(CancellationPoint& cancellation_point)
  {
    const std::size_t n = m_loop.size();
    if (n <= MAXIMUM_OPTIMAL_SIZE)
      return;
    std::vector<std::size_t> before(n), after(n); // `after` of a point that has been cut off is n
    for (std::size_t i = 0; i != n; ++i) {
      before[i] = i == 0 ? n - 1 : i - 1;
      after[i] = i + 1 == n ? 0 : i + 1;
    }
    std::priority_queue<Ear> queue;
    const auto push = [&](std::size_t i) {
      const double squared = (m_points[m_loop[before[i]]] - m_points[m_loop[after[i]]]).squared_length();
      queue.push(Ear{ squared, i, before[i], after[i] });
    };
    for (std::size_t i = 0; i != n; ++i)
      push(i);
    for (std::size_t size = n; size > MAXIMUM_OPTIMAL_SIZE && !queue.empty();) {
      cancellation_point();
      const Ear ear = queue.top();
      queue.pop();
      if (after[ear.at] != ear.after || before[ear.at] != ear.before || !is_ear(ear))
        continue;
      m_fill.push_back(Triangle{ { m_loop[ear.before], m_loop[ear.at], m_loop[ear.after] } });
      m_outer[ear.before] = m_loop[ear.at];
      after[ear.before] = ear.after;
      before[ear.after] = ear.before;
      after[ear.at] = n;
      --size;
      push(ear.before);
      push(ear.after);
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i != n; ++i)
      if (after[i] != n) {
        m_loop[kept] = m_loop[i];
        m_outer[kept++] = m_outer[i];
      }
    m_loop.resize(kept);
    m_outer.resize(kept);
  }

  bool is_ear(const Ear& ear) const
  {
    const Point_index p = m_loop[ear.before], q = m_loop[ear.at], r = m_loop[ear.after];
    return is_free_chord(p, r) && !m_builder.predicates().is_degenerate(p, q, r) &&
           bending(p, q, r, m_outer[ear.before]) != IMPOSSIBLE && bending(q, r, p, m_outer[ear.at]) != IMPOSSIBLE;
  }

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  Boundary_loop m_loop;
  std::vector<Point_index> m_outer; // the vertex of the surface beyond the edge from point i to the next
  std::vector<Triangle> m_fill;     // growing from the surface, so that the gate sees the orientation
  std::vector<Entry> m_table;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_HOLE_FILLER_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_HOLE_CLOSING_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_HOLE_CLOSING_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_loops.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/flat_sheet.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/hole_filler.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Closes the boundary loops of a surface without new points (thesis 4.3.6). A loop that cannot be
// closed, because the edges it needs exist elsewhere, is widened by the ring of triangles around it
// and tried again, unless it is a boundary that the stars agree on, such as that of a flat sheet.
template <typename Builder>
class Hole_closing
{
public:
  // Loops of more than `maximum_size` edges stay open, and those for which is_boundary(loop) holds.
  Hole_closing(const std::vector<Local_point>& points, Builder& builder, std::size_t maximum_size)
    : m_points(points), m_builder(builder), m_maximum_size(maximum_size), m_fill(points, builder)
  { }

  // Ends early if cancelled.
  template <typename IsBoundary, typename Progress, typename OnVerdict>
  void operator()(const IsBoundary& is_boundary, Progress& progress, OnVerdict on_verdict)
  {
    for (std::size_t round = 0; round != MAXIMUM_ROUNDS; ++round) {
      const std::vector<Boundary_loop> failed = fill_loops(is_boundary, progress, on_verdict);
      if (progress.is_cancelled())
        return;
      const bool is_single = keep_largest_fans();
      if (failed.empty() && is_single)
        return;
      if (round + 1 == MAXIMUM_ROUNDS)
        break;
      for (const Boundary_loop& loop : failed)
        remove_ring(loop);
    }
    restore_rings();
    keep_largest_fans();
  }

  // Closes the short loops between agreed triangles whose filling is planar (thesis 4.3.5), such as a
  // quadrangle on whose diagonal the stars do not agree. A loop around a point without triangles is
  // left alone, and so is one along which no star is in conflict: it is a boundary. Ends early if
  // cancelled.
  template <typename Progress, typename OnVerdict>
  void close_planar_loops(Progress& progress, OnVerdict on_verdict)
  {
    for (const Boundary_loop& loop : Boundary_loops<Builder>(m_points, m_builder)()) {
      if (!progress.advance(0.))
        return;
      if (loop.size() <= MAXIMUM_PLANAR_SIZE &&
          !std::all_of(loop.begin(), loop.end(),
                       [&](Point_index p) { return m_builder.compatibility().is_point_agreed(p); }) &&
          std::none_of(loop.begin(), loop.end(), [&](Point_index p) { return is_next_to_bare_point(p); }))
        m_fill.fill_if_planar(loop, on_verdict);
    }
  }

private:
  // Two crossing diagonals leave a loop of 4; a conflict that leaves more than two such is not simple.
  static constexpr std::size_t MAXIMUM_PLANAR_SIZE = 8;

  bool is_next_to_bare_point(Point_index p) const
  {
    const Star_table& stars = m_builder.compatibility().stars();
    for (Star_table::Slot s = stars.begin(p); s != stars.end(p); ++s) {
      const Point_index q = stars.neighbor(s);
      if (q != NO_POINT && m_builder.is_open(q) && m_builder.corners(q).empty())
        return true;
    }
    return false;
  }

  // A loop that resists widening this often bounds a surface that would fold onto itself, such as a
  // sheet; it stays open as it was.
  static constexpr std::size_t MAXIMUM_ROUNDS = 12;

  template <typename IsBoundary, typename Progress, typename OnVerdict>
  std::vector<Boundary_loop> fill_loops(const IsBoundary& is_boundary, Progress& progress, OnVerdict on_verdict)
  {
    std::vector<Boundary_loop> failed;
    Flat_sheet<Builder> flat_sheet(m_points, m_builder);
    for (const Boundary_loop& loop : Boundary_loops<Builder>(m_points, m_builder)()) {
      if (!progress.advance(0.))
        break;
      if (loop.size() > m_maximum_size || is_boundary(loop) ||
          (is_agreed_boundary(loop) && flat_sheet.is_outline(loop)) || m_fill(loop, on_verdict) ||
          is_agreed_boundary(loop))
        continue;
      // A short loop may be an outline, too, if it cannot be filled.
      if (!(do_stars_end_along(loop) && flat_sheet.is_outline(loop)))
        failed.push_back(loop);
    }
    return failed;
  }

  // A short loop is a gap.
  bool is_agreed_boundary(const Boundary_loop& loop) const
  {
    return loop.size() > MAXIMUM_PLANAR_SIZE && do_stars_end_along(loop);
  }

  // Whether most stars along the loop agree that the surface ends there.
  bool do_stars_end_along(const Boundary_loop& loop) const
  {
    const auto agreed = std::count_if(loop.begin(), loop.end(),
                                      [&](Point_index p) { return m_builder.compatibility().is_point_on_boundary(p); });
    return 2 * static_cast<std::size_t>(agreed) > loop.size();
  }

  // Where several fans meet at a point, only the largest stays. Returns whether there were none.
  bool keep_largest_fans()
  {
    bool is_single = true;
    std::vector<Point_index> todo(m_builder.open_points());
    while (!todo.empty()) {
      const Point_index p = todo.back();
      todo.pop_back();
      const std::vector<Point_index> touched = remove_smaller_fans(p);
      is_single = is_single && touched.empty();
      todo.insert(todo.end(), touched.begin(), touched.end());
    }
    return is_single;
  }

  // Returns the points of the triangles removed.
  std::vector<Point_index> remove_smaller_fans(Point_index p)
  {
    std::vector<Point_index> touched;
    if (m_builder.number_of_boundary_edges(p) <= 2)
      return touched;
    std::size_t largest = 0;
    Point_index largest_begin = NO_POINT;
    for (const auto& corner : m_builder.corners(p)) {
      const auto fan = m_builder.fan_from(p, fan_begin(p, corner.a));
      if (fan.size > largest) {
        largest = fan.size;
        largest_begin = fan_begin(p, corner.a);
      }
    }
    if (largest == m_builder.corners(p).size())
      return touched;
    std::vector<typename Builder::Triangle_index> removed;
    for (const auto& corner : m_builder.corners(p)) {
      const Point_index begin = fan_begin(p, corner.a);
      if (begin != largest_begin)
        removed.push_back(corner.triangle);
    }
    for (auto t : removed) {
      const typename Builder::Triangle vertices = m_builder.triangle(t);
      touched.insert(touched.end(), vertices.begin(), vertices.end());
      m_builder.remove(t);
      m_removed.push_back(vertices);
    }
    return touched;
  }

  // The end of the fan through the neighbor q that is the smaller index, or the smallest neighbor of
  // a closed fan.
  Point_index fan_begin(Point_index p, Point_index q) const
  {
    const Point_index one = m_builder.fan_from(p, q).end;
    const Point_index other = m_builder.fan_from(p, one).end;
    return (std::min)(one, other);
  }

  void remove_ring(const Boundary_loop& loop)
  {
    for (std::size_t i = 0; i != loop.size(); ++i) {
      const Point_index p = loop[i], q = loop[(i + 1) % loop.size()], r = m_builder.opposite_vertex(p, q);
      if (r == NO_POINT)
        continue;
      m_builder.remove(m_builder.find_triangle(p, q, r));
      m_removed.push_back(typename Builder::Triangle{ { p, q, r } });
    }
  }

  // Attaches the triangles again that were removed in vain.
  void restore_rings()
  {
    for (; !m_removed.empty(); m_removed.pop_back())
      m_builder.try_add(m_removed.back()[0], m_removed.back()[1], m_removed.back()[2]);
  }

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  std::size_t m_maximum_size;
  Hole_filler<Builder> m_fill;
  std::vector<typename Builder::Triangle> m_removed; // in this order, to be restored
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_HOLE_CLOSING_H

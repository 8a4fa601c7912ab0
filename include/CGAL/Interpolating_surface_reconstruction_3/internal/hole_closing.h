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
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Face_filler.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_loops.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/flat_sheet.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/flatness.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/hole_filler.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_crossings.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
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

  // Returns whether all loops are closed that had to be. Ends early if cancelled.
  template <typename IsBoundary, typename Progress, typename OnVerdict>
  bool operator()(const IsBoundary& is_boundary, Progress& progress, OnVerdict on_verdict)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    try {
      return fill_and_widen(is_boundary, cancellation_point, on_verdict);
    } catch (const Cancelled&) {
    }
    return true;
  }

  // Loops that are still open although they had to be closed: what could not be, and the outlines of flat sheets.
  struct Open_loops
  {
    std::vector<Point_index> points_of_failed; // increasing
    std::vector<Boundary_loop> outlines;       // in canonical order
  };

  // Ends early if cancelled.
  template <typename IsBoundary, typename Progress>
  Open_loops find_open_loops(const IsBoundary& is_boundary, Progress& progress) const
  {
    Cancellation_point<Progress> cancellation_point(progress);
    Open_loops result;
    std::vector<Point_index>& points = result.points_of_failed;
    Flat_sheet<Builder> flat_sheet(m_points, m_builder);
    try {
      for (const Boundary_loop& loop : Boundary_loops<Builder>(m_points, m_builder)(cancellation_point))
        if (loop.size() <= m_maximum_size && !is_boundary(loop) && !has_crossing_lid(loop)) {
          if (do_stars_end_along(loop) && flat_sheet.is_outline(loop, maximum_thickness(loop), cancellation_point))
            result.outlines.push_back(loop);
          else
            points.insert(points.end(), loop.begin(), loop.end());
        }
    } catch (const Cancelled&) {
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return result;
  }

  // Whether loops stay open because what fills them crosses the surface.
  bool has_crossing_lids() const { return !m_with_crossing_lids.empty(); }

  // Fills them all the same.
  template <typename Progress, typename OnVerdict>
  void close_with_crossing_lids(Progress& progress, OnVerdict on_verdict)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    try {
      for (const Boundary_loop& loop : Boundary_loops<Builder>(m_points, m_builder)(cancellation_point))
        if (has_crossing_lid(loop))
          m_fill(loop, on_verdict, cancellation_point);
    } catch (const Cancelled&) {
    }
  }

  // Where several fans meet at a point, because triangles were removed, only the largest stays. Ends early if cancelled.
  template <typename Progress>
  void keep_largest_fans(Progress& progress)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    try {
      remove_smaller_fans(cancellation_point);
    } catch (const Cancelled&) {
    }
  }

  // Closes the short loops between agreed triangles whose filling is planar (thesis 4.3.5), such as a
  // quadrangle on whose diagonal the stars do not agree. A loop around a point without triangles is
  // left alone, and so is one along which no star is in conflict: it is a boundary. Ends early if
  // cancelled.
  template <typename Progress, typename OnVerdict>
  void close_planar_loops(Progress& progress, OnVerdict on_verdict)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    try {
      for (const Boundary_loop& loop : Boundary_loops<Builder>(m_points, m_builder)(cancellation_point)) {
        cancellation_point(loop.size());
        if (is_short(loop) &&
            !std::all_of(loop.begin(), loop.end(),
                         [&](Point_index p) { return m_builder.compatibility().is_point_agreed(p); }) &&
            std::none_of(loop.begin(), loop.end(), [&](Point_index p) { return is_next_to_bare_point(p); }))
          m_fill.fill_if_planar(loop, on_verdict);
      }
    } catch (const Cancelled&) {
    }
  }

  // Closes flat faces with holes in them: labels, which are to come, would put triangles where the faces should be. Ends
  // early if cancelled.
  template <typename Progress, typename OnVerdict>
  void close_faces_with_holes(Progress& progress, OnVerdict on_verdict)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    try {
      Face_filler<Builder> fill_faces(m_points, m_builder, Face_selection::EXACT_WITH_HOLES);
      fill_faces([](const Boundary_loop&) { return false; }, on_verdict, cancellation_point);
    } catch (const Cancelled&) {
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

  template <typename IsBoundary, typename CancellationPoint, typename OnVerdict>
  bool fill_and_widen(const IsBoundary& is_boundary, CancellationPoint& cancellation_point, OnVerdict on_verdict)
  {
    fill_flat_faces(is_boundary, cancellation_point, on_verdict);
    for (std::size_t round = 0; round != MAXIMUM_ROUNDS; ++round) {
      const std::vector<Boundary_loop> failed = fill_loops(is_boundary, cancellation_point, on_verdict);
      const bool is_single = remove_smaller_fans(cancellation_point);
      if (failed.empty() && is_single)
        return true;
      if (round + 1 == MAXIMUM_ROUNDS)
        break;
      for (const Boundary_loop& loop : failed)
        remove_ring(loop, cancellation_point);
    }
    restore_rings(cancellation_point);
    remove_smaller_fans(cancellation_point);
    return false;
  }

  template <typename IsBoundary, typename CancellationPoint, typename OnVerdict>
  void fill_flat_faces(const IsBoundary& is_boundary, CancellationPoint& cancellation_point, OnVerdict on_verdict)
  {
    Face_filler<Builder> fill_faces(m_points, m_builder, Face_selection::ALL);
    fill_faces([&](const Boundary_loop& l) { return l.size() > m_maximum_size || is_boundary(l); }, on_verdict,
               cancellation_point);
  }

  template <typename IsBoundary, typename CancellationPoint, typename OnVerdict>
  std::vector<Boundary_loop> fill_loops(const IsBoundary& is_boundary, CancellationPoint& cancellation_point,
                                        OnVerdict on_verdict)
  {
    std::vector<Boundary_loop> failed;
    std::vector<Lid> lids;
    Flat_sheet<Builder> flat_sheet(m_points, m_builder);
    for (const Boundary_loop& loop : Boundary_loops<Builder>(m_points, m_builder)(cancellation_point)) {
      cancellation_point(loop.size());
      if (loop.size() > m_maximum_size || is_boundary(loop) || has_crossing_lid(loop))
        continue;
      const bool is_end = do_stars_end_along(loop);
      if (is_end && flat_sheet.is_outline(loop, maximum_thickness(loop), cancellation_point))
        continue;
      const std::size_t first = m_builder.number_of_stored_triangles();
      const bool is_filled = m_fill(loop, on_verdict, cancellation_point);
      if (is_end && !is_short(loop)) {
        if (is_filled && do_most_stars_agree())
          lids.push_back(Lid{ first, m_builder.number_of_stored_triangles(), loop });
      } else if (!is_filled)
        failed.push_back(loop);
    }
    remove_crossing_lids(std::move(lids), cancellation_point);
    return failed;
  }

  // The triangles stored from `begin` to `end` that fill a loop at which the stars say that the surface ends.
  struct Lid
  {
    std::size_t begin, end;
    Boundary_loop loop;
  };

  // Whether they can be believed where they say that the surface ends: of undersampled parts, a third conflicts, of open
  // surfaces hardly any.
  bool do_most_stars_agree() const
  {
    constexpr std::size_t PART_OF_CONFLICTS = 10;
    const std::size_t points = m_points.size();
    return (points - m_builder.compatibility().number_of_agreed_points()) * PART_OF_CONFLICTS <= points;
  }

  // Such a loop stays open if what fills it crosses the surface, as that of the outline of a terrain may, unless one that
  // is as long or longer has been filled in the same part: that surface does not stay open.
  template <typename CancellationPoint>
  void remove_crossing_lids(std::vector<Lid> lids, CancellationPoint& cancellation_point)
  {
    using Index = typename Builder::Triangle_index;
    using Triangle = typename Builder::Triangle;
    if (lids.empty())
      return;
    std::vector<Triangle> of_lids, crossing;
    for (const Lid& lid : lids)
      for (std::size_t t = lid.begin; t != lid.end; ++t)
        of_lids.push_back(m_builder.triangle(static_cast<Index>(t)));
    std::sort(of_lids.begin(), of_lids.end());
    const auto is_of_lid = [&](const Triangle& t) { return std::binary_search(of_lids.begin(), of_lids.end(), t); };
    Surface_crossings<Builder>(m_points, m_builder)
      .for_each(
        static_cast<Index>(lids.front().begin), is_of_lid,
        [&](const Triangle& t, const Triangle&) { crossing.push_back(t); }, cancellation_point);
    std::sort(crossing.begin(), crossing.end());
    const auto crosses = [&](const Lid& lid) {
      for (std::size_t t = lid.begin; t != lid.end; ++t)
        if (std::binary_search(crossing.begin(), crossing.end(), m_builder.triangle(static_cast<Index>(t))))
          return true;
      return false;
    };
    const auto end_of_crossing = std::stable_partition(lids.begin(), lids.end(), crosses);
    for (auto lid = end_of_crossing; lid != lids.end(); ++lid)
      m_filled_ends.push_back(Filled_end{ lid->loop.front(), lid->loop.size() });
    if (end_of_crossing == lids.begin())
      return;
    const auto longest = longest_filled_ends();
    for (auto lid = lids.begin(); lid != end_of_crossing; ++lid) {
      const auto filled = longest.find(part_at(lid->loop.front()));
      if (filled != longest.end() && filled->second >= lid->loop.size())
        continue;
      for (std::size_t t = lid->begin; t != lid->end; ++t)
        m_builder.remove(static_cast<Index>(t));
      m_with_crossing_lids.push_back(sorted(lid->loop));
    }
    std::sort(m_with_crossing_lids.begin(), m_with_crossing_lids.end());
  }

  // A loop that was filled although the stars say that the surface ends there: a point of it, and its size.
  struct Filled_end
  {
    Point_index point;
    std::size_t size;
  };

  using Part = Parity_union_find::Element;

  // Triangles are in one part if they have been connected once.
  Part part_at(Point_index p) { return m_builder.orientation(m_builder.corners(p).front().triangle).root; }

  std::map<Part, std::size_t> longest_filled_ends()
  {
    std::map<Part, std::size_t> result;
    for (const Filled_end& end : m_filled_ends)
      if (!m_builder.corners(end.point).empty()) {
        std::size_t& longest = result[part_at(end.point)];
        longest = (std::max)(longest, end.size);
      }
    return result;
  }

  bool has_crossing_lid(const Boundary_loop& loop) const
  {
    return !m_with_crossing_lids.empty() &&
           std::binary_search(m_with_crossing_lids.begin(), m_with_crossing_lids.end(), sorted(loop));
  }

  static Boundary_loop sorted(Boundary_loop loop)
  {
    std::sort(loop.begin(), loop.end());
    return loop;
  }

  bool is_short(const Boundary_loop& loop) const { return loop.size() <= MAXIMUM_PLANAR_SIZE; }

  // That of a sheet whose outline is the loop. A short loop is a gap, unless the sheet is flat up to rounding.
  double maximum_thickness(const Boundary_loop& loop) const { return is_short(loop) ? ROUNDING_OF_SIX_DIGITS : 1.; }

  // Whether most stars along the loop agree that the surface ends there.
  bool do_stars_end_along(const Boundary_loop& loop) const
  {
    const auto agreed = std::count_if(loop.begin(), loop.end(),
                                      [&](Point_index p) { return m_builder.compatibility().is_point_on_boundary(p); });
    return 2 * static_cast<std::size_t>(agreed) > loop.size();
  }

  // Returns whether there were none.
  template <typename CancellationPoint>
  bool remove_smaller_fans(CancellationPoint& cancellation_point)
  {
    bool is_single = true;
    std::vector<Point_index> todo(m_builder.open_points());
    while (!todo.empty()) {
      const Point_index p = todo.back();
      todo.pop_back();
      cancellation_point(m_builder.corners(p).size());
      const std::vector<Point_index> touched = remove_smaller_fans_at(p);
      is_single = is_single && touched.empty();
      todo.insert(todo.end(), touched.begin(), touched.end());
    }
    return is_single;
  }

  // Returns the points of the triangles removed.
  std::vector<Point_index> remove_smaller_fans_at(Point_index p)
  {
    std::vector<Point_index> touched;
    if (m_builder.number_of_boundary_edges(p) <= 2)
      return touched;
    const std::vector<std::size_t> fans = fans_of_corners(p);
    std::vector<std::size_t> sizes(fans.size(), 0);
    for (std::size_t fan : fans)
      ++sizes[fan];
    const std::size_t largest = std::size_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    if (sizes[largest] == fans.size())
      return touched;
    std::vector<typename Builder::Triangle_index> removed;
    for (std::size_t i = 0; i != fans.size(); ++i)
      if (fans[i] != largest)
        removed.push_back(m_builder.corners(p)[i].triangle);
    for (auto t : removed) {
      const typename Builder::Triangle vertices = m_builder.triangle(t);
      touched.insert(touched.end(), vertices.begin(), vertices.end());
      m_builder.remove(t);
      m_removed.push_back(vertices);
    }
    return touched;
  }

  // The fan of each corner at p, named by its first corner.
  std::vector<std::size_t> fans_of_corners(Point_index p) const
  {
    const auto& corners = m_builder.corners(p);
    std::vector<std::pair<Point_index, std::size_t> > ends;
    for (std::size_t i = 0; i != corners.size(); ++i) {
      ends.emplace_back(corners[i].a, i);
      ends.emplace_back(corners[i].b, i);
    }
    std::sort(ends.begin(), ends.end());
    std::vector<std::size_t> fans(corners.size());
    std::iota(fans.begin(), fans.end(), std::size_t(0));
    const auto first = [&](std::size_t i) {
      while (fans[i] != i)
        i = fans[i] = fans[fans[i]];
      return i;
    };
    for (std::size_t i = 1; i < ends.size(); ++i)
      if (ends[i].first == ends[i - 1].first) {
        const std::size_t a = first(ends[i - 1].second), b = first(ends[i].second);
        fans[(std::max)(a, b)] = (std::min)(a, b);
      }
    for (std::size_t i = 0; i != fans.size(); ++i)
      fans[i] = first(i);
    return fans;
  }

  template <typename CancellationPoint>
  void remove_ring(const Boundary_loop& loop, CancellationPoint& cancellation_point)
  {
    for (std::size_t i = 0; i != loop.size(); ++i) {
      cancellation_point();
      const Point_index p = loop[i], q = loop[(i + 1) % loop.size()], r = m_builder.opposite_vertex(p, q);
      if (r == NO_POINT)
        continue;
      m_builder.remove(m_builder.find_triangle(p, q, r));
      m_removed.push_back(typename Builder::Triangle{ { p, q, r } });
    }
  }

  // Attaches the triangles again that were removed in vain.
  template <typename CancellationPoint>
  void restore_rings(CancellationPoint& cancellation_point)
  {
    for (; !m_removed.empty(); m_removed.pop_back()) {
      cancellation_point();
      m_builder.try_add(m_removed.back()[0], m_removed.back()[1], m_removed.back()[2]);
    }
  }

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  std::size_t m_maximum_size;
  Hole_filler<Builder> m_fill;
  std::vector<typename Builder::Triangle> m_removed; // in this order, to be restored
  std::vector<Boundary_loop> m_with_crossing_lids;   // stay open; sorted in themselves and among each other
  std::vector<Filled_end> m_filled_ends;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_HOLE_CLOSING_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_CLOSING_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_CLOSING_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Bore_opening.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Component_joining.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Component_reunion.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Conflict_relabelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Corner_recovery.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Diagonal_exchange.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_loops.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/crossing_removal.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/hole_closing.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/hull_attachment.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/island_removal.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/lid_removal.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/point_insertion.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/sheet_joining.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_crossings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/temporary_lids.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// What of a surface is to be closed.
struct Closing_options
{
  double maximum_radius = std::numeric_limits<double>::infinity(); // of neighborhoods
  std::size_t maximum_hole_size = (std::numeric_limits<std::size_t>::max)();
  bool keep_boundaries = false;
  bool relabels_conflicts = true;

  bool closes_all_loops() const
  {
    return !keep_boundaries && maximum_hole_size == (std::numeric_limits<std::size_t>::max)();
  }
};

// Makes the surface that charts and labels have left the one that is written: loops are closed (thesis 4.3.6), points
// that are left over inserted, crossings removed, and what closed loops have hidden is looked for. Every step leaves a
// manifold; the next one starts from it.
template <typename ConcurrencyTag, typename Builder, typename StarConstruction, typename Progress, typename OnVerdict>
class Surface_closing
{
public:
  // `normals` are those of the points, or none; `on_verdict(triangle, verdict)` is told of the triangles that close loops.
  Surface_closing(const std::vector<Local_point>& points, const std::vector<Local_vector>& normals,
                  const Point_octree_3& octree, const StarConstruction& construction, const Closing_options& options,
                  Builder& builder, Kept_triangulation& triangulation, Progress& progress, const OnVerdict& on_verdict)
    : m_points(points), m_normals(normals), m_octree(octree), m_construction(construction), m_options(options),
      m_builder(builder), m_triangulation(triangulation), m_progress(progress), m_on_verdict(on_verdict),
      m_close(points, builder, options.maximum_hole_size), m_insert(points, octree, options.maximum_radius, builder),
      m_lids(builder), m_first(next_triangle())
  { }

  Surface_closing(const Surface_closing&) = delete;
  Surface_closing& operator=(const Surface_closing&) = delete;

  // Returns the number of points without triangles. Ends early if cancelled.
  std::size_t operator()()
  {
    close_loops();
    join_sheets();
    insert_points();
    remove_crossings();
    if (m_options.closes_all_loops()) {
      find_what_loops_hide();
      if (m_options.relabels_conflicts)
        relabel_conflicts();
    }
    m_triangulation.clear(); // nothing needs it any more
    if (m_options.keep_boundaries)
      remove_lids();
    exchange_diagonals();
    return m_unused;
  }

private:
  using Triangle_index = typename Builder::Triangle_index;

  // As long as each finds at most half of the crossings that the one before found. One may be in vain after one that was
  // not: what closes the last holes of a large component may cross more than before.
  static constexpr int MAXIMUM_PASSES = 8;

  Triangle_index next_triangle() const { return static_cast<Triangle_index>(m_builder.number_of_stored_triangles()); }

  void close_loops() { m_is_closed = m_close(is_boundary(), m_progress, m_on_verdict); }

  // Where no triangles between the vertices of a loop close it: around flat sheets, and where there is no surface at all.
  void join_sheets()
  {
    Island_removal<Builder> remove_islands(m_builder);
    remove_islands();
    Sheet_joining<ConcurrencyTag, Builder> join(m_points, m_builder);
    join(m_close.find_open_loops(is_boundary(), m_progress).outlines, m_progress);
    if (m_options.closes_all_loops() && m_options.maximum_radius == std::numeric_limits<double>::infinity() &&
        attach_hull_if_empty(m_points, m_builder, m_progress, m_on_verdict))
      close_loops();
  }

  void insert_points()
  {
    const Triangle_index next = next_triangle();
    m_unused = m_insert(m_progress);
    // A sheet into which points were inserted may be flat no more; what closes it may leave points out.
    if (m_is_closed && next_triangle() != next) {
      close_loops();
      m_unused = m_insert(m_progress);
    }
  }

  // Crossings can be removed from closed components only: boundaries that stay open are closed for that.
  void remove_crossings()
  {
    // What crosses elsewhere can be replaced if it is closed.
    if (m_close.has_crossing_lids() && crosses())
      m_close.close_with_crossing_lids(m_progress, m_on_verdict);
    std::vector<Point_index> unclosed;
    if (!m_is_closed)
      unclosed = m_close.find_open_loops(is_boundary(), m_progress).points_of_failed;
    if (!m_options.keep_boundaries || !crosses()) {
      remove_crossings_of_closed(std::move(unclosed));
      return;
    }
    m_lids.expect_at(boundary_loops());
    m_has_temporary_lids = true;
    close_loops();
    remove_crossings_of_closed(std::move(unclosed));
    m_lids.remove();
    m_has_temporary_lids = false;
    close_loops();
    m_unused = m_insert(m_progress);
  }

  // Also the loops of the points `unclosed`. The new triangles of a component may cross others, and so may what closes
  // holes that they leave and points that were left out when they are inserted again.
  void remove_crossings_of_closed(std::vector<Point_index> unclosed)
  {
    Crossing_removal<ConcurrencyTag, Builder> remove(m_points, m_normals, m_octree, m_options.maximum_radius, m_builder,
                                                     m_triangulation);
    Triangle_index first = m_first;
    std::size_t crossings = 0;
    bool may_be_in_vain = false;
    for (int pass = 0; pass != MAXIMUM_PASSES; ++pass) {
      const Triangle_index next = next_triangle();
      if (!remove(first, unclosed, m_progress))
        break;
      unclosed.clear();
      close_loops();
      m_unused = m_insert(m_progress);
      first = next;
      const bool is_in_vain = pass != 0 && 2 * remove.number_of_crossings() > crossings;
      if (is_in_vain && !may_be_in_vain)
        break;
      may_be_in_vain = pass != 0 && !is_in_vain;
      crossings = remove.number_of_crossings();
    }
  }

  void find_what_loops_hide()
  {
    open_bores();
    recover_corners();
    if (reunite_components())
      join_components();
  }

  void relabel_conflicts()
  {
    Conflict_relabelling<ConcurrencyTag, Builder> relabel(m_points, m_builder, m_triangulation);
    if (!relabel(m_progress))
      return;
    const std::size_t unused = std::exchange(m_unused, m_insert(m_progress));
    find_what_loops_hide();
    if (!relabel.keep_if_better())
      m_unused = unused;
  }

  void open_bores()
  {
    Bore_opening<Builder> open(m_points, m_builder);
    open(m_progress);
  }

  void recover_corners()
  {
    Corner_recovery<ConcurrencyTag, Builder> recover(m_points, m_octree, m_builder, m_triangulation);
    if (recover(m_progress))
      m_unused = m_insert(m_progress);
  }

  // Returns whether there may be components to join.
  bool reunite_components()
  {
    Component_reunion<ConcurrencyTag, Builder> reunite(m_points, m_octree, m_builder, m_triangulation);
    if (reunite(m_progress))
      m_unused = m_insert(m_progress);
    return reunite.has_found_components();
  }

  void join_components()
  {
    Component_joining<ConcurrencyTag, Builder> join(m_points, m_octree, m_builder, m_triangulation);
    if (join(m_progress))
      m_unused = m_insert(m_progress);
  }

  void remove_lids()
  {
    Lid_removal<Builder, StarConstruction> remove(m_points, m_octree, m_construction, m_builder);
    if (!remove(m_progress))
      return;
    m_close.keep_largest_fans(m_progress);
    m_unused = m_insert(m_progress);
  }

  void exchange_diagonals()
  {
    Diagonal_exchange<Builder> exchange(m_points, m_octree, m_builder);
    exchange(m_progress);
  }

  // Whether triangles that came after the charts and labels cross the surface; false if cancelled.
  bool crosses() const
  {
    Cancellation_point<Progress> cancellation_point(m_progress);
    try {
      return !Surface_crossings<Builder>(m_points, m_builder)(m_first, cancellation_point).empty();
    } catch (const Cancelled&) {
      return false;
    }
  }

  // Of a loop: whether it is one of the sampled surface and stays open.
  auto is_boundary() const
  {
    return [this](const Boundary_loop& loop) {
      return m_options.keep_boundaries && !m_has_temporary_lids && are_most_stars_open(loop);
    };
  }

  bool are_most_stars_open(const Boundary_loop& loop) const
  {
    std::size_t open = 0;
    for (Point_index p : loop)
      open += m_builder.compatibility().is_star_open(p) ? 1u : 0u;
    return 2 * open > loop.size();
  }

  // None if cancelled.
  std::vector<Boundary_loop> boundary_loops() const
  {
    Cancellation_point<Progress> cancellation_point(m_progress);
    std::vector<Boundary_loop> loops;
    try {
      loops = Boundary_loops<Builder>(m_points, m_builder)(cancellation_point);
    } catch (const Cancelled&) {
    }
    const auto is_kept = is_boundary();
    loops.erase(std::remove_if(loops.begin(), loops.end(), [&](const Boundary_loop& l) { return !is_kept(l); }),
                loops.end());
    return loops;
  }

  const std::vector<Local_point>& m_points;
  const std::vector<Local_vector>& m_normals;
  const Point_octree_3& m_octree;
  const StarConstruction& m_construction;
  const Closing_options m_options;
  Builder& m_builder;
  Kept_triangulation& m_triangulation;
  Progress& m_progress;
  const OnVerdict& m_on_verdict;
  Hole_closing<Builder> m_close;
  Point_insertion<Builder> m_insert;
  Temporary_lids<Builder> m_lids;
  const Triangle_index m_first; // that is stored by these steps
  bool m_is_closed = false;     // but for loops that are to stay open
  bool m_has_temporary_lids = false;
  std::size_t m_unused = 0; // points
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_CLOSING_H

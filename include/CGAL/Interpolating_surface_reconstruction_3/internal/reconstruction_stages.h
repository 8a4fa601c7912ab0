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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_STAGES_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_STAGES_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Component_joining.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Corner_recovery.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Diagonal_exchange.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Manifold_builder.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_cloud_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Surface_predicates.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_loops.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/conflict_completion.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/crossing_removal.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/hole_closing.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/hull_attachment.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/island_removal.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/lid_removal.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/orientation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/point_insertion.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/sheet_joining.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/star_compatibility.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/star_construction.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_crossings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/temporary_lids.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// What the user can ask of a reconstruction.
struct Reconstruction_options
{
  double neighbor_radius = 0.; // in the user's unit; 0: unlimited
  std::size_t maximum_hole_size = (std::numeric_limits<std::size_t>::max)();
  bool keep_boundaries = false;
};

// Receives the triangles of a surface, as positions in the input.
using Triangle_output = std::function<void(const std::array<std::size_t, 3>&)>;

// The stages that the algorithms on stars share, from the points to the oriented surface. `share` is
// the part of the run time that a stage is expected to take.
template <typename ConcurrencyTag, typename Traits, typename StarConstruction, typename Visitor>
class Reconstruction_stages
{
public:
  using Cloud = Point_cloud_3<Traits>;
  using Predicates = Surface_predicates<Traits>;
  using Builder = Manifold_builder<Predicates>;
  using Input_triangle = std::array<std::size_t, 3>;

  // `normals` are in the order of the cloud, or empty.
  Reconstruction_stages(const Cloud& cloud, const std::vector<Local_vector>& normals,
                        const StarConstruction& construction, const Reconstruction_options& options,
                        Progress<Visitor>& progress)
    : m_cloud(cloud), m_normals(normals), m_construction(construction), m_options(options), m_progress(progress),
      m_predicates(cloud), m_triangulation(cloud.positions())
  { }

  const Predicates& predicates() const { return m_predicates; }

  Point_octree_3 build_octree(double share)
  {
    m_progress.begin_stage(Stage::INDEXING, share);
    Point_octree_3 octree(m_cloud.positions());
    m_progress.end_stage(octree.leaves().size());
    return octree;
  }

  Star_table build_stars(const Point_octree_3& octree, double share)
  {
    m_progress.begin_stage(Stage::STARS, share);
    Star_table stars = construct_stars<ConcurrencyTag>(m_cloud.positions(), octree, m_construction, maximum_radius(),
                                                       m_progress, !closes_all_loops());
    m_progress.end_stage(stars.size());
    return stars;
  }

  Star_compatibility find_agreed_triangles(const Star_table& stars, double share)
  {
    m_progress.begin_stage(Stage::COMPATIBILITY, share);
    Star_compatibility compatibility(stars);
    const auto go_further = [&] { return m_progress.advance(0.); };
    compatibility.template count_votes<ConcurrencyTag>(m_predicates, go_further);
    compatibility.orient(go_further);
    m_progress.end_stage(compatibility.number_of_agreed_points());
    return compatibility;
  }

  void complete_conflicts(const Point_octree_3& octree, Builder& builder, double share)
  {
    m_progress.begin_stage(Stage::COMPLETION, share);
    std::size_t attached = 0;
    const auto on_verdict = [&](const typename Builder::Triangle& t, Triangle_verdict verdict) {
      attached += verdict == Triangle_verdict::ADDED ? 1u : 0u;
      report(t, verdict);
    };
    Hole_closing<Builder> close(m_cloud.positions(), builder, m_options.maximum_hole_size);
    close.close_planar_loops(m_progress, on_verdict);
    Conflict_completion<ConcurrencyTag, Builder> complete(m_cloud.positions(), octree, maximum_radius(), builder);
    complete(m_progress, on_verdict, m_triangulation);
    m_progress.end_stage(attached);
  }

  void close_holes(const Point_octree_3& octree, Builder& builder, double share)
  {
    m_progress.begin_stage(Stage::HOLES, share);
    std::size_t attached = 0;
    const auto first_late = static_cast<typename Builder::Triangle_index>(builder.number_of_stored_triangles());
    Hole_closing<Builder> close(m_cloud.positions(), builder, m_options.maximum_hole_size);
    bool has_temporary_lids = false;
    const auto is_boundary = [&](const Boundary_loop& loop) {
      return m_options.keep_boundaries && !has_temporary_lids && are_most_stars_open(builder, loop);
    };
    const auto on_verdict = [&](const typename Builder::Triangle& t, Triangle_verdict verdict) {
      attached += verdict == Triangle_verdict::ADDED ? 1u : 0u;
      report(t, verdict);
    };
    bool is_closed = close(is_boundary, m_progress, on_verdict);
    Island_removal<Builder> remove_islands(builder);
    remove_islands();
    Sheet_joining<ConcurrencyTag, Builder> join_sheets(m_cloud.positions(), builder);
    join_sheets(close.find_open_loops(is_boundary, m_progress).outlines, m_progress);
    if (closes_all_loops() && !(m_options.neighbor_radius > 0.) &&
        attach_hull_if_empty(m_cloud.positions(), builder, m_progress, on_verdict))
      is_closed = close(is_boundary, m_progress, on_verdict);
    Point_insertion<Builder> insert(m_cloud.positions(), octree, maximum_radius(), builder);
    const std::size_t stored = builder.number_of_stored_triangles();
    std::size_t unused = insert(m_progress);
    // A sheet into which points were inserted may be flat no more; what closes it may leave points out.
    if (is_closed && builder.number_of_stored_triangles() != stored) {
      is_closed = close(is_boundary, m_progress, on_verdict);
      unused = insert(m_progress);
    }
    // What crosses elsewhere can be replaced if it is closed.
    if (close.has_crossing_lids() && crosses(builder, first_late))
      close.close_with_crossing_lids(m_progress, on_verdict);
    std::vector<Point_index> unclosed;
    if (!is_closed)
      unclosed = close.find_open_loops(is_boundary, m_progress).points_of_failed;
    const auto close_again = [&] { close(is_boundary, m_progress, on_verdict); };
    Temporary_lids<Builder> lids(builder);
    // Crossings can be removed from closed components only.
    if (m_options.keep_boundaries && crosses(builder, first_late)) {
      lids.expect_at(boundary_loops(builder, is_boundary));
      has_temporary_lids = true;
      close_again();
    }
    unused = remove_crossings(first_late, std::move(unclosed), octree, builder, close_again, insert, unused);
    if (has_temporary_lids) {
      lids.remove();
      has_temporary_lids = false;
      close_again();
      unused = insert(m_progress);
    }
    if (closes_all_loops()) {
      Corner_recovery<ConcurrencyTag, Builder> recover_corners(m_cloud.positions(), octree, builder, m_triangulation);
      if (recover_corners(m_progress))
        unused = insert(m_progress);
      Component_joining<ConcurrencyTag, Builder> join_components(m_cloud.positions(), octree, builder, m_triangulation);
      if (join_components(m_progress))
        unused = insert(m_progress);
    }
    if (m_options.keep_boundaries) {
      Lid_removal<Builder, StarConstruction> remove_lids(m_cloud.positions(), octree, m_construction, builder);
      if (remove_lids(m_progress)) {
        close.keep_largest_fans(m_progress);
        unused = insert(m_progress);
      }
    }
    m_triangulation.clear();
    Diagonal_exchange<Builder> exchange_diagonals(m_cloud.positions(), octree, builder);
    exchange_diagonals(m_progress);
    if (!m_progress.is_cancelled())
      m_progress.visitor().on_points_unused(unused);
    m_progress.end_stage(attached);
  }

  // Removes crossings of the triangles stored from `first` on, and the loops of the points `unclosed`. The new
  // triangles of a component may cross others, and so may what closes holes that they leave and points that were left
  // out when they are inserted again. Returns the number of unused points, which was `unused`.
  template <typename CloseAgain>
  std::size_t remove_crossings(typename Builder::Triangle_index first, std::vector<Point_index> unclosed,
                               const Point_octree_3& octree, Builder& builder, const CloseAgain& close_again,
                               Point_insertion<Builder>& insert, std::size_t unused)
  {
    constexpr int PASSES = 2, MAXIMUM_PASSES = 8;
    Crossing_removal<ConcurrencyTag, Builder> remove(m_cloud.positions(), m_normals, octree, maximum_radius(), builder,
                                                     m_triangulation);
    std::size_t crossings = 0;
    for (int pass = 0; pass != MAXIMUM_PASSES; ++pass) {
      const auto next = static_cast<typename Builder::Triangle_index>(builder.number_of_stored_triangles());
      if (!remove(first, unclosed, m_progress))
        break;
      unclosed.clear();
      close_again();
      unused = insert(m_progress);
      first = next;
      // More passes are worth their time as long as they leave few.
      if (pass + 1 >= PASSES && 2 * remove.number_of_crossings() > crossings)
        break;
      crossings = remove.number_of_crossings();
    }
    return unused;
  }

  bool write_oriented(Builder& builder, const Triangle_output& output, double share)
  {
    m_progress.begin_stage(Stage::ORIENTATION, share);
    Surface_orientation<Builder> orientation(m_cloud.positions(), builder);
    if (!m_progress.advance(0.)) {
      m_progress.end_stage(0);
      return false;
    }
    if (m_normals.empty())
      orientation.face_outward([&] { return m_progress.advance(0.); });
    else
      orientation.align_with_normals([&](Point_index p) { return m_normals[p]; });
    m_progress.end_stage(orientation.number_of_triangles());
    if (!m_progress.finish())
      return false;
    orientation.for_each_oriented_triangle([&](const typename Builder::Triangle& t) { output(input_triangle(t)); });
    return true;
  }

  // Tells the visitor what happened to a triangle.
  void report(const typename Builder::Triangle& t, Triangle_verdict verdict)
  {
    m_progress.visitor().on_triangle(input_triangle(t), verdict);
  }

private:
  static constexpr std::size_t NO_LIMIT = (std::numeric_limits<std::size_t>::max)();

  bool closes_all_loops() const { return !m_options.keep_boundaries && m_options.maximum_hole_size == NO_LIMIT; }

  double maximum_radius() const
  {
    return m_options.neighbor_radius > 0. ? m_cloud.local_length(m_options.neighbor_radius)
                                          : std::numeric_limits<double>::infinity();
  }

  // Whether triangles stored from `first` on cross the surface; false if cancelled.
  bool crosses(const Builder& builder, typename Builder::Triangle_index first)
  {
    Cancellation_point<Progress<Visitor> > cancellation_point(m_progress);
    try {
      return !Surface_crossings<Builder>(m_cloud.positions(), builder)(first, cancellation_point).empty();
    } catch (const Cancelled&) {
      return false;
    }
  }

  // Those that are boundaries of the surface; none if cancelled.
  template <typename IsBoundary>
  std::vector<Boundary_loop> boundary_loops(const Builder& builder, const IsBoundary& is_boundary)
  {
    Cancellation_point<Progress<Visitor> > cancellation_point(m_progress);
    std::vector<Boundary_loop> loops;
    try {
      loops = Boundary_loops<Builder>(m_cloud.positions(), builder)(cancellation_point);
    } catch (const Cancelled&) {
    }
    loops.erase(std::remove_if(loops.begin(), loops.end(), [&](const Boundary_loop& l) { return !is_boundary(l); }),
                loops.end());
    return loops;
  }

  static bool are_most_stars_open(const Builder& builder, const Boundary_loop& loop)
  {
    std::size_t open = 0;
    for (Point_index p : loop)
      open += builder.compatibility().is_star_open(p) ? 1u : 0u;
    return 2 * open > loop.size();
  }

  Input_triangle input_triangle(const typename Builder::Triangle& t) const
  {
    return Input_triangle{ { m_cloud.input_index(t[0]), m_cloud.input_index(t[1]), m_cloud.input_index(t[2]) } };
  }

  const Cloud& m_cloud;
  const std::vector<Local_vector>& m_normals;
  const StarConstruction& m_construction;
  const Reconstruction_options m_options;
  Progress<Visitor>& m_progress;
  const Predicates m_predicates;
  Kept_triangulation m_triangulation; // most of what the later stages look at is the same
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_STAGES_H

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

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Manifold_builder.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_cloud_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Prism_recognition.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Surface_predicates.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/conflict_completion.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/hole_closing.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/orientation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/star_compatibility.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/star_construction.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_closing.h>

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
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
                                                       m_progress, !closing_options().closes_all_loops());
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
    m_is_prism =
      closing_options().closes_all_loops() && Prism_recognition<Builder>(m_cloud.positions(), builder)(m_progress);
    if (m_is_prism) {
      m_progress.end_stage(builder.number_of_stored_triangles());
      return;
    }
    std::size_t attached = 0;
    const auto on_verdict = report_and_count(attached);
    Hole_closing<Builder> close(m_cloud.positions(), builder, m_options.maximum_hole_size);
    close.close_planar_loops(m_progress, on_verdict);
    if (closing_options().closes_all_loops())
      close.close_faces_with_holes(m_progress, on_verdict);
    Conflict_completion<ConcurrencyTag, Builder> complete(m_cloud.positions(), octree, maximum_radius(), builder);
    complete(m_progress, on_verdict, m_triangulation);
    m_progress.end_stage(attached);
  }

  void close_holes(const Point_octree_3& octree, Builder& builder, double share)
  {
    m_progress.begin_stage(Stage::HOLES, share);
    std::size_t attached = 0;
    const auto on_verdict = report_and_count(attached);
    Surface_closing<ConcurrencyTag, Builder, StarConstruction, Progress<Visitor>, decltype(on_verdict)> close(
      m_cloud.positions(), m_normals, octree, m_construction, closing_options(), builder, m_triangulation, m_progress,
      on_verdict);
    const std::size_t unused = close();
    if (!m_progress.is_cancelled())
      m_progress.visitor().on_points_unused(unused);
    m_progress.end_stage(attached);
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
  // What is called with the verdicts of a stage: tells the visitor, and counts the triangles attached.
  auto report_and_count(std::size_t& attached)
  {
    return [this, &attached](const typename Builder::Triangle& t, Triangle_verdict verdict) {
      attached += verdict == Triangle_verdict::ADDED ? 1u : 0u;
      report(t, verdict);
    };
  }

  Closing_options closing_options() const
  {
    return Closing_options{ maximum_radius(), m_options.maximum_hole_size, m_options.keep_boundaries, !m_is_prism };
  }

  double maximum_radius() const
  {
    return m_options.neighbor_radius > 0. ? m_cloud.local_length(m_options.neighbor_radius)
                                          : std::numeric_limits<double>::infinity();
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
  bool m_is_prism = false;            // then its stars, which do not know of the other end, are of no use
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_STAGES_H

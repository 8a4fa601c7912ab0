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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LIS_RECONSTRUCTOR_3_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LIS_RECONSTRUCTOR_3_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Linear_pieces.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_cloud_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Regular_diagonals.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_opening.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/cell_signs.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/label_relaxation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/chart_normals.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/flatness.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/hull_facets.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelled_surface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/side_of_normals.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/star_construction.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_refinement.h>
#include <CGAL/Interpolating_surface_reconstruction_3/linear_implicit_weights.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// What the user can ask of a reconstruction by an implicit function.
struct Lis_options
{
  double neighbor_radius = 0.; // in the user's unit; 0: unlimited
  double grid_spacing = 0.;    // in the user's unit; 0: no finer than the samples
  bool keep_boundaries = false;
  bool encloses_sheets = false; // samples of an open sheet get a closed surface, too
};

// Oriented triangles; vertices from the number of samples on are added points.
struct Lis_surface
{
  std::vector<Local_point> added_points;
  std::vector<std::array<Point_index, 3> > triangles;
};

// Linear implicit surface (thesis chapter 5): the tangent planes at the samples are blended into one
// function; its signs label the Delaunay tetrahedra of the samples inside and outside, and the surface
// consists of the facets between the labels.
template <typename ConcurrencyTag, typename Traits, typename StarConstruction, typename Visitor>
class Lis_reconstructor_3
{
public:
  using Cloud = Point_cloud_3<Traits>;
  using Triangle = std::array<Point_index, 3>;
  using Triangles = std::vector<Triangle>;

  // `normals` are in the order of the cloud and have unit length, or there are none.
  Lis_reconstructor_3(const Cloud& cloud, std::vector<Local_vector> normals, const StarConstruction& construction,
                      const Lis_options& options, Progress<Visitor>& progress)
    : m_cloud(cloud), m_normals(std::move(normals)), m_construction(construction), m_options(options),
      m_progress(progress), m_cancellation_point(progress)
  { }

  // Returns false if cancelled.
  bool operator()(Lis_surface& surface);

private:
  // Shares of the run time, measured on scans, for the progress.
  static constexpr double INDEXING_SHARE = .7, FUNCTION_SHARE = .1, ISOSURFACE_SHARE = .2;

  // The part of the indexing that the charts take, if there are no normals.
  static constexpr double NORMALS_PART = .5;

  // The Delaunay triangulation of the samples with normals.
  Cell_complex triangulate()
  {
    m_progress.begin_stage(Stage::INDEXING, INDEXING_SHARE);
    if (m_normals.empty())
      find_normals();
    std::vector<Point_index> samples;
    if (!m_progress.is_cancelled() && !is_flat_up_to_rounding(m_cloud.positions()))
      for (Point_index p = 0; p != m_cloud.size(); ++p)
        if (m_normals[p] != Local_vector(0, 0, 0))
          samples.push_back(p);
    Cell_complex cells(m_cloud.positions(), std::move(samples), m_cancellation_point);
    m_progress.end_stage(cells.size());
    return cells;
  }

  // Samples without normals get those of a surface of compatible charts, but for points that it leaves out.
  void find_normals()
  {
    m_normals =
      chart_normals<ConcurrencyTag>(m_cloud, m_construction, m_options.neighbor_radius,
                                    [this](double fraction) { return m_progress.advance(NORMALS_PART * fraction); });
  }

  // Samples in one plane have no tetrahedra, or none but for rounding, and those of no surface too many; those of a
  // sheet have no inside.
  void connect_charts(Lis_surface& surface)
  {
    m_progress.begin_stage(Stage::ISOSURFACE, FUNCTION_SHARE + ISOSURFACE_SHARE);
    surface.triangles =
      chart_triangles<ConcurrencyTag>(m_cloud, m_normals, m_construction, chart_options(),
                                      [this](double fraction) { return m_progress.advance(fraction); });
    refine(surface);
    m_progress.end_stage(surface.triangles.size());
  }

  Reconstruction_options chart_options() const
  {
    Reconstruction_options result;
    result.neighbor_radius = m_options.neighbor_radius;
    result.keep_boundaries = m_options.keep_boundaries;
    return result;
  }

  void turn_normals()
  {
    for (Local_vector& n : m_normals)
      n = -n;
  }

  static void turn_over(Lis_surface& surface)
  {
    for (Triangle& t : surface.triangles)
      std::swap(t[1], t[2]);
  }

  Oriented_labelling find_signs(const Cell_complex& cells)
  {
    m_progress.begin_stage(Stage::FUNCTION, FUNCTION_SHARE);
    const Cell_signs signs(cells, m_cloud.positions(), m_normals);
    Oriented_labelling labelling(cells, m_cloud.positions(), m_normals,
                                 signs.template compute<ConcurrencyTag>([this] { return m_progress.advance(0.); }));
    m_progress.end_stage(cells.size());
    return labelling;
  }

  void extract_surface(const Cell_complex& cells, Oriented_labelling& labelling, Lis_surface& surface)
  {
    m_progress.begin_stage(Stage::ISOSURFACE, ISOSURFACE_SHARE);
    relax_labels(cells, labelling, m_cancellation_point);
    make_manifold(cells, labelling, m_cancellation_point);
    Regular_diagonals diagonals(cells, m_cloud.positions(), labelling);
    relax_labels(cells, diagonals, m_cancellation_point);
    surface.triangles = facets_between_labels(cells, labelling, m_cancellation_point);
    if (surface.triangles.empty()) // few samples, whose normals agree with none of the facets
      surface.triangles = hull_facets(cells);
    if (m_options.keep_boundaries)
      surface.triangles = Boundary_opening(m_cloud.positions(), m_normals, surface.triangles)();
    refine(surface);
    m_progress.end_stage(surface.triangles.size());
  }

  // Adds vertices on a surface that is smooth between the samples.
  void refine(Lis_surface& surface)
  {
    if (m_options.grid_spacing == 0. || surface.triangles.empty() || m_progress.is_cancelled())
      return;
    const Point_octree_3 octree(m_cloud.positions());
    const double maximum_radius = m_options.neighbor_radius > 0. ? m_cloud.local_length(m_options.neighbor_radius)
                                                                 : std::numeric_limits<double>::infinity();
    const Star_table stars =
      construct_stars<ConcurrencyTag>(m_cloud.positions(), octree, m_construction, maximum_radius, m_progress);
    if (m_progress.is_cancelled())
      return;
    const Linear_pieces pieces(m_cloud.positions(), m_normals, star_radii(m_cloud.positions(), stars));
    Surface_refinement split(m_cloud.positions(), surface.triangles, surface.added_points);
    split.template operator()<ConcurrencyTag>(
      m_cloud.local_length(m_options.grid_spacing),
      [&](const Local_point& x) { return pieces.moved_to_surface(x, Interpolating_weight()); },
      [this](double fraction) { return m_progress.advance(fraction); });
  }

  bool finish(const Lis_surface& surface)
  {
    if (m_progress.is_cancelled())
      return false;
    std::vector<unsigned char> is_used(m_cloud.size() + surface.added_points.size(), 0);
    for (const Triangle& t : surface.triangles)
      for (Point_index p : t)
        is_used[p] = 1;
    std::size_t unused = 0;
    for (Point_index p = 0; p != m_cloud.size(); ++p)
      unused += is_used[p] == 0 ? 1u : 0u;
    m_progress.visitor().on_points_unused(unused);
    return m_progress.finish();
  }

  const Cloud& m_cloud;
  std::vector<Local_vector> m_normals;
  const StarConstruction& m_construction;
  const Lis_options m_options;
  Progress<Visitor>& m_progress;
  Cancellation_point<Progress<Visitor> > m_cancellation_point;
};

// Not inline, so that a program may instantiate it once for all of its translation units.
template <typename ConcurrencyTag, typename Traits, typename StarConstruction, typename Visitor>
bool Lis_reconstructor_3<ConcurrencyTag, Traits, StarConstruction, Visitor>::operator()(Lis_surface& surface)
{
  try {
    const Cell_complex cells = triangulate();
    const Hull_flux flux(cells, m_cloud.positions(), m_normals);
    if (cells.size() == 0 || (flux.is_through_sheet() && !m_options.encloses_sheets)) {
      connect_charts(surface);
    } else {
      // The surface of samples whose normals point inward is that of the opposite normals, turned over.
      const bool is_inside_out = flux.is_inward();
      if (is_inside_out)
        turn_normals();
      Oriented_labelling labelling = find_signs(cells);
      extract_surface(cells, labelling, surface);
      if (is_inside_out)
        turn_over(surface);
    }
  } catch (const Cancelled&) {
    return false;
  }
  return finish(surface);
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LIS_RECONSTRUCTOR_3_H

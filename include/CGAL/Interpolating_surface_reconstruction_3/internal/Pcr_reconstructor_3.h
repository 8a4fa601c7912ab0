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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PCR_RECONSTRUCTOR_3_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PCR_RECONSTRUCTOR_3_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/reconstruction_stages.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_growth.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Proximity, coplanarity and regularity (thesis chapter 3): the surface grows from its most planar star,
// the most coplanar triangle first.
template <typename ConcurrencyTag, typename Traits, typename StarConstruction, typename Visitor>
class Pcr_reconstructor_3
{
public:
  using Stages = Reconstruction_stages<ConcurrencyTag, Traits, StarConstruction, Visitor>;
  using Builder = typename Stages::Builder;

  // `normals` are in the order of the cloud, or empty.
  Pcr_reconstructor_3(const typename Stages::Cloud& cloud, const std::vector<Local_vector>& normals,
                      const StarConstruction& construction, const Reconstruction_options& options,
                      Progress<Visitor>& progress)
    : m_cloud(cloud), m_stages(cloud, normals, construction, options, progress), m_progress(progress)
  { }

  // Calls output(triangle) for each triangle of the surface; returns false if cancelled, before the
  // first call.
  bool operator()(const Triangle_output& output);

private:
  // Shares of the run time, measured on scans, for the progress.
  static constexpr double INDEXING_SHARE = .05, STARS_SHARE = .5, COMPATIBILITY_SHARE = .1, GROWING_SHARE = .15,
                          COMPLETION_SHARE = .1, HOLES_SHARE = .05, ORIENTATION_SHARE = .05;

  void grow(Builder& builder)
  {
    m_progress.begin_stage(Stage::GROWING, GROWING_SHARE);
    Surface_growth<Builder> growth(m_cloud.positions(), builder);
    const std::size_t attached = growth.template grow_from_seeds<ConcurrencyTag>(
      m_progress, [&](const typename Builder::Triangle& t, Triangle_verdict verdict) { m_stages.report(t, verdict); });
    m_progress.end_stage(attached);
  }

  const typename Stages::Cloud& m_cloud;
  Stages m_stages;
  Progress<Visitor>& m_progress;
};

// Not inline, so that a program may instantiate it once for all of its translation units.
template <typename ConcurrencyTag, typename Traits, typename StarConstruction, typename Visitor>
bool Pcr_reconstructor_3<ConcurrencyTag, Traits, StarConstruction, Visitor>::operator()(const Triangle_output& output)
{
  const Point_octree_3 octree = m_stages.build_octree(INDEXING_SHARE);
  if (m_progress.is_cancelled())
    return false;
  const Star_table stars = m_stages.build_stars(octree, STARS_SHARE);
  if (m_progress.is_cancelled())
    return false;
  Star_compatibility compatibility = m_stages.find_agreed_triangles(stars, COMPATIBILITY_SHARE);
  if (m_progress.is_cancelled())
    return false;
  Builder builder(compatibility, m_stages.predicates());
  grow(builder);
  if (m_progress.is_cancelled())
    return false;
  m_stages.complete_conflicts(octree, builder, COMPLETION_SHARE);
  if (m_progress.is_cancelled())
    return false;
  m_stages.close_holes(octree, builder, HOLES_SHARE);
  return !m_progress.is_cancelled() && m_stages.write_oriented(builder, output, ORIENTATION_SHARE);
}

template <typename ConcurrencyTag>
struct Pcr_algorithm
{
  template <typename Traits, typename StarConstruction, typename Visitor>
  using Reconstructor = Pcr_reconstructor_3<ConcurrencyTag, Traits, StarConstruction, Visitor>;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PCR_RECONSTRUCTOR_3_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CTC_RECONSTRUCTOR_3_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CTC_RECONSTRUCTOR_3_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/reconstruction_stages.h>

#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Compatible triangle charts (thesis chapter 4): a star of triangles at every point, made compatible
// into an atlas of the surface.
template <typename ConcurrencyTag, typename Traits, typename StarConstruction, typename Visitor>
class Ctc_reconstructor_3
{
public:
  using Stages = Reconstruction_stages<ConcurrencyTag, Traits, StarConstruction, Visitor>;
  using Builder = typename Stages::Builder;

  // `normals` are in the order of the cloud, or empty.
  Ctc_reconstructor_3(const typename Stages::Cloud& cloud, const std::vector<Local_vector>& normals,
                      const StarConstruction& construction, const Reconstruction_options& options,
                      Progress<Visitor>& progress)
    : m_stages(cloud, normals, construction, options, progress), m_progress(progress)
  { }

  // Calls output(triangle) for each triangle of the surface; returns false if cancelled, before the
  // first call.
  bool operator()(const Triangle_output& output);

private:
  // Shares of the run time, measured on scans, for the progress.
  static constexpr double INDEXING_SHARE = .05, STARS_SHARE = .6, COMPATIBILITY_SHARE = .1, COMPLETION_SHARE = .1,
                          HOLES_SHARE = .05, ORIENTATION_SHARE = .1;

  Stages m_stages;
  Progress<Visitor>& m_progress;
};

// Not inline, so that a program may instantiate it once for all of its translation units.
template <typename ConcurrencyTag, typename Traits, typename StarConstruction, typename Visitor>
bool Ctc_reconstructor_3<ConcurrencyTag, Traits, StarConstruction, Visitor>::operator()(const Triangle_output& output)
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
  m_stages.complete_conflicts(octree, builder, COMPLETION_SHARE);
  if (m_progress.is_cancelled())
    return false;
  m_stages.close_holes(octree, builder, HOLES_SHARE);
  return !m_progress.is_cancelled() && m_stages.write_oriented(builder, output, ORIENTATION_SHARE);
}

template <typename ConcurrencyTag>
struct Ctc_algorithm
{
  template <typename Traits, typename StarConstruction, typename Visitor>
  using Reconstructor = Ctc_reconstructor_3<ConcurrencyTag, Traits, StarConstruction, Visitor>;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CTC_RECONSTRUCTOR_3_H

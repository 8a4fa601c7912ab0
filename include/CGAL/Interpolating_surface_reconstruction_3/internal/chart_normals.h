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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CHART_NORMALS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CHART_NORMALS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Any_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Ctc_reconstructor_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_cloud_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/vertex_normals.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The surface of compatible charts through the points (thesis chapter 4) as triangles of cloud indices.
// `keep_going(fraction)` is asked now and then; nothing comes back after it returned false. `normals`
// orient the triangles, if there are any.
template <typename ConcurrencyTag, typename Cloud, typename StarConstruction, typename KeepGoing>
std::vector<std::array<Point_index, 3> >
chart_triangles(const Cloud& cloud, const std::vector<Local_vector>& normals, const StarConstruction& construction,
                const Reconstruction_options& options, const KeepGoing& keep_going)
{
  using Reconstructor =
    Ctc_reconstructor_3<ConcurrencyTag, typename Cloud::Traits_class, StarConstruction, Any_visitor>;
  std::vector<Point_index> cloud_index;
  for (Point_index p = 0; p != cloud.size(); ++p) {
    cloud_index.resize((std::max)(cloud_index.size(), cloud.input_index(p) + 1));
    cloud_index[cloud.input_index(p)] = p;
  }
  Stored_visitor<Default_visitor> visitor;
  Progress<Any_visitor> progress(std::function<bool(double)>(keep_going), visitor);
  std::vector<std::array<Point_index, 3> > triangles;
  Reconstructor(cloud, normals, construction, options, progress)([&](const std::array<std::size_t, 3>& t) {
    triangles.push_back({ { cloud_index[t[0]], cloud_index[t[1]], cloud_index[t[2]] } });
  });
  return triangles;
}

// Normals for points without: those of the vertices of the charts, zero at points that they leave out.
template <typename ConcurrencyTag, typename Cloud, typename StarConstruction, typename KeepGoing>
std::vector<Local_vector> chart_normals(const Cloud& cloud, const StarConstruction& construction,
                                        double neighbor_radius, const KeepGoing& keep_going)
{
  Reconstruction_options options;
  options.neighbor_radius = neighbor_radius;
  const std::vector<std::array<Point_index, 3> > triangles =
    chart_triangles<ConcurrencyTag>(cloud, {}, construction, options, keep_going);
  keep_going(1.);
  return vertex_normals(cloud.positions(), triangles);
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CHART_NORMALS_H

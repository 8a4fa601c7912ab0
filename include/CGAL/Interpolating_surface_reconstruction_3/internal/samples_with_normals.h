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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SAMPLES_WITH_NORMALS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SAMPLES_WITH_NORMALS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_cloud_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/reconstruction_call.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>

#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The points without those that have no usable normal; of no use if go_further() is false.
template <typename Types, typename PointRange, typename NamedParameters, typename GoFurther>
Point_cloud_3<typename Types::Traits> read_samples(const PointRange& points, const NamedParameters& np,
                                                   const typename Types::Traits& traits, const GoFurther& go_further)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const typename Types::Point_map point_map =
    choose_parameter<typename Types::Point_map>(get_parameter(np, internal_np::point_map));
  if constexpr (Types::has_normals) {
    const auto normal_map = get_parameter(np, internal_np::normal_map);
    if (is_usable(normal_map))
      return Point_cloud_3<typename Types::Traits>(
        points, point_map, traits,
        [&](const auto& element) { return unit_normal(get(normal_map, element), traits) != Local_vector(0, 0, 0); },
        go_further);
  }
  return Point_cloud_3<typename Types::Traits>(
    points, point_map, traits, [](const auto&) { return true; }, go_further);
}

// Their normals at unit length in the order of the cloud, or none if they are not given.
template <typename Types, typename PointRange, typename NamedParameters, typename Cloud>
std::vector<Local_vector> read_sample_normals(const PointRange& points, const NamedParameters& np, const Cloud& cloud)
{
  if constexpr (Types::has_normals)
    return read_normals(points, parameters::get_parameter(np, internal_np::normal_map), cloud);
  else
    return {};
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SAMPLES_WITH_NORMALS_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LIS_CALL_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LIS_CALL_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Lis_reconstructor_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_cloud_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/parameter_check.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/reconstruction_call.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/samples_with_normals.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Input position of a vertex that is no sample.
constexpr std::size_t NO_INPUT_INDEX = (std::numeric_limits<std::size_t>::max)();

inline double checked_grid_spacing(double spacing)
{
  if (!std::isfinite(spacing) || spacing < 0.)
    throw std::invalid_argument("grid_spacing: must be finite and not negative");
  return spacing;
}

template <typename NamedParameters>
Lis_options read_lis_options(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Lis_options options;
  options.neighbor_radius =
    checked_neighbor_radius(CGAL::to_double(choose_parameter(get_parameter(np, internal_np::neighbor_radius), 0.)));
  options.grid_spacing =
    checked_grid_spacing(CGAL::to_double(choose_parameter(get_parameter(np, internal_np::grid_spacing), 0.)));
  options.keep_boundaries = choose_parameter(get_parameter(np, internal_np::keep_boundaries), false);
  return options;
}

// The sample at each position in the input up to that of the last one, NO_POINT if there is none.
template <typename Cloud>
std::vector<Point_index> samples_in_input_order(const Cloud& cloud)
{
  std::size_t size = 0;
  for (Point_index p = 0; p != cloud.size(); ++p)
    size = (std::max)(size, cloud.input_index(p) + 1);
  std::vector<Point_index> result(size, NO_POINT);
  for (Point_index p = 0; p != cloud.size(); ++p)
    result[cloud.input_index(p)] = p;
  return result;
}

// Passes a surface on: add_vertex(point, input position) for each vertex, first the samples in the
// order of the input, then add_triangle(three numbers of vertices) for each triangle.
template <typename Cloud, typename AddVertex, typename AddTriangle>
void write_surface(const Cloud& cloud, const Lis_surface& surface, const AddVertex& add_vertex,
                   const AddTriangle& add_triangle)
{
  std::vector<std::size_t> vertex_of(cloud.size() + surface.added_points.size(), NO_INPUT_INDEX);
  for (const auto& t : surface.triangles)
    for (Point_index p : t)
      vertex_of[p] = 0;
  std::size_t next = 0;
  for (Point_index p : samples_in_input_order(cloud))
    if (p != NO_POINT && vertex_of[p] != NO_INPUT_INDEX) {
      vertex_of[p] = next++;
      add_vertex(cloud.point(p), cloud.input_index(p));
    }
  for (std::size_t i = 0; i != surface.added_points.size(); ++i) {
    vertex_of[cloud.size() + i] = next++;
    add_vertex(cloud.global_point(surface.added_points[i]), NO_INPUT_INDEX);
  }
  for (const auto& t : surface.triangles)
    add_triangle(std::array<std::size_t, 3>{ { vertex_of[t[0]], vertex_of[t[1]], vertex_of[t[2]] } });
}

// Reads and checks the parameters, reconstructs, and passes the surface on by write(cloud, surface).
// Returns false if cancelled; nothing is written then.
template <typename ConcurrencyTag, typename PointRange, typename Write, typename NamedParameters>
bool reconstruct_lis(const PointRange& points, const Write& write, const NamedParameters& np)
{
  static_assert(
    Only_allowed<NamedParameters, internal_np::point_t, internal_np::normal_t, internal_np::geom_traits_t,
                 internal_np::callback_t, internal_np::visitor_t, internal_np::neighbor_radius_t,
                 internal_np::grid_spacing_t, internal_np::keep_boundaries_t, internal_np::star_construction_t>::value,
    "a named parameter is not known to this function");
  using Call = Reconstruction_call<PointRange, NamedParameters>;
  using Types = typename Call::Types;
  using Traits = typename Types::Traits;
  using Reconstructor =
    Lis_reconstructor_3<ConcurrencyTag, Traits, typename Types::Star_construction, typename Call::Visitor>;

  const Lis_options options = read_lis_options(np);
  Call call(np);
  return call(points, [&] {
    const Point_cloud_3<Traits> cloud =
      read_samples<Types>(points, np, call.traits, [&] { return call.progress.advance(0.); });
    if (!call.may_go_on_with(cloud))
      return false;
    std::vector<Local_vector> normals = read_sample_normals<Types>(points, np, cloud);
    Lis_surface surface;
    const bool is_complete =
      Reconstructor(cloud, std::move(normals), call.construction, options, call.progress)(surface);
    if (is_complete)
      write(cloud, surface);
    return is_complete;
  });
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LIS_CALL_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CALL_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CALL_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Any_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Call_types.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/reconstruction_stages.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_cloud_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/parameter_check.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>
#include <CGAL/Interpolating_surface_reconstruction_3/triangles_to_surface_mesh.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/number_utils.h>

#include <array>
#include <algorithm>
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

inline double checked_neighbor_radius(double radius)
{
  if (!std::isfinite(radius) || radius < 0.)
    throw std::invalid_argument("neighbor_radius: must be finite and not negative");
  return radius;
}

template <typename Integer>
std::size_t checked_maximum_hole_size(Integer size)
{
  static_assert(std::is_integral<Integer>::value, "maximum_hole_size must be an integer");
  if (std::is_signed<Integer>::value && size < Integer(0))
    throw std::invalid_argument("maximum_hole_size: must not be negative");
  return static_cast<std::size_t>(size);
}

template <typename NamedParameters>
Reconstruction_options read_options(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Reconstruction_options options;
  options.neighbor_radius =
    checked_neighbor_radius(CGAL::to_double(choose_parameter(get_parameter(np, internal_np::neighbor_radius), 0.)));
  options.maximum_hole_size = checked_maximum_hole_size(
    choose_parameter(get_parameter(np, internal_np::maximum_hole_size), (std::numeric_limits<std::size_t>::max)()));
  options.keep_boundaries = choose_parameter(get_parameter(np, internal_np::keep_boundaries), false);
  return options;
}

// A property map of a point set without normals is a map to nothing.
template <typename NormalMap>
bool is_usable(const NormalMap& normal_map)
{
  if constexpr (std::is_convertible<const NormalMap&, bool>::value)
    return static_cast<bool>(normal_map);
  else
    return true;
}

// A given normal at unit length, or zero if it is zero or not finite.
template <typename Vector, typename Traits>
Local_vector unit_normal(const Vector& normal, const Traits& traits)
{
  auto c = traits.construct_cartesian_const_iterator_3_object()(normal);
  const double x = CGAL::to_double(*c++), y = CGAL::to_double(*c++), z = CGAL::to_double(*c);
  // divided first: the square of a finite number may overflow or vanish
  const double largest = (std::max)({ std::abs(x), std::abs(y), std::abs(z) });
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z) || largest == 0.)
    return Local_vector(0, 0, 0);
  const Local_vector v(x / largest, y / largest, z / largest);
  return v / std::sqrt(v.squared_length());
}

// Given normals in the order of the cloud; one that is not finite counts as none.
template <typename PointRange, typename NormalMap, typename Cloud>
std::vector<Local_vector> read_normals(const PointRange& points, NormalMap normal_map, const Cloud& cloud)
{
  std::vector<Local_vector> normals;
  if (!is_usable(normal_map))
    return normals;
  normals.assign(cloud.size(), Local_vector(0, 0, 0));
  const std::size_t n = static_cast<std::size_t>(std::distance(points.begin(), points.end()));
  std::vector<Point_index> cloud_index(n, NO_POINT);
  for (Point_index p = 0; p != cloud.size(); ++p)
    cloud_index[cloud.input_index(p)] = p;
  std::size_t i = 0;
  for (auto it = points.begin(); it != points.end(); ++it, ++i)
    if (cloud_index[i] != NO_POINT)
      normals[cloud_index[i]] = unit_normal(get(normal_map, *it), cloud.traits());
  return normals;
}

// What all algorithms need of the parameters of a call, and its progress.
template <typename PointRange, typename NamedParameters>
class Reconstruction_call
{
public:
  using Types = Call_types<PointRange, NamedParameters>;
  using Visitor = Any_visitor;

private:
  Stored_visitor<typename Types::Visitor> m_visitor;

public:
  explicit Reconstruction_call(const NamedParameters& np)
    : m_visitor(choose<Default_visitor>(np, internal_np::visitor)),
      traits(choose<typename Types::Traits>(np, internal_np::geom_traits)),
      construction(choose<typename Types::Star_construction>(np, internal_np::star_construction)), visitor(m_visitor),
      progress(choose<std::function<bool(double)> >(np, internal_np::callback), visitor)
  { }

  // Runs reconstruct(), which returns false if cancelled, and so does this.
  template <typename Reconstruct>
  bool operator()(const PointRange& points, const Reconstruct& reconstruct)
  {
    visitor.on_reconstruction_begin(static_cast<std::size_t>(std::distance(points.begin(), points.end())));
    const bool is_complete = reconstruct();
    visitor.on_reconstruction_end(!is_complete);
    return is_complete;
  }

  // Returns false if reading the points has been cancelled.
  template <typename Cloud>
  bool may_go_on_with(const Cloud& cloud)
  {
    if (progress.is_cancelled()) {
      progress.finish();
      return false;
    }
    visitor.on_points_set_aside(cloud.number_of_duplicates(), cloud.number_of_non_finite_points());
    return true;
  }

  const typename Types::Traits traits;
  const typename Types::Star_construction construction;
  Visitor& visitor;
  Progress<Visitor> progress;

private:
  template <typename Default, typename Tag>
  static auto choose(const NamedParameters& np, Tag tag)
  {
    return parameters::choose_parameter<Default>(parameters::get_parameter(np, tag));
  }
};

// Reads and checks the parameters, runs the algorithm, and calls output(triangle) for each triangle.
// Returns false if cancelled; nothing is written then.
template <typename Algorithm, typename PointRange, typename Output, typename NamedParameters>
bool reconstruct(const PointRange& points, const Output& output, const NamedParameters& np)
{
  static_assert(Only_allowed<NamedParameters, internal_np::point_t, internal_np::normal_t, internal_np::geom_traits_t,
                             internal_np::callback_t, internal_np::visitor_t, internal_np::neighbor_radius_t,
                             internal_np::maximum_hole_size_t, internal_np::keep_boundaries_t,
                             internal_np::star_construction_t>::value,
                "a named parameter is not known to this function");
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Call = Reconstruction_call<PointRange, NamedParameters>;
  using Types = typename Call::Types;
  using Reconstructor =
    typename Algorithm::template Reconstructor<typename Types::Traits, typename Types::Star_construction,
                                               typename Call::Visitor>;

  const Reconstruction_options options = read_options(np);
  const typename Types::Point_map point_map =
    choose_parameter<typename Types::Point_map>(get_parameter(np, internal_np::point_map));
  Call call(np);
  return call(points, [&] {
    const Point_cloud_3<typename Types::Traits> cloud(
      points, point_map, call.traits, [](const auto&) { return true; }, [&] { return call.progress.advance(0.); });
    if (!call.may_go_on_with(cloud))
      return false;
    std::vector<Local_vector> normals;
    if constexpr (Types::has_normals)
      normals = read_normals(points, get_parameter(np, internal_np::normal_map), cloud);
    return Reconstructor(cloud, normals, call.construction, options, call.progress)(output);
  });
}

// The same with an output iterator of triangles, which is returned after the last of them.
template <typename Algorithm, typename PointRange, typename TriangleOutputIterator, typename NamedParameters>
TriangleOutputIterator reconstruct_triangles(const PointRange& points, TriangleOutputIterator triangles,
                                             const NamedParameters& np)
{
  reconstruct<Algorithm>(
    points, [&](const std::array<std::size_t, 3>& triangle) { *triangles++ = triangle; }, np);
  return triangles;
}

// The same as a mesh.
template <typename Algorithm, typename PointRange, typename Point, typename NamedParameters>
bool reconstruct_mesh(const PointRange& points, Surface_mesh<Point>& mesh, const NamedParameters& np)
{
  std::vector<std::array<std::size_t, 3> > triangles;
  const bool is_complete = reconstruct<Algorithm>(
    points, [&](const std::array<std::size_t, 3>& triangle) { triangles.push_back(triangle); }, np);
  return is_complete && triangles_to_surface_mesh(points, triangles, mesh, np);
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CALL_H

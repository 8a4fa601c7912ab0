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
#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/reconstruction_stages.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_cloud_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/parameter_check.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <array>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The types that the named parameters of a call over `PointRange` stand for.
template <typename PointRange, typename NamedParameters>
struct Call_types
{
  template <typename Tag, typename Default>
  using Parameter = typename internal_np::Lookup_named_param_def<Tag, NamedParameters, Default>::type;

  using Element = typename std::iterator_traits<typename PointRange::const_iterator>::value_type;
  using Point_map = Parameter<internal_np::point_t, Identity_property_map<Element> >;
  using Point_3 = typename boost::property_traits<Point_map>::value_type;
  using Traits = Parameter<internal_np::geom_traits_t, typename Kernel_traits<Point_3>::Kernel>;
  using Star_construction = Parameter<internal_np::star_construction_t, Restricted_voronoi_star_3>;
  using Stored_visitor = Parameter<internal_np::visitor_t, Default_visitor>;

  static constexpr bool has_normals = !parameters::is_default_parameter<NamedParameters, internal_np::normal_t>::value;
};

template <typename Visitor>
Visitor& unwrap(Visitor& visitor)
{
  return visitor;
}

template <typename Visitor>
Visitor& unwrap(std::reference_wrapper<Visitor>& visitor)
{
  return visitor.get();
}

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
  using Types = Call_types<PointRange, NamedParameters>;
  using Visitor = std::remove_reference_t<decltype(internal::unwrap(std::declval<typename Types::Stored_visitor&>()))>;

  const Reconstruction_options options = read_options(np);
  const typename Types::Point_map point_map =
    choose_parameter<typename Types::Point_map>(get_parameter(np, internal_np::point_map));
  const typename Types::Traits traits =
    choose_parameter<typename Types::Traits>(get_parameter(np, internal_np::geom_traits));
  const typename Types::Star_construction construction =
    choose_parameter<typename Types::Star_construction>(get_parameter(np, internal_np::star_construction));
  typename Types::Stored_visitor stored_visitor =
    choose_parameter<Default_visitor>(get_parameter(np, internal_np::visitor));
  Visitor& visitor = internal::unwrap(stored_visitor);
  const std::function<bool(double)> callback =
    choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>());

  Progress<Visitor> progress(callback, visitor);
  visitor.on_reconstruction_begin(static_cast<std::size_t>(std::distance(points.begin(), points.end())));
  const Point_cloud_3<typename Types::Traits> cloud(
    points, point_map, traits, [](const auto&) { return true; }, [&] { return progress.advance(0.); });
  if (progress.is_cancelled()) {
    progress.finish();
    visitor.on_reconstruction_end(true);
    return false;
  }
  visitor.on_points_set_aside(cloud.number_of_duplicates(), cloud.number_of_non_finite_points());
  std::vector<Local_vector> normals;
  if constexpr (Types::has_normals)
    normals = read_normals(points, get_parameter(np, internal_np::normal_map), cloud);

  using Reconstructor =
    typename Algorithm::template Reconstructor<typename Types::Traits, typename Types::Star_construction, Visitor>;
  const bool is_complete = Reconstructor(cloud, normals, construction, options, progress)(output);
  visitor.on_reconstruction_end(!is_complete);
  return is_complete;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CALL_H

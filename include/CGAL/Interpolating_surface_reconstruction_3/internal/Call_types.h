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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CALL_TYPES_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CALL_TYPES_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/property_map.h>

#include <iterator>

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
  using Visitor = Parameter<internal_np::visitor_t, Default_visitor>;

  static constexpr bool has_normals = !parameters::is_default_parameter<NamedParameters, internal_np::normal_t>::value;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CALL_TYPES_H

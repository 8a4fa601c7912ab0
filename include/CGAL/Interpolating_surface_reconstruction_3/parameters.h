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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_PARAMETERS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_PARAMETERS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

namespace CGAL {

// CGAL's own list of named parameters cannot be extended from outside, so the tags and the free
// functions are added next to it; combine() stands in for chaining with a dot.
namespace internal_np {

enum maximum_hole_size_t
{
  maximum_hole_size
};
enum keep_boundaries_t
{
  keep_boundaries
};
enum star_construction_t
{
  star_construction
};

} // namespace internal_np

namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Appends the parameters of `np` to the pack `head`.
template <typename Head, typename T, typename Tag>
auto append(const Head& head, const Named_function_parameters<T, Tag, internal_np::No_property>& np)
{
  return Named_function_parameters<T, Tag, Head>(np.v, head);
}

template <typename Head, typename T, typename Tag, typename Base>
auto append(const Head& head, const Named_function_parameters<T, Tag, Base>& np)
{
  const auto prefix = internal::append(head, static_cast<const Base&>(np));
  return Named_function_parameters<T, Tag, std::decay_t<decltype(prefix)> >(np.v, prefix);
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3

namespace parameters {

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3NamedParameters

starts a pack of named parameters with the largest number of boundary edges of a loop that is closed.
`0` closes no loop. It can be followed by CGAL's own parameters with a dot.
*/
template <typename K>
Named_function_parameters<K, internal_np::maximum_hole_size_t> maximum_hole_size(const K& value)
{
  return Named_function_parameters<K, internal_np::maximum_hole_size_t>(value);
}

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3NamedParameters

starts a pack of named parameters with the policy for openings of the sampled surface: `true` leaves
them open. It can be followed by CGAL's own parameters with a dot.
*/
template <typename K>
Named_function_parameters<K, internal_np::keep_boundaries_t> keep_boundaries(const K& value)
{
  return Named_function_parameters<K, internal_np::keep_boundaries_t>(value);
}

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3NamedParameters

starts a pack of named parameters with a model of `StarConstruction_3`.
It can be followed by CGAL's own parameters with a dot.
*/
template <typename K>
Named_function_parameters<K, internal_np::star_construction_t> star_construction(const K& value)
{
  return Named_function_parameters<K, internal_np::star_construction_t>(value);
}

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3NamedParameters

joins packs of named parameters into one, in this order:
`combine(point_set.parameters(), maximum_hole_size(64), keep_boundaries(true))`.
*/
template <typename NP>
NP combine(const NP& np)
{
  return np;
}

template <typename NP0, typename NP1, typename... NPs>
auto combine(const NP0& np0, const NP1& np1, const NPs&... nps)
{
  return parameters::combine(Interpolating_surface_reconstruction_3::internal::append(np0, np1), nps...);
}

} // namespace parameters
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_PARAMETERS_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PARAMETER_CHECK_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PARAMETER_CHECK_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// CGAL ignores a known parameter that a function does not read; a misspelt intent must not compile.
template <typename NamedParameters, typename... AllowedTags>
struct Only_allowed;

template <typename... AllowedTags>
struct Only_allowed<internal_np::No_property, AllowedTags...> : std::true_type
{ };

template <typename T, typename Tag, typename Base, typename... AllowedTags>
struct Only_allowed<Named_function_parameters<T, Tag, Base>, AllowedTags...>
  : std::bool_constant<(std::is_same<Tag, internal_np::all_default_t>::value ||
                        (std::is_same<Tag, AllowedTags>::value || ...)) &&
                       Only_allowed<Base, AllowedTags...>::value>
{ };

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PARAMETER_CHECK_H

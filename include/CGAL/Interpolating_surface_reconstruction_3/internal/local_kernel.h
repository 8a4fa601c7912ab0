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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LOCAL_KERNEL_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LOCAL_KERNEL_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Simple_cartesian.h>

#include <cstdint>
#include <limits>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Measures that only rank candidates are computed in double; predicates go through the traits.
using Local_kernel = Simple_cartesian<double>;
using Local_point = Local_kernel::Point_3;
using Local_vector = Local_kernel::Vector_3;

// Position of a point in the cloud; 32 bits halve the memory of every table.
using Point_index = std::uint32_t;

constexpr Point_index NO_POINT = (std::numeric_limits<Point_index>::max)();

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LOCAL_KERNEL_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_AREA_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_AREA_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

inline double surface_area(const std::vector<Local_point>& points,
                           const std::vector<std::array<Point_index, 3> >& triangles)
{
  double result = 0.;
  for (const std::array<Point_index, 3>& t : triangles)
    result += std::sqrt(cross_product(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]).squared_length()) / 2;
  return result;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_AREA_H

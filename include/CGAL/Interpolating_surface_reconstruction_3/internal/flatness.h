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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FLATNESS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FLATNESS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// How far points may be from their plane because files tell coordinates with six digits, in mean edges of their outline.
constexpr double ROUNDING_OF_SIX_DIGITS = 1e-4;

// The same of a flat face, with five digits: nothing but rounding moves its points out of its plane.
constexpr double ROUNDING_OF_FIVE_DIGITS = 1e-3;

// Whether the points lie in one plane but for the rounding of their coordinates, which turned what was
// one plane into a slab that is thinner than any shape in double precision.
inline bool is_flat_up_to_rounding(const std::vector<Local_point>& points)
{
  // Of a rotation, which adds three rounded products, and of the plane below.
  constexpr double ROUNDINGS = 32.;
  if (points.size() < 3)
    return true;
  const Local_point& origin = points.front();
  const auto farthest = [&](const auto& squared_distance) {
    return *std::max_element(points.begin(), points.end(), [&](const Local_point& p, const Local_point& q) {
      return squared_distance(p) < squared_distance(q);
    });
  };
  const auto squared_distance_to_origin = [&](const Local_point& p) { return (p - origin).squared_length(); };
  const Local_vector axis = farthest(squared_distance_to_origin) - origin;
  const auto squared_distance_to_axis = [&](const Local_point& p) {
    return cross_product(axis, p - origin).squared_length();
  };
  const Local_vector normal = cross_product(axis, farthest(squared_distance_to_axis) - origin);
  if (!(normal.squared_length() > 0.))
    return true;
  const auto squared_height = [&](const Local_point& p) {
    const double height = normal * (p - origin);
    return height * height / normal.squared_length();
  };
  return std::sqrt(squared_height(farthest(squared_height))) <=
         ROUNDINGS * std::numeric_limits<double>::epsilon() * std::sqrt(axis.squared_length());
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FLATNESS_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ISOSURFACE_CALL_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ISOSURFACE_CALL_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Container_helper.h>
#include <CGAL/number_utils.h>

#include <boost/range/value_type.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Corners of cells have 32-bit numbers; there are at most twice as many of them as of cells.
constexpr std::size_t LARGEST_NUMBER_OF_CELLS = std::size_t(1) << 30;

template <typename Traits>
typename Traits::Point_3 point_at(const std::array<double, 3>& x, const Traits& traits)
{
  using FT = typename Traits::FT;
  return traits.construct_point_3_object()(FT(x[0]), FT(x[1]), FT(x[2]));
}

template <typename Traits>
std::array<double, 3> coordinates_of(const typename Traits::Point_3& p, const Traits& traits)
{
  auto c = traits.construct_cartesian_const_iterator_3_object()(p);
  const double x = CGAL::to_double(*c++), y = CGAL::to_double(*c++), z = CGAL::to_double(*c);
  return { { x, y, z } };
}

// Appends the vertices and triangles of a contour.
template <typename Contour, typename Traits, typename OutputPointRange, typename OutputTriangleRange>
void append_contour(const Contour& contour, const Traits& traits, OutputPointRange& output_points,
                    OutputTriangleRange& output_triangles)
{
  using Output_point = typename boost::range_value<OutputPointRange>::type;
  using Output_triangle = typename boost::range_value<OutputTriangleRange>::type;
  const std::size_t first = output_points.size();
  for (const std::array<double, 3>& x : contour.vertices())
    output_points.push_back(Output_point(internal::point_at(x, traits)));
  for (const std::array<std::size_t, 3>& triangle : contour.triangles()) {
    Output_triangle t;
    CGAL::internal::resize(t, 3);
    for (std::size_t i = 0; i != 3; ++i)
      t[i] = static_cast<std::decay_t<decltype(t[i])> >(first + triangle[i]);
    output_triangles.push_back(std::move(t));
  }
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ISOSURFACE_CALL_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_LINEAR_IMPLICIT_ISOSURFACE_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_LINEAR_IMPLICIT_ISOSURFACE_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Linear_implicit_function_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/isosurface_call.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/marching_tetrahedra.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

triangulates the zero set of a linear implicit function on a regular grid, for comparison with the surface of
`CGAL::lis_reconstruction()`.

With the default step, the smallest radius of a star, and with `Quadratic_weight` as the weight of the function,
this is the method of the thesis (5.3.5), but for two things. The cubes of the grid are cut into tetrahedra, which
makes the surface an oriented manifold without boundary. And only cubes that the surface passes through are
visited, from those with a point on. The vertices are no points of the range.
`adaptive_linear_implicit_isosurface()` needs fewer cells where the spacing of the points varies.

The time and memory are proportional to the number of cubes visited, about the area of the surface over the
square of the step: non-uniform samples with a small default step need very many.

\tparam Traits a model of `InterpolatingReconstructionTraits_3`
\tparam Weight a model of `LinearImplicitWeight`
\tparam OutputPointRange a model of `BackInsertionSequence` whose value type can be constructed from
`Traits::Point_3`
\tparam OutputTriangleRange a model of `BackInsertionSequence` whose value type has `operator[]` for 0, 1 and 2

\param function the function
\param output_points receives the vertices
\param output_triangles receives for each triangle the positions of its vertices in `output_points`; both
ranges are appended to
\param step the length of the edges of the cubes, in the unit of the points; `0` stands for
`function.smallest_radius()`
\param maximum_number_of_cells the number of cubes that are visited at most

`std::invalid_argument` is thrown, and nothing is written, if `step` is negative or not finite, or if more cubes
than allowed would be needed; the message states their number.

\return the number of cubes visited

\sa `adaptive_linear_implicit_isosurface()`
*/
template <typename Traits, typename Weight, typename OutputPointRange, typename OutputTriangleRange>
std::size_t linear_implicit_isosurface(const Linear_implicit_function_3<Traits, Weight>& function,
                                       OutputPointRange& output_points, OutputTriangleRange& output_triangles,
                                       double step = 0., std::size_t maximum_number_of_cells = 20000000)
{
  using Coordinates = std::array<double, 3>;

  if (!std::isfinite(step) || step < 0.)
    throw std::invalid_argument("step: must be finite and not negative");
  if (step == 0.)
    step = CGAL::to_double(function.smallest_radius());
  if (step == 0.) // fewer than two points
    return 0;
  const std::size_t maximum = (std::min)(maximum_number_of_cells, internal::LARGEST_NUMBER_OF_CELLS);
  // every point stands for about the square of its radius
  const double cells = 2. * function.sum_of_squared_radii() / (step * step);
  const Bbox_3 box = function.bbox();
  if (!(cells <= double(maximum)) || !(box.xmax() - box.xmin() < step * 1e9) ||
      !(box.ymax() - box.ymin() < step * 1e9) || !(box.zmax() - box.zmin() < step * 1e9))
    throw std::invalid_argument("step: about " + std::to_string(cells) + " cells would be needed, more than " +
                                std::to_string(maximum));

  const Traits& traits = function.geom_traits();
  const auto value = [&](const Coordinates& x) { return CGAL::to_double(function(internal::point_at(x, traits))); };
  internal::Marching_tetrahedra<decltype(value)> march(value, { { box.xmin(), box.ymin(), box.zmin() } }, step,
                                                       maximum);
  function.for_each_point(
    [&](const typename Traits::Point_3& p) { march.add_seed(internal::coordinates_of(p, traits)); });
  march();
  internal::append_contour(march, traits, output_points, output_triangles);
  return march.number_of_visited_cubes();
}

} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_LINEAR_IMPLICIT_ISOSURFACE_H

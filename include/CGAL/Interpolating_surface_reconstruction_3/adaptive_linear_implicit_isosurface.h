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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_ADAPTIVE_LINEAR_IMPLICIT_ISOSURFACE_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_ADAPTIVE_LINEAR_IMPLICIT_ISOSURFACE_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Linear_implicit_function_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Adaptive_contour.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Adaptive_grid.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Banded_function.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/isosurface_call.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

triangulates the zero set of a linear implicit function with triangles as large as the spacing of the points asks
for.

The cells are the leaves of an octree, small where the stars of the points are small. Edges of cells and centers of
cells at them make tetrahedra that fit together whatever the sizes of the cells are, so that the triangles in them,
by the signs of the function at their corners, leave no crack: they are an oriented 2-manifold that does not cross
itself. The surface is followed from cells with a point on, and the function is evaluated at cells that it passes
through and at cells beside them. The vertices are no points of the range. The output does not depend on the number
of threads.

Far from the points, tangent planes do not tell the inside from the outside. The function counts only in a band around
the surface of `CGAL::lis_reconstruction()` through the points, closed for samples of an open sheet, too. The band is as
wide as the tangent planes at the vertices of the nearest triangle rise over it, each times the agreement of its normal
with that of the triangle; elsewhere, the signed distance from that surface counts, and in the band its share is the
square of its part of the width, so that the two join without a jump. The zero set is closed then, and has no part that
leads away from the points. Sheets that are nearer to each other than the size of the cells may touch and join. If that
surface is not closed, as through points in a plane, the function counts everywhere, and the zero set ends at the
bounding box of the points enlarged by twice their largest radius.

The number of cells is proportional to the number of points, whatever their bounding box is and however much their
spacing varies, and grows with the inverse square of `relative_step`, but for the evaluations of the function, which
take logarithmic time each. To the time and memory for them come those of `CGAL::lis_reconstruction()`.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` (needs \ref thirdpartyTBB) or
`CGAL::Parallel_if_available_tag`
\tparam Traits a model of `InterpolatingReconstructionTraits_3`
\tparam Weight a model of `LinearImplicitWeight`
\tparam OutputPointRange a model of `BackInsertionSequence` whose value type can be constructed from
`Traits::Point_3`
\tparam OutputTriangleRange a model of `BackInsertionSequence` whose value type has `operator[]` for 0, 1 and 2

\param function the function
\param output_points receives the vertices
\param output_triangles receives for each triangle the positions of its vertices in `output_points`; both
ranges are appended to
\param relative_step the largest size of the cells near a point, as a part of the mean radius of its star
\param maximum_number_of_cells the number of cells of the octree at most

`std::invalid_argument` is thrown, and nothing is written, if `relative_step` is not positive or not finite, or if
more cells than allowed would be needed. Nothing is written either for fewer than two points.

\return the number of cells visited

\sa `linear_implicit_isosurface()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename Traits, typename Weight, typename OutputPointRange,
          typename OutputTriangleRange>
std::size_t adaptive_linear_implicit_isosurface(const Linear_implicit_function_3<Traits, Weight>& function,
                                                OutputPointRange& output_points, OutputTriangleRange& output_triangles,
                                                double relative_step = 1.,
                                                std::size_t maximum_number_of_cells = 200000000)
{
  if (!std::isfinite(relative_step) || !(relative_step > 0.))
    throw std::invalid_argument("relative_step: must be finite and positive");
  if (!(function.smallest_radius() > 0)) // fewer than two points
    return 0;
  const std::size_t maximum = (std::min)(maximum_number_of_cells, internal::LARGEST_NUMBER_OF_CELLS);
  const Traits& traits = function.geom_traits();
  using Value = internal::Banded_function<ConcurrencyTag, Linear_implicit_function_3<Traits, Weight> >;
  const Value value(function);
  const Bbox_3 box = function.bbox();
  const double margin = (std::max)(2. * function.largest_radius(), 2. * value.largest_width()),
               size = (std::max)({ box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin() }) +
                      2. * margin;
  internal::Adaptive_grid grid({ { box.xmin() - margin, box.ymin() - margin, box.zmin() - margin } }, size);
  function.for_each_sample([&](const typename Traits::Point_3& p, double radius) {
    if (!grid.refine(internal::coordinates_of(p, traits), radius, relative_step * radius, maximum))
      throw std::invalid_argument("relative_step: more than " + std::to_string(maximum) + " cells would be needed");
  });

  internal::Adaptive_contour<ConcurrencyTag, Value> contour(value, grid);
  function.for_each_sample(
    [&](const typename Traits::Point_3& p, double) { contour.add_seed(internal::coordinates_of(p, traits)); });
  contour();
  internal::append_contour(contour, traits, output_points, output_triangles);
  return contour.number_of_visited_leaves();
}

} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_ADAPTIVE_LINEAR_IMPLICIT_ISOSURFACE_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_LABELLING_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_LABELLING_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Surface_sides.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/cell_signs.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/label_relaxation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Labels by the sides of a surface; where these are unknown, by the linear implicit function of its normals (thesis
// 5.2). `normals` must outlive the labels. Ends early if cancelled; `cancellation_point()` may throw.
template <typename ConcurrencyTag, typename Progress, typename CancellationPoint>
Oriented_labelling label_by_sides(const Cell_complex& cells, const Surface_sides& sides,
                                  const std::vector<Local_point>& points, const std::vector<Local_vector>& normals,
                                  Progress& progress, CancellationPoint& cancellation_point)
{
  // As a value of the function, which is in units of the distance to the samples.
  constexpr float CERTAIN = 100.f;
  using Side = Surface_sides::Side;
  const Cell_signs signs(cells, points, normals);
  std::vector<float> values = signs.template compute<ConcurrencyTag>(
    [&] { return progress.advance(0.); }, [&](Cell_complex::Cell_index c) { return sides[c] == Side::UNKNOWN; });
  for (Cell_complex::Cell_index c = 0; c != cells.size(); ++c)
    if (sides[c] != Side::UNKNOWN && !Cell_complex::is_infinite(cells[c]))
      values[c] = sides[c] == Side::INSIDE ? -CERTAIN : CERTAIN;
  Oriented_labelling labelling(cells, points, normals, std::move(values));
  relax_labels(cells, labelling, cancellation_point);
  return labelling;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_LABELLING_H

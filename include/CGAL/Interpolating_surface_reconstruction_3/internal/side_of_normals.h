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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SIDE_OF_NORMALS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SIDE_OF_NORMALS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/hull_facets.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Whether the normals at the vertices of the convex hull point into it, weighted by the area of its facets:
// what they call the outside is then bounded, as for the scan of a room. Where they are as often right
// as wrong, as on a sheet, they do not.
inline bool do_normals_point_inward(const Cell_complex& cells, const std::vector<Local_point>& positions,
                                    const std::vector<Local_vector>& normals)
{
  constexpr double ROUNDING = 1e-9;
  double flux = 0., area = 0.; // twice
  for (const std::array<Point_index, 3>& f : hull_facets(cells)) {
    const Local_vector n = cross_product(positions[f[1]] - positions[f[0]], positions[f[2]] - positions[f[0]]);
    flux += n * (normals[f[0]] + normals[f[1]] + normals[f[2]]) / 3.;
    area += std::sqrt(n.squared_length());
  }
  return flux < -ROUNDING * area;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SIDE_OF_NORMALS_H

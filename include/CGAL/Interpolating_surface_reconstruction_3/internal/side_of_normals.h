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

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The flux of the normals through the convex hull, per area: outward and inward, through the facets where it is so.
struct Hull_flux
{
  double outward = 0., inward = 0.;

  Hull_flux(const Cell_complex& cells, const std::vector<Local_point>& positions,
            const std::vector<Local_vector>& normals)
  {
    double area = 0.; // twice
    for (const std::array<Point_index, 3>& f : hull_facets(cells)) {
      const Local_vector n = cross_product(positions[f[1]] - positions[f[0]], positions[f[2]] - positions[f[0]]);
      const double flux = n * (normals[f[0]] + normals[f[1]] + normals[f[2]]) / 3.;
      (flux > 0. ? outward : inward) += std::abs(flux);
      area += std::sqrt(n.squared_length());
    }
    if (area > 0.) {
      outward /= area;
      inward /= area;
    }
  }

  // What the normals call the outside is then bounded, as for the scan of a room.
  bool is_inward() const
  {
    constexpr double ROUNDING = 1e-9;
    return outward - inward < -ROUNDING;
  }

  // The convex hull of a sheet has the outside of the sheet on one side and its inside on the other: a half each, or a
  // quarter where the sheet bends. Of solids, even with flipped normals, it has hardly any of the inside, and normals at
  // random cancel out.
  bool is_through_sheet() const
  {
    constexpr double LEAST_FLUX = .25;
    return (std::min)(outward, inward) > LEAST_FLUX;
  }
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SIDE_OF_NORMALS_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_VERTEX_NORMALS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_VERTEX_NORMALS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Of oriented triangles, at each point: the sum of their area vectors, twice; zero without a triangle.
inline std::vector<Local_vector> doubled_area_vectors(const std::vector<Local_point>& positions,
                                                      const std::vector<std::array<Point_index, 3> >& triangles)
{
  std::vector<Local_vector> result(positions.size(), Local_vector(0, 0, 0));
  for (const std::array<Point_index, 3>& t : triangles) {
    const Local_vector n = cross_product(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
    for (Point_index p : t)
      result[p] = result[p] + n;
  }
  return result;
}

// The vectors with length 1, or zero if they have none.
inline std::vector<Local_vector> unit_vectors(std::vector<Local_vector> vectors)
{
  for (Local_vector& v : vectors) {
    const double length = std::sqrt(v.squared_length());
    v = length > 0. && std::isfinite(length) ? v / length : Local_vector(0, 0, 0);
  }
  return vectors;
}

// Unit normals of the vertices of oriented triangles, weighted by area; zero at points without a
// triangle.
inline std::vector<Local_vector> vertex_normals(const std::vector<Local_point>& positions,
                                                const std::vector<std::array<Point_index, 3> >& triangles)
{
  return unit_vectors(doubled_area_vectors(positions, triangles));
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_VERTEX_NORMALS_H

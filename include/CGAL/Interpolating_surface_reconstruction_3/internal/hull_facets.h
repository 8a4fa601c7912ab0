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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_HULL_FACETS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_HULL_FACETS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The facets of the convex hull of the points of the cells, which face outward.
inline std::vector<std::array<Point_index, 3> > hull_facets(const Cell_complex& cells)
{
  std::vector<std::array<Point_index, 3> > facets;
  for (std::size_t c = 0; c != cells.size(); ++c)
    for (std::size_t i = 0; i != 4; ++i) {
      if (cells[c].vertices[i] != NO_POINT)
        continue;
      std::array<Point_index, 3> f = Cell_complex::facet(cells[c], i);
      // The facet is seen from the infinite cell, not from the convex hull.
      if (i % 2 == 0)
        std::swap(f[1], f[2]);
      facets.push_back(f);
    }
  return facets;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_HULL_FACETS_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_RINGS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_RINGS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Of each point, 1 if it is one of the given points or in one of the rings of triangles around them.
// `cancellation_point()` is called again and again and may throw.
template <typename Builder, typename CancellationPoint>
std::vector<unsigned char> mark_rings(const Builder& builder, const std::vector<Point_index>& points, int rings,
                                      CancellationPoint& cancellation_point)
{
  std::vector<unsigned char> is_marked(builder.number_of_points(), 0);
  std::vector<Point_index> marked;
  const auto mark = [&](Point_index p) {
    if (!is_marked[p]) {
      is_marked[p] = 1;
      marked.push_back(p);
    }
  };
  for (Point_index p : points)
    mark(p);
  std::size_t begin = 0;
  for (int ring = 0; ring != rings; ++ring)
    for (const std::size_t end = marked.size(); begin != end; ++begin) {
      cancellation_point();
      builder.for_each_triangle_at(marked[begin], [&](const std::array<Point_index, 3>& t) {
        for (Point_index p : t)
          mark(p);
      });
    }
  return is_marked;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_RINGS_H

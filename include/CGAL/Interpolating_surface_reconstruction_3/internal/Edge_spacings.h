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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_EDGE_SPACINGS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_EDGE_SPACINGS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The spacing at each vertex of a surface, to tell the edges that span an opening of the sampled surface: the length of
// its third shortest edge, as two edges of the outline of an opening and at least one other belong to the surface.
class Edge_spacings
{
public:
  // An opening has an edge that is far longer than the spacing: an octagon measures 2.6 of its edges. Its other edges
  // are longer than those of a grid, whose diagonals are the square root of 2 times the spacing.
  static constexpr double FAR_LONGER = 2.5, LONGER = 1.5;

  explicit Edge_spacings(const std::vector<Local_point>& points) : m_points(points), m_spacings(points.size(), 0.) { }

  // `neighbors` are those of p on the surface, each once; their order changes.
  template <typename Iterator>
  void set(Point_index p, Iterator neighbors, Iterator end)
  {
    if (neighbors == end)
      return;
    const Iterator third = neighbors + (std::min)(end - neighbors - 1, std::ptrdiff_t(2));
    std::nth_element(neighbors, third, end,
                     [&](Point_index a, Point_index b) { return squared_length(p, a) < squared_length(p, b); });
    m_spacings[p] = std::sqrt(squared_length(p, *third));
  }

  bool is_longer(Point_index p, Point_index q, double times) const
  {
    return std::sqrt(squared_length(p, q)) > times * (std::max)(m_spacings[p], m_spacings[q]);
  }

private:
  double squared_length(Point_index p, Point_index q) const { return (m_points[q] - m_points[p]).squared_length(); }

  const std::vector<Local_point>& m_points;
  std::vector<double> m_spacings;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_EDGE_SPACINGS_H

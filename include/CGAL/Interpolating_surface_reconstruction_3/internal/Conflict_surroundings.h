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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_SURROUNDINGS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_SURROUNDINGS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Nearest_neighbors.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Point_star.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// What the completion of a conflict must see of the points around it.
class Conflict_surroundings
{
public:
  Conflict_surroundings(const std::vector<Local_point>& points, const Point_octree_3& octree, double maximum_radius,
                        const Star_table& stars)
    : m_stars(stars), m_neighbors(points, octree, maximum_radius)
  { }

  // The neighbors of the point, its link, and the links of its link, so that their stars are complete; some of
  // them repeatedly.
  void operator()(Point_index p, std::vector<Point_index>& result)
  {
    result.assign(1, p);
    m_neighbors.for_point(p, NEIGHBORS, NEIGHBORS, [&](Point_index, const Star_neighborhood&) { return true; });
    result.insert(result.end(), m_neighbors.indices().begin(), m_neighbors.indices().end());
    const std::size_t before = result.size();
    add_link(p, result);
    const std::size_t inner = result.size();
    for (std::size_t i = before; i != inner; ++i)
      add_link(result[i], result);
  }

private:
  // Two rings of a regular sample hold 18 points.
  static constexpr std::size_t NEIGHBORS = 16;

  void add_link(Point_index p, std::vector<Point_index>& result) const
  {
    for (Star_table::Slot s = m_stars.begin(p); s != m_stars.end(p); ++s)
      if (m_stars.neighbor(s) != NO_POINT)
        result.push_back(m_stars.neighbor(s));
  }

  const Star_table& m_stars;
  Nearest_neighbors m_neighbors;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_SURROUNDINGS_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ISLAND_REMOVAL_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ISLAND_REMOVAL_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/star_compatibility.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Whether each of the points, which are increasing, has others in its star.
inline bool are_among_others(const Star_table& stars, const std::vector<Point_index>& points)
{
  return std::all_of(points.begin(), points.end(), [&](Point_index p) {
    for (Star_table::Slot s = stars.begin(p); s != stars.end(p); ++s)
      if (stars.neighbor(s) != NO_POINT && !std::binary_search(points.begin(), points.end(), stars.neighbor(s)))
        return true;
    return false;
  });
}

// Removes the islands of a surface: components without an agreed point that has kept its star, all of whose
// points have a point of another component in their star. No chart vouches for an island, and every chart on
// it says that it belongs to its surroundings; its points are left to the insertion of points.
template <typename Builder>
class Island_removal
{
public:
  explicit Island_removal(Builder& builder) : m_builder(builder) { }

  void operator()()
  {
    m_is_visited.assign(m_builder.number_of_points(), 0);
    const std::vector<Point_index> open_points = m_builder.open_points();
    for (Point_index p : open_points)
      if (!m_is_visited[p] && !is_vouched_for(p) && !m_builder.corners(p).empty() && find_component(p) &&
          are_among_others(m_builder.compatibility().stars(), m_component))
        remove_component();
  }

private:
  // Whether p is agreed and has all triangles of its star; the closing of holes may have removed some.
  bool is_vouched_for(Point_index p) const
  {
    const Star_compatibility& compatibility = m_builder.compatibility();
    if (!compatibility.is_point_agreed(p) || !m_builder.is_open(p))
      return compatibility.is_point_agreed(p);
    const Star_table& stars = compatibility.stars();
    const std::size_t triangles = stars.end(p) - stars.begin(p) - (compatibility.is_point_on_boundary(p) ? 2 : 0);
    return m_builder.corners(p).size() >= triangles;
  }

  // Collects the part of the component of p that such points do not cut off; false if there is one.
  bool find_component(Point_index p)
  {
    bool is_island = true;
    m_component.assign(1, p);
    m_is_visited[p] = 1;
    for (std::size_t i = 0; i != m_component.size(); ++i) {
      const auto& corners = m_builder.corners(m_component[i]);
      for (const auto& corner : corners)
        for (Point_index r : { corner.a, corner.b })
          if (is_vouched_for(r)) {
            is_island = false;
          } else if (!m_is_visited[r]) {
            m_is_visited[r] = 1;
            m_component.push_back(r);
          }
    }
    std::sort(m_component.begin(), m_component.end());
    return is_island;
  }

  void remove_component()
  {
    for (Point_index p : m_component)
      while (!m_builder.corners(p).empty())
        m_builder.remove(m_builder.corners(p).front().triangle);
  }

  Builder& m_builder;
  std::vector<unsigned char> m_is_visited;
  std::vector<Point_index> m_component;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ISLAND_REMOVAL_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_CLUSTERS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_CLUSTERS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Nearest_neighbors.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/star_compatibility.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The points at which the surface is neither closed nor ends at a boundary, in clusters that can be
// completed one by one.
template <typename Builder>
class Conflict_clusters
{
public:
  Conflict_clusters(const std::vector<Local_point>& points, const Point_octree_3& octree, double maximum_radius,
                    const Builder& builder)
    : m_builder(builder), m_neighbors(points, octree, maximum_radius)
  {
    for (Point_index p : m_builder.open_points())
      if (!is_on_boundary(p) && !m_builder.is_fan_closed(p))
        m_conflicts.push_back(p);
    std::sort(m_conflicts.begin(), m_conflicts.end());
  }

  const std::vector<Point_index>& conflicts() const { return m_conflicts; }

  // Which conflicts are in which cluster; none if cancelled.
  template <typename Progress>
  std::vector<std::vector<Point_index> > find(Progress& progress)
  {
    Parity_union_find sets(m_conflicts.size());
    std::vector<Point_index> positions(m_builder.number_of_points(), NO_POINT), around;
    for (std::size_t i = 0; i != m_conflicts.size(); ++i)
      positions[m_conflicts[i]] = static_cast<Point_index>(i);
    for (std::size_t i = 0; i != m_conflicts.size(); ++i) {
      if (i % CONFLICTS_PER_POLL == 0 && !progress.advance(0.))
        return {};
      surroundings(m_conflicts[i], around);
      for (Point_index q : around)
        if (positions[q] != NO_POINT)
          sets.unite(static_cast<Point_index>(i), positions[q], false);
    }
    std::vector<std::size_t> cluster_of(m_conflicts.size(), 0);
    std::vector<std::vector<Point_index> > clusters;
    for (std::size_t i = 0; i != m_conflicts.size(); ++i) {
      const std::size_t root = sets.find(static_cast<Point_index>(i)).root;
      if (root == i) {
        cluster_of[i] = clusters.size();
        clusters.emplace_back();
      }
      clusters[cluster_of[root]].push_back(m_conflicts[i]);
    }
    return clusters;
  }

  // The points around a conflict that its completion must see: its neighbors, its link, and the
  // links of its link, so that their stars are complete; some of them repeatedly.
  void surroundings(Point_index p, std::vector<Point_index>& result)
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
  void add_link(Point_index p, std::vector<Point_index>& result) const
  {
    const Star_table& stars = m_builder.compatibility().stars();
    for (Star_table::Slot s = stars.begin(p); s != stars.end(p); ++s)
      if (stars.neighbor(s) != NO_POINT)
        result.push_back(stars.neighbor(s));
  }

  // Whether the surface has a boundary at the point: its star has a gap, and so have the stars of the
  // next points along the boundary. Single open stars are conflicts.
  bool is_on_boundary(Point_index p) const
  {
    const Star_compatibility& compatibility = m_builder.compatibility();
    if (!compatibility.is_point_on_boundary(p))
      return false;
    for (const auto& corner : m_builder.corners(p))
      for (Point_index q : { corner.a, corner.b })
        if (m_builder.number_of_triangles(p, q) == 1 && !reaches(q, p, BOUNDARY_LENGTH))
          return false;
    return true;
  }

  // Whether the boundary goes on from p, coming from `from`, over `length` open stars.
  bool reaches(Point_index p, Point_index from, std::size_t length) const
  {
    for (; length != 0; --length) {
      if (!m_builder.is_open(p) || !m_builder.compatibility().is_point_on_boundary(p))
        return false;
      Point_index next = NO_POINT;
      for (const auto& corner : m_builder.corners(p))
        for (Point_index q : { corner.a, corner.b })
          if (q != from && m_builder.number_of_triangles(p, q) == 1)
            next = q;
      if (next == NO_POINT)
        return false;
      from = p;
      p = next;
    }
    return true;
  }

  // Open stars that must follow one another in both directions to make a boundary.
  static constexpr std::size_t BOUNDARY_LENGTH = 2;

  static constexpr std::size_t CONFLICTS_PER_POLL = 64;

  // Two rings of a regular sample hold 18 points.
  static constexpr std::size_t NEIGHBORS = 16;

  const Builder& m_builder;
  Nearest_neighbors m_neighbors;
  std::vector<Point_index> m_conflicts; // increasing
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_CLUSTERS_H

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

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Conflict_surroundings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
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
    : m_builder(builder), m_surroundings(points, octree, maximum_radius, builder.compatibility().stars())
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
      m_surroundings(m_conflicts[i], around);
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

private:
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

  const Builder& m_builder;
  Conflict_surroundings m_surroundings;
  std::vector<Point_index> m_conflicts; // increasing
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_CLUSTERS_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_COMPONENT_REUNION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_COMPONENT_REUNION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Component_contacts.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Near_components.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Nearest_search.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Surface_sides.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Winding_number_fit.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelled_surface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/vertex_normals.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Parts that caps have cut off from each other where points are sparse or noisy become one again: the normals of the
// smaller ones, and around them, are fitted to the winding number that all points make, and the Delaunay cells there are
// labelled by the linear implicit function of these normals. That stays if there are fewer components then, and no point is
// left out.
template <typename ConcurrencyTag, typename Builder>
class Component_reunion
{
public:
  using Triangle = typename Builder::Triangle;

  Component_reunion(const std::vector<Local_point>& points, const Point_octree_3& octree, Builder& builder,
                    Kept_triangulation& triangulation)
    : m_points(points), m_octree(octree), m_builder(builder), m_triangulation(triangulation)
  { }

  // For a closed surface. Returns whether it has changed; ends early if cancelled.
  template <typename Progress>
  bool operator()(Progress& progress)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    bool is_changed = false;
    try {
      Near_components<Builder> near(m_points, m_octree, m_builder, progress, cancellation_point);
      m_has_found = !near.groups().empty();
      for (const std::vector<Point_index>& group : near.groups())
        is_changed = unite(group, near, progress, cancellation_point) || is_changed;
    } catch (const Cancelled&) {
    }
    return is_changed;
  }

  // Whether the last call has found components that are near to each other.
  bool has_found_components() const { return m_has_found; }

private:
  using Triangles = typename Near_components<Builder>::Triangles;

  // Around every point of a smaller component: two rings.
  static constexpr std::size_t NEIGHBORS_IN_DOUBT = 24;

  // Pairs of a point and one in doubt: a tenth of a second.
  static constexpr std::size_t MAXIMUM_PAIRS = std::size_t(1) << 19;

  template <typename Progress, typename CancellationPoint>
  bool unite(const std::vector<Point_index>& group, Near_components<Builder>& near, Progress& progress,
             CancellationPoint& cancellation_point)
  {
    const std::vector<Point_index> doubts = find_doubts(group, near.contacts(), cancellation_point);
    if (doubts.empty() || doubts.size() > MAXIMUM_PAIRS / group.size())
      return false;
    const std::shared_ptr<const Cell_complex> kept = m_triangulation(group, cancellation_point);
    const Cell_complex& cells = *kept;
    if (cells.size() == 0)
      return false;
    const Triangles old = near.triangles(group);
    const std::vector<Local_vector> normals = fitted_normals(group, old, doubts, cancellation_point);
    std::vector<unsigned char> is_in_doubt(m_points.size(), 0);
    for (Point_index p : doubts)
      is_in_doubt[p] = 1;
    const Surface_sides sides(cells, old, is_in_doubt, cancellation_point);
    Oriented_labelling labelling =
      label_by_sides<ConcurrencyTag>(cells, sides, m_points, normals, progress, cancellation_point);
    make_nearly_manifold(cells, labelling, cancellation_point);
    Triangles united = facets_between_labels(cells, labelling, cancellation_point);
    return near.exchange(group, old, std::move(united), cancellation_point);
  }

  // The points of all components but the largest one, and the points near to them, increasing.
  template <typename CancellationPoint>
  std::vector<Point_index> find_doubts(const std::vector<Point_index>& group, const Component_contacts& contacts,
                                       CancellationPoint& cancellation_point) const
  {
    const Point_index largest = contacts.largest_component(group);
    Nearest_search search(m_points, m_octree);
    std::vector<Point_index> result;
    for (Point_index p : group)
      if (contacts.component(p) != largest) {
        cancellation_point();
        result.push_back(p);
        for (const auto& neighbor : search(p, NEIGHBORS_IN_DOUBT, std::numeric_limits<double>::infinity()))
          if (std::binary_search(group.begin(), group.end(), neighbor.second))
            result.push_back(neighbor.second);
      }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Unit normals, or zero.
  template <typename CancellationPoint>
  std::vector<Local_vector> fitted_normals(const std::vector<Point_index>& group, const Triangles& triangles,
                                           const std::vector<Point_index>& doubts,
                                           CancellationPoint& cancellation_point) const
  {
    std::vector<Local_vector> areas = doubled_area_vectors(m_points, triangles);
    for (Local_vector& area : areas)
      area = area / 6.; // a third of half
    Winding_number_fit fit(m_points, m_octree, group);
    fit(doubts, areas, cancellation_point);
    return unit_vectors(std::move(areas));
  }

  const std::vector<Local_point>& m_points;
  const Point_octree_3& m_octree;
  Builder& m_builder;
  Kept_triangulation& m_triangulation;
  bool m_has_found = false;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_COMPONENT_REUNION_H

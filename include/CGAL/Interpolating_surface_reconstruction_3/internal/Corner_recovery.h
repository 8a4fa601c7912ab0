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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CORNER_RECOVERY_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CORNER_RECOVERY_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Component_contacts.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Label_search.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Lost_corners.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelled_surface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/orientation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_exchange.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_reproduction.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_rings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/vertex_normals.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Opens what is closed over lost corners, see Corner_test: where bores, pockets and gaps have points on their rims only,
// caps bend the surface less than walls do. The surface becomes one between labels of the Delaunay cells of its points;
// the labels around lost corners change as long as that lowers the bending energy, in which a lost corner now counts as
// much as a point at which the surface is no manifold.
template <typename ConcurrencyTag, typename Builder>
class Corner_recovery
{
public:
  using Triangle = typename Builder::Triangle;

  Corner_recovery(const std::vector<Local_point>& points, const Point_octree_3& octree, Builder& builder,
                  Kept_triangulation& triangulation)
    : m_points(points), m_octree(octree), m_builder(builder), m_triangulation(triangulation)
  { }

  // For a closed surface. Returns whether it has changed; ends early if cancelled.
  template <typename Progress>
  bool operator()(Progress& progress)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    try {
      const std::vector<Point_index> used = used_points();
      if (used.size() > Kept_triangulation::MAXIMUM_POINTS)
        return false;
      m_triangles = oriented_triangles(m_points, {}, m_builder, [&] { return progress.advance(0.); });
      Lost_corners lost(m_points, m_triangles);
      lost.find_alone(m_octree, cancellation_point);
      const std::vector<Point_index> corners = lost.corners();
      if (corners.empty() || corners.size() < used.size() / PART_OF_LOST)
        return false;
      return recover(used, corners, lost, progress, cancellation_point);
    } catch (const Cancelled&) {
      return false;
    }
  }

private:
  using Triangles = std::vector<Triangle>;
  using Cell_index = Cell_complex::Cell_index;

  // The fewest lost corners, in parts of all points: a few are not worth a triangulation.
  static constexpr std::size_t PART_OF_LOST = 64;

  // Rings around lost corners whose cells may change.
  static constexpr int FREE_RINGS = 2;

  // Changes of labels that may be tried, in all and after kicks: more than models with bores take.
  static constexpr std::size_t SEARCH_EFFORT = 125000, SEARCH_EFFORT_PER_POINT = 8, EFFORT_OF_KICKS_PER_POINT = 16;

  // Those with triangles, increasing.
  std::vector<Point_index> used_points() const
  {
    std::vector<unsigned char> is_used(m_points.size(), 0);
    m_builder.for_each_triangle([&](const Triangle& t, auto) {
      for (Point_index p : t)
        is_used[p] = 1;
    });
    std::vector<Point_index> result;
    for (Point_index p = 0; p != m_points.size(); ++p)
      if (is_used[p] != 0)
        result.push_back(p);
    return result;
  }

  // Keeps the new surface if it has fewer lost corners, no more components, and all points.
  template <typename Progress, typename CancellationPoint>
  bool recover(const std::vector<Point_index>& used, const std::vector<Point_index>& corners, const Lost_corners& lost,
               Progress& progress, CancellationPoint& cancellation_point)
  {
    const std::shared_ptr<const Cell_complex> kept = m_triangulation(used, cancellation_point);
    const Cell_complex& cells = *kept;
    if (cells.size() == 0)
      return false;
    const std::vector<Local_vector> normals = vertex_normals(m_points, m_triangles);
    std::optional<Oriented_labelling> labelling = reproduce_surface<ConcurrencyTag>(
      cells, m_triangles, m_points, normals, used.size(), progress, cancellation_point);
    if (!labelling)
      return false;
    search(cells, *labelling, corners, lost, cancellation_point);
    repair_labels(cells, *labelling, cancellation_point);
    Triangles recovered = facets_between_labels(cells, *labelling, cancellation_point);
    const Component_contacts before(m_points, m_triangles), after(m_points, recovered);
    const Lost_corners still_lost(m_points, recovered);
    std::size_t left = 0;
    for (Point_index p : used) {
      if (!after.is_on_surface(p))
        return false;
      left += still_lost.is_lost(p) && !lost.is_by_right(p) ? 1u : 0u;
    }
    return left < corners.size() && after.size() <= before.size() &&
           !exchange_triangles(m_builder, used, std::move(recovered), cancellation_point).empty();
  }

  template <typename CancellationPoint>
  void search(const Cell_complex& cells, Oriented_labelling& labelling, const std::vector<Point_index>& corners,
              const Lost_corners& lost, CancellationPoint& cancellation_point) const
  {
    const std::vector<unsigned char> is_free = mark_rings(m_builder, corners, FREE_RINGS, cancellation_point);
    const auto has_vertex = [&](Cell_index c, const auto& is_wanted) {
      const auto& vertices = cells[c].vertices;
      return std::any_of(vertices.begin(), vertices.end(),
                         [&](Point_index p) { return p != NO_POINT && is_wanted(p); });
    };
    Label_search<Oriented_labelling> search(
      cells, m_points, labelling,
      [&](Cell_index c) { return has_vertex(c, [&](Point_index p) { return is_free[p] != 0; }); },
      [&](Cell_index c) { return has_vertex(c, [&](Point_index p) { return lost.is_corner(p); }); },
      [](auto...) { return false; }, [](auto) { return true; }, cancellation_point);
    search.count_lost_corners([&](Point_index p) { return !lost.is_by_right(p); });
    const std::size_t size = cells.points().size();
    Search_effort effort{ SEARCH_EFFORT + SEARCH_EFFORT_PER_POINT * size, EFFORT_OF_KICKS_PER_POINT * size };
    search(effort, cancellation_point);
  }

  const std::vector<Local_point>& m_points;
  const Point_octree_3& m_octree;
  Builder& m_builder;
  Kept_triangulation& m_triangulation;
  Triangles m_triangles; // of the surface as it was, oriented
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CORNER_RECOVERY_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_RELABELLING_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_RELABELLING_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Component_contacts.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Normal_consistency.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Surface_sides.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelled_surface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/orientation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_exchange.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/vertex_normals.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// A second opinion on conflicts: the surface that bends least may lead through a part, or from one part to another, where
// points are sparse. The directions of the points in conflict are found anew, from those of the agreed ones alone, and the
// Delaunay cells there are labelled by the linear implicit function of these normals (thesis 5.2). Of the two surfaces, once
// both are finished, the one that more stars vote for stays (thesis 4.2: compatibility): a star that is not agreed on is
// seldom all wrong.
template <typename ConcurrencyTag, typename Builder>
class Conflict_relabelling
{
public:
  using Triangle = typename Builder::Triangle;

  Conflict_relabelling(const std::vector<Local_point>& points, Builder& builder, Kept_triangulation& triangulation)
    : m_points(points), m_builder(builder), m_triangulation(triangulation), m_find_normals(points)
  { }

  // For a closed surface; does nothing for others. Returns whether another surface is there now; ends early if cancelled.
  template <typename Progress>
  bool operator()(Progress& progress)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    try {
      if (!find_conflicts(cancellation_point))
        return false;
      const std::shared_ptr<const Cell_complex> cells = m_triangulation(m_group, cancellation_point);
      if (cells->size() == 0)
        return false;
      m_old = oriented_triangles(m_points, {}, m_builder, [&] { return progress.advance(0.); });
      Triangles relabelled = relabel(*cells, progress, cancellation_point);
      return has_more_votes(relabelled) && exchange(std::move(relabelled), cancellation_point);
    } catch (const Cancelled&) {
      return false;
    }
  }

  // After that has returned true, and what was to be done to the new surface is done: takes it back unless it is better.
  // Returns whether it stays.
  bool keep_if_better()
  {
    const Triangles current = triangles();
    if (is_better(current))
      return true;
    for (const Triangle& t : current)
      m_builder.remove(m_builder.find_triangle(t[0], t[1], t[2]));
    for (const typename Builder::Removed_triangle& t : m_removed)
      m_builder.restore(t);
    return false;
  }

private:
  using Triangles = std::vector<Triangle>;

  // Of the points: with fewer conflicts, to triangulate all takes longer than everything else, and hardly anything changes.
  static constexpr std::size_t PART_IN_CONFLICT = 8;

  // What is won must be more than other diagonals win.
  static constexpr std::size_t CONFLICTS_PER_VOTE = 10;

  // The points of the surface, and those of them in conflict. Returns false if it is not closed, if these are few, or if
  // there are more points than a kept triangulation may have.
  template <typename CancellationPoint>
  bool find_conflicts(CancellationPoint& cancellation_point)
  {
    m_group.clear();
    m_is_in_conflict.assign(m_points.size(), 0);
    m_conflicts = 0;
    for (Point_index p = 0; p != m_points.size(); ++p) {
      cancellation_point();
      const bool is_open = m_builder.is_open(p);
      if (is_open && m_builder.corners(p).empty())
        continue;
      if (is_open && !m_builder.is_fan_closed(p))
        return false;
      m_group.push_back(p);
      m_is_in_conflict[p] = m_builder.compatibility().is_point_agreed(p) ? 0 : 1;
      m_conflicts += m_is_in_conflict[p];
    }
    return m_conflicts != 0 && m_conflicts >= m_group.size() / PART_IN_CONFLICT &&
           m_group.size() <= Kept_triangulation::MAXIMUM_POINTS;
  }

  template <typename Progress, typename CancellationPoint>
  Triangles relabel(const Cell_complex& cells, Progress& progress, CancellationPoint& cancellation_point)
  {
    const std::vector<Local_vector> normals = normals_from_agreed(cells, cancellation_point);
    const Surface_sides sides(cells, m_old, m_is_in_conflict, cancellation_point);
    Oriented_labelling labelling =
      label_by_sides<ConcurrencyTag>(cells, sides, m_points, normals, progress, cancellation_point);
    make_nearly_manifold(cells, labelling, cancellation_point);
    return facets_between_labels(cells, labelling, cancellation_point);
  }

  // Unit normals, or zero.
  template <typename CancellationPoint>
  std::vector<Local_vector> normals_from_agreed(const Cell_complex& cells, CancellationPoint& cancellation_point)
  {
    std::vector<Local_vector> result = doubled_area_vectors(m_points, m_old), areas;
    std::vector<unsigned char> is_unknown;
    for (Point_index p : m_group) {
      areas.push_back(result[p]);
      is_unknown.push_back(m_is_in_conflict[p]);
    }
    m_find_normals.set_cells(cells, cancellation_point);
    m_find_normals.find_unknown(is_unknown, areas, cancellation_point);
    for (std::size_t k = 0; k != m_group.size(); ++k)
      result[m_group[k]] = areas[k];
    return unit_vectors(std::move(result));
  }

  // All triangles for others. Returns whether it does, not if one of them is refused.
  template <typename CancellationPoint>
  bool exchange(Triangles relabelled, CancellationPoint& cancellation_point)
  {
    auto removed = exchange_triangles(m_builder, triangles(), std::move(relabelled), 0, cancellation_point);
    if (removed)
      m_removed = std::move(*removed);
    return removed.has_value();
  }

  // As they are stored.
  Triangles triangles() const
  {
    Triangles result;
    m_builder.for_each_triangle([&](const Triangle& t, auto) { result.push_back(t); });
    return result;
  }

  // Clearly more of all stars than the surface as it was.
  bool has_more_votes(const Triangles& current) const
  {
    return votes(current) > votes(m_old) + m_conflicts / CONFLICTS_PER_VOTE;
  }

  // Whether it has another topology, all points and no more components, and clearly more stars vote for it. Where the
  // topology is the same, the surface that bends less is better.
  bool is_better(const Triangles& current) const
  {
    if (!has_more_votes(current))
      return false;
    const Component_contacts after(m_points, current);
    const std::size_t components = Component_contacts(m_points, m_old).size();
    // Handles are triangles more, as the points are the same.
    return (current.size() != m_old.size() ? after.size() <= components : after.size() < components) &&
           std::all_of(m_group.begin(), m_group.end(), [&](Point_index p) { return after.is_on_surface(p); });
  }

  std::size_t votes(const Triangles& triangles) const
  {
    std::size_t result = 0;
    for (const Triangle& t : triangles)
      result += m_builder.compatibility().stars().votes(t[0], t[1], t[2]);
    return result;
  }

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  Kept_triangulation& m_triangulation;
  Normal_consistency m_find_normals;
  std::vector<Point_index> m_group;                          // the points of the surface, increasing
  std::vector<unsigned char> m_is_in_conflict;               // of each point
  std::size_t m_conflicts = 0;                               // their number
  Triangles m_old;                                           // the surface as it was, oriented
  std::vector<typename Builder::Removed_triangle> m_removed; // the same as it was stored
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_RELABELLING_H

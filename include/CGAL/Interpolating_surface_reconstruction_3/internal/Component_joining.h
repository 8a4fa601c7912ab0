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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_COMPONENT_JOINING_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_COMPONENT_JOINING_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Component_contacts.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Label_search.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Near_components.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelled_surface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_reproduction.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_rings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/vertex_normals.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Joins components that are nearer to each other than their own points: where points are sparse, the ends of a thin part
// are closed by caps without points of their own, and what remains of it is a component. The Delaunay cells between two
// components change their labels together, which makes a bridge; then the surface around is bent as little as possible.
// A bridge stays if it bends the surface little more than the caps do that it takes the place of.
template <typename ConcurrencyTag, typename Builder>
class Component_joining
{
public:
  using Triangle = typename Builder::Triangle;

  Component_joining(const std::vector<Local_point>& points, const Point_octree_3& octree, Builder& builder,
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
      if (near.groups().empty())
        return false;
      m_is_free = mark_rings(m_builder, near.contacts().near(), FREE_RINGS, cancellation_point);
      for (const std::vector<Point_index>& group : near.groups())
        is_changed = join(group, near, progress, cancellation_point) || is_changed;
    } catch (const Cancelled&) {
    }
    return is_changed;
  }

private:
  using Triangles = typename Near_components<Builder>::Triangles;
  using Cell_index = Cell_complex::Cell_index;

  // The most points beside triangles that are no facets, in parts of all: the labels would give another surface.
  static constexpr std::size_t PART_IN_DOUBT = 32;

  // Rings around points near another component whose cells may change.
  static constexpr int FREE_RINGS = 2;

  // In defects, which are what a bridge may cost: a sampled surface has few components.
  static constexpr double MAXIMUM_COST = 2.;

  // Changes of labels that may be tried: enough for a few bridges, and some for every point of many components.
  static constexpr std::size_t SEARCH_EFFORT = 50000, SEARCH_EFFORT_PER_POINT = 4;

  // Bridges are found anew after each.
  static constexpr std::size_t MAXIMUM_ROUNDS = 4;

  // Two components, in order.
  using Ends = std::array<Point_index, 2>;

  static constexpr Ends NO_ENDS{ { NO_POINT, NO_POINT } };

  struct Bridge
  {
    Ends ends;
    std::vector<Cell_index> cells;
    double cost; // in defects; infinite if it has not been tried
  };

  // Joins components of all these points, if no point is left out. Returns whether there are fewer then.
  template <typename Progress, typename CancellationPoint>
  bool join(const std::vector<Point_index>& group, Near_components<Builder>& near, Progress& progress,
            CancellationPoint& cancellation_point)
  {
    const std::shared_ptr<const Cell_complex> kept = m_triangulation(group, cancellation_point);
    const Cell_complex& cells = *kept;
    if (cells.size() == 0)
      return false;
    const Triangles old = near.triangles(group);
    const std::vector<Local_vector> normals = vertex_normals(m_points, old);
    std::optional<Oriented_labelling> labelling = reproduce_surface<ConcurrencyTag>(
      cells, old, m_points, normals, group.size() / PART_IN_DOUBT, progress, cancellation_point);
    if (!labelling)
      return false;
    build_bridges(cells, *labelling, cancellation_point);
    repair_labels(cells, *labelling, cancellation_point);
    Triangles joined = facets_between_labels(cells, *labelling, cancellation_point);
    return near.exchange(group, old, std::move(joined), cancellation_point);
  }

  // The best ones first, and no two between the same components, which would make a handle.
  template <typename CancellationPoint>
  void build_bridges(const Cell_complex& cells, Oriented_labelling& labelling, CancellationPoint& cancellation_point)
  {
    const auto is_free = [&](Cell_index c) {
      const auto& vertices = cells[c].vertices;
      return std::any_of(vertices.begin(), vertices.end(), [&](Point_index p) { return m_is_free[p] != 0; });
    };
    Label_search<Oriented_labelling> search(
      cells, m_points, labelling, is_free, is_free, [](auto...) { return false; }, [](auto) { return true; },
      cancellation_point);
    std::size_t effort = SEARCH_EFFORT + SEARCH_EFFORT_PER_POINT * cells.points().size();
    for (std::size_t round = 0; round != MAXIMUM_ROUNDS; ++round) {
      std::vector<Bridge> bridges = find_bridges(cells, labelling, cancellation_point);
      for (Bridge& bridge : bridges)
        if (effort != 0)
          bridge.cost = search.cost_together(bridge.cells, effort, cancellation_point);
      std::stable_sort(bridges.begin(), bridges.end(),
                       [](const Bridge& a, const Bridge& b) { return a.cost < b.cost; });
      Parity_union_find joined(m_points.size());
      bool is_changed = false;
      for (const Bridge& bridge : bridges) {
        const Point_index first = joined.find(bridge.ends[0]).root, second = joined.find(bridge.ends[1]).root;
        if (!(bridge.cost < MAXIMUM_COST))
          break;
        // Others may have changed what it costs.
        if (first == second || effort == 0 ||
            !search.change_together(bridge.cells, MAXIMUM_COST, effort, cancellation_point))
          continue;
        joined.unite(first, second, false);
        is_changed = true;
      }
      if (!is_changed)
        return;
    }
  }

  // The cells between two components whose points are near to each other, those together that share facets.
  template <typename CancellationPoint>
  std::vector<Bridge> find_bridges(const Cell_complex& cells, const Oriented_labelling& labelling,
                                   CancellationPoint& cancellation_point) const
  {
    const Component_contacts contacts(m_points, facets_between_labels(cells, labelling, cancellation_point));
    std::vector<Ends> ends(cells.size(), NO_ENDS);
    for (Cell_index c = 0; c != cells.size(); ++c)
      ends[c] = ends_of(cells[c], contacts);
    std::vector<Bridge> result;
    for (Cell_index c = 0; c != cells.size(); ++c) {
      cancellation_point();
      if (ends[c] == NO_ENDS)
        continue;
      result.push_back(Bridge{ ends[c], { c }, std::numeric_limits<double>::infinity() });
      ends[c] = NO_ENDS;
      Bridge& bridge = result.back();
      for (std::size_t k = 0; k != bridge.cells.size(); ++k)
        for (Cell_index n : cells[bridge.cells[k]].neighbors)
          if (ends[n] == bridge.ends && labelling.label(n) == labelling.label(c)) {
            ends[n] = NO_ENDS;
            bridge.cells.push_back(n);
          }
    }
    return result;
  }

  // The two components that the cell is between, if it is; those between more are left to what bends the surface least.
  static Ends ends_of(const Cell_complex::Cell& cell, const Component_contacts& contacts)
  {
    if (Cell_complex::is_infinite(cell))
      return NO_ENDS;
    std::array<Point_index, 4> components;
    for (std::size_t i = 0; i != 4; ++i) {
      components[i] = contacts.component(cell.vertices[i]);
      for (std::size_t j = 0; j != i; ++j)
        if (components[j] != components[i] && !contacts.are_near(cell.vertices[j], cell.vertices[i]))
          return NO_ENDS;
    }
    std::sort(components.begin(), components.end());
    const Ends ends{ { components.front(), components.back() } };
    const bool are_two = ends[0] != ends[1] && std::all_of(components.begin(), components.end(),
                                                           [&](Point_index c) { return c == ends[0] || c == ends[1]; });
    return are_two ? ends : NO_ENDS;
  }

  const std::vector<Local_point>& m_points;
  const Point_octree_3& m_octree;
  Builder& m_builder;
  Kept_triangulation& m_triangulation;
  std::vector<unsigned char> m_is_free; // of each point
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_COMPONENT_JOINING_H

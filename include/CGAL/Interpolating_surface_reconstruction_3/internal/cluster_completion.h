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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CLUSTER_COMPLETION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CLUSTER_COMPLETION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Conflict_surroundings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Facet_knowledge.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Label_search.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Local_surface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Site_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/facet_evidence.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelling_repair.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/oriented_energy.h>

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

// The surface at the conflicts of one cluster, and what has to give way to it.
struct Completed_cluster
{
  using Triangle = std::array<Point_index, 3>;

  std::vector<Triangle> withdrawn;    // in order, with increasing vertices
  std::vector<Point_index> conflicts; // those of the cluster and all that have joined them
  std::vector<Triangle> surface;      // in order, with increasing vertices
  std::size_t effort = 0;             // that the searches have spent
};

// Completes the surface at a cluster of conflicts (thesis 6.3, "Compatibility"): the conflicting points
// and the surface around them are triangulated by Delaunay tetrahedra, these are labelled inside
// and outside, and the facets between the labels are the surface. The labels follow the sides of the
// charts around, the votes of the stars and the shapes of the cells; then, as all that makes an
// oriented surface, the linear implicit function of its normals (thesis 5.2), again and again; and at last
// the surface is bent as little as possible. The builder stays as it is; one object serves one thread.
template <typename Builder>
class Cluster_completion
{
public:
  // `is_conflict` tells of each point whether it is in conflict.
  Cluster_completion(const std::vector<Local_point>& points, const Point_octree_3& octree, double maximum_radius,
                     const Builder& builder, const std::vector<unsigned char>& is_conflict)
    : m_points(points), m_stars(builder.compatibility().stars()),
      m_surroundings(points, octree, maximum_radius, m_stars), m_oriented_energy(points), m_is_site(points.size(), 0),
      m_surface(builder, is_conflict), m_knowledge(m_surface, points.size())
  { }

  Cluster_completion(const Cluster_completion&) = delete;
  Cluster_completion& operator=(const Cluster_completion&) = delete;

  // The searches spend at most `maximum_effort`, none of it on kicks. `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  Completed_cluster operator()(const std::vector<Point_index>& cluster, std::size_t maximum_effort,
                               Cancellation_point& cancellation_point)
  {
    m_surface.reset();
    for (Point_index p : m_sites)
      m_is_site[p] = 0;
    m_sites.clear();
    m_cluster.clear();
    for (Point_index p : cluster)
      add_to_cluster(p, cancellation_point);
    Completed_cluster result;
    Search_effort effort{ maximum_effort, 0 };
    m_triangulation = std::make_unique<Site_triangulation>(m_points);
    Site_triangulation& triangulation = *m_triangulation;
    triangulate_with_surface(triangulation, cancellation_point);
    Cell_complex cells(triangulation, m_sites, cancellation_point);
    // Once: stars that contradict the second surface would go on to spread.
    if (cells.size() != 0 && !find_surface_or_withdraw(cells, true, effort, result.surface, cancellation_point)) {
      if (cells.points().size() != m_sites.size()) {
        insert_sites_from(cells.points().size(), triangulation, cancellation_point);
        cells = Cell_complex();
        cells = Cell_complex(triangulation, m_sites, cancellation_point);
      }
      if (cells.size() != 0)
        find_surface_or_withdraw(cells, false, effort, result.surface, cancellation_point);
    }
    result.withdrawn = m_surface.withdrawn();
    result.conflicts = m_cluster;
    result.effort = maximum_effort - effort.all;
    return result;
  }

  // That of the sites of the cluster that was completed last; once.
  std::unique_ptr<Site_triangulation> release_triangulation() { return std::move(m_triangulation); }

private:
  using Triangle = Completed_cluster::Triangle;
  using Facet = std::array<Point_index, 3>;
  using Cell_index = Cell_complex::Cell_index;

  // Weight of a facet that is known to be on the surface, or negative, known not to be.
  static constexpr double CERTAIN = 20.;

  // Of a point; twice as much where the points are of very unlike density.
  static constexpr std::size_t MICROSECONDS_PER_SURROUNDINGS = 32;

  // The normals of the third surface hardly differ from those of the second one.
  static constexpr std::size_t ORIENTED_ROUNDS = 2;

  // Finds what the surface of the labelling of the cells adds, or withdraws the stars that it contradicts and
  // returns false, if that is allowed.
  template <typename CancellationPoint>
  bool find_surface_or_withdraw(const Cell_complex& cells, bool may_withdraw, Search_effort& effort,
                                std::vector<Triangle>& surface, CancellationPoint& cancellation_point)
  {
    m_knowledge.gather(cells, cancellation_point);
    const Cell_labelling labelling = label(cells, may_withdraw, effort, cancellation_point);
    if (may_withdraw && withdraw_contradicted_stars(cells, labelling, cancellation_point))
      return false;
    for_each_missing_triangle(cells, labelling, cancellation_point, [&](Triangle t) {
      std::sort(t.begin(), t.end());
      surface.push_back(t);
    });
    std::sort(surface.begin(), surface.end());
    return true;
  }

  // Cells beside agreed triangles may change as long as these may be withdrawn.
  template <typename CancellationPoint>
  Cell_labelling label(const Cell_complex& cells, bool may_withdraw, Search_effort& effort,
                       CancellationPoint& cancellation_point)
  {
    const auto known = [&](Cell_index c, std::size_t i) { return m_knowledge.certainty(c, i); };
    Cell_labelling labelling = label_by_evidence(cells, known, cancellation_point);
    const auto is_in_scope = [&](Point_index p) { return m_knowledge.is_in_scope(p); };
    Labelling_repair<Cell_labelling> repair(cells, labelling, is_in_scope, CERTAIN / 2, false, cancellation_point);
    repair(cancellation_point);
    m_oriented_energy.set_cells(cells, known, cancellation_point);
    for (std::size_t round = 0; round != ORIENTED_ROUNDS; ++round) {
      const double certain = m_oriented_energy(labelling, known, cancellation_point);
      const std::vector<Cell_index> changed = labelling.relax(cancellation_point);
      repair.again(changed, certain / 2, cancellation_point);
    }
    Label_search<Cell_labelling> search(
      cells, m_points, labelling,
      [&](Cell_index c) {
        const auto& vertices = cells[c].vertices;
        return may_withdraw ? std::all_of(vertices.begin(), vertices.end(), is_in_scope) : m_knowledge.is_undecided(c);
      },
      [&](Cell_index c) {
        const auto& vertices = cells[c].vertices;
        return std::any_of(vertices.begin(), vertices.end(),
                           [&](Point_index p) { return p != NO_POINT && m_surface.is_conflict(p); });
      },
      [&](Cell_index c, std::size_t i) { return m_knowledge.is_on_surface(c, i); }, is_in_scope, cancellation_point);
    search(effort, cancellation_point);
    return labelling;
  }

  template <typename Known, typename CancellationPoint>
  Cell_labelling label_by_evidence(const Cell_complex& cells, const Known& known, CancellationPoint& cancellation_point)
  {
    Cell_labelling labelling(cells);
    {
      const Facet_evidence evidence(cells, m_points, m_stars, cancellation_point);
      labelling.set_weights(
        [&](Cell_index c, std::size_t i) {
          const std::optional<double> on_surface = known(c, i);
          return on_surface ? CERTAIN * *on_surface : evidence(c, i);
        },
        cancellation_point);
    }
    labelling.label_by_weights([&](Cell_index c, std::size_t i) { return m_knowledge.chart(cells, c, i); },
                               cancellation_point);
    return labelling;
  }

  // Adds a conflict and what it must see.
  template <typename CancellationPoint>
  void add_to_cluster(Point_index p, CancellationPoint& cancellation_point)
  {
    cancellation_point(MICROSECONDS_PER_SURROUNDINGS);
    m_cluster.push_back(p);
    m_surroundings(p, m_around);
    for (Point_index q : m_around)
      if (!m_is_site[q]) {
        m_is_site[q] = 1;
        m_sites.push_back(q);
      }
  }

  // Without the agreed triangles at conflicts that are no facets.
  template <typename CancellationPoint>
  void triangulate_with_surface(Site_triangulation& triangulation, CancellationPoint& cancellation_point)
  {
    insert_sites_from(0, triangulation, cancellation_point);
    const std::size_t old_sites = m_sites.size();
    if (triangulation.is_usable())
      // Once: the few triangles around the points that join then hardly matter.
      withdraw_triangles_without_facet(triangulation, cancellation_point);
    insert_sites_from(old_sites, triangulation, cancellation_point);
  }

  template <typename CancellationPoint>
  void insert_sites_from(std::size_t first, Site_triangulation& triangulation, CancellationPoint& cancellation_point)
  {
    std::sort(m_sites.begin() + std::ptrdiff_t(first), m_sites.end());
    triangulation.insert(std::vector<Point_index>(m_sites.begin() + std::ptrdiff_t(first), m_sites.end()),
                         cancellation_point);
  }

  // The surface of the labelling consists of facets. An agreed triangle at a conflict that is no
  // facet would cross it; it is withdrawn and its points join the conflict.
  template <typename CancellationPoint>
  void withdraw_triangles_without_facet(const Site_triangulation& triangulation, CancellationPoint& cancellation_point)
  {
    std::vector<Facet> facets;
    triangulation.for_each_facet([&](Facet f) {
      cancellation_point();
      if (Cell_complex::is_infinite(f) || !is_at_conflict(f) || !m_surface.has_triangle(f))
        return;
      std::sort(f.begin(), f.end());
      facets.push_back(f);
    });
    std::sort(facets.begin(), facets.end());
    std::vector<Facet> others;
    for (Point_index p : m_cluster)
      m_surface.for_each_triangle_at(p, [&](Facet t) {
        std::sort(t.begin(), t.end());
        if (!std::binary_search(facets.begin(), facets.end(), t))
          others.push_back(t);
      });
    withdraw(std::move(others), cancellation_point);
  }

  // An agreed star that the surface of the labelling meets beside its triangles is wrong or leaves no room
  // for a right one: it is withdrawn and its points join the conflict. Returns whether there was one.
  template <typename CancellationPoint>
  bool withdraw_contradicted_stars(const Cell_complex& cells, const Cell_labelling& labelling,
                                   CancellationPoint& cancellation_point)
  {
    std::vector<Point_index> contradicted;
    for_each_missing_triangle(cells, labelling, cancellation_point, [&](const Triangle& t) {
      for (Point_index p : t)
        if (!m_surface.is_conflict(p) && m_surface.is_complete(p))
          contradicted.push_back(p);
    });
    std::sort(contradicted.begin(), contradicted.end());
    contradicted.erase(std::unique(contradicted.begin(), contradicted.end()), contradicted.end());
    std::vector<Facet> triangles;
    for (Point_index p : contradicted)
      m_surface.for_each_triangle_at(p, [&](Facet t) {
        std::sort(t.begin(), t.end());
        triangles.push_back(t);
      });
    withdraw(std::move(triangles), cancellation_point);
    return !contradicted.empty();
  }

  template <typename CancellationPoint>
  void withdraw(std::vector<Facet> triangles, CancellationPoint& cancellation_point)
  {
    m_surface.withdraw(std::move(triangles), [&](Point_index p) { add_to_cluster(p, cancellation_point); });
  }

  bool is_at_conflict(const Facet& f) const
  {
    return m_surface.is_conflict(f[0]) || m_surface.is_conflict(f[1]) || m_surface.is_conflict(f[2]);
  }

  // Calls visit(triangle) for the facets between the labels at conflicts that the surface lacks.
  template <typename CancellationPoint, typename Visit>
  void for_each_missing_triangle(const Cell_complex& cells, const Cell_labelling& labelling,
                                 CancellationPoint& cancellation_point, const Visit& visit) const
  {
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i) {
        cancellation_point();
        const Facet f = Cell_complex::facet(cells[c], i);
        if (cells[c].neighbors[i] >= c && !Cell_complex::is_infinite(f) && labelling.is_surface(c, i) &&
            !m_knowledge.is_on_surface(c, i) && is_at_conflict(f))
          visit(f);
      }
  }

  const std::vector<Local_point>& m_points;
  const Star_table& m_stars;
  Conflict_surroundings m_surroundings;
  Oriented_energy m_oriented_energy;
  std::vector<unsigned char> m_is_site; // of each point
  Local_surface<Builder> m_surface;
  Facet_knowledge<Builder> m_knowledge;
  std::unique_ptr<Site_triangulation> m_triangulation;
  std::vector<Point_index> m_cluster; // conflicts of the current cluster
  std::vector<Point_index> m_sites;   // of the current cluster
  std::vector<Point_index> m_around;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CLUSTER_COMPLETION_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_COMPLETION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_COMPLETION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Facet_knowledge.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Label_search.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Site_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/conflict_clusters.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/facet_evidence.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelling_repair.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/oriented_energy.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Completes the surface where charts conflict (thesis 6.3, "Compatibility"): the conflicting points
// and the surface around them are triangulated by Delaunay tetrahedra, these are labelled inside
// and outside, and the facets between the labels are the surface. The labels follow the sides of the
// charts around, the votes of the stars and the shapes of the cells; then, as all that makes an
// oriented surface, the linear implicit function of its normals (thesis 5.2), again and again; and at last
// the surface is bent as little as possible.
template <typename Builder>
class Conflict_completion
{
public:
  Conflict_completion(const std::vector<Local_point>& points, const Point_octree_3& octree, double maximum_radius,
                      Builder& builder)
    : m_points(points), m_builder(builder), m_clusters(points, octree, maximum_radius, builder),
      m_oriented_energy(points), m_knowledge(builder, m_is_conflict)
  { }

  // Ends early if cancelled.
  template <typename Progress, typename OnVerdict>
  void operator()(Progress& progress, OnVerdict on_verdict)
  {
    if (m_clusters.conflicts().empty())
      return;
    m_is_conflict.assign(m_points.size(), 0);
    m_is_site.assign(m_points.size(), 0);
    m_search_effort = SEARCH_EFFORT + SEARCH_EFFORT_PER_POINT * m_points.size();
    for (Point_index p : m_clusters.conflicts())
      m_is_conflict[p] = 1;
    std::size_t done = 0;
    // A single cluster may hold all points.
    Cancellation_point<Progress> cancellation_point(progress);
    for (const std::vector<Point_index>& cluster : m_clusters.find(progress)) {
      try {
        complete(cluster, cancellation_point, on_verdict);
      } catch (const Cancelled&) {
        return;
      }
      done += cluster.size();
      if (!progress.advance(double(done) / double(m_clusters.conflicts().size())))
        return;
    }
  }

private:
  using Triangle = typename Builder::Triangle;
  using Facet = std::array<Point_index, 3>;
  using Cell_index = Cell_complex::Cell_index;

  // Weight of a facet that is known to be on the surface, or negative, known not to be.
  static constexpr double CERTAIN = 20.;

  // Of a point; twice as much where the points are of very unlike density.
  static constexpr std::size_t MICROSECONDS_PER_SURROUNDINGS = 32;

  // The normals of the third surface hardly differ from those of the second one.
  static constexpr std::size_t ORIENTED_ROUNDS = 2;

  // Changes of labels that the searches may try in all: enough for a few thousand conflicts, and two for every
  // point where there are more.
  static constexpr std::size_t SEARCH_EFFORT = 500000, SEARCH_EFFORT_PER_POINT = 2;

  bool is_conflict(Point_index p) const { return m_is_conflict[p] != 0; }

  template <typename CancellationPoint, typename OnVerdict>
  void complete(const std::vector<Point_index>& cluster, CancellationPoint& cancellation_point, OnVerdict on_verdict)
  {
    m_cluster.clear();
    for (Point_index p : m_sites)
      m_is_site[p] = 0;
    m_sites.clear();
    for (Point_index p : cluster)
      add_to_cluster(p, cancellation_point);
    Cell_complex cells = triangulate_with_surface(cancellation_point);
    // Once: stars that contradict the second surface would go on to spread.
    if (cells.size() != 0 && !attach_or_withdraw(cells, true, cancellation_point, on_verdict)) {
      cells = Cell_complex();
      cells = triangulate(cancellation_point);
      if (cells.size() != 0)
        attach_or_withdraw(cells, false, cancellation_point, on_verdict);
    }
    for (Point_index p : m_cluster)
      m_is_conflict[p] = m_knowledge.is_complete(p) ? 0 : 1;
  }

  // Attaches the surface of the labelling of the cells, or withdraws the stars that it contradicts and
  // returns false, if that is allowed.
  template <typename CancellationPoint, typename OnVerdict>
  bool attach_or_withdraw(const Cell_complex& cells, bool may_withdraw, CancellationPoint& cancellation_point,
                          OnVerdict on_verdict)
  {
    m_knowledge.gather(cells, cancellation_point);
    const Cell_labelling labelling = label(cells, may_withdraw, cancellation_point);
    if (may_withdraw && withdraw_contradicted_stars(cells, labelling, cancellation_point))
      return false;
    attach(cells, labelling, cancellation_point, on_verdict);
    return true;
  }

  // Cells beside agreed triangles may change as long as these may be withdrawn.
  template <typename CancellationPoint>
  Cell_labelling label(const Cell_complex& cells, bool may_withdraw, CancellationPoint& cancellation_point)
  {
    const auto known = [&](Cell_index c, std::size_t i) { return m_knowledge.certainty(c, i); };
    Cell_labelling labelling = label_by_evidence(cells, known, cancellation_point);
    const auto is_in_scope = [&](Point_index p) { return m_knowledge.is_in_scope(p); };
    Labelling_repair<Cell_labelling> repair(cells, labelling, is_in_scope, CERTAIN / 2, false, cancellation_point);
    repair(cancellation_point);
    for (std::size_t round = 0; round != ORIENTED_ROUNDS; ++round) {
      const double certain = m_oriented_energy(cells, labelling, known, cancellation_point);
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
                           [&](Point_index p) { return p != NO_POINT && is_conflict(p); });
      },
      [&](Cell_index c, std::size_t i) { return m_knowledge.is_on_surface(c, i); }, is_in_scope, cancellation_point);
    search(m_search_effort, cancellation_point);
    return labelling;
  }

  template <typename Known, typename CancellationPoint>
  Cell_labelling label_by_evidence(const Cell_complex& cells, const Known& known, CancellationPoint& cancellation_point)
  {
    Cell_labelling labelling(cells);
    {
      const Facet_evidence evidence(cells, m_points, m_builder.compatibility().stars(), cancellation_point);
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
    m_clusters.surroundings(p, m_around);
    for (Point_index q : m_around)
      if (!m_is_site[q]) {
        m_is_site[q] = 1;
        m_sites.push_back(q);
      }
  }

  template <typename CancellationPoint>
  Cell_complex triangulate(CancellationPoint& cancellation_point)
  {
    return Cell_complex(m_points, m_sites, cancellation_point);
  }

  // Without the agreed triangles at conflicts that are no facets.
  template <typename CancellationPoint>
  Cell_complex triangulate_with_surface(CancellationPoint& cancellation_point)
  {
    Site_triangulation triangulation(m_points);
    std::sort(m_sites.begin(), m_sites.end());
    triangulation.insert(m_sites, cancellation_point);
    const std::size_t old_sites = m_sites.size();
    if (triangulation.is_usable())
      // Once: the few triangles around the points that join then hardly matter.
      withdraw_triangles_without_facet(triangulation, cancellation_point);
    std::vector<Point_index> new_sites(m_sites.begin() + std::ptrdiff_t(old_sites), m_sites.end());
    std::sort(new_sites.begin(), new_sites.end());
    triangulation.insert(new_sites, cancellation_point);
    return Cell_complex(triangulation, m_sites, cancellation_point);
  }

  // The surface of the labelling consists of facets. An agreed triangle at a conflict that is no
  // facet would cross it; it is withdrawn and its points join the conflict.
  template <typename CancellationPoint>
  void withdraw_triangles_without_facet(const Site_triangulation& triangulation, CancellationPoint& cancellation_point)
  {
    std::vector<Facet> facets;
    triangulation.for_each_facet([&](Facet f) {
      cancellation_point();
      if (Cell_complex::is_infinite(f) || !(is_conflict(f[0]) || is_conflict(f[1]) || is_conflict(f[2])) ||
          !m_knowledge.has_triangle(f))
        return;
      std::sort(f.begin(), f.end());
      facets.push_back(f);
    });
    std::sort(facets.begin(), facets.end());
    std::vector<Facet> withdrawn;
    for (Point_index p : m_cluster)
      m_builder.for_each_triangle_at(p, [&](Facet t) {
        std::sort(t.begin(), t.end());
        if (!std::binary_search(facets.begin(), facets.end(), t))
          withdrawn.push_back(t);
      });
    std::sort(withdrawn.begin(), withdrawn.end());
    withdrawn.erase(std::unique(withdrawn.begin(), withdrawn.end()), withdrawn.end());
    for (const Facet& t : withdrawn)
      withdraw(t, cancellation_point);
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
        if (!is_conflict(p) && m_knowledge.is_complete(p))
          contradicted.push_back(p);
    });
    std::sort(contradicted.begin(), contradicted.end());
    contradicted.erase(std::unique(contradicted.begin(), contradicted.end()), contradicted.end());
    for (Point_index p : contradicted) {
      std::vector<Triangle> star;
      m_builder.for_each_triangle_at(p, [&](const Triangle& t) { star.push_back(t); });
      m_builder.open(p);
      for (const Triangle& t : star)
        withdraw(t, cancellation_point);
    }
    return !contradicted.empty();
  }

  template <typename CancellationPoint>
  void withdraw(const Triangle& t, CancellationPoint& cancellation_point)
  {
    m_builder.remove(stored_triangle(t));
    for (Point_index p : t)
      if (!is_conflict(p)) {
        m_is_conflict[p] = 1;
        add_to_cluster(p, cancellation_point);
      }
  }

  // The stored triangle with an open point among its vertices.
  typename Builder::Triangle_index stored_triangle(const Triangle& t) const
  {
    const std::size_t i = m_builder.is_open(t[0]) ? 0 : m_builder.is_open(t[1]) ? 1 : 2;
    return m_builder.find_triangle(t[i], t[(i + 1) % 3], t[(i + 2) % 3]);
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
            !m_knowledge.is_on_surface(c, i) && (is_conflict(f[0]) || is_conflict(f[1]) || is_conflict(f[2])))
          visit(f);
      }
  }

  template <typename CancellationPoint, typename OnVerdict>
  void attach(const Cell_complex& cells, const Cell_labelling& labelling, CancellationPoint& cancellation_point,
              OnVerdict on_verdict)
  {
    std::vector<Triangle> surface;
    for_each_missing_triangle(cells, labelling, cancellation_point, [&](Triangle t) {
      std::sort(t.begin(), t.end());
      surface.push_back(t);
    });
    std::sort(surface.begin(), surface.end());
    for (const Triangle& t : surface) {
      cancellation_point();
      on_verdict(t, m_builder.try_add(t[0], t[1], t[2]));
    }
  }

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  Conflict_clusters<Builder> m_clusters;
  Oriented_energy m_oriented_energy;
  std::vector<unsigned char> m_is_conflict, m_is_site; // of each point, now
  Facet_knowledge<Builder> m_knowledge;
  std::vector<Point_index> m_cluster; // conflicts of the current cluster
  std::vector<Point_index> m_sites;   // of the current cluster, increasing
  std::vector<Point_index> m_around;
  std::size_t m_search_effort = 0; // that is left
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_COMPLETION_H

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
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Nearest_neighbors.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelling_repair.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Completes the surface where charts conflict (thesis 6.3, "Compatibility"): the conflicting points
// and the surface around them are triangulated by Delaunay tetrahedra, these are labelled inside
// and outside by the votes of the stars, and the facets between the labels are the surface.
template <typename Builder>
class Conflict_completion
{
public:
  Conflict_completion(const std::vector<Local_point>& points, const Point_octree_3& octree, double maximum_radius, Builder& builder)
    : m_points(points), m_builder(builder), m_neighbors(points, octree, maximum_radius)
  { }

  // Ends early if cancelled.
  template <typename Progress, typename OnVerdict>
  void operator()(Progress& progress, OnVerdict on_verdict)
  {
    find_conflicts();
    const std::vector<std::vector<std::size_t> > clusters = find_clusters(progress);
    std::size_t done = 0;
    // A single cluster may hold all points.
    Cancellation_point<Progress> cancellation_point(progress);
    for (const std::vector<std::size_t>& cluster : clusters) {
      try {
        complete(cluster, cancellation_point, on_verdict);
      } catch (const Cancelled&) {
        return;
      }
      done += cluster.size();
      if (!progress.advance(double(done) / double(m_conflicts.size())))
        return;
    }
  }

private:
  using Triangle = typename Builder::Triangle;
  using Facet = std::array<Point_index, 3>;
  using Cell_index = Cell_complex::Cell_index;

  // Weight of a facet that is known to be on the surface, or negative, known not to be.
  static constexpr double CERTAIN = 20.;

  // Whether the surface at the point is one closed fan.
  bool is_complete(Point_index p) const
  {
    return !m_builder.is_open(p) || m_builder.is_fan_closed(p);
  }

  void find_conflicts()
  {
    m_is_conflict.assign(m_points.size(), 0);
    m_is_site.assign(m_points.size(), 0);
    for (Point_index p : m_builder.open_points())
      if (!is_on_boundary(p) && !is_complete(p))
        m_conflicts.push_back(p);
    std::sort(m_conflicts.begin(), m_conflicts.end());
    for (Point_index p : m_conflicts)
      m_is_conflict[p] = 1;
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

  bool is_conflict(Point_index p) const { return m_is_conflict[p] != 0; }

  // The points around a conflict that its completion must see: its neighbors, its link, and the
  // links of its link, so that their stars are complete.
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
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
  }

  void add_link(Point_index p, std::vector<Point_index>& result) const
  {
    const Star_table& stars = m_builder.compatibility().stars();
    for (Star_table::Slot s = stars.begin(p); s != stars.end(p); ++s)
      if (stars.neighbor(s) != NO_POINT)
        result.push_back(stars.neighbor(s));
  }

  Point_index position_of(Point_index conflict) const
  {
    return static_cast<Point_index>(std::lower_bound(m_conflicts.begin(), m_conflicts.end(), conflict) - m_conflicts.begin());
  }

  // Conflicts that see each other, as positions in m_conflicts; none if cancelled.
  template <typename Progress>
  std::vector<std::vector<std::size_t> > find_clusters(Progress& progress)
  {
    Parity_union_find sets(m_conflicts.size());
    m_surroundings.resize(m_conflicts.size());
    for (std::size_t i = 0; i != m_conflicts.size(); ++i) {
      if (i % CONFLICTS_PER_POLL == 0 && !progress.advance(0.))
        return {};
      surroundings(m_conflicts[i], m_surroundings[i]);
      for (Point_index q : m_surroundings[i])
        if (is_conflict(q))
          sets.unite(static_cast<Point_index>(i), position_of(q), false);
    }
    std::vector<std::size_t> cluster_of(m_conflicts.size(), 0);
    std::vector<std::vector<std::size_t> > clusters;
    for (std::size_t i = 0; i != m_conflicts.size(); ++i) {
      const std::size_t root = sets.find(static_cast<Point_index>(i)).root;
      if (root == i) {
        cluster_of[i] = clusters.size();
        clusters.emplace_back();
      }
      clusters[cluster_of[root]].push_back(i);
    }
    return clusters;
  }

  template <typename CancellationPoint, typename OnVerdict>
  void complete(const std::vector<std::size_t>& cluster, CancellationPoint& cancellation_point, OnVerdict on_verdict)
  {
    m_cluster.clear();
    for (Point_index p : m_sites)
      m_is_site[p] = 0;
    m_sites.clear();
    for (std::size_t i : cluster)
      add_to_cluster(m_conflicts[i], m_surroundings[i]);
    Cell_complex cells(m_points, sorted_sites(), cancellation_point);
    // Once: the few triangles around the points that join then hardly matter.
    if (cells.size() != 0 && withdraw_triangles_without_facet(cells, cancellation_point))
      cells = Cell_complex(m_points, sorted_sites(), cancellation_point);
    if (cells.size() == 0)
      return;
    find_certain_sites(cells, cancellation_point);
    compute_spheres(cells, cancellation_point);
    Cell_labelling labelling(cells, [&](Cell_index c, std::size_t i) { return weight(cells, c, i); }, cancellation_point);
    Labelling_repair repair(cells, labelling, [&](Point_index p) { return is_conflict(p) || is_certain(p); }, CERTAIN / 2,
                            cancellation_point);
    repair(cancellation_point);
    attach(cells, labelling, cancellation_point, on_verdict);
    for (Point_index p : m_cluster)
      m_is_conflict[p] = is_complete(p) ? 0 : 1;
  }

  // Hands the surroundings of a conflict over to the current cluster.
  void add_to_cluster(Point_index p, std::vector<Point_index>& surroundings)
  {
    m_cluster.push_back(p);
    // Marked: surroundings overlap so much that all of them take far more memory than the sites.
    for (Point_index q : surroundings)
      if (!m_is_site[q]) {
        m_is_site[q] = 1;
        m_sites.push_back(q);
      }
    std::vector<Point_index>().swap(surroundings);
  }

  const std::vector<Point_index>& sorted_sites()
  {
    std::sort(m_sites.begin(), m_sites.end());
    return m_sites;
  }

  // The surface of the labelling consists of facets. An agreed triangle at a conflict that is no
  // facet would cross it; it is withdrawn and its points join the conflict. Returns whether there
  // was one.
  template <typename CancellationPoint>
  bool withdraw_triangles_without_facet(const Cell_complex& cells, CancellationPoint& cancellation_point)
  {
    std::vector<Facet> facets;
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i) {
        cancellation_point();
        Facet f = Cell_complex::facet(cells[c], i);
        if (cells[c].neighbors[i] < c || is_infinite(f) || !(is_conflict(f[0]) || is_conflict(f[1]) || is_conflict(f[2])) ||
            !has_triangle(f))
          continue;
        std::sort(f.begin(), f.end());
        facets.push_back(f);
      }
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
    for (const Facet& t : withdrawn) {
      m_builder.remove(stored_triangle(t));
      for (Point_index p : t)
        if (!is_conflict(p)) {
          m_is_conflict[p] = 1;
          std::vector<Point_index> around;
          surroundings(p, around);
          add_to_cluster(p, around);
        }
    }
    return !withdrawn.empty();
  }

  // The stored triangle with a conflict among its vertices.
  typename Builder::Triangle_index stored_triangle(const Facet& t) const
  {
    const std::size_t i = m_builder.is_open(t[0]) ? 0 : m_builder.is_open(t[1]) ? 1 : 2;
    return m_builder.find_triangle(t[i], t[(i + 1) % 3], t[(i + 2) % 3]);
  }

  bool has_triangle(const Facet& f) const
  {
    if (m_builder.is_open(f[0]))
      return m_builder.find_triangle(f[0], f[1], f[2]) != Builder::NO_TRIANGLE;
    return m_builder.compatibility().stars().view(f[0], f[1], f[2]) != Star_table::View::ABSENT;
  }

  // A site is certain if its fan is closed and made of facets of the cells.
  template <typename CancellationPoint>
  void find_certain_sites(const Cell_complex& cells, CancellationPoint& cancellation_point)
  {
    std::vector<std::size_t> facets_at(m_sites.size(), 0);
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i) {
        cancellation_point();
        const Facet f = Cell_complex::facet(cells[c], i);
        if (cells[c].neighbors[i] < c || is_infinite(f) || !has_triangle(f))
          continue;
        for (Point_index p : f)
          ++facets_at[site(p)];
      }
    m_is_certain.assign(m_sites.size(), 0);
    for (std::size_t s = 0; s != m_sites.size(); ++s) {
      std::size_t triangles = 0;
      m_builder.for_each_triangle_at(m_sites[s], [&](const Triangle&) { ++triangles; });
      m_is_certain[s] = !is_conflict(m_sites[s]) && is_complete(m_sites[s]) && facets_at[s] == triangles ? 1 : 0;
    }
  }

  std::size_t site(Point_index p) const
  {
    return static_cast<std::size_t>(std::lower_bound(m_sites.begin(), m_sites.end(), p) - m_sites.begin());
  }
  bool is_certain(Point_index p) const { return m_is_certain[site(p)] != 0; }
  static bool is_infinite(const Facet& f) { return f[0] == NO_POINT || f[1] == NO_POINT || f[2] == NO_POINT; }

  struct Sphere { Local_point center; double radius; };

  template <typename CancellationPoint>
  void compute_spheres(const Cell_complex& cells, CancellationPoint& cancellation_point)
  {
    m_spheres.resize(cells.size());
    for (Cell_index c = 0; c != cells.size(); ++c) {
      cancellation_point();
      if (!Cell_complex::is_infinite(cells[c]))
        m_spheres[c] = circumsphere(cells[c].vertices);
    }
  }

  Sphere circumsphere(const std::array<Point_index, 4>& v) const
  {
    const Local_point& o = m_points[v[0]];
    const Local_vector a = m_points[v[1]] - o, b = m_points[v[2]] - o, c = m_points[v[3]] - o;
    const Local_vector numerator = a.squared_length() * cross_product(b, c) + b.squared_length() * cross_product(c, a) +
                                   c.squared_length() * cross_product(a, b);
    const Local_vector offset = numerator / (2. * (cross_product(a, b) * c));
    return Sphere{ o + offset, std::sqrt(offset.squared_length()) };
  }

  // How the facet wants the labels of its cells to differ: known, or from the votes of the stars and
  // from the angle at which the circumscribed spheres of the cells meet (Amenta, Choi and Kolluri,
  // The power crust, 2001).
  double weight(const Cell_complex& cells, Cell_index c, std::size_t i) const
  {
    const Facet f = Cell_complex::facet(cells[c], i);
    if (is_infinite(f)) {
      for (Point_index p : f)
        if (p != NO_POINT && (is_conflict(p) || is_certain(p)))
          return -CERTAIN;
      return 0.;
    }
    if (has_triangle(f))
      return CERTAIN;
    if (is_certain(f[0]) || is_certain(f[1]) || is_certain(f[2]))
      return -CERTAIN;
    constexpr double trust[4] = { -1., -.2, .2, 1.5 };
    return trust[votes(f)] - cosine_of_spheres(cells, f, c, cells[c].neighbors[i]);
  }

  std::size_t votes(const Facet& f) const
  {
    const Star_table& stars = m_builder.compatibility().stars();
    std::size_t result = 0;
    for (std::size_t i = 0; i != 3; ++i)
      if (stars.view(f[i], f[(i + 1) % 3], f[(i + 2) % 3]) != Star_table::View::ABSENT)
        ++result;
    return result;
  }

  double cosine_of_spheres(const Cell_complex& cells, const Facet& f, Cell_index c, Cell_index d) const
  {
    const double x = height(cells, f, c), y = height(cells, f, d);
    return std::sqrt((1. - x * x) * (1. - y * y)) - x * y;
  }

  // Signed distance of the center of the cell's sphere to the facet, towards the cell, over the radius.
  double height(const Cell_complex& cells, const Facet& f, Cell_index c) const
  {
    if (Cell_complex::is_infinite(cells[c]))
      return 1.;
    Point_index apex = NO_POINT;
    for (Point_index p : cells[c].vertices)
      if (p != f[0] && p != f[1] && p != f[2])
        apex = p;
    const Local_point& o = m_points[f[0]];
    const Local_vector n = cross_product(m_points[f[1]] - o, m_points[f[2]] - o);
    const double side = n * (m_points[apex] - o) < 0. ? -1. : 1.;
    const double length = std::sqrt(n.squared_length()) * m_spheres[c].radius;
    const double value = side * (n * (m_spheres[c].center - o)) / length;
    return value >= -1. && value <= 1. ? value : value > 1. ? 1. : -1.;
  }

  template <typename CancellationPoint, typename OnVerdict>
  void attach(const Cell_complex& cells, const Cell_labelling& labelling, CancellationPoint& cancellation_point, OnVerdict on_verdict)
  {
    std::vector<Triangle> surface;
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i) {
        cancellation_point();
        Facet f = Cell_complex::facet(cells[c], i);
        if (cells[c].neighbors[i] < c || is_infinite(f) || !labelling.is_surface(c, i) || has_triangle(f) ||
            !(is_conflict(f[0]) || is_conflict(f[1]) || is_conflict(f[2])))
          continue;
        std::sort(f.begin(), f.end());
        surface.push_back(f);
      }
    std::sort(surface.begin(), surface.end());
    for (const Triangle& t : surface) {
      cancellation_point();
      on_verdict(t, m_builder.try_add(t[0], t[1], t[2]));
    }
  }

  // Open stars that must follow one another in both directions to make a boundary.
  static constexpr std::size_t BOUNDARY_LENGTH = 2;

  static constexpr std::size_t CONFLICTS_PER_POLL = 64;

  // Two rings of a regular sample hold 18 points.
  static constexpr std::size_t NEIGHBORS = 16;

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  Nearest_neighbors m_neighbors;
  std::vector<Point_index> m_conflicts;                  // at the beginning, increasing
  std::vector<unsigned char> m_is_conflict, m_is_site;              // of each point, now
  std::vector<std::vector<Point_index> > m_surroundings; // of each conflict
  std::vector<Point_index> m_cluster;                    // conflicts of the current cluster
  std::vector<Point_index> m_sites;                      // of the current cluster, increasing
  std::vector<unsigned char> m_is_certain;               // of each site
  std::vector<Sphere> m_spheres;                         // of the cells
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_COMPLETION_H

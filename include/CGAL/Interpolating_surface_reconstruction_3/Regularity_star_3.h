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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_REGULARITY_STAR_3_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_REGULARITY_STAR_3_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Point_star.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {

namespace internal {

// One star of 3.3.1 in the making. The center P0 is the origin; its neighbors are named by their
// positions in the neighborhood, NONE stands for no neighbor.
class Regularity_star_builder
{
public:
  Regularity_star_builder(const Star_neighborhood& neighborhood, std::vector<std::uint32_t>& link)
    : m_neighbors(neighborhood), m_link(link)
  { }

  // 3.3.1: the initial triangle, then further triangles around P0. A star that does not close is
  // continued at the other end, and keeps a gap there.
  void build()
  {
    m_link.clear();
    if (!find_initial_triangle() || grow_until_closed())
      return;
    std::reverse(m_link.begin(), m_link.end());
    if (!grow_until_closed())
      m_link.push_back(Point_star::GAP);
  }

private:
  using Neighbor = std::uint32_t;

  static constexpr Neighbor NONE = Point_star::GAP;
  // Ends a growth that winds around the center of a hopeless neighborhood.
  static constexpr std::size_t MAXIMUM_STAR_SIZE = 64;
  // The plane of a flatter triangle is a matter of rounding.
  static constexpr double LEAST_REGULARITY = 1. + 1e-9;

  // Where the third vertex of a triangle may lie: in front of up to two planes through P0. The
  // first point of the star lies on one of them, and is welcome as soon as it can close the star.
  struct Subspace
  {
    std::array<Local_vector, 2> normals;
    std::size_t size;
    Neighbor closing;

    bool contains(const Local_vector& v) const
    {
      for (std::size_t i = 0; i != size; ++i)
        if (!(v * normals[i] > 0.))
          return false;
      return true;
    }
  };

  // 3.3.1.1: P1 is the nearest point, Pk makes the most regular triangle with it on either side.
  bool find_initial_triangle()
  {
    const Neighbor p1 = nearest_neighbor();
    if (p1 == NONE)
      return false;
    const Subspace everywhere{ {}, 0, NONE };
    const Neighbor pk = most_regular(p1, everywhere);
    if (pk == NONE)
      return false;
    const Subspace side_of_pk{ { -outward_normal(p1, pk) }, 1, NONE };
    const Neighbor p2 = closest_fitting(p1, pk, side_of_pk);
    m_link.push_back(p1);
    m_link.push_back(p2);
    return true;
  }

  // Points that coincide with P0 in double coordinates make no triangle.
  Neighbor nearest_neighbor() const
  {
    for (Neighbor i = 0; i != m_neighbors.size(); ++i)
      if (m_neighbors[i].squared_length() > 0.)
        return i;
    return NONE;
  }

  // 3.3.1.2: attaches triangles at the last edge until the star closes. False if it cannot.
  bool grow_until_closed()
  {
    while (m_link.size() < MAXIMUM_STAR_SIZE) {
      const Subspace subspace = subspace_of_next_triangle();
      const Neighbor last = m_link.back();
      Neighbor next = most_regular(last, subspace);
      if (next == NONE)
        return false;
      next = closest_fitting(last, next, subspace);
      if (next == m_link.front())
        return true;
      if (!is_smooth(next))
        return false;
      m_link.push_back(next);
    }
    return false;
  }

  // Beyond the last edge; and beyond the first edge too as soon as that comes into view (Fig.
  // 3.4c).
  Subspace subspace_of_next_triangle() const
  {
    const std::size_t n = m_link.size();
    const Neighbor first = m_link[0], last = m_link[n - 1];
    Subspace result{ { outward_normal(last, m_link[n - 2]) }, 1, NONE };
    if (n > 2 && result.contains(m_neighbors[first])) {
      result.normals[result.size++] = outward_normal(first, m_link[1]);
      result.closing = first;
    }
    return result;
  }

  // Normal of the edge from P0 to `end` in the plane of its triangle, away from the third vertex.
  Local_vector outward_normal(Neighbor end, Neighbor third) const
  {
    const Local_vector& e = m_neighbors[end];
    const Local_vector& v = m_neighbors[third];
    return e * ((v * e) / e.squared_length()) - v;
  }

  bool is_candidate(Neighbor i, Neighbor end, const Subspace& subspace) const
  {
    return i != end && (i == subspace.closing || subspace.contains(m_neighbors[i]));
  }

  // The third vertex of the most regular triangle at the edge from P0 to `end`.
  Neighbor most_regular(Neighbor end, const Subspace& subspace) const
  {
    const double length = std::sqrt(m_neighbors[end].squared_length());
    Neighbor result = NONE;
    double best = LEAST_REGULARITY, squared_reach = (std::numeric_limits<double>::max)();
    for (Neighbor i = 0; i != m_neighbors.size(); ++i) {
      if (m_neighbors[i].squared_length() > squared_reach)
        break;
      if (!is_candidate(i, end, subspace))
        continue;
      const double r = regularity(CENTER, m_neighbors[end], m_neighbors[i]);
      if (r > best) {
        best = r;
        result = i;
        squared_reach = square(length / sine_of_least_angle(r));
      }
    }
    return result;
  }

  // A triangle of this regularity or a higher one has no smaller angle: the other two angles
  // contribute 2 sin(angle / 2) at most, so that cos(angle) + 2 sin(angle / 2) >= regularity. By
  // the law of sines a side is at most 1 / sin(angle) times as long as another.
  static double sine_of_least_angle(double regularity)
  {
    const double sine_of_half = (1. - std::sqrt((std::max)(0., 3. - 2. * regularity))) / 2.;
    return 2. * sine_of_half * std::sqrt(1. - sine_of_half * sine_of_half);
  }

  // Starting with Pk, looks at the points closer to the edge as third vertices: approaching the
  // edge point by point makes far more stars agree than looking at the closest point first.
  Neighbor closest_fitting(Neighbor end, Neighbor pk, const Subspace& subspace) const
  {
    double distance = distance_to_edge(end, pk);
    while (true) {
      const Neighbor p2 = next_closer(end, distance, subspace);
      if (p2 == NONE)
        return pk;
      if (is_second_preferred(end, pk, p2))
        pk = p2;
      distance = distance_to_edge(end, p2);
    }
  }

  // The candidate that is farthest from the edge among those closer than `distance`.
  Neighbor next_closer(Neighbor end, double distance, const Subspace& subspace) const
  {
    const double length = std::sqrt(m_neighbors[end].squared_length());
    Neighbor result = NONE;
    double farthest = 0.;
    for (Neighbor i = 0; i != m_neighbors.size(); ++i) {
      // By the triangle inequality the points from here on are too far.
      if (2. * std::sqrt(m_neighbors[i].squared_length()) - length > distance)
        break;
      if (!is_candidate(i, end, subspace))
        continue;
      const double d = distance_to_edge(end, i);
      if (d > farthest && d < distance && regularity(CENTER, m_neighbors[end], m_neighbors[i]) > LEAST_REGULARITY) {
        farthest = d;
        result = i;
      }
    }
    return result;
  }

  // The sum of distances in Eq. 3.13.
  double distance_to_edge(Neighbor end, Neighbor i) const
  {
    return std::sqrt(m_neighbors[i].squared_length()) + std::sqrt((m_neighbors[i] - m_neighbors[end]).squared_length());
  }

  // Whether the closer point p2 replaces pk. If only one of them projects into the triangle of the
  // other, it is the better one; if both do, the closer one as in 3.3.2.3; if none does, Eq. 3.2.
  bool is_second_preferred(Neighbor end, Neighbor pk, Neighbor p2) const
  {
    if (projects_into(p2, end, pk))
      return true;
    if (projects_into(pk, end, p2))
      return false;
    return !is_first_more_regular(CENTER, m_neighbors[end], m_neighbors[pk], m_neighbors[p2]);
  }

  // Whether the orthogonal projection of point i lies in the triangle of P0, `u` and `v`.
  bool projects_into(Neighbor i, Neighbor u, Neighbor v) const
  {
    const Local_vector& a = m_neighbors[u];
    const Local_vector& b = m_neighbors[v];
    const Local_vector& p = m_neighbors[i];
    const Local_vector normal = cross_product(a, b);
    return cross_product(a, p) * normal > 0. && cross_product(p, b) * normal > 0. &&
           cross_product(b - a, p - a) * normal > 0.;
  }

  // No point of the star projects into the triangle of the last edge and `next`, nor `next` into a
  // triangle of the star; and `next` is not part of the star.
  bool is_smooth(Neighbor next) const
  {
    for (std::size_t i = 0; i != m_link.size(); ++i)
      if (m_link[i] == next || projects_into(m_link[i], m_link.back(), next) ||
          (i != 0 && projects_into(next, m_link[i - 1], m_link[i])))
        return false;
    return true;
  }

  static inline const Local_vector CENTER{ 0., 0., 0. };

  const Star_neighborhood& m_neighbors;
  std::vector<Neighbor>& m_link;
};

} // namespace internal

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

The star of a point that grows triangle by triangle around the point, as described in Section 3.3.1
of the thesis on which this package is based.

The initial triangle has the edge to the nearest neighbor; every further triangle is attached to the
last edge of the star until it reaches the first edge. The third vertex of each triangle is
chosen among the points beyond the edge by proximity to the edge (Eq. 3.13) and by regularity of the
triangles (Eq. 3.1 and 3.2), such that no point of the star projects orthogonally into another
triangle of it. A star that cannot be closed in this way is kept with a gap.

The star takes the neighborhood as it is given, and never asks for a larger one.

\cgalModels{StarConstruction_3}

\sa `Restricted_voronoi_star_3`
*/
class Regularity_star_3
{
public:
  /// the star takes the points of the octree leaves around the point.
  using Neighborhood_category = Box_neighborhood_tag;

  /// number of neighbors to start with; of no effect, since the leaves decide.
  static std::size_t initial_number_of_neighbors() { return MAXIMUM_NEIGHBORS; }
  /// largest number of neighbors that are worth looking at.
  static std::size_t maximum_number_of_neighbors() { return MAXIMUM_NEIGHBORS; }

  /// computes the star of the center of `neighborhood`; returns `true`.
  bool operator()(const Star_neighborhood& neighborhood, Point_star& star) const
  {
    internal::Regularity_star_builder(neighborhood, star.link).build();
    orient(neighborhood, star);
    return true;
  }

private:
  using Vector_3 = Star_neighborhood::Vector_3;

  // All points of the 27 leaves in a block of equal cells.
  static constexpr std::size_t MAXIMUM_NEIGHBORS = std::size_t(27) * 24;

  // The link is counterclockwise about the sum of the triangles' normals.
  static void orient(const Star_neighborhood& neighborhood, Point_star& star)
  {
    Vector_3 sum(0., 0., 0.);
    for (std::size_t i = 0; i != star.link.size(); ++i) {
      const std::uint32_t u = star.link[i], v = star.link[(i + 1) % star.link.size()];
      if (u != Point_star::GAP && v != Point_star::GAP)
        sum = sum + CGAL::cross_product(neighborhood[u], neighborhood[v]);
    }
    const double length = std::sqrt(sum.squared_length());
    star.normal = length > 0. ? sum / length : Vector_3(0., 0., 1.);
  }
};

} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_REGULARITY_STAR_3_H

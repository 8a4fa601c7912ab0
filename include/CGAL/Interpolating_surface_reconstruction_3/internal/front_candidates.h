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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FRONT_CANDIDATES_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FRONT_CANDIDATES_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Growing_front.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/star_compatibility.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_measures.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The triangle that an edge of the front wants to be attached to it.
struct Front_candidate
{
  Point_index apex = NO_POINT; // its third vertex
  double coplanarity = 0.;     // cosine of the supplementary angle with the triangle beside the edge
  bool is_agreed = false;      // by the stars of its vertices
};

// Finds the candidate triangle of an edge AB of the front (thesis 3.3.2). The points around A and B that
// count are those that their stars connect to the edge: they are its neighbors by proximity.
template <typename Builder>
class Front_candidates
{
public:
  using Edge_index = Growing_front::Edge_index;

  Front_candidates(const std::vector<Local_point>& points, const Builder& builder, const Growing_front& front)
    : m_points(points), m_compatibility(builder.compatibility()), m_front(front)
  { }

  Front_candidate operator()(Edge_index e) const
  {
    const Growing_front::Edge& edge = m_front.edge(e);
    const Point_index a = edge.ends[0], b = edge.ends[1];
    Front_candidate candidate;
    candidate.apex = agreed_apex(a, b, edge.opposite);
    candidate.is_agreed = candidate.apex != NO_POINT;
    // Where the star of an end is agreed, there is no other triangle: the surface ends.
    if (!candidate.is_agreed && !m_compatibility.is_point_agreed(a) && !m_compatibility.is_point_agreed(b))
      candidate.apex = disputed_apex(e);
    if (candidate.apex != NO_POINT)
      candidate.coplanarity =
        cosine_of_supplementary_angle(m_points[a], m_points[b], m_points[candidate.apex], m_points[edge.opposite]);
    return candidate;
  }

private:
  using Apices = boost::container::small_vector<Point_index, 4>;

  // The third vertex of the other agreed triangle at the edge, or NO_POINT.
  Point_index agreed_apex(Point_index a, Point_index b, Point_index opposite) const
  {
    const Star_table& stars = m_compatibility.stars();
    for (Star_table::Slot s = stars.begin(a); s != stars.end(a); ++s)
      if (stars.neighbor(s) == b) {
        const Star_table::Slot after = stars.next(a, s), before = s == stars.begin(a) ? stars.end(a) - 1 : s - 1;
        if (m_compatibility.is_triangle_agreed(s) && stars.neighbor(after) != opposite)
          return stars.neighbor(after);
        if (m_compatibility.is_triangle_agreed(before) && stars.neighbor(before) != opposite)
          return stars.neighbor(before);
        break;
      }
    return NO_POINT;
  }

  // The third vertex that is chosen where the stars do not agree. It counts if the majority of the
  // stars of the triangle have it; to fill the gap between adjacent edges, one of them is enough.
  Point_index disputed_apex(Edge_index e) const
  {
    Apices apices = star_apices(e);
    if (apices.empty())
      apices = ear_apices(e);
    if (apices.empty())
      return NO_POINT;
    const Point_index a = m_front.edge(e).ends[0], b = m_front.edge(e).ends[1], apex = chosen(a, b, apices);
    const bool is_ear = apex == m_front.following(e, 0) || apex == m_front.following(e, 1);
    const std::size_t needed = is_ear ? 1 : 2;
    return m_compatibility.stars().votes(a, b, apex) >= needed ? apex : NO_POINT;
  }

  // The points in the subspace beyond the edge that the stars of A and B connect to the edge.
  Apices star_apices(Edge_index e) const
  {
    const Star_table& stars = m_compatibility.stars();
    Apices apices;
    for (std::size_t i = 0; i != 2; ++i) {
      const Point_index center = m_front.edge(e).ends[i], other = m_front.edge(e).ends[1 - i];
      for (Star_table::Slot s = stars.begin(center); s != stars.end(center); ++s) {
        const Star_table::Slot t = stars.next(center, s);
        if (!stars.has_triangle(center, s) || (stars.neighbor(s) != other && stars.neighbor(t) != other))
          continue;
        const Point_index x = stars.neighbor(s) == other ? stars.neighbor(t) : stars.neighbor(s);
        if (std::find(apices.begin(), apices.end(), x) == apices.end() && !m_compatibility.is_point_agreed(x) &&
            is_in_subspace(e, x))
          apices.push_back(x);
      }
    }
    return apices;
  }

  // Fig. 3.7: the ends of the adjacent edges of the front.
  Apices ear_apices(Edge_index e) const
  {
    Apices apices;
    for (std::size_t i = 0; i != 2; ++i) {
      const Point_index x = m_front.following(e, i);
      if (x != m_front.edge(e).opposite && !m_compatibility.is_point_agreed(x) && (apices.empty() || apices[0] != x))
        apices.push_back(x);
    }
    return apices;
  }

  // Fig. 3.5: whether x lies beyond the edge, and beyond the adjacent edges of the front as far as these
  // reach beyond it.
  bool is_in_subspace(Edge_index e, Point_index x) const
  {
    if (x == m_front.edge(e).opposite || !is_beyond(e, x))
      return false;
    for (std::size_t i = 0; i != 2; ++i) {
      const Point_index following = m_front.following(e, i);
      if (following != x && is_beyond(e, following) && !is_beyond(m_front.edge(e).links[i], x))
        return false;
    }
    return true;
  }

  // Whether x is outside of the plane through the edge that is perpendicular to the triangle beside it.
  bool is_beyond(Edge_index e, Point_index x) const
  {
    const Growing_front::Edge& edge = m_front.edge(e);
    const Local_point& a = m_points[edge.ends[0]];
    const Local_vector along = m_points[edge.ends[1]] - a, inward = m_points[edge.opposite] - a;
    return cross_product(along, cross_product(along, inward)) * (m_points[x] - a) > 0.;
  }

  // The nearest two by Eq. 3.13, and one of them by Fig. 3.6.
  Point_index chosen(Point_index a, Point_index b, Apices& apices) const
  {
    std::sort(apices.begin(), apices.end(), [&](Point_index p, Point_index q) {
      const double dp = distance(a, b, p), dq = distance(a, b, q);
      return dp != dq ? dp < dq : p < q;
    });
    if (apices.size() == 1)
      return apices[0];
    const Point_index nearer = apices[0], farther = apices[1];
    if (is_in_prism(a, b, farther, nearer))
      return nearer;
    if (is_in_prism(a, b, nearer, farther))
      return farther;
    return is_first_more_regular(m_points[a], m_points[b], m_points[nearer], m_points[farther]) ? nearer : farther;
  }

  // Eq. 3.13
  double distance(Point_index a, Point_index b, Point_index x) const
  {
    return std::sqrt((m_points[x] - m_points[a]).squared_length()) +
           std::sqrt((m_points[x] - m_points[b]).squared_length());
  }

  // Fig. 3.6: whether x projects into the triangle (a, b, p).
  bool is_in_prism(Point_index a, Point_index b, Point_index p, Point_index x) const
  {
    const Local_vector normal = cross_product(m_points[b] - m_points[a], m_points[p] - m_points[a]);
    return is_left(a, b, normal, x) && is_left(b, p, normal, x) && is_left(p, a, normal, x);
  }

  bool is_left(Point_index p, Point_index q, const Local_vector& normal, Point_index x) const
  {
    return cross_product(normal, m_points[q] - m_points[p]) * (m_points[x] - m_points[p]) >= 0.;
  }

  const std::vector<Local_point>& m_points;
  const Star_compatibility& m_compatibility;
  const Growing_front& m_front;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FRONT_CANDIDATES_H

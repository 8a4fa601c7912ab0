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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BOUNDARY_LOOPS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BOUNDARY_LOOPS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// A cycle of boundary edges, as the points that it visits.
using Boundary_loop = std::vector<Point_index>;

// The sum of the normals of the triangles of a fan over the loop, each twice as long as its area.
inline Local_vector loop_normal(const std::vector<Local_point>& points, const Boundary_loop& loop)
{
  Local_vector result(0, 0, 0);
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    result = result + cross_product(points[loop[i]] - points[loop[0]], points[loop[i + 1]] - points[loop[0]]);
  return result;
}

inline double mean_edge_of_loop(const std::vector<Local_point>& points, const Boundary_loop& loop)
{
  double length = 0.;
  for (std::size_t i = 0; i != loop.size(); ++i)
    length += std::sqrt((points[loop[(i + 1) % loop.size()]] - points[loop[i]]).squared_length());
  return length / double(loop.size());
}

// Finds the boundary loops of a surface. Where several fans meet at a point, a loop goes on across
// the gap to the next fan around the point, so that filling the loops joins the fans.
template <typename Builder>
class Boundary_loops
{
public:
  Boundary_loops(const std::vector<Local_point>& points, const Builder& builder) : m_points(points), m_builder(builder)
  { }

  // Loops by increasing length; a loop begins at its smallest point.
  template <typename CancellationPoint = No_cancellation>
  std::vector<Boundary_loop> operator()(CancellationPoint&& cancellation_point = CancellationPoint())
  {
    collect_passages(cancellation_point);
    std::vector<Boundary_loop> loops;
    for (std::size_t i = 0; i != m_passages.size(); ++i)
      if (!m_passages[i].is_visited)
        loops.push_back(trace(i));
    std::stable_sort(loops.begin(), loops.end(),
                     [](const Boundary_loop& a, const Boundary_loop& b) { return a.size() < b.size(); });
    return loops;
  }

private:
  // A loop passes `at` between the neighbors `from` and `to`, in either direction.
  struct Passage
  {
    Point_index at, from, to;
    bool is_visited;
    bool operator<(const Passage& other) const { return at < other.at; }
  };

  struct Fan
  {
    Point_index begin, end;
    double angle;
  };

  template <typename CancellationPoint>
  void collect_passages(CancellationPoint& cancellation_point)
  {
    for (Point_index p : m_builder.open_points()) {
      // around a point of many triangles every fan is searched for among them all
      const std::size_t degree = m_builder.corners(p).size();
      cancellation_point(1 + degree * degree / 256);
      std::vector<Fan> fans = fans_at(p);
      if (fans.size() > 1)
        sort_around(p, fans);
      for (std::size_t i = 0; i != fans.size(); ++i)
        m_passages.push_back(Passage{ p, fans[i].end, fans[(i + 1) % fans.size()].begin, false });
    }
    std::stable_sort(m_passages.begin(), m_passages.end());
  }

  std::vector<Fan> fans_at(Point_index p) const
  {
    std::vector<Fan> fans;
    std::vector<Point_index> ends;
    for (const auto& corner : m_builder.corners(p))
      for (Point_index q : { corner.a, corner.b })
        if (m_builder.number_of_triangles(p, q) == 1)
          ends.push_back(q);
    while (!ends.empty()) {
      const Point_index begin = ends.front(), end = m_builder.fan_from(p, begin).end;
      fans.push_back(Fan{ begin, end, 0. });
      ends.erase(std::remove_if(ends.begin(), ends.end(), [&](Point_index q) { return q == begin || q == end; }),
                 ends.end());
    }
    return fans;
  }

  // Orders the fans counterclockwise about a common normal, each from its begin to its end.
  void sort_around(Point_index p, std::vector<Fan>& fans) const
  {
    Local_vector normal = fan_normal(p, fans[0].begin);
    for (std::size_t i = 1; i != fans.size(); ++i) {
      const Local_vector n = fan_normal(p, fans[i].begin);
      if (n * normal < 0.)
        std::swap(fans[i].begin, fans[i].end);
      normal = normal + (n * normal < 0. ? -n : n);
    }
    const Local_vector u = m_points[fans[0].begin] - m_points[p];
    const Local_vector v = cross_product(normal, u);
    const double length = std::sqrt(normal.squared_length());
    for (Fan& fan : fans) {
      const Local_vector d = m_points[fan.begin] - m_points[p];
      fan.angle = std::atan2(d * v, (d * u) * length);
      if (fan.angle < 0.)
        fan.angle += 2. * CGAL_PI;
    }
    std::stable_sort(fans.begin() + 1, fans.end(), [](const Fan& a, const Fan& b) { return a.angle < b.angle; });
  }

  // Sum of the normals along the fan, as if it turned counterclockwise from `begin`.
  Local_vector fan_normal(Point_index p, Point_index begin) const
  {
    Local_vector normal(0, 0, 0);
    Point_index at = begin, before = NO_POINT;
    for (std::size_t size = m_builder.fan_from(p, begin).size; size != 0; --size) {
      for (const auto& corner : m_builder.corners(p)) {
        const Point_index other = corner.a == at ? corner.b : corner.b == at ? corner.a : NO_POINT;
        if (other == NO_POINT || other == before)
          continue;
        normal = normal + cross_product(m_points[at] - m_points[p], m_points[other] - m_points[p]);
        before = at;
        at = other;
        break;
      }
    }
    return normal;
  }

  Boundary_loop trace(std::size_t first)
  {
    Boundary_loop loop;
    m_passages[first].is_visited = true;
    loop.push_back(m_passages[first].at);
    Point_index at = m_passages[first].at, to = m_passages[first].to;
    while (true) {
      const auto range = std::equal_range(m_passages.begin(), m_passages.end(), Passage{ to, 0, 0, false });
      const auto it = std::find_if(range.first, range.second,
                                   [&](const Passage& p) { return !p.is_visited && (p.from == at || p.to == at); });
      if (it == range.second)
        return loop;
      it->is_visited = true;
      loop.push_back(to);
      at = std::exchange(to, it->from == at ? it->to : it->from);
    }
  }

  const std::vector<Local_point>& m_points;
  const Builder& m_builder;
  std::vector<Passage> m_passages;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BOUNDARY_LOOPS_H

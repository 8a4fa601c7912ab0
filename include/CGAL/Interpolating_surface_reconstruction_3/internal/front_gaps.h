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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FRONT_GAPS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FRONT_GAPS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Growing_front.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Chooses the gap of the front at a point that a new triangle lies in, by the directions in which the
// edges leave the point, seen along the normal of the triangle.
class Front_gaps
{
public:
  using Gap = Growing_front::Gap;

  Front_gaps(const std::vector<Local_point>& points, const Growing_front& front) : m_points(points), m_front(front) { }

  // The gap at p for the triangle (p, a, b), its first edge being on the side of a.
  Gap operator()(Point_index p, Point_index a, Point_index b, const std::vector<Gap>& gaps) const
  {
    const Frame frame(m_points[a] - m_points[p], m_points[b] - m_points[p]);
    Gap best = gaps.front();
    double least = std::numeric_limits<double>::infinity();
    for (const Gap& gap : gaps) {
      // Turn so that the gap extends counterclockwise from its first edge.
      const Gap turned = is_left_of_surface(frame, p, gap.first) ? gap : Gap{ gap.second, gap.first };
      const double from = angle(frame, p, far_end(p, turned.first)),
                   width = difference(angle(frame, p, far_end(p, turned.second)), from);
      const double to_a = difference(0., from), to_b = difference(frame.angle_of_second(), from);
      const double beyond = (std::max)(0., (std::max)(to_a, to_b) - width);
      if (beyond < least) {
        least = beyond;
        best = to_a < to_b ? turned : Gap{ turned.second, turned.first };
      }
    }
    return best;
  }

private:
  // Plane coordinates: the first axis along u, v on the left of it.
  struct Frame
  {
    Frame(const Local_vector& u, const Local_vector& v) : x(u), y(cross_product(cross_product(u, v), u)), second(v)
    {
      x = x / std::sqrt(x.squared_length());
      y = y / std::sqrt(y.squared_length());
    }
    double angle(const Local_vector& d) const { return std::atan2(d * y, d * x); }
    double angle_of_second() const { return angle(second); }
    Local_vector x, y, second;
  };

  Point_index far_end(Point_index p, Growing_front::Edge_index e) const
  {
    const auto& ends = m_front.edge(e).ends;
    return ends[0] == p ? ends[1] : ends[0];
  }

  double angle(const Frame& frame, Point_index p, Point_index q) const
  {
    return frame.angle(m_points[q] - m_points[p]);
  }

  // The angle from `from` to `to`, counterclockwise, in [0, 2 pi).
  static double difference(double to, double from)
  {
    const double d = to - from;
    return d < 0. ? d + 2. * CGAL_PI : d;
  }

  // Whether the surface beside the edge is clockwise of it.
  bool is_left_of_surface(const Frame& frame, Point_index p, Growing_front::Edge_index e) const
  {
    const Local_vector d = m_points[far_end(p, e)] - m_points[p], o = m_points[m_front.edge(e).opposite] - m_points[p];
    return (d * frame.x) * (o * frame.y) < (d * frame.y) * (o * frame.x);
  }

  const std::vector<Local_point>& m_points;
  const Growing_front& m_front;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FRONT_GAPS_H

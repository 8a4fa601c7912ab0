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

#ifndef ISR_BENCHMARK_MEASURES_SELF_INTERSECTIONS_H
#define ISR_BENCHMARK_MEASURES_SELF_INTERSECTIONS_H

#include "../models/model_files.h"

#include <CGAL/box_intersection_d.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace isr_benchmark {

// Exact count of the pairs of triangles of a soup that meet in more than their common vertices and
// edges: the definition of Polygon_mesh_processing::self_intersections(), which needs a mesh, and
// making one of a soup that is not a manifold duplicates vertices and invents intersections.
class Self_intersection_counter
{
public:
  Self_intersection_counter(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
    : m_points(points), m_triangles(triangles)
  { }

  std::size_t operator()() const
  {
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
    std::vector<Box> boxes;
    for (std::size_t t = 0; t != m_triangles.size(); ++t)
      if (!CGAL::collinear(point(t, 0), point(t, 1), point(t, 2)))
        boxes.emplace_back(point(t, 0).bbox() + point(t, 1).bbox() + point(t, 2).bbox(), t);
    std::size_t count = 0;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      count += do_intersect(a.info(), b.info()) ? 1u : 0u;
    });
    return count;
  }

private:
  const Point& point(std::size_t t, std::size_t i) const { return m_points[m_triangles[t][i % 3]]; }
  Kernel::Triangle_3 triangle(std::size_t t) const { return Kernel::Triangle_3(point(t, 0), point(t, 1), point(t, 2)); }

  bool do_intersect(std::size_t s, std::size_t t) const
  {
    std::size_t shared = 0, i = 0, j = 0; // the last common vertex is corner i of s and corner j of t
    std::size_t sum_i = 0, sum_j = 0;
    for (std::size_t a = 0; a != 3; ++a)
      for (std::size_t b = 0; b != 3; ++b)
        if (m_triangles[s][a] == m_triangles[t][b]) {
          ++shared;
          i = a;
          j = b;
          sum_i += a;
          sum_j += b;
        }
    if (shared == 0)
      return CGAL::do_intersect(triangle(s), triangle(t));
    if (shared == 1)
      return CGAL::do_intersect(triangle(s), Kernel::Segment_3(point(t, j + 1), point(t, j + 2))) ||
             CGAL::do_intersect(triangle(t), Kernel::Segment_3(point(s, i + 1), point(s, i + 2)));
    if (shared == 2)
      return are_folded(s, 3 - sum_i, t, 3 - sum_j);
    return true; // the same triangle twice
  }

  // Whether two triangles with a common edge overlap; i and j are their other corners.
  bool are_folded(std::size_t s, std::size_t i, std::size_t t, std::size_t j) const
  {
    const Point& a = point(s, i + 1);
    const Point& b = point(s, i + 2);
    return CGAL::coplanar(a, b, point(s, i), point(t, j)) &&
           CGAL::coplanar_orientation(a, b, point(s, i), point(t, j)) == CGAL::POSITIVE;
  }

  const std::vector<Point>& m_points;
  const std::vector<Triangle>& m_triangles;
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MEASURES_SELF_INTERSECTIONS_H

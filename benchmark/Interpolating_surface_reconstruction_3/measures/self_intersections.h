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
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_intersection.h>

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
  const Point& point(std::size_t t, std::size_t i) const { return m_points[m_triangles[t][i]]; }

  bool do_intersect(std::size_t s, std::size_t t) const
  {
    namespace isr_internal = CGAL::Interpolating_surface_reconstruction_3::internal;
    return isr_internal::do_triangles_cross(m_triangles[s], m_triangles[t],
                                            [this](std::size_t v) { return m_points[v]; });
  }

  const std::vector<Point>& m_points;
  const std::vector<Triangle>& m_triangles;
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MEASURES_SELF_INTERSECTIONS_H

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

#ifndef ISR_BENCHMARK_MEASURES_MESH_DISTANCE_H
#define ISR_BENCHMARK_MEASURES_MESH_DISTANCE_H

#include "../models/model_files.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <cmath>
#include <limits>
#include <vector>

namespace isr_benchmark {

// Distance of a point to a triangle mesh.
class Mesh_distance
{
public:
  Mesh_distance(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
  {
    for (const Triangle& t : triangles)
      if (!CGAL::collinear(points[t[0]], points[t[1]], points[t[2]]))
        m_triangles.emplace_back(points[t[0]], points[t[1]], points[t[2]]);
    m_tree.insert(m_triangles.begin(), m_triangles.end());
    m_tree.build();
    if (!m_triangles.empty())
      m_tree.accelerate_distance_queries();
  }

  Mesh_distance(const Mesh_distance&) = delete; // the tree refers to the triangles
  Mesh_distance& operator=(const Mesh_distance&) = delete;

  double operator()(const Point& p) const
  {
    return m_triangles.empty() ? std::numeric_limits<double>::infinity() : std::sqrt(m_tree.squared_distance(p));
  }

private:
  using Iterator = std::vector<Kernel::Triangle_3>::const_iterator;
#if CGAL_VERSION_NR >= 1060000000
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, CGAL::AABB_triangle_primitive_3<Kernel, Iterator> > >;
#else
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Iterator> > >;
#endif

  std::vector<Kernel::Triangle_3> m_triangles;
  Tree m_tree;
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MEASURES_MESH_DISTANCE_H

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

#ifndef ISR_BENCHMARK_MODELS_POLYHEDRON_H
#define ISR_BENCHMARK_MODELS_POLYHEDRON_H

#include "Surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace isr_benchmark {

// Disjoint convex solids, each with planar faces and sharp edges.
class Polyhedron : public Surface
{
public:
  double distance(const Point& p) const override
  {
    double result = std::numeric_limits<double>::infinity();
    for (const auto& t : m_triangles)
      result = (std::min)(result, CGAL::squared_distance(p, t));
    return std::sqrt(result);
  }

  std::vector<Point> random_points(std::size_t n, CGAL::Random& random) const override
  {
    std::vector<Point> points;
    while (points.size() != n) {
      double rest = random.get_double(0., m_area);
      std::size_t t = 0;
      for (; t + 1 != m_triangles.size() && rest > area(m_triangles[t]); ++t)
        rest -= area(m_triangles[t]);
      double u = random.get_double(), v = random.get_double();
      if (u + v > 1.) {
        u = 1. - u;
        v = 1. - v;
      }
      const Point& p = m_triangles[t].vertex(0);
      points.push_back(p + u * (m_triangles[t].vertex(1) - p) + v * (m_triangles[t].vertex(2) - p));
    }
    return points;
  }

  double area() const override { return m_area; }
  std::size_t components() const override { return m_solids; }
  long euler_characteristic() const override { return 2 * static_cast<long>(m_solids); }

  std::vector<Point> feature_points(double spacing) const override
  {
    std::vector<Point> points;
    for (const auto& edge : m_edges) {
      const Vector v = edge.second - edge.first;
      const int parts = (std::max)(1, static_cast<int>(std::lround(std::sqrt(v.squared_length()) / spacing)));
      for (int i = 0; i <= parts; ++i)
        points.push_back(i == parts ? edge.second : edge.first + (double(i) / parts) * v);
    }
    return points;
  }

  // The prism between a convex polygon at height z0 and the same polygon at height z1.
  void add_prism(const std::vector<std::array<double, 2> >& polygon, double z0, double z1)
  {
    const std::size_t n = polygon.size();
    const auto at = [&](std::size_t i, double z) { return Point(polygon[i % n][0], polygon[i % n][1], z); };
    for (std::size_t i = 2; i < n; ++i) {
      add(at(0, z0), at(i, z0), at(i - 1, z0));
      add(at(0, z1), at(i - 1, z1), at(i, z1));
    }
    for (std::size_t i = 0; i != n; ++i) {
      add(at(i, z0), at(i + 1, z0), at(i + 1, z1));
      add(at(i, z0), at(i + 1, z1), at(i, z1));
      m_edges.emplace_back(at(i, z0), at(i + 1, z0));
      m_edges.emplace_back(at(i, z1), at(i + 1, z1));
      m_edges.emplace_back(at(i, z0), at(i, z1));
    }
    ++m_solids;
  }

  void add_box(const Point& p, const Point& q)
  {
    add_prism({ { p.x(), p.y() }, { q.x(), p.y() }, { q.x(), q.y() }, { p.x(), q.y() } }, p.z(), q.z());
  }

private:
  void add(const Point& p, const Point& q, const Point& r)
  {
    m_triangles.emplace_back(p, q, r);
    m_area += area(m_triangles.back());
  }

  static double area(const Kernel::Triangle_3& t) { return std::sqrt(t.squared_area()); }

  std::vector<Kernel::Triangle_3> m_triangles;
  std::vector<std::pair<Point, Point> > m_edges;
  double m_area = 0.;
  std::size_t m_solids = 0;
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MODELS_POLYHEDRON_H

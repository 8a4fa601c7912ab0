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

#ifndef ISR_BENCHMARK_MODELS_SAMPLING_H
#define ISR_BENCHMARK_MODELS_SAMPLING_H

#include "Surface.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace isr_benchmark {

// Keeps points at least `distance` from all points kept before.
class Dart_board
{
public:
  explicit Dart_board(double distance) : m_distance(distance) { }

  bool throw_dart(const Point& p)
  {
    const std::array<long, 3> c = { cell(p.x()), cell(p.y()), cell(p.z()) };
    for (long i = c[0] - 1; i <= c[0] + 1; ++i)
      for (long j = c[1] - 1; j <= c[1] + 1; ++j)
        for (long k = c[2] - 1; k <= c[2] + 1; ++k) {
          const auto found = m_cells.find(hash(i, j, k));
          if (found == m_cells.end())
            continue;
          for (std::size_t q : found->second)
            if (CGAL::squared_distance(p, m_points[q]) < m_distance * m_distance)
              return false;
        }
    m_cells[hash(c[0], c[1], c[2])].push_back(m_points.size());
    m_points.push_back(p);
    return true;
  }

  const std::vector<Point>& points() const { return m_points; }

private:
  long cell(double x) const { return static_cast<long>(std::floor(x / m_distance)); }

  // Cells with the same hash share a list, which costs time only.
  static std::size_t hash(long i, long j, long k)
  {
    return static_cast<std::size_t>(i) * 73856093u ^ static_cast<std::size_t>(j) * 19349663u ^
           static_cast<std::size_t>(k) * 83492791u;
  }

  double m_distance;
  std::vector<Point> m_points;
  std::unordered_map<std::size_t, std::vector<std::size_t> > m_cells;
};

// About n points of the surface in random order, even but irregular: none nearer than 3/4 of the
// square root of the area per point, and hardly any gap that would admit one more.
inline std::vector<Point> sample(const Surface& surface, std::size_t n, unsigned int seed)
{
  CGAL::Random random(seed);
  const double spacing = std::sqrt(surface.area() / double(n));
  Dart_board board(0.75 * spacing);
  for (const Point& p : surface.feature_points(spacing))
    board.throw_dart(p);
  for (std::size_t round = 0; round != 20; ++round)
    for (const Point& p : surface.random_points(n, random))
      board.throw_dart(p);
  std::vector<Point> points = board.points();
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1], points[static_cast<std::size_t>(random.get_int(0, static_cast<int>(i)))]);
  return points;
}

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MODELS_SAMPLING_H

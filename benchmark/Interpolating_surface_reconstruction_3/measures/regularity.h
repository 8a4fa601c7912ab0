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

#ifndef ISR_BENCHMARK_MEASURES_REGULARITY_H
#define ISR_BENCHMARK_MEASURES_REGULARITY_H

#include "../models/model_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace isr_benchmark {

// Regularity of triangles, the sum of the cosines of their angles (Eq. 3.1 of the thesis): 1 for a
// triangle without area, 1.5 for an equilateral one. The bins divide that interval evenly.
struct Regularity
{
  double mean = 0.;
  std::array<std::size_t, 10> histogram = {};
};

inline double regularity_of(const Point& p, const Point& q, const Point& r)
{
  const double a = CGAL::squared_distance(q, r), b = CGAL::squared_distance(r, p), c = CGAL::squared_distance(p, q);
  if (a == 0. || b == 0. || c == 0.)
    return 1.;
  return 0.5 * ((b + c - a) / std::sqrt(b * c) + (c + a - b) / std::sqrt(c * a) + (a + b - c) / std::sqrt(a * b));
}

inline Regularity measure_regularity(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  Regularity result;
  for (const Triangle& t : triangles) {
    const double r = (std::min)((std::max)(regularity_of(points[t[0]], points[t[1]], points[t[2]]), 1.), 1.5);
    result.mean += r / double(triangles.size());
    ++result.histogram[(std::min)(std::size_t(9), static_cast<std::size_t>((r - 1.) * 20.))];
  }
  return result;
}

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MEASURES_REGULARITY_H

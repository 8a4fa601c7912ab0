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

#ifndef ISR_TEST_HOSTILE_UTILS_H
#define ISR_TEST_HOSTILE_UTILS_H

#include "isr_test_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace isr_test {

// Inputs made to break a reconstruction. A generator makes about n points, the same ones for the same
// n and seed; n serves to measure how time and memory grow.
struct Hostile_generator
{
  std::string name;
  Points (*generate)(std::size_t n, std::uint64_t seed);
};

namespace hostile {

inline std::size_t root(double n, double degree)
{
  return (std::max)(std::size_t(2), std::size_t(std::lround(std::pow(n, 1. / degree))));
}

// Number of cells along the side of a box whose surface has about n points.
inline std::size_t box_side(std::size_t n) { return root(double(n) / 6., 2.); }

inline std::size_t sheet_side(std::size_t n) { return root(double(n), 2.) - 1; }

inline Points lattice(std::size_t n)
{
  const std::size_t m = root(double(n), 3.);
  Points points;
  for (std::size_t i = 0; i != m * m * m; ++i)
    points.emplace_back(double(i % m), double(i / m % m), double(i / m / m));
  return points;
}

// The spacing of n points on a unit sphere.
inline double sphere_spacing(std::size_t n) { return std::sqrt(4. * PI / double(n)); }

// A coordinate moved by up to `ulps` floating-point numbers.
inline double nudged(double c, Random& random, std::size_t ulps)
{
  const std::size_t steps = random.below(2 * ulps + 1);
  const double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i != steps / 2; ++i)
    c = std::nextafter(c, steps % 2 == 0 ? infinity : -infinity);
  return c;
}

inline Points nudged(Points points, std::uint64_t seed, std::size_t ulps)
{
  Random random(seed);
  for (Point& p : points) {
    const double x = nudged(p.x(), random, ulps), y = nudged(p.y(), random, ulps), z = nudged(p.z(), random, ulps);
    p = Point(x, y, z);
  }
  return points;
}

inline Points joined(Points points, const Points& more)
{
  append(points, more);
  return points;
}

} // namespace hostile
} // namespace isr_test

#endif // ISR_TEST_HOSTILE_UTILS_H

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

// Fractals, lattices, clusters and crossings.

#ifndef ISR_TEST_HOSTILE_STRUCTURES_H
#define ISR_TEST_HOSTILE_STRUCTURES_H

#include "isr_test_hostile_utils.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isr_test {
namespace hostile {

// ---- regular positions ---------------------------------------------------------------------------

// Every point has twelve nearest neighbors at the same distance.
inline Points close_packing(std::size_t n, std::uint64_t)
{
  Points points;
  for (const Point& p : lattice(2 * n))
    if (std::lround(p.x() + p.y() + p.z()) % 2 == 0)
      points.push_back(p);
  return points;
}

inline Points lattices_interleaved(std::size_t n, std::uint64_t)
{
  const Points one = lattice(n / 2);
  return joined(one, translated(one, Vector(.5, .5, .25)));
}

inline Points lattice_anisotropic(std::size_t n, std::uint64_t)
{
  Points points = lattice(n);
  for (Point& p : points)
    p = Point(p.x(), 1e-3 * p.y(), 1e-6 * p.z());
  return points;
}

// Many planes at a third of the spacing.
inline Points layers(std::size_t n, std::uint64_t seed)
{
  constexpr std::size_t LAYERS = 12;
  Points points;
  for (std::size_t i = 0; i != LAYERS; ++i)
    append(points, translated(plane_random(n / LAYERS, seed + i).points,
                              Vector(0, 0, double(i) / std::sqrt(double(n / LAYERS)) / 3.)));
  return points;
}

inline Points sheet_rotated_nudged(std::size_t n, std::uint64_t seed)
{
  return nudged(rotated(plane_random(n, seed).points, .3), seed, 1);
}

inline Points circles_concentric(std::size_t n, std::uint64_t)
{
  const std::size_t m = root(double(n), 2.);
  Points points(1, Point(0, 0, 0));
  for (std::size_t i = 1; i <= m; ++i)
    for (std::size_t j = 0; j != m; ++j)
      points.push_back(on_circle(2. * PI * double(j) / double(m), double(i) / double(m), 0.));
  return points;
}

// Integer points, far from the tip with steps that grow upwards only.
inline Points paraboloid(std::size_t n, std::uint64_t)
{
  const double m = double(root(double(n), 2.) / 2);
  Points points;
  for (double x = -m; x <= m; ++x)
    for (double y = -m; y <= m; ++y)
      points.emplace_back(x, y, x * x + y * y);
  return points;
}

inline Points sphere_nudged(std::size_t n, std::uint64_t seed) { return nudged(sphere_fibonacci(n).points, seed, 2); }

// ---- components ----------------------------------------------------------------------------------

inline Points spheres_nested(std::size_t n, std::uint64_t seed)
{
  constexpr std::size_t SPHERES = 8;
  Points points;
  for (std::size_t i = 1; i <= SPHERES; ++i)
    append(points, scaled(sphere_random(n / SPHERES, seed + i).points, double(i)));
  return points;
}

// Each touches six others in points of its own.
inline Points spheres_tangent(std::size_t n, std::uint64_t seed)
{
  constexpr std::size_t SPHERES = 27;
  Points sphere = sphere_random(n / SPHERES, seed).points;
  append(sphere, { Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1) });
  Points points;
  for (const Point& p : lattice(SPHERES))
    append(points, translated(sphere, 2. * (p - CGAL::ORIGIN)));
  return points;
}

// Very many components of four to twelve points.
inline Points specks(std::size_t n, std::uint64_t seed)
{
  Random random(seed);
  Points points;
  while (points.size() < n) {
    const Vector center(random.uniform(), random.uniform(), random.uniform());
    for (std::size_t i = 4 + random.below(9); i != 0; --i)
      points.push_back(CGAL::ORIGIN + center + .1 / std::cbrt(double(n)) * random.unit());
  }
  return points;
}

inline Points cluster_dense(std::size_t n, std::uint64_t seed)
{
  return joined(scaled(random_cube(n / 2, seed), 1e-6), random_cube(n / 2, seed + 1));
}

// ---- crossings -----------------------------------------------------------------------------------

// Seven pages with a common edge.
inline Points book(std::size_t n, std::uint64_t)
{
  constexpr std::size_t PAGES = 7;
  const std::size_t m = root(double(n) / double(PAGES), 2.);
  Points points;
  for (std::size_t page = 0; page != PAGES; ++page)
    for (std::size_t i = page == 0 ? 0 : 1; i <= m; ++i)
      for (std::size_t j = 0; j <= m; ++j)
        points.push_back(on_circle(2. * PI * double(page) / double(PAGES), double(i), double(j)));
  return points;
}

inline Points lines_crossing(std::size_t n, std::uint64_t seed)
{
  constexpr std::size_t LINES = 10;
  Random random(seed);
  Points points(1, Point(0, 0, 0));
  for (std::size_t i = 0; i != LINES; ++i) {
    const Vector direction = random.unit();
    for (std::size_t j = 0; j != n / LINES; ++j)
      points.push_back(CGAL::ORIGIN + (double(j) - double(n / LINES) / 2.) * direction);
  }
  return points;
}

// Near the center nothing but scales, far away a long way from ray to ray.
inline Points rays_growing(std::size_t n, std::uint64_t seed)
{
  const std::size_t rays = root(double(n), 2.);
  Random random(seed);
  Points points;
  for (std::size_t i = 0; i != rays; ++i) {
    const Vector direction = random.unit();
    for (std::size_t j = 0; j != rays; ++j)
      points.push_back(CGAL::ORIGIN + std::pow(10., 12. * double(j) / double(rays)) * direction);
  }
  return points;
}

// ---- fractals and curves -------------------------------------------------------------------------

// The images of a point by all words of maps to one of the `corners`, until there are n.
inline Points attractor(const Points& corners, double ratio, std::size_t n)
{
  Points points(1, Point(0, 0, 0));
  while (points.size() < n) {
    Points next;
    for (const Point& corner : corners)
      append(next, translated(scaled(points, ratio), (1. - ratio) * (corner - CGAL::ORIGIN)));
    points = next;
  }
  return points;
}

inline Points cantor_dust(std::size_t n, std::uint64_t) { return attractor(lattice(8), 1. / 3., n); }

inline Points sierpinski(std::size_t n, std::uint64_t)
{
  return attractor({ Point(0, 0, 0), Point(1, 1, 0), Point(1, 0, 1), Point(0, 1, 1) }, .5, n);
}

inline Points spiral(std::size_t n, std::uint64_t)
{
  Points points;
  for (std::size_t i = 0; i != n; ++i) {
    const double radius = std::exp(-20. * double(i) / double(n));
    points.push_back(on_circle(.1 * double(i), radius, radius));
  }
  return points;
}

// A flat sheet without rows.
inline Points sunflower(std::size_t n, std::uint64_t)
{
  Points points;
  for (std::size_t i = 0; i != n; ++i)
    points.push_back(on_circle(PI * (3. - std::sqrt(5.)) * double(i), std::sqrt(double(i)), 0.));
  return points;
}

// All its circles meet in one point.
inline Points horn_torus(std::size_t n, std::uint64_t)
{
  const std::size_t m = root(double(n), 2.);
  Points points;
  for (std::size_t i = 0; i != m; ++i)
    for (std::size_t j = 0; j != m; ++j) {
      const double angle = 2. * PI * double(j) / double(m);
      points.push_back(on_circle(2. * PI * double(i) / double(m), 1. - std::cos(angle), std::sin(angle)));
    }
  return points;
}

// Thin fingers side by side.
inline Points comb(std::size_t n, std::uint64_t)
{
  constexpr std::size_t FINGERS = 10;
  const std::size_t m = (std::max)(std::size_t(2), n / FINGERS / 4);
  Points points;
  for (std::size_t finger = 0; finger != FINGERS; ++finger)
    for (std::size_t i = 0; i != m; ++i)
      for (std::size_t corner = 0; corner != 4; ++corner)
        points.emplace_back(1.7 * double(finger) + double(corner % 2), double(corner / 2), double(i));
  return points;
}

// ---- magnitude -----------------------------------------------------------------------------------

inline Points range_both_ends(std::size_t n, std::uint64_t seed)
{
  constexpr std::array<double, 5> MAGNITUDES = { { 1e308, 1e-308, 1., 0., 5e-324 } };
  Random random(seed);
  Points points;
  while (points.size() < n) {
    double c[3];
    for (double& value : c)
      value = MAGNITUDES[random.below(MAGNITUDES.size())] * std::round(random.uniform(-1.4, 1.4));
    if (random.below(2) == 0)
      c[random.below(3)] *= random.uniform();
    points.emplace_back(c[0], c[1], c[2]);
  }
  return points;
}

inline Points powers_of_two(std::size_t n, std::uint64_t seed)
{
  Random random(seed);
  const auto power = [&] { return std::ldexp(random.below(2) == 0 ? 1. : -1., int(random.below(60)) - 30); };
  Points points;
  while (points.size() < n) {
    const double x = power(), y = power(), z = power();
    points.emplace_back(x, y, z);
  }
  return points;
}

} // namespace hostile
} // namespace isr_test

#endif // ISR_TEST_HOSTILE_STRUCTURES_H

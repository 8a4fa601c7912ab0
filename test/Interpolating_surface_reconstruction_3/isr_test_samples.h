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

#ifndef ISR_TEST_SAMPLES_H
#define ISR_TEST_SAMPLES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace isr_test {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Points = std::vector<Point>;

constexpr double PI = 3.14159265358979323846;

// ---- random numbers that are the same with every standard library --------------------------------

class Random
{
public:
  explicit Random(std::uint64_t seed) : m_engine(seed) { }

  double uniform(double low = 0., double high = 1.)
  {
    return low + (high - low) * (double(m_engine() >> 11) * 0x1p-53);
  }

  std::size_t below(std::size_t n) { return std::size_t(m_engine() % n); }

  Vector in_cube(double half) { return Vector(uniform(-half, half), uniform(-half, half), uniform(-half, half)); }

  Vector unit()
  {
    while (true) {
      const Vector v = in_cube(1.);
      if (v.squared_length() > 1e-4 && v.squared_length() <= 1.)
        return v / std::sqrt(v.squared_length());
    }
  }

private:
  std::mt19937_64 m_engine;
};

// ---- samples of surfaces of known topology -------------------------------------------------------

struct Sample
{
  std::string name;
  Points points;
  long euler; // of the surface that the points were taken from
  std::size_t components;
  std::size_t boundary_loops;
};

inline Point on_circle(double angle, double radius, double z)
{
  return Point(radius * std::cos(angle), radius * std::sin(angle), z);
}

inline Sample sphere_fibonacci(std::size_t n)
{
  Sample s{ "fibonacci sphere", {}, 2, 1, 0 };
  const double golden_angle = PI * (3. - std::sqrt(5.));
  for (std::size_t i = 0; i != n; ++i) {
    const double z = 1. - (2. * double(i) + 1.) / double(n);
    s.points.push_back(on_circle(golden_angle * double(i), std::sqrt(1. - z * z), z));
  }
  return s;
}

// Without what is above `height`.
inline Sample sphere_with_opening(std::size_t n, double height)
{
  Sample s = sphere_fibonacci(n);
  s.points.erase(std::remove_if(s.points.begin(), s.points.end(), [&](const Point& p) { return p.z() > height; }),
                 s.points.end());
  s.name = "sphere up to " + std::to_string(height);
  s.euler = 1;
  s.boundary_loops = 1;
  return s;
}

inline Sample sphere_random(std::size_t n, std::uint64_t seed)
{
  Sample s{ "random sphere, seed " + std::to_string(seed), {}, 2, 1, 0 };
  Random random(seed);
  for (std::size_t i = 0; i != n; ++i)
    s.points.push_back(CGAL::ORIGIN + random.unit());
  return s;
}

// Meridians and parallels: points crowd at the poles, and all quads are cocircular.
inline Sample sphere_uv(std::size_t meridians, std::size_t parallels)
{
  Sample s{ "UV sphere", { Point(0, 0, 1), Point(0, 0, -1) }, 2, 1, 0 };
  for (std::size_t j = 1; j != parallels; ++j)
    for (std::size_t i = 0; i != meridians; ++i) {
      const double polar = PI * double(j) / double(parallels);
      s.points.push_back(on_circle(2. * PI * double(i) / double(meridians), std::sin(polar), std::cos(polar)));
    }
  return s;
}

// `jitter` is in units of the spacing; 0 gives cocircular quads.
inline Sample torus(std::size_t rings, std::size_t ring_size, double jitter, std::uint64_t seed)
{
  Sample s{ "torus, jitter " + std::to_string(jitter), {}, 0, 1, 0 };
  Random random(seed);
  for (std::size_t i = 0; i != rings; ++i)
    for (std::size_t j = 0; j != ring_size; ++j) {
      const double u = 2. * PI * (double(i) + random.uniform(-jitter, jitter)) / double(rings);
      const double v = 2. * PI * (double(j) + random.uniform(-jitter, jitter)) / double(ring_size);
      s.points.push_back(on_circle(u, 1. + .4 * std::cos(v), .4 * std::sin(v)));
    }
  return s;
}

// Rows around the tube of the torus, each turned at random: their points are much closer than the rows.
inline Sample torus_in_rows(std::size_t rows, std::size_t row_size, std::uint64_t seed)
{
  Sample s{ "torus in " + std::to_string(rows) + " rows of " + std::to_string(row_size), {}, 0, 1, 0 };
  Random random(seed);
  for (std::size_t i = 0; i != rows; ++i) {
    const double first = random.uniform(0., 2. * PI);
    for (std::size_t j = 0; j != row_size; ++j) {
      const double v = first + 2. * PI * double(j) / double(row_size);
      s.points.push_back(on_circle(2. * PI * double(i) / double(rows), 1. + .4 * std::cos(v), .4 * std::sin(v)));
    }
  }
  return s;
}

// Hills as a scanner sees them that turns around a vertical axis at height 2: rows of `row_size` points from distance 4
// on that are the farther from each other the farther away they are.
inline Sample hills_in_rows(std::size_t rows, std::size_t row_size, std::uint64_t seed)
{
  Sample s{ "hills in " + std::to_string(rows) + " rows of " + std::to_string(row_size), {}, 0, 1, 2 };
  Random random(seed);
  for (std::size_t i = 0; i != rows; ++i) {
    const double distance = 2. / (.5 - .45 * double(i) / double(rows - 1)), first = random.uniform(0., 2. * PI);
    for (std::size_t j = 0; j != row_size; ++j) {
      const Point p = on_circle(first + 2. * PI * double(j) / double(row_size), distance, 0.);
      s.points.emplace_back(p.x(), p.y(), std::sin(.25 * p.x()) * std::cos(.2 * p.y()));
    }
  }
  return s;
}

// A tube around a trefoil knot.
inline Sample knot(std::size_t rings, std::size_t ring_size)
{
  Sample s{ "knot", {}, 0, 1, 0 };
  const auto axis = [](double t) {
    return Point(std::sin(t) + 2. * std::sin(2. * t), std::cos(t) - 2. * std::cos(2. * t), -std::sin(3. * t));
  };
  for (std::size_t i = 0; i != rings; ++i) {
    const double t = 2. * PI * double(i) / double(rings);
    const Vector tangent = axis(t + 1e-4) - axis(t - 1e-4);
    Vector u = CGAL::cross_product(tangent, Vector(0, 0, 1));
    u = u / std::sqrt(u.squared_length());
    Vector v = CGAL::cross_product(tangent, u);
    v = v / std::sqrt(v.squared_length());
    for (std::size_t j = 0; j != ring_size; ++j) {
      const double a = 2. * PI * (double(j) + .5 * double(i % 2)) / double(ring_size);
      s.points.push_back(axis(t) + .35 * (std::cos(a) * u + std::sin(a) * v));
    }
  }
  return s;
}

// Darts on an implicit surface of genus 2, no two closer than `spacing`.
inline Sample double_torus(double spacing, std::uint64_t seed)
{
  Sample s{ "double torus, seed " + std::to_string(seed), {}, -2, 1, 0 };
  const auto f = [](const Point& p) {
    const double a = p.x() * (p.x() - 1) * (p.x() - 1) * (p.x() - 2) + p.y() * p.y();
    return a * a + p.z() * p.z() - .01;
  };
  const auto gradient = [&](const Point& p) {
    const double h = 1e-6;
    return Vector(f(p + Vector(h, 0, 0)) - f(p - Vector(h, 0, 0)), f(p + Vector(0, h, 0)) - f(p - Vector(0, h, 0)),
                  f(p + Vector(0, 0, h)) - f(p - Vector(0, 0, h))) /
           (2. * h);
  };
  std::map<std::array<long, 3>, Points> grid;
  const auto cell = [&](const Point& p, std::size_t neighbor) {
    return std::array<long, 3>{ std::lround(std::floor(p.x() / spacing)) + long(neighbor % 3) - 1,
                                std::lround(std::floor(p.y() / spacing)) + long(neighbor / 3 % 3) - 1,
                                std::lround(std::floor(p.z() / spacing)) + long(neighbor / 9) - 1 };
  };
  constexpr std::size_t CENTER = 13, CELLS = 27, MISSES = 20000;
  Random random(seed);
  for (std::size_t misses = 0; misses != MISSES;) {
    Point p(random.uniform(-.1, 2.1), random.uniform(-.7, .7), random.uniform(-.15, .15));
    for (int step = 0; step != 30; ++step) {
      const Vector g = gradient(p);
      p = p - g * (f(p) / (g.squared_length() + 1e-9));
    }
    bool is_free = std::abs(f(p)) < 1e-9;
    for (std::size_t c = 0; c != CELLS && is_free; ++c)
      for (const Point& q : grid[cell(p, c)])
        is_free = is_free && CGAL::squared_distance(p, q) >= spacing * spacing;
    if (!is_free) {
      ++misses;
      continue;
    }
    grid[cell(p, CENTER)].push_back(p);
    s.points.push_back(p);
    misses = 0;
  }
  return s;
}

// The surface points of a lattice of nx x ny x nz cells of size 1, without those inside.
inline Sample box(std::size_t nx, std::size_t ny, std::size_t nz)
{
  Sample s{ "box", {}, 2, 1, 0 };
  for (std::size_t i = 0; i <= nx; ++i)
    for (std::size_t j = 0; j <= ny; ++j)
      for (std::size_t k = 0; k <= nz; ++k)
        if (i % nx == 0 || j % ny == 0 || k % nz == 0)
          s.points.emplace_back(double(i), double(j), double(k));
  return s;
}

// The points of a box moved by up to `jitter` within their face or edge; corners stay.
inline Sample box_jittered(std::size_t n, double jitter, std::uint64_t seed)
{
  Sample s = box(n, n, n);
  s.name = "jittered box, seed " + std::to_string(seed);
  Random random(seed);
  const auto moved = [&](double c) {
    const double by = random.uniform(-jitter, jitter);
    return c == 0. || c == double(n) ? c : c + by;
  };
  for (Point& p : s.points) {
    const double x = moved(p.x()), y = moved(p.y()), z = moved(p.z());
    p = Point(x, y, z);
  }
  return s;
}

// A box whose spacing grows geometrically along each edge, 70 times from end to end.
inline Sample box_varying_spacing(std::size_t n)
{
  Sample s = box(n, n, n);
  s.name = "box, spacing varying 70 times";
  const double ratio = std::pow(70., 1. / double(n - 1));
  const auto stretched = [&](double c) { return (std::pow(ratio, c) - 1.) / (ratio - 1.); };
  for (Point& p : s.points)
    p = Point(stretched(p.x()), stretched(p.y()), stretched(p.z()));
  return s;
}

inline Points translated(Points points, const Vector& by)
{
  for (Point& p : points)
    p = p + by;
  return points;
}

inline void append(Points& points, const Points& more) { points.insert(points.end(), more.begin(), more.end()); }

// `gap` in spacings.
inline Sample two_boxes(std::size_t n, double gap)
{
  Sample s = box(n, n, n);
  append(s.points, translated(s.points, Vector(double(n) + gap, 0, 0)));
  return Sample{ "two boxes, gap " + std::to_string(gap), s.points, 4, 2, 0 };
}

inline Sample plane_grid(std::size_t n)
{
  Sample s{ "plane grid", {}, 1, 1, 1 };
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      s.points.emplace_back(double(i), double(j), 0.);
  return s;
}

inline Sample plane_random(std::size_t n, std::uint64_t seed)
{
  Sample s{ "random planar points, seed " + std::to_string(seed), {}, 1, 1, 1 };
  Random random(seed);
  for (std::size_t i = 0; i != n; ++i) {
    const double x = random.uniform(), y = random.uniform();
    s.points.emplace_back(x, y, .25);
  }
  return s;
}

// `gap` in spacings.
inline Sample two_plates(std::size_t n, double gap)
{
  Sample s = plane_grid(n);
  append(s.points, translated(s.points, Vector(0, 0, gap)));
  return Sample{ "two plates, gap " + std::to_string(gap), s.points, 2, 2, 2 };
}

inline Sample cylinder_open(std::size_t rings, std::size_t ring_size)
{
  Sample s{ "open cylinder", {}, 0, 1, 2 };
  const double step = 2. * PI / double(ring_size);
  for (std::size_t i = 0; i != rings; ++i)
    for (std::size_t j = 0; j != ring_size; ++j)
      s.points.push_back(on_circle(step * (double(j) + .5 * double(i % 2)), 1., step * double(i)));
  return s;
}

// A cone with its base disc; the tip is a sample.
inline Sample cone(std::size_t rings, double height)
{
  Sample s{ "cone, height " + std::to_string(height), { Point(0, 0, height), Point(0, 0, 0) }, 2, 1, 0 };
  for (std::size_t i = 1; i <= rings; ++i) {
    const double r = double(i) / double(rings);
    for (std::size_t j = 0; j != 6 * i; ++j) {
      const double a = 2. * PI * double(j) / double(6 * i);
      s.points.push_back(on_circle(a, r, height * (1. - r)));
      if (i != rings)
        s.points.push_back(on_circle(a, r, 0.));
    }
  }
  return s;
}

// A box whose top is tilted down to one edge at the bottom.
inline Sample wedge(std::size_t n, double thickness)
{
  Sample s{ "wedge, thickness " + std::to_string(thickness), {}, 2, 1, 0 };
  const std::size_t layers = (std::max)(std::size_t(1), std::size_t(std::lround(thickness * double(n))));
  for (const Point& p : box(n, n, layers).points) {
    const double x = p.x() / double(n);
    if (p.x() != 0. || p.z() == 0.)
      s.points.emplace_back(x, p.y() / double(n), thickness * x * p.z() / double(layers));
  }
  return s;
}

inline Points moebius_strip(std::size_t around, std::size_t across)
{
  Points points;
  for (std::size_t i = 0; i != around; ++i)
    for (std::size_t j = 0; j <= across; ++j) {
      const double u = 2. * PI * double(i) / double(around), v = .6 * (double(j) / double(across) - .5);
      points.push_back(on_circle(u, 1. + v * std::cos(u / 2), v * std::sin(u / 2)));
    }
  return points;
}

// The figure-eight immersion; it crosses itself along a circle.
inline Points klein_bottle(std::size_t around, std::size_t across)
{
  Points points;
  for (std::size_t i = 0; i != around; ++i)
    for (std::size_t j = 0; j != across; ++j) {
      const double u = 2. * PI * double(i) / double(around), v = 2. * PI * double(j) / double(across);
      const double a = std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
      const double b = std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v);
      points.push_back(on_circle(u, 1. + .4 * a, .4 * b));
    }
  return points;
}

// ---- changes to points ---------------------------------------------------------------------------

inline Points with_noise(Points points, double half, std::uint64_t seed)
{
  Random random(seed);
  for (Point& p : points)
    p = p + random.in_cube(half);
  return points;
}

inline Points random_cube(std::size_t n, std::uint64_t seed) { return with_noise(Points(n, Point(0, 0, 0)), 1., seed); }

inline Points with_outliers(Points points, std::size_t n, std::uint64_t seed)
{
  append(points, random_cube(n, seed));
  return points;
}

inline Points repeated(const Points& points, std::size_t times)
{
  Points result;
  for (std::size_t i = 0; i != times; ++i)
    append(result, points);
  return result;
}

inline Points scaled(Points points, double by)
{
  for (Point& p : points)
    p = Point(p.x() * by, p.y() * by, p.z() * by);
  return points;
}

// Around an axis that no coordinate axis is close to.
inline Points rotated(Points points, double angle)
{
  const Vector axis = Vector(1, 2, 3) / std::sqrt(14.);
  for (Point& p : points) {
    const Vector v = p - CGAL::ORIGIN;
    p = CGAL::ORIGIN + std::cos(angle) * v + std::sin(angle) * CGAL::cross_product(axis, v) +
        (1. - std::cos(angle)) * (axis * v) * axis;
  }
  return points;
}

// The corners of a prism with regular faces.
inline Sample prism(std::size_t sides, double height)
{
  Sample s{ "prism with " + std::to_string(sides) + " sides, height " + std::to_string(height), {}, 2, 1, 0 };
  for (double z : { 0., height })
    for (std::size_t i = 0; i != sides; ++i)
      s.points.push_back(on_circle(2. * CGAL_PI * double(i) / double(sides), 1., z));
  return s;
}

inline Sample tetrahedron_random(std::uint64_t seed)
{
  return Sample{ "random tetrahedron, seed " + std::to_string(seed), random_cube(4, seed), 2, 1, 0 };
}

// Convex solids that have points at their corners only, also in general orientation.
inline std::vector<Sample> solids_of_few_points()
{
  std::vector<Sample> result;
  for (const Point& size : { Point(1, 1, 1), Point(1, 2, 3), Point(1, 1, 5), Point(5, 5, 1) }) {
    Sample s = box(1, 1, 1);
    s.name += " with 8 points, height " + std::to_string(size.z()) + ", width " + std::to_string(size.y());
    for (Point& p : s.points)
      p = Point(p.x() * size.x(), p.y() * size.y(), p.z() * size.z());
    result.push_back(s);
  }
  for (std::size_t sides = 3; sides != 8; ++sides)
    for (double height : { .5, 1., 3. })
      result.push_back(prism(sides, height));
  for (std::size_t i = 0, n = result.size(); i != n; ++i) {
    Sample s = result[i];
    s.name += ", rotated";
    s.points = rotated(s.points, .7);
    result.push_back(s);
  }
  for (std::uint64_t seed = 1; seed != 21; ++seed)
    result.push_back(tetrahedron_random(seed));
  return result;
}

// The corners of a plate, and the rims of a bore in its middle, of n points each.
inline Points plate_with_bore(std::size_t n)
{
  Points points;
  for (double z : { 0., .8 }) {
    for (double x : { -3., 3. })
      for (double y : { -3., 3. })
        points.emplace_back(x, y, z);
    for (std::size_t i = 0; i != n; ++i)
      points.push_back(on_circle(2. * PI * double(i) / double(n), 1., z));
  }
  return points;
}

// order[i] is the old position of the new i-th point.
inline std::vector<std::size_t> random_order(std::size_t n, std::uint64_t seed)
{
  Random random(seed);
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t i = n; i > 1; --i)
    std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

inline Points permuted(const Points& points, const std::vector<std::size_t>& order)
{
  Points result;
  for (std::size_t i : order)
    result.push_back(points[i]);
  return result;
}

} // namespace isr_test

#endif // ISR_TEST_SAMPLES_H

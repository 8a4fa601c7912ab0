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

#ifndef ISR_TEST_HOSTILE_H
#define ISR_TEST_HOSTILE_H

#include "isr_test_hostile_structures.h"
#include "isr_test_hostile_utils.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace isr_test {

namespace hostile {

// ---- too few dimensions --------------------------------------------------------------------------

inline Points equal(std::size_t n, std::uint64_t) { return Points(n, Point(1, 2, 3)); }

inline Points two_places(std::size_t n, std::uint64_t) { return repeated({ Point(1, 2, 3), Point(3, 2, 1) }, n / 2); }

inline Points line(std::size_t n, std::uint64_t)
{
  Points points;
  for (std::size_t i = 0; i != n; ++i)
    points.emplace_back(double(i), 2. * double(i), -3. * double(i));
  return points;
}

// Collinear but for rounding.
inline Points line_rounded(std::size_t n, std::uint64_t seed)
{
  Random random(seed);
  Points points;
  for (std::size_t i = 0; i != n; ++i) {
    const double t = random.uniform();
    points.emplace_back(.1 * t, .7 * t, -.3 * t);
  }
  return points;
}

inline Points circle(std::size_t n, std::uint64_t)
{
  Points points;
  for (std::size_t i = 0; i != n; ++i)
    points.push_back(on_circle(2. * PI * double(i) / double(n), 1., 0.));
  return points;
}

inline Points sheet_grid(std::size_t n, std::uint64_t) { return plane_grid(sheet_side(n)).points; }

inline Points sheet_grid_rotated(std::size_t n, std::uint64_t seed)
{
  return rotated(plane_grid(sheet_side(n)).points, .7 + double(seed));
}

inline Points sheet_random(std::size_t n, std::uint64_t seed) { return plane_random(n, seed).points; }

inline Points sheet_random_rotated(std::size_t n, std::uint64_t seed)
{
  return rotated(plane_random(n, seed).points, .7);
}

// Every height is one of three neighboring floating-point numbers.
inline Points sheet_nudged(std::size_t n, std::uint64_t seed) { return nudged(plane_random(n, seed).points, seed, 1); }

// A line with a point beside it.
inline Points needle_fan(std::size_t n, std::uint64_t seed)
{
  Points points = line(n, seed);
  points.emplace_back(.5, 1e-12, 0.);
  return points;
}

// ---- regular positions ---------------------------------------------------------------------------

inline Points lattice_solid(std::size_t n, std::uint64_t) { return lattice(n); }
inline Points lattice_rotated(std::size_t n, std::uint64_t seed) { return rotated(lattice(n), .7 + double(seed)); }
inline Points lattice_nudged(std::size_t n, std::uint64_t seed) { return nudged(lattice(n), seed, 2); }

inline Points box_grid(std::size_t n, std::uint64_t)
{
  const std::size_t m = box_side(n);
  return box(m, m, m).points;
}

inline Points box_grid_rotated(std::size_t n, std::uint64_t seed)
{
  return rotated(box_grid(n, seed), .4 + double(seed));
}

// Integer points on a common sphere.
inline Points cospherical(std::size_t n, std::uint64_t)
{
  Points points;
  // The number of ways to write m as a sum of three squares grows like sqrt(m).
  const long m = long(n) * long(n) / 200 * 8 + 1, r = long(std::sqrt(double(m))) + 1;
  for (long x = -r; x <= r; ++x)
    for (long y = -r; y <= r; ++y) {
      const long rest = m - x * x - y * y;
      const long z = rest < 0 ? 0 : std::lround(std::sqrt(double(rest)));
      if (rest < 0 || z * z != rest)
        continue;
      points.emplace_back(double(x), double(y), double(z));
      if (z != 0)
        points.emplace_back(double(x), double(y), double(-z));
    }
  return points;
}

inline Points cylinder_cocircular(std::size_t n, std::uint64_t)
{
  const std::size_t m = root(double(n), 2.);
  Points points;
  for (std::size_t i = 0; i != m; ++i)
    for (std::size_t j = 0; j != m; ++j)
      points.push_back(on_circle(2. * PI * double(j) / double(m), 1., double(i) / double(m)));
  return points;
}

// ---- sheets near each other ----------------------------------------------------------------------

// The gap is drawn between 0.3 and 2 spacings.
inline double drawn_gap(std::uint64_t seed) { return Random(seed).uniform(.3, 2.); }

inline Points plates(std::size_t n, std::uint64_t seed)
{
  return two_plates(sheet_side(n / 2), drawn_gap(seed)).points;
}

inline Points boxes(std::size_t n, std::uint64_t seed) { return two_boxes(box_side(n / 2), drawn_gap(seed)).points; }

inline Points boxes_rotated(std::size_t n, std::uint64_t seed) { return rotated(boxes(n, seed), 1.1); }

inline Points shells(std::size_t n, std::uint64_t seed)
{
  const Points inner = sphere_random(n / 2, seed).points;
  return joined(scaled(inner, 1. + drawn_gap(seed) * sphere_spacing(n / 2)), inner);
}

inline Points spheres_touching(std::size_t n, std::uint64_t)
{
  Points points = sphere_fibonacci(n / 2).points;
  points.emplace_back(1., 0., 0.);
  return joined(points, translated(points, Vector(2, 0, 0)));
}

inline Points wedge_thin(std::size_t n, std::uint64_t seed)
{
  return wedge(root(double(n) / 2., 2.), .02 + .1 * Random(seed).uniform()).points;
}

inline Points cone_sharp(std::size_t n, std::uint64_t seed)
{
  return cone(root(double(n) / 6., 2.), Random(seed).uniform(2., 30.)).points;
}

inline Points cones_common_tip(std::size_t n, std::uint64_t)
{
  const Points points = translated(cone(root(double(n) / 12., 2.), 1.).points, Vector(0, 0, -1));
  return joined(points, scaled(points, -1.));
}

// The corners and edges of a Menger sponge: the points of a lattice next to a removed cell.
inline Points menger(std::size_t n, std::uint64_t)
{
  const std::size_t level = n < 2000 ? 2 : n < 40000 ? 3 : 4;
  const std::size_t m = std::size_t(std::lround(std::pow(3., double(level))));
  const auto is_solid = [m](std::size_t x, std::size_t y, std::size_t z) {
    if (x >= m || y >= m || z >= m) // -1 as well
      return false;
    for (; x != 0 || y != 0 || z != 0; x /= 3, y /= 3, z /= 3)
      if ((x % 3 == 1) + (y % 3 == 1) + (z % 3 == 1) >= 2)
        return false;
    return true;
  };
  Points points;
  for (std::size_t x = 0; x <= m; ++x)
    for (std::size_t y = 0; y <= m; ++y)
      for (std::size_t z = 0; z <= m; ++z) {
        int solid = 0;
        for (std::size_t c = 0; c != 8; ++c)
          solid += is_solid(x - c % 2, y - c / 2 % 2, z - c / 4) ? 1 : 0;
        if (solid != 0 && solid != 8)
          points.emplace_back(double(x), double(y), double(z));
      }
  return points;
}

inline Points planes_crossing(std::size_t n, std::uint64_t seed)
{
  Points points;
  Random random(seed);
  for (std::size_t i = 0; i != n; ++i) {
    const double x = random.uniform(-1., 1.), y = random.uniform(-1., 1.);
    points.push_back(i % 3 == 0 ? Point(x, y, 0) : i % 3 == 1 ? Point(x, 0, y) : Point(0, x, y));
  }
  return points;
}

// ---- no surface ----------------------------------------------------------------------------------

inline Points moebius(std::size_t n, std::uint64_t)
{
  const std::size_t m = root(double(n) / 10., 2.);
  return moebius_strip(10 * m, m);
}

inline Points klein(std::size_t n, std::uint64_t)
{
  const std::size_t m = root(double(n) / 2., 2.);
  return klein_bottle(2 * m, m);
}

inline Points cube_random(std::size_t n, std::uint64_t seed) { return random_cube(n, seed); }

inline Points sphere_outliers(std::size_t n, std::uint64_t seed)
{
  return with_outliers(sphere_fibonacci(n * 7 / 10).points, n * 3 / 10, seed);
}

// The noise is drawn between 0 and 2 spacings.
inline Points sphere_noise(std::size_t n, std::uint64_t seed)
{
  return with_noise(sphere_fibonacci(n).points, Random(seed).uniform(0., 2.) * sphere_spacing(n), seed);
}

inline Points helix(std::size_t n, std::uint64_t)
{
  Points points;
  for (std::size_t i = 0; i != n; ++i)
    points.push_back(on_circle(.1 * double(i), 1., .01 * double(i)));
  return points;
}

// Three rows of points along a helix: nearly all of them are on the boundary.
inline Points ribbon(std::size_t n, std::uint64_t)
{
  Points points;
  for (std::size_t i = 0; i != n / 3; ++i)
    for (int row = 0; row != 3; ++row)
      points.push_back(on_circle(.01 * double(i), 1., .01 * double(row) + .001 * double(i)));
  return points;
}

inline Points helices(std::size_t n, std::uint64_t seed)
{
  const Points one = helix(n / 2, seed);
  return joined(one, rotated(translated(one, Vector(.3, 0, 0)), 1.));
}

// Every pair of points of the two lines makes a Delaunay edge.
inline Points lines_skew(std::size_t n, std::uint64_t seed)
{
  Random random(seed);
  Points points;
  for (std::size_t i = 0; i != n; ++i) {
    const double t = random.uniform(-1., 1.);
    points.push_back(i % 2 == 0 ? Point(t, 0, 1) : Point(0, t, -1));
  }
  return points;
}

inline Points moment_curve(std::size_t n, std::uint64_t)
{
  Points points;
  for (std::size_t i = 0; i != n; ++i) {
    const double t = double(i + 1) / double(n);
    points.emplace_back(t, t * t, t * t * t);
  }
  return points;
}

inline Points random_walk(std::size_t n, std::uint64_t seed)
{
  Random random(seed);
  Points points(1, Point(0, 0, 0));
  while (points.size() < n)
    points.push_back(points.back() + random.unit());
  return points;
}

// A circle of points with the two ends of its axis: every triangle could meet at them.
inline Points bicone(std::size_t n, std::uint64_t seed)
{
  Points points = circle(n, seed);
  points.emplace_back(0., 0., .5);
  points.emplace_back(0., 0., -.5);
  return points;
}

inline Points poles_crowded(std::size_t n, std::uint64_t) { return sphere_uv(n / 8, 9).points; }

// ---- spacing and magnitude -----------------------------------------------------------------------

// From one pole to the other the spacing grows 1000 times.
inline Points spacing_varying(std::size_t n, std::uint64_t seed)
{
  Random random(seed);
  Points points;
  while (points.size() < n) {
    const double polar = PI * std::pow(1e-3, random.uniform()), azimuth = random.uniform(0., 2. * PI);
    points.push_back(on_circle(azimuth, std::sin(polar), std::cos(polar)));
  }
  return points;
}

// Distances from a center over the whole range of double.
inline Points scales_all(std::size_t n, std::uint64_t seed)
{
  Random random(seed);
  Points points;
  while (points.size() < n)
    points.push_back(CGAL::ORIGIN + std::ldexp(1., int(random.below(2000)) - 1000) * random.unit());
  return points;
}

inline Points clusters(std::size_t n, std::uint64_t seed)
{
  Points points;
  for (std::size_t i = 0; i != 10; ++i)
    append(points, translated(scaled(random_cube(n / 10, seed + i), 1e-3), Vector(1e6 * double(i), 0, 0)));
  return points;
}

inline Points spheres_far(std::size_t n, std::uint64_t seed)
{
  const Points one = sphere_random(n / 2, seed).points;
  return joined(one, translated(one, Vector(1e6, 0, 0)));
}

inline Points speck_far(std::size_t n, std::uint64_t seed)
{
  return joined(scaled(sphere_random(n - 2, seed).points, 1e-200), { Point(1, 0, 0), Point(0, 1e200, 0) });
}

// The spacing is 1e-3.
inline Points offset_large(std::size_t n, std::uint64_t seed)
{
  return translated(scaled(sphere_random(n, seed).points, 1e-3 / sphere_spacing(n)), Vector(1e6, -1e6, 1e6));
}

inline Points offset_planar(std::size_t n, std::uint64_t seed)
{
  return translated(scaled(plane_random(n, seed).points, 1e-6), Vector(1e6, -1e6, 1e6));
}

inline Points range_upper(std::size_t n, std::uint64_t seed) { return scaled(sphere_random(n, seed).points, 1.7e308); }

inline Points denormal(std::size_t n, std::uint64_t seed) { return scaled(sphere_random(n, seed).points, 1e-310); }

// There are some hundred different points at most.
inline Points denormal_smallest(std::size_t n, std::uint64_t seed) { return scaled(random_cube(n, seed), 1.5e-323); }

inline Points non_finite(std::size_t n, std::uint64_t seed)
{
  const double bad[] = { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                         -std::numeric_limits<double>::infinity() };
  Random random(seed);
  Points points = sphere_random(n, seed).points;
  for (std::size_t i = 0; i < n; i += 7) {
    double c[3] = { points[i].x(), points[i].y(), points[i].z() };
    c[random.below(3)] = bad[random.below(3)];
    points[i] = Point(c[0], c[1], c[2]);
  }
  return points;
}

inline Points thrice(std::size_t n, std::uint64_t seed) { return repeated(sphere_random(n / 3, seed).points, 3); }

// Every point three times, but for the last bits.
inline Points nearly_thrice(std::size_t n, std::uint64_t seed)
{
  return nudged(repeated(sphere_random(n / 3, seed).points, 3), seed, 2);
}

inline Points aspect_extreme(std::size_t n, std::uint64_t seed)
{
  Points points = sphere_random(n, seed).points;
  for (Point& p : points)
    p = Point(1e9 * p.x(), p.y(), 1e-9 * p.z());
  return points;
}

} // namespace hostile

inline std::vector<Hostile_generator> hostile_corpus()
{
  return {
    { "equal", hostile::equal },
    { "two places", hostile::two_places },
    { "line", hostile::line },
    { "line, rounded", hostile::line_rounded },
    { "circle", hostile::circle },
    { "sheet, grid", hostile::sheet_grid },
    { "sheet, rotated grid", hostile::sheet_grid_rotated },
    { "sheet, random", hostile::sheet_random },
    { "sheet, random, rotated", hostile::sheet_random_rotated },
    { "sheet, nudged", hostile::sheet_nudged },
    { "needle fan", hostile::needle_fan },
    { "lattice", hostile::lattice_solid },
    { "lattice, rotated", hostile::lattice_rotated },
    { "lattice, nudged", hostile::lattice_nudged },
    { "box", hostile::box_grid },
    { "box, rotated", hostile::box_grid_rotated },
    { "cospherical", hostile::cospherical },
    { "cylinder", hostile::cylinder_cocircular },
    { "plates", hostile::plates },
    { "boxes", hostile::boxes },
    { "boxes, rotated", hostile::boxes_rotated },
    { "shells", hostile::shells },
    { "spheres touching", hostile::spheres_touching },
    { "wedge", hostile::wedge_thin },
    { "cone", hostile::cone_sharp },
    { "cones with a common tip", hostile::cones_common_tip },
    { "Menger sponge", hostile::menger },
    { "planes crossing", hostile::planes_crossing },
    { "Moebius strip", hostile::moebius },
    { "Klein bottle", hostile::klein },
    { "random cube", hostile::cube_random },
    { "outliers", hostile::sphere_outliers },
    { "noise", hostile::sphere_noise },
    { "helix", hostile::helix },
    { "helices", hostile::helices },
    { "ribbon", hostile::ribbon },
    { "skew lines", hostile::lines_skew },
    { "moment curve", hostile::moment_curve },
    { "random walk", hostile::random_walk },
    { "bicone", hostile::bicone },
    { "crowded poles", hostile::poles_crowded },
    { "varying spacing", hostile::spacing_varying },
    { "all scales", hostile::scales_all },
    { "clusters", hostile::clusters },
    { "spheres far", hostile::spheres_far },
    { "speck far", hostile::speck_far },
    { "large offset", hostile::offset_large },
    { "sheet at a large offset", hostile::offset_planar },
    { "upper end of the range", hostile::range_upper },
    { "denormal", hostile::denormal },
    { "smallest denormals", hostile::denormal_smallest },
    { "not finite", hostile::non_finite },
    { "thrice", hostile::thrice },
    { "nearly thrice", hostile::nearly_thrice },
    { "extreme aspect", hostile::aspect_extreme },
    { "close packing", hostile::close_packing },
    { "two lattices", hostile::lattices_interleaved },
    { "lattice of unlike spacings", hostile::lattice_anisotropic },
    { "layers", hostile::layers },
    { "rotated sheet, nudged", hostile::sheet_rotated_nudged },
    { "circles around a center", hostile::circles_concentric },
    { "paraboloid", hostile::paraboloid },
    { "sphere, nudged", hostile::sphere_nudged },
    { "nested spheres", hostile::spheres_nested },
    { "lattice of touching spheres", hostile::spheres_tangent },
    { "specks", hostile::specks },
    { "dense cluster", hostile::cluster_dense },
    { "book", hostile::book },
    { "lines through a point", hostile::lines_crossing },
    { "rays of growing steps", hostile::rays_growing },
    { "Cantor dust", hostile::cantor_dust },
    { "Sierpinski tetrahedron", hostile::sierpinski },
    { "spiral", hostile::spiral },
    { "sunflower", hostile::sunflower },
    { "horn torus", hostile::horn_torus },
    { "comb", hostile::comb },
    { "both ends of the range", hostile::range_both_ends },
    { "powers of two", hostile::powers_of_two },
  };
}

} // namespace isr_test

#endif // ISR_TEST_HOSTILE_H

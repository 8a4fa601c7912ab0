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

// Inputs that no surface was meant by: whatever comes out keeps the guarantees.

#include "isr_test_ctc.h"

#include <limits>

using namespace isr_test;

void test_no_surface(const std::string& name, const Points& points)
{
  begin_case(name);
  ISR_CHECK(checked_ctc(points).empty());
}

void test_guarantees(const std::string& name, const Points& points)
{
  begin_case(name);
  checked_ctc(points);
  Counting_visitor visitor;
  checked_ctc(points, visitor, params::keep_boundaries(true));
}

Points collinear_points(std::size_t n, const Vector& step)
{
  Points points;
  for (std::size_t i = 0; i != n; ++i)
    points.push_back(CGAL::ORIGIN + double(i) * step);
  return points;
}

void test_no_surfaces()
{
  test_no_surface("no point", {});
  test_no_surface("one point", { Point(1, 2, 3) });
  test_no_surface("two points", { Point(1, 2, 3), Point(3, 2, 1) });
  test_no_surface("all equal", Points(100, Point(1, 2, 3)));
  test_no_surface("two places, many times", repeated({ Point(1, 2, 3), Point(3, 2, 1) }, 50));
  test_no_surface("three collinear points", collinear_points(3, Vector(1, 1, 1)));
  test_no_surface("collinear along an axis", collinear_points(200, Vector(1, 0, 0)));
  test_no_surface("collinear along a diagonal", collinear_points(200, Vector(1, 2, -3)));
}

void test_few_points()
{
  test_guarantees("triangle", { Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0) });
  test_guarantees("needle", { Point(0, 0, 0), Point(1, 0, 0), Point(.5, 1e-300, 0) });
  test_guarantees("tetrahedron", { Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1) });
  test_guarantees("square", { Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(1, 1, 0) });
  test_guarantees("triangle and its center", { Point(0, 0, 0), Point(3, 0, 0), Point(0, 3, 0), Point(1, 1, 0) });
  test_guarantees("cube", box(1, 1, 1).points);
  Points line = collinear_points(50, Vector(1, 0, 0));
  line.emplace_back(10.5, 1., 0.);
  test_guarantees("line and a point", line);
}

// A flat sheet stays open, however small.
void test_flat_sheet(const std::string& name, const Points& points, std::size_t triangles)
{
  begin_case(name);
  const Triples triples = checked_ctc(points);
  ISR_CHECK_EQUAL(triples.size(), triangles);
  ISR_CHECK_EQUAL(validation::number_of_components(triples), 1u);
}

void test_small_sheets()
{
  test_flat_sheet("one triangle", { Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, .1) }, 1);
  test_flat_sheet("two triangles", { Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(1, 1.1, 0) }, 2);
  test_flat_sheet("three triangles", { Point(0, 0, 0), Point(3, 0, 0), Point(0, 3, 0), Point(1, 1, 0) }, 3);
  test_flat_sheet("grid", plane_grid(2).points, 8);
  begin_case("no sheet");
  ISR_CHECK_EQUAL(checked_ctc({ Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1) }).size(), 4u);
}

void test_planar()
{
  test_guarantees("plane grid", plane_grid(15).points);
  test_guarantees("rotated plane grid", rotated(plane_grid(15).points, .7));
  test_guarantees("random planar", plane_random(400, 1).points);
  Points circle;
  for (int i = 0; i != 64; ++i)
    circle.push_back(on_circle(2. * PI * i / 64, 1., 0.));
  test_guarantees("circle", circle);
}

void test_non_finite()
{
  begin_case("NaN and infinity");
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Points bad = { Point(nan, 0, 0), Point(0, nan, 0), Point(0, 0, nan), Point(inf, 0, 0), Point(0, -inf, 0) };
  const Points good = sphere_fibonacci(500).points;
  Points points;
  for (std::size_t i = 0; i != good.size(); ++i) {
    if (i % 100 == 50)
      points.push_back(bad[i / 100]);
    points.push_back(good[i]);
  }
  Counting_visitor visitor;
  const Triples triples = checked_ctc(points, visitor, params::keep_boundaries(false));
  ISR_CHECK_EQUAL(visitor.non_finite, bad.size());
  ISR_CHECK_EQUAL(triples.size(), ctc(good).size());
  test_no_surface("only NaN and infinity", bad);
}

void test_duplicates()
{
  begin_case("every point three times");
  const Points once = sphere_fibonacci(500).points;
  Counting_visitor visitor;
  const Triples triples = checked_ctc(repeated(once, 3), visitor, params::keep_boundaries(false));
  ISR_CHECK_EQUAL(visitor.duplicates, 2 * once.size());
  // the first of the positions is used, and the rest changes nothing
  ISR_CHECK(triples == ctc(once));
  begin_case("positive and negative zero");
  checked_ctc({ Point(0., 0, 0), Point(-0., 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1) });
}

void test_extreme_coordinates()
{
  const Points sphere = sphere_fibonacci(500).points;
  const std::size_t size = ctc(sphere).size();
  const auto test = [&](const std::string& name, const Points& points) {
    begin_case(name);
    ISR_CHECK_EQUAL(checked_ctc(points).size(), size);
  };
  test("spacing 1e-3 at 1e6", translated(scaled(sphere, .01), Vector(1e6, -1e6, 1e6)));
  test("1e150", scaled(sphere, 1e150));
  test("1e-150", scaled(sphere, 1e-150));
  test_guarantees("1e308", scaled(sphere, 1e308));
  test_guarantees("denormal", scaled(sphere, 1e-310));
  test_guarantees("smallest denormals", scaled(sphere, 3e-323));
  test_guarantees("huge and tiny together", [&] {
    Points points = scaled(sphere, 1e-300);
    append(points, scaled(sphere, 1e300));
    return points;
  }());
}

void test_clusters()
{
  begin_case("two spheres 1e6 apart");
  Points points = sphere_fibonacci(500).points;
  append(points, translated(points, Vector(1e6, 0, 0)));
  const Triples triples = checked_ctc(points);
  ISR_CHECK_EQUAL(validation::number_of_components(triples), 2u);
  Points specks;
  for (int i = 0; i != 10; ++i)
    append(specks, translated(scaled(random_cube(20, std::uint64_t(i)), 1e-3), Vector(1e6 * i, 0, 0)));
  test_guarantees("specks 1e6 apart", specks);
}

void test_no_clean_surface()
{
  test_guarantees("sphere with outliers", with_outliers(sphere_fibonacci(1000).points, 100, 1));
  for (const std::uint64_t seed : { 1u, 2u, 3u })
    test_guarantees("random cube, seed " + std::to_string(seed), random_cube(600, seed));
  test_guarantees("noise of half a spacing", with_noise(sphere_fibonacci(1000).points, .055, 1));
  test_guarantees("Moebius strip", moebius_strip(80, 8));
  test_guarantees("Klein bottle", klein_bottle(60, 30));
  test_guarantees("solid lattice", [] {
    Points points;
    for (int i = 0; i != 512; ++i)
      points.emplace_back(i % 8, i / 8 % 8, i / 64);
    return points;
  }());
}

void test_hard_shapes()
{
  test_guarantees("two plates half a spacing apart", two_plates(15, .5).points);
  test_guarantees("two boxes half a spacing apart", two_boxes(6, .5).points);
  test_guarantees("thin wedge", wedge(20, .05).points);
  test_guarantees("two plates two spacings apart", two_plates(15, 2.).points);
  test_guarantees("two boxes two spacings apart", two_boxes(6, 2.).points);
  test_guarantees("sharp cone", cone(15, 8.).points);
  test_guarantees("cone with aligned samples", cone(15, 1.).points);
  test_guarantees("varying spacing", box_varying_spacing(15).points);
  test_guarantees("UV sphere with crowded poles", sphere_uv(100, 12).points);
  Points cones = translated(cone(10, 1.).points, Vector(0, 0, -1));
  append(cones, scaled(cones, -1.));
  test_guarantees("two cones with a common tip", cones);
}

int main()
{
  test_no_surfaces();
  test_few_points();
  test_small_sheets();
  test_planar();
  test_non_finite();
  test_duplicates();
  test_extreme_coordinates();
  test_clusters();
  test_no_clean_surface();
  test_hard_shapes();
  return result();
}

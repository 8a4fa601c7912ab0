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

// The function: zero at the samples, signs, gradients, weights, copies and threads.

#include "isr_test_lis.h"

#include <CGAL/Interpolating_surface_reconstruction_3/Linear_implicit_function_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/adaptive_linear_implicit_isosurface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/linear_implicit_isosurface.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

using namespace isr_test;
using Function = isr::Linear_implicit_function_3<Kernel>;
using Thesis_function = isr::Linear_implicit_function_3<Kernel, isr::Quadratic_weight>;

namespace {

Vector from_origin(const Point& p) { return p - CGAL::ORIGIN; }

Oriented_points sphere() { return with_normals(sphere_fibonacci(2000).points, from_origin); }

template <typename F>
double largest_value(const F& f, const Points& points)
{
  double result = 0.;
  for (const Point& p : points)
    result = (std::max)(result, std::abs(f(p)));
  return result;
}

void test_interpolation()
{
  begin_case("zero at the samples, with the normal as gradient");
  const Oriented_points samples = sphere();
  const Function f(samples, oriented_maps());
  ISR_CHECK(largest_value(f, positions_of(samples)) < 1e-9);
  for (const Oriented_point& s : samples)
    ISR_CHECK((f.gradient(s.first) - s.second).squared_length() < 1e-18);
  // ... and beside them
  for (std::size_t i = 0; i < samples.size(); i += 7)
    ISR_CHECK(std::abs(f(samples[i].first + Vector(1e-9, 1e-9, 0))) < 1e-8);

  begin_case("in other units, far from the origin");
  Oriented_points moved = samples;
  for (Oriented_point& s : moved)
    s.first = Point(std::ldexp(s.first.x(), -10) + 4096., std::ldexp(s.first.y(), -10), std::ldexp(s.first.z(), -10));
  const Function g(moved, oriented_maps());
  ISR_CHECK(largest_value(g, positions_of(moved)) < 1e-12);
  // the moved coordinates are rounded
  ISR_CHECK(std::abs(g(Point(4096., 0, 0)) - std::ldexp(f(Point(0, 0, 0)), -10)) < 1e-5);

  begin_case("the weight of the thesis does not interpolate");
  const Thesis_function thesis(samples, oriented_maps());
  const double error = largest_value(thesis, positions_of(samples));
  ISR_CHECK(error > 1e-5 && error < .01);
}

void test_distance()
{
  begin_case("height over a sphere");
  const Function f(sphere(), oriented_maps());
  Random random(3);
  for (int i = 0; i != 300; ++i) {
    const Vector direction = random.unit();
    for (double r : { .5, .9, .99, 1., 1.01, 1.1, 2. })
      ISR_CHECK(std::abs(f(CGAL::ORIGIN + r * direction) - (r - 1.)) < .01);
  }
  const CGAL::Bbox_3 box = f.bbox();
  ISR_CHECK(box.xmin() < -.99 && box.xmin() >= -1. && box.zmax() > .99 && box.zmax() <= 1.);
}

void test_gradient()
{
  begin_case("gradient against differences");
  const Function f(with_normals(torus(50, 20, .2, 3).points, normal_of_torus), oriented_maps());
  Random random(4);
  std::size_t wrong = 0;
  constexpr int POINTS = 500;
  constexpr double h = 1e-6;
  for (int i = 0; i != POINTS; ++i) {
    const Point p = Point(1.4, 0, 0) + random.in_cube(.1);
    const Vector differences((f(p + Vector(h, 0, 0)) - f(p - Vector(h, 0, 0))) / (2 * h),
                             (f(p + Vector(0, h, 0)) - f(p - Vector(0, h, 0))) / (2 * h),
                             (f(p + Vector(0, 0, h)) - f(p - Vector(0, 0, h))) / (2 * h));
    wrong += (differences - f.gradient(p)).squared_length() > 1e-8 ? 1u : 0u;
  }
  // where the nearest sample changes, the function jumps
  ISR_CHECK(wrong < POINTS / 100);
}

void test_close_sheets()
{
  begin_case("plates half a spacing apart");
  // the upper side of the lower plate, and the lower side of the upper one
  Oriented_points samples;
  for (const Point& p : plane_grid(20).points) {
    samples.emplace_back(p, Vector(0, 0, 1));
    samples.emplace_back(p + Vector(0, 0, .5), Vector(0, 0, -1));
  }
  const Function f(samples, oriented_maps());
  const Thesis_function thesis(samples, oriented_maps());
  double error = 0., error_of_thesis = 0.;
  for (double x = 5.; x < 15.; x += .37)
    for (double z : { .05, .1, .2, .3, .4 }) {
      const double height = (std::min)(z, .5 - z);
      error = (std::max)(error, std::abs(f(Point(x, x + .3, z)) - height));
      error_of_thesis = (std::max)(error_of_thesis, std::abs(thesis(Point(x, x + .3, z)) - height));
    }
  ISR_CHECK(error < 1e-9);
  ISR_CHECK(error_of_thesis > .05);
}

void test_copies_and_threads()
{
  begin_case("copies and threads");
  const Function* original = new Function(sphere(), oriented_maps());
  const Function f = *original;
  delete original;
  Points points = random_cube(2000, 5);
  std::vector<double> expected, found(points.size());
  for (const Point& p : points)
    expected.push_back(f(p));
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t != 4; ++t)
    threads.emplace_back([&, t] {
      for (std::size_t i = t; i < points.size(); i += 4)
        found[i] = f(points[i]);
    });
  for (std::thread& t : threads)
    t.join();
  ISR_CHECK(found == expected);
}

void test_few_samples()
{
  begin_case("few samples");
  const Function empty(Oriented_points(), oriented_maps());
  ISR_CHECK_EQUAL(empty(Point(1, 2, 3)), 1.);
  ISR_CHECK(empty.gradient(Point(1, 2, 3)) == Vector(0, 0, 0));
  for (std::size_t n : { 1u, 2u, 3u }) {
    const Points line = { Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0) };
    Oriented_points samples = with_normals(line, [](const Point&) { return Vector(0, 0, 3); });
    samples.resize(n);
    const Function f(samples, oriented_maps());
    ISR_CHECK_EQUAL(f(Point(.5, 7, 2)), 2.);
    ISR_CHECK_EQUAL(f(Point(0, 0, 0)), 0.);
  }
  begin_case("without normals");
  const Function f(sphere_fibonacci(500).points);
  ISR_CHECK(f(Point(0, 0, 0)) < -.9);
  ISR_CHECK(f(Point(0, 0, 2)) > .9);
  begin_case("bad radius");
  try {
    const Function g(sphere_fibonacci(50).points, params::neighbor_radius(-1.));
    ISR_CHECK(!"exception");
  } catch (const std::invalid_argument& e) {
    ISR_CHECK(std::string(e.what()).find("neighbor_radius") != std::string::npos);
  }
}

void test_isosurface()
{
  begin_case("isosurface of a torus");
  const Oriented_points samples = with_normals(torus(60, 24, .2, 3).points, normal_of_torus);
  const auto distance = [](const Point& p) {
    const double r = std::sqrt(p.x() * p.x() + p.y() * p.y()) - 1.;
    return std::abs(std::sqrt(r * r + p.z() * p.z()) - .4);
  };
  Soup soup;
  isr::linear_implicit_isosurface(Function(samples, oriented_maps()), soup.points, soup.triangles, .05);
  ISR_CHECK(validation::are_indices_valid(soup.triangles, soup.points.size()));
  ISR_CHECK(validation::is_vertex_manifold(soup.triangles));
  ISR_CHECK(validation::is_consistently_oriented(soup.triangles));
  ISR_CHECK(validation::boundary_edges(soup.triangles).empty());
  ISR_CHECK_EQUAL(validation::euler_characteristic(soup.triangles), 0);
  ISR_CHECK_EQUAL(validation::number_of_components(soup.triangles), 1u);
  ISR_CHECK(are_outward(soup.points, soup.triangles));
  for (const Point& p : soup.points)
    ISR_CHECK(distance(p) < .02);

  begin_case("the method of the thesis: weights and default step");
  Soup thesis;
  const Thesis_function f(samples, oriented_maps());
  isr::linear_implicit_isosurface(f, thesis.points, thesis.triangles);
  ISR_CHECK(validation::is_vertex_manifold(thesis.triangles));
  ISR_CHECK(validation::boundary_edges(thesis.triangles).empty());
  ISR_CHECK(!thesis.triangles.empty());
  ISR_CHECK(f.smallest_radius() > .05 && f.smallest_radius() < .15);

  begin_case("too many cells");
  for (double step : { 1e-7, 1e-300, -1., std::numeric_limits<double>::infinity() })
    try {
      isr::linear_implicit_isosurface(f, thesis.points, thesis.triangles, step);
      ISR_CHECK(!"exception");
    } catch (const std::invalid_argument& e) {
      ISR_CHECK(std::string(e.what()).find("step") == 0);
    }
  begin_case("no points");
  Soup none;
  isr::adaptive_linear_implicit_isosurface(Function(Oriented_points(), oriented_maps()), none.points, none.triangles);
  isr::linear_implicit_isosurface(Function(Oriented_points(), oriented_maps()), none.points, none.triangles);
  ISR_CHECK(none.triangles.empty());
}

double distance_to_torus(const Point& p)
{
  const double r = std::sqrt(p.x() * p.x() + p.y() * p.y()) - 1.;
  return std::abs(std::sqrt(r * r + p.z() * p.z()) - .4);
}

void check_closed_manifold(const Soup& soup, std::ptrdiff_t euler_characteristic, std::size_t components)
{
  ISR_CHECK(validation::are_indices_valid(soup.triangles, soup.points.size()));
  ISR_CHECK(validation::is_vertex_manifold(soup.triangles));
  ISR_CHECK(validation::is_consistently_oriented(soup.triangles));
  ISR_CHECK(validation::boundary_edges(soup.triangles).empty());
  ISR_CHECK_EQUAL(validation::euler_characteristic(soup.triangles), euler_characteristic);
  ISR_CHECK_EQUAL(validation::number_of_components(soup.triangles), components);
  ISR_CHECK(are_outward(soup.points, soup.triangles));
}

// A point every `spacing` of a sphere around the z-axis, but every 1/64 of that near the pole.
Oriented_points nonuniform_sphere(double spacing)
{
  Oriented_points samples;
  constexpr double pi = 3.14159265358979323846;
  for (double t = 0.; t < pi;) {
    const double step = spacing * (t < .1 ? 1. / 64 : (std::min)(1., (t - .1) * .5 + 1. / 64));
    const int n = (std::max)(1, int(2. * pi * std::sin(t) / step));
    for (int i = 0; i != n; ++i) {
      const double u = 2. * pi * (i + (samples.size() % 2 == 0 ? 0. : .5)) / n;
      const Vector v(std::sin(t) * std::cos(u), std::sin(t) * std::sin(u), std::cos(t));
      samples.emplace_back(CGAL::ORIGIN + v, v);
    }
    t += step;
  }
  samples.emplace_back(Point(0, 0, -1), Vector(0, 0, -1));
  return samples;
}

double distance_to_box(const Point& p, const Point& low, const Point& high)
{
  double outside = 0., inside = std::numeric_limits<double>::infinity();
  for (int a = 0; a != 3; ++a) {
    const double beyond = (std::max)({ 0., low[a] - p[a], p[a] - high[a] });
    outside += beyond * beyond;
    inside = (std::min)({ inside, p[a] - low[a], high[a] - p[a] });
  }
  return outside > 0. ? std::sqrt(outside) : inside;
}

// The surface of a box of nx x ny x nz parts.
Points box_surface(std::size_t nx, std::size_t ny, std::size_t nz, const Point& high)
{
  Points points;
  for (std::size_t i = 0; i <= nx; ++i)
    for (std::size_t j = 0; j <= ny; ++j)
      for (std::size_t k = 0; k <= nz; ++k)
        if (i == 0 || i == nx || j == 0 || j == ny || k == 0 || k == nz)
          points.emplace_back(high.x() * double(i) / double(nx), high.y() * double(j) / double(ny),
                              high.z() * double(k) / double(nz));
  return points;
}

// A flat toothed wheel: samples on the outlines of its faces and at their centers.
Oriented_points gear(std::size_t teeth, double thickness)
{
  constexpr double pi = 3.14159265358979323846;
  constexpr int parts = 8;
  const auto corner = [&](std::size_t i) {
    const double angle = pi * double(i) / double(teeth), radius = i % 2 == 0 ? .5 : 1.;
    return Vector(radius * std::cos(angle), radius * std::sin(angle), 0);
  };
  const auto side_normal = [&](std::size_t i) {
    const Vector side = corner(i + 1) - corner(i);
    return Vector(side.y(), -side.x(), 0) / std::sqrt(side.squared_length());
  };
  Oriented_points samples;
  for (double up : { -1., 1. }) {
    const Vector z(0, 0, up), height = .5 * thickness * z;
    samples.emplace_back(CGAL::ORIGIN + height, z);
    for (std::size_t i = 0; i != 2 * teeth; ++i)
      for (int part = 0; part != parts; ++part) {
        const Vector n = side_normal(i), m = part == 0 ? side_normal(i + 2 * teeth - 1) : n;
        const Vector x = corner(i) + (double(part) / parts) * (corner(i + 1) - corner(i));
        samples.emplace_back(CGAL::ORIGIN + x + height, (n + m) / std::sqrt((n + m).squared_length()) + z);
      }
  }
  return samples;
}

void test_thin_parts()
{
  begin_case("isosurface of plates: as near to them as their tangent planes");
  const auto isosurface_of_box = [](std::size_t nx, std::size_t ny, std::size_t nz, const Point& high) {
    const auto normal = [&](const Point& p) { return normal_of_box(p, Point(0, 0, 0), high); };
    const Function f(with_normals(box_surface(nx, ny, nz, high), normal), oriented_maps());
    Soup soup;
    isr::adaptive_linear_implicit_isosurface(f, soup.points, soup.triangles);
    check_closed_manifold(soup, 2, 1);
    double distance = 0.;
    for (const Point& p : soup.points)
      distance = (std::max)(distance, distance_to_box(p, Point(0, 0, 0), high));
    return distance;
  };
  ISR_CHECK(isosurface_of_box(16, 16, 1, Point(16., 16., 2.)) < .5);
  ISR_CHECK(isosurface_of_box(16, 16, 1, Point(16., 16., 1.)) < .3);

  begin_case("... with spacings that differ by direction: nothing leads away from the samples");
  ISR_CHECK(isosurface_of_box(32, 4, 1, Point(16., 16., 2.)) < .7);
  ISR_CHECK(isosurface_of_box(32, 1, 1, Point(16., 8., 1.)) < 2.);

  begin_case("... with teeth");
  Soup soup;
  isr::adaptive_linear_implicit_isosurface(Function(gear(12, .2), oriented_maps()), soup.points, soup.triangles);
  check_closed_manifold(soup, 2, 1);

  begin_case("normals that point inward: the same, turned over");
  const Point high(16., 16., 2.);
  const auto inward = [&](const Point& p) { return -normal_of_box(p, Point(0, 0, 0), high); };
  const Function room(with_normals(box_surface(32, 4, 1, high), inward), oriented_maps());
  Soup walls;
  isr::adaptive_linear_implicit_isosurface(room, walls.points, walls.triangles);
  ISR_CHECK(validation::is_vertex_manifold(walls.triangles));
  ISR_CHECK(validation::boundary_edges(walls.triangles).empty());
  ISR_CHECK_EQUAL(validation::euler_characteristic(walls.triangles), 2);
  ISR_CHECK(!are_outward(walls.points, walls.triangles));
}

void test_adaptive_isosurface()
{
  begin_case("adaptive isosurface of a torus");
  const Function f(with_normals(torus(60, 24, .2, 3).points, normal_of_torus), oriented_maps());
  Soup soup;
  const std::size_t cells = isr::adaptive_linear_implicit_isosurface(f, soup.points, soup.triangles);
  check_closed_manifold(soup, 0, 1);
  for (const Point& p : soup.points)
    ISR_CHECK(distance_to_torus(p) < .01);

  Soup fine;
  const std::size_t fine_cells = isr::adaptive_linear_implicit_isosurface(f, fine.points, fine.triangles, .5);
  check_closed_manifold(fine, 0, 1);
  ISR_CHECK(double(fine_cells) > 3. * double(cells) && double(fine_cells) < 5. * double(cells));

  begin_case("... of a sphere: planes and triangles together are nearer to it than the planes");
  Oriented_points sphere_samples;
  for (const Point& p : sphere_random(400, 1).points)
    sphere_samples.emplace_back(p, p - CGAL::ORIGIN);
  Soup ball;
  isr::adaptive_linear_implicit_isosurface(Function(sphere_samples, oriented_maps()), ball.points, ball.triangles);
  check_closed_manifold(ball, 2, 1);
  double sum = 0.;
  for (const Point& p : ball.points)
    sum += std::abs(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1.);
  ISR_CHECK(sum < .002 * double(ball.points.size()));

  begin_case("two components far apart: the cells are those of the surface, not of the box");
  Oriented_points samples = sphere();
  const Function one(samples, oriented_maps());
  const std::size_t n = samples.size();
  for (std::size_t i = 0; i != n; ++i)
    samples.emplace_back(samples[i].first + Vector(1e5, -1e4, 1e3), samples[i].second);
  const Function two(samples, oriented_maps());
  Soup near, far;
  const double near_cells = double(isr::adaptive_linear_implicit_isosurface(one, near.points, near.triangles));
  const double far_cells = double(isr::adaptive_linear_implicit_isosurface(two, far.points, far.triangles));
  check_closed_manifold(near, 2, 1);
  check_closed_manifold(far, 4, 2);
  // the grids have other sizes of cells, up to twice
  ISR_CHECK(far_cells < 8. * near_cells);

  begin_case("spacing that varies");
  const Oriented_points varied = nonuniform_sphere(.1);
  const Function g(varied, oriented_maps());
  Soup adapted;
  const std::size_t adapted_cells = isr::adaptive_linear_implicit_isosurface(g, adapted.points, adapted.triangles);
  check_closed_manifold(adapted, 2, 1);
  for (const Point& p : adapted.points)
    ISR_CHECK(std::abs(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1.) < .01);
  ISR_CHECK(adapted_cells < 10 * varied.size());
  // a grid of one size would have far more
  ISR_CHECK(g.sum_of_squared_radii() > 20. * double(adapted_cells) * g.smallest_radius() * g.smallest_radius());

  begin_case("the same for any number of threads");
  Soup parallel;
  isr::adaptive_linear_implicit_isosurface<CGAL::Parallel_if_available_tag>(g, parallel.points, parallel.triangles);
  ISR_CHECK(parallel.points == adapted.points && parallel.triangles == adapted.triangles);

  begin_case("an open sheet ends at the box");
  const Function plane(with_normals(plane_grid(10).points, [](const Point&) { return Vector(0, 0, 1); }),
                       oriented_maps());
  Soup sheet;
  isr::adaptive_linear_implicit_isosurface(plane, sheet.points, sheet.triangles);
  ISR_CHECK(validation::is_vertex_manifold(sheet.triangles));
  ISR_CHECK_EQUAL(validation::euler_characteristic(sheet.triangles), 1);
  for (const Point& p : sheet.points)
    ISR_CHECK(std::abs(p.z()) < .01);

  begin_case("bad arguments");
  const auto throws = [&](double step, std::size_t maximum) {
    Soup none;
    try {
      isr::adaptive_linear_implicit_isosurface(f, none.points, none.triangles, step, maximum);
    } catch (const std::invalid_argument& e) {
      return std::string(e.what()).find("relative_step") == 0 && none.points.empty();
    }
    return false;
  };
  for (double step : { 0., -1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
    ISR_CHECK(throws(step, 1000000));
  ISR_CHECK(throws(1., 1000));
  ISR_CHECK(throws(1e-9, 1000000));
}

} // namespace

int main()
{
  test_interpolation();
  test_distance();
  test_gradient();
  test_close_sheets();
  test_copies_and_threads();
  test_few_samples();
  test_isosurface();
  test_adaptive_isosurface();
  test_thin_parts();
  return result();
}

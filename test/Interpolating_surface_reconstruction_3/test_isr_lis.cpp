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

// End to end: surfaces of known topology, from samples with and without normals.

#include "isr_test_hostile.h"
#include "isr_test_lis.h"
#include "isr_test_self_intersections.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

using namespace isr_test;

namespace {

Vector from_origin(const Point& p) { return p - CGAL::ORIGIN; }

// A closed surface with normals.
struct Solid
{
  Sample sample;
  Oriented_points points;
};

template <typename NormalAt>
Solid solid(Sample sample, const NormalAt& normal_at)
{
  Oriented_points points = with_normals(sample.points, normal_at);
  return Solid{ std::move(sample), std::move(points) };
}

Solid box_solid(Sample sample)
{
  const Point low = sample.points.front(), high = sample.points.back();
  return solid(std::move(sample), [=](const Point& p) { return normal_of_box(p, low, high); });
}

// Boxes that are plates, one above the other.
Solid plates(std::size_t n, double thickness, double gap)
{
  Solid result{ Sample{ "plates, gap " + std::to_string(gap), {}, 4, 2, 0 }, {} };
  for (double bottom : { 0., thickness + gap }) {
    Sample plate = box(n, n, 1);
    for (Point& p : plate.points)
      p = Point(p.x(), p.y(), bottom + thickness * p.z());
    const Solid s = box_solid(plate);
    result.points.insert(result.points.end(), s.points.begin(), s.points.end());
  }
  result.sample.points = positions_of(result.points);
  return result;
}

std::vector<Solid> solids()
{
  return { solid(sphere_fibonacci(700), from_origin),
           solid(sphere_random(1500, 5), from_origin),
           solid(sphere_uv(20, 12), from_origin),
           solid(torus(50, 20, .2, 1), normal_of_torus),
           solid(torus(40, 16, 0., 1), normal_of_torus),
           box_solid(box(8, 7, 6)),
           box_solid(box_jittered(10, .3, 2)),
           box_solid(box_varying_spacing(20)),
           plates(15, 1., .5),
           plates(15, 1., 1.) };
}

void check_topology(const Solid& s, const Soup& soup, std::size_t unused)
{
  ISR_CHECK_EQUAL(unused, 0u);
  ISR_CHECK_EQUAL(validation::number_of_components(soup.triangles), s.sample.components);
  ISR_CHECK_EQUAL(validation::euler_characteristic(soup.triangles), s.sample.euler);
  ISR_CHECK(are_outward(soup.points, soup.triangles));
}

void test_closed_surfaces()
{
  for (const Solid& s : solids()) {
    begin_case(s.sample.name);
    Counting_visitor visitor;
    const Soup soup = checked_lis(s.points, visitor);
    check_topology(s, soup, visitor.unused);
    ISR_CHECK(!has_self_intersection(soup.points, soup.triangles));
  }
}

void test_without_normals()
{
  for (const Solid& s : { solid(sphere_fibonacci(700), from_origin), solid(torus(50, 20, .2, 1), normal_of_torus) }) {
    begin_case(s.sample.name + ", without normals");
    Counting_visitor visitor;
    check_topology(s, lis(s.sample.points, params::visitor(std::ref(visitor))), visitor.unused);
    ISR_CHECK_EQUAL(visitor.stages_begun, visitor.stages_ended);
  }
  for (const Sample& s : solids_of_few_points()) {
    begin_case(s.name + ", without normals");
    const Soup soup = lis(s.points, params::grid_spacing(0.));
    ISR_CHECK_EQUAL(soup.triangles.size(), 2 * s.points.size() - 4);
    ISR_CHECK(validation::is_oriented_manifold(soup.points, soup.triangles, Kernel()));
    ISR_CHECK(validation::boundary_edges(soup.triangles).empty());
    ISR_CHECK_EQUAL(validation::number_of_components(soup.triangles), 1u);
  }
  begin_case("point set with and without normals");
  CGAL::Point_set_3<Point> points;
  for (const Point& p : sphere_fibonacci(300).points)
    points.insert(p);
  const Soup without = lis(points, points.parameters());
  points.add_normal_map();
  for (const auto& index : points)
    points.normal(index) = from_origin(points.point(index));
  const Soup with = lis(points, points.parameters());
  ISR_CHECK_EQUAL(with.triangles.size(), 596u);
  ISR_CHECK(canonical(with.triangles) == canonical(without.triangles));
}

// Normals that point inward turn the surface over, and change nothing else.
void test_normals_inward()
{
  for (Solid& s : solids()) {
    begin_case(s.sample.name + ", normals inward");
    const Soup expected = checked_lis(s.points);
    for (Oriented_point& p : s.points)
      p.second = -p.second;
    Soup turned = lis(s.points, oriented_maps());
    ISR_CHECK(turned.points == expected.points);
    for (Triple& t : turned.triangles)
      std::swap(t[1], t[2]);
    ISR_CHECK(canonical(turned.triangles) == canonical(expected.triangles));
  }
}

void test_lengths_of_normals()
{
  begin_case("normals of any length");
  const Oriented_points samples = with_normals(sphere_fibonacci(300).points, from_origin);
  const Soup expected = checked_lis(samples);
  for (double length : { 1e-310, 1e-200, 1e200, 1e308 }) {
    Oriented_points scaled = samples;
    for (std::size_t i = 0; i < scaled.size(); i += 2)
      scaled[i].second = scaled[i].second * length;
    ISR_CHECK(checked_lis(scaled).triangles.size() == expected.triangles.size());
  }

  begin_case("normals that are zero or not finite");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Oriented_points broken = samples;
  broken[10].second = Vector(0, 0, 0);
  broken[150].second = Vector(nan, 0, 1);
  broken[200].second = Vector(1, infinity, 0);
  broken.push_back(broken[150]); // equal to a point that is set aside
  broken.back().second = samples[150].second;
  Counting_visitor visitor;
  const Soup soup = checked_lis(broken, visitor);
  ISR_CHECK_EQUAL(visitor.non_finite, 3u);
  ISR_CHECK_EQUAL(visitor.duplicates, 0u);
  ISR_CHECK_EQUAL(soup.points.size(), 298u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(soup.triangles), 2);
  begin_case("no usable normal");
  for (Oriented_point& s : broken)
    s.second = Vector(0, 0, 0);
  ISR_CHECK(checked_lis(broken).triangles.empty());
}

// Where the surface cannot be repaired at a point, points around it may be left out, but that must not spread.
void test_normals_without_sides()
{
  begin_case("half of the normals flipped");
  std::size_t unused = 0;
  Random random(1);
  for (const double noise : { .02, .03, .04 })
    for (std::uint64_t seed = 1; seed != 3; ++seed) {
      Oriented_points samples = with_normals(with_noise(sphere_random(5000, seed).points, noise, seed), from_origin);
      for (Oriented_point& s : samples)
        s.second = (random.below(2) == 0 ? 1. : -1.) * (s.second + .4 * random.unit());
      Counting_visitor visitor;
      const Soup soup = lis(samples, params::combine(oriented_maps(), params::visitor(std::ref(visitor))));
      ISR_CHECK(validation::is_oriented_manifold(soup.points, soup.triangles, Kernel()));
      ISR_CHECK(validation::boundary_edges(soup.triangles).empty());
      unused += visitor.unused;
    }
  ISR_CHECK(unused < 300);
}

// Whatever the samples are, the result is a closed manifold.
void test_bad_samples()
{
  const Sample clean = sphere_random(1500, 7);
  const double spacing = std::sqrt(4. * PI / 1500.);
  for (double noise : { .1, .2, .5, 1. }) {
    begin_case("noise " + std::to_string(noise));
    Oriented_points samples = with_normals(clean.points, from_origin);
    const Points moved = with_noise(clean.points, noise * spacing, 3);
    for (std::size_t i = 0; i != samples.size(); ++i)
      samples[i].first = moved[i];
    Counting_visitor visitor;
    const Soup soup = checked_lis(samples, visitor);
    ISR_CHECK(visitor.unused < 75);
    if (noise <= .1)
      ISR_CHECK_EQUAL(validation::euler_characteristic(soup.triangles), 2);
  }
  begin_case("flipped normals");
  Oriented_points flipped = with_normals(clean.points, from_origin);
  for (std::size_t i = 0; i < flipped.size(); i += 20)
    flipped[i].second = -flipped[i].second;
  Counting_visitor visitor;
  const Soup soup = checked_lis(flipped, visitor);
  ISR_CHECK_EQUAL(visitor.unused, 0u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(soup.triangles), 2);
  begin_case("outliers");
  Random random(5);
  Oriented_points outliers = with_normals(clean.points, from_origin);
  for (const Point& p : random_cube(15, 9))
    outliers.emplace_back(p, random.unit());
  Counting_visitor outlier_visitor;
  ISR_CHECK(checked_lis(outliers, outlier_visitor).points.size() >= clean.points.size());
  begin_case("random points with random normals");
  Oriented_points noise;
  for (const Point& p : random_cube(1000, 4))
    noise.emplace_back(p, random.unit());
  checked_lis(noise);
}

// Areas that are rounded add up to flows that are not those of a cut.
void test_rounded_areas()
{
  for (const Points& points :
       { hostile::boxes_rotated(300, 1), hostile::boxes_rotated(300, 2), hostile::wedge_thin(300, 1) }) {
    begin_case("a cut through " + std::to_string(points.size()) + " points with rounded areas");
    Counting_visitor visitor;
    const Soup soup = lis(points, params::visitor(std::ref(visitor)));
    ISR_CHECK(validation::is_oriented_manifold(soup.points, soup.triangles, Kernel()));
    ISR_CHECK(validation::boundary_edges(soup.triangles).empty());
    ISR_CHECK_EQUAL(soup.points.size() + visitor.unused, points.size());
  }
}

void test_few_or_flat_points()
{
  const auto up = [](const Point&) { return Vector(0, 0, 2); };
  begin_case("few points");
  Points few = { Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0) };
  for (std::size_t n : { 3u, 2u, 1u, 0u }) {
    few.resize(n);
    ISR_CHECK(lis(with_normals(few, up), oriented_maps()).triangles.size() <= 1);
  }
  begin_case("collinear points");
  Points line;
  for (int i = 0; i != 20; ++i)
    line.emplace_back(i, 2 * i, 3 * i);
  ISR_CHECK(lis(with_normals(line, up), oriented_maps()).triangles.empty());
  begin_case("coplanar points");
  const Soup plane = lis(with_normals(plane_grid(6).points, up), oriented_maps());
  ISR_CHECK_EQUAL(plane.triangles.size(), 72u);
  ISR_CHECK(validation::is_oriented_manifold(plane.points, plane.triangles, Kernel()));
  ISR_CHECK(CGAL::normal(plane.points[plane.triangles[0][0]], plane.points[plane.triangles[0][1]],
                         plane.points[plane.triangles[0][2]])
              .z() > 0.);
  begin_case("one tetrahedron");
  const Points four = { Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1) };
  const Soup tetrahedron = checked_lis(with_normals(four, [](const Point& p) { return p - Point(.2, .2, .2); }));
  ISR_CHECK_EQUAL(tetrahedron.triangles.size(), 4u);
  begin_case("duplicate points");
  Counting_visitor visitor;
  checked_lis(with_normals(repeated(sphere_fibonacci(200).points, 3), from_origin), visitor);
  ISR_CHECK_EQUAL(visitor.duplicates, 400u);
  ISR_CHECK_EQUAL(visitor.unused, 0u);
}

void test_determinism()
{
  begin_case("threads");
  const Oriented_points samples = with_normals(torus(60, 24, .3, 4).points, normal_of_torus);
  const Soup expected = lis(samples, oriented_maps());
  const Soup parallel = lis<CGAL::Parallel_if_available_tag>(samples, oriented_maps());
  ISR_CHECK(parallel.triangles == expected.triangles);
  ISR_CHECK(parallel.points == expected.points);

  begin_case("permutation");
  const std::vector<std::size_t> order = random_order(samples.size(), 2);
  Oriented_points permuted;
  for (std::size_t i : order)
    permuted.push_back(samples[i]);
  ISR_CHECK(canonical(relabeled(lis(permuted, oriented_maps()).triangles, order)) == canonical(expected.triangles));

  begin_case("far from the origin, in small units");
  Oriented_points moved = samples;
  for (Oriented_point& s : moved)
    s.first =
      Point(std::ldexp(s.first.x(), -10) + 4096., std::ldexp(s.first.y(), -10) - 8192., std::ldexp(s.first.z(), -10));
  Counting_visitor visitor;
  const Soup soup = checked_lis(moved, visitor);
  ISR_CHECK_EQUAL(visitor.unused, 0u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(soup.triangles), 0);
}

void test_overloads()
{
  begin_case("mesh and soups");
  const Oriented_points samples = with_normals(sphere_fibonacci(200).points, from_origin);
  const Soup expected = checked_lis(samples);
  CGAL::Surface_mesh<Point> mesh;
  ISR_CHECK(CGAL::lis_reconstruction(samples, mesh, oriented_maps()));
  ISR_CHECK_EQUAL(mesh.number_of_faces(), expected.triangles.size());
  ISR_CHECK(CGAL::is_closed(mesh));
  const auto index = mesh.add_property_map<CGAL::Surface_mesh<Point>::Vertex_index, std::size_t>("v:input_index").first;
  for (const auto v : mesh.vertices())
    ISR_CHECK(mesh.point(v) == samples[index[v]].first);
  // appended to what is there, with triangles of another type
  Points points(3, Point(7, 7, 7));
  std::vector<std::vector<int> > triangles(1, std::vector<int>{ 0, 1, 2 });
  ISR_CHECK(CGAL::lis_reconstruction(samples, points, triangles, oriented_maps()));
  ISR_CHECK_EQUAL(points.size(), 3 + expected.points.size());
  ISR_CHECK_EQUAL(triangles.size(), 1 + expected.triangles.size());
  ISR_CHECK_EQUAL(std::size_t(triangles[1][0]), 3 + expected.triangles[0][0]);
}

void test_refinement()
{
  begin_case("a finer mesh of a sphere");
  const Oriented_points samples = with_normals(sphere_fibonacci(500).points, from_origin);
  const auto np = oriented_maps();
  const Soup coarse = lis(samples, np);
  for (double spacing : { .1, .05 }) {
    const Soup fine = lis(samples, np.grid_spacing(spacing));
    ISR_CHECK(validation::is_oriented_manifold(fine.points, fine.triangles, Kernel()));
    ISR_CHECK_EQUAL(validation::euler_characteristic(fine.triangles), 2);
    double longest = 0., error = 0.;
    for (const Triple& t : fine.triangles)
      for (std::size_t i = 0; i != 3; ++i)
        longest = (std::max)(longest, CGAL::squared_distance(fine.points[t[i]], fine.points[t[(i + 1) % 3]]));
    for (const Point& p : fine.points)
      error = (std::max)(error, std::abs(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1.));
    ISR_CHECK(longest <= spacing * spacing);
    // the middles of the edges of the samples are 3e-3 below the sphere
    ISR_CHECK(error < 5e-4);
    for (std::size_t i = 0; i != coarse.points.size(); ++i)
      ISR_CHECK(fine.points[i] == coarse.points[i]);
    const Soup parallel = lis<CGAL::Parallel_if_available_tag>(samples, np.grid_spacing(spacing));
    ISR_CHECK(parallel.points == fine.points && parallel.triangles == fine.triangles);
  }
  ISR_CHECK(lis(samples, np.grid_spacing(100.)).triangles == coarse.triangles);

  begin_case("added vertices have no input index");
  CGAL::Surface_mesh<Point> mesh;
  CGAL::lis_reconstruction(samples, mesh, np.grid_spacing(.1));
  const auto index = mesh.add_property_map<CGAL::Surface_mesh<Point>::Vertex_index, std::size_t>("v:input_index").first;
  std::size_t from_input = 0;
  for (const auto v : mesh.vertices())
    from_input += index[v] != (std::numeric_limits<std::size_t>::max)() ? 1u : 0u;
  ISR_CHECK_EQUAL(from_input, samples.size());

  begin_case("bad grid spacing");
  for (double spacing :
       { -1., 1e-12, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
    try {
      lis(samples, np.grid_spacing(spacing));
      ISR_CHECK(!"exception");
    } catch (const std::invalid_argument& e) {
      ISR_CHECK(std::string(e.what()).find("grid_spacing") != std::string::npos);
    }
}

// A tube around the z-axis with radius 1, whose normals at the ends have a share that points along it.
Oriented_points tube(int sides, int rings, double height, double share_at_ends)
{
  Oriented_points result;
  for (int i = 0; i != rings; ++i)
    for (int j = 0; j != sides; ++j) {
      const double angle = 2. * CGAL_PI * (j + (i % 2 == 0 ? 0. : .5)) / sides;
      const int end = (i + 1 == rings ? 1 : 0) - (i == 0 ? 1 : 0);
      result.emplace_back(on_circle(angle, 1., height * i), on_circle(angle, 1., end * share_at_ends) - CGAL::ORIGIN);
    }
  return result;
}

void test_boundaries()
{
  // a sphere without its top
  Oriented_points bowl;
  for (const Oriented_point& s : with_normals(sphere_fibonacci(3000).points, from_origin))
    if (s.first.z() < .6)
      bowl.push_back(s);
  begin_case("openings are closed");
  ISR_CHECK_EQUAL(validation::euler_characteristic(checked_lis(bowl).triangles), 2);
  begin_case("openings are kept");
  const Soup open = lis(bowl, params::combine(params::keep_boundaries(true), oriented_maps()));
  ISR_CHECK(validation::is_oriented_manifold(open.points, open.triangles, Kernel()));
  ISR_CHECK_EQUAL(validation::number_of_boundary_loops(open.triangles), 1u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(open.triangles), 1);
  const auto keep = params::combine(params::keep_boundaries(true), oriented_maps());
  begin_case("the ends of a tube are kept");
  const Soup ends = lis(tube(40, 30, .14, 0.), keep);
  ISR_CHECK(validation::is_oriented_manifold(ends.points, ends.triangles, Kernel()));
  ISR_CHECK_EQUAL(validation::number_of_boundary_loops(ends.triangles), 2u);
  ISR_CHECK_EQUAL(validation::boundary_edges(ends.triangles).size(), 80u);

  begin_case("openings of ten edges are kept");
  const Soup narrow = lis(tube(10, 12, .6, 0.), keep);
  ISR_CHECK(validation::is_oriented_manifold(narrow.points, narrow.triangles, Kernel()));
  ISR_CHECK_EQUAL(validation::number_of_boundary_loops(narrow.triangles), 2u);
  ISR_CHECK_EQUAL(validation::boundary_edges(narrow.triangles).size(), 20u);

  begin_case("flat ends that have a share in the normals stay closed");
  ISR_CHECK(validation::boundary_edges(lis(tube(40, 30, .14, 3.), keep).triangles).empty());

  begin_case("ends stay closed if the normals are as near to those with lids as to those without");
  ISR_CHECK(validation::boundary_edges(lis(tube(40, 30, .14, .36), keep).triangles).empty());

  begin_case("a closed surface stays closed");
  for (const Solid& s : { solid(sphere_random(1500, 5), from_origin), box_solid(box_varying_spacing(20)) })
    ISR_CHECK(validation::boundary_edges(
                lis(s.points, params::combine(params::keep_boundaries(true), oriented_maps())).triangles)
                .empty());
}

// The convex hull of a sheet has the inside of the sheet on one side: what would close it there lies on the sheet.
void test_sheets()
{
  const auto normal_of_hills = [](const Point& p) {
    return Vector(-.25 * std::cos(.25 * p.x()) * std::cos(.2 * p.y()),
                  .2 * std::sin(.25 * p.x()) * std::sin(.2 * p.y()), 1.);
  };
  const Sample hills = hills_in_rows(24, 500, 1);
  const Oriented_points samples = with_normals(hills.points, normal_of_hills);
  for (const bool keep : { false, true }) {
    begin_case(hills.name + (keep ? ", boundaries kept" : ""));
    Counting_visitor visitor;
    const Soup soup =
      lis(samples, params::combine(params::keep_boundaries(keep), params::visitor(std::ref(visitor)), oriented_maps()));
    ISR_CHECK(validation::is_oriented_manifold(soup.points, soup.triangles, Kernel()));
    ISR_CHECK_EQUAL(visitor.unused, 0u);
    ISR_CHECK_EQUAL(validation::number_of_components(soup.triangles), 1u);
    ISR_CHECK(validation::boundary_edges(soup.triangles).size() >= 500);
    if (keep)
      ISR_CHECK_EQUAL(validation::number_of_boundary_loops(soup.triangles), 2u);
    for (const auto& t : soup.triangles)
      ISR_CHECK(CGAL::normal(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]).z() > 0.);
  }
}

void test_cancel()
{
  begin_case("cancel at every step");
  const Oriented_points samples = with_normals(sphere_fibonacci(2000).points, from_origin);
  std::size_t calls = 0;
  double last = 0.;
  lis(samples, params::combine(oriented_maps(), params::callback(std::function<bool(double)>([&](double x) {
                                 ISR_CHECK(x >= last && x <= 1.);
                                 last = x;
                                 ++calls;
                                 return true;
                               }))));
  ISR_CHECK_EQUAL(last, 1.);
  for (std::size_t stop = 0; stop != calls; ++stop) {
    std::size_t count = 0;
    const std::function<bool(double)> callback = [&](double) { return count++ != stop; };
    CGAL::Surface_mesh<Point> mesh;
    ISR_CHECK(!CGAL::lis_reconstruction(samples, mesh, params::combine(oriented_maps(), params::callback(callback))));
    ISR_CHECK(mesh.is_empty());
  }
}

} // namespace

int main()
{
  test_closed_surfaces();
  test_without_normals();
  test_normals_inward();
  test_lengths_of_normals();
  test_normals_without_sides();
  test_bad_samples();
  test_rounded_areas();
  test_few_or_flat_points();
  test_determinism();
  test_overloads();
  test_refinement();
  test_boundaries();
  test_sheets();
  test_cancel();
  return result();
}

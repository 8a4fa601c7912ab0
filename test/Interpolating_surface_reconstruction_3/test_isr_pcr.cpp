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

// pcr_reconstruction() on known surfaces: guarantees, topology, the order of the growth, regularity,
// independence of threads and of the order of the points, cancellation, and bad input.

#include "isr_test_pcr.h"

#include <CGAL/Interpolating_surface_reconstruction_3/Regularity_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_measures.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Projection_traits_xy_3.h>
#include <CGAL/Surface_mesh.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <limits>
#include <set>
#include <stdexcept>

using namespace isr_test;

void test_closed(const Sample& s)
{
  begin_case(s.name);
  Counting_visitor visitor;
  const Triples triples = checked_pcr(s.points, visitor, params::keep_boundaries(false));
  check_topology(s, triples, visitor);
  ISR_CHECK_EQUAL(triples.size(), 2 * (s.points.size() - std::size_t(s.euler)));
  ISR_CHECK(are_outward(s.points, triples));
}

void test_with_boundaries(const Sample& s)
{
  begin_case(s.name + ", boundaries kept");
  Counting_visitor visitor;
  check_topology(s, checked_pcr(s.points, visitor, params::keep_boundaries(true)), visitor);
}

void test_surfaces()
{
  const Sample closed[] = { sphere_fibonacci(2000),    sphere_random(1500, 1),   sphere_uv(40, 20),
                            torus(60, 24, 0., 1),      torus(60, 24, .2, 2),     knot(200, 12),
                            double_torus(.05, 1),      box(12, 12, 12),          box(12, 7, 3),
                            box_jittered(12, .3, 1),   two_boxes(8, 4.),         cone(20, 2.),
                            torus_in_rows(32, 128, 1), torus_in_rows(32, 512, 1) };
  for (const Sample& s : closed)
    test_closed(s);
  for (const Sample& s : solids_of_few_points())
    test_closed(s);
  const Sample open[] = { plane_grid(20), two_plates(12, 5.), cylinder_open(20, 40), hills_in_rows(24, 500, 1),
                          sphere_with_opening(4000, .8) };
  for (const Sample& s : open)
    test_with_boundaries(s);
}

// Records what happens during the growth.
struct Growth_recorder : Counting_visitor
{
  bool is_growing = false;
  Triples attached;
  std::size_t items = 0;

  void on_stage_begin(isr::Stage stage)
  {
    Counting_visitor::on_stage_begin(stage);
    is_growing = stage == isr::Stage::GROWING;
  }
  void on_triangle(const Triple& t, isr::Triangle_verdict verdict)
  {
    if (is_growing && verdict == isr::Triangle_verdict::ADDED)
      attached.push_back(t);
  }
  void on_stage_end(isr::Stage stage, std::size_t n)
  {
    Counting_visitor::on_stage_end(stage, n);
    if (stage == isr::Stage::GROWING)
      items = n;
    is_growing = false;
  }
};

Triples grown(const Points& points)
{
  Growth_recorder recorder;
  checked_pcr(points, recorder, params::keep_boundaries(true));
  return recorder.attached;
}

std::size_t number_of_seeds(const Triples& attached)
{
  std::set<std::array<std::size_t, 2> > edges;
  std::size_t seeds = 0;
  for (const Triple& t : attached) {
    bool is_adjacent = false;
    for (std::size_t i = 0; i != 3; ++i) {
      const std::size_t p = t[i], q = t[(i + 1) % 3];
      const std::array<std::size_t, 2> edge{ { (std::min)(p, q), (std::max)(p, q) } };
      is_adjacent = !edges.insert(edge).second || is_adjacent;
    }
    seeds += is_adjacent ? 0u : 1u;
  }
  return seeds;
}

// Every triangle is attached to an edge of those before it, but for one seed a component.
void test_growth_is_connected()
{
  begin_case("the growth is connected");
  ISR_CHECK_EQUAL(number_of_seeds(grown(sphere_fibonacci(1000).points)), 1u);
  ISR_CHECK_EQUAL(number_of_seeds(grown(torus(60, 24, 0., 1).points)), 1u);
  ISR_CHECK_EQUAL(number_of_seeds(grown(two_boxes(8, 4.).points)), 2u);

  begin_case("the growth is the surface where stars agree");
  Growth_recorder recorder;
  const Sample s = sphere_fibonacci(1000);
  const Triples triples = checked_pcr(s.points, recorder, params::keep_boundaries(false));
  ISR_CHECK_EQUAL(recorder.items, triples.size());
  ISR_CHECK(validation::is_consistently_oriented(recorder.attached));
  const auto sorted = [](Triples list) {
    for (Triple& t : list)
      std::sort(t.begin(), t.end());
    std::sort(list.begin(), list.end());
    return list;
  };
  ISR_CHECK(sorted(recorder.attached) == sorted(triples));
}

// A plate with a bump in the middle: the height is 0 outside of the bump's radius.
Points plate_with_bump(std::size_t n, double radius)
{
  Points points;
  Random random(7);
  for (std::size_t i = 0; i != n; ++i)
    for (std::size_t j = 0; j != n; ++j) {
      const double half = double(n - 1) / 2.;
      const double x = double(i) - half + random.uniform(-.2, .2), y = double(j) - half + random.uniform(-.2, .2);
      const double squared = (x * x + y * y) / (radius * radius);
      points.emplace_back(x, y, squared < 1. ? radius * std::pow(1. - squared, 2) : 0.);
    }
  return points;
}

// 3.2.1: flat regions come first. Without the priority, the front would reach the bump from one side
// before it has gone round it.
void test_flat_regions_come_first()
{
  begin_case("flat regions are meshed first");
  const Points points = plate_with_bump(41, 6.);
  const Triples attached = grown(points);
  std::size_t flat = 0, curved = 0, last_flat = 0, first_curved = attached.size();
  for (std::size_t i = 0; i != attached.size(); ++i) {
    const Triple& t = attached[i];
    if (points[t[0]].z() == 0. && points[t[1]].z() == 0. && points[t[2]].z() == 0.) {
      ++flat;
      last_flat = i;
    } else {
      ++curved;
      first_curved = (std::min)(first_curved, i);
    }
  }
  ISR_CHECK(flat > 2000 && curved > 150);
  ISR_CHECK(last_flat < first_curved);

  begin_case("a face of a box is finished before the growth turns round an edge");
  const Points box_points = box_jittered(12, .3, 1).points;
  std::vector<int> faces;
  for (const Triple& t : grown(box_points))
    for (int side = 0; side != 6; ++side)
      if (std::all_of(t.begin(), t.end(),
                      [&](std::size_t p) { return box_points[p][side / 2] == (side % 2 == 0 ? 0. : 12.); }) &&
          (faces.empty() || faces.back() != side))
        faces.push_back(side);
  std::set<int> finished(faces.begin(), faces.end());
  ISR_CHECK_EQUAL(finished.size(), 6u);
  ISR_CHECK_EQUAL(faces.size(), 6u);
}

// Mean of Eq. 3.1 over triangles given by their points.
double mean_regularity(const std::vector<std::array<Point, 3> >& triangles)
{
  using CGAL::Interpolating_surface_reconstruction_3::internal::Local_point;
  const auto local = [](const Point& p) { return Local_point(p.x(), p.y(), p.z()); };
  double sum = 0.;
  for (const auto& t : triangles)
    sum += CGAL::Interpolating_surface_reconstruction_3::internal::regularity(local(t[0]), local(t[1]), local(t[2]));
  return sum / double(triangles.size());
}

void test_regularity()
{
  for (const std::uint64_t seed : { 1u, 2u, 3u }) {
    begin_case("regularity of a flat random sample, seed " + std::to_string(seed));
    const Points points = plane_random(2000, seed).points;
    std::vector<std::array<Point, 3> > ours, delaunay;
    for (const Triple& t : pcr(points, params::keep_boundaries(true)))
      ours.push_back({ { points[t[0]], points[t[1]], points[t[2]] } });
    const CGAL::Delaunay_triangulation_2<CGAL::Projection_traits_xy_3<Kernel> > triangulation(points.begin(),
                                                                                              points.end());
    for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
      delaunay.push_back({ { f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point() } });
    ISR_CHECK(double(ours.size()) > .98 * double(delaunay.size()));
    ISR_CHECK(mean_regularity(ours) >= .99 * mean_regularity(delaunay));
  }
}

void test_independence(const std::string& name, const Points& points)
{
  begin_case(name + ": order of the points, threads");
  const Triples expected = checked_pcr(points);
  const std::vector<std::size_t> order = random_order(points.size(), 5);
  ISR_CHECK(relabeled(pcr(permuted(points, order)), order) == expected);
#ifdef CGAL_LINKED_WITH_TBB
  for (const std::size_t threads : { std::size_t(1), std::size_t(2), std::size_t(4) }) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    ISR_CHECK(pcr<CGAL::Parallel_tag>(points, params::keep_boundaries(false)) == expected);
  }
#endif
}

void test_independence()
{
  test_independence("random sphere", sphere_random(8000, 1).points);
  test_independence("regular torus", torus(60, 24, 0., 1).points);
  test_independence("noise", with_noise(sphere_fibonacci(2000).points, .05, 1));
  test_independence("random cube", random_cube(500, 1));
  test_independence("box of varying spacing", box_varying_spacing(12).points);
}

// Ends the run when the growth has attached a number of triangles.
struct Growth_stopper : Counting_visitor
{
  std::size_t attached = 0, last = 0;
  void on_triangle(const Triple&, isr::Triangle_verdict) { ++attached; }
  bool go_further() { return attached < last; }
};

void test_cancel()
{
  const Points points = sphere_fibonacci(5000).points;
  for (const std::size_t last : { std::size_t(1), std::size_t(5000) }) {
    begin_case("cancelled after " + std::to_string(last) + " triangles");
    Growth_stopper stopper;
    stopper.last = last;
    ISR_CHECK(pcr(points, params::visitor(std::ref(stopper))).empty());
    ISR_CHECK(stopper.was_cancelled && stopper.ended == 1);
    ISR_CHECK(stopper.attached >= last && stopper.attached < last + 2048);
    CGAL::Surface_mesh<Point> mesh;
    stopper.attached = 0;
    ISR_CHECK(!CGAL::pcr_reconstruction(points, mesh, params::visitor(std::ref(stopper))));
    ISR_CHECK(mesh.is_empty());
  }

  begin_case("progress");
  std::vector<double> values;
  const std::function<bool(double)> record = [&](double value) {
    values.push_back(value);
    return true;
  };
  pcr(points, params::callback(record));
  ISR_CHECK(std::is_sorted(values.begin(), values.end()));
  ISR_CHECK(!values.empty() && values.front() >= 0. && values.back() == 1.);
}

template <typename NamedParameters>
void check_throws(const std::string& parameter, const NamedParameters& np)
{
  const Points points = sphere_fibonacci(100).points;
  Triples triples;
  std::string message;
  try {
    CGAL::pcr_reconstruction(points, std::back_inserter(triples), np);
  } catch (const std::invalid_argument& e) {
    message = e.what();
  }
  ISR_CHECK(message.find(parameter) != std::string::npos);
  ISR_CHECK(triples.empty());
}

void test_parameters()
{
  begin_case("bad parameters");
  check_throws("neighbor_radius", params::neighbor_radius(-1.));
  check_throws("neighbor_radius", params::neighbor_radius(std::numeric_limits<double>::quiet_NaN()));
  check_throws("maximum_hole_size", params::maximum_hole_size(-1));

  begin_case("maximum hole size");
  const Points cylinder = cylinder_open(20, 40).points;
  ISR_CHECK_EQUAL(validation::number_of_boundary_loops(pcr(cylinder, params::maximum_hole_size(39))), 2u);
  ISR_CHECK_EQUAL(validation::number_of_boundary_loops(pcr(cylinder, params::maximum_hole_size(40))), 0u);

  begin_case("neighbor radius");
  const Points sphere = sphere_fibonacci(1000).points;
  ISR_CHECK(pcr(sphere, params::neighbor_radius(10.)) == pcr(sphere));
  ISR_CHECK(pcr(sphere, params::neighbor_radius(.001)).empty());

  begin_case("star construction of the thesis");
  const Sample s = torus(40, 16, .2, 3);
  Counting_visitor visitor;
  check_topology(s, checked_pcr(s.points, visitor, params::star_construction(isr::Regularity_star_3())), visitor);
}

void test_mesh()
{
  begin_case("mesh");
  const Points points = torus(40, 16, .2, 3).points;
  CGAL::Surface_mesh<Point> mesh;
  ISR_CHECK(CGAL::pcr_reconstruction(points, mesh));
  ISR_CHECK_EQUAL(mesh.number_of_faces(), pcr(points).size());
  ISR_CHECK_EQUAL(mesh.number_of_vertices(), points.size());
}

void test_degenerate()
{
  const Point a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(0, 0, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto number = [](const Points& points) { return checked_pcr(points).size(); };
  begin_case("few points");
  ISR_CHECK_EQUAL(number({}), 0u);
  ISR_CHECK_EQUAL(number({ a }), 0u);
  ISR_CHECK_EQUAL(number({ a, b }), 0u);
  ISR_CHECK_EQUAL(number({ a, b, c }), 1u);
  ISR_CHECK_EQUAL(number({ a, b, c, Point(1, 1.1, 0) }), 2u);
  ISR_CHECK_EQUAL(number({ a, b, c, d }), 4u);
  ISR_CHECK_EQUAL(number({ a, a, b, b, c, c, d, d }), 4u);
  ISR_CHECK_EQUAL(number({ a, b, Point(2, 0, 0), Point(5, 0, 0) }), 0u);
  ISR_CHECK_EQUAL(number({ Point(nan, 0, 0), a, b, Point(0, nan, 0), c, d }), 4u);
  begin_case("guarantees only");
  for (std::uint64_t seed = 1; seed != 4; ++seed) {
    checked_pcr(random_cube(300, seed));
    checked_pcr(with_noise(sphere_fibonacci(500).points, .2, seed));
    checked_pcr(with_outliers(torus(30, 12, .2, seed).points, 20, seed));
  }
  checked_pcr(repeated(random_cube(100, 4), 3));
  checked_pcr(plane_random(300, 1).points);
  checked_pcr(two_plates(12, .5).points);
  checked_pcr(moebius_strip(60, 6));
  checked_pcr(klein_bottle(60, 30));
  checked_pcr(wedge(16, .2).points);
  checked_pcr(translated(scaled(sphere_fibonacci(500).points, 1e-3), Vector(1e6, 1e6, 1e6)));
}

int main()
{
  test_surfaces();
  test_growth_is_connected();
  test_flat_regions_come_first();
  test_regularity();
  test_independence();
  test_cancel();
  test_parameters();
  test_mesh();
  test_degenerate();
  return result();
}

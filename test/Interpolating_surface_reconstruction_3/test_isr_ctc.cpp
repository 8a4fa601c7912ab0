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

// End to end: surfaces of known topology.

#include "isr_test_ctc.h"
#include "isr_test_self_intersections.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Regularity_star_3.h>

using namespace isr_test;

void test_closed(const Sample& s)
{
  begin_case(s.name);
  Counting_visitor visitor;
  const Triples triples = checked_ctc(s.points, visitor, params::keep_boundaries(false));
  check_topology(s, triples, visitor);
  ISR_CHECK(are_outward(s.points, triples));
}

void test_with_boundaries(const Sample& s)
{
  begin_case(s.name + ", boundaries kept");
  Counting_visitor visitor;
  const Triples triples = checked_ctc(s.points, visitor, params::keep_boundaries(true));
  check_topology(s, triples, visitor);
}

void test_closed_surfaces()
{
  const Sample samples[] = { sphere_fibonacci(2000),    sphere_random(1500, 1),   sphere_uv(40, 20),
                             torus(60, 24, 0., 1),      torus(60, 24, .2, 2),     knot(200, 12),
                             double_torus(.05, 1),      box(12, 12, 12),          box(12, 7, 3),
                             box_jittered(12, .3, 1),   two_boxes(8, 4.),         cone(20, 2.),
                             torus_in_rows(32, 128, 1), torus_in_rows(32, 512, 1) };
  for (const Sample& s : samples)
    test_closed(s);
}

void test_few_points()
{
  for (const Sample& s : solids_of_few_points())
    test_closed(s);
}

// A closed surface has no boundary to keep.
void test_surfaces_with_boundaries()
{
  const Sample samples[] = { plane_grid(20),       two_plates(12, 5.), cylinder_open(20, 40),    sphere_fibonacci(2000),
                             torus(60, 24, 0., 1), box(12, 12, 12),    hills_in_rows(24, 500, 1) };
  for (const Sample& s : samples)
    test_with_boundaries(s);
  Sample s = plane_grid(20);
  s.points = rotated(s.points, .7);
  s.name = "rotated plane grid";
  test_with_boundaries(s);
}

// The stars around an opening see across it, or conflict there where the points are noisy.
void test_openings()
{
  constexpr std::size_t N = 4000;
  const double spacing = std::sqrt(4. * PI / double(N));
  for (const double noise : { 0., .1, .3 }) {
    Sample s = sphere_with_opening(N, .8);
    s.name += ", noise " + std::to_string(noise);
    s.points = with_noise(s.points, noise * spacing, 1);
    test_with_boundaries(s);
  }
}

// Noise on the half that is far from the opening.
void test_crossings_beside_opening()
{
  begin_case("crossings beside an opening, boundaries kept");
  constexpr std::size_t N = 3000;
  Sample s = sphere_with_opening(N, .6);
  const Points noisy = with_noise(s.points, .8 * std::sqrt(4. * PI / double(N)), 1);
  for (std::size_t i = 0; i != s.points.size(); ++i)
    if (s.points[i].z() < 0.)
      s.points[i] = noisy[i];
  Counting_visitor visitor;
  const Triples triples = checked_ctc(s.points, visitor, params::keep_boundaries(true));
  ISR_CHECK_EQUAL(validation::number_of_boundary_loops(triples), 1u);
  ISR_CHECK(!has_self_intersection(s.points, triples));
}

// The stars at the corners of plates see as far as 4 spacings, and so reach a plate that near: a known
// limitation. The guarantees hold all the same.
void test_close_plates()
{
  for (const double gap : { 2., 3., 4. }) {
    const Sample s = two_plates(12, gap);
    begin_case(s.name + ", boundaries kept, guarantees only");
    Counting_visitor visitor;
    checked_ctc(s.points, visitor, params::keep_boundaries(true));
    ISR_CHECK_EQUAL(visitor.unused, 0u);
  }
}

void test_plane_grid_is_exact()
{
  begin_case("plane grid, exact boundary");
  const std::size_t n = 20;
  const Triples triples = ctc(plane_grid(n).points, params::keep_boundaries(true));
  ISR_CHECK_EQUAL(triples.size(), 2 * n * n);
  ISR_CHECK_EQUAL(validation::boundary_edges(triples).size(), 4 * n);
}

// Also where the points are cocircular, and cospherical.
void test_grid_has_diagonals_of_delaunay_triangulation()
{
  begin_case("grid, diagonals of the Delaunay triangulation");
  using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
  const Sample s = box(9, 7, 5);
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (const Point& p : s.points)
    vertices.push_back(triangulation.insert(p));
  std::size_t facets = 0;
  const Triples triples = ctc(s.points);
  for (const Triple& t : triples) {
    Triangulation::Cell_handle cell;
    int i = 0, j = 0, k = 0;
    facets += triangulation.is_facet(vertices[t[0]], vertices[t[1]], vertices[t[2]], cell, i, j, k) ? 1u : 0u;
  }
  ISR_CHECK_EQUAL(facets, triples.size());
}

// The ends of the cylinder have 40 edges each.
void test_maximum_hole_size()
{
  begin_case("maximum hole size");
  const Sample s = cylinder_open(20, 40);
  for (const std::size_t size : { std::size_t(0), std::size_t(39), std::size_t(1000) }) {
    const Triples triples = ctc(s.points, params::maximum_hole_size(size));
    ISR_CHECK(validation::is_oriented_manifold(s.points, triples, Kernel()));
    ISR_CHECK_EQUAL(validation::number_of_boundary_loops(triples), size == 1000 ? 0u : 2u);
  }
}

void test_orientation_follows_normals()
{
  begin_case("orientation follows normals");
  const Sample s = sphere_fibonacci(1000);
  for (const double length : { 1., -1., 1e300, -1e-300 }) {
    std::vector<std::pair<Point, Vector> > oriented;
    for (const Point& p : s.points)
      oriented.emplace_back(p, length * (p - CGAL::ORIGIN));
    const Triples triples =
      ctc(oriented, params::point_map(CGAL::First_of_pair_property_map<std::pair<Point, Vector> >())
                      .normal_map(CGAL::Second_of_pair_property_map<std::pair<Point, Vector> >()));
    ISR_CHECK(validation::is_oriented_manifold(s.points, triples, Kernel()));
    ISR_CHECK_EQUAL(validation::number_of_components(triples), 1u);
    ISR_CHECK((length > 0.) == (volumes_of_components(s.points, triples).front() > 0.));
  }
}

void test_neighbor_radius()
{
  begin_case("neighbor radius");
  const Sample s = sphere_fibonacci(1000);
  // spacing is about 0.11: a generous radius changes nothing, a tiny one leaves no neighbors
  ISR_CHECK(canonical(ctc(s.points, params::neighbor_radius(10.))) == canonical(ctc(s.points)));
  ISR_CHECK(ctc(s.points, params::neighbor_radius(.001)).empty());
  ISR_CHECK(ctc(s.points, params::neighbor_radius(0.)) == ctc(s.points));
}

// What would close it crosses it: it stays open without being asked to.
void test_terrain()
{
  begin_case("terrain");
  constexpr std::size_t N = 45;
  Points points = with_noise(plane_grid(N).points, .3, 11);
  for (Point& p : points)
    p = Point(p.x(), p.y(), 3. * std::sin(p.x() / 7.) * std::cos(p.y() / 5.));
  Counting_visitor visitor;
  const Triples triples = checked_ctc(points, visitor, params::keep_boundaries(false));
  ISR_CHECK_EQUAL(visitor.unused, 0u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(triples), 1);
  ISR_CHECK_EQUAL(validation::number_of_boundary_loops(triples), 1u);
  ISR_CHECK(!has_self_intersection(points, triples));
}

void test_star_construction()
{
  begin_case("star construction");
  const Sample s = torus(40, 16, .2, 3);
  ISR_CHECK(ctc(s.points, params::star_construction(isr::Restricted_voronoi_star_3())) == ctc(s.points));

  begin_case("star construction of the thesis");
  Counting_visitor visitor;
  check_topology(s, checked_ctc(s.points, visitor, params::star_construction(isr::Regularity_star_3())), visitor);
}

int main()
{
  test_closed_surfaces();
  test_few_points();
  test_surfaces_with_boundaries();
  test_openings();
  test_crossings_beside_opening();
  test_close_plates();
  test_plane_grid_is_exact();
  test_grid_has_diagonals_of_delaunay_triangulation();
  test_maximum_hole_size();
  test_orientation_follows_normals();
  test_neighbor_radius();
  test_terrain();
  test_star_construction();
  return result();
}

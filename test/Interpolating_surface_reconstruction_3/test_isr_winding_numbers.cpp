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

// Winding numbers, normals that are made consistent with them, and surfaces that these decide.

#include "isr_stage_test_utils.h"
#include "isr_surface_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Component_contacts.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Component_reunion.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Conflict_relabelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Dipole_view.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Normal_consistency.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Winding_number_fit.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

using namespace isr_test;
using isr_internal::Cell_complex;
using isr_internal::Component_contacts;
using isr_internal::Component_reunion;
using isr_internal::Conflict_relabelling;
using isr_internal::Dipole_view;
using isr_internal::Kept_triangulation;
using isr_internal::Local_point;
using isr_internal::Local_vector;
using isr_internal::Normal_consistency;
using isr_internal::Point_octree_3;
using isr_internal::Winding_number_fit;
using isr_stage_test::Indexed_points;

namespace {

// Of the points of a sphere around the origin: outward.
std::vector<Local_vector> sphere_areas(const std::vector<Local_point>& points)
{
  std::vector<Local_vector> result;
  for (const Local_point& p : points)
    result.push_back(4. * PI / double(points.size()) * (p - Local_point(0, 0, 0)));
  return result;
}

std::vector<Point_index> all_indices(std::size_t n)
{
  std::vector<Point_index> result(n);
  std::iota(result.begin(), result.end(), Point_index(0));
  return result;
}

// In degrees.
double deviation(const Local_vector& a, const Local_vector& b)
{
  const double cosine = a * b / std::sqrt(a.squared_length() * b.squared_length());
  return std::acos((std::max)(-1., (std::min)(1., cosine))) * 180. / PI;
}

double largest_deviation(const std::vector<Local_vector>& areas, const std::vector<Local_vector>& from)
{
  double result = 0.;
  for (std::size_t k = 0; k != areas.size(); ++k)
    result = (std::max)(result, deviation(areas[k], from[k]));
  return result;
}

double sum_of_deviations(const std::vector<Local_vector>& areas, const std::vector<Local_vector>& from)
{
  double result = 0.;
  for (std::size_t k = 0; k != areas.size(); ++k)
    result += deviation(areas[k], from[k]);
  return result;
}

double winding_number(const std::vector<Local_point>& points, const std::vector<Local_vector>& areas,
                      const Local_point& x)
{
  double result = 0.;
  for (std::size_t k = 0; k != points.size(); ++k)
    result += Dipole_view(points[k] - x, 0.).potential(areas[k]);
  return result / (4. * PI);
}

void test_dipoles()
{
  begin_case("winding numbers of a sphere");
  const std::vector<Local_point> points = isr_stage_test::sphere(2000, 0., 1);
  const std::vector<Local_vector> areas = sphere_areas(points);
  ISR_CHECK(std::abs(winding_number(points, areas, Local_point(0, 0, 0)) - 1.) < 1e-9);
  ISR_CHECK(std::abs(winding_number(points, areas, Local_point(.5, .3, -.2)) - 1.) < 1e-3);
  ISR_CHECK(std::abs(winding_number(points, areas, Local_point(1.2, .9, 0))) < 1e-3);

  begin_case("the field is the slope of the potential");
  const Local_vector area(.3, -.2, .5), to_dipole(.7, .4, -.6);
  const double step = 1e-6, softening = .04;
  const auto potential = [&](const Local_vector& d) { return Dipole_view(to_dipole + d, softening).potential(area); };
  const Local_vector field = Dipole_view(to_dipole, softening).field(area);
  ISR_CHECK(std::abs(field.x() -
                     (potential(Local_vector(step, 0, 0)) - potential(Local_vector(-step, 0, 0))) / (2 * step)) < 1e-8);
  ISR_CHECK(std::abs(field.y() -
                     (potential(Local_vector(0, step, 0)) - potential(Local_vector(0, -step, 0))) / (2 * step)) < 1e-8);
  ISR_CHECK(std::abs(field.z() -
                     (potential(Local_vector(0, 0, step)) - potential(Local_vector(0, 0, -step))) / (2 * step)) < 1e-8);
  ISR_CHECK(std::abs(Dipole_view(to_dipole, softening).direction() * area - potential(Local_vector(0, 0, 0))) < 1e-15);
}

void test_consistency()
{
  const std::vector<Local_point> points = isr_stage_test::sphere(600, .02, 2);
  const Cell_complex cells(points, all_indices(points.size()));
  const std::vector<Local_vector> right = sphere_areas(points);
  isr_internal::No_cancellation never;
  Normal_consistency make_consistent(points);
  make_consistent.set_cells(cells, never);

  begin_case("consistent normals stay");
  std::vector<Local_vector> areas = right;
  make_consistent(areas, never);
  ISR_CHECK(largest_deviation(areas, right) < 10.);
  for (std::size_t k = 0; k != areas.size(); ++k)
    ISR_CHECK(std::abs(areas[k].squared_length() / right[k].squared_length() - 1.) < 1e-9);

  begin_case("single normals turn to those around them");
  areas = right;
  for (std::size_t k = 0; k < areas.size(); k += 20)
    areas[k] = Local_vector(areas[k].y(), areas[k].z(), areas[k].x());
  const double before = largest_deviation(areas, right);
  make_consistent(areas, never);
  ISR_CHECK(before > 80.);
  ISR_CHECK(largest_deviation(areas, right) < .8 * before);

  begin_case("all the other way round");
  areas = right;
  for (Local_vector& a : areas)
    a = -a;
  std::vector<Local_vector> turned = areas;
  make_consistent(turned, never);
  ISR_CHECK(largest_deviation(turned, areas) < 10.);

  begin_case("points without a surface");
  areas.assign(points.size(), Local_vector(0, 0, 0));
  make_consistent(areas, never);
  ISR_CHECK(std::all_of(areas.begin(), areas.end(), [](const Local_vector& a) { return a == Local_vector(0, 0, 0); }));
}

// Half of a sphere tells the other half.
void test_unknown()
{
  begin_case("unknown normals");
  const std::vector<Local_point> points = isr_stage_test::sphere(600, .02, 4);
  const Cell_complex cells(points, all_indices(points.size()));
  const std::vector<Local_vector> right = sphere_areas(points);
  isr_internal::No_cancellation never;
  Normal_consistency find_normals(points);
  find_normals.set_cells(cells, never);
  std::vector<Local_vector> areas = right;
  std::vector<unsigned char> is_unknown;
  for (std::size_t k = 0; k != points.size(); ++k) {
    is_unknown.push_back(points[k].z() < 0. ? 1 : 0);
    if (is_unknown[k])
      areas[k] = Local_vector(right[k].y(), right[k].z(), -right[k].x()); // must not matter
  }
  find_normals.find_unknown(is_unknown, areas, never);
  for (std::size_t k = 0; k != areas.size(); ++k)
    if (is_unknown[k]) {
      ISR_CHECK(deviation(areas[k], right[k]) < 45.);
      ISR_CHECK(std::abs(areas[k].squared_length() / right[k].squared_length() - 1.) < 1e-9);
    } else {
      ISR_CHECK(areas[k] == right[k]);
    }

  begin_case("none are known");
  std::fill(is_unknown.begin(), is_unknown.end(), static_cast<unsigned char>(1));
  find_normals.find_unknown(is_unknown, areas, never);
  ISR_CHECK(std::all_of(areas.begin(), areas.end(), [](const Local_vector& a) { return a == Local_vector(0, 0, 0); }));
}

// A cap of a sphere whose normals are those of a lid below it: neighbors agree on it, the winding number does not.
void test_fit()
{
  begin_case("a cap that faces down");
  const Indexed_points sphere(isr_stage_test::sphere(600, .02, 3));
  const std::vector<Local_vector> right = sphere_areas(sphere.points);
  std::vector<Local_vector> areas = right;
  std::vector<Point_index> doubts;
  for (Point_index p = 0; p != areas.size(); ++p) {
    if (sphere.points[p].z() > .8)
      areas[p] = std::sqrt(areas[p].squared_length()) * Local_vector(.8, 0, -.6);
    if (sphere.points[p].z() > .6)
      doubts.push_back(p);
  }
  const std::vector<Local_vector> before = areas;
  const std::vector<Point_index> all = all_indices(areas.size());
  isr_internal::No_cancellation never;
  Winding_number_fit(sphere.points, sphere.octree, all)(doubts, areas, never);
  ISR_CHECK(largest_deviation(before, right) > 90.);
  ISR_CHECK(sum_of_deviations(areas, right) < .5 * sum_of_deviations(before, right));
  for (Point_index p = 0; p != areas.size(); ++p)
    if (!std::binary_search(doubts.begin(), doubts.end(), p))
      ISR_CHECK(areas[p] == before[p]);
}

// An ellipsoid, cut in two by caps: cells across z = `height` are outside.
Triples cut_surface(const Hand_surface& s, double height)
{
  return surface_of_labels(s, [&](const Cell_complex::Cell& c) {
    if (Cell_complex::is_infinite(c))
      return 0;
    const auto below = std::count_if(c.vertices.begin(), c.vertices.end(),
                                     [&](Point_index p) { return s.cloud.positions()[p].z() < height; });
    return below == 4 ? 1 : below == 0 ? 2 : 0;
  });
}

bool reunite(Hand_surface& s)
{
  const Point_octree_3 octree(s.cloud.positions());
  Kept_triangulation triangulation(s.cloud.positions());
  return Component_reunion<CGAL::Sequential_tag, Hand_surface::Builder>(s.cloud.positions(), octree, s.builder,
                                                                        triangulation)(no_progress);
}

std::size_t number_of_components(Hand_surface& s)
{
  return Component_contacts(s.cloud.positions(), triangles_of(s, s.triangles())).size();
}

void test_reunion()
{
  begin_case("an end that is cut off");
  Points points = sphere_fibonacci(300).points;
  for (Point& p : points)
    p = Point(.4 * p.x(), .4 * p.y(), 1.5 * p.z());
  Hand_surface s(points);
  const double low = s.cloud.positions()[s.indices.back()].z(), high = s.cloud.positions()[s.indices.front()].z();
  const Triples before = cut_surface(s, (std::min)(low, high) + .7 * std::abs(high - low));
  ISR_CHECK(s.add(before));
  ISR_CHECK_EQUAL(number_of_components(s), 2u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(before), 4);
  ISR_CHECK(reunite(s));
  const Triples after = s.triangles();
  ISR_CHECK(validation::is_oriented_manifold(points, after, Kernel()));
  ISR_CHECK(validation::boundary_edges(after).empty());
  ISR_CHECK_EQUAL(validation::used_points(after).size(), points.size());
  ISR_CHECK_EQUAL(number_of_components(s), 1u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(after), 2);
  ISR_CHECK(!reunite(s)); // nothing is left to do

  begin_case("two bodies");
  Mesh mesh = globe(12, 20);
  append(mesh, globe(12, 20, Point(2.1, 0, 0)));
  Hand_surface bodies(mesh.points);
  ISR_CHECK(bodies.add(mesh.triples));
  Component_contacts contacts(bodies.cloud.positions(), triangles_of(bodies, mesh.triples));
  isr_internal::No_cancellation never;
  contacts.find(Point_octree_3(bodies.cloud.positions()), never);
  ISR_CHECK(!contacts.near().empty()); // so that they are tried
  ISR_CHECK_EQUAL(number_of_components(bodies), 2u);
  ISR_CHECK(!reunite(bodies));
  ISR_CHECK(canonical(bodies.triangles()) == canonical(mesh.triples));
}

using Relabelling = Conflict_relabelling<CGAL::Sequential_tag, Hand_surface::Builder>;

bool relabel(Hand_surface& s)
{
  Kept_triangulation triangulation(s.cloud.positions());
  Relabelling relabelling(s.cloud.positions(), s.builder, triangulation);
  return relabelling(no_progress) && relabelling.keep_if_better();
}

// An ellipsoid that is cut in two by caps, which is not what most stars around the cut see: each of them has lost a neighbor,
// so that they do not agree.
void test_relabelling()
{
  begin_case("stars vote against a cut");
  Points points = sphere_fibonacci(300).points;
  for (Point& p : points)
    p = Point(.9 * p.x(), p.y(), 1.1 * p.z());
  const Hand_surface whole(points);
  const Triples right =
    surface_of_labels(whole, [](const Cell_complex::Cell& c) { return Cell_complex::is_infinite(c) ? 0 : 1; });
  Links links = links_of(points.size(), right);
  for (std::size_t p = 0; p != points.size(); ++p)
    if (std::abs(points[p].z()) < .3)
      links[p].erase(links[p].begin());
  const auto make = [&](Hand_surface& s, const Triples& triples) {
    const auto is_missing_in = [](const Triples& sorted, const Triple& t) {
      return !std::binary_search(sorted.begin(), sorted.end(), t);
    };
    const Triples wanted = canonical(triples), agreed = canonical(s.triangles());
    for (const Triple& t : agreed)
      if (is_missing_in(wanted, t))
        s.remove(t[0], t[1], t[2]);
    return std::all_of(wanted.begin(), wanted.end(), [&](const Triple& t) {
      return !is_missing_in(agreed, t) || s.add(t[0], t[1], t[2]) == Triangle_verdict::ADDED;
    });
  };
  const double low = whole.cloud.positions()[whole.indices.back()].z(),
               high = whole.cloud.positions()[whole.indices.front()].z();
  const Triples cut = cut_surface(whole, (low + high) / 2.);
  Hand_surface s(points, links);
  ISR_CHECK(make(s, cut));
  ISR_CHECK(canonical(s.triangles()) == canonical(cut));
  ISR_CHECK_EQUAL(number_of_components(s), 2u);
  ISR_CHECK(relabel(s));
  ISR_CHECK_EQUAL(number_of_components(s), 1u);
  const Triples after = s.triangles();
  ISR_CHECK(validation::is_oriented_manifold(points, after, Kernel()));
  ISR_CHECK(validation::boundary_edges(after).empty());
  ISR_CHECK_EQUAL(validation::used_points(after).size(), points.size());
  ISR_CHECK_EQUAL(validation::euler_characteristic(after), 2);
  ISR_CHECK(!relabel(s)); // nothing is left to do

  begin_case("what becomes of the new surface is no better");
  Hand_surface worse(points, links);
  ISR_CHECK(make(worse, cut));
  Kept_triangulation triangulation(worse.cloud.positions());
  Relabelling relabelling(worse.cloud.positions(), worse.builder, triangulation);
  ISR_CHECK(relabelling(no_progress));
  ISR_CHECK_EQUAL(number_of_components(worse), 1u);
  const Triples parts = cut_surface(whole, (3. * low + 2. * high) / 5.);
  ISR_CHECK(make(worse, parts));
  ISR_CHECK_EQUAL(number_of_components(worse), 2u);
  ISR_CHECK(canonical(worse.triangles()) != canonical(cut));
  ISR_CHECK(!relabelling.keep_if_better());
  ISR_CHECK(canonical(worse.triangles()) == canonical(cut));

  begin_case("no stars, no votes");
  Hand_surface voteless(points);
  ISR_CHECK(voteless.add(cut));
  ISR_CHECK(!relabel(voteless));
  ISR_CHECK(canonical(voteless.triangles()) == canonical(cut));

  begin_case("a surface that is not closed");
  Hand_surface open(points, links);
  ISR_CHECK(make(open, cut));
  const auto missing = std::find_if(cut.begin(), cut.end(), [&](const Triple& t) {
    return std::all_of(t.begin(), t.end(), [&](std::size_t p) { return std::abs(points[p].z()) < .3; });
  });
  ISR_CHECK(missing != cut.end());
  open.remove((*missing)[0], (*missing)[1], (*missing)[2]);
  const Triples before = canonical(open.triangles());
  ISR_CHECK_EQUAL(before.size(), cut.size() - 1);
  ISR_CHECK(!relabel(open));
  ISR_CHECK(canonical(open.triangles()) == before);
}

} // namespace

int main()
{
  test_dipoles();
  test_consistency();
  test_unknown();
  test_fit();
  test_reunion();
  test_relabelling();
  return result();
}

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

// Recovery of corners that the surface passes over.

#include "isr_surface_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Corner_recovery.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Corner_test.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Lost_corners.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Steep_search.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

using namespace isr_test;
using isr_internal::Cell_complex;
using isr_internal::Corner_recovery;
using isr_internal::Corner_test;
using isr_internal::Kept_triangulation;
using isr_internal::Local_point;
using isr_internal::Local_vector;
using isr_internal::Lost_corners;
using isr_internal::Point_octree_3;
using isr_internal::Steep_search;

namespace {

// A plate whose points are rows, far from each other.
Points plate_of_rows(std::size_t rows, std::size_t n, double distance)
{
  Points points;
  for (double z : { 0., 4. })
    for (std::size_t row = 0; row != rows; ++row)
      for (std::size_t i = 0; i != n; ++i)
        points.emplace_back(double(i), distance * double(row), z);
  return points;
}

// The ground around a scanner, circles of points nearer to each other than the circles are, and one point over it.
Points ground(double height)
{
  Points points{ Point(0, 0, height) };
  for (std::size_t circle = 1; circle <= 6; ++circle) {
    const std::size_t n = 50 * circle; // a distance of about one
    for (std::size_t i = 0; i != n; ++i)
      points.push_back(on_circle(2. * PI * double(i) / double(n), 8. * double(circle), 0.));
  }
  return points;
}

// The convex hull, with all points on it.
Triples hull(const Hand_surface& s)
{
  return surface_of_labels(s, [](const Cell_complex::Cell& c) { return Cell_complex::is_infinite(c) ? 0 : 1; });
}

std::size_t number_of_corners(const Hand_surface& s, const Triples& triples)
{
  const std::vector<std::array<Point_index, 3> > triangles = triangles_of(s, triples);
  return Lost_corners(s.cloud.positions(), triangles).corners().size();
}

bool recover_corners(Hand_surface& s)
{
  Kept_triangulation triangulation(s.cloud.positions());
  const Point_octree_3 octree(s.cloud.positions());
  return Corner_recovery<CGAL::Sequential_tag, Hand_surface::Builder>(s.cloud.positions(), octree, s.builder,
                                                                      triangulation)(no_progress);
}

void test_corner()
{
  begin_case("flat, with edges of very unlike length");
  const Local_point p(0, 0, 0), near(1, 0, 0), left(0, 9, 0), far(-9, 0, 0), right(0, -9, 0);
  const auto is_lost = [&](const std::vector<Local_point>& around) {
    Corner_test test(p);
    for (std::size_t i = 0; i != around.size(); ++i)
      test.add_facet(around[i], around[(i + 1) % around.size()]);
    return test.is_lost();
  };
  ISR_CHECK(is_lost({ near, left, far, right }));
  ISR_CHECK(!is_lost({ Local_point(4, 0, 0), left, far, right }));
  ISR_CHECK(!is_lost({ near, left, Local_point(-9, 0, 2), right }));
  ISR_CHECK(!is_lost({}));
}

void test_bore()
{
  begin_case("a bore that is closed by caps");
  const std::size_t n = 24;
  const Points points = plate_with_bore(n);
  Hand_surface s(points);
  const Triples before = hull(s);
  ISR_CHECK(s.add(before));
  ISR_CHECK_EQUAL(validation::euler_characteristic(before), 2);
  ISR_CHECK_EQUAL(number_of_corners(s, before), 2 * n);
  ISR_CHECK(recover_corners(s));
  const Triples after = s.triangles();
  ISR_CHECK(validation::is_oriented_manifold(points, after, Kernel()));
  ISR_CHECK(validation::boundary_edges(after).empty());
  ISR_CHECK_EQUAL(validation::used_points(after).size(), points.size());
  ISR_CHECK_EQUAL(validation::euler_characteristic(after), 0);
  ISR_CHECK_EQUAL(number_of_corners(s, after), 0u);
  ISR_CHECK(!recover_corners(s)); // nothing is left to do
}

void test_rows()
{
  begin_case("rows are no corners");
  const Points points = plate_of_rows(8, 30, 8.);
  Hand_surface s(points);
  const Triples before = hull(s);
  ISR_CHECK(s.add(before));
  const std::vector<std::array<Point_index, 3> > triangles = triangles_of(s, before);
  const Lost_corners lost(s.cloud.positions(), triangles);
  std::size_t number = 0;
  for (Point_index p = 0; p != points.size(); ++p) {
    number += lost.is_lost(p) ? 1u : 0u;
    ISR_CHECK(!lost.is_lost(p) || lost.is_by_right(p));
  }
  ISR_CHECK_EQUAL(number, 2u * 6u * 28u);
  ISR_CHECK(lost.corners().empty());
  ISR_CHECK(!recover_corners(s));
  ISR_CHECK(canonical(s.triangles()) == canonical(before));
}

void test_steep_search()
{
  begin_case("steep points, by looking at all of them");
  const Points points = random_cube(2000, 7);
  const Hand_surface s(points);
  const std::vector<Local_point>& positions = s.cloud.positions();
  const Point_octree_3 octree(positions);
  Steep_search has_steep_point(positions, octree);
  for (const Local_vector& normal : { Local_vector(0, 0, 1), Local_vector(.6, 0, -.8), Local_vector(1, 0, 0) })
    for (Point_index p = 0; p < positions.size(); p += 3) {
      double least = std::numeric_limits<double>::infinity();
      for (const Local_point& q : positions) {
        const Local_vector v = q - positions[p];
        if (v.squared_length() > 0. && 2. * (normal * v) * (normal * v) >= v.squared_length())
          least = (std::min)(least, v.squared_length());
      }
      ISR_CHECK(has_steep_point(p, normal, least));
      ISR_CHECK(!has_steep_point(p, normal, .999 * least));
    }
}

void test_ground()
{
  begin_case("nothing is near enough to turn to");
  for (const bool is_near : { false, true }) {
    const Points points = ground(is_near ? 30. : 300.);
    Hand_surface s(points);
    const Triples before = hull(s);
    ISR_CHECK(s.add(before));
    const std::vector<std::array<Point_index, 3> > triangles = triangles_of(s, before);
    Lost_corners lost(s.cloud.positions(), triangles);
    ISR_CHECK_EQUAL(lost.corners().size(), 50u + 100u + 150u + 200u + 250u);
    isr_internal::No_cancellation cancellation_point;
    lost.find_alone(Point_octree_3(s.cloud.positions()), cancellation_point);
    ISR_CHECK_EQUAL(lost.corners().empty(), !is_near);
    if (!is_near) {
      ISR_CHECK(!recover_corners(s));
      ISR_CHECK(canonical(s.triangles()) == canonical(before));
    }
  }
}

} // namespace

int main()
{
  test_corner();
  test_bore();
  test_rows();
  test_steep_search();
  test_ground();
  return result();
}

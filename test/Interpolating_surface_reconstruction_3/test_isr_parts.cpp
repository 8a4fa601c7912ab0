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

// Parts as a lathe and a mill make them, with points on their walls only, or on their edges only: the flat faces, with
// holes or without, have none.

#include "isr_test_ctc.h"
#include "isr_test_pcr.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace isr_test;

std::size_t parts_of(double length, double spacing)
{
  return (std::max)(std::size_t(1), std::size_t(std::lround(length / spacing)));
}

Points ring(const Vector& center, double radius, double spacing)
{
  const std::size_t n = parts_of(2. * PI * radius, spacing);
  Points points;
  for (std::size_t i = 0; i != n; ++i)
    points.push_back(on_circle(2. * PI * double(i) / double(n), radius, 0.) + center);
  return points;
}

Points rectangle(const Vector& corner, double width, double depth, double spacing)
{
  const std::size_t n = parts_of(width, spacing), m = parts_of(depth, spacing);
  const double dx = width / double(n), dy = depth / double(m);
  Points points;
  for (std::size_t i = 0; i != n; ++i) {
    points.push_back(Point(double(i) * dx, 0., 0.) + corner);
    points.push_back(Point(width - double(i) * dx, depth, 0.) + corner);
  }
  for (std::size_t i = 0; i != m; ++i) {
    points.push_back(Point(width, double(i) * dy, 0.) + corner);
    points.push_back(Point(0., depth - double(i) * dy, 0.) + corner);
  }
  return points;
}

// The profile at each of the heights from 0 on.
template <typename Profile>
Points extruded(const Profile& profile, double height, double spacing)
{
  const std::size_t n = parts_of(height, spacing);
  Points points;
  for (std::size_t j = 0; j <= n; ++j)
    append(points, profile(height * double(j) / double(n)));
  return points;
}

Points frame_profile(double z, double spacing)
{
  Points points = rectangle(Vector(0, 0, z), 3., 3., spacing);
  append(points, rectangle(Vector(.5, .5, z), 2., 2., spacing));
  return points;
}

// That of a plate with three holes.
Points plate_profile(double z, double spacing)
{
  Points points = rectangle(Vector(0, 0, z), 6., 3., spacing);
  for (double x : { 1.2, 3., 4.8 })
    append(points, ring(Vector(x, 1.5, z), .5, spacing));
  return points;
}

void test_part(const std::string& name, const Points& points, long euler_characteristic, std::size_t components = 1)
{
  for (double angle : { 0., .7, 1.9, 2.6 }) {
    begin_case(name + (angle == 0. ? "" : ", rotated by " + std::to_string(angle)));
    const Points placed = rotated(points, angle);
    for (const Triples& triples : { checked_ctc(placed), checked_pcr(placed) }) {
      ISR_CHECK_EQUAL(validation::boundary_edges(triples).size(), 0u);
      ISR_CHECK_EQUAL(validation::number_of_components(triples), components);
      ISR_CHECK_EQUAL(validation::euler_characteristic(triples), euler_characteristic);
      ISR_CHECK(are_outward(placed, triples));
    }
  }
}

void test_turned_parts(double spacing)
{
  const Vector up(0, 0, 1), zero(0, 0, 0);
  const auto rings = [&](const std::vector<double>& radii) {
    return [=](double z) {
      Points points;
      for (double radius : radii)
        append(points, ring(z * up, radius, spacing));
      return points;
    };
  };
  const std::string with = ", spacing " + std::to_string(spacing);
  test_part("rod" + with, extruded(rings({ 1. }), 1., spacing), 2);
  test_part("pipe" + with, extruded(rings({ 1., .6 }), 3., spacing), 0);
  test_part("rod, ends only" + with, extruded(rings({ 1. }), 6., 6.), 2);
  test_part("pipe, ends only" + with, extruded(rings({ 1., .5 }), 9., 9.), 0);
}

void test_milled_parts(double spacing)
{
  const Vector up(0, 0, 1);
  const std::string with = ", spacing " + std::to_string(spacing);
  const auto square = [&](double z) { return rectangle(z * up, 3., 3., spacing); };
  test_part("block" + with, extruded(square, 1., spacing), 2);
  const auto frame = [&](double z) { return frame_profile(z, spacing); };
  test_part("frame" + with, extruded(frame, 1., spacing), 0);
  const auto plate = [&](double z) { return plate_profile(z, spacing); };
  const auto flange = [&](double z) {
    Points points = ring(z * up, 3., spacing);
    append(points, ring(z * up, .6, spacing));
    for (int i = 0; i != 5; ++i)
      append(points, ring(Vector(2. * std::cos(2. * PI * i / 5.), 2. * std::sin(2. * PI * i / 5.), z), .4, spacing));
    return points;
  };
  test_part("flange with bolt holes" + with, extruded(flange, 1., spacing), -10);
  for (double height : { .6, 2. })
    test_part("plate with three holes" + with, extruded(plate, height, spacing), -4);
  Points boss = extruded(square, 1., spacing);
  append(boss, extruded([&](double z) { return ring(Vector(1.5, 1.5, 1. + z), 1., spacing); }, .6, spacing));
  test_part("block with a boss" + with, boss, 2);
}

// Nothing but the rims of holes tells of them: stars agree on caps.
void test_parts_with_points_on_edges(double spacing)
{
  const Vector up(0, 0, 1);
  const std::string with = ", edges only, spacing " + std::to_string(spacing);
  const auto frame = [&](double z) { return frame_profile(z, spacing); };
  test_part("frame" + with, extruded(frame, 1., 1.), 0);
  const auto plate = [&](double z) { return plate_profile(z, spacing); };
  for (double height : { .6, 1., 2. })
    test_part("plate with three holes" + with, extruded(plate, height, height), -4);
  const auto stepped = [&](double z) { // not a prism: one point more above
    Points points = plate(z);
    if (z != 0.)
      points.push_back(Point(0., .5 * spacing, z));
    return points;
  };
  test_part("plate with an extra point" + with, extruded(stepped, 1., 1.), -4);
  const auto cone = [&](double z) {
    Points points = ring(z * up, 2., spacing);
    append(points, ring(z * up, .5 + .5 * z, spacing));
    return points;
  };
  if (spacing < .2) // else, a tunnel is left beside the bore
    test_part("ring with a conical bore" + with, extruded(cone, 1., 1.), 0);
}

// Turned by a unit quaternion.
Points turned(Points points, unsigned int seed)
{
  Random random(seed);
  double w = 0.;
  Vector v(0, 0, 0);
  do {
    w = random.uniform(-1., 1.);
    const double x = random.uniform(-1., 1.), y = random.uniform(-1., 1.), z = random.uniform(-1., 1.);
    v = Vector(x, y, z);
  } while (w * w + v.squared_length() < .01);
  const double norm = std::sqrt(w * w + v.squared_length());
  w /= norm;
  v = v / norm;
  for (Point& p : points) {
    const Vector u = p - CGAL::ORIGIN, t = 2. * CGAL::cross_product(v, u);
    p = p + w * t + CGAL::cross_product(v, t);
  }
  return points;
}

// The stars of a prism do not know of its other end: they would vote against walls, in some orientations only.
void test_votes_in_prisms()
{
  const Points plate = extruded([](double z) { return plate_profile(z, .2); }, .6, .6);
  test_part("plate with three holes, edges only, turned", turned(plate, 49), -4);
}

// Flat faces with points all over have no caps.
void test_boxes_with_points_on_faces()
{
  for (unsigned int seed : { 1u, 2u, 3u }) {
    Random random(seed);
    Points points;
    for (int i = 0; i != 2000; ++i) {
      const double x = random.uniform(0., 2.), y = random.uniform(0., 2.);
      points.push_back(Point(x, y, i % 2 == 0 ? 0. : .5));
    }
    append(points, extruded([](double z) { return rectangle(Vector(0, 0, z), 2., 2., .1); }, .5, .1));
    test_part("plate with points at random, seed " + std::to_string(seed), points, 2);
  }
}

int main()
{
  for (double spacing : { .1, .13, .2 }) {
    test_turned_parts(spacing);
    test_milled_parts(spacing);
    test_parts_with_points_on_edges(spacing);
  }
  test_votes_in_prisms();
  test_boxes_with_points_on_faces();
  return result();
}

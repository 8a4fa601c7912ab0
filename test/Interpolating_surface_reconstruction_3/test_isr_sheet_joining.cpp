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

// Flat sheets that face each other become one closed surface, and so do the ends of a prism that are sampled along their
// edges, however far they are from each other; others stay as they are.

#include "isr_test_ctc.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace isr_test;

constexpr std::size_t SIDE = 8; // of a sheet, in edges of length 1

Points sheet_at(const Vector& origin, const Vector& u, const Vector& v)
{
  Points points;
  for (std::size_t i = 0; i <= SIDE; ++i)
    for (std::size_t j = 0; j <= SIDE; ++j)
      points.push_back(CGAL::ORIGIN + (origin + double(i) * u + double(j) * v));
  return points;
}

const Vector X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1), ZERO(0, 0, 0);

Points horizontal_sheets(const std::vector<double>& heights)
{
  Points points;
  for (double z : heights)
    append(points, sheet_at(z * Z, X, Y));
  return points;
}

// Through all points, without boundary, with the Euler characteristic of a sphere.
void test_joined(const std::string& name, const Points& points)
{
  begin_case(name);
  const Triples triples = checked_ctc(points);
  ISR_CHECK_EQUAL(triples.size(), 2 * points.size() - 4);
  ISR_CHECK_EQUAL(validation::boundary_edges(triples).size(), 0u);
  ISR_CHECK_EQUAL(validation::number_of_components(triples), 1u);
}

template <typename NamedParameters>
void test_apart(const std::string& name, const Points& points, std::size_t sheets, const NamedParameters& np)
{
  begin_case(name);
  Counting_visitor visitor;
  const Triples triples = checked_ctc(points, visitor, np);
  ISR_CHECK_EQUAL(triples.size(), 2 * SIDE * SIDE * sheets);
  ISR_CHECK_EQUAL(validation::boundary_edges(triples).size(), 4 * SIDE * sheets);
  ISR_CHECK_EQUAL(validation::number_of_components(triples), sheets);
}

void test_apart(const std::string& name, const Points& points, std::size_t sheets)
{
  test_apart(name, points, sheets, params::keep_boundaries(false));
}

// A closed polygon of edges of equal length along the unit circle, or scaled.
Points ring(std::size_t n, double radius, double z)
{
  Points points;
  for (std::size_t i = 0; i != n; ++i)
    points.push_back(on_circle(2. * CGAL_PI * double(i) / double(n), radius, z));
  return points;
}

// The outline of an L, its edges cut into `parts`.
Points angle_profile(std::size_t parts, double z)
{
  const std::vector<Point> corners = { Point(0, 0, z),   Point(2, 0, z),  Point(2, .6, z),
                                       Point(.6, .6, z), Point(.6, 2, z), Point(0, 2, z) };
  Points points;
  for (std::size_t i = 0; i != corners.size(); ++i)
    for (std::size_t k = 0; k != parts; ++k)
      points.push_back(corners[i] + double(k) / double(parts) * (corners[(i + 1) % corners.size()] - corners[i]));
  return points;
}

// The two ends, sampled along their edges, become a closed surface of this volume.
void test_prism(const std::string& name, const Points& points, std::ptrdiff_t euler_characteristic, double volume)
{
  begin_case(name);
  const Triples triples = checked_ctc(points);
  ISR_CHECK_EQUAL(validation::boundary_edges(triples).size(), 0u);
  ISR_CHECK_EQUAL(validation::number_of_components(triples), 1u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(triples), euler_characteristic);
  const std::vector<double> volumes = volumes_of_components(points, triples);
  ISR_CHECK(std::abs(volumes[0] - volume) < 1e-6 * volume);
}

double area_of_polygon(std::size_t n, double radius)
{
  return double(n) * std::sin(2. * CGAL_PI / double(n)) * radius * radius / 2.;
}

void test_prisms()
{
  const std::size_t n = 40;
  for (double height : { 5., 50. }) {
    Points rod = ring(n, 1., 0.), pipe = rod, angle = angle_profile(4, 0.);
    append(rod, ring(n, 1., height));
    test_prism("rod", rotated(rod, .7), 2, area_of_polygon(n, 1.) * height);
    append(pipe, ring(n, .6, 0.));
    append(pipe, ring(n, 1., height));
    append(pipe, ring(n, .6, height));
    test_prism("pipe", rotated(pipe, .7), 0, (area_of_polygon(n, 1.) - area_of_polygon(n, .6)) * height);
    append(angle, angle_profile(4, height));
    test_prism("angle", rotated(angle, .7), 2, (2. * 2. - 1.4 * 1.4) * height);
  }
  Points cone = ring(n, 1., 0.);
  append(cone, ring(n, .25, 9.));
  test_prism("frustum", cone, 2, area_of_polygon(n, 1.) * 9. * (1. + .25 + .25 * .25) / 3.);
}

int main()
{
  const Points facing = horizontal_sheets({ 0., 6. });
  test_joined("two faces of a box", facing);
  test_joined("two faces of a rotated box", rotated(facing, .7));
  test_apart("the same, openings kept", facing, 2, params::keep_boundaries(true));
  test_apart("the same, openings larger than what is closed", facing, 2, params::maximum_hole_size(4 * SIDE - 1));
  test_apart("farther apart than wide", horizontal_sheets({ 0., 9. }), 2);
  Points rows = sheet_at(ZERO, X, 2.1 * Y);
  append(rows, sheet_at(40. * Z, X, 2.1 * Y));
  test_apart("rows, farther apart than wide", rows, 2);
  test_apart("one between others", horizontal_sheets({ 0., 6., 12. }), 3);

  // three spacings from each edge of the box
  const double low = -3., high = double(SIDE) + 3.;
  Points faces = horizontal_sheets({ low, high });
  for (double x : { low, high }) {
    append(faces, sheet_at(x * X, Y, Z));
    append(faces, sheet_at(x * Y, Z, X));
  }
  test_joined("six faces of a box", faces);
  test_prisms();
  return result();
}

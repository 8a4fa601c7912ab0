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

// Flat sheets that face each other become one closed surface; others stay as they are.

#include "isr_test_ctc.h"

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

int main()
{
  const Points facing = horizontal_sheets({ 0., 6. });
  test_joined("two faces of a box", facing);
  test_joined("two faces of a rotated box", rotated(facing, .7));
  test_apart("the same, openings kept", facing, 2, params::keep_boundaries(true));
  test_apart("the same, openings larger than what is closed", facing, 2, params::maximum_hole_size(4 * SIDE - 1));
  test_apart("farther apart than wide", horizontal_sheets({ 0., 9. }), 2);
  test_apart("one between others", horizontal_sheets({ 0., 6., 12. }), 3);

  // three spacings from each edge of the box
  const double low = -3., high = double(SIDE) + 3.;
  Points faces = horizontal_sheets({ low, high });
  for (double x : { low, high }) {
    append(faces, sheet_at(x * X, Y, Z));
    append(faces, sheet_at(x * Y, Z, X));
  }
  test_joined("six faces of a box", faces);
  return result();
}

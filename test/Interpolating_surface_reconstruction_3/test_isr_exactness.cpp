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

// Decisions that change the topology, on inputs for which the same computation in double is wrong.

#include "isr_surface_test_utils.h"
#include "isr_test_ctc.h"
#include "isr_test_hostile.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/determinant.h>

using namespace isr_test;

// Point (i, j) of a grid of neighboring floating-point numbers around (1/2, 1/2), in the plane y = z. With
// (12, 12) and (24, 24) it is collinear if i = j, else on the side that i - j tells (after Kettner,
// Mehlhorn, Pion, Schirra and Yap, Classroom examples of robustness problems in geometric computations,
// 2008).
Point near_diagonal(long i, long j)
{
  const double x = .5 + double(i) * 0x1p-53, y = .5 + double(j) * 0x1p-53;
  return Point(x, y, y);
}

const Point ON_DIAGONAL[] = { Point(12, 12, 12), Point(24, 24, 24) };

int side(long i, long j) { return i < j ? 1 : i > j ? -1 : 0; }

int side_in_double(const Point& p)
{
  const Point& q = ON_DIAGONAL[0];
  const Point& r = ON_DIAGONAL[1];
  const double area = (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  return area < 0. ? 1 : area > 0. ? -1 : 0;
}

constexpr long GRID = 64;

// The points of the diagonal and those of the grid on the two diagonals next to the main one.
struct Near_diagonals
{
  Near_diagonals()
  {
    points.assign(ON_DIAGONAL, ON_DIAGONAL + 2);
    for (long i = 0; i != GRID; ++i)
      for (long j = (std::max)(0l, i - 1); j <= i + 1 && j != GRID; ++j) {
        points.push_back(near_diagonal(i, j));
        sides.push_back(side(i, j));
        wrong_in_double += side_in_double(points.back()) != sides.back() ? 1u : 0u;
      }
  }

  Points points;
  std::vector<int> sides; // of all points but the first two
  std::size_t wrong_in_double = 0;
};

void test_collinear()
{
  begin_case("collinear points");
  const Near_diagonals input;
  ISR_CHECK(input.wrong_in_double != 0);
  const Hand_surface s(input.points);
  for (std::size_t i = 0; i != input.sides.size(); ++i)
    ISR_CHECK_EQUAL(s.predicates.is_degenerate(s.indices[0], s.indices[1], s.indices[i + 2]), input.sides[i] == 0);

  begin_case("a single triangle");
  for (std::size_t i = 0; i != input.sides.size(); ++i) {
    const Points triangle = { input.points[0], input.points[1], input.points[i + 2] };
    ISR_CHECK(ctc(triangle).empty() || input.sides[i] != 0);
  }
}

void test_folded()
{
  begin_case("triangles in a plane");
  const Near_diagonals input;
  const Hand_surface s(input.points);
  for (std::size_t i = 0; i != input.sides.size(); ++i)
    for (std::size_t j = 0; j != input.sides.size(); ++j)
      if (i != j && input.sides[i] != 0 && input.sides[j] != 0)
        ISR_CHECK_EQUAL(s.predicates.is_folded(s.indices[0], s.indices[1], s.indices[i + 2], s.indices[j + 2]),
                        input.sides[i] == input.sides[j]);

  begin_case("triangles in different planes");
  Points points = input.points;
  for (std::size_t i = 2; i != points.size(); ++i)
    points[i] = Point(points[i].x(), points[i].y(), std::nextafter(points[i].z(), 1.));
  points.insert(points.end(), input.points.begin() + 2, input.points.end());
  const Hand_surface lifted(points);
  for (std::size_t i = 0; i != input.sides.size(); ++i)
    for (std::size_t j = 0; j != input.sides.size(); ++j)
      if (input.sides[j] != 0) // a point beside the diagonal in y = z, and one out of this plane
        ISR_CHECK(!lifted.predicates.is_folded(lifted.indices[0], lifted.indices[1], lifted.indices[i + 2],
                                               lifted.indices[input.points.size() + j]));
}

// The sign of the determinant in double that tells whether e is in the sphere through the other points.
int in_sphere_in_double(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e)
{
  std::array<std::array<double, 4>, 4> rows;
  const Point* const points[] = { &a, &b, &c, &d };
  for (std::size_t i = 0; i != 4; ++i) {
    const Vector v = *points[i] - e;
    rows[i] = { { v.x(), v.y(), v.z(), v.squared_length() } };
  }
  const double value =
    CGAL::determinant(rows[0][0], rows[0][1], rows[0][2], rows[0][3], rows[1][0], rows[1][1], rows[1][2], rows[1][3],
                      rows[2][0], rows[2][1], rows[2][2], rows[2][3], rows[3][0], rows[3][1], rows[3][2], rows[3][3]);
  return value < 0. ? -1 : value > 0. ? 1 : 0;
}

void test_cells(const std::string& name, const Points& points)
{
  begin_case("cells of Delaunay tetrahedra: " + name);
  using isr_internal::Cell_complex;
  const Hand_surface s(points);
  std::vector<Point_index> all(s.cloud.size());
  std::iota(all.begin(), all.end(), Point_index(0));
  const Cell_complex cells(s.cloud.positions(), all);
  ISR_CHECK(cells.size() != 0);
  std::size_t inside = 0, inverted = 0, wrong_in_double = 0;
  for (std::size_t c = 0; c != cells.size(); ++c) {
    if (Cell_complex::is_infinite(cells[c]))
      continue;
    const auto& v = cells[c].vertices;
    const Point &p = s.cloud.point(v[0]), &q = s.cloud.point(v[1]), &r = s.cloud.point(v[2]), &t = s.cloud.point(v[3]);
    inverted += CGAL::orientation(p, q, r, t) == CGAL::POSITIVE ? 0u : 1u;
    for (std::size_t i = 0; i != 4; ++i)
      for (Point_index w : cells[cells[c].neighbors[i]].vertices) {
        if (w == NO_POINT || std::find(v.begin(), v.end(), w) != v.end())
          continue;
        const int exact = CGAL::side_of_oriented_sphere(p, q, r, t, s.cloud.point(w));
        inside += exact == CGAL::ON_POSITIVE_SIDE ? 1u : 0u;
        const int in_double = in_sphere_in_double(p, q, r, t, s.cloud.point(w));
        wrong_in_double += in_double != exact && in_double != -exact ? 1u : 0u;
      }
  }
  ISR_CHECK_EQUAL(inside, 0u);
  ISR_CHECK_EQUAL(inverted, 0u);
  ISR_CHECK(wrong_in_double != 0);
}

void test_equal()
{
  begin_case("points that differ in the last bit");
  const double next = std::nextafter(1., 2.);
  Counting_visitor visitor;
  checked_ctc(
    { Point(1, 1, 1), Point(1, 1, next), Point(1, next, 1), Point(-0., 0, 0), Point(0., -0., 0), Point(1, 1, 1) },
    visitor, params::keep_boundaries(false));
  ISR_CHECK_EQUAL(visitor.duplicates, 2u);
}

int main()
{
  test_collinear();
  test_folded();
  // away from zero, next to which are denormal numbers that no scale leaves as they are
  test_cells("nudged lattice", hostile::nudged(translated(hostile::lattice(343), Vector(1, 1, 1)), 1, 2));
  test_cells("rotated lattice", hostile::lattice_rotated(343, 1));
  test_cells("sphere", sphere_fibonacci(300).points);
  test_equal();
  return result();
}

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

// The same surface for the same points in another order, unit or place.

#include "isr_test_ctc.h"

using namespace isr_test;

Triples canonical_ctc(const Points& points) { return canonical(ctc(points)); }

// Coordinates in multiples of 2^-20, so that a translation by 2^20 is exact.
Points rounded(Points points)
{
  for (Point& p : points)
    p = Point(std::round(p.x() * 0x1p20) * 0x1p-20, std::round(p.y() * 0x1p20) * 0x1p-20,
              std::round(p.z() * 0x1p20) * 0x1p-20);
  return points;
}

void test_permutation(const Sample& s)
{
  begin_case(s.name + ", permuted");
  const Triples expected = canonical_ctc(s.points);
  for (const std::uint64_t seed : { 1u, 2u }) {
    const std::vector<std::size_t> order = random_order(s.points.size(), seed);
    const Triples found = ctc(permuted(s.points, order));
    ISR_CHECK(canonical(relabeled(found, order)) == expected);
  }
}

void test_scale(const Sample& s)
{
  begin_case(s.name + ", scaled by powers of two");
  const Triples expected = ctc(s.points);
  for (const double by : { 0x1p-40, 0x1p-1, 0x1p1, 0x1p60 })
    ISR_CHECK(ctc(scaled(s.points, by)) == expected);
}

void test_translation(const Sample& s)
{
  begin_case(s.name + ", translated by 2^20");
  const Points points = rounded(s.points);
  const Triples expected = canonical_ctc(points);
  ISR_CHECK(canonical_ctc(translated(points, Vector(0x1p20, 0x1p20, 0x1p20))) == expected);
  ISR_CHECK(canonical_ctc(translated(points, Vector(-0x1p20, 0x1p20, 0))) == expected);
}

// Rounding moves the points, so only what does not hang on it is compared.
void test_rotation(const Sample& s)
{
  begin_case(s.name + ", rotated");
  for (const double angle : { .3, 2.1 }) {
    const Triples triples = checked_ctc(rotated(s.points, angle));
    ISR_CHECK_EQUAL(validation::euler_characteristic(triples), s.euler);
    ISR_CHECK_EQUAL(validation::number_of_components(triples), s.components);
    ISR_CHECK_EQUAL(validation::used_points(triples).size(), s.points.size());
    ISR_CHECK(validation::boundary_edges(triples).empty());
  }
}

int main()
{
  const Sample samples[] = { sphere_fibonacci(1000), torus(50, 20, 0., 1), torus(50, 20, .2, 1), box(10, 10, 10),
                             box_jittered(10, .3, 1) };
  for (const Sample& s : samples) {
    test_permutation(s);
    test_scale(s);
    test_translation(s);
    test_rotation(s);
  }
  const Sample conflicting = { "random cube", random_cube(500, 1), 0, 0, 0 };
  test_permutation(conflicting);
  test_scale(conflicting);
  test_permutation(Sample{ "solid lattice",
                           [] {
                             Points points;
                             for (int i = 0; i != 343; ++i)
                               points.emplace_back(i % 7, i / 7 % 7, i / 49);
                             return points;
                           }(),
                           0, 0, 0 });
  return result();
}

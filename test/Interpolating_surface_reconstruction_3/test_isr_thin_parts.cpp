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

// Thin parts with sparse random points: no method has all of them right, so the right ones are counted.

#include "isr_test_ctc.h"
#include "isr_test_samples.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>

using namespace isr_test;

namespace {

constexpr int SAMPLES = 40;

// Around the z-axis.
Points thin_torus(std::uint64_t seed)
{
  Random random(seed);
  const std::size_t n = 90 + 10 * (seed % 12);
  Points points;
  for (std::size_t i = 0; i != n; ++i) {
    const double u = random.uniform(0., 2. * PI), v = random.uniform(0., 2. * PI);
    points.push_back(on_circle(u, 1. + .15 * std::cos(v), .15 * std::sin(v)));
  }
  return points;
}

// Two balls and the rod between them.
Points dumbbell(std::uint64_t seed)
{
  Random random(seed);
  const std::size_t n = 60 + 10 * (seed % 15);
  Points points;
  for (std::size_t i = 0; i != n; ++i) {
    const double part = random.uniform(), angle = random.uniform(0., 2. * PI), z = random.uniform(-1., 1.);
    if (part < .2)
      points.push_back(on_circle(angle, .08, .5 * z));
    else
      points.push_back(on_circle(angle, .3 * std::sqrt(1. - z * z), .3 * z + (part < .6 ? -.8 : .8)));
  }
  return points;
}

template <typename Make>
int count_right(const Make& make, int euler)
{
  int result = 0;
  for (int seed = 0; seed != SAMPLES; ++seed) {
    const Points points = make(std::uint64_t(seed));
    const Triples triples = checked_ctc(points);
    ISR_CHECK(validation::boundary_edges(triples).empty());
    ISR_CHECK_EQUAL(validation::used_points(triples).size(), points.size());
    if (validation::number_of_components(triples) == 1 && validation::euler_characteristic(triples) == euler)
      ++result;
  }
  std::cout << "  " << result << " of " << SAMPLES << " are right\n";
  return result;
}

} // namespace

int main()
{
  begin_case("tori");
  ISR_CHECK(count_right(thin_torus, 0) >= 36);
  begin_case("dumbbells");
  ISR_CHECK(count_right(dumbbell, 2) >= 34);
  return result();
}

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

// Identical triangles in an identical order for any number of threads. Arguments: algorithms, and the
// number of points of an input.

#include "isr_test_algorithms.h"

#include <cstdlib>

#ifdef CGAL_LINKED_WITH_TBB

#include <tbb/global_control.h>

using namespace isr_test;

template <typename Algorithm>
void test_threads(Algorithm algorithm, const std::string& name, const Points& points)
{
  begin_case(algorithm.name() + ": " + name);
  const auto np = params::neighbor_radius(0.);
  const Triples expected = triangles_of(algorithm, points, np);
  for (const std::size_t threads : { 1u, 2u, 4u, 8u }) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    ISR_CHECK((triangles_of<Algorithm, CGAL::Parallel_tag>(algorithm, points, np)) == expected);
  }
  ISR_CHECK(triangles_of(algorithm, points, np) == expected);
}

int main(int argc, char** argv)
{
  const unsigned long given = argc > 1 ? std::strtoul(argv[argc - 1], nullptr, 10) : 0;
  const std::size_t n = given != 0 ? given : 12000;
  for_each_algorithm(argc, argv, [&](auto algorithm) {
    test_threads(algorithm, "random sphere", sphere_random(n, 1).points);
    test_threads(algorithm, "regular torus", torus(n / 80, 80, 0., 1).points);
    test_threads(algorithm, "noise", with_noise(sphere_fibonacci(n / 4).points, .03, 1));
    test_threads(algorithm, "random cube", random_cube(n / 10, 1));
    test_threads(algorithm, "two plates", two_plates(40, .5).points);
    test_threads(algorithm, "empty", {});
  });
  return result();
}

#else

int main() { std::cout << "skipped: built without TBB" << std::endl; }

#endif

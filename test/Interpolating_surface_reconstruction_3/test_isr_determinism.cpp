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

// Identical triangles in an identical order for any number of threads.

#include "isr_test_ctc.h"

#ifdef CGAL_LINKED_WITH_TBB

#include <tbb/global_control.h>

using namespace isr_test;

void test_threads(const std::string& name, const Points& points)
{
  begin_case(name);
  const Triples expected = ctc<CGAL::Sequential_tag>(points, params::keep_boundaries(false));
  for (const std::size_t threads : { std::size_t(1), std::size_t(2), std::size_t(4) }) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    for (int run = 0; run != 2; ++run)
      ISR_CHECK(ctc<CGAL::Parallel_tag>(points, params::keep_boundaries(false)) == expected);
  }
  ISR_CHECK(ctc<CGAL::Sequential_tag>(points, params::keep_boundaries(false)) == expected);
}

int main()
{
  test_threads("random sphere", sphere_random(20000, 1).points);
  test_threads("regular torus", torus(200, 80, 0., 1).points);
  test_threads("noise", with_noise(sphere_fibonacci(5000).points, .03, 1));
  test_threads("random cube", random_cube(2000, 1));
  test_threads("two plates", two_plates(40, .5).points);
  test_threads("empty", {});
  return result();
}

#else

int main() { std::cout << "skipped: built without TBB" << std::endl; }

#endif

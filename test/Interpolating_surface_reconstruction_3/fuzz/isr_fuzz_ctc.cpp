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

// Any points and parameters: every guarantee of a reconstruction holds.

#include "isr_fuzz_input.h"

#include "../isr_test_algorithms.h"

#include <exception>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace isr_fuzz;
  namespace params = CGAL::parameters;
  namespace validation = isr_test::validation;
  Byte_stream in(data, size);
  const bool keeps_boundaries = in.below(2) == 0;
  const std::size_t maximum_hole_size = in.below(4) == 0 ? in.below(16) : 1000;
  const double neighbor_radius = in.below(4) == 0 ? std::abs(in.small()) : 0.;
  const Points points = read_points(in, 60);

  isr_test::Counting_visitor visitor;
  isr_test::Triples triples;
  CGAL::ctc_reconstruction(points, std::back_inserter(triples),
                           params::combine(params::keep_boundaries(keeps_boundaries),
                                           params::maximum_hole_size(maximum_hole_size),
                                           params::neighbor_radius(neighbor_radius).visitor(std::ref(visitor))));
  ISR_FUZZ_REQUIRE(validation::is_oriented_manifold(points, triples, isr_test::Kernel()));
  ISR_FUZZ_REQUIRE(validation::used_points(triples).size() + visitor.unused + visitor.duplicates + visitor.non_finite ==
                   points.size());
  return 0;
}

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

// Any stars, then any sequence of proposals and removals: the gate keeps edges manifold and triangles
// oriented.

#include "isr_fuzz_surface.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace isr_fuzz;
  namespace validation = isr_test::validation;
  Byte_stream in(data, size);
  const Points points = read_distinct_points(in, 3 + in.below(14));
  const Links links = in.below(2) == 0 ? Links() : read_links(in, points.size());
  Hand_surface surface(points, links);
  const auto check = [&] {
    const isr_test::Triples triples = surface.triangles();
    ISR_FUZZ_REQUIRE(validation::are_indices_valid(triples, points.size()));
    ISR_FUZZ_REQUIRE(validation::is_edge_manifold(triples));
    ISR_FUZZ_REQUIRE(validation::is_consistently_oriented(triples));
    ISR_FUZZ_REQUIRE(!validation::has_degenerate_triangle(points, triples, isr_test::Kernel()));
  };
  check();
  change(surface, in, points.size(), 200);
  check();
  return 0;
}

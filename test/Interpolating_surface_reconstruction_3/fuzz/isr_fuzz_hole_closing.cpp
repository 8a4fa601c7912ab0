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

// Any surface that the gate lets pass: closing its holes, dissolving islands and inserting points gives
// a manifold.

#include "isr_fuzz_surface.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/hole_closing.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/island_removal.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/point_insertion.h>

#include <limits>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace isr_fuzz;
  using Builder = Hand_surface::Builder;
  namespace validation = isr_test::validation;
  Byte_stream in(data, size);
  const Points points = read_distinct_points(in, 3 + in.below(30));
  const std::size_t maximum_size = in.below(4) == 0 ? in.below(16) : points.size();
  const bool is_inserting = in.below(2) == 0;
  const Links links = in.below(2) == 0 ? Links() : read_links(in, points.size());
  Hand_surface surface(points, links);
  change(surface, in, points.size(), 200);

  const auto ignore = [](const Builder::Triangle&, isr_test::Triangle_verdict) {};
  const auto& positions = surface.cloud.positions();
  isr_test::isr_internal::Hole_closing<Builder> close(positions, surface.builder, maximum_size);
  close.close_planar_loops(isr_test::no_progress, ignore);
  close([](const isr_test::isr_internal::Boundary_loop&) { return false; }, isr_test::no_progress, ignore);
  isr_test::isr_internal::Island_removal<Builder> remove_islands(surface.builder);
  remove_islands();
  if (is_inserting) {
    const isr_test::isr_internal::Point_octree_3 octree(positions);
    isr_test::isr_internal::Point_insertion<Builder> insert(positions, octree, std::numeric_limits<double>::infinity(),
                                                            surface.builder);
    insert(isr_test::no_progress);
  }
  const isr_test::Triples triples = surface.triangles();
  ISR_FUZZ_REQUIRE(validation::is_oriented_manifold(points, triples, isr_test::Kernel()));
  return 0;
}

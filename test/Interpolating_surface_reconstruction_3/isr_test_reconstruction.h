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

// What the tests of all algorithms share: a visitor that counts, and the guarantees.

#ifndef ISR_TEST_RECONSTRUCTION_H
#define ISR_TEST_RECONSTRUCTION_H

#include "isr_test_utils.h" // first: it turns assertions on

#include "isr_test_reconstructors.h"

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>

#include <cstddef>

namespace isr_test {

namespace isr = CGAL::Interpolating_surface_reconstruction_3;
namespace params = CGAL::parameters;

// Counts what the visitor is told.
struct Counting_visitor : isr::Default_visitor
{
  std::size_t points = 0, duplicates = 0, non_finite = 0, unused = 0;
  std::size_t begun = 0, ended = 0, stages_begun = 0, stages_ended = 0;
  bool was_cancelled = false;

  void on_reconstruction_begin(std::size_t n)
  {
    points = n;
    ++begun;
  }
  void on_points_set_aside(std::size_t equal, std::size_t not_finite)
  {
    duplicates = equal;
    non_finite = not_finite;
  }
  void on_stage_begin(isr::Stage) { ++stages_begun; }
  void on_stage_end(isr::Stage, std::size_t) { ++stages_ended; }
  void on_points_unused(std::size_t n) { unused = n; }
  void on_reconstruction_end(bool cancelled)
  {
    was_cancelled = cancelled;
    ++ended;
  }
};

// The guarantees that hold whatever the points are, and what a visitor is told.
inline void check_guarantees(const Points& points, const Triples& triples, const Counting_visitor& visitor)
{
  ISR_CHECK(validation::are_indices_valid(triples, points.size()));
  ISR_CHECK(validation::is_edge_manifold(triples));
  ISR_CHECK(validation::is_vertex_manifold(triples));
  ISR_CHECK(validation::is_consistently_oriented(triples));
  ISR_CHECK(!validation::has_degenerate_triangle(points, triples, Kernel()));
  ISR_CHECK_EQUAL(visitor.points, points.size());
  ISR_CHECK_EQUAL(validation::used_points(triples).size() + visitor.unused + visitor.duplicates + visitor.non_finite,
                  points.size());
  ISR_CHECK_EQUAL(visitor.begun, 1u);
  ISR_CHECK_EQUAL(visitor.ended, 1u);
  ISR_CHECK_EQUAL(visitor.stages_begun, visitor.stages_ended);
  ISR_CHECK(!visitor.was_cancelled);
}

// What the sample is known to be.
inline void check_topology(const Sample& s, const Triples& triples, const Counting_visitor& visitor)
{
  ISR_CHECK_EQUAL(visitor.unused, 0u);
  ISR_CHECK_EQUAL(validation::number_of_boundary_loops(triples), s.boundary_loops);
  ISR_CHECK_EQUAL(validation::number_of_components(triples), s.components);
  ISR_CHECK_EQUAL(validation::euler_characteristic(triples), s.euler);
}

} // namespace isr_test

#endif // ISR_TEST_RECONSTRUCTION_H

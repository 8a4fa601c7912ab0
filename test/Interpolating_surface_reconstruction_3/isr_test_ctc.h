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

#ifndef ISR_TEST_CTC_H
#define ISR_TEST_CTC_H

#include "isr_test_utils.h"

#include <CGAL/ctc_reconstruction.h>

#include <cstddef>
#include <functional>
#include <iterator>

namespace isr_test {

namespace isr = CGAL::Interpolating_surface_reconstruction_3;
namespace params = CGAL::parameters;

// Counts what the visitor is told.
struct Counting_visitor : isr::Default_visitor
{
  std::size_t points = 0, duplicates = 0, non_finite = 0, unused = 0;
  std::size_t begun = 0, ended = 0, stages_begun = 0, stages_ended = 0;
  bool was_cancelled = false;

  void on_reconstruction_begin(std::size_t n) { points = n; ++begun; }
  void on_points_set_aside(std::size_t equal, std::size_t not_finite) { duplicates = equal; non_finite = not_finite; }
  void on_stage_begin(isr::Stage) { ++stages_begun; }
  void on_stage_end(isr::Stage, std::size_t) { ++stages_ended; }
  void on_points_unused(std::size_t n) { unused = n; }
  void on_reconstruction_end(bool cancelled) { was_cancelled = cancelled; ++ended; }
};

template <typename ConcurrencyTag = CGAL::Sequential_tag, typename PointRange, typename NamedParameters>
Triples ctc(const PointRange& points, const NamedParameters& np)
{
  Triples triples;
  CGAL::ctc_reconstruction<ConcurrencyTag>(points, std::back_inserter(triples), np);
  return triples;
}

template <typename PointRange>
Triples ctc(const PointRange& points)
{
  Triples triples;
  CGAL::ctc_reconstruction(points, std::back_inserter(triples));
  return triples;
}

// Reconstructs and checks what holds for any input: an oriented manifold on valid indices without
// degenerate triangles, and a visitor that can account for every point.
template <typename NamedParameters>
Triples checked_ctc(const Points& points, Counting_visitor& visitor, const NamedParameters& np)
{
  const Triples triples = ctc(points, params::combine(np, params::visitor(std::ref(visitor))));
  ISR_CHECK(validation::are_indices_valid(triples, points.size()));
  ISR_CHECK(validation::is_edge_manifold(triples));
  ISR_CHECK(validation::is_vertex_manifold(triples));
  ISR_CHECK(validation::is_consistently_oriented(triples));
  ISR_CHECK(!validation::has_degenerate_triangle(points, triples, Kernel()));
  ISR_CHECK_EQUAL(visitor.points, points.size());
  ISR_CHECK_EQUAL(validation::used_points(triples).size() + visitor.unused + visitor.duplicates +
                    visitor.non_finite, points.size());
  ISR_CHECK_EQUAL(visitor.begun, 1u);
  ISR_CHECK_EQUAL(visitor.ended, 1u);
  ISR_CHECK_EQUAL(visitor.stages_begun, visitor.stages_ended);
  ISR_CHECK(!visitor.was_cancelled);
  return triples;
}

inline Triples checked_ctc(const Points& points)
{
  Counting_visitor visitor;
  return checked_ctc(points, visitor, params::keep_boundaries(false));
}

} // namespace isr_test

#endif // ISR_TEST_CTC_H

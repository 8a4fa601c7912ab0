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

#ifndef ISR_TEST_ALGORITHMS_H
#define ISR_TEST_ALGORITHMS_H

#include "isr_test_ctc.h"

#include <CGAL/ctc_reconstruction.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <string>

namespace isr_test {

// The public functions as types, for tests that hold for each of them.
struct Ctc
{
  static std::string name() { return "CTC"; }

  template <typename ConcurrencyTag = CGAL::Sequential_tag, typename PointRange, typename Output, typename NamedParameters>
  static auto reconstruct(const PointRange& points, Output&& output, const NamedParameters& np)
  {
    return CGAL::ctc_reconstruction<ConcurrencyTag>(points, std::forward<Output>(output), np);
  }
};

// Calls test(algorithm) with an object of each type above.
template <typename Test>
void for_each_algorithm(Test test)
{
  test(Ctc());
}

template <typename Algorithm, typename ConcurrencyTag = CGAL::Sequential_tag, typename NamedParameters>
Triples triangles_of(Algorithm, const Points& points, const NamedParameters& np)
{
  Triples triples;
  Algorithm::template reconstruct<ConcurrencyTag>(points, std::back_inserter(triples), np);
  return triples;
}

template <typename Algorithm>
Triples triangles_of(Algorithm algorithm, const Points& points)
{
  return triangles_of(algorithm, points, params::neighbor_radius(0.));
}

// What the visitor is told, with a bound on the work.
struct Accounting_visitor : Counting_visitor
{
  std::size_t proposals = 0;
  void on_triangle(const Triple&, isr::Triangle_verdict) { ++proposals; }
};

// Reconstructs, checks what is guaranteed for every input, and returns the triangles.
template <typename Algorithm, typename NamedParameters>
Triples checked_triangles(Algorithm algorithm, const Points& points, const NamedParameters& np)
{
  // Conflicts are proposed by Delaunay facets, of which a surface has few a point, and closing tries a
  // few rounds.
  constexpr std::size_t PROPOSALS_PER_POINT = 100;
  Accounting_visitor visitor;
  const Triples triples = triangles_of(algorithm, points, params::combine(np, params::visitor(std::ref(visitor))));
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
  ISR_CHECK(visitor.proposals <= PROPOSALS_PER_POINT * points.size());
  return triples;
}

template <typename Algorithm>
Triples checked_triangles(Algorithm algorithm, const Points& points)
{
  return checked_triangles(algorithm, points, params::neighbor_radius(0.));
}

} // namespace isr_test

#endif // ISR_TEST_ALGORITHMS_H

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

// The same surface for hostile points in another order, unit or place, and for any number of threads.

#include "isr_test_algorithms.h"
#include "isr_test_hostile.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <map>

using namespace isr_test;

// The first position of each point, for duplicates.
std::vector<std::size_t> first_positions(const Points& points)
{
  std::map<Point, std::size_t> first;
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i != points.size(); ++i)
    result.push_back(points[i] == points[i] ? first.emplace(points[i], i).first->second : i);
  return result;
}

template <typename Algorithm>
void test_permutation(Algorithm algorithm, const Points& points, const Triples& triples)
{
  const std::vector<std::size_t> first = first_positions(points);
  const Triples expected = canonical(relabeled(triples, first));
  const std::vector<std::size_t> order = random_order(points.size(), 1);
  const Triples found = triangles_of(algorithm, permuted(points, order));
  ISR_CHECK(canonical(relabeled(relabeled(found, order), first)) == expected);
}

// By a power of two that changes no bit of any coordinate.
template <typename Algorithm>
void test_scale(Algorithm algorithm, const Points& points, const Triples& triples)
{
  for (const double by : { 0x1p-9, 0x1p30 }) {
    const Points result = scaled(points, by);
    if (scaled(result, 1. / by) == points)
      ISR_CHECK(triangles_of(algorithm, result) == triples);
  }
}

template <typename Algorithm>
void test_threads(Algorithm algorithm, const Points& points, const Triples& triples)
{
#ifdef CGAL_LINKED_WITH_TBB
  for (const std::size_t threads : { 1u, 2u, 4u, 8u }) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const Triples found = triangles_of<Algorithm, CGAL::Parallel_tag>(algorithm, points, params::neighbor_radius(0.));
    ISR_CHECK(found == triples);
  }
#else
  (void)algorithm, (void)points, (void)triples;
#endif
}

template <typename Algorithm>
void test_corpus(Algorithm algorithm, std::size_t n)
{
  for (const Hostile_generator& generator : hostile_corpus()) {
    begin_case(algorithm.name() + ": " + generator.name);
    const Points points = generator.generate(n, 3);
    const Triples triples = triangles_of(algorithm, points);
    test_permutation(algorithm, points, triples);
    test_scale(algorithm, points, triples);
    test_threads(algorithm, points, triples);
  }
}

// A third of a turn around the diagonal of the axes exchanges the coordinates and rounds nothing.
Points turned(Points points)
{
  for (Point& p : points)
    p = Point(p.y(), p.z(), p.x());
  return points;
}

template <typename Algorithm>
void test_rotation(Algorithm algorithm)
{
  std::vector<Points> inputs = { sphere_random(800, 1).points, with_noise(sphere_fibonacci(600).points, .01, 1) };
  // Radial normals are rounded, and so wrong for a torus that the rounding decides.
  if (algorithm.name() != Lis<Radial_normals>::name())
    inputs.push_back(torus(40, 16, .2, 1).points);
  for (const Points& points : inputs) {
    begin_case(algorithm.name() + ": an exact rotation");
    ISR_CHECK(canonical(triangles_of(algorithm, turned(points))) == canonical(triangles_of(algorithm, points)));
  }
}

int main(int argc, char** argv)
{
  for_each_algorithm(argc, argv, [](auto algorithm) {
    test_corpus(algorithm, 300);
    test_rotation(algorithm);
  });
  return result();
}

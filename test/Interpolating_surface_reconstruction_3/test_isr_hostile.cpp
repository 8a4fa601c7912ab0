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

// Whatever the points, every algorithm ends and keeps its guarantees. Arguments: the number of points
// of an input, and the number of seeds.

#include "isr_test_algorithms.h"
#include "isr_test_hostile.h"

#include <cstdlib>
#include <map>

using namespace isr_test;

template <typename Algorithm>
void test_few_points(Algorithm algorithm)
{
  const Points corners = { Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1) };
  for (std::size_t n = 0; n <= corners.size(); ++n) {
    begin_case(algorithm.name() + ": " + std::to_string(n) + " points");
    const Triples triples = checked_triangles(algorithm, Points(corners.begin(), corners.begin() + std::ptrdiff_t(n)));
    ISR_CHECK(triples.empty() || n >= 3);
  }
  begin_case(algorithm.name() + ": few points with rounding");
  Random random(1);
  for (std::size_t i = 0; i != 300; ++i) {
    Points points;
    for (std::size_t j = random.below(8); j-- != 0;) {
      // coordinates from few values, so that many are equal, collinear or coplanar
      const double x = double(random.below(3)), y = double(random.below(3)), z = double(random.below(2)) * 1e-17;
      points.emplace_back(x, y, z);
    }
    checked_triangles(algorithm, points);
  }
}

// Few points of a small lattice have all ties there are: equal, collinear, coplanar, cocircular,
// cospherical. Their order does not matter.
template <typename Algorithm>
void test_small_lattices(Algorithm algorithm, std::size_t number_of_sets)
{
  begin_case(algorithm.name() + ": few points of a lattice");
  Random random(7);
  for (std::size_t set = 0; set != number_of_sets; ++set) {
    const std::size_t size = 3 + random.below(7), side = 3 + random.below(2);
    Points points;
    while (points.size() != size) {
      const double x = double(random.below(side)), y = double(random.below(side)), z = double(random.below(side));
      points.emplace_back(x, y, z);
    }
    const std::map<Point, std::size_t> positions = positions_of_finite(points);
    const auto triangles_by_position = [&](const Points& range) {
      std::vector<std::size_t> labels;
      for (const Point& p : range)
        labels.push_back(positions.at(p));
      return canonical(relabeled(checked_triangles(algorithm, range), labels));
    };
    ISR_CHECK(triangles_by_position(points) == triangles_by_position(permuted(points, random_order(size, set))));
  }
}

template <typename Algorithm>
void test_corpus(Algorithm algorithm, std::size_t n, std::uint64_t seeds)
{
  for (const Hostile_generator& generator : hostile_corpus())
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      begin_case(algorithm.name() + ": " + generator.name + ", n = " + std::to_string(n) + ", seed " +
                 std::to_string(seed));
      checked_triangles(algorithm, generator.generate(n, seed));
    }
}

// A flat sheet is one sheet with one boundary, not two that enclose it.
template <typename Algorithm>
void test_flat(Algorithm algorithm, const std::string& name, const Points& points)
{
  begin_case(algorithm.name() + ": " + name + " is one sheet");
  const Triples triples = checked_triangles(algorithm, points);
  ISR_CHECK_EQUAL(validation::used_points(triples).size(), points.size());
  ISR_CHECK_EQUAL(validation::number_of_components(triples), 1u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(triples), 1);
  ISR_CHECK_EQUAL(validation::number_of_boundary_loops(triples), 1u);
}

template <typename Algorithm>
void test_few_dimensions(Algorithm algorithm)
{
  for (const auto generate : { hostile::equal, hostile::two_places, hostile::line }) {
    begin_case(algorithm.name() + ": no surface");
    ISR_CHECK(checked_triangles(algorithm, generate(200, 1)).empty());
  }
  test_flat(algorithm, "a grid", hostile::sheet_grid(400, 1));
  test_flat(algorithm, "a rotated grid", hostile::sheet_grid_rotated(400, 1));
  test_flat(algorithm, "a random sheet", hostile::sheet_random(400, 1));
}

int main(int argc, char** argv)
{
  // strtoul() makes 0 of the name of an algorithm
  const std::size_t n = argc > 1 && std::strtoul(argv[1], nullptr, 10) != 0 ? std::strtoul(argv[1], nullptr, 10) : 500;
  const std::uint64_t seeds =
    argc > 2 && std::strtoul(argv[2], nullptr, 10) != 0 ? std::strtoull(argv[2], nullptr, 10) : 2;
  const auto test = [&](auto algorithm) {
    test_few_points(algorithm);
    test_few_dimensions(algorithm);
    test_small_lattices(algorithm, 4 * n);
    test_corpus(algorithm, n, seeds);
  };
  for_each_algorithm(argc, argv, test);
  return result();
}

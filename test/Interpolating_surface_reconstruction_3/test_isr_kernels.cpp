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

// The same small inputs with several kernels.

#include "isr_test_ctc.h"
#include "isr_test_pcr.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <limits>

using namespace isr_test;

template <typename K>
std::vector<typename K::Point_3> converted(const Points& points)
{
  std::vector<typename K::Point_3> result;
  for (const Point& p : points)
    result.emplace_back(typename K::FT(p.x()), typename K::FT(p.y()), typename K::FT(p.z()));
  return result;
}

template <typename K>
Triples test_sample(const std::string& kernel, const Sample& s)
{
  begin_case(kernel + ", " + s.name);
  const std::vector<typename K::Point_3> points = converted<K>(s.points);
  const Triples triples = ctc(points);
  ISR_CHECK(validation::is_oriented_manifold(points, triples, K()));
  ISR_CHECK(validation::boundary_edges(triples).empty());
  ISR_CHECK_EQUAL(validation::euler_characteristic(triples), s.euler);
  ISR_CHECK_EQUAL(validation::used_points(triples).size(), s.points.size());
  ISR_CHECK(validation::is_oriented_manifold(points, pcr(points), K()));
  ISR_CHECK_EQUAL(pcr(points).size(), triples.size());
  return triples;
}

template <typename K>
void test_degenerate(const std::string& kernel)
{
  begin_case(kernel + ", degenerate input");
  using K_point = typename K::Point_3;
  ISR_CHECK(ctc(std::vector<K_point>()).empty());
  ISR_CHECK(ctc(std::vector<K_point>(10, K_point(1, 2, 3))).empty());
  std::vector<K_point> line;
  for (int i = 0; i != 40; ++i)
    line.emplace_back(i, 2 * i, -i);
  ISR_CHECK(ctc(line).empty());
  const std::vector<K_point> cube = converted<K>(random_cube(150, 1));
  ISR_CHECK(validation::is_oriented_manifold(cube, ctc(cube), K()));
  const std::vector<K_point> grid = converted<K>(plane_grid(8).points);
  ISR_CHECK_EQUAL(ctc(grid, params::keep_boundaries(true)).size(), 128u);
  ISR_CHECK(validation::is_oriented_manifold(grid, ctc(grid, params::keep_boundaries(true)), K()));
}

// Few points near the positions of a lattice: predicates that are not exact contradict themselves.
template <typename K>
void test_near_lattice(const std::string& kernel)
{
  begin_case(kernel + ", points near a lattice");
  Random random(1);
  const auto coordinate = [&] { return double(random.below(3)) + (double(random.below(3)) - 1.) * 0x1p-51; };
  for (std::size_t i = 0; i != 200; ++i) {
    Points points;
    for (std::size_t j = 8 + random.below(6); j-- != 0;) {
      const double x = coordinate(), y = coordinate(), z = coordinate();
      points.emplace_back(x, y, z);
    }
    for (const Triples& triples : { ctc(converted<K>(points)), pcr(converted<K>(points)) }) {
      ISR_CHECK(validation::are_indices_valid(triples, points.size()));
      ISR_CHECK(validation::is_edge_manifold(triples));
      ISR_CHECK(validation::is_vertex_manifold(triples));
      ISR_CHECK(validation::is_consistently_oriented(triples));
    }
  }
}

template <typename K>
void test_kernel(const std::string& kernel)
{
  test_sample<K>(kernel, sphere_fibonacci(300));
  test_sample<K>(kernel, torus(24, 12, .2, 1));
  test_sample<K>(kernel, box(5, 5, 5));
  test_degenerate<K>(kernel);
  test_near_lattice<K>(kernel);
}

// All of them know the same coordinates, so they agree.
void test_agreement()
{
  begin_case("kernels with double coordinates agree");
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const Points points = sphere_fibonacci(300).points;
  const Triples expected = ctc(points);
  ISR_CHECK(ctc(converted<Exact>(points)) == expected);
  ISR_CHECK(ctc(converted<CGAL::Simple_cartesian<double> >(points)) == expected);
}

int main()
{
  test_kernel<CGAL::Exact_predicates_inexact_constructions_kernel>("EPICK");
  test_kernel<CGAL::Exact_predicates_exact_constructions_kernel>("EPECK");
  test_kernel<CGAL::Simple_cartesian<double> >("Simple_cartesian<double>");
  test_kernel<CGAL::Simple_cartesian<float> >("Simple_cartesian<float>");
  test_agreement();
  return result();
}

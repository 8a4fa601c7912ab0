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

// The package uses no member of the traits that its concept does not name.

#include "isr_archetype_traits.h"
#include "isr_test_ctc.h"
#include "isr_test_lis.h"
#include "isr_test_pcr.h"

#include <CGAL/Interpolating_surface_reconstruction_3/Linear_implicit_function_3.h>

using namespace isr_test;

using Archetype_points = std::vector<Archetype_traits::Point_3>;

Archetype_points wrapped(const Points& points)
{
  Archetype_points result;
  for (const Point& p : points)
    result.push_back(Archetype_traits::make_point(p));
  return result;
}

// The archetype computes what the kernel computes.
void test_same_as_kernel(const std::string& name, const Points& points)
{
  begin_case(name);
  ISR_CHECK(ctc(wrapped(points), params::geom_traits(Archetype_traits())) == ctc(points));
  ISR_CHECK(
    ctc(wrapped(points), params::combine(params::keep_boundaries(true), params::geom_traits(Archetype_traits()))) ==
    ctc(points, params::keep_boundaries(true)));
  ISR_CHECK(pcr(wrapped(points), params::geom_traits(Archetype_traits())) == pcr(points));
}

void test_normals()
{
  begin_case("normals");
  using Oriented = std::pair<Archetype_traits::Point_3, Archetype_traits::Vector_3>;
  const Points points = sphere_fibonacci(300).points;
  const Archetype_points wrapped_points = wrapped(points);
  const Archetype_traits traits;
  std::vector<Oriented> oriented;
  for (const auto& p : wrapped_points)
    oriented.emplace_back(p, traits.construct_vector_3_object()(p, Archetype_traits::make_point(Point(0, 0, 0))));
  const Triples triples = ctc(oriented, params::point_map(CGAL::First_of_pair_property_map<Oriented>())
                                          .normal_map(CGAL::Second_of_pair_property_map<Oriented>())
                                          .geom_traits(traits));
  ISR_CHECK(validation::is_oriented_manifold(points, triples, Kernel()));
  ISR_CHECK_EQUAL(validation::number_of_components(triples), 1u);
  ISR_CHECK(volumes_of_components(points, triples).front() < 0.);
}

// LIS and its function, on samples with normals and without.
void test_lis()
{
  begin_case("LIS");
  const Points points = sphere_fibonacci(300).points;
  const auto traits = params::geom_traits(Archetype_traits());
  std::vector<Archetype_traits::Point_3> vertices;
  Triples triples;
  CGAL::lis_reconstruction(wrapped(points), vertices, triples, traits);
  ISR_CHECK(triples == lis(points, params::default_values()).triangles);

  using Function = CGAL::Interpolating_surface_reconstruction_3::Linear_implicit_function_3<Archetype_traits>;
  const Function function(wrapped(points), traits);
  ISR_CHECK(function(Archetype_traits::make_point(Point(0, 0, .5))) < 0.);
  ISR_CHECK(function(Archetype_traits::make_point(Point(0, 0, 1.5))) > 0.);
}

int main()
{
  test_same_as_kernel("sphere", sphere_fibonacci(500).points);
  test_same_as_kernel("box", box(6, 6, 6).points);
  test_same_as_kernel("plane grid", plane_grid(8).points);
  test_same_as_kernel("noise", with_noise(sphere_fibonacci(500).points, .08, 1));
  test_same_as_kernel("random cube", random_cube(200, 1));
  test_same_as_kernel("empty", {});
  test_normals();
  test_lis();
  return result();
}

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

// Splitting edges, and opening boundaries.

#include "isr_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_opening.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_refinement.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/vertex_normals.h>

#include <cmath>
#include <stdexcept>
#include <vector>

using namespace isr_test;
namespace in = CGAL::Interpolating_surface_reconstruction_3::internal;
using Triangle = std::array<in::Point_index, 3>;

namespace {

Triples triples(const std::vector<Triangle>& triangles)
{
  Triples result;
  for (const Triangle& t : triangles)
    result.push_back(Triple{ t[0], t[1], t[2] });
  return result;
}

std::vector<in::Local_point> octahedron()
{
  return { { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
}

std::vector<Triangle> faces_of_octahedron()
{
  std::vector<Triangle> result;
  for (in::Point_index i = 0; i != 4; ++i) {
    result.push_back({ { i, (i + 1) % 4, 4 } });
    result.push_back({ { (i + 1) % 4, i, 5 } });
  }
  return result;
}

double longest_edge(const std::vector<in::Local_point>& positions, const std::vector<Triangle>& triangles)
{
  double result = 0.;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i != 3; ++i)
      result = (std::max)(result, std::sqrt((positions[t[i]] - positions[t[(i + 1) % 3]]).squared_length()));
  return result;
}

in::Local_point on_sphere(const in::Local_point& p)
{
  const in::Local_vector v = p - CGAL::ORIGIN;
  return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
}

void test_refinement()
{
  const std::vector<in::Local_point> positions = octahedron();
  for (double length : { 2., 1.3, .5, .07 }) {
    begin_case("refined octahedron");
    std::vector<Triangle> triangles = faces_of_octahedron();
    std::vector<in::Local_point> added;
    in::Surface_refinement refine(positions, triangles, added);
    refine.operator()<CGAL::Sequential_tag>(length, on_sphere,
                                            [](double fraction) { return fraction >= 0. && fraction <= 1.; });
    std::vector<in::Local_point> all = positions;
    all.insert(all.end(), added.begin(), added.end());
    ISR_CHECK(longest_edge(all, triangles) <= length);
    ISR_CHECK(validation::is_vertex_manifold(triples(triangles)));
    ISR_CHECK(validation::is_consistently_oriented(triples(triangles)));
    ISR_CHECK(validation::boundary_edges(triples(triangles)).empty());
    ISR_CHECK_EQUAL(validation::euler_characteristic(triples(triangles)), 2);
    ISR_CHECK_EQUAL(validation::used_points(triples(triangles)).size(), all.size());
    ISR_CHECK((length == 2.) == added.empty());
  }
  begin_case("triangles of which one, two or three edges are split");
  const std::vector<in::Local_point> strip = { { 0, 0, 0 }, { 4, 0, 0 }, { 2, .5, 0 }, { 2, -3, 0 }, { 2.5, -3.2, 0 } };
  std::vector<Triangle> triangles = { { { 0, 1, 2 } }, { { 1, 0, 3 } }, { { 1, 3, 4 } } };
  std::vector<in::Local_point> added;
  in::Surface_refinement refine(strip, triangles, added);
  refine.operator()<CGAL::Sequential_tag>(
    2.5, [](const in::Local_point& x) { return x; }, [](double) { return true; });
  ISR_CHECK_EQUAL(triangles.size(), 2u + 4u + 3u);
  ISR_CHECK_EQUAL(added.size(), 4u);
  ISR_CHECK(validation::is_vertex_manifold(triples(triangles)));
  ISR_CHECK(validation::is_consistently_oriented(triples(triangles)));
  ISR_CHECK_EQUAL(validation::euler_characteristic(triples(triangles)), 1);

  begin_case("too many triangles");
  try {
    refine.operator()<CGAL::Sequential_tag>(
      1e-9, [](const in::Local_point& x) { return x; }, [](double) { return true; });
    ISR_CHECK(!"exception");
  } catch (const std::invalid_argument& e) {
    ISR_CHECK(std::string(e.what()).find("grid_spacing") == 0);
  }
  ISR_CHECK_EQUAL(triangles.size(), 9u);
}

void test_vertex_normals()
{
  begin_case("vertex normals");
  std::vector<in::Local_point> positions = octahedron();
  positions.emplace_back(7, 7, 7);
  const std::vector<in::Local_vector> normals = in::vertex_normals(positions, faces_of_octahedron());
  for (std::size_t p = 0; p != 6; ++p)
    ISR_CHECK((normals[p] - (positions[p] - CGAL::ORIGIN)).squared_length() < 1e-20);
  ISR_CHECK(normals[6] == in::Local_vector(0, 0, 0));
}

// Openings are tested with the surfaces of samples that have one.
void test_boundary_opening()
{
  begin_case("nothing to open");
  std::vector<in::Local_point> positions = octahedron(), added;
  std::vector<Triangle> triangles = faces_of_octahedron();
  in::Surface_refinement refine(positions, triangles, added);
  refine.operator()<CGAL::Sequential_tag>(.15, on_sphere, [](double) { return true; });
  positions.insert(positions.end(), added.begin(), added.end());
  std::vector<in::Local_vector> normals;
  for (const in::Local_point& p : positions)
    normals.push_back(p - CGAL::ORIGIN);
  ISR_CHECK_EQUAL(in::Boundary_opening(positions, normals, triangles)().size(), triangles.size());
}

} // namespace

int main()
{
  test_refinement();
  test_vertex_normals();
  test_boundary_opening();
  return result();
}

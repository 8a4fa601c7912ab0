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

// The overload that fills a Surface_mesh.

#include "isr_test_ctc.h"

#include <CGAL/Surface_mesh.h>

#include <type_traits>

using namespace isr_test;

using Mesh = CGAL::Surface_mesh<Point>;

// Which of the overloads is chosen shows in the type of the result.
void test_overload_resolution()
{
  begin_case("overload resolution");
  const Points points = sphere_fibonacci(200).points;
  Mesh mesh;
  Triples triples;
  auto np = params::keep_boundaries(false);
  const auto& const_np = np;
  static_assert(std::is_same<decltype(CGAL::ctc_reconstruction(points, mesh)), bool>::value, "");
  static_assert(std::is_same<decltype(CGAL::ctc_reconstruction(points, mesh, np)), bool>::value, "");
  static_assert(std::is_same<decltype(CGAL::ctc_reconstruction(points, mesh, const_np)), bool>::value, "");
  static_assert(std::is_same<decltype(CGAL::ctc_reconstruction<CGAL::Sequential_tag>(points, mesh, np)), bool>::value,
                "");
  using Inserter = std::back_insert_iterator<Triples>;
  Inserter out = std::back_inserter(triples);
  static_assert(std::is_same<decltype(CGAL::ctc_reconstruction(points, out)), Inserter>::value, "");
  static_assert(std::is_same<decltype(CGAL::ctc_reconstruction(points, out, np)), Inserter>::value, "");
  ISR_CHECK(CGAL::ctc_reconstruction(points, mesh, np));
  CGAL::ctc_reconstruction(points, out, np);
  ISR_CHECK_EQUAL(mesh.number_of_faces(), triples.size());
}

void check_mesh(const Points& points, const Mesh& mesh, const Triples& triples)
{
  ISR_CHECK(mesh.is_valid(false));
  ISR_CHECK(!mesh.has_garbage());
  // a second map of this name and type is not added; the pair exists in CGAL 5 and 6
  Mesh copy = mesh;
  const auto found = copy.add_property_map<Mesh::Vertex_index, std::size_t>("v:input_index");
  ISR_CHECK(!found.second);
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    ISR_CHECK(!mesh.is_isolated(v));
    ISR_CHECK(mesh.point(v) == points[found.first[v]]);
  }
  Triples faces;
  for (const Mesh::Face_index f : mesh.faces()) {
    Triple t;
    std::size_t i = 0;
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      t[i++] = found.first[v];
    faces.push_back(t);
  }
  ISR_CHECK(canonical(faces) == canonical(triples));
  ISR_CHECK_EQUAL(mesh.number_of_vertices(), validation::used_points(triples).size());
}

void test_mesh(const std::string& name, const Points& points)
{
  begin_case(name);
  Mesh mesh;
  ISR_CHECK(CGAL::ctc_reconstruction(points, mesh));
  check_mesh(points, mesh, ctc(points));
}

void test_open_mesh()
{
  begin_case("open");
  const Points points = plane_grid(10).points;
  Mesh mesh;
  ISR_CHECK(CGAL::ctc_reconstruction(points, mesh, params::keep_boundaries(true)));
  check_mesh(points, mesh, ctc(points, params::keep_boundaries(true)));
}

int main()
{
  test_overload_resolution();
  test_mesh("sphere", sphere_fibonacci(1000).points);
  test_mesh("duplicates", repeated(sphere_fibonacci(300).points, 2));
  test_mesh("two boxes", two_boxes(5, 2.).points);
  test_mesh("random cube", random_cube(300, 1));
  test_mesh("empty", {});
  test_mesh("two points", { Point(0, 0, 0), Point(1, 0, 0) });
  test_open_mesh();
  return result();
}

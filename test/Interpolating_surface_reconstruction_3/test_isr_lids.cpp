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

// Triangles that span openings of a surface are removed where its boundaries are kept.

#include "isr_surface_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/lid_removal.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/temporary_lids.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace isr_test;
using Builder = Hand_surface::Builder;
using Star_construction = CGAL::Interpolating_surface_reconstruction_3::Restricted_voronoi_star_3;

namespace {

Triples sorted(Triples triples)
{
  for (Triple& t : triples)
    std::sort(t.begin(), t.end());
  std::sort(triples.begin(), triples.end());
  return triples;
}

// A flat ring around a hole of n edges of length 1; the first n points are its outline.
Mesh ring(std::size_t n)
{
  constexpr std::size_t CIRCLES = 5;
  const double radius = .5 / std::sin(PI / double(n));
  Mesh mesh;
  for (std::size_t j = 0; j != CIRCLES; ++j)
    for (std::size_t i = 0; i != n; ++i)
      mesh.points.push_back(on_circle(2. * PI * (double(i) + .3 * double(j)) / double(n), radius + double(j), 0.));
  for (std::size_t j = 0; j + 1 != CIRCLES; ++j)
    for (std::size_t i = 0; i != n; ++i) {
      const std::size_t k = (i + 1) % n, p = j * n + i, q = j * n + k;
      mesh.triples.push_back(Triple{ p, p + n, q + n });
      mesh.triples.push_back(Triple{ p, q + n, q });
    }
  return mesh;
}

// n - 2 triangles between the points of the outline, to and fro.
Triples lid(std::size_t n)
{
  Triples result;
  for (std::size_t low = 0, high = n - 1; high - low > 1;) {
    const std::size_t next = result.size() % 2 == 0 ? low + 1 : high - 1;
    result.push_back(Triple{ low, next, high });
    (result.size() % 2 == 1 ? low : high) = next;
  }
  return result;
}

bool remove_lids(Hand_surface& s)
{
  const isr_internal::Point_octree_3 octree(s.cloud.positions());
  const Star_construction construct_star;
  isr_internal::Lid_removal<Builder, Star_construction> remove(s.cloud.positions(), octree, construct_star, s.builder);
  return remove(no_progress);
}

// How many triangles are left of a lid that lacks its first `missing` triangles, with `others` beside the ring.
std::size_t left_of_lid(std::size_t n, std::size_t missing = 0, const Mesh& others = Mesh())
{
  Mesh mesh = ring(n);
  append(mesh, others);
  const Triples beside = sorted(mesh.triples), all_of_lid = lid(n);
  ISR_CHECK_EQUAL(all_of_lid.size(), n - 2);
  mesh.triples.insert(mesh.triples.end(), all_of_lid.begin() + std::ptrdiff_t(missing), all_of_lid.end());
  Hand_surface s(mesh.points);
  ISR_CHECK(s.add(mesh.triples));
  const bool is_changed = remove_lids(s);
  const Triples left = sorted(s.triangles());
  ISR_CHECK(std::includes(left.begin(), left.end(), beside.begin(), beside.end()));
  ISR_CHECK_EQUAL(is_changed, left.size() != mesh.triples.size());
  return left.size() - beside.size();
}

void test_lid_removal()
{
  begin_case("lid of a large hole");
  ISR_CHECK_EQUAL(left_of_lid(32), 0u);
  ISR_CHECK_EQUAL(left_of_lid(200), 0u);

  begin_case("lid of a small hole");
  ISR_CHECK_EQUAL(left_of_lid(31), 29u);

  begin_case("part of a lid at what is open already");
  ISR_CHECK_EQUAL(left_of_lid(31, 8), 0u);

  begin_case("samples behind the outline");
  Mesh behind = sheet(24);
  for (Point& p : behind.points)
    p = p + Vector(-12, -12, .5);
  ISR_CHECK_EQUAL(left_of_lid(32, 0, behind), 30u);
}

void check_without_lids(const Mesh& mesh)
{
  Hand_surface s(mesh.points);
  ISR_CHECK(s.add(mesh.triples));
  ISR_CHECK(!remove_lids(s));
  ISR_CHECK(sorted(s.triangles()) == sorted(mesh.triples));
}

void test_point_inside()
{
  begin_case("point inside");
  constexpr std::size_t N = 40;
  Mesh mesh = ring(N);
  for (std::size_t i = 0; i != N; ++i)
    mesh.triples.push_back(Triple{ i, (i + 1) % N, mesh.points.size() });
  mesh.points.push_back(Point(0, 0, 0));
  check_without_lids(mesh);
}

// The wall of a tube with points at its ends only is no disk.
void test_tube()
{
  begin_case("tube");
  check_without_lids(wall(40, 2.));
}

// Two triangles between the points of their only loop, closed by two others.
void test_temporary_lids()
{
  begin_case("temporary lids");
  const Points points{ Point(0, 0, 0), Point(1, 0, .1), Point(1, 1, 0), Point(0, 1, .1) };
  const Triples surface{ Triple{ 0, 1, 2 }, Triple{ 0, 2, 3 } }, closing{ Triple{ 0, 3, 1 }, Triple{ 1, 3, 2 } };
  Hand_surface s(points);
  ISR_CHECK(s.add(surface));
  isr_internal::Temporary_lids<Builder> lids(s.builder);
  lids.expect_at({ { s.indices[0], s.indices[1], s.indices[2], s.indices[3] } });
  ISR_CHECK(s.add(closing));
  ISR_CHECK_EQUAL(s.triangles().size(), 4u);
  lids.remove();
  ISR_CHECK(sorted(s.triangles()) == sorted(surface));
}

} // namespace

int main()
{
  test_lid_removal();
  test_point_inside();
  test_tube();
  test_temporary_lids();
  return result();
}

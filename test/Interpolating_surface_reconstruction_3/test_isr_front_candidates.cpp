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

// The candidate triangle of an edge of the front: where stars agree, the subspace of Fig. 3.5, the choice of
// Fig. 3.6, the ears of Fig. 3.7, and the votes that a candidate needs.

#include "isr_surface_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Growing_front.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/front_candidates.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/front_gaps.h>

#include <algorithm>
#include <initializer_list>
#include <memory>

using namespace isr_test;
using isr_internal::Front_candidate;
using isr_internal::Growing_front;

constexpr std::size_t A = 0, B = 1, C = 2, P = 3, Q = 4;

// A front around the first triangles of a surface whose stars are given; points by their position in the
// input.
struct Hand_front
{
  Hand_front(const Points& points, const Links& links, const Triples& triangles)
    : surface(points, links), front(surface.builder.number_of_points())
  {
    const isr_internal::Front_gaps choose_gap(surface.cloud.positions(), front);
    for (std::size_t i = 0; i != triangles.size(); ++i) {
      const Triple& t = triangles[i];
      if (i == 0)
        front.begin({ { index(t[0]), index(t[1]), index(t[2]) } }, choose_gap);
      else
        front.attach(front.find(index(t[0]), index(t[1])), index(t[2]), choose_gap);
    }
  }

  Point_index index(std::size_t p) const { return surface.indices[p]; }

  Front_candidate candidate(std::size_t p, std::size_t q) const
  {
    const isr_internal::Front_candidates<Hand_surface::Builder> find(surface.cloud.positions(), surface.builder, front);
    return find(front.find(index(p), index(q)));
  }

  void check_apex(std::size_t p, std::size_t q, std::size_t expected) const
  {
    ISR_CHECK_EQUAL(candidate(p, q).apex, index(expected));
    ISR_CHECK(!candidate(p, q).is_agreed);
  }
  void check_none(std::size_t p, std::size_t q) const { ISR_CHECK_EQUAL(candidate(p, q).apex, NO_POINT); }

  const Hand_surface surface;
  Growing_front front;
};

// The triangle (A, B, C) in the plane z = 0, and points beyond its edge AB.
Points with(const Points& more)
{
  Points points = { Point(0, 0, 0), Point(1, 0, 0), Point(.5, -1, 0) };
  append(points, more);
  return points;
}

constexpr Point_index GAP = NO_POINT;

Link link(std::initializer_list<std::size_t> neighbors)
{
  Link result(neighbors.begin(), neighbors.end());
  result.push_back(GAP);
  return result;
}

void test_agreed()
{
  begin_case("the candidate on which the stars agree");
  const Mesh mesh = globe(5, 8);
  const Triple& t = mesh.triples[10];
  const Hand_front hand(mesh.points, links_of(mesh.points.size(), mesh.triples), { t });
  for (std::size_t i = 0; i != 3; ++i) {
    const std::size_t p = t[i], q = t[(i + 1) % 3];
    const auto other = std::find_if(mesh.triples.begin(), mesh.triples.end(), [&](const Triple& s) {
      return s != t && std::count(s.begin(), s.end(), p) + std::count(s.begin(), s.end(), q) == 2;
    });
    const Front_candidate candidate = hand.candidate(p, q);
    ISR_CHECK(candidate.is_agreed);
    ISR_CHECK(std::any_of(other->begin(), other->end(),
                          [&](std::size_t v) { return v != p && v != q && hand.index(v) == candidate.apex; }));
    ISR_CHECK(candidate.coplanarity > .5 && candidate.coplanarity < 1.);
  }
}

void test_subspace()
{
  begin_case("a point beyond the edge");
  const Hand_front beyond(with({ Point(.5, .8, 0) }), { link({ C, B, P }), link({ P, A, C }) }, { { A, B, C } });
  beyond.check_apex(A, B, P);
  ISR_CHECK_EQUAL(beyond.candidate(A, B).coplanarity, 1.);
  beyond.check_none(B, C);

  begin_case("a point behind the edge");
  const Hand_front behind(with({ Point(.5, -.3, .8) }), { link({ C, B, P }), link({ P, A, C }) }, { { A, B, C } });
  behind.check_none(A, B);
}

void test_votes()
{
  begin_case("a candidate of one star only");
  const Hand_front hand(with({ Point(.5, .8, 0) }), { link({ C, B, P }), link({ A, C }) }, { { A, B, C } });
  hand.check_none(A, B);
}

void test_choice()
{
  // The star of A has P, that of B has Q, and both are supported by the star of the third vertex.
  const auto hand = [](const Point& p, const Point& q) {
    return std::make_unique<Hand_front>(
      with({ p, q }), Links{ link({ C, B, P }), link({ Q, A, C }), {}, link({ A, B }), link({ A, B }) },
      Triples{ { A, B, C } });
  };
  begin_case("one point projects into the triangle of the other");
  hand(Point(.5, .5, .1), Point(.5, 2, 0))->check_apex(A, B, P);
  hand(Point(.5, 2, 0), Point(.5, .5, .1))->check_apex(A, B, Q);

  begin_case("both points project into the triangle of the other: the nearer one");
  hand(Point(.5, .4, .7), Point(.5, .9, -.4))->check_apex(A, B, P);
  hand(Point(.5, .9, -.4), Point(.5, .4, .7))->check_apex(A, B, Q);

  begin_case("none does: the more regular triangulation");
  hand(Point(.2, .9, 0), Point(1.3, .9, 0))->check_apex(A, B, P);
  hand(Point(-.3, .9, 0), Point(.8, .9, 0))->check_apex(A, B, Q);
}

void test_ears()
{
  // Triangles around the point 0 leave a gap from 4 to 1, that only the star of 0 fills.
  Points points = { Point(0, 0, 0) };
  for (const double degrees : { 0., 70., 150., 220. })
    points.push_back(on_circle(degrees * PI / 180., 1., 0.));
  const Triples fan = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 } };

  begin_case("an ear that one star has");
  const Hand_front ear(points, { Link{ 1, 2, 3, 4 } }, fan);
  ear.check_apex(0, 4, 1);
  ear.check_apex(0, 1, 4);
  ear.check_none(1, 2);

  begin_case("an ear that no star has");
  const Hand_front none(points, { Link{ 1, 2, 3, 4, GAP } }, fan);
  none.check_none(0, 4);
}

int main()
{
  test_agreed();
  test_subspace();
  test_votes();
  test_choice();
  test_ears();
  return result();
}

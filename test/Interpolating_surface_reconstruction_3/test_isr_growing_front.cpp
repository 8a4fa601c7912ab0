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

// The rings of the front, one test for each event, and their agreement with the edges that have one
// triangle while surfaces grow in random orders.

#include "isr_surface_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Coplanarity_queue.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Growing_front.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/front_gaps.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>

using namespace isr_test;
using isr_internal::Front_event;
using isr_internal::Front_gaps;
using isr_internal::Growing_front;
using Edge_index = Growing_front::Edge_index;
using Gap = Growing_front::Gap;
using Gaps = std::vector<Gap>;
using Event_name = int;

// Where a surface is that simple, there is no choice.
Gap first_gap(Point_index, Point_index, Point_index, const Gaps& gaps) { return gaps.front(); }

Front_event begin(Growing_front& front, Point_index p, Point_index q, Point_index r)
{
  return front.begin({ { p, q, r } }, first_gap);
}

Front_event attach(Growing_front& front, Point_index p, Point_index q, Point_index apex)
{
  return front.attach(front.find(p, q), apex, first_gap);
}

void check_event(Front_event event, Front_event expected)
{
  ISR_CHECK_EQUAL(static_cast<Event_name>(event), static_cast<Event_name>(expected));
}

std::size_t ring_size_at(const Growing_front& front, Point_index p, Point_index q)
{
  return front.ring_size(front.edge(front.find(p, q)).ring);
}

// Every edge of the front is linked at both ends, rings have the sizes that they claim, and the edges are
// those given.
void check_front(const Growing_front& front, const std::set<std::array<std::size_t, 2> >& expected)
{
  std::set<std::array<std::size_t, 2> > found;
  std::map<Growing_front::Ring_index, std::size_t> sizes;
  for (Edge_index e = 0; e != front.edge_bound(); ++e) {
    if (!front.is_edge(e))
      continue;
    const Growing_front::Edge& edge = front.edge(e);
    found.insert({ { (std::min)(edge.ends[0], edge.ends[1]), (std::max)(edge.ends[0], edge.ends[1]) } });
    ++sizes[edge.ring];
    for (std::size_t i = 0; i != 2; ++i) {
      const Growing_front::Edge& next = front.edge(edge.links[i]);
      ISR_CHECK(next.ring == edge.ring);
      const std::size_t j = next.ends[0] == edge.ends[i] ? 0 : 1;
      ISR_CHECK(next.ends[j] == edge.ends[i] && next.links[j] == e);
    }
  }
  ISR_CHECK(found == expected);
  ISR_CHECK_EQUAL(sizes.size(), front.number_of_rings());
  for (const auto& ring : sizes)
    ISR_CHECK_EQUAL(ring.second, front.ring_size(ring.first));
}

void test_begin()
{
  begin_case("a triangle begins a ring");
  Growing_front front(3);
  ISR_CHECK(!front.is_reached(0));
  check_event(begin(front, 0, 1, 2), Front_event::BEGIN);
  ISR_CHECK_EQUAL(front.number_of_rings(), 1u);
  ISR_CHECK_EQUAL(front.new_edges().size(), 3u);
  ISR_CHECK(front.is_reached(0) && front.is_on_front(0));
  ISR_CHECK_EQUAL(front.edge(front.find(1, 2)).opposite, 0u);
  check_front(front, { { { 0, 1 } }, { { 1, 2 } }, { { 0, 2 } } });
}

void test_extend()
{
  begin_case("a new point extends its ring");
  Growing_front front(4);
  begin(front, 0, 1, 2);
  check_event(attach(front, 1, 2, 3), Front_event::EXTEND);
  ISR_CHECK_EQUAL(front.new_edges().size(), 2u);
  ISR_CHECK_EQUAL(front.relinked_edges().size(), 2u);
  ISR_CHECK(front.find(1, 2) == Growing_front::NO_EDGE);
  const Edge_index e = front.find(1, 3);
  ISR_CHECK_EQUAL(front.following(e, front.edge(e).ends[0] == 1 ? 0 : 1), 0u);
  ISR_CHECK_EQUAL(front.following(e, front.edge(e).ends[0] == 3 ? 0 : 1), 2u);
  check_front(front, { { { 0, 1 } }, { { 1, 3 } }, { { 2, 3 } }, { { 0, 2 } } });
}

void test_close_ear()
{
  begin_case("a triangle between adjacent edges closes an ear");
  Growing_front front(5);
  begin(front, 0, 1, 2);
  attach(front, 0, 2, 3);
  attach(front, 0, 3, 4);
  check_event(attach(front, 0, 4, 1), Front_event::CLOSE_EAR);
  ISR_CHECK(front.is_reached(0) && !front.is_on_front(0));
  ISR_CHECK_EQUAL(front.new_edges().size(), 1u);
  check_front(front, { { { 1, 2 } }, { { 2, 3 } }, { { 3, 4 } }, { { 1, 4 } } });
}

void test_close_loop()
{
  begin_case("the last triangle closes the loop");
  Growing_front front(4);
  begin(front, 0, 1, 2);
  check_event(attach(front, 0, 1, 3), Front_event::EXTEND);
  check_event(attach(front, 1, 2, 3), Front_event::CLOSE_EAR);
  check_event(attach(front, 2, 0, 3), Front_event::CLOSE_LOOP);
  ISR_CHECK_EQUAL(front.number_of_rings(), 0u);
  check_front(front, {});
}

// A strip of triangles (0, 1, 2), (1, 2, 3), ...
Growing_front strip(Point_index n)
{
  Growing_front front(n);
  begin(front, 0, 1, 2);
  for (Point_index p = 3; p != n; ++p)
    attach(front, p - 2, p - 1, p);
  return front;
}

void test_split()
{
  begin_case("a ring that reaches itself is split");
  Growing_front front = strip(8);
  // The strip bends round: its last edge reaches the point 0.
  check_event(attach(front, 6, 7, 0), Front_event::SPLIT);
  ISR_CHECK_EQUAL(front.number_of_rings(), 2u);
  ISR_CHECK_EQUAL(ring_size_at(front, 0, 6) + ring_size_at(front, 0, 7), 9u);
  ISR_CHECK(front.edge(front.find(0, 6)).ring != front.edge(front.find(0, 7)).ring);
  // The strip becomes a ring of triangles with an inner and an outer boundary.
  check_event(attach(front, 0, 7, 1), Front_event::CLOSE_EAR);
  ISR_CHECK_EQUAL(front.number_of_rings(), 2u);
  ISR_CHECK_EQUAL(ring_size_at(front, 0, 2), 4u);
  ISR_CHECK_EQUAL(ring_size_at(front, 1, 3), 4u);
  check_front(
    front,
    { { { 0, 2 } }, { { 2, 4 } }, { { 4, 6 } }, { { 0, 6 } }, { { 1, 3 } }, { { 3, 5 } }, { { 5, 7 } }, { { 1, 7 } } });
}

void test_merge()
{
  begin_case("a ring that reaches another is merged with it");
  Growing_front front(6);
  begin(front, 0, 1, 2);
  check_event(begin(front, 3, 4, 5), Front_event::BEGIN);
  ISR_CHECK_EQUAL(front.number_of_rings(), 2u);
  check_event(attach(front, 1, 2, 3), Front_event::MERGE);
  ISR_CHECK_EQUAL(front.number_of_rings(), 1u);
  ISR_CHECK_EQUAL(ring_size_at(front, 4, 5), 7u);
  check_front(front,
              { { { 0, 1 } }, { { 0, 2 } }, { { 1, 3 } }, { { 2, 3 } }, { { 3, 4 } }, { { 3, 5 } }, { { 4, 5 } } });

  begin_case("the two rings of a surface are merged by a handle");
  Growing_front tube = strip(8);
  attach(tube, 6, 7, 0);
  attach(tube, 0, 7, 1);
  check_event(attach(tube, 2, 4, 5), Front_event::MERGE);
  ISR_CHECK_EQUAL(tube.number_of_rings(), 1u);
  ISR_CHECK_EQUAL(ring_size_at(tube, 1, 3), 9u);
}

void test_begin_at_front()
{
  begin_case("a triangle that begins at points of the front is merged with it");
  Growing_front front(5);
  begin(front, 0, 1, 2);
  check_event(begin(front, 2, 3, 4), Front_event::MERGE);
  ISR_CHECK_EQUAL(front.number_of_rings(), 1u);
  check_front(front, { { { 0, 1 } }, { { 1, 2 } }, { { 0, 2 } }, { { 2, 3 } }, { { 3, 4 } }, { { 2, 4 } } });

  begin_case("a triangle that begins at an edge of the front closes it");
  Growing_front other(4);
  begin(other, 0, 1, 2);
  check_event(begin(other, 1, 2, 3), Front_event::CLOSE_EAR);
  ISR_CHECK_EQUAL(other.number_of_rings(), 1u);
  check_front(other, { { { 0, 1 } }, { { 0, 2 } }, { { 1, 3 } }, { { 2, 3 } } });
}

// The point that follows in the ring of the edge pq beyond p.
Point_index following(const Growing_front& front, Point_index p, Point_index q)
{
  const Edge_index e = front.find(p, q);
  return front.following(e, front.edge(e).ends[0] == p ? 0 : 1);
}

void test_choice_of_gap()
{
  begin_case("a point with several gaps");
  // Three triangles around the point 0 leave gaps from 2 to 3, from 4 to 5 and from 6 to 1, whichever
  // comes first and whichever side it is seen from.
  std::vector<isr_internal::Local_point> positions{ { 0, 0, 0 } };
  for (const double degrees : { 0., 40., 120., 160., 240., 280. })
    positions.emplace_back(std::cos(degrees * PI / 180.), std::sin(degrees * PI / 180.), .2);
  std::vector<std::array<Point_index, 3> > triangles = { { { 0, 1, 2 } }, { { 0, 3, 4 } }, { { 5, 0, 6 } } };
  std::sort(triangles.begin(), triangles.end());
  do {
    Growing_front front(7);
    for (const auto& t : triangles)
      front.begin(t, Front_gaps(positions, front));
    ISR_CHECK_EQUAL(front.number_of_rings(), 1u);
    ISR_CHECK_EQUAL(following(front, 0, 2), 3u);
    ISR_CHECK_EQUAL(following(front, 0, 4), 5u);
    ISR_CHECK_EQUAL(following(front, 0, 6), 1u);
    // The gaps are filled one after the other.
    check_event(front.attach(front.find(0, 2), 3, first_gap), Front_event::CLOSE_EAR);
    check_event(front.attach(front.find(0, 4), 5, first_gap), Front_event::CLOSE_EAR);
    check_event(front.attach(front.find(0, 6), 1, first_gap), Front_event::CLOSE_EAR);
    ISR_CHECK(!front.is_on_front(0));
  } while (std::next_permutation(triangles.begin(), triangles.end()));
}

// Grows the surface from its triangles in a random order, as far as they are adjacent to the front.
void test_random_order(const std::string& name, const Mesh& mesh, std::uint64_t seed)
{
  begin_case(name + ", random order " + std::to_string(seed));
  std::vector<isr_internal::Local_point> positions;
  for (const Point& p : mesh.points)
    positions.emplace_back(p.x(), p.y(), p.z());
  Growing_front front(static_cast<Point_index>(mesh.points.size()));
  const Front_gaps choose_gap(positions, front);
  std::set<std::array<std::size_t, 2> > expected;
  std::size_t step = 0;
  for (std::size_t i : random_order(mesh.triples.size(), seed)) {
    const Triple& t = mesh.triples[i];
    std::size_t on_front = 3;
    for (std::size_t j = 0; j != 3; ++j) {
      std::array<std::size_t, 2> edge{ { t[j], t[(j + 1) % 3] } };
      if (front.find(static_cast<Point_index>(edge[0]), static_cast<Point_index>(edge[1])) != Growing_front::NO_EDGE)
        on_front = j;
      std::sort(edge.begin(), edge.end());
      if (!expected.erase(edge))
        expected.insert(edge);
    }
    const std::array<Point_index, 3> triangle = { { static_cast<Point_index>(t[0]), static_cast<Point_index>(t[1]),
                                                    static_cast<Point_index>(t[2]) } };
    if (on_front == 3)
      front.begin(triangle, choose_gap);
    else
      front.attach(front.find(triangle[on_front], triangle[(on_front + 1) % 3]), triangle[(on_front + 2) % 3],
                   choose_gap);
    if (++step % 16 == 0)
      check_front(front, expected);
  }
  check_front(front, expected);
  ISR_CHECK_EQUAL(front.number_of_rings(), validation::number_of_boundary_loops(mesh.triples));
}

struct Queue_entry
{
  double coplanarity;
  int number;
  bool operator<(const Queue_entry& other) const
  {
    return coplanarity != other.coplanarity ? coplanarity < other.coplanarity : number > other.number;
  }
};

double random_cosine(Random& random, int i)
{
  const double angle = std::pow(10., random.uniform(-10., .5));
  const double cosines[] = { std::cos(angle), 1., -1., 0., 1. + 1e-15, -1. - 1e-15 };
  return cosines[i % 16 < 5 ? i % 16 + 1 : 0];
}

// Entries whose order is needed come in that of a sorted set, whatever the classes.
void test_ordered_queue()
{
  begin_case("queue of candidates in order");
  isr_internal::Coplanarity_queue<Queue_entry> queue;
  std::set<Queue_entry> expected;
  Random random(5);
  for (int i = 0; i != 20000; ++i) {
    if (random.uniform(0., 1.) < .6) {
      const Queue_entry entry{ random_cosine(random, i), i };
      queue.push(entry, true);
      expected.insert(entry);
    } else if (!queue.empty()) {
      ISR_CHECK_EQUAL(queue.top().number, expected.rbegin()->number);
      queue.pop();
      expected.erase(std::prev(expected.end()));
    }
    ISR_CHECK_EQUAL(queue.empty(), expected.empty());
  }
}

// Of entries whose order is free, none comes before another whose angle is smaller by the square root of two or
// more; of entries as coplanar as each other, the last one comes first, and those in order come after them.
void test_unordered_queue()
{
  begin_case("queue of candidates without order");
  isr_internal::Coplanarity_queue<Queue_entry> queue;
  std::multiset<double> cosines;
  Random random(6);
  std::size_t checked = 0;
  for (int i = 0; i != 20000; ++i) {
    if (random.uniform(0., 1.) < .6) {
      const Queue_entry entry{ random_cosine(random, i), i };
      queue.push(entry, false);
      cosines.insert(entry.coplanarity);
    } else if (!queue.empty()) {
      const double gap = 1. - queue.top().coplanarity, least = 1. - *cosines.rbegin();
      ISR_CHECK(gap <= 2. * least || gap < 2e-9);
      cosines.erase(cosines.find(queue.top().coplanarity));
      queue.pop();
      ++checked;
    }
    ISR_CHECK_EQUAL(queue.empty(), cosines.empty());
  }
  ISR_CHECK(checked > 7000);

  isr_internal::Coplanarity_queue<Queue_entry> ties;
  for (int i = 0; i != 6; ++i)
    ties.push(Queue_entry{ .5, i }, i % 2 == 0);
  for (int expected : { 5, 3, 1, 0, 2, 4 }) {
    ISR_CHECK_EQUAL(ties.top().number, expected);
    ties.pop();
  }
  ISR_CHECK(ties.empty());
}

int main()
{
  test_ordered_queue();
  test_unordered_queue();
  test_begin();
  test_extend();
  test_close_ear();
  test_close_loop();
  test_split();
  test_merge();
  test_begin_at_front();
  test_choice_of_gap();
  for (std::uint64_t seed = 1; seed != 6; ++seed) {
    test_random_order("globe", globe(9, 16), seed);
    test_random_order("wall", wall(30, 1.), seed);
    test_random_order("sheet with a hole",
                      sheet(12, [](std::size_t i, std::size_t j) { return i / 3 == 1 && j / 3 == 2; }), seed);
  }
  return result();
}

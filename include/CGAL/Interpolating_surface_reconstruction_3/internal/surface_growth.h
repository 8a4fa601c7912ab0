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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_GROWTH_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_GROWTH_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Coplanarity_queue.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Growing_front.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/front_candidates.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/front_gaps.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/parallel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_measures.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Grows the surface from the most planar star (thesis 3.3): the triangle that is attached next is, of the
// candidates of all edges of the front, the one that is the most coplanar with the surface beside it. Of
// agreed candidates that are about as coplanar, the order is free, for they do not compete: which of them
// are attached before the first disputed one of their class does not depend on it.
// There is no bound on the angle. When the front has no candidate left, the growth begins again at the
// most planar star that it has not reached.
//
// The triangles on which the stars agree are part of the surface from the beginning, as far as the gate
// of `Builder` is concerned: a triangle on which they do not agree is attached only if it leaves room for
// those. Edges that have no such candidate stay on the front.
template <typename Builder>
class Surface_growth
{
public:
  using Triangle = typename Builder::Triangle;

  Surface_growth(const std::vector<Local_point>& points, Builder& builder)
    : m_points(points), m_builder(builder), m_front(builder.number_of_points()),
      m_find_candidate(points, builder, m_front), m_choose_gap(points, m_front)
  { }

  // Calls on_verdict(triangle, verdict) for the triangles in the order in which they are attached, or
  // refused; those that grow from one seed are oriented consistently. Ends early if cancelled. Returns the number of
  // attached triangles.
  template <typename ConcurrencyTag, typename Progress, typename OnVerdict>
  std::size_t grow_from_seeds(Progress& progress, OnVerdict on_verdict)
  {
    std::vector<Seed> seeds = find_seeds<ConcurrencyTag>();
    const auto is_reached = [&](const Seed& seed) { return m_front.is_reached(seed.center); };
    // The first seed mostly reaches nearly all others, so that few are left to be sorted.
    if (!seeds.empty() && !grow_from(*std::min_element(seeds.begin(), seeds.end()), progress, on_verdict))
      return m_attached;
    seeds.erase(std::remove_if(seeds.begin(), seeds.end(), is_reached), seeds.end());
    std::sort(seeds.begin(), seeds.end());
    for (const Seed& seed : seeds)
      if (!is_reached(seed) && !grow_from(seed, progress, on_verdict))
        return m_attached;
    withdraw_incomplete_regions();
    return m_attached;
  }

  const Growing_front& front() const { return m_front; }

private:
  using Edge_index = Growing_front::Edge_index;

  // A star on which its neighbors agree, where the growth may begin; a closed one if possible.
  struct Seed
  {
    bool is_closed;
    double planarity;
    Point_index center;

    bool operator<(const Seed& other) const
    {
      if (is_closed != other.is_closed)
        return is_closed;
      return planarity != other.planarity ? planarity > other.planarity : center < other.center;
    }
  };

  // The candidate of an edge in the queue. Ties are broken by the vertices.
  struct Entry
  {
    double coplanarity;
    std::array<Point_index, 3> vertices; // the ends of the edge, the smaller one first, and the apex
    Edge_index edge;

    bool operator<(const Entry& other) const
    {
      return coplanarity != other.coplanarity ? coplanarity < other.coplanarity : vertices > other.vertices;
    }
  };

  template <typename ConcurrencyTag>
  std::vector<Seed> find_seeds() const
  {
    constexpr std::size_t POINTS_PER_BLOCK = 4096;
    const Star_compatibility& compatibility = m_builder.compatibility();
    std::vector<Seed> seeds(m_points.size());
    for_each_block<ConcurrencyTag>(m_points.size(), POINTS_PER_BLOCK, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t> link;
      for (std::size_t i = begin; i != end; ++i) {
        const Point_index p = static_cast<Point_index>(i);
        seeds[i] = compatibility.is_point_agreed(p)
                     ? Seed{ !compatibility.is_point_on_boundary(p), planarity(p, link), p }
                     : Seed{ false, 0., NO_POINT };
      }
    });
    seeds.erase(std::remove_if(seeds.begin(), seeds.end(), [](const Seed& seed) { return seed.center == NO_POINT; }),
                seeds.end());
    return seeds;
  }

  double planarity(Point_index p, std::vector<std::uint32_t>& link) const
  {
    const Star_table& stars = m_builder.compatibility().stars();
    link.clear();
    for (Star_table::Slot s = stars.begin(p); s != stars.end(p); ++s)
      link.push_back(stars.neighbor(s));
    return planarity_degree(m_points[p], link, [&](std::uint32_t q) { return m_points[q]; });
  }

  // The star of the seed (3.3.1): its first triangle, and the others one after the other around it.
  template <typename OnVerdict>
  void begin_star(Point_index p, OnVerdict on_verdict)
  {
    const Star_table& stars = m_builder.compatibility().stars();
    const Star_table::Slot size = stars.end(p) - stars.begin(p);
    Star_table::Slot first = stars.begin(p);
    for (Star_table::Slot s = stars.begin(p); s != stars.end(p); ++s)
      if (stars.neighbor(s) == NO_POINT)
        first = stars.next(p, s);
    bool is_first = true;
    for (Star_table::Slot i = 0, s = first; i != size; ++i, s = stars.next(p, s)) {
      if (!stars.has_triangle(p, s))
        continue;
      const Triangle t{ { p, stars.neighbor(s), stars.neighbor(stars.next(p, s)) } };
      if (is_first)
        m_front.begin(t, m_choose_gap);
      else
        m_front.attach(m_front.find(p, t[1]), t[2], m_choose_gap);
      is_first = false;
      finish_triangle(t, on_verdict);
    }
  }

  // Returns false if cancelled.
  template <typename Progress, typename OnVerdict>
  bool grow_from(const Seed& seed, Progress& progress, OnVerdict on_verdict)
  {
    begin_star(seed.center, on_verdict);
    while (!m_queue.empty()) {
      if (++m_steps % STEPS_PER_POLL == 0 &&
          !progress.advance((std::min)(1., double(m_attached) / (2. * double(m_points.size())))))
        return false;
      const Entry entry = m_queue.top();
      m_queue.pop();
      if (is_current(entry))
        attach(entry, on_verdict);
    }
    return true;
  }

  bool is_current(const Entry& entry) const
  {
    return m_front.is_edge(entry.edge) && m_candidates[entry.edge].apex == entry.vertices[2] &&
           sorted_ends(entry.edge) == std::make_pair(entry.vertices[0], entry.vertices[1]);
  }

  std::pair<Point_index, Point_index> sorted_ends(Edge_index e) const
  {
    const auto& ends = m_front.edge(e).ends;
    return std::minmax(ends[0], ends[1]);
  }

  template <typename OnVerdict>
  void attach(const Entry& entry, OnVerdict on_verdict)
  {
    // Turned as the triangle beside the edge: the front keeps the ends of an edge in the order of that one.
    const auto& ends = m_front.edge(entry.edge).ends;
    const Triangle t{ { ends[1], ends[0], entry.vertices[2] } };
    const bool is_agreed = m_candidates[entry.edge].is_agreed;
    const Triangle_verdict verdict = is_agreed ? Triangle_verdict::ADDED : m_builder.try_add(t[0], t[1], t[2]);
    if (verdict != Triangle_verdict::ADDED) {
      // The edge waits until the front around it changes.
      m_candidates[entry.edge].apex = NO_POINT;
      on_verdict(t, verdict);
      return;
    }
    m_front.attach(entry.edge, t[2], m_choose_gap);
    if (!is_agreed)
      m_disputed.push_back(t);
    finish_triangle(t, on_verdict);
  }

  // Takes back the disputed triangles of a region that the growth did not close: one that is incomplete
  // is as likely to be wrong.
  void withdraw_incomplete_regions()
  {
    Parity_union_find regions(m_points.size());
    for (const Triangle& t : m_disputed) {
      regions.unite(t[0], t[1], false);
      regions.unite(t[0], t[2], false);
    }
    std::vector<unsigned char> is_incomplete(m_points.size(), 0);
    for (const Triangle& t : m_disputed)
      for (Point_index p : t)
        if (m_front.is_on_front(p))
          is_incomplete[regions.find(p).root] = 1;
    for (const Triangle& t : m_disputed)
      if (is_incomplete[regions.find(t[0]).root] != 0) {
        m_builder.remove(m_builder.find_triangle(t[0], t[1], t[2]));
        --m_attached;
      }
  }

  template <typename OnVerdict>
  void finish_triangle(const Triangle& t, OnVerdict on_verdict)
  {
    ++m_attached;
    on_verdict(t, Triangle_verdict::ADDED);
    m_candidates.resize(m_front.edge_bound());
    for (Edge_index e : m_front.new_edges())
      enqueue(e);
    // An agreed candidate does not depend on the front around it.
    for (Edge_index e : m_front.relinked_edges())
      if (!m_candidates[e].is_agreed)
        enqueue(e);
  }

  void enqueue(Edge_index e)
  {
    const Front_candidate candidate = m_candidates[e] = m_find_candidate(e);
    if (candidate.apex == NO_POINT)
      return;
    const auto ends = sorted_ends(e);
    m_queue.push(Entry{ candidate.coplanarity, { { ends.first, ends.second, candidate.apex } }, e },
                 !candidate.is_agreed);
  }

  static constexpr std::size_t STEPS_PER_POLL = 1024;

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  Growing_front m_front;
  const Front_candidates<Builder> m_find_candidate;
  const Front_gaps m_choose_gap;
  std::vector<Triangle> m_disputed; // those on which the stars do not agree
  Coplanarity_queue<Entry> m_queue;
  std::vector<Front_candidate> m_candidates; // of the edges
  std::size_t m_attached = 0, m_steps = 0;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_GROWTH_H

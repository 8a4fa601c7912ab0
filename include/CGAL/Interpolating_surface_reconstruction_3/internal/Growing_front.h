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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_GROWING_FRONT_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_GROWING_FRONT_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// What a triangle does to the front (thesis 3.3.3, Fig. 3.7).
enum class Front_event
{
  BEGIN,      // a triangle on its own is a new ring
  EXTEND,     // the triangle brings a new point into the ring
  CLOSE_EAR,  // the triangle fills the gap between adjacent edges
  CLOSE_LOOP, // the triangle fills the last gap of a ring
  SPLIT,      // the triangle reaches another point of its ring and divides it
  MERGE       // the triangle reaches a point of another ring and joins the two
};

// The front of a growing surface: rings of the edges that have one triangle (thesis 3.3.3). It knows
// how edges follow one another, and nothing about where points lie. A ring passes through a point once
// for each gap between the triangles at the point. Edges have no direction, so that parts of the
// surface that began with opposite orientations can meet; the order of its ends only recalls its triangle.
class Growing_front
{
public:
  using Edge_index = std::uint32_t;
  using Ring_index = std::uint32_t;

  static constexpr Edge_index NO_EDGE = (std::numeric_limits<Edge_index>::max)();

  struct Edge
  {
    std::array<Point_index, 2> ends;  // in the order in which the triangle that upholds the edge has them
    Point_index opposite;             // of that triangle
    std::array<Edge_index, 2> links;  // the next edge of the ring, at each end
    std::array<Edge_index, 2> others; // another edge at the same end, whichever ring it is in
    Ring_index ring;
  };

  // A gap at a point, between two edges of a ring that follow one another there.
  struct Gap
  {
    Edge_index first, second;
  };

  explicit Growing_front(Point_index number_of_points)
    : m_edge_at(number_of_points, NO_EDGE), m_is_reached(number_of_points, 0)
  { }

  const Edge& edge(Edge_index e) const { return m_edges[e]; }
  bool is_edge(Edge_index e) const { return m_edges[e].ends[0] != NO_POINT; }
  // Upper bound of the indices of edges.
  Edge_index edge_bound() const { return static_cast<Edge_index>(m_edges.size()); }

  // Whether the surface has a triangle at the point.
  bool is_reached(Point_index p) const { return m_is_reached[p] != 0; }
  // Whether an edge of the front ends at the point.
  bool is_on_front(Point_index p) const { return m_edge_at[p] != NO_EDGE; }

  // The point that follows in the ring beyond an end of the edge: A' or B' in Fig. 3.5.
  Point_index following(Edge_index e, std::size_t end) const
  {
    const Edge& next = m_edges[m_edges[e].links[end]];
    return next.ends[0] == m_edges[e].ends[end] ? next.ends[1] : next.ends[0];
  }

  Edge_index find(Point_index p, Point_index q) const { return find_besides(p, q, NO_EDGE); }

  std::size_t number_of_rings() const { return m_ring_sizes.size() - m_free_rings.size(); }
  std::size_t ring_size(Ring_index r) const { return m_ring_sizes[r]; }

  // The edges that the last triangle brought to the front.
  const std::vector<Edge_index>& new_edges() const { return m_new; }
  // The other edges that got another neighbor in their ring by it.
  const std::vector<Edge_index>& relinked_edges() const { return m_relinked; }

  // Begins a ring with a triangle. If the triangle touches the front, their rings are merged; an edge that
  // it has in common with the front is closed. choose_gap is that of attach().
  template <typename ChooseGap>
  Front_event begin(const std::array<Point_index, 3>& triangle, const ChooseGap& choose_gap)
  {
    clear_changes();
    const Ring_index ring = add_ring(3);
    std::array<Edge_index, 3> edges;
    for (std::size_t i = 0; i != 3; ++i)
      edges[i] = add_edge(triangle[i], triangle[(i + 1) % 3], triangle[(i + 2) % 3], ring);
    for (std::size_t i = 0; i != 3; ++i)
      link(edges[(i + 2) % 3], edges[i], triangle[i]);
    Front_event event = Front_event::BEGIN;
    for (std::size_t i = 0; i != 3; ++i)
      if (is_gap_needed(triangle[i]))
        event = touch(edges[(i + 2) % 3], edges[i], triangle[i], choose_gap);
    bool is_edge_closed = false;
    for (Edge_index e : edges)
      is_edge_closed = zip_if_double(e) || is_edge_closed;
    for (Point_index p : triangle)
      m_is_reached[p] = 1;
    keep_changes();
    return is_edge_closed ? closing_event() : event;
  }

  // Attaches the triangle of the edge and the point p. If the triangle reaches the front at p, and not along
  // an edge, choose_gap(p, a, b, gaps), with the other vertices a and b of the triangle, returns the gap that
  // it lies in, its first edge being the one on the side of a.
  template <typename ChooseGap>
  Front_event attach(Edge_index e, Point_index p, const ChooseGap& choose_gap)
  {
    clear_changes();
    const Edge old = m_edges[e];
    const Edge_index u = add_edge(old.ends[0], p, old.ends[1], old.ring),
                     v = add_edge(p, old.ends[1], old.ends[0], old.ring);
    link(old.links[0], u, old.ends[0]);
    link(old.links[1], v, old.ends[1]);
    link(u, v, p);
    remove_edge(e);
    ++m_ring_sizes[old.ring];
    Front_event event = Front_event::EXTEND;
    if (is_gap_needed(p))
      event = touch(u, v, p, choose_gap);
    const bool is_u_closed = zip_if_double(u), is_v_closed = zip_if_double(v);
    m_is_reached[p] = 1;
    keep_changes();
    return is_u_closed || is_v_closed ? closing_event() : event;
  }

private:
  std::size_t end_at(Edge_index e, Point_index p) const { return m_edges[e].ends[0] == p ? 0 : 1; }
  Edge_index& link_at(Edge_index e, Point_index p) { return m_edges[e].links[end_at(e, p)]; }

  void link(Edge_index e, Edge_index f, Point_index p)
  {
    link_at(e, p) = f;
    link_at(f, p) = e;
    m_relinked.push_back(e);
    m_relinked.push_back(f);
  }

  Edge_index find_besides(Point_index p, Point_index q, Edge_index excluded) const
  {
    for (Edge_index e = m_edge_at[p]; e != NO_EDGE; e = m_edges[e].others[end_at(e, p)])
      if (e != excluded && (m_edges[e].ends[0] == q || m_edges[e].ends[1] == q))
        return e;
    return NO_EDGE;
  }

  Edge_index add_edge(Point_index p, Point_index q, Point_index opposite, Ring_index ring)
  {
    const Edge edge{ { { p, q } }, opposite, { { NO_EDGE, NO_EDGE } }, { { m_edge_at[p], m_edge_at[q] } }, ring };
    Edge_index e = static_cast<Edge_index>(m_edges.size());
    if (m_free_edges.empty()) {
      m_edges.push_back(edge);
    } else {
      e = m_free_edges.back();
      m_free_edges.pop_back();
      m_edges[e] = edge;
    }
    m_edge_at[p] = m_edge_at[q] = e;
    m_new.push_back(e);
    return e;
  }

  void remove_edge(Edge_index e)
  {
    for (std::size_t i = 0; i != 2; ++i) {
      const Point_index p = m_edges[e].ends[i];
      Edge_index* at = &m_edge_at[p];
      while (*at != e)
        at = &m_edges[*at].others[end_at(*at, p)];
      *at = m_edges[e].others[i];
    }
    m_edges[e].ends[0] = m_edges[e].ends[1] = NO_POINT;
    m_free_edges.push_back(e);
  }

  Ring_index add_ring(std::size_t size)
  {
    if (m_free_rings.empty()) {
      m_ring_sizes.push_back(size);
      return static_cast<Ring_index>(m_ring_sizes.size() - 1);
    }
    const Ring_index ring = m_free_rings.back();
    m_free_rings.pop_back();
    m_ring_sizes[ring] = size;
    return ring;
  }

  void remove_ring(Ring_index ring)
  {
    m_ring_sizes[ring] = 0;
    m_free_rings.push_back(ring);
  }

  // Whether the front passes p besides the new triangle, that has two edges there.
  bool is_gap_needed(Point_index p) const
  {
    const Edge_index e = m_edge_at[p], f = m_edges[e].others[end_at(e, p)];
    return m_edges[f].others[end_at(f, p)] != NO_EDGE;
  }

  // The new edges u and v follow one another at p; they enter a gap that the front has there: u gets
  // one side of the gap as its neighbor, v the other.
  template <typename ChooseGap>
  Front_event touch(Edge_index u, Edge_index v, Point_index p, const ChooseGap& choose_gap)
  {
    const Gap gap = find_gap(u, v, p, choose_gap);
    if (m_edges[u].ring != m_edges[gap.first].ring) {
      merge(u, gap.first);
      link(u, gap.first, p);
      link(v, gap.second, p);
      return Front_event::MERGE;
    }
    split(u, v, p, gap);
    return Front_event::SPLIT;
  }

  // A gap beside an edge that the new triangle closes, if any.
  template <typename ChooseGap>
  Gap find_gap(Edge_index u, Edge_index v, Point_index p, const ChooseGap& choose_gap)
  {
    const Point_index a = other_end(u, p), b = other_end(v, p);
    const Edge_index twin_of_u = find_besides(p, a, u);
    if (twin_of_u != NO_EDGE)
      return Gap{ twin_of_u, link_at(twin_of_u, p) };
    const Edge_index twin_of_v = find_besides(p, b, v);
    if (twin_of_v != NO_EDGE)
      return Gap{ link_at(twin_of_v, p), twin_of_v };
    m_gaps.clear();
    for (Edge_index e = m_edge_at[p]; e != NO_EDGE; e = m_edges[e].others[end_at(e, p)])
      if (e != u && e != v && e < link_at(e, p))
        m_gaps.push_back(Gap{ e, link_at(e, p) });
    return choose_gap(p, a, b, m_gaps);
  }

  Point_index other_end(Edge_index e, Point_index p) const
  {
    return m_edges[e].ends[0] == p ? m_edges[e].ends[1] : m_edges[e].ends[0];
  }

  // Divides the ring of u, v and the gap: from v, the ring comes back to p on one side of the gap, and
  // from u on the other. The shorter part becomes a new ring.
  void split(Edge_index u, Edge_index v, Point_index p, const Gap& gap)
  {
    const auto is_end = [&](Edge_index e, Point_index to) { return to == p && (e == gap.first || e == gap.second); };
    Walker from_u{ u, p, 1 }, from_v{ v, p, 1 };
    bool is_v_first = true;
    while (!is_end(from_v.edge, other_end(from_v.edge, from_v.at))) {
      step(from_v);
      if (is_end(from_u.edge, other_end(from_u.edge, from_u.at))) {
        is_v_first = false;
        break;
      }
      step(from_u);
    }
    const Walker& shorter = is_v_first ? from_v : from_u;
    const Edge_index beside = shorter.edge, opposite = beside == gap.first ? gap.second : gap.first;
    link(is_v_first ? v : u, beside, p);
    link(is_v_first ? u : v, opposite, p);
    divide(is_v_first ? v : u, p, shorter.size);
  }

  // The next `size` edges from `e`, left behind at p, become a ring of their own.
  void divide(Edge_index e, Point_index p, std::size_t size)
  {
    m_ring_sizes[m_edges[e].ring] -= size;
    relabel(e, p, size, add_ring(size));
  }

  void relabel(Edge_index e, Point_index p, std::size_t size, Ring_index ring)
  {
    for (Walker walker{ e, p, 1 }; walker.size <= size; step(walker))
      m_edges[walker.edge].ring = ring;
  }

  // Makes one ring of two, of which the shorter one is renamed.
  void merge(Edge_index e, Edge_index f)
  {
    if (m_ring_sizes[m_edges[e].ring] > m_ring_sizes[m_edges[f].ring])
      std::swap(e, f);
    const Ring_index kept = m_edges[f].ring, removed = m_edges[e].ring;
    const std::size_t size = m_ring_sizes[removed];
    relabel(e, m_edges[e].ends[0], size, kept);
    m_ring_sizes[kept] += size;
    remove_ring(removed);
  }

  // A walk along a ring: about to go along the edge from one of its ends.
  struct Walker
  {
    Edge_index edge;
    Point_index at;
    std::size_t size;
  };

  void step(Walker& walker) const
  {
    walker.at = other_end(walker.edge, walker.at);
    walker.edge = m_edges[walker.edge].links[end_at(walker.edge, walker.at)];
    ++walker.size;
  }

  // If the front has the edge twice, the triangles beside it meet there, and the edge is no longer part
  // of the front. Returns whether that was so.
  bool zip_if_double(Edge_index e)
  {
    const Point_index p = m_edges[e].ends[0], q = m_edges[e].ends[1];
    const Edge_index f = find_besides(p, q, e);
    if (f == NO_EDGE)
      return false;
    const Edge_index e_p = link_at(e, p), e_q = link_at(e, q), f_p = link_at(f, p), f_q = link_at(f, q);
    const bool is_adjacent_at_p = e_p == f, is_adjacent_at_q = e_q == f;
    if (m_edges[e].ring != m_edges[f].ring)
      merge(e, f);
    const Ring_index ring = m_edges[e].ring;
    m_ring_sizes[ring] -= 2;
    remove_edge(e);
    remove_edge(f);
    if (!is_adjacent_at_p)
      link(e_p, f_p, p);
    if (!is_adjacent_at_q)
      link(e_q, f_q, q);
    if (m_ring_sizes[ring] == 0)
      remove_ring(ring);
    else if (!is_adjacent_at_p && !is_adjacent_at_q)
      divide_if_apart(e_p, p, e_q, q);
    return true;
  }

  // A triangle that closed edges: the last of a loop, if none of its own edges is left.
  Front_event closing_event() const { return m_new.empty() ? Front_event::CLOSE_LOOP : Front_event::CLOSE_EAR; }

  // The ring of e was joined anew at p and at q, where e and f begin; it may have fallen into two.
  void divide_if_apart(Edge_index e, Point_index p, Edge_index f, Point_index q)
  {
    const Edge_index last_of_e = link_at(e, p), last_of_f = link_at(f, q);
    Walker from_e{ e, p, 1 }, from_f{ f, q, 1 };
    const auto is_back = [&](const Walker& walker, Edge_index last, Point_index start) {
      return walker.edge == last && other_end(walker.edge, walker.at) == start;
    };
    while (!is_back(from_e, last_of_e, p) && !is_back(from_f, last_of_f, q)) {
      step(from_e);
      step(from_f);
    }
    if (from_e.size == m_ring_sizes[m_edges[e].ring])
      return;
    if (is_back(from_e, last_of_e, p))
      divide(e, p, from_e.size);
    else
      divide(f, q, from_f.size);
  }

  void clear_changes()
  {
    m_new.clear();
    m_relinked.clear();
  }

  // Drops what is no edge any more, and what is listed twice.
  void keep_changes()
  {
    const auto is_removed = [&](Edge_index e) { return !is_edge(e); };
    m_new.erase(std::remove_if(m_new.begin(), m_new.end(), is_removed), m_new.end());
    std::size_t kept = 0;
    for (Edge_index e : m_relinked)
      if (is_edge(e) && std::find(m_new.begin(), m_new.end(), e) == m_new.end() &&
          std::find(m_relinked.begin(), m_relinked.begin() + std::ptrdiff_t(kept), e) ==
            m_relinked.begin() + std::ptrdiff_t(kept))
        m_relinked[kept++] = e;
    m_relinked.resize(kept);
  }

  std::vector<Edge> m_edges;
  std::vector<Edge_index> m_free_edges;
  std::vector<Edge_index> m_edge_at;       // an edge at each point
  std::vector<unsigned char> m_is_reached; // of each point
  std::vector<std::size_t> m_ring_sizes;   // 0 if the ring is free
  std::vector<Ring_index> m_free_rings;
  std::vector<Edge_index> m_new, m_relinked;
  std::vector<Gap> m_gaps;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_GROWING_FRONT_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TRIANGLE_ATTACHMENT_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TRIANGLE_ATTACHMENT_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Manifold_builder.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_measures.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <queue>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Attaches the triangles of the stars on which not all three vertices agree (thesis 4.3.5): the most
// planar ones first, measured against the triangles that are there already.
template <typename Builder>
class Triangle_attachment
{
public:
  Triangle_attachment(const std::vector<Local_point>& points, Builder& builder)
    : m_points(points), m_builder(builder)
  {
    collect_candidates();
  }

  // Proposes every candidate once its turn comes; on_verdict(triangle, verdict) is told.
  template <typename Progress, typename OnVerdict>
  void operator()(Progress& progress, OnVerdict on_verdict)
  {
    std::size_t proposed = 0;
    for (std::size_t i = 0; i != m_candidates.size(); ++i)
      push(i);
    while (!m_queue.empty()) {
      const Entry entry = m_queue.top();
      m_queue.pop();
      Candidate& candidate = m_candidates[entry.candidate];
      if (candidate.is_done || entry.priority != candidate.priority)
        continue;
      if (++proposed % PROPOSALS_PER_REPORT == 0 && !progress.advance(double(proposed) / double(m_candidates.size())))
        return;
      candidate.is_done = true;
      const Triangle& t = candidate.vertices;
      const Triangle_verdict verdict = m_builder.try_add(t[0], t[1], t[2]);
      on_verdict(t, verdict);
      if (verdict == Triangle_verdict::ADDED)
        update_around(t);
    }
  }

private:
  using Triangle = typename Builder::Triangle;

  struct Candidate
  {
    Triangle vertices; // increasing
    int votes;
    bool is_done;
    double priority;
    bool operator<(const Candidate& other) const { return vertices < other.vertices; }
    bool operator==(const Candidate& other) const { return vertices == other.vertices; }
  };

  struct Entry
  {
    double priority;
    std::size_t candidate;
    bool operator<(const Entry& other) const
    {
      return priority < other.priority || (priority == other.priority && candidate > other.candidate);
    }
  };

  void collect_candidates()
  {
    const Star_compatibility& compatibility = m_builder.compatibility();
    const Star_table& stars = compatibility.stars();
    for (Point_index p : m_builder.open_points())
      for (Star_table::Slot s = stars.begin(p); s != stars.end(p); ++s) {
        if (compatibility.votes(s) == 0 || compatibility.is_triangle_agreed(s))
          continue;
        const Point_index a = stars.neighbor(s), b = stars.neighbor(stars.next(p, s));
        if (!m_builder.is_open(a) || !m_builder.is_open(b))
          continue;
        Candidate candidate{ Triangle{ { p, a, b } }, compatibility.votes(s), false, 0. };
        std::sort(candidate.vertices.begin(), candidate.vertices.end());
        m_candidates.push_back(candidate);
      }
    std::sort(m_candidates.begin(), m_candidates.end());
    m_candidates.erase(std::unique(m_candidates.begin(), m_candidates.end()), m_candidates.end());
    index_by_vertex();
  }

  void index_by_vertex()
  {
    for (std::size_t i = 0; i != m_candidates.size(); ++i)
      for (Point_index p : m_candidates[i].vertices)
        m_at_vertex.push_back(At_vertex{ p, i });
    std::sort(m_at_vertex.begin(), m_at_vertex.end());
  }

  // Planarity with the triangles that the candidate would join, a credit for each edge that it would
  // close, and its votes.
  double priority(const Candidate& candidate) const
  {
    double result = VOTE_CREDIT * candidate.votes;
    const Triangle& t = candidate.vertices;
    for (std::size_t i = 0; i != 3; ++i) {
      const Point_index p = t[i], q = t[(i + 1) % 3], r = t[(i + 2) % 3];
      const Point_index opposite = m_builder.opposite_vertex(p, q);
      if (opposite != NO_POINT)
        result += EDGE_CREDIT + cosine_of_supplementary_angle(m_points[p], m_points[q], m_points[r], m_points[opposite]);
    }
    return result;
  }

  void push(std::size_t i)
  {
    m_candidates[i].priority = priority(m_candidates[i]);
    m_queue.push(Entry{ m_candidates[i].priority, i });
  }

  // A new triangle changes the priority of the candidates that share an edge with it.
  void update_around(const Triangle& t)
  {
    for (Point_index p : t)
      for (auto it = std::lower_bound(m_at_vertex.begin(), m_at_vertex.end(), At_vertex{ p, 0 });
           it != m_at_vertex.end() && it->vertex == p; ++it) {
        const Candidate& candidate = m_candidates[it->candidate];
        const auto shared = std::count_if(t.begin(), t.end(), [&](Point_index q) {
          return std::find(candidate.vertices.begin(), candidate.vertices.end(), q) != candidate.vertices.end();
        });
        if (!candidate.is_done && shared == 2)
          push(it->candidate);
      }
  }

  struct At_vertex
  {
    Point_index vertex;
    std::size_t candidate;
    bool operator<(const At_vertex& other) const
    {
      return vertex < other.vertex || (vertex == other.vertex && candidate < other.candidate);
    }
  };

  static constexpr std::size_t PROPOSALS_PER_REPORT = 1024;

  // A vote weighs as much as a right angle, so does an edge: both are as good as coplanarity.
public:
  static inline double VOTE_CREDIT = 1., EDGE_CREDIT = 1.;
private:

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  std::vector<Candidate> m_candidates;
  std::vector<At_vertex> m_at_vertex;
  std::priority_queue<Entry> m_queue;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TRIANGLE_ATTACHMENT_H

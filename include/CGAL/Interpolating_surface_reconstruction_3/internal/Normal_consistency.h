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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_NORMAL_CONSISTENCY_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_NORMAL_CONSISTENCY_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Dipole_view.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Turns the area vectors of the points of a surface towards the gradient of the winding number that they make, again and
// again. Right ones do not turn: across a surface the winding number falls along the normal. In this field, points side
// by side turn each other to the same side, and points in front of and behind each other, as on two sheets, to opposite
// ones. What has turned over altogether stays so. (Lin, Shi and Liu, Fast and globally consistent normal orientation
// based on the winding number normal consistency, ACM Transactions on Graphics 43, 2024; here the field is that of the
// neighbors in the Delaunay triangulation alone.)
class Normal_consistency
{
public:
  explicit Normal_consistency(const std::vector<Local_point>& points) : m_points(points) { }

  // For what follows. `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  void set_cells(const Cell_complex& cells, Cancellation_point& cancellation_point)
  {
    find_edges(cells, cancellation_point);
    find_softenings(cells.points().size());
    m_views.clear();
    m_views.reserve(m_edges.size());
    for (const Edge& e : m_edges)
      m_views.emplace_back(e.to_second, (m_softenings[e.first] + m_softenings[e.second]) / 2.);
  }

  // `areas` are those of the points of the cells, in their order, away from the inside or all towards it. They keep their
  // lengths. `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  void operator()(std::vector<Local_vector>& areas, Cancellation_point& cancellation_point)
  {
    for (int round = 0; round != ROUNDS; ++round)
      turn(areas, cancellation_point);
  }

  // The same for the points with `is_unknown[k]` alone, whose area vectors have no direction at first.
  template <typename Cancellation_point>
  void find_unknown(const std::vector<unsigned char>& is_unknown, std::vector<Local_vector>& areas,
                    Cancellation_point& cancellation_point)
  {
    const std::vector<Local_vector> old = areas;
    for (std::size_t k = 0; k != areas.size(); ++k)
      if (is_unknown[k])
        areas[k] = Local_vector(0, 0, 0);
    std::vector<Local_vector> of_known(areas.size(), Local_vector(0, 0, 0));
    std::vector<std::size_t> edges; // between unknown ones
    for (std::size_t e = 0; e != m_edges.size(); ++e) {
      cancellation_point();
      const std::uint32_t a = m_edges[e].first, b = m_edges[e].second;
      if (is_unknown[a] && is_unknown[b])
        edges.push_back(e);
      else if (is_unknown[a])
        of_known[a] = of_known[a] + m_views[e].field(areas[b]);
      else if (is_unknown[b])
        of_known[b] = of_known[b] + m_views[e].field(areas[a]);
    }
    for (int round = 0; round != ROUNDS_FROM_NOTHING; ++round) {
      m_field = of_known;
      for (std::size_t k = 0; k != areas.size(); ++k)
        if (is_unknown[k])
          m_field[k] = m_field[k] + Dipole_view(Local_vector(0, 0, 0), m_softenings[k]).field(areas[k]);
      for (std::size_t e : edges) {
        cancellation_point();
        exchange_fields(e, areas);
      }
      for (std::size_t k = 0; k != areas.size(); ++k)
        if (is_unknown[k] && m_field[k] != Local_vector(0, 0, 0))
          areas[k] = turned_to_field(old[k], m_field[k]);
    }
  }

private:
  // Measured: five are too few, forty no better.
  static constexpr int ROUNDS = 10;

  // Directions spread from neighbor to neighbor. Measured: with ten, fewer are right.
  static constexpr int ROUNDS_FROM_NOTHING = 40;

  struct Edge
  {
    std::uint32_t first, second; // positions of its ends
    Local_vector to_second;
  };

  template <typename Cancellation_point>
  void find_edges(const Cell_complex& cells, Cancellation_point& cancellation_point)
  {
    static constexpr std::size_t ENDS[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
    // By their ends of smaller index; every edge is one of several cells.
    const std::size_t n = cells.points().size();
    std::vector<std::size_t> end(n + 1, 0);
    std::vector<std::uint32_t> others;
    const auto for_each_edge = [&](const auto& visit) {
      for (std::size_t c = 0; c != cells.size(); ++c) {
        cancellation_point();
        if (Cell_complex::is_infinite(cells[c]))
          continue;
        std::array<std::uint32_t, 4> v;
        for (std::size_t i = 0; i != 4; ++i)
          v[i] = static_cast<std::uint32_t>(cells.position(cells[c].vertices[i]));
        for (const auto& e : ENDS)
          visit((std::min)(v[e[0]], v[e[1]]), (std::max)(v[e[0]], v[e[1]]));
      }
    };
    for_each_edge([&](std::uint32_t a, std::uint32_t) { ++end[a + 1]; });
    for (std::size_t k = 0; k != n; ++k)
      end[k + 1] += end[k];
    others.resize(end[n]);
    for_each_edge([&](std::uint32_t a, std::uint32_t b) { others[end[a]++] = b; });
    m_edges.clear();
    m_last.assign(n, static_cast<std::uint32_t>(n));
    for (std::size_t a = 0, k = 0; a != n; ++a)
      for (; k != end[a]; ++k)
        if (m_last[others[k]] != a) {
          m_last[others[k]] = static_cast<std::uint32_t>(a);
          m_edges.push_back(Edge{ static_cast<std::uint32_t>(a), others[k],
                                  m_points[cells.points()[others[k]]] - m_points[cells.points()[a]] });
        }
  }

  // Of `n` points, squared.
  void find_softenings(std::size_t n)
  {
    std::vector<std::size_t> end(n + 1, 0); // of the lengths at each point, so far
    for (const Edge& e : m_edges) {
      ++end[e.first + 1];
      ++end[e.second + 1];
    }
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<double> lengths(end[n]);
    for (const Edge& e : m_edges)
      lengths[end[e.first]++] = lengths[end[e.second]++] = e.to_second.squared_length();
    m_softenings.assign(n, 0.);
    for (std::size_t k = 0, begin = 0; k != n; begin = end[k], ++k)
      if (begin != end[k]) {
        const auto first = lengths.begin() + std::ptrdiff_t(begin), last = lengths.begin() + std::ptrdiff_t(end[k]);
        const auto sixth = first + std::ptrdiff_t((std::min)(DIPOLE_NEIGHBORS, end[k] - begin) - 1);
        std::nth_element(first, sixth, last);
        m_softenings[k] = DIPOLE_SOFTENING * DIPOLE_SOFTENING * *sixth;
      }
  }

  template <typename Cancellation_point>
  void turn(std::vector<Local_vector>& areas, Cancellation_point& cancellation_point)
  {
    m_field.clear();
    for (std::size_t k = 0; k != areas.size(); ++k)
      m_field.push_back(Dipole_view(Local_vector(0, 0, 0), m_softenings[k]).field(areas[k]));
    for (std::size_t e = 0; e != m_edges.size(); ++e) {
      cancellation_point();
      exchange_fields(e, areas);
    }
    for (std::size_t k = 0; k != areas.size(); ++k)
      areas[k] = turned_to_field(areas[k], m_field[k]);
  }

  void exchange_fields(std::size_t e, const std::vector<Local_vector>& areas)
  {
    const std::uint32_t a = m_edges[e].first, b = m_edges[e].second;
    m_field[a] = m_field[a] + m_views[e].field(areas[b]);
    m_field[b] = m_field[b] + m_views[e].field(areas[a]); // the same from the other side
  }

  const std::vector<Local_point>& m_points;
  std::vector<Edge> m_edges;
  std::vector<Dipole_view> m_views; // of the edges
  std::vector<double> m_softenings;
  std::vector<std::uint32_t> m_last;
  std::vector<Local_vector> m_field;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_NORMAL_CONSISTENCY_H

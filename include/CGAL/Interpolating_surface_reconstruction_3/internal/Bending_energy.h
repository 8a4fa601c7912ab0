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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BENDING_ENERGY_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BENDING_ENERGY_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Bending_edges.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Corner_test.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Label_stars.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The energy of the surface between two labels of the cells of a Delaunay triangulation: every edge costs
// its length times half of the square of the angle by which the surface bends there, and a small share of
// its length, which is what remains to be decided where the surface is flat. A point at which the surface is
// no manifold costs several edges, and so do lost corners if they are counted. Of all surfaces through the points the flattest is seldom wrong, even
// where the points are too sparse for the shapes of the triangles to tell (thesis 4.2.2: coplanarity).
template <typename Labelling>
class Bending_energy
{
public:
  using Cell_index = Cell_complex::Cell_index;

  // Only cells with `is_free(c)`, which are finite, can be asked for and change. Only points with `is_in_scope(p)` must be
  // manifold. From now on, all labels change by change(). `cancellation_point()` is called again and again and may throw.
  template <typename IsFree, typename IsAgreed, typename IsInScope, typename Cancellation_point>
  Bending_energy(const Cell_complex& cells, const std::vector<Local_point>& points, Labelling& labelling,
                 const IsFree& is_free, const IsAgreed& is_agreed, const IsInScope& is_in_scope,
                 Cancellation_point&& cancellation_point)
    : m_cells(cells), m_points(points), m_labelling(labelling), m_edges(cells, points, labelling),
      m_stars(cells, labelling), m_defect_costs(cells.points().size(), NO_COST),
      m_defects(cells.points().size(), NOT_COUNTED), m_agreed(cells.size(), 0)
  {
    for (Cell_index c = 0; c != cells.size(); ++c) {
      cancellation_point();
      if (!is_free(c))
        continue;
      for (std::size_t i = 0; i != 4; ++i) {
        if (is_agreed(c, i))
          m_agreed[c] = static_cast<unsigned char>(m_agreed[c] | (1u << i));
        const std::size_t v = position_of(cells[c].vertices[i]);
        if (m_defect_costs[v] == NO_COST)
          m_defect_costs[v] = is_in_scope(cells[c].vertices[i]) ? find_defect_cost(v) : 0.;
      }
    }
  }

  // Whether the energy around the finite cell can be told: no vertex is a hub, a point of very many cells.
  bool has_no_hub(Cell_index c) const
  {
    return std::none_of(m_cells[c].vertices.begin(), m_cells[c].vertices.end(),
                        [&](Point_index p) { return m_stars.is_hub(position_of(p)); });
  }

  // By how much the energy grows if the finite cell without hub changes its label.
  double cost_of_change(Cell_index c)
  {
    m_last = c;
    double result = 0.;
    std::uint32_t corners = 0,
                  arcs = 0; // at each vertex, in bytes: the edges and facets of the cell that are on the surface
    std::array<int, 4> bent_edges{}; // at each vertex after the change, of those looked at
    if (!m_is_corner.empty())
      for (std::size_t i = 0; i != 4; ++i)
        bent_edges[i] = m_edges.number_of_bent(position_of(m_cells[c].vertices[i]));
    for (std::size_t e = 0; e != Edges::EDGES_OF_CELL; ++e) {
      const std::size_t i = Edges::ENDS[e][0], j = Edges::ENDS[e][1];
      const typename Edges::Change change = m_edges.change(c, e);
      result += change.cost;
      corners += std::uint32_t(change.is_on_surface) * (byte(i) + byte(j));
      bent_edges[i] += change.bent_edges;
      bent_edges[j] += change.bent_edges;
    }
    for (std::size_t i = 0; i != 4; ++i) {
      const bool is_on_surface = m_labelling.is_surface(c, i);
      arcs += std::uint32_t(is_on_surface) * (ALL_BYTES - byte(i));
      if (m_agreement != 0. && is_agreed(c, i))
        result += (is_on_surface ? 1. : -1.) * worth_of_agreement(Cell_complex::facet(m_cells[c], i));
    }
    for (std::size_t i = 0; i != 4; ++i)
      result += cost_at_point(c, i, arcs >> 8 * i & 3, corners >> 8 * i & 3, bent_edges[i]);
    return result;
  }

  // Whether the surface bends by more than the angle at an edge of the finite cell, or has a defect at a vertex.
  bool bends_more_than(double angle, Cell_index c)
  {
    for (std::size_t e = 0; e != Edges::EDGES_OF_CELL; ++e)
      if (m_edges.bending(c, e) > angle)
        return true;
    return std::any_of(m_cells[c].vertices.begin(), m_cells[c].vertices.end(),
                       [&](Point_index p) { return defects(position_of(p)) != 0; });
  }

  // Of the vertices of a cell.
  using Defects = std::array<int, 4>;

  // Changes the label of the finite cell without hub; returns what change_back() needs.
  Defects change(Cell_index c)
  {
    if (m_last != c)
      cost_of_change(c);
    const Defects after = m_defects_after_change;
    const Defects before = set_defects(c, after);
    flip(c);
    return before;
  }

  // Takes the last change back that is not yet taken back.
  void change_back(Cell_index c, const Defects& before)
  {
    flip(c);
    set_defects(c, before);
  }

  // From now on, an agreed facet on the surface is worth half of its perimeter times the factor.
  void set_worth_of_agreement(double factor) { m_agreement = factor; }

  // From now on, lost corners (see Corner_test) with `is_counted(p)` are defects.
  template <typename IsCounted>
  void count_lost_corners(const IsCounted& is_counted)
  {
    std::fill(m_defects.begin(), m_defects.end(), NOT_COUNTED);
    m_is_corner.clear();
    for (Point_index p : m_cells.points())
      m_is_corner.push_back(is_counted(p) ? 1 : 0);
  }

  bool has_lost_agreed_facet(Cell_index c) const
  {
    for (std::size_t i = 0; i != 4; ++i)
      if (is_agreed(c, i) && !m_labelling.is_surface(c, i))
        return true;
    return false;
  }

  // What a defect costs at the vertices of the finite cell, at most.
  double cost_of_defect(Cell_index c) const
  {
    double result = 0.;
    for (Point_index p : m_cells[c].vertices)
      result = (std::max)(result, m_defect_costs[position_of(p)]);
    return result;
  }

  Label_stars<Labelling>& stars() { return m_stars; }

private:
  using Edges = Bending_edges<Labelling>;

  // Edges of mean length that a defect costs.
  static constexpr double DEFECT_EDGES = 3.;

  // Of vertices that are not asked for.
  static constexpr double NO_COST = -1.;

  // In place of a number of defects. A lost corner is one where there is no other.
  static constexpr int NOT_COUNTED = -1, LOST_CORNER = -2;

  // The defects that the change of a triangle leads to, after the arcs and the corners of it that are on the cycle. An
  // arc has two corners.
  static constexpr int DEFECTS_BESIDE_CYCLE[4][4] = { { 1, 1, 2, 3 }, { 0, 0, 0, 1 }, { 0, 0, 0, 0 }, { 1, 1, 1, 1 } };

  static constexpr std::uint32_t ALL_BYTES = 0x01010101;

  // Of three vertices, around and around.
  static constexpr std::uint8_t NEXT[4] = { 1, 2, 0, 1 };

  static constexpr std::uint32_t byte(std::size_t i) { return std::uint32_t(1) << 8 * i; }

  void flip(Cell_index c)
  {
    m_labelling.flip(c);
    m_edges.flip(c);
    m_stars.flip(c);
    m_last = Cell_complex::NO_CELL;
  }

  std::size_t position_of(Point_index p) const { return m_cells.position(p); }

  // After the mean length of the edges of the surface at the vertex, or of all edges if it is off the surface. An edge
  // counts for each of its facets.
  double find_defect_cost(std::size_t v) const
  {
    const Point_index p = m_cells.points()[v];
    for (const bool is_surface : { true, false }) {
      double sum = 0.;
      std::size_t edges = 0;
      m_stars.for_each_cell(v, [&](Cell_index c) {
        for (std::size_t i = 0; i != 4; ++i) {
          if (m_cells[c].neighbors[i] <= c || m_cells[c].vertices[i] == p ||
              (is_surface && !m_labelling.is_surface(c, i)))
            continue;
          const std::array<Point_index, 3> f = Cell_complex::facet(m_cells[c], i);
          if (Cell_complex::is_infinite(f))
            continue;
          for (std::size_t k = 0; k != 3; ++k) {
            const Point_index q = f[k], r = f[(k + 1) % 3];
            if (q == p || r == p) {
              sum += length(q, r);
              ++edges;
            }
          }
        }
      });
      if (edges != 0)
        return DEFECT_EDGES * sum / double(edges);
    }
    return 0.;
  }

  bool is_agreed(Cell_index c, std::size_t i) const { return (m_agreed[c] >> i & 1) != 0; }

  double worth_of_agreement(const std::array<Point_index, 3>& f) const
  {
    return .5 * m_agreement * (length(f[0], f[1]) + length(f[1], f[2]) + length(f[2], f[0]));
  }

  double length(Point_index p, Point_index q) const { return std::sqrt((m_points[q] - m_points[p]).squared_length()); }

  // The change of the defects at vertex i. Where there are none, the surface meets a sphere around the point in
  // one cycle of arcs, and it is known what the triangle of the cell there, which has `arcs` and `corners` on it, does
  // to it.
  double cost_at_point(Cell_index c, std::size_t i, std::size_t arcs, std::size_t corners, int bent_edges)
  {
    const std::size_t v = position_of(m_cells[c].vertices[i]);
    m_defects_after_change[i] = 0;
    if (m_defect_costs[v] == 0.)
      return 0.;
    const int before = defects(v);
    int& after = m_defects_after_change[i];
    after = before > 0 ? m_stars.defects(v, c) : DEFECTS_BESIDE_CYCLE[arcs][corners];
    if (!m_is_corner.empty() && after == 0 && bent_edges == 0 && is_lost_corner(v, c))
      after = LOST_CORNER;
    return m_defect_costs[v] * double(number(after) - number(before));
  }

  static int number(int defects) { return defects == LOST_CORNER ? 1 : defects; }

  // With the label of cell `changed` the other way round.
  bool is_lost_corner(std::size_t v, Cell_index changed)
  {
    if (m_is_corner.empty() || m_is_corner[v] == 0 || m_stars.is_hub(v))
      return false;
    const auto label = [&](Cell_index c) { return m_labelling.label(c) != (c == changed); };
    const Point_index p = m_cells.points()[v];
    Corner_test test(m_points[p]);
    m_stars.for_each_cell_at_surface(v, changed, [&](Cell_index c) {
      for (std::size_t i = 0; i != 4 && test.is_flat(); ++i)
        if (m_cells[c].vertices[i] != p && !label(m_cells[c].neighbors[i]))
          add_facet(p, c, i, test);
    });
    return test.is_lost();
  }

  // Facet i of a finite cell, of which p is a vertex.
  void add_facet(Point_index p, Cell_index c, std::size_t i, Corner_test& test) const
  {
    const std::array<Point_index, 3> f = Cell_complex::facet(m_cells[c], i);
    const std::size_t k = f[0] == p ? 0 : f[1] == p ? 1 : 2;
    const Local_point& a = m_points[f[NEXT[k]]];
    const Local_point& b = m_points[f[NEXT[k + 1]]];
    if (i % 2 == 0)
      test.add_facet(a, b);
    else
      test.add_facet(b, a);
  }

  // Returns those before.
  Defects set_defects(Cell_index c, const Defects& defects)
  {
    Defects before;
    for (std::size_t i = 0; i != 4; ++i) {
      int& at_vertex = m_defects[position_of(m_cells[c].vertices[i])];
      before[i] = at_vertex;
      at_vertex = defects[i];
    }
    return before;
  }

  // The defects at vertex v; most are never asked for.
  int defects(std::size_t v)
  {
    if (m_defects[v] == NOT_COUNTED) {
      m_defects[v] = m_defect_costs[v] == 0. || m_stars.is_hub(v) ? 0 : m_stars.defects(v);
      if (m_defects[v] == 0 && is_lost_corner(v, Cell_complex::NO_CELL))
        m_defects[v] = LOST_CORNER;
    }
    return m_defects[v];
  }

  const Cell_complex& m_cells;
  const std::vector<Local_point>& m_points;
  Labelling& m_labelling;
  Edges m_edges;
  Label_stars<Labelling> m_stars;
  std::vector<double> m_defect_costs;     // of the vertices of free cells; 0 out of the scope
  std::vector<int> m_defects;             // of the vertices, now
  std::vector<unsigned char> m_is_corner; // of the vertices, whether it counts if it is lost; empty if none does
  std::vector<unsigned char> m_agreed;    // facets of the cells, as bits
  double m_agreement = 0.;
  Cell_index m_last = Cell_complex::NO_CELL; // cell whose cost has been told
  Defects m_defects_after_change{};          // of the last cell
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BENDING_ENERGY_H

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

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
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
// no manifold costs several edges. Of all surfaces through the points the flattest is seldom wrong, even
// where the points are too sparse for the shapes of the triangles to tell (thesis 4.2.2: coplanarity).
template <typename Labelling>
class Bending_energy
{
public:
  using Cell_index = Cell_complex::Cell_index;

  // Only points with `is_in_scope(p)` must be manifold. From now on, all labels change by change().
  // `cancellation_point()` is called again and again and may throw.
  template <typename IsAgreed, typename IsInScope, typename Cancellation_point>
  Bending_energy(const Cell_complex& cells, const std::vector<Local_point>& points, Labelling& labelling,
                 const IsAgreed& is_agreed, const IsInScope& is_in_scope, Cancellation_point&& cancellation_point)
    : m_cells(cells), m_points(points), m_labelling(labelling), m_stars(cells, labelling),
      m_defect_costs(cells.points().size(), 0.), m_defects(cells.points().size(), NOT_COUNTED),
      m_agreed(cells.size(), 0)
  {
    for (Cell_index c = 0; c != cells.size(); ++c) {
      cancellation_point();
      for (std::size_t i = 0; i != 4; ++i)
        if (is_agreed(c, i))
          m_agreed[c] = static_cast<unsigned char>(m_agreed[c] | (1u << i));
    }
    find_defect_costs(is_in_scope, cancellation_point);
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
    for (std::size_t i = 0; i != 4; ++i)
      for (std::size_t j = i + 1; j != 4; ++j) {
        result += cost_at_edge(c, i, j);
        m_is_edge_on_surface[i][j] = m_is_edge_on_surface[j][i] = m_facets_at_edge != 0;
      }
    for (std::size_t i = 0; i != 4; ++i) {
      m_is_facet_on_surface[i] = m_labelling.is_surface(c, i);
      if (m_agreement != 0. && is_agreed(c, i))
        result += (m_is_facet_on_surface[i] ? 1. : -1.) * worth_of_agreement(Cell_complex::facet(m_cells[c], i));
    }
    for (std::size_t i = 0; i != 4; ++i)
      result += cost_at_point(c, i);
    return result;
  }

  // Whether the surface bends by more than the angle at an edge of the finite cell, or is no manifold at a vertex.
  bool bends_more_than(double angle, Cell_index c)
  {
    m_largest_bending = 0.;
    cost_of_change(c);
    return m_largest_bending > angle || std::any_of(m_cells[c].vertices.begin(), m_cells[c].vertices.end(),
                                                    [&](Point_index p) { return defects(position_of(p), c) != 0; });
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
    m_labelling.flip(c);
    m_last = Cell_complex::NO_CELL;
    return before;
  }

  // Takes the last change back that is not yet taken back.
  void change_back(Cell_index c, const Defects& before)
  {
    m_labelling.flip(c);
    set_defects(c, before);
    m_last = Cell_complex::NO_CELL;
  }

  // From now on, an agreed facet on the surface is worth half of its perimeter times the factor.
  void set_worth_of_agreement(double factor) { m_agreement = factor; }

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
  // Edges of mean length that a defect costs.
  static constexpr double DEFECT_EDGES = 3.;

  static constexpr int NOT_COUNTED = -1;

  // Worth of an edge where the surface is flat.
  static constexpr double FLAT_SHARE = .1;

  static constexpr double PI = 3.14159265358979323846;

  std::size_t position_of(Point_index p) const { return m_cells.position(p); }

  // After the mean length of the edges of the surface at a point, or of all edges if it is off the surface.
  template <typename IsInScope, typename Cancellation_point>
  void find_defect_costs(const IsInScope& is_in_scope, Cancellation_point& cancellation_point)
  {
    std::vector<std::uint32_t> edges(m_defect_costs.size(), 0), edges_of_surface(m_defect_costs.size(), 0);
    for (const bool is_surface : { true, false }) {
      for (Cell_index c = 0; c != m_cells.size(); ++c) {
        cancellation_point();
        for (std::size_t i = 0; i != 4; ++i)
          if (m_cells[c].neighbors[i] > c && (!is_surface || m_labelling.is_surface(c, i)))
            add_edges(Cell_complex::facet(m_cells[c], i), edges_of_surface, edges);
      }
      edges_of_surface = edges;
    }
    for (std::size_t v = 0; v != m_defect_costs.size(); ++v)
      m_defect_costs[v] =
        edges[v] != 0 && is_in_scope(m_cells.points()[v]) ? DEFECT_EDGES * m_defect_costs[v] / edges[v] : 0.;
  }

  // Adds and counts the lengths of the edges of a facet at the points that have no others.
  void add_edges(const std::array<Point_index, 3>& f, const std::vector<std::uint32_t>& others,
                 std::vector<std::uint32_t>& edges)
  {
    if (Cell_complex::is_infinite(f))
      return;
    for (std::size_t i = 0; i != 3; ++i) {
      const std::array<Point_index, 2> edge{ { f[i], f[(i + 1) % 3] } };
      for (Point_index p : edge)
        if (others[position_of(p)] == 0) {
          m_defect_costs[position_of(p)] += length(edge[0], edge[1]);
          ++edges[position_of(p)];
        }
    }
  }

  bool is_agreed(Cell_index c, std::size_t i) const { return (m_agreed[c] >> i & 1) != 0; }

  double worth_of_agreement(const std::array<Point_index, 3>& f) const
  {
    return .5 * m_agreement * (length(f[0], f[1]) + length(f[1], f[2]) + length(f[2], f[0]));
  }

  double length(Point_index p, Point_index q) const { return std::sqrt((m_points[q] - m_points[p]).squared_length()); }

  // The change of the energy of the edge between vertices i and j.
  double cost_at_edge(Cell_index c, std::size_t i, std::size_t j)
  {
    const Point_index p = m_cells[c].vertices[i], q = m_cells[c].vertices[j];
    if (p == NO_POINT || q == NO_POINT)
      return 0.;
    std::size_t exit = 0;
    while (exit == i || exit == j)
      ++exit;
    const std::size_t last = 6 - i - j - exit; // the indices of a cell add up to 6
    const Point_index first_apex = m_cells[c].vertices[last], last_apex = m_cells[c].vertices[exit];
    m_inner_facets = 0;
    // Around the edge, from facet to facet, but for the two facets of the cell itself.
    Cell_index current = m_cells[c].neighbors[exit];
    Point_index apex = first_apex;
    bool label = m_labelling.label(current);
    const bool first_label = label;
    while (true) {
      const auto& vertices = m_cells[current].vertices;
      const std::size_t k =
        (vertices[1] == apex ? 1u : 0u) + (vertices[2] == apex ? 2u : 0u) + (vertices[3] == apex ? 3u : 0u);
      const Cell_index next = m_cells[current].neighbors[k];
      apex ^= p ^ q ^ vertices[0] ^ vertices[1] ^ vertices[2] ^ vertices[3]; // the fourth vertex
      if (next == c)
        break;
      const bool next_label = m_labelling.label(next);
      if (next_label != label) {
        if (m_inner_facets < m_apexes.size())
          m_apexes[m_inner_facets] = apex;
        ++m_inner_facets;
      }
      label = next_label;
      current = next;
    }
    const bool own = m_labelling.label(c);
    m_facets_at_edge = m_inner_facets + (own != first_label ? 1 : 0) + (own != label ? 1 : 0);
    const double now = energy_of_edge(p, q, own != first_label, own != label, first_apex, last_apex);
    m_largest_bending = (std::max)(m_largest_bending, m_bending);
    return energy_of_edge(p, q, own == first_label, own == label, first_apex, last_apex) - now;
  }

  // The energy of an edge with the inner facets of the surface and the two others if they are on it.
  double energy_of_edge(Point_index p, Point_index q, bool has_first, bool has_last, Point_index first,
                        Point_index last)
  {
    const std::size_t inner = m_inner_facets, facets = inner + (has_first ? 1 : 0) + (has_last ? 1 : 0);
    m_bending = facets == 0 ? 0. : PI;
    if (facets == 0)
      return 0.;
    if (facets != 2)
      return length(p, q) * double(facets / 2) * (FLAT_SHARE + .5 * PI * PI);
    const Point_index a = inner != 0 ? m_apexes[0] : first, b = inner == 2 ? m_apexes[1] : has_last ? last : first;
    m_bending = a == NO_POINT || b == NO_POINT ? 0. : bending_angle(p, q, a, b);
    return length(p, q) * (FLAT_SHARE + .5 * m_bending * m_bending);
  }

  // Between the planes of triangles p, q, a and q, p, b: 0 if they are flat.
  double bending_angle(Point_index p, Point_index q, Point_index a, Point_index b) const
  {
    const Local_vector e = m_points[q] - m_points[p];
    const Local_vector m = cross_product(e, m_points[a] - m_points[p]), n = cross_product(m_points[b] - m_points[p], e);
    const double scale = std::sqrt(m.squared_length() * n.squared_length());
    return scale == 0. ? PI : std::acos((std::max)(-1., (std::min)(1., m * n / scale)));
  }

  // The change of the defects at vertex i. Where there are none, the surface meets a sphere around the point in
  // one cycle of arcs, and it is known what the triangle of the cell there does to it.
  double cost_at_point(Cell_index c, std::size_t i)
  {
    const Point_index p = m_cells[c].vertices[i];
    const std::size_t v = position_of(p);
    m_defects_after_change[i] = 0;
    if (m_defect_costs[v] == 0.)
      return 0.;
    const int before = defects(v, c);
    m_defects_after_change[i] = before != 0 ? m_stars.defects(v, c, c) : defects_beside_cycle(i);
    return m_defect_costs[v] * double(m_defects_after_change[i] - before);
  }

  // The defects that the change of the last cell leads to at vertex i if there are none.
  int defects_beside_cycle(std::size_t i) const
  {
    int arcs = 0, corners = 0;
    for (std::size_t j = 0; j != 4; ++j)
      if (j != i) {
        arcs += m_is_facet_on_surface[j] ? 1 : 0;
        corners += m_is_edge_on_surface[i][j] ? 1 : 0;
      }
    return arcs == 0 ? (std::max)(corners, 1) : arcs == 1 ? corners - 2 : arcs == 2 ? 0 : 1;
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

  // The defects at vertex v, of which `first` is a cell; most are never asked for.
  int defects(std::size_t v, Cell_index first)
  {
    if (m_defects[v] == NOT_COUNTED)
      m_defects[v] = m_defect_costs[v] == 0. || m_stars.is_hub(v) ? 0 : m_stars.defects(v, first);
    return m_defects[v];
  }

  const Cell_complex& m_cells;
  const std::vector<Local_point>& m_points;
  Labelling& m_labelling;
  Label_stars<Labelling> m_stars;
  std::vector<double> m_defect_costs;  // of the vertices; 0 out of the scope
  std::vector<int> m_defects;          // of the vertices, now
  std::vector<unsigned char> m_agreed; // facets of the cells, as bits
  double m_agreement = 0.;
  double m_bending = 0., m_largest_bending = 0.; // at the last edge; at edges as they are
  std::size_t m_facets_at_edge = 0;              // on the surface, around the last edge
  std::size_t m_inner_facets = 0;                // of them, those not of the cell, and the apexes of the first two
  std::array<Point_index, 2> m_apexes{};
  Cell_index m_last = Cell_complex::NO_CELL; // cell whose cost has been told
  // Of the last cell.
  Defects m_defects_after_change{};
  std::array<std::array<bool, 4>, 4> m_is_edge_on_surface{};
  std::array<bool, 4> m_is_facet_on_surface{};
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BENDING_ENERGY_H

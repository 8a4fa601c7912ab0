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
#include <cstdlib>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The energy of the surface between two labels of the cells of a Delaunay triangulation: every edge costs
// its length times half of the square of the angle by which the surface bends there, and a small share of
// its length, which is what remains to be decided where the surface is flat. A point at which the surface is
// no manifold costs several edges. Of all surfaces through the points, the flattest is seldom wrong, even
// where the points are too sparse for the shapes of the triangles to tell (thesis 4.2.2: coplanarity).
template <typename Labelling>
class Bending_energy
{
public:
  using Cell_index = Cell_complex::Cell_index;

  template <typename IsInScope>
  Bending_energy(const Cell_complex& cells, const std::vector<Local_point>& points, Labelling& labelling,
                 const IsInScope& is_in_scope)
    : m_cells(cells), m_points(points), m_labelling(labelling), m_stars(cells, labelling),
      m_scale(cells.points().size(), 0.)
  {
    std::vector<std::uint32_t> edges(m_scale.size(), 0);
    const std::vector<std::uint32_t> none = edges;
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i)
        if (cells[c].neighbors[i] > c && labelling.is_surface(c, i))
          add_lengths(Cell_complex::facet(cells[c], i), edges, none);
    // Around points off the surface, all edges.
    const std::vector<std::uint32_t> edges_of_surface = edges;
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i)
        if (cells[c].neighbors[i] > c)
          add_lengths(Cell_complex::facet(cells[c], i), edges, edges_of_surface);
    for (std::size_t v = 0; v != m_scale.size(); ++v)
      m_scale[v] = is_in_scope(cells.points()[v]) && edges[v] != 0 ? DEFECT_EDGES * m_scale[v] / edges[v] : 0.;
    m_defects.assign(m_scale.size(), -1);
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (Point_index p : cells[c].vertices)
        if (p != NO_POINT && m_scale[position_of(p)] != 0. && m_defects[position_of(p)] < 0)
          m_defects[position_of(p)] = m_stars.defects(position_of(p), c);
  }

  // By how much the energy grows if the cell changes its label. The cell is finite.
  double cost_of_change(Cell_index c)
  {
    ++evals;
    double result = 0.;
    for (std::size_t i = 0; i != 4; ++i)
      for (std::size_t j = i + 1; j != 4; ++j) {
        result += cost_at_edge(c, i, j);
        m_is_edge_on_surface[i][j] = m_is_edge_on_surface[j][i] = m_facets_at_edge != 0;
      }
    for (std::size_t i = 0; i != 4; ++i)
      m_is_facet_on_surface[i] = m_labelling.is_surface(c, i);
    for (std::size_t i = 0; i != 4; ++i)
      result += cost_at_point(c, i);
    return result;
  }

  // Changes the label of the cell.
  void change(Cell_index c)
  {
    m_labelling.flip(c);
    for (Point_index p : m_cells[c].vertices)
      if (m_scale[position_of(p)] != 0.)
        m_defects[position_of(p)] = m_stars.defects(position_of(p), c);
  }

  // The largest angle by which the surface bends at an edge of the cell; a half turn if there is a defect.
  double bending(Cell_index c)
  {
    m_max_bending = 0.;
    m_track = true;
    cost_of_change(c);
    m_track = false;
    for (Point_index p : m_cells[c].vertices)
      if (m_scale[position_of(p)] != 0. && m_defects[position_of(p)] > 0)
        return PI;
    return m_max_bending;
  }

  // Whether the surface around the cells has several components, one of which has few points.
  bool has_split(const std::vector<Cell_index>& changed)
  {
    std::vector<std::pair<Point_index, Cell_index> > starts;
    for (Cell_index c : changed)
      for (Point_index p : m_cells[c].vertices)
        starts.emplace_back(p, c);
    std::sort(starts.begin(), starts.end());
    starts.erase(std::unique(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first == b.first; }), starts.end());
    std::vector<std::pair<Point_index, Cell_index> > found;
    std::vector<Point_index> seen;
    for (const auto& start : starts) {
      if (std::find(seen.begin(), seen.end(), start.first) != seen.end())
        continue;
      found.assign(1, start);
      for (std::size_t k = 0; k != found.size() && found.size() < 64; ++k) {
        const Point_index p = found[k].first;
        m_stars.for_each_cell(position_of(p), found[k].second, [&](Cell_index d) {
          for (std::size_t i = 0; i != 4; ++i)
            if (m_cells[d].vertices[i] != p && m_labelling.is_surface(d, i))
              for (Point_index q : Cell_complex::facet(m_cells[d], i))
                if (q != NO_POINT && std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.first == q; }) == found.end())
                  found.emplace_back(q, d);
        });
      }
      for (const auto& f : found)
        seen.push_back(f.first);
      if (found.size() < 64 && found.size() > 1)
        for (const auto& other : starts)
          if (std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.first == other.first; }) == found.end())
            return true;
    }
    return false;
  }

  // What a defect costs at the vertices of the cell.
  double scale(Cell_index c) const
  {
    double result = 0.;
    for (Point_index p : m_cells[c].vertices)
      result = (std::max)(result, m_scale[position_of(p)]);
    return result;
  }

  // Calls visit(cell) for the cells at the point, of which `first` is one.
  template <typename Visit>
  void for_each_cell_at(Point_index p, Cell_index first, const Visit& visit)
  {
    m_stars.for_each_cell(position_of(p), first, visit);
  }

private:
  // Edges of mean length that a defect costs.
  inline static double DEFECT_EDGES = getenv("DEF")?atof(getenv("DEF")):3.;

  // Worth of an edge without bending.
  inline static double FLAT_SHARE = getenv("FLAT")?atof(getenv("FLAT")):.1;

  inline static const bool LIN = getenv("LIN");
  static constexpr double PI = 3.14159265358979323846;

  std::size_t position_of(Point_index p) const
  {
    const std::vector<Point_index>& points = m_cells.points();
    if (p < points.size() && points[p] == p)
      return p;
    return static_cast<std::size_t>(std::lower_bound(points.begin(), points.end(), p) - points.begin());
  }

  // At the points that have none of the edges to leave out.
  void add_lengths(const std::array<Point_index, 3>& f, std::vector<std::uint32_t>& edges,
                   const std::vector<std::uint32_t>& others)
  {
    if (Cell_complex::is_infinite(f))
      return;
    for (std::size_t i = 0; i != 3; ++i) {
      const double length = std::sqrt((m_points[f[i]] - m_points[f[(i + 1) % 3]]).squared_length());
      for (Point_index p : { f[i], f[(i + 1) % 3] }) {
        if (others[position_of(p)] == 0) {
          m_scale[position_of(p)] += length;
          ++edges[position_of(p)];
        }
      }
    }
  }

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
    m_apexes.clear();
    // Around the edge, from facet to facet, but for the two facets of the cell itself.
    Cell_index current = m_cells[c].neighbors[exit];
    Point_index apex = first_apex;
    bool label = m_labelling.label(current);
    const bool first_label = label;
    while (true) {
      std::size_t k = 0;
      while (m_cells[current].vertices[k] != apex)
        ++k;
      const Cell_index next = m_cells[current].neighbors[k];
      for (k = 0; k != 4; ++k) {
        const Point_index r = m_cells[current].vertices[k];
        if (r != p && r != q && r != apex)
          break;
      }
      apex = m_cells[current].vertices[k];
      if (next == c)
        break;
      const bool next_label = m_labelling.label(next);
      if (next_label != label)
        m_apexes.push_back(apex);
      label = next_label;
      current = next;
    }
    const bool own = m_labelling.label(c);
    m_facets_at_edge = m_apexes.size() + (own != first_label ? 1 : 0) + (own != label ? 1 : 0);
    const double now = energy_of_edge(p, q, own != first_label, own != label, first_apex, last_apex);
    const bool track = m_track;
    m_track = false;
    const double then = energy_of_edge(p, q, own == first_label, own == label, first_apex, last_apex);
    m_track = track;
    return then - now;
  }

  // The energy of an edge with surface facets to m_apexes and to the two others if they are on the surface.
  double energy_of_edge(Point_index p, Point_index q, bool has_first, bool has_last, Point_index first,
                        Point_index last)
  {
    const std::size_t inner = m_apexes.size(), facets = inner + (has_first ? 1 : 0) + (has_last ? 1 : 0);
    if (facets == 0)
      return 0.;
    const double length = std::sqrt((m_points[q] - m_points[p]).squared_length());
    if (facets != 2)
      return length * double(facets / 2) * (FLAT_SHARE + .5 * PI * PI);
    const Point_index a = inner != 0 ? m_apexes[0] : first, b = inner == 2 ? m_apexes[1] : has_last ? last : first;
    const double bending = a == NO_POINT || b == NO_POINT ? 0. : bending_angle(p, q, a, b);
    if (m_track && bending > m_max_bending)
      m_max_bending = bending;
    return length * (FLAT_SHARE + (LIN?bending:.5 * bending * bending));
  }

  // Between the planes of triangles p, q, a and q, p, b: 0 if they are flat.
  double m_max_bending = 0.; bool m_track = false;
  double bending_angle(Point_index p, Point_index q, Point_index a, Point_index b) const
  {
    const Local_vector e = m_points[q] - m_points[p];
    const Local_vector m = cross_product(e, m_points[a] - m_points[p]), n = cross_product(m_points[b] - m_points[p], e);
    return std::atan2(std::sqrt(cross_product(m, n).squared_length()), m * n);
  }

  // The change of the defects at vertex i. Where there are none, the surface meets a sphere around the point in
  // one cycle of arcs, and it is known what the triangle of the cell there does to it.
  double cost_at_point(Cell_index c, std::size_t i)
  {
    const Point_index p = m_cells[c].vertices[i];
    const std::size_t v = position_of(p);
    if (m_scale[v] == 0.)
      return 0.;
    if (m_defects[v] != 0) {
      const int after = m_stars.defects(v, c, c);
      return m_scale[v] * double(after - m_defects[v]);
    }
    int arcs = 0, corners = 0;
    for (std::size_t j = 0; j != 4; ++j)
      if (j != i) {
        arcs += m_is_facet_on_surface[j] ? 1 : 0;
        corners += m_is_edge_on_surface[i][j] ? 1 : 0;
      }
    const int defects = arcs == 0 ? (std::max)(corners, 1) : arcs == 1 ? corners - 2 : arcs == 2 ? 0 : 1;
    return m_scale[v] * double(defects);
  }

  const Cell_complex& m_cells;
  const std::vector<Local_point>& m_points;
  Labelling& m_labelling;
  Label_stars<Labelling> m_stars;
  std::vector<double> m_scale;       // of the vertices: what a defect costs; 0 out of the scope
public: std::size_t evals = 0; private:
  std::vector<int> m_defects;        // of the vertices, now
  std::vector<Point_index> m_apexes; // of the facets on the surface around an edge
  std::size_t m_facets_at_edge = 0;  // on the surface, around the last edge
  // Of the last cell.
  std::array<std::array<bool, 4>, 4> m_is_edge_on_surface{};
  std::array<bool, 4> m_is_facet_on_surface{};
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BENDING_ENERGY_H

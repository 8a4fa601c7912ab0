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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BENDING_EDGES_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BENDING_EDGES_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Corner_test.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <boost/multiprecision/integer.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The edges of a Delaunay triangulation, with what the surface between two labels of the cells costs at each: its
// length times half of the square of the angle by which the surface bends there, and a small share of its length. The
// cells around an edge are collected when it is first asked for; their labels are bits, and the facets between them
// have a direction, so that neither has to be found again for each of the many changes that are tried.
template <typename Labelling>
class Bending_edges
{
public:
  using Cell_index = Cell_complex::Cell_index;

  static constexpr std::size_t EDGES_OF_CELL = 6;

  // The vertices of the edges of a cell.
  static constexpr std::uint8_t ENDS[EDGES_OF_CELL][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };

  // From now on, all labels change together with flip().
  Bending_edges(const Cell_complex& cells, const std::vector<Local_point>& points, const Labelling& labelling)
    : m_cells(cells), m_points(points), m_labelling(labelling),
      m_places(cells.size(), { { Place(), Place(), Place(), Place(), Place(), Place() } }),
      m_bent(cells.points().size(), 0)
  { }

  // Whether an edge is on the surface, and what happens there if a cell changes its label: by how much its energy grows, and
  // 1 if it becomes a bent edge, -1 if it is none any longer.
  struct Change
  {
    bool is_on_surface;
    int bent_edges;
    double cost;
  };

  // Of edge e of the finite cell. No end of the edge has more than 256 cells, so that positions around it take one byte.
  Change change(Cell_index c, std::size_t e)
  {
    const Place place = find(c, e);
    const Edge& edge = m_edges[place.edge];
    const Facets after = facets(edge, place.position);
    const double angle = bending(after);
    return Change{ edge.facets != 0, int(is_bent(angle)) - int(edge.is_bent),
                   energy(edge, after.number, angle) - edge.energy };
  }

  // The angle by which the surface bends at the edge: 0 where it is flat, a half turn where it is no surface.
  double bending(Cell_index c, std::size_t e)
  {
    const Edge& edge = m_edges[find(c, e).edge];
    return bending(facets(edge, NO_POSITION));
  }

  // Edges at the vertex at which the surface is not flat, of those that have been looked at.
  int number_of_bent(std::size_t v) const { return m_bent[v]; }

  // Tells the edges of the finite cell that its label has changed.
  void flip(Cell_index c)
  {
    for (const Place& place : m_places[c])
      if (place.edge != NO_EDGE) {
        Edge& edge = m_edges[place.edge];
        if (edge.size <= BITS)
          edge.labels ^= std::uint64_t(1) << place.position;
        update(edge);
      }
  }

private:
  static constexpr std::uint32_t NO_EDGE = static_cast<std::uint32_t>(-1);
  static constexpr std::size_t NO_POSITION = static_cast<std::size_t>(-1), BITS = 64;

  // Worth of an edge where the surface is flat: what remains to be decided there.
  static constexpr double FLAT_SHARE = .1;

  static constexpr double PI = 3.14159265358979323846;

  // An edge, and the position of a cell around it.
  struct Place
  {
    std::uint32_t edge = NO_EDGE;
    std::uint8_t position = 0;
  };

  struct Edge
  {
    double length;
    double energy;        // now
    std::uint64_t labels; // of the cells around the edge, in order, if they are not more than the bits
    std::uint32_t first;  // of the cells around the edge in m_cells_around
    std::uint16_t size;
    std::uint16_t facets;              // on the surface, now
    std::array<std::uint32_t, 2> ends; // positions of vertices
    bool is_bent;                      // now
  };

  // Tells directions around an edge from each other, as angles.
  class Frame
  {
  public:
    Frame(const Local_point& p, const Local_point& q, const Local_point& zero)
      : m_origin(p), m_length(std::sqrt((q - p).squared_length()))
    {
      const Local_vector axis = (q - p) / m_length, side = zero - p;
      m_x = side - (side * axis) * axis;
      m_y = cross_product(axis, m_x);
    }

    double length() const { return m_length; }
    double direction(const Local_point& r) const { return std::atan2((r - m_origin) * m_y, (r - m_origin) * m_x); }

  private:
    Local_point m_origin;
    double m_length;
    Local_vector m_x, m_y;
  };

  // The surface at an edge: how many facets, and the directions of the first two.
  struct Facets
  {
    std::size_t number = 0;
    std::array<double, 2> directions{};
  };

  Place find(Cell_index c, std::size_t e)
  {
    if (m_places[c][e].edge == NO_EDGE)
      collect(c, e);
    return m_places[c][e];
  }

  // With the label of the cell at position `changed` the other way round.
  Facets facets(const Edge& edge, std::size_t changed) const
  {
    Facets result;
    const double* const directions = m_directions.data() + edge.first;
    if (edge.size > BITS) {
      const auto label = [&](std::size_t k) {
        return m_labelling.label(m_cells_around[edge.first + k]) != (k == changed);
      };
      for (std::size_t k = 0; k != edge.size; ++k)
        if (label(k) != label(k + 1 == edge.size ? 0 : k + 1))
          add(directions[k], result);
      return result;
    }
    const std::uint64_t labels = changed == NO_POSITION ? edge.labels : edge.labels ^ std::uint64_t(1) << changed,
                        next = labels >> 1 | (labels & 1) << (edge.size - 1);
    for (std::uint64_t between = labels ^ next; between != 0; between &= between - 1)
      add(directions[boost::multiprecision::lsb(between)], result);
    return result;
  }

  void update(Edge& edge)
  {
    const Facets now = facets(edge, NO_POSITION);
    const double angle = bending(now);
    edge.energy = energy(edge, now.number, angle);
    edge.facets = static_cast<std::uint16_t>(now.number);
    if (is_bent(angle) != edge.is_bent) {
      edge.is_bent = !edge.is_bent;
      for (std::size_t end : edge.ends)
        m_bent[end] += edge.is_bent ? 1 : -1;
    }
  }

  static bool is_bent(double angle) { return angle > Corner_test::MAXIMUM_BENDING; }

  static void add(double direction, Facets& facets)
  {
    if (facets.number < facets.directions.size())
      facets.directions[facets.number] = direction;
    ++facets.number;
  }

  static double energy(const Edge& edge, std::size_t facets, double angle)
  {
    const std::size_t sheets = facets / 2;
    return edge.length * double(sheets) * (FLAT_SHARE + .5 * angle * angle);
  }

  static double bending(const Facets& facets)
  {
    if (facets.number != 2)
      return facets.number == 0 ? 0. : PI;
    const double angle = std::abs(PI - std::abs(facets.directions[0] - facets.directions[1]));
    return std::isnan(angle) ? 0. : angle; // an infinite facet does not tell
  }

  // Walks around the edge, from facet to facet.
  void collect(Cell_index c, std::size_t e)
  {
    const auto& vertices = m_cells[c].vertices;
    const std::size_t i = ENDS[e][0], j = ENDS[e][1];
    const Point_index p = vertices[i], q = vertices[j];
    const auto id = static_cast<std::uint32_t>(m_edges.size()), first = static_cast<std::uint32_t>(m_directions.size());
    std::size_t crossed = i != 0 ? 0 : j != 1 ? 1 : 2;                        // the vertex opposite to the next facet
    Point_index apex = vertices[6 - i - j - crossed];                         // the indices of a cell add up to 6
    const Frame frame(m_points[p], m_points[q], m_points[vertices[crossed]]); // any that is finite
    std::uint64_t labels = 0;
    Cell_index current = c;
    do {
      const std::size_t position = m_directions.size() - first;
      place_at(current, p, q) = Place{ id, static_cast<std::uint8_t>(position) };
      if (position < BITS)
        labels |= std::uint64_t(m_labelling.label(current) ? 1 : 0) << position;
      m_cells_around.push_back(current);
      m_directions.push_back(apex == NO_POINT ? std::numeric_limits<double>::quiet_NaN()
                                              : frame.direction(m_points[apex]));
      current = m_cells[current].neighbors[crossed];
      const auto& v = m_cells[current].vertices;
      crossed = (v[1] == apex ? 1u : 0u) + (v[2] == apex ? 2u : 0u) + (v[3] == apex ? 3u : 0u);
      apex ^= p ^ q ^ v[0] ^ v[1] ^ v[2] ^ v[3]; // the fourth vertex
    } while (current != c);
    Edge edge{};
    edge.length = frame.length();
    edge.labels = labels;
    edge.first = first;
    edge.size = static_cast<std::uint16_t>(m_directions.size() - first);
    edge.ends = { { static_cast<std::uint32_t>(m_cells.position(p)),
                    static_cast<std::uint32_t>(m_cells.position(q)) } };
    m_edges.push_back(edge);
    update(m_edges.back());
  }

  // Of the edge between two vertices of a cell.
  Place& place_at(Cell_index c, Point_index p, Point_index q)
  {
    const auto& vertices = m_cells[c].vertices;
    const auto is_end = [&](std::size_t i) { return vertices[i] == p || vertices[i] == q; };
    std::size_t e = 0;
    while (!is_end(ENDS[e][0]) || !is_end(ENDS[e][1]))
      ++e;
    return m_places[c][e];
  }

  const Cell_complex& m_cells;
  const std::vector<Local_point>& m_points;
  const Labelling& m_labelling;
  std::vector<std::array<Place, EDGES_OF_CELL> > m_places; // of the edges of each cell
  std::vector<Edge> m_edges;
  std::vector<int> m_bent;                // edges at each vertex
  std::vector<Cell_index> m_cells_around; // all edges, one after the other
  std::vector<double> m_directions;       // of the facet between each of them and the next one
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BENDING_EDGES_H

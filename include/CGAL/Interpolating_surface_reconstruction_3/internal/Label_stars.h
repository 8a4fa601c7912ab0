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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_STARS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_STARS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <boost/multiprecision/integer.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The cells around the vertices, to count components of equal labels again and again; which of them are neighbors in a
// star is found when it is first asked for.
template <typename Labelling>
class Label_stars
{
public:
  using Cell_index = Cell_complex::Cell_index;

  Label_stars(const Cell_complex& cells, const Labelling& labelling)
    : m_cells(cells), m_labelling(labelling), m_places(cells.size()), m_begins(cells.points().size() + 1, 0),
      m_neighbor_begins(cells.points().size(), NO_STAR), m_labels(cells.points().size(), 0)
  {
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (Point_index p : cells[c].vertices)
        if (p != NO_POINT)
          ++m_begins[cells.position(p)];
    // Sums up to each vertex are the ends of the stars, which the cells count down from the last one.
    for (std::size_t v = 1; v != m_begins.size(); ++v)
      m_begins[v] += m_begins[v - 1];
    m_star_cells.resize(m_begins.back());
    for (std::size_t c = cells.size(); c-- != 0;)
      for (Point_index p : cells[c].vertices)
        if (p != NO_POINT)
          m_star_cells[--m_begins[cells.position(p)]] = static_cast<Cell_index>(c);
  }

  // Tells the stars that the label of a cell has changed; they must know of every change.
  void flip(Cell_index c)
  {
    const auto& vertices = m_cells[c].vertices;
    for (std::size_t i = 0; i != 4; ++i) {
      if (vertices[i] == NO_POINT)
        continue;
      const std::size_t v = m_cells.position(vertices[i]);
      if (m_neighbor_begins[v] != NO_STAR && star_size(v) <= BITS)
        m_labels[v] ^= bit(m_places[c][i]);
    }
  }

  bool has_cells(std::size_t v) const { return star_size(v) != 0; }

  // Whether the vertex has more cells than a star can have.
  bool is_hub(std::size_t v) const { return star_size(v) > MAXIMUM_CELLS; }

  // For a vertex that is no hub: how far the surface between the labels is from a manifold at vertex v, with the label
  // of cell `changed` the other way round: 0 if there is one component of each label.
  int defects(std::size_t v, Cell_index changed = Cell_complex::NO_CELL)
  {
    const auto components = static_cast<int>(count_components(v, changed));
    return components == 1 ? 1 : components - 2;
  }

  // The number of components that find_components() finds, in less time: the cells of a star are mostly not more than
  // the bits of a number.
  std::size_t count_components(std::size_t v, Cell_index changed = Cell_complex::NO_CELL)
  {
    if (star_size(v) > BITS)
      return find_components(v, changed);
    const std::size_t neighbor_begin = find_neighbors(v);
    const std::uint64_t labels = labels_at(v, changed);
    const std::array<unsigned char, 3>* const neighbors = m_neighbors.data() + neighbor_begin;
    std::uint64_t left = ~std::uint64_t(0) >> (BITS - star_size(v));
    std::size_t components = 0;
    for (; left != 0; ++components) {
      std::uint64_t reached = left & (~left + 1);
      const std::uint64_t equal = (labels & reached) != 0 ? labels : ~labels;
      left ^= reached;
      while (reached != 0) {
        const std::array<unsigned char, 3>& n = neighbors[boost::multiprecision::lsb(reached)];
        const std::uint64_t next = (bit(n[0]) | bit(n[1]) | bit(n[2])) & equal & left;
        left ^= next;
        reached = (reached & (reached - 1)) | next;
      }
    }
    return components;
  }

  // The components of equal labels around vertex v, which is no hub, connected by facets at v and numbered in the order
  // of their smallest cells; returns their number.
  std::size_t find_components(std::size_t v, Cell_index changed = Cell_complex::NO_CELL)
  {
    m_begin = m_begins[v];
    m_size = star_size(v);
    m_neighbor_begin = find_neighbors(v);
    std::array<unsigned char, MAXIMUM_CELLS> labels, stack;
    for (std::size_t k = 0; k != m_size; ++k) {
      const Cell_index c = m_star_cells[m_begin + k];
      labels[k] = m_labelling.label(c) != (c == changed) ? 1 : 0;
    }
    std::size_t components = 0;
    for (std::size_t k = 0; k != m_size; ++k) {
      const unsigned char label = labels[k];
      if (label == VISITED)
        continue;
      const auto component = static_cast<unsigned char>(components++);
      std::size_t height = 0;
      stack[height++] = static_cast<unsigned char>(k);
      labels[k] = VISITED;
      while (height != 0) {
        const unsigned char m = stack[--height];
        m_component_of[m] = component;
        for (unsigned char n : m_neighbors[m_neighbor_begin + m])
          if (labels[n] == label) {
            labels[n] = VISITED;
            stack[height++] = n;
          }
      }
    }
    return components;
  }

  // The cells around the vertex at which components were found last, increasing, and their components.
  std::size_t size() const { return m_size; }
  Cell_index cell(std::size_t k) const { return m_star_cells[m_begin + k]; }
  std::size_t component(std::size_t k) const { return m_component_of[k]; }

  // Whether a change of the label of cell k joins components; else, as long as its own does not vanish, it lessens no
  // defects there.
  bool is_between(std::size_t k) const
  {
    const unsigned char own = m_component_of[k];
    unsigned char first = own;
    for (unsigned char n : m_neighbors[m_neighbor_begin + k]) {
      const unsigned char other = m_component_of[n];
      if (first == own)
        first = other;
      else if (other != own && other != first)
        return true;
    }
    return false;
  }

  Cell_index first_cell(std::size_t v) const { return m_star_cells[m_begins[v]]; }

  // Calls visit(cell) for the cells at vertex v.
  template <typename Visit>
  void for_each_cell(std::size_t v, const Visit& visit) const
  {
    for (std::size_t k = m_begins[v]; k != m_begins[v + 1]; ++k)
      visit(m_star_cells[k]);
  }

  // Calls visit(cell) for the cells with the label at vertex v, which is no hub, that have a neighbor without it there, and
  // perhaps for others; all by their order, and with the label of cell `changed` the other way round.
  template <typename Visit>
  void for_each_cell_at_surface(std::size_t v, Cell_index changed, const Visit& visit)
  {
    if (star_size(v) > BITS) {
      for_each_cell(v, [&](Cell_index c) {
        if (m_labelling.label(c) != (c == changed))
          visit(c);
      });
      return;
    }
    const std::size_t begin = find_neighbors(v); // may move the neighbors
    const std::array<unsigned char, 3>* const neighbors = m_neighbors.data() + begin;
    const std::uint64_t labels = labels_at(v, changed);
    for (std::uint64_t left = labels; left != 0; left &= left - 1) {
      const std::size_t k = boost::multiprecision::lsb(left);
      const std::array<unsigned char, 3>& n = neighbors[k];
      if ((labels >> n[0] & labels >> n[1] & labels >> n[2] & 1) == 0)
        visit(m_star_cells[m_begins[v] + k]);
    }
  }

private:
  static constexpr std::uint32_t NO_STAR = static_cast<std::uint32_t>(-1);
  static constexpr unsigned char VISITED = 2;
  static constexpr std::size_t BITS = 64;

  // Positions in a star take one byte. A point of a surface has some thirty cells.
  static constexpr std::size_t MAXIMUM_CELLS = 256;

  std::size_t star_size(std::size_t v) const { return m_begins[v + 1] - m_begins[v]; }

  static std::uint64_t bit(std::size_t k) { return std::uint64_t(1) << k; }

  // In the star of its vertex p, of which the neighbors have been found.
  unsigned char place_of(Cell_index c, Point_index p) const
  {
    const auto& vertices = m_cells[c].vertices;
    return m_places[c][vertices[0] == p ? 0 : vertices[1] == p ? 1 : vertices[2] == p ? 2 : 3];
  }

  // Of a star of not more cells than the bits, with the label of cell `changed` the other way round.
  std::uint64_t labels_at(std::size_t v, Cell_index changed) const
  {
    return changed == Cell_complex::NO_CELL ? m_labels[v] : m_labels[v] ^ bit(place_of(changed, m_cells.points()[v]));
  }

  // The position in m_neighbors of those of the star of vertex v, which is no hub.
  std::size_t find_neighbors(std::size_t v)
  {
    if (m_neighbor_begins[v] == NO_STAR) {
      m_neighbor_begins[v] = static_cast<std::uint32_t>(m_neighbors.size());
      collect_neighbors(v);
    }
    return m_neighbor_begins[v];
  }

  // Also the labels.
  void collect_neighbors(std::size_t v)
  {
    const Point_index p = m_cells.points()[v];
    const Cell_index* const star = m_star_cells.data() + m_begins[v];
    const std::size_t size = star_size(v);
    for (std::size_t k = 0; k != size; ++k) {
      const auto& vertices = m_cells[star[k]].vertices;
      const auto i = static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), p) - vertices.begin());
      m_places[star[k]][i] = static_cast<unsigned char>(k);
      if (k < BITS && m_labelling.label(star[k]))
        m_labels[v] |= bit(k);
    }
    for (std::size_t k = 0; k != size; ++k) {
      const Cell_complex::Cell& cell = m_cells[star[k]];
      std::array<unsigned char, 3> neighbors{};
      std::size_t n = 0;
      for (std::size_t i = 0; i != 4; ++i)
        if (cell.vertices[i] != p)
          neighbors[n++] = place_of(cell.neighbors[i], p);
      m_neighbors.push_back(neighbors);
    }
  }

  const Cell_complex& m_cells;
  const Labelling& m_labelling;
  std::vector<std::array<unsigned char, 4> > m_places;    // of each cell in the stars of its vertices
  std::vector<std::uint32_t> m_begins;                    // of the star of each vertex in m_star_cells, and the end
  std::vector<Cell_index> m_star_cells;                   // increasing in each star
  std::vector<std::uint32_t> m_neighbor_begins;           // of the star of each vertex in m_neighbors, or NO_STAR
  std::vector<std::array<unsigned char, 3> > m_neighbors; // of cells, in their star
  std::vector<std::uint64_t> m_labels; // of the cells in each star with neighbors, if not more than the bits
  // Of the components found last.
  std::size_t m_begin = 0, m_neighbor_begin = 0, m_size = 0;
  std::array<unsigned char, MAXIMUM_CELLS> m_component_of;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_STARS_H

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

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The cells around the vertices, to count components of equal labels again and again; every star is
// collected when it is first asked for.
template <typename Labelling>
class Label_stars
{
public:
  using Cell_index = Cell_complex::Cell_index;

  Label_stars(const Cell_complex& cells, const Labelling& labelling)
    : m_cells(cells), m_labelling(labelling), m_places(cells.size(), NO_PLACE), m_sizes(cells.points().size(), 0),
      m_begins(cells.points().size(), NO_STAR)
  {
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (Point_index p : cells[c].vertices)
        if (p != NO_POINT)
          ++m_sizes[cells.position(p)];
  }

  // Whether the vertex has more cells than a star can have.
  bool is_hub(std::size_t v) const { return m_sizes[v] > MAXIMUM_CELLS; }

  // For a vertex that is no hub: how far the surface between the labels is from a manifold at vertex v, of which
  // `first` is a cell, with the label of cell `changed` the other way round: 0 if there is one component of each
  // label.
  int defects(std::size_t v, Cell_index first, Cell_index changed = Cell_complex::NO_CELL)
  {
    const auto components = static_cast<int>(find_components(v, first, changed));
    return components == 1 ? 1 : components - 2;
  }

  // The components of equal labels around vertex v, which is no hub, connected by facets at v and numbered in the order
  // of their smallest cells; returns their number.
  std::size_t find_components(std::size_t v, Cell_index first, Cell_index changed = Cell_complex::NO_CELL)
  {
    m_begin = find_star(v, first);
    m_size = m_sizes[v];
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
        for (unsigned char n : m_neighbors[m_begin + m])
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
    for (unsigned char n : m_neighbors[m_begin + k]) {
      const unsigned char other = m_component_of[n];
      if (first == own)
        first = other;
      else if (other != own && other != first)
        return true;
    }
    return false;
  }

  // Calls visit(cell) for the cells at vertex v, which is no hub, of which `first` is one.
  template <typename Visit>
  void for_each_cell(std::size_t v, Cell_index first, const Visit& visit)
  {
    const std::size_t begin = find_star(v, first);
    for (std::size_t k = begin; k != begin + m_sizes[v]; ++k)
      visit(m_star_cells[k]);
  }

private:
  static constexpr std::uint32_t NO_STAR = static_cast<std::uint32_t>(-1);
  static constexpr unsigned char VISITED = 2;

  // Positions in a star take one byte. A point of a surface has some thirty cells.
  static constexpr std::size_t MAXIMUM_CELLS = 256;

  static constexpr std::uint16_t NO_PLACE = static_cast<std::uint16_t>(-1);

  // The position of the star in m_star_cells.
  std::size_t find_star(std::size_t v, Cell_index first)
  {
    if (m_begins[v] == NO_STAR) {
      m_begins[v] = static_cast<std::uint32_t>(m_star_cells.size());
      collect(m_cells.points()[v], first);
    }
    return m_begins[v];
  }

  void collect(Point_index p, Cell_index first)
  {
    const std::size_t begin = m_star_cells.size();
    const auto add = [&](Cell_index c) {
      if (m_places[c] == NO_PLACE) {
        m_places[c] = 0;
        m_star_cells.push_back(c);
      }
    };
    add(first);
    for (std::size_t k = begin; k != m_star_cells.size(); ++k) {
      const Cell_complex::Cell& cell = m_cells[m_star_cells[k]];
      for (std::size_t i = 0; i != 4; ++i)
        if (cell.vertices[i] != p)
          add(cell.neighbors[i]);
    }
    std::sort(m_star_cells.begin() + static_cast<std::ptrdiff_t>(begin), m_star_cells.end());
    for (std::size_t k = begin; k != m_star_cells.size(); ++k)
      m_places[m_star_cells[k]] = static_cast<std::uint16_t>(k - begin);
    for (std::size_t k = begin; k != m_star_cells.size(); ++k) {
      const Cell_complex::Cell& cell = m_cells[m_star_cells[k]];
      std::array<unsigned char, 3> neighbors{};
      std::size_t n = 0;
      for (std::size_t i = 0; i != 4; ++i)
        if (cell.vertices[i] != p)
          neighbors[n++] = static_cast<unsigned char>(m_places[cell.neighbors[i]]);
      m_neighbors.push_back(neighbors);
    }
    for (std::size_t k = begin; k != m_star_cells.size(); ++k)
      m_places[m_star_cells[k]] = NO_PLACE;
  }

  const Cell_complex& m_cells;
  const Labelling& m_labelling;
  std::vector<std::uint16_t> m_places;                    // of the cells in the star that is being collected
  std::vector<std::uint32_t> m_sizes;                     // of the star of each vertex
  std::vector<std::uint32_t> m_begins;                    // of the star of each vertex in m_star_cells, or NO_STAR
  std::vector<Cell_index> m_star_cells;                   // increasing in each star
  std::vector<std::array<unsigned char, 3> > m_neighbors; // of each of them, in its star
  // Of the components found last.
  std::size_t m_begin = 0, m_size = 0;
  std::array<unsigned char, MAXIMUM_CELLS> m_component_of;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_STARS_H

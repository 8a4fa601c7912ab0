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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CELL_COMPLEX_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CELL_COMPLEX_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Site_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The cells of the Delaunay triangulation of some points, in flat arrays. The order of the cells, and that
// of the vertices of a cell, depend on the points only. An infinite cell has the vertex NO_POINT.
class Cell_complex
{
public:
  using Cell_index = std::uint32_t;

  static constexpr Cell_index NO_CELL = static_cast<Cell_index>(-1);

  struct Cell
  {
    std::array<Point_index, 4> vertices;
    std::array<Cell_index, 4> neighbors; // neighbor i is opposite to vertex i
  };

  Cell_complex() = default;

  // `sites` are those of the triangulation. There are no cells if it is not usable.
  // `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  Cell_complex(const Site_triangulation& triangulation, std::vector<Point_index> sites,
               Cancellation_point& cancellation_point)
    : m_points(std::move(sites))
  {
    std::sort(m_points.begin(), m_points.end());
    tabulate_positions();
    if (triangulation.is_usable())
      copy_cells(triangulation.delaunay(), cancellation_point);
  }

  // `points` are distinct.
  template <typename Cancellation_point>
  Cell_complex(const std::vector<Local_point>& positions, std::vector<Point_index> points,
               Cancellation_point& cancellation_point)
    : m_points(std::move(points))
  {
    // What stays, but for the cells, is allocated before the triangulation, so that the system gets its memory back.
    std::sort(m_points.begin(), m_points.end());
    tabulate_positions();
    Site_triangulation triangulation(positions);
    triangulation.insert(m_points, cancellation_point);
    if (triangulation.is_usable())
      copy_cells(triangulation.delaunay(), cancellation_point);
  }

  Cell_complex(const std::vector<Local_point>& positions, std::vector<Point_index> points)
  {
    No_cancellation cancellation_point;
    *this = Cell_complex(positions, std::move(points), cancellation_point);
  }

  // The points that the cells may have as vertices, increasing.
  const std::vector<Point_index>& points() const { return m_points; }

  // The position of a point in points().
  std::size_t position(Point_index p) const
  {
    if (m_positions.empty())
      return static_cast<std::size_t>(std::lower_bound(m_points.begin(), m_points.end(), p) - m_points.begin());
    return m_positions[p - m_points.front()];
  }

  std::size_t size() const { return m_cells.size(); }
  const Cell& operator[](std::size_t c) const { return m_cells[c]; }

  static bool is_infinite(const Cell& cell)
  {
    return cell.vertices[0] == NO_POINT || cell.vertices[1] == NO_POINT || cell.vertices[2] == NO_POINT ||
           cell.vertices[3] == NO_POINT;
  }

  static bool is_infinite(const std::array<Point_index, 3>& facet)
  {
    return facet[0] == NO_POINT || facet[1] == NO_POINT || facet[2] == NO_POINT;
  }

  // The vertices of the facet opposite to vertex i. Seen from outside of the cell, they are in
  // counterclockwise order if i is even.
  static std::array<Point_index, 3> facet(const Cell& cell, std::size_t i)
  {
    return { { cell.vertices[(i + 1) & 3], cell.vertices[(i + 2) & 3], cell.vertices[(i + 3) & 3] } };
  }

  // The vertex of the cell that is not of its facet.
  static Point_index apex(const Cell& cell, const std::array<Point_index, 3>& facet)
  {
    return cell.vertices[0] ^ cell.vertices[1] ^ cell.vertices[2] ^ cell.vertices[3] ^ facet[0] ^ facet[1] ^ facet[2];
  }

  // The facet of neighbor i that is facet i of the cell. Small triangulations may have cells that share
  // two facets.
  std::size_t mirror(std::size_t c, std::size_t i) const
  {
    const Cell& neighbor = m_cells[m_cells[c].neighbors[i]];
    const auto f = facet(m_cells[c], i);
    for (std::size_t j = 0; j != 4; ++j)
      if (neighbor.neighbors[j] == c && std::find(f.begin(), f.end(), neighbor.vertices[j]) == f.end())
        return j;
    return 0;
  }

private:
  using Delaunay = Site_triangulation::Delaunay;

  // A table is worth its memory if at least one of so many indices is that of a point.
  static constexpr std::size_t MAXIMUM_INDICES_PER_POINT = 32;

  // More cells are not sorted by insertion.
  static constexpr std::size_t CELLS_TO_INSERT = 32;

  // What is in place of the neighbors of cells that are being sorted.
  static constexpr std::size_t NUMBER = 0, ORDER = 1;

  void tabulate_positions()
  {
    if (m_points.empty() || (m_points.back() - m_points.front()) / MAXIMUM_INDICES_PER_POINT >= m_points.size())
      return;
    m_positions.resize(m_points.back() - m_points.front() + 1);
    for (std::size_t k = 0; k != m_points.size(); ++k)
      m_positions[m_points[k] - m_points.front()] = static_cast<Point_index>(k);
  }

  // The cells get into the lexicographic order of their increasing vertices: they are put where those with the same
  // smallest vertex are, which are few, then sorted. The info of each cell of the triangulation becomes its number in
  // memory, whose order is nearly that of the places.
  template <typename Cancellation_point>
  void copy_cells(const Delaunay& delaunay, Cancellation_point& cancellation_point)
  {
    std::vector<Cell_index> end(m_points.size() + 1, 0); // of the cells of each smallest vertex, so far
    std::vector<Cell_index> places;                      // of each number; at first the smallest vertex
    places.reserve(delaunay.tds().number_of_cells());
    for (const Delaunay::Cell_handle cell : delaunay.all_cell_handles()) {
      cancellation_point();
      cell->info() = static_cast<Cell_index>(places.size());
      const std::array<Point_index, 4> v = vertices_of(cell);
      places.push_back(static_cast<Cell_index>(position(*std::min_element(v.begin(), v.end()))));
      ++end[places.back() + 1];
    }
    std::partial_sum(end.begin(), end.end(), end.begin());
    m_cells.resize(places.size());
    for (const Delaunay::Cell_handle cell : delaunay.all_cell_handles()) {
      cancellation_point();
      m_cells[end[places[cell->info()]]++] = sorted_cell(vertices_of(cell), cell->info());
    }
    for (std::size_t k = 0, begin = 0; k != m_points.size(); begin = end[k], ++k) {
      cancellation_point();
      sort_cells(begin, end[k]);
    }
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      places[m_cells[c].neighbors[NUMBER]] = c;
    for (const Delaunay::Cell_handle cell : delaunay.all_cell_handles()) {
      cancellation_point();
      Cell& copy = m_cells[places[cell->info()]];
      const Cell_index order = copy.neighbors[ORDER];
      for (std::size_t i = 0; i != 4; ++i)
        copy.neighbors[i] = places[cell->neighbor(static_cast<int>(order >> (2 * i) & 3))->info()];
    }
  }

  static std::array<Point_index, 4> vertices_of(Delaunay::Cell_handle cell)
  {
    return { { cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(), cell->vertex(3)->info() } };
  }

  // The vertices increase, but for the last two, which are exchanged where that keeps the orientation. As long as the
  // neighbors have no places, there are the number of the cell and, in two bits each, the order its vertices had.
  static Cell sorted_cell(const std::array<Point_index, 4>& vertices, Cell_index number)
  {
    Cell cell{ vertices, { { 0, 1, 2, 3 } } };
    bool is_odd = false;
    const auto exchange = [&](std::size_t i, std::size_t j) {
      std::swap(cell.vertices[i], cell.vertices[j]);
      std::swap(cell.neighbors[i], cell.neighbors[j]);
      is_odd = !is_odd;
    };
    const auto sort_two = [&](std::size_t i, std::size_t j) {
      if (cell.vertices[i] > cell.vertices[j])
        exchange(i, j);
    };
    sort_two(0, 1);
    sort_two(2, 3);
    sort_two(0, 2);
    sort_two(1, 3);
    sort_two(1, 2);
    if (is_odd)
      exchange(2, 3);
    const Cell_index order =
      cell.neighbors[0] | cell.neighbors[1] << 2 | cell.neighbors[2] << 4 | cell.neighbors[3] << 6;
    cell.neighbors[NUMBER] = number;
    cell.neighbors[ORDER] = order;
    return cell;
  }

  // Of cells with the same smallest vertex.
  static bool is_before(const Cell& a, const Cell& b)
  {
    const auto last = [](const Cell& c) { return std::minmax(c.vertices[2], c.vertices[3]); };
    return a.vertices[1] != b.vertices[1] ? a.vertices[1] < b.vertices[1] : last(a) < last(b);
  }

  void sort_cells(std::size_t begin, std::size_t end)
  {
    Cell* const cells = m_cells.data();
    if (end - begin > CELLS_TO_INSERT) {
      std::sort(cells + begin, cells + end, is_before);
      return;
    }
    for (std::size_t c = begin; c != end; ++c) {
      const Cell cell = cells[c];
      std::size_t place = c;
      for (; place != begin && is_before(cell, cells[place - 1]); --place)
        cells[place] = cells[place - 1];
      cells[place] = cell;
    }
  }

  std::vector<Point_index> m_points;    // increasing
  std::vector<Point_index> m_positions; // of the points in m_points, by their distance from the first one
  std::vector<Cell> m_cells;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CELL_COMPLEX_H

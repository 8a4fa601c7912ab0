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
#include <tuple>
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
      sort_cells(cells_of(triangulation.delaunay(), cancellation_point), cancellation_point);
  }

  // `points` are distinct.
  template <typename Cancellation_point>
  Cell_complex(const std::vector<Local_point>& positions, std::vector<Point_index> points,
               Cancellation_point& cancellation_point)
    : m_points(std::move(points))
  {
    // What stays is allocated before the triangulation, so that the system gets the memory of that back.
    std::sort(m_points.begin(), m_points.end());
    tabulate_positions();
    std::vector<Cell> unsorted;
    {
      Site_triangulation triangulation(positions);
      triangulation.insert(m_points, cancellation_point);
      if (triangulation.is_usable())
        unsorted = cells_of(triangulation.delaunay(), cancellation_point);
    }
    sort_cells(std::move(unsorted), cancellation_point);
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

  void tabulate_positions()
  {
    if (m_points.empty() || (m_points.back() - m_points.front()) / MAXIMUM_INDICES_PER_POINT >= m_points.size())
      return;
    m_positions.resize(m_points.back() - m_points.front() + 1);
    for (std::size_t k = 0; k != m_points.size(); ++k)
      m_positions[m_points[k] - m_points.front()] = static_cast<Point_index>(k);
  }

  // The cells in the order in which they are in memory, which is nearly that of their places. The info of each
  // cell of the triangulation becomes its number.
  template <typename Cancellation_point>
  static std::vector<Cell> cells_of(const Delaunay& delaunay, Cancellation_point& cancellation_point)
  {
    std::vector<Cell> cells;
    cells.reserve(delaunay.tds().number_of_cells());
    for (const Delaunay::Cell_handle cell : delaunay.all_cell_handles()) {
      cancellation_point();
      cell->info() = static_cast<Cell_index>(cells.size());
      cells.emplace_back();
      for (std::size_t i = 0; i != 4; ++i)
        cells.back().vertices[i] = cell->vertex(static_cast<int>(i))->info();
    }
    for (const Delaunay::Cell_handle cell : delaunay.all_cell_handles()) {
      cancellation_point();
      for (std::size_t i = 0; i != 4; ++i)
        cells[cell->info()].neighbors[i] = cell->neighbor(static_cast<int>(i))->info();
    }
    return cells;
  }

  // The cells get into the lexicographic order of their increasing vertices. They are put where those with
  // the same smallest vertex are, which are few, then sorted.
  template <typename Cancellation_point>
  void sort_cells(std::vector<Cell> unsorted, Cancellation_point& cancellation_point)
  {
    std::vector<Cell_index> end(m_points.size() + 1, 0); // of the cells of each smallest vertex, so far
    for (Cell& cell : unsorted) {
      cancellation_point();
      sort_vertices(cell);
      ++end[position(cell.vertices[0]) + 1];
    }
    for (std::size_t k = 0; k != m_points.size(); ++k)
      end[k + 1] += end[k];
    m_cells.resize(unsorted.size());
    std::vector<Cell_index> numbers(unsorted.size()), places(unsorted.size());
    for (Cell_index c = 0; c != unsorted.size(); ++c) {
      cancellation_point();
      const Cell_index place = end[position(unsorted[c].vertices[0])]++;
      m_cells[place] = unsorted[c];
      numbers[place] = c;
    }
    std::vector<Cell>().swap(unsorted);
    for (std::size_t k = 0, begin = 0; k != m_points.size(); begin = end[k], ++k) {
      cancellation_point();
      sort_cells(begin, end[k], numbers);
    }
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      places[numbers[c]] = c;
    for (Cell& cell : m_cells) {
      cancellation_point();
      for (Cell_index& n : cell.neighbors)
        n = places[n];
    }
  }

  // Makes the vertices increasing, but for the last two, which are exchanged where that keeps the orientation.
  static void sort_vertices(Cell& cell)
  {
    bool is_odd = false;
    const auto sort_two = [&](std::size_t i, std::size_t j) {
      if (cell.vertices[i] > cell.vertices[j]) {
        std::swap(cell.vertices[i], cell.vertices[j]);
        std::swap(cell.neighbors[i], cell.neighbors[j]);
        is_odd = !is_odd;
      }
    };
    sort_two(0, 1);
    sort_two(2, 3);
    sort_two(0, 2);
    sort_two(1, 3);
    sort_two(1, 2);
    if (is_odd) {
      std::swap(cell.vertices[2], cell.vertices[3]);
      std::swap(cell.neighbors[2], cell.neighbors[3]);
    }
  }

  // Of cells with the same smallest vertex.
  static bool is_before(const Cell& a, const Cell& b)
  {
    const auto last = [](const Cell& c) { return std::minmax(c.vertices[2], c.vertices[3]); };
    return a.vertices[1] != b.vertices[1] ? a.vertices[1] < b.vertices[1] : last(a) < last(b);
  }

  // `numbers` are those of the cells.
  void sort_cells(std::size_t begin, std::size_t end, std::vector<Cell_index>& numbers)
  {
    if (end - begin > CELLS_TO_INSERT) {
      std::vector<std::pair<Cell, Cell_index> > entries;
      for (std::size_t c = begin; c != end; ++c)
        entries.emplace_back(m_cells[c], numbers[c]);
      std::sort(entries.begin(), entries.end(),
                [](const auto& a, const auto& b) { return is_before(a.first, b.first); });
      for (std::size_t c = begin; c != end; ++c)
        std::tie(m_cells[c], numbers[c]) = entries[c - begin];
      return;
    }
    for (std::size_t c = begin; c != end; ++c) {
      const Cell cell = m_cells[c];
      const Cell_index number = numbers[c];
      std::size_t place = c;
      for (; place != begin && is_before(cell, m_cells[place - 1]); --place) {
        m_cells[place] = m_cells[place - 1];
        numbers[place] = numbers[place - 1];
      }
      m_cells[place] = cell;
      numbers[place] = number;
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

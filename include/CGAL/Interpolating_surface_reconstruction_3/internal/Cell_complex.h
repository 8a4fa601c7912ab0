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
      copy_cells(triangulation.delaunay(), cancellation_point);
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
  using Vertices = std::array<Point_index, 4>;

  // A table is worth its memory if at least one of so many indices is that of a point.
  static constexpr std::size_t MAXIMUM_INDICES_PER_POINT = 32;

  void tabulate_positions()
  {
    if (m_points.empty() || (m_points.back() - m_points.front()) / MAXIMUM_INDICES_PER_POINT >= m_points.size())
      return;
    m_positions.resize(m_points.back() - m_points.front() + 1);
    for (std::size_t k = 0; k != m_points.size(); ++k)
      m_positions[m_points[k] - m_points.front()] = static_cast<Point_index>(k);
  }

  using Cell_handle = Delaunay::Cell_handle;

  // The cells are in the lexicographic order of their increasing vertices. They are put where those with
  // the same smallest vertex are, which are few, then sorted, and get their neighbors last, in an order in
  // which these are near in memory. The info of each cell of the triangulation becomes its place.
  template <typename Cancellation_point>
  void copy_cells(const Delaunay& delaunay, Cancellation_point& cancellation_point)
  {
    std::vector<Cell_index> end(m_points.size() + 1, 0); // of the cells of each smallest vertex, so far
    for (Cell_handle cell : delaunay.all_cell_handles()) {
      cancellation_point();
      ++end[position(smallest_vertex(cell)) + 1];
    }
    for (std::size_t k = 0; k != m_points.size(); ++k)
      end[k + 1] += end[k];
    m_cells.resize(end.back());
    std::vector<Cell_handle> handles(m_cells.size());
    for (Cell_handle cell : delaunay.all_cell_handles()) {
      cancellation_point();
      const Cell_index c = end[position(smallest_vertex(cell))]++;
      handles[c] = cell;
      m_cells[c].vertices = increasing_vertices(cell);
    }
    std::vector<std::pair<Vertices, Cell_handle> > entries;
    for (std::size_t k = 0, begin = 0; k != m_points.size(); begin = end[k], ++k) {
      cancellation_point();
      sort_cells(begin, end[k], handles, entries);
    }
    for (std::size_t c = 0; c != m_cells.size(); ++c)
      handles[c]->info() = static_cast<Cell_index>(c);
    for (std::size_t c = 0; c != m_cells.size(); ++c) {
      cancellation_point();
      set_neighbors(m_cells[c], handles[c]);
    }
  }

  static Point_index smallest_vertex(Cell_handle cell)
  {
    return (std::min)((std::min)(cell->vertex(0)->info(), cell->vertex(1)->info()),
                      (std::min)(cell->vertex(2)->info(), cell->vertex(3)->info()));
  }

  static Vertices increasing_vertices(Cell_handle cell)
  {
    Vertices v;
    for (std::size_t i = 0; i != 4; ++i)
      v[i] = cell->vertex(static_cast<int>(i))->info();
    std::sort(v.begin(), v.end());
    return v;
  }

  // `entries` is a buffer.
  void sort_cells(std::size_t begin, std::size_t end, std::vector<Cell_handle>& handles,
                  std::vector<std::pair<Vertices, Cell_handle> >& entries)
  {
    entries.clear();
    for (std::size_t c = begin; c != end; ++c)
      entries.emplace_back(m_cells[c].vertices, handles[c]);
    std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t c = begin; c != end; ++c)
      std::tie(m_cells[c].vertices, handles[c]) = entries[c - begin];
  }

  // Exchanges the last two of the increasing vertices where that keeps the orientation.
  static void set_neighbors(Cell& copy, Cell_handle cell)
  {
    std::array<int, 4> order; // which vertices of the cell those of the copy are
    for (int i = 0; i != 4; ++i)
      order[std::size_t(std::find(copy.vertices.begin(), copy.vertices.end(), cell->vertex(i)->info()) -
                        copy.vertices.begin())] = i;
    bool is_odd = false;
    for (std::size_t i = 0; i != 4; ++i)
      for (std::size_t j = i + 1; j != 4; ++j)
        is_odd ^= order[i] > order[j];
    if (is_odd) {
      std::swap(copy.vertices[2], copy.vertices[3]);
      std::swap(order[2], order[3]);
    }
    for (std::size_t i = 0; i != 4; ++i)
      copy.neighbors[i] = cell->neighbor(order[i])->info();
  }

  std::vector<Point_index> m_points;    // increasing
  std::vector<Point_index> m_positions; // of the points in m_points, by their distance from the first one
  std::vector<Cell> m_cells;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CELL_COMPLEX_H

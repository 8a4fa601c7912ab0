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
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The cells of the Delaunay triangulation of some points, in flat arrays and in an order that depends
// on the points only. Local coordinates are exact copies of the input up to shift and scale, so that
// the exact predicates of the kernel decide for the input. An infinite cell has the vertex NO_POINT.
class Cell_complex
{
public:
  using Cell_index = std::uint32_t;

  struct Cell
  {
    std::array<Point_index, 4> vertices;
    std::array<Cell_index, 4> neighbors; // neighbor i is opposite to vertex i
  };

  // `points` are distinct. There are no cells if they are coplanar, or if they have far more cells than
  // the samples of a surface, which may be as many as the square of the points, as on a helix.
  // `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  Cell_complex(const std::vector<Local_point>& positions, std::vector<Point_index> points,
               Cancellation_point& cancellation_point)
    : m_points(std::move(points))
  {
    std::sort(m_points.begin(), m_points.end());
    Delaunay delaunay;
    // Every second point of the ones left out so far joins in a round, the first round has few.
    std::size_t stride = 1;
    while (m_points.size() / stride > POINTS_OF_FIRST_ROUND)
      stride *= 2;
    for (bool is_first = true; stride != 0; stride /= 2, is_first = false) {
      Delaunay::Vertex_handle hint;
      for (std::size_t i = is_first ? 0 : stride; i < m_points.size(); i += is_first ? stride : 2 * stride) {
        cancellation_point(MICROSECONDS_PER_INSERTION);
        hint = insert(delaunay, positions[m_points[i]], static_cast<Point_index>(i), hint);
      }
      if (delaunay.number_of_cells() > MAXIMUM_CELLS_PER_POINT * delaunay.number_of_vertices())
        return;
    }
    // Coplanar points have no cells.
    if (delaunay.dimension() == 3)
      copy_cells(delaunay, cancellation_point);
  }

  Cell_complex(const std::vector<Local_point>& positions, std::vector<Point_index> points)
  {
    No_cancellation cancellation_point;
    *this = Cell_complex(positions, std::move(points), cancellation_point);
  }

  // The points that the cells may have as vertices, increasing.
  const std::vector<Point_index>& points() const { return m_points; }

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

  // The vertex of the cell that is not of the facet.
  static Point_index apex(const Cell& cell, const std::array<Point_index, 3>& facet)
  {
    for (std::size_t i = 0; i != 3; ++i)
      if (cell.vertices[i] != facet[0] && cell.vertices[i] != facet[1] && cell.vertices[i] != facet[2])
        return cell.vertices[i];
    return cell.vertices[3];
  }

private:
  // A random sample has 7 cells a point.
  static constexpr std::size_t MAXIMUM_CELLS_PER_POINT = 50, POINTS_OF_FIRST_ROUND = 500;

  static constexpr std::size_t MICROSECONDS_PER_INSERTION = 16;

  // Not less than the 128 facets of what CGAL takes for a small hole.
  static constexpr std::size_t CELLS_OF_SMALL_HOLE = 256;

  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = Triangulation_vertex_base_with_info_3<Point_index, Kernel>;
  using Cell_base =
    Triangulation_cell_base_with_info_3<Cell_index, Kernel, Delaunay_triangulation_cell_base_3<Kernel> >;
  using Delaunay = Delaunay_triangulation_3<Kernel, Triangulation_data_structure_3<Vertex_base, Cell_base> >;

  // CGAL keeps a static table while it replaces the cells of a small hole, which an exception would leave
  // broken for the next triangulation: memory for the new cells is made sure of before.
  static Delaunay::Vertex_handle insert(Delaunay& delaunay, const Local_point& p, Point_index index,
                                        Delaunay::Vertex_handle hint)
  {
    auto& cells = delaunay.tds().cells();
    if (cells.capacity() - cells.size() < CELLS_OF_SMALL_HOLE)
      cells.reserve(cells.size() + CELLS_OF_SMALL_HOLE);
    const Delaunay::Vertex_handle vertex = delaunay.insert(Delaunay::Point(p.x(), p.y(), p.z()), hint);
    vertex->info() = index;
    return vertex;
  }

  // The vertices of a cell as positions in m_points; NO_POINT if infinite.
  static std::array<Point_index, 4> vertices_of(const Delaunay& delaunay, Delaunay::Cell_handle cell)
  {
    std::array<Point_index, 4> result;
    for (int i = 0; i != 4; ++i)
      result[std::size_t(i)] = delaunay.is_infinite(cell->vertex(i)) ? NO_POINT : cell->vertex(i)->info();
    return result;
  }

  template <typename Cancellation_point>
  void copy_cells(const Delaunay& delaunay, Cancellation_point& cancellation_point)
  {
    const std::vector<Delaunay::Cell_handle> order = sorted_cells(delaunay, cancellation_point);
    for (std::size_t c = 0; c != order.size(); ++c) {
      cancellation_point();
      order[c]->info() = static_cast<Cell_index>(c);
    }
    m_cells.resize(order.size());
    for (std::size_t c = 0; c != order.size(); ++c) {
      cancellation_point();
      m_cells[c].vertices = vertices_of(delaunay, order[c]);
      for (std::size_t i = 0; i != 4; ++i) {
        m_cells[c].neighbors[i] = order[c]->neighbor(int(i))->info();
        if (m_cells[c].vertices[i] != NO_POINT)
          m_cells[c].vertices[i] = m_points[m_cells[c].vertices[i]];
      }
    }
  }

  // The cells in lexicographic order of their increasing vertices: those with the same smallest
  // vertex are few.
  template <typename Cancellation_point>
  std::vector<Delaunay::Cell_handle> sorted_cells(const Delaunay& delaunay,
                                                  Cancellation_point& cancellation_point) const
  {
    const auto key = [&](Delaunay::Cell_handle cell) {
      std::array<Point_index, 4> result = vertices_of(delaunay, cell);
      std::sort(result.begin(), result.end());
      return result;
    };
    const auto smallest = [&](Delaunay::Cell_handle cell) {
      const std::array<Point_index, 4> v = vertices_of(delaunay, cell);
      return std::size_t((std::min)((std::min)(v[0], v[1]), (std::min)(v[2], v[3])));
    };
    std::vector<Cell_index> next(m_points.size() + 1, 0);
    for (auto cell = delaunay.all_cells_begin(); cell != delaunay.all_cells_end(); ++cell) {
      cancellation_point();
      ++next[smallest(cell) + 1];
    }
    for (std::size_t k = 0; k != m_points.size(); ++k)
      next[k + 1] += next[k];
    std::vector<Delaunay::Cell_handle> result(next.back());
    for (auto cell = delaunay.all_cells_begin(); cell != delaunay.all_cells_end(); ++cell) {
      cancellation_point();
      result[next[smallest(cell)]++] = cell;
    }
    using Keyed_cell = std::pair<std::array<Point_index, 4>, Delaunay::Cell_handle>;
    std::vector<Keyed_cell> bucket;
    for (std::size_t k = 0, begin = 0; k != m_points.size(); begin = next[k], ++k) {
      bucket.clear();
      for (std::size_t c = begin; c != next[k]; ++c) {
        cancellation_point();
        bucket.emplace_back(key(result[c]), result[c]);
      }
      std::sort(bucket.begin(), bucket.end(),
                [](const Keyed_cell& a, const Keyed_cell& b) { return a.first < b.first; });
      for (std::size_t c = begin; c != next[k]; ++c)
        result[c] = bucket[c - begin].second;
    }
    return result;
  }

  std::vector<Point_index> m_points; // increasing
  std::vector<Cell> m_cells;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CELL_COMPLEX_H

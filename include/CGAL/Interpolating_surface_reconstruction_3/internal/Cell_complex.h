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
#include <cmath>
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

  // `points` are distinct and close to each other in their order. There are no cells if they are coplanar,
  // or if they have far more cells than the samples of a surface, which may be as many as the square of
  // the points, as on a helix. `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  Cell_complex(const std::vector<Local_point>& positions, const std::vector<Point_index>& points,
               Cancellation_point& cancellation_point)
  {
    Delaunay delaunay;
    // Every second point of the ones left out so far joins in a round, the first round has few.
    std::size_t stride = 1;
    while (points.size() / stride > POINTS_OF_FIRST_ROUND)
      stride *= 2;
    for (bool is_first = true; stride != 0; stride /= 2, is_first = false) {
      Delaunay::Vertex_handle hint;
      for (std::size_t i = is_first ? 0 : stride; i < points.size(); i += is_first ? stride : 2 * stride) {
        cancellation_point(MICROSECONDS_PER_INSERTION);
        hint = insert(delaunay, positions[points[i]], points[i], hint);
      }
      if (delaunay.number_of_cells() > MAXIMUM_CELLS_PER_POINT * delaunay.number_of_vertices())
        return;
    }
    // Coplanar points have no cells.
    if (delaunay.dimension() == 3)
      copy_cells(delaunay, cancellation_point);
  }

  Cell_complex(const std::vector<Local_point>& positions, const std::vector<Point_index>& points)
  {
    No_cancellation cancellation_point;
    *this = Cell_complex(positions, points, cancellation_point);
  }

  std::size_t size() const { return m_cells.size(); }
  const Cell& operator[](std::size_t c) const { return m_cells[c]; }

  static bool is_infinite(const Cell& cell)
  {
    return cell.vertices[0] == NO_POINT || cell.vertices[1] == NO_POINT || cell.vertices[2] == NO_POINT ||
           cell.vertices[3] == NO_POINT;
  }

  // The vertices of the facet opposite to vertex i.
  static std::array<Point_index, 3> facet(const Cell& cell, std::size_t i)
  {
    return { { cell.vertices[(i + 1) & 3], cell.vertices[(i + 2) & 3], cell.vertices[(i + 3) & 3] } };
  }

private:
  // A random sample has 7 cells a point.
  static constexpr std::size_t MAXIMUM_CELLS_PER_POINT = 50, POINTS_OF_FIRST_ROUND = 500;

  static constexpr std::size_t MICROSECONDS_PER_INSERTION = 16;

  // Not less than the 128 facets of what CGAL takes for a small hole.
  static constexpr std::size_t CELLS_OF_SMALL_HOLE = 256;

  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = Triangulation_vertex_base_with_info_3<Point_index, Kernel>;
  using Cell_base = Triangulation_cell_base_with_info_3<Cell_index, Kernel, Delaunay_triangulation_cell_base_3<Kernel> >;
  using Delaunay = Delaunay_triangulation_3<Kernel, Triangulation_data_structure_3<Vertex_base, Cell_base> >;

  // CGAL keeps a static table while it replaces the cells of a small hole, which an exception would leave
  // broken for the next triangulation: memory for the new cells is made sure of before.
  static Delaunay::Vertex_handle insert(Delaunay& delaunay, const Local_point& p, Point_index index, Delaunay::Vertex_handle hint)
  {
    auto& cells = delaunay.tds().cells();
    if (cells.capacity() - cells.size() < CELLS_OF_SMALL_HOLE)
      cells.reserve(cells.size() + CELLS_OF_SMALL_HOLE);
    const Delaunay::Vertex_handle vertex = delaunay.insert(Delaunay::Point(p.x(), p.y(), p.z()), hint);
    vertex->info() = index;
    return vertex;
  }

  template <typename Cancellation_point>
  void copy_cells(const Delaunay& delaunay, Cancellation_point& cancellation_point)
  {
    struct Sortable
    {
      std::array<Point_index, 4> key;
      Delaunay::Cell_handle handle;
    };
    std::vector<Sortable> order;
    order.reserve(delaunay.number_of_cells());
    for (auto cell = delaunay.all_cells_begin(); cell != delaunay.all_cells_end(); ++cell) {
      cancellation_point();
      Sortable sortable{ vertices_of(delaunay, cell), cell };
      std::sort(sortable.key.begin(), sortable.key.end());
      order.push_back(sortable);
    }
    std::sort(order.begin(), order.end(), [&](const Sortable& a, const Sortable& b) {
      cancellation_point();
      return a.key < b.key;
    });
    for (std::size_t c = 0; c != order.size(); ++c)
      order[c].handle->info() = static_cast<Cell_index>(c);
    m_cells.resize(order.size());
    for (std::size_t c = 0; c != order.size(); ++c) {
      cancellation_point();
      m_cells[c].vertices = vertices_of(delaunay, order[c].handle);
      for (int i = 0; i != 4; ++i)
        m_cells[c].neighbors[std::size_t(i)] = order[c].handle->neighbor(i)->info();
    }
  }

  static std::array<Point_index, 4> vertices_of(const Delaunay& delaunay, Delaunay::Cell_handle cell)
  {
    std::array<Point_index, 4> result;
    for (int i = 0; i != 4; ++i)
      result[std::size_t(i)] = delaunay.is_infinite(cell->vertex(i)) ? NO_POINT : cell->vertex(i)->info();
    return result;
  }

  std::vector<Cell> m_cells;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CELL_COMPLEX_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SITE_TRIANGULATION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SITE_TRIANGULATION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

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
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The Delaunay triangulation of some of the points, to which more can be added. Local coordinates are
// exact copies of the input up to shift and scale, so that the exact predicates of the kernel decide for
// the input.
class Site_triangulation
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = Triangulation_vertex_base_with_info_3<Point_index, Kernel>;
  using Cell_base =
    Triangulation_cell_base_with_info_3<std::uint32_t, Kernel, Delaunay_triangulation_cell_base_3<Kernel> >;

public:
  // The info of a vertex is its point, NO_POINT if infinite; that of a cell is free.
  using Delaunay = Delaunay_triangulation_3<Kernel, Triangulation_data_structure_3<Vertex_base, Cell_base> >;

  explicit Site_triangulation(const std::vector<Local_point>& positions) : m_positions(positions)
  {
    m_delaunay.infinite_vertex()->info() = NO_POINT;
  }

  // `sites` are increasing and new. `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  void insert(const std::vector<Point_index>& sites, Cancellation_point& cancellation_point)
  {
    // Three of four points of the ones left out so far join in a round, the first round has few.
    std::size_t stride = 1;
    while (sites.size() / stride > POINTS_OF_FIRST_ROUND)
      stride *= STRIDE_RATIO;
    const std::size_t old_vertices = m_delaunay.number_of_vertices();
    for (bool is_first = true; stride != 0 && !m_has_too_many_cells; stride /= STRIDE_RATIO, is_first = false) {
      const std::size_t size = (sites.size() + stride - 1) / stride,
                        maximum_cells = MAXIMUM_CELLS_PER_POINT * (old_vertices + size);
      Delaunay::Vertex_handle hint;
      for (std::size_t k = 0; k != size && !m_has_too_many_cells; ++k) {
        if (!is_first && k % STRIDE_RATIO == 0)
          continue;
        cancellation_point(MICROSECONDS_PER_INSERTION);
        hint = insert(sites[k * stride], hint);
        m_has_too_many_cells = m_delaunay.number_of_cells() > maximum_cells;
      }
    }
  }

  // `sites` are increasing; others are left alone.
  template <typename Cancellation_point>
  void remove(const std::vector<Point_index>& sites, Cancellation_point& cancellation_point)
  {
    std::vector<Delaunay::Vertex_handle> vertices;
    for (const Delaunay::Vertex_handle vertex : m_delaunay.finite_vertex_handles())
      if (std::binary_search(sites.begin(), sites.end(), vertex->info()))
        vertices.push_back(vertex);
    for (const Delaunay::Vertex_handle vertex : vertices) {
      cancellation_point(MICROSECONDS_PER_REMOVAL);
      m_delaunay.remove(vertex);
    }
  }

  // Increasing.
  std::vector<Point_index> sites() const
  {
    std::vector<Point_index> result;
    result.reserve(m_delaunay.number_of_vertices());
    for (const Delaunay::Vertex_handle vertex : m_delaunay.finite_vertex_handles())
      result.push_back(vertex->info());
    std::sort(result.begin(), result.end());
    return result;
  }

  const Delaunay& delaunay() const { return m_delaunay; }

  // Calls visit(facet) once for each facet with its points, NO_POINT if infinite.
  template <typename Visit>
  void for_each_facet(const Visit& visit) const
  {
    for (auto f = m_delaunay.all_facets_begin(); f != m_delaunay.all_facets_end(); ++f)
      visit(std::array<Point_index, 3>{ { f->first->vertex((f->second + 1) & 3)->info(),
                                          f->first->vertex((f->second + 2) & 3)->info(),
                                          f->first->vertex((f->second + 3) & 3)->info() } });
  }

  // Coplanar points have no cells. Those that have far more cells than the samples of a surface, which may
  // be as many as the square of the points, as on a helix, are not all inserted.
  bool is_usable() const { return m_delaunay.dimension() == 3 && !m_has_too_many_cells; }

private:
  // A random sample has 7 cells a point.
  static constexpr std::size_t MAXIMUM_CELLS_PER_POINT = 50, POINTS_OF_FIRST_ROUND = 500;

  // More rounds pass over the whole triangulation more often, fewer have more cells that do not last.
  static constexpr std::size_t STRIDE_RATIO = 4;

  // A few, but hundreds where many points are cospherical.
  static constexpr std::size_t MICROSECONDS_PER_INSERTION = 64, MICROSECONDS_PER_REMOVAL = 256;

  // Not less than the 128 facets of what CGAL takes for a small hole.
  static constexpr std::size_t CELLS_OF_SMALL_HOLE = 256;

  // CGAL keeps a static table while it replaces the cells of a small hole, which an exception would leave
  // broken for the next triangulation: memory for the new cells is made sure of before.
  Delaunay::Vertex_handle insert(Point_index site, Delaunay::Vertex_handle hint)
  {
    auto& cells = m_delaunay.tds().cells();
    if (cells.capacity() - cells.size() < CELLS_OF_SMALL_HOLE)
      cells.reserve(cells.size() + CELLS_OF_SMALL_HOLE);
    const Local_point& p = m_positions[site];
    const Delaunay::Vertex_handle vertex = m_delaunay.insert(Delaunay::Point(p.x(), p.y(), p.z()), hint);
    vertex->info() = site;
    return vertex;
  }

  const std::vector<Local_point>& m_positions;
  Delaunay m_delaunay;
  bool m_has_too_many_cells = false;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SITE_TRIANGULATION_H

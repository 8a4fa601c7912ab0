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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_SIDES_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_SIDES_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// On which side of an oriented surface the cells of a Delaunay triangulation of its points are, apart from parts of
// the surface that are in doubt.
class Surface_sides
{
public:
  using Cell_index = Cell_complex::Cell_index;
  using Triangle = std::array<Point_index, 3>;

  enum class Side : unsigned char
  {
    UNKNOWN,
    INSIDE,
    OUTSIDE
  };

  // `is_in_doubt` of each point; it becomes 1 at triangles that are no facets. `cancellation_point()` is called again
  // and again and may throw.
  template <typename CancellationPoint>
  Surface_sides(const Cell_complex& cells, std::vector<Triangle> triangles, std::vector<unsigned char>& is_in_doubt,
                CancellationPoint& cancellation_point)
    : m_cells(cells), m_triangles(std::move(triangles)), m_sides(cells.size(), Side::UNKNOWN)
  {
    for (Triangle& t : m_triangles)
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(m_triangles.begin(), m_triangles.end());
    m_begins.assign(cells.points().size() + 1, 0);
    for (const Triangle& t : m_triangles)
      ++m_begins[cells.position(t[0]) + 1];
    std::partial_sum(m_begins.begin(), m_begins.end(), m_begins.begin());
    const std::vector<Facet_sides> sides = find_sides_at_triangles(is_in_doubt, cancellation_point);
    find_sides(sides, is_in_doubt, cancellation_point);
  }

  Side operator[](Cell_index c) const { return m_sides[c]; }

  // Each from its smallest point on, in order.
  const std::vector<Triangle>& triangles() const { return m_triangles; }
  // Whether a triangle is a facet of the cells.
  bool is_facet(std::size_t t) const { return m_is_facet[t] != 0; }

private:
  // Of a cell at its facets.
  using Facet_sides = std::array<Side, 4>;

  // Also doubts the triangles that are no facets.
  template <typename CancellationPoint>
  std::vector<Facet_sides> find_sides_at_triangles(std::vector<unsigned char>& is_in_doubt,
                                                   CancellationPoint& cancellation_point)
  {
    std::vector<Facet_sides> sides(m_cells.size(),
                                   Facet_sides{ { Side::UNKNOWN, Side::UNKNOWN, Side::UNKNOWN, Side::UNKNOWN } });
    m_is_facet.assign(m_triangles.size(), 0);
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i) {
        cancellation_point();
        Triangle f = Cell_complex::facet(m_cells[c], i);
        const Cell_index n = m_cells[c].neighbors[i];
        if (n < c || Cell_complex::is_infinite(f))
          continue;
        std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
        bool is_triangle = false, is_reversed_triangle = false;
        for_each_triangle_from(f[0], [&](std::size_t k) {
          const Triangle& t = m_triangles[k];
          const bool is_same = t[1] == f[1] && t[2] == f[2], is_reversed = t[1] == f[2] && t[2] == f[1];
          if (is_same || is_reversed)
            m_is_facet[k] = 1;
          is_triangle = is_triangle || is_same;
          is_reversed_triangle = is_reversed_triangle || is_reversed;
        });
        if (!is_triangle && !is_reversed_triangle)
          continue;
        // Seen from its cell, a facet of even index is in counterclockwise order; sheets may lie on each other.
        sides[c][i] = side(is_triangle == (i % 2 == 0));
        const std::size_t j = m_cells.mirror(c, i);
        sides[n][j] = side(is_triangle && is_reversed_triangle ? j % 2 == 0 : sides[c][i] == Side::OUTSIDE);
      }
    for (std::size_t t = 0; t != m_triangles.size(); ++t)
      if (!is_facet(t))
        for (Point_index p : m_triangles[t])
          is_in_doubt[p] = 1;
    return sides;
  }

  static Side side(bool is_inside) { return is_inside ? Side::INSIDE : Side::OUTSIDE; }

  // Calls visit(position) for the triangles whose smallest point is p: few.
  template <typename Visit>
  void for_each_triangle_from(Point_index p, const Visit& visit) const
  {
    const std::size_t v = m_cells.position(p);
    for (std::size_t k = m_begins[v]; k != m_begins[v + 1]; ++k)
      visit(k);
  }

  // Cells at triangles first, then their neighbors across facets that are none, but for facets at doubtful points.
  template <typename CancellationPoint>
  void find_sides(const std::vector<Facet_sides>& sides, const std::vector<unsigned char>& is_in_doubt,
                  CancellationPoint& cancellation_point)
  {
    const auto is_sure = [&](Cell_index c, std::size_t i) {
      const Triangle f = Cell_complex::facet(m_cells[c], i);
      return std::none_of(f.begin(), f.end(), [&](Point_index p) { return p != NO_POINT && is_in_doubt[p] != 0; });
    };
    std::vector<Cell_index> reached;
    for (Cell_index c = 0; c != m_cells.size(); ++c) {
      cancellation_point();
      for (std::size_t i = 0; i != 4 && m_sides[c] == Side::UNKNOWN; ++i)
        if (sides[c][i] != Side::UNKNOWN && is_sure(c, i))
          m_sides[c] = sides[c][i];
      if (m_sides[c] != Side::UNKNOWN)
        reached.push_back(c);
    }
    for (std::size_t k = 0; k != reached.size(); ++k) {
      cancellation_point();
      const Cell_index c = reached[k];
      for (std::size_t i = 0; i != 4; ++i) {
        const Cell_index n = m_cells[c].neighbors[i];
        if (m_sides[n] == Side::UNKNOWN && sides[c][i] == Side::UNKNOWN && is_sure(c, i)) {
          m_sides[n] = m_sides[c];
          reached.push_back(n);
        }
      }
    }
  }

  const Cell_complex& m_cells;
  std::vector<Triangle> m_triangles;
  std::vector<unsigned char> m_is_facet; // of each triangle
  std::vector<std::size_t> m_begins;     // of the triangles whose smallest point is a point of the cells, for each
  std::vector<Side> m_sides;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_SIDES_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_FANS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_FANS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The facets around each vertex of the surface between the labels of a labelling. At nearly all vertices they are one
// closed fan, which is found out sooner from the few facets than from the many cells.
class Surface_fans
{
public:
  using Cell_index = Cell_complex::Cell_index;

  // `cancellation_point()` is called again and again and may throw.
  template <typename Labelling, typename Cancellation_point>
  Surface_fans(const Cell_complex& cells, const Labelling& labelling, Cancellation_point& cancellation_point)
    : m_ends(cells.points().size() + 1, 0)
  {
    const auto for_each_corner = [&](const auto& visit) {
      for (Cell_index c = 0; c != cells.size(); ++c) {
        cancellation_point();
        if (labelling.label(c))
          for (std::size_t i = 0; i != 4; ++i)
            if (labelling.is_surface(c, i))
              visit_corners(cells, c, i, visit);
      }
    };
    for_each_corner([&](std::size_t v, const Edge&) { ++m_ends[v + 1]; });
    for (std::size_t v = 1; v != m_ends.size(); ++v)
      m_ends[v] += m_ends[v - 1];
    m_edges.resize(m_ends.back());
    for_each_corner([&](std::size_t v, const Edge& edge) { m_edges[m_ends[v]++] = edge; });
  }

  // Whether the facets at the vertex are one fan, of which each edge has two facets: the cells of each label around the
  // vertex are connected then.
  bool is_closed(std::size_t v) const
  {
    const std::size_t begin = v == 0 ? 0 : m_ends[v - 1], size = m_ends[v] - begin;
    if (size == 0 || size > MAXIMUM_SIZE)
      return false;
    // The edges opposite to the vertex are a cycle without repetitions if following them does not end sooner.
    Point_index last = m_edges[begin].second;
    for (std::size_t steps = 1; steps != size; ++steps) {
      std::size_t k = begin;
      while (k != m_ends[v] && m_edges[k].first != last)
        ++k;
      if (k == m_ends[v] || k == begin)
        return false;
      last = m_edges[k].second;
    }
    return last == m_edges[begin].first;
  }

private:
  // Of a facet, opposite to a vertex, in the direction that has the label on its left.
  using Edge = std::pair<Point_index, Point_index>;

  // Larger fans would take the square of their size.
  static constexpr std::size_t MAXIMUM_SIZE = 64;

  template <typename Visit>
  static void visit_corners(const Cell_complex& cells, Cell_index c, std::size_t i, const Visit& visit)
  {
    const std::array<Point_index, 3> f = Cell_complex::facet(cells[c], i);
    for (std::size_t k = 0; k != 3; ++k)
      if (f[k] != NO_POINT) {
        const Point_index a = f[(k + 1) % 3], b = f[(k + 2) % 3];
        visit(cells.position(f[k]), i % 2 == 0 ? Edge(a, b) : Edge(b, a));
      }
  }

  std::vector<std::uint32_t> m_ends; // of the edges of each vertex in m_edges
  std::vector<Edge> m_edges;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_FANS_H

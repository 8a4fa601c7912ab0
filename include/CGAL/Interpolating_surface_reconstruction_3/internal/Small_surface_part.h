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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SMALL_SURFACE_PART_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SMALL_SURFACE_PART_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Label_stars.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Whether the surface between the labels at the vertices of some cells consists of several components, one of
// which has few points. Hubs end the search.
template <typename Labelling>
class Small_surface_part
{
public:
  using Cell_index = Cell_complex::Cell_index;

  Small_surface_part(const Cell_complex& cells, const Labelling& labelling, const Label_stars<Labelling>& stars)
    : m_cells(cells), m_labelling(labelling), m_stars(stars), m_last_walks(cells.points().size(), 0),
      m_is_start(cells.points().size(), 0)
  { }

  bool operator()(const std::vector<Cell_index>& cells)
  {
    find_starts(cells);
    const bool result = is_small_part_at_starts();
    for (Point_index p : m_starts)
      m_is_start[m_cells.position(p)] = 0;
    return result;
  }

private:
  // Points that a component has at least. What is cut off by a chain of changes has fewer.
  static constexpr std::size_t MINIMUM_POINTS = 64;

  bool is_small_part_at_starts()
  {
    const std::uint32_t before = m_walk;
    for (Point_index start : m_starts) {
      if (last_walk_to(start) > before)
        continue;
      if (walk(start) &&
          std::any_of(m_starts.begin(), m_starts.end(), [&](Point_index p) { return last_walk_to(p) != m_walk; }))
        return true;
    }
    return false;
  }

  std::uint32_t& last_walk_to(Point_index p) { return m_last_walks[m_cells.position(p)]; }

  // The vertices on the surface.
  void find_starts(const std::vector<Cell_index>& cells)
  {
    m_starts.clear();
    for (Cell_index c : cells)
      for (Point_index p : m_cells[c].vertices)
        if (p != NO_POINT)
          m_starts.push_back(p);
    std::sort(m_starts.begin(), m_starts.end());
    m_starts.erase(std::unique(m_starts.begin(), m_starts.end()), m_starts.end());
    m_starts.erase(std::remove_if(m_starts.begin(), m_starts.end(), [&](Point_index p) { return !is_on_surface(p); }),
                   m_starts.end());
    for (Point_index p : m_starts)
      m_is_start[m_cells.position(p)] = 1;
  }

  // Whether cells of both labels are around the point.
  bool is_on_surface(Point_index p) const
  {
    const std::size_t v = m_cells.position(p);
    if (m_stars.is_hub(v))
      return false;
    const bool first = m_labelling.label(m_stars.first_cell(v));
    bool result = false;
    m_stars.for_each_cell(v, [&](Cell_index c) { result = result || m_labelling.label(c) != first; });
    return result;
  }

  // Walks over the surface until it ends, has enough points or connects all starts, as it mostly does soon; returns
  // whether it has ended.
  bool walk(Point_index start)
  {
    ++m_walk;
    m_reached.clear();
    std::size_t starts_left = m_starts.size();
    const auto reach = [&](Point_index p) {
      const std::size_t v = m_cells.position(p);
      if (m_last_walks[v] == m_walk)
        return;
      m_last_walks[v] = m_walk;
      m_reached.push_back(p);
      starts_left -= m_is_start[v];
    };
    reach(start);
    for (std::size_t k = 0; k != m_reached.size(); ++k) {
      if (starts_left == 0 || m_reached.size() >= MINIMUM_POINTS || m_stars.is_hub(m_cells.position(m_reached[k])))
        return false;
      for_each_neighbor(m_reached[k], reach);
    }
    return true;
  }

  // Calls visit(point) for the points connected to a point by edges of the surface. A facet of the surface has one cell
  // with the label.
  template <typename Visit>
  void for_each_neighbor(Point_index p, const Visit& visit) const
  {
    const std::size_t v = m_cells.position(p);
    if (m_stars.is_hub(v))
      return;
    m_stars.for_each_cell(v, [&](Cell_index c) {
      for (std::size_t i = 0; i != 4 && m_labelling.label(c); ++i)
        if (m_cells[c].vertices[i] != p && m_labelling.is_surface(c, i))
          for (Point_index q : Cell_complex::facet(m_cells[c], i))
            if (q != NO_POINT && q != p)
              visit(q);
    });
  }

  const Cell_complex& m_cells;
  const Labelling& m_labelling;
  const Label_stars<Labelling>& m_stars;
  std::vector<Point_index> m_starts, m_reached;
  std::uint32_t m_walk = 0;                // number of walks so far
  std::vector<std::uint32_t> m_last_walks; // of each point: the last one that reached it, counted from 1
  std::vector<unsigned char> m_is_start;   // of each point
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SMALL_SURFACE_PART_H

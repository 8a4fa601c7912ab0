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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STAR_TABLE_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STAR_TABLE_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Point_star.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The links of the stars of all points in one array. Slot s of the link of point p, followed by the
// slot next(p, s), spans the triangle (p, neighbor(s), neighbor(next(p, s))), unless one is NO_POINT.
class Star_table
{
public:
  using Slot = std::size_t;

  Point_index size() const { return static_cast<Point_index>(m_begin.size() - 1); }
  Slot number_of_slots() const { return m_neighbors.size(); }

  Slot begin(Point_index p) const { return m_begin[p]; }
  Slot end(Point_index p) const { return m_begin[p + 1]; }
  Slot next(Point_index p, Slot s) const { return s + 1 == m_begin[p + 1] ? m_begin[p] : s + 1; }
  Point_index neighbor(Slot s) const { return m_neighbors[s]; }

  // Whether the slot and the next one span a triangle; a link of two is one triangle, not two.
  bool has_triangle(Point_index p, Slot s) const
  {
    const Slot t = next(p, s);
    return m_neighbors[s] != NO_POINT && m_neighbors[t] != NO_POINT && m_neighbors[s] != m_neighbors[t] &&
           (end(p) - begin(p) > 2 || s == begin(p));
  }

  // How the star of `center` sees the triangle (center, a, b).
  enum class View
  {
    ABSENT,
    SAME_ORIENTATION,
    OPPOSITE_ORIENTATION
  };

  View view(Point_index center, Point_index a, Point_index b) const
  {
    for (Slot s = begin(center); s != end(center); ++s)
      if (m_neighbors[s] == a) {
        if (m_neighbors[next(center, s)] == b)
          return View::SAME_ORIENTATION;
        const Slot previous = s == begin(center) ? end(center) - 1 : s - 1;
        return m_neighbors[previous] == b ? View::OPPOSITE_ORIENTATION : View::ABSENT;
      }
    return View::ABSENT;
  }

  // The number of the stars of a, b and c that contain the triangle (a, b, c).
  std::size_t votes(Point_index a, Point_index b, Point_index c) const
  {
    return (view(a, b, c) != View::ABSENT ? 1u : 0u) + (view(b, c, a) != View::ABSENT ? 1u : 0u) +
           (view(c, a, b) != View::ABSENT ? 1u : 0u);
  }

  // Builds the table from blocks of consecutive points, each with the lengths and the concatenation
  // of its links.
  struct Block
  {
    std::vector<std::uint32_t> lengths;
    std::vector<Point_index> neighbors;
  };

  explicit Star_table(std::vector<Block>&& blocks)
  {
    std::size_t points = 0, slots = 0;
    for (const Block& block : blocks) {
      points += block.lengths.size();
      slots += block.neighbors.size();
    }
    m_begin.reserve(points + 1);
    m_neighbors.reserve(slots);
    m_begin.push_back(0);
    for (Block& block : blocks) {
      for (std::uint32_t length : block.lengths)
        m_begin.push_back(m_begin.back() + length);
      m_neighbors.insert(m_neighbors.end(), block.neighbors.begin(), block.neighbors.end());
      block = Block();
    }
  }

private:
  std::vector<Slot> m_begin;
  std::vector<Point_index> m_neighbors;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STAR_TABLE_H

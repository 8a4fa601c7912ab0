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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_COMPONENTS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_COMPONENTS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The cells around a point in components of equal labels, connected by facets at the point.
template <typename Labelling>
class Label_components
{
public:
  using Cell_index = Cell_complex::Cell_index;

  struct Star_cell
  {
    Cell_index cell;
    std::uint32_t component;
    bool operator<(const Star_cell& other) const { return cell < other.cell; }
  };

  Label_components(const Cell_complex& cells, const Labelling& labelling)
    : m_cells(cells), m_labelling(labelling), m_mark(cells.size(), 0)
  { }

  // Finds the components around the point, of which `first` is a cell; returns their number.
  std::size_t find(Point_index p, Cell_index first)
  {
    std::uint32_t components = 0;
    ++m_stamp;
    m_star_cells.clear();
    m_seeds.assign(1, first);
    while (!m_seeds.empty()) {
      const Cell_index seed = m_seeds.back();
      m_seeds.pop_back();
      if (m_mark[seed] == m_stamp)
        continue;
      m_mark[seed] = m_stamp;
      m_stack.assign(1, seed);
      while (!m_stack.empty()) {
        const Cell_index c = m_stack.back();
        m_stack.pop_back();
        m_star_cells.push_back(Star_cell{ c, components });
        for (std::size_t i = 0; i != 4; ++i) {
          const Cell_index n = m_cells[c].neighbors[i];
          if (m_cells[c].vertices[i] == p || m_mark[n] == m_stamp)
            continue;
          if (m_labelling.label(n) == m_labelling.label(c)) {
            m_mark[n] = m_stamp;
            m_stack.push_back(n);
          } else {
            m_seeds.push_back(n);
          }
        }
      }
      ++components;
    }
    return components;
  }

  // The cells of each of the components found last, in the order of their smallest cells.
  std::vector<std::vector<Cell_index> > sorted(std::size_t components)
  {
    std::sort(m_star_cells.begin(), m_star_cells.end());
    std::vector<std::vector<Cell_index> > result(components);
    for (const Star_cell& c : m_star_cells)
      result[c.component].push_back(c.cell);
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  const Cell_complex& m_cells;
  const Labelling& m_labelling;
  std::vector<std::uint32_t> m_mark; // of each cell: the last search that reached it
  std::uint32_t m_stamp = 0;
  std::vector<Star_cell> m_star_cells; // of the last search
  std::vector<Cell_index> m_seeds, m_stack;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_COMPONENTS_H

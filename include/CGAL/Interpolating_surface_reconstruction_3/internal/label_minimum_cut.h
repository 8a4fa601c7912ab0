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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_MINIMUM_CUT_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_MINIMUM_CUT_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Minimum_cut.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelling_repair.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Changes the labels of many cells together where the surface faces against the normals of its
// vertices, and these differ from each other: where sheets are closer than the spacing, the averaged normals at a
// crease may label a passage between them inside, and no single cell opens it. The labels of the cells around such
// facets that have the least energy are a minimum cut. The values of the function are what is wrong there, so
// that they count little.
class Label_minimum_cut
{
public:
  using Cell_index = Cell_complex::Cell_index;

  Label_minimum_cut(const Cell_complex& cells, Oriented_labelling& labelling)
    : m_cells(cells), m_labelling(labelling), m_node_of(cells.size(), OUT)
  { }

  // Keeps what makes no more points irregular. `cancellation_point()` is called again and again and
  // may throw.
  template <typename Repair, typename Cancellation_point>
  void operator()(Repair& repair, Cancellation_point&& cancellation_point)
  {
    const std::vector<Cell_index> cells = find_cells(cancellation_point);
    for (Cell_index c : cells)
      if (m_node_of[c] == IN) {
        collect_region(c);
        for (const std::vector<Cell_index>& changes : cut(cancellation_point))
          repair.change_unless_worse(changes, cancellation_point);
      }
  }

private:
  static constexpr std::uint32_t OUT = static_cast<std::uint32_t>(-1), IN = OUT - 1;

  // Rings of cells around a facet that are free to change: enough for the corner of a passage.
  static constexpr int RINGS = 4;

  // Between a facet and its vertices. At the corner of a cube it is 1 / sqrt(3).
  static constexpr double SMALLEST_COSINE = .1;

  // Between the normals of a facet across a passage. Where they are more alike, as on a single noisy sheet, a cut would
  // do no more than to cut off small parts.
  static constexpr double LARGEST_COSINE_OF_VERTICES = .7;

  static constexpr double VALUE_SHARE = .1;

  // The finite cells around facets across passages.
  template <typename Cancellation_point>
  std::vector<Cell_index> find_cells(Cancellation_point& cancellation_point)
  {
    std::vector<Cell_index> result;
    const auto add = [&](Cell_index c) {
      if (m_node_of[c] == OUT && !Cell_complex::is_infinite(m_cells[c])) {
        m_node_of[c] = IN;
        result.push_back(c);
      }
    };
    for (Cell_index c = 0; c != m_cells.size(); ++c) {
      cancellation_point();
      for (std::size_t i = 0; i != 4; ++i)
        if (m_labelling.label(c) && m_labelling.is_surface(c, i) && is_across_passage(c, i)) {
          add(c);
          add(m_cells[c].neighbors[i]);
        }
    }
    std::size_t begin = 0;
    for (int ring = 0; ring != RINGS; ++ring) {
      const std::size_t end = result.size();
      for (; begin != end; ++begin)
        for (Cell_index n : m_cells[result[begin]].neighbors)
          add(n);
    }
    return result;
  }

  bool is_across_passage(Cell_index c, std::size_t i) const
  {
    return m_labelling.smallest_cosine_of_vertices(c, i) < LARGEST_COSINE_OF_VERTICES &&
           m_labelling.faces_by_less_than(SMALLEST_COSINE, c, i);
  }

  // The connected cells get numbers as nodes, in the order in which they and their vertices are in memory.
  void collect_region(Cell_index first)
  {
    m_region.assign(1, first);
    m_node_of[first] = 0;
    for (std::size_t k = 0; k != m_region.size(); ++k)
      for (Cell_index n : m_cells[m_region[k]].neighbors)
        if (m_node_of[n] == IN) {
          m_node_of[n] = 0;
          m_region.push_back(n);
        }
    std::sort(m_region.begin(), m_region.end());
    for (std::size_t k = 0; k != m_region.size(); ++k)
      m_node_of[m_region[k]] = static_cast<std::uint32_t>(k);
  }

  // The cells of the region that the cut labels otherwise, by connected parts.
  template <typename Cancellation_point>
  std::vector<std::vector<Cell_index> > cut(Cancellation_point& cancellation_point)
  {
    const std::vector<unsigned char> is_inside = minimum_cut()(cancellation_point);
    for (std::size_t k = 0; k != m_region.size(); ++k)
      m_node_of[m_region[k]] = (is_inside[k] != 0) != m_labelling.label(m_region[k]) ? IN : OUT;
    return connected_parts();
  }

  // Of the energies of the region: a cell pays for its label and for facets to cells that stay, two cells for the
  // facet between them. What the better of its sides costs, its cells pay by themselves: no cost is negative then,
  // and the search for the cut has to follow arcs in one direction only.
  Minimum_cut minimum_cut() const
  {
    std::vector<float> inside_costs(m_region.size(), 0.f);
    std::vector<Minimum_cut::Pair_cost> pairs;
    pairs.reserve(2 * m_region.size());
    for (std::uint32_t k = 0; k != m_region.size(); ++k) {
      const Cell_index c = m_region[k];
      double total_area = 0., inside_cost = 0.;
      const std::array<Oriented_labelling::Facet_energy, 4> energies = m_labelling.facet_energies(c);
      for (std::size_t i = 0; i != 4; ++i) {
        const Oriented_labelling::Facet_energy& energy = energies[i];
        const Cell_index n = m_cells[c].neighbors[i];
        total_area += energy.area;
        if (m_node_of[n] >= IN) {
          inside_cost += m_labelling.label(n) ? -energy.if_outside : energy.if_inside;
        } else if (m_node_of[n] > k) {
          const bool faces_out = energy.if_inside < energy.if_outside;
          const double own = faces_out ? energy.if_inside : -energy.if_outside;
          inside_cost += own;
          inside_costs[m_node_of[n]] -= float(own);
          pairs.push_back(Minimum_cut::Pair_cost{ faces_out ? m_node_of[n] : k, faces_out ? k : m_node_of[n],
                                                  float(energy.if_inside + energy.if_outside) });
        }
      }
      inside_costs[k] += float(inside_cost + VALUE_SHARE * m_labelling.outside_preference(c, total_area));
    }
    return Minimum_cut(inside_costs, pairs);
  }

  // Of the cells of the region that are IN, which become OUT.
  std::vector<std::vector<Cell_index> > connected_parts()
  {
    std::vector<std::vector<Cell_index> > parts;
    for (Cell_index c : m_region) {
      if (m_node_of[c] != IN)
        continue;
      std::vector<Cell_index> part(1, c);
      m_node_of[c] = OUT;
      for (std::size_t k = 0; k != part.size(); ++k)
        for (Cell_index n : m_cells[part[k]].neighbors)
          if (m_node_of[n] == IN) {
            m_node_of[n] = OUT;
            part.push_back(n);
          }
      parts.push_back(part);
    }
    return parts;
  }

  const Cell_complex& m_cells;
  Oriented_labelling& m_labelling;
  std::vector<std::uint32_t> m_node_of; // number in the region, IN: waits for its region, OUT: stays
  std::vector<Cell_index> m_region;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_MINIMUM_CUT_H

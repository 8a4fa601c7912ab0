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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CELL_LABELLING_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CELL_LABELLING_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <queue>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Two labels for the cells of a Delaunay triangulation. Every facet has a weight, positive if it seems
// to separate inside from outside, negative if both its cells seem to be on one side; the labels
// make the sum of the weights of the facets between different labels large. Which label is the
// outside is left open, so that no seed and no orientation is needed.
class Cell_labelling
{
public:
  using Cell_index = Cell_complex::Cell_index;

  // `weight(cell, i)` is the weight of facet i of the cell; it is called once a facet.
  template <typename Weight>
  Cell_labelling(const Cell_complex& cells, const Weight& weight)
    : Cell_labelling(cells, weight, No_cancellation())
  { }

  // `cancellation_point()` is called again and again and may throw.
  template <typename Weight, typename Cancellation_point>
  Cell_labelling(const Cell_complex& cells, const Weight& weight, Cancellation_point&& cancellation_point)
    : m_cells(cells), m_labels(cells.size(), 0), m_weights(cells.size())
  {
    std::vector<Facet> facets;
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i) {
        const Cell_index n = cells[c].neighbors[i];
        if (n < c)
          continue;
        cancellation_point();
        const double w = weight(c, i);
        m_weights[c][i] = w;
        m_weights[n][index_of(n, c, i)] = w;
        facets.push_back(Facet{ std::abs(w), c, n, w > 0. });
      }
    contract(facets, cancellation_point);
    relax(cancellation_point);
  }

  bool label(Cell_index c) const { return m_labels[c] != 0; }
  void flip(Cell_index c) { m_labels[c] ^= 1; }
  bool is_surface(Cell_index c, std::size_t i) const { return m_labels[c] != m_labels[m_cells[c].neighbors[i]]; }
  double weight(Cell_index c, std::size_t i) const { return m_weights[c][i]; }

  // What the sum of the weights wins if the cell changes its label.
  double gain(Cell_index c) const
  {
    double result = 0.;
    for (std::size_t i = 0; i != 4; ++i)
      result += is_surface(c, i) ? -m_weights[c][i] : m_weights[c][i];
    return result;
  }

  // Changes single cells as long as that wins.
  void relax()
  {
    No_cancellation cancellation_point;
    relax(cancellation_point);
  }

  template <typename Cancellation_point>
  void relax(Cancellation_point& cancellation_point)
  {
    std::priority_queue<Entry> queue;
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      push(queue, c);
    while (!queue.empty()) {
      cancellation_point();
      const Entry entry = queue.top();
      queue.pop();
      if (gain(entry.cell) != entry.gain)
        continue;
      flip(entry.cell);
      for (Cell_index n : m_cells[entry.cell].neighbors)
        push(queue, n);
    }
  }

private:
  struct Facet
  {
    double certainty;
    Cell_index first, second;
    bool is_separating;
  };

  struct Entry
  {
    double gain;
    Cell_index cell;
    bool operator<(const Entry& other) const
    {
      return gain < other.gain || (gain == other.gain && cell > other.cell);
    }
  };

  // Gains below this are rounding errors of sums of weights.
  static constexpr double SMALLEST_GAIN = 1e-9;

  void push(std::priority_queue<Entry>& queue, Cell_index c) const
  {
    const double g = gain(c);
    if (g > SMALLEST_GAIN)
      queue.push(Entry{ g, c });
  }

  // The facet of `cell` towards `neighbor` that is facet i of `neighbor`. Small triangulations may have
  // cells that share two facets.
  std::size_t index_of(Cell_index cell, Cell_index neighbor, std::size_t i) const
  {
    const auto& vertices = m_cells[cell].vertices;
    const auto facet = Cell_complex::facet(m_cells[neighbor], i);
    for (std::size_t j = 0; j != 4; ++j)
      if (m_cells[cell].neighbors[j] == neighbor && std::find(facet.begin(), facet.end(), vertices[j]) == facet.end())
        return j;
    return 0;
  }

  // Follows the facets from the most certain one; a facet that contradicts more certain ones is
  // ignored.
  template <typename Cancellation_point>
  void contract(std::vector<Facet>& facets, Cancellation_point& cancellation_point)
  {
    std::stable_sort(facets.begin(), facets.end(), [&](const Facet& a, const Facet& b) {
      cancellation_point();
      return a.certainty > b.certainty;
    });
    Parity_union_find sides(m_cells.size());
    for (const Facet& f : facets) {
      cancellation_point();
      sides.unite(f.first, f.second, f.is_separating);
    }
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      m_labels[c] = sides.find(c).is_flipped ? 1 : 0;
  }

  const Cell_complex& m_cells;
  std::vector<unsigned char> m_labels;
  std::vector<std::array<double, 4> > m_weights;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CELL_LABELLING_H

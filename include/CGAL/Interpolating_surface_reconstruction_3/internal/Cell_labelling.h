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
#include <CGAL/Interpolating_surface_reconstruction_3/internal/label_relaxation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Two labels for the cells of a Delaunay triangulation. Every facet has a weight, positive if it seems
// to separate inside from outside, negative if both its cells seem to be on one side; the labels
// make the sum of the weights of the facets between different labels large. Which label is the
// outside is left open, so that no seed and no orientation is needed; where one is known, oriented
// energies can take the place of the weights.
class Cell_labelling
{
public:
  using Cell_index = Cell_complex::Cell_index;
  using Oriented_root = Parity_union_find::Oriented_root;

  // All labels are equal.
  explicit Cell_labelling(const Cell_complex& cells)
    : m_cells(cells), m_labels(cells.size(), 0), m_costs(cells.size()), m_preferences(cells.size(), 0.f)
  { }

  // Labels after weights alone.
  template <typename Weight>
  Cell_labelling(const Cell_complex& cells, const Weight& weight) : Cell_labelling(cells)
  {
    set_weights(weight, No_cancellation());
    label_by_weights([](Cell_index, std::size_t) { return std::optional<Oriented_root>(); }, No_cancellation());
  }

  // `weight(cell, i)` is the weight of facet i of the cell; it is called once a facet.
  // `cancellation_point()` is called again and again and may throw.
  template <typename Weight, typename Cancellation_point>
  void set_weights(const Weight& weight, Cancellation_point&& cancellation_point)
  {
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i)
        if (m_cells[c].neighbors[i] >= c) {
          cancellation_point();
          const double w = weight(c, i);
          set_cost(c, i, Cost{ -w, -w });
        }
  }

  // `chart(cell, i)` is the part of the surface that facet i is known to belong to, if any, flipped if the
  // cell lies on its other side: all facets of a part have the same label on the same side.
  template <typename Chart, typename Cancellation_point>
  void label_by_weights(const Chart& chart, Cancellation_point&& cancellation_point)
  {
    Parity_union_find sides(m_cells.size());
    follow_charts(chart, sides, cancellation_point);
    follow_facets(sides, cancellation_point);
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      m_labels[c] = sides.find(c).is_flipped ? 1 : 0;
    relax(cancellation_point);
  }

  bool label(Cell_index c) const { return m_labels[c] != 0; }
  void flip(Cell_index c) { m_labels[c] ^= 1; }
  bool is_surface(Cell_index c, std::size_t i) const { return m_labels[c] != m_labels[m_cells[c].neighbors[i]]; }
  // The weight of the facet, or the mean of its costs the other way round.
  double weight(Cell_index c, std::size_t i) const
  {
    return -(double(m_costs[c][i].if_set) + double(m_costs[c][i].if_clear)) / 2.;
  }

  // What a facet costs between different labels: if its cell has the label, or if its neighbor has it.
  struct Cost
  {
    double if_set, if_clear;
  };

  // Replaces the weights: `cost(cell, i)` is the Cost of facet i, called once a facet, and
  // `preference(cell)` what the label costs the cell.
  template <typename Facet_cost, typename Preference>
  void set_energy(const Facet_cost& cost, const Preference& preference)
  {
    for (Cell_index c = 0; c != m_cells.size(); ++c) {
      m_preferences[c] = static_cast<float>(preference(c));
      for (std::size_t i = 0; i != 4; ++i)
        if (m_cells[c].neighbors[i] >= c)
          set_cost(c, i, cost(c, i));
    }
  }

  static constexpr bool may_gain(Cell_index) { return true; }

  // What is won if the cell changes its label.
  double gain(Cell_index c) const
  {
    double set = double(m_preferences[c]), clear = 0.;
    for (std::size_t i = 0; i != 4; ++i)
      if (label(m_cells[c].neighbors[i]))
        clear += double(m_costs[c][i].if_clear);
      else
        set += double(m_costs[c][i].if_set);
    return label(c) ? set - clear : clear - set;
  }

  // Gains below this are rounding errors of sums of weights. Costs may be far from one: changes that win
  // nothing would go on for ever.
  double smallest_gain(Cell_index c) const
  {
    double total = double(std::abs(m_preferences[c]));
    for (const Stored_cost& cost : m_costs[c])
      total += double(std::abs(cost.if_set)) + double(std::abs(cost.if_clear));
    return (std::max)(1e-9, 16. * std::numeric_limits<double>::epsilon() * total);
  }

  // Changes single cells as long as that wins; returns them.
  std::vector<Cell_index> relax() { return relax(No_cancellation()); }

  template <typename Cancellation_point>
  std::vector<Cell_index> relax(Cancellation_point&& cancellation_point)
  {
    return relax_labels(m_cells, *this, cancellation_point);
  }

private:
  // The costs take most of the memory of a labelling.
  struct Stored_cost
  {
    float if_set, if_clear;
  };

  struct Facet
  {
    float certainty;
    Cell_index cell;
    std::uint32_t index;

    bool operator<(const Facet& other) const
    {
      if (certainty != other.certainty)
        return certainty > other.certainty;
      return cell < other.cell || (cell == other.cell && index < other.index);
    }
  };

  void set_cost(Cell_index c, std::size_t i, const Cost& cost)
  {
    const Stored_cost stored{ static_cast<float>(cost.if_set), static_cast<float>(cost.if_clear) };
    m_costs[c][i] = stored;
    m_costs[m_cells[c].neighbors[i]][m_cells.mirror(c, i)] = Stored_cost{ stored.if_clear, stored.if_set };
  }

  template <typename Chart, typename Cancellation_point>
  void follow_charts(const Chart& chart, Parity_union_find& sides, Cancellation_point& cancellation_point) const
  {
    std::unordered_map<Parity_union_find::Element, Parity_union_find::Element> sides_of_charts;
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i) {
        const Cell_index n = m_cells[c].neighbors[i];
        if (n < c)
          continue;
        cancellation_point();
        if (const std::optional<Oriented_root> side = chart(c, i)) {
          const auto it = sides_of_charts.emplace(side->root, static_cast<Parity_union_find::Element>(sides.size()));
          if (it.second)
            sides.add();
          sides.unite(it.first->second, c, side->is_flipped);
          sides.unite(it.first->second, n, !side->is_flipped);
        }
      }
  }

  // From the most certain facet on; one that contradicts more certain ones is ignored. Those that are most
  // certain, which are many, come without sorting, and leave few to be sorted.
  template <typename Cancellation_point>
  void follow_facets(Parity_union_find& sides, Cancellation_point& cancellation_point) const
  {
    const auto certainty = [&](Cell_index c, std::size_t i) { return std::abs(m_costs[c][i].if_set); };
    float most = 0.f;
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i)
        most = (std::max)(most, certainty(c, i));
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i)
        if (m_cells[c].neighbors[i] >= c && certainty(c, i) == most) {
          cancellation_point();
          follow(c, i, sides);
        }
    std::vector<Facet> facets;
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      for (std::uint32_t i = 0; i != 4; ++i)
        if (m_cells[c].neighbors[i] >= c && certainty(c, i) != most &&
            sides.find(c).root != sides.find(m_cells[c].neighbors[i]).root) {
          cancellation_point();
          facets.push_back(Facet{ certainty(c, i), c, i });
        }
    std::sort(facets.begin(), facets.end());
    for (const Facet& f : facets) {
      cancellation_point();
      follow(f.cell, f.index, sides);
    }
  }

  void follow(Cell_index c, std::size_t i, Parity_union_find& sides) const
  {
    sides.unite(c, m_cells[c].neighbors[i], m_costs[c][i].if_set < 0.f);
  }

  const Cell_complex& m_cells;
  std::vector<unsigned char> m_labels;
  std::vector<std::array<Stored_cost, 4> > m_costs;
  std::vector<float> m_preferences; // against the label
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CELL_LABELLING_H

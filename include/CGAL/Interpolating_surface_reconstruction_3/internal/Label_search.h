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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_SEARCH_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_SEARCH_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Label_chains.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Changes of labels that a search may try: in all, and of these after kicks.
struct Search_effort
{
  std::size_t all, of_kicks;
};

// Lowers the bending energy of the surface between the labels by chains of changes, and where it is folded
// after that, by kicks: a few cells there change at random, chains are followed from around them, and everything is
// taken back unless it wins (Lourenco, Martin and Stuetzle, Iterated local search, 2003).
template <typename Labelling>
class Label_search
{
public:
  using Cell_index = Cell_complex::Cell_index;

  // Only cells with `is_free(c)` change, and chains start from those with `is_seed(c)`, or where one has changed
  // something. Only points with `is_in_scope(p)` must be manifold. Facets with `is_agreed(c, i)` are worth keeping.
  // `cancellation_point()` is called again and again and may throw.
  template <typename IsFree, typename IsSeed, typename IsAgreed, typename IsInScope, typename Cancellation_point>
  Label_search(const Cell_complex& cells, const std::vector<Local_point>& points, Labelling& labelling,
               const IsFree& is_free, const IsSeed& is_seed, const IsAgreed& is_agreed, const IsInScope& is_in_scope,
               Cancellation_point&& cancellation_point)
    : m_cells(cells), m_chains(cells, points, labelling, is_free, is_seed, is_agreed, is_in_scope, cancellation_point)
  { }

  // From now on, lost corners (see Corner_test) with `is_counted(p)` cost as much as points at which the surface is no
  // manifold.
  template <typename IsCounted>
  void count_lost_corners(const IsCounted& is_counted)
  {
    m_chains.energy().count_lost_corners(is_counted);
  }

  // Ends when all of the effort has been spent at the latest, and takes what it spends from it.
  // `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  void operator()(Search_effort& effort, Cancellation_point&& cancellation_point)
  {
    if (!has_fold(cancellation_point))
      return;
    m_chains.set_effort(effort.all);
    Changes changes;
    m_chains.follow(all_cells(), MAXIMUM_CHAIN, changes, cancellation_point);
    const std::size_t left = m_chains.effort(), of_kicks = (std::min)(left, effort.of_kicks);
    m_chains.set_effort(of_kicks);
    kick(cancellation_point);
    const std::size_t spent = of_kicks - m_chains.effort();
    effort.of_kicks -= spent;
    m_chains.set_effort(left - spent);
    restore_agreed_facets(cancellation_point);
    effort.all = m_chains.effort();
  }

  // What it costs, in defects, to change the free ones of the cells together and then to follow chains from around them.
  // Nothing stays changed. Takes what it spends from the effort.
  template <typename Cancellation_point>
  double cost_together(const std::vector<Cell_index>& cells, std::size_t& effort,
                       Cancellation_point&& cancellation_point)
  {
    Changes changes;
    const double result = change_together(cells, effort, changes, cancellation_point);
    m_chains.take_back(changes, 0);
    return result;
  }

  // The same, but if it costs less than the maximum, what was changed stays so; returns whether it does.
  template <typename Cancellation_point>
  bool change_together(const std::vector<Cell_index>& cells, double maximum_cost, std::size_t& effort,
                       Cancellation_point&& cancellation_point)
  {
    Changes changes;
    const bool is_cheap = change_together(cells, effort, changes, cancellation_point) < maximum_cost;
    if (!is_cheap)
      m_chains.take_back(changes, 0);
    return is_cheap;
  }

private:
  using Changes = typename Label_chains<Labelling>::Changes;
  using Change = typename Label_chains<Labelling>::Change;

  // The most cells across a handle.
  static constexpr std::size_t MAXIMUM_CHAIN = 40;

  // The most cells that a kick changes.
  static constexpr std::size_t MAXIMUM_KICK = 6;

  static constexpr double ROUNDING = 1e-9;

  // A right angle, and one that right angles do not come near.
  static constexpr double SHARP_BENDING = 1.57079632679489661923, FOLD = 2.09439510239319549231;

  std::vector<Cell_index> all_cells() const
  {
    std::vector<Cell_index> result(m_cells.size());
    std::iota(result.begin(), result.end(), Cell_index(0));
    return result;
  }

  // Wrong handles and bridges have sharp edges somewhere. Most conflicts are no more than diagonals.
  template <typename Cancellation_point>
  bool has_fold(Cancellation_point& cancellation_point)
  {
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      if (m_chains.is_awake(c) && m_chains.is_at_surface(c)) {
        cancellation_point();
        if (m_chains.energy().bends_more_than(SHARP_BENDING, c))
          return true;
      }
    return false;
  }

  bool is_folded(Cell_index c)
  {
    return m_chains.is_free(c) && m_chains.is_at_surface(c) && m_chains.energy().cost_of_defect(c) > 0. &&
           m_chains.energy().bends_more_than(FOLD, c);
  }

  // Ends when as many kicks as there are folded cells were in vain, one after the other.
  template <typename Cancellation_point>
  void kick(Cancellation_point& cancellation_point)
  {
    std::vector<Cell_index> folded;
    for (Cell_index c = 0; c != m_cells.size() && m_chains.effort() != 0; ++c) {
      cancellation_point();
      if (is_folded(c))
        folded.push_back(c);
    }
    std::vector<Cell_index> changed;
    for (std::size_t in_vain = 0; m_chains.effort() != 0 && in_vain < folded.size(); ++in_vain) {
      cancellation_point();
      const std::size_t k = random(folded.size());
      if (!is_folded(folded[k])) {
        folded[k] = folded.back();
        folded.pop_back();
      } else if (kick_at(folded[k], changed, cancellation_point)) {
        in_vain = 0;
        std::copy_if(changed.begin(), changed.end(), std::back_inserter(folded),
                     [&](Cell_index c) { return is_folded(c); });
      }
    }
  }

  // Returns whether the energy is lower then; if so, tells which cells have changed.
  template <typename Cancellation_point>
  bool kick_at(Cell_index c, std::vector<Cell_index>& changed, Cancellation_point& cancellation_point)
  {
    const double scale = m_chains.energy().cost_of_defect(c);
    Changes changes;
    double cost = change_at_random(c, changes);
    std::vector<Cell_index> starts;
    m_chains.wake_around(changes, starts);
    cost += m_chains.follow(std::move(starts), MAXIMUM_CHAIN, changes, cancellation_point);
    find_changed(changes, changed);
    if (cost < -ROUNDING * scale && !changed.empty() && !m_chains.is_small_part_at(changed))
      return true;
    m_chains.take_back(changes, 0);
    return false;
  }

  // Changes the cell and some more at the surface, each beside one of them; returns what that costs.
  double change_at_random(Cell_index c, Changes& changes)
  {
    double cost = 0.;
    for (std::size_t left = 1 + random(MAXIMUM_KICK); left != 0; --left) {
      const bool is_new =
        std::none_of(changes.begin(), changes.end(), [c](const Change& change) { return change.cell == c; });
      if (is_new && m_chains.is_free(c) && m_chains.is_at_surface(c)) {
        cost += m_chains.cost_of_change(c);
        changes.push_back(Change{ c, m_chains.energy().change(c) });
      }
      c = m_cells[changes[random(changes.size())].cell].neighbors[random(4)];
    }
    return cost;
  }

  // The cells that have changed an odd number of times.
  static void find_changed(const Changes& changes, std::vector<Cell_index>& changed)
  {
    std::vector<Cell_index> cells = Label_chains<Labelling>::cells_of(changes);
    std::sort(cells.begin(), cells.end());
    changed.clear();
    for (auto it = cells.begin(); it != cells.end();) {
      const auto end = std::upper_bound(it, cells.end(), *it);
      if ((end - it) % 2 != 0)
        changed.push_back(*it);
      it = end;
    }
  }

  // Where the surface bends little either way, as along the diagonals of nearly flat quadrangles, the stars know
  // better.
  template <typename Cancellation_point>
  void restore_agreed_facets(Cancellation_point& cancellation_point)
  {
    m_chains.energy().set_worth_of_agreement(1.);
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      if (m_chains.is_free(c))
        m_chains.set_awake(c, m_chains.energy().has_lost_agreed_facet(c));
    Changes changes;
    m_chains.follow(all_cells(), 1, changes, cancellation_point);
  }

  // Returns what that costs in the largest defects of the cells; infinite if none is free.
  template <typename Cancellation_point>
  double change_together(const std::vector<Cell_index>& cells, std::size_t& effort, Changes& changes,
                         Cancellation_point& cancellation_point)
  {
    m_chains.set_effort(effort);
    double cost = 0., defect = 0.;
    for (Cell_index c : cells)
      if (m_chains.is_free(c)) {
        cancellation_point();
        cost += m_chains.cost_of_change(c);
        defect = (std::max)(defect, m_chains.energy().cost_of_defect(c));
        changes.push_back(Change{ c, m_chains.energy().change(c) });
      }
    std::vector<Cell_index> starts;
    m_chains.wake_around(changes, starts);
    cost += m_chains.follow(std::move(starts), MAXIMUM_CHAIN, changes, cancellation_point);
    effort = m_chains.effort();
    return defect > 0. ? cost / defect : std::numeric_limits<double>::infinity();
  }

  // Less than n; the same in every run and on every machine.
  std::size_t random(std::size_t n) { return static_cast<std::size_t>(m_random() % n); }

  const Cell_complex& m_cells;
  Label_chains<Labelling> m_chains;
  std::minstd_rand m_random;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_SEARCH_H

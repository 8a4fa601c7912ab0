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

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Bending_energy.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Small_surface_part.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Lowers the bending energy of the surface between the labels by chains of changes: from a cell at the
// surface, the neighbor whose change costs least is changed next, even at a loss, and the chain is cut
// where the energy is lowest (Kernighan and Lin, An efficient heuristic procedure for partitioning graphs,
// 1970). No single change opens or closes a handle without a loss.
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
    : m_cells(cells), m_labelling(labelling),
      m_energy(cells, points, labelling, is_agreed, is_in_scope, cancellation_point),
      m_has_small_part(cells, labelling, m_energy.stars()), m_state(cells.size(), State::FIXED),
      m_chain_of(cells.size(), 0)
  {
    for (Cell_index c = 0; c != cells.size(); ++c) {
      cancellation_point();
      if (!Cell_complex::is_infinite(cells[c]) && is_free(c) && m_energy.has_no_hub(c))
        m_state[c] = is_seed(c) ? State::AWAKE : State::ASLEEP;
    }
  }

  // Ends at the latest when `effort` changes have been tried, and takes those tried from it.
  // `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  void operator()(std::size_t& effort, Cancellation_point&& cancellation_point)
  {
    m_effort = effort;
    if (!has_fold(cancellation_point))
      return;
    follow_chains(MAXIMUM_CHAIN, cancellation_point);
    restore_agreed_facets(cancellation_point);
    effort = m_effort;
  }

private:
  // Changes win less and less.
  static constexpr std::size_t MAXIMUM_ROUNDS = 5;

  // The most cells across a handle.
  static constexpr std::size_t MAXIMUM_CHAIN = 40;

  // A longer way after the best place seldom leads to a better one.
  static constexpr std::size_t LINKS_AFTER_BEST = 10;

  // What the first change and what all together may lose, in defects.
  static constexpr double FIRST_LOSS = 2., MAXIMUM_LOSS = 6.;

  static constexpr double ROUNDING = 1e-9;

  // A right angle.
  static constexpr double SHARP_BENDING = 1.57079632679489661923;

  static constexpr std::size_t MICROSECONDS_PER_CHAIN = 256;

  // Free cells sleep until something changes around them, and again as soon as they were in a chain that led to
  // nothing: the chains from all of its cells are mostly the same.
  enum class State : unsigned char
  {
    FIXED,
    AWAKE,
    ASLEEP
  };

  // A cell, and what its change costs.
  struct Link
  {
    Cell_index cell;
    double cost;
    bool operator<(const Link& other) const { return cost < other.cost || (cost == other.cost && cell < other.cell); }
  };

  // Wrong handles and bridges have sharp edges somewhere. Most conflicts are no more than diagonals.
  template <typename Cancellation_point>
  bool has_fold(Cancellation_point& cancellation_point)
  {
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      if (m_state[c] == State::AWAKE && is_at_surface(c)) {
        cancellation_point();
        if (m_energy.bends_more_than(SHARP_BENDING, c))
          return true;
      }
    return false;
  }

  template <typename Cancellation_point>
  void follow_chains(std::size_t maximum_length, Cancellation_point& cancellation_point)
  {
    for (std::size_t round = 0; round != MAXIMUM_ROUNDS && m_effort != 0; ++round)
      for (const Link& seed : find_seeds(cancellation_point)) {
        cancellation_point(MICROSECONDS_PER_CHAIN);
        if (m_effort != 0 && m_state[seed.cell] == State::AWAKE && is_at_surface(seed.cell) &&
            follow_chain(seed.cell, maximum_length))
          wake();
      }
  }

  // Where the surface bends little either way, as along the diagonals of nearly flat quadrangles, the stars know
  // better.
  template <typename Cancellation_point>
  void restore_agreed_facets(Cancellation_point& cancellation_point)
  {
    m_energy.set_worth_of_agreement(1.);
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      if (m_state[c] != State::FIXED)
        m_state[c] = m_energy.has_lost_agreed_facet(c) ? State::AWAKE : State::ASLEEP;
    follow_chains(1, cancellation_point);
  }

  bool is_at_surface(Cell_index c) const
  {
    for (std::size_t i = 0; i != 4; ++i)
      if (m_labelling.is_surface(c, i))
        return true;
    return false;
  }

  double cost_of_change(Cell_index c)
  {
    m_effort -= m_effort != 0 ? 1 : 0;
    return m_energy.cost_of_change(c);
  }

  // The cells at the surface that are awake, the best first; others fall asleep.
  template <typename Cancellation_point>
  std::vector<Link> find_seeds(Cancellation_point& cancellation_point)
  {
    std::vector<Link> seeds;
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      if (m_state[c] == State::AWAKE) {
        cancellation_point();
        if (is_at_surface(c))
          seeds.push_back(Link{ c, cost_of_change(c) });
        else
          m_state[c] = State::ASLEEP;
      }
    std::sort(seeds.begin(), seeds.end());
    return seeds;
  }

  // Makes the changes of the best chain from the cell; returns whether there are any. A chain that cuts a
  // small component off is none: that is what bends least around a few points.
  bool follow_chain(Cell_index seed, std::size_t maximum_length)
  {
    ++m_chain;
    m_links.clear();
    m_defects_before.clear();
    m_candidates.clear();
    const double scale = m_energy.cost_of_defect(seed);
    double cost = cost_of_change(seed), least = -ROUNDING * scale;
    m_state[seed] = State::ASLEEP;
    if (cost > FIRST_LOSS * scale)
      return false;
    std::size_t best = 0;
    for (Cell_index c = seed; cost <= MAXIMUM_LOSS * scale; c = take_best_candidate(cost)) {
      add_link(c);
      if (cost < least) {
        least = cost;
        best = m_links.size();
      }
      const bool is_after_best = best != 0 && m_links.size() >= best + LINKS_AFTER_BEST;
      if (m_candidates.empty() || m_links.size() == maximum_length || is_after_best)
        break;
    }
    if (best == 0)
      put_links_asleep();
    cut_chain(best);
    if (best > 1 && m_has_small_part(m_links))
      cut_chain(0);
    return !m_links.empty();
  }

  // Changes the cell; its neighbors become candidates.
  void add_link(Cell_index c)
  {
    m_defects_before.push_back(m_energy.change(c));
    m_links.push_back(c);
    m_chain_of[c] = m_chain;
    for (Link& candidate : m_candidates)
      if (share_edge(candidate.cell, c))
        candidate.cost = cost_of_change(candidate.cell);
    for (Cell_index n : m_cells[c].neighbors)
      if (m_state[n] != State::FIXED && m_chain_of[n] != m_chain) {
        m_chain_of[n] = m_chain;
        m_candidates.push_back(Link{ n, cost_of_change(n) });
      }
  }

  bool share_edge(Cell_index c, Cell_index d) const
  {
    int shared = 0;
    for (Point_index p : m_cells[c].vertices)
      for (Point_index q : m_cells[d].vertices)
        shared += p == q ? 1 : 0;
    return shared >= 2;
  }

  // Adds what the change of the candidate costs to `cost`; what it cost when it was tried may be out of date.
  Cell_index take_best_candidate(double& cost)
  {
    const auto best = std::min_element(m_candidates.begin(), m_candidates.end());
    const Cell_index result = best->cell;
    *best = m_candidates.back();
    m_candidates.pop_back();
    cost += cost_of_change(result);
    return result;
  }

  // Takes the changes from the given one on back.
  void cut_chain(std::size_t length)
  {
    for (; m_links.size() > length; m_links.pop_back(), m_defects_before.pop_back())
      m_energy.change_back(m_links.back(), m_defects_before.back());
  }

  void put_links_asleep()
  {
    for (Cell_index c : m_links)
      m_state[c] = State::ASLEEP;
  }

  void wake()
  {
    for (Cell_index c : m_links)
      for (Point_index p : m_cells[c].vertices)
        m_energy.stars().for_each_cell(m_cells.position(p), c, [&](Cell_index n) {
          if (m_state[n] != State::FIXED)
            m_state[n] = State::AWAKE;
        });
  }

  const Cell_complex& m_cells;
  Labelling& m_labelling;
  Bending_energy<Labelling> m_energy;
  Small_surface_part<Labelling> m_has_small_part;
  std::size_t m_effort = 0;              // that is left
  std::vector<State> m_state;            // of each cell
  std::vector<std::uint32_t> m_chain_of; // of each cell: the last chain that came to it
  std::uint32_t m_chain = 0;
  std::vector<Cell_index> m_links;                                           // of the current chain
  std::vector<typename Bending_energy<Labelling>::Defects> m_defects_before; // at each link
  std::vector<Link> m_candidates;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_SEARCH_H

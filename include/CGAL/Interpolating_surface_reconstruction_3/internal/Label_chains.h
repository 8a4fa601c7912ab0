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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_CHAINS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_CHAINS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Bending_energy.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Small_surface_part.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Chains of changes of labels that lower the bending energy of the surface between the labels: from a cell at the
// surface, the neighbor whose change costs least is changed next, even at a loss, and the chain is cut
// where the energy is lowest (Kernighan and Lin, An efficient heuristic procedure for partitioning graphs,
// 1970). No single change opens or closes a handle without a loss.
template <typename Labelling>
class Label_chains
{
public:
  using Cell_index = Cell_complex::Cell_index;
  using Energy = Bending_energy<Labelling>;

  // A change of the label of a cell, and what takes it back.
  struct Change
  {
    Cell_index cell;
    typename Energy::Defects before;
  };
  using Changes = std::vector<Change>;

  static std::vector<Cell_index> cells_of(const Changes& changes)
  {
    std::vector<Cell_index> result(changes.size());
    std::transform(changes.begin(), changes.end(), result.begin(), [](const Change& change) { return change.cell; });
    return result;
  }

  // The parameters are those of Label_search.
  template <typename IsFree, typename IsSeed, typename IsAgreed, typename IsInScope, typename Cancellation_point>
  Label_chains(const Cell_complex& cells, const std::vector<Local_point>& points, Labelling& labelling,
               const IsFree& is_free, const IsSeed& is_seed, const IsAgreed& is_agreed, const IsInScope& is_in_scope,
               Cancellation_point&& cancellation_point)
    : m_cells(cells), m_labelling(labelling), m_state(states(cells, is_free, is_seed, cancellation_point)),
      m_energy(
        cells, points, labelling, [&](Cell_index c) { return m_state[c] != State::FIXED; }, is_agreed, is_in_scope,
        cancellation_point),
      m_has_small_part(cells, labelling, m_energy.stars()), m_chain_of(cells.size(), 0), m_waking_of(cells.size(), 0),
      m_last_wakings(cells.points().size(), 0)
  {
    for (Cell_index c = 0; c != cells.size(); ++c)
      if (m_state[c] != State::FIXED && !m_energy.has_no_hub(c))
        m_state[c] = State::FIXED;
  }

  Energy& energy() { return m_energy; }

  // Changes of labels that may still be tried.
  std::size_t effort() const { return m_effort; }
  void set_effort(std::size_t effort) { m_effort = effort; }

  bool is_free(Cell_index c) const { return m_state[c] != State::FIXED; }
  bool is_awake(Cell_index c) const { return m_state[c] == State::AWAKE; }
  void set_awake(Cell_index c, bool is_awake) { m_state[c] = is_awake ? State::AWAKE : State::ASLEEP; }

  bool is_at_surface(Cell_index c) const
  {
    for (std::size_t i = 0; i != 4; ++i)
      if (m_labelling.is_surface(c, i))
        return true;
    return false;
  }

  // Of a free cell; takes some of the effort.
  double cost_of_change(Cell_index c)
  {
    m_effort -= m_effort != 0 ? 1 : 0;
    return m_energy.cost_of_change(c);
  }

  // Whether one of the components of the surface at the cells is small.
  bool is_small_part_at(const std::vector<Cell_index>& cells) { return m_has_small_part(cells); }

  // Follows chains from the distinct cells that are awake and at the surface, the best first, and then from those around
  // their changes, again and again. What has been changed is added to `changes`. Returns by how much the energy has
  // grown.
  template <typename Cancellation_point>
  double follow(std::vector<Cell_index> starts, std::size_t maximum_length, Changes& changes,
                Cancellation_point&& cancellation_point)
  {
    double result = 0.;
    for (std::size_t round = 0; round != MAXIMUM_ROUNDS && !starts.empty() && m_effort != 0; ++round) {
      std::sort(starts.begin(), starts.end());
      const std::vector<Link> seeds = find_seeds(starts, cancellation_point);
      starts.clear();
      for (const Link& seed : seeds) {
        cancellation_point(MICROSECONDS_PER_CHAIN);
        if (m_effort == 0 || !is_awake(seed.cell) || !is_at_surface(seed.cell))
          continue;
        result += follow_chain(seed.cell, maximum_length);
        changes.insert(changes.end(), m_links.begin(), m_links.end());
        wake_around(m_links, starts);
      }
    }
    return result;
  }

  // Wakes the free cells at the vertices of changed cells and adds them to `woken`, unless they have been added since
  // that was empty.
  void wake_around(const Changes& changes, std::vector<Cell_index>& woken)
  {
    ++m_waking;
    if (woken.empty())
      m_first_waking = m_waking;
    for (const Change& change : changes)
      for (Point_index p : m_cells[change.cell].vertices) {
        const std::size_t v = m_cells.position(p);
        if (m_last_wakings[v] == m_waking)
          continue;
        m_last_wakings[v] = m_waking;
        m_energy.stars().for_each_cell(v, [&](Cell_index c) { wake(c, woken); });
      }
  }

  // Takes back the changes from the given one on; none came after them.
  void take_back(Changes& changes, std::size_t first)
  {
    for (; changes.size() > first; changes.pop_back())
      m_energy.change_back(changes.back().cell, changes.back().before);
  }

private:
  // Changes win less and less.
  static constexpr std::size_t MAXIMUM_ROUNDS = 5;

  // A longer way after the best place seldom leads to a better one.
  static constexpr std::size_t LINKS_AFTER_BEST = 10;

  // What the first change and what all together may lose, in defects.
  static constexpr double FIRST_LOSS = 2., MAXIMUM_LOSS = 6.;

  static constexpr double ROUNDING = 1e-9;

  static constexpr std::size_t MICROSECONDS_PER_CHAIN = 256;

  // Free cells sleep until something changes around them, and again as soon as they were in a chain that led to
  // nothing: the chains from all of its cells are mostly the same.
  enum class State : unsigned char
  {
    FIXED,
    AWAKE,
    ASLEEP
  };

  // Hubs are still to be found.
  template <typename IsFree, typename IsSeed, typename Cancellation_point>
  static std::vector<State> states(const Cell_complex& cells, const IsFree& is_free, const IsSeed& is_seed,
                                   Cancellation_point& cancellation_point)
  {
    std::vector<State> result(cells.size(), State::FIXED);
    for (Cell_index c = 0; c != cells.size(); ++c) {
      cancellation_point();
      if (!Cell_complex::is_infinite(cells[c]) && is_free(c))
        result[c] = is_seed(c) ? State::AWAKE : State::ASLEEP;
    }
    return result;
  }

  // A cell, and what its change costs.
  struct Link
  {
    Cell_index cell;
    double cost;
    bool operator<(const Link& other) const { return cost < other.cost || (cost == other.cost && cell < other.cell); }
  };

  void wake(Cell_index c, std::vector<Cell_index>& woken)
  {
    if (!is_free(c))
      return;
    m_state[c] = State::AWAKE;
    if (m_waking_of[c] < m_first_waking)
      woken.push_back(c);
    m_waking_of[c] = m_waking;
  }

  // The cells at the surface that are awake, the best first; others fall asleep.
  template <typename Cancellation_point>
  std::vector<Link> find_seeds(const std::vector<Cell_index>& starts, Cancellation_point& cancellation_point)
  {
    std::vector<Link> seeds;
    for (Cell_index c : starts)
      if (is_awake(c)) {
        cancellation_point();
        if (is_at_surface(c))
          seeds.push_back(Link{ c, cost_of_change(c) });
        else
          m_state[c] = State::ASLEEP;
      }
    std::sort(seeds.begin(), seeds.end());
    return seeds;
  }

  // Makes the changes of the best chain from the cell, if there are any: they are in m_links then. Returns by how
  // much the energy has grown. A chain that cuts a small component off is none: that is what bends least around a
  // few points.
  double follow_chain(Cell_index seed, std::size_t maximum_length)
  {
    ++m_chain;
    m_links.clear();
    m_candidates.clear();
    const double scale = m_energy.cost_of_defect(seed);
    double cost = cost_of_change(seed), least = -ROUNDING * scale;
    m_state[seed] = State::ASLEEP;
    if (cost > FIRST_LOSS * scale)
      return 0.;
    std::size_t best = 0;
    for (Cell_index c = seed; cost <= MAXIMUM_LOSS * scale; c = take_best_candidate(cost)) {
      m_links.push_back(Change{ c, m_energy.change(c) });
      if (cost < least) {
        least = cost;
        best = m_links.size();
      }
      const bool is_after_best = best != 0 && m_links.size() >= best + LINKS_AFTER_BEST;
      if (m_links.size() == maximum_length || is_after_best)
        break;
      find_candidates_after(c);
      if (m_candidates.empty())
        break;
    }
    if (best == 0)
      for (const Change& link : m_links)
        m_state[link.cell] = State::ASLEEP;
    take_back(m_links, best);
    if (best > 1 && is_small_part_at(cells_of(m_links)))
      take_back(m_links, 0);
    return m_links.empty() ? 0. : least;
  }

  // The neighbors of the cell that has changed last become candidates, and what others cost changes.
  void find_candidates_after(Cell_index c)
  {
    m_chain_of[c] = m_chain;
    for (Link& candidate : m_candidates)
      if (share_edge(candidate.cell, c))
        candidate.cost = cost_of_change(candidate.cell);
    for (Cell_index n : m_cells[c].neighbors)
      if (is_free(n) && m_chain_of[n] != m_chain) {
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

  const Cell_complex& m_cells;
  Labelling& m_labelling;
  std::vector<State> m_state; // of each cell
  Energy m_energy;
  Small_surface_part<Labelling> m_has_small_part;
  std::size_t m_effort = 0;              // that is left
  std::vector<std::uint32_t> m_chain_of; // of each cell: the last chain that came to it
  std::uint32_t m_chain = 0;
  std::vector<std::uint32_t> m_waking_of, m_last_wakings; // of each cell and of each vertex: the last one
  std::uint32_t m_waking = 0, m_first_waking = 0;         // now, and when the list of woken cells began
  Changes m_links;                                        // of the current chain
  std::vector<Link> m_candidates;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_CHAINS_H

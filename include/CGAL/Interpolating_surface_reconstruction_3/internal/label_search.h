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

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>
#include <iostream>

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

  // Only cells with `is_free(c)` change, and only points with `is_in_scope(p)` must be manifold.
  template <typename IsFree, typename IsSeed, typename IsInScope>
  Label_search(const Cell_complex& cells, const std::vector<Local_point>& points, Labelling& labelling,
               const IsFree& is_free, const IsSeed& is_seed, const IsInScope& is_in_scope)
    : m_cells(cells), m_labelling(labelling), m_energy(cells, points, labelling, is_in_scope),
      m_state(cells.size(), State::FIXED), m_chain_of(cells.size(), 0)
  {
    for (Cell_index c = 0; c != cells.size(); ++c)
      if (!Cell_complex::is_infinite(cells[c]) && is_free(c))
        m_state[c] = is_seed(c) ? State::SEED : State::ASLEEP;
  }

  ~Label_search() { if (getenv("VERB")) std::cerr << "evals " << m_energy.evals << " cells " << m_cells.size() << "\n"; }
  // `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  void operator()(std::size_t& budget, Cancellation_point&& cancellation_point)
  {
    struct Payer { std::size_t& b; Bending_energy<Labelling>& e; ~Payer() { b -= (std::min)(b, e.evals); } } payer{ budget, m_energy };
    static const double first_loss = getenv("FIRST") ? atof(getenv("FIRST")) : 0.;
    for (std::size_t round = 0; round != MAXIMUM_ROUNDS; ++round) {
      const std::vector<Link> seeds = find_seeds(cancellation_point);
      if (seeds.empty())
        return;
      for (const Link& seed : seeds) {
        cancellation_point(MICROSECONDS_PER_CHAIN);
        if (m_energy.evals > budget) return;
        if (is_at_surface(seed.cell) && (!first_loss || m_energy.cost_of_change(seed.cell) <= first_loss * m_energy.scale(seed.cell)) && search(seed.cell))
          wake();
      }
    }
  }

private:
  // Changes win less and less.
  inline static std::size_t MAXIMUM_ROUNDS = getenv("ROUNDS")?atoi(getenv("ROUNDS")):5;

  // The most cells of a handle between sheets.
  inline static std::size_t MAXIMUM_CHAIN = getenv("CHAIN")?atoi(getenv("CHAIN")):40;

  // A longer way over the best place is not worth while.
  static constexpr std::size_t LINKS_BEHIND_BEST = 10;

  // Defects that a chain may have in between.
  inline static double MAXIMUM_LOSS = getenv("LOSS")?atof(getenv("LOSS")):6.;

  static constexpr std::size_t MICROSECONDS_PER_CHAIN = 256;

  enum class State : unsigned char
  {
    FIXED,
    SEED,
    ASLEEP
  };

  // A cell, and what its change costs.
  struct Link
  {
    Cell_index cell;
    double cost;
    bool operator<(const Link& other) const { return cost < other.cost || (cost == other.cost && cell < other.cell); }
  };

  bool is_at_surface(Cell_index c) const
  {
    for (std::size_t i = 0; i != 4; ++i)
      if (m_labelling.is_surface(c, i))
        return true;
    return false;
  }

  // Cells at the surface around which something has changed, the best first.
  template <typename Cancellation_point>
  std::vector<Link> find_seeds(Cancellation_point& cancellation_point)
  {
    std::vector<Link> seeds;
    for (Cell_index c = 0; c != m_cells.size(); ++c)
      if (m_state[c] == State::SEED) {
        cancellation_point();
        m_state[c] = State::ASLEEP;
        static const double TAU = getenv("TAU") ? atof(getenv("TAU")) * 3.14159265 / 180. : 0.;
        if (is_at_surface(c) && (TAU == 0. || m_energy.bending(c) > TAU))
          seeds.push_back(Link{ c, m_energy.cost_of_change(c) });
      }
    std::sort(seeds.begin(), seeds.end());
    return seeds;
  }

  // Finds the best chain from the cell and makes its changes; returns whether there are any.
  bool search(Cell_index seed)
  {
    ++m_chain;
    m_links.clear();
    m_candidates.clear();
    const double scale = m_energy.scale(seed);
    double cost = m_energy.cost_of_change(seed), least = -1e-9 * scale;
    std::size_t best = 0;
    for (Cell_index c = seed; cost <= MAXIMUM_LOSS * scale; ) {
      add_link(c);
      if (cost < least) {
        least = cost;
        best = m_links.size();
      }
      const bool is_behind_best = best != 0 && m_links.size() >= best + LINKS_BEHIND_BEST;
      if (m_candidates.empty() || m_links.size() == MAXIMUM_CHAIN || is_behind_best)
        break;
      c = take_best_candidate(cost);
    }
    for (std::size_t k = m_links.size(); k > best; --k)
      m_energy.change(m_links[k - 1]);
    m_links.resize(best);
    if (best != 0 && m_energy.has_split(m_links)) {
      for (std::size_t k = best; k != 0; --k)
        m_energy.change(m_links[k - 1]);
      m_links.clear();
      return false;
    }
    return best != 0;
  }

  // The costs of candidates may be out of date.
  Cell_index take_best_candidate(double& cost)
  {
    for (int tries = 0;; ++tries) {
      const auto next = std::min_element(m_candidates.begin(), m_candidates.end());
      const Link best = *next;
      *next = m_candidates.back();
      m_candidates.pop_back();
      const double now = m_energy.cost_of_change(best.cell);
      static const int TRIES = getenv("TRIES") ? atoi(getenv("TRIES")) : 0;
      if (now <= best.cost || tries >= TRIES || m_candidates.empty()) {
        cost += now;
        return best.cell;
      }
      m_candidates.push_back(Link{ best.cell, now });
    }
  }

  // Changes the cell; its neighbors become candidates.
  void add_link(Cell_index c)
  {
    m_energy.change(c);
    m_links.push_back(c);
    m_chain_of[c] = m_chain;
    for (Link& candidate : m_candidates)
      if (share_edge(candidate.cell, c))
        candidate.cost = m_energy.cost_of_change(candidate.cell);
    for (Cell_index n : m_cells[c].neighbors)
      if (m_state[n] != State::FIXED && m_chain_of[n] != m_chain) {
        m_chain_of[n] = m_chain;
        m_candidates.push_back(Link{ n, m_energy.cost_of_change(n) });
      }
  }

  bool share_edge(Cell_index c, Cell_index d) const
  {
    int shared = 0;
    for (Point_index p : m_cells[c].vertices)
      for (Point_index q : m_cells[d].vertices)
        shared += p == q ? 1 : 0;
    static const int SH = getenv("SH") ? atoi(getenv("SH")) : 2;
    return shared >= SH;
  }

  // What lies around changed cells may change again.
  void wake()
  {
    for (Cell_index c : m_links)
      for (Point_index p : m_cells[c].vertices)
        m_energy.for_each_cell_at(p, c, [&](Cell_index n) {
          if (m_state[n] == State::ASLEEP)
            m_state[n] = State::SEED;
        });
  }

  const Cell_complex& m_cells;
  Labelling& m_labelling;
  Bending_energy<Labelling> m_energy;
  std::vector<State> m_state;            // of each cell
  std::vector<std::uint32_t> m_chain_of; // of each cell: the last chain that came to it
  std::uint32_t m_chain = 0;
  std::vector<Cell_index> m_links; // of the current chain
  std::vector<Link> m_candidates;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_SEARCH_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABELLING_REPAIR_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABELLING_REPAIR_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Label_defects.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Surface_fans.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/label_components.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Changes labels of cells until the surface between the labels is a manifold through all points of a
// scope. At a point, the surface is a manifold if the cells of each label around the point are
// connected by facets at the point and there are cells of both labels. Hubs are left out but for the last step.
template <typename Labelling>
class Labelling_repair : private Label_defects<Labelling>
{
  using Base = Label_defects<Labelling>;
  using Base::change_by_one_cell;
  using Base::count_components;
  using Base::count_defects;
  using Base::find_moves;
  using Base::find_touched;
  using Base::flip;
  using Base::gain;
  using Base::is_at_surface;
  using Base::is_better;
  using Base::m_cells;
  using Base::m_counts_points_left_out;
  using Base::m_defects;
  using Base::m_hubs;
  using Base::m_is_counted;
  using Base::m_labelling;
  using Base::m_moves;
  using Base::m_stars;
  using Base::m_touched;
  using Base::move_of;
  using Base::update_defects;
  using typename Base::Hub;
  using typename Base::Move;

public:
  using Cell_index = Cell_complex::Cell_index;

  // `is_in_scope(p)` tells the points that matter. No change loses more than `maximum_loss`. Points off
  // the surface may get one of their own unless `keeps_components`.
  template <typename IsInScope>
  Labelling_repair(const Cell_complex& cells, Labelling& labelling, const IsInScope& is_in_scope, double maximum_loss,
                   bool keeps_components = false)
    : Labelling_repair(cells, labelling, is_in_scope, maximum_loss, keeps_components, No_cancellation())
  { }

  // `cancellation_point()` is called again and again and may throw.
  template <typename IsInScope, typename Cancellation_point>
  Labelling_repair(const Cell_complex& cells, Labelling& labelling, const IsInScope& is_in_scope, double maximum_loss,
                   bool keeps_components, Cancellation_point&& cancellation_point)
    : Base(cells, labelling, is_in_scope, cancellation_point), m_maximum_loss(maximum_loss),
      m_keeps_components(keeps_components)
  { }

  // Returns the number of points but hubs at which the surface is no manifold in the end.
  std::size_t operator()() { return (*this)(No_cancellation()); }

  // `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  std::size_t operator()(Cancellation_point&& cancellation_point)
  {
    std::vector<std::size_t> todo;
    const Surface_fans fans(m_cells, m_labelling, cancellation_point);
    for (std::size_t v = m_is_counted.size(); v-- != 0;) {
      cancellation_point();
      m_defects[v] = m_is_counted[v] == 0 || fans.is_closed(v) ? 0 : count_defects(v);
      if (m_defects[v] != 0)
        todo.push_back(v);
    }
    repair(std::move(todo), cancellation_point);
    return m_defects.size() - static_cast<std::size_t>(std::count(m_defects.begin(), m_defects.end(), 0));
  }

  // To be called after operator() when cells have changed since, each of them as often as it is in the list, to repair
  // what that broke.
  template <typename Cancellation_point>
  void again(const std::vector<Cell_index>& changed, double maximum_loss, Cancellation_point&& cancellation_point)
  {
    m_maximum_loss = maximum_loss;
    for (Cell_index c : changed)
      m_stars.flip(c);
    update_defects(changed);
    repair(m_touched, cancellation_point);
  }

  // To be called after operator(), if label 1 is the inside and infinite cells have label 0: makes
  // the surface a manifold at all points of the scope that it still passes through, whatever it
  // loses. `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  void enforce(Cancellation_point&& cancellation_point)
  {
    std::vector<unsigned char> changes(m_defects.size(), 0);
    std::vector<std::size_t> todo;
    for (std::size_t v = 0; v != m_defects.size(); ++v)
      if (m_defects[v] != 0)
        todo.push_back(v);
    while (!todo.empty() || enforce_at_hubs(todo)) {
      if (todo.empty())
        continue;
      const std::size_t v = todo.back();
      todo.pop_back();
      cancellation_point(MICROSECONDS_PER_MOVE);
      if (count_components(v) <= 2)
        continue;
      // From some time on, cells only become inside, which ends with the convex hull.
      flip(cells_to_change(v, changes[v]));
      if (changes[v] != FREE_CHANGES)
        ++changes[v];
      update_defects(m_best.cells);
      add_touched_defects(todo);
    }
  }

  // To be called after operator(), before enforce(): where moves one by one do not help, sequences of moves are tried
  // that lead over surfaces with as many defects, or more; last, points may be left out for that.
  // `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  void untangle(Cancellation_point&& cancellation_point)
  {
    for (const bool may_leave_out : { false, true }) {
      std::vector<std::size_t> todo;
      for (std::size_t v = m_defects.size(); v-- != 0;)
        if (m_defects[v] != 0) {
          if (count_components(v) > 2)
            todo.push_back(v);
          else if (may_leave_out)
            m_defects[v] = 0;
        }
      m_counts_points_left_out = !may_leave_out;
      while (!todo.empty()) {
        const std::size_t v = todo.back();
        todo.pop_back();
        if (m_defects[v] == 0 || count_components(v) <= 2 || !untangle_at(v, cancellation_point))
          continue;
        todo.push_back(v);
        add_touched_defects(todo);
      }
    }
  }

  // To be called after operator(): changes the cells together and repairs what that breaks; takes
  // it all back if defects remain that were not there before. `cancellation_point()` is called
  // again and again and may throw.
  template <typename Cancellation_point>
  void change_unless_worse(std::vector<Cell_index> cells, Cancellation_point&& cancellation_point)
  {
    flip(cells);
    int change = update_defects(cells);
    std::vector<std::size_t> todo = m_touched;
    while (!todo.empty()) {
      const std::size_t v = todo.back();
      todo.pop_back();
      cancellation_point(MICROSECONDS_PER_MOVE);
      if (m_defects[v] == 0 || !improve(v))
        continue;
      change += m_best.defects;
      cells.insert(cells.end(), m_best.cells.begin(), m_best.cells.end());
      todo.insert(todo.end(), m_touched.begin(), m_touched.end());
    }
    if (change > 0) {
      flip(cells);
      update_defects(cells);
    }
  }

private:
  static constexpr unsigned char FREE_CHANGES = 12;

  // Moves one after the other.
  static constexpr std::size_t MAXIMUM_SEQUENCE = 32;

  static constexpr std::size_t MICROSECONDS_PER_MOVE = 128;

  template <typename Cancellation_point>
  void repair(std::vector<std::size_t> todo, Cancellation_point& cancellation_point)
  {
    while (!todo.empty()) {
      const std::size_t v = todo.back();
      todo.pop_back();
      cancellation_point(MICROSECONDS_PER_MOVE);
      if (m_defects[v] != 0 && improve(v))
        add_touched_defects(todo);
    }
  }

  void add_touched_defects(std::vector<std::size_t>& todo) const
  {
    std::copy_if(m_touched.begin(), m_touched.end(), std::back_inserter(todo),
                 [&](std::size_t v) { return m_defects[v] != 0; });
  }

  // Makes the best of the moves at vertex v that lessen the defects; false if there is none. The
  // moves change all cells of a component around v, or one of its cells.
  bool improve(std::size_t v)
  {
    m_best.cells.clear();
    const std::size_t components = find_moves(v);
    for (std::size_t k = 0; k != m_moves.size(); ++k)
      try_move(v, m_moves[k], k < components ? change_at(v, m_moves[k]) : change_by_one_cell(components));
    if (m_best.cells.empty())
      return false;
    flip(m_best.cells);
    m_touched = m_best_touched;
    for (std::size_t k = 0; k != m_touched.size(); ++k)
      m_defects[m_touched[k]] = m_best_defects[k];
    return true;
  }

  // By how many defects there are more at v if the cells change.
  int change_at(std::size_t v, const std::vector<Cell_index>& cells)
  {
    flip(cells);
    const int change = count_defects(v) - m_defects[v];
    flip(cells);
    return change;
  }

  // Makes a move at v and goes on with the best moves at what it breaks, without changing a cell twice, until there are
  // fewer defects than before; tries the next move at v if that is not soon. Returns false if none helps.
  template <typename Cancellation_point>
  bool untangle_at(std::size_t v, Cancellation_point& cancellation_point)
  {
    std::vector<Cell_index> changed;
    for (const Move& first : new_moves_at(v, changed)) {
      std::optional<Move> move = first;
      int change = 0;
      for (std::size_t step = 0; move && step != MAXIMUM_SEQUENCE; ++step) {
        cancellation_point(MICROSECONDS_PER_MOVE);
        flip(move->cells);
        update_defects(move->cells);
        changed.insert(changed.end(), move->cells.begin(), move->cells.end());
        change += move->defects;
        if (change < 0)
          return true;
        const std::size_t worst =
          *std::max_element(m_touched.begin(), m_touched.end(),
                            [&](std::size_t w, std::size_t x) { return m_defects[w] < m_defects[x]; });
        std::vector<Move> moves;
        if (m_defects[worst] != 0)
          moves = new_moves_at(worst, changed);
        move = moves.empty() ? std::nullopt : std::optional<Move>(std::move(moves.front()));
      }
      flip(changed);
      update_defects(changed);
      changed.clear();
    }
    return false;
  }

  // The moves at v without changed cells: first those that leave the fewest defects, and of these, those that win most.
  std::vector<Move> new_moves_at(std::size_t v, const std::vector<Cell_index>& changed)
  {
    std::vector<Move> result;
    find_moves(v);
    for (std::size_t k = 0; k != m_moves.size(); ++k) {
      std::vector<Cell_index>& cells = m_moves[k];
      const bool is_new = std::none_of(cells.begin(), cells.end(), [&](Cell_index c) {
        return Cell_complex::is_infinite(m_cells[c]) || std::find(changed.begin(), changed.end(), c) != changed.end();
      });
      if (!is_new || (m_keeps_components && !is_at_surface(cells)))
        continue;
      result.push_back(move_of(std::move(cells)));
    }
    std::stable_sort(result.begin(), result.end(), is_better);
    return result;
  }

  // Remembers the move if it lessens the defects at v and in all, and is better than the best so far. Those at v become
  // by `change_at_v` more.
  void try_move(std::size_t v, const std::vector<Cell_index>& cells, int change_at_v)
  {
    if (change_at_v >= 0 || (m_keeps_components && !is_at_surface(cells)))
      return;
    const double g = gain(cells);
    if (!(g > -m_maximum_loss))
      return;
    // Not worse than the best so far.
    const int maximum_change = m_best.cells.empty() ? -1 : g > m_best.gain ? m_best.defects : m_best.defects - 1;
    find_touched(cells);
    flip(cells);
    const std::optional<int> change = change_of_defects(v, change_at_v, maximum_change);
    flip(cells);
    if (!change)
      return;
    m_best.cells = cells;
    m_best.defects = *change;
    m_best.gain = g;
    m_best_touched = m_touched;
    m_best_defects = m_new_defects;
  }

  // By how many defects there are more at the touched vertices, if not more than `maximum`; m_new_defects then has those
  // at each of them.
  std::optional<int> change_of_defects(std::size_t v, int change_at_v, int maximum)
  {
    // What the vertices may still lessen.
    int reserve = -m_defects[v];
    for (std::size_t w : m_touched)
      reserve += m_defects[w];
    int change = change_at_v;
    m_new_defects.clear();
    for (std::size_t w : m_touched) {
      if (change - reserve > maximum)
        return std::nullopt;
      m_new_defects.push_back(w == v ? m_defects[v] + change_at_v : count_defects(w));
      if (w == v)
        continue;
      reserve -= m_defects[w];
      change += m_new_defects.back() - m_defects[w];
    }
    return change <= maximum ? std::optional<int>(change) : std::nullopt;
  }

  // What to change at v, which has been changed some times: finite cells of one of the moves there, or all with one label,
  // which takes v off the surface. At first those that leave the fewest defects, lest these spread, then the next best,
  // lest neighboring points go on to undo what they did; in the end only the best with label 0. count_components() has
  // counted more than two.
  const std::vector<Cell_index>& cells_to_change(std::size_t v, unsigned char changes)
  {
    const bool is_filling = changes == FREE_CHANGES;
    std::vector<Move> moves;
    std::array<std::vector<Cell_index>, 2> with_label;
    const std::size_t components = find_moves(v);
    for (std::size_t k = 0; k != m_moves.size(); ++k) {
      std::vector<Cell_index>& cells = m_moves[k];
      const bool label = m_labelling.label(cells.front());
      cells.erase(
        std::remove_if(cells.begin(), cells.end(), [&](Cell_index c) { return Cell_complex::is_infinite(m_cells[c]); }),
        cells.end());
      if (cells.empty() || (is_filling && label))
        continue;
      std::vector<Cell_index>& all = with_label[label ? 1 : 0];
      if (k < components)
        all.insert(all.end(), cells.begin(), cells.end());
      moves.push_back(move_of(std::move(cells)));
    }
    for (std::vector<Cell_index>& cells : with_label)
      if (!cells.empty())
        moves.push_back(move_of(std::move(cells)));
    std::stable_sort(moves.begin(), moves.end(), is_better);
    m_best = moves.empty() ? Move{ {}, 0, 0. } : std::move(moves[is_filling ? 0 : changes % moves.size()]);
    return m_best.cells;
  }

  // Changes all components around each hub but the largest of each label, from some time on only to the
  // inside, and adds the vertices to `todo`; returns whether there
  // was a change.
  bool enforce_at_hubs(std::vector<std::size_t>& todo)
  {
    bool is_changed = false;
    if (m_hubs.empty())
      return is_changed;
    Label_components<Labelling> components_at_hub(m_cells, m_labelling);
    for (Hub& hub : m_hubs) {
      const std::size_t number = components_at_hub.find(m_cells.points()[hub.vertex], hub.cell);
      if (number <= 2)
        continue;
      const std::vector<std::vector<Cell_index> > components = components_at_hub.sorted(number);
      const std::vector<Cell_index> cells = beside_largest(components, hub.changes == FREE_CHANGES);
      if (hub.changes != FREE_CHANGES)
        ++hub.changes;
      is_changed = true;
      flip(cells);
      update_defects(cells);
      add_touched_defects(todo);
    }
    return is_changed;
  }

  // The finite cells of all components but the largest of each label; all with label 0 if
  // `is_filling`.
  std::vector<Cell_index> beside_largest(const std::vector<std::vector<Cell_index> >& components, bool is_filling) const
  {
    std::array<std::size_t, 2> largest{ { components.size(), components.size() } };
    for (std::size_t k = 0; k != components.size(); ++k) {
      const std::size_t label = m_labelling.label(components[k].front()) ? 1 : 0;
      if (largest[label] == components.size() || components[k].size() > components[largest[label]].size())
        largest[label] = k;
    }
    std::vector<Cell_index> result;
    for (std::size_t k = 0; k != components.size(); ++k) {
      const std::size_t label = m_labelling.label(components[k].front()) ? 1 : 0;
      if (is_filling ? label == 1 : k == largest[label])
        continue;
      for (Cell_index c : components[k])
        if (!Cell_complex::is_infinite(m_cells[c]))
          result.push_back(c);
    }
    return result;
  }

  double m_maximum_loss;
  bool m_keeps_components;
  Move m_best;
  std::vector<std::size_t> m_best_touched;        // by the best move
  std::vector<int> m_best_defects, m_new_defects; // at touched vertices, after the best move and the last one
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABELLING_REPAIR_H

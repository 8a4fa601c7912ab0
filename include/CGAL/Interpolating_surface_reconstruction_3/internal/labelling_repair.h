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
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>


#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Changes labels of cells until the surface between the labels is a manifold through all points of a
// scope. At a point, the surface is a manifold if the cells of each label around the point are
// connected by facets at the point and there are cells of both labels.
class Labelling_repair
{
public:
  using Cell_index = Cell_complex::Cell_index;

  // `is_in_scope(p)` tells the points that matter. No change loses more than `maximum_loss`.
  template <typename IsInScope>
  Labelling_repair(const Cell_complex& cells, Cell_labelling& labelling, const IsInScope& is_in_scope, double maximum_loss)
    : Labelling_repair(cells, labelling, is_in_scope, maximum_loss, No_cancellation())
  { }

  // `cancellation_point()` is called again and again and may throw.
  template <typename IsInScope, typename Cancellation_point>
  Labelling_repair(const Cell_complex& cells, Cell_labelling& labelling, const IsInScope& is_in_scope, double maximum_loss,
                   Cancellation_point&& cancellation_point)
    : m_cells(cells), m_labelling(labelling), m_maximum_loss(maximum_loss), m_position(cells.size(), 0)
  {
    collect_vertices(is_in_scope, cancellation_point);
  }

  // Returns the number of points at which the surface is no manifold in the end.
  std::size_t operator()()
  {
    return (*this)(No_cancellation());
  }

  // `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  std::size_t operator()(Cancellation_point&& cancellation_point)
  {
    m_defects.resize(m_points.size());
    std::vector<std::size_t> todo;
    for (std::size_t v = m_points.size(); v-- != 0; ) {
      cancellation_point();
      m_defects[v] = count_defects(v);
      if (m_defects[v] != 0)
        todo.push_back(v);
    }
    while (!todo.empty()) {
      const std::size_t v = todo.back();
      todo.pop_back();
      cancellation_point(MICROSECONDS_PER_MOVE);
      if (m_defects[v] == 0 || !improve(v))
        continue;
      for (std::size_t w : m_touched)
        if (m_defects[w] != 0)
          todo.push_back(w);
    }
    return m_points.size() - static_cast<std::size_t>(std::count(m_defects.begin(), m_defects.end(), 0));
  }

private:
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);

  // A point has 27 cells in a random sample. One that has far more, such as the tip of a cone over a line
  // of points, is left as it is: the moves at a point take time quadratic in its cells.
  static constexpr std::size_t MAXIMUM_CELLS_AT_POINT = 256;

  static constexpr std::size_t MICROSECONDS_PER_MOVE = 128;

  // Cells to change together, and what that brings.
  struct Move
  {
    std::vector<Cell_index> cells;
    int defects;
    double gain;
  };

  template <typename IsInScope, typename Cancellation_point>
  void collect_vertices(const IsInScope& is_in_scope, Cancellation_point& cancellation_point)
  {
    for (std::size_t c = 0; c != m_cells.size(); ++c) {
      cancellation_point();
      for (Point_index p : m_cells[c].vertices)
        if (p != NO_POINT && is_in_scope(p))
          m_points.push_back(p);
    }
    std::sort(m_points.begin(), m_points.end(), [&](Point_index p, Point_index q) {
      cancellation_point();
      return p < q;
    });
    keep_points_of_few_cells();
    m_begin.assign(m_points.size() + 1, 0);
    m_cell_vertices.resize(m_cells.size());
    for (std::size_t c = 0; c != m_cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i) {
        cancellation_point();
        const auto it = std::lower_bound(m_points.begin(), m_points.end(), m_cells[c].vertices[i]);
        const bool is_found = it != m_points.end() && *it == m_cells[c].vertices[i];
        m_cell_vertices[c][i] = is_found ? std::size_t(it - m_points.begin()) : NONE;
        if (is_found)
          ++m_begin[m_cell_vertices[c][i] + 1];
      }
    for (std::size_t v = 0; v != m_points.size(); ++v)
      m_begin[v + 1] += m_begin[v];
    m_around.resize(m_begin.back());
    std::vector<std::size_t> next(m_begin.begin(), m_begin.end() - 1);
    for (std::size_t c = 0; c != m_cells.size(); ++c)
      for (std::size_t v : m_cell_vertices[c])
        if (v != NONE)
          m_around[next[v]++] = static_cast<Cell_index>(c);
  }

  // `m_points` has every point once for each of its cells, and then once if it stays.
  void keep_points_of_few_cells()
  {
    std::size_t kept = 0;
    for (std::size_t begin = 0, end = 0; begin != m_points.size(); begin = end) {
      while (end != m_points.size() && m_points[end] == m_points[begin])
        ++end;
      if (end - begin <= MAXIMUM_CELLS_AT_POINT)
        m_points[kept++] = m_points[begin];
    }
    m_points.resize(kept);
  }

  // Finds the components of equal labels around vertex v: m_component[k] for the k-th cell around it.
  std::size_t find_components(std::size_t v)
  {
    const std::size_t size = m_begin[v + 1] - m_begin[v];
    m_component.assign(size, NONE);
    for (std::size_t k = 0; k != size; ++k)
      m_position[m_around[m_begin[v] + k]] = k;
    std::size_t components = 0;
    for (std::size_t k = 0; k != size; ++k) {
      if (m_component[k] != NONE)
        continue;
      m_component[k] = components;
      m_stack.assign(1, k);
      while (!m_stack.empty()) {
        const Cell_index c = m_around[m_begin[v] + m_stack.back()];
        m_stack.pop_back();
        for (std::size_t i = 0; i != 4; ++i) {
          if (m_cell_vertices[c][i] == v)
            continue;
          const Cell_index n = m_cells[c].neighbors[i];
          const std::size_t position = m_position[n];
          if (m_component[position] == NONE && m_labelling.label(n) == m_labelling.label(c)) {
            m_component[position] = components;
            m_stack.push_back(position);
          }
        }
      }
      ++components;
    }
    return components;
  }

  // How far the surface is from a manifold at vertex v: 0 if there is one component of each label.
  int count_defects(std::size_t v)
  {
    const int components = static_cast<int>(find_components(v));
    return components == 1 ? 1 : components - 2;
  }

  // Makes the best of the moves at vertex v that lessen the defects; false if there is none. The
  // moves change all cells of a component around v, or one of its cells.
  bool improve(std::size_t v)
  {
    m_best = Move{ {}, 0, 0. };
    const std::size_t components = find_components(v);
    const std::size_t size = m_begin[v + 1] - m_begin[v];
    std::vector<std::vector<Cell_index> > moves(components);
    for (std::size_t k = 0; k != size; ++k)
      moves[m_component[k]].push_back(m_around[m_begin[v] + k]);
    for (std::size_t k = 0; k != size; ++k)
      if (moves[m_component[k]].size() > 1)
        moves.push_back({ m_around[m_begin[v] + k] });
    for (const std::vector<Cell_index>& cells : moves)
      try_move(v, cells);
    if (m_best.cells.empty())
      return false;
    flip(m_best.cells);
    find_touched(m_best.cells);
    for (std::size_t w : m_touched)
      m_defects[w] = count_defects(w);
    return true;
  }

  void flip(const std::vector<Cell_index>& cells)
  {
    for (Cell_index c : cells)
      m_labelling.flip(c);
  }

  // The vertices of the cells that are in the scope.
  void find_touched(const std::vector<Cell_index>& cells)
  {
    m_touched.clear();
    for (Cell_index c : cells)
      for (std::size_t w : m_cell_vertices[c])
        if (w != NONE)
          m_touched.push_back(w);
    std::sort(m_touched.begin(), m_touched.end());
    m_touched.erase(std::unique(m_touched.begin(), m_touched.end()), m_touched.end());
  }

  // Remembers the move if it lessens the defects at v and in all, and is better than the best so far.
  void try_move(std::size_t v, const std::vector<Cell_index>& cells)
  {
    double gain = 0.;
    for (Cell_index c : cells) {
      gain += m_labelling.gain(c);
      m_labelling.flip(c);
    }
    if (gain > -m_maximum_loss && count_defects(v) < m_defects[v]) {
      find_touched(cells);
      int change = 0;
      for (std::size_t w : m_touched)
        change += count_defects(w) - m_defects[w];
      if (change < 0 && (m_best.cells.empty() || change < m_best.defects || (change == m_best.defects && gain > m_best.gain)))
        m_best = Move{ cells, change, gain };
    }
    flip(cells);
  }

  const Cell_complex& m_cells;
  Cell_labelling& m_labelling;
  double m_maximum_loss;
  std::vector<Point_index> m_points;                            // of the scope, increasing
  std::vector<std::size_t> m_begin;                             // cells around each point, in m_around
  std::vector<Cell_index> m_around;
  std::vector<std::array<std::size_t, 4> > m_cell_vertices;     // positions in m_points, or NONE
  std::vector<std::size_t> m_position, m_component, m_stack, m_touched;
  std::vector<int> m_defects;                                   // of each point of the scope
  Move m_best;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABELLING_REPAIR_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_DEFECTS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_DEFECTS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Label_stars.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/label_components.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// How far the surface between labels of cells is from a manifold at each point of a scope, and how labels change there.
// Hubs, points of very many cells as the tip of a cone over a line, would take the square of these: they are set aside.
template <typename Labelling>
class Label_defects
{
protected:
  using Cell_index = Cell_complex::Cell_index;

  // A vertex with very many cells, one of them, and how often they were changed.
  struct Hub
  {
    std::size_t vertex;
    Cell_index cell;
    unsigned char changes;
  };

  // Cells to change together, how many more defects that makes, and what it wins.
  struct Move
  {
    std::vector<Cell_index> cells;
    int defects;
    double gain;
  };

  static bool is_better(const Move& a, const Move& b)
  {
    return a.defects < b.defects || (a.defects == b.defects && a.gain > b.gain);
  }

  // Lists that keep their memory when they are cleared.
  class Cell_lists
  {
  public:
    void clear() { m_size = 0; }

    std::vector<Cell_index>& add()
    {
      if (m_size == m_lists.size())
        m_lists.emplace_back();
      m_lists[m_size].clear();
      return m_lists[m_size++];
    }

    std::size_t size() const { return m_size; }
    std::vector<Cell_index>& operator[](std::size_t k) { return m_lists[k]; }

  private:
    std::vector<std::vector<Cell_index> > m_lists;
    std::size_t m_size = 0;
  };

  template <typename IsInScope, typename Cancellation_point>
  Label_defects(const Cell_complex& cells, Labelling& labelling, const IsInScope& is_in_scope,
                Cancellation_point& cancellation_point)
    : m_cells(cells), m_labelling(labelling), m_is_counted(cells.points().size(), 0),
      m_defects(cells.points().size(), 0), m_stars(cells, labelling)
  {
    for (std::size_t v = 0; v != m_is_counted.size(); ++v) {
      cancellation_point();
      if (!m_stars.has_cells(v) || !is_in_scope(cells.points()[v]))
        continue;
      if (m_stars.is_hub(v))
        m_hubs.push_back(Hub{ v, m_stars.first_cell(v), 0 });
      else
        m_is_counted[v] = 1;
    }
  }

  std::size_t position_of(Point_index p) const { return m_cells.position(p); }

  std::size_t count_components(std::size_t v) { return m_stars.count_components(v); }

  // How far the surface is from a manifold at the vertex: 0 if there is one component of each label.
  int count_defects(std::size_t v)
  {
    const auto components = static_cast<int>(count_components(v));
    return components == 1 ? (m_counts_points_left_out ? 1 : 0) : components - 2;
  }

  // Sets m_moves to the cells to change together that may lessen the defects at vertex v: first each component around it,
  // then single cells. Returns the number of components.
  std::size_t find_moves(std::size_t v)
  {
    const std::size_t components = m_stars.find_components(v);
    m_moves.clear();
    for (std::size_t i = 0; i != components; ++i)
      m_moves.add();
    for (std::size_t k = 0; k != m_stars.size(); ++k)
      m_moves[m_stars.component(k)].push_back(m_stars.cell(k));
    for (std::size_t k = 0; k != m_stars.size(); ++k)
      if (m_moves[m_stars.component(k)].size() > 1 && (components == 1 || m_stars.is_between(k)))
        m_moves.add().push_back(m_stars.cell(k));
    return components;
  }

  // By how many defects there are more at a vertex if one of the single cells found there changes. It joins two of the
  // components, and has one neighbor in its own: that stays in one piece. Or it becomes the second one.
  int change_by_one_cell(std::size_t components) const { return components == 1 && !m_counts_points_left_out ? 0 : -1; }

  void flip(const std::vector<Cell_index>& cells)
  {
    for (Cell_index c : cells) {
      m_labelling.flip(c);
      m_stars.flip(c);
    }
  }

  bool is_at_surface(const std::vector<Cell_index>& cells) const
  {
    for (Cell_index c : cells)
      for (std::size_t i = 0; i != 4; ++i)
        if (m_labelling.is_surface(c, i))
          return true;
    return false;
  }

  // What the sum of the weights wins if all the cells change.
  double gain(const std::vector<Cell_index>& cells)
  {
    double result = 0.;
    for (Cell_index c : cells) {
      result += m_labelling.gain(c);
      m_labelling.flip(c);
    }
    for (Cell_index c : cells)
      m_labelling.flip(c);
    return result;
  }

  // The vertices of the cells that are in the scope.
  void find_touched(const std::vector<Cell_index>& cells)
  {
    m_touched.clear();
    for (Cell_index c : cells)
      for (Point_index p : m_cells[c].vertices)
        if (p != NO_POINT)
          touch(position_of(p));
    std::sort(m_touched.begin(), m_touched.end());
    for (std::size_t v : m_touched)
      m_is_counted[v] = 1;
  }

  // Many cells share a vertex: it counts as seen until all of them have been looked at.
  void touch(std::size_t v)
  {
    if (m_is_counted[v] == 0)
      return;
    m_is_counted[v] = 0;
    m_touched.push_back(v);
  }

  // The cells as a move; nothing stays changed.
  Move move_of(std::vector<Cell_index> cells)
  {
    const double g = gain(cells);
    flip(cells);
    find_touched(cells);
    int defects = 0;
    for (std::size_t v : m_touched)
      defects += count_defects(v) - m_defects[v];
    flip(cells);
    return Move{ std::move(cells), defects, g };
  }

  // Counts the defects at the vertices of cells that have changed; returns by how many there are more.
  int update_defects(const std::vector<Cell_index>& cells)
  {
    int change = 0;
    find_touched(cells);
    for (std::size_t v : m_touched) {
      const int defects = count_defects(v);
      change += defects - m_defects[v];
      m_defects[v] = defects;
    }
    return change;
  }

  const Cell_complex& m_cells;
  Labelling& m_labelling;
  bool m_counts_points_left_out = true;
  std::vector<unsigned char> m_is_counted; // of each point: whether it is in the scope and no hub
  std::vector<Hub> m_hubs;
  std::vector<int> m_defects; // of each point, 0 out of the scope
  Label_stars<Labelling> m_stars;
  Cell_lists m_moves;                 // those found last
  std::vector<std::size_t> m_touched; // by the cells that were looked at last
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_DEFECTS_H

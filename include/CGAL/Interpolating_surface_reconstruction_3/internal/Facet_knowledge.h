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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACET_KNOWLEDGE_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACET_KNOWLEDGE_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Local_surface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// What the surface around conflicts says about the facets of the cells there. Of an infinite facet it says
// that it bounds the convex hull of the sites, or nothing, because points beyond the sites are unknown.
template <typename Builder>
class Facet_knowledge
{
public:
  using Cell_index = Cell_complex::Cell_index;
  using Facet = std::array<Point_index, 3>;

  Facet_knowledge(const Local_surface<Builder>& surface, std::size_t number_of_points)
    : m_surface(surface), m_is_certain(number_of_points, 0), m_facets_at(number_of_points, 0)
  { }

  // `cancellation_point()` is called again and again and may throw.
  template <typename Cancellation_point>
  void gather(const Cell_complex& cells, Cancellation_point& cancellation_point)
  {
    m_knowledge.assign(cells.size(), { { Knowledge::NONE, Knowledge::NONE, Knowledge::NONE, Knowledge::NONE } });
    find_triangles(cells, cancellation_point);
    find_certain_sites(cells, cancellation_point);
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i) {
        cancellation_point();
        if (cells[c].neighbors[i] >= c && m_knowledge[c][i] == Knowledge::NONE)
          learn(cells, c, i, knowledge_beside_triangles(Cell_complex::facet(cells[c], i)));
      }
  }

  bool is_on_surface(Cell_index c, std::size_t i) const { return m_knowledge[c][i] == Knowledge::ON_SURFACE; }

  // Whether a facet is on the surface, or not, or does not matter; empty if nothing is known.
  std::optional<double> certainty(Cell_index c, std::size_t i) const
  {
    const Knowledge knowledge = m_knowledge[c][i];
    if (knowledge == Knowledge::NONE)
      return std::nullopt;
    return knowledge == Knowledge::ON_SURFACE ? 1. : knowledge == Knowledge::OFF_SURFACE ? -1. : 0.;
  }

  // Whether of no facet of the cell it is known that it is on the surface or that it is not.
  bool is_undecided(Cell_index c) const
  {
    return std::all_of(m_knowledge[c].begin(), m_knowledge[c].end(),
                       [](Knowledge k) { return k == Knowledge::NONE || k == Knowledge::IRRELEVANT; });
  }

  // The connected part of the surface that the facet belongs to, flipped if the cell lies behind it.
  std::optional<Parity_union_find::Oriented_root> chart(const Cell_complex& cells, Cell_index c, std::size_t i) const
  {
    if (!is_on_surface(c, i))
      return std::nullopt;
    const Facet f = Cell_complex::facet(cells[c], i);
    auto result = m_surface.orientation(f);
    if (result && i % 2 == 0)
      result->is_flipped = !result->is_flipped;
    return result;
  }

  // Whether the cells show all of the surface at the point: it is in conflict, or its fan consists of facets.
  bool is_in_scope(Point_index p) const { return p != NO_POINT && (m_surface.is_conflict(p) || m_is_certain[p] != 0); }

private:
  using Triangle = typename Builder::Triangle;

  enum class Knowledge : unsigned char
  {
    NONE,
    ON_SURFACE,
    OFF_SURFACE,
    IRRELEVANT
  };

  void learn(const Cell_complex& cells, Cell_index c, std::size_t i, Knowledge knowledge)
  {
    m_knowledge[c][i] = m_knowledge[cells[c].neighbors[i]][cells.mirror(c, i)] = knowledge;
  }

  Knowledge knowledge_beside_triangles(const Facet& f) const
  {
    if (!Cell_complex::is_infinite(f))
      return m_is_certain[f[0]] || m_is_certain[f[1]] || m_is_certain[f[2]] ? Knowledge::OFF_SURFACE : Knowledge::NONE;
    return is_in_scope(f[0]) || is_in_scope(f[1]) || is_in_scope(f[2]) ? Knowledge::OFF_SURFACE : Knowledge::IRRELEVANT;
  }

  template <typename Cancellation_point>
  void find_triangles(const Cell_complex& cells, Cancellation_point& cancellation_point)
  {
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i) {
        cancellation_point();
        const Facet f = Cell_complex::facet(cells[c], i);
        if (cells[c].neighbors[i] >= c && !Cell_complex::is_infinite(f) && m_surface.has_triangle(f))
          learn(cells, c, i, Knowledge::ON_SURFACE);
      }
  }

  // A site is certain if its fan is closed and made of facets of the cells.
  template <typename Cancellation_point>
  void find_certain_sites(const Cell_complex& cells, Cancellation_point& cancellation_point)
  {
    for (Point_index p : cells.points())
      m_facets_at[p] = 0;
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i) {
        cancellation_point();
        if (cells[c].neighbors[i] >= c && m_knowledge[c][i] == Knowledge::ON_SURFACE)
          for (Point_index p : Cell_complex::facet(cells[c], i))
            ++m_facets_at[p];
      }
    for (Point_index p : cells.points()) {
      m_is_certain[p] = 0;
      if (m_surface.is_conflict(p) || !m_surface.is_complete(p))
        continue;
      std::uint32_t triangles = 0;
      m_surface.for_each_triangle_at(p, [&](const Triangle&) { ++triangles; });
      m_is_certain[p] = m_facets_at[p] == triangles ? 1 : 0;
    }
  }

  const Local_surface<Builder>& m_surface;
  std::vector<unsigned char> m_is_certain;            // of each site
  std::vector<std::uint32_t> m_facets_at;             // of each site
  std::vector<std::array<Knowledge, 4> > m_knowledge; // of the facets of each cell
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACET_KNOWLEDGE_H

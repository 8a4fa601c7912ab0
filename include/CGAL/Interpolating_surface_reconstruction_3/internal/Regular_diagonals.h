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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_REGULAR_DIAGONALS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_REGULAR_DIAGONALS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_measures.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// A labelling for relax_labels() that changes the diagonals of quadrangles. The label of a flat cell with two facets on
// the surface decides between the diagonals of its four points, which are nearly cocircular. Where the energy of the
// labelling makes little difference, circles decide as they do for stars (Star_diagonals): of the two pairs of triangles
// the one wins whose larger circle is smaller. Changes keep the surface a manifold.
class Regular_diagonals
{
public:
  using Cell_index = Cell_complex::Cell_index;

  Regular_diagonals(const Cell_complex& cells, const std::vector<Local_point>& positions, Oriented_labelling& labelling)
    : m_cells(cells), m_positions(positions), m_labelling(labelling)
  { }

  static constexpr bool may_gain(Cell_index) { return true; }

  // By which share the square of the larger circle of the cell becomes smaller; 0 if its label had better stay.
  double gain(Cell_index c) const
  {
    std::array<double, 2> diameters{ { 0., 0. } }; // squared, of the facets off the surface and on it
    std::array<std::size_t, 4> facets;             // first those off the surface
    std::size_t off = 0, on = 0;
    for (std::size_t i = 0; i != 4; ++i)
      facets[m_labelling.is_surface(c, i) ? 3 - on++ : off++] = i;
    if (on != 2 || Cell_complex::is_infinite(m_cells[c]))
      return 0.;
    for (std::size_t k = 0; k != 4; ++k)
      diameters[k / 2] = (std::max)(diameters[k / 2], squared_diameter(Cell_complex::facet(m_cells[c], facets[k])));
    // The facets off the surface are opposite to the ends of the present diagonal: they share the other one.
    if (!(diameters[0] < diameters[1]) || -m_labelling.gain(c) > SMALL_SHARE * m_labelling.area(c) ||
        is_edge_of_surface(c, facets[2], facets[3]))
      return 0.;
    return 1. - diameters[0] / diameters[1];
  }

  // Diagonals of a square are equally good.
  static constexpr double smallest_gain(Cell_index) { return ROUNDING; }

  void flip(Cell_index c) { m_labelling.flip(c); }

private:
  // Of the area of the facets of a cell. Measured: with twice as much, more meshes have the diagonals of their originals,
  // but creases are hurt.
  static constexpr double SMALL_SHARE = .1;

  static constexpr double ROUNDING = 1e-9;

  double squared_diameter(const std::array<Point_index, 3>& f) const
  {
    return squared_circumdiameter(m_positions[f[0]], m_positions[f[1]], m_positions[f[2]]);
  }

  // Whether the surface meets the edge between vertices i and j of the cell. The facets of the cell there are off the
  // surface.
  bool is_edge_of_surface(Cell_index c, std::size_t i, std::size_t j) const
  {
    const Point_index p = m_cells[c].vertices[i], q = m_cells[c].vertices[j];
    std::size_t exit = 0;
    while (exit == i || exit == j)
      ++exit;
    Point_index apex = m_cells[c].vertices[6 - i - j - exit]; // the indices of a cell add up to 6
    for (Cell_index current = m_cells[c].neighbors[exit]; current != c;) {
      if (m_labelling.label(current) != m_labelling.label(c))
        return true;
      const auto& vertices = m_cells[current].vertices;
      const auto k = static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), apex) - vertices.begin());
      apex ^= p ^ q ^ vertices[0] ^ vertices[1] ^ vertices[2] ^ vertices[3]; // the fourth vertex
      current = m_cells[current].neighbors[k];
    }
    return false;
  }

  const Cell_complex& m_cells;
  const std::vector<Local_point>& m_positions;
  Oriented_labelling& m_labelling;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_REGULAR_DIAGONALS_H

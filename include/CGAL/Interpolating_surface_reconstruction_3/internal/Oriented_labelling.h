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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ORIENTED_LABELLING_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ORIENTED_LABELLING_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Inside and outside labels for the cells of a Delaunay triangulation whose vertices have normals.
// The labels follow the signs of a function, and the surface between them has an energy: its area less the flux of
// the normals through it (Kolmogorov and Boykov, What metrics can be approximated by geo-cuts, or global
// optimization of length/area and flux, 2005), and for each cell labelled against its sign the area of its facets
// times the absolute value of the function.
class Oriented_labelling
{
public:
  using Cell_index = Cell_complex::Cell_index;

  // `values` are negative inside; unit normals point outside.
  Oriented_labelling(const Cell_complex& cells, const std::vector<Local_point>& positions,
                     const std::vector<Local_vector>& normals, std::vector<float> values)
    : m_cells(cells), m_positions(positions), m_normals(normals), m_values(std::move(values)), m_labels(cells.size())
  {
    for (Cell_index c = 0; c != cells.size(); ++c)
      m_labels[c] = wants_inside(c) ? 1 : 0;
  }

  bool label(Cell_index c) const { return m_labels[c] != 0; }
  void flip(Cell_index c) { m_labels[c] ^= 1; }
  bool is_surface(Cell_index c, std::size_t i) const { return m_labels[c] != m_labels[m_cells[c].neighbors[i]]; }

  // What facet i counts if it is a surface with its cell inside, or outside: negative if it faces along the normals
  // of its vertices, on the average, better than at a crease.
  struct Facet_energy
  {
    double if_inside, if_outside, area;
  };

  Facet_energy facet_energy(Cell_index c, std::size_t i) const
  {
    const auto f = Cell_complex::facet(m_cells[c], i);
    return facet_energy(i, m_positions[f[0]], m_positions[f[1]], m_positions[f[2]],
                        m_normals[f[0]] + m_normals[f[1]] + m_normals[f[2]]);
  }

  // Of a finite cell, whose vertices are read once.
  std::array<Facet_energy, 4> facet_energies(Cell_index c) const
  {
    const auto& v = m_cells[c].vertices;
    const Local_point p0 = m_positions[v[0]], p1 = m_positions[v[1]], p2 = m_positions[v[2]], p3 = m_positions[v[3]];
    const Local_vector n0 = m_normals[v[0]], n1 = m_normals[v[1]], n2 = m_normals[v[2]], n3 = m_normals[v[3]];
    return { { facet_energy(0, p1, p2, p3, n1 + n2 + n3), facet_energy(1, p2, p3, p0, n2 + n3 + n0),
               facet_energy(2, p3, p0, p1, n3 + n0 + n1), facet_energy(3, p0, p1, p2, n0 + n1 + n2) } };
  }

  // Of the facets of a finite cell.
  double area(Cell_index c) const { return area(m_positions, m_cells[c]); }

  static double area(const std::vector<Local_point>& positions, const Cell_complex::Cell& cell)
  {
    double result = 0.;
    for (std::size_t i = 0; i != 4; ++i)
      result += std::sqrt(normal(positions, Cell_complex::facet(cell, i)).squared_length()) / 2;
    return result;
  }

  // Twice the area vector of a facet, whose vertices are seen in counterclockwise order from where it points.
  static Local_vector normal(const std::vector<Local_point>& positions, const std::array<Point_index, 3>& f)
  {
    return cross_product(positions[f[1]] - positions[f[0]], positions[f[2]] - positions[f[0]]);
  }

  // Negative if the cell wants to be inside, in units of area.
  double outside_preference(Cell_index c, double total_area) const { return double(m_values[c]) * total_area; }

  // Whether a change of its label may win anything. Facets all around a cell do not, if the function does not ask for
  // them: their area vectors add up to zero, so that the mean normals of their vertices gain a third of the area at most.
  bool may_gain(Cell_index c) const
  {
    return label(c) != wants_inside(c) || is_surface(c, 0) || is_surface(c, 1) || is_surface(c, 2) || is_surface(c, 3);
  }

  // By what the energy falls if the cell changes its label. Infinite cells stay outside.
  double gain(Cell_index c) const
  {
    if (Cell_complex::is_infinite(m_cells[c]))
      return -std::numeric_limits<double>::infinity();
    double result = 0., total_area = 0.;
    const std::array<Facet_energy, 4> energies = facet_energies(c);
    for (std::size_t i = 0; i != 4; ++i) {
      const Facet_energy& energy = energies[i];
      if (is_surface(c, i))
        result += label(c) ? energy.if_inside : energy.if_outside;
      else
        result -= label(c) ? energy.if_outside : energy.if_inside;
      total_area += energy.area;
    }
    const double preference = outside_preference(c, total_area);
    return result + (label(c) ? preference : -preference);
  }

  double smallest_gain(Cell_index c) const
  {
    double total = 0.;
    for (std::size_t i = 0; i != 4; ++i) {
      const auto f = Cell_complex::facet(m_cells[c], i);
      if (!Cell_complex::is_infinite(f))
        total += normal(m_positions, f).squared_length();
    }
    return ROUNDING * std::sqrt(total);
  }

  // Whether facet i, if it is a surface with its cell inside, faces along the normals by less than the cosine.
  bool faces_by_less_than(double cosine, Cell_index c, std::size_t i) const
  {
    const Facet_energy energy = facet_energy(c, i);
    return energy.if_inside > (AREA_SHARE - cosine) * energy.area;
  }

  // Of the angles between the normals of the vertices of facet i.
  double smallest_cosine_of_vertices(Cell_index c, std::size_t i) const
  {
    const auto f = Cell_complex::facet(m_cells[c], i);
    return (std::min)(
      { m_normals[f[0]] * m_normals[f[1]], m_normals[f[1]] * m_normals[f[2]], m_normals[f[2]] * m_normals[f[0]] });
  }

private:
  // The normals at a crease of a right angle are half way between its sides, their cosine is .71: with less than that
  // share, facets along either side win, so that holes in plates stay open. The more, the less harm do flipped normals.
  static constexpr double AREA_SHARE = .7;

  // Gains below this part of the area are rounding errors.
  static constexpr double ROUNDING = 1e-9;

  bool wants_inside(Cell_index c) const { return m_values[c] < 0.f; }

  // Of facet i with vertices p, q and r; `normals` is the sum of theirs.
  static Facet_energy facet_energy(std::size_t i, const Local_point& p, const Local_point& q, const Local_point& r,
                                   const Local_vector& normals)
  {
    const Local_vector area_vector = (i % 2 == 0 ? .5 : -.5) * cross_product(q - p, r - p);
    const double area = std::sqrt(area_vector.squared_length());
    const double along = area_vector * normals / 3;
    return Facet_energy{ AREA_SHARE * area - along, AREA_SHARE * area + along, area };
  }

  const Cell_complex& m_cells;
  const std::vector<Local_point>& m_positions;
  const std::vector<Local_vector>& m_normals;
  std::vector<float> m_values;
  std::vector<unsigned char> m_labels;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ORIENTED_LABELLING_H

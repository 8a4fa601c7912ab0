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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CELL_SIGNS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CELL_SIGNS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/parallel.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The linear implicit function at the cells of the Delaunay triangulation of the samples, negative
// inside. At a circumcenter the nearest samples are the vertices of the cell, all at one distance: the
// radii and the choice of samples, on which the function of the thesis (Eq. 5.6) depends elsewhere,
// cancel out, and no search is needed. Values are heights over the tangent planes in units of the
// distance to the samples.
class Cell_signs
{
public:
  using Cell_index = Cell_complex::Cell_index;

  // `normals` have unit length.
  Cell_signs(const Cell_complex& cells, const std::vector<Local_point>& positions,
             const std::vector<Local_vector>& normals)
    : m_cells(cells), m_positions(positions), m_normals(normals)
  { }

  // Infinite cells get 1, cells without `is_wanted(c)` 0. Ends early, with values missing, if go_further() is false; both
  // are called concurrently.
  template <typename ConcurrencyTag, typename GoFurther, typename IsWanted>
  std::vector<float> compute(const GoFurther& go_further, const IsWanted& is_wanted) const
  {
    std::vector<float> values(m_cells.size());
    for_each_block<ConcurrencyTag>(m_cells.size(), CELLS_PER_BLOCK, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c != end && (c != begin || go_further()); ++c)
        values[c] = Cell_complex::is_infinite(m_cells[c])   ? 1.f
                    : is_wanted(static_cast<Cell_index>(c)) ? float(value(m_cells[c]))
                                                            : 0.f;
    });
    return values;
  }

  template <typename ConcurrencyTag, typename GoFurther>
  std::vector<float> compute(const GoFurther& go_further) const
  {
    return compute<ConcurrencyTag>(go_further, [](Cell_index) { return true; });
  }

  template <typename ConcurrencyTag>
  std::vector<float> compute() const
  {
    return compute<ConcurrencyTag>([] { return true; });
  }

  // Of a finite cell; 0 if it is flat.
  double value(const Cell_complex::Cell& cell) const
  {
    Local_vector to_center; // from vertex 0
    if (!find_circumcenter(cell, to_center))
      return 0.;
    const double radius = std::sqrt(to_center.squared_length());
    const Local_point center = m_positions[cell.vertices[0]] + to_center;
    double sum = 0.;
    for (Point_index p : cell.vertices)
      sum += m_normals[p] * (center - m_positions[p]) / radius;
    for (std::size_t i = 0; i != 4; ++i)
      sum += value_of_opposite(cell, i, center, radius);
    return (sum + BARYCENTER_SHARE * value_at_barycenter(cell)) / 4;
  }

private:
  static constexpr std::size_t CELLS_PER_BLOCK = 4096;

  // Measured: half keeps sheets thinner than the spacing, more tips over cells at creases.
  static constexpr double BARYCENTER_SHARE = .5;

  // A determinant below this part of the product of its rows is rounding error.
  static constexpr double FLATNESS = 1e-12;

  bool find_circumcenter(const Cell_complex::Cell& cell, Local_vector& to_center) const
  {
    const Local_point& o = m_positions[cell.vertices[0]];
    const Local_vector a = m_positions[cell.vertices[1]] - o, b = m_positions[cell.vertices[2]] - o,
                       c = m_positions[cell.vertices[3]] - o;
    const Local_vector bc = cross_product(b, c);
    const double aa = a.squared_length(), bb = b.squared_length(), cc = c.squared_length(), determinant = a * bc;
    if (!(determinant * determinant > FLATNESS * FLATNESS * aa * bb * cc))
      return false;
    to_center = (aa * bc + bb * cross_product(c, a) + cc * cross_product(a, b)) / (2. * determinant);
    return true;
  }

  // The sample across facet i: farther than the vertices, with a weight that falls off quickly.
  double value_of_opposite(const Cell_complex::Cell& cell, std::size_t i, const Local_point& center,
                           double radius) const
  {
    const Cell_complex::Cell& neighbor = m_cells[cell.neighbors[i]];
    const Point_index m = m_cells.apex(neighbor, Cell_complex::facet(cell, i));
    if (m == NO_POINT)
      return 0.;
    const Local_vector to_center = center - m_positions[m];
    const double q = radius * radius / to_center.squared_length();
    return q * q * q * (m_normals[m] * to_center) / radius;
  }

  // Tells the two sides of a sheet that is thinner than the spacing: the circumcenter may be far away.
  double value_at_barycenter(const Cell_complex::Cell& cell) const
  {
    Local_vector sum(0, 0, 0);
    const Local_point& o = m_positions[cell.vertices[0]];
    for (std::size_t i = 1; i != 4; ++i)
      sum = sum + (m_positions[cell.vertices[i]] - o);
    const Local_point barycenter = o + sum / 4;
    double result = 0.;
    for (Point_index p : cell.vertices) {
      const Local_vector v = barycenter - m_positions[p];
      result += m_normals[p] * v / std::sqrt(v.squared_length());
    }
    return result;
  }

  const Cell_complex& m_cells;
  const std::vector<Local_point>& m_positions;
  const std::vector<Local_vector>& m_normals;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CELL_SIGNS_H

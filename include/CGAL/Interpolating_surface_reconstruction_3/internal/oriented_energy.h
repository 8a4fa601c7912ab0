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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ORIENTED_ENERGY_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ORIENTED_ENERGY_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Normal_consistency.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/cell_signs.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The energy of surfaces that follow the normals of the surface between the labels of a labelling, as
// their linear implicit function wants it.
class Oriented_energy
{
public:
  using Cell_index = Cell_complex::Cell_index;

  explicit Oriented_energy(const std::vector<Local_point>& points) : m_points(points), m_make_consistent(points) { }

  // Replaces the energy of the labelling. `known(cell, i)` is 1 for a facet that is known to be on the
  // surface, -1 for one known not to be, 0 for one that does not matter, and empty for the others.
  // Returns the cost of a facet known not to be on the surface: more than that of all others.
  template <typename Known, typename Cancellation_point>
  double operator()(const Cell_complex& cells, Cell_labelling& labelling, const Known& known,
                    Cancellation_point& cancellation_point)
  {
    if (m_normals.empty())
      m_normals.assign(m_points.size(), Local_vector(0, 0, 0));
    // Costs are in units of the mean area of the facets of the surface.
    const double unit = estimate_normals(cells, labelling, cancellation_point);
    if (is_bent(cells, labelling, cancellation_point))
      turn_normals(cells, cancellation_point);
    // Nothing but the known facets decides cells that have no others.
    std::vector<unsigned char> is_free(cells.size(), 0);
    for (Cell_index c = 0; c != cells.size(); ++c)
      is_free[c] = !Cell_complex::is_infinite(cells[c]) && !(known(c, 0) && known(c, 1) && known(c, 2) && known(c, 3));
    const Oriented_labelling oriented(cells, m_points, m_normals, values(cells, is_free, cancellation_point));
    std::vector<float> preferences(cells.size(), 0.f);
    double certain = 1.;
    for (Cell_index c = 0; c != cells.size(); ++c)
      if (is_free[c]) {
        cancellation_point();
        const double area = oriented.area(c);
        preferences[c] = static_cast<float>(oriented.outside_preference(c, area) / unit);
        certain += area / unit;
      }
    labelling.set_energy(
      [&](Cell_index c, std::size_t i) {
        cancellation_point();
        if (const std::optional<double> on_surface = known(c, i))
          return Cell_labelling::Cost{ -certain * *on_surface, -certain * *on_surface };
        const Oriented_labelling::Facet_energy energy = oriented.facet_energy(c, i);
        return Cell_labelling::Cost{ energy.if_inside / unit, energy.if_outside / unit };
      },
      [&](Cell_index c) { return double(preferences[c]); });
    return certain;
  }

private:
  // Of the implicit function at the free cells.
  template <typename CancellationPoint>
  std::vector<float> values(const Cell_complex& cells, const std::vector<unsigned char>& is_free,
                            CancellationPoint& cancellation_point) const
  {
    const Cell_signs signs(cells, m_points, m_normals);
    std::vector<float> result(cells.size(), 0.f);
    for (Cell_index c = 0; c != cells.size(); ++c)
      if (is_free[c]) {
        cancellation_point();
        result[c] = float(signs.value(cells[c]));
      }
    return result;
  }

  // Normals of the surface at the sites, weighted by angles, away from the label, and area vectors; returns the mean
  // area of its facets.
  template <typename CancellationPoint>
  double estimate_normals(const Cell_complex& cells, const Cell_labelling& labelling,
                          CancellationPoint& cancellation_point)
  {
    for (Point_index p : cells.points())
      m_normals[p] = Local_vector(0, 0, 0);
    m_areas.assign(cells.points().size(), Local_vector(0, 0, 0));
    double area = 0.;
    std::size_t facets = 0;
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i) {
        cancellation_point();
        const std::array<Point_index, 3> f = Cell_complex::facet(cells[c], i);
        if (!labelling.label(c) || !labelling.is_surface(c, i) || Cell_complex::is_infinite(f))
          continue;
        const Local_vector n =
          (i % 2 == 0 ? .5 : -.5) * cross_product(m_points[f[1]] - m_points[f[0]], m_points[f[2]] - m_points[f[0]]);
        const double length = std::sqrt(n.squared_length());
        area += length;
        ++facets;
        if (length > 0.)
          for (std::size_t k = 0; k != 3; ++k)
            m_normals[f[k]] = m_normals[f[k]] + angle(f[k], f[(k + 1) % 3], f[(k + 2) % 3]) / length * n;
        for (Point_index p : f)
          m_areas[cells.position(p)] = m_areas[cells.position(p)] + n / 3;
      }
    for (Point_index p : cells.points()) {
      const double length = std::sqrt(m_normals[p].squared_length());
      m_normals[p] = length > 0. ? m_normals[p] / length : Local_vector(0, 0, 0);
    }
    return area > 0. ? area / double(facets) : 1.;
  }

  // Whether a facet of the surface faces more than 45 degrees off the normal of a vertex of it. Elsewhere, the normals
  // are consistent.
  template <typename CancellationPoint>
  bool is_bent(const Cell_complex& cells, const Cell_labelling& labelling, CancellationPoint& cancellation_point) const
  {
    constexpr double COSINE = .70710678118654752440;
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i) {
        cancellation_point();
        const std::array<Point_index, 3> f = Cell_complex::facet(cells[c], i);
        if (!labelling.label(c) || !labelling.is_surface(c, i) || Cell_complex::is_infinite(f))
          continue;
        const Local_vector n =
          (i % 2 == 0 ? 1. : -1.) * cross_product(m_points[f[1]] - m_points[f[0]], m_points[f[2]] - m_points[f[0]]);
        const double length = std::sqrt(n.squared_length());
        for (Point_index p : f)
          if (n * m_normals[p] < COSINE * length)
            return true;
      }
    return false;
  }

  // Makes the normals of the surface consistent with each other.
  template <typename CancellationPoint>
  void turn_normals(const Cell_complex& cells, CancellationPoint& cancellation_point)
  {
    m_make_consistent(cells, m_areas, cancellation_point);
    for (std::size_t k = 0; k != cells.points().size(); ++k) {
      const double length = std::sqrt(m_areas[k].squared_length());
      if (length > 0.)
        m_normals[cells.points()[k]] = m_areas[k] / length;
    }
  }

  double angle(Point_index p, Point_index q, Point_index r) const
  {
    const Local_vector a = m_points[q] - m_points[p], b = m_points[r] - m_points[p];
    return std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b);
  }

  const std::vector<Local_point>& m_points;
  std::vector<Local_vector> m_normals; // of the points of the present cells
  std::vector<Local_vector> m_areas;   // of the same in the order of the cells: area vectors
  Normal_consistency m_make_consistent;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ORIENTED_ENERGY_H

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

  // For what follows. `known(cell, i)` is 1 for a facet that is known to be on the surface, -1 for one known not to be, 0
  // for one that does not matter, and empty for the others. `cells` must stay, and `cancellation_point()` is called again and
  // again and may throw.
  template <typename Known, typename Cancellation_point>
  void set_cells(const Cell_complex& cells, const Known& known, Cancellation_point& cancellation_point)
  {
    m_cells = &cells;
    m_knows_neighbors = false;
    if (m_normals.empty())
      m_normals.assign(m_points.size(), Local_vector(0, 0, 0));
    // Nothing but the known facets decides cells that have no others.
    m_free.clear();
    for (Cell_index c = 0; c != cells.size(); ++c) {
      cancellation_point();
      if (!Cell_complex::is_infinite(cells[c]) && !(known(c, 0) && known(c, 1) && known(c, 2) && known(c, 3)))
        m_free.push_back(Free_cell{ c, Oriented_labelling::area(m_points, cells[c]) });
    }
  }

  // Replaces the energy of the labelling of the cells. Returns the cost of a facet known not to be on the surface: more
  // than that of all others.
  template <typename Known, typename Cancellation_point>
  double operator()(Cell_labelling& labelling, const Known& known, Cancellation_point& cancellation_point)
  {
    const Cell_complex& cells = *m_cells;
    find_facets(labelling, cancellation_point);
    // Costs are in units of the mean area of the facets of the surface.
    const double unit = estimate_normals(cancellation_point);
    if (is_bent(cancellation_point))
      turn_normals(cancellation_point);
    const Oriented_labelling oriented(cells, m_points, m_normals, values(cancellation_point));
    std::vector<float> preferences(cells.size(), 0.f);
    double certain = 1.;
    for (const Free_cell& free : m_free) {
      cancellation_point();
      preferences[free.cell] = static_cast<float>(oriented.outside_preference(free.cell, free.area) / unit);
      certain += free.area / unit;
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
  // A cell whose label is not decided by known facets, and the area of its facets.
  struct Free_cell
  {
    Cell_index cell;
    double area;
  };

  // A facet of the surface, and its area vector away from the label.
  struct Surface_facet
  {
    std::array<Point_index, 3> vertices;
    Local_vector area_vector;
  };

  // Of the implicit function at the free cells.
  template <typename CancellationPoint>
  std::vector<float> values(CancellationPoint& cancellation_point) const
  {
    const Cell_signs signs(*m_cells, m_points, m_normals);
    std::vector<float> result(m_cells->size(), 0.f);
    for (const Free_cell& free : m_free) {
      cancellation_point();
      result[free.cell] = float(signs.value((*m_cells)[free.cell]));
    }
    return result;
  }

  template <typename CancellationPoint>
  void find_facets(const Cell_labelling& labelling, CancellationPoint& cancellation_point)
  {
    m_facets.clear();
    for (Cell_index c = 0; c != m_cells->size(); ++c) {
      cancellation_point();
      if (!labelling.label(c))
        continue;
      for (std::size_t i = 0; i != 4; ++i) {
        const std::array<Point_index, 3> f = Cell_complex::facet((*m_cells)[c], i);
        if (labelling.is_surface(c, i) && !Cell_complex::is_infinite(f))
          m_facets.push_back(Surface_facet{ f, (i % 2 == 0 ? .5 : -.5) * Oriented_labelling::normal(m_points, f) });
      }
    }
  }

  // Normals of the surface at the sites, weighted by angles, and area vectors; returns the mean area of its facets.
  template <typename CancellationPoint>
  double estimate_normals(CancellationPoint& cancellation_point)
  {
    for (Point_index p : m_cells->points())
      m_normals[p] = Local_vector(0, 0, 0);
    m_areas.assign(m_cells->points().size(), Local_vector(0, 0, 0));
    double area = 0.;
    for (const Surface_facet& facet : m_facets) {
      cancellation_point();
      const auto& f = facet.vertices;
      const Local_vector& n = facet.area_vector;
      const double length = std::sqrt(n.squared_length());
      area += length;
      if (length > 0.)
        for (std::size_t k = 0; k != 3; ++k)
          m_normals[f[k]] = m_normals[f[k]] + angle(f[k], f[(k + 1) % 3], f[(k + 2) % 3]) / length * n;
      for (Point_index p : f)
        m_areas[m_cells->position(p)] = m_areas[m_cells->position(p)] + n / 3;
    }
    for (Point_index p : m_cells->points()) {
      const double length = std::sqrt(m_normals[p].squared_length());
      m_normals[p] = length > 0. ? m_normals[p] / length : Local_vector(0, 0, 0);
    }
    return area > 0. ? area / double(m_facets.size()) : 1.;
  }

  // Whether a facet of the surface faces more than 45 degrees off the normal of a vertex of it. Elsewhere, the normals
  // are consistent.
  template <typename CancellationPoint>
  bool is_bent(CancellationPoint& cancellation_point) const
  {
    constexpr double COSINE = .70710678118654752440;
    for (const Surface_facet& facet : m_facets) {
      cancellation_point();
      const double length = std::sqrt(facet.area_vector.squared_length());
      for (Point_index p : facet.vertices)
        if (facet.area_vector * m_normals[p] < COSINE * length)
          return true;
    }
    return false;
  }

  // Makes the normals of the surface consistent with each other.
  template <typename CancellationPoint>
  void turn_normals(CancellationPoint& cancellation_point)
  {
    if (!m_knows_neighbors)
      m_make_consistent.set_cells(*m_cells, cancellation_point);
    m_knows_neighbors = true;
    m_make_consistent(m_areas, cancellation_point);
    for (std::size_t k = 0; k != m_areas.size(); ++k) {
      const double length = std::sqrt(m_areas[k].squared_length());
      if (length > 0.)
        m_normals[m_cells->points()[k]] = m_areas[k] / length;
    }
  }

  double angle(Point_index p, Point_index q, Point_index r) const
  {
    const Local_vector a = m_points[q] - m_points[p], b = m_points[r] - m_points[p];
    return std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b);
  }

  const std::vector<Local_point>& m_points;
  const Cell_complex* m_cells = nullptr;
  std::vector<Free_cell> m_free;
  std::vector<Surface_facet> m_facets; // of the present labelling
  std::vector<Local_vector> m_normals; // of the points of the cells
  std::vector<Local_vector> m_areas;   // of the same in the order of the cells: area vectors
  Normal_consistency m_make_consistent;
  bool m_knows_neighbors = false; // whether that has the present cells
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ORIENTED_ENERGY_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACET_EVIDENCE_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACET_EVIDENCE_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// What speaks for a facet of a Delaunay triangulation to be on the surface, without any orientation:
// the votes of the stars, and the angle at which the circumscribed spheres of its cells meet, which is
// flat where both cells are on one side of the surface (Amenta, Choi and Kolluri, The power crust,
// 2001).
class Facet_evidence
{
public:
  using Cell_index = Cell_complex::Cell_index;
  using Facet = std::array<Point_index, 3>;

  template <typename Cancellation_point>
  Facet_evidence(const Cell_complex& cells, const std::vector<Local_point>& points, const Star_table& stars,
                 Cancellation_point& cancellation_point)
    : m_cells(cells), m_points(points), m_stars(stars), m_spheres(cells.size())
  {
    for (Cell_index c = 0; c != cells.size(); ++c) {
      cancellation_point();
      if (!Cell_complex::is_infinite(cells[c]))
        m_spheres[c] = circumsphere(cells[c].vertices);
    }
  }

  // Positive if a finite facet seems to be on the surface.
  double operator()(Cell_index c, std::size_t i) const
  {
    const Facet f = Cell_complex::facet(m_cells[c], i);
    return TRUST[m_stars.votes(f[0], f[1], f[2])] - cosine_of_spheres(f, c, m_cells[c].neighbors[i]);
  }

private:
  // Worth of 0 to 3 votes. Results hardly depend on it.
  static constexpr double TRUST[4] = { -1., -.2, .2, 1.5 };

  struct Sphere
  {
    Local_point center;
    double radius;
  };

  Sphere circumsphere(const std::array<Point_index, 4>& v) const
  {
    const Local_point& o = m_points[v[0]];
    const Local_vector a = m_points[v[1]] - o, b = m_points[v[2]] - o, c = m_points[v[3]] - o;
    const Local_vector numerator = a.squared_length() * cross_product(b, c) + b.squared_length() * cross_product(c, a) +
                                   c.squared_length() * cross_product(a, b);
    const Local_vector offset = numerator / (2. * (cross_product(a, b) * c));
    return Sphere{ o + offset, std::sqrt(offset.squared_length()) };
  }

  double cosine_of_spheres(const Facet& f, Cell_index c, Cell_index d) const
  {
    const double x = height(f, c), y = height(f, d);
    return std::sqrt((1. - x * x) * (1. - y * y)) - x * y;
  }

  // Signed distance of the center of the cell's sphere to the facet, towards the cell, over the radius.
  double height(const Facet& f, Cell_index c) const
  {
    if (Cell_complex::is_infinite(m_cells[c]))
      return 1.;
    const Point_index apex = Cell_complex::apex(m_cells[c], f);
    const Local_point& o = m_points[f[0]];
    const Local_vector n = cross_product(m_points[f[1]] - o, m_points[f[2]] - o);
    const double side = n * (m_points[apex] - o) < 0. ? -1. : 1.;
    const double length = std::sqrt(n.squared_length()) * m_spheres[c].radius;
    const double value = side * (n * (m_spheres[c].center - o)) / length;
    return value >= -1. && value <= 1. ? value : value > 1. ? 1. : -1.;
  }

  const Cell_complex& m_cells;
  const std::vector<Local_point>& m_points;
  const Star_table& m_stars;
  std::vector<Sphere> m_spheres;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACET_EVIDENCE_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TANGENT_PROJECTION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TANGENT_PROJECTION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Point_star.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Neighbors of a point in an orthonormal frame of its tangent plane. The plane meets the bisector of the
// point and neighbor i in the line x(i) x + y(i) y = half_square(i).
template <std::size_t MaximumSize>
class Tangent_projection
{
public:
  using Vector_3 = Star_neighborhood::Vector_3;

  // Takes the first MaximumSize neighbors if there are more.
  Tangent_projection(const Star_neighborhood& neighborhood, const Vector_3& normal)
    : m_size(neighborhood.size() < MaximumSize ? neighborhood.size() : MaximumSize)
  {
    Vector_3 u, v;
    set_frame(normal, u, v);
    for (std::size_t i = 0; i != m_size; ++i) {
      const Vector_3& d = neighborhood[i];
      m_x[i] = d * u;
      m_y[i] = d * v;
      m_half_squares[i] = d.squared_length() / 2;
    }
  }

  std::size_t size() const { return m_size; }
  double x(std::size_t i) const { return m_x[i]; }
  double y(std::size_t i) const { return m_y[i]; }
  // Half of the squared length in space, not in the plane.
  double half_square(std::size_t i) const { return m_half_squares[i]; }

private:
  static void set_frame(const Vector_3& n, Vector_3& u, Vector_3& v)
  {
    const double ax = std::abs(n.x()), ay = std::abs(n.y()), az = std::abs(n.z());
    const Vector_3 axis = ax <= ay && ax <= az ? Vector_3(1, 0, 0) : ay <= az ? Vector_3(0, 1, 0) : Vector_3(0, 0, 1);
    u = cross_product(n, axis);
    u = u / std::sqrt(u.squared_length());
    v = cross_product(n, u);
  }

  std::size_t m_size;
  std::array<double, MaximumSize> m_x, m_y, m_half_squares;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TANGENT_PROJECTION_H

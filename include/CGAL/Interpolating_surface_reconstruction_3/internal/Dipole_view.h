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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_DIPOLE_VIEW_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_DIPOLE_VIEW_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Close to a sample the field is that of a patch of this part of the distance to its sixth neighbor: a point of a triangle
// mesh has six on the average. Measured: less than a fifth follows wrong neighbors, a half rounds creases off.
constexpr double DIPOLE_SOFTENING = 1. / 4.;
constexpr std::size_t DIPOLE_NEIGHBORS = 6;

// A sample of a surface with its area vector is a dipole: the winding number around a place is the sum of the potentials
// there, times 1 / (4 pi), and falls along the normals. This is what the place sees of one that is `to_dipole` away from
// it; `softening`, the square of a length, keeps that finite, as a sample is no point but a patch.
class Dipole_view
{
public:
  Dipole_view(const Local_vector& to_dipole, double softening)
    : m_to_dipole(to_dipole), m_squared(1. / (to_dipole.squared_length() + softening)),
      m_cubed(m_squared * std::sqrt(m_squared))
  { }

  double potential(const Local_vector& area) const { return m_cubed * (area * m_to_dipole); }

  // The gradient of the potential with respect to the area vector.
  Local_vector direction() const { return m_cubed * m_to_dipole; }

  // By what the potential falls from there on.
  Local_vector field(const Local_vector& area) const
  {
    return m_cubed * (area - 3. * m_squared * (area * m_to_dipole) * m_to_dipole);
  }

private:
  Local_vector m_to_dipole;
  double m_squared, m_cubed; // of the inverse of the distance
};

// The area vector turned to the field, unless points are so near to each other that the field is no number.
inline Local_vector turned_to_field(const Local_vector& area, const Local_vector& field)
{
  const double length = std::sqrt(field.squared_length());
  return length > 0. && std::isfinite(length) ? std::sqrt(area.squared_length()) / length * field : area;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_DIPOLE_VIEW_H

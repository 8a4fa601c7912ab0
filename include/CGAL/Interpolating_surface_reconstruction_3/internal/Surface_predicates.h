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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_PREDICATES_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_PREDICATES_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_cloud_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <CGAL/enum.h>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The geometric decisions that change the topology, taken by the predicates of the traits. A bound
// on the rounding error of double spares the predicate in the obvious cases.
template <typename Traits>
class Surface_predicates
{
public:
  explicit Surface_predicates(const Point_cloud_3<Traits>& cloud) : m_cloud(cloud) { }

  // Whether the three points are collinear.
  bool is_degenerate(Point_index p, Point_index q, Point_index r) const
  {
    const Local_vector u = m_cloud.position(q) - m_cloud.position(p), v = m_cloud.position(r) - m_cloud.position(p);
    if (cross_product(u, v).squared_length() > SQUARED_ERROR * u.squared_length() * v.squared_length())
      return false;
    return m_cloud.traits().collinear_3_object()(m_cloud.point(p), m_cloud.point(q), m_cloud.point(r));
  }

  // Whether the triangles (p, q, r) and (q, p, s) lie in one plane, on the same side of their edge.
  bool is_folded(Point_index p, Point_index q, Point_index r, Point_index s) const
  {
    const Local_vector e = m_cloud.position(q) - m_cloud.position(p), a = m_cloud.position(r) - m_cloud.position(p),
                       b = m_cloud.position(s) - m_cloud.position(p);
    const Local_vector m = cross_product(e, a), n = cross_product(e, b);
    // The errors are relative to the factors: a triangle that is nearly degenerate has no certain normal.
    const double error =
      SQUARED_ERROR * e.squared_length() * e.squared_length() * a.squared_length() * b.squared_length();
    const double cosine = m * n;
    if ((cosine < 0. && cosine * cosine > error) || cross_product(m, n).squared_length() > error)
      return false;
    const Traits& traits = m_cloud.traits();
    const auto coplanar_orientation = traits.coplanar_orientation_3_object();
    // Predicates that are not exact may find a triangle collinear that is not.
    return traits.orientation_3_object()(m_cloud.point(p), m_cloud.point(q), m_cloud.point(r), m_cloud.point(s)) ==
             COPLANAR &&
           coplanar_orientation(m_cloud.point(p), m_cloud.point(q), m_cloud.point(r)) != COLLINEAR &&
           coplanar_orientation(m_cloud.point(p), m_cloud.point(q), m_cloud.point(r), m_cloud.point(s)) == POSITIVE;
  }

private:
  // Far above the square of the rounding error of a cross product relative to its factors, 2^-50.
  static constexpr double SQUARED_ERROR = 1e-20;

  const Point_cloud_3<Traits>& m_cloud;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_PREDICATES_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CORNER_TEST_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CORNER_TEST_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Whether the surface passes over a corner. Where a surface is flat, its samples are regular, so that a point with edges
// of very unlike length in the middle of a flat part is more likely to be one of a bore, a pocket or a gap that is closed
// by a cap (thesis 3.2: coplanarity and regularity): a lost corner.
class Corner_test
{
public:
  explicit Corner_test(const Local_point& p) : m_point(p) { }

  // Facet (p, a, b) is on the surface. All facets have the same orientation.
  void add_facet(const Local_point& a, const Local_point& b)
  {
    const Local_vector to_a = a - m_point, to_b = b - m_point, normal = cross_product(to_a, to_b);
    for (double squared_length : { to_a.squared_length(), to_b.squared_length() }) {
      m_shortest = (std::min)(m_shortest, squared_length);
      m_longest = (std::max)(m_longest, squared_length);
    }
    const double length = std::sqrt(normal.squared_length());
    if (!(length > 0.))
      return;
    if (!m_has_normal)
      m_normal = normal / length;
    else
      m_is_flat = m_is_flat && m_normal * normal > LEAST_COSINE * length;
    m_has_normal = true;
  }

  bool is_flat() const { return m_is_flat; }
  bool is_lost() const { return m_is_flat && m_has_normal && m_longest > LEAST_RATIO * LEAST_RATIO * m_shortest; }

  // Of the edges at the point.
  double squared_length_of_shortest() const { return m_shortest; }
  double squared_length_of_longest() const { return m_longest; }

  // If it is lost, the normal of the surface, of unit length.
  const Local_vector& normal() const { return m_normal; }

  // Longer edges than that are worth no corner: it would lose by them what it wins.
  double squared_length_of_longest_gained() const { return LEAST_RATIO * LEAST_RATIO * m_longest; }

  // No edge bends more where the surface is flat, as an angle: twice the one below, rounded up.
  static constexpr double MAXIMUM_BENDING = .18;

private:
  // Of five degrees: less than between the facets of what is round.
  static constexpr double LEAST_COSINE = .9962;

  // Between the longest and the shortest edge. Points that are sampled from a surface have twice or three times.
  static constexpr double LEAST_RATIO = 6.;

  Local_point m_point;
  Local_vector m_normal{ 0, 0, 0 }; // of the first facet
  double m_shortest = std::numeric_limits<double>::infinity(), m_longest = 0.;
  bool m_has_normal = false, m_is_flat = true;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CORNER_TEST_H

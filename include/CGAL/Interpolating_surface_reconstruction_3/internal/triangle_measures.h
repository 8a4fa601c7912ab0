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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TRIANGLE_MEASURES_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TRIANGLE_MEASURES_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Point_star.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// A `Location` below is a Local_point, or a Local_vector from an origin that all arguments share.
// No measure of the positions of a cloud is NaN: a degenerate triangle gets the worst value.

// Cosine of the angle between two vectors; 0 if one of them is zero and there is no angle.
inline double cosine(const Local_vector& u, const Local_vector& v)
{
  // The root of each factor: the product of two small squared lengths would be 0 too early.
  const double lengths = std::sqrt(u.squared_length()) * std::sqrt(v.squared_length());
  return lengths > 0. ? (std::min)(1., (std::max)(-1., u * v / lengths)) : 0.;
}

// Eq. 3.10, 3.11: the regularity of an equilateral triangle.
constexpr double MAXIMUM_REGULARITY = 1.5;

// Eq. 3.1: the sum of the cosines of the angles of a triangle. It is 1.5 if all sides are equal, 1
// if the triangle is degenerate, and 0 if its vertices coincide.
template <typename Location>
double regularity(const Location& p, const Location& q, const Location& r)
{
  return cosine(q - p, r - p) + cosine(r - q, p - q) + cosine(p - r, q - r);
}

// Eq. 3.2 for the points p and q on one side of the edge ab: whether the triangle (a, b, p) belongs
// to the more regular of the two triangulations of the quadrilateral. The wider angle at the edge
// tells which of p and q is next to a; the two triangulations are those of that quadrilateral,
// because the other order of the vertices makes it cross itself. A tie goes to p.
template <typename Location>
bool is_first_more_regular(const Location& a, const Location& b, const Location& p, const Location& q)
{
  const bool is_p_next_to_a = cosine(b - a, p - a) < cosine(b - a, q - a);
  // The diagonal from the first candidate ends at the end of the edge that is next to the second.
  const Location& p_diagonal = is_p_next_to_a ? b : a;
  const Location& q_diagonal = is_p_next_to_a ? a : b;
  const double with_p = (std::min)(regularity(a, b, p), regularity(p_diagonal, p, q));
  const double with_q = (std::min)(regularity(a, b, q), regularity(q_diagonal, q, p));
  return with_p >= with_q;
}

// The square of the diameter of the circle through three distinct points; infinite if they lie on a line.
template <typename Location>
double squared_circumdiameter(const Location& a, const Location& b, const Location& c)
{
  const Local_vector u = b - a, v = c - a;
  return u.squared_length() * v.squared_length() * (v - u).squared_length() / cross_product(u, v).squared_length();
}

// Order of points in which vectors from an origin have the same order as the points.
template <typename Location>
bool is_lexicographically_less(const Location& a, const Location& b)
{
  return a.x() != b.x() ? a.x() < b.x() : a.y() != b.y() ? a.y() < b.y() : a.z() < b.z();
}

// Whether ac is the better diagonal of the quadrangle a, b, c, d than bd: of the two pairs of triangles, the one whose
// larger circumscribed circle is smaller. Cocircular points, such as those of a grid, get the diagonal that spares
// the last point, which is that of the symbolic perturbation of Delaunay_triangulation_3.
template <typename Location>
bool is_first_diagonal_better(const Location& a, const Location& b, const Location& c, const Location& d)
{
  // More than a rotation of the points changes circles, unless these are tiny.
  constexpr double ROUNDING = 1e-12;
  const double first = (std::max)(squared_circumdiameter(a, b, c), squared_circumdiameter(a, c, d)),
               second = (std::max)(squared_circumdiameter(a, b, d), squared_circumdiameter(b, c, d));
  const bool is_tie = first >= (1. - ROUNDING) * second && second >= (1. - ROUNDING) * first;
  const auto is_less = [](const Location& p, const Location& q) { return is_lexicographically_less(p, q); };
  return is_tie ? is_less((std::max)(a, c, is_less), (std::max)(b, d, is_less)) : first < second;
}

// 4.2.2: cosine of the angle that adds up to 180 degrees with the dihedral angle of the triangles
// (a, b, c) and (b, a, d): 1 if they continue each other, -1 if they are folded onto each other or
// if one is degenerate and has no plane.
template <typename Location>
double cosine_of_supplementary_angle(const Location& a, const Location& b, const Location& c, const Location& d)
{
  const Local_vector n = cross_product(b - a, c - a), m = cross_product(d - a, b - a);
  const double lengths = std::sqrt(n.squared_length()) * std::sqrt(m.squared_length());
  return lengths > 0. ? (std::min)(1., (std::max)(-1., n * m / lengths)) : -1.;
}

// 4.2.2: planarity degree of a star, the least cosine over its pairs of adjacent triangles. `link`
// is cyclic and may have gaps; position(i) is where neighbor i lies. A star without such a pair is
// the least planar one, because nothing vouches for it.
template <typename Location, typename Position>
double planarity_degree(const Location& center, const std::vector<std::uint32_t>& link, Position position)
{
  const std::size_t n = link.size();
  bool has_pair = false;
  double result = 1.;
  for (std::size_t i = 0; i != n; ++i) {
    const std::uint32_t before = link[i], middle = link[(i + 1) % n], after = link[(i + 2) % n];
    if (before == Point_star::GAP || middle == Point_star::GAP || after == Point_star::GAP)
      continue;
    has_pair = true;
    result = (std::min)(
      result, cosine_of_supplementary_angle<Location>(center, position(middle), position(after), position(before)));
  }
  return has_pair ? result : -1.;
}

// The cosine that stands for a missing neighbor in Eq. 4.1: its supplementary angle counts as 0.
constexpr double MISSING_NEIGHBOR_COSINE = 1.;

// Whether two angles of at most 180 degrees sum up to less than 90 degrees, given their cosines:
// both are acute, and cos a cos b > sin a sin b, which squared is cos^2 a + cos^2 b > 1.
inline bool is_sum_acute(double cosine_a, double cosine_b)
{
  return cosine_a > 0. && cosine_b > 0. && cosine_a * cosine_a + cosine_b * cosine_b > 1.;
}

// Eq. 4.1 for the cosines of the supplementary angles at the three edges of a triangle.
inline bool fulfils_minimum_planarity(double cosine_a, double cosine_b, double cosine_c)
{
  return is_sum_acute(cosine_a, cosine_b) && is_sum_acute(cosine_b, cosine_c) && is_sum_acute(cosine_c, cosine_a);
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TRIANGLE_MEASURES_H

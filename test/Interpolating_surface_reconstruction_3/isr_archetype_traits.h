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

#ifndef ISR_ARCHETYPE_TRAITS_H
#define ISR_ARCHETYPE_TRAITS_H

#include "isr_test_samples.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/enum.h>

namespace isr_test {

// A model of InterpolatingReconstructionTraits_3 with the members of the concept and nothing else:
// its points and vectors have no operators, and its functors only the overloads that the concept names.
class Archetype_traits
{
  struct Access;

public:
  using FT = double;

  class Point_3
  {
  public:
    Point_3() = default;

  private:
    explicit Point_3(const Point& p) : m_point(p) { }
    friend struct Access;
    Point m_point;
  };

  class Vector_3
  {
  public:
    Vector_3() = default;

  private:
    explicit Vector_3(const Vector& v) : m_vector(v) { }
    friend struct Access;
    Vector m_vector;
  };

  // The only way to make points for a test.
  static Point_3 make_point(const Point& p) { return Access::wrap(p); }

private:
  struct Access
  {
    static const Point& unwrap(const Point_3& p) { return p.m_point; }
    static const Vector& unwrap(const Vector_3& v) { return v.m_vector; }
    static Point_3 wrap(const Point& p) { return Point_3(p); }
    static Vector_3 wrap(const Vector& v) { return Vector_3(v); }
  };

  static const Point& in(const Point_3& p) { return Access::unwrap(p); }
  static const Vector& in(const Vector_3& v) { return Access::unwrap(v); }

public:
  struct Equal_3
  {
    bool operator()(const Point_3& p, const Point_3& q) const { return in(p) == in(q); }
  };
  struct Less_xyz_3
  {
    bool operator()(const Point_3& p, const Point_3& q) const { return in(p) < in(q); }
  };
  struct Collinear_3
  {
    bool operator()(const Point_3& p, const Point_3& q, const Point_3& r) const
    {
      return CGAL::collinear(in(p), in(q), in(r));
    }
  };
  struct Coplanar_orientation_3
  {
    CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r) const
    {
      return CGAL::coplanar_orientation(in(p), in(q), in(r));
    }
    CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s) const
    {
      return CGAL::coplanar_orientation(in(p), in(q), in(r), in(s));
    }
  };
  struct Orientation_3
  {
    CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s) const
    {
      return CGAL::orientation(in(p), in(q), in(r), in(s));
    }
  };
  struct Compare_squared_distance_3
  {
    CGAL::Comparison_result operator()(const Point_3& p, const Point_3& q, const FT& d) const
    {
      return CGAL::compare_squared_distance(in(p), in(q), d);
    }
    CGAL::Comparison_result operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s) const
    {
      return Kernel().compare_squared_distance_3_object()(in(p), in(q), in(r), in(s));
    }
  };
  struct Construct_vector_3
  {
    Vector_3 operator()(const Point_3& p, const Point_3& q) const { return Access::wrap(in(q)-in(p)); }
    Vector_3 operator()(const FT& x, const FT& y, const FT& z) const { return Access::wrap(Vector(x, y, z)); }
  };
  struct Construct_point_3
  {
    Point_3 operator()(const FT& x, const FT& y, const FT& z) const { return Access::wrap(Point(x, y, z)); }
  };
  struct Construct_translated_point_3
  {
    Point_3 operator()(const Point_3& p, const Vector_3& v) const { return Access::wrap(in(p) + in(v)); }
  };
  struct Construct_scaled_vector_3
  {
    Vector_3 operator()(const Vector_3& v, const FT& by) const { return Access::wrap(in(v)*by); }
  };
  struct Construct_sum_of_vectors_3
  {
    Vector_3 operator()(const Vector_3& v, const Vector_3& w) const { return Access::wrap(in(v) + in(w)); }
  };
  struct Construct_cross_product_vector_3
  {
    Vector_3 operator()(const Vector_3& v, const Vector_3& w) const
    {
      return Access::wrap(CGAL::cross_product(in(v), in(w)));
    }
  };
  struct Construct_bbox_3
  {
    CGAL::Bbox_3 operator()(const Point_3& p) const { return in(p).bbox(); }
  };
  struct Construct_cartesian_const_iterator_3
  {
    using result_type = Kernel::Cartesian_const_iterator_3;
    result_type operator()(const Point_3& p) const { return in(p).cartesian_begin(); }
    result_type operator()(const Point_3& p, int) const { return in(p).cartesian_end(); }
    result_type operator()(const Vector_3& v) const { return in(v).cartesian_begin(); }
    result_type operator()(const Vector_3& v, int) const { return in(v).cartesian_end(); }
  };
  struct Compute_squared_distance_3
  {
    FT operator()(const Point_3& p, const Point_3& q) const { return CGAL::squared_distance(in(p), in(q)); }
  };
  struct Compute_squared_length_3
  {
    FT operator()(const Vector_3& v) const { return in(v).squared_length(); }
  };
  struct Compute_scalar_product_3
  {
    FT operator()(const Vector_3& v, const Vector_3& w) const { return in(v)*in(w); }
  };
  struct Compute_determinant_3
  {
    FT operator()(const Vector_3& u, const Vector_3& v, const Vector_3& w) const
    {
      return CGAL::determinant(in(u), in(v), in(w));
    }
  };

  Equal_3 equal_3_object() const { return Equal_3(); }
  Less_xyz_3 less_xyz_3_object() const { return Less_xyz_3(); }
  Collinear_3 collinear_3_object() const { return Collinear_3(); }
  Coplanar_orientation_3 coplanar_orientation_3_object() const { return Coplanar_orientation_3(); }
  Orientation_3 orientation_3_object() const { return Orientation_3(); }
  Compare_squared_distance_3 compare_squared_distance_3_object() const { return Compare_squared_distance_3(); }
  Construct_vector_3 construct_vector_3_object() const { return Construct_vector_3(); }
  Construct_point_3 construct_point_3_object() const { return Construct_point_3(); }
  Construct_translated_point_3 construct_translated_point_3_object() const { return Construct_translated_point_3(); }
  Construct_scaled_vector_3 construct_scaled_vector_3_object() const { return Construct_scaled_vector_3(); }
  Construct_sum_of_vectors_3 construct_sum_of_vectors_3_object() const { return Construct_sum_of_vectors_3(); }
  Construct_cross_product_vector_3 construct_cross_product_vector_3_object() const
  {
    return Construct_cross_product_vector_3();
  }
  Construct_bbox_3 construct_bbox_3_object() const { return Construct_bbox_3(); }
  Construct_cartesian_const_iterator_3 construct_cartesian_const_iterator_3_object() const
  {
    return Construct_cartesian_const_iterator_3();
  }
  Compute_squared_distance_3 compute_squared_distance_3_object() const { return Compute_squared_distance_3(); }
  Compute_squared_length_3 compute_squared_length_3_object() const { return Compute_squared_length_3(); }
  Compute_scalar_product_3 compute_scalar_product_3_object() const { return Compute_scalar_product_3(); }
  Compute_determinant_3 compute_determinant_3_object() const { return Compute_determinant_3(); }
};

} // namespace isr_test

#endif // ISR_ARCHETYPE_TRAITS_H

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

#ifndef ISR_TEST_LIS_H
#define ISR_TEST_LIS_H

#include "isr_test_ctc.h"

#include <CGAL/lis_reconstruction.h>

#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace isr_test {

// Samples with normals.
using Oriented_point = std::pair<Point, Vector>;
using Oriented_points = std::vector<Oriented_point>;

inline auto oriented_maps()
{
  return params::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
    .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());
}

// `normal_at(p)` may have any length.
template <typename NormalAt>
Oriented_points with_normals(const Points& points, const NormalAt& normal_at)
{
  Oriented_points result;
  for (const Point& p : points)
    result.emplace_back(p, normal_at(p));
  return result;
}

inline Points positions_of(const Oriented_points& samples)
{
  Points result;
  for (const Oriented_point& s : samples)
    result.push_back(s.first);
  return result;
}

inline Vector normal_of_torus(const Point& p)
{
  const double r = std::sqrt(p.x() * p.x() + p.y() * p.y());
  return p - Point(p.x() / r, p.y() / r, 0);
}

// The sum of the normals of the sides of the box [low, high] on which p lies.
inline Vector normal_of_box(const Point& p, const Point& low, const Point& high)
{
  const auto along = [](double c, double l, double h) { return c == l ? -1. : c == h ? 1. : 0.; };
  return Vector(along(p.x(), low.x(), high.x()), along(p.y(), low.y(), high.y()), along(p.z(), low.z(), high.z()));
}

struct Soup
{
  Points points;
  Triples triangles;
};

template <typename ConcurrencyTag = CGAL::Sequential_tag, typename PointRange, typename NamedParameters>
Soup lis(const PointRange& points, const NamedParameters& np)
{
  Soup soup;
  CGAL::lis_reconstruction<ConcurrencyTag>(points, soup.points, soup.triangles, np);
  return soup;
}

// What holds for any samples that are not coplanar: a closed oriented manifold that faces outward, whose
// vertices are samples, and a visitor that can account for every point.
inline Soup checked_lis(const Oriented_points& samples, Counting_visitor& visitor)
{
  const Soup soup = lis(samples, params::combine(oriented_maps(), params::visitor(std::ref(visitor))));
  ISR_CHECK(validation::is_oriented_manifold(soup.points, soup.triangles, Kernel()));
  ISR_CHECK(validation::boundary_edges(soup.triangles).empty());
  ISR_CHECK(are_outward(soup.points, soup.triangles) || soup.triangles.empty() ||
            validation::number_of_components(soup.triangles) > 1);
  ISR_CHECK_EQUAL(validation::used_points(soup.triangles).size(), soup.points.size());
  ISR_CHECK_EQUAL(visitor.points, samples.size());
  ISR_CHECK_EQUAL(soup.points.size() + visitor.unused + visitor.duplicates + visitor.non_finite, samples.size());
  ISR_CHECK_EQUAL(visitor.begun, 1u);
  ISR_CHECK_EQUAL(visitor.ended, 1u);
  ISR_CHECK_EQUAL(visitor.stages_begun, visitor.stages_ended);
  ISR_CHECK(!visitor.was_cancelled);
  return soup;
}

inline Soup checked_lis(const Oriented_points& samples)
{
  Counting_visitor visitor;
  return checked_lis(samples, visitor);
}

} // namespace isr_test

#endif // ISR_TEST_LIS_H

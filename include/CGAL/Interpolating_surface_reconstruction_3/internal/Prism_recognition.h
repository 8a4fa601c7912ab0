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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PRISM_RECOGNITION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PRISM_RECOGNITION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Sheet_prism.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/flatness.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_exchange.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Replaces the surface of points that are those on the edges of a prism, or of a frustum (see Sheet_prism): all in two
// parallel planes, where they lie along the same curves. Stars cannot tell the faces of such a part from its bores.
template <typename Builder>
class Prism_recognition
{
public:
  Prism_recognition(const std::vector<Local_point>& points, Builder& builder) : m_points(points), m_builder(builder) { }

  // Returns whether it is one. Ends early if cancelled.
  template <typename Progress>
  bool operator()(Progress& progress)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    try {
      for (const Plane& plane : candidates(cancellation_point))
        if (find_ends(plane, cancellation_point))
          return replace_surface(plane, cancellation_point);
    } catch (const Cancelled&) {
    }
    return false;
  }

private:
  using Triangle = typename Builder::Triangle;

  struct Plane
  {
    double area; // of its triangle
    Local_point origin;
    Local_vector normal; // of unit length
  };

  // The triangles of an end are larger than those of the walls, unless these are few.
  static constexpr std::size_t TRIANGLES_LOOKED_AT = 64;

  // Those of the largest triangles.
  template <typename CancellationPoint>
  std::vector<Plane> candidates(CancellationPoint& cancellation_point) const
  {
    std::vector<std::pair<double, Triangle> > by_area;
    m_builder.for_each_triangle([&](const Triangle& t, auto) {
      cancellation_point();
      by_area.emplace_back(-doubled_area_vector(t).squared_length(), t);
    });
    const std::size_t n = (std::min)(by_area.size(), TRIANGLES_LOOKED_AT);
    std::partial_sort(by_area.begin(), by_area.begin() + std::ptrdiff_t(n), by_area.end());
    std::vector<Plane> planes;
    for (std::size_t k = 0; k != n; ++k) {
      const Local_vector normal = doubled_area_vector(by_area[k].second);
      const double length = std::sqrt(normal.squared_length());
      if (length > 0.)
        planes.push_back(Plane{ length / 2, m_points[by_area[k].second[0]], normal / length });
    }
    return planes;
  }

  Local_vector doubled_area_vector(const Triangle& t) const
  {
    return cross_product(m_points[t[1]] - m_points[t[0]], m_points[t[2]] - m_points[t[0]]);
  }

  // Whether as many points are in the plane as in a parallel one, and none elsewhere, but for rounding.
  template <typename CancellationPoint>
  bool find_ends(const Plane& plane, CancellationPoint& cancellation_point)
  {
    const double tolerance = ROUNDING_OF_FIVE_DIGITS * std::sqrt(plane.area);
    double top = 0.;
    m_base.clear();
    m_top.clear();
    for (Point_index p = 0; p != m_points.size(); ++p) {
      cancellation_point();
      const double height = plane.normal * (m_points[p] - plane.origin);
      if (std::abs(height) <= tolerance) {
        m_base.push_back(p);
        continue;
      }
      if (m_top.empty())
        top = height;
      if (!(std::abs(height - top) <= tolerance))
        return false;
      m_top.push_back(p);
    }
    return m_base.size() == m_top.size();
  }

  template <typename CancellationPoint>
  bool replace_surface(const Plane& plane, CancellationPoint& cancellation_point)
  {
    Sheet_prism prism(m_points);
    std::vector<Triangle> triangles = prism(m_base, plane.normal, m_top, cancellation_point);
    if (triangles.empty())
      return false;
    std::vector<Point_index> all(m_points.size());
    std::iota(all.begin(), all.end(), Point_index(0));
    return !exchange_triangles(m_builder, all, std::move(triangles), cancellation_point).empty();
  }

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  std::vector<Point_index> m_base, m_top; // increasing
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PRISM_RECOGNITION_H

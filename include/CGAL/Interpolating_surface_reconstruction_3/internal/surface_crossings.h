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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_CROSSINGS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_CROSSINGS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Box_hierarchy.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_intersection.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Finds where triangles that were attached late cross the surface: those between stars that agree and
// those of a labelling do not cross each other.
template <typename Builder>
class Surface_crossings
{
public:
  using Triangle_index = typename Builder::Triangle_index;

  // Two points of triangles that cross, the smaller one first.
  using Crossing = std::pair<Point_index, Point_index>;

  Surface_crossings(const std::vector<Local_point>& points, const Builder& builder)
    : m_points(points), m_builder(builder)
  { }

  // Crossings of the triangles with `is_suspect(triangle)` stored from `first` on with any others, sorted, among those
  // with `is_wanted(triangle)`. Where the boxes of very many pairs meet, as of thin triangles, each of the former triangles
  // counts as one that crosses itself. `cancellation_point()` is called again and again and may throw.
  template <typename IsSuspect, typename IsWanted, typename CancellationPoint>
  std::vector<Crossing> operator()(Triangle_index first, const IsSuspect& is_suspect, const IsWanted& is_wanted,
                                   CancellationPoint& cancellation_point)
  {
    m_late.clear();
    m_crossings.clear();
    for (Triangle_index t = first; t != m_builder.number_of_stored_triangles(); ++t)
      if (!m_builder.is_removed(t) && is_wanted(m_builder.triangle(t)) && is_suspect(m_builder.triangle(t)) &&
          !is_degenerate(m_builder.triangle(t)))
        m_late.push_back(m_builder.triangle(t));
    if (!m_late.empty())
      cross_with_surface(is_wanted, cancellation_point);
    std::sort(m_crossings.begin(), m_crossings.end());
    m_crossings.erase(std::unique(m_crossings.begin(), m_crossings.end()), m_crossings.end());
    return std::move(m_crossings);
  }

private:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Triangle = typename Builder::Triangle;

  struct Too_many_pairs
  { };

  // Well-shaped triangles have about ten.
  static constexpr std::size_t PAIRS_PER_POINT = 64;

  template <typename IsWanted, typename CancellationPoint>
  void cross_with_surface(const IsWanted& is_wanted, CancellationPoint& cancellation_point)
  {
    std::vector<Bbox_3> boxes;
    boxes.reserve(m_late.size());
    for (const Triangle& t : m_late)
      boxes.push_back(bbox(t));
    const Box_hierarchy hierarchy(std::move(boxes), cancellation_point);
    m_pairs_left = PAIRS_PER_POINT * m_points.size();
    try {
      m_builder.for_each_triangle([&](const Triangle& t, Parity_union_find::Element) {
        cancellation_point();
        if (is_wanted(t))
          cross_with(t, hierarchy, cancellation_point);
      });
    } catch (const Too_many_pairs&) {
      m_crossings.clear();
      for (const Triangle& t : m_late)
        m_crossings.emplace_back(t[0], t[0]);
    }
  }

  template <typename CancellationPoint>
  void cross_with(const Triangle& t, const Box_hierarchy& hierarchy, CancellationPoint& cancellation_point)
  {
    m_near.clear();
    hierarchy.for_each_meeting(bbox(t), [this](Box_hierarchy::Box_index i) { m_near.push_back(i); });
    if (m_near.empty() || is_degenerate(t))
      return;
    for (Box_hierarchy::Box_index i : m_near) {
      cancellation_point();
      if (m_pairs_left-- == 0)
        throw Too_many_pairs();
      const Triangle& late = m_late[i];
      if (!is_same(late, t) && do_triangles_cross(late, t, [this](Point_index p) { return point(p); }))
        m_crossings.push_back(std::minmax(late[0], t[0]));
    }
  }

  static bool is_same(Triangle s, Triangle t)
  {
    std::sort(s.begin(), s.end());
    std::sort(t.begin(), t.end());
    return s == t;
  }

  Kernel::Point_3 point(Point_index p) const
  {
    return Kernel::Point_3(m_points[p].x(), m_points[p].y(), m_points[p].z());
  }

  // Predicates that are not exact may take it for a triangle.
  bool is_degenerate(const Triangle& t) const { return collinear(point(t[0]), point(t[1]), point(t[2])); }

  Bbox_3 bbox(const Triangle& t) const { return m_points[t[0]].bbox() + m_points[t[1]].bbox() + m_points[t[2]].bbox(); }

  const std::vector<Local_point>& m_points;
  const Builder& m_builder;
  std::vector<Triangle> m_late;
  std::vector<Box_hierarchy::Box_index> m_near; // late triangles whose boxes meet that of another triangle
  std::vector<Crossing> m_crossings;
  std::size_t m_pairs_left = 0;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_CROSSINGS_H

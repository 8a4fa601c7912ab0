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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FLAT_SHEET_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FLAT_SHEET_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_loops.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Tells the outlines of flat sheets from holes. Closing an outline would put a second sheet onto the
// first. If the points lie exactly in a plane the gate refuses that; here the sheet may have the
// thickness that rounding and noise give it, as long as no point is farther from the plane of the outline
// than the mean edge at it: the sampling does not tell anything thinner from a sheet. A wall as low as that
// is no sheet, because its triangles stand on the plane.
template <typename Builder>
class Flat_sheet
{
public:
  Flat_sheet(const std::vector<Local_point>& points, const Builder& builder)
    : m_points(points), m_builder(builder), m_visits_left(VISITS_PER_POINT * points.size())
  { }

  // The thickness is in mean edges at a point, 1 at most.
  template <typename CancellationPoint>
  bool is_outline(const Boundary_loop& loop, double maximum_thickness, CancellationPoint& cancellation_point)
  {
    if (loop.size() < 3 || !find_plane(loop) || !is_surface_inside(loop))
      return false;
    if (m_is_visited.empty())
      m_is_visited.assign(m_points.size(), 0);
    const bool is_flat = is_component_flat(loop, maximum_thickness, cancellation_point);
    for (Point_index p : m_component)
      m_is_visited[p] = 0;
    return is_flat;
  }

private:
  using Triangle = typename Builder::Triangle;

  // A surface has few outlines. More than that is no sheet.
  static constexpr std::size_t VISITS_PER_POINT = 8;

  bool find_plane(const Boundary_loop& loop)
  {
    m_origin = m_points[loop[0]];
    m_normal = loop_normal(m_points, loop);
    return m_normal.squared_length() > 0.;
  }

  // Whether the triangles at most edges of the loop lie on its inner side, where its filling would be.
  bool is_surface_inside(const Boundary_loop& loop) const
  {
    std::size_t inside = 0;
    for (std::size_t i = 0; i != loop.size(); ++i) {
      const Point_index p = loop[i], q = loop[(i + 1) % loop.size()], r = m_builder.opposite_vertex(p, q);
      if (r != NO_POINT && cross_product(m_normal, m_points[q] - m_points[p]) * (m_points[r] - m_points[p]) > 0.)
        ++inside;
    }
    return 2 * inside > loop.size();
  }

  template <typename CancellationPoint>
  bool is_component_flat(const Boundary_loop& loop, double maximum_thickness, CancellationPoint& cancellation_point)
  {
    m_component.clear();
    for (Point_index p : loop)
      visit(p);
    double area = 0., projected_area = 0.;
    for (std::size_t i = 0; i != m_component.size(); ++i) {
      cancellation_point();
      const Point_index p = m_component[i];
      double edge_length = 0.; // each edge of a closed fan twice
      std::size_t edges = 0;
      m_builder.for_each_triangle_at(p, [&](const Triangle& t) {
        const Local_vector n = cross_product(m_points[t[1]] - m_points[t[0]], m_points[t[2]] - m_points[t[0]]);
        area += std::sqrt(n.squared_length() * m_normal.squared_length());
        projected_area += std::abs(n * m_normal);
        for (Point_index q : t)
          if (q != p) {
            edge_length += std::sqrt((m_points[q] - m_points[p]).squared_length());
            ++edges;
            visit(q);
          }
      });
      const double thickness = edges == 0 ? 0. : maximum_thickness * edge_length / double(edges);
      const double height = m_normal * (m_points[p] - m_origin);
      if (m_visits_left == 0 || height * height > thickness * thickness * m_normal.squared_length())
        return false;
      --m_visits_left;
    }
    return 2. * projected_area > area;
  }

  void visit(Point_index p)
  {
    if (m_is_visited[p])
      return;
    m_is_visited[p] = 1;
    m_component.push_back(p);
  }

  const std::vector<Local_point>& m_points;
  const Builder& m_builder;
  std::size_t m_visits_left;
  Local_point m_origin;
  Local_vector m_normal;
  std::vector<unsigned char> m_is_visited;
  std::vector<Point_index> m_component;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FLAT_SHEET_H

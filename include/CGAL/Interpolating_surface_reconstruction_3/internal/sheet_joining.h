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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SHEET_JOINING_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SHEET_JOINING_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Sheet_prism.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_loops.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/cell_signs.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/label_relaxation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelled_surface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_area.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_exchange.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Joins flat sheets to one closed surface. A machine part that is cut out of a plate has points on its edges only: the
// stars agree on its two faces, and that each of them ends at its outline. One sheet cannot be closed by triangles
// between its points, but several can if each has all others on one side, which then is the inside: the linear
// implicit function of the normals that this gives to the sheets (thesis 5.2) labels the cells of all points.
template <typename ConcurrencyTag, typename Builder>
class Sheet_joining
{
public:
  Sheet_joining(const std::vector<Local_point>& points, Builder& builder) : m_points(points), m_builder(builder) { }

  // `outlines` are those of flat sheets. Returns whether the surface has changed; ends early if cancelled.
  template <typename Progress>
  bool operator()(const std::vector<Boundary_loop>& outlines, Progress& progress)
  {
    if (outlines.size() < 2)
      return false;
    Cancellation_point<Progress> cancellation_point(progress);
    try {
      collect_sheets(outlines, cancellation_point);
      if (m_sheets.size() < 2 || m_sheets.size() > MAXIMUM_SHEETS || !find_normals(cancellation_point))
        return false;
      return join_ends_of_prism(cancellation_point) || join(progress, cancellation_point);
    } catch (const Cancelled&) {
    }
    return false;
  }

private:
  using Triangle = std::array<Point_index, 3>;

  // That of a cube with two opposite faces sampled. Sheets farther apart than they are wide are two parts, unless they
  // are nearer than their points.
  static constexpr double MAXIMUM_GROWTH = 3.;

  // All points are looked at from each.
  static constexpr std::size_t MAXIMUM_SHEETS = 256;

  // Of areas, and of heights over the mean edge of an outline.
  static constexpr double ROUNDING = 1e-9;

  struct Sheet
  {
    std::vector<Point_index> points; // increasing
    Local_point origin;
    Local_vector normal;
    double mean_edge; // of the outline
    double thickness; // no point is higher over its plane
  };

  template <typename CancellationPoint>
  void collect_sheets(const std::vector<Boundary_loop>& outlines, CancellationPoint& cancellation_point)
  {
    m_is_visited.assign(m_points.size(), 0);
    m_sheets.clear();
    for (const Boundary_loop& outline : outlines) {
      if (m_is_visited[outline.front()])
        continue;
      m_sheets.push_back(sheet_in(outline));
      Sheet& sheet = m_sheets.back();
      std::vector<Point_index>& points = sheet.points;
      m_is_visited[outline.front()] = 1;
      points.push_back(outline.front());
      for (std::size_t i = 0; i != points.size(); ++i) {
        cancellation_point();
        sheet.thickness = (std::max)(sheet.thickness, std::abs(height(sheet, points[i])));
        m_builder.for_each_triangle_at(points[i], [&](const Triangle& t) {
          for (Point_index p : t)
            if (!m_is_visited[p]) {
              m_is_visited[p] = 1;
              points.push_back(p);
            }
        });
      }
      std::sort(points.begin(), points.end());
    }
  }

  double height(const Sheet& sheet, Point_index p) const { return sheet.normal * (m_points[p] - sheet.origin); }

  // Without its points, as thick as rounding may make it.
  Sheet sheet_in(const Boundary_loop& outline) const
  {
    const Local_vector normal = loop_normal(m_points, outline);
    const double mean_edge = mean_edge_of_loop(m_points, outline);
    return Sheet{
      {}, m_points[outline.front()], normal / std::sqrt(normal.squared_length()), mean_edge, ROUNDING * mean_edge
    };
  }

  // Turns the normal of each sheet away from all other sheets; false if they are not all on one side.
  template <typename CancellationPoint>
  bool find_normals(CancellationPoint& cancellation_point)
  {
    m_normals.assign(m_points.size(), Local_vector(0, 0, 0));
    m_are_near = true;
    for (Sheet& sheet : m_sheets) {
      bool is_above = false, is_below = false, is_beside = false, is_near = false;
      for (const Sheet& other : m_sheets) {
        if (&other == &sheet)
          continue;
        for (Point_index p : other.points) {
          cancellation_point();
          const double h = height(sheet, p);
          is_above = is_above || h > sheet.thickness;
          is_below = is_below || h < -sheet.thickness;
          is_beside = is_beside || std::abs(h) <= sheet.thickness;
          is_near = is_near || std::abs(h) <= sheet.mean_edge;
        }
      }
      if (is_beside || is_above == is_below)
        return false;
      m_are_near = m_are_near && is_near;
      for (Point_index p : sheet.points)
        m_normals[p] = is_above ? -sheet.normal : sheet.normal;
    }
    return true;
  }

  template <typename CancellationPoint>
  bool join_ends_of_prism(CancellationPoint& cancellation_point)
  {
    if (m_sheets.size() != 2)
      return false;
    const Sheet &base = m_sheets[0], &top = m_sheets[1];
    Sheet_prism prism(m_points);
    std::vector<Triangle> joined = prism(base.points, base.normal, top.points, cancellation_point);
    return !joined.empty() &&
           !exchange_triangles(m_builder, all_points(), std::move(joined), cancellation_point).empty();
  }

  // Increasing.
  std::vector<Point_index> all_points() const
  {
    std::vector<Point_index> points;
    for (const Sheet& sheet : m_sheets)
      points.insert(points.end(), sheet.points.begin(), sheet.points.end());
    std::sort(points.begin(), points.end());
    return points;
  }

  template <typename Progress, typename CancellationPoint>
  bool join(Progress& progress, CancellationPoint& cancellation_point)
  {
    const std::vector<Point_index> points = all_points();
    const Cell_complex cells(m_points, points, cancellation_point);
    if (cells.size() == 0)
      return false;
    const Cell_signs signs(cells, m_points, m_normals);
    Oriented_labelling labelling(cells, m_points, m_normals,
                                 signs.template compute<ConcurrencyTag>([&] { return progress.advance(0.); }));
    relax_labels(cells, labelling, cancellation_point);
    make_manifold(cells, labelling, cancellation_point);
    std::vector<Triangle> joined = facets_between_labels(cells, labelling, cancellation_point);
    if (!has_all(points, joined) || !(m_are_near || is_small(joined, triangles_at(points))))
      return false;
    return !exchange_triangles(m_builder, points, std::move(joined), cancellation_point).empty();
  }

  bool is_small(const std::vector<Triangle>& joined, const std::vector<Triangle>& sheets) const
  {
    return surface_area(m_points, joined) <= (1. + ROUNDING) * MAXIMUM_GROWTH * surface_area(m_points, sheets);
  }

  std::vector<Triangle> triangles_at(const std::vector<Point_index>& points) const
  {
    std::vector<Triangle> result;
    for (Point_index p : points)
      m_builder.for_each_triangle_at(p, [&](const Triangle& t) {
        if (p == *std::min_element(t.begin(), t.end()))
          result.push_back(t);
      });
    return result;
  }

  static bool has_all(const std::vector<Point_index>& points, const std::vector<Triangle>& triangles)
  {
    std::vector<Point_index> used;
    for (const Triangle& t : triangles)
      used.insert(used.end(), t.begin(), t.end());
    std::sort(used.begin(), used.end());
    return std::includes(used.begin(), used.end(), points.begin(), points.end());
  }

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  std::vector<Sheet> m_sheets;
  std::vector<Local_vector> m_normals;
  bool m_are_near = false;                 // each to another one, as points of one sheet are
  std::vector<unsigned char> m_is_visited; // of each point
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SHEET_JOINING_H

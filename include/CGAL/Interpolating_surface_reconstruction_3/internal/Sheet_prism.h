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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SHEET_PRISM_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SHEET_PRISM_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Sheet_curves.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The prism, or the frustum of a pyramid, between two flat sheets with the same points but for their place and size, if
// the points lie along curves: nobody samples the two ends of a part alike unless they are its edges. Its ends are what
// is between the curves, and its walls are plane quadrangles on their edges, however far the ends are from each other.
class Sheet_prism
{
public:
  using Triangle = std::array<Point_index, 3>;

  explicit Sheet_prism(const std::vector<Local_point>& points) : m_points(points) { }

  // The triangles of the prism; none if it is no prism. The points of each sheet increase; `normal` is that of the base.
  // `cancellation_point()` is called again and again and may throw.
  template <typename CancellationPoint>
  std::vector<Triangle> operator()(const std::vector<Point_index>& base, const Local_vector& normal,
                                   const std::vector<Point_index>& top, CancellationPoint&& cancellation_point)
  {
    std::vector<Triangle> result;
    if (base.size() != top.size())
      return result;
    const Sheet_curves curves(m_points, base, normal, cancellation_point);
    if (!curves.are_closed() || !find_images(base, curves, top, cancellation_point))
      return result;
    curves.for_each_triangle_inside([&](std::size_t i, std::size_t j, std::size_t k) {
      result.push_back(Triangle{ { base[i], base[j], base[k] } });
      result.push_back(Triangle{ { m_images[i], m_images[j], m_images[k] } });
    });
    curves.for_each_curve_edge([&](std::size_t i, std::size_t j) {
      result.push_back(Triangle{ { base[i], base[j], m_images[j] } });
      result.push_back(Triangle{ { base[i], m_images[j], m_images[i] } });
    });
    return result;
  }

private:
  // How far a point of the top may be from where it should be, in nearest distances: no other can be as near.
  static constexpr double TOLERANCE = .125;

  struct Frame
  {
    Local_point centroid;
    double radius; // root mean square
  };

  Frame frame_of(const std::vector<Point_index>& sheet) const
  {
    Local_vector sum(0, 0, 0);
    for (Point_index p : sheet)
      sum = sum + (m_points[p] - m_points[sheet.front()]);
    Frame result{ m_points[sheet.front()] + sum / double(sheet.size()), 0. };
    for (Point_index p : sheet)
      result.radius += (m_points[p] - result.centroid).squared_length();
    result.radius = std::sqrt(result.radius / double(sheet.size()));
    return result;
  }

  // Finds the point of the top for each of the base; returns whether there is one.
  template <typename CancellationPoint>
  bool find_images(const std::vector<Point_index>& base, const Sheet_curves& curves,
                   const std::vector<Point_index>& top, CancellationPoint& cancellation_point)
  {
    const Frame from = frame_of(base), to = frame_of(top);
    const double scale = to.radius / from.radius;
    std::vector<std::pair<double, Point_index> > sorted; // along an axis
    sorted.reserve(top.size());
    const int axis = longest_axis(top);
    for (Point_index p : top)
      sorted.emplace_back(m_points[p][axis], p);
    std::sort(sorted.begin(), sorted.end());
    m_images.clear();
    for (std::size_t i = 0; i != base.size(); ++i) {
      cancellation_point();
      const Local_point target = to.centroid + scale * (m_points[base[i]] - from.centroid);
      const double tolerance = TOLERANCE * scale * curves.nearest_distance(i);
      auto it =
        std::lower_bound(sorted.begin(), sorted.end(), std::make_pair(target[axis] - tolerance, Point_index(0)));
      while (it != sorted.end() && it->first <= target[axis] + tolerance &&
             !((m_points[it->second] - target).squared_length() <= tolerance * tolerance))
        ++it;
      if (it == sorted.end() || it->first > target[axis] + tolerance)
        return false;
      m_images.push_back(it->second);
    }
    std::vector<Point_index> used = m_images;
    std::sort(used.begin(), used.end());
    return used == top;
  }

  int longest_axis(const std::vector<Point_index>& sheet) const
  {
    int longest = 0;
    double length = -1.;
    for (int axis = 0; axis != 3; ++axis) {
      const auto ends = std::minmax_element(sheet.begin(), sheet.end(), [&](Point_index p, Point_index q) {
        return m_points[p][axis] < m_points[q][axis];
      });
      const double extent = m_points[*ends.second][axis] - m_points[*ends.first][axis];
      if (extent > length) {
        length = extent;
        longest = axis;
      }
    }
    return longest;
  }

  const std::vector<Local_point>& m_points;
  std::vector<Point_index> m_images; // of each point of the base
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SHEET_PRISM_H

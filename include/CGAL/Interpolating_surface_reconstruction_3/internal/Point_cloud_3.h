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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_POINT_CLOUD_3_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_POINT_CLOUD_3_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Morton_order.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The points of a reconstruction: finite, distinct in double precision and in an order that depends on their positions
// only. Every point is kept twice: as the user's `Point_3`, for predicates, and in double
// coordinates near the origin, for measures. The latter are shifted only where the subtraction is
// exact, and scaled by a power of two, so that they lose nothing.
template <typename Traits>
class Point_cloud_3
{
public:
  using Traits_class = Traits;
  using Point_3 = typename Traits::Point_3;

  template <typename PointRange, typename PointMap>
  Point_cloud_3(const PointRange& range, PointMap point_map, const Traits& traits)
    : Point_cloud_3(
        range, point_map, traits, [](const auto&) { return true; }, [] { return true; })
  { }

  // Elements for which `is_usable(element)` is false are set aside like points that are not finite.
  // If go_further() is false, the cloud is of no use.
  template <typename PointRange, typename PointMap, typename IsUsable, typename GoFurther>
  Point_cloud_3(const PointRange& range, PointMap point_map, const Traits& traits, const IsUsable& is_usable,
                const GoFurther& go_further)
    : m_traits(traits)
  {
    copy_finite_points(range, point_map, is_usable);
    set_local_coordinates();
    if (!go_further())
      return;
    const std::vector<Point_index> order = sorted_order();
    if (!go_further())
      return;
    permute(order);
    if (!go_further())
      return;
    merge_duplicates();
    go_further();
  }

  Point_index size() const { return static_cast<Point_index>(m_points.size()); }
  const Traits& traits() const { return m_traits; }

  // The user's point.
  const Point_3& point(Point_index i) const { return m_points[i]; }
  // The point for measures; the longest side of the bounding box is in [1, 2).
  const Local_point& position(Point_index i) const { return m_positions[i]; }
  const std::vector<Local_point>& positions() const { return m_positions; }
  // Position in the user's range of the first of the points that coincide here.
  std::size_t input_index(Point_index i) const { return m_input_indices[i]; }

  // A length in the user's unit as a length between positions.
  double local_length(double length) const { return length * m_scale.first * m_scale.second; }

  // The inverse of length and point for measures; rounded.
  double global_length(double length) const { return length / m_scale.first / m_scale.second; }

  Point_3 global_point(const Local_point& p) const
  {
    using FT = typename Traits::FT;
    return m_traits.construct_point_3_object()(FT(global_length(p.x()) + m_shift[0]),
                                               FT(global_length(p.y()) + m_shift[1]),
                                               FT(global_length(p.z()) + m_shift[2]));
  }

  // A point in the user's coordinates as a point for measures.
  Local_point local_point(double x, double y, double z) const
  {
    // the sum makes a negative zero positive, which an angle tells apart
    return Local_point(local_length(x - m_shift[0]) + 0., local_length(y - m_shift[1]) + 0.,
                       local_length(z - m_shift[2]) + 0.);
  }

  std::size_t number_of_duplicates() const { return m_duplicates; }
  std::size_t number_of_non_finite_points() const { return m_non_finite; }

private:
  template <typename PointRange, typename PointMap, typename IsUsable>
  void copy_finite_points(const PointRange& range, PointMap point_map, const IsUsable& is_usable)
  {
    const auto begin_coordinates = m_traits.construct_cartesian_const_iterator_3_object();
    const std::size_t n = static_cast<std::size_t>(std::distance(range.begin(), range.end()));
    m_points.reserve(n);
    m_positions.reserve(n);
    m_input_indices.reserve(n);
    std::size_t index = 0;
    for (auto it = range.begin(); it != range.end(); ++it, ++index) {
      if (index >= NO_POINT)
        throw std::invalid_argument("points: more than 2^32 - 2 points");
      const Point_3& p = get(point_map, *it);
      auto c = begin_coordinates(p);
      const double x = CGAL::to_double(*c++), y = CGAL::to_double(*c++), z = CGAL::to_double(*c);
      if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z) || !is_usable(*it)) {
        ++m_non_finite;
        continue;
      }
      m_points.push_back(p);
      m_positions.emplace_back(x, y, z);
      m_input_indices.push_back(static_cast<Point_index>(index));
    }
  }

  void set_local_coordinates()
  {
    std::array<double, 3> low, high;
    bounding_box(low, high);
    double extent = 0.;
    for (std::size_t a = 0; a != 3; ++a)
      // halved: the difference of finite numbers may overflow
      extent = (std::max)(extent, high[a] / 2 - low[a] / 2);
    m_scale = extent > 0. ? power_of_two(-std::ilogb(extent) - 1) : std::make_pair(1., 1.);
    m_shift = { exact_shift(low[0], high[0]), exact_shift(low[1], high[1]), exact_shift(low[2], high[2]) };
    for (Local_point& p : m_positions)
      p = local_point(p.x(), p.y(), p.z());
  }

  void bounding_box(std::array<double, 3>& low, std::array<double, 3>& high) const
  {
    low = high = std::array<double, 3>{};
    for (std::size_t i = 0; i != m_positions.size(); ++i)
      for (std::size_t a = 0; a != 3; ++a) {
        const double c = m_positions[i][static_cast<int>(a)];
        low[a] = i == 0 ? c : (std::min)(low[a], c);
        high[a] = i == 0 ? c : (std::max)(high[a], c);
      }
  }

  // c - shift is exact for all c in [low, high] if shift <= 2 c and c <= 2 shift (Sterbenz' lemma).
  static double exact_shift(double low, double high)
  {
    if ((low > 0. && high <= 2. * low) || (high < 0. && low >= 2. * high))
      return low / 2 + high / 2;
    return 0.;
  }

  // 2^exponent as a product of two factors, since 2^-exponent of a denormal number overflows.
  static std::pair<double, double> power_of_two(int exponent)
  {
    return { std::ldexp(1., exponent / 2), std::ldexp(1., exponent - exponent / 2) };
  }

  // Equal positions become adjacent: the order of the exact points alone may have another point between
  // two that differ by less than a position can show.
  std::vector<Point_index> sorted_order() const
  {
    const auto less_xyz = m_traits.less_xyz_3_object();
    const auto less = [&](Point_index i, Point_index j) {
      for (int a = 0; a != 3; ++a)
        if (m_positions[i][a] != m_positions[j][a])
          return m_positions[i][a] < m_positions[j][a];
      if (less_xyz(m_points[i], m_points[j]))
        return true;
      return !less_xyz(m_points[j], m_points[i]) && i < j;
    };
    return Morton_sorter<decltype(less)>(m_positions, less)();
  }

  void permute(const std::vector<Point_index>& order)
  {
    m_points = permuted(m_points, order);
    m_positions = permuted(m_positions, order);
    m_input_indices = permuted(m_input_indices, order);
  }

  template <typename T>
  static std::vector<T> permuted(const std::vector<T>& values, const std::vector<Point_index>& order)
  {
    std::vector<T> result;
    result.reserve(order.size());
    for (Point_index i : order)
      result.push_back(values[i]);
    return result;
  }

  // The sort has made equal points adjacent, first in the range first. Points that only their exact
  // coordinates tell apart are merged, too: no star could tell them apart, and where they are many each
  // would have all others as its nearest neighbors.
  void merge_duplicates()
  {
    const auto equal = m_traits.equal_3_object();
    std::size_t kept = 0;
    for (std::size_t i = 0; i != m_points.size(); ++i) {
      if (kept != 0 && (m_positions[kept - 1] == m_positions[i] || equal(m_points[kept - 1], m_points[i])))
        continue;
      if (kept != i) {
        m_points[kept] = m_points[i];
        m_positions[kept] = m_positions[i];
        m_input_indices[kept] = m_input_indices[i];
      }
      ++kept;
    }
    m_duplicates = m_points.size() - kept;
    m_points.resize(kept);
    m_positions.resize(kept);
    m_input_indices.resize(kept);
  }

  Traits m_traits;
  std::vector<Point_3> m_points;
  std::vector<Local_point> m_positions;
  std::vector<Point_index> m_input_indices;
  std::array<double, 3> m_shift;
  std::pair<double, double> m_scale;
  std::size_t m_duplicates = 0, m_non_finite = 0;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_POINT_CLOUD_3_H

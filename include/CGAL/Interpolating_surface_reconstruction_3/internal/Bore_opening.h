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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BORE_OPENING_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BORE_OPENING_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Flat_caps.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/orientation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_crossings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_exchange.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Opens bores that are closed by flat caps at both ends (see Flat_caps), as where they have points on their rims only:
// stars may even agree on these caps. Two of them that turn their backs to each other are exchanged for the wall between
// them, if the surface stays closed and the wall crosses nothing.
template <typename Builder>
class Bore_opening
{
public:
  using Triangle = typename Builder::Triangle;

  Bore_opening(const std::vector<Local_point>& points, Builder& builder) : m_points(points), m_builder(builder) { }

  // For a closed surface; ends early if cancelled.
  template <typename Progress>
  void operator()(Progress& progress)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    try {
      Triangles triangles;
      m_builder.for_each_triangle([&](const Triangle& t, auto) { triangles.push_back(t); });
      if (Flat_caps(m_points, triangles).caps().size() < 2)
        return;
      triangles = oriented_triangles(m_points, {}, m_builder, [&] { return progress.advance(0.); });
      const Flat_caps flat(m_points, triangles);
      if (flat.caps().size() <= MAXIMUM_CAPS)
        open_pairs(flat.caps(), cancellation_point);
    } catch (const Cancelled&) {
    }
  }

private:
  using Triangles = std::vector<Triangle>;
  using Cap = Flat_caps::Cap;
  using Rim = std::vector<Point_index>;

  // All pairs of them are looked at.
  static constexpr std::size_t MAXIMUM_CAPS = 4096;

  // Of a point of either rim; rims of two thousand points have as many.
  static constexpr std::size_t MAXIMUM_RIM_PAIRS = 1 << 22;

  struct Pair
  {
    double squared_distance;
    std::size_t first, second;
    bool operator<(const Pair& other) const
    {
      return std::tie(squared_distance, first, second) < std::tie(other.squared_distance, other.first, other.second);
    }
  };

  // What has taken the place of two caps.
  struct Bore
  {
    std::vector<typename Builder::Removed_triangle> caps;
    Triangles wall;
  };

  template <typename CancellationPoint>
  void open_pairs(const std::vector<Cap>& caps, CancellationPoint& cancellation_point)
  {
    const auto next = static_cast<typename Builder::Triangle_index>(m_builder.number_of_stored_triangles());
    std::vector<unsigned char> is_open(caps.size(), 0);
    std::vector<Bore> bores;
    for (const Pair& pair : find_pairs(caps, cancellation_point))
      if (is_open[pair.first] == 0 && is_open[pair.second] == 0 &&
          open(caps[pair.first], caps[pair.second], bores, cancellation_point))
        is_open[pair.first] = is_open[pair.second] = 1;
    Triangles crossing;
    Surface_crossings<Builder>(m_points, m_builder)
      .for_each(
        next, [](const Triangle&) { return true; }, [&](const Triangle& t, const Triangle&) { crossing.push_back(t); },
        cancellation_point);
    std::sort(crossing.begin(), crossing.end());
    for (const Bore& bore : bores)
      if (std::any_of(bore.wall.begin(), bore.wall.end(), [&](const Triangle& t) {
            return std::binary_search(crossing.begin(), crossing.end(), stored(t));
          }))
        close(bore);
  }

  Triangle stored(const Triangle& t) const { return m_builder.triangle(m_builder.find_triangle(t[0], t[1], t[2])); }

  // Each of which has the center of the other one behind it, inside; the nearest ones first.
  template <typename CancellationPoint>
  std::vector<Pair> find_pairs(const std::vector<Cap>& caps, CancellationPoint& cancellation_point) const
  {
    std::vector<Local_point> centers;
    for (const Cap& cap : caps)
      centers.push_back(center(cap));
    std::vector<Pair> result;
    for (std::size_t i = 0; i != caps.size(); ++i) {
      cancellation_point(caps.size());
      for (std::size_t j = i + 1; j != caps.size(); ++j)
        if (is_behind(caps[i], centers[i], centers[j]) && is_behind(caps[j], centers[j], centers[i]))
          result.push_back(Pair{ (centers[j] - centers[i]).squared_length(), i, j });
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  Local_point center(const Cap& cap) const
  {
    const Local_point& origin = m_points[cap.rim.front()];
    Local_vector sum(0, 0, 0);
    for (Point_index p : cap.rim)
      sum = sum + (m_points[p] - origin);
    return origin + sum / double(cap.rim.size());
  }

  // Whether the point is inside and no farther aside than the points of the cap.
  bool is_behind(const Cap& cap, const Local_point& center, const Local_point& p) const
  {
    const Local_vector d = p - center;
    if (!(d * cap.normal < 0.))
      return false;
    const double aside = cross_product(d, cap.normal).squared_length() / cap.normal.squared_length();
    return std::any_of(cap.rim.begin(), cap.rim.end(),
                       [&](Point_index q) { return (m_points[q] - center).squared_length() > aside; });
  }

  // Returns whether the surface stays a closed manifold; else all is as it was.
  template <typename CancellationPoint>
  bool open(const Cap& first, const Cap& second, std::vector<Bore>& bores, CancellationPoint& cancellation_point)
  {
    if (first.rim.size() > MAXIMUM_RIM_PAIRS / second.rim.size())
      return false;
    Rim other = second.rim; // seen from the same side
    std::reverse(other.begin(), other.end());
    Triangles caps(first.triangles);
    caps.insert(caps.end(), second.triangles.begin(), second.triangles.end());
    Bore bore{ {}, find_wall(first.rim, other) };
    auto stored = exchange_triangles(m_builder, caps, bore.wall, 0, cancellation_point);
    if (!stored)
      return false;
    bore.caps = std::move(*stored);
    const auto is_closed = [&](Point_index p) { return m_builder.is_fan_closed(p); };
    if (std::all_of(first.rim.begin(), first.rim.end(), is_closed) &&
        std::all_of(other.begin(), other.end(), is_closed)) {
      bores.push_back(std::move(bore));
      return true;
    }
    close(bore);
    return false;
  }

  void close(const Bore& bore)
  {
    for (const Triangle& t : bore.wall)
      m_builder.remove(m_builder.find_triangle(t[0], t[1], t[2]));
    for (const auto& t : bore.caps)
      m_builder.restore(t);
  }

  // From the nearest two points of the rims on, by the shorter diagonals.
  Triangles find_wall(const Rim& first, const Rim& second) const
  {
    std::size_t i = 0, j = 0;
    for (std::size_t k = 0; k != first.size(); ++k)
      for (std::size_t l = 0; l != second.size(); ++l)
        if (squared_length(first[k], second[l]) < squared_length(first[i], second[j])) {
          i = k;
          j = l;
        }
    Triangles wall;
    std::size_t left = first.size(), left_of_second = second.size();
    while (left + left_of_second != 0) {
      const Point_index p = first[i], q = second[j], next = first[(i + 1) % first.size()],
                        next_of_second = second[(j + 1) % second.size()];
      if (left_of_second == 0 || (left != 0 && squared_length(next, q) <= squared_length(p, next_of_second))) {
        wall.push_back(Triangle{ { p, q, next } });
        i = (i + 1) % first.size();
        --left;
      } else {
        wall.push_back(Triangle{ { p, q, next_of_second } });
        j = (j + 1) % second.size();
        --left_of_second;
      }
    }
    return wall;
  }

  double squared_length(Point_index p, Point_index q) const { return (m_points[q] - m_points[p]).squared_length(); }

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BORE_OPENING_H

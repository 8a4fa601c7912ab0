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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACE_RIMS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACE_RIMS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_loops.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/flatness.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The plane of a flat face.
struct Face_plane
{
  Local_point origin, second; // on it
  Local_vector normal;        // of unit length
  double area, mean_edge;     // of the loop that it was found by
};

// Finds the boundary loops of a surface that are rims of flat faces, where walls end.
template <typename Builder>
class Face_rims
{
public:
  using Triangle = typename Builder::Triangle;

  // A face with a hole in it has more edges around it than gaps between triangles have, which are many.
  static constexpr std::size_t MINIMUM_OUTER_SIZE = 6;

  // How far the points of a loop may be from its plane, in its mean edges: a loop on a curved surface is no face.
  static constexpr double FLATNESS = .125;

  Face_rims(const std::vector<Local_point>& points, const Builder& builder, double flatness)
    : m_points(points), m_builder(builder), m_flatness(flatness)
  { }

  // That of the loop, if it is a rim.
  std::optional<Face_plane> plane(const Boundary_loop& loop) const
  {
    // Once more without what the wall lacks, which tilts the plane.
    Face_plane result{};
    Boundary_loop rim = loop;
    for (int pass = 0; pass != 2; ++pass) {
      const Local_vector normal = loop_normal(m_points, rim);
      const double length = std::sqrt(normal.squared_length());
      if (!(length > 0.))
        return {};
      result =
        Face_plane{ m_points[rim[0]], m_points[rim[1]], normal / length, length / 2, mean_edge_of_loop(m_points, rim) };
      const std::vector<Boundary_loop> rims = operator()(loop, result);
      if (rims.empty())
        return {};
      rim = *std::max_element(rims.begin(), rims.end(),
                              [](const Boundary_loop& a, const Boundary_loop& b) { return a.size() < b.size(); });
    }
    return result;
  }

  // Whether what the face leaves of the loop, in gaps of the wall, is more than a gap between triangles.
  bool has_long_gap(const Boundary_loop& loop, const Face_plane& plane) const
  {
    return find_gaps(loop, plane).longest + 2 >= MINIMUM_OUTER_SIZE; // two of the points are in the plane
  }

  // The cycles of the loop in the plane: without points beside it, where the wall below has gaps, and apart from each other
  // where they pinch, without small ones, which are gaps, too. None if gaps are many, or if edges of the cycles are in the
  // surface already.
  std::vector<Boundary_loop> operator()(const Boundary_loop& loop, const Face_plane& plane) const
  {
    constexpr std::size_t POINTS_PER_GAP = 4;
    const Gaps gaps = find_gaps(loop, plane);
    if (gaps.points_in_plane < 3 || gaps.points_in_plane < POINTS_PER_GAP * gaps.number)
      return {};
    const std::size_t n = loop.size();
    std::vector<Boundary_loop> rims;
    Boundary_loop rim;
    const std::vector<Point_index> pinches = repeated(loop);
    const auto is_pinch = [&](Point_index p) { return std::binary_search(pinches.begin(), pinches.end(), p); };
    const std::size_t first = std::size_t(
      std::find_if(loop.begin(), loop.end(), [&](Point_index p) { return is_in_plane(p, plane) && !is_pinch(p); }) -
      loop.begin());
    for (std::size_t i = first; i != first + n; ++i) {
      const Point_index p = loop[i % n];
      if (!is_in_plane(p, plane))
        continue;
      const auto before = is_pinch(p) ? std::find(rim.rbegin(), rim.rend(), p) : rim.rend();
      if (before == rim.rend()) {
        rim.push_back(p);
        continue;
      }
      const auto begin = before.base() - 1;
      if (rim.end() - begin >= std::ptrdiff_t(MINIMUM_OUTER_SIZE))
        rims.emplace_back(begin, rim.end());
      rim.erase(begin + 1, rim.end());
    }
    if (rim.size() >= 3)
      rims.push_back(std::move(rim));
    for (const Boundary_loop& r : rims)
      for (std::size_t i = 0; i != r.size(); ++i)
        if (m_builder.number_of_triangles(r[i], r[(i + 1) % r.size()]) > 1)
          return {};
    return rims;
  }

  bool is_in_plane(Point_index p, const Face_plane& plane) const
  {
    return std::abs(plane.normal * (m_points[p] - plane.origin)) <= m_flatness * plane.mean_edge;
  }

  // Triangles of a low wall are not, but thin ones of points on a line are, whose normal is that of rounding errors.
  bool is_in_plane(const Triangle& t, const Face_plane& plane) const
  {
    double height = 0.;
    for (Point_index p : t) {
      height = (std::max)(height, std::abs(plane.normal * (m_points[p] - plane.origin)));
      if (height > m_flatness * plane.mean_edge)
        return false;
    }
    const Local_vector n = cross_product(m_points[t[1]] - m_points[t[0]], m_points[t[2]] - m_points[t[0]]);
    const double cosine = n * plane.normal; // times the length of n
    return height <= ROUNDING_OF_SIX_DIGITS * plane.mean_edge || 2. * cosine * cosine > n.squared_length();
  }

private:
  struct Gaps
  {
    std::size_t points_in_plane, number, longest;
  };

  Gaps find_gaps(const Boundary_loop& loop, const Face_plane& plane) const
  {
    const std::size_t n = loop.size();
    const std::size_t first = static_cast<std::size_t>(
      std::find_if(loop.begin(), loop.end(), [&](Point_index p) { return is_in_plane(p, plane); }) - loop.begin());
    Gaps result{ 0, 0, 0 };
    std::size_t length = 0;
    for (std::size_t i = first; i != first + n; ++i)
      if (is_in_plane(loop[i % n], plane)) {
        ++result.points_in_plane;
        length = 0;
      } else {
        result.number += length == 0 ? 1u : 0u;
        result.longest = (std::max)(result.longest, ++length);
      }
    return result;
  }

  static std::vector<Point_index> repeated(Boundary_loop loop)
  {
    std::vector<Point_index> result;
    std::sort(loop.begin(), loop.end());
    for (std::size_t i = 1; i != loop.size(); ++i)
      if (loop[i] == loop[i - 1])
        result.push_back(loop[i]);
    return result;
  }

  const std::vector<Local_point>& m_points;
  const Builder& m_builder;
  const double m_flatness;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACE_RIMS_H

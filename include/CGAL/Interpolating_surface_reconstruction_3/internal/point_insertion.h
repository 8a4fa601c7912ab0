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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_POINT_INSERTION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_POINT_INSERTION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Crossing_test.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Nearest_neighbors.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Inserts the points that no triangle uses into the nearest triangle or edge of the surface at which that leads to no
// crossing, or into the nearest one if there is none.
template <typename Builder>
class Point_insertion
{
public:
  Point_insertion(const std::vector<Local_point>& points, const Point_octree_3& octree, double maximum_radius,
                  Builder& builder)
    : m_points(points), m_builder(builder), m_neighbors(points, octree, maximum_radius),
      m_crosses(points, octree, builder)
  { }

  // Returns the number of points that could not be inserted. Ends early if cancelled.
  template <typename Progress>
  std::size_t operator()(Progress& progress)
  {
    m_crosses.reset();
    std::vector<Point_index> unused;
    for (Point_index p : m_builder.open_points())
      if (m_builder.corners(p).empty())
        unused.push_back(p);
    std::sort(unused.begin(), unused.end());
    // A point may get a surface to lie on only when its neighbors have been inserted. A pass without an
    // insertion would repeat itself, as would the first one without a surface.
    std::size_t before = m_builder.number_of_points();
    for (std::size_t pass = 0; pass != MAXIMUM_PASSES && unused.size() < before && !progress.is_cancelled(); ++pass) {
      before = unused.size();
      unused.erase(
        std::remove_if(unused.begin(), unused.end(), [&](Point_index p) { return progress.advance(0.) && insert(p); }),
        unused.end());
    }
    return unused.size();
  }

private:
  using Triangle = typename Builder::Triangle;

  // A triangle near the point; `edge` is the side opposite to vertex `edge` if that is nearest, or 3.
  struct Target
  {
    double squared_distance;
    Triangle triangle;
    std::size_t edge;
    bool operator<(const Target& other) const
    {
      return squared_distance < other.squared_distance ||
             (squared_distance == other.squared_distance && triangle < other.triangle);
    }
    bool operator==(const Target& other) const { return triangle == other.triangle; }
  };

  bool insert(Point_index p)
  {
    const std::vector<Target> nearest = targets(p);
    std::size_t pairs_left = MAXIMUM_PAIRS;
    bool has_crossed = false;
    const auto crosses_nothing = [&](const std::vector<Triangle>& added) {
      const bool result = pairs_left != 0 && !crosses(p, added, pairs_left);
      has_crossed = has_crossed || !result;
      return result;
    };
    return insert(p, nearest, crosses_nothing) ||
           (has_crossed && insert(p, nearest, [](const std::vector<Triangle>&) { return true; }));
  }

  // Into the first target for which is_wanted(triangles around the point) holds.
  template <typename IsWanted>
  bool insert(Point_index p, const std::vector<Target>& nearest, const IsWanted& is_wanted)
  {
    return std::any_of(nearest.begin(), nearest.end(), [&](const Target& target) {
      return !is_crowded(target.triangle) &&
             ((target.edge != 3 && split_edge(p, target, is_wanted)) || split_triangle(p, target.triangle, is_wanted));
    });
  }

  // Whether a vertex has so many triangles that the gate, quadratic in them, would be slow.
  bool is_crowded(const Triangle& t) const
  {
    return std::any_of(t.begin(), t.end(), [&](Point_index p) {
      return m_builder.is_open(p) && m_builder.corners(p).size() > MAXIMUM_DEGREE;
    });
  }

  // Triangles at the nearest points, nearest first.
  std::vector<Target> targets(Point_index p)
  {
    std::vector<Target> result;
    m_neighbors.for_point(p, OCTREE_LEAF_SIZE, MAXIMUM_NEIGHBORS, [&](Point_index, const Star_neighborhood&) {
      result.clear();
      for (Point_index q : m_neighbors.indices())
        m_builder.for_each_triangle_at(q, [&](Triangle t) {
          std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
          result.push_back(target(p, t));
        });
      return !result.empty();
    });
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    result.resize((std::min)(result.size(), MAXIMUM_TARGETS));
    return result;
  }

  Target target(Point_index p, const Triangle& t) const
  {
    Target result{ 0., t, 3 };
    const Local_point& a = m_points[t[0]];
    const Local_vector n = cross_product(m_points[t[1]] - a, m_points[t[2]] - a);
    for (std::size_t i = 0; i != 3; ++i) {
      const Local_point& u = m_points[t[(i + 1) % 3]];
      const Local_vector edge = m_points[t[(i + 2) % 3]] - u, d = m_points[p] - u;
      if (cross_product(n, edge) * d > 0.)
        continue;
      const double s = (std::min)(1., (std::max)(0., (edge * d) / edge.squared_length()));
      const double squared = (d - s * edge).squared_length();
      if (result.edge == 3 || squared < result.squared_distance)
        result = Target{ squared, t, i };
    }
    if (result.edge == 3) {
      const double height = n * (m_points[p] - a);
      result.squared_distance = height * height / n.squared_length();
    }
    return result;
  }

  // Replaces the triangle by three around the point.
  template <typename IsWanted>
  bool split_triangle(Point_index p, const Triangle& t, const IsWanted& is_wanted)
  {
    return replace({ t },
                   { Triangle{ { t[0], t[1], p } }, Triangle{ { t[1], t[2], p } }, Triangle{ { t[2], t[0], p } } },
                   is_wanted);
  }

  // Splits the edge opposite to vertex `edge` and the triangles at it in two.
  template <typename IsWanted>
  bool split_edge(Point_index p, const Target& target, const IsWanted& is_wanted)
  {
    const Point_index r = target.triangle[target.edge], u = target.triangle[(target.edge + 1) % 3],
                      v = target.triangle[(target.edge + 2) % 3];
    std::vector<Triangle> removed{ target.triangle }, added{ Triangle{ { r, u, p } }, Triangle{ { p, v, r } } };
    m_builder.open(u);
    for (const auto& corner : m_builder.corners(u)) {
      const Point_index s = corner.a == v ? corner.b : corner.b == v ? corner.a : NO_POINT;
      if (s == NO_POINT || s == r)
        continue;
      removed.push_back(Triangle{ { v, u, s } });
      added.push_back(Triangle{ { s, v, p } });
      added.push_back(Triangle{ { p, u, s } });
    }
    return replace(removed, added, is_wanted);
  }

  // Exchanges the triangles for those around the point, or none.
  template <typename IsWanted>
  bool replace(const std::vector<Triangle>& removed, const std::vector<Triangle>& added, const IsWanted& is_wanted)
  {
    std::vector<typename Builder::Removed_triangle> stored;
    for (const Triangle& t : removed) {
      for (Point_index q : t)
        m_builder.open(q);
      stored.push_back(m_builder.remove(m_builder.find_triangle(t[0], t[1], t[2])));
    }
    std::size_t attached = 0;
    while (attached != added.size() &&
           m_builder.try_add(added[attached][0], added[attached][1], added[attached][2]) == Triangle_verdict::ADDED)
      ++attached;
    if (attached == added.size() && is_wanted(added)) {
      for (const Triangle& t : added)
        m_crosses.attach(t);
      return true;
    }
    while (attached-- != 0)
      m_builder.remove(m_builder.find_triangle(added[attached][0], added[attached][1], added[attached][2]));
    for (const auto& t : stored)
      m_builder.restore(t);
    return false;
  }

  // Of the triangles around the point; takes the pairs that have been looked at from those left.
  bool crosses(Point_index p, const std::vector<Triangle>& triangles, std::size_t& pairs_left)
  {
    const bool result =
      m_crosses(triangles, [p](const Triangle& t) { return std::find(t.begin(), t.end(), p) == t.end(); });
    pairs_left -= (std::min)(pairs_left, m_crosses.take_pairs());
    return result;
  }

  static constexpr std::size_t MAXIMUM_PASSES = 4, MAXIMUM_DEGREE = 128;

  // A point that the nearest triangles refuse would only be taken by ones that are not near.
  static constexpr std::size_t MAXIMUM_TARGETS = 16;

  // Of triangles that are looked at for crossings. Of real points, fifty are enough for most, and these for all but one
  // in a hundred; where nothing fits, there may be ten thousands.
  static constexpr std::size_t MAXIMUM_PAIRS = 1024;

  // Beyond so many neighbors without a triangle a point has no surface around it.
  static constexpr std::size_t MAXIMUM_NEIGHBORS = 384;

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  Nearest_neighbors m_neighbors;
  Crossing_test<Builder> m_crosses;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_POINT_INSERTION_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FLAT_CAPS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FLAT_CAPS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_loops.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/flatness.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Flat caps of a surface over the ends of bores: parts of its flat faces without points inside, around which points follow
// each other closely although the face goes on. Nothing but a wall that is missing tells why they are there. Triangles
// belong to one part if the center of the circle around either is across their edge, as in polygons of points on a circle
// (Edelsbrunner, Facello and Liang, On the definition and the construction of pockets in macromolecules, 1998).
class Flat_caps
{
public:
  using Triangle = std::array<Point_index, 3>;

  struct Cap
  {
    std::vector<Point_index> rim; // around the triangles
    std::vector<Triangle> triangles;
    Local_vector normal{ 0, 0, 0 }; // the sum of their area vectors, twice, to one side
  };

  // Triangles of a cap need not be oriented alike; the normal of a cap is oriented as its first triangle is.
  Flat_caps(const std::vector<Local_point>& points, const std::vector<Triangle>& triangles) : m_points(points)
  {
    find_flat_triangles(triangles);
    Parity_union_find parts(m_triangles.size());
    const std::vector<Edge> edges = sorted_edges();
    join_across_edges(edges, parts);
    find_caps(edges, parts);
  }

  const std::vector<Cap>& caps() const { return m_caps; }

private:
  // Edges between six points on a circle are as long as its radius.
  static constexpr std::size_t MINIMUM_POINTS = 7;

  using Ends = std::pair<Point_index, Point_index>; // of an edge, in order

  // An edge and its triangle, with the third point of that.
  struct Edge
  {
    Ends ends;
    std::size_t triangle;
    Point_index opposite;
    bool operator<(const Edge& other) const
    {
      return ends < other.ends || (ends == other.ends && triangle < other.triangle);
    }
  };

  struct Part
  {
    Cap cap;
    std::vector<Ends> rim; // edges
    // Squares: of the longest edge of the rim, of the largest triangle, and of its circle.
    double longest = 0., area = 0., diameter = 0.;
  };

  Local_vector doubled_area_vector(const Triangle& t) const
  {
    return cross_product(m_points[t[1]] - m_points[t[0]], m_points[t[2]] - m_points[t[0]]);
  }

  // Those around whose vertices all triangles are in one plane.
  void find_flat_triangles(const std::vector<Triangle>& triangles)
  {
    std::vector<Local_vector> normals(m_points.size(), Local_vector(0, 0, 0)); // of the largest triangle
    for (const Triangle& t : triangles) {
      const Local_vector n = doubled_area_vector(t);
      for (Point_index p : t)
        if (n.squared_length() > normals[p].squared_length())
          normals[p] = n;
    }
    std::vector<unsigned char> is_flat(m_points.size(), 1);
    for (const Triangle& t : triangles)
      for (std::size_t i = 0; i != 3; ++i)
        if (is_flat[t[i]] != 0 &&
            !(is_beside(t[i], t[(i + 1) % 3], normals[t[i]]) && is_beside(t[i], t[(i + 2) % 3], normals[t[i]])))
          is_flat[t[i]] = 0;
    for (const Triangle& t : triangles)
      if (is_flat[t[0]] != 0 && is_flat[t[1]] != 0 && is_flat[t[2]] != 0)
        m_triangles.push_back(t);
  }

  // Whether the edge is in the plane through p with the normal.
  bool is_beside(Point_index p, Point_index q, const Local_vector& normal) const
  {
    const Local_vector e = m_points[q] - m_points[p];
    const double height = e * normal;
    return height * height <=
           ROUNDING_OF_FIVE_DIGITS * ROUNDING_OF_FIVE_DIGITS * e.squared_length() * normal.squared_length();
  }

  std::vector<Edge> sorted_edges() const
  {
    std::vector<Edge> result;
    for (std::size_t k = 0; k != m_triangles.size(); ++k)
      for (std::size_t i = 0; i != 3; ++i) {
        const Triangle& t = m_triangles[k];
        result.push_back(Edge{ std::minmax(t[i], t[(i + 1) % 3]), k, t[(i + 2) % 3] });
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  void join_across_edges(const std::vector<Edge>& edges, Parity_union_find& parts) const
  {
    for (std::size_t k = 1; k < edges.size(); ++k)
      if (edges[k].ends == edges[k - 1].ends && (is_wide(edges[k]) || is_wide(edges[k - 1])))
        parts.unite(Parity_union_find::Element(edges[k].triangle), Parity_union_find::Element(edges[k - 1].triangle),
                    false);
  }

  // Whether the angle opposite to the edge is a right one or more.
  bool is_wide(const Edge& e) const
  {
    const Local_vector a = m_points[e.ends.first] - m_points[e.opposite],
                       b = m_points[e.ends.second] - m_points[e.opposite];
    const double cosine = a * b;
    return cosine <= ROUNDING_OF_FIVE_DIGITS * std::sqrt(a.squared_length() * b.squared_length());
  }

  void find_caps(const std::vector<Edge>& edges, Parity_union_find& parts)
  {
    std::vector<Part> all(m_triangles.size());
    const auto part_of = [&](std::size_t triangle) -> Part& {
      return all[parts.find(Parity_union_find::Element(triangle)).root];
    };
    for (std::size_t k = 0; k != m_triangles.size(); ++k)
      add_triangle(m_triangles[k], part_of(k));
    for (std::size_t k = 0; k != edges.size(); ++k) {
      const auto is_same = [&](std::size_t j) {
        return j < edges.size() && edges[j].ends == edges[k].ends &&
               &part_of(edges[j].triangle) == &part_of(edges[k].triangle);
      };
      if (is_same(k - 1) || is_same(k + 1))
        continue;
      Part& part = part_of(edges[k].triangle);
      part.rim.push_back(edges[k].ends);
      part.longest = (std::max)(part.longest, squared_length(edges[k].ends.first, edges[k].ends.second));
    }
    for (Part& part : all)
      if (is_cap(part))
        m_caps.push_back(std::move(part.cap));
  }

  void add_triangle(const Triangle& t, Part& part) const
  {
    part.cap.triangles.push_back(t);
    const Local_vector n = doubled_area_vector(t);
    part.cap.normal = part.cap.normal + (n * part.cap.normal < 0. ? -n : n);
    const double area = n.squared_length();
    if (area > part.area) {
      part.area = area;
      part.diameter = squared_circumdiameter(m_points[t[0]], m_points[t[1]], m_points[t[2]]);
    }
  }

  double squared_length(Point_index p, Point_index q) const { return (m_points[q] - m_points[p]).squared_length(); }

  // Polygons without points inside have two triangles less than points and edges.
  bool is_cap(Part& part) const
  {
    const std::size_t size = part.cap.triangles.size() + 2;
    if (size < MINIMUM_POINTS || part.rim.size() != size || !(4. * part.longest < part.diameter))
      return false;
    part.cap.rim = rim_of(part);
    return part.cap.rim.size() == size && is_convex(part.cap);
  }

  // As bores mostly are, and gaps between samples at random hardly ever.
  bool is_convex(const Cap& cap) const
  {
    const std::size_t n = cap.rim.size();
    for (std::size_t i = 0; i != n; ++i) {
      const Local_point& p = m_points[cap.rim[(i + 1) % n]];
      const Local_vector from = p - m_points[cap.rim[i]], to = m_points[cap.rim[(i + 2) % n]] - p;
      const double lengths = std::sqrt(from.squared_length() * to.squared_length() * cap.normal.squared_length());
      if (cross_product(from, to) * cap.normal < -ROUNDING_OF_FIVE_DIGITS * lengths)
        return false;
    }
    return true;
  }

  // In the order in which its points follow each other, counterclockwise around the normal; up to where they do so first.
  std::vector<Point_index> rim_of(const Part& part) const
  {
    std::vector<Ends> next;
    for (const Ends& e : part.rim) {
      next.push_back(e);
      next.emplace_back(e.second, e.first);
    }
    std::sort(next.begin(), next.end());
    std::vector<Point_index> rim;
    Point_index p = next.front().first, before = NO_POINT;
    do {
      const auto it = std::lower_bound(next.begin(), next.end(), Ends(p, 0));
      const Point_index q = it->second != before ? it->second : (it + 1)->second;
      rim.push_back(p);
      before = std::exchange(p, q);
    } while (p != next.front().first && rim.size() < part.rim.size());
    if (loop_normal(m_points, rim) * part.cap.normal < 0.)
      std::reverse(rim.begin(), rim.end());
    return rim;
  }

  const std::vector<Local_point>& m_points;
  std::vector<Triangle> m_triangles; // that are flat
  std::vector<Cap> m_caps;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FLAT_CAPS_H

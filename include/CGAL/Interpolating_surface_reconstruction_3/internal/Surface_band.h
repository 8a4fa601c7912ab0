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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_BAND_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_BAND_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_measures.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_neighbors.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// A triangle of a soup, found by its number.
class Soup_triangle
{
public:
  using Triangle = std::array<Point_index, 3>;
  using Id = std::uint32_t;
  using Point = Local_point;
  using Datum = Local_kernel::Triangle_3;
  using Datum_reference = Datum;
  using Point_reference = const Point&;
  using Shared_data = std::pair<const std::vector<Local_point>*, const std::vector<Triangle>*>;

  static Shared_data construct_shared_data(const std::vector<Local_point>& positions,
                                           const std::vector<Triangle>& triangles)
  {
    return Shared_data(&positions, &triangles);
  }

  template <typename Iterator, typename... Soup>
  explicit Soup_triangle(Iterator it, const Soup&...) : m_id(*it)
  { }

  Id id() const { return m_id; }
  Datum datum(const Shared_data& soup) const
  {
    const Triangle& t = (*soup.second)[m_id];
    return Datum((*soup.first)[t[0]], (*soup.first)[t[1]], (*soup.first)[t[2]]);
  }
  Point_reference reference_point(const Shared_data& soup) const { return (*soup.first)[(*soup.second)[m_id][0]]; }

private:
  Id m_id;
};

// Where the surface of an implicit function can be, beside a closed surface of triangles through its samples: no
// farther from it than the tangent planes of the nearest triangle rise over it, which count less the less their
// normals agree with its own. Elsewhere the side of the triangles is the sign: planes far from their samples do
// not tell it.
class Surface_band
{
public:
  using Triangle = std::array<Point_index, 3>;

  // Negative inside.
  struct Place
  {
    double signed_distance, width;
  };

  // `normals` have unit length. The triangles are oriented; a surface with boundary has no inside.
  Surface_band(std::vector<Local_point> positions, std::vector<Local_vector> normals, std::vector<Triangle> triangles)
    : m_positions(std::move(positions)), m_normals(std::move(normals)), m_triangles(std::move(triangles)),
      m_neighbors(neighbors_of_closed_surface(m_triangles))
  {
    if (m_neighbors.empty())
      m_triangles.clear();
    sum_up_normals();
    // The edges of a triangle without a plane are those of others.
    std::vector<Soup_triangle::Id> ids;
    for (std::size_t t = 0; t != m_triangles.size(); ++t)
      if (normal(t).squared_length() >= (std::numeric_limits<double>::min)())
        ids.push_back(static_cast<Soup_triangle::Id>(t));
    m_tree.insert(ids.begin(), ids.end(), m_positions, m_triangles);
    m_tree.build();
    if (!ids.empty())
      m_tree.accelerate_distance_queries();
  }

  Surface_band(const Surface_band&) = delete; // the tree refers to the triangles
  Surface_band& operator=(const Surface_band&) = delete;

  bool is_empty() const { return m_tree.empty(); }

  // No place has a larger one.
  double largest_width() const
  {
    double result = 0.;
    for (const Triangle& v : m_triangles)
      for (Point_index p : v)
        for (Point_index q : v)
          result = (std::max)(result, std::abs(m_normals[p] * (m_positions[q] - m_positions[p])));
    return result;
  }

  // Not if it is empty.
  Place operator()(const Local_point& x) const
  {
    const std::size_t t = m_tree.closest_point_and_primitive(x).second;
    const std::array<double, 3> part = nearest_place(t, x);
    const Triangle& v = m_triangles[t];
    const Local_vector a = x - m_positions[v[0]], ab = m_positions[v[1]] - m_positions[v[0]],
                       ac = m_positions[v[2]] - m_positions[v[0]];
    const Local_vector offset = a - part[1] * ab - part[2] * ac;
    double width = 0.;
    const Local_vector n = unit_normal(t);
    for (std::size_t i = 0; i != 3; ++i) {
      const Local_vector& normal = m_normals[v[i]];
      width += part[i] * (std::max)(normal * n, 0.) * std::abs(normal * (x - offset - m_positions[v[i]]));
    }
    const double distance = std::sqrt(offset.squared_length());
    return Place{ offset * normal_at(t, part) < 0. ? -distance : distance, width };
  }

private:
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  using Tree = AABB_tree<AABB_traits_3<Local_kernel, Soup_triangle> >;
#else
  using Tree = AABB_tree<AABB_traits<Local_kernel, Soup_triangle> >;
#endif

  Local_vector normal(std::size_t t) const
  {
    const Triangle& v = m_triangles[t];
    return cross_product(m_positions[v[1]] - m_positions[v[0]], m_positions[v[2]] - m_positions[v[0]]);
  }

  Local_vector unit_normal(std::size_t t) const
  {
    const Local_vector n = normal(t);
    const double length = std::sqrt(n.squared_length());
    return length > 0. ? n / length : Local_vector(0, 0, 0);
  }

  // At a vertex, the normals of its triangles weighted by their angles tell the sides of the surface apart.
  void sum_up_normals()
  {
    m_sums.assign(m_positions.size(), Local_vector(0, 0, 0));
    for (std::size_t t = 0; t != m_triangles.size(); ++t)
      for (std::size_t i = 0; i != 3; ++i) {
        const Triangle& v = m_triangles[t];
        const double angle = std::acos(
          cosine(m_positions[v[(i + 1) % 3]] - m_positions[v[i]], m_positions[v[(i + 2) % 3]] - m_positions[v[i]]));
        m_sums[v[i]] = m_sums[v[i]] + angle * unit_normal(t);
      }
  }

  // The parts that the vertices have in the point of triangle t next to x: some are zero exactly if it is on the
  // boundary.
  std::array<double, 3> nearest_place(std::size_t t, const Local_point& x) const
  {
    const Triangle& v = m_triangles[t];
    const Local_point &a = m_positions[v[0]], &b = m_positions[v[1]], &c = m_positions[v[2]];
    const Local_vector n = normal(t);
    const std::array<double, 3> area{ { n * cross_product(b - x, c - x), n * cross_product(c - x, a - x),
                                        n * cross_product(a - x, b - x) } };
    if (area[0] > 0. && area[1] > 0. && area[2] > 0.) {
      const double sum = area[0] + area[1] + area[2];
      return { { area[0] / sum, area[1] / sum, area[2] / sum } };
    }
    std::array<double, 3> result{ { 1., 0., 0. } };
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i != 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const Local_point& p = m_positions[v[i]];
      const Local_vector edge = m_positions[v[j]] - p, px = x - p;
      const double along = edge * px / edge.squared_length(), s = (std::min)((std::max)(along, 0.), 1.);
      const double squared = (px - s * edge).squared_length();
      if (squared < smallest) {
        smallest = squared;
        result = { { 0., 0., 0. } };
        result[i] = 1. - s;
        result[j] = s;
      }
    }
    return result;
  }

  // Whatever has the sign of the side on which x is, if the vertices have these parts in the point next to it.
  Local_vector normal_at(std::size_t t, const std::array<double, 3>& part) const
  {
    for (std::size_t i = 0; i != 3; ++i) {
      if (part[i] == 1.)
        return m_sums[m_triangles[t][i]];
      if (part[i] == 0. && part[(i + 1) % 3] != 0. && part[(i + 2) % 3] != 0.)
        return unit_normal(t) + unit_normal(m_neighbors[t][(i + 1) % 3]);
    }
    return unit_normal(t);
  }

  const std::vector<Local_point> m_positions;
  const std::vector<Local_vector> m_normals;
  std::vector<Triangle> m_triangles;
  Triangle_neighbors m_neighbors;
  std::vector<Local_vector> m_sums; // of the normals of the triangles at each vertex
  Tree m_tree;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_BAND_H

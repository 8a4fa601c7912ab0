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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_RESTRICTED_VORONOI_STAR_3_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_RESTRICTED_VORONOI_STAR_3_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Point_star.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {

namespace internal {

// A convex polygon around the origin of a plane, cut by half-planes. Edge i goes from vertex i to
// vertex i + 1 and remembers which half-plane made it.
class Clipped_polygon
{
public:
  // The square with half side `size`, whose edges no neighbor made.
  explicit Clipped_polygon(double size)
    : m_size(4)
  {
    const double x[4] = { size, size, -size, -size }, y[4] = { -size, size, size, -size };
    for (std::size_t i = 0; i != 4; ++i)
      m_vertices[i] = Vertex{ x[i], y[i], Point_star::GAP };
  }

  std::size_t size() const { return m_size; }
  std::uint32_t maker(std::size_t i) const { return m_vertices[i].maker; }

  double squared_radius() const
  {
    double result = 0.;
    for (std::size_t i = 0; i != m_size; ++i)
      result = (std::max)(result, m_vertices[i].x * m_vertices[i].x + m_vertices[i].y * m_vertices[i].y);
    return result;
  }

  // Cuts off a x + b y > c, where c > 0. Returns whether anything was cut.
  bool clip(double a, double b, double c, std::uint32_t maker)
  {
    std::size_t first_out = CAPACITY;
    double previous = a * m_vertices[m_size - 1].x + b * m_vertices[m_size - 1].y - c;
    for (std::size_t i = 0; i != m_size; ++i) {
      const double value = a * m_vertices[i].x + b * m_vertices[i].y - c;
      m_values[i] = value;
      if (value > 0. && previous <= 0.)
        first_out = i;
      previous = value;
    }
    if (first_out == CAPACITY || m_size == CAPACITY)
      return false;
    if (m_values[0] > 0. && m_values[m_size - 1] <= 0.)
      first_out = 0;
    std::size_t end_out = first_out; // first kept vertex after the ones cut off
    std::size_t removed = 0;
    while (removed != m_size && m_values[end_out] > 0.) {
      end_out = next(end_out);
      ++removed;
    }
    if (removed == m_size)
      return false;
    const std::size_t before = first_out == 0 ? m_size - 1 : first_out - 1;
    const std::size_t last_out = end_out == 0 ? m_size - 1 : end_out - 1;
    Vertex entry = crossing(before, first_out);
    entry.maker = maker;
    Vertex exit = crossing(end_out, last_out);
    exit.maker = m_vertices[last_out].maker;
    replace(first_out, removed, entry, exit);
    return true;
  }

private:
  struct Vertex { double x, y; std::uint32_t maker; };

  // A cell with more edges than this keeps the nearest neighbors' edges.
  static constexpr std::size_t CAPACITY = 64;

  std::size_t next(std::size_t i) const { return i + 1 == m_size ? 0 : i + 1; }

  Vertex crossing(std::size_t kept, std::size_t cut) const
  {
    const Vertex& u = m_vertices[kept];
    const Vertex& v = m_vertices[cut];
    const double t = m_values[kept] / (m_values[kept] - m_values[cut]);
    return Vertex{ u.x + t * (v.x - u.x), u.y + t * (v.y - u.y), 0 };
  }

  // Replaces `removed` vertices from `first` on, cyclically, by two.
  void replace(std::size_t first, std::size_t removed, const Vertex& entry, const Vertex& exit)
  {
    if (first + removed <= m_size) {
      const std::size_t tail = first + removed;
      if (removed == 1)
        for (std::size_t i = m_size; i-- > tail; )
          m_vertices[i + 1] = m_vertices[i];
      else if (removed > 2)
        for (std::size_t i = tail; i != m_size; ++i)
          m_vertices[i + 2 - removed] = m_vertices[i];
      m_vertices[first] = entry;
      m_vertices[first + 1] = exit;
    } else {
      const std::size_t wrapped = first + removed - m_size; // vertices cut off at the beginning
      const std::size_t kept = m_size - removed;
      for (std::size_t i = 0; i != kept; ++i)
        m_vertices[i] = m_vertices[i + wrapped];
      m_vertices[kept] = entry;
      m_vertices[kept + 1] = exit;
    }
    m_size = m_size + 2 - removed;
  }

  std::array<Vertex, CAPACITY + 1> m_vertices;
  std::array<double, CAPACITY + 1> m_values;
  std::size_t m_size;
};

} // namespace internal

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

The star of a point from its Voronoi cell restricted to its tangent plane.

The bisector planes of the point and its neighbors clip the tangent plane to a convex polygon; the
neighbors that own an edge of the polygon form the star, in cyclic order. The triangles are facets of
the Delaunay triangulation of the points where the sampling suffices. The star is certain as soon as
the neighborhood reaches twice as far as the farthest vertex of the polygon (the radius of security
of L&eacute;vy and Bonneel, <em>Variational anisotropic surface meshing with Voronoi parallel linear
enumeration</em>, 2012). The construction follows Boltcheva and L&eacute;vy, <em>Surface
reconstruction by computing restricted Voronoi cells in parallel</em>, 2017.

\cgalModels{StarConstruction_3}
*/
class Restricted_voronoi_star_3
{
public:
  /// the star asks for the nearest neighbors.
  using Neighborhood_category = Nearest_neighborhood_tag;

  /// number of neighbors to start with.
  static std::size_t initial_number_of_neighbors() { return INITIAL_NEIGHBORS; }
  /// largest number of neighbors that are worth looking at.
  static std::size_t maximum_number_of_neighbors() { return MAXIMUM_NEIGHBORS; }

  /// computes the star of the center of `neighborhood`; returns whether no point outside of the
  /// neighborhood can change it.
  bool operator()(const Star_neighborhood& neighborhood, Point_star& star) const
  {
    star.link.clear();
    star.normal = covariance_normal(neighborhood);
    return clip(neighborhood, star);
  }

  static inline std::size_t INITIAL_NEIGHBORS = 16, MAXIMUM_NEIGHBORS = 64, NORMAL_NEIGHBORS = 16;
  static inline int REESTIMATE = 1;

private:
  using Vector_3 = Star_neighborhood::Vector_3;

  static Vector_3 covariance_normal(const Star_neighborhood& neighborhood)
  {
    const std::size_t n = (std::min)(neighborhood.size(), NORMAL_NEIGHBORS);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    const double farthest = n == 0 ? 0. : neighborhood[n - 1].squared_length();
    const double scale = farthest > 0. ? 1. / std::sqrt(farthest) : 1.; // all may coincide in double
    for (std::size_t i = 0; i != n; ++i) {
      const Vector_3& d = neighborhood[i];
      const Eigen::Vector3d v(d.x() * scale, d.y() * scale, d.z() * scale);
      mean += v;
      moments += v * v.transpose();
    }
    moments -= mean * mean.transpose() / double(n + 1);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(moments);
    const Eigen::Vector3d normal = solver.eigenvectors().col(0);
    return Vector_3(normal.x(), normal.y(), normal.z());
  }

  static bool clip(const Star_neighborhood& neighborhood, Point_star& star)
  {
    if (neighborhood.size() == 0)
      return true;
    Vector_3 u, v;
    tangent_frame(star.normal, u, v);
    const double far = neighborhood[neighborhood.size() - 1].squared_length();
    internal::Clipped_polygon polygon(2. * std::sqrt(far));
    double squared_radius = polygon.squared_radius();
    for (std::size_t i = 0; i != neighborhood.size(); ++i) {
      const Vector_3& d = neighborhood[i];
      const double squared_length = d.squared_length();
      if (squared_length >= 4. * squared_radius)
        break;
      if (polygon.clip(d * u, d * v, squared_length / 2, static_cast<std::uint32_t>(i)))
        squared_radius = polygon.squared_radius();
    }
    for (std::size_t i = 0; i != polygon.size(); ++i)
      if (polygon.maker(i) != Point_star::GAP || star.link.empty() || star.link.back() != Point_star::GAP)
        star.link.push_back(polygon.maker(i));
    return neighborhood.squared_radius() >= 4. * squared_radius;
  }

  static void tangent_frame(const Vector_3& n, Vector_3& u, Vector_3& v)
  {
    const double ax = std::abs(n.x()), ay = std::abs(n.y()), az = std::abs(n.z());
    const Vector_3 axis = ax <= ay && ax <= az ? Vector_3(1, 0, 0) : ay <= az ? Vector_3(0, 1, 0) : Vector_3(0, 0, 1);
    u = cross_product(n, axis);
    u = u / std::sqrt(u.squared_length());
    v = cross_product(n, u);
  }
};

} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_RESTRICTED_VORONOI_STAR_3_H

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
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Clipped_polygon.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_diagonals.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Tangent_projection.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

The star of a point from its Voronoi cell restricted to its tangent plane.

The bisector planes of the point and its neighbors clip the tangent plane to a convex polygon; the
neighbors that own an edge of the polygon form the star, in cyclic order. The tangent plane is first that of
the covariance of the 16 nearest neighbors, or of twice as many as long as these lie along a line, as in one row of a
scan. Some of them may lie across a crease or on another sheet. The star is
therefore made a second time in the plane of its own triangles, where that plane differs: its normal is
the mean of their normals, weighted by their angles at the point (Th&uuml;rmer and W&uuml;thrich,
<em>Computing vertex normals from polygonal facets</em>, 1998). Where four points are
nearly cocircular the diagonal is chosen by the circles through them in space instead, so that the
stars of all four points agree, whatever their tangent planes. The triangles are facets of
the Delaunay triangulation of the points where the sampling suffices. The star is certain as soon as
the neighborhood reaches twice as far as the farthest vertex of the polygon (the radius of security
of L&eacute;vy and Bonneel, <em>Variational anisotropic surface meshing with Voronoi parallel linear
enumeration</em>, 2012). The search begins with 16 neighbors and ends with 16 times the number that spans the
plane, 256 at points that are not in rows and 1024 at most, or with four times that number if boundaries are kept: a
star that is not certain by then is taken as it is. The construction follows Boltcheva and L&eacute;vy, <em>Surface
reconstruction by computing restricted Voronoi cells in parallel</em>, 2017.

\cgalModels{StarConstruction_3}
*/
class Restricted_voronoi_star_3
{
public:
  /// the star asks for the nearest neighbors.
  using Neighborhood_category = Nearest_neighborhood_tag;

  /// number of neighbors to start with.
  static constexpr std::size_t initial_number_of_neighbors() { return INITIAL_NEIGHBORS; }
  /// largest number of neighbors that are worth looking at.
  static constexpr std::size_t maximum_number_of_neighbors() { return MAXIMUM_NEIGHBORS; }

  /// computes the star of the center of `neighborhood`; returns whether no point outside of the
  /// neighborhood can change it, or no more neighbors are worth looking at.
  bool operator()(const Star_neighborhood& neighborhood, Point_star& star) const
  {
    const std::size_t size_of_plane = set_normal_of_plane(neighborhood, star.normal);
    const std::size_t growth = neighborhood.keeps_boundaries() ? GROWTH_THIS_SIDE_OF_OPENINGS : MAXIMUM_GROWTH;
    const bool is_last = !neighborhood.may_grow() || neighborhood.size() >= growth * size_of_plane;
    bool is_certain = clip(neighborhood, is_last, star);
    if (is_certain && tilt(neighborhood, star))
      is_certain = clip(neighborhood, is_last, star);
    return is_certain || is_last;
  }

private:
  using Vector_3 = Star_neighborhood::Vector_3;

  // Two rings of a regular sample hold 18 points: fewer seldom make a star certain, and their normal
  // changes little with more.
  static constexpr std::size_t INITIAL_NEIGHBORS = 16;

  // Of the neighbors that span a plane: four times doubled. A star that is not certain by then has a gap, or triangles
  // that are far longer than its shortest ones. One that sees as far as that closes openings.
  static constexpr std::size_t MAXIMUM_GROWTH = 16, GROWTH_THIS_SIDE_OF_OPENINGS = 4;

  // Enough for rows that are a hundred times as far from each other as the points in them.
  static constexpr std::size_t MAXIMUM_NEIGHBORS = 1024;

  // Neighbors along a line have less than this part of their variance across it: an eighth of the extent.
  static constexpr double LEAST_VARIANCE_ACROSS = 1. / 64.;

  // Eight degrees, for speed alone: smaller tilts change one star in a thousand, and to make every star twice
  // takes a fifth more time.
  static constexpr double COSINE_OF_SMALL_TILT = .99;

  // A point on the circle around the farthest vertex does change the star, as one of many cocircular ones.
  static constexpr double WITH_ROUNDING = 1. + 1e-9;

  // The plane of the nearest neighbors, of twice as many as long as they lie along a line, as in one row of a scan: its
  // plane would be that in which it bends. Returns how many span the plane; more than there are if all lie along a
  // line, with the plane of the first ones.
  static std::size_t set_normal_of_plane(const Star_neighborhood& neighborhood, Vector_3& normal)
  {
    std::size_t n = INITIAL_NEIGHBORS;
    while (!is_plane(neighborhood, n, normal)) {
      if (n >= neighborhood.size()) {
        is_plane(neighborhood, INITIAL_NEIGHBORS, normal);
        return neighborhood.size() + 1;
      }
      n *= 2;
    }
    return n;
  }

  // Computes the normal of the plane of the `n` nearest neighbors; returns whether they extend in two directions.
  static bool is_plane(const Star_neighborhood& neighborhood, std::size_t n, Vector_3& normal)
  {
    n = (std::min)(neighborhood.size(), n);
    const double farthest = n == 0 ? 0. : neighborhood[n - 1].squared_length();
    const double scale = farthest > 0. ? 1. / std::sqrt(farthest) : 1.; // all may coincide in double
    double x = 0., y = 0., z = 0., xx = 0., xy = 0., xz = 0., yy = 0., yz = 0., zz = 0.;
    for (std::size_t i = 0; i != n; ++i) {
      const double dx = neighborhood[i].x() * scale, dy = neighborhood[i].y() * scale, dz = neighborhood[i].z() * scale;
      x += dx;
      y += dy;
      z += dz;
      xx += dx * dx;
      xy += dx * dy;
      xz += dx * dz;
      yy += dy * dy;
      yz += dy * dz;
      zz += dz * dz;
    }
    const double size = double(n + 1);
    Eigen::Matrix3d moments; // the solver reads the lower triangle
    moments << xx - x * x / size, 0., 0., xy - x * y / size, yy - y * y / size, 0., xz - x * z / size,
      yz - y * z / size, zz - z * z / size;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(moments);
    const Eigen::Vector3d direction = solver.eigenvectors().col(0);
    normal = Vector_3(direction.x(), direction.y(), direction.z());
    return solver.eigenvalues()(1) >= LEAST_VARIANCE_ACROSS * solver.eigenvalues()(2);
  }

  // Turns the normal to that of the star's own triangles; returns whether this can change the star.
  static bool tilt(const Star_neighborhood& neighborhood, Point_star& star)
  {
    Vector_3 sum(0, 0, 0);
    for (std::size_t i = 0; i != star.link.size(); ++i) {
      const std::uint32_t a = star.link[i], b = star.link[i + 1 == star.link.size() ? 0 : i + 1];
      if (a == Point_star::GAP || b == Point_star::GAP)
        continue;
      const Vector_3 normal = cross_product(neighborhood[a], neighborhood[b]);
      const double length = std::sqrt(normal.squared_length());
      if (length > 0.)
        sum = sum + std::atan2(length, neighborhood[a] * neighborhood[b]) / length * normal;
    }
    const double length = std::sqrt(sum.squared_length());
    if (!(length > 0.) || sum * star.normal > COSINE_OF_SMALL_TILT * length)
      return false;
    star.normal = sum / length;
    return true;
  }

  static bool clip(const Star_neighborhood& neighborhood, bool is_last, Point_star& star)
  {
    star.link.clear();
    if (neighborhood.size() == 0)
      return true;
    const internal::Tangent_projection<MAXIMUM_NEIGHBORS> projection(neighborhood, star.normal);
    internal::Clipped_polygon polygon(2. * std::sqrt(2. * projection.half_square(projection.size() - 1)));
    double squared_radius = polygon.squared_radius();
    for (std::size_t i = 0; i != projection.size() && projection.half_square(i) < 2. * squared_radius; ++i)
      if (polygon.clip(projection.x(i), projection.y(i), projection.half_square(i), static_cast<std::uint32_t>(i)))
        squared_radius = polygon.squared_radius();
    const bool is_certain = neighborhood.squared_radius() >= WITH_ROUNDING * 4. * squared_radius;
    if (is_certain || is_last)
      internal::Star_diagonals<MAXIMUM_NEIGHBORS>(neighborhood, projection, polygon, squared_radius).settle(star.link);
    return is_certain;
  }
};

} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_RESTRICTED_VORONOI_STAR_3_H

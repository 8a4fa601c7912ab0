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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_POINT_STAR_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_POINT_STAR_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

The neighbors of a point, as a star construction sees them: vectors from the point to its neighbors
by increasing length. Lengths are in a unit of the cloud's own.
*/
class Star_neighborhood
{
public:
  /// vector type, with `double` coordinates.
  using Vector_3 = internal::Local_vector;

  /// constructs the neighborhood of `size` neighbors at `offsets`; no other point of the cloud is
  /// closer to the center than the square root of `squared_radius`.
  /// If `may_grow`, more neighbors follow as long as the star is not certain.
  /// If `keeps_boundaries`, boundaries of the surface are to stay.
  Star_neighborhood(const Vector_3* offsets, std::size_t size, double squared_radius, bool may_grow = false,
                    bool keeps_boundaries = false)
    : m_offsets(offsets), m_size(size), m_squared_radius(squared_radius), m_may_grow(may_grow),
      m_keeps_boundaries(keeps_boundaries)
  { }

  /// returns the number of neighbors.
  std::size_t size() const { return m_size; }
  /// returns the vector from the center to the `i`-th nearest neighbor.
  const Vector_3& operator[](std::size_t i) const { return m_offsets[i]; }
  /// returns the squared radius within which all points of the cloud are listed; infinite if the
  /// cloud has no other points.
  double squared_radius() const { return m_squared_radius; }
  /// returns whether the star is asked for again, with more neighbors, if it is not certain: then it need not be told.
  bool may_grow() const { return m_may_grow; }
  /// returns whether boundaries of the surface are to stay: a star that looks far closes an opening.
  bool keeps_boundaries() const { return m_keeps_boundaries; }

private:
  const Vector_3* m_offsets;
  std::size_t m_size;
  double m_squared_radius;
  bool m_may_grow, m_keeps_boundaries;
};

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

Neighborhood category of a star construction that asks for the nearest neighbors, and for more of
them as long as its star is not certain.
*/
struct Nearest_neighborhood_tag
{ };

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

Neighborhood category of a star construction that takes all points of the octree leaves around the
point whose enlarged boxes overlap (thesis 4.3.2).
*/
struct Box_neighborhood_tag
{ };

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

The star of a point: the cyclic sequence of its neighbors in the star, as positions in the
neighborhood. Consecutive neighbors and the center form a triangle, unless one of them is `GAP`.
*/
struct Point_star
{
  /// marks an opening of the star.
  static constexpr std::uint32_t GAP = internal::NO_POINT;

  /// neighbors in cyclic order, counterclockwise seen from the tip of `normal`.
  std::vector<std::uint32_t> link;
  /// direction of the surface normal at the center, up to sign.
  internal::Local_vector normal;
};

} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_POINT_STAR_H

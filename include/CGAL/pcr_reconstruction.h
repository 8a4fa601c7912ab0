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

#ifndef CGAL_PCR_RECONSTRUCTION_H
#define CGAL_PCR_RECONSTRUCTION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Pcr_reconstructor_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/reconstruction_call.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

reconstructs a surface through points by growing it, the most coplanar triangle first.

A star of triangles is built at every point from the points around it. The surface begins with the most
planar star and grows at its front, the edges that have one triangle. Each edge of the front has at
most one candidate triangle: of the points beyond the edge that the stars of its ends connect to it, the
nearest two are compared by the regularity of the triangles that they make; where there is none, a triangle
between adjacent edges is considered. Of all candidates, the one that is the most coplanar with the
triangle beside it is attached next, so that flat regions are meshed before curved ones; no angle is too
sharp. Among candidates on which the stars agree, the most coplanar means to within a factor of \f$ \sqrt 2 \f$ of
the angle. When no edge has a candidate left, the growth begins again at the most planar star that was not
reached. Where the stars conflict so that no candidate is consistent with them, the surface is completed as
by `ctc_reconstruction()`: by facets of Delaunay tetrahedra, and by closing of loops.

The triangles form an oriented 2-manifold whose vertices are points of the range, with the guarantees of
`ctc_reconstruction()`: at most two triangles meet at an edge, at most one fan of triangles at a vertex,
adjacent triangles traverse their common edge in opposite directions, loops are closed by default as far as
that does not cross the surface at its ends, and closed components face outward. The triangles and their
order depend on the sequence of points and on the parameters, not on the number of threads; a permutation of
the points only renames them. Points that are not finite, or equal to an earlier one, are set aside and
counted. Fewer than three distinct points, or collinear ones, give no triangle. A reconstruction that is
cancelled writes nothing.

A visitor sees the surface grow: between the begin and the end of `Stage::GROWING`, its function
`on_triangle()` is called for the triangles in the order in which they are attached.

The method is from chapter 3 of the thesis cited in the user manual. The growth is sequential, the
stages before it run in parallel.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` (needs \ref thirdpartyTBB) or
`CGAL::Parallel_if_available_tag`
\tparam PointRange a model of `ForwardRange`, with at most \f$ 2^{32}-2 \f$ elements
\tparam TriangleOutputIterator a model of `OutputIterator` that accepts `std::array<std::size_t, 3>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points
\param triangles receives for each triangle the positions of its vertices in `points`
\param np optional named parameters: `point_map`, `normal_map`, `geom_traits`, `callback`, `visitor`,
`neighbor_radius`, `maximum_hole_size`, `keep_boundaries` and `star_construction`, with the types, units,
defaults and errors that `ctc_reconstruction()` gives for them

\return the output iterator after the last triangle.

The time is \f$ O(n \log n) \f$ for \f$ n \f$ points, with a small logarithmic part, if a ball around a
point holds a bounded number of the points that it would hold on a plane.

\sa `CGAL::ctc_reconstruction()`
\sa `CGAL::advancing_front_surface_reconstruction()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename PointRange, typename TriangleOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
TriangleOutputIterator pcr_reconstruction(const PointRange& points, TriangleOutputIterator triangles,
                                          const NamedParameters& np = parameters::default_values())
{
  using Algorithm = Interpolating_surface_reconstruction_3::internal::Pcr_algorithm<ConcurrencyTag>;
  return Interpolating_surface_reconstruction_3::internal::reconstruct_triangles<Algorithm>(points, triangles, np);
}

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

reconstructs a surface through points by growing it, as a mesh.

Only points that are used become vertices. The property map `"v:input_index"` of type `std::size_t`
holds the position of each vertex in `points`. The named parameters and guarantees are those of the
overload for triangles.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` (needs \ref thirdpartyTBB) or
`CGAL::Parallel_if_available_tag`
\tparam PointRange a model of `ForwardRange`, with at most \f$ 2^{32}-2 \f$ elements
\tparam Point the point type of the mesh
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points
\param mesh receives the surface
\param np optional named parameters, see the other overload

\pre `mesh` is empty

\return `false` if the reconstruction was cancelled; the mesh is unchanged then.
*/
template <typename ConcurrencyTag = Sequential_tag, typename PointRange, typename Point,
          typename NamedParameters = parameters::Default_named_parameters>
bool pcr_reconstruction(const PointRange& points, Surface_mesh<Point>& mesh,
                        const NamedParameters& np = parameters::default_values())
{
  using Algorithm = Interpolating_surface_reconstruction_3::internal::Pcr_algorithm<ConcurrencyTag>;
  return Interpolating_surface_reconstruction_3::internal::reconstruct_mesh<Algorithm>(points, mesh, np);
}

} // namespace CGAL

#endif // CGAL_PCR_RECONSTRUCTION_H

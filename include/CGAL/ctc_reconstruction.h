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

#ifndef CGAL_CTC_RECONSTRUCTION_H
#define CGAL_CTC_RECONSTRUCTION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Ctc_reconstructor_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/reconstruction_call.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

reconstructs a surface through points by compatible triangle charts.

A star of triangles is built at every point from the points around it; triangles on which the stars
of all three vertices agree are taken at once, and small loops between them are closed if that can be
done by nearly planar triangles; where the stars conflict, the surface is completed by facets of
Delaunay tetrahedra that are labelled inside and outside. The labels keep the sides of the agreed charts,
follow the votes of the stars and the angles at which circumscribed spheres meet, and then the linear
implicit function of the normals of the surface that they make; agreed stars that this surface contradicts
are withdrawn, once. The remaining loops are closed, islands on which no star agrees are dissolved, flat sheets
that face each other are joined, and points left over are inserted. If all loops are closed, components nearer to each
other than their points are joined where that bends the surface little.

The triangles form an oriented 2-manifold whose vertices are points of the range: at most two
triangles meet at an edge, at most one fan of triangles at a vertex, adjacent triangles traverse
their common edge in opposite directions. By default loops are closed, but for those at which
the stars agree that the surface ends and that cannot be closed without crossing it; closed components face
outward. The triangles and their order depend on the sequence of points and on the parameters, not
on the number of threads; a permutation of the points only renames them.

Points with a coordinate that is not a finite number and points equal to an earlier one are set
aside and counted; see `on_points_set_aside()` of `InterpolatingReconstructionVisitor`. Fewer than
three distinct points, or collinear ones, give no triangle. Points that lie in one plane give a
surface with boundary. A reconstruction that is cancelled writes nothing.

The method is from chapter 4 of the thesis cited in the user manual.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` (needs \ref thirdpartyTBB) or
`CGAL::Parallel_if_available_tag`
\tparam PointRange a model of `ForwardRange`, with at most \f$ 2^{32}-2 \f$ elements
\tparam TriangleOutputIterator a model of `OutputIterator` that accepts `std::array<std::size_t, 3>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points
\param triangles receives for each triangle the positions of its vertices in `points`
\param np optional named parameters; those marked * start a pack or are joined by
`parameters::combine()`

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map from the elements of `points` to points}
    \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
    \cgalParamDefault{`CGAL::Identity_property_map`}
  \cgalParamNEnd
  \cgalParamNBegin{normal_map}
    \cgalParamDescription{a property map from the elements of `points` to normals of any length; each
      component of the surface is oriented along the majority of them}
    \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Vector_3`}
    \cgalParamDefault{none: closed components face outward}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of the geometric traits class}
    \cgalParamType{a model of `InterpolatingReconstructionTraits_3`}
    \cgalParamDefault{the \cgal kernel of the point type}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{called with the progress, from 0 to 1 and never decreasing, never
      concurrently but possibly from a worker thread; `false` cancels}
    \cgalParamType{convertible to `std::function<bool(double)>`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told about stages, points set aside and triangles proposed; pass
      `std::ref(visitor)` to keep its state}
    \cgalParamType{a model of `InterpolatingReconstructionVisitor`}
    \cgalParamDefault{`Interpolating_surface_reconstruction_3::Default_visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{neighbor_radius}
    \cgalParamDescription{the largest distance between neighbors in a star, in the unit of the points;
      `0` means no limit}
    \cgalParamType{`geom_traits::FT`}
    \cgalParamDefault{`0`}
    \cgalParamExtra{`std::invalid_argument` is thrown if it is negative or not finite}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_hole_size}
    \cgalParamDescription{* the largest number of edges of a boundary loop that is closed; `0` closes none}
    \cgalParamType{an integer type}
    \cgalParamDefault{no limit}
    \cgalParamExtra{`std::invalid_argument` is thrown if it is negative. Places where stars conflict are no
      holes: they are completed whatever the value, and openings among them may be closed}
  \cgalParamNEnd
  \cgalParamNBegin{keep_boundaries}
    \cgalParamDescription{* whether openings of the sampled surface stay open: loops along which most stars are
      open, and what is wider than ten spacings. Gaps of the sampling that wide are openings, too}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{star_construction}
    \cgalParamDescription{* how the star of a point is made}
    \cgalParamType{a model of `StarConstruction_3`}
    \cgalParamDefault{`Interpolating_surface_reconstruction_3::Restricted_voronoi_star_3`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the output iterator after the last triangle.

The time is \f$ O(n \log n) \f$ for \f$ n \f$ points, with a small logarithmic part, if a ball around a
point holds a bounded number of the points that it would hold on a plane.

\sa `CGAL::pcr_reconstruction()`
\sa `CGAL::lis_reconstruction()`
\sa `CGAL::advancing_front_surface_reconstruction()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename PointRange, typename TriangleOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
TriangleOutputIterator ctc_reconstruction(const PointRange& points, TriangleOutputIterator triangles,
                                          const NamedParameters& np = parameters::default_values())
{
  using Algorithm = Interpolating_surface_reconstruction_3::internal::Ctc_algorithm<ConcurrencyTag>;
  return Interpolating_surface_reconstruction_3::internal::reconstruct_triangles<Algorithm>(points, triangles, np);
}

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

reconstructs a surface through points by compatible triangle charts, as a mesh.

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
bool ctc_reconstruction(const PointRange& points, Surface_mesh<Point>& mesh,
                        const NamedParameters& np = parameters::default_values())
{
  using Algorithm = Interpolating_surface_reconstruction_3::internal::Ctc_algorithm<ConcurrencyTag>;
  return Interpolating_surface_reconstruction_3::internal::reconstruct_mesh<Algorithm>(points, mesh, np);
}

} // namespace CGAL

#endif // CGAL_CTC_RECONSTRUCTION_H

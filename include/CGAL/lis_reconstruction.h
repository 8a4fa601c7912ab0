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

#ifndef CGAL_LIS_RECONSTRUCTION_H
#define CGAL_LIS_RECONSTRUCTION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/lis_call.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>

#include <CGAL/Container_helper.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <boost/range/has_range_iterator.hpp>
#include <boost/range/value_type.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

reconstructs a surface through points with normals by a linear implicit function.

The tangent planes at the points are blended into one function, negative inside of the surface. No
linear system is solved. The signs of the function label the Delaunay tetrahedra of the points inside
and outside; labels are changed where that lessens the area of the surface, or makes it follow the
normals better, and where the surface would not be a manifold. The facets between the labels are the
surface.

By default, the triangles form an oriented 2-manifold without boundary: two triangles meet at every edge, one fan
of triangles at every vertex. They face outward, as the normals do, and do not cross each other, since
they are Delaunay facets. Normals that point inward turn the surface over and change nothing else: all are taken to
do so if those on the convex hull do, weighted by the area of its facets. By default, their vertices are points of
the range. The vertices and
triangles depend on the sequence of points and on the parameters, not on the number of threads; a
permutation of the points only renames them.

Points with a coordinate that is not a finite number, points with a normal that is zero or not finite,
and points equal to an earlier one are set aside and counted; see `on_points_set_aside()` of
`InterpolatingReconstructionVisitor`, which is told the first two kinds as one. Fewer than three
distinct points, or collinear ones, give no triangle. Points that lie in one plane, points with more
than 50 Delaunay tetrahedra each, and samples of an open sheet are handed on to `ctc_reconstruction()`, with
`keep_boundaries` if it is given, and may give a surface with boundary, or one that crosses itself. They are those of a
sheet if the flux of the normals through the facets of the convex hull is more than a quarter of their area both outward
and inward. A reconstruction that is cancelled writes
nothing.

The method is from chapter 5 of the thesis cited in the user manual; its function with marching cubes
is available as `Interpolating_surface_reconstruction_3::Linear_implicit_function_3`.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` (needs \ref thirdpartyTBB) or
`CGAL::Parallel_if_available_tag`
\tparam PointRange a model of `ForwardRange`, with at most \f$ 2^{32}-2 \f$ elements
\tparam OutputPointRange a model of `BackInsertionSequence` whose value type can be constructed from
`geom_traits::Point_3`
\tparam OutputTriangleRange a model of `BackInsertionSequence` whose value type has `operator[]` for 0, 1
and 2, with integers of type `std::size_t` or similar, for example `std::array<std::size_t, 3>` or
`std::vector<std::size_t>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points
\param output_points receives the vertices, in the order of `points`, then those that are no points of
the range
\param output_triangles receives for each triangle the positions of its vertices in `output_points`;
both ranges are appended to
\param np optional named parameters; those marked * start a pack or are joined by
`parameters::combine()`

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map from the elements of `points` to points}
    \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Point_3`}
    \cgalParamDefault{`CGAL::Identity_property_map`}
  \cgalParamNEnd
  \cgalParamNBegin{normal_map}
    \cgalParamDescription{a property map from the elements of `points` to normals of any length that
      all point outside, or all inside}
    \cgalParamType{a model of `ReadablePropertyMap` with value type `geom_traits::Vector_3`}
    \cgalParamDefault{none: the normals of a surface by `ctc_reconstruction()`}
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
    \cgalParamDescription{is told about stages and points set aside; pass `std::ref(visitor)` to keep its
      state}
    \cgalParamType{a model of `InterpolatingReconstructionVisitor`}
    \cgalParamDefault{`Interpolating_surface_reconstruction_3::Default_visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{grid_spacing}
    \cgalParamDescription{the largest length of an edge, in the unit of the points: longer edges are split, and
      the new vertices are moved onto a smooth surface between the samples; `0` adds no vertices. The
      surface stays a manifold, but may cross itself then}
    \cgalParamType{`geom_traits::FT`}
    \cgalParamDefault{`0`}
    \cgalParamExtra{`std::invalid_argument` is thrown if it is negative or not finite, or so small that
      there would be more than a billion triangles; the message states their number}
  \cgalParamNEnd
  \cgalParamNBegin{keep_boundaries}
    \cgalParamDescription{* whether openings stay open whose triangles are much larger than those around
      them and have no share in the normals. The surface may have a boundary then}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{neighbor_radius}
    \cgalParamDescription{the largest distance between neighbors in a star, in the unit of the points;
      `0` means no limit. Used if normals are not given}
    \cgalParamType{`geom_traits::FT`}
    \cgalParamDefault{`0`}
    \cgalParamExtra{`std::invalid_argument` is thrown if it is negative or not finite}
  \cgalParamNEnd
  \cgalParamNBegin{star_construction}
    \cgalParamDescription{* how the star of a point is made. Used if normals are not given}
    \cgalParamType{a model of `StarConstruction_3`}
    \cgalParamDefault{`Interpolating_surface_reconstruction_3::Restricted_voronoi_star_3`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `false` if the reconstruction was cancelled; the output is unchanged then.

The time and memory are those of a Delaunay triangulation of the points, of which \f$ n \f$ points on a
surface have \f$ O(n \log n) \f$ tetrahedra.

\sa `CGAL::poisson_surface_reconstruction_delaunay()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename PointRange, typename OutputPointRange,
          typename OutputTriangleRange, typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<boost::has_range_iterator<OutputTriangleRange>::value, int> = 0
#endif
          >
bool lis_reconstruction(const PointRange& points, OutputPointRange& output_points,
                        OutputTriangleRange& output_triangles, const NamedParameters& np = parameters::default_values())
{
  using Output_point = typename boost::range_value<OutputPointRange>::type;
  using Output_triangle = typename boost::range_value<OutputTriangleRange>::type;
  return Interpolating_surface_reconstruction_3::internal::reconstruct_lis<ConcurrencyTag>(
    points,
    [&](const auto& cloud, const auto& surface) {
      const std::size_t first = output_points.size();
      Interpolating_surface_reconstruction_3::internal::write_surface(
        cloud, surface, [&](const auto& point, std::size_t) { output_points.push_back(Output_point(point)); },
        [&](const std::array<std::size_t, 3>& triangle) {
          Output_triangle t;
          CGAL::internal::resize(t, 3);
          for (std::size_t i = 0; i != 3; ++i)
            t[i] = static_cast<std::decay_t<decltype(t[i])> >(first + triangle[i]);
          output_triangles.push_back(std::move(t));
        });
    },
    np);
}

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

reconstructs a surface through points with normals by a linear implicit function, as a mesh.

Only points that are used become vertices. The property map `"v:input_index"` of type `std::size_t`
holds the position of each vertex in `points`, and the largest `std::size_t` for vertices that are no
points of the range. The named parameters and guarantees are those of the overload for triangles.

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
bool lis_reconstruction(const PointRange& points, Surface_mesh<Point>& mesh,
                        const NamedParameters& np = parameters::default_values())
{
  using Mesh = Surface_mesh<Point>;
  using Vertex = typename Mesh::Vertex_index;
  // not yet `mesh`: the visitor is called once more when the surface has been written, and may throw
  Mesh result;
  const bool is_complete = Interpolating_surface_reconstruction_3::internal::reconstruct_lis<ConcurrencyTag>(
    points,
    [&](const auto& cloud, const auto& surface) {
      using Size = typename Mesh::size_type;
      auto input_index = result.template add_property_map<Vertex, std::size_t>("v:input_index", 0).first;
      const std::size_t triangles = surface.triangles.size(), vertices = cloud.size() + surface.added_points.size();
      result.reserve(static_cast<Size>(vertices), static_cast<Size>(triangles + triangles / 2),
                     static_cast<Size>(triangles));
      Interpolating_surface_reconstruction_3::internal::write_surface(
        cloud, surface, [&](const auto& point, std::size_t index) { input_index[result.add_vertex(point)] = index; },
        [&](const std::array<std::size_t, 3>& t) {
          result.add_face(Vertex(static_cast<Size>(t[0])), Vertex(static_cast<Size>(t[1])),
                          Vertex(static_cast<Size>(t[2])));
        });
    },
    np);
  if (is_complete)
    mesh = std::move(result);
  return is_complete;
}

} // namespace CGAL

#endif // CGAL_LIS_RECONSTRUCTION_H

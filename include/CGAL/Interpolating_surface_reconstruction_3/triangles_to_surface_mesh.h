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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_TRIANGLES_TO_SURFACE_MESH_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_TRIANGLES_TO_SURFACE_MESH_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Call_types.h>

#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

makes a mesh of triangles that are given by positions of points.

Only points that are used become vertices, in the order of their positions. The property map
`"v:input_index"` of type `std::size_t` holds these positions.

\tparam PointRange a model of `ForwardRange`
\tparam TriangleRange a model of `ForwardRange` whose elements have `operator[]` for 0, 1 and 2
\tparam Point the point type of the mesh
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points
\param triangles the triangles
\param mesh receives the triangles
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map from the elements of `points` to points}
    \cgalParamType{a model of `ReadablePropertyMap` with value type `Point`}
    \cgalParamDefault{`CGAL::Identity_property_map`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre `mesh` is empty, the triangles form an oriented 2-manifold

\return whether the triangles form one; the mesh is unchanged if not.
*/
template <typename PointRange, typename TriangleRange, typename Point,
          typename NamedParameters = parameters::Default_named_parameters>
bool triangles_to_surface_mesh(const PointRange& points, const TriangleRange& triangles, Surface_mesh<Point>& mesh,
                               const NamedParameters& np = parameters::default_values())
{
  using Mesh = Surface_mesh<Point>;
  using Vertex = typename Mesh::Vertex_index;
  using Point_map = typename internal::Call_types<PointRange, NamedParameters>::Point_map;
  const Point_map point_map =
    parameters::choose_parameter<Point_map>(parameters::get_parameter(np, internal_np::point_map));
  const std::size_t n = static_cast<std::size_t>(std::distance(points.begin(), points.end()));
  constexpr std::size_t UNUSED = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> vertex_of(n, UNUSED);
  for (const auto& t : triangles)
    for (int i = 0; i != 3; ++i)
      vertex_of[t[std::size_t(i)]] = 0;

  Mesh result;
  auto input_index = result.template add_property_map<Vertex, std::size_t>("v:input_index", 0).first;
  std::size_t i = 0;
  for (auto it = points.begin(); it != points.end(); ++it, ++i)
    if (vertex_of[i] != UNUSED) {
      const Vertex v = result.add_vertex(get(point_map, *it));
      vertex_of[i] = std::size_t(v);
      input_index[v] = i;
    }
  for (const auto& t : triangles)
    if (result.add_face(Vertex(typename Mesh::size_type(vertex_of[t[0]])),
                        Vertex(typename Mesh::size_type(vertex_of[t[1]])),
                        Vertex(typename Mesh::size_type(vertex_of[t[2]]))) == Mesh::null_face())
      return false;
  mesh = std::move(result);
  return true;
}

} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_TRIANGLES_TO_SURFACE_MESH_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_DEFAULT_VISITOR_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_DEFAULT_VISITOR_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

The stages of a reconstruction, in the order in which they run.
*/
enum class Stage
{
  INDEXING,      ///< copying, sorting and indexing the points
  STARS,         ///< a star of triangles at every point, from its neighbors
  COMPATIBILITY, ///< triangles on which the stars agree
  GROWING,       ///< growth of the surface from its most planar stars, by `pcr_reconstruction()`
  COMPLETION,    ///< closing of planar loops, completion of the surface where the stars conflict
  HOLES,         ///< closing of loops, dissolving of islands, insertion of points left over
  ORIENTATION,   ///< consistent orientation, outward for closed components
  FUNCTION,      ///< the implicit function of `lis_reconstruction()`
  ISOSURFACE     ///< the surface of the implicit function
};

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

What happened to a triangle proposed to the surface.
*/
enum class Triangle_verdict
{
  ADDED,          ///< the triangle is now part of the surface
  EDGE_FULL,      ///< an edge has two triangles already
  VERTEX_FULL,    ///< a vertex would have a closed fan and other triangles, or more than 1024
  NOT_ORIENTABLE, ///< the surface would become non-orientable
  DUPLICATE,      ///< the triangle is part of the surface already
  DEGENERATE,     ///< the three points are collinear
  FOLDED          ///< the triangle would lie on an adjacent one
};

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

The default visitor: every call does nothing. A visitor may derive from it and hide what it needs.

\cgalModels{InterpolatingReconstructionVisitor}
*/
struct Default_visitor
{
  /// called first, with the number of points in the range.
  void on_reconstruction_begin(std::size_t /* number_of_points */) { }

  /// called once after reading: `duplicates` coincide in double precision with another point that is kept,
  /// `non_finite` have a coordinate that is not a finite number or, for `lis_reconstruction()`, a normal
  /// that is zero or not finite. None of them is used.
  void on_points_set_aside(std::size_t /* duplicates */, std::size_t /* non_finite */) { }

  /// called when a stage begins.
  void on_stage_begin(Stage /* stage */) { }

  /// polled during the reconstruction, possibly from several threads; `false` cancels.
  bool go_further() { return true; }

  /// called for each triangle proposed after the agreed ones, with positions in the input range; during
  /// `Stage::GROWING`, for the agreed ones as well.
  void on_triangle(const std::array<std::size_t, 3>& /* triangle */, Triangle_verdict /* verdict */) { }

  /// called when a stage ends, with the number of items that it produced.
  void on_stage_end(Stage /* stage */, std::size_t /* items */) { }

  /// called before the end, unless cancelled, with the number of distinct finite points that no
  /// triangle uses.
  void on_points_unused(std::size_t /* unused */) { }

  /// called last.
  void on_reconstruction_end(bool /* cancelled */) { }
};

} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_DEFAULT_VISITOR_H

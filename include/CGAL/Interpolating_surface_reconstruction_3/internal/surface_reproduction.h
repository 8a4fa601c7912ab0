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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_REPRODUCTION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_REPRODUCTION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Component_contacts.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Surface_sides.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelled_surface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_labelling.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Labels of the cells between which the surface is as large as that of the oriented triangles, and has as many
// components, if there are any: it is the same one then, up to diagonals. `normals` are those of its points, and must
// outlive the labels. No more than `maximum_doubts` points may have triangles that are no facets.
// Ends early if cancelled; `cancellation_point()` may throw.
template <typename ConcurrencyTag, typename Progress, typename CancellationPoint>
std::optional<Oriented_labelling>
reproduce_surface(const Cell_complex& cells, const std::vector<std::array<Point_index, 3> >& triangles,
                  const std::vector<Local_point>& points, const std::vector<Local_vector>& normals,
                  std::size_t maximum_doubts, Progress& progress, CancellationPoint& cancellation_point)
{
  std::vector<unsigned char> is_in_doubt(points.size(), 0);
  const Surface_sides sides(cells, triangles, is_in_doubt, cancellation_point);
  if (static_cast<std::size_t>(std::count(is_in_doubt.begin(), is_in_doubt.end(), 1)) > maximum_doubts)
    return std::nullopt;
  Oriented_labelling labelling =
    label_by_sides<ConcurrencyTag>(cells, sides, points, normals, progress, cancellation_point);
  make_nearly_manifold(cells, labelling, cancellation_point);
  const auto labelled = facets_between_labels(cells, labelling, cancellation_point);
  if (labelled.size() != triangles.size() ||
      Component_contacts(points, labelled).size() != Component_contacts(points, triangles).size())
    return std::nullopt;
  return labelling;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_REPRODUCTION_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_EXCHANGE_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_EXCHANGE_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Attaches all of the triangles; if the gate of the builder refuses one, none, and returns false.
template <typename Builder, typename OnVerdict>
bool attach_all(Builder& builder, const std::vector<std::array<Point_index, 3> >& triangles, OnVerdict& on_verdict)
{
  const std::size_t before = builder.number_of_stored_triangles();
  for (const std::array<Point_index, 3>& t : triangles) {
    const Triangle_verdict verdict = builder.try_add(t[0], t[1], t[2]);
    on_verdict(t, verdict);
    if (verdict == Triangle_verdict::ADDED)
      continue;
    for (std::size_t added = builder.number_of_stored_triangles(); added-- != before;)
      builder.remove(static_cast<typename Builder::Triangle_index>(added));
    return false;
  }
  return true;
}

// Exchanges triangles of the surface for others. Returns how the former were stored, or nothing, with the surface as it
// was, if the gate of the builder refuses more of the added ones than `maximum_refused`. `cancellation_point()` is called
// again and again and may throw, before anything changes.
template <typename Builder, typename CancellationPoint>
std::optional<std::vector<typename Builder::Removed_triangle> >
exchange_triangles(Builder& builder, const std::vector<std::array<Point_index, 3> >& removed,
                   std::vector<std::array<Point_index, 3> > added, std::size_t maximum_refused,
                   CancellationPoint& cancellation_point)
{
  using Triangle = std::array<Point_index, 3>;
  const auto open = [&](const Triangle& t) {
    cancellation_point();
    for (Point_index p : t)
      builder.open(p);
  };
  std::for_each(removed.begin(), removed.end(), open);
  std::for_each(added.begin(), added.end(), open);
  const auto remove = [&](const Triangle& t) { return builder.remove(builder.find_triangle(t[0], t[1], t[2])); };
  std::vector<typename Builder::Removed_triangle> stored;
  std::transform(removed.begin(), removed.end(), std::back_inserter(stored), remove);
  std::sort(added.begin(), added.end());
  std::size_t refused = 0, attached = 0; // the attached ones come to the front
  for (std::size_t i = 0; i != added.size() && refused <= maximum_refused; ++i)
    if (builder.try_add(added[i][0], added[i][1], added[i][2]) == Triangle_verdict::ADDED)
      added[attached++] = added[i];
    else
      ++refused;
  if (refused <= maximum_refused)
    return stored;
  while (attached-- != 0)
    remove(added[attached]);
  for (const auto& t : stored)
    builder.restore(t);
  return std::nullopt;
}

// The same for all triangles of the points, which are whole components. Returns the triangles removed, or none.
template <typename Builder, typename CancellationPoint>
std::vector<std::array<Point_index, 3> > exchange_triangles(Builder& builder, const std::vector<Point_index>& points,
                                                            std::vector<std::array<Point_index, 3> > added,
                                                            CancellationPoint& cancellation_point,
                                                            std::size_t maximum_refused = 0)
{
  using Triangle = std::array<Point_index, 3>;
  std::vector<Triangle> removed;
  for (Point_index p : points) {
    cancellation_point();
    builder.open(p);
    builder.for_each_triangle_at(p, [&](const Triangle& t) {
      if (t[0] < t[1] && t[0] < t[2])
        removed.push_back(t);
    });
  }
  if (!exchange_triangles(builder, removed, std::move(added), maximum_refused, cancellation_point))
    removed.clear();
  return removed;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_EXCHANGE_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACE_FILLER_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACE_FILLER_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Face_rims.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Face_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_loops.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/flatness.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_crossings.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Which faces are filled.
enum class Face_selection
{
  ALL,
  EXACT_WITH_HOLES // those that only rounding keeps from being in a plane, of which several loops are the rims
};

// Fills boundary loops together that lie in one plane: the flat faces of a part, with holes or without, have points at
// the walls only, and a face filled inside of each loop would lie on others. What is inside of an odd number of rims of
// walls is filled, by the constrained Delaunay triangulation in the plane. What lies in the plane already, between points
// of walls, is taken off for it: caps of holes, and what stars and completion put there.
template <typename Builder>
class Face_filler
{
public:
  Face_filler(const std::vector<Local_point>& points, Builder& builder, Face_selection selection)
    : m_points(points), m_builder(builder), m_needs_holes(selection == Face_selection::EXACT_WITH_HOLES),
      m_rims(points, builder, m_needs_holes ? ROUNDING_OF_FIVE_DIGITS : Face_rims<Builder>::FLATNESS),
      m_triangulate(points)
  { }

  // Leaves loops for which stays_open(loop) holds, faces without holes in whose plane nothing lies, which are simple, and
  // those with which the surface would not stay a manifold.
  template <typename StaysOpen, typename OnVerdict, typename CancellationPoint>
  void operator()(const StaysOpen& stays_open, OnVerdict on_verdict, CancellationPoint& cancellation_point)
  {
    const std::vector<Boundary_loop> loops = Boundary_loops<Builder>(m_points, m_builder)(cancellation_point);
    std::vector<Planar_loop> planar;
    for (const Boundary_loop& loop : loops) {
      cancellation_point(loop.size());
      if (stays_open(loop))
        continue;
      if (const std::optional<Face_plane> plane = m_rims.plane(loop))
        planar.push_back(Planar_loop{ &loop, *plane, false });
    }
    std::stable_sort(planar.begin(), planar.end(),
                     [](const Planar_loop& a, const Planar_loop& b) { return a.plane.area > b.plane.area; });
    std::size_t planes = 0;
    for (const Planar_loop& outer : planar) {
      if (outer.is_done || outer.loop->size() < Face_rims<Builder>::MINIMUM_OUTER_SIZE || planes++ >= MAXIMUM_PLANES)
        continue;
      cancellation_point(planar.size());
      for (Planar_loop& other : planar)
        other.is_done = other.is_done || !m_rims(*other.loop, outer.plane).empty();
      fill_plane(outer.plane, stays_open, on_verdict, cancellation_point);
    }
  }

private:
  using Triangle = typename Builder::Triangle;

  struct Planar_loop
  {
    const Boundary_loop* loop;
    Face_plane plane;
    bool is_done;
  };

  // All triangles are looked at for each.
  static constexpr std::size_t MAXIMUM_PLANES = 16;

  // If that is not possible, all stays as it was.
  template <typename StaysOpen, typename OnVerdict, typename CancellationPoint>
  void fill_plane(const Face_plane& plane, const StaysOpen& stays_open, OnVerdict& on_verdict,
                  CancellationPoint& cancellation_point)
  {
    const std::vector<Triangle> removed = find_removable(plane, cancellation_point);
    std::vector<typename Builder::Removed_triangle> stored;
    for (const Triangle& t : removed)
      stored.push_back(m_builder.remove(m_builder.find_triangle(t[0], t[1], t[2])));
    bool has_long_gap = false;
    const std::vector<Boundary_loop> rims = find_rims(plane, stays_open, has_long_gap, cancellation_point);
    const Flat_face face = m_triangulate(plane, rims, loose_points(removed), cancellation_point);
    // Without holes, it may be a lid of a sheet.
    const bool is_certain = face.has_holes || !(m_needs_holes || removed.empty() || has_long_gap);
    if (!is_certain || !attach(face, on_verdict, cancellation_point))
      for (const auto& t : stored)
        m_builder.restore(t);
  }

  // Where rims pinch or walls have gaps, some triangles may not be possible: what they leave is closed later. Attaches
  // none and returns false if these are many, or if it is a sheet that would be covered, or a lid that crosses the surface.
  template <typename OnVerdict, typename CancellationPoint>
  bool attach(const Flat_face& face, OnVerdict& on_verdict, CancellationPoint& cancellation_point)
  {
    constexpr std::size_t TRIANGLES_PER_GAP = 8;
    // A face without holes has two triangles less than points.
    if (face.triangles.empty() || 2 * number_of_folds(face.triangles) > face.triangles.size() + 2)
      return false;
    using Index = typename Builder::Triangle_index;
    const std::size_t before = m_builder.number_of_stored_triangles();
    std::size_t refused = 0;
    for (const Triangle& t : face.triangles) {
      const Triangle_verdict verdict = m_builder.try_add(t[0], t[1], t[2]);
      on_verdict(t, verdict);
      refused += verdict == Triangle_verdict::ADDED ? 0u : 1u;
    }
    if (refused * TRIANGLES_PER_GAP <= face.triangles.size() &&
        Surface_crossings<Builder>(m_points, m_builder)(static_cast<Index>(before), cancellation_point).empty())
      return true;
    for (std::size_t added = m_builder.number_of_stored_triangles(); added-- != before;)
      m_builder.remove(static_cast<Index>(added));
    return false;
  }

  // Triangles of the surface in the plane, but for those of parts most of whose points are samples of the face: these are
  // right.
  template <typename CancellationPoint>
  std::vector<Triangle> find_removable(const Face_plane& plane, CancellationPoint& cancellation_point)
  {
    std::vector<Triangle> flat, result;
    std::vector<Point_index> points, samples;
    Parity_union_find parts(m_points.size());
    m_builder.for_each_triangle([&](const Triangle& t, auto) {
      cancellation_point();
      if (!m_rims.is_in_plane(t, plane))
        return;
      flat.push_back(t);
      points.insert(points.end(), t.begin(), t.end());
      parts.unite(t[0], t[1], false);
      parts.unite(t[0], t[2], false);
    });
    sort_and_unique(points);
    std::copy_if(points.begin(), points.end(), std::back_inserter(samples),
                 [&](Point_index p) { return is_sample(p, plane); });
    const std::vector<Point_index> roots = sorted_roots(parts, points), roots_of_samples = sorted_roots(parts, samples);
    std::copy_if(flat.begin(), flat.end(), std::back_inserter(result), [&](const Triangle& t) {
      const Point_index root = parts.find(t[0]).root;
      return 2 * number_of(root, roots_of_samples) <= number_of(root, roots);
    });
    for (const Triangle& t : result)
      for (Point_index p : t)
        m_builder.open(p);
    return result;
  }

  static std::vector<Point_index> sorted_roots(Parity_union_find& parts, const std::vector<Point_index>& points)
  {
    std::vector<Point_index> result;
    std::transform(points.begin(), points.end(), std::back_inserter(result),
                   [&](Point_index p) { return parts.find(p).root; });
    std::sort(result.begin(), result.end());
    return result;
  }

  static std::ptrdiff_t number_of(Point_index root, const std::vector<Point_index>& sorted_roots)
  {
    const auto range = std::equal_range(sorted_roots.begin(), sorted_roots.end(), root);
    return range.second - range.first;
  }

  // Off all walls, with a star that is closed and agreed on.
  bool is_sample(Point_index p, const Face_plane& plane) const
  {
    const auto& compatibility = m_builder.compatibility();
    if (!compatibility.is_point_agreed(p) || compatibility.is_point_on_boundary(p))
      return false;
    bool result = true;
    m_builder.for_each_triangle_at(p, [&](const Triangle& t) { result = result && m_rims.is_in_plane(t, plane); });
    return result;
  }

  static void sort_and_unique(std::vector<Point_index>& points)
  {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }

  // Those of removed triangles that have no others.
  std::vector<Point_index> loose_points(const std::vector<Triangle>& removed) const
  {
    std::vector<Point_index> result;
    for (const Triangle& t : removed)
      std::copy_if(t.begin(), t.end(), std::back_inserter(result),
                   [&](Point_index p) { return m_builder.corners(p).empty(); });
    sort_and_unique(result);
    return result;
  }

  // The rims of the boundary loops in the plane; none if one of them stays open. Tells whether one has a long gap.
  template <typename StaysOpen, typename CancellationPoint>
  std::vector<Boundary_loop> find_rims(const Face_plane& plane, const StaysOpen& stays_open, bool& has_long_gap,
                                       CancellationPoint& cancellation_point) const
  {
    std::vector<Boundary_loop> result;
    for (const Boundary_loop& loop : Boundary_loops<Builder>(m_points, m_builder)(cancellation_point)) {
      std::vector<Boundary_loop> rims = m_rims(loop, plane);
      if (!rims.empty() && stays_open(loop))
        return {};
      has_long_gap = has_long_gap || (!rims.empty() && m_rims.has_long_gap(loop, plane));
      std::move(rims.begin(), rims.end(), std::back_inserter(result));
    }
    return result;
  }

  // The edges at which triangles lie on those of the surface, as they would on a sheet that ends there.
  std::size_t number_of_folds(const std::vector<Triangle>& triangles) const
  {
    std::size_t result = 0;
    for (const Triangle& t : triangles)
      for (std::size_t i = 0; i != 3; ++i) {
        const Point_index p = t[i], q = t[(i + 1) % 3], r = t[(i + 2) % 3];
        const Point_index opposite = m_builder.opposite_vertex(p, q);
        if (opposite != NO_POINT && m_builder.number_of_triangles(p, q) == 1 && is_sharp(p, q, r, opposite))
          ++result;
      }
    return result;
  }

  // Whether the angle at the edge (p, q) is less than 45 degrees.
  bool is_sharp(Point_index p, Point_index q, Point_index r, Point_index opposite) const
  {
    const Local_vector e = m_points[q] - m_points[p], a = cross_product(e, m_points[r] - m_points[p]),
                       b = cross_product(e, m_points[opposite] - m_points[p]);
    const double cosine = a * b;
    return cosine > 0. && 2. * cosine * cosine > a.squared_length() * b.squared_length();
  }

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  const bool m_needs_holes;
  const Face_rims<Builder> m_rims;
  const Face_triangulation m_triangulate;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACE_FILLER_H

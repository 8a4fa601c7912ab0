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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_CROSSINGS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_CROSSINGS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_intersection.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Finds where triangles that were attached late cross the surface: those between stars that agree and
// those of a labelling do not cross each other.
template <typename Builder>
class Surface_crossings
{
public:
  using Triangle_index = typename Builder::Triangle_index;

  // Two points of triangles that cross, the smaller one first.
  using Crossing = std::pair<Point_index, Point_index>;

  Surface_crossings(const std::vector<Local_point>& points, const Builder& builder)
    : m_points(points), m_builder(builder)
  { }

  // Crossings of the triangles stored from `first` on with any others, sorted. Where the boxes of very many pairs meet, as
  // of thin triangles, each of the former triangles counts as one that crosses itself. `cancellation_point()` is called
  // again and again and may throw.
  template <typename CancellationPoint>
  std::vector<Crossing> operator()(Triangle_index first, CancellationPoint& cancellation_point)
  {
    std::vector<Crossing> crossings;
    for_each(
      first, [](const Triangle&) { return true; },
      [&](const Triangle& s, const Triangle& t) { crossings.push_back(std::minmax(s[0], t[0])); }, cancellation_point);
    std::sort(crossings.begin(), crossings.end());
    crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());
    return crossings;
  }

  // The same crossings of those of the triangles with `is_suspect(triangle)`, as calls of visit(triangle, other triangle),
  // some of them twice.
  template <typename IsSuspect, typename Visit, typename CancellationPoint>
  void for_each(Triangle_index first, const IsSuspect& is_suspect, const Visit& visit,
                CancellationPoint& cancellation_point)
  {
    m_late.clear();
    for (Triangle_index t = first; t != m_builder.number_of_stored_triangles(); ++t)
      if (!m_builder.is_removed(t) && is_suspect(m_builder.triangle(t)))
        add_box(m_builder.triangle(t), m_late);
    m_pairs_left = (std::max)(PAIRS_OF_FEW_POINTS, PAIRS_PER_POINT * m_points.size());
    if (m_late.empty())
      return;
    sort_late();
    try {
      cross_with_surface(visit, cancellation_point);
    } catch (const Too_many_pairs&) {
      for (const Box& box : m_late)
        visit(box.info(), box.info());
    }
  }

private:
  using Triangle = typename Builder::Triangle;
  using Box = Box_intersection_d::Box_with_info_d<double, 3, Triangle>;

  struct Too_many_pairs
  { };

  // Well-shaped triangles have about ten. The boxes of a few thousand thin ones may all meet.
  static constexpr std::size_t PAIRS_PER_POINT = 64, PAIRS_OF_FEW_POINTS = 1 << 18;

  // Of late triangles next to another one.
  static constexpr int MAXIMUM_TESTS = 16;

  // Sets of boxes that are not divided further. Measured: half the time of the default.
  static constexpr std::ptrdiff_t LARGEST_SCAN = 1000;

  // Triangles of the surface that are looked at together, if the late ones are not more.
  static constexpr std::size_t BLOCK_SIZE = 1 << 15;

  void sort_late()
  {
    std::sort(m_late.begin(), m_late.end(), [](const Box& a, const Box& b) { return a.min_coord(0) < b.min_coord(0); });
    m_late_width = 0.;
    for (const Box& box : m_late)
      m_late_width = (std::max)(m_late_width, box.max_coord(0) - box.min_coord(0));
  }

  // Whether the triangle may meet a late one: a quick test, as most are far from all of these.
  bool may_cross(const Triangle& t) const
  {
    const Bbox_3 box = bbox(t);
    auto late = std::lower_bound(m_late.begin(), m_late.end(), box.xmin() - m_late_width,
                                 [](const Box& b, double x) { return b.min_coord(0) < x; });
    for (int k = 0; late != m_late.end() && late->min_coord(0) <= box.xmax(); ++late, ++k)
      if (k == MAXIMUM_TESTS || do_overlap(late->bbox(), box))
        return true;
    return false;
  }

  template <typename Visit, typename CancellationPoint>
  void cross_with_surface(const Visit& visit, CancellationPoint& cancellation_point)
  {
    const std::size_t block_size = (std::max)(BLOCK_SIZE, m_late.size());
    std::vector<Box> block;
    block.reserve(block_size);
    m_builder.for_each_triangle([&](const Triangle& t, Parity_union_find::Element) {
      if (may_cross(t))
        add_box(t, block);
      if (block.size() == block_size)
        cross_with(block, visit, cancellation_point);
    });
    cross_with(block, visit, cancellation_point);
  }

  template <typename Visit, typename CancellationPoint>
  void cross_with(std::vector<Box>& block, const Visit& visit, CancellationPoint& cancellation_point)
  {
    std::vector<Box> late(m_late); // gets into another order
    box_intersection_d(
      late.begin(), late.end(), block.begin(), block.end(),
      [&](const Box& a, const Box& b) {
        cancellation_point();
        if (m_pairs_left-- == 0)
          throw Too_many_pairs();
        if (!is_same(a.info(), b.info()) &&
            do_triangles_cross(a.info(), b.info(), [this](Point_index p) { return exact_point(m_points[p]); }))
          visit(a.info(), b.info());
      },
      LARGEST_SCAN);
    block.clear();
  }

  static bool is_same(Triangle s, Triangle t)
  {
    std::sort(s.begin(), s.end());
    std::sort(t.begin(), t.end());
    return s == t;
  }

  // But of degenerate triangles.
  void add_box(const Triangle& t, std::vector<Box>& boxes) const
  {
    if (!is_degenerate(t, [this](Point_index p) { return exact_point(m_points[p]); }))
      boxes.emplace_back(bbox(t), t);
  }

  Bbox_3 bbox(const Triangle& t) const { return m_points[t[0]].bbox() + m_points[t[1]].bbox() + m_points[t[2]].bbox(); }

  const std::vector<Local_point>& m_points;
  const Builder& m_builder;
  std::vector<Box> m_late;  // by their smallest x
  double m_late_width = 0.; // of the widest one in x
  std::size_t m_pairs_left = 0;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_CROSSINGS_H

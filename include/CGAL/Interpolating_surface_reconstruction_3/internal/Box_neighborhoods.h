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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BOX_NEIGHBORHOODS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BOX_NEIGHBORHOODS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Point_star.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The neighborhoods of 4.3.2: all points of a leaf have the same neighbors, namely the points of
// the leaf and of those adjacent leaves whose enlarged boxes intersect the leaf's enlarged box. One
// object serves one thread; its buffers are kept from leaf to leaf.
class Box_neighborhoods
{
public:
  // No point farther than `maximum_radius` is a neighbor; if boundaries are kept, only nearer ones are.
  Box_neighborhoods(const std::vector<Local_point>& points, const Point_octree_3& octree, double maximum_radius,
                    bool keeps_boundaries = false)
    : m_points(points), m_octree(octree), m_maximum_radius(maximum_radius), m_keeps_boundaries(keeps_boundaries)
  { }

  // Indices of the neighbors that were passed last.
  const std::vector<Point_index>& indices() const { return m_indices; }

  // Calls visit(p, neighborhood) once for each point p of the leaf, with its neighbors or with the
  // `maximum_size` nearest of them. Asking for more has no effect: the boxes decide.
  template <typename Visit>
  void for_each_point(const Point_octree_3::Node& leaf, std::size_t /* size */, std::size_t maximum_size, Visit visit)
  {
    gather(leaf);
    for (Point_index p = leaf.begin; p != leaf.end; ++p) {
      sort_by_distance(p,
                       m_keeps_boundaries ? (std::min)(maximum_size, NEIGHBORS_THIS_SIDE_OF_OPENINGS) : maximum_size);
      // The boxes do not promise a radius within which all points are listed.
      visit(p, Star_neighborhood(m_offsets.data(), m_offsets.size(), 0., false, m_keeps_boundaries));
    }
  }

private:
  struct Neighbor
  {
    double squared_distance;
    Point_index index;
    bool operator<(const Neighbor& other) const
    {
      return squared_distance < other.squared_distance ||
             (squared_distance == other.squared_distance && index < other.index);
    }
  };

  // A star that sees more closes an opening that shall stay.
  static constexpr std::size_t NEIGHBORS_THIS_SIDE_OF_OPENINGS = 64;

  // Two cells with a common corner touch although their coordinates are rounded.
  static constexpr double ROUNDING = 1e-9;

  static Local_box cell_box(const Octree_cube& cell)
  {
    return Local_box{
      { cell.origin[0], cell.origin[1], cell.origin[2] },
      { cell.origin[0] + cell.size, cell.origin[1] + cell.size, cell.origin[2] + cell.size }
    }.enlarged(cell.size * ROUNDING);
  }

  // The cube around the center of the leaf's tight box. Its half side, not its side as one may also
  // read 4.3.2, is twice the distance from the center to the nearest corner of the cell, which
  // counts at least as far as the corners of the box. Half of it cuts leaves off where points and
  // cells are aligned, because the gap between two boxes is then wider than what they gain.
  static Local_box enlarged_box(const Point_octree_3::Node& leaf)
  {
    double squared_to_box = 0., squared_to_cell = 0.;
    std::array<double, 3> center{};
    for (std::size_t a = 0; a != 3; ++a) {
      center[a] = leaf.box.low[a] / 2 + leaf.box.high[a] / 2;
      const double to_box = leaf.box.high[a] - center[a];
      const double from_origin = center[a] - leaf.cell.origin[a];
      const double to_cell = (std::min)(from_origin, leaf.cell.size - from_origin);
      squared_to_box += to_box * to_box;
      squared_to_cell += to_cell * to_cell;
    }
    return Local_box{ center, center }.enlarged(2. * std::sqrt((std::max)(squared_to_box, squared_to_cell)));
  }

  // Points of the leaf and of its neighbors.
  void gather(const Point_octree_3::Node& leaf)
  {
    m_candidates.clear();
    const Local_box cell = cell_box(leaf.cell), box = enlarged_box(leaf);
    m_stack.assign(1, 0);
    while (!m_stack.empty()) {
      const Point_octree_3::Node& n = m_octree.node(m_stack.back());
      m_stack.pop_back();
      if (!cell_box(n.cell).overlaps(cell))
        continue;
      if (n.number_of_children == 0 && (n.begin == leaf.begin || enlarged_box(n).overlaps(box)))
        append_points(n);
      for (std::uint32_t c = 0; c != n.number_of_children; ++c)
        m_stack.push_back(n.first_child + c);
    }
  }

  // A larger leaf is one place in double coordinates, for which some of its points stand.
  void append_points(const Point_octree_3::Node& leaf)
  {
    const std::size_t n = (std::min)(OCTREE_LEAF_SIZE, std::size_t(leaf.end - leaf.begin));
    for (std::size_t i = 0; i != n; ++i)
      m_candidates.push_back(leaf.begin + static_cast<Point_index>(i));
  }

  void sort_by_distance(Point_index center, std::size_t maximum_size)
  {
    const Local_point& p = m_points[center];
    const double squared_maximum_radius = m_maximum_radius * m_maximum_radius;
    m_neighbors.clear();
    for (Point_index i : m_candidates) {
      const double squared_distance = (m_points[i] - p).squared_length();
      if (i != center && squared_distance <= squared_maximum_radius)
        m_neighbors.push_back(Neighbor{ squared_distance, i });
    }
    if (m_neighbors.size() > maximum_size) {
      std::nth_element(m_neighbors.begin(), m_neighbors.begin() + std::ptrdiff_t(maximum_size), m_neighbors.end());
      m_neighbors.resize(maximum_size);
    }
    std::sort(m_neighbors.begin(), m_neighbors.end());
    m_indices.clear();
    m_offsets.clear();
    for (const Neighbor& n : m_neighbors) {
      m_indices.push_back(n.index);
      m_offsets.push_back(m_points[n.index] - p);
    }
  }

  const std::vector<Local_point>& m_points;
  const Point_octree_3& m_octree;
  double m_maximum_radius;
  bool m_keeps_boundaries;
  std::vector<std::uint32_t> m_stack;
  std::vector<Point_index> m_candidates;
  std::vector<Neighbor> m_neighbors;
  std::vector<Point_index> m_indices;
  std::vector<Local_vector> m_offsets;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BOX_NEIGHBORHOODS_H

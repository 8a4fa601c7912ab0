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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BOX_HIERARCHY_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BOX_HIERARCHY_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Boxes in a binary tree of the boxes around them, each half of them on one side of the longest extent, to find those
// that meet another box.
class Box_hierarchy
{
public:
  using Box_index = std::uint32_t;

  // `cancellation_point()` is called again and again and may throw.
  template <typename CancellationPoint>
  Box_hierarchy(std::vector<Bbox_3> boxes, CancellationPoint& cancellation_point)
    : m_boxes(std::move(boxes)), m_order(m_boxes.size())
  {
    std::iota(m_order.begin(), m_order.end(), Box_index(0));
    if (!m_boxes.empty())
      build(0, m_boxes.size(), cancellation_point);
  }

  // Calls visit(i) for each box that has a point in common with the given one.
  template <typename Visit>
  void for_each_meeting(const Bbox_3& box, const Visit& visit) const
  {
    std::size_t todo[MAXIMUM_DEPTH], height = 0;
    if (!m_nodes.empty())
      todo[height++] = 0;
    while (height != 0) {
      const std::size_t k = todo[--height];
      const Node& node = m_nodes[k];
      if (!do_overlap(node.box, box))
        continue;
      if (node.second_child == NO_NODE) {
        for (std::size_t i = node.begin; i != node.end; ++i)
          if (do_overlap(m_boxes[m_order[i]], box))
            visit(m_order[i]);
      } else {
        todo[height++] = node.second_child;
        todo[height++] = k + 1;
      }
    }
  }

private:
  static constexpr std::uint32_t NO_NODE = static_cast<std::uint32_t>(-1);

  // Each level halves the boxes, of which there are less than two to the power of 32.
  static constexpr std::size_t MAXIMUM_DEPTH = 64;

  static constexpr std::size_t BOXES_PER_LEAF = 4;

  // The first child comes next.
  struct Node
  {
    Bbox_3 box;
    std::uint32_t begin, end; // in the order
    std::uint32_t second_child;
  };

  template <typename CancellationPoint>
  void build(std::size_t begin, std::size_t end, CancellationPoint& cancellation_point)
  {
    cancellation_point();
    const std::size_t id = m_nodes.size();
    Bbox_3 box;
    for (std::size_t i = begin; i != end; ++i)
      box += m_boxes[m_order[i]];
    m_nodes.push_back(Node{ box, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), NO_NODE });
    if (end - begin <= BOXES_PER_LEAF)
      return;
    const int axis = longest_axis(box);
    const auto twice_center = [&](Box_index i) { return m_boxes[i].min(axis) + m_boxes[i].max(axis); };
    const std::size_t middle = (begin + end) / 2;
    const auto first = m_order.begin();
    std::nth_element(first + std::ptrdiff_t(begin), first + std::ptrdiff_t(middle), first + std::ptrdiff_t(end),
                     [&](Box_index i, Box_index j) { return twice_center(i) < twice_center(j); });
    build(begin, middle, cancellation_point);
    m_nodes[id].second_child = static_cast<std::uint32_t>(m_nodes.size());
    build(middle, end, cancellation_point);
  }

  static int longest_axis(const Bbox_3& box)
  {
    const auto extent = [&](int axis) { return box.max(axis) - box.min(axis); };
    const int longer = extent(0) < extent(1) ? 1 : 0;
    return extent(longer) < extent(2) ? 2 : longer;
  }

  std::vector<Bbox_3> m_boxes;
  std::vector<Box_index> m_order; // of the leaves
  std::vector<Node> m_nodes;      // the root first
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BOX_HIERARCHY_H

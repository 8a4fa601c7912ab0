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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_POINT_OCTREE_3_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_POINT_OCTREE_3_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Morton_order.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// An axis-aligned box; bounds are included.
struct Local_box
{
  static constexpr double FAR = std::numeric_limits<double>::infinity();

  std::array<double, 3> low{ { FAR, FAR, FAR } }, high{ { -FAR, -FAR, -FAR } }; // contains nothing

  void include(const Local_point& p)
  {
    for (std::size_t a = 0; a != 3; ++a) {
      low[a] = (std::min)(low[a], p[static_cast<int>(a)]);
      high[a] = (std::max)(high[a], p[static_cast<int>(a)]);
    }
  }

  void include(const Local_box& other)
  {
    for (std::size_t a = 0; a != 3; ++a) {
      low[a] = (std::min)(low[a], other.low[a]);
      high[a] = (std::max)(high[a], other.high[a]);
    }
  }

  bool overlaps(const Local_box& other) const
  {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] && other.low[1] <= high[1] &&
           low[2] <= other.high[2] && other.low[2] <= high[2];
  }

  bool contains(const Local_box& other) const
  {
    return low[0] <= other.low[0] && other.high[0] <= high[0] && low[1] <= other.low[1] && other.high[1] <= high[1] &&
           low[2] <= other.low[2] && other.high[2] <= high[2];
  }

  // Without branches: for most points that are asked for, either answer is likely.
  bool contains(const Local_point& p) const
  {
    const auto is_between = [](double l, double x, double h) { return int(l <= x) & int(x <= h); };
    return (is_between(low[0], p.x(), high[0]) & is_between(low[1], p.y(), high[1]) &
            is_between(low[2], p.z(), high[2])) != 0;
  }

  // To the nearest point of the box. Like the difference of two points, so that rounding does not put a box behind its
  // points.
  double squared_distance(const Local_point& p) const
  {
    double result = 0.;
    for (std::size_t a = 0; a != 3; ++a) {
      const double x = p[static_cast<int>(a)], d = (std::max)({ low[a] - x, x - high[a], 0. });
      result += d * d;
    }
    return result;
  }

  Local_box enlarged(double by) const
  {
    return Local_box{ { low[0] - by, low[1] - by, low[2] - by }, { high[0] + by, high[1] + by, high[2] + by } };
  }
};

// The octree of 4.3.1 over points in Morton order: a node is an interval of the points, its tight box
// and its cell. Chains of nodes with one child are left out. Nothing changes after construction.
class Point_octree_3
{
public:
  struct Node
  {
    Octree_cube cell;
    Local_box box;
    Point_index begin, end;
    std::uint32_t parent;
    std::uint32_t first_child;
    std::uint32_t number_of_children; // 0 for a leaf
  };

  explicit Point_octree_3(const std::vector<Local_point>& points) : m_points(points)
  {
    if (points.empty())
      return;
    m_keys.resize(points.size());
    m_nodes.push_back(Node());
    m_nodes[0].begin = 0;
    m_nodes[0].end = static_cast<Point_index>(points.size());
    m_nodes[0].parent = 0;
    std::vector<Pending> stack{ Pending{ 0, MORTON_LEVELS } };
    while (!stack.empty()) {
      const Pending next = stack.back();
      stack.pop_back();
      subdivide(next, stack);
    }
    compute_boxes();
    std::vector<Morton_code>().swap(m_keys);
  }

  const std::vector<Node>& nodes() const { return m_nodes; }
  const Node& node(std::uint32_t i) const { return m_nodes[i]; }
  // The leaves in the order of their points.
  const std::vector<std::uint32_t>& leaves() const { return m_leaves; }

  // The leaf that holds a point.
  std::uint32_t leaf_of(Point_index p) const
  {
    return *(std::upper_bound(m_leaves.begin(), m_leaves.end(), p,
                              [&](Point_index q, std::uint32_t leaf) { return q < m_nodes[leaf].begin; }) -
             1);
  }

  // Calls visit(leaf) for every leaf whose tight box overlaps `box`, in their order, until it returns false.
  template <typename Visit>
  void for_each_leaf_overlapping(const Local_box& box, Visit visit) const
  {
    std::vector<std::uint32_t> stack;
    for_each_leaf_overlapping(box, stack, visit);
  }

  // The same with a stack that the caller keeps.
  template <typename Visit>
  void for_each_leaf_overlapping(const Local_box& box, std::vector<std::uint32_t>& stack, Visit visit) const
  {
    for_each_leaf(
      stack, [&](std::uint32_t i) { return m_nodes[i].box.overlaps(box); },
      [&](std::uint32_t i) { return visit(m_nodes[i]); });
  }

  // Calls visit(i) for every leaf i such that is_near(j) holds for it and for all nodes j above it, in their order, until
  // it returns false.
  template <typename IsNear, typename Visit>
  void for_each_leaf(std::vector<std::uint32_t>& stack, const IsNear& is_near, const Visit& visit) const
  {
    stack.clear();
    if (!m_nodes.empty())
      stack.push_back(0);
    while (!stack.empty()) {
      const std::uint32_t i = stack.back();
      stack.pop_back();
      if (!is_near(i))
        continue;
      const Node& n = m_nodes[i];
      if (n.number_of_children == 0 && !visit(i))
        return;
      for (std::uint32_t c = n.number_of_children; c-- != 0;)
        stack.push_back(n.first_child + c);
    }
  }

private:
  using Morton_code = std::uint64_t;

  struct Pending
  {
    std::uint32_t node;
    int level; // MORTON_LEVELS: the keys must be computed anew
  };

  void subdivide(Pending pending, std::vector<Pending>& stack)
  {
    Node& node = m_nodes[pending.node];
    node.number_of_children = 0;
    const bool is_root = pending.node == 0;
    if (pending.level == MORTON_LEVELS) {
      const Octree_cube cube = bounding_cube(m_points.begin() + node.begin, m_points.begin() + node.end);
      if (is_root)
        node.cell = cube;
      if (node.end - node.begin <= OCTREE_LEAF_SIZE || !(cube.size > 0.)) {
        return;
      }
      node.cell = cube;
      const Morton_key key(cube);
      for (Point_index i = node.begin; i != node.end; ++i)
        m_keys[i] = key(m_points[i]);
      pending.level = 0;
    }
    if (node.end - node.begin > OCTREE_LEAF_SIZE)
      add_children(pending, stack);
  }

  void add_children(Pending pending, std::vector<Pending>& stack)
  {
    const Point_index begin = m_nodes[pending.node].begin, end = m_nodes[pending.node].end;
    Octree_cube cell = m_nodes[pending.node].cell;
    int level = pending.level;
    // Halve the cell while all points stay together.
    while (level != MORTON_LEVELS &&
           Morton_key::octant(m_keys[begin], level) == Morton_key::octant(m_keys[end - 1], level)) {
      cell = child_cell(cell, Morton_key::octant(m_keys[begin], level));
      ++level;
    }
    m_nodes[pending.node].cell = cell;
    if (level == MORTON_LEVELS) {
      stack.push_back(Pending{ pending.node, level });
      return;
    }
    const std::uint32_t first_child = static_cast<std::uint32_t>(m_nodes.size());
    for (Point_index i = begin; i != end;) {
      const unsigned int octant = Morton_key::octant(m_keys[i], level);
      const Point_index next = static_cast<Point_index>(
        std::partition_point(m_keys.begin() + i, m_keys.begin() + end,
                             [&](Morton_code key) { return Morton_key::octant(key, level) <= octant; }) -
        m_keys.begin());
      Node child{};
      child.cell = child_cell(cell, octant);
      child.begin = i;
      child.end = next;
      child.parent = pending.node;
      m_nodes.push_back(child);
      i = next;
    }
    m_nodes[pending.node].first_child = first_child;
    m_nodes[pending.node].number_of_children = static_cast<std::uint32_t>(m_nodes.size()) - first_child;
    for (std::uint32_t c = first_child; c != m_nodes.size(); ++c)
      stack.push_back(Pending{ c, level + 1 });
  }

  static Octree_cube child_cell(const Octree_cube& cell, unsigned int octant)
  {
    const double half = cell.size / 2;
    return Octree_cube{ { cell.origin[0] + ((octant & 1u) ? half : 0.), cell.origin[1] + ((octant & 2u) ? half : 0.),
                          cell.origin[2] + ((octant & 4u) ? half : 0.) },
                        half };
  }

  // Children follow their parent in the array.
  void compute_boxes()
  {
    for (std::size_t i = m_nodes.size(); i-- != 0;) {
      Node& n = m_nodes[i];
      if (n.number_of_children == 0) {
        for (Point_index j = n.begin; j != n.end; ++j)
          n.box.include(m_points[j]);
        m_leaves.push_back(static_cast<std::uint32_t>(i));
        continue;
      }
      n.box = m_nodes[n.first_child].box;
      for (std::uint32_t c = n.first_child + 1; c != n.first_child + n.number_of_children; ++c)
        n.box.include(m_nodes[c].box);
    }
    std::sort(m_leaves.begin(), m_leaves.end(),
              [&](std::uint32_t a, std::uint32_t b) { return m_nodes[a].begin < m_nodes[b].begin; });
  }

  const std::vector<Local_point>& m_points;
  std::vector<Morton_code> m_keys;
  std::vector<Node> m_nodes;
  std::vector<std::uint32_t> m_leaves;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_POINT_OCTREE_3_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_MORTON_ORDER_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_MORTON_ORDER_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// A cubic cell of an octree over the cloud.
struct Octree_cube
{
  std::array<double, 3> origin;
  double size;
};

// Most points of an octree leaf: the nearest point in each of the eight half-spaces around each of the
// three vertices of a triangle (thesis 3.2.4).
constexpr std::size_t OCTREE_LEAF_SIZE = 24;

// Number of octree levels that one 63-bit Morton key tells apart.
constexpr int MORTON_LEVELS = 21;

// Morton key of a point in a cube: the octant on level 1 in the highest bits.
class Morton_key
{
public:
  explicit Morton_key(const Octree_cube& cube)
    : m_cube(cube), m_scale(double(std::uint32_t(1) << MORTON_LEVELS) / cube.size)
  { }

  std::uint64_t operator()(const Local_point& p) const
  {
    return spread(cell(p.x(), 0)) | (spread(cell(p.y(), 1)) << 1) | (spread(cell(p.z(), 2)) << 2);
  }

  static unsigned int octant(std::uint64_t key, int level)
  {
    return static_cast<unsigned int>(key >> (3 * (MORTON_LEVELS - 1 - level))) & 7u;
  }

private:
  std::uint64_t cell(double coordinate, std::size_t axis) const
  {
    constexpr double last = double((std::uint32_t(1) << MORTON_LEVELS) - 1);
    return static_cast<std::uint64_t>((std::min)(last, (std::max)(0., (coordinate - m_cube.origin[axis]) * m_scale)));
  }

  // Moves bit i to bit 3 i.
  static std::uint64_t spread(std::uint64_t x)
  {
    x = (x | (x << 32)) & 0x001f00000000ffffull;
    x = (x | (x << 16)) & 0x001f0000ff0000ffull;
    x = (x | (x << 8)) & 0x100f00f00f00f00full;
    x = (x | (x << 4)) & 0x10c30c30c30c30c3ull;
    x = (x | (x << 2)) & 0x1249249249249249ull;
    return x;
  }

  Octree_cube m_cube;
  double m_scale;
};

// The smallest cube at the lower corner of the points' bounding box that contains them all.
template <typename PointIterator>
Octree_cube bounding_cube(PointIterator begin, PointIterator end)
{
  std::array<double, 3> low{}, high{};
  bool is_first = true;
  for (PointIterator it = begin; it != end; ++it, is_first = false)
    for (int axis = 0; axis != 3; ++axis) {
      const double c = (*it)[axis];
      const std::size_t a = static_cast<std::size_t>(axis);
      low[a] = is_first ? c : (std::min)(low[a], c);
      high[a] = is_first ? c : (std::max)(high[a], c);
    }
  const double size = (std::max)({ high[0] - low[0], high[1] - low[1], high[2] - low[2] });
  return Octree_cube{ low, size };
}

// Sorts points along the Morton curve. Points that share a key are sorted along the curve of their
// own bounding cube, so that a far outlier or a dense cluster does not spoil the order; runs that
// fit in a leaf and points that cannot be told apart are left to `less`, a strict total order.
template <typename IndexLess>
class Morton_sorter
{
public:
  Morton_sorter(const std::vector<Local_point>& points, const IndexLess& less) : m_points(points), m_less(less) { }

  std::vector<Point_index> operator()() const
  {
    std::vector<Point_index> order(m_points.size());
    for (std::size_t i = 0; i != order.size(); ++i)
      order[i] = static_cast<Point_index>(i);
    std::vector<Keyed_index> keyed(order.size());
    sort(order, keyed, 0, order.size());
    return order;
  }

private:
  struct Keyed_index
  {
    std::uint64_t key;
    Point_index index;
    bool operator<(const Keyed_index& other) const { return key < other.key; }
  };

  struct Key_shift
  {
    std::uint64_t operator()(const Keyed_index& k, unsigned int offset) const { return k.key >> offset; }
  };

  struct Range
  {
    std::size_t begin, end;
  };

  void sort(std::vector<Point_index>& order, std::vector<Keyed_index>& keyed, std::size_t begin, std::size_t end) const
  {
    // An explicit stack: exponentially spaced points nest as deep as the exponent of a double.
    std::vector<Range> stack{ Range{ begin, end } };
    while (!stack.empty()) {
      const Range range = stack.back();
      stack.pop_back();
      if (range.end - range.begin <= OCTREE_LEAF_SIZE || !sort_by_key(order, keyed, range)) {
        std::sort(order.begin() + std::ptrdiff_t(range.begin), order.begin() + std::ptrdiff_t(range.end), m_less);
        continue;
      }
      push_runs_of_equal_keys(keyed, range, stack);
    }
  }

  // False if the points of the range all coincide.
  bool sort_by_key(std::vector<Point_index>& order, std::vector<Keyed_index>& keyed, Range range) const
  {
    const Octree_cube cube = bounding_cube_of(order, range);
    if (!(cube.size > 0.))
      return false;
    const Morton_key key(cube);
    for (std::size_t i = range.begin; i != range.end; ++i)
      keyed[i] = Keyed_index{ key(m_points[order[i]]), order[i] };
    boost::sort::spreadsort::integer_sort(keyed.begin() + std::ptrdiff_t(range.begin),
                                          keyed.begin() + std::ptrdiff_t(range.end), Key_shift());
    for (std::size_t i = range.begin; i != range.end; ++i)
      order[i] = keyed[i].index;
    return true;
  }

  void push_runs_of_equal_keys(const std::vector<Keyed_index>& keyed, Range range, std::vector<Range>& stack) const
  {
    for (std::size_t i = range.begin; i != range.end;) {
      std::size_t j = i + 1;
      while (j != range.end && keyed[j].key == keyed[i].key)
        ++j;
      if (j - i > 1)
        stack.push_back(Range{ i, j });
      i = j;
    }
  }

  Octree_cube bounding_cube_of(const std::vector<Point_index>& order, Range range) const
  {
    struct Iterator
    {
      const std::vector<Local_point>& points;
      const Point_index* it;
      const Local_point& operator*() const { return points[*it]; }
      Iterator& operator++()
      {
        ++it;
        return *this;
      }
      bool operator!=(const Iterator& other) const { return it != other.it; }
    };
    return bounding_cube(Iterator{ m_points, order.data() + range.begin },
                         Iterator{ m_points, order.data() + range.end });
  }

  const std::vector<Local_point>& m_points;
  const IndexLess& m_less;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_MORTON_ORDER_H

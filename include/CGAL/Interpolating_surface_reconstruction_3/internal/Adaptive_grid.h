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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ADAPTIVE_GRID_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ADAPTIVE_GRID_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// An octree whose leaves may have any sizes side by side, and the tetrahedra that they define: the center
// of a leaf, the center of a leaf across a face, and an edge that no smaller leaf divides. They fit
// together without balancing, because the segment between two centers passes through the smaller of their
// faces: if the leaves have the sizes s and t s, t >= 1, it is off the center of that face by at most
// (t - 1) / (t + 1) of s / 2.
class Adaptive_grid
{
public:
  // Coordinates of corners and centers, in units of half the smallest size.
  using Lattice_point = std::array<std::uint32_t, 3>;
  using Coordinates = std::array<double, 3>;

  struct Leaf
  {
    Lattice_point origin;
    std::uint32_t size;
    std::uint32_t node;

    Lattice_point center() const
    {
      return Lattice_point{ { origin[0] + size / 2, origin[1] + size / 2, origin[2] + size / 2 } };
    }
  };

  // Part of a face of a leaf, which no smaller leaf divides. Its boundary may have more than four corners.
  struct Face
  {
    std::size_t axis;                   // of its normal
    Leaf neighbor;                      // across it
    std::vector<Lattice_point> corners; // counterclockwise, seen from the larger coordinates along the axis
  };

  Adaptive_grid(const Coordinates& origin, double size) : m_origin(origin), m_unit(size / ROOT_SIZE), m_children(1, 0)
  { }

  // Divides all leaves that meet a ball until their size is not above a maximum. Returns false if there
  // would be more leaves than allowed.
  bool refine(const Coordinates& center, double radius, double maximum_size, std::size_t maximum_leaves)
  {
    m_stack.assign(1, root());
    while (!m_stack.empty()) {
      const Leaf leaf = m_stack.back();
      m_stack.pop_back();
      if (leaf.size <= SMALLEST_SIZE || leaf.size * m_unit <= maximum_size || !meets_ball(leaf, center, radius))
        continue;
      if (m_children[leaf.node] == 0) {
        if (number_of_leaves() + 7 > maximum_leaves)
          return false;
        m_children[leaf.node] = static_cast<std::uint32_t>(m_children.size());
        m_children.resize(m_children.size() + 8, 0);
      }
      for (unsigned int i = 0; i != 8; ++i)
        m_stack.push_back(child(leaf, i));
    }
    return true;
  }

  std::size_t number_of_nodes() const { return m_children.size(); }
  std::size_t number_of_leaves() const { return m_children.size() - m_children.size() / 8; }

  Coordinates coordinates(const Lattice_point& p) const
  {
    return Coordinates{ { m_origin[0] + p[0] * m_unit, m_origin[1] + p[1] * m_unit, m_origin[2] + p[2] * m_unit } };
  }

  // The leaf that contains a point of the root.
  Leaf locate(const Coordinates& x) const
  {
    Lattice_point p;
    for (std::size_t a = 0; a != 3; ++a) {
      const double c = (x[a] - m_origin[a]) / m_unit;
      p[a] = c > 0. ? static_cast<std::uint32_t>((std::min)(c, double(ROOT_SIZE - 1))) : 0u;
    }
    return descend(p, 0);
  }

  // Calls visit(face) for the parts of the faces of a leaf, but for those on the boundary of the root.
  template <typename Visit>
  void for_each_face(const Leaf& leaf, const Visit& visit) const
  {
    Face face;
    for (face.axis = 0; face.axis != 3; ++face.axis)
      for (bool is_upper : { false, true }) {
        Lattice_point origin = leaf.origin;
        origin[face.axis] += is_upper ? leaf.size : 0u;
        if (origin[face.axis] != 0 && origin[face.axis] != ROOT_SIZE)
          visit_face(origin, leaf.size, is_upper, face, visit);
      }
  }

private:
  static constexpr std::uint32_t ROOT_SIZE = 1u << 30, SMALLEST_SIZE = 2;

  Leaf root() const { return Leaf{ { { 0, 0, 0 } }, ROOT_SIZE, 0 }; }

  // Bit a of the number is the side along axis a.
  Leaf child(const Leaf& parent, unsigned int i) const
  {
    const std::uint32_t half = parent.size / 2;
    return Leaf{ { { parent.origin[0] + (i & 1u) * half, parent.origin[1] + (i >> 1 & 1u) * half,
                     parent.origin[2] + (i >> 2) * half } },
                 half,
                 m_children[parent.node] + i };
  }

  bool meets_ball(const Leaf& leaf, const Coordinates& center, double radius) const
  {
    const Coordinates low = coordinates(leaf.origin);
    double squared = 0.;
    for (std::size_t a = 0; a != 3; ++a) {
      const double d = (std::max)({ low[a] - center[a], center[a] - low[a] - leaf.size * m_unit, 0. });
      squared += d * d;
    }
    return squared <= radius * radius;
  }

  // The node that contains a cube of the smallest size at p and is a leaf or not larger than `size`.
  Leaf descend(const Lattice_point& p, std::uint32_t size) const
  {
    Leaf leaf = root();
    while (m_children[leaf.node] != 0 && leaf.size > size) {
      const std::uint32_t half = leaf.size / 2;
      unsigned int i = 0;
      for (unsigned int a = 0; a != 3; ++a)
        i |= p[a] >= leaf.origin[a] + half ? 1u << a : 0u;
      leaf = child(leaf, i);
    }
    return leaf;
  }

  // A square on a face of a leaf; the neighbors are on the upper or lower side.
  template <typename Visit>
  void visit_face(const Lattice_point& origin, std::uint32_t size, bool is_upper, Face& face, const Visit& visit) const
  {
    Lattice_point beside = origin;
    beside[face.axis] -= is_upper ? 0u : 1u;
    face.neighbor = descend(beside, size);
    const std::size_t u = (face.axis + 1) % 3, v = (face.axis + 2) % 3;
    if (m_children[face.neighbor.node] != 0) {
      for (unsigned int i = 0; i != 4; ++i) {
        Lattice_point part = origin;
        part[u] += (i & 1u) * (size / 2);
        part[v] += (i >> 1) * (size / 2);
        visit_face(part, size / 2, is_upper, face, visit);
      }
      return;
    }
    face.corners.clear();
    Lattice_point p = origin;
    append_side(p, Side{ u, v, face.axis, true, false }, size, face.corners);
    p[u] += size;
    append_side(p, Side{ v, u, face.axis, true, true }, size, face.corners);
    p[v] += size;
    append_side(p, Side{ u, v, face.axis, false, true }, size, face.corners);
    p[u] -= size;
    append_side(p, Side{ v, u, face.axis, false, false }, size, face.corners);
    visit(face);
  }

  // Of a face: the axis along it, and the axis that points away from the face, upward or downward.
  struct Side
  {
    std::size_t along, across, face_axis;
    bool is_increasing, is_upper;
  };

  // Appends the start of a side and the corners of smaller leaves on it.
  void append_side(const Lattice_point& from, const Side& side, std::uint32_t size,
                   std::vector<Lattice_point>& corners) const
  {
    Lattice_point low = from, middle = from;
    low[side.along] -= side.is_increasing ? 0u : size;
    middle[side.along] += side.is_increasing ? size / 2 : 0u - size / 2;
    if (!is_divided(low, side, size)) {
      corners.push_back(from);
      return;
    }
    append_side(from, side, size / 2, corners);
    append_side(middle, side, size / 2, corners);
  }

  // Whether one of the nodes that are as long as a side has children: the two at the face have none.
  bool is_divided(const Lattice_point& low, const Side& side, std::uint32_t size) const
  {
    Lattice_point p = low;
    p[side.across] -= side.is_upper ? 0u : 1u;
    if (p[side.across] >= ROOT_SIZE) // or below 0
      return false;
    if (m_children[descend(p, size).node] != 0)
      return true;
    p[side.face_axis] -= 1;
    return m_children[descend(p, size).node] != 0;
  }

  const Coordinates m_origin;
  const double m_unit;
  std::vector<std::uint32_t> m_children; // the first of eight, or 0
  std::vector<Leaf> m_stack;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ADAPTIVE_GRID_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CLIPPED_POLYGON_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CLIPPED_POLYGON_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Point_star.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// A convex polygon around the origin of a plane, cut by half-planes. Edge i goes from vertex i to
// vertex i + 1 and remembers which half-plane made it. Linear functions are evaluated at a group of vertices at a
// time; past the last vertex, where the group is filled with origins, they are 0.
class Clipped_polygon
{
public:
  // The square with half side `size`, whose edges no neighbor made.
  explicit Clipped_polygon(double size) : m_size(4)
  {
    const double x[4] = { size, size, -size, -size }, y[4] = { -size, size, size, -size };
    for (std::size_t i = 0; i != 4; ++i)
      set(i, Vertex{ x[i], y[i], Point_star::GAP });
    fill_group();
  }

  std::size_t size() const { return m_size; }
  std::uint32_t maker(std::size_t i) const { return m_makers[i]; }
  double x(std::size_t i) const { return m_x[i]; }
  double y(std::size_t i) const { return m_y[i]; }

  // A cell with more edges than this keeps the nearest neighbors' edges.
  static constexpr std::size_t CAPACITY = 64;

  using Values = std::array<double, CAPACITY>;

  // Evaluates a x + b y at the vertices; returns the maximum, which is not negative.
  double evaluate(double a, double b, Values& values) const
  {
    Group largest = Group::Zero();
    for (std::size_t i = 0; i < m_size; i += GROUP_SIZE) {
      const Group group = a * Eigen::Map<const Group>(m_x.data() + i) + b * Eigen::Map<const Group>(m_y.data() + i);
      Eigen::Map<Group>(values.data() + i) = group;
      largest = largest.max(group);
    }
    return largest.maxCoeff();
  }

  double squared_radius() const
  {
    double result = 0.;
    for (std::size_t i = 0; i != m_size; ++i)
      result = (std::max)(result, m_x[i] * m_x[i] + m_y[i] * m_y[i]);
    return result;
  }

  // Cuts off a x + b y > c, where c > 0. Returns whether anything was cut.
  bool clip(double a, double b, double c, std::uint32_t maker)
  {
    Values values;
    std::size_t first_out = CAPACITY;
    double last = a * m_x[m_size - 1] + b * m_y[m_size - 1];
    for (std::size_t i = 0; i != m_size; ++i) {
      values[i] = a * m_x[i] + b * m_y[i];
      if (values[i] > c && !(last > c))
        first_out = i;
      last = values[i];
    }
    if (first_out == CAPACITY || m_size == CAPACITY)
      return false;
    const auto is_out = [&](std::size_t i) { return values[i] > c; };
    std::size_t end_out = next(first_out); // first kept vertex after the ones cut off
    std::size_t removed = 1;
    for (; is_out(end_out); end_out = next(end_out))
      ++removed;
    const std::size_t before = previous(first_out), last_out = previous(end_out);
    Vertex entry = crossing(before, values[before] - c, first_out, values[first_out] - c);
    entry.maker = maker;
    Vertex exit = crossing(end_out, values[end_out] - c, last_out, values[last_out] - c);
    exit.maker = m_makers[last_out];
    replace(first_out, removed, entry, exit);
    return true;
  }

private:
  // Most cells have no more vertices.
  static constexpr std::size_t GROUP_SIZE = 8;
  using Group = Eigen::Array<double, GROUP_SIZE, 1>;

  struct Vertex
  {
    double x, y;
    std::uint32_t maker;
  };

  std::size_t next(std::size_t i) const { return i + 1 == m_size ? 0 : i + 1; }
  std::size_t previous(std::size_t i) const { return i == 0 ? m_size - 1 : i - 1; }

  void set(std::size_t i, const Vertex& v)
  {
    m_x[i] = v.x;
    m_y[i] = v.y;
    m_makers[i] = v.maker;
  }

  void copy(std::size_t from, std::size_t to)
  {
    m_x[to] = m_x[from];
    m_y[to] = m_y[from];
    m_makers[to] = m_makers[from];
  }

  Vertex crossing(std::size_t kept, double kept_value, std::size_t cut, double cut_value) const
  {
    const double t = kept_value / (kept_value - cut_value);
    return Vertex{ m_x[kept] + t * (m_x[cut] - m_x[kept]), m_y[kept] + t * (m_y[cut] - m_y[kept]), 0 };
  }

  // Replaces `removed` vertices from `first` on, cyclically, by two.
  void replace(std::size_t first, std::size_t removed, const Vertex& entry, const Vertex& exit)
  {
    if (first + removed <= m_size) {
      const std::size_t tail = first + removed;
      if (removed == 1)
        for (std::size_t i = m_size; i-- > tail;)
          copy(i, i + 1);
      else if (removed > 2)
        for (std::size_t i = tail; i != m_size; ++i)
          copy(i, i + 2 - removed);
      set(first, entry);
      set(first + 1, exit);
    } else {
      const std::size_t wrapped = first + removed - m_size; // vertices cut off at the beginning
      const std::size_t kept = m_size - removed;
      for (std::size_t i = 0; i != kept; ++i)
        copy(i + wrapped, i);
      set(kept, entry);
      set(kept + 1, exit);
    }
    m_size = m_size + 2 - removed;
    fill_group();
  }

  void fill_group()
  {
    for (std::size_t i = m_size; i % GROUP_SIZE != 0; ++i)
      m_x[i] = m_y[i] = 0.;
  }

  std::array<double, CAPACITY> m_x, m_y;
  std::array<std::uint32_t, CAPACITY> m_makers;
  std::size_t m_size;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CLIPPED_POLYGON_H

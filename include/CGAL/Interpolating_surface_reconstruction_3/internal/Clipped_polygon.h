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

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// A convex polygon around the origin of a plane, cut by half-planes. Edge i goes from vertex i to
// vertex i + 1 and remembers which half-plane made it.
class Clipped_polygon
{
public:
  // The square with half side `size`, whose edges no neighbor made.
  explicit Clipped_polygon(double size) : m_size(4)
  {
    const double x[4] = { size, size, -size, -size }, y[4] = { -size, size, size, -size };
    for (std::size_t i = 0; i != 4; ++i)
      m_vertices[i] = Vertex{ x[i], y[i], Point_star::GAP };
  }

  std::size_t size() const { return m_size; }
  std::uint32_t maker(std::size_t i) const { return m_vertices[i].maker; }

  struct Extreme
  {
    std::size_t vertex;
    double value;
  };

  // The vertex where a x + b y is largest, and that value.
  Extreme extreme(double a, double b) const
  {
    Extreme result{ 0, a * m_vertices[0].x + b * m_vertices[0].y };
    for (std::size_t i = 1; i != m_size; ++i) {
      const double value = a * m_vertices[i].x + b * m_vertices[i].y;
      if (value > result.value)
        result = Extreme{ i, value };
    }
    return result;
  }

  double squared_radius() const
  {
    double result = 0.;
    for (std::size_t i = 0; i != m_size; ++i)
      result = (std::max)(result, m_vertices[i].x * m_vertices[i].x + m_vertices[i].y * m_vertices[i].y);
    return result;
  }

  // Cuts off a x + b y > c, where c > 0. Returns whether anything was cut.
  bool clip(double a, double b, double c, std::uint32_t maker)
  {
    std::size_t first_out = CAPACITY;
    double previous = a * m_vertices[m_size - 1].x + b * m_vertices[m_size - 1].y - c;
    for (std::size_t i = 0; i != m_size; ++i) {
      const double value = a * m_vertices[i].x + b * m_vertices[i].y - c;
      m_values[i] = value;
      if (value > 0. && previous <= 0.)
        first_out = i;
      previous = value;
    }
    if (first_out == CAPACITY || m_size == CAPACITY)
      return false;
    if (m_values[0] > 0. && m_values[m_size - 1] <= 0.)
      first_out = 0;
    std::size_t end_out = first_out; // first kept vertex after the ones cut off
    std::size_t removed = 0;
    while (removed != m_size && m_values[end_out] > 0.) {
      end_out = next(end_out);
      ++removed;
    }
    if (removed == m_size)
      return false;
    const std::size_t before = first_out == 0 ? m_size - 1 : first_out - 1;
    const std::size_t last_out = end_out == 0 ? m_size - 1 : end_out - 1;
    Vertex entry = crossing(before, first_out);
    entry.maker = maker;
    Vertex exit = crossing(end_out, last_out);
    exit.maker = m_vertices[last_out].maker;
    replace(first_out, removed, entry, exit);
    return true;
  }

  // A cell with more edges than this keeps the nearest neighbors' edges.
  static constexpr std::size_t CAPACITY = 64;

private:
  struct Vertex
  {
    double x, y;
    std::uint32_t maker;
  };

  std::size_t next(std::size_t i) const { return i + 1 == m_size ? 0 : i + 1; }

  Vertex crossing(std::size_t kept, std::size_t cut) const
  {
    const Vertex& u = m_vertices[kept];
    const Vertex& v = m_vertices[cut];
    const double t = m_values[kept] / (m_values[kept] - m_values[cut]);
    return Vertex{ u.x + t * (v.x - u.x), u.y + t * (v.y - u.y), 0 };
  }

  // Replaces `removed` vertices from `first` on, cyclically, by two.
  void replace(std::size_t first, std::size_t removed, const Vertex& entry, const Vertex& exit)
  {
    if (first + removed <= m_size) {
      const std::size_t tail = first + removed;
      if (removed == 1)
        for (std::size_t i = m_size; i-- > tail;)
          m_vertices[i + 1] = m_vertices[i];
      else if (removed > 2)
        for (std::size_t i = tail; i != m_size; ++i)
          m_vertices[i + 2 - removed] = m_vertices[i];
      m_vertices[first] = entry;
      m_vertices[first + 1] = exit;
    } else {
      const std::size_t wrapped = first + removed - m_size; // vertices cut off at the beginning
      const std::size_t kept = m_size - removed;
      for (std::size_t i = 0; i != kept; ++i)
        m_vertices[i] = m_vertices[i + wrapped];
      m_vertices[kept] = entry;
      m_vertices[kept + 1] = exit;
    }
    m_size = m_size + 2 - removed;
  }

  std::array<Vertex, CAPACITY + 1> m_vertices;
  std::array<double, CAPACITY + 1> m_values;
  std::size_t m_size;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CLIPPED_POLYGON_H

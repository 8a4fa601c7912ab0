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

#ifndef ISR_FUZZ_PARTS_H
#define ISR_FUZZ_PARTS_H

#include "isr_fuzz_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace isr_fuzz {

// Samples of machine parts, as designed or scanned, well or badly: points on rims, walls and faces, in few planes, exact or
// rounded. Several may share a plane, touch or cross each other.
class Parts
{
public:
  Parts(Byte_stream& in, std::size_t maximum_size)
    : m_in(in), m_maximum_size(maximum_size), m_unit(unit_of_rounding(in.below(4))), m_turn(turn(in.below(4)))
  {
    while (!m_in.is_at_end() && m_points.size() < m_maximum_size)
      switch (m_in.below(4)) {
      case 0:
        add_pipe();
        break;
      case 1:
        add_block();
        break;
      case 2:
        add_face();
        break;
      default:
        add_point();
      }
  }

  const Points& points() const { return m_points; }

private:
  static double unit_of_rounding(std::size_t kind)
  {
    return kind == 0 ? 0. : kind == 1 ? std::ldexp(1., -7) : kind == 2 ? 1e-3 : 1e-5;
  }

  // About the axis through (1, 1, 0); its cosine and sine may be exact.
  struct Turn
  {
    double cosine, sine;
  };

  static Turn turn(std::size_t kind)
  {
    return kind < 2 ? Turn{ 1., 0. } : kind == 2 ? Turn{ .6, .8 } : Turn{ std::cos(1.), std::sin(1.) };
  }

  void add(double x, double y, double z)
  {
    if (m_points.size() == m_maximum_size)
      return;
    const double along = (x + y) / 2., across = (x - y) / 2.;
    const double a = m_turn.cosine * across - m_turn.sine * z, b = m_turn.sine * across + m_turn.cosine * z;
    const auto rounded = [this](double value) { return m_unit == 0. ? value : m_unit * std::round(value / m_unit); };
    m_points.emplace_back(rounded(along + a), rounded(along - a), rounded(b));
  }

  void add_point()
  {
    const double x = m_in.small(), y = m_in.small(), z = m_in.small();
    add(x, y, z);
  }

  // Rings of three to 34 points around a bore, a boss or a cone, one above the other.
  void add_pipe()
  {
    constexpr double PI = 3.14159265358979323846;
    const std::size_t n = 3 + m_in.below(32), rings = 1 + m_in.below(4);
    const double x = m_in.small(), y = m_in.small(), z = m_in.small(), height = m_in.small();
    const double radius = m_in.small(), growth = m_in.small() / 16.;
    for (std::size_t ring = 0; ring != rings; ++ring)
      for (std::size_t k = 0; k != n; ++k) {
        const double angle = 2. * PI * double(k) / double(n), r = radius + growth * double(ring);
        add(x + r * std::cos(angle), y + r * std::sin(angle), z + height * double(ring));
      }
  }

  // The edges of rectangles, one above the other.
  void add_block()
  {
    const std::size_t n = 1 + m_in.below(8), rectangles = 1 + m_in.below(4);
    const double x = m_in.small(), y = m_in.small(), z = m_in.small();
    const double width = m_in.small(), depth = m_in.small(), height = m_in.small();
    for (std::size_t i = 0; i != rectangles; ++i)
      for (std::size_t k = 0; k != n; ++k) {
        const double s = double(k) / double(n), at = z + height * double(i);
        add(x + s * width, y, at);
        add(x + width, y + s * depth, at);
        add(x + (1. - s) * width, y + depth, at);
        add(x, y + (1. - s) * depth, at);
      }
  }

  // A grid in a plane.
  void add_face()
  {
    const std::size_t columns = 1 + m_in.below(8), rows = 1 + m_in.below(8);
    const double x = m_in.small(), y = m_in.small(), z = m_in.small(), step = m_in.small();
    const bool is_upright = m_in.below(2) == 1;
    for (std::size_t i = 0; i != rows; ++i)
      for (std::size_t j = 0; j != columns; ++j)
        add(x + step * double(j), is_upright ? y : y + step * double(i), is_upright ? z + step * double(i) : z);
  }

  Byte_stream& m_in;
  const std::size_t m_maximum_size;
  const double m_unit; // that coordinates are rounded to; none if 0
  const Turn m_turn;
  Points m_points;
};

} // namespace isr_fuzz

#endif // ISR_FUZZ_PARTS_H

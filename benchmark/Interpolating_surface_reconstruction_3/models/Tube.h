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

#ifndef ISR_BENCHMARK_MODELS_TUBE_H
#define ISR_BENCHMARK_MODELS_TUBE_H

#include "Surface.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace isr_benchmark {

// Surface at a constant distance from a closed curve with period 2 pi. The distance must be smaller
// than the reach of the curve: then it is the difference of the distance to the curve.
class Tube : public Surface
{
public:
  // The curve and its first two derivatives.
  using Curve = std::function<std::array<Vector, 3>(double)>;

  Tube(Curve curve, double radius) : m_curve(std::move(curve)), m_radius(radius)
  {
    for (std::size_t i = 0; i != TABLE_SIZE; ++i) {
      const auto jet = m_curve(parameter(i));
      m_table.push_back(CGAL::ORIGIN + jet[0]);
      const double speed = std::sqrt(jet[1].squared_length());
      m_length += speed * 2. * CGAL_PI / double(TABLE_SIZE);
      m_maximum_speed = (std::max)(m_maximum_speed, speed);
    }
    m_maximum_speed *= 1.05; // between the entries of the table
  }

  double distance(const Point& p) const override
  {
    std::size_t nearest = 0;
    for (std::size_t i = 0; i != TABLE_SIZE; ++i)
      if (CGAL::squared_distance(p, m_table[i]) < CGAL::squared_distance(p, m_table[nearest]))
        nearest = i;
    double t = parameter(nearest);
    for (int step = 0; step != 30; ++step) {
      const auto jet = m_curve(t);
      const Vector v = CGAL::ORIGIN + jet[0] - p;
      const double slope = v * jet[1], curvature = jet[1].squared_length() + v * jet[2];
      if (!(curvature > 0.) || std::abs(slope) <= 1e-15 * curvature)
        break;
      t -= slope / curvature;
    }
    return std::abs(std::sqrt(CGAL::squared_distance(p, CGAL::ORIGIN + m_curve(t)[0])) - m_radius);
  }

  // A random place along the curve and a random direction around it, accepted with a probability in
  // proportion to the element of area there, (1 - curvature towards the direction) |C'|.
  std::vector<Point> random_points(std::size_t n, CGAL::Random& random) const override
  {
    std::vector<Point> points;
    while (points.size() != n) {
      const auto jet = m_curve(random.get_double(0., 2. * CGAL_PI));
      const double speed = std::sqrt(jet[1].squared_length());
      const Vector tangent = jet[1] / speed;
      const Vector helper = std::abs(tangent.x()) < 0.7 ? Vector(1, 0, 0) : Vector(0, 1, 0);
      Vector a = CGAL::cross_product(tangent, helper);
      a = a / std::sqrt(a.squared_length());
      const Vector b = CGAL::cross_product(tangent, a);
      const double angle = random.get_double(0., 2. * CGAL_PI);
      const Vector normal = std::cos(angle) * a + std::sin(angle) * b;
      const double element = speed * (1. - m_radius * (jet[2] * normal) / (speed * speed));
      if (random.get_double(0., 2. * m_maximum_speed) < element)
        points.push_back(CGAL::ORIGIN + jet[0] + m_radius * normal);
    }
    return points;
  }

  double area() const override { return 2. * CGAL_PI * m_radius * m_length; }
  long euler_characteristic() const override { return 0; }

private:
  static constexpr std::size_t TABLE_SIZE = 512;
  static double parameter(std::size_t i) { return 2. * CGAL_PI * double(i) / double(TABLE_SIZE); }

  Curve m_curve;
  double m_radius;
  std::vector<Point> m_table;
  double m_length = 0., m_maximum_speed = 0.;
};

// The trefoil, a torus knot that winds twice one way and three times the other.
inline std::array<Vector, 3> trefoil(double t)
{
  const double c2 = std::cos(2 * t), s2 = std::sin(2 * t), c3 = std::cos(3 * t), s3 = std::sin(3 * t);
  return { Vector((2 + c3) * c2, (2 + c3) * s2, s3),
           Vector(-3 * s3 * c2 - 2 * (2 + c3) * s2, -3 * s3 * s2 + 2 * (2 + c3) * c2, 3 * c3),
           Vector(-9 * c3 * c2 + 12 * s3 * s2 - 4 * (2 + c3) * c2, -9 * c3 * s2 - 12 * s3 * c2 - 4 * (2 + c3) * s2,
                  -9 * s3) };
}

// The figure-eight knot: a loop that passes near itself four times.
inline std::array<Vector, 3> figure_eight_knot(double t)
{
  const double c2 = std::cos(2 * t), s2 = std::sin(2 * t), c3 = std::cos(3 * t), s3 = std::sin(3 * t);
  return { Vector((2 + c2) * c3, (2 + c2) * s3, std::sin(4 * t)),
           Vector(-2 * s2 * c3 - 3 * (2 + c2) * s3, -2 * s2 * s3 + 3 * (2 + c2) * c3, 4 * std::cos(4 * t)),
           Vector(-4 * c2 * c3 + 12 * s2 * s3 - 9 * (2 + c2) * c3, -4 * c2 * s3 - 12 * s2 * c3 - 9 * (2 + c2) * s3,
                  -16 * std::sin(4 * t)) };
}

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MODELS_TUBE_H

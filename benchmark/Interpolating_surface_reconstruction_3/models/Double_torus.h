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

#ifndef ISR_BENCHMARK_MODELS_DOUBLE_TORUS_H
#define ISR_BENCHMARK_MODELS_DOUBLE_TORUS_H

#include "Surface.h"

#include <CGAL/number_utils.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/point_generators_3.h>
#include <CGAL/Search_traits_3.h>

#include <Eigen/Dense>

#include <cmath>

namespace isr_benchmark {

// The surface (x^2 (1 - x^2) - y^2)^2 + z^2 = 0.01 of genus 2.
class Double_torus : public Surface
{
public:
  Double_torus()
  {
    CGAL::Random random(0);
    const std::size_t lines = 100000;
    std::vector<Point> found;
    for (std::size_t i = 0; i != lines; ++i)
      intersect_random_line(random, found);
    m_area = 2. * CGAL_PI * RADIUS * RADIUS * double(found.size()) / double(lines); // Cauchy, Crofton
    m_nearby.insert(found.begin(), found.end());
    m_nearby.build();
  }

  // Newton's method for the foot of the perpendicular, x - p + lambda grad f(x) = 0 and f(x) = 0,
  // from a near point of the surface.
  double distance(const Point& p) const override
  {
    const Search search(m_nearby, p, 1);
    const Point q = search.begin()->first;
    const Eigen::Vector3d target(p.x(), p.y(), p.z());
    Eigen::Vector3d x(q.x(), q.y(), q.z());
    const Jet start = jet(x);
    double lambda = (target - x).dot(start.gradient) / start.gradient.squaredNorm();
    for (int step = 0; step != 50; ++step) {
      const Jet f = jet(x);
      Eigen::Matrix4d system = Eigen::Matrix4d::Zero();
      system.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity() + lambda * f.hessian;
      system.topRightCorner<3, 1>() = f.gradient;
      system.bottomLeftCorner<1, 3>() = f.gradient.transpose();
      Eigen::Vector4d rest;
      rest << x - target + lambda * f.gradient, f.value;
      const Eigen::Vector4d change = system.fullPivLu().solve(rest);
      x -= change.head<3>();
      lambda -= change[3];
      if (change.head<3>().norm() < 1e-15)
        break;
    }
    const double from_newton = (x - target).norm(), from_sample = std::sqrt(search.begin()->second);
    // a foot farther than a known point of the surface is not the nearest
    return std::isfinite(from_newton) && from_newton < from_sample ? from_newton : from_sample;
  }

  std::vector<Point> random_points(std::size_t n, CGAL::Random& random) const override
  {
    std::vector<Point> points;
    while (points.size() < n)
      intersect_random_line(random, points);
    points.resize(n);
    return points;
  }

  double area() const override { return m_area; }
  long euler_characteristic() const override { return -2; }

private:
  using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel> >;

  struct Jet
  {
    double value;
    Eigen::Vector3d gradient;
    Eigen::Matrix3d hessian;
  };

  static double value(double x, double y, double z)
  {
    const double g = x * x * (1. - x * x) - y * y;
    return g * g + z * z - 0.01;
  }

  static Jet jet(const Eigen::Vector3d& p)
  {
    const double x = p[0], y = p[1], z = p[2];
    const double g = x * x * (1. - x * x) - y * y, gx = 2. * x - 4. * x * x * x, gy = -2. * y;
    Jet result;
    result.value = g * g + z * z - 0.01;
    result.gradient = Eigen::Vector3d(2. * g * gx, 2. * g * gy, 2. * z);
    result.hessian << 2. * (gx * gx + g * (2. - 12. * x * x)), 2. * gx * gy, 0., 2. * gx * gy, 2. * (gy * gy - 2. * g),
      0., 0., 0., 2.;
    return result;
  }

  // Isotropic random lines meet equal areas equally often.
  static void intersect_random_line(CGAL::Random& random, std::vector<Point>& found)
  {
    CGAL::Random_points_on_sphere_3<Point> sphere(1., random);
    const Vector direction = *sphere - CGAL::ORIGIN;
    const Vector helper = std::abs(direction.x()) < 0.7 ? Vector(1, 0, 0) : Vector(0, 1, 0);
    Vector a = CGAL::cross_product(direction, helper);
    a = a / std::sqrt(a.squared_length());
    const Vector b = CGAL::cross_product(direction, a);
    const double r = RADIUS * std::sqrt(random.get_double()), angle = random.get_double(0., 2. * CGAL_PI);
    const Point origin = CGAL::ORIGIN + r * (std::cos(angle) * a + std::sin(angle) * b);
    const auto f = [&](double t) {
      const Point p = origin + t * direction;
      return value(p.x(), p.y(), p.z());
    };
    double t = -RADIUS, before = f(t);
    while (t < RADIUS) {
      const double next = t + STEP, after = f(next);
      if ((before < 0.) != (after < 0.))
        found.push_back(origin + root(f, t, next) * direction);
      t = next;
      before = after;
    }
  }

  template <typename Function>
  static double root(const Function& f, double low, double high)
  {
    const bool low_is_negative = f(low) < 0.;
    for (int step = 0; step != 60; ++step) {
      const double middle = 0.5 * (low + high);
      ((f(middle) < 0.) == low_is_negative ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  static constexpr double RADIUS = 1.25; // of a ball that contains the surface
  static constexpr double STEP = 0.01;

  double m_area = 0.;
  Search::Tree m_nearby;
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MODELS_DOUBLE_TORUS_H

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

#ifndef ISR_BENCHMARK_MEASURES_PICTURE_H
#define ISR_BENCHMARK_MEASURES_PICTURE_H

#include "../models/model_files.h"

#include <CGAL/bounding_box.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace isr_benchmark {

// An orthographic view that depends on the points of the model alone, so that all surfaces of a model
// are seen from the same place: y points up, and the widest sides face the camera.
class Camera
{
public:
  explicit Camera(const std::vector<Point>& points)
  {
    const auto box = CGAL::bounding_box(points.begin(), points.end());
    const Vector size = (box.max)() - (box.min)();
    const double azimuth = (size.z() <= size.x() ? 0.5 : 0.) * CGAL_PI - CGAL_PI / 6.;
    const double elevation = (size.y() < 0.6 * (std::min)(size.x(), size.z()) ? 55. : 15.) * CGAL_PI / 180.;
    m_to_eye =
      Vector(std::cos(azimuth) * std::cos(elevation), std::sin(elevation), std::sin(azimuth) * std::cos(elevation));
    m_right = CGAL::cross_product(Vector(0, 1, 0), m_to_eye);
    m_right = m_right / std::sqrt(m_right.squared_length());
    m_up = CGAL::cross_product(m_to_eye, m_right);
    fit(points);
  }

  // Coordinates in the image, from -1 to 1, and the height above the image plane.
  std::array<double, 3> operator()(const Point& p) const
  {
    const Vector v = p - m_center;
    return { v * m_right / m_scale, v * m_up / m_scale, v * m_to_eye / m_scale };
  }

private:
  void fit(const std::vector<Point>& points)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 4> limits = { infinity, -infinity, infinity, -infinity };
    for (const Point& p : points) {
      const double x = (p - points.front()) * m_right, y = (p - points.front()) * m_up;
      limits = { (std::min)(limits[0], x), (std::max)(limits[1], x), (std::min)(limits[2], y),
                 (std::max)(limits[3], y) };
    }
    m_center = points.front() + 0.5 * (limits[0] + limits[1]) * m_right + 0.5 * (limits[2] + limits[3]) * m_up;
    m_scale = (std::max)({ limits[1] - limits[0], limits[3] - limits[2], 1e-300 }) * 0.53; // and a margin
  }

  Vector m_to_eye, m_right, m_up;
  Point m_center;
  double m_scale = 1.;
};

using Color = std::array<double, 3>;

// Gray without error, over yellow to red at the largest error of the scale; the square root spreads small errors.
inline Color error_color(double relative_error)
{
  const double t = std::sqrt((std::min)((std::max)(relative_error, 0.), 1.));
  const Color gray = { .84, .85, .87 }, yellow = { .98, .78, .16 }, red = { .78, .07, .10 };
  const Color& from = t < 0.5 ? gray : yellow;
  const Color& to = t < 0.5 ? yellow : red;
  const double s = t < 0.5 ? 2. * t : 2. * t - 1.;
  return { from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1]), from[2] + s * (to[2] - from[2]) };
}

// Draws meshes and points with a depth buffer, without any display.
class Picture
{
public:
  Picture(const Camera& camera, std::size_t pixels)
    : m_camera(camera), m_pixels(pixels), m_size(OVERSAMPLING * pixels),
      m_depth(m_size * m_size, -std::numeric_limits<double>::infinity()), m_colors(m_size * m_size, Color{ 1., 1., 1. })
  { }

  // Colors are one a triangle. The side of triangles that is seen less is blue: behind holes, the inside.
  void draw_mesh(const std::vector<Point>& points, const std::vector<Triangle>& triangles,
                 const std::vector<Color>& colors)
  {
    std::vector<std::size_t> visible(m_size * m_size, triangles.size());
    for (std::size_t t = 0; t != triangles.size(); ++t)
      cover(points, triangles[t], [&](std::size_t pixel) { visible[pixel] = t; });
    std::vector<double> facing(triangles.size());
    for (std::size_t t = 0; t != triangles.size(); ++t)
      facing[t] = cosine(points, triangles[t]);
    double balance = 0.;
    for (std::size_t t : visible)
      balance += t == triangles.size() ? 0. : facing[t] > 0. ? 1. : -1.;
    for (std::size_t i = 0; i != visible.size(); ++i)
      if (visible[i] != triangles.size()) {
        const double side = balance < 0. ? -facing[visible[i]] : facing[visible[i]];
        m_colors[i] = shaded(side < 0. ? Color{ .25, .38, .62 } : colors[visible[i]], std::abs(side));
      }
  }

  void draw_points(const std::vector<Point>& points)
  {
    for (const Point& p : points) {
      const auto c = m_camera(p);
      for (int dx = -1; dx != OVERSAMPLING; ++dx)
        for (int dy = -1; dy != OVERSAMPLING; ++dy)
          plot(pixel(c[0]) + dx, pixel(-c[1]) + dy, c[2], Color{ .25, .27, .32 });
    }
  }

  void write(const std::string& file) const
  {
    std::ofstream out(file, std::ios::binary);
    out << "P6\n" << m_pixels << ' ' << m_pixels << "\n255\n";
    for (std::size_t y = 0; y != m_pixels; ++y)
      for (std::size_t x = 0; x != m_pixels; ++x)
        for (std::size_t channel = 0; channel != 3; ++channel) {
          double sum = 0.;
          for (std::size_t dy = 0; dy != OVERSAMPLING; ++dy)
            for (std::size_t dx = 0; dx != OVERSAMPLING; ++dx)
              sum += m_colors[(OVERSAMPLING * y + dy) * m_size + OVERSAMPLING * x + dx][channel];
          out.put(static_cast<char>(
            static_cast<unsigned char>(std::lround(255. * sum / double(OVERSAMPLING * OVERSAMPLING)))));
        }
    if (!out)
      throw std::runtime_error(file + ": cannot be written");
  }

private:
  static constexpr int OVERSAMPLING = 2;

  double to_pixels(double x) const { return 0.5 * (x + 1.) * double(m_size); }
  long pixel(double x) const { return static_cast<long>(std::floor(to_pixels(x))); }

  static Color shaded(const Color& color, double cosine)
  {
    const double light = 0.25 + 0.75 * cosine;
    return { color[0] * light, color[1] * light, color[2] * light };
  }

  void plot(long x, long y, double depth, const Color& color)
  {
    const long size = static_cast<long>(m_size);
    if (x < 0 || y < 0 || x >= size || y >= size)
      return;
    const std::size_t i = static_cast<std::size_t>(y * size + x);
    if (depth > m_depth[i]) {
      m_depth[i] = depth;
      m_colors[i] = color;
    }
  }

  // Between the normal of a triangle and the direction to the eye.
  double cosine(const std::vector<Point>& points, const Triangle& t) const
  {
    const auto a = m_camera(points[t[0]]), b = m_camera(points[t[1]]), c = m_camera(points[t[2]]);
    const Vector n =
      CGAL::cross_product(Vector(b[0] - a[0], b[1] - a[1], b[2] - a[2]), Vector(c[0] - a[0], c[1] - a[1], c[2] - a[2]));
    const double length = std::sqrt(n.squared_length());
    return length > 0. ? n.z() / length : 0.;
  }

  // Calls `visit` for the pixels where the triangle is in front of everything before.
  template <typename Visit>
  void cover(const std::vector<Point>& points, const Triangle& triangle, Visit visit)
  {
    std::array<std::array<double, 3>, 3> p;
    for (std::size_t i = 0; i != 3; ++i) {
      const auto c = m_camera(points[triangle[i]]);
      p[i] = { to_pixels(c[0]), to_pixels(-c[1]), c[2] };
    }
    const double area = cross(p[0], p[1], p[2]);
    if (area == 0. || !std::isfinite(area))
      return;
    const auto range = [&](std::size_t axis) {
      const auto limits = std::minmax({ p[0][axis], p[1][axis], p[2][axis] });
      const double last = double(m_size) - 1.;
      return std::pair<long, long>(std::lround(std::ceil((std::max)(limits.first - 0.5, 0.))),
                                   std::lround(std::floor((std::min)(limits.second - 0.5, last))));
    };
    const auto columns = range(0), rows = range(1);
    // Of two triangles on each other, the one that faces the eye is seen.
    const double tolerance = area < 0. ? -1e-7 : 1e-7; // y points down in the image
    for (long y = rows.first; y <= rows.second; ++y)
      for (long x = columns.first; x <= columns.second; ++x) {
        const std::array<double, 3> q = { double(x) + 0.5, double(y) + 0.5, 0. };
        const double u = cross(q, p[1], p[2]) / area, v = cross(p[0], q, p[2]) / area, w = 1. - u - v;
        if (u < 0. || v < 0. || w < 0.)
          continue;
        const double depth = u * p[0][2] + v * p[1][2] + w * p[2][2];
        const std::size_t i = static_cast<std::size_t>(y) * m_size + static_cast<std::size_t>(x);
        if (depth > m_depth[i] + tolerance) {
          m_depth[i] = depth;
          visit(i);
        }
      }
  }

  static double cross(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  Camera m_camera;
  std::size_t m_pixels, m_size;
  std::vector<double> m_depth;
  std::vector<Color> m_colors;
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MEASURES_PICTURE_H

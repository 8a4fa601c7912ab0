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

#ifndef ISR_BENCHMARK_MODELS_SPHERE_H
#define ISR_BENCHMARK_MODELS_SPHERE_H

#include "Surface.h"

#include <CGAL/number_utils.h>
#include <CGAL/point_generators_3.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace isr_benchmark {

class Sphere : public Surface
{
public:
  double distance(const Point& p) const override
  {
    return std::abs(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1.);
  }

  std::vector<Point> random_points(std::size_t n, CGAL::Random& random) const override
  {
    std::vector<Point> points;
    CGAL::Random_points_on_sphere_3<Point> generator(1., random);
    std::copy_n(generator, n, std::back_inserter(points));
    return points;
  }

  double area() const override { return 4. * CGAL_PI; }
  long euler_characteristic() const override { return 2; }
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MODELS_SPHERE_H

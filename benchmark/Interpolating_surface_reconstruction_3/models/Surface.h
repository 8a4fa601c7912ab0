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

#ifndef ISR_BENCHMARK_MODELS_SURFACE_H
#define ISR_BENCHMARK_MODELS_SURFACE_H

#include "model_files.h"

#include <CGAL/Random.h>

#include <cstddef>
#include <vector>

namespace isr_benchmark {

// A closed surface that is known exactly.
class Surface
{
public:
  virtual ~Surface() = default;

  // Distance of a point near the surface to it, exact up to rounding.
  virtual double distance(const Point& p) const = 0;

  // n points of the surface, independent and uniform by area.
  virtual std::vector<Point> random_points(std::size_t n, CGAL::Random& random) const = 0;

  virtual double area() const = 0;

  virtual std::size_t components() const { return 1; }
  virtual long euler_characteristic() const = 0;

  // Points that a sample of this spacing has on sharp edges.
  virtual std::vector<Point> feature_points(double /* spacing */) const { return {}; }
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MODELS_SURFACE_H

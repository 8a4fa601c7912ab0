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

#ifndef ISR_BENCHMARK_MODELS_NOISE_H
#define ISR_BENCHMARK_MODELS_NOISE_H

#include "model_files.h"

#include <CGAL/Random.h>

#include <cmath>
#include <cstddef>

namespace isr_benchmark {

// Of the edges of the triangles, each counted in each of its triangles.
inline double mean_edge_length(const Model& model)
{
  double sum = 0.;
  for (const Triangle& t : model.triangles)
    for (std::size_t i = 0; i != 3; ++i)
      sum += std::sqrt(CGAL::squared_distance(model.points[t[i]], model.points[t[(i + 1) % 3]]));
  return model.triangles.empty() ? 0. : sum / (3. * static_cast<double>(model.triangles.size()));
}

// Moves the points of a model with triangles, each coordinate by up to `share` of the mean length of an edge, equally
// likely. Normals stay as they are.
inline void add_noise(Model& model, double share, unsigned int seed)
{
  CGAL::Random random(seed);
  const double most = share * mean_edge_length(model);
  if (most == 0.)
    return;
  const auto coordinate = [&] { return random.get_double(-most, most); };
  for (Point& p : model.points) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    p = p + Vector(x, y, z);
  }
}

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MODELS_NOISE_H

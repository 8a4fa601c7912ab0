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

#ifndef ISR_BENCHMARK_MODELS_ORIENTED_POINTS_H
#define ISR_BENCHMARK_MODELS_ORIENTED_POINTS_H

#include "model_files.h"

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace isr_benchmark {

using Oriented_point = std::pair<Point, Vector>;
using Oriented_point_map = CGAL::First_of_pair_property_map<Oriented_point>;
using Oriented_normal_map = CGAL::Second_of_pair_property_map<Oriented_point>;

// The points with their normals, which are zero if the model has none.
inline std::vector<Oriented_point> oriented_points(const Model& model)
{
  std::vector<Oriented_point> points;
  points.reserve(model.points.size());
  for (std::size_t i = 0; i != model.points.size(); ++i)
    points.emplace_back(model.points[i], model.normals.empty() ? Vector(0, 0, 0) : model.normals[i]);
  return points;
}

// The maps of oriented points as named parameters.
inline auto oriented_point_parameters()
{
  return CGAL::parameters::point_map(Oriented_point_map()).normal_map(Oriented_normal_map());
}

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MODELS_ORIENTED_POINTS_H

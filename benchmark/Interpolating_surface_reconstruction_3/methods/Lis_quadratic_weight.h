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

#ifndef ISR_BENCHMARK_METHODS_LIS_QUADRATIC_WEIGHT_H
#define ISR_BENCHMARK_METHODS_LIS_QUADRATIC_WEIGHT_H

#include "../models/oriented_points.h"
#include "Method.h"

#include <CGAL/Interpolating_surface_reconstruction_3/Linear_implicit_function_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/linear_implicit_isosurface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/linear_implicit_weights.h>

#include <cstddef>
#include <string>

namespace isr_benchmark {

class Lis_quadratic_weight : public Method
{
public:
  std::string key() const override { return "lis-thesis"; }
  std::string title() const override { return "LIS, thesis's weights"; }
  std::string description() const override
  {
    return "Linear_implicit_function_3 with Quadratic_weight (Eq. 5.5) and "
           "linear_implicit_isosurface() with its default step, the smallest radius of a star "
           "(5.3.5); its vertices are no samples; more than " +
           std::to_string(MAXIMUM_NUMBER_OF_CUBES) + " cubes are an error; normals as for LIS";
  }

  Reconstruction operator()(const Model& model, std::size_t) const override
  {
    using CGAL::Interpolating_surface_reconstruction_3::linear_implicit_isosurface;
    Reconstruction result;
    const Function function =
      model.normals.empty() ? Function(model.points) : Function(oriented_points(model), oriented_point_parameters());
    linear_implicit_isosurface(function, result.vertices, result.triangles, 0., MAXIMUM_NUMBER_OF_CUBES);
    return result;
  }

private:
  using Function = CGAL::Interpolating_surface_reconstruction_3::Linear_implicit_function_3<
    Kernel, CGAL::Interpolating_surface_reconstruction_3::Quadratic_weight>;

  // About four times as many as the largest mesh of Table 5.1 had. Two samples close together make the
  // step so small that millions would be needed, and measuring their triangles takes minutes.
  static constexpr std::size_t MAXIMUM_NUMBER_OF_CUBES = 400000;
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_METHODS_LIS_QUADRATIC_WEIGHT_H

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

#ifndef ISR_BENCHMARK_METHODS_POWER_CRUST_H
#define ISR_BENCHMARK_METHODS_POWER_CRUST_H

#include "Method.h"
#include "power_crust/Pole_labelling.h"
#include "power_crust/poles.h"
#include "power_crust/power_diagram.h"

namespace isr_benchmark {

class Power_crust : public Method
{
public:
  std::string key() const override { return "power-crust"; }
  std::string title() const override { return "Power crust"; }
  std::string description() const override
  {
    return "own implementation on CGAL's Delaunay and regular triangulations after Amenta, Choi and Kolluri 2001: "
           "poles, power diagram of the polar balls, labels by the deepest known intersections first, faces between "
           "inside and outside cells, cut into triangles; no removal of poles, no simplification";
  }

  Reconstruction operator()(const Model& model, std::size_t) const override
  {
    const power_crust::Poles poles = power_crust::find_poles(model.points);
    const power_crust::Power_diagram diagram(poles.balls);
    const std::vector<char> is_inside = power_crust::Pole_labelling(model.points, poles, diagram)();
    Reconstruction result;
    diagram.faces_between(is_inside, result.vertices, result.triangles);
    return result;
  }
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_METHODS_POWER_CRUST_H

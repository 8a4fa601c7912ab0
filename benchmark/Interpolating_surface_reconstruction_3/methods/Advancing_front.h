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

#ifndef ISR_BENCHMARK_METHODS_ADVANCING_FRONT_H
#define ISR_BENCHMARK_METHODS_ADVANCING_FRONT_H

#include "Method.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Random.h>

#include <iterator>

namespace isr_benchmark {

class Advancing_front : public Method
{
public:
  std::string key() const override { return "af"; }
  std::string title() const override { return "Advancing front"; }
  std::string description() const override
  {
    return "CGAL::advancing_front_surface_reconstruction() with its defaults (Cohen-Steiner and Da 2004)";
  }

  Reconstruction operator()(const Model& model, std::size_t) const override
  {
    // The Delaunay triangulation inserts in an order drawn from the process-wide generator, on which
    // the result depends; the seed makes every run equal to the first one of a process.
    CGAL::get_default_random() = CGAL::Random(0);
    Reconstruction result;
    CGAL::advancing_front_surface_reconstruction(model.points.begin(), model.points.end(),
                                                 std::back_inserter(result.triangles));
    return result;
  }
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_METHODS_ADVANCING_FRONT_H

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

#ifndef ISR_BENCHMARK_MODELS_GENERATED_MODELS_H
#define ISR_BENCHMARK_MODELS_GENERATED_MODELS_H

#include "model_files.h"
#include "Surface.h"

#include <memory>
#include <string>

namespace isr_benchmark {

// A model and, if it is generated, the surface that it samples.
struct Surface_model
{
  Model model;
  std::unique_ptr<Surface> surface;
  unsigned int seed = 0;
};

// The description is SHAPE:POINTS:SEED.
Surface_model generate_model(const std::string& description);

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MODELS_GENERATED_MODELS_H

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

#ifndef ISR_BENCHMARK_MEASURE_MESH_H
#define ISR_BENCHMARK_MEASURE_MESH_H

#include "models/generated_models.h"

#include <cstddef>
#include <iosfwd>
#include <string>

namespace isr_benchmark {

struct Measure_options
{
  std::string mesh_file;    // none: the mesh that came with the model
  std::string picture_file; // none: no picture
  std::size_t pixels = 320;
  std::size_t intersection_limit = 1000000; // triangles
};

// Writes the measures of a mesh as lines of "key<TAB>value".
void measure_mesh(const Surface_model& model, const Measure_options& options, std::ostream& out);

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MEASURE_MESH_H

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

#ifndef ISR_BENCHMARK_RUN_METHOD_H
#define ISR_BENCHMARK_RUN_METHOD_H

#include "models/model_files.h"

#include <cstddef>
#include <iosfwd>
#include <string>

namespace isr_benchmark {

struct Run_options
{
  std::string method;
  std::size_t threads = 1;
  std::size_t runs = 1;
  double budget = 0.; // seconds after which no other run begins
  std::string mesh_file;
};

// Runs a method, in turn with the advancing front, and writes the mesh and lines of "key<TAB>value";
// of lines with the same key, the last one is right.
void run_method(const Model& model, const Run_options& options, std::ostream& out);

// Writes a line a method: key, title, whether it is ours, whether it uses threads, description.
void list_methods(std::ostream& out);

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_RUN_METHOD_H

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

// One job of the benchmark in a process of its own: run a method, or measure its mesh. run_tables.sh
// is the command that runs all jobs and makes the report.

#include "measure_mesh.h"
#include "models/generated_models.h"
#include "models/model_files.h"
#include "run_method.h"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace isr_benchmark;

const char* const usage =
  "usage: isr_tables methods\n"
  "       isr_tables run MODEL METHOD THREADS RUNS BUDGET MESH\n"
  "       isr_tables measure MODEL MESH PICTURE PIXELS\n"
  "\n"
  "MODEL is a file (.ply, .off, .xyz) or SHAPE:POINTS:SEED with a shape of sphere, knot, loop,\n"
  "doubletorus, boxes, plates, wedge. MESH is written by run and read by measure; '-' is the mesh of\n"
  "the model itself. Results are lines of a key, a tabulator and a value.\n";

Surface_model find_model(const std::string& description)
{
  if (!std::filesystem::exists(description) && description.find(':') != std::string::npos)
    return generate_model(description);
  Surface_model result;
  result.model = read_model(description);
  return result;
}

void run(const std::vector<std::string>& words)
{
  const Surface_model model = find_model(words.at(1));
  Run_options options;
  options.method = words.at(2);
  options.threads = std::stoul(words.at(3));
  options.runs = std::stoul(words.at(4));
  options.budget = std::stod(words.at(5));
  options.mesh_file = words.at(6);
  run_method(model.model, options, std::cout);
}

void measure(const std::vector<std::string>& words)
{
  const Surface_model model = find_model(words.at(1));
  Measure_options options;
  options.mesh_file = words.at(2) == "-" ? "" : words.at(2);
  options.picture_file = words.at(3) == "-" ? "" : words.at(3);
  options.pixels = std::stoul(words.at(4));
  measure_mesh(model, options, std::cout);
}

int main(int argc, char** argv)
{
  std::cout.precision(10);
  const std::vector<std::string> words(argv + 1, argv + argc);
  const std::string command = words.empty() ? "" : words.front();
  try {
    if (command == "methods" && words.size() == 1)
      list_methods(std::cout);
    else if (command == "run" && words.size() == 7)
      run(words);
    else if (command == "measure" && words.size() == 5)
      measure(words);
    else {
      std::cerr << usage;
      return EXIT_FAILURE;
    }
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

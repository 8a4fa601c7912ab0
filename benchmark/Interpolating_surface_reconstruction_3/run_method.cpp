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

#include "run_method.h"

#include "measures/peak_memory.h"
#include "methods/Method.h"

#include <CGAL/IO/PLY.h>
#include <CGAL/Random.h>
#include <CGAL/Real_timer.h>

#include <ostream>
#include <stdexcept>
#include <vector>

namespace isr_benchmark {

namespace {

const char* const BASELINE = "af";

double timed(const Method& method, const Model& model, std::size_t threads, Reconstruction& result)
{
  // CGAL's generator starts differently in every process, and surface meshers draw from it.
  CGAL::get_default_random() = CGAL::Random(0);
  CGAL::Real_timer timer;
  timer.start();
  result = method(model, threads);
  return timer.time();
}

void write_seconds(const char* key, const std::vector<double>& seconds, std::ostream& out)
{
  out << key << '\t';
  for (std::size_t i = 0; i != seconds.size(); ++i)
    out << (i == 0 ? "" : " ") << seconds[i];
  out << '\n';
}

} // namespace

void run_method(const Model& model, const Run_options& options, std::ostream& out)
{
  const Method& method = method_of_key(options.method);
  Reconstruction result, other;
  // The first run is alone in the process, so that its peak is the peak.
  const Peak_memory memory;
  std::vector<double> seconds = { timed(method, model, options.threads, result) }, baseline;
  out << "growth_bytes\t" << memory.growth_in_bytes() << '\n'
      << "peak_bytes\t" << memory.peak() << '\n'
      << "normal_seconds\t" << result.normal_seconds << '\n'
      << "points\t" << model.points.size() << '\n';
  if (!CGAL::IO::write_PLY(options.mesh_file, result.vertices.empty() ? model.points : result.vertices,
                           result.triangles, CGAL::parameters::use_binary_mode(true)))
    throw std::runtime_error(options.mesh_file + ": cannot be written");
  // What is known now counts, should later runs take too long.
  write_seconds("seconds", seconds, out);
  write_seconds("baseline_seconds", baseline, out);
  out << std::flush;

  CGAL::Real_timer elapsed;
  elapsed.start();
  if (options.method != BASELINE) {
    baseline.push_back(timed(method_of_key(BASELINE), model, 1, other));
    while (seconds.size() < options.runs && elapsed.time() + seconds.back() + baseline.back() < options.budget) {
      seconds.push_back(timed(method, model, options.threads, other));
      baseline.push_back(timed(method_of_key(BASELINE), model, 1, other));
    }
  } else
    while (seconds.size() < options.runs && elapsed.time() + seconds.back() < options.budget)
      seconds.push_back(timed(method, model, options.threads, other));
  write_seconds("seconds", seconds, out);
  write_seconds("baseline_seconds", baseline, out);
}

void list_methods(std::ostream& out)
{
  for (const auto& method : registered_methods())
    out << method->key() << '\t' << method->title() << '\t' << method->is_ours() << '\t' << method->uses_threads()
        << '\t' << method->description() << '\n';
}

} // namespace isr_benchmark

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

// Compares CTC, PCR and LIS with CGAL's advancing front on the same points in the same process.

#include "comparison_report.h"
#include "measures/mesh_statistics.h"
#include "models/model_files.h"
#include "models/noise.h"
#include "models/rotation.h"
#include "measures/peak_memory.h"
#include "reconstruction_methods.h"
#include "measures/self_intersections.h"
#include "measures/surface_metrics.h"

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace isr_benchmark;

struct Options
{
  std::vector<std::unique_ptr<Method> > methods;
  std::size_t threads = 1;
  std::size_t runs = 3;
  std::size_t intersection_limit = 200000;
  bool with_metrics = true;
  bool measure_memory = false;
  bool has_rotation = false;
  unsigned int rotation_seed = 0;
  double noise = 0.;
  std::string csv_file;
  std::vector<std::string> paths;
};

// Every run of the program is the same.
constexpr unsigned int NOISE_SEED = 1;

const char* const usage =
  "usage: isr_compare [options] FILE_OR_FOLDER...\n"
  "       isr_compare [options] --memory METHOD FILE\n"
  "\n"
  "Files are .ply, .off or .xyz. If a file has polygons, its surface is the reference, and LIS\n"
  "gets its normals.\n"
  "\n"
  "  --runs N                 runs of each method, alternating (default 3)\n"
  "  --method af|ctc|pcr|lis  run this method only; may be repeated\n"
  "  --threads N              CTC, PCR and LIS with Parallel_tag on N > 1 threads (default: one\n"
  "                           thread, Sequential_tag)\n"
  "  --keep-boundaries        CTC, PCR and LIS leave real boundaries open\n"
  "  --rotate SEED            rotate the models at random first; what is decided by ties and near\n"
  "                           ties then differs, what is sure does not\n"
  "  --noise SHARE            move the points of models with polygons by up to SHARE of the mean length\n"
  "                           of an edge in each coordinate; LIS gets the normals from before\n"
  "  --no-metrics             no distances to the reference and no self-intersections\n"
  "  --intersection-limit N   count self-intersections up to N triangles (default 200000)\n"
  "  --csv FILE               write the rows to FILE as well\n"
  "  --memory METHOD FILE     one run of one method; prints the peak memory per point\n";

Options parse(int argc, char** argv)
{
  Options options;
  std::vector<std::string> names;
  bool keep_boundaries = false;
  const auto value = [&](int& i) -> std::string {
    if (i + 1 >= argc)
      throw std::invalid_argument(std::string(argv[i]) + ": value missing");
    return argv[++i];
  };
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--runs")
      options.runs = (std::max)(std::stoul(value(i)), 1ul);
    else if (word == "--method")
      names.push_back(value(i));
    else if (word == "--threads")
      options.threads = std::stoul(value(i));
    else if (word == "--keep-boundaries")
      keep_boundaries = true;
    else if (word == "--rotate") {
      options.has_rotation = true;
      options.rotation_seed = static_cast<unsigned int>(std::stoul(value(i)));
    } else if (word == "--noise")
      options.noise = std::stod(value(i));
    else if (word == "--no-metrics")
      options.with_metrics = false;
    else if (word == "--intersection-limit")
      options.intersection_limit = std::stoul(value(i));
    else if (word == "--csv")
      options.csv_file = value(i);
    else if (word == "--memory") {
      options.measure_memory = true;
      names.push_back(value(i));
    } else if (word.rfind("--", 0) == 0)
      throw std::invalid_argument(word + ": unknown option");
    else
      options.paths.push_back(word);
  }
  if (options.paths.empty() || (options.measure_memory && options.paths.size() != 1))
    throw std::invalid_argument("file missing");
  if (!(options.noise >= 0. && std::isfinite(options.noise)))
    throw std::invalid_argument("--noise: not a share of an edge");
  if (names.empty())
    names = { "af", "ctc", "pcr" };
  options.methods = methods_of_names(names, keep_boundaries);
  return options;
}

Model read(const std::filesystem::path& file, const Options& options)
{
  Model model = read_model(file);
  if (options.has_rotation)
    transform(model, random_rotation(options.rotation_seed));
  set_reference_normals(model);
  add_noise(model, options.noise, NOISE_SEED);
  return model;
}

void measure_memory(const Options& options)
{
  const Model model = read(options.paths.front(), options);
  const Method& method = *options.methods.front();
  const Peak_memory memory;
  const Reconstruction result = method(model, options.threads);
  const double bytes = static_cast<double>(memory.growth_in_bytes());
  std::cout << model.name << ' ' << name(method) << ": " << model.points.size() << " points, "
            << result.triangles.size() << " triangles, peak " << bytes / 1e6 << " MB above the points, "
            << bytes / static_cast<double>(model.points.size()) << " bytes a point\n";
}

Row describe(const Model& model, const std::string& method, const std::vector<Triangle>& triangles,
             const Options& options)
{
  Row row;
  row.model = model.name;
  row.method = method;
  row.statistics = Mesh_statistician(model.points, triangles)();
  row.has_intersections = options.with_metrics && triangles.size() <= options.intersection_limit;
  if (row.has_intersections)
    row.intersections = Self_intersection_counter(model.points, triangles)();
  return row;
}

// Runs the methods in turn, so that a disturbance of the machine hits all of them.
void compare(const Model& model, const Options& options, Report& report)
{
  const std::size_t n = options.methods.size();
  std::vector<std::vector<double> > seconds(n);
  std::vector<std::vector<Triangle> > triangles(n);
  std::vector<std::string> failures(n);
  for (std::size_t run = 0; run != options.runs; ++run)
    for (std::size_t m = 0; m != n; ++m) {
      try {
        CGAL::Real_timer timer;
        timer.start();
        Reconstruction result = (*options.methods[m])(model, options.threads);
        seconds[m].push_back(timer.time());
        triangles[m] = triangles_of_points(model, std::move(result));
      } catch (const std::exception& e) {
        failures[m] = e.what();
      }
    }
  std::unique_ptr<Surface_comparer> comparer;
  Model_rows rows;
  if (!model.triangles.empty()) {
    rows.reference = describe(model, "reference", model.triangles, options);
    rows.has_reference = true;
    if (options.with_metrics)
      comparer = std::make_unique<Surface_comparer>(model.points, model.triangles);
  }
  for (std::size_t m = 0; m != n; ++m) {
    if (!failures[m].empty())
      std::cerr << model.name << ' ' << name(*options.methods[m]) << ": " << failures[m] << '\n';
    Row row = describe(model, name(*options.methods[m]), triangles[m], options);
    row.set_times(seconds[m]);
    row.has_metrics = comparer != nullptr;
    if (comparer)
      row.metrics = (*comparer)(model.points, triangles[m]);
    rows.found.push_back(row);
  }
  report.add(rows);
}

int main(int argc, char** argv)
{
  Options options;
  try {
    options = parse(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << e.what() << "\n\n" << usage;
    return EXIT_FAILURE;
  }
  try {
    if (options.measure_memory) {
      measure_memory(options);
      return EXIT_SUCCESS;
    }
    Report report(std::cout, options.csv_file);
    for (const auto& file : find_model_files(options.paths))
      compare(read(file, options), options, report);
    report.summarize();
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

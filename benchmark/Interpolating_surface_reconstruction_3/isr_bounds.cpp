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

// What a user can rely on, measured on hostile inputs: time and peak memory against the number of
// points, and how long a cancelled reconstruction goes on.
//
// Usage: isr_bounds [--method ctc|pcr|lis|lis_normals] [--cancel RUNS] N [INPUT...]
// Without inputs, all of them are run. With --cancel, another thread cancels every input RUNS times,
// at moments spread over the run. lis_normals has the positions as normals.

#include "measures/peak_memory.h"

#include "../../test/Interpolating_surface_reconstruction_3/isr_test_hostile.h"

#include <CGAL/ctc_reconstruction.h>
#include <CGAL/lis_reconstruction.h>
#include <CGAL/pcr_reconstruction.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace isr = CGAL::Interpolating_surface_reconstruction_3;
namespace params = CGAL::parameters;

namespace {

using Clock = std::chrono::steady_clock;
using Points = isr_test::Points;
using Triples = std::vector<std::array<std::size_t, 3> >;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// Of the processor, since the machine may be shared.
double processor_seconds_since(std::clock_t begin) { return double(std::clock() - begin) / double(CLOCKS_PER_SEC); }

// Finds the longest time between two polls, and the stage in which it was.
struct Poll_watch : isr::Default_visitor
{
  std::clock_t last = std::clock();
  double longest = 0.;
  int stage = -1, longest_stage = -1;
  std::atomic<bool> is_stopped{ false };

  void on_stage_begin(isr::Stage s) { stage = static_cast<int>(s); }
  bool go_further()
  {
    const double gap = processor_seconds_since(last);
    if (gap > longest) {
      longest = gap;
      longest_stage = stage;
    }
    last = std::clock();
    return !is_stopped;
  }
};

// Returns the number of triangles, none if cancelled.
using Method = std::size_t (*)(const Points&, Poll_watch&);

std::size_t ctc(const Points& points, Poll_watch& watch)
{
  Triples triples;
  CGAL::ctc_reconstruction(points, std::back_inserter(triples), params::visitor(std::ref(watch)));
  return triples.size();
}

std::size_t pcr(const Points& points, Poll_watch& watch)
{
  Triples triples;
  CGAL::pcr_reconstruction(points, std::back_inserter(triples), params::visitor(std::ref(watch)));
  return triples.size();
}

std::size_t lis(const Points& points, Poll_watch& watch)
{
  Points vertices;
  Triples triples;
  CGAL::lis_reconstruction(points, vertices, triples, params::visitor(std::ref(watch)));
  return triples.size();
}

std::size_t lis_normals(const Points& points, Poll_watch& watch)
{
  Points vertices;
  Triples triples;
  const auto normal = [](const isr_test::Point& p) { return p - CGAL::ORIGIN; };
  CGAL::lis_reconstruction(
    points, vertices, triples,
    params::visitor(std::ref(watch)).normal_map(boost::make_function_property_map<isr_test::Point>(normal)));
  return triples.size();
}

const std::map<std::string, Method>& methods()
{
  static const std::map<std::string, Method> all = {
    { "ctc", ctc }, { "pcr", pcr }, { "lis", lis }, { "lis_normals", lis_normals }
  };
  return all;
}

void run_to_end(Method method, const std::string& name, const Points& points)
{
  Poll_watch watch;
  const isr_benchmark::Peak_memory memory;
  const std::clock_t begin = std::clock();
  const std::size_t triangles = method(points, watch);
  const double seconds = processor_seconds_since(begin);
  const double n = double((std::max)(std::size_t(1), points.size()));
  std::cout << std::left << std::setw(28) << name << std::right << std::fixed << std::setprecision(2) << std::setw(10)
            << points.size() << std::setw(10) << triangles << std::setw(10) << 1e6 * seconds / n << std::setprecision(0)
            << std::setw(10) << double(memory.growth_in_bytes()) / n << std::setw(10) << 1e3 * watch.longest
            << std::setw(6) << watch.longest_stage << std::endl;
}

void cancel(Method method, const std::string& name, const Points& points, std::size_t runs)
{
  Poll_watch watch;
  const Clock::time_point begin = Clock::now();
  method(points, watch);
  const double seconds = seconds_since(begin);
  std::vector<double> latencies;
  for (std::size_t run = 0; run != runs; ++run) {
    Poll_watch stopped_watch;
    std::clock_t stopped = 0;
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::duration<double>(seconds * (double(run) + .5) / double(runs)));
      stopped = std::clock();
      stopped_watch.is_stopped = true;
    });
    const std::size_t triangles = method(points, stopped_watch);
    const std::clock_t returned = std::clock();
    other.join();
    if (triangles == 0 && returned > stopped)
      latencies.push_back(double(returned - stopped) / double(CLOCKS_PER_SEC));
  }
  std::sort(latencies.begin(), latencies.end());
  std::cout << std::left << std::setw(28) << name << std::right << std::fixed << std::setprecision(0) << std::setw(10)
            << points.size() << std::setw(10) << 1e3 * seconds << std::setw(10) << latencies.size();
  if (!latencies.empty())
    std::cout << std::setw(10) << 1e3 * latencies[latencies.size() / 2] << std::setw(10) << 1e3 * latencies.back();
  std::cout << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  std::map<std::string, std::string> options = { { "--method", "ctc" }, { "--cancel", "0" } };
  while (arguments.size() > 1 && options.count(arguments[0]) != 0) {
    options[arguments[0]] = arguments[1];
    arguments.erase(arguments.begin(), arguments.begin() + 2);
  }
  const std::size_t runs = std::strtoul(options["--cancel"].c_str(), nullptr, 10);
  const std::size_t n = arguments.empty() ? 0 : std::strtoul(arguments[0].c_str(), nullptr, 10);
  if (n == 0 || methods().count(options["--method"]) == 0) {
    std::cerr << "Usage: isr_bounds [--method ctc|pcr|lis|lis_normals] [--cancel RUNS] N [INPUT...]" << std::endl;
    return EXIT_FAILURE;
  }
  const Method method = methods().at(options["--method"]);
  std::cout << (runs == 0 ? "input                           points triangles  us/point   B/point   poll ms stage\n"
                          : "input                           points    run ms cancelled median ms    max ms\n");
  std::vector<isr_test::Hostile_generator> inputs = isr_test::hostile_corpus();
  inputs.insert(inputs.begin(), { "sphere", [](std::size_t m, std::uint64_t seed) {
                                   return isr_test::sphere_random(m, seed).points;
                                 } });
  for (const isr_test::Hostile_generator& input : inputs) {
    if (arguments.size() > 1 && std::find(arguments.begin() + 1, arguments.end(), input.name) == arguments.end())
      continue;
    const Points points = input.generate(n, 1);
    if (runs == 0)
      run_to_end(method, input.name, points);
    else
      cancel(method, input.name, points, runs);
  }
  return EXIT_SUCCESS;
}

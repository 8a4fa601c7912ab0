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
// Usage: isr_bounds [--cancel RUNS] N [INPUT...]
// Without inputs, all of them are run. With --cancel, another thread cancels every input RUNS times,
// at moments spread over the run.

#include "measures/peak_memory.h"

#include "../../test/Interpolating_surface_reconstruction_3/isr_test_hostile.h"

#include <CGAL/ctc_reconstruction.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

namespace isr = CGAL::Interpolating_surface_reconstruction_3;
namespace params = CGAL::parameters;

namespace {

using Clock = std::chrono::steady_clock;
using Triples = std::vector<std::array<std::size_t, 3> >;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// Finds the longest time between two polls, and the stage in which it was.
struct Poll_watch : isr::Default_visitor
{
  Clock::time_point last = Clock::now();
  double longest = 0.;
  int stage = -1, longest_stage = -1;
  std::atomic<bool> is_stopped{ false };

  void on_stage_begin(isr::Stage s) { stage = static_cast<int>(s); }
  bool go_further()
  {
    const double gap = seconds_since(last);
    if (gap > longest) {
      longest = gap;
      longest_stage = stage;
    }
    last = Clock::now();
    return !is_stopped;
  }
};

void run_to_end(const isr_test::Hostile_generator& input, const isr_test::Points& points)
{
  Triples triples;
  Poll_watch watch;
  const isr_benchmark::Peak_memory memory;
  const Clock::time_point begin = Clock::now();
  CGAL::ctc_reconstruction(points, std::back_inserter(triples), params::visitor(std::ref(watch)));
  const double seconds = seconds_since(begin);
  const double n = double((std::max)(std::size_t(1), points.size()));
  std::cout << std::left << std::setw(28) << input.name << std::right << std::fixed << std::setprecision(2)
            << std::setw(10) << points.size() << std::setw(10) << triples.size() << std::setw(10) << 1e6 * seconds / n
            << std::setprecision(0) << std::setw(10) << double(memory.growth_in_bytes()) / n << std::setw(10)
            << 1e3 * watch.longest << std::setw(6) << watch.longest_stage << std::endl;
}

void cancel(const isr_test::Hostile_generator& input, const isr_test::Points& points, std::size_t runs)
{
  Triples triples;
  const Clock::time_point begin = Clock::now();
  CGAL::ctc_reconstruction(points, std::back_inserter(triples));
  const double seconds = seconds_since(begin);
  std::vector<double> latencies;
  for (std::size_t run = 0; run != runs; ++run) {
    Poll_watch watch;
    Clock::time_point stopped;
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::duration<double>(seconds * (double(run) + .5) / double(runs)));
      stopped = Clock::now();
      watch.is_stopped = true;
    });
    triples.clear();
    CGAL::ctc_reconstruction(points, std::back_inserter(triples), params::visitor(std::ref(watch)));
    const Clock::time_point returned = Clock::now();
    other.join();
    if (triples.empty())
      latencies.push_back(std::chrono::duration<double>(returned - stopped).count());
  }
  std::sort(latencies.begin(), latencies.end());
  std::cout << std::left << std::setw(28) << input.name << std::right << std::fixed << std::setprecision(0)
            << std::setw(10) << points.size() << std::setw(10) << 1e3 * seconds << std::setw(10) << latencies.size();
  if (!latencies.empty())
    std::cout << std::setw(10) << 1e3 * latencies[latencies.size() / 2] << std::setw(10) << 1e3 * latencies.back();
  std::cout << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  std::size_t runs = 0;
  if (arguments.size() > 1 && arguments[0] == "--cancel") {
    runs = std::strtoul(arguments[1].c_str(), nullptr, 10);
    arguments.erase(arguments.begin(), arguments.begin() + 2);
  }
  const std::size_t n = arguments.empty() ? 0 : std::strtoul(arguments[0].c_str(), nullptr, 10);
  if (n == 0) {
    std::cerr << "Usage: isr_bounds [--cancel RUNS] N [INPUT...]" << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << (runs == 0 ? "input                           points triangles  us/point   B/point   poll ms stage\n"
                          : "input                           points    run ms cancelled median ms    max ms\n");
  std::vector<isr_test::Hostile_generator> inputs = isr_test::hostile_corpus();
  inputs.insert(inputs.begin(), { "sphere", [](std::size_t m, std::uint64_t seed) {
                                   return isr_test::sphere_random(m, seed).points;
                                 } });
  for (const isr_test::Hostile_generator& input : inputs) {
    if (arguments.size() > 1 && std::find(arguments.begin() + 1, arguments.end(), input.name) == arguments.end())
      continue;
    const isr_test::Points points = input.generate(n, 1);
    if (runs == 0)
      run_to_end(input, points);
    else
      cancel(input, points, runs);
  }
  return EXIT_SUCCESS;
}

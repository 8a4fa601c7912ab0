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

// Progress and cancellation.

#include "isr_test_ctc.h"

#include <CGAL/Surface_mesh.h>

#include <atomic>
#include <chrono>
#include <thread>

using namespace isr_test;

const Points& sphere()
{
  static const Points points = sphere_fibonacci(5000).points;
  return points;
}

struct Stopping_visitor : Counting_visitor
{
  std::atomic<bool> is_stopped{ false };
  bool go_further() { return !is_stopped; }
};

// Stops when the given stage begins.
struct Stage_stopping_visitor : Counting_visitor
{
  isr::Stage last;
  std::atomic<bool> is_stopped{ false };
  void on_stage_begin(isr::Stage stage)
  {
    Counting_visitor::on_stage_begin(stage);
    is_stopped = is_stopped || stage == last;
  }
  bool go_further() { return !is_stopped; }
};

template <typename NamedParameters>
void check_nothing_is_written(const NamedParameters& np)
{
  ISR_CHECK(ctc(sphere(), np).empty());
  CGAL::Surface_mesh<Point> mesh;
  ISR_CHECK(!CGAL::ctc_reconstruction(sphere(), mesh, np));
  ISR_CHECK(mesh.is_empty());
  ISR_CHECK(mesh.properties<CGAL::Surface_mesh<Point>::Vertex_index>() ==
            CGAL::Surface_mesh<Point>().properties<CGAL::Surface_mesh<Point>::Vertex_index>());
}

std::size_t test_progress()
{
  begin_case("progress");
  std::vector<double> values;
  const std::function<bool(double)> record = [&](double value) {
    values.push_back(value);
    return true;
  };
  ISR_CHECK(!ctc(sphere(), params::callback(record)).empty());
  ISR_CHECK(std::is_sorted(values.begin(), values.end()));
  ISR_CHECK(values.size() >= 5);
  ISR_CHECK(!values.empty() && values.front() >= 0. && values.back() == 1.);
  return values.size();
}

void test_callback(std::size_t number_of_calls)
{
  begin_case("callback cancels at each of " + std::to_string(number_of_calls) + " calls");
  const std::size_t step = (std::max)(std::size_t(1), number_of_calls / 20);
  for (std::size_t last = 0; last < number_of_calls; last += step) {
    std::size_t calls = 0;
    bool is_called_again = false;
    const std::function<bool(double)> callback = [&](double) {
      is_called_again = is_called_again || calls > last;
      return calls++ < last;
    };
    Counting_visitor visitor;
    ISR_CHECK(ctc(sphere(), params::callback(callback).visitor(std::ref(visitor))).empty());
    ISR_CHECK(!is_called_again);
    ISR_CHECK(visitor.was_cancelled);
    ISR_CHECK_EQUAL(visitor.ended, 1u);
  }
  const std::function<bool(double)> at_once = [](double) { return false; };
  check_nothing_is_written(params::callback(at_once));
  // completion is reported before anything is written, and may be refused
  const std::function<bool(double)> at_last = [](double value) { return value < 1.; };
  check_nothing_is_written(params::callback(at_last));
}

void test_stages()
{
  const isr::Stage stages[] = { isr::Stage::INDEXING,   isr::Stage::STARS, isr::Stage::COMPATIBILITY,
                                isr::Stage::COMPLETION, isr::Stage::HOLES, isr::Stage::ORIENTATION };
  std::size_t begun = 0;
  for (const isr::Stage stage : stages) {
    ++begun;
    begin_case("visitor cancels in stage " + std::to_string(int(stage)));
    Stage_stopping_visitor visitor;
    visitor.last = stage;
    const Triples triples = ctc(sphere(), params::visitor(std::ref(visitor)));
    ISR_CHECK(visitor.is_stopped);                // every stage is announced
    ISR_CHECK_EQUAL(visitor.stages_begun, begun); // and none follows
    ISR_CHECK_EQUAL(visitor.stages_ended, visitor.stages_begun);
    ISR_CHECK(triples.empty());
    ISR_CHECK(visitor.was_cancelled);
  }
}

void test_other_thread()
{
  begin_case("another thread cancels");
  Stopping_visitor visitor;
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    visitor.is_stopped = true;
  });
  const Points points = sphere_random(200000, 1).points;
  const Triples triples = ctc(points, params::visitor(std::ref(visitor)));
  other.join();
  ISR_CHECK(triples.empty());
  ISR_CHECK(visitor.was_cancelled);
}

void test_exception()
{
  begin_case("an exception of the callback passes through");
  const std::function<bool(double)> callback = [](double value) {
    if (value > .3)
      throw std::runtime_error("stop");
    return true;
  };
  Triples triples;
  bool is_thrown = false;
  try {
    CGAL::ctc_reconstruction(sphere(), std::back_inserter(triples), params::callback(callback));
  } catch (const std::runtime_error& e) {
    is_thrown = std::string(e.what()) == "stop";
  }
  ISR_CHECK(is_thrown);
  ISR_CHECK(triples.empty());
}

void test_few_points()
{
  begin_case("progress without a surface");
  double last = -1.;
  const std::function<bool(double)> callback = [&](double value) {
    last = value;
    return true;
  };
  ISR_CHECK(ctc(Points{ Point(0, 0, 0) }, params::callback(callback)).empty());
  ISR_CHECK_EQUAL(last, 1.);
}

int main()
{
  const std::size_t number_of_calls = test_progress();
  test_callback(number_of_calls);
  test_stages();
  test_other_thread();
  test_exception();
  test_few_points();
  return result();
}

#include "isr_stage_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>

#include <atomic>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

using ISR_visitor = CGAL::Interpolating_surface_reconstruction_3::Default_visitor;
using CGAL::Interpolating_surface_reconstruction_3::Stage;
template <typename Visitor>
using Progress = CGAL::Interpolating_surface_reconstruction_3::internal::Progress<Visitor>;

struct Recording_visitor : ISR_visitor
{
  std::vector<std::pair<Stage, std::ptrdiff_t> > events;
  std::size_t polls = 0, polls_before_cancel = std::size_t(-1);

  void on_stage_begin(Stage stage) { events.emplace_back(stage, -1); }
  void on_stage_end(Stage stage, std::size_t items) { events.emplace_back(stage, std::ptrdiff_t(items)); }
  bool go_further() { return ++polls <= polls_before_cancel; }
};

template <typename Visitor>
void run(Progress<Visitor>& progress)
{
  for (Stage stage : { Stage::INDEXING, Stage::STARS, Stage::COMPLETION, Stage::ORIENTATION }) {
    progress.begin_stage(stage, .25);
    for (int i = 0; i <= 10; ++i)
      progress.advance(.1 * i);
    progress.end_stage(10);
  }
}

void check_monotone(const std::vector<double>& values)
{
  for (double v : values)
    assert(v >= 0. && v <= 1.);
  assert(std::is_sorted(values.begin(), values.end()));
}

void test_monotone()
{
  std::vector<double> values;
  Recording_visitor visitor;
  Progress<Recording_visitor> progress(
    [&](double v) {
      values.push_back(v);
      return true;
    },
    visitor);
  run(progress);
  assert(progress.finish() && !progress.is_cancelled());
  check_monotone(values);
  assert(values.front() == 0. && values.back() == 1. && values.size() > 40);
  assert(visitor.events.size() == 8 && &progress.visitor() == &visitor);
  const std::vector<std::pair<Stage, std::ptrdiff_t> > expected = {
    { Stage::INDEXING, -1 },   { Stage::INDEXING, 10 },   { Stage::STARS, -1 },       { Stage::STARS, 10 },
    { Stage::COMPLETION, -1 }, { Stage::COMPLETION, 10 }, { Stage::ORIENTATION, -1 }, { Stage::ORIENTATION, 10 }
  };
  assert(visitor.events == expected);
}

// A fraction that falls back does not show.
void test_fraction_that_decreases()
{
  std::vector<double> values;
  ISR_visitor visitor;
  Progress<ISR_visitor> progress(
    [&](double v) {
      values.push_back(v);
      return true;
    },
    visitor);
  progress.begin_stage(Stage::STARS, 1.);
  for (double fraction : { .5, .2, .7, .1 })
    assert(progress.advance(fraction));
  check_monotone(values);
  assert(values.back() == .7);
}

void test_no_callback()
{
  ISR_visitor visitor;
  Progress<ISR_visitor> progress(std::function<bool(double)>(), visitor);
  run(progress);
  assert(progress.finish());
}

// After the first refusal the callback is not called again.
void test_sticky_cancel()
{
  for (std::size_t calls_before_cancel : { 0u, 1u, 7u, 30u }) {
    std::size_t calls = 0;
    ISR_visitor visitor;
    Progress<ISR_visitor> progress([&](double) { return ++calls <= calls_before_cancel; }, visitor);
    run(progress);
    assert(progress.is_cancelled() && !progress.advance(.5) && !progress.finish());
    assert(calls == calls_before_cancel + 1);
  }
}

void test_cancel_by_visitor()
{
  Recording_visitor visitor;
  visitor.polls_before_cancel = 5;
  Progress<Recording_visitor> progress(std::function<bool(double)>(), visitor);
  run(progress);
  assert(progress.is_cancelled() && !progress.finish() && visitor.polls == 6);
}

// A run may be refused when everything else is done.
void test_cancel_at_end()
{
  ISR_visitor visitor;
  Progress<ISR_visitor> progress([](double v) { return v < 1.; }, visitor);
  progress.begin_stage(Stage::STARS, .9);
  progress.end_stage(1);
  assert(!progress.is_cancelled() && !progress.finish() && progress.is_cancelled());
}

void test_exception()
{
  ISR_visitor visitor;
  int calls = 0;
  Progress<ISR_visitor> progress(
    [&](double v) -> bool {
      ++calls;
      if (v > .1)
        throw std::runtime_error("from the callback");
      return true;
    },
    visitor);
  progress.begin_stage(Stage::STARS, .5);
  // in the worker: no exception, but the run is cancelled
  std::thread worker([&] { assert(!progress.advance(.9)); });
  worker.join();
  const int calls_until_exception = calls;
  assert(progress.is_cancelled() && !progress.advance(1.));
  bool is_thrown = false;
  try {
    progress.end_stage(1);
  } catch (const std::runtime_error& e) {
    is_thrown = std::string(e.what()) == "from the callback";
  }
  assert(is_thrown && calls == calls_until_exception);

  Progress<ISR_visitor> last([](double v) -> bool { return v < 1. ? true : throw 5; }, visitor);
  is_thrown = false;
  try {
    last.finish();
  } catch (int i) {
    is_thrown = i == 5;
  }
  assert(is_thrown);
}

// Never two calls at a time, never a smaller value, whatever the threads do.
void test_threads()
{
  std::vector<double> values;
  std::atomic<int> inside{ 0 };
  ISR_visitor visitor;
  Progress<ISR_visitor> progress(
    [&](double v) {
      assert(++inside == 1);
      values.push_back(v);
      std::this_thread::yield();
      --inside;
      return true;
    },
    visitor);
  progress.begin_stage(Stage::STARS, 1.);
  std::atomic<int> done{ 0 };
  std::vector<std::thread> threads;
  for (int t = 0; t != 4; ++t)
    threads.emplace_back([&] {
      for (int i = 0; i != 2000; ++i)
        assert(progress.advance(double(++done) / 8000.));
    });
  for (std::thread& t : threads)
    t.join();
  progress.end_stage(8000);
  assert(progress.finish());
  check_monotone(values);
  assert(values.back() == 1.);
}

int main()
{
  test_monotone();
  test_fraction_that_decreases();
  test_no_callback();
  test_sticky_cancel();
  test_cancel_by_visitor();
  test_cancel_at_end();
  test_exception();
  test_threads();
  std::cout << "done" << std::endl;
  return 0;
}

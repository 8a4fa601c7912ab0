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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PROGRESS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PROGRESS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Joins the `callback` and `visitor` parameters. Cancellation is sticky. The callback is never
// called concurrently, its argument never decreases, and an exception that it throws in a worker
// cancels the run and is thrown again by the thread that ends the stage.
template <typename Visitor>
class Progress
{
public:
  Progress(std::function<bool(double)> callback, Visitor& visitor) : m_callback(std::move(callback)), m_visitor(visitor)
  { }

  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  Visitor& visitor() const { return m_visitor; }
  bool is_cancelled() const { return m_cancelled.load(std::memory_order_relaxed); }

  // `share` is the part of the whole run that the stage is expected to take.
  void begin_stage(Stage stage, double share)
  {
    m_stage = stage;
    m_stage_begin = m_stage_end;
    m_stage_end += share;
    m_visitor.on_stage_begin(stage);
    advance(0.);
  }

  void end_stage(std::size_t items)
  {
    advance(1.);
    rethrow();
    m_visitor.on_stage_end(m_stage, items);
  }

  // Reports that `fraction` of the stage is done; false if the run is cancelled. Thread-safe.
  bool advance(double fraction)
  {
    if (is_cancelled())
      return false;
    const std::unique_lock<std::mutex> lock(m_mutex, std::try_to_lock);
    if (!lock.owns_lock())
      return true;
    const double value = m_stage_begin + fraction * (m_stage_end - m_stage_begin);
    m_reported = value > m_reported ? value : m_reported;
    return poll(m_reported);
  }

  // Reports completion; called once, after the last stage and before the output is written.
  bool finish()
  {
    const bool completed = !is_cancelled() && poll(1.);
    rethrow();
    return completed;
  }

private:
  void rethrow() const
  {
    if (m_exception)
      std::rethrow_exception(m_exception);
  }

  bool poll(double value)
  {
    try {
      if ((m_callback && !m_callback(value)) || !m_visitor.go_further())
        m_cancelled.store(true, std::memory_order_relaxed);
    } catch (...) {
      m_exception = std::current_exception();
      m_cancelled.store(true, std::memory_order_relaxed);
    }
    return !is_cancelled();
  }

  std::function<bool(double)> m_callback;
  Visitor& m_visitor;
  std::mutex m_mutex;
  std::atomic<bool> m_cancelled{ false };
  std::exception_ptr m_exception;
  Stage m_stage = Stage::INDEXING;
  double m_stage_begin = 0., m_stage_end = 0., m_reported = 0.;
};

// Thrown out of a long computation when the run is cancelled; the stage that called catches it.
struct Cancelled
{ };

// Called in the inner loops of a long computation, it polls now and then.
template <typename Progress>
class Cancellation_point
{
public:
  explicit Cancellation_point(Progress& progress) : m_progress(&progress) { }

  // `work` is about the number of microseconds until the next call, if they are more than one.
  void operator()(std::size_t work = 1)
  {
    m_work += work;
    if (m_work < WORK_PER_POLL)
      return;
    m_work = 0;
    if (!m_progress->advance(0.))
      throw Cancelled();
  }

private:
  // Between two polls are some milliseconds.
  static constexpr std::size_t WORK_PER_POLL = 4096;

  Progress* m_progress;
  std::size_t m_work = 0;
};

// Never cancels.
struct No_cancellation
{
  void operator()(std::size_t = 1) const { }
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PROGRESS_H

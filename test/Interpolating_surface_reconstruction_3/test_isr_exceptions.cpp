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

// Exceptions of the user's objects, and memory that runs out at any allocation: nothing is written,
// nothing leaks, and the mesh is as it was.

#include "isr_test_algorithms.h"

#include <CGAL/Surface_mesh.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <stdexcept>

namespace {

// Allocations up to `last_allocation` succeed.
std::atomic<std::size_t> number_of_allocations{ 0 }, last_allocation{ static_cast<std::size_t>(-1) };
std::atomic<long> number_of_live_blocks{ 0 };

void* allocate(std::size_t size, std::size_t alignment)
{
  if (number_of_allocations++ >= last_allocation)
    return nullptr;
  void* const block =
    std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment + (size == 0 ? alignment : 0));
  if (block != nullptr)
    ++number_of_live_blocks;
  return block;
}

void* allocate_or_throw(std::size_t size, std::size_t alignment = alignof(std::max_align_t))
{
  void* const block = allocate(size, alignment);
  if (block == nullptr)
    throw std::bad_alloc();
  return block;
}

void release(void* block)
{
  if (block == nullptr)
    return;
  --number_of_live_blocks;
  std::free(block);
}

} // namespace

void* operator new(std::size_t size) { return allocate_or_throw(size); }
void* operator new[](std::size_t size) { return allocate_or_throw(size); }
void* operator new(std::size_t size, std::align_val_t a) { return allocate_or_throw(size, std::size_t(a)); }
void* operator new[](std::size_t size, std::align_val_t a) { return allocate_or_throw(size, std::size_t(a)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return allocate(size, alignof(std::max_align_t));
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept
{
  return allocate(size, alignof(std::max_align_t));
}
void operator delete(void* p) noexcept { release(p); }
void operator delete[](void* p) noexcept { release(p); }
void operator delete(void* p, std::size_t) noexcept { release(p); }
void operator delete[](void* p, std::size_t) noexcept { release(p); }
void operator delete(void* p, std::align_val_t) noexcept { release(p); }
void operator delete[](void* p, std::align_val_t) noexcept { release(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { release(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { release(p); }

using namespace isr_test;

using Mesh = CGAL::Surface_mesh<Point>;

// With work for every stage, and small: the time of the test grows with the square of what it allocates.
Points small_input()
{
  Points points = sphere_fibonacci(20).points;
  append(points, translated(random_cube(8, 1), Vector(.3, 0, 0)));
  points.push_back(points.front());
  return points;
}

bool is_untouched(const Mesh& mesh)
{
  return mesh.is_empty() && mesh.properties<Mesh::Vertex_index>() == Mesh().properties<Mesh::Vertex_index>();
}

// Counts blocks that are not given back. CGAL's Compact_container loses the block of elements that it
// has just allocated if the list of its blocks cannot grow then; the list doubles, so that this is
// seldom. Nothing else may be lost.
class Leak_check
{
public:
  void operator()()
  {
    const long lost = number_of_live_blocks - m_live;
    m_live = number_of_live_blocks;
    ISR_CHECK(lost == 0 || lost == 1);
    m_lost += lost;
  }

  void check_total(std::size_t failures) const
  {
    std::cout << "    " << failures << " failures, " << m_lost << " blocks lost" << std::endl;
    ISR_CHECK(m_lost <= MAXIMUM_LOST);
  }

private:
  // The lists of the few containers of a run double a few times each, however much else is allocated.
  static constexpr long MAXIMUM_LOST = 30;

  long m_live = number_of_live_blocks, m_lost = 0;
};

// Calls run() with memory for 0, step, 2 step, ... allocations until it succeeds, and check() after each
// failure. Returns the number of failures.
template <typename Run, typename Check>
std::size_t run_out_of_memory(std::size_t step, const Run& run, const Check& check)
{
  for (std::size_t failures = 0;; ++failures) {
    bool is_thrown = false;
    number_of_allocations = 0;
    last_allocation = failures * step;
    try {
      run();
    } catch (const std::bad_alloc&) {
      is_thrown = true;
    }
    last_allocation = static_cast<std::size_t>(-1);
    if (!is_thrown)
      return failures;
    check();
  }
}

template <typename Algorithm>
void test_memory(Algorithm algorithm)
{
  begin_case(algorithm.name() + ": no memory, triangles");
  const Points points = small_input();
  const Triples expected = triangles_of(algorithm, points);
  ISR_CHECK(!expected.empty());

  Triples triples;
  triples.reserve(expected.size());
  const auto run = [&] {
    triples.clear();
    Algorithm::reconstruct(points, std::back_inserter(triples), params::neighbor_radius(0.));
  };
  run(); // what is allocated once and for all
  Leak_check check_leaks;
  std::size_t failures = run_out_of_memory(1, run, [&] {
    ISR_CHECK(triples.empty());
    check_leaks();
  });
  check_leaks();
  check_leaks.check_total(failures);
  ISR_CHECK(failures > 100);
  ISR_CHECK(triples == expected);

  begin_case(algorithm.name() + ": no memory, mesh");
  Mesh mesh;
  Leak_check check_mesh_leaks;
  failures = run_out_of_memory(
    1, [&] { Algorithm::reconstruct(points, mesh, params::neighbor_radius(0.)); },
    [&] {
      ISR_CHECK(is_untouched(mesh));
      check_mesh_leaks();
    });
  check_mesh_leaks.check_total(failures);
  ISR_CHECK(failures > 100);
  ISR_CHECK_EQUAL(mesh.number_of_faces(), expected.size());
}

#ifdef CGAL_LINKED_WITH_TBB
// The scheduler has memory of its own that comes and goes, so that leaks are not counted.
template <typename Algorithm>
void test_memory_in_parallel(Algorithm algorithm)
{
  begin_case(algorithm.name() + ": no memory, parallel");
  constexpr std::size_t STEP = 499; // some 10 to 100 failures
  const Points points = sphere_fibonacci(3000).points;
  Mesh mesh;
  const std::size_t failures = run_out_of_memory(
    STEP, [&] { Algorithm::template reconstruct<CGAL::Parallel_tag>(points, mesh, params::neighbor_radius(0.)); },
    [&] { ISR_CHECK(is_untouched(mesh)); });
  std::cout << "    " << failures << " failures" << std::endl;
  ISR_CHECK(failures > 3);
  ISR_CHECK(!mesh.is_empty());
}
#endif

struct Refusal : std::runtime_error
{
  Refusal() : std::runtime_error("refused") { }
};

// Counts down; throws when nothing is left.
struct Countdown
{
  explicit Countdown(std::size_t n) : left(n) { }
  void operator()()
  {
    if (left-- == 0)
      throw Refusal();
  }
  std::size_t left;
};

// Calls run(countdown) with longer and longer countdowns until it does not throw.
template <typename Run, typename Check>
void test_throwing(const std::string& what, const Run& run, const Check& check)
{
  begin_case(what);
  {
    Countdown warm_up(static_cast<std::size_t>(-1));
    run(warm_up);
  }
  const long live = number_of_live_blocks;
  std::size_t failures = 0;
  for (std::size_t n = 0;; ++n, ++failures) {
    Countdown countdown(n);
    bool is_thrown = false;
    try {
      run(countdown);
    } catch (const Refusal&) {
      is_thrown = true;
    }
    if (!is_thrown)
      break;
    check();
    ISR_CHECK_EQUAL(number_of_live_blocks, live);
  }
  std::cout << "    " << failures << " failures" << std::endl;
  ISR_CHECK(failures != 0);
}

struct Throwing_iterator
{
  using iterator_category = std::output_iterator_tag;
  using value_type = void;
  using difference_type = void;
  using pointer = void;
  using reference = void;

  Throwing_iterator& operator*() { return *this; }
  Throwing_iterator& operator++() { return *this; }
  Throwing_iterator& operator++(int) { return *this; }
  Throwing_iterator& operator=(const Triple&)
  {
    (*countdown)();
    return *this;
  }
  Countdown* countdown;
};

struct Throwing_map
{
  using key_type = Point;
  using value_type = Point;
  using reference = Point;
  using category = boost::readable_property_map_tag;
  friend Point get(const Throwing_map& map, const Point& p)
  {
    (*map.countdown)();
    return p;
  }
  Countdown* countdown;
};

struct Throwing_visitor
{
  void on_reconstruction_begin(std::size_t) { (*countdown)(); }
  void on_points_set_aside(std::size_t, std::size_t) { (*countdown)(); }
  void on_stage_begin(isr::Stage) { (*countdown)(); }
  bool go_further()
  {
    (*countdown)();
    return true;
  }
  void on_triangle(const Triple&, isr::Triangle_verdict) { (*countdown)(); }
  void on_stage_end(isr::Stage, std::size_t) { (*countdown)(); }
  void on_points_unused(std::size_t) { (*countdown)(); }
  void on_reconstruction_end(bool) { (*countdown)(); }
  Countdown* countdown;
};

template <typename Algorithm>
void test_user_objects(Algorithm algorithm)
{
  const Points points = small_input();
  Mesh mesh;
  const auto is_mesh_untouched = [&] { ISR_CHECK(is_untouched(mesh)); };
  const auto into_mesh = [&](const auto& np) {
    Algorithm::reconstruct(points, mesh, np);
    mesh = Mesh();
  };
  test_throwing(
    algorithm.name() + ": the output iterator throws",
    [&](Countdown& countdown) {
      Algorithm::reconstruct(points, Throwing_iterator{ &countdown }, params::neighbor_radius(0.));
    },
    [] {});
  test_throwing(
    algorithm.name() + ": the callback throws",
    [&](Countdown& countdown) {
      const std::function<bool(double)> callback = [&](double) {
        countdown();
        return true;
      };
      into_mesh(params::callback(callback));
    },
    is_mesh_untouched);
  test_throwing(
    algorithm.name() + ": the visitor throws",
    [&](Countdown& countdown) {
      Throwing_visitor visitor{ &countdown };
      into_mesh(params::visitor(std::ref(visitor)));
    },
    is_mesh_untouched);
  test_throwing(
    algorithm.name() + ": the point map throws",
    [&](Countdown& countdown) { into_mesh(params::point_map(Throwing_map{ &countdown })); }, is_mesh_untouched);
}

int main(int argc, char** argv)
{
  for_each_algorithm(argc, argv, [](auto algorithm) {
    test_memory(algorithm);
#ifdef CGAL_LINKED_WITH_TBB
    test_memory_in_parallel(algorithm);
#endif
    test_user_objects(algorithm);
  });
  return result();
}

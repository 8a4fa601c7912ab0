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

// Time of the single stages against the number of points: a sphere sampled at random, in random order.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Nearest_neighbors.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_cloud_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/point_generators_3.h>
#include <CGAL/property_map.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

namespace isr = CGAL::Interpolating_surface_reconstruction_3;
namespace internal = CGAL::Interpolating_surface_reconstruction_3::internal;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Cloud = internal::Point_cloud_3<Kernel>;

namespace {

std::vector<Point> sphere(std::size_t n)
{
  CGAL::Random random(1);
  CGAL::Random_points_on_sphere_3<Point> generator(1., random);
  std::vector<Point> points;
  std::copy_n(generator, n, std::back_inserter(points));
  return points;
}

Cloud make_cloud(const std::vector<Point>& points)
{
  return Cloud(points, CGAL::Identity_property_map<Point>(), Kernel());
}

void report_points(benchmark::State& state) { state.SetItemsProcessed(state.iterations() * state.range(0)); }

void point_cloud(benchmark::State& state)
{
  const std::vector<Point> points = sphere(std::size_t(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(make_cloud(points).size());
  report_points(state);
}

void octree(benchmark::State& state)
{
  const Cloud cloud = make_cloud(sphere(std::size_t(state.range(0))));
  for (auto _ : state)
    benchmark::DoNotOptimize(internal::Point_octree_3(cloud.positions()).nodes().size());
  report_points(state);
}

// Visits the neighborhoods of all points with as many neighbors as `visit` asks for.
template <typename Visit>
void visit_neighborhoods(benchmark::State& state, Visit visit)
{
  const Cloud cloud = make_cloud(sphere(std::size_t(state.range(0))));
  const internal::Point_octree_3 octree(cloud.positions());
  for (auto _ : state) {
    internal::Nearest_neighbors neighbors(cloud.positions(), octree, (std::numeric_limits<double>::max)());
    for (std::uint32_t leaf : octree.leaves())
      neighbors.for_each_point(octree.node(leaf), isr::Restricted_voronoi_star_3::initial_number_of_neighbors(),
                               isr::Restricted_voronoi_star_3::maximum_number_of_neighbors(), visit);
  }
  report_points(state);
}

void nearest_neighbors(benchmark::State& state)
{
  std::size_t found = 0;
  visit_neighborhoods(state, [&](internal::Point_index, const isr::Star_neighborhood& neighborhood) {
    found += neighborhood.size();
    return true;
  });
  benchmark::DoNotOptimize(found);
}

// The neighborhoods included, as in a reconstruction.
void stars(benchmark::State& state)
{
  const isr::Restricted_voronoi_star_3 construct_star;
  isr::Point_star star;
  std::size_t found = 0;
  visit_neighborhoods(state, [&](internal::Point_index, const isr::Star_neighborhood& neighborhood) {
    const bool is_certain = construct_star(neighborhood, star);
    found += star.link.size();
    return is_certain;
  });
  benchmark::DoNotOptimize(found);
}

void sizes(benchmark::internal::Benchmark* b)
{
  b->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond);
}

BENCHMARK(point_cloud)->Apply(sizes);
BENCHMARK(octree)->Apply(sizes);
BENCHMARK(nearest_neighbors)->Apply(sizes);
BENCHMARK(stars)->Apply(sizes);

} // namespace

BENCHMARK_MAIN();

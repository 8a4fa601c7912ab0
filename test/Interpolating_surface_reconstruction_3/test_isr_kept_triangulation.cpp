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

// A kept triangulation has the cells of each set of points, whatever it had before.

#include "isr_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Site_triangulation.h>

#include <cstddef>
#include <memory>
#include <random>
#include <utility>
#include <vector>

using namespace isr_test;
namespace in = CGAL::Interpolating_surface_reconstruction_3::internal;

namespace {

using Points = std::vector<in::Point_index>;

std::vector<in::Local_point> random_points(std::size_t n)
{
  std::minstd_rand random(1);
  std::uniform_real_distribution<double> coordinate(-1., 1.);
  std::vector<in::Local_point> result;
  while (result.size() != n) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    result.emplace_back(x, y, z);
  }
  return result;
}

// Most of eight points of a grid are cospherical.
std::vector<in::Local_point> grid_points(int n)
{
  std::vector<in::Local_point> result;
  for (int x = 0; x != n; ++x)
    for (int y = 0; y != n; ++y)
      for (int z = 0; z != n; ++z)
        result.emplace_back(x, y, z);
  return result;
}

Points all_but(std::size_t n, std::size_t first, std::size_t stride)
{
  Points result;
  for (std::size_t p = 0; p != n; ++p)
    if (p < first || (p - first) % stride != 0)
      result.push_back(static_cast<in::Point_index>(p));
  return result;
}

bool are_cells_of(const in::Cell_complex& cells, const std::vector<in::Local_point>& positions, const Points& points)
{
  const in::Cell_complex fresh(positions, points);
  bool result = cells.points() == points && cells.size() == fresh.size();
  for (std::size_t c = 0; result && c != cells.size(); ++c)
    result = cells[c].vertices == fresh[c].vertices && cells[c].neighbors == fresh[c].neighbors;
  return result;
}

void test_sets(const std::vector<in::Local_point>& positions)
{
  in::No_cancellation cancellation_point;
  const std::size_t n = positions.size();
  in::Kept_triangulation kept(positions);
  auto sites = std::make_unique<in::Site_triangulation>(positions);
  sites->insert(all_but(n, 2, 29), cancellation_point);
  kept.adopt(std::move(sites));
  // Some of each are removed, or too many to be.
  for (const Points& points : { all_but(n, 3, 31), all_but(n, n, 1), all_but(n, 0, 37), all_but(n, 0, 2),
                                all_but(n, 1, 41), all_but(n, n / 3, 1), all_but(n, 5, 43) })
    ISR_CHECK(are_cells_of(*kept(points, cancellation_point), positions, points));
  const Points points = all_but(n, 5, 43);
  const auto cells = kept(points, cancellation_point);
  ISR_CHECK(kept(points, cancellation_point) == cells);
  kept.clear();
  ISR_CHECK(are_cells_of(*kept(points, cancellation_point), positions, points));
}

} // namespace

int main()
{
  begin_case("random points");
  test_sets(random_points(700));
  begin_case("grid");
  test_sets(grid_points(8));
  return result();
}

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

// The bending energy of labels and the search that lowers it.

#include "isr_test_samples.h"
#include "isr_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Bending_energy.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Label_search.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Lost_corners.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/validation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

using namespace isr_test;
namespace isr_internal = CGAL::Interpolating_surface_reconstruction_3::internal;
namespace validation = isr_internal::validation;
using isr_internal::Bending_energy;
using isr_internal::Cell_complex;
using isr_internal::Label_search;
using isr_internal::Local_point;
using isr_internal::Local_vector;
using isr_internal::Lost_corners;
using isr_internal::No_cancellation;
using isr_internal::Search_effort;
using Cell_index = Cell_complex::Cell_index;
using Point_index = isr_internal::Point_index;

namespace {

constexpr double PI = 3.14159265358979323846;

// Labels without any energy of their own.
class Labels
{
public:
  explicit Labels(const Cell_complex& cells) : m_cells(cells), m_labels(cells.size(), false) { }
  bool label(Cell_index c) const { return m_labels[c]; }
  void flip(Cell_index c) { m_labels[c] = !m_labels[c]; }
  bool is_surface(Cell_index c, std::size_t i) const { return m_labels[c] != m_labels[m_cells[c].neighbors[i]]; }
  const std::vector<bool>& all() const { return m_labels; }

private:
  const Cell_complex& m_cells;
  std::vector<bool> m_labels;
};

struct Sample
{
  explicit Sample(const Points& points)
    : positions(positions_of(points)), cells(positions, indices(points.size())), labels(cells)
  { }

  static std::vector<Local_point> positions_of(const Points& points)
  {
    std::vector<Local_point> result;
    for (const Point& p : points)
      result.emplace_back(p.x(), p.y(), p.z());
    return result;
  }

  static std::vector<Point_index> indices(std::size_t n)
  {
    std::vector<Point_index> result(n);
    std::iota(result.begin(), result.end(), Point_index(0));
    return result;
  }

  bool is_finite(Cell_index c) const { return !Cell_complex::is_infinite(cells[c]); }

  void fill()
  {
    for (Cell_index c = 0; c != cells.size(); ++c)
      if (is_finite(c) && !labels.label(c))
        labels.flip(c);
  }

  Local_vector center(Cell_index c) const
  {
    Local_vector sum(0, 0, 0);
    for (Point_index p : cells[c].vertices)
      sum = sum + (positions[p] - Local_point(0, 0, 0)) / 4.;
    return sum;
  }

  std::vector<Local_point> positions;
  Cell_complex cells;
  Labels labels;
};

// The facets between the labels, or all of them, but no infinite ones.
std::vector<std::array<Point_index, 3> > facets_of(const Sample& s, bool is_surface)
{
  std::vector<std::array<Point_index, 3> > result;
  for (Cell_index c = 0; c != s.cells.size(); ++c)
    for (std::size_t i = 0; i != 4; ++i)
      if (s.cells[c].neighbors[i] > c && (!is_surface || s.labels.is_surface(c, i)) &&
          !Cell_complex::is_infinite(Cell_complex::facet(s.cells[c], i)))
        result.push_back(Cell_complex::facet(s.cells[c], i));
  return result;
}

double distance(const Sample& s, Point_index p, Point_index q)
{
  return std::sqrt((s.positions[p] - s.positions[q]).squared_length());
}

int defects_at(const Sample& s, Point_index p)
{
  validation::Disjoint_sets sets(s.cells.size());
  std::set<std::size_t> roots;
  for (const bool is_joined : { false, true })
    for (Cell_index c = 0; c != s.cells.size(); ++c) {
      const auto& vertices = s.cells[c].vertices;
      if (std::count(vertices.begin(), vertices.end(), p) == 0)
        continue;
      if (is_joined)
        roots.insert(sets.find(c));
      else
        for (std::size_t i = 0; i != 4; ++i)
          if (vertices[i] != p && !s.labels.is_surface(c, i))
            sets.unite(c, s.cells[c].neighbors[i]);
    }
  return roots.size() == 1 ? 1 : static_cast<int>(roots.size()) - 2;
}

int number_of_defects(const Sample& s)
{
  int result = 0;
  for (Point_index p = 0; p != s.positions.size(); ++p)
    result += defects_at(s, p);
  return result;
}

// Three times the mean length of the edges of the surface at each point.
std::vector<double> costs_of_defects(const Sample& s)
{
  std::vector<double> result(s.positions.size(), 0.);
  for (Point_index p = 0; p != result.size(); ++p)
    for (const bool is_surface : { true, false }) {
      double sum = 0., edges = 0.;
      for (const auto& f : facets_of(s, is_surface))
        if (std::count(f.begin(), f.end(), p) != 0)
          for (Point_index q : f)
            if (q != p) {
              sum += distance(s, p, q);
              edges += 1.;
            }
      if (edges != 0. && result[p] == 0.)
        result[p] = 3. * sum / edges;
    }
  return result;
}

// The points of the surface that are lost corners, and of which it is a manifold.
std::vector<Point_index> lost_corners(const Sample& s)
{
  std::vector<std::array<Point_index, 3> > triangles;
  for (Cell_index c = 0; c != s.cells.size(); ++c)
    for (std::size_t i = 0; i != 4; ++i)
      if (s.labels.label(c) && s.labels.is_surface(c, i)) {
        triangles.push_back(Cell_complex::facet(s.cells[c], i));
        if (i % 2 != 0)
          std::swap(triangles.back()[1], triangles.back()[2]);
      }
  const Lost_corners lost(s.positions, triangles);
  std::vector<Point_index> result;
  for (Point_index p = 0; p != s.positions.size(); ++p)
    if (lost.is_lost(p) && defects_at(s, p) == 0)
      result.push_back(p);
  return result;
}

// A tenth of the length of each edge of the surface and half of the square of its bending, and the defects.
double energy(const Sample& s, const std::vector<double>& costs)
{
  std::map<std::pair<Point_index, Point_index>, std::vector<Point_index> > edges;
  for (const auto& f : facets_of(s, true))
    for (std::size_t i = 0; i != 3; ++i)
      edges[std::minmax(f[i], f[(i + 1) % 3])].push_back(f[(i + 2) % 3]);
  double result = 0.;
  for (const auto& edge : edges) {
    const Point_index p = edge.first.first, q = edge.first.second;
    double bending = PI;
    if (edge.second.size() == 2) {
      const Local_vector e = (s.positions[q] - s.positions[p]) / distance(s, p, q);
      const auto direction = [&](Point_index r) {
        const Local_vector v = s.positions[r] - s.positions[p], w = v - (v * e) * e;
        return Local_vector(w / std::sqrt(w.squared_length()));
      };
      bending = PI - std::acos((std::max)(-1., direction(edge.second[0]) * direction(edge.second[1])));
    }
    result += double(edge.second.size() / 2) * distance(s, p, q) * (.1 + .5 * bending * bending);
  }
  for (Point_index p = 0; p != costs.size(); ++p)
    result += costs[p] * defects_at(s, p);
  return result;
}

int euler_characteristic(const Sample& s)
{
  std::set<Point_index> points;
  std::set<std::pair<Point_index, Point_index> > edges;
  const auto facets = facets_of(s, true);
  for (const auto& f : facets)
    for (std::size_t i = 0; i != 3; ++i) {
      points.insert(f[i]);
      edges.insert(std::minmax(f[i], f[(i + 1) % 3]));
    }
  return static_cast<int>(points.size() + facets.size()) - static_cast<int>(edges.size());
}

// An edge with as many cells around it as there are points on a circle.
Points spindle(std::size_t n)
{
  Points result{ Point(0, 0, .1), Point(0, 0, -.1) };
  for (std::size_t i = 0; i != n; ++i)
    result.push_back(on_circle(2. * PI * double(i) / double(n), 1., 0.));
  return result;
}

// What a change is said to cost is what the energy, computed anew, grows by.
void test_cost_of_change(const Points& points, std::uint64_t seed, bool counts_lost_corners)
{
  begin_case("cost of changes, seed " + std::to_string(seed) + (counts_lost_corners ? ", with lost corners" : ""));
  Sample s(points);
  s.fill();
  const std::vector<double> costs = costs_of_defects(s);
  Bending_energy<Labels> bending(
    s.cells, s.positions, s.labels, [&](Cell_index c) { return s.is_finite(c); },
    [](Cell_index, std::size_t) { return false; }, [](Point_index) { return true; }, No_cancellation());
  if (counts_lost_corners)
    bending.count_lost_corners([](Point_index) { return true; });
  Random random(seed);
  int changes_of_defects = 0, changes_of_corners = 0;
  std::vector<Point_index> corners;
  const auto total_energy = [&] {
    double result = energy(s, costs);
    corners = counts_lost_corners ? lost_corners(s) : std::vector<Point_index>();
    for (Point_index p : corners)
      result += costs[p];
    return result;
  };
  double before = total_energy();
  for (int i = 0; i != 60; ++i) {
    const Cell_index c = static_cast<Cell_index>(random.below(s.cells.size()));
    if (!s.is_finite(c))
      continue;
    const int defects = number_of_defects(s);
    const std::vector<Point_index> corners_before = corners;
    const double cost = bending.cost_of_change(c);
    const auto before_change = bending.change(c);
    const double after = total_energy();
    ISR_CHECK(std::abs(cost - (after - before)) < 1e-6);
    changes_of_defects += number_of_defects(s) != defects ? 1 : 0;
    changes_of_corners += corners != corners_before ? 1 : 0;
    // from a surface without defects again and again
    if (i % 3 != 0)
      bending.change_back(c, before_change);
    before = total_energy();
  }
  ISR_CHECK(changes_of_defects > 5);
  ISR_CHECK(!counts_lost_corners || changes_of_corners > 5);
}

void test_cost_of_change()
{
  const std::vector<Points> samples = { sphere_random(40, 1).points, random_cube(40, 2), sphere_random(40, 3).points,
                                        random_cube(40, 4), spindle(100) };
  for (std::uint64_t seed = 1; seed <= samples.size(); ++seed)
    test_cost_of_change(samples[seed - 1], seed, false);
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    test_cost_of_change(plate_with_bore(12), seed, true);
}

template <typename IsFree>
void search(Sample& s, Search_effort& effort, const IsFree& is_free)
{
  Label_search<Labels>(
    s.cells, s.positions, s.labels, is_free, is_free, [](Cell_index, std::size_t) { return false; },
    [](Point_index) { return true; }, No_cancellation())(effort, No_cancellation());
}

// A tunnel through a ball is closed, though no single change closes it.
void test_tunnel()
{
  for (std::uint64_t seed = 1; seed != 6; ++seed) {
    begin_case("tunnel, seed " + std::to_string(seed));
    Sample s(sphere_random(60, seed).points);
    s.fill();
    const std::vector<double> costs = costs_of_defects(s);
    const double best = energy(s, costs);
    for (Cell_index c = 0; c != s.cells.size(); ++c)
      if (s.is_finite(c) && std::hypot(s.center(c).x(), s.center(c).y()) < .3)
        s.labels.flip(c);
    const double before = energy(s, costs);
    ISR_CHECK(euler_characteristic(s) != 2 || number_of_defects(s) != 0);
    ISR_CHECK(before > best);
    const std::vector<bool> labels = s.labels.all();

    Search_effort effort{ 0, 0 };
    search(s, effort, [](Cell_index) { return true; });
    ISR_CHECK(s.labels.all() == labels);
    effort.all = 1000000;
    search(s, effort, [](Cell_index) { return false; });
    ISR_CHECK(s.labels.all() == labels);
    ISR_CHECK_EQUAL(effort.all, 1000000u);

    search(s, effort, [](Cell_index) { return true; });
    ISR_CHECK(effort.all < 1000000);
    ISR_CHECK_EQUAL(number_of_defects(s), 0);
    ISR_CHECK_EQUAL(euler_characteristic(s), 2);
    ISR_CHECK(energy(s, costs) <= best + 1e-9);
  }
}

// Where chains leave folds, kicks lower the energy further, the same way every time, and spend no more than they may.
void test_kicks()
{
  double without_kicks = 0., with_kicks = 0.;
  for (std::uint64_t seed = 1; seed != 5; ++seed) {
    begin_case("kicks, seed " + std::to_string(seed));
    constexpr std::size_t kicks = 50000;
    std::vector<std::vector<bool> > labels;
    for (const std::size_t effort_of_kicks : { std::size_t(0), kicks, kicks }) {
      Sample s(random_cube(150, seed));
      s.fill();
      const std::vector<double> costs = costs_of_defects(s);
      for (Cell_index c = 0; c != s.cells.size(); ++c)
        if (s.is_finite(c) && c % 2 == 0)
          s.labels.flip(c);
      Search_effort effort{ 1000000, effort_of_kicks };
      search(s, effort, [](Cell_index) { return true; });
      (effort_of_kicks == 0 ? without_kicks : with_kicks) += energy(s, costs);
      labels.push_back(s.labels.all());
      ISR_CHECK(effort.all > 0);
      ISR_CHECK_EQUAL(effort.of_kicks, 0u);
    }
    ISR_CHECK(labels[0] != labels[1]);
    ISR_CHECK(labels[1] == labels[2]);
  }
  ISR_CHECK(with_kicks / 2. < .95 * without_kicks);
}

// Components are small below 64 points.
void test_small_part()
{
  for (const std::size_t n : { std::size_t(40), std::size_t(100) }) {
    begin_case("two balls of " + std::to_string(n) + " points");
    Points points = sphere_random(n, 1).points;
    const Points other = translated(sphere_random(100, 2).points, Vector(5, 0, 0));
    points.insert(points.end(), other.begin(), other.end());
    Sample s(points);
    std::vector<Cell_index> in_first, in_both;
    for (Cell_index c = 0; c != s.cells.size(); ++c) {
      const auto& v = s.cells[c].vertices;
      const bool is_first = std::all_of(v.begin(), v.end(), [&](Point_index p) { return p < n; });
      const bool is_second = std::all_of(v.begin(), v.end(), [&](Point_index p) { return p >= n; });
      if (!s.is_finite(c) || !(is_first || is_second))
        continue;
      s.labels.flip(c);
      in_both.push_back(c);
      if (is_first)
        in_first.push_back(c);
    }
    isr_internal::Label_stars<Labels> stars(s.cells, s.labels);
    isr_internal::Small_surface_part<Labels> has_small_part(s.cells, s.labels, stars);
    ISR_CHECK(!has_small_part(in_first));
    ISR_CHECK(has_small_part(in_both) == (n == 40));
  }
}

} // namespace

int main()
{
  test_cost_of_change();
  test_tunnel();
  test_kicks();
  test_small_part();
  return isr_test::result();
}

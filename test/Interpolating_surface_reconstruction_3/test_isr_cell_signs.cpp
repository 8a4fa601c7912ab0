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

// Signs of cells, their labelling, its relaxation, and minimum cuts.

#include "isr_test_lis.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Label_stars.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Minimum_cut.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Regular_diagonals.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Surface_fans.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/cell_signs.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/label_components.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/label_minimum_cut.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/label_relaxation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelling_repair.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

using namespace isr_test;
namespace in = CGAL::Interpolating_surface_reconstruction_3::internal;
using Cell_index = in::Cell_complex::Cell_index;

namespace {

// Samples with their Delaunay cells.
struct Cells
{
  std::vector<in::Local_point> positions;
  std::vector<in::Local_vector> normals;
  in::Cell_complex cells;

  explicit Cells(const Oriented_points& samples)
    : positions(to_positions(samples)), normals(to_normals(samples)), cells(positions, all(samples.size()))
  { }

  static std::vector<in::Local_point> to_positions(const Oriented_points& samples)
  {
    std::vector<in::Local_point> result;
    for (const Oriented_point& s : samples)
      result.emplace_back(s.first.x(), s.first.y(), s.first.z());
    return result;
  }

  static std::vector<in::Local_vector> to_normals(const Oriented_points& samples)
  {
    std::vector<in::Local_vector> result;
    for (const Oriented_point& s : samples) {
      const in::Local_vector n(s.second.x(), s.second.y(), s.second.z());
      result.push_back(n / std::sqrt(n.squared_length()));
    }
    return result;
  }

  static std::vector<in::Point_index> all(std::size_t n)
  {
    std::vector<in::Point_index> result(n);
    std::iota(result.begin(), result.end(), in::Point_index(0));
    return result;
  }

  std::vector<float> signs() const { return in::Cell_signs(cells, positions, normals).compute<CGAL::Sequential_tag>(); }
};

Oriented_points sphere(std::size_t n)
{
  return with_normals(sphere_fibonacci(n).points, [](const Point& p) { return p - CGAL::ORIGIN; });
}

// In a cube, with normals in any direction.
Oriented_points random_samples(std::size_t n, std::uint64_t seed)
{
  Random random(seed + 1);
  Oriented_points samples;
  for (const Point& p : random_cube(n, seed))
    samples.emplace_back(p, random.unit());
  return samples;
}

// The repair of LIS: no loss is too large, and components stay.
in::Labelling_repair<in::Oriented_labelling> repair_of(const Cells& s, in::Oriented_labelling& labelling)
{
  return in::Labelling_repair<in::Oriented_labelling>(
    s.cells, labelling, [](in::Point_index) { return true; }, 1e300, true);
}

void test_signs()
{
  begin_case("signs in a sphere");
  const Cells s(sphere(600));
  const std::vector<float> signs = s.signs();
  for (std::size_t c = 0; c != s.cells.size(); ++c)
    ISR_CHECK((signs[c] > 0.f) == in::Cell_complex::is_infinite(s.cells[c]));
  ISR_CHECK((in::Cell_signs(s.cells, s.positions, s.normals).compute<CGAL::Parallel_if_available_tag>() == signs));

  begin_case("signs between two spheres, of which the inner one is a void");
  Oriented_points shell = sphere(600);
  for (const Oriented_point& p : sphere(300))
    shell.emplace_back(CGAL::ORIGIN + .6 * (p.first - CGAL::ORIGIN), -p.second);
  const Cells t(shell);
  const std::vector<float> values = t.signs();
  for (std::size_t c = 0; c != t.cells.size(); ++c) {
    if (in::Cell_complex::is_infinite(t.cells[c]))
      continue;
    std::size_t inner = 0;
    for (in::Point_index p : t.cells[c].vertices)
      inner += p >= 600 ? 1u : 0u;
    ISR_CHECK((values[c] > 0.f) == (inner == 4));
  }
}

// The sum of the energies of all facets, part of their area less the flux of the normals, and of all cells.
double energy(const Cells& s, const std::vector<float>& values, const in::Oriented_labelling& labelling)
{
  double result = 0.;
  for (Cell_index c = 0; c != s.cells.size(); ++c) {
    double area = 0.;
    for (std::size_t i = 0; i != 4; ++i) {
      const auto f = in::Cell_complex::facet(s.cells[c], i);
      if (in::Cell_complex::is_infinite(f))
        continue;
      in::Local_vector n =
        CGAL::cross_product(s.positions[f[1]] - s.positions[f[0]], s.positions[f[2]] - s.positions[f[0]]) / 2;
      const double size = std::sqrt(n.squared_length());
      area += size;
      if (!in::Cell_complex::is_infinite(s.cells[c]) &&
          n * (s.positions[s.cells[c].vertices[i]] - s.positions[f[0]]) > 0.)
        n = -n;
      if (labelling.label(c) && labelling.is_surface(c, i))
        result += .7 * size - n * (s.normals[f[0]] + s.normals[f[1]] + s.normals[f[2]]) / 3;
    }
    if (!in::Cell_complex::is_infinite(s.cells[c]) && labelling.label(c) != (values[c] < 0.f))
      result += std::abs(double(values[c])) * area;
  }
  return result;
}

void test_gain()
{
  begin_case("gains are differences of the energy");
  const Cells s(random_samples(60, 2));
  const std::vector<float> values = s.signs();
  in::Oriented_labelling labelling(s.cells, s.positions, s.normals, values);
  std::size_t settled = 0;
  for (Cell_index c = 0; c != s.cells.size(); ++c) {
    if (in::Cell_complex::is_infinite(s.cells[c])) {
      ISR_CHECK_EQUAL(labelling.gain(c), -std::numeric_limits<double>::infinity());
      continue;
    }
    const double gain = labelling.gain(c), before = energy(s, values, labelling);
    ISR_CHECK(labelling.may_gain(c) || gain < 0.);
    settled += labelling.may_gain(c) ? 0u : 1u;
    labelling.flip(c);
    ISR_CHECK(std::abs(before - energy(s, values, labelling) - gain) < 1e-6);
    ISR_CHECK(std::abs(labelling.gain(c) + gain) < 1e-9);
    if (c % 2 == 0)
      labelling.flip(c);
  }
  ISR_CHECK(settled != 0);

  begin_case("relaxation ends where no cell wins");
  const double before = energy(s, values, labelling);
  in::relax_labels(s.cells, labelling, in::No_cancellation());
  ISR_CHECK(energy(s, values, labelling) < before);
  for (Cell_index c = 0; c != s.cells.size(); ++c)
    ISR_CHECK(labelling.gain(c) <= labelling.smallest_gain(c));

  begin_case("repair makes any labelling a manifold");
  in::Labelling_repair<in::Oriented_labelling> repair = repair_of(s, labelling);
  repair();
  repair.enforce(in::No_cancellation());
  Triples triples;
  for (Cell_index c = 0; c != s.cells.size(); ++c)
    for (std::size_t i = 0; i != 4; ++i)
      if (labelling.label(c) && labelling.is_surface(c, i)) {
        const auto f = in::Cell_complex::facet(s.cells[c], i);
        triples.push_back(i % 2 == 0 ? Triple{ f[0], f[1], f[2] } : Triple{ f[0], f[2], f[1] });
      }
  ISR_CHECK(validation::is_vertex_manifold(triples));
  ISR_CHECK(validation::is_consistently_oriented(triples));
  ISR_CHECK(validation::boundary_edges(triples).empty());
}

// Points around which the cells have more than two components of equal labels.
std::size_t number_of_tangles(const Cells& s, const in::Oriented_labelling& labelling)
{
  in::Label_components<in::Oriented_labelling> components(s.cells, labelling);
  std::vector<Cell_index> cell_of(s.positions.size());
  for (Cell_index c = 0; c != s.cells.size(); ++c)
    for (in::Point_index p : s.cells[c].vertices)
      if (p != in::NO_POINT)
        cell_of[p] = c;
  std::size_t result = 0;
  for (in::Point_index p = 0; p != s.positions.size(); ++p)
    result += components.find(p, cell_of[p]) > 2 ? 1u : 0u;
  return result;
}

void test_untangling()
{
  begin_case("sequences of moves where single ones do not help");
  const Cells s(random_samples(2000, 4));
  in::Oriented_labelling labelling(s.cells, s.positions, s.normals, s.signs());
  in::relax_labels(s.cells, labelling, in::No_cancellation());
  in::Labelling_repair<in::Oriented_labelling> repair = repair_of(s, labelling);
  repair();
  const std::size_t before = number_of_tangles(s, labelling);
  ISR_CHECK(before > 10);
  repair.untangle(in::No_cancellation());
  const std::size_t after = number_of_tangles(s, labelling);
  ISR_CHECK(10 * after <= before);
  repair.enforce(in::No_cancellation());
  ISR_CHECK_EQUAL(number_of_tangles(s, labelling), 0u);
  std::vector<unsigned char> is_used(s.positions.size(), 0);
  for (Cell_index c = 0; c != s.cells.size(); ++c)
    for (std::size_t i = 0; i != 4; ++i)
      if (labelling.label(c) && labelling.is_surface(c, i))
        for (in::Point_index p : in::Cell_complex::facet(s.cells[c], i))
          is_used[p] = 1;
  ISR_CHECK(std::count(is_used.begin(), is_used.end(), 0) < 20);
}

// Stars count the components that a search over the cells finds, and fans are closed where there are two.
void test_stars_and_fans()
{
  begin_case("stars of cells and fans of facets");
  for (double part_inside : { .1, .5, .9, 1.01 }) {
    const Cells s(random_samples(500, 5));
    in::Oriented_labelling labelling(s.cells, s.positions, s.normals, s.signs());
    Random random(6);
    std::vector<Cell_index> cell_of(s.positions.size());
    for (Cell_index c = 0; c != s.cells.size(); ++c) {
      if (labelling.label(c) != (random.uniform(0., 1.) < part_inside))
        labelling.flip(c);
      for (in::Point_index p : s.cells[c].vertices)
        if (p != in::NO_POINT)
          cell_of[p] = c;
    }
    in::Label_components<in::Oriented_labelling> components(s.cells, labelling);
    in::Label_stars<in::Oriented_labelling> stars(s.cells, labelling);
    const in::No_cancellation no_cancellation;
    const in::Surface_fans fans(s.cells, labelling, no_cancellation);
    for (in::Point_index p = 0; p != s.positions.size(); ++p) {
      const std::size_t number = components.find(p, cell_of[p]);
      ISR_CHECK_EQUAL(stars.find_components(p), number);
      ISR_CHECK(fans.is_closed(p) == (number == 2));
      std::vector<std::vector<Cell_index> > found(number);
      for (std::size_t k = 0; k != stars.size(); ++k)
        found[stars.component(k)].push_back(stars.cell(k));
      ISR_CHECK(found == components.sorted(number));
    }
  }
}

// Stars that are told of changes know the labels; what changes for a question only is not kept.
void test_stars_after_changes()
{
  begin_case("stars of cells whose labels change");
  const Cells s(random_samples(500, 8));
  in::Oriented_labelling labelling(s.cells, s.positions, s.normals, s.signs());
  in::Label_stars<in::Oriented_labelling> stars(s.cells, labelling);
  Random random(9);
  int differences = 0;
  for (int change = 0; change != 3000; ++change) {
    const auto c = static_cast<Cell_index>(random.below(s.cells.size()));
    std::array<std::size_t, 4> expected{};
    for (std::size_t i = 0; i != 4; ++i)
      if (s.cells[c].vertices[i] != in::NO_POINT) {
        const std::size_t before = stars.count_components(s.cells[c].vertices[i]);
        expected[i] = stars.count_components(s.cells[c].vertices[i], c);
        ISR_CHECK_EQUAL(stars.count_components(s.cells[c].vertices[i]), before);
        differences += expected[i] != before ? 1 : 0;
      }
    labelling.flip(c);
    stars.flip(c);
    in::Label_components<in::Oriented_labelling> components(s.cells, labelling);
    for (std::size_t i = 0; i != 4; ++i)
      if (s.cells[c].vertices[i] != in::NO_POINT) {
        ISR_CHECK_EQUAL(stars.count_components(s.cells[c].vertices[i]), expected[i]);
        ISR_CHECK_EQUAL(components.find(s.cells[c].vertices[i], c), expected[i]);
      }
  }
  ISR_CHECK(differences > 1000);
}

// Of a labelling of nodes by the bits of a number.
float cost_of(unsigned labels, const std::vector<float>& inside_costs,
              const std::vector<in::Minimum_cut::Pair_cost>& pairs)
{
  const auto is_inside = [labels](std::size_t v) { return (labels >> v & 1u) != 0; };
  float result = 0.f;
  for (std::size_t v = 0; v != inside_costs.size(); ++v)
    result += is_inside(v) ? inside_costs[v] : 0.f;
  for (const auto& p : pairs)
    result += is_inside(p.inside) && !is_inside(p.outside) ? p.cost : 0.f;
  return result;
}

// All labellings of small graphs are tried. Costs are small integers, so that several often have the least sum.
void test_least_cut()
{
  begin_case("least of all cuts");
  constexpr std::size_t NODES = 9, MAXIMUM_DEGREE = 4;
  Random random(7);
  for (int graph = 0; graph != 500; ++graph) {
    std::vector<float> inside_costs;
    for (std::size_t v = 0; v != NODES; ++v)
      inside_costs.push_back(float(random.below(13)) - 6.f);
    std::vector<in::Minimum_cut::Pair_cost> pairs;
    std::array<std::size_t, NODES> degree{};
    for (int k = 0; k != 40; ++k) {
      const auto v = std::uint32_t(random.below(NODES)), w = std::uint32_t(random.below(NODES));
      if (v == w || degree[v] == MAXIMUM_DEGREE || degree[w] == MAXIMUM_DEGREE)
        continue;
      ++degree[v];
      ++degree[w];
      pairs.push_back(in::Minimum_cut::Pair_cost{ v, w, float(random.below(6)) });
    }
    // Of the labellings with the least sum, the one whose inside is part of all others'.
    unsigned least = 0;
    for (unsigned labels = 1; labels != 1u << NODES; ++labels) {
      const float difference = cost_of(labels, inside_costs, pairs) - cost_of(least, inside_costs, pairs);
      least = difference < 0.f ? labels : difference > 0.f ? least : least & labels;
    }
    const std::vector<unsigned char> is_inside = in::Minimum_cut(inside_costs, pairs)(in::No_cancellation());
    unsigned found = 0;
    for (std::size_t v = 0; v != NODES; ++v)
      found |= is_inside[v] != 0 ? 1u << v : 0u;
    ISR_CHECK_EQUAL(found, least);
  }
}

// A wall of wrong labels in the gap between two boxes is removed by the cut.
void test_minimum_cut()
{
  begin_case("minimum cut");
  Oriented_points samples;
  for (double x : { 0., 6.5 })
    for (const Point& p : box(6, 6, 6).points)
      samples.emplace_back(p + Vector(x, 0, 0), normal_of_box(p, Point(0, 0, 0), Point(6, 6, 6)));
  const Cells s(samples);
  in::Oriented_labelling labelling(s.cells, s.positions, s.normals, s.signs());
  in::relax_labels(s.cells, labelling, in::No_cancellation());
  in::Labelling_repair<in::Oriented_labelling> repair = repair_of(s, labelling);
  repair();
  const auto labelled_inside_gap = [&] {
    std::size_t result = 0;
    for (Cell_index c = 0; c != s.cells.size(); ++c) {
      if (!labelling.label(c))
        continue;
      std::size_t right = 0;
      for (in::Point_index p : s.cells[c].vertices)
        right += s.positions[p].x() > 6.2 ? 1u : 0u;
      result += right != 0 && right != 4 ? 1u : 0u;
    }
    return result;
  };
  // the averaged normals at the edges mislead the signs at the corners of the gap
  ISR_CHECK(labelled_inside_gap() > 0);
  in::Label_minimum_cut cut(s.cells, labelling);
  cut(repair, in::No_cancellation());
  ISR_CHECK_EQUAL(labelled_inside_gap(), 0u);
  ISR_CHECK_EQUAL(repair(), 0u);
}

// The facets of a noisy sheet that face against the normals are no passages: a cut would only take tips away.
void test_minimum_cut_of_noise()
{
  begin_case("minimum cut of a single noisy sheet");
  Random random(8);
  Oriented_points samples = sphere(2000);
  for (Oriented_point& p : samples)
    p.first = CGAL::ORIGIN + random.uniform(.9, 1.1) * (p.first - CGAL::ORIGIN);
  const Cells s(samples);
  in::Oriented_labelling labelling(s.cells, s.positions, s.normals, s.signs());
  in::relax_labels(s.cells, labelling, in::No_cancellation());
  in::Labelling_repair<in::Oriented_labelling> repair = repair_of(s, labelling);
  repair();
  std::vector<bool> before;
  bool faces_against_normals = false;
  for (Cell_index c = 0; c != s.cells.size(); ++c) {
    before.push_back(labelling.label(c));
    for (std::size_t i = 0; i != 4; ++i)
      faces_against_normals = faces_against_normals || (labelling.label(c) && labelling.is_surface(c, i) &&
                                                        labelling.faces_by_less_than(0., c, i));
  }
  ISR_CHECK(faces_against_normals);
  in::Label_minimum_cut cut(s.cells, labelling);
  cut(repair, in::No_cancellation());
  std::size_t changed = 0;
  for (Cell_index c = 0; c != s.cells.size(); ++c)
    changed += labelling.label(c) != before[c] ? 1u : 0u;
  ISR_CHECK_EQUAL(changed, 0u);
}

// A box with a roof over a rhombus, the shorter diagonal of which, from 0 to 2, is `height` above the longer one.
Oriented_points box_with_rhombus(double height)
{
  const Point corners[] = { Point(-.9, 0, height), Point(0, -1, 0), Point(.9, 0, height), Point(0, 1, 0) };
  Oriented_points samples;
  for (const Point& p : corners)
    samples.emplace_back(p, Vector(0, 0, 1) + (p.z() == 0. ? Vector(0, 0, 0) : -height * (p - CGAL::ORIGIN)));
  for (double x : { -1., 1. })
    for (double y : { -1., 1. })
      samples.emplace_back(Point(x, y, -2), Vector(x, y, -1));
  return samples;
}

// Of a box with a rhombus. All finite cells are inside, and with them the flat one over the rhombus, so that the longer
// diagonal is on the surface.
struct Labelled_box : Cells
{
  explicit Labelled_box(double height)
    : Cells(box_with_rhombus(height)), labelling(cells, positions, normals, std::vector<float>(cells.size(), 0.f))
  {
    for (Cell_index c = 0; c != cells.size(); ++c) {
      if (!in::Cell_complex::is_infinite(cells[c]))
        labelling.flip(c);
      if (has(c, 0) && has(c, 1) && has(c, 2) && has(c, 3))
        rhombus = c;
    }
  }

  bool has(Cell_index c, in::Point_index p) const
  {
    return std::count(cells[c].vertices.begin(), cells[c].vertices.end(), p) != 0;
  }

  std::size_t facets_of_rhombus() const
  {
    std::size_t facets = 0;
    for (std::size_t i = 0; i != 4; ++i)
      facets += labelling.is_surface(rhombus, i) ? 1u : 0u;
    return facets;
  }

  in::Oriented_labelling labelling;
  Cell_index rhombus = in::Cell_complex::NO_CELL;
};

void test_regular_diagonals()
{
  for (bool is_inside_first : { true, false }) {
    begin_case("the shorter diagonal of a rhombus that is nearly flat");
    Labelled_box s(-.02);
    ISR_CHECK(s.rhombus != in::Cell_complex::NO_CELL);
    if (!is_inside_first)
      s.labelling.flip(s.rhombus);
    ISR_CHECK_EQUAL(s.facets_of_rhombus(), 2u);
    in::Regular_diagonals diagonals(s.cells, s.positions, s.labelling);
    in::relax_labels(s.cells, diagonals, in::No_cancellation());
    ISR_CHECK(!s.labelling.label(s.rhombus));
    ISR_CHECK_EQUAL(s.facets_of_rhombus(), 2u);
  }

  begin_case("a ridge along the longer diagonal stays");
  Labelled_box ridge(-.8);
  ISR_CHECK(ridge.rhombus != in::Cell_complex::NO_CELL);
  in::Regular_diagonals diagonals(ridge.cells, ridge.positions, ridge.labelling);
  in::relax_labels(ridge.cells, diagonals, in::No_cancellation());
  ISR_CHECK(ridge.labelling.label(ridge.rhombus));

  begin_case("a diagonal that is an edge of the surface already");
  Labelled_box tunnel(-.02);
  in::Regular_diagonals over_tunnel(tunnel.cells, tunnel.positions, tunnel.labelling);
  ISR_CHECK(over_tunnel.gain(tunnel.rhombus) > 0.);
  std::size_t cells_of_tunnel = 0;
  for (Cell_index c = 0; c != tunnel.cells.size(); ++c)
    if (tunnel.has(c, 0) && tunnel.has(c, 2) && !tunnel.has(c, 1) && !tunnel.has(c, 3)) {
      tunnel.labelling.flip(c);
      ++cells_of_tunnel;
    }
  ISR_CHECK(cells_of_tunnel > 0);
  ISR_CHECK_EQUAL(tunnel.facets_of_rhombus(), 2u);
  ISR_CHECK_EQUAL(over_tunnel.gain(tunnel.rhombus), 0.);
}

} // namespace

int main()
{
  test_signs();
  test_gain();
  test_untangling();
  test_stars_and_fans();
  test_stars_after_changes();
  test_least_cut();
  test_minimum_cut();
  test_minimum_cut_of_noise();
  test_regular_diagonals();
  return result();
}

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

// Values outside of a parameter's range throw before anything is written; ranges and maps of many kinds.

#include "isr_test_ctc.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/Surface_mesh.h>

#include <deque>
#include <limits>
#include <list>
#include <stdexcept>

using namespace isr_test;

template <typename NamedParameters>
void check_throws(const std::string& parameter, const Points& points, const NamedParameters& np)
{
  Triples triples = { Triple{ 7, 8, 9 } };
  std::string message;
  try {
    CGAL::ctc_reconstruction(points, std::back_inserter(triples), np);
  } catch (const std::invalid_argument& e) {
    message = e.what();
  }
  ISR_CHECK(message.find(parameter) != std::string::npos);
  ISR_CHECK_EQUAL(triples.size(), 1u);
  CGAL::Surface_mesh<Point> mesh;
  message.clear();
  try {
    CGAL::ctc_reconstruction(points, mesh, np);
  } catch (const std::invalid_argument& e) {
    message = e.what();
  }
  ISR_CHECK(message.find(parameter) != std::string::npos);
  ISR_CHECK(mesh.is_empty());
}

// Also where there is no surface to reconstruct.
void test_neighbor_radius(const Points& points)
{
  begin_case("bad neighbor_radius, " + std::to_string(points.size()) + " points");
  check_throws("neighbor_radius", points, params::neighbor_radius(-1.));
  check_throws("neighbor_radius", points, params::neighbor_radius(-std::numeric_limits<double>::infinity()));
  check_throws("neighbor_radius", points, params::neighbor_radius(std::numeric_limits<double>::quiet_NaN()));
  check_throws("neighbor_radius", points,
               params::combine(params::keep_boundaries(true), params::neighbor_radius(-1e-300)));
}

void test_maximum_hole_size(const Points& points)
{
  begin_case("bad maximum_hole_size, " + std::to_string(points.size()) + " points");
  check_throws("maximum_hole_size", points, params::maximum_hole_size(-1));
}

// The order of combined parameters and their number do not matter.
void test_combinations()
{
  begin_case("combinations of parameters");
  const Points points = cylinder_open(12, 30).points;
  const Triples expected = ctc(points, params::maximum_hole_size(std::size_t(0)));
  Counting_visitor visitor;
  const std::function<bool(double)> callback = [](double) { return true; };
  ISR_CHECK(ctc(points, params::combine(params::maximum_hole_size(std::size_t(0)),
                                        params::callback(callback).neighbor_radius(0.),
                                        params::visitor(std::ref(visitor)).geom_traits(Kernel()),
                                        params::keep_boundaries(false))) == expected);
  ISR_CHECK(ctc(points, params::combine(params::keep_boundaries(false), params::visitor(std::ref(visitor)),
                                        params::maximum_hole_size(0))) == expected);
  ISR_CHECK(ctc(points, params::maximum_hole_size(0).callback(callback)) == expected);
  ISR_CHECK(ctc(points, params::callback(std::function<bool(double)>())) == ctc(points));
  ISR_CHECK(ctc(points, params::default_values()) == ctc(points));
}

template <typename PointRange>
void check_range(const std::string& name, const PointRange& range, const Triples& expected)
{
  begin_case(name);
  Triples triples;
  CGAL::ctc_reconstruction(range, std::back_inserter(triples));
  ISR_CHECK(triples == expected);
}

void test_ranges()
{
  const Points points = sphere_fibonacci(200).points;
  const Triples expected = ctc(points);
  check_range("list", std::list<Point>(points.begin(), points.end()), expected);
  check_range("deque", std::deque<Point>(points.begin(), points.end()), expected);
  check_range("iterator range", CGAL::make_range(points.begin(), points.end()), expected);
  begin_case("pointers through a map");
  std::vector<std::size_t> indices(points.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  ISR_CHECK(ctc(indices, params::point_map(CGAL::make_property_map(points))) == expected);
  begin_case("Point_set_3");
  CGAL::Point_set_3<Point> set;
  for (const Point& p : points)
    set.insert(p);
  ISR_CHECK(ctc(set, set.parameters()) == expected);
  ISR_CHECK(ctc(set, params::combine(set.parameters(), params::keep_boundaries(false))) == expected);
}

void test_output_iterator()
{
  begin_case("output iterator is passed back");
  const Points points = sphere_fibonacci(200).points;
  Triples triples(ctc(points).size() + 1);
  const auto end = CGAL::ctc_reconstruction(points, triples.begin());
  ISR_CHECK(end == triples.end() - 1);
}

int main()
{
  for (const Points& points : { Points(), sphere_fibonacci(200).points }) {
    test_neighbor_radius(points);
    test_maximum_hole_size(points);
  }
  test_combinations();
  test_ranges();
  test_output_iterator();
  return result();
}

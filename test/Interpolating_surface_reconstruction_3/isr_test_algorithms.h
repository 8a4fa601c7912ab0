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

#ifndef ISR_TEST_ALGORITHMS_H
#define ISR_TEST_ALGORITHMS_H

#include "isr_test_reconstruction.h"
#include "isr_test_self_intersections.h"

#include <CGAL/ctc_reconstruction.h>
#include <CGAL/lis_reconstruction.h>
#include <CGAL/pcr_reconstruction.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace isr_test {

// The public functions as types, for tests that hold for each of them.
struct Ctc
{
  static std::string name() { return "CTC"; }

  template <typename ConcurrencyTag = CGAL::Sequential_tag, typename PointRange, typename Output,
            typename NamedParameters>
  static auto reconstruct(const PointRange& points, Output&& output, const NamedParameters& np)
  {
    return CGAL::ctc_reconstruction<ConcurrencyTag>(points, std::forward<Output>(output), np);
  }
};

struct Pcr
{
  static std::string name() { return "PCR"; }

  template <typename ConcurrencyTag = CGAL::Sequential_tag, typename PointRange, typename Output,
            typename NamedParameters>
  static auto reconstruct(const PointRange& points, Output&& output, const NamedParameters& np)
  {
    return CGAL::pcr_reconstruction<ConcurrencyTag>(points, std::forward<Output>(output), np);
  }
};

// Normals as a function of the position, or none.
struct Normal_map
{
  using key_type = Point;
  using value_type = Vector;
  using reference = Vector;
  using category = boost::readable_property_map_tag;
  friend Vector get(const Normal_map& map, const Point& p) { return map.normal_at(p); }
  operator bool() const { return static_cast<bool>(normal_at); }
  std::function<Vector(const Point&)> normal_at;
};

// The first position of each finite point.
inline std::map<Point, std::size_t> positions_of_finite(const Points& points)
{
  std::map<Point, std::size_t> result;
  for (std::size_t i = 0; i != points.size(); ++i)
    if (std::isfinite(points[i].x()) && std::isfinite(points[i].y()) && std::isfinite(points[i].z()))
      result.emplace(points[i], i);
  return result;
}

// LIS with the result of Normals::map(points), and triangles of positions in `points`.
template <typename Normals>
struct Lis
{
  static std::string name() { return "LIS, " + Normals::name(); }

  template <typename ConcurrencyTag = CGAL::Sequential_tag, typename Output, typename NamedParameters>
  static void reconstruct(const Points& points, Output&& output, const NamedParameters& np)
  {
    const auto all = params::combine(np, params::normal_map(Normals::map(points)));
    if constexpr (std::is_same<std::decay_t<Output>, CGAL::Surface_mesh<Point> >::value) {
      CGAL::lis_reconstruction<ConcurrencyTag>(points, output, all);
    } else {
      Points vertices;
      const std::map<Point, std::size_t> positions = positions_of_finite(points);
      Sink<std::decay_t<Output> > sink{ output, vertices, positions };
      CGAL::lis_reconstruction<ConcurrencyTag>(points, vertices, sink, all);
    }
  }

private:
  // A range of triangles that passes them on.
  template <typename Output>
  struct Sink
  {
    using value_type = Triple;
    using iterator = Triple*;
    using const_iterator = const Triple*;
    void push_back(const Triple& t)
    {
      *output++ = Triple{ positions.at(vertices[t[0]]), positions.at(vertices[t[1]]), positions.at(vertices[t[2]]) };
    }
    Output output;
    const Points& vertices;
    const std::map<Point, std::size_t>& positions;
  };
};

struct No_normals
{
  static std::string name() { return "no normals"; }
  static Normal_map map(const Points&) { return Normal_map(); }
};

// Exact for spheres around the origin, and quite wrong for most other surfaces.
struct Radial_normals
{
  static std::string name() { return "radial normals"; }
  static Vector normal_at(const Point& p) { return p == CGAL::ORIGIN ? Vector(0, 0, 1) : p - CGAL::ORIGIN; }
  static Normal_map map(const Points&) { return Normal_map{ normal_at }; }
};

// Those of planes fitted to neighbors, away from the origin; they depend on the order of points at
// equal distances.
struct Plane_normals
{
  static std::string name() { return "normals of planes"; }

  static Normal_map map(const Points& points)
  {
    constexpr unsigned int NEIGHBORS = 10;
    using Oriented = std::pair<Point, Vector>;
    std::vector<Oriented> samples;
    double largest = 0.;
    for (const auto& p : positions_of_finite(points)) {
      samples.emplace_back(p.first, Vector(0, 0, 0));
      largest = (std::max)({ largest, std::abs(p.first.x()), std::abs(p.first.y()), std::abs(p.first.z()) });
    }
    // far from the ends of the range of double
    const auto scaled_point = [&](const Point& p) { return Point(p.x() / largest, p.y() / largest, p.z() / largest); };
    if (samples.size() > NEIGHBORS)
      CGAL::pca_estimate_normals<CGAL::Sequential_tag>(
        samples, NEIGHBORS,
        params::point_map(
          boost::make_function_property_map<Oriented>([&](const Oriented& s) { return scaled_point(s.first); }))
          .normal_map(CGAL::Second_of_pair_property_map<Oriented>()));
    const auto normals = std::make_shared<std::map<Point, Vector> >(samples.begin(), samples.end());
    return Normal_map{ [normals](const Point& p) {
      const Vector n = normals->at(p);
      return n * Radial_normals::normal_at(p) < 0. ? -n : n;
    } };
  }
};

// Calls test(algorithm) with an object of each type above that is named in the arguments, or with
// all if none is.
template <typename Test>
void for_each_algorithm(int argc, char** argv, Test test)
{
  const std::vector<std::string> names(argv + 1, argv + argc);
  const auto is_chosen = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const bool is_any_chosen = is_chosen("CTC") || is_chosen("PCR") || is_chosen("LIS");
  if (!is_any_chosen || is_chosen("CTC"))
    test(Ctc());
  if (!is_any_chosen || is_chosen("PCR"))
    test(Pcr());
  if (!is_any_chosen || is_chosen("LIS")) {
    test(Lis<No_normals>());
    test(Lis<Radial_normals>());
  }
}

template <typename Algorithm, typename ConcurrencyTag = CGAL::Sequential_tag, typename NamedParameters>
Triples triangles_of(Algorithm, const Points& points, const NamedParameters& np)
{
  Triples triples;
  Algorithm::template reconstruct<ConcurrencyTag>(points, std::back_inserter(triples), np);
  return triples;
}

template <typename Algorithm>
Triples triangles_of(Algorithm algorithm, const Points& points)
{
  return triangles_of(algorithm, points, params::neighbor_radius(0.));
}

// What the visitor is told, with a bound on the work.
struct Accounting_visitor : Counting_visitor
{
  std::size_t proposals = 0;
  bool has_cells = false;
  void on_triangle(const Triple&, isr::Triangle_verdict) { ++proposals; }
  void on_stage_begin(isr::Stage stage)
  {
    Counting_visitor::on_stage_begin(stage);
    has_cells = has_cells || stage == isr::Stage::FUNCTION;
  }
};

// Reconstructs, checks what is guaranteed for every input, and returns the triangles.
template <typename Algorithm, typename NamedParameters>
Triples checked_triangles(Algorithm algorithm, const Points& points, const NamedParameters& np)
{
  // Conflicts are proposed by Delaunay facets, of which a surface has few a point, and closing tries a
  // few rounds.
  constexpr std::size_t PROPOSALS_PER_POINT = 100;
  Accounting_visitor visitor;
  const Triples triples = triangles_of(algorithm, points, params::combine(np, params::visitor(std::ref(visitor))));
  ISR_CHECK(validation::are_indices_valid(triples, points.size()));
  ISR_CHECK(validation::is_edge_manifold(triples));
  ISR_CHECK(validation::is_vertex_manifold(triples));
  ISR_CHECK(validation::is_consistently_oriented(triples));
  ISR_CHECK(!validation::has_degenerate_triangle(points, triples, Kernel()));
  ISR_CHECK_EQUAL(visitor.points, points.size());
  ISR_CHECK_EQUAL(validation::used_points(triples).size() + visitor.unused + visitor.duplicates + visitor.non_finite,
                  points.size());
  ISR_CHECK_EQUAL(visitor.begun, 1u);
  ISR_CHECK_EQUAL(visitor.ended, 1u);
  ISR_CHECK_EQUAL(visitor.stages_begun, visitor.stages_ended);
  ISR_CHECK(!visitor.was_cancelled);
  ISR_CHECK(visitor.proposals <= PROPOSALS_PER_POINT * points.size());
  // The surface between labels of Delaunay tetrahedra.
  if (visitor.has_cells) {
    ISR_CHECK(validation::boundary_edges(triples).empty());
    ISR_CHECK(!has_self_intersection(points, triples));
  }
  return triples;
}

template <typename Algorithm>
Triples checked_triangles(Algorithm algorithm, const Points& points)
{
  return checked_triangles(algorithm, points, params::neighbor_radius(0.));
}

} // namespace isr_test

#endif // ISR_TEST_ALGORITHMS_H

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

#ifndef ISR_SURFACE_TEST_UTILS_H
#define ISR_SURFACE_TEST_UTILS_H

#include "isr_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Manifold_builder.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_cloud_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Surface_predicates.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/star_compatibility.h>

#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

// Surfaces made by hand, for the tests of the stages that change a surface.

namespace isr_test {

namespace isr_internal = CGAL::Interpolating_surface_reconstruction_3::internal;
using CGAL::Interpolating_surface_reconstruction_3::Triangle_verdict;
using isr_internal::NO_POINT;
using isr_internal::Point_index;
using isr_internal::Star_compatibility;
using isr_internal::Star_table;

// Progress of which nobody is told.
struct No_progress
{
  bool advance(double) const { return true; }
  bool is_cancelled() const { return false; }
};
constexpr No_progress no_progress;

using Link = std::vector<Point_index>;
using Links = std::vector<Link>;

inline Star_table star_table(const Links& links)
{
  std::vector<Star_table::Block> blocks(1);
  for (const Link& link : links) {
    blocks[0].lengths.push_back(static_cast<std::uint32_t>(link.size()));
    blocks[0].neighbors.insert(blocks[0].neighbors.end(), link.begin(), link.end());
  }
  return Star_table(std::move(blocks));
}

// The links of the points below n in an oriented surface; a gap follows every open fan.
inline Links links_of(std::size_t n, const Triples& triples)
{
  std::vector<std::map<std::size_t, std::size_t> > next(n);
  for (const Triple& t : triples)
    for (std::size_t i = 0; i != 3; ++i)
      next[t[i]][t[(i + 1) % 3]] = t[(i + 2) % 3];
  Links links(n);
  for (std::size_t p = 0; p != n; ++p)
    while (!next[p].empty()) {
      std::set<std::size_t> ends;
      for (const auto& edge : next[p])
        ends.insert(edge.second);
      std::size_t at = next[p].begin()->first;
      for (const auto& edge : next[p])
        if (ends.count(edge.first) == 0)
          at = edge.first;
      const std::size_t begin = at;
      do {
        links[p].push_back(static_cast<Point_index>(at));
        const auto it = next[p].find(at);
        if (it == next[p].end()) {
          links[p].push_back(NO_POINT);
          break;
        }
        at = it->second;
        next[p].erase(it);
      } while (at != begin);
    }
  return links;
}

// A cloud, a surface on it, and how its points are numbered in the input. The surface begins with the
// stars that `links` agree on; links and triangles are in the order of the input.
class Hand_surface
{
public:
  using Cloud = isr_internal::Point_cloud_3<Kernel>;
  using Predicates = isr_internal::Surface_predicates<Kernel>;
  using Builder = isr_internal::Manifold_builder<Predicates>;

  explicit Hand_surface(const Points& points, const Links& links = {})
    : cloud(points, CGAL::Identity_property_map<Point>(), Kernel()), predicates(cloud), indices(indices_of(cloud)),
      stars(star_table(renumbered(links))), compatibility(voted(stars, predicates)), builder(compatibility, predicates)
  { }
  Hand_surface(const Hand_surface&) = delete;
  Hand_surface& operator=(const Hand_surface&) = delete;

  Triangle_verdict add(std::size_t p, std::size_t q, std::size_t r)
  {
    return builder.try_add(indices[p], indices[q], indices[r]);
  }

  // Whether all triangles could be added.
  bool add(const Triples& triples)
  {
    return std::all_of(triples.begin(), triples.end(),
                       [&](const Triple& t) { return add(t[0], t[1], t[2]) == Triangle_verdict::ADDED; });
  }

  void remove(std::size_t p, std::size_t q, std::size_t r)
  {
    builder.open(indices[p]);
    builder.remove(builder.find_triangle(indices[p], indices[q], indices[r]));
  }

  // The triangles of the surface, each connected part oriented in itself.
  Triples triangles()
  {
    Triples result;
    builder.for_each_triangle([&](const Builder::Triangle& t, isr_internal::Parity_union_find::Element e) {
      const bool is_flipped = builder.orientations().find(e).is_flipped;
      result.push_back(input_triple(is_flipped ? Builder::Triangle{ { t[0], t[2], t[1] } } : t));
    });
    return result;
  }

  Triple input_triple(const Builder::Triangle& t) const
  {
    return Triple{ cloud.input_index(t[0]), cloud.input_index(t[1]), cloud.input_index(t[2]) };
  }

  const Cloud cloud;
  const Predicates predicates;
  const std::vector<Point_index> indices; // in the cloud, of each point of the input
  const Star_table stars;
  Star_compatibility compatibility;
  Builder builder;

private:
  static std::vector<Point_index> indices_of(const Cloud& cloud)
  {
    std::vector<Point_index> result(cloud.size());
    for (Point_index p = 0; p != cloud.size(); ++p)
      result[cloud.input_index(p)] = p;
    return result;
  }

  Links renumbered(const Links& links) const
  {
    Links result(indices.size());
    for (std::size_t p = 0; p != links.size(); ++p)
      for (Point_index q : links[p])
        result[indices[p]].push_back(q == NO_POINT ? NO_POINT : indices[q]);
    return result;
  }

  static Star_compatibility voted(const Star_table& stars, const Predicates& predicates)
  {
    Star_compatibility result(stars);
    result.count_votes<CGAL::Sequential_tag>(predicates);
    result.orient();
    return result;
  }
};

// ---- triangulated surfaces -----------------------------------------------------------------------

struct Mesh
{
  Points points;
  Triples triples;
};

// (m + 1)^2 points; the squares for which is_hole(column, row) holds are left out.
template <typename IsHole>
Mesh sheet(std::size_t m, const IsHole& is_hole)
{
  Mesh mesh{ plane_grid(m).points, {} };
  for (std::size_t i = 0; i != m; ++i)
    for (std::size_t j = 0; j != m; ++j) {
      const std::size_t p = i * (m + 1) + j, q = p + m + 1;
      if (is_hole(i, j))
        continue;
      mesh.triples.push_back(Triple{ p, q, q + 1 });
      mesh.triples.push_back(Triple{ p, q + 1, p + 1 });
    }
  return mesh;
}

inline Mesh sheet(std::size_t m)
{
  return sheet(m, [](std::size_t, std::size_t) { return false; });
}

// A wall of two circles of n points around the z axis.
inline Mesh wall(std::size_t n, double height)
{
  Mesh mesh;
  for (std::size_t i = 0; i != n; ++i) {
    const double angle = 2. * PI * double(i) / double(n);
    mesh.points.push_back(on_circle(angle, 1., 0.));
    mesh.points.push_back(on_circle(angle, 1., height));
    const std::size_t p = 2 * i, q = 2 * ((i + 1) % n);
    mesh.triples.push_back(Triple{ p, q, q + 1 });
    mesh.triples.push_back(Triple{ p, q + 1, p + 1 });
  }
  return mesh;
}

// A sphere of two poles and `rings` rings of n points, facing outward; the south pole is point 0,
// point i of ring j is 1 + j n + i, and the triangles at the south pole come first.
inline Mesh globe(std::size_t rings, std::size_t n, const Point& center = Point(0, 0, 0), double radius = 1.)
{
  Mesh mesh;
  const auto add_point = [&](const Point& p) { mesh.points.push_back(center + radius * (p - CGAL::ORIGIN)); };
  add_point(Point(0, 0, -1));
  for (std::size_t j = 0; j != rings; ++j)
    for (std::size_t i = 0; i != n; ++i) {
      const double polar = PI * double(j + 1) / double(rings + 1);
      add_point(on_circle(2. * PI * (double(i) + .3 * double(j)) / double(n), std::sin(polar), -std::cos(polar)));
    }
  add_point(Point(0, 0, 1));
  const std::size_t north = mesh.points.size() - 1;
  for (std::size_t i = 0; i != n; ++i)
    mesh.triples.push_back(Triple{ 0, 1 + (i + 1) % n, 1 + i });
  for (std::size_t j = 0; j + 1 != rings; ++j)
    for (std::size_t i = 0; i != n; ++i) {
      const std::size_t p = 1 + j * n + i, q = 1 + j * n + (i + 1) % n;
      mesh.triples.push_back(Triple{ p, q, q + n });
      mesh.triples.push_back(Triple{ p, q + n, p + n });
    }
  for (std::size_t i = 0; i != n; ++i)
    mesh.triples.push_back(Triple{ north, north - n + i, north - n + (i + 1) % n });
  return mesh;
}

inline void append(Mesh& mesh, const Mesh& more)
{
  const std::size_t n = mesh.points.size();
  for (const Triple& t : more.triples)
    mesh.triples.push_back(Triple{ n + t[0], n + t[1], n + t[2] });
  append(mesh.points, more.points);
}

inline Triples turned(Triples triples)
{
  for (Triple& t : triples)
    std::swap(t[1], t[2]);
  return triples;
}

// A closed band of n triangles with one twist; 5 <= n, n odd.
inline Triples moebius_triples(std::size_t n)
{
  Triples triples;
  for (std::size_t i = 0; i != n; ++i)
    triples.push_back(i % 2 == 0 ? Triple{ i, (i + 1) % n, (i + 2) % n } : Triple{ (i + 1) % n, i, (i + 2) % n });
  return triples;
}

// Of input triangles of the surface, with the points of the cloud.
inline std::vector<std::array<Point_index, 3> > triangles_of(const Hand_surface& s, const Triples& triples)
{
  std::vector<std::array<Point_index, 3> > triangles;
  for (const Triple& t : triples)
    triangles.push_back({ { s.indices[t[0]], s.indices[t[1]], s.indices[t[2]] } });
  return triangles;
}

// The surface of the Delaunay cells of all points with labels other than zero: it separates different ones.
template <typename Label>
Triples surface_of_labels(const Hand_surface& s, const Label& label)
{
  std::vector<Point_index> all(s.cloud.size());
  for (Point_index p = 0; p != all.size(); ++p)
    all[p] = p;
  const isr_internal::Cell_complex cells(s.cloud.positions(), all);
  Triples triples;
  for (std::size_t c = 0; c != cells.size(); ++c)
    for (std::size_t i = 0; i != 4; ++i)
      if (label(cells[c]) != 0 && label(cells[cells[c].neighbors[i]]) != label(cells[c])) {
        std::array<Point_index, 3> f = isr_internal::Cell_complex::facet(cells[c], i);
        if (i % 2 != 0)
          std::swap(f[1], f[2]);
        triples.push_back(s.input_triple(f));
      }
  return triples;
}

} // namespace isr_test

#endif // ISR_SURFACE_TEST_UTILS_H

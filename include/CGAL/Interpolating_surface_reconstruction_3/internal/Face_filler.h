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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACE_FILLER_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACE_FILLER_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_loops.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/flatness.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_crossings.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Fills boundary loops together that lie in one plane: the flat faces of a part, with holes or without, have points at
// the walls only, and a face filled inside of each loop would lie on others. What is inside of an odd number of rims of
// walls is filled, by the constrained Delaunay triangulation in the plane. What lies in the plane already, between points
// of walls, is taken off for it: caps of holes, and what stars and completion put there.
template <typename Builder>
class Face_filler
{
public:
  Face_filler(const std::vector<Local_point>& points, Builder& builder) : m_points(points), m_builder(builder) { }

  // Leaves loops for which stays_open(loop) holds, faces without holes in whose plane nothing lies, which are simple, and
  // those with which the surface would not stay a manifold.
  template <typename StaysOpen, typename OnVerdict, typename CancellationPoint>
  void operator()(const StaysOpen& stays_open, OnVerdict on_verdict, CancellationPoint& cancellation_point)
  {
    const std::vector<Boundary_loop> loops = Boundary_loops<Builder>(m_points, m_builder)(cancellation_point);
    std::vector<Planar_loop> planar;
    for (const Boundary_loop& loop : loops) {
      cancellation_point(loop.size());
      if (!stays_open(loop))
        add_if_planar(loop, planar);
    }
    std::stable_sort(planar.begin(), planar.end(),
                     [](const Planar_loop& a, const Planar_loop& b) { return a.area > b.area; });
    std::size_t planes = 0;
    for (const Planar_loop& plane : planar) {
      if (plane.is_done || plane.loop->size() < MINIMUM_OUTER_SIZE || planes++ >= MAXIMUM_PLANES)
        continue;
      cancellation_point(planar.size());
      for (Planar_loop& other : planar)
        other.is_done = other.is_done || !rims_of_loop(*other.loop, plane).empty();
      fill_plane(plane, stays_open, on_verdict, cancellation_point);
    }
  }

private:
  using Triangle = typename Builder::Triangle;

  struct Planar_loop
  {
    const Boundary_loop* loop;
    Local_point origin, second; // on it
    Local_vector normal;        // of unit length
    double area, mean_edge;
    bool is_done;
  };

  struct Face
  {
    std::vector<Triangle> triangles;
    bool has_holes;
  };

  using Planar_kernel = Exact_predicates_inexact_constructions_kernel;
  using Planar_point = Planar_kernel::Point_2;
  using Vertex_base = Triangulation_vertex_base_with_info_2<Point_index, Planar_kernel>;
  // How many loops the face is inside of.
  using Face_base =
    Triangulation_face_base_with_info_2<int, Planar_kernel, Constrained_triangulation_face_base_2<Planar_kernel> >;
  using Triangulation =
    Constrained_Delaunay_triangulation_2<Planar_kernel, Triangulation_data_structure_2<Vertex_base, Face_base>,
                                         Exact_predicates_tag>;
  using Face_handle = typename Triangulation::Face_handle;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  static constexpr int UNKNOWN = -1, DEPTH_OF_HOLES = 2;

  // A face with a hole in it has more edges around it than gaps between triangles have, which are many.
  static constexpr std::size_t MINIMUM_OUTER_SIZE = 6;

  // All triangles are looked at for each.
  static constexpr std::size_t MAXIMUM_PLANES = 16;

  // How far the points of a loop may be from its plane, in its mean edges: a loop on a curved surface is no face.
  static constexpr double FLATNESS = .125;

  void add_if_planar(const Boundary_loop& loop, std::vector<Planar_loop>& planar) const
  {
    // Once more without what the wall lacks, which tilts the plane.
    Planar_loop result{ &loop, {}, {}, {}, 0., 0., false };
    Boundary_loop rim = loop;
    for (int pass = 0; pass != 2; ++pass) {
      const Local_vector normal = loop_normal(m_points, rim);
      const double length = std::sqrt(normal.squared_length());
      if (!(length > 0.))
        return;
      result = Planar_loop{
        &loop, m_points[rim[0]], m_points[rim[1]], normal / length, length / 2, mean_edge_of_loop(m_points, rim), false
      };
      const std::vector<Boundary_loop> rims = rims_of_loop(loop, result);
      if (rims.empty())
        return;
      rim = *std::max_element(rims.begin(), rims.end(),
                              [](const Boundary_loop& a, const Boundary_loop& b) { return a.size() < b.size(); });
    }
    planar.push_back(result);
  }

  // The cycles of the loop in the plane: without points beside it, where the wall below has gaps, and apart from each other
  // where they pinch, without small ones, which are gaps, too. None if gaps are many, or if edges of the cycles are in the
  // surface already.
  std::vector<Boundary_loop> rims_of_loop(const Boundary_loop& loop, const Planar_loop& plane) const
  {
    constexpr std::size_t POINTS_PER_GAP = 4;
    const std::size_t n = loop.size();
    std::size_t gaps = 0, in_plane = 0;
    for (std::size_t i = 0; i != n; ++i)
      if (is_in_plane(loop[i], plane))
        ++in_plane;
      else
        gaps += is_in_plane(loop[(i + 1) % n], plane) ? 1u : 0u;
    if (in_plane < 3 || in_plane < POINTS_PER_GAP * gaps)
      return {};
    std::vector<Boundary_loop> rims;
    Boundary_loop rim;
    const std::vector<Point_index> pinches = repeated(loop);
    const auto is_pinch = [&](Point_index p) { return std::binary_search(pinches.begin(), pinches.end(), p); };
    const std::size_t first = std::size_t(
      std::find_if(loop.begin(), loop.end(), [&](Point_index p) { return is_in_plane(p, plane) && !is_pinch(p); }) -
      loop.begin());
    for (std::size_t i = first; i != first + n; ++i) {
      const Point_index p = loop[i % n];
      if (!is_in_plane(p, plane))
        continue;
      const auto before = is_pinch(p) ? std::find(rim.rbegin(), rim.rend(), p) : rim.rend();
      if (before == rim.rend()) {
        rim.push_back(p);
        continue;
      }
      const auto begin = before.base() - 1;
      if (rim.end() - begin >= std::ptrdiff_t(MINIMUM_OUTER_SIZE))
        rims.emplace_back(begin, rim.end());
      rim.erase(begin + 1, rim.end());
    }
    if (rim.size() >= 3)
      rims.push_back(std::move(rim));
    for (const Boundary_loop& r : rims)
      for (std::size_t i = 0; i != r.size(); ++i)
        if (m_builder.number_of_triangles(r[i], r[(i + 1) % r.size()]) > 1)
          return {};
    return rims;
  }

  static std::vector<Point_index> repeated(Boundary_loop loop)
  {
    std::vector<Point_index> result;
    std::sort(loop.begin(), loop.end());
    for (std::size_t i = 1; i != loop.size(); ++i)
      if (loop[i] == loop[i - 1])
        result.push_back(loop[i]);
    return result;
  }

  bool is_in_plane(Point_index p, const Planar_loop& plane) const
  {
    return std::abs(plane.normal * (m_points[p] - plane.origin)) <= FLATNESS * plane.mean_edge;
  }

  // Triangles of a low wall are not, but thin ones of points on a line are, whose normal is that of rounding errors.
  bool is_in_plane(const Triangle& t, const Planar_loop& plane) const
  {
    double height = 0.;
    for (Point_index p : t) {
      height = (std::max)(height, std::abs(plane.normal * (m_points[p] - plane.origin)));
      if (height > FLATNESS * plane.mean_edge)
        return false;
    }
    const Local_vector n = cross_product(m_points[t[1]] - m_points[t[0]], m_points[t[2]] - m_points[t[0]]);
    const double cosine = n * plane.normal; // times the length of n
    return height <= ROUNDING_OF_SIX_DIGITS * plane.mean_edge || 2. * cosine * cosine > n.squared_length();
  }

  // If that is not possible, all stays as it was.
  template <typename StaysOpen, typename OnVerdict, typename CancellationPoint>
  void fill_plane(const Planar_loop& plane, const StaysOpen& stays_open, OnVerdict& on_verdict,
                  CancellationPoint& cancellation_point)
  {
    const std::vector<Triangle> removed = find_removable(plane, cancellation_point);
    for (const Triangle& t : removed)
      m_builder.remove(m_builder.find_triangle(t[0], t[1], t[2]));
    const Face face =
      fill(plane, find_rims(plane, stays_open, cancellation_point), loose_points(removed), cancellation_point);
    if ((!face.has_holes && removed.empty()) || !attach(face, on_verdict, cancellation_point))
      for (const Triangle& t : removed)
        m_builder.restore(t);
  }

  // Where rims pinch or walls have gaps, some triangles may not be possible: what they leave is closed later. Attaches
  // none and returns false if these are many, or if it is a sheet that would be covered, or a lid that crosses the surface.
  template <typename OnVerdict, typename CancellationPoint>
  bool attach(const Face& face, OnVerdict& on_verdict, CancellationPoint& cancellation_point)
  {
    constexpr std::size_t TRIANGLES_PER_GAP = 8;
    // A face without holes has two triangles less than points.
    if (face.triangles.empty() || 2 * number_of_folds(face.triangles) > face.triangles.size() + 2)
      return false;
    using Index = typename Builder::Triangle_index;
    const std::size_t before = m_builder.number_of_stored_triangles();
    std::size_t refused = 0;
    for (const Triangle& t : face.triangles) {
      const Triangle_verdict verdict = m_builder.try_add(t[0], t[1], t[2]);
      on_verdict(t, verdict);
      refused += verdict == Triangle_verdict::ADDED ? 0u : 1u;
    }
    if (refused * TRIANGLES_PER_GAP <= face.triangles.size() &&
        Surface_crossings<Builder>(m_points, m_builder)(static_cast<Index>(before), cancellation_point).empty())
      return true;
    for (std::size_t added = m_builder.number_of_stored_triangles(); added-- != before;)
      m_builder.remove(static_cast<Index>(added));
    return false;
  }

  // Triangles of the surface in the plane, but for those of parts most of whose points are samples of the face: these are
  // right.
  template <typename CancellationPoint>
  std::vector<Triangle> find_removable(const Planar_loop& plane, CancellationPoint& cancellation_point)
  {
    std::vector<Triangle> flat, result;
    std::vector<Point_index> points, samples;
    Parity_union_find parts(m_points.size());
    m_builder.for_each_triangle([&](const Triangle& t, auto) {
      cancellation_point();
      if (!is_in_plane(t, plane))
        return;
      flat.push_back(t);
      points.insert(points.end(), t.begin(), t.end());
      parts.unite(t[0], t[1], false);
      parts.unite(t[0], t[2], false);
    });
    sort_and_unique(points);
    std::copy_if(points.begin(), points.end(), std::back_inserter(samples),
                 [&](Point_index p) { return is_sample(p, plane); });
    const std::vector<Point_index> roots = sorted_roots(parts, points), roots_of_samples = sorted_roots(parts, samples);
    std::copy_if(flat.begin(), flat.end(), std::back_inserter(result), [&](const Triangle& t) {
      const Point_index root = parts.find(t[0]).root;
      return 2 * number_of(root, roots_of_samples) <= number_of(root, roots);
    });
    for (const Triangle& t : result)
      for (Point_index p : t)
        m_builder.open(p);
    return result;
  }

  static std::vector<Point_index> sorted_roots(Parity_union_find& parts, const std::vector<Point_index>& points)
  {
    std::vector<Point_index> result;
    std::transform(points.begin(), points.end(), std::back_inserter(result),
                   [&](Point_index p) { return parts.find(p).root; });
    std::sort(result.begin(), result.end());
    return result;
  }

  static std::ptrdiff_t number_of(Point_index root, const std::vector<Point_index>& sorted_roots)
  {
    const auto range = std::equal_range(sorted_roots.begin(), sorted_roots.end(), root);
    return range.second - range.first;
  }

  // Off all walls, with a star that is closed and agreed on.
  bool is_sample(Point_index p, const Planar_loop& plane) const
  {
    const auto& compatibility = m_builder.compatibility();
    if (!compatibility.is_point_agreed(p) || compatibility.is_point_on_boundary(p))
      return false;
    bool result = true;
    m_builder.for_each_triangle_at(p, [&](const Triangle& t) { result = result && is_in_plane(t, plane); });
    return result;
  }

  static void sort_and_unique(std::vector<Point_index>& points)
  {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }

  // Those of removed triangles that have no others.
  std::vector<Point_index> loose_points(const std::vector<Triangle>& removed) const
  {
    std::vector<Point_index> result;
    for (const Triangle& t : removed)
      std::copy_if(t.begin(), t.end(), std::back_inserter(result),
                   [&](Point_index p) { return m_builder.corners(p).empty(); });
    sort_and_unique(result);
    return result;
  }

  // The boundary loops in the plane; none if one of them stays open.
  template <typename StaysOpen, typename CancellationPoint>
  std::vector<Boundary_loop> find_rims(const Planar_loop& plane, const StaysOpen& stays_open,
                                       CancellationPoint& cancellation_point) const
  {
    std::vector<Boundary_loop> result;
    for (const Boundary_loop& loop : Boundary_loops<Builder>(m_points, m_builder)(cancellation_point)) {
      std::vector<Boundary_loop> rims = rims_of_loop(loop, plane);
      if (!rims.empty() && stays_open(loop))
        return {};
      std::move(rims.begin(), rims.end(), std::back_inserter(result));
    }
    return result;
  }

  // The triangles inside of an odd number of the loops, with the loose points as vertices; none if loops do not bound
  // faces, or if there are loose points in holes, far from the rims: then what has covered these was right.
  template <typename CancellationPoint>
  Face fill(const Planar_loop& plane, const std::vector<Boundary_loop>& loops, const std::vector<Point_index>& loose,
            CancellationPoint& cancellation_point) const
  {
    const Local_vector u = plane.second - plane.origin, v = cross_product(plane.normal, u);
    Triangulation triangulation;
    const auto insert = [&](Point_index p) {
      cancellation_point();
      const Local_vector d = m_points[p] - plane.origin;
      const auto vertex = triangulation.insert(Planar_point(d * u, d * v));
      vertex->info() = p;
      return vertex;
    };
    std::vector<Point_index> points;
    for (const Boundary_loop& loop : loops)
      points.insert(points.end(), loop.begin(), loop.end());
    sort_and_unique(points);
    std::vector<Vertex_handle> vertices;
    std::transform(points.begin(), points.end(), std::back_inserter(vertices), insert);
    const auto vertex_of = [&](Point_index p) {
      return vertices[std::size_t(std::lower_bound(points.begin(), points.end(), p) - points.begin())];
    };
    for (const Boundary_loop& loop : loops)
      for (std::size_t k = 0; k != loop.size(); ++k) {
        const auto from = vertex_of(loop[k]), to = vertex_of(loop[(k + 1) % loop.size()]);
        if (from != to)
          triangulation.insert_constraint(from, to);
      }
    // Loops that cross each other in the plane do not bound a face.
    if (triangulation.number_of_vertices() != points.size() || triangulation.dimension() != 2)
      return Face{ {}, false };
    vertices.clear();
    std::transform(loose.begin(), loose.end(), std::back_inserter(vertices), insert);
    if (triangulation.number_of_vertices() != points.size() + loose.size())
      return Face{ {}, false };
    flood(triangulation);
    if (std::any_of(vertices.begin(), vertices.end(),
                    [&](Vertex_handle vertex) { return is_apart_in_hole(vertex, triangulation); }))
      return Face{ {}, false };
    Face result{ {}, false };
    for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
      if (f->info() % 2 == 1)
        result.triangles.push_back(Triangle{ { f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info() } });
      result.has_holes = result.has_holes || f->info() >= DEPTH_OF_HOLES;
    }
    return result;
  }

  // Whether the vertex is in a hole and farther from the neighbors on its rim than these are from each other. The others
  // are points of the rim that the wall has skipped.
  bool is_apart_in_hole(Vertex_handle v, const Triangulation& triangulation) const
  {
    if (v->face()->info() < DEPTH_OF_HOLES || v->face()->info() % 2 == 1)
      return false;
    const auto squared_length = [](Vertex_handle a, Vertex_handle b) {
      return squared_distance(a->point(), b->point());
    };
    auto q = triangulation.incident_vertices(v);
    const auto first = q;
    do {
      auto e = triangulation.incident_edges(q);
      const auto first_edge = e;
      do {
        if (triangulation.is_constrained(*e) &&
            squared_length(v, q) <= squared_length(e->first->vertex(Triangulation::cw(e->second)),
                                                   e->first->vertex(Triangulation::ccw(e->second))))
          return false;
      } while (++e != first_edge);
    } while (++q != first);
    return true;
  }

  // Tells faces how many loops they are inside of, from outside, across one loop after the other.
  static void flood(Triangulation& triangulation)
  {
    for (auto f = triangulation.all_faces_begin(); f != triangulation.all_faces_end(); ++f)
      f->info() = UNKNOWN;
    std::vector<Face_handle> todo(1, triangulation.infinite_face()), beyond;
    for (int depth = 0; !todo.empty(); ++depth) {
      beyond.clear();
      while (!todo.empty()) {
        const Face_handle f = todo.back();
        todo.pop_back();
        if (f->info() != UNKNOWN)
          continue;
        f->info() = depth;
        for (int i = 0; i != 3; ++i)
          (f->is_constrained(i) ? beyond : todo).push_back(f->neighbor(i));
      }
      beyond.erase(std::remove_if(beyond.begin(), beyond.end(), [](Face_handle f) { return f->info() != UNKNOWN; }),
                   beyond.end());
      std::swap(todo, beyond);
    }
  }

  // The edges at which triangles lie on those of the surface, as they would on a sheet that ends there.
  std::size_t number_of_folds(const std::vector<Triangle>& triangles) const
  {
    std::size_t result = 0;
    for (const Triangle& t : triangles)
      for (std::size_t i = 0; i != 3; ++i) {
        const Point_index p = t[i], q = t[(i + 1) % 3], r = t[(i + 2) % 3];
        const Point_index opposite = m_builder.opposite_vertex(p, q);
        if (opposite != NO_POINT && m_builder.number_of_triangles(p, q) == 1 && is_sharp(p, q, r, opposite))
          ++result;
      }
    return result;
  }

  // Whether the angle at the edge (p, q) is less than 45 degrees.
  bool is_sharp(Point_index p, Point_index q, Point_index r, Point_index opposite) const
  {
    const Local_vector e = m_points[q] - m_points[p], a = cross_product(e, m_points[r] - m_points[p]),
                       b = cross_product(e, m_points[opposite] - m_points[p]);
    const double cosine = a * b;
    return cosine > 0. && 2. * cosine * cosine > a.squared_length() * b.squared_length();
  }

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACE_FILLER_H

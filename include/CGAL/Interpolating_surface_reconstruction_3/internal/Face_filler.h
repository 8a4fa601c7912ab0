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
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_exchange.h>

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

// Fills boundary loops together that lie in one plane and inside of each other: the flat faces of a part with holes
// have points at the walls only, and a face filled inside of each loop would lie on others. What is inside of an odd
// number of rims of walls is filled, by the constrained Delaunay triangulation in the plane. What lies in the plane
// already, between points of walls, is taken off for it: caps of holes, and what stars and completion put there.
template <typename Builder>
class Face_filler
{
public:
  Face_filler(const std::vector<Local_point>& points, Builder& builder) : m_points(points), m_builder(builder) { }

  // Leaves loops that are not inside of others, and those with which the surface would not stay a manifold.
  template <typename OnVerdict, typename CancellationPoint>
  void operator()(const std::vector<Boundary_loop>& loops, OnVerdict on_verdict, CancellationPoint& cancellation_point)
  {
    std::vector<Planar_loop> planar;
    for (const Boundary_loop& loop : loops) {
      cancellation_point(loop.size());
      add_if_planar(loop, planar);
    }
    std::stable_sort(planar.begin(), planar.end(),
                     [](const Planar_loop& a, const Planar_loop& b) { return a.area > b.area; });
    std::size_t planes = 0;
    for (const Planar_loop& plane : planar) {
      if (plane.is_done || plane.loop->size() < MINIMUM_OUTER_SIZE || planes++ >= MAXIMUM_PLANES)
        continue;
      cancellation_point(planar.size());
      std::vector<Point_index> points;
      for (Planar_loop& other : planar)
        if (!other.is_done && is_in_plane(other, plane)) {
          other.is_done = true;
          points.insert(points.end(), other.loop->begin(), other.loop->end());
        }
      fill_plane(plane, std::move(points), on_verdict, cancellation_point);
    }
  }

private:
  using Triangle = typename Builder::Triangle;

  struct Planar_loop
  {
    const Boundary_loop* loop;
    Local_point origin;
    Local_vector normal; // of unit length
    double area, mean_edge;
    bool is_done;
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
  static constexpr int UNKNOWN = -1;

  // A face with a hole in it has more edges around it than gaps between triangles have, which are many.
  static constexpr std::size_t MINIMUM_OUTER_SIZE = 6;

  // All triangles are looked at for each.
  static constexpr std::size_t MAXIMUM_PLANES = 16;

  // How far the points of a loop may be from its plane, in its mean edges: a loop on a curved surface is no face.
  static constexpr double FLATNESS = .125;

  void add_if_planar(const Boundary_loop& loop, std::vector<Planar_loop>& planar) const
  {
    for (std::size_t i = 0; i != loop.size(); ++i)
      if (m_builder.number_of_triangles(loop[i], loop[(i + 1) % loop.size()]) != 1)
        return;
    const Local_vector normal = loop_normal(m_points, loop);
    const double length = std::sqrt(normal.squared_length());
    if (!(length > 0.))
      return;
    const Planar_loop result{
      &loop, m_points[loop.front()], normal / length, length / 2, mean_edge_of_loop(m_points, loop), false
    };
    if (is_in_plane(result, result))
      planar.push_back(result);
  }

  // Whether the loop is in the plane of the other one.
  bool is_in_plane(const Planar_loop& a, const Planar_loop& b) const
  {
    const double thickness = FLATNESS * (std::min)(a.mean_edge, b.mean_edge);
    return std::all_of(a.loop->begin(), a.loop->end(),
                       [&](Point_index p) { return std::abs(b.normal * (m_points[p] - b.origin)) <= thickness; });
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

  // `points` are those of loops in the plane, which may be filled. If that is not possible, all stays as it was.
  template <typename OnVerdict, typename CancellationPoint>
  void fill_plane(const Planar_loop& plane, std::vector<Point_index> points, OnVerdict& on_verdict,
                  CancellationPoint& cancellation_point)
  {
    const std::vector<Triangle> removed = find_removable(plane, cancellation_point);
    for (const Triangle& t : removed) {
      points.insert(points.end(), t.begin(), t.end());
      m_builder.remove(m_builder.find_triangle(t[0], t[1], t[2]));
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const std::vector<Triangle> triangles = fill(plane, find_rims(plane, points), cancellation_point);
    if (!triangles.empty() && 2 * number_of_folds(triangles) <= points.size() &&
        attach_all(m_builder, triangles, on_verdict))
      return;
    for (const Triangle& t : removed)
      m_builder.restore(t);
  }

  // Triangles of the surface in the plane, but for those of parts with a point of their own, off all walls.
  template <typename CancellationPoint>
  std::vector<Triangle> find_removable(const Planar_loop& plane, CancellationPoint& cancellation_point)
  {
    const auto is_flat = [&](const Triangle& t) { return is_in_plane(t, plane); };
    std::vector<Triangle> flat, result;
    Parity_union_find parts(m_points.size());
    m_builder.for_each_triangle([&](const Triangle& t, auto) {
      cancellation_point();
      if (!is_flat(t))
        return;
      flat.push_back(t);
      parts.unite(t[0], t[1], false);
      parts.unite(t[0], t[2], false);
    });
    std::vector<Point_index> kept; // by their roots
    for (const Triangle& t : flat)
      for (Point_index p : t) {
        bool is_on_wall = false;
        m_builder.for_each_triangle_at(p, [&](const Triangle& other) { is_on_wall = is_on_wall || !is_flat(other); });
        if (!is_on_wall)
          kept.push_back(parts.find(p).root);
      }
    std::sort(kept.begin(), kept.end());
    std::copy_if(flat.begin(), flat.end(), std::back_inserter(result), [&](const Triangle& t) {
      return !std::binary_search(kept.begin(), kept.end(), parts.find(t[0]).root);
    });
    for (const Triangle& t : result)
      for (Point_index p : t)
        m_builder.open(p);
    return result;
  }

  // The cycles of boundary edges in the plane at the points, which increase; none if cycles meet or leave the points.
  std::vector<Boundary_loop> find_rims(const Planar_loop& plane, const std::vector<Point_index>& points) const
  {
    const auto position = [&](Point_index p) {
      return static_cast<std::size_t>(std::lower_bound(points.begin(), points.end(), p) - points.begin());
    };
    std::vector<std::vector<Point_index> > neighbors(points.size());
    for (std::size_t i = 0; i != points.size(); ++i) {
      for (const auto& corner : m_builder.corners(points[i]))
        for (Point_index q : { corner.a, corner.b })
          if (m_builder.number_of_triangles(points[i], q) == 1 && is_in_plane(q, plane))
            neighbors[i].push_back(q);
      if (!(neighbors[i].empty() || neighbors[i].size() == 2) ||
          !std::all_of(neighbors[i].begin(), neighbors[i].end(),
                       [&](Point_index q) { return std::binary_search(points.begin(), points.end(), q); }))
        return {};
    }
    std::vector<Boundary_loop> result;
    std::vector<unsigned char> is_visited(points.size(), 0);
    for (std::size_t first = 0; first != points.size(); ++first) {
      if (is_visited[first] != 0 || neighbors[first].empty())
        continue;
      result.emplace_back();
      for (std::size_t i = first, last = first;;) {
        is_visited[i] = 1;
        result.back().push_back(points[i]);
        const std::size_t a = position(neighbors[i][0]), b = position(neighbors[i][1]);
        last = std::exchange(i, a == last ? b : a);
        if (i == first)
          break;
      }
    }
    return result;
  }

  // The triangles inside of an odd number of the loops; none if they do not bound faces, or faces without holes.
  template <typename CancellationPoint>
  std::vector<Triangle> fill(const Planar_loop& plane, const std::vector<Boundary_loop>& loops,
                             CancellationPoint& cancellation_point) const
  {
    Triangulation triangulation;
    const Local_vector u = m_points[(*plane.loop)[1]] - m_points[plane.loop->front()],
                       v = cross_product(plane.normal, u);
    std::size_t size = 0;
    for (const Boundary_loop& loop : loops) {
      std::vector<typename Triangulation::Vertex_handle> vertices;
      for (Point_index p : loop) {
        cancellation_point();
        const Local_vector d = m_points[p] - plane.origin;
        vertices.push_back(triangulation.insert(Planar_point(d * u, d * v)));
        vertices.back()->info() = p;
      }
      for (std::size_t k = 0; k != loop.size(); ++k)
        if (vertices[k] != vertices[(k + 1) % loop.size()])
          triangulation.insert_constraint(vertices[k], vertices[(k + 1) % loop.size()]);
      size += loop.size();
    }
    // Loops that cross each other in the plane do not bound a face.
    if (triangulation.number_of_vertices() != size || triangulation.dimension() != 2)
      return {};
    return triangles_inside(triangulation);
  }

  // Floods the plane from outside, across one loop after the other.
  static std::vector<Triangle> triangles_inside(Triangulation& triangulation)
  {
    for (auto f = triangulation.all_faces_begin(); f != triangulation.all_faces_end(); ++f)
      f->info() = UNKNOWN;
    std::vector<Triangle> result;
    std::vector<Face_handle> todo(1, triangulation.infinite_face()), beyond;
    int depth = 0;
    for (; !todo.empty(); ++depth) {
      beyond.clear();
      while (!todo.empty()) {
        const Face_handle f = todo.back();
        todo.pop_back();
        if (f->info() != UNKNOWN)
          continue;
        f->info() = depth;
        if (depth % 2 == 1)
          result.push_back(Triangle{ { f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info() } });
        for (int i = 0; i != 3; ++i)
          (f->is_constrained(i) ? beyond : todo).push_back(f->neighbor(i));
      }
      beyond.erase(std::remove_if(beyond.begin(), beyond.end(), [](Face_handle f) { return f->info() != UNKNOWN; }),
                   beyond.end());
      std::swap(todo, beyond);
    }
    constexpr int DEPTHS_WITHOUT_HOLES = 2;
    if (depth <= DEPTHS_WITHOUT_HOLES)
      result.clear();
    return result;
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

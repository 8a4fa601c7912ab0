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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACE_TRIANGULATION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACE_TRIANGULATION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Face_rims.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Triangles in a plane.
struct Flat_face
{
  std::vector<std::array<Point_index, 3> > triangles;
  bool has_holes;
};

// Triangulates flat faces within their rims.
class Face_triangulation
{
public:
  explicit Face_triangulation(const std::vector<Local_point>& points) : m_points(points) { }

  // The triangles inside of an odd number of the loops, with the loose points as vertices; none if loops do not bound
  // faces, if points coincide in the plane, or if there are loose points in holes, far from the rims: then what has covered these was right.
  template <typename CancellationPoint>
  Flat_face operator()(const Face_plane& plane, const std::vector<Boundary_loop>& loops,
                       const std::vector<Point_index>& loose, CancellationPoint& cancellation_point) const
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
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::vector<Vertex_handle> vertices;
    std::transform(points.begin(), points.end(), std::back_inserter(vertices), insert);
    if (triangulation.number_of_vertices() != points.size())
      return Flat_face{ {}, false };
    const auto vertex_of = [&](Point_index p) {
      return vertices[std::size_t(std::lower_bound(points.begin(), points.end(), p) - points.begin())];
    };
    for (const Boundary_loop& loop : loops)
      for (std::size_t k = 0; k != loop.size(); ++k) {
        if (loop[k] != loop[(k + 1) % loop.size()])
          triangulation.insert_constraint(vertex_of(loop[k]), vertex_of(loop[(k + 1) % loop.size()]));
      }
    // Loops that cross each other in the plane do not bound a face: where they do is a new vertex, which is no point.
    if (triangulation.number_of_vertices() != points.size() || triangulation.dimension() != 2)
      return Flat_face{ {}, false };
    vertices.clear();
    std::transform(loose.begin(), loose.end(), std::back_inserter(vertices), insert);
    if (triangulation.number_of_vertices() != points.size() + loose.size())
      return Flat_face{ {}, false };
    flood(triangulation);
    if (std::any_of(vertices.begin(), vertices.end(),
                    [&](Vertex_handle vertex) { return is_apart_in_hole(vertex, triangulation); }))
      return Flat_face{ {}, false };
    Flat_face result{ {}, false };
    for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
      if (f->info() % 2 == 1)
        result.triangles.push_back(Triangle{ { f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info() } });
      result.has_holes = result.has_holes || f->info() >= DEPTH_OF_HOLES;
    }
    return result;
  }

private:
  using Planar_kernel = Exact_predicates_inexact_constructions_kernel;
  using Planar_point = Planar_kernel::Point_2;
  using Vertex_base = Triangulation_vertex_base_with_info_2<Point_index, Planar_kernel>;
  // How many loops the face is inside of.
  using Face_base =
    Triangulation_face_base_with_info_2<int, Planar_kernel, Constrained_triangulation_face_base_2<Planar_kernel> >;
  using Triangulation =
    Constrained_Delaunay_triangulation_2<Planar_kernel, Triangulation_data_structure_2<Vertex_base, Face_base>,
                                         Exact_predicates_tag>;
  using Face_handle = Triangulation::Face_handle;
  using Vertex_handle = Triangulation::Vertex_handle;
  using Triangle = std::array<Point_index, 3>;
  static constexpr int UNKNOWN = -1, DEPTH_OF_HOLES = 2;

  // Whether the vertex is in a hole and farther from the neighbors on its rim than these are from each other. The others
  // are points of the rim that the wall has skipped.
  static bool is_apart_in_hole(Vertex_handle v, const Triangulation& triangulation)
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

  const std::vector<Local_point>& m_points;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACE_TRIANGULATION_H

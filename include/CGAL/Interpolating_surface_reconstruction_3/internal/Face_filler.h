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
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

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
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Fills boundary loops together that lie in one plane and inside of each other: the flat faces of a part with holes
// have points at the walls only, and a face filled inside of each loop would lie on others. What is inside of an odd
// number of loops is filled, by the constrained Delaunay triangulation in the plane. Caps in that plane, which have been
// put on walls before, are taken off for it.
template <typename Builder>
class Face_filler
{
public:
  Face_filler(const std::vector<Local_point>& points, Builder& builder)
    : m_points(points), m_builder(builder), m_visits_left(FACES_WITH_CAPS * points.size())
  { }

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
    for (std::size_t outer = 0; outer != planar.size(); ++outer) {
      if (planar[outer].is_done || planar[outer].loop->size() < MINIMUM_OUTER_SIZE)
        continue;
      cancellation_point(planar.size() - outer);
      std::vector<Boundary_loop> chosen(1, *planar[outer].loop);
      std::vector<std::size_t> inside;
      for (std::size_t i = outer + 1; i != planar.size(); ++i)
        if (!planar[i].is_done && is_inside(planar[i], planar[outer])) {
          inside.push_back(i);
          chosen.push_back(*planar[i].loop);
        }
      const std::vector<Triangle> caps = find_caps(planar[outer], cancellation_point);
      append_rims(caps, chosen);
      if (chosen.size() > 1 && exchange_caps(caps, planar[outer], chosen, on_verdict, cancellation_point))
        for (std::size_t i : inside)
          planar[i].is_done = true;
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

  // Faces for which caps are looked for among all triangles.
  static constexpr std::size_t FACES_WITH_CAPS = 16;

  // How far the points of a loop may be from its plane, in its mean edges: a loop on a curved surface is no face.
  static constexpr double FLATNESS = .125;

  void add_if_planar(const Boundary_loop& loop, std::vector<Planar_loop>& planar) const
  {
    Planar_loop result{ &loop, m_points[loop.front()], Local_vector(0, 0, 0), 0., 0., false };
    for (std::size_t i = 0; i != loop.size(); ++i) {
      const Point_index p = loop[i], q = loop[(i + 1) % loop.size()];
      if (m_builder.number_of_triangles(p, q) != 1)
        return;
      result.normal = result.normal + cross_product(m_points[p] - result.origin, m_points[q] - result.origin);
      result.mean_edge += std::sqrt((m_points[q] - m_points[p]).squared_length()) / double(loop.size());
    }
    const double length = std::sqrt(result.normal.squared_length());
    if (!(length > 0.))
      return;
    result.area = length / 2;
    result.normal = result.normal / length;
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

  bool is_inside(const Planar_loop& a, const Planar_loop& b) const
  {
    return is_in_plane(a, b) && is_point_inside(m_points[a.loop->front()], b);
  }

  // By the number of edges that a ray in the plane crosses.
  bool is_point_inside(const Local_point& p, const Planar_loop& b) const
  {
    const Local_vector u = m_points[(*b.loop)[1]] - m_points[b.loop->front()], v = cross_product(b.normal, u);
    bool result = false;
    for (std::size_t i = 0; i != b.loop->size(); ++i) {
      const Local_vector q = m_points[(*b.loop)[i]] - p, r = m_points[(*b.loop)[(i + 1) % b.loop->size()]] - p;
      const double yq = q * v, yr = r * v;
      if ((yq > 0.) != (yr > 0.) && ((q * u) * yr > (r * u) * yq) == (yr > yq))
        result = !result;
    }
    return result;
  }

  // Triangles of the surface in the plane of the loop and inside of it, but for those of parts that have a boundary or
  // points of their own: those are no caps.
  template <typename CancellationPoint>
  std::vector<Triangle> find_caps(const Planar_loop& loop, CancellationPoint& cancellation_point)
  {
    std::vector<Triangle> flat, caps;
    if (m_visits_left < m_points.size())
      return caps;
    m_visits_left -= m_points.size();
    const double thickness = FLATNESS * loop.mean_edge;
    const auto is_in_face = [&](const Triangle& t) {
      return std::all_of(
               t.begin(), t.end(),
               [&](Point_index p) { return std::abs(loop.normal * (m_points[p] - loop.origin)) <= thickness; }) &&
             is_point_inside(centroid(m_points[t[0]], m_points[t[1]], m_points[t[2]]), loop);
    };
    m_builder.for_each_triangle([&](const Triangle& t, auto) {
      cancellation_point();
      if (is_in_face(t))
        flat.push_back(t);
    });
    // by the edges between them
    Parity_union_find parts(m_points.size());
    for (const Triangle& t : flat)
      for (Point_index p : t) {
        m_builder.open(p);
        parts.unite(t[0], p, false);
      }
    std::vector<Point_index> others;
    for (const Triangle& t : flat)
      for (std::size_t i = 0; i != 3; ++i) {
        std::size_t outside = 0;
        m_builder.for_each_triangle_at(t[i], [&](const Triangle& other) { outside += is_in_face(other) ? 0u : 1u; });
        if (outside == 0 || m_builder.number_of_triangles(t[i], t[(i + 1) % 3]) != 2)
          others.push_back(parts.find(t[i]).root);
      }
    std::sort(others.begin(), others.end());
    std::copy_if(flat.begin(), flat.end(), std::back_inserter(caps), [&](const Triangle& t) {
      return !std::binary_search(others.begin(), others.end(), parts.find(t[0]).root);
    });
    return caps;
  }

  // The cycles of edges around the caps.
  static void append_rims(const std::vector<Triangle>& caps, std::vector<Boundary_loop>& loops)
  {
    // The triangles of a cap need not be oriented alike.
    std::vector<std::array<Point_index, 2> > edges;
    for (const Triangle& t : caps)
      for (std::size_t i = 0; i != 3; ++i)
        edges.push_back({ { (std::min)(t[i], t[(i + 1) % 3]), (std::max)(t[i], t[(i + 1) % 3]) } });
    std::sort(edges.begin(), edges.end());
    std::map<Point_index, std::vector<Point_index> > next;
    for (std::size_t i = 0; i != edges.size(); ++i)
      if ((i == 0 || edges[i - 1] != edges[i]) && (i + 1 == edges.size() || edges[i + 1] != edges[i])) {
        next[edges[i][0]].push_back(edges[i][1]);
        next[edges[i][1]].push_back(edges[i][0]);
      }
    while (!next.empty()) {
      Boundary_loop loop(1, next.begin()->first);
      for (bool is_found = true; is_found;) {
        const auto it = next.find(loop.back());
        is_found = it != next.end() && !it->second.empty();
        if (!is_found)
          break;
        const Point_index q = it->second.back();
        it->second.pop_back();
        auto& back = next[q];
        back.erase(std::find(back.begin(), back.end(), loop.back()));
        loop.push_back(q);
      }
      for (Point_index p : loop)
        if (next.count(p) != 0 && next[p].empty())
          next.erase(p);
      if (loop.size() > 3 && loop.front() == loop.back()) {
        loop.pop_back();
        loops.push_back(loop);
      }
    }
  }

  // Takes the caps off and fills the loops; if that is not possible, all stays as it was.
  template <typename OnVerdict, typename CancellationPoint>
  bool exchange_caps(const std::vector<Triangle>& caps, const Planar_loop& outer,
                     const std::vector<Boundary_loop>& chosen, OnVerdict& on_verdict,
                     CancellationPoint& cancellation_point)
  {
    const std::vector<Triangle> triangles = fill(outer, chosen, cancellation_point);
    if (triangles.empty())
      return false;
    for (const Triangle& t : caps)
      m_builder.remove(m_builder.find_triangle(t[0], t[1], t[2]));
    std::size_t size = 0;
    for (const Boundary_loop& loop : chosen)
      size += loop.size();
    if (2 * number_of_folds(triangles) <= size && attach(triangles, on_verdict))
      return true;
    for (const Triangle& t : caps)
      m_builder.restore(t);
    return false;
  }

  // The triangles inside of an odd number of the loops; none if they do not bound a face.
  template <typename CancellationPoint>
  std::vector<Triangle> fill(const Planar_loop& outer, const std::vector<Boundary_loop>& chosen,
                             CancellationPoint& cancellation_point) const
  {
    Triangulation triangulation;
    const Local_vector u = m_points[(*outer.loop)[1]] - m_points[outer.loop->front()],
                       v = cross_product(outer.normal, u);
    std::size_t size = 0;
    for (const Boundary_loop& loop : chosen) {
      std::vector<typename Triangulation::Vertex_handle> vertices;
      for (Point_index p : loop) {
        cancellation_point();
        const Local_vector d = m_points[p] - outer.origin;
        vertices.push_back(triangulation.insert(Planar_point(d * u, d * v)));
        vertices.back()->info() = p;
      }
      for (std::size_t k = 0; k != loop.size(); ++k)
        if (vertices[k] != vertices[(k + 1) % loop.size()])
          triangulation.insert_constraint(vertices[k], vertices[(k + 1) % loop.size()]);
      size += loop.size();
    }
    // Loops that touch or cross each other in the plane do not bound a face.
    if (triangulation.number_of_vertices() != size || triangulation.dimension() != 2)
      return {};
    return triangles_inside(triangulation);
  }

  static std::vector<Triangle> triangles_inside(Triangulation& triangulation)
  {
    for (auto f = triangulation.all_faces_begin(); f != triangulation.all_faces_end(); ++f)
      f->info() = UNKNOWN;
    std::vector<Triangle> result;
    std::vector<Face_handle> todo(1, triangulation.infinite_face());
    todo.front()->info() = 0;
    while (!todo.empty()) {
      const Face_handle f = todo.back();
      todo.pop_back();
      if (f->info() == 1)
        result.push_back(Triangle{ { f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info() } });
      for (int i = 0; i != 3; ++i)
        if (f->neighbor(i)->info() == UNKNOWN) {
          f->neighbor(i)->info() = f->is_constrained(i) ? 1 - f->info() : f->info();
          todo.push_back(f->neighbor(i));
        }
    }
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

  // All triangles or none.
  template <typename OnVerdict>
  bool attach(const std::vector<Triangle>& triangles, OnVerdict& on_verdict)
  {
    const std::size_t before = m_builder.number_of_stored_triangles();
    for (const Triangle& t : triangles) {
      const Triangle_verdict verdict = m_builder.try_add(t[0], t[1], t[2]);
      on_verdict(t, verdict);
      if (verdict == Triangle_verdict::ADDED)
        continue;
      for (std::size_t added = m_builder.number_of_stored_triangles(); added-- != before;)
        m_builder.remove(static_cast<typename Builder::Triangle_index>(added));
      return false;
    }
    return true;
  }

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  std::size_t m_visits_left;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_FACE_FILLER_H

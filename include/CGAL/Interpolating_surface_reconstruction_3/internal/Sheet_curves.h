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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SHEET_CURVES_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SHEET_CURVES_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Closed curves through the points of a flat sheet, each point on one of them: where a face of a part is sampled along
// its edges only, they are the edges, while the triangles of the sheet fill its holes and notches, too. The curves are
// short ones among the edges of the Delaunay triangulation in the plane: the shortest first, where they leave no point
// with three; then points with less than two get them by changes along paths on which edges of curves alternate with
// others.
class Sheet_curves
{
public:
  using Triangle = std::array<Point_index, 3>;

  // The points of the sheet increase; `normal` is that of its plane. `cancellation_point()` is called again and again
  // and may throw.
  template <typename CancellationPoint>
  Sheet_curves(const std::vector<Local_point>& points, const std::vector<Point_index>& sheet,
               const Local_vector& normal, CancellationPoint&& cancellation_point)
    : m_points(points), m_sheet(sheet), m_spokes(sheet.size()), m_curves(sheet.size(), 0)
  {
    triangulate(normal);
    if (m_triangulation.number_of_vertices() != sheet.size() || m_triangulation.dimension() != 2)
      return;
    collect_edges();
    connect_nearest(cancellation_point);
    if (!complete(cancellation_point))
      return;
    trace(cancellation_point);
    m_are_closed = is_sampled_along_curves(cancellation_point);
  }

  // Whether there are such curves, and points are nearer to their neighbors on them than to what is across a face.
  bool are_closed() const { return m_are_closed; }

  // The nearest neighbor of the point with this position in the sheet is so far away.
  double nearest_distance(std::size_t i) const { return m_edges[m_spokes[i].front()].length; }

  // Calls visit(i, j) for each edge of the curves, with positions in the sheet.
  template <typename Visit>
  void for_each_curve_edge(Visit visit) const
  {
    for (const Edge& e : m_edges)
      if (e.is_on_curve)
        visit(e.ends[0], e.ends[1]);
  }

  // Calls visit(i, j, k) for each triangle between the curves, inside of an odd number of them.
  template <typename Visit>
  void for_each_triangle_inside(Visit visit) const
  {
    std::vector<Face_handle> todo(1, m_triangulation.infinite_face());
    todo.front()->info() = Side::OUTSIDE;
    while (!todo.empty()) {
      const Face_handle f = todo.back();
      todo.pop_back();
      if (f->info() == Side::INSIDE)
        visit(f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info());
      for (int i = 0; i != 3; ++i)
        if (f->neighbor(i)->info() == Side::UNKNOWN) {
          const bool is_across =
            !m_triangulation.is_infinite(typename Triangulation::Edge(f, i)) &&
            is_on_curve(f->vertex(Triangulation::cw(i))->info(), f->vertex(Triangulation::ccw(i))->info());
          f->neighbor(i)->info() = (f->info() == Side::INSIDE) != is_across ? Side::INSIDE : Side::OUTSIDE;
          todo.push_back(f->neighbor(i));
        }
    }
  }

private:
  // Curves are told from points all over a sheet if no point across a face is clearly nearer than the neighbors on the
  // curve, and from most points it is clearly farther: grids and random points have many that are nearer.
  static constexpr double CLEARLY = 1.25;

  // A point is across a face if the way to it along the curve is so many times as long. Round a circle it is less.
  static constexpr double DETOUR = 2.;

  // Points without two edges that paths can be expected to mend: in parts of all, and in all. It takes milliseconds each.
  static constexpr std::size_t PART_TO_MEND = 8, MAXIMUM_TO_MEND = 64;

  // Edges of a path: odd, so that it adds one more than it takes away.
  static constexpr std::size_t MAXIMUM_PATH = 15;

  enum class Side : unsigned char
  {
    UNKNOWN,
    OUTSIDE,
    INSIDE
  };

  using Planar_kernel = Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = Triangulation_vertex_base_with_info_2<std::size_t, Planar_kernel>;
  using Face_base = Triangulation_face_base_with_info_2<Side, Planar_kernel>;
  using Triangulation =
    Delaunay_triangulation_2<Planar_kernel, Triangulation_data_structure_2<Vertex_base, Face_base> >;
  using Face_handle = Triangulation::Face_handle;

  using Edge_index = std::size_t;
  static constexpr Edge_index NO_EDGE = static_cast<Edge_index>(-1);
  static constexpr std::size_t NO_CURVE = static_cast<std::size_t>(-1);

  struct Edge
  {
    std::array<std::size_t, 2> ends; // positions in the sheet
    double length;
    bool is_on_curve;
  };

  // In coordinates along the longest edge from the first point and across.
  void triangulate(const Local_vector& normal)
  {
    const Local_point& origin = m_points[m_sheet.front()];
    Local_vector u(0, 0, 0);
    for (Point_index p : m_sheet)
      if ((m_points[p] - origin).squared_length() > u.squared_length())
        u = m_points[p] - origin;
    const Local_vector v = cross_product(normal, u);
    std::vector<std::pair<Planar_kernel::Point_2, std::size_t> > sites;
    for (std::size_t i = 0; i != m_sheet.size(); ++i) {
      const Local_vector d = m_points[m_sheet[i]] - origin;
      sites.emplace_back(Planar_kernel::Point_2(d * u, d * v), i);
    }
    m_triangulation.insert(sites.begin(), sites.end());
    for (auto f = m_triangulation.all_faces_begin(); f != m_triangulation.all_faces_end(); ++f)
      f->info() = Side::UNKNOWN;
  }

  void collect_edges()
  {
    for (auto it = m_triangulation.finite_edges_begin(); it != m_triangulation.finite_edges_end(); ++it) {
      const std::size_t i = it->first->vertex(Triangulation::cw(it->second))->info(),
                        j = it->first->vertex(Triangulation::ccw(it->second))->info();
      m_edges.push_back(Edge{ { { (std::min)(i, j), (std::max)(i, j) } },
                              std::sqrt((m_points[m_sheet[i]] - m_points[m_sheet[j]]).squared_length()),
                              false });
    }
    std::sort(m_edges.begin(), m_edges.end(),
              [](const Edge& a, const Edge& b) { return std::tie(a.length, a.ends) < std::tie(b.length, b.ends); });
    for (Edge_index e = 0; e != m_edges.size(); ++e)
      for (std::size_t i : m_edges[e].ends)
        m_spokes[i].push_back(e);
  }

  bool is_on_curve(std::size_t i, std::size_t j) const
  {
    return std::any_of(m_spokes[i].begin(), m_spokes[i].end(),
                       [&](Edge_index e) { return m_edges[e].is_on_curve && other_end(e, i) == j; });
  }

  bool is_full(std::size_t i) const { return m_curves[i] == 2; }

  void put_on_curve(Edge_index e, bool is_on_curve)
  {
    m_edges[e].is_on_curve = is_on_curve;
    for (std::size_t i : m_edges[e].ends)
      m_curves[i] += is_on_curve ? 1 : -1;
  }

  // Edges by increasing length, where both ends have room.
  template <typename CancellationPoint>
  void connect_nearest(CancellationPoint& cancellation_point)
  {
    for (Edge_index e = 0; e != m_edges.size(); ++e) {
      cancellation_point();
      if (!is_full(m_edges[e].ends[0]) && !is_full(m_edges[e].ends[1]))
        put_on_curve(e, true);
    }
  }

  // Returns whether each point has two edges then.
  template <typename CancellationPoint>
  bool complete(CancellationPoint& cancellation_point)
  {
    const auto wanting = std::count_if(m_curves.begin(), m_curves.end(), [](int edges) { return edges != 2; });
    const auto number = static_cast<std::size_t>(wanting);
    if (number > MAXIMUM_TO_MEND || number * PART_TO_MEND > m_curves.size())
      return false;
    for (std::size_t i = 0; i != m_curves.size(); ++i)
      while (!is_full(i)) {
        cancellation_point();
        if (!mend(i))
          return false;
      }
    return true;
  }

  // Where a point is: on which curve, and how far along it.
  struct Place
  {
    std::size_t curve = NO_CURVE;
    double distance = 0.;
  };

  // Follows each curve from one of its points.
  template <typename CancellationPoint>
  void trace(CancellationPoint& cancellation_point)
  {
    m_places.resize(m_sheet.size());
    for (std::size_t first = 0; first != m_sheet.size(); ++first) {
      if (m_places[first].curve != NO_CURVE)
        continue;
      double length = 0.;
      std::size_t at = first;
      Edge_index by = NO_EDGE;
      do {
        cancellation_point();
        m_places[at].curve = m_lengths.size();
        m_places[at].distance = length;
        by = *std::find_if(m_spokes[at].begin(), m_spokes[at].end(),
                           [&](Edge_index e) { return e != by && m_edges[e].is_on_curve; });
        length += m_edges[by].length;
        at = other_end(by, at);
      } while (at != first);
      m_lengths.push_back(length);
    }
  }

  std::size_t other_end(Edge_index e, std::size_t i) const { return m_edges[e].ends[m_edges[e].ends[0] == i ? 1 : 0]; }

  bool is_across(const Edge& e) const
  {
    const Place &a = m_places[e.ends[0]], &b = m_places[e.ends[1]];
    const double along = std::abs(a.distance - b.distance);
    return a.curve != b.curve || (std::min)(along, m_lengths[a.curve] - along) > DETOUR * e.length;
  }

  template <typename CancellationPoint>
  bool is_sampled_along_curves(CancellationPoint& cancellation_point) const
  {
    std::size_t clear = 0;
    for (const Spokes& spokes : m_spokes) {
      cancellation_point();
      double along = 0., across = std::numeric_limits<double>::infinity();
      for (Edge_index e : spokes)
        if (m_edges[e].is_on_curve)
          along = (std::max)(along, m_edges[e].length);
        else if (is_across(m_edges[e]))
          across = (std::min)(across, m_edges[e].length);
      if (CLEARLY * across < along)
        return false;
      clear += across > CLEARLY * along ? 1u : 0u;
    }
    return 2 * clear > m_spokes.size();
  }

  // Where a path is after some edges: at a point, by the edge, with what all of its edges add to the length of the curves.
  struct Step
  {
    std::size_t at;
    Edge_index by;
    double length;
    std::size_t before; // in the last layer
  };
  using Layer = std::vector<Step>;

  // Adds an edge at the point and takes others away and adds them along the path to another point that lacks one, so
  // that the curves grow least.
  bool mend(std::size_t i)
  {
    std::vector<Layer> layers(1, Layer(1, Step{ i, NO_EDGE, 0., 0 }));
    std::size_t best_layer = 0, best = 0;
    double least = std::numeric_limits<double>::infinity();
    while (layers.size() <= MAXIMUM_PATH) {
      const bool adds = layers.size() % 2 == 1;
      layers.push_back(next_layer(layers, adds));
      const Layer& layer = layers.back();
      for (std::size_t k = 0; adds && k != layer.size(); ++k) {
        const bool lacks_edge = layer[k].at == i ? m_curves[i] == 0 : !is_full(layer[k].at);
        if (lacks_edge && layer[k].length < least) {
          least = layer[k].length;
          best_layer = layers.size() - 1;
          best = k;
        }
      }
    }
    for (std::size_t l = best_layer, k = best; l != 0; k = layers[l--][k].before)
      put_on_curve(layers[l][k].by, l % 2 == 1);
    return best_layer != 0;
  }

  // The shortest way to each point that the last layer reaches by edges that are not on curves, or that are.
  Layer next_layer(const std::vector<Layer>& layers, bool adds) const
  {
    const Layer& last = layers.back();
    Layer result;
    for (std::size_t k = 0; k != last.size(); ++k)
      for (Edge_index e : m_spokes[last[k].at]) {
        const Edge& edge = m_edges[e];
        if (edge.is_on_curve == adds || is_on_path(layers, k, e))
          continue;
        result.push_back(Step{ other_end(e, last[k].at), e, last[k].length + (adds ? edge.length : -edge.length), k });
      }
    std::sort(result.begin(), result.end(), [](const Step& a, const Step& b) {
      return std::tie(a.at, a.length, a.by) < std::tie(b.at, b.length, b.by);
    });
    result.erase(std::unique(result.begin(), result.end(), [](const Step& a, const Step& b) { return a.at == b.at; }),
                 result.end());
    return result;
  }

  static bool is_on_path(const std::vector<Layer>& layers, std::size_t k, Edge_index e)
  {
    for (std::size_t l = layers.size() - 1; l != 0; k = layers[l--][k].before)
      if (layers[l][k].by == e)
        return true;
    return false;
  }

  using Spokes = boost::container::small_vector<Edge_index, 8>;

  const std::vector<Local_point>& m_points;
  const std::vector<Point_index>& m_sheet;
  Triangulation m_triangulation;
  std::vector<Edge> m_edges;     // by increasing length
  std::vector<Spokes> m_spokes;  // of each point, its edges by increasing length
  std::vector<int> m_curves;     // of each point, the number of its edges that are on curves
  std::vector<Place> m_places;   // of each point
  std::vector<double> m_lengths; // of each curve
  bool m_are_closed = false;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SHEET_CURVES_H

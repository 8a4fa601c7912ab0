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

#ifndef ISR_BENCHMARK_METHODS_POWER_CRUST_POLES_H
#define ISR_BENCHMARK_METHODS_POWER_CRUST_POLES_H

#include "../../models/model_files.h"
#include "centers.h"

#include <CGAL/bounding_box.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace isr_benchmark {
namespace power_crust {

constexpr std::size_t NO_POLE = std::size_t(-1);

struct Poles
{
  std::vector<Kernel::Weighted_point_3> balls;       // around the poles, through their samples
  std::vector<std::array<std::size_t, 2> > of_point; // balls of the two poles of a sample, or NO_POLE
  std::vector<std::size_t> outer;                    // balls that are outside for sure
};

// The poles of a sample: the farthest vertex of its Voronoi cell, and the farthest one on the other
// side of the sample.
class Pole_finder
{
public:
  explicit Pole_finder(const std::vector<Point>& points) : m_points(points) { }

  Poles operator()()
  {
    m_result.of_point.assign(m_points.size(), { NO_POLE, NO_POLE });
    if (m_points.empty())
      return m_result;
    triangulate();
    for (auto v = m_delaunay.finite_vertices_begin(); v != m_delaunay.finite_vertices_end(); ++v)
      if (v->info() < m_points.size())
        add_poles(v);
    for (std::size_t i = 0; i != m_result.of_point.size(); ++i)
      for (std::size_t ball : m_result.of_point[i])
        if (ball != NO_POLE && m_touches_corner[ball])
          m_result.outer.push_back(ball);
    return m_result;
  }

private:
  struct Cell_info
  {
    bool has_center = false;
    Point center;
    std::size_t ball = NO_POLE;
  };
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel>;
  using Cell_base =
    CGAL::Triangulation_cell_base_with_info_3<Cell_info, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel> >;
  using Delaunay =
    CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base> >;
  using Vertex_handle = Delaunay::Vertex_handle;
  using Cell_handle = Delaunay::Cell_handle;

  // With the corners of a box five times as large as that of the points, all Voronoi cells of the
  // points are bounded, and cells at the corners are outside.
  void triangulate()
  {
    std::vector<std::pair<Point, std::size_t> > sites;
    for (std::size_t i = 0; i != m_points.size(); ++i)
      sites.emplace_back(m_points[i], i);
    const auto box = CGAL::bounding_box(m_points.begin(), m_points.end());
    const Point center = CGAL::midpoint((box.min)(), (box.max)());
    const double diagonal = std::sqrt(CGAL::squared_distance((box.min)(), (box.max)()));
    const double size = diagonal > 0. ? 2.5 * diagonal : 1.;
    for (int corner = 0; corner != 8; ++corner)
      sites.emplace_back(center + Vector((corner & 1) != 0 ? size : -size, (corner & 2) != 0 ? size : -size,
                                         (corner & 4) != 0 ? size : -size),
                         m_points.size());
    m_delaunay.insert(sites.begin(), sites.end());
  }

  void add_poles(Vertex_handle v)
  {
    m_cells.clear();
    m_delaunay.finite_incident_cells(v, std::back_inserter(m_cells));
    const Point& p = v->point();
    const Cell_handle first = farthest(p, [](const Vector&) { return true; });
    if (first == Cell_handle())
      return;
    const Vector direction = first->info().center - p;
    const Cell_handle second = farthest(p, [&](const Vector& w) { return w * direction < 0.; });
    m_result.of_point[v->info()] = { ball_of(first), second == Cell_handle() ? NO_POLE : ball_of(second) };
  }

  template <typename Accept>
  Cell_handle farthest(const Point& p, Accept accept) const
  {
    Cell_handle result;
    double maximum = 0.;
    for (Cell_handle cell : m_cells) {
      const Vector w = center(cell) - p;
      if (w.squared_length() > maximum && accept(w)) {
        maximum = w.squared_length();
        result = cell;
      }
    }
    return result;
  }

  const Point& center(Cell_handle cell) const
  {
    if (!cell->info().has_center) {
      cell->info().center = m_centers.circumcenter(cell);
      cell->info().has_center = true;
    }
    return cell->info().center;
  }

  std::size_t ball_of(Cell_handle cell)
  {
    if (cell->info().ball == NO_POLE) {
      cell->info().ball = m_result.balls.size();
      const double weight = CGAL::squared_distance(cell->info().center, cell->vertex(0)->point());
      m_result.balls.emplace_back(cell->info().center, weight);
      bool touches_corner = false;
      for (int i = 0; i != 4; ++i)
        touches_corner = touches_corner || cell->vertex(i)->info() == m_points.size();
      m_touches_corner.push_back(touches_corner);
    }
    return cell->info().ball;
  }

  const std::vector<Point>& m_points;
  Delaunay m_delaunay;
  Centers m_centers;
  std::vector<Cell_handle> m_cells; // around the vertex at hand
  std::vector<bool> m_touches_corner;
  Poles m_result;
};

inline Poles find_poles(const std::vector<Point>& points) { return Pole_finder(points)(); }

} // namespace power_crust
} // namespace isr_benchmark

#endif // ISR_BENCHMARK_METHODS_POWER_CRUST_POLES_H

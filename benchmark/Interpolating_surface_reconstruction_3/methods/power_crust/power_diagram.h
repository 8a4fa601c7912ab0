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

#ifndef ISR_BENCHMARK_METHODS_POWER_CRUST_POWER_DIAGRAM_H
#define ISR_BENCHMARK_METHODS_POWER_CRUST_POWER_DIAGRAM_H

#include "../../models/model_files.h"
#include "centers.h"

#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace isr_benchmark {
namespace power_crust {

// Power diagram of balls, as the dual of their regular triangulation.
class Power_diagram
{
public:
  explicit Power_diagram(const std::vector<Kernel::Weighted_point_3>& balls)
  {
    std::vector<std::pair<Kernel::Weighted_point_3, std::size_t> > sites;
    for (std::size_t i = 0; i != balls.size(); ++i)
      sites.emplace_back(balls[i], i);
    m_triangulation.insert(sites.begin(), sites.end());
    m_neighbors.resize(balls.size());
    if (m_triangulation.dimension() < 3)
      return;
    for (auto e = m_triangulation.finite_edges_begin(); e != m_triangulation.finite_edges_end(); ++e) {
      const std::size_t i = e->first->vertex(e->second)->info(), j = e->first->vertex(e->third)->info();
      m_neighbors[i].push_back(j);
      m_neighbors[j].push_back(i);
    }
  }

  const std::vector<std::size_t>& neighbors(std::size_t ball) const { return m_neighbors[ball]; }

  // The faces between cells of balls inside and cells of balls outside, oriented outward.
  void faces_between(const std::vector<char>& is_inside, std::vector<Point>& vertices,
                     std::vector<Triangle>& triangles) const
  {
    if (m_triangulation.dimension() < 3)
      return;
    for (auto e = m_triangulation.finite_edges_begin(); e != m_triangulation.finite_edges_end(); ++e) {
      const Vertex_handle u = e->first->vertex(e->second), v = e->first->vertex(e->third);
      if (is_inside[u->info()] != is_inside[v->info()])
        add_face(*e, is_inside[u->info()] != 0, vertices, triangles);
    }
  }

private:
  struct Cell_info
  {
    std::size_t vertex = std::size_t(-1);
  };
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel,
                                                                  CGAL::Regular_triangulation_vertex_base_3<Kernel> >;
  using Cell_base =
    CGAL::Triangulation_cell_base_with_info_3<Cell_info, Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel> >;
  using Triangulation =
    CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base> >;
  using Vertex_handle = Triangulation::Vertex_handle;
  using Cell_handle = Triangulation::Cell_handle;

  // The face dual to an edge has the weighted circumcenters of the cells around the edge as vertices.
  void add_face(const Triangulation::Edge& edge, bool first_is_inside, std::vector<Point>& vertices,
                std::vector<Triangle>& triangles) const
  {
    std::vector<std::size_t> face;
    auto cell = m_triangulation.incident_cells(edge);
    const auto end = cell;
    do {
      if (m_triangulation.is_infinite(cell))
        return;
      face.push_back(vertex_of(cell, vertices));
    } while (++cell != end);
    // Cells pass counterclockwise as seen from the second end of the edge.
    for (std::size_t i = 2; i < face.size(); ++i)
      triangles.push_back(first_is_inside ? Triangle{ face[0], face[i - 1], face[i] }
                                          : Triangle{ face[0], face[i], face[i - 1] });
  }

  std::size_t vertex_of(Cell_handle cell, std::vector<Point>& vertices) const
  {
    if (cell->info().vertex == std::size_t(-1)) {
      cell->info().vertex = vertices.size();
      vertices.push_back(m_centers.weighted_circumcenter(cell));
    }
    return cell->info().vertex;
  }

  Triangulation m_triangulation;
  Centers m_centers;
  std::vector<std::vector<std::size_t> > m_neighbors;
};

} // namespace power_crust
} // namespace isr_benchmark

#endif // ISR_BENCHMARK_METHODS_POWER_CRUST_POWER_DIAGRAM_H

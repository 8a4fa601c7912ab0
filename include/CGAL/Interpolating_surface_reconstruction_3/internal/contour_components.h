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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONTOUR_COMPONENTS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONTOUR_COMPONENTS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Adaptive_grid.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Leaves those components of a contour that are the nearest one to a seed. Others are where the signs of the
// function change far from all samples, as between two planes that both end there.
class Contour_components
{
public:
  using Coordinates = Adaptive_grid::Coordinates;
  using Triangle = std::array<std::size_t, 3>;

  Contour_components(const Adaptive_grid& grid, std::vector<Coordinates>& vertices, std::vector<Triangle>& triangles)
    : m_grid(grid), m_vertices(vertices), m_triangles(triangles), m_component(vertices.size())
  { }

  void keep_nearest_to(const std::vector<Coordinates>& seeds)
  {
    find_components();
    sort_into_leaves();
    std::vector<unsigned char> is_kept(m_vertices.size(), 0); // by the number of a component
    for (const Coordinates& seed : seeds) {
      const std::size_t v = nearest_vertex(seed);
      if (v != NO_VERTEX)
        is_kept[m_component[v]] = 1;
    }
    remove_others(is_kept);
  }

private:
  static constexpr std::size_t NO_VERTEX = (std::numeric_limits<std::size_t>::max)();

  // A component has the number of one of its vertices.
  void find_components()
  {
    boost::disjoint_sets_with_storage<> sets(m_vertices.size());
    for (const Triangle& t : m_triangles) {
      sets.union_set(t[0], t[1]);
      sets.union_set(t[0], t[2]);
    }
    for (std::size_t v = 0; v != m_vertices.size(); ++v)
      m_component[v] = sets.find_set(v);
  }

  void sort_into_leaves()
  {
    for (std::size_t v = 0; v != m_vertices.size(); ++v)
      m_vertex_in.emplace_back(m_grid.locate(m_vertices[v]).node, v);
    std::sort(m_vertex_in.begin(), m_vertex_in.end());
  }

  // Of those in the leaf of x and beside it.
  std::size_t nearest_vertex(const Coordinates& x) const
  {
    std::size_t nearest = NO_VERTEX;
    double smallest = std::numeric_limits<double>::infinity();
    const auto look = [&](const Adaptive_grid::Leaf& leaf) {
      for (auto it =
             std::lower_bound(m_vertex_in.begin(), m_vertex_in.end(), std::make_pair(leaf.node, std::size_t(0)));
           it != m_vertex_in.end() && it->first == leaf.node; ++it) {
        double squared = 0.;
        for (std::size_t a = 0; a != 3; ++a)
          squared += (m_vertices[it->second][a] - x[a]) * (m_vertices[it->second][a] - x[a]);
        if (squared < smallest) {
          smallest = squared;
          nearest = it->second;
        }
      }
    };
    const Adaptive_grid::Leaf leaf = m_grid.locate(x);
    look(leaf);
    m_grid.for_each_face(leaf, [&](const Adaptive_grid::Face& face) { look(face.neighbor); });
    return nearest;
  }

  void remove_others(const std::vector<unsigned char>& is_kept)
  {
    std::vector<std::size_t> new_index(m_vertices.size(), 0);
    std::size_t size = 0;
    for (std::size_t v = 0; v != m_vertices.size(); ++v)
      if (is_kept[m_component[v]]) {
        m_vertices[size] = m_vertices[v];
        new_index[v] = size++;
      }
    m_vertices.resize(size);
    m_triangles.erase(std::remove_if(m_triangles.begin(), m_triangles.end(),
                                     [&](const Triangle& t) { return !is_kept[m_component[t[0]]]; }),
                      m_triangles.end());
    for (Triangle& t : m_triangles)
      for (std::size_t& v : t)
        v = new_index[v];
  }

  const Adaptive_grid& m_grid;
  std::vector<Coordinates>& m_vertices;
  std::vector<Triangle>& m_triangles;
  std::vector<std::size_t> m_component;
  std::vector<std::pair<std::uint32_t, std::size_t> > m_vertex_in; // leaf and vertex
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONTOUR_COMPONENTS_H

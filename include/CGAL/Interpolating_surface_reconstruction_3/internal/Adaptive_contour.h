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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ADAPTIVE_CONTOUR_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ADAPTIVE_CONTOUR_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Adaptive_grid.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Tetrahedra_contour.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/contour_components.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The zero set of a function in the tetrahedra of an adaptive grid, followed from leaves where it is known
// to be. The function is evaluated at leaves that it passes through and at leaves beside them.
template <typename ConcurrencyTag, typename Function>
class Adaptive_contour
{
public:
  using Coordinates = Adaptive_grid::Coordinates;
  using Triangle = Tetrahedra_contour::Triangle;

  // `function(x)` is negative inside, and is called concurrently.
  Adaptive_contour(const Function& function, const Adaptive_grid& grid)
    : m_function(function), m_grid(grid), m_state(grid.number_of_nodes(), UNSEEN)
  { }

  // The surface may pass through the leaf of x or through one beside it.
  void add_seed(const Coordinates& x)
  {
    visit(m_grid.locate(x));
    m_seeds.push_back(x);
  }

  void operator()()
  {
    const std::size_t seeds = m_leaves.size();
    for (std::size_t first = 0; first != m_leaves.size();) {
      const std::size_t last = m_leaves.size();
      for (std::size_t k = first; k != last; ++k)
        find_faces(m_leaves[k]);
      evaluate();
      for (std::size_t k = first; k != last; ++k)
        classify(k);
      evaluate();
      for (std::size_t k = first; k != last; ++k)
        follow(k, k < seeds);
      first = last;
    }
    for (std::size_t k = 0; k != m_leaves.size(); ++k)
      cut(k);
    place_vertices();
    m_triangles = m_contour.triangles();
    Contour_components(m_grid, m_vertices, m_triangles).keep_nearest_to(m_seeds);
  }

  const std::vector<Coordinates>& vertices() const { return m_vertices; }
  const std::vector<Triangle>& triangles() const { return m_triangles; }
  std::size_t number_of_visited_leaves() const { return m_leaves.size(); }

private:
  using Corner = Tetrahedra_contour::Corner;
  using Lattice_point = Adaptive_grid::Lattice_point;
  using Leaf = Adaptive_grid::Leaf;

  // Of a visited leaf.
  struct Face
  {
    Leaf neighbor;
    Corner neighbor_center;
    bool is_neighbor_above;
    std::size_t end; // of its corners, which begin at the end of those of the face before
  };

  enum State : unsigned char
  {
    UNSEEN,
    VISITED,
    CROSSED
  };

  struct Hash
  {
    std::size_t operator()(const Lattice_point& p) const
    {
      std::uint64_t h = 0;
      for (std::uint32_t c : p)
        h = (h ^ c) * 0x9E3779B97F4A7C15u, h ^= h >> 29;
      return static_cast<std::size_t>(h);
    }
  };

  static constexpr std::size_t EVALUATIONS_PER_BLOCK = 256;

  // A vertex that is nearer to the end of its edge than this part of it moves away. Beside the error of a linear
  // function in a tetrahedron that is little.
  static constexpr double MARGIN = 1. / 1024;

  // Of a vertex on its edge: the function is not linear.
  static constexpr int SECANT_STEPS = 1;

  void visit(const Leaf& leaf)
  {
    if (m_state[leaf.node] != UNSEEN)
      return;
    m_state[leaf.node] = VISITED;
    m_leaves.push_back(leaf);
  }

  Corner corner(const Lattice_point& p)
  {
    const auto it = m_corner_at.emplace(p, static_cast<Corner>(m_points.size()));
    if (it.second)
      m_points.push_back(p);
    return it.first->second;
  }

  bool is_inside(Corner c) const { return m_values[c] < 0.; }

  std::size_t first_face(std::size_t leaf) const { return leaf == 0 ? 0 : m_end_of_faces[leaf - 1]; }
  std::size_t first_corner(std::size_t face) const { return face == 0 ? 0 : m_faces[face - 1].end; }

  // Computes the values at all new corners.
  void evaluate()
  {
    const std::size_t first = m_values.size();
    m_values.resize(m_points.size());
    for_each_block<ConcurrencyTag>(m_points.size() - first, EVALUATIONS_PER_BLOCK,
                                   [&](std::size_t begin, std::size_t end) {
                                     for (std::size_t k = first + begin; k != first + end; ++k)
                                       m_values[k] = m_function(m_grid.coordinates(m_points[k]));
                                   });
  }

  void find_faces(const Leaf& leaf)
  {
    m_centers.push_back(corner(leaf.center()));
    m_grid.for_each_face(leaf, [&](const Adaptive_grid::Face& face) {
      for (const Lattice_point& p : face.corners)
        m_corners_of_faces.push_back(corner(p));
      const bool is_above = face.neighbor.origin[face.axis] >= leaf.origin[face.axis] + leaf.size;
      m_faces.push_back(Face{ face.neighbor, 0, is_above, m_corners_of_faces.size() });
    });
    m_end_of_faces.push_back(m_faces.size());
  }

  // Whether a sign at a face is not that at the center of the leaf.
  bool is_crossed(std::size_t face, bool is_center_inside) const
  {
    for (std::size_t i = first_corner(face); i != m_faces[face].end; ++i)
      if (is_inside(m_corners_of_faces[i]) != is_center_inside)
        return true;
    return false;
  }

  // A leaf is crossed if the signs at its center and on its boundary differ. The centers beside it are wanted then.
  void classify(std::size_t leaf)
  {
    const std::size_t begin = first_face(leaf), end = m_end_of_faces[leaf];
    const bool is_center_inside = is_inside(m_centers[leaf]);
    std::size_t face = begin;
    while (face != end && !is_crossed(face, is_center_inside))
      ++face;
    if (face == end)
      return;
    m_state[m_leaves[leaf].node] = CROSSED;
    for (face = begin; face != end; ++face)
      m_faces[face].neighbor_center = corner(m_faces[face].neighbor.center());
  }

  // Visits the leaves across the faces that the surface passes by; across all, if a leaf of a seed is not crossed.
  void follow(std::size_t leaf, bool is_seed)
  {
    const bool is_uncrossed = m_state[m_leaves[leaf].node] != CROSSED, is_center_inside = is_inside(m_centers[leaf]);
    if (is_uncrossed && !is_seed)
      return;
    for (std::size_t face = first_face(leaf); face != m_end_of_faces[leaf]; ++face)
      if (is_uncrossed || is_inside(m_faces[face].neighbor_center) != is_center_inside ||
          is_crossed(face, is_center_inside))
        visit(m_faces[face].neighbor);
  }

  // The tetrahedra at the faces of a crossed leaf. If both leaves at a face are crossed, the lower one has them.
  void cut(std::size_t leaf)
  {
    if (m_state[m_leaves[leaf].node] != CROSSED)
      return;
    for (std::size_t f = first_face(leaf); f != m_end_of_faces[leaf]; ++f) {
      const Face& face = m_faces[f];
      if (!face.is_neighbor_above && m_state[face.neighbor.node] == CROSSED)
        continue;
      const std::size_t begin = first_corner(f), n = face.end - begin;
      for (std::size_t i = 0; i != n; ++i)
        m_contour.add({ { m_corners_of_faces[begin + i], m_corners_of_faces[begin + (i + 1) % n], m_centers[leaf],
                          face.neighbor_center } },
                      m_values, face.is_neighbor_above);
    }
  }

  void place_vertices()
  {
    const std::vector<Tetrahedra_contour::Edge>& edges = m_contour.vertices();
    m_vertices.resize(edges.size());
    for_each_block<ConcurrencyTag>(edges.size(), EVALUATIONS_PER_BLOCK, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v != end; ++v)
        m_vertices[v] = vertex(edges[v].first, edges[v].second);
    });
  }

  // The zero on the edge between two corners.
  Coordinates vertex(Corner inside, Corner outside) const
  {
    const Coordinates a = m_grid.coordinates(m_points[inside]), b = m_grid.coordinates(m_points[outside]);
    const auto at = [&](double t) {
      return Coordinates{ { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) } };
    };
    double low = 0., high = 1., low_value = m_values[inside], high_value = m_values[outside];
    const auto secant = [&] {
      const double t = low + (high - low) * (low_value / (low_value - high_value));
      return (std::min)((std::max)(t, MARGIN), 1. - MARGIN);
    };
    double t = secant();
    for (int step = 0; step != SECANT_STEPS; ++step) {
      const double f = m_function(at(t));
      (f < 0. ? low : high) = t;
      (f < 0. ? low_value : high_value) = f;
      t = secant();
    }
    return at(t);
  }

  const Function& m_function;
  const Adaptive_grid& m_grid;
  std::vector<State> m_state; // of the nodes
  std::vector<Coordinates> m_seeds;
  std::vector<Leaf> m_leaves; // in the order of their visit
  std::vector<Corner> m_centers;
  std::vector<std::size_t> m_end_of_faces;
  std::vector<Face> m_faces;
  std::vector<Corner> m_corners_of_faces;
  std::unordered_map<Lattice_point, Corner, Hash> m_corner_at;
  std::vector<Lattice_point> m_points; // of the corners
  std::vector<double> m_values;
  Tetrahedra_contour m_contour;
  std::vector<Coordinates> m_vertices;
  std::vector<Triangle> m_triangles;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ADAPTIVE_CONTOUR_H

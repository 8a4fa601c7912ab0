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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LINEAR_PIECES_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LINEAR_PIECES_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The mean distance of every point to the neighbors in its star (thesis Eq. 5.3), or to another point
// next to it in the order if the star is empty.
inline std::vector<double> star_radii(const std::vector<Local_point>& positions, const Star_table& stars)
{
  std::vector<double> radii(positions.size(), 0.);
  for (Point_index p = 0; p != stars.size(); ++p) {
    double sum = 0.;
    std::size_t neighbors = 0;
    for (Star_table::Slot s = stars.begin(p); s != stars.end(p); ++s)
      if (stars.neighbor(s) != NO_POINT) {
        sum += std::sqrt((positions[stars.neighbor(s)] - positions[p]).squared_length());
        ++neighbors;
      }
    if (neighbors != 0)
      radii[p] = sum / double(neighbors);
    else if (positions.size() > 1)
      radii[p] = std::sqrt((positions[p == 0 ? 1 : p - 1] - positions[p]).squared_length());
  }
  return radii;
}

// The tangent planes at the samples (thesis Eq. 5.4) and the radii that they reach, with an index that
// finds those that reach a point.
class Linear_pieces
{
public:
  // The blended heights, their gradient, the blended offsets from the samples, and a direction of the
  // normal. That is to vary evenly between the samples, and is blended by the fourth root of the weights,
  // which is the inverse of the distance if the function interpolates.
  struct Value
  {
    double value;
    Local_vector gradient, normal, offset;
  };

  // Unit normals; positive radii. At least one sample.
  Linear_pieces(std::vector<Local_point> positions, std::vector<Local_vector> normals, std::vector<double> radii)
    : m_positions(std::move(positions)), m_normals(std::move(normals)), m_radii(std::move(radii)),
      m_octree(m_positions), m_largest_radius(m_octree.nodes().size(), 0.)
  {
    for (std::size_t i = m_largest_radius.size(); i-- != 0;) {
      const Point_octree_3::Node& n = m_octree.node(static_cast<std::uint32_t>(i));
      if (n.number_of_children == 0)
        m_largest_radius[i] = *std::max_element(m_radii.begin() + n.begin, m_radii.begin() + n.end);
      for (std::uint32_t c = n.first_child; c != n.first_child + n.number_of_children; ++c)
        m_largest_radius[i] = (std::max)(m_largest_radius[i], m_largest_radius[c]);
    }
  }

  Linear_pieces(const Linear_pieces&) = delete; // the index refers to the positions
  Linear_pieces& operator=(const Linear_pieces&) = delete;

  const std::vector<Local_point>& positions() const { return m_positions; }
  const std::vector<Local_vector>& normals() const { return m_normals; }
  const std::vector<double>& radii() const { return m_radii; }

  // The planes blended by their weights (thesis Eq. 5.6); where no weight reaches, the nearest plane. At
  // a sample, the weights that grow without bound there leave its own plane only.
  template <typename Weight>
  Value operator()(const Local_point& x, const Weight& weight) const
  {
    Nearest nearest{ 0, std::numeric_limits<double>::infinity() };
    find_nearest(0, x, nearest);
    const Local_vector& nearest_normal = m_normals[nearest.index];
    const Local_vector nearest_offset = x - m_positions[nearest.index];
    const Value plane{ nearest_normal * nearest_offset, nearest_normal, nearest_normal, nearest_offset };
    const double support = weight.support();
    const double nearest_support = support * m_radii[nearest.index];
    if (!(weight(nearest.squared_distance / (nearest_support * nearest_support), 1.) < LARGEST_WEIGHT))
      return plane;
    double sum = 0., sum_of_values = 0.;
    Local_vector gradient_of_sum(0, 0, 0), gradient_of_values(0, 0, 0), normals(0, 0, 0), smooth_normal(0, 0, 0),
      offsets(0, 0, 0);
    for_each_reaching(0, x, support, [&](Point_index i) {
      const Local_vector v = x - m_positions[i];
      const double squared_support = support * support * m_radii[i] * m_radii[i],
                   ratio = v.squared_length() / squared_support;
      if (!(ratio < 1.))
        return;
      const double agreement = m_normals[i] * nearest_normal, w = weight(ratio, agreement), height = m_normals[i] * v;
      const Local_vector gradient = (2. * weight.derivative(ratio, agreement) / squared_support) * v;
      sum += w;
      sum_of_values += w * height;
      smooth_normal = smooth_normal + std::sqrt(std::sqrt(w)) * m_normals[i];
      normals = normals + w * m_normals[i];
      offsets = offsets + w * v;
      gradient_of_sum = gradient_of_sum + gradient;
      gradient_of_values = gradient_of_values + height * gradient;
    });
    if (!(sum > 0.))
      return plane;
    const double value = sum_of_values / sum;
    return Value{ value, (gradient_of_values + normals - value * gradient_of_sum) / sum, smooth_normal, offsets / sum };
  }

  // A point near the surface moved onto it. Between samples, the planes overshoot a curved surface by as
  // much as the chords undershoot it, and the mean of both, the height over a plane through the sample that
  // is normal to the mean of its normal and the normal at x, is right on a sphere.
  template <typename Weight>
  Local_point moved_to_surface(Local_point x, const Weight& weight) const
  {
    for (int step = 0; step != STEPS_TO_SURFACE; ++step) {
      const Value f = (*this)(x, weight);
      const double length = std::sqrt(f.normal.squared_length());
      if (!(length > 0.))
        return x;
      const Local_vector n = f.normal / length;
      x = x - (f.value + n * f.offset) / 2 * n;
    }
    return x;
  }

private:
  static constexpr int STEPS_TO_SURFACE = 2; // the second corrects the normal

  struct Nearest
  {
    Point_index index;
    double squared_distance;
  };

  // Beside this weight of the nearest sample no other counts, and its derivative does not overflow yet.
  static constexpr double LARGEST_WEIGHT = 1e60;

  // Of equally near ones, the one with the smallest index.
  void find_nearest(std::uint32_t index, const Local_point& x, Nearest& nearest) const
  {
    const Point_octree_3::Node& node = m_octree.node(index);
    if (node.number_of_children == 0) {
      for (Point_index i = node.begin; i != node.end; ++i) {
        const double squared = (m_positions[i] - x).squared_length();
        if (squared < nearest.squared_distance || (squared == nearest.squared_distance && i < nearest.index))
          nearest = Nearest{ i, squared };
      }
      return;
    }
    std::pair<double, std::uint32_t> children[8];
    for (std::uint32_t c = 0; c != node.number_of_children; ++c)
      children[c] = { m_octree.node(node.first_child + c).box.squared_distance(x), node.first_child + c };
    std::sort(children, children + node.number_of_children);
    for (std::uint32_t c = 0; c != node.number_of_children; ++c)
      if (children[c].first <= nearest.squared_distance)
        find_nearest(children[c].second, x, nearest);
  }

  // Calls visit(i) for the samples of all leaves that may reach x.
  template <typename Visit>
  void for_each_reaching(std::uint32_t index, const Local_point& x, double support, const Visit& visit) const
  {
    const Point_octree_3::Node& node = m_octree.node(index);
    const double reach = support * m_largest_radius[index];
    if (node.box.squared_distance(x) > reach * reach)
      return;
    if (node.number_of_children == 0)
      for (Point_index i = node.begin; i != node.end; ++i)
        visit(i);
    for (std::uint32_t c = node.first_child; c != node.first_child + node.number_of_children; ++c)
      for_each_reaching(c, x, support, visit);
  }

  const std::vector<Local_point> m_positions;
  const std::vector<Local_vector> m_normals;
  const std::vector<double> m_radii;
  const Point_octree_3 m_octree;
  std::vector<double> m_largest_radius; // of the samples of each node
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LINEAR_PIECES_H

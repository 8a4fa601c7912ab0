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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LID_REMOVAL_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LID_REMOVAL_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Point_star.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Edge_spacings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Nearest_search.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Opens what spans openings of the sampled surface. The stars around a small opening see across it and agree on
// triangles there, and the completion of conflicts closes what it can. Such a lid consists of triangles between the
// points of its outline that share edges longer than the spacing of these, and most of the points have neighbors on one
// side only (angle criterion of Bendels, Schnabel and Klein, Detecting holes in point set surfaces, 2006).
template <typename Builder, typename StarConstruction>
class Lid_removal
{
public:
  Lid_removal(const std::vector<Local_point>& points, const Point_octree_3& octree,
              const StarConstruction& construct_star, Builder& builder)
    : m_points(points), m_construct_star(construct_star), m_builder(builder), m_search(points, octree),
      m_spacings(points)
  { }

  // Returns whether there were lids. Ends early if cancelled.
  template <typename Progress>
  bool operator()(Progress& progress)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    std::vector<Triangle> lids;
    try {
      find_spacings(cancellation_point);
      std::vector<Triangle> seeds;
      m_builder.for_each_triangle([&](const Triangle& t, auto) {
        if (has_edge_far_longer(t))
          seeds.push_back(sorted(t));
      });
      for (const Triangle& seed : seeds)
        if (m_is_seen.count(seed) == 0) {
          const std::vector<Triangle> region = region_of(seed, cancellation_point);
          if (is_lid(region, cancellation_point))
            lids.insert(lids.end(), region.begin(), region.end());
        }
    } catch (const Cancelled&) {
      return false;
    }
    for (const Triangle& t : lids)
      for (Point_index p : t)
        m_builder.open(p);
    for (const Triangle& t : lids)
      m_builder.remove(m_builder.find_triangle(t[0], t[1], t[2]));
    return !lids.empty();
  }

private:
  using Triangle = typename Builder::Triangle;

  // The outline of an opening ten spacings wide has 32 edges. Smaller ones cannot be told from gaps of a scan.
  static constexpr std::size_t MINIMUM_SIZE = 30;

  // Beside a straight outline there are no neighbors within 180 degrees; it may be curved, and jagged.
  static constexpr double LEAST_ANGLE = CGAL_PI * 3. / 4.;

  // As many as span the first plane of a star.
  static constexpr std::size_t NEIGHBORS = 16;

  static Triangle sorted(Triangle t)
  {
    std::sort(t.begin(), t.end());
    return t;
  }

  template <typename CancellationPoint>
  void find_spacings(CancellationPoint& cancellation_point)
  {
    std::vector<Point_index> neighbors;
    for (Point_index p = 0; p != m_points.size(); ++p) {
      cancellation_point();
      neighbors.clear();
      m_builder.for_each_triangle_at(p, [&](const Triangle& t) { neighbors.insert(neighbors.end(), { t[1], t[2] }); });
      std::sort(neighbors.begin(), neighbors.end());
      m_spacings.set(p, neighbors.begin(), std::unique(neighbors.begin(), neighbors.end()));
    }
  }

  bool has_edge_far_longer(const Triangle& t) const
  {
    return m_spacings.is_longer(t[0], t[1], Edge_spacings::FAR_LONGER) ||
           m_spacings.is_longer(t[1], t[2], Edge_spacings::FAR_LONGER) ||
           m_spacings.is_longer(t[2], t[0], Edge_spacings::FAR_LONGER);
  }

  // The triangles connected to the seed across long edges.
  template <typename CancellationPoint>
  std::vector<Triangle> region_of(const Triangle& seed, CancellationPoint& cancellation_point)
  {
    std::vector<Triangle> region(1, seed);
    m_is_seen.insert(seed);
    for (std::size_t k = 0; k != region.size(); ++k)
      for (std::size_t i = 0; i != 3; ++i) {
        cancellation_point();
        const Point_index p = region[k][i], q = region[k][(i + 1) % 3];
        if (m_spacings.is_longer(p, q, Edge_spacings::LONGER))
          m_builder.for_each_triangle_at(p, [&](const Triangle& t) {
            if ((t[1] == q || t[2] == q) && m_is_seen.insert(sorted(t)).second)
              region.push_back(sorted(t));
          });
      }
    return region;
  }

  // A small region is one only at what is open already.
  template <typename CancellationPoint>
  bool is_lid(const std::vector<Triangle>& region, CancellationPoint& cancellation_point)
  {
    const bool extends_opening = is_at_boundary(region);
    std::vector<Point_index> outline;
    return (extends_opening || region.size() >= MINIMUM_SIZE) && is_polygon(region, outline) &&
           is_wider(region, outline, extends_opening ? 1. : Edge_spacings::LONGER) &&
           end_samples_at(outline, cancellation_point);
  }

  bool is_at_boundary(const std::vector<Triangle>& region) const
  {
    return std::any_of(region.begin(), region.end(), [&](const Triangle& t) {
      return is_boundary(t[0], t[1]) || is_boundary(t[1], t[2]) || is_boundary(t[2], t[0]);
    });
  }

  bool is_boundary(Point_index p, Point_index q) const
  {
    return m_builder.is_open(p) && m_builder.number_of_triangles(p, q) == 1;
  }

  // Whether its edges are so many times as long as those of the other triangles at its points, of which each must have
  // some. Between two rows of a scan they are not.
  bool is_wider(const std::vector<Triangle>& region, const std::vector<Point_index>& outline, double times) const
  {
    const std::set<Triangle> triangles(region.begin(), region.end());
    double width = 0., width_beside = 0.;
    for (Point_index p : outline) {
      double longest = 0., longest_beside = 0.;
      m_builder.for_each_triangle_at(p, [&](const Triangle& t) {
        const double length = std::sqrt(
          (std::max)((m_points[t[1]] - m_points[p]).squared_length(), (m_points[t[2]] - m_points[p]).squared_length()));
        double& l = triangles.count(sorted(t)) != 0 ? longest : longest_beside;
        l = (std::max)(l, length);
      });
      if (longest_beside == 0.)
        return false;
      width += longest;
      width_beside += longest_beside;
    }
    return width > times * width_beside;
  }

  // Whether the region is a disk without points inside; collects those of its outline.
  bool is_polygon(const std::vector<Triangle>& region, std::vector<Point_index>& outline) const
  {
    std::vector<std::pair<Point_index, Point_index> > edges;
    for (const Triangle& t : region) {
      edges.insert(edges.end(), { { t[0], t[1] }, { t[1], t[2] }, { t[0], t[2] } });
      outline.insert(outline.end(), t.begin(), t.end());
    }
    std::sort(outline.begin(), outline.end());
    outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
    std::sort(edges.begin(), edges.end());
    std::size_t boundary_edges = 0;
    for (std::size_t i = 0; i != edges.size(); ++i)
      boundary_edges +=
        (i == 0 || edges[i - 1] != edges[i]) && (i + 1 == edges.size() || edges[i + 1] != edges[i]) ? 1u : 0u;
    // a connected surface of n triangles between n + 2 points, all of them on its boundary
    return outline.size() == region.size() + 2 && boundary_edges == outline.size();
  }

  // Whether most of the points have no neighbors within a large angle.
  template <typename CancellationPoint>
  bool end_samples_at(const std::vector<Point_index>& outline, CancellationPoint& cancellation_point)
  {
    std::size_t ends = 0;
    for (Point_index p : outline) {
      cancellation_point();
      ends += largest_angle_without_neighbors(p) >= LEAST_ANGLE ? 1u : 0u;
    }
    return 2 * ends >= outline.size();
  }

  // In the plane of the star of the nearest neighbors.
  double largest_angle_without_neighbors(Point_index p)
  {
    m_offsets.clear();
    double squared_radius = 0.;
    for (const Nearest_search::Neighbor& n : m_search(p, NEIGHBORS, std::numeric_limits<double>::infinity())) {
      m_offsets.push_back(m_points[n.second] - m_points[p]);
      squared_radius = n.first;
    }
    m_construct_star(Star_neighborhood(m_offsets.data(), m_offsets.size(), squared_radius), m_star);
    const Local_vector& normal = m_star.normal;
    const double length = std::sqrt(normal.squared_length());
    if (m_offsets.empty() || !(length > 0.))
      return 0.;
    const Local_vector axis =
      std::abs(normal.x()) < std::abs(normal.y()) ? Local_vector(1, 0, 0) : Local_vector(0, 1, 0);
    const Local_vector u = cross_product(normal, axis);
    const Local_vector v = cross_product(normal, u) / length;
    m_angles.clear();
    for (const Local_vector& offset : m_offsets)
      m_angles.push_back(std::atan2(offset * v, offset * u));
    std::sort(m_angles.begin(), m_angles.end());
    double largest = m_angles.front() + 2. * CGAL_PI - m_angles.back();
    for (std::size_t i = 1; i != m_angles.size(); ++i)
      largest = (std::max)(largest, m_angles[i] - m_angles[i - 1]);
    return largest;
  }

  const std::vector<Local_point>& m_points;
  const StarConstruction& m_construct_star;
  Builder& m_builder;
  Nearest_search m_search;
  Edge_spacings m_spacings;
  std::set<Triangle> m_is_seen; // with increasing vertices
  std::vector<Local_vector> m_offsets;
  std::vector<double> m_angles;
  Point_star m_star;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LID_REMOVAL_H

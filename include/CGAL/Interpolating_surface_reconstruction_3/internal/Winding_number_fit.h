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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_WINDING_NUMBER_FIT_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_WINDING_NUMBER_FIT_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Dipole_view.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Nearest_search.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Area vectors of points in doubt that agree with all others of a closed surface: the winding number is one half at its
// points, which a step of steepest descent aims at (Lin, Xiao, Shi and Wang, Surface reconstruction from point clouds
// without normals by parametrizing the Gauss formula, ACM Transactions on Graphics 42, 2022), and falls along the normals, to
// which they are turned after each step (Lin, Shi and Liu, Fast and globally consistent normal orientation based on the
// winding number normal consistency, ACM Transactions on Graphics 43, 2024). Caps that close the surface where it should
// go on are outvoted in this way.
class Winding_number_fit
{
public:
  // `all` are the points of the surface.
  Winding_number_fit(const std::vector<Local_point>& points, const Point_octree_3& octree,
                     const std::vector<Point_index>& all)
    : m_points(points), m_octree(octree), m_all(all)
  { }

  // `areas` are those of all points, outward; those of the doubts change. Takes time in proportion to the product of the numbers
  // of points and doubts. `cancellation_point()` is called again and again and may throw.
  template <typename CancellationPoint>
  void operator()(const std::vector<Point_index>& doubts, std::vector<Local_vector>& areas,
                  CancellationPoint& cancellation_point)
  {
    find_softenings(doubts);
    for (int round = 0; round != ROUNDS; ++round) {
      descend(doubts, areas, cancellation_point);
      turn(doubts, areas, cancellation_point);
    }
  }

private:
  // Measured: thirty join other parts, and no more of them.
  static constexpr int ROUNDS = 10;

  static constexpr double FOUR_PI = 12.5663706143591729538;

  void find_softenings(const std::vector<Point_index>& doubts)
  {
    Nearest_search search(m_points, m_octree);
    m_softenings.clear();
    for (Point_index p : doubts) {
      const auto& nearest = search(p, DIPOLE_NEIGHBORS, std::numeric_limits<double>::infinity());
      m_softenings.push_back(DIPOLE_SOFTENING * DIPOLE_SOFTENING * nearest.back().first);
    }
  }

  Dipole_view view(Point_index from, Point_index dipole, double softening) const
  {
    return Dipole_view(m_points[dipole] - m_points[from], softening);
  }

  // Towards winding numbers of one half at the doubts.
  template <typename CancellationPoint>
  void descend(const std::vector<Point_index>& doubts, std::vector<Local_vector>& areas,
               CancellationPoint& cancellation_point)
  {
    const std::size_t n = doubts.size();
    m_residuals.assign(n, .5);
    for (std::size_t k = 0; k != n; ++k)
      for (Point_index q : m_all) {
        cancellation_point();
        m_residuals[k] -= view(doubts[k], q, m_softenings[k]).potential(areas[q]) / FOUR_PI;
      }
    m_steps.assign(n, Local_vector(0, 0, 0));
    for (std::size_t k = 0; k != n; ++k)
      for (std::size_t l = 0; l != n; ++l) {
        cancellation_point();
        m_steps[l] = m_steps[l] + m_residuals[k] / FOUR_PI * view(doubts[k], doubts[l], m_softenings[k]).direction();
      }
    double squared_step = 0., squared_effect = 0.;
    for (std::size_t k = 0; k != n; ++k) {
      double effect = 0.;
      for (std::size_t l = 0; l != n; ++l) {
        cancellation_point();
        effect += view(doubts[k], doubts[l], m_softenings[k]).potential(m_steps[l]) / FOUR_PI;
      }
      squared_step += m_steps[k].squared_length();
      squared_effect += effect * effect;
    }
    const double length = squared_step / squared_effect;
    if (std::isfinite(length))
      for (std::size_t k = 0; k != n; ++k)
        areas[doubts[k]] = areas[doubts[k]] + length * m_steps[k];
  }

  template <typename CancellationPoint>
  void turn(const std::vector<Point_index>& doubts, std::vector<Local_vector>& areas,
            CancellationPoint& cancellation_point)
  {
    m_steps.assign(doubts.size(), Local_vector(0, 0, 0));
    for (std::size_t k = 0; k != doubts.size(); ++k)
      for (Point_index q : m_all) {
        cancellation_point();
        m_steps[k] = m_steps[k] + view(doubts[k], q, m_softenings[k]).field(areas[q]);
      }
    for (std::size_t k = 0; k != doubts.size(); ++k)
      areas[doubts[k]] = turned_to_field(areas[doubts[k]], m_steps[k]);
  }

  const std::vector<Local_point>& m_points;
  const Point_octree_3& m_octree;
  const std::vector<Point_index>& m_all;
  std::vector<double> m_softenings, m_residuals; // of the doubts
  std::vector<Local_vector> m_steps;             // of the same
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_WINDING_NUMBER_FIT_H

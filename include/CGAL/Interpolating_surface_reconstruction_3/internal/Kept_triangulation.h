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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_KEPT_TRIANGULATION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_KEPT_TRIANGULATION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Site_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Delaunay cells of sets of points, one after the other, most of which are the same. A triangulation is kept, from which
// the points are removed that are not of the next set and into which the others are inserted: the cells depend on the
// points only.
class Kept_triangulation
{
public:
  // Larger ones would take too much memory for as long as they are kept.
  static constexpr std::size_t MAXIMUM_POINTS = 1 << 15;

  explicit Kept_triangulation(const std::vector<Local_point>& positions) : m_positions(positions) { }

  // Keeps a triangulation that has been made for something else, unless it is too large.
  void adopt(std::unique_ptr<Site_triangulation> triangulation)
  {
    if (!triangulation->is_usable() || triangulation->delaunay().number_of_vertices() > MAXIMUM_POINTS)
      return;
    m_cells.reset();
    m_sites = triangulation->sites();
    m_triangulation = std::move(triangulation);
  }

  void clear()
  {
    m_triangulation.reset();
    m_sites.clear();
    m_cells.reset();
  }

  // `points` are increasing. `cancellation_point()` is called again and again and may throw: nothing is kept then.
  template <typename Cancellation_point>
  std::shared_ptr<const Cell_complex> operator()(const std::vector<Point_index>& points,
                                                 Cancellation_point& cancellation_point)
  {
    if (m_cells && points == m_sites)
      return m_cells;
    std::vector<Point_index> removed, added;
    std::set_difference(m_sites.begin(), m_sites.end(), points.begin(), points.end(), std::back_inserter(removed));
    const bool is_like_kept = m_triangulation && removed.size() <= m_sites.size() / PART_REMOVED;
    // The largest set is likely to be asked for again.
    if (points.size() > MAXIMUM_POINTS || (!is_like_kept && points.size() < m_sites.size()))
      return std::make_shared<const Cell_complex>(m_positions, points, cancellation_point);
    std::unique_ptr<Site_triangulation> triangulation = std::move(m_triangulation);
    m_cells.reset();
    if (!is_like_kept) {
      triangulation = std::make_unique<Site_triangulation>(m_positions);
      m_sites.clear();
      removed.clear();
    }
    std::set_difference(points.begin(), points.end(), m_sites.begin(), m_sites.end(), std::back_inserter(added));
    m_sites.clear();
    triangulation->insert(added, cancellation_point);
    triangulation->remove(removed, cancellation_point);
    const auto result = std::make_shared<const Cell_complex>(*triangulation, points, cancellation_point);
    if (triangulation->is_usable()) {
      m_triangulation = std::move(triangulation);
      m_sites = points;
      m_cells = result;
    }
    return result;
  }

private:
  // To remove a point takes several times what it takes to insert one.
  static constexpr std::size_t PART_REMOVED = 16;

  const std::vector<Local_point>& m_positions;
  std::unique_ptr<Site_triangulation> m_triangulation;
  std::vector<Point_index> m_sites;            // of the triangulation, increasing
  std::shared_ptr<const Cell_complex> m_cells; // of the triangulation, if they have been asked for
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_KEPT_TRIANGULATION_H

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
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Delaunay cells of sets of points, one after the other. The triangulation of the largest set so far is kept with its
// cells, and grows into those of sets that it is a part of: the cells do not depend on the order of insertion.
class Kept_triangulation
{
public:
  explicit Kept_triangulation(const std::vector<Local_point>& positions) : m_positions(positions) { }

  // `points` are increasing. `cancellation_point()` is called again and again and may throw: nothing is kept then.
  template <typename Cancellation_point>
  std::shared_ptr<const Cell_complex> operator()(const std::vector<Point_index>& points,
                                                 Cancellation_point& cancellation_point)
  {
    if (m_cells && points == m_cells->points())
      return m_cells;
    if (m_cells && points.size() < m_cells->points().size())
      return std::make_shared<const Cell_complex>(m_positions, points, cancellation_point);
    std::unique_ptr<Site_triangulation> triangulation = std::move(m_triangulation);
    std::vector<Point_index> old, added;
    if (const std::shared_ptr<const Cell_complex> cells = std::move(m_cells))
      old = cells->points();
    if (!triangulation || !std::includes(points.begin(), points.end(), old.begin(), old.end())) {
      triangulation = std::make_unique<Site_triangulation>(m_positions);
      old.clear();
    }
    std::set_difference(points.begin(), points.end(), old.begin(), old.end(), std::back_inserter(added));
    triangulation->insert(added, cancellation_point);
    const auto result = std::make_shared<const Cell_complex>(*triangulation, points, cancellation_point);
    if (triangulation->is_usable()) {
      m_triangulation = std::move(triangulation);
      m_cells = result;
    }
    return result;
  }

private:
  const std::vector<Local_point>& m_positions;
  std::unique_ptr<Site_triangulation> m_triangulation;
  std::shared_ptr<const Cell_complex> m_cells; // of the triangulation, if there is one
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_KEPT_TRIANGULATION_H

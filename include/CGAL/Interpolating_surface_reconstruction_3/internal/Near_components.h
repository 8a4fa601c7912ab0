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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_NEAR_COMPONENTS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_NEAR_COMPONENTS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Component_contacts.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/orientation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_exchange.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The components of a closed surface that are nearer to each other than their own points, in groups, each of which may
// give way to a surface of fewer components.
template <typename Builder>
class Near_components
{
public:
  using Triangle = typename Builder::Triangle;
  using Triangles = std::vector<Triangle>;

  // `cancellation_point()` is called again and again and may throw.
  template <typename Progress, typename CancellationPoint>
  Near_components(const std::vector<Local_point>& points, const Point_octree_3& octree, Builder& builder,
                  Progress& progress, CancellationPoint& cancellation_point)
    : m_points(points), m_builder(builder), m_contacts(points, triangles_of(builder))
  {
    if (m_contacts.size() < 2)
      return;
    m_contacts.find(octree, cancellation_point);
    if (m_contacts.near().empty())
      return;
    m_triangles = oriented_triangles(points, {}, builder, [&] { return progress.advance(0.); });
    m_groups = m_contacts.groups();
    m_groups.erase(std::remove_if(m_groups.begin(), m_groups.end(),
                                  [](const auto& group) { return group.size() > Kept_triangulation::MAXIMUM_POINTS; }),
                   m_groups.end());
  }

  const Component_contacts& contacts() const { return m_contacts; }

  // The points of each, increasing; of as many as a kept triangulation may have, at most.
  const std::vector<std::vector<Point_index> >& groups() const { return m_groups; }

  // Those of a group before any change, oriented outward.
  Triangles triangles(const std::vector<Point_index>& group) const
  {
    Triangles result;
    std::copy_if(m_triangles.begin(), m_triangles.end(), std::back_inserter(result),
                 [&](const Triangle& t) { return std::binary_search(group.begin(), group.end(), t[0]); });
    return result;
  }

  // Exchanges the triangles of a group for others, if these have fewer components and leave no point out. Returns
  // whether it does.
  template <typename CancellationPoint>
  bool exchange(const std::vector<Point_index>& group, const Triangles& old, Triangles added,
                CancellationPoint& cancellation_point)
  {
    const Component_contacts before(m_points, old), after(m_points, added);
    const bool has_all = std::all_of(group.begin(), group.end(),
                                     [&](Point_index p) { return after.is_on_surface(p) || !before.is_on_surface(p); });
    return has_all && after.size() < before.size() &&
           !exchange_triangles(m_builder, group, std::move(added), cancellation_point).empty();
  }

private:
  static Triangles triangles_of(const Builder& builder)
  {
    Triangles result;
    builder.for_each_triangle([&](const Triangle& t, auto) { result.push_back(t); });
    return result;
  }

  const std::vector<Local_point>& m_points;
  Builder& m_builder;
  Component_contacts m_contacts;
  Triangles m_triangles; // of the surface as it was, oriented
  std::vector<std::vector<Point_index> > m_groups;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_NEAR_COMPONENTS_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SITES_AROUND_DOUBTS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SITES_AROUND_DOUBTS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Conflict_surroundings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The points of a component that are enough to make its surface anew where it is in doubt: all that are near, and a few
// of the others, which tell the inside from the outside far from the surface.
template <typename Builder>
class Sites_around_doubts
{
public:
  Sites_around_doubts(const std::vector<Local_point>& points, const Point_octree_3& octree, double maximum_radius,
                      const Builder& builder)
    : m_builder(builder), m_surroundings(points, octree, maximum_radius, builder.compatibility().stars())
  { }

  // `component` is increasing. All of its points are sites if they are few, or if most of them would be.
  // `cancellation_point()` is called again and again and may throw.
  template <typename CancellationPoint>
  void find(const std::vector<Point_index>& component, const std::vector<unsigned char>& is_in_doubt,
            CancellationPoint& cancellation_point)
  {
    m_incomplete.clear();
    m_sites = component;
    const std::size_t far_sites = (std::min)(MAXIMUM_FAR_SITES, component.size() / PART_OF_FAR_SITES);
    find_near(component, is_in_doubt, cancellation_point);
    if (far_sites == 0 || 2 * (m_sites.size() + far_sites) > component.size()) {
      m_sites = component;
      return;
    }
    for (Point_index p : m_sites)
      if (!is_complete(p))
        m_incomplete.push_back(p);
    add_far(component, far_sites);
  }

  // Increasing.
  const std::vector<Point_index>& sites() const { return m_sites; }
  // Those that have triangles with points that are no sites.
  const std::vector<Point_index>& incomplete() const { return m_incomplete; }

private:
  // What tells the inside from the outside need not be fine: as many, and no more than that part of the component.
  static constexpr std::size_t MAXIMUM_FAR_SITES = 4096, PART_OF_FAR_SITES = 8;

  // Beyond what the completion of a conflict must see, so that cells at points in doubt have complete points.
  static constexpr int RINGS = 4;

  static constexpr std::size_t MICROSECONDS_PER_SURROUNDINGS = 32;

  template <typename CancellationPoint>
  void find_near(const std::vector<Point_index>& component, const std::vector<unsigned char>& is_in_doubt,
                 CancellationPoint& cancellation_point)
  {
    m_sites.clear();
    std::vector<Point_index> around;
    for (Point_index p : component)
      if (is_in_doubt[p]) {
        cancellation_point(MICROSECONDS_PER_SURROUNDINGS);
        m_surroundings(p, around);
        m_sites.insert(m_sites.end(), around.begin(), around.end());
      }
    make_unique();
    for (int ring = 0; ring != RINGS; ++ring) {
      for (std::size_t k = 0, size = m_sites.size(); k != size; ++k) {
        cancellation_point();
        m_builder.for_each_triangle_at(m_sites[k],
                                       [&](const Triangle& t) { m_sites.insert(m_sites.end(), t.begin(), t.end()); });
      }
      make_unique();
    }
    std::vector<Point_index> of_component;
    std::set_intersection(m_sites.begin(), m_sites.end(), component.begin(), component.end(),
                          std::back_inserter(of_component));
    m_sites.swap(of_component);
  }

  bool is_complete(Point_index p) const
  {
    bool result = true;
    m_builder.for_each_triangle_at(p, [&](const Triangle& t) {
      for (Point_index q : t)
        result = result && std::binary_search(m_sites.begin(), m_sites.end(), q);
    });
    return result;
  }

  void add_far(const std::vector<Point_index>& component, std::size_t number)
  {
    const std::size_t stride = (component.size() + number - 1) / number;
    std::vector<Point_index> far;
    for (std::size_t k = 0; k < component.size(); k += stride)
      if (!std::binary_search(m_sites.begin(), m_sites.end(), component[k]))
        far.push_back(component[k]);
    for (std::vector<Point_index>* points : { &m_sites, &m_incomplete }) {
      const auto middle = static_cast<std::ptrdiff_t>(points->size());
      points->insert(points->end(), far.begin(), far.end());
      std::inplace_merge(points->begin(), points->begin() + middle, points->end());
    }
  }

  void make_unique()
  {
    std::sort(m_sites.begin(), m_sites.end());
    m_sites.erase(std::unique(m_sites.begin(), m_sites.end()), m_sites.end());
  }

  using Triangle = std::array<Point_index, 3>;

  const Builder& m_builder;
  Conflict_surroundings m_surroundings;
  std::vector<Point_index> m_sites, m_incomplete;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SITES_AROUND_DOUBTS_H

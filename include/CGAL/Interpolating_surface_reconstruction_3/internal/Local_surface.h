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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LOCAL_SURFACE_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LOCAL_SURFACE_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The surface as the completion of one cluster of conflicts changes it: triangles are withdrawn and points join the
// conflict. The builder stays as it is, so that several clusters can be completed at the same time.
template <typename Builder>
class Local_surface
{
public:
  using Facet = std::array<Point_index, 3>;

  // `is_conflict` tells of each point whether it was in conflict before.
  Local_surface(const Builder& builder, const std::vector<unsigned char>& is_conflict)
    : m_builder(builder), m_was_conflict(is_conflict)
  { }

  // Forgets the changes.
  void reset()
  {
    m_has_joined.resize(m_was_conflict.size(), 0);
    for (Point_index p : m_joined)
      m_has_joined[p] = 0;
    m_joined.clear();
    m_withdrawn.clear();
  }

  bool is_conflict(Point_index p) const { return m_was_conflict[p] != 0 || m_has_joined[p] != 0; }

  // Withdraws triangles, which have increasing vertices. Calls visit(point) for the points that join the conflict.
  template <typename Visit>
  void withdraw(std::vector<Facet> triangles, const Visit& visit)
  {
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    const std::size_t before = m_withdrawn.size();
    m_withdrawn.insert(m_withdrawn.end(), triangles.begin(), triangles.end());
    std::inplace_merge(m_withdrawn.begin(), m_withdrawn.begin() + std::ptrdiff_t(before), m_withdrawn.end());
    for (const Facet& t : triangles)
      for (Point_index p : t)
        if (!is_conflict(p)) {
          m_has_joined[p] = 1;
          m_joined.push_back(p);
          visit(p);
        }
  }

  // In order, with increasing vertices.
  const std::vector<Facet>& withdrawn() const { return m_withdrawn; }

  bool has_triangle(const Facet& f) const
  {
    const bool had = m_builder.is_open(f[0])
                       ? m_builder.find_triangle(f[0], f[1], f[2]) != Builder::NO_TRIANGLE
                       : m_builder.compatibility().stars().view(f[0], f[1], f[2]) != Star_table::View::ABSENT;
    return had && !is_withdrawn(f);
  }

  // Orientation of a triangle against the representative of its connected part.
  std::optional<Parity_union_find::Oriented_root> orientation(const Facet& f) const
  {
    return m_builder.orientation(f[0], f[1], f[2]);
  }

  // Whether the surface at a point that is not in conflict is one closed fan.
  bool is_complete(Point_index p) const { return !m_builder.is_open(p) || m_builder.is_fan_closed(p); }

  // Calls visit(triangle) for the triangles at a point that is not in conflict, or before any is withdrawn.
  template <typename Visit>
  void for_each_triangle_at(Point_index p, const Visit& visit) const
  {
    m_builder.for_each_triangle_at(p, visit);
  }

private:
  bool is_withdrawn(Facet f) const
  {
    if (m_withdrawn.empty() || !(is_conflict(f[0]) && is_conflict(f[1]) && is_conflict(f[2])))
      return false;
    std::sort(f.begin(), f.end());
    return std::binary_search(m_withdrawn.begin(), m_withdrawn.end(), f);
  }

  const Builder& m_builder;
  const std::vector<unsigned char>& m_was_conflict;
  std::vector<unsigned char> m_has_joined; // of each point
  std::vector<Point_index> m_joined;
  std::vector<Facet> m_withdrawn; // in order
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LOCAL_SURFACE_H

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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TEMPORARY_LIDS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TEMPORARY_LIDS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_loops.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Opens boundaries again that were closed for stages that need a closed surface. Such stages may change a lid, but what
// closes a loop still lies between points of the loop: it is told from the surface by that this had none such.
template <typename Builder>
class Temporary_lids
{
public:
  explicit Temporary_lids(Builder& builder) : m_builder(builder) { }

  // The loops are about to be closed.
  void expect_at(std::vector<Boundary_loop> loops)
  {
    m_loops = std::move(loops);
    m_triangles_before.clear();
    for (Boundary_loop& loop : m_loops) {
      std::sort(loop.begin(), loop.end());
      for_each_triangle_of(loop, [&](const Triangle& t) { m_triangles_before.push_back(t); });
    }
    std::sort(m_triangles_before.begin(), m_triangles_before.end());
  }

  void remove()
  {
    std::vector<Triangle> lids;
    for (const Boundary_loop& loop : m_loops)
      for_each_triangle_of(loop, [&](const Triangle& t) {
        if (!std::binary_search(m_triangles_before.begin(), m_triangles_before.end(), t))
          lids.push_back(t);
      });
    for (const Triangle& t : lids) {
      for (Point_index p : t)
        m_builder.open(p);
      const auto index = m_builder.find_triangle(t[0], t[1], t[2]);
      if (index != Builder::NO_TRIANGLE) // it may be between points of two loops
        m_builder.remove(index);
    }
    m_loops.clear();
  }

private:
  using Triangle = typename Builder::Triangle;

  // Calls visit(triangle) for those between three points of the loop, which are sorted, with increasing vertices.
  template <typename Visit>
  void for_each_triangle_of(const Boundary_loop& loop, const Visit& visit) const
  {
    const auto is_on_loop = [&](Point_index p) { return std::binary_search(loop.begin(), loop.end(), p); };
    for (std::size_t i = 0; i != loop.size(); ++i)
      if (i == 0 || loop[i] != loop[i - 1])
        m_builder.for_each_triangle_at(loop[i], [&](Triangle t) {
          std::sort(t.begin(), t.end());
          if (t[0] == loop[i] && is_on_loop(t[1]) && is_on_loop(t[2]))
            visit(t);
        });
  }

  Builder& m_builder;
  std::vector<Boundary_loop> m_loops;       // each sorted
  std::vector<Triangle> m_triangles_before; // between points of one loop, sorted
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_TEMPORARY_LIDS_H

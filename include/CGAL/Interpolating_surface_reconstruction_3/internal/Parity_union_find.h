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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PARITY_UNION_FIND_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PARITY_UNION_FIND_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Disjoint sets whose elements carry an orientation relative to their set's representative.
class Parity_union_find
{
public:
  using Element = std::uint32_t;

  struct Oriented_root
  {
    Element root;
    bool is_flipped;
  };

  explicit Parity_union_find(std::size_t n) : m_parent(n), m_is_flipped(n, 0)
  {
    for (std::size_t i = 0; i != n; ++i)
      m_parent[i] = static_cast<Element>(i);
  }

  Element add()
  {
    m_parent.push_back(static_cast<Element>(m_parent.size()));
    m_is_flipped.push_back(0);
    return m_parent.back();
  }

  std::size_t size() const { return m_parent.size(); }

  // The representative, and whether the element is oriented against it. Halves the path.
  Oriented_root find(Element e)
  {
    unsigned char flipped = 0;
    while (m_parent[e] != e) {
      const Element parent = m_parent[e];
      m_is_flipped[e] = static_cast<unsigned char>(m_is_flipped[e] ^ m_is_flipped[parent]);
      m_parent[e] = m_parent[parent];
      flipped = static_cast<unsigned char>(flipped ^ m_is_flipped[e]);
      e = m_parent[e];
    }
    return Oriented_root{ e, flipped != 0 };
  }

  // The same, without a change: several threads may ask.
  Oriented_root find(Element e) const
  {
    unsigned char flipped = 0;
    for (; m_parent[e] != e; e = m_parent[e])
      flipped = static_cast<unsigned char>(flipped ^ m_is_flipped[e]);
    return Oriented_root{ e, flipped != 0 };
  }

  // Joins the sets of a and b so that b is oriented against a if `is_flipped`; false if they are in
  // one set already, the other way round.
  bool unite(Element a, Element b, bool is_flipped)
  {
    const Oriented_root ra = find(a), rb = find(b);
    const bool relative = (ra.is_flipped != rb.is_flipped) != is_flipped;
    if (ra.root == rb.root)
      return !relative;
    // The smaller index stays the root: elements are created in spatial order, so paths stay short.
    const Element root = (std::min)(ra.root, rb.root), child = (std::max)(ra.root, rb.root);
    m_parent[child] = root;
    m_is_flipped[child] = relative ? 1 : 0;
    return true;
  }

private:
  std::vector<Element> m_parent;
  std::vector<unsigned char> m_is_flipped;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PARITY_UNION_FIND_H

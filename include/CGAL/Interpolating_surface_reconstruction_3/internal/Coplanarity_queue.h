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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_COPLANARITY_QUEUE_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_COPLANARITY_QUEUE_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <boost/dynamic_bitset.hpp>
#include <boost/heap/d_ary_heap.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// A queue of entries by classes of similar `coplanarity`, a cosine; the most coplanar class is on top. Within
// a class, the entries whose order matters come last, the greatest of them first. The others come before
// them, the last one pushed first: it lies where the caller has just been, so that what it needs is still in
// the cache. A growth that jumps over the surface for each entry waits for memory most of its time.
template <typename Entry>
class Coplanarity_queue
{
public:
  Coplanarity_queue() : m_classes(CLASSES), m_is_filled(CLASSES) { }

  bool empty() const { return m_is_filled.none(); }
  const Entry& top() const
  {
    const Class& c = m_classes[m_is_filled.find_first()];
    return c.unordered.empty() ? c.ordered.top() : c.unordered.back();
  }

  void push(const Entry& entry, bool is_order_needed)
  {
    const std::size_t k = class_of(entry.coplanarity);
    if (is_order_needed)
      m_classes[k].ordered.push(entry);
    else
      m_classes[k].unordered.push_back(entry);
    m_is_filled.set(k);
  }

  void pop()
  {
    const std::size_t k = m_is_filled.find_first();
    Class& c = m_classes[k];
    if (c.unordered.empty())
      c.ordered.pop();
    else
      c.unordered.pop_back();
    m_is_filled.set(k, !c.unordered.empty() || !c.ordered.empty());
  }

private:
  struct Class
  {
    std::vector<Entry> unordered;
    boost::heap::d_ary_heap<Entry, boost::heap::arity<4> > ordered;
  };

  // One for each time that 1 - cosine is halved, that is, the angle shrinks by the square root of two, down
  // to where the cosine hardly differs from one.
  static constexpr int CLASSES = 32;

  // Not greater for a greater coplanarity.
  static std::size_t class_of(double coplanarity)
  {
    const double gap = std::ldexp(1. - coplanarity, CLASSES - 2); // at most 2^(CLASSES - 1), but for rounding
    if (!(gap >= 1.))
      return 0;
    return static_cast<std::size_t>((std::min)(std::ilogb(gap), CLASSES - 1));
  }

  std::vector<Class> m_classes; // the most coplanar one first
  boost::dynamic_bitset<> m_is_filled;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_COPLANARITY_QUEUE_H

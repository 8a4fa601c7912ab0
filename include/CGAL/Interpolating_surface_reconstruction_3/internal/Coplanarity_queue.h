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

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// A queue of entries by `coplanarity`, a cosine, that comes first in their order; the greatest entry is on
// top. A heap over a long front is larger than the cache, and misses it on nearly every level. Here
// there is a heap for each class of similar coplanarity; growth stays in the best ones, which are small.
template <typename Entry>
class Coplanarity_queue
{
public:
  Coplanarity_queue() : m_heaps(CLASSES), m_is_filled(CLASSES) { }

  bool empty() const { return m_is_filled.none(); }
  const Entry& top() const { return m_heaps[m_is_filled.find_first()].top(); }

  void push(const Entry& entry)
  {
    const std::size_t k = class_of(entry.coplanarity);
    m_heaps[k].push(entry);
    m_is_filled.set(k);
  }

  void pop()
  {
    const std::size_t k = m_is_filled.find_first();
    m_heaps[k].pop();
    m_is_filled.set(k, !m_heaps[k].empty());
  }

private:
  // Eight of each time that the angle shrinks by the square root of two, down to where the cosine hardly
  // differs from one.
  static constexpr int CLASSES_PER_OCTAVE = 8, OCTAVES = 32;
  static constexpr std::size_t CLASSES = std::size_t(CLASSES_PER_OCTAVE) * std::size_t(OCTAVES);

  // Not greater for a greater coplanarity.
  static std::size_t class_of(double coplanarity)
  {
    const double gap = std::ldexp(1. - coplanarity, OCTAVES - 2); // less than 2^OCTAVES
    if (!(gap >= 1.))
      return 0;
    int exponent;
    const double mantissa = std::frexp(gap, &exponent); // in [1/2, 1)
    const std::size_t k = static_cast<std::size_t>((exponent - 1) * CLASSES_PER_OCTAVE) +
                          static_cast<std::size_t>((mantissa * 2. - 1.) * CLASSES_PER_OCTAVE);
    return k < CLASSES ? k : CLASSES - 1;
  }

  std::vector<boost::heap::d_ary_heap<Entry, boost::heap::arity<4> > > m_heaps; // the most coplanar class first
  boost::dynamic_bitset<> m_is_filled;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_COPLANARITY_QUEUE_H

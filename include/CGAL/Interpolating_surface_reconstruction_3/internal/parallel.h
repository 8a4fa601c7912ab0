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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PARALLEL_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PARALLEL_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#endif

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

template <typename ConcurrencyTag>
struct Is_parallel : std::bool_constant<std::is_convertible<ConcurrencyTag, Parallel_tag>::value>
{ };

// Calls body(begin, end) on the blocks [0, block_size), [block_size, 2 block_size), ... of [0, n).
// Blocks do not depend on the number of threads, so a body that writes to its block only is
// deterministic.
template <typename ConcurrencyTag, typename Body>
void for_each_block(std::size_t n, std::size_t block_size, const Body& body)
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_same<ConcurrencyTag, Parallel_tag>::value, "Parallel_tag is enabled but TBB is unavailable.");
#else
  if constexpr (Is_parallel<ConcurrencyTag>::value) {
    const std::size_t blocks = (n + block_size - 1) / block_size;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks, 1), [&](const tbb::blocked_range<std::size_t>& range) {
      for (std::size_t b = range.begin(); b != range.end(); ++b)
        body(b * block_size, (std::min)(n, (b + 1) * block_size));
    });
    return;
  }
#endif
  for (std::size_t begin = 0; begin < n; begin += block_size)
    body(begin, (std::min)(n, begin + block_size));
}

// An object for each thread, made when it first asks for one.
template <typename ConcurrencyTag, typename T>
class Thread_locals
{
public:
  explicit Thread_locals(std::function<std::unique_ptr<T>()> make) : m_make(std::move(make)) { }

  T& local()
  {
    std::unique_ptr<T>* object = nullptr;
#ifdef CGAL_LINKED_WITH_TBB
    if constexpr (Is_parallel<ConcurrencyTag>::value)
      object = &m_objects.local();
#endif
    if (object == nullptr)
      object = &m_object;
    if (*object == nullptr)
      *object = m_make();
    return **object;
  }

private:
  std::function<std::unique_ptr<T>()> m_make;
  std::unique_ptr<T> m_object; // without threads
#ifdef CGAL_LINKED_WITH_TBB
  tbb::enumerable_thread_specific<std::unique_ptr<T> > m_objects;
#endif
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_PARALLEL_H

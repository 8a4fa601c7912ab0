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

#ifndef ISR_FUZZ_SURFACE_H
#define ISR_FUZZ_SURFACE_H

#include "isr_fuzz_input.h"

#include "../isr_surface_test_utils.h"

#include <algorithm>
#include <cstddef>

namespace isr_fuzz {

using isr_test::Hand_surface;
using isr_test::Link;
using isr_test::Links;

// Stars as a StarConstruction_3 may return them: different neighbors, any number of gaps.
inline Links read_links(Byte_stream& in, std::size_t number_of_points)
{
  Links links(number_of_points);
  for (std::size_t p = 0; p != number_of_points; ++p)
    for (std::size_t size = in.below(8); size != 0; --size) {
      const std::size_t q = in.below(number_of_points + 1);
      const isr_test::Point_index neighbor = q == number_of_points ? isr_test::NO_POINT : isr_test::Point_index(q);
      if (q != p &&
          (neighbor == isr_test::NO_POINT || std::find(links[p].begin(), links[p].end(), neighbor) == links[p].end()))
        links[p].push_back(neighbor);
    }
  return links;
}

// Proposes and removes triangles as long as there are bytes, at most `maximum_size` times.
inline void change(Hand_surface& surface, Byte_stream& in, std::size_t number_of_points, std::size_t maximum_size)
{
  for (std::size_t i = 0; i != maximum_size && !in.is_at_end() && number_of_points >= 3; ++i) {
    const std::size_t p = in.below(number_of_points), q = in.below(number_of_points), r = in.below(number_of_points);
    if (p == q || q == r || r == p)
      continue;
    for (const std::size_t v : { p, q, r })
      surface.builder.open(surface.indices[v]);
    const auto found = surface.builder.find_triangle(surface.indices[p], surface.indices[q], surface.indices[r]);
    if (found != Hand_surface::Builder::NO_TRIANGLE)
      surface.builder.remove(found);
    else
      surface.add(p, q, r);
  }
}

} // namespace isr_fuzz

#endif // ISR_FUZZ_SURFACE_H

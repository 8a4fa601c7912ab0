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

#ifndef ISR_FUZZ_INPUT_H
#define ISR_FUZZ_INPUT_H

#include "isr_fuzz_bytes.h"
#include "isr_fuzz_parts.h"

#include <cmath>
#include <cstddef>
#include <iostream>
#include <set>

namespace isr_fuzz {

// Parts with fewer points have no faces with holes.
constexpr std::size_t POINTS_OF_PARTS = 5;

// Of parts, up to so many times the maximum size.
inline Points read_points(Byte_stream& in, std::size_t maximum_size)
{
  const std::size_t kind = in.below(5);
  if (kind == 4)
    return Parts(in, POINTS_OF_PARTS * maximum_size).points();
  const auto coordinate = [&] {
    return kind == 0   ? in.small()
           : kind == 1 ? in.nudged()
           : kind == 2 ? in.any()
                       : std::ldexp(in.small(), int(in.byte()) * 8 - 1020);
  };
  Points points;
  while (!in.is_at_end() && points.size() != maximum_size) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.emplace_back(x, y, z);
  }
  return points;
}

inline Points read_distinct_points(Byte_stream& in, std::size_t size)
{
  std::set<Point> points;
  for (std::size_t i = 0; i != size; ++i) {
    const double x = in.small(), y = in.small(), z = in.small();
    points.insert(Point(x, y, z));
  }
  return Points(points.begin(), points.end());
}

// Ends the program, so that the fuzzer keeps the input.
inline void require(bool condition, const char* what)
{
  if (!condition) {
    std::cerr << "violated: " << what << std::endl;
    __builtin_trap();
  }
}

#define ISR_FUZZ_REQUIRE(condition) isr_fuzz::require((condition), #condition)

} // namespace isr_fuzz

#endif // ISR_FUZZ_INPUT_H

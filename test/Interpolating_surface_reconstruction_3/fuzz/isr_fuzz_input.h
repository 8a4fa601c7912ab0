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

#include "../isr_test_samples.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <set>

namespace isr_fuzz {

using isr_test::Point;
using isr_test::Points;

// The bytes of an input as numbers; zeros follow its end.
class Byte_stream
{
public:
  Byte_stream(const std::uint8_t* data, std::size_t size) : m_data(data), m_end(data + size) { }

  bool is_at_end() const { return m_data == m_end; }
  unsigned byte() { return is_at_end() ? 0u : *m_data++; }
  std::size_t below(std::size_t n) { return byte() % n; }

  // Few different numbers, so that many points are equal, collinear, coplanar or cospherical.
  double small() { return double(static_cast<std::int8_t>(byte())) / 16.; }

  // A number some floating-point numbers beside a small one.
  double nudged()
  {
    const double value = small();
    return value + std::ldexp(double(byte() % 7) - 3., -52);
  }

  double any()
  {
    std::uint8_t bytes[sizeof(double)];
    for (std::uint8_t& b : bytes)
      b = static_cast<std::uint8_t>(byte());
    double result;
    std::memcpy(&result, bytes, sizeof result);
    return result;
  }

private:
  const std::uint8_t* m_data;
  const std::uint8_t* const m_end;
};

inline Points read_points(Byte_stream& in, std::size_t maximum_size)
{
  const std::size_t kind = in.below(4);
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

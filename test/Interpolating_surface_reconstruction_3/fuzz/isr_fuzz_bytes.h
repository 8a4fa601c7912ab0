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

#ifndef ISR_FUZZ_BYTES_H
#define ISR_FUZZ_BYTES_H

#include "../isr_test_samples.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

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

} // namespace isr_fuzz

#endif // ISR_FUZZ_BYTES_H

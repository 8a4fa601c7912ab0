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

// Any file: the readers of isr_reconstruct return points or throw a std::exception. The first byte
// chooses the format.

#include "isr_fuzz_input.h"

#include "../../../examples/Interpolating_surface_reconstruction_3/isr_reconstruct/point_file.h"

#include <exception>
#include <iterator>
#include <sstream>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0)
    return 0;
  const auto& readers = isr::internal::readers();
  const auto reader = std::next(readers.begin(), data[0] % std::ptrdiff_t(readers.size()));
  const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
  std::istringstream in(text);
  isr::Point_set points;
  const isr::internal::Captured_cerr cerr;
  try {
    reader->second(in, points);
    isr_fuzz::require(points.size() <= size, "no more points than bytes");
  } catch (const std::exception&) {
  }
  return 0;
}

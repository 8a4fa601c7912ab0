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

#ifndef ISR_TEST_UTILS_H
#define ISR_TEST_UTILS_H

// Tests check in every build mode.
#undef NDEBUG

#include "isr_test_samples.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/validation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace isr_test {

namespace validation = CGAL::Interpolating_surface_reconstruction_3::internal::validation;

using Triple = std::array<std::size_t, 3>;
using Triples = std::vector<Triple>;

// ---- checks: a failure is reported with the current case, and the test goes on ------------------

inline std::string& current_case()
{
  static std::string text = "(no case)";
  return text;
}

inline int& number_of_failures()
{
  static int n = 0;
  return n;
}

inline void begin_case(const std::string& text)
{
  current_case() = text;
  std::cout << "  " << text << std::endl;
}

inline bool check(bool condition, const char* text, const char* file, int line)
{
  if (!condition) {
    ++number_of_failures();
    std::cerr << file << ':' << line << ": " << current_case() << ": failed: " << text << std::endl;
  }
  return condition;
}

template <typename A, typename B>
bool check_equal(const A& a, const B& b, const char* text, const char* file, int line)
{
  if (!check(a == b, text, file, line)) {
    std::cerr << "    " << a << " != " << b << std::endl;
    return false;
  }
  return true;
}

#define ISR_CHECK(condition) isr_test::check((condition), #condition, __FILE__, __LINE__)
#define ISR_CHECK_EQUAL(a, b) isr_test::check_equal((a), (b), #a " == " #b, __FILE__, __LINE__)

// The value of main().
inline int result()
{
  if (number_of_failures() == 0)
    std::cout << "all checks passed" << std::endl;
  return number_of_failures() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

// ---- triangles -----------------------------------------------------------------------------------

// The same triangles, each from its smallest index on, in lexicographic order.
inline Triples canonical(Triples triples)
{
  for (Triple& t : triples)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triples.begin(), triples.end());
  return triples;
}

inline Triples relabeled(Triples triples, const std::vector<std::size_t>& new_labels)
{
  for (Triple& t : triples)
    for (std::size_t& v : t)
      v = new_labels[v];
  return triples;
}

inline std::vector<double> volumes_of_components(const Points& points, const Triples& triples)
{
  std::vector<double> volumes(validation::number_of_components(triples), 0.);
  const std::vector<std::size_t> components = validation::component_of_triangles(triples);
  for (std::size_t i = 0; i != triples.size(); ++i) {
    const Triple& t = triples[i];
    volumes[components[i]] +=
      CGAL::determinant(points[t[0]] - points[0], points[t[1]] - points[0], points[t[2]] - points[0]) / 6.;
  }
  return volumes;
}

inline bool are_outward(const Points& points, const Triples& triples)
{
  const std::vector<double> volumes = volumes_of_components(points, triples);
  return std::all_of(volumes.begin(), volumes.end(), [](double v) { return v > 0.; });
}

} // namespace isr_test

#endif // ISR_TEST_UTILS_H

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

#ifndef ISR_BENCHMARK_RECONSTRUCTION_METHODS_H
#define ISR_BENCHMARK_RECONSTRUCTION_METHODS_H

#include "model_files.h"

#include <CGAL/ctc_reconstruction.h>
#include <CGAL/pcr_reconstruction.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Random.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace isr_benchmark {

enum class Method { AF, CTC, PCR };

inline const char* name(Method method)
{
  return method == Method::AF ? "AF" : method == Method::CTC ? "CTC" : "PCR";
}

inline Method method_of_name(const std::string& text)
{
  if (text == "af" || text == "AF")
    return Method::AF;
  if (text == "ctc" || text == "CTC")
    return Method::CTC;
  if (text == "pcr" || text == "PCR")
    return Method::PCR;
  throw std::invalid_argument("unknown method " + text + " (af, ctc, pcr)");
}

struct Method_options
{
  std::size_t threads = 0; // 0: Sequential_tag
  bool keep_boundaries = false;
};

// The Delaunay triangulation inserts in an order drawn from the process-wide generator, on which the
// result depends; the seed makes every run equal to the first one of a process.
inline std::vector<Triangle> advancing_front(const std::vector<Point>& points)
{
  CGAL::get_default_random() = CGAL::Random(0);
  std::vector<Triangle> triangles;
  CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(), std::back_inserter(triangles));
  return triangles;
}

template <typename ConcurrencyTag>
std::vector<Triangle> ours(Method method, const std::vector<Point>& points, const Method_options& options)
{
  const auto np = CGAL::parameters::keep_boundaries(options.keep_boundaries);
  std::vector<Triangle> triangles;
  if (method == Method::CTC)
    CGAL::ctc_reconstruction<ConcurrencyTag>(points, std::back_inserter(triangles), np);
  else
    CGAL::pcr_reconstruction<ConcurrencyTag>(points, std::back_inserter(triangles), np);
  return triangles;
}

inline std::vector<Triangle> reconstruct(Method method, const std::vector<Point>& points,
                                         const Method_options& options)
{
  if (method == Method::AF)
    return advancing_front(points);
  if (options.threads == 0)
    return ours<CGAL::Sequential_tag>(method, points, options);
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, options.threads);
  return ours<CGAL::Parallel_tag>(method, points, options);
#else
  throw std::invalid_argument("--threads: built without TBB");
#endif
}

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_RECONSTRUCTION_METHODS_H

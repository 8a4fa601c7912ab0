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

#include "methods/Advancing_front.h"
#include "methods/Method.h"
#include "models/model_files.h"

#include <CGAL/ctc_reconstruction.h>

#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace isr_benchmark {

enum class Compared_method { AF, CTC };

inline const char* name(Compared_method method) { return method == Compared_method::AF ? "AF" : "CTC"; }

inline Compared_method method_of_name(const std::string& text)
{
  if (text == "af" || text == "AF")
    return Compared_method::AF;
  if (text == "ctc" || text == "CTC")
    return Compared_method::CTC;
  throw std::invalid_argument("unknown method " + text + " (af, ctc)");
}

struct Method_options
{
  std::size_t threads = 0; // 0 and 1: Sequential_tag
  bool keep_boundaries = false;
};

inline std::vector<Triangle> reconstruct(Compared_method method, const Model& model, const Method_options& options)
{
  if (method == Compared_method::AF)
    return Advancing_front()(model, 1).triangles;
  return with_threads(options.threads, [&](auto tag) {
    Reconstruction result;
    CGAL::ctc_reconstruction<decltype(tag)>(model.points, std::back_inserter(result.triangles),
                                            CGAL::parameters::keep_boundaries(options.keep_boundaries));
    return result;
  }).triangles;
}

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_RECONSTRUCTION_METHODS_H

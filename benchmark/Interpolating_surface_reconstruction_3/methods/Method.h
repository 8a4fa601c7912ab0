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

#ifndef ISR_BENCHMARK_METHODS_METHOD_H
#define ISR_BENCHMARK_METHODS_METHOD_H

#include "../models/model_files.h"

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace isr_benchmark {

struct Reconstruction
{
  std::vector<Point> vertices; // none: the triangles refer to the points of the model
  std::vector<Triangle> triangles;
  double normal_seconds = 0.; // part of the run that made up for normals that were not given
};

// A reconstruction method. A header in this folder with a class of the header's name that derives
// from this one is a method of the benchmark: there is nothing else to change.
class Method
{
public:
  virtual ~Method() = default;

  virtual std::string key() const = 0;           // word of the command line and of file names
  virtual std::string title() const = 0;         // column of tables
  virtual std::string description() const = 0;   // with all parameters that are not defaults
  virtual bool is_ours() const { return false; } // promises a manifold through the points
  virtual bool uses_threads() const { return false; }

  virtual Reconstruction operator()(const Model& model, std::size_t threads) const = 0;
};

inline std::vector<std::unique_ptr<Method> >& registered_methods()
{
  static std::vector<std::unique_ptr<Method> > methods;
  return methods;
}

template <typename Method_type>
struct Method_registration
{
  Method_registration() { registered_methods().push_back(std::make_unique<Method_type>()); }
};

inline const Method& method_of_key(const std::string& key)
{
  for (const auto& method : registered_methods())
    if (method->key() == key)
      return *method;
  throw std::invalid_argument(key + ": no such method");
}

// Calls `run(tag)` with the concurrency tag for that many threads.
template <typename Run>
Reconstruction with_threads(std::size_t threads, Run run)
{
  if (threads <= 1)
    return run(CGAL::Sequential_tag());
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  return run(CGAL::Parallel_tag());
#else
  throw std::invalid_argument("threads: built without TBB");
#endif
}

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_METHODS_METHOD_H

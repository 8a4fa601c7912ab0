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
#include <CGAL/lis_reconstruction.h>
#include <CGAL/pcr_reconstruction.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace isr_benchmark {

enum class Method { AF, CTC, PCR, LIS };

inline const char* name(Method method)
{
  return method == Method::AF ? "AF" : method == Method::CTC ? "CTC" : method == Method::PCR ? "PCR" : "LIS";
}

inline Method method_of_name(const std::string& text)
{
  if (text == "af" || text == "AF")
    return Method::AF;
  if (text == "ctc" || text == "CTC")
    return Method::CTC;
  if (text == "pcr" || text == "PCR")
    return Method::PCR;
  if (text == "lis" || text == "LIS")
    return Method::LIS;
  throw std::invalid_argument("unknown method " + text + " (af, ctc, pcr, lis)");
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
std::vector<Triangle> charts(Method method, const std::vector<Point>& points, const Method_options& options)
{
  const auto np = CGAL::parameters::keep_boundaries(options.keep_boundaries);
  std::vector<Triangle> triangles;
  if (method == Method::CTC)
    CGAL::ctc_reconstruction<ConcurrencyTag>(points, std::back_inserter(triangles), np);
  else
    CGAL::pcr_reconstruction<ConcurrencyTag>(points, std::back_inserter(triangles), np);
  return triangles;
}

// Area-weighted normals of the vertices of the reference, if there is one.
inline std::vector<Kernel::Vector_3> reference_normals(const Model& model)
{
  std::vector<Kernel::Vector_3> normals;
  if (model.triangles.empty())
    return normals;
  normals.assign(model.points.size(), CGAL::NULL_VECTOR);
  for (const Triangle& t : model.triangles)
    for (std::size_t v : t)
      normals[v] = normals[v] + CGAL::cross_product(model.points[t[1]] - model.points[t[0]], model.points[t[2]] - model.points[t[0]]);
  return normals;
}

// With the normals of the model, if it has any.
template <typename ConcurrencyTag>
std::vector<Triangle> lis(const Model& model, const std::vector<Kernel::Vector_3>& normals, const Method_options& options)
{
  namespace params = CGAL::parameters;
  CGAL::Surface_mesh<Point> mesh;
  if (normals.empty()) {
    CGAL::lis_reconstruction<ConcurrencyTag>(model.points, mesh, params::keep_boundaries(options.keep_boundaries));
  } else {
    std::vector<std::size_t> samples(model.points.size());
    std::iota(samples.begin(), samples.end(), std::size_t(0));
    CGAL::lis_reconstruction<ConcurrencyTag>(
      samples, mesh,
      params::combine(params::keep_boundaries(options.keep_boundaries),
                      params::point_map(CGAL::make_property_map(model.points)).normal_map(CGAL::make_property_map(normals))));
  }
  const auto input_index =
    mesh.add_property_map<CGAL::Surface_mesh<Point>::Vertex_index, std::size_t>("v:input_index").first;
  std::vector<Triangle> triangles;
  for (const auto face : mesh.faces()) {
    Triangle triangle;
    std::size_t i = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(face)))
      triangle[i++] = input_index[v];
    triangles.push_back(triangle);
  }
  return triangles;
}

template <typename ConcurrencyTag>
std::vector<Triangle> reconstruct_by(Method method, const Model& model, const std::vector<Kernel::Vector_3>& normals,
                                     const Method_options& options)
{
  return method == Method::LIS ? lis<ConcurrencyTag>(model, normals, options)
                               : charts<ConcurrencyTag>(method, model.points, options);
}

inline std::vector<Triangle> reconstruct(Method method, const Model& model, const std::vector<Kernel::Vector_3>& normals,
                                         const Method_options& options)
{
  if (method == Method::AF)
    return advancing_front(model.points);
  if (options.threads == 0)
    return reconstruct_by<CGAL::Sequential_tag>(method, model, normals, options);
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, options.threads);
  return reconstruct_by<CGAL::Parallel_tag>(method, model, normals, options);
#else
  throw std::invalid_argument("--threads: built without TBB");
#endif
}

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_RECONSTRUCTION_METHODS_H

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

// The methods that isr_compare compares.

#ifndef ISR_BENCHMARK_RECONSTRUCTION_METHODS_H
#define ISR_BENCHMARK_RECONSTRUCTION_METHODS_H

#include "methods/Advancing_front.h"
#include "methods/Ctc.h"
#include "methods/Lis.h"
#include "methods/Method.h"
#include "methods/Pcr.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace isr_benchmark {

inline std::string name(const Method& method)
{
  std::string key = method.key();
  std::transform(key.begin(), key.end(), key.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return key;
}

inline std::vector<std::unique_ptr<Method> > compared_methods(bool keep_boundaries)
{
  std::vector<std::unique_ptr<Method> > methods;
  methods.push_back(std::make_unique<Advancing_front>());
  methods.push_back(std::make_unique<Ctc>(keep_boundaries));
  methods.push_back(std::make_unique<Pcr>(keep_boundaries));
  methods.push_back(std::make_unique<Lis>(keep_boundaries));
  return methods;
}

// The methods of these names, upper or lower case, in the order of the names.
inline std::vector<std::unique_ptr<Method> > methods_of_names(const std::vector<std::string>& names,
                                                              bool keep_boundaries)
{
  std::vector<std::unique_ptr<Method> > chosen;
  for (const std::string& text : names) {
    std::vector<std::unique_ptr<Method> > methods = compared_methods(keep_boundaries);
    const auto found = std::find_if(methods.begin(), methods.end(),
                                    [&](const auto& method) { return text == method->key() || text == name(*method); });
    if (found == methods.end())
      throw std::invalid_argument("unknown method " + text + " (af, ctc, pcr, lis)");
    chosen.push_back(std::move(*found));
  }
  return chosen;
}

// Gives a model without normals the area-weighted ones of the vertices of its surface, if it has one. They point
// outside although some files are oriented inside out.
inline void set_reference_normals(Model& model)
{
  if (model.triangles.empty() || !model.normals.empty())
    return;
  model.normals.assign(model.points.size(), CGAL::NULL_VECTOR);
  for (const Triangle& t : model.triangles)
    for (std::size_t v : t)
      model.normals[v] = model.normals[v] + CGAL::cross_product(model.points[t[1]] - model.points[t[0]],
                                                                model.points[t[2]] - model.points[t[0]]);
  double volume = 0.;
  for (const Triangle& t : model.triangles)
    volume += CGAL::volume(model.points[0], model.points[t[0]], model.points[t[1]], model.points[t[2]]);
  if (volume < 0.)
    for (Vector& normal : model.normals)
      normal = -normal;
}

// Triangles of positions in the points of the model: methods that write vertices do so in their
// order.
inline std::vector<Triangle> triangles_of_points(const Model& model, Reconstruction result)
{
  std::vector<std::size_t> position;
  std::size_t i = 0;
  for (const Point& vertex : result.vertices) {
    while (model.points.at(i) != vertex)
      ++i;
    position.push_back(i);
  }
  if (!position.empty())
    for (Triangle& triangle : result.triangles)
      for (std::size_t& v : triangle)
        v = position[v];
  return std::move(result.triangles);
}

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_RECONSTRUCTION_METHODS_H

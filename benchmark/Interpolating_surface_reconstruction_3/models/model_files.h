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

#ifndef ISR_BENCHMARK_MODELS_MODEL_FILES_H
#define ISR_BENCHMARK_MODELS_MODEL_FILES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace isr_benchmark {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Triangle = std::array<std::size_t, 3>;

// A point set, and the surface that it was taken from if the file has one.
struct Model
{
  std::string name;
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<Vector> normals; // one a point, or none
};

// Polygons become fans. Vertices that no polygon uses are not samples of the surface. There is a normal for each
// vertex, or none.
inline void set_surface(const std::vector<Point>& vertices, const std::vector<Vector>& normals,
                        const std::vector<std::vector<std::size_t> >& polygons, Model& model)
{
  std::vector<std::size_t> new_index(vertices.size(), vertices.size());
  for (const std::vector<std::size_t>& polygon : polygons)
    for (std::size_t v : polygon)
      new_index.at(v) = 0;
  for (std::size_t v = 0; v != vertices.size(); ++v)
    if (new_index[v] != vertices.size()) {
      new_index[v] = model.points.size();
      model.points.push_back(vertices[v]);
      if (!normals.empty())
        model.normals.push_back(normals[v]);
    }
  for (const std::vector<std::size_t>& polygon : polygons)
    for (std::size_t i = 2; i < polygon.size(); ++i)
      model.triangles.push_back(Triangle{ new_index[polygon[0]], new_index[polygon[i - 1]], new_index[polygon[i]] });
}

inline bool has_extension(const std::filesystem::path& path, const std::string& extension)
{
  std::string found = path.extension().string();
  std::transform(found.begin(), found.end(), found.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return found == extension;
}

// Points, and their normals if the file has them.
inline void read_oriented_points(const std::string& path, Model& model)
{
  using Oriented_point = std::pair<Point, Vector>;
  std::vector<Oriented_point> points;
  if (!CGAL::IO::read_points(path, std::back_inserter(points),
                             CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                               .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>())))
    throw std::runtime_error(path + ": cannot be read");
  model.points.clear();
  bool has_normals = !points.empty();
  for (const Oriented_point& p : points) {
    model.points.push_back(p.first);
    model.normals.push_back(p.second);
    has_normals = has_normals && p.second != CGAL::NULL_VECTOR;
  }
  if (!has_normals)
    model.normals.clear();
}

inline bool is_model_file(const std::filesystem::path& path)
{
  return has_extension(path, ".ply") || has_extension(path, ".off") || has_extension(path, ".xyz");
}

inline Model read_model(const std::filesystem::path& path)
{
  Model model;
  model.name = path.stem().string();
  std::vector<Point> vertices;
  std::vector<std::vector<std::size_t> > polygons;
  const bool is_ply = has_extension(path, ".ply") && CGAL::IO::read_PLY(path.string(), vertices, polygons),
             is_off = has_extension(path, ".off") && CGAL::IO::read_OFF(path.string(), vertices, polygons);
  if (is_ply || polygons.empty())
    read_oriented_points(path.string(), model);
  if ((is_ply || is_off) && !polygons.empty()) {
    const std::vector<Vector> normals = std::move(model.normals);
    model.points.clear();
    model.normals.clear();
    set_surface(vertices, normals, polygons, model);
  }
  return model;
}

// The model files among `paths` and in the folders among them, in alphabetical order per folder.
inline std::vector<std::filesystem::path> find_model_files(const std::vector<std::string>& paths)
{
  std::vector<std::filesystem::path> files;
  for (const std::string& path : paths) {
    if (!std::filesystem::is_directory(path)) {
      files.emplace_back(path);
      continue;
    }
    const std::size_t first = files.size();
    for (const auto& entry : std::filesystem::directory_iterator(path))
      if (entry.is_regular_file() && is_model_file(entry.path()))
        files.push_back(entry.path());
    std::sort(files.begin() + static_cast<std::ptrdiff_t>(first), files.end());
  }
  return files;
}

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MODELS_MODEL_FILES_H

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

#include "measure_mesh.h"

#include "measures/mesh_statistics.h"
#include "measures/Picture.h"
#include "measures/regularity.h"
#include "measures/self_intersections.h"
#include "measures/surface_metrics.h"
#include "measures/True_surface.h"

#include <CGAL/IO/PLY.h>

#include <algorithm>
#include <memory>
#include <ostream>
#include <vector>

namespace isr_benchmark {

namespace {

// Of the error's color scale, in percent of the diagonal.
constexpr double LARGEST_ERROR = 1.;

struct Mesh
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

Mesh read_mesh(const std::string& file)
{
  Mesh mesh;
  std::vector<std::vector<std::size_t> > polygons;
  if (!CGAL::IO::read_PLY(file, mesh.points, polygons) && !polygons.empty())
    throw std::runtime_error(file + ": cannot be read");
  for (const auto& polygon : polygons)
    mesh.triangles.push_back(Triangle{ polygon.at(0), polygon.at(1), polygon.at(2) });
  return mesh;
}

std::vector<Point> used_vertices(const Mesh& mesh)
{
  std::vector<Point> result;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t v : t)
      result.push_back(mesh.points[v]);
  sort_and_merge(result);
  return result;
}

// Distinct points of the model, and how many of them are vertices of the mesh.
void write_points(const Model& model, const Mesh& mesh, std::ostream& out)
{
  std::vector<Point> points = model.points, common;
  sort_and_merge(points);
  const std::vector<Point> vertices = used_vertices(mesh);
  std::set_intersection(points.begin(), points.end(), vertices.begin(), vertices.end(), std::back_inserter(common));
  out << "vertices\t" << vertices.size() << '\n'
      << "points\t" << model.points.size() << '\n'
      << "distinct_points\t" << points.size() << '\n'
      << "points_used\t" << common.size() << '\n'
      << "interpolates\t" << (common.size() == vertices.size()) << '\n';
}

void write_topology(const Mesh& mesh, std::size_t intersection_limit, std::ostream& out)
{
  const Mesh_statistics s = Mesh_statistician(mesh.points, mesh.triangles)();
  out << "triangles\t" << s.triangles << '\n'
      << "components\t" << s.components << '\n'
      << "boundary_edges\t" << s.boundary_edges << '\n'
      << "boundary_loops\t" << s.boundary_loops << '\n'
      << "euler\t" << s.euler_characteristic << '\n'
      << "nonmanifold_edges\t" << s.nonmanifold_edges << '\n'
      << "nonmanifold_vertices\t" << s.nonmanifold_vertices << '\n'
      << "degenerate_triangles\t" << s.degenerate_triangles << '\n'
      << "oriented\t" << s.is_oriented << '\n'
      << "outward_components\t" << s.outward_components << '\n'
      << "closed_components\t" << s.closed_components << '\n';
  if (s.triangles <= intersection_limit)
    out << "self_intersections\t" << Self_intersection_counter(mesh.points, mesh.triangles)() << '\n';
}

void write_metrics(const std::string& prefix, const Surface_metrics& metrics, std::ostream& out)
{
  out << prefix << "_hausdorff\t" << metrics.hausdorff << '\n'
      << prefix << "_mean\t" << metrics.mean << '\n'
      << prefix << "_rms\t" << metrics.root_mean_square << '\n'
      << prefix << "_sd\t" << metrics.standard_deviation << '\n';
}

void write_regularity(const Mesh& mesh, std::ostream& out)
{
  const Regularity regularity = measure_regularity(mesh.points, mesh.triangles);
  out << "regularity_mean\t" << regularity.mean << "\nregularity_histogram\t";
  for (std::size_t i = 0; i != regularity.histogram.size(); ++i)
    out << (i == 0 ? "" : " ") << regularity.histogram[i];
  out << '\n';
}

std::unique_ptr<True_surface> true_surface(const Surface_model& model)
{
  if (model.surface)
    return std::make_unique<Exact_true_surface>(*model.surface, model.model.points.size(),
                                                CGAL::Random(model.seed + 1000));
  if (!model.model.triangles.empty())
    return std::make_unique<Mesh_true_surface>(model.model.points, model.model.triangles);
  return nullptr;
}

void draw(const Model& model, const Mesh& mesh, const std::vector<double>& errors, double diagonal,
          const Measure_options& options)
{
  Picture picture(Camera(model.points), options.pixels);
  if (mesh.triangles.empty())
    picture.draw_points(model.points);
  else {
    std::vector<Color> colors(mesh.triangles.size(), error_color(0.));
    for (std::size_t t = 0; !errors.empty() && t != colors.size(); ++t)
      colors[t] = error_color(100. * errors[t] / diagonal / LARGEST_ERROR);
    picture.draw_mesh(mesh.points, mesh.triangles, colors);
  }
  picture.write(options.picture_file);
}

} // namespace

void measure_mesh(const Surface_model& generated, const Measure_options& options, std::ostream& out)
{
  const Model& model = generated.model;
  const bool is_reference = options.mesh_file.empty();
  const Mesh mesh = is_reference ? Mesh{ model.points, model.triangles } : read_mesh(options.mesh_file);
  const double diagonal = bounding_box_diagonal(model.points);
  out << "diagonal\t" << diagonal << '\n';
  if (generated.surface)
    out << "true_euler\t" << generated.surface->euler_characteristic() << '\n'
        << "true_components\t" << generated.surface->components() << '\n';
  write_points(model, mesh, out);
  write_topology(mesh, options.intersection_limit, out);
  write_regularity(mesh, out);
  std::vector<double> errors;
  if (!is_reference) {
    if (!model.triangles.empty())
      write_metrics("thesis", Surface_comparer(model.points, model.triangles)(mesh.points, mesh.triangles), out);
    if (const auto surface = true_surface(generated)) {
      errors = distances_to(*surface, mesh.points, mesh.triangles);
      write_metrics("true", compare_with(*surface, mesh.points, mesh.triangles, errors, diagonal), out);
    }
  }
  if (!options.picture_file.empty())
    draw(model, mesh, errors, diagonal, options);
}

} // namespace isr_benchmark

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

#ifndef ISR_BENCHMARK_METHODS_POISSON_H
#define ISR_BENCHMARK_METHODS_POISSON_H

#include "../models/oriented_points.h"
#include "Method.h"

#include <CGAL/compute_average_spacing.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>
#include <vector>

namespace isr_benchmark {

class Poisson : public Method
{
public:
  std::string key() const override { return "poisson"; }
  std::string title() const override { return "Poisson"; }
  std::string description() const override
  {
    return "CGAL::poisson_surface_reconstruction_delaunay() with its defaults (20 degrees, "
           "radius 30, distance 0.375 of the average spacing of 6 neighbors); normals as given, "
           "else by CGAL::jet_estimate_normals() and CGAL::mst_orient_normals() with 18 "
           "neighbors, points that stay unoriented left out (Kazhdan et al. 2006)";
  }

  Reconstruction operator()(const Model& model, std::size_t) const override
  {
    Reconstruction result;
    CGAL::Real_timer timer;
    timer.start();
    std::vector<Oriented_point> points = points_with_normals(model);
    if (model.normals.empty())
      result.normal_seconds = timer.time();
    CGAL::Surface_mesh<Point> mesh;
    const double spacing = CGAL::compute_average_spacing<CGAL::Sequential_tag>(model.points, 6);
    if (!CGAL::poisson_surface_reconstruction_delaunay(points.begin(), points.end(), Oriented_point_map(),
                                                       Oriented_normal_map(), mesh, spacing))
      throw std::runtime_error("Poisson reconstruction reports failure");
    for (const auto v : mesh.vertices())
      result.vertices.push_back(mesh.point(v));
    for (const auto f : mesh.faces()) {
      const auto h = mesh.halfedge(f);
      result.triangles.push_back(
        Triangle{ mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx() });
    }
    return result;
  }

private:
  static std::vector<Oriented_point> points_with_normals(const Model& model)
  {
    std::vector<Oriented_point> points = oriented_points(model);
    if (!model.normals.empty())
      return points;
    const auto maps = oriented_point_parameters();
    CGAL::jet_estimate_normals<CGAL::Sequential_tag>(points, NEIGHBORS, maps);
    points.erase(CGAL::mst_orient_normals(points, NEIGHBORS, maps), points.end());
    return points;
  }

  static constexpr unsigned int NEIGHBORS = 18;
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_METHODS_POISSON_H

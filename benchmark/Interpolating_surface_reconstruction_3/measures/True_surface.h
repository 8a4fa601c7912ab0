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

#ifndef ISR_BENCHMARK_MEASURES_TRUE_SURFACE_H
#define ISR_BENCHMARK_MEASURES_TRUE_SURFACE_H

#include "../models/Surface.h"
#include "mesh_distance.h"
#include "surface_metrics.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace isr_benchmark {

// The surface from which the points of a model come: exact, or the mesh whose vertices they are.
class True_surface
{
public:
  virtual ~True_surface() = default;
  virtual double distance(const Point& p) const = 0;
  const std::vector<Point>& samples() const { return m_samples; }

protected:
  explicit True_surface(std::vector<Point> samples) : m_samples(std::move(samples)) { }

private:
  std::vector<Point> m_samples;
};

class Exact_true_surface : public True_surface
{
public:
  // Samples are independent of the points of the model, and four times as many.
  Exact_true_surface(const Surface& surface, std::size_t points, CGAL::Random random)
    : True_surface(surface.random_points(4 * points, random)), m_surface(surface)
  { }

  double distance(const Point& p) const override { return m_surface.distance(p); }

private:
  const Surface& m_surface;
};

class Mesh_true_surface : public True_surface
{
public:
  Mesh_true_surface(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
    : True_surface(mesh_samples(points, triangles)), m_distance(points, triangles)
  { }

  double distance(const Point& p) const override { return m_distance(p); }

private:
  Mesh_distance m_distance;
};

// Distances of the samples of a mesh to the true surface, those of the barycenters of its triangles first.
inline std::vector<double> distances_to(const True_surface& surface, const std::vector<Point>& points,
                                        const std::vector<Triangle>& triangles)
{
  std::vector<double> result;
  for (const Point& p : mesh_samples(points, triangles))
    result.push_back(surface.distance(p));
  return result;
}

// Two-sided distances between a mesh and the true surface; `to_surface` are those of the mesh's samples.
inline Surface_metrics compare_with(const True_surface& surface, const std::vector<Point>& points,
                                    const std::vector<Triangle>& triangles, std::vector<double> to_surface,
                                    double diagonal)
{
  const Mesh_distance to_mesh(points, triangles);
  for (const Point& p : surface.samples())
    to_surface.push_back((std::min)(to_mesh(p), diagonal)); // no mesh: as far as can be
  return summarize(to_surface, diagonal);
}

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MEASURES_TRUE_SURFACE_H

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

#ifndef ISR_BENCHMARK_MEASURES_SURFACE_METRICS_H
#define ISR_BENCHMARK_MEASURES_SURFACE_METRICS_H

#include "../models/model_files.h"

#include <CGAL/bounding_box.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace isr_benchmark {

// Hausdorff distance, its mean, root mean square and standard deviation (Eq. 3.14 to 3.18 of the
// thesis), in percent of the diagonal of the bounding box of the model.
struct Surface_metrics
{
  double hausdorff = 0., mean = 0., root_mean_square = 0., standard_deviation = 0.;
};

inline Surface_metrics summarize(const std::vector<double>& distances, double diagonal)
{
  Surface_metrics result;
  const double n = static_cast<double>(distances.size());
  double sum = 0., sum_of_squares = 0.;
  for (double d : distances) {
    result.hausdorff = (std::max)(result.hausdorff, d);
    sum += d;
    sum_of_squares += d * d;
  }
  result.mean = sum / n;
  result.root_mean_square = std::sqrt(sum_of_squares / n);
  result.standard_deviation = std::sqrt((std::max)(0., sum_of_squares / n - result.mean * result.mean));
  const double percent = 100. / diagonal;
  return Surface_metrics{ percent * result.hausdorff, percent * result.mean, percent * result.root_mean_square,
                          percent * result.standard_deviation };
}

inline double bounding_box_diagonal(const std::vector<Point>& points)
{
  const auto box = CGAL::bounding_box(points.begin(), points.end());
  return std::sqrt(CGAL::squared_distance((box.min)(), (box.max)()));
}

template <typename T>
void sort_and_merge(std::vector<T>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

// The thesis's samples of a mesh: used vertices, midpoints of edges and barycenters of triangles.
// Coordinates are summed in the order of the indices, so that equal triangles have equal samples.
inline std::vector<Point> mesh_samples(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  std::vector<std::size_t> vertices;
  std::vector<std::pair<std::size_t, std::size_t> > edges;
  std::vector<Point> result;
  for (Triangle t : triangles) {
    std::sort(t.begin(), t.end());
    vertices.insert(vertices.end(), t.begin(), t.end());
    edges.insert(edges.end(), { { t[0], t[1] }, { t[0], t[2] }, { t[1], t[2] } });
    result.push_back(CGAL::centroid(points[t[0]], points[t[1]], points[t[2]]));
  }
  sort_and_merge(vertices);
  sort_and_merge(edges);
  for (std::size_t v : vertices)
    result.push_back(points[v]);
  for (const auto& edge : edges)
    result.push_back(CGAL::midpoint(points[edge.first], points[edge.second]));
  return result;
}

// The thesis's distance between two meshes: from samples to samples.
class Surface_comparer
{
public:
  // The reference's samples are indexed once for all surfaces of a model.
  Surface_comparer(const std::vector<Point>& points, const std::vector<Triangle>& reference)
    : m_reference_samples(mesh_samples(points, reference)), m_reference_tree(m_reference_samples),
      m_diagonal(bounding_box_diagonal(points))
  { }

  Surface_metrics operator()(const std::vector<Point>& points, const std::vector<Triangle>& triangles) const
  {
    if (triangles.empty())
      return Surface_metrics{ 100., 100., 100., 0. };
    const std::vector<Point> found_samples = mesh_samples(points, triangles);
    const Tree found_tree(found_samples);
    std::vector<double> distances;
    distances.reserve(found_samples.size() + m_reference_samples.size());
    for (const Point& p : found_samples)
      distances.push_back(m_reference_tree.distance(p));
    for (const Point& p : m_reference_samples)
      distances.push_back(found_tree.distance(p));
    return summarize(distances, m_diagonal);
  }

private:
  class Tree
  {
  public:
    explicit Tree(const std::vector<Point>& samples) : m_tree(samples.begin(), samples.end()) { m_tree.build(); }

    double distance(const Point& p) const
    {
      const Search search(m_tree, p, 1);
      return std::sqrt(search.begin()->second);
    }

  private:
    using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel> >;
    Search::Tree m_tree;
  };

  std::vector<Point> m_reference_samples;
  Tree m_reference_tree;
  double m_diagonal;
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MEASURES_SURFACE_METRICS_H

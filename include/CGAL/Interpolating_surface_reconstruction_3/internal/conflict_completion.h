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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_COMPLETION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_COMPLETION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/cluster_completion.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/conflict_clusters.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/parallel.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Completes the surface where charts conflict, cluster by cluster. Clusters of a batch do not see each other's
// surface, so that threads can share them: what they find is attached in their order.
template <typename ConcurrencyTag, typename Builder>
class Conflict_completion
{
public:
  Conflict_completion(const std::vector<Local_point>& points, const Point_octree_3& octree, double maximum_radius,
                      Builder& builder)
    : m_points(points), m_octree(octree), m_maximum_radius(maximum_radius), m_builder(builder),
      m_clusters(points, octree, maximum_radius, builder)
  { }

  // Ends early if cancelled. The triangulation of the cluster with the most conflicts is left for what comes next.
  template <typename Progress, typename OnVerdict>
  void operator()(Progress& progress, OnVerdict on_verdict, Kept_triangulation& triangulation)
  {
    if (m_clusters.conflicts().empty())
      return;
    m_is_conflict.assign(m_points.size(), 0);
    for (Point_index p : m_clusters.conflicts())
      m_is_conflict[p] = 1;
    try {
      complete(m_clusters.find(progress), progress, on_verdict, triangulation);
    } catch (const Cancelled&) {
    }
  }

private:
  using Clusters = std::vector<std::vector<Point_index> >;

  // Conflicts of the clusters that are completed before their surfaces are attached: enough for many threads.
  static constexpr std::size_t CONFLICTS_PER_BATCH = 4096;

  // Changes of labels that the searches may try in all, none of them after kicks: enough for a few thousand conflicts, and
  // one for every point where there are more. Measured: four times as many, or kicks, find no better surfaces.
  static constexpr std::size_t SEARCH_EFFORT = 125000, SEARCH_EFFORT_PER_POINT = 1;

  template <typename Progress, typename OnVerdict>
  void complete(const Clusters& clusters, Progress& progress, const OnVerdict& on_verdict,
                Kept_triangulation& triangulation)
  {
    using Worker = Cluster_completion<Builder>;
    Thread_locals<ConcurrencyTag, Worker> workers(
      [&] { return std::make_unique<Worker>(m_points, m_octree, m_maximum_radius, m_builder, m_is_conflict); });
    std::size_t effort = SEARCH_EFFORT + SEARCH_EFFORT_PER_POINT * m_points.size(),
                conflicts_left = m_clusters.conflicts().size();
    const std::size_t largest = clusters.empty() ? 0 : largest_first(clusters, 0, clusters.size()).front();
    std::atomic<std::size_t> done{ 0 };
    for (std::size_t begin = 0, end = 0; begin != clusters.size(); begin = end) {
      end = end_of_batch(clusters, begin);
      std::vector<Completed_cluster> completed(end - begin);
      const std::vector<std::size_t> order = largest_first(clusters, begin, end);
      std::atomic<std::size_t> next{ 0 };
      for_each_block<ConcurrencyTag>(order.size(), 1, [&](std::size_t, std::size_t) {
        const std::size_t k = order[next++]; // in this order, however the blocks are shared
        const std::vector<Point_index>& cluster = clusters[k];
        // A single cluster may hold all points.
        Cancellation_point<Progress> cancellation_point(progress);
        const double share = double(cluster.size()) / double(conflicts_left);
        Worker& worker = workers.local();
        completed[k - begin] = worker(cluster, static_cast<std::size_t>(share * double(effort)), cancellation_point);
        if (k == largest)
          triangulation.adopt(worker.release_triangulation());
        if (!progress.advance(double(done += cluster.size()) / double(m_clusters.conflicts().size())))
          throw Cancelled();
      });
      for (const Completed_cluster& cluster : completed) {
        attach(cluster, progress, on_verdict);
        effort -= (std::min)(effort, cluster.effort);
      }
      for (std::size_t k = begin; k != end; ++k)
        conflicts_left -= clusters[k].size();
    }
  }

  static std::size_t end_of_batch(const Clusters& clusters, std::size_t begin)
  {
    std::size_t conflicts = 0;
    for (; begin != clusters.size() && conflicts < CONFLICTS_PER_BATCH; ++begin)
      conflicts += clusters[begin].size();
    return begin;
  }

  // Clusters differ much: a large one that begins last would be waited for.
  static std::vector<std::size_t> largest_first(const Clusters& clusters, std::size_t begin, std::size_t end)
  {
    std::vector<std::size_t> result(end - begin);
    std::iota(result.begin(), result.end(), begin);
    std::stable_sort(result.begin(), result.end(),
                     [&](std::size_t a, std::size_t b) { return clusters[a].size() > clusters[b].size(); });
    return result;
  }

  template <typename Progress, typename OnVerdict>
  void attach(const Completed_cluster& cluster, Progress& progress, const OnVerdict& on_verdict)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    for (const Completed_cluster::Triangle& t : cluster.withdrawn) {
      cancellation_point();
      m_builder.open(t[0]);
      // Another cluster may have withdrawn it.
      const auto stored = m_builder.find_triangle(t[0], t[1], t[2]);
      if (stored != Builder::NO_TRIANGLE)
        m_builder.remove(stored);
    }
    for (const Completed_cluster::Triangle& t : cluster.surface) {
      cancellation_point();
      on_verdict(t, m_builder.try_add(t[0], t[1], t[2]));
    }
    for (Point_index p : cluster.conflicts)
      m_is_conflict[p] = !m_builder.is_open(p) || m_builder.is_fan_closed(p) ? 0 : 1;
  }

  const std::vector<Local_point>& m_points;
  const Point_octree_3& m_octree;
  double m_maximum_radius;
  Builder& m_builder;
  Conflict_clusters<Builder> m_clusters;
  std::vector<unsigned char> m_is_conflict; // of each point, now
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CONFLICT_COMPLETION_H

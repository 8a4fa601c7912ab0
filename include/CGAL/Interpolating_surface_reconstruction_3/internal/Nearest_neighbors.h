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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_NEAREST_NEIGHBORS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_NEAREST_NEIGHBORS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Nearest_search.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Point_star.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Neighbors of the points of one octree leaf by increasing distance. The points of a leaf share the
// candidates, which are gathered once around the leaf's box; the box grows only for the points that
// ask for more. One object serves one thread; its buffers are kept from leaf to leaf.
class Nearest_neighbors
{
public:
  // No point farther than `maximum_radius` is a neighbor. Each neighborhood is told whether boundaries are kept.
  Nearest_neighbors(const std::vector<Local_point>& points, const Point_octree_3& octree, double maximum_radius,
                    bool keeps_boundaries = false)
    : m_points(points), m_octree(octree), m_maximum_radius(maximum_radius), m_keeps_boundaries(keeps_boundaries),
      m_search(points, octree)
  { }

  // Indices of the neighbors that were passed last.
  const std::vector<Point_index>& indices() const { return m_indices; }

  // Calls visit(p, neighborhood) for each point p of the leaf with its `size` nearest neighbors, and
  // again with twice as many as long as it returns false, up to `maximum_size` or all there are.
  template <typename Visit>
  void for_each_point(const Point_octree_3::Node& leaf, std::size_t size, std::size_t maximum_size, Visit visit)
  {
    m_pending.clear();
    for (Point_index p = leaf.begin; p != leaf.end; ++p)
      m_pending.push_back(Request{ p, size });
    const double spacing = typical_spacing(leaf);
    // a disc of this radius holds `size` points at this spacing
    double radius = spacing * std::sqrt(double(size) / CGAL_PI) * GATHERING_MARGIN;
    m_guess_per_neighbor = radius * radius / double(size);
    for (bool is_exhaustive = false; !m_pending.empty(); radius *= 2) {
      const double gathered = (std::min)(radius, m_maximum_radius);
      const Local_box box = leaf.box.enlarged(gathered);
      if (!gather(leaf, leaf.box.enlarged(gathered * (1. + ROUNDING)), gathered)) {
        for (const Request& request : m_pending)
          serve_alone(request, maximum_size, visit);
        return;
      }
      is_exhaustive = box.contains(m_octree.node(0).box) || gathered == m_maximum_radius || !(radius > 0.);
      std::size_t kept = 0;
      for (Request request : m_pending)
        if (!serve(request, leaf, box, is_exhaustive, maximum_size, visit))
          m_pending[kept++] = request;
      m_pending.resize(is_exhaustive ? 0 : kept);
    }
  }

  // The same for a single point.
  template <typename Visit>
  void for_point(Point_index p, std::size_t size, std::size_t maximum_size, Visit visit)
  {
    Point_octree_3::Node leaf = m_octree.node(m_octree.leaf_of(p));
    leaf.begin = p;
    leaf.end = p + 1;
    for_each_point(leaf, size, maximum_size, visit);
  }

private:
  struct Request
  {
    Point_index point;
    std::size_t size;
  };

  // Measured: smaller margins gather twice too often, larger ones too many candidates.
  static constexpr double GATHERING_MARGIN = 1.5;

  // Measured: with a smaller one too many neighbors are looked for twice, with a larger one too many are sorted.
  static constexpr double GUESS_MARGIN = 1.4;

  // Keys that sort_by_rank() takes; those around most points are fewer.
  static constexpr std::size_t MAXIMUM_RANKED = 48;

  // Candidates reach farther than the distances that count by this part, so that none is missed that is as far as
  // the last one.
  static constexpr double ROUNDING = 8. * double((std::numeric_limits<float>::epsilon)());

  // A distance of this part of a float coordinate is known to four digits, as its square is.
  static constexpr double RELATIVE_RESOLUTION = 1. / 128;

  // Spacing of the points around the leaf, as if they covered a rectangle of its parent's box.
  double typical_spacing(const Point_octree_3::Node& leaf) const
  {
    const Point_octree_3::Node& parent = m_octree.node(leaf.parent);
    double side[3];
    for (std::size_t a = 0; a != 3; ++a)
      side[a] = parent.box.high[a] - parent.box.low[a];
    std::sort(side, side + 3);
    return (std::max)(std::sqrt(side[1] * side[2] / (parent.end - parent.begin)),
                      side[2] / (parent.end - parent.begin));
  }

  // The candidates of a leaf are too many where the box around it holds a much denser part of the points.
  static constexpr std::size_t MAXIMUM_CANDIDATES = 4096;

  // Coordinates relative to the leaf in single precision: they only rank. The candidates stay for the
  // next point of the leaf. False if there are too many.
  bool gather(const Point_octree_3::Node& leaf, const Local_box& box, double radius)
  {
    if (radius == m_gathered_radius && leaf.box.low == m_gathered_leaf.low && leaf.box.high == m_gathered_leaf.high)
      return true;
    m_gathered_radius = NOT_GATHERED;
    m_candidates.clear();
    m_octree.for_each_leaf_overlapping(box, m_stack, [&](const Point_octree_3::Node& n) {
      const std::size_t first = m_candidates.size();
      m_candidates.resize(first + (n.end - n.begin));
      std::size_t end = first;
      for (Point_index i = n.begin; i != n.end; ++i) {
        m_candidates[end] = i;
        end += box.contains(m_points[i]) ? 1u : 0u;
      }
      m_candidates.resize(end);
      return end <= MAXIMUM_CANDIDATES;
    });
    const std::size_t n = m_candidates.size();
    if (n > MAXIMUM_CANDIDATES)
      return false;
    m_x.resize(n);
    m_y.resize(n);
    m_z.resize(n);
    m_squared_distances.resize(n);
    for (std::size_t i = 0; i != n; ++i) {
      const Local_point& p = m_points[m_candidates[i]];
      m_x[i] = float(p.x() - leaf.box.low[0]);
      m_y[i] = float(p.y() - leaf.box.low[1]);
      m_z[i] = float(p.z() - leaf.box.low[2]);
    }
    m_gathered_radius = radius;
    m_gathered_leaf = leaf.box;
    return true;
  }

  // Like serve(), without candidates.
  template <typename Visit>
  void serve_alone(Request request, std::size_t maximum_size, Visit& visit)
  {
    const double squared_reach = m_maximum_radius * m_maximum_radius;
    while (true) {
      const std::vector<Nearest_search::Neighbor>& nearest = m_search(request.point, request.size, squared_reach);
      const std::size_t found = nearest.size();
      m_nearest.resize((std::max)(m_nearest.size(), found));
      for (std::size_t i = 0; i != found; ++i)
        m_nearest[i] = nearest[i].second;
      const double squared_radius =
        copy_offsets(m_points[request.point], found, found < request.size ? squared_reach : 0.);
      const bool may_grow = request.size < maximum_size && found == request.size;
      if (visit_neighborhood(request.point, squared_radius, may_grow, visit) || !may_grow)
        return;
      request.size = (std::min)(2 * request.size, maximum_size);
    }
  }

  // False if the candidates do not reach far enough.
  template <typename Visit>
  bool serve(Request& request, const Point_octree_3::Node& leaf, const Local_box& box, bool is_exhaustive,
             std::size_t maximum_size, Visit& visit)
  {
    const Local_point& p = m_points[request.point];
    double reach = is_exhaustive ? m_maximum_radius : (std::numeric_limits<double>::max)();
    if (!is_exhaustive)
      for (std::size_t a = 0; a != 3; ++a)
        reach = (std::min)({ reach, p[int(a)] - box.low[a], box.high[a] - p[int(a)] });
    compute_squared_distances(p, leaf);
    m_sorted = 0;
    m_has_all_in_reach = false;
    while (true) {
      std::size_t found = select(request, reach * reach);
      if (is_too_close(found, p, leaf, reach * reach)) {
        found = select_in_double_precision(request, reach * reach);
        m_has_all_in_reach = false;
      }
      if (found < request.size && !is_exhaustive)
        return false;
      const std::size_t used = (std::min)(found, request.size);
      const double squared_radius = copy_offsets(p, used, found < request.size ? reach * reach : 0.);
      const bool may_grow = request.size < maximum_size && used == request.size;
      if (visit_neighborhood(request.point, squared_radius, may_grow, visit) || !may_grow)
        return true;
      request.size = (std::min)(2 * request.size, maximum_size);
    }
  }

  template <typename Visit>
  bool visit_neighborhood(Point_index p, double squared_radius, bool may_grow, Visit& visit) const
  {
    return visit(p,
                 Star_neighborhood(m_offsets.data(), m_offsets.size(), squared_radius, may_grow, m_keeps_boundaries));
  }

  void compute_squared_distances(const Local_point& p, const Point_octree_3::Node& leaf)
  {
    const float x = float(p.x() - leaf.box.low[0]), y = float(p.y() - leaf.box.low[1]),
                z = float(p.z() - leaf.box.low[2]);
    const std::size_t n = m_candidates.size();
    const float* const xs = m_x.data();
    const float* const ys = m_y.data();
    const float* const zs = m_z.data();
    float* const squared = m_squared_distances.data();
    for (std::size_t i = 0; i != n; ++i) {
      const float dx = xs[i] - x, dy = ys[i] - y, dz = zs[i] - z;
      squared[i] = dx * dx + dy * dy + dz * dz;
    }
  }

  // Sorts the nearest candidates but the point itself into m_nearest, at most request.size of them.
  // Returns how many there are within the radius, or request.size.
  std::size_t select(const Request& request, double squared_reach)
  {
    if (!m_has_all_in_reach)
      collect(request, squared_reach);
    if (m_found <= MAXIMUM_RANKED) {
      if (m_sorted < m_found)
        sort_by_rank(m_found);
      m_sorted = m_found;
    } else {
      const std::size_t kept = (std::min)(m_found, request.size);
      const auto first = m_nearest.begin() + std::ptrdiff_t(m_sorted), last = m_nearest.begin() + std::ptrdiff_t(kept);
      std::nth_element(first, last, m_nearest.begin() + std::ptrdiff_t(m_found));
      std::sort(first, last);
      m_sorted = kept;
    }
    if (m_found < request.size)
      return m_found;
    // the next point is close to this one
    m_guess_per_neighbor = GUESS_MARGIN * double(squared_distance(m_nearest[request.size - 1])) / double(request.size);
    return request.size;
  }

  // Those within a guess of the radius, if they are enough. A point that asks again will mostly ask once more: then all
  // within reach are collected, and what has been sorted of them stays.
  void collect(const Request& request, double squared_reach)
  {
    const double guess = m_guess_per_neighbor * double(request.size);
    m_has_all_in_reach = m_sorted != 0 || !(guess < squared_reach);
    m_sorted = 0;
    m_found = collect(m_has_all_in_reach ? squared_reach : guess, request.point);
    if (m_found < request.size && !m_has_all_in_reach) {
      m_found = collect(squared_reach, request.point);
      m_has_all_in_reach = true;
    }
  }

  // That of a key.
  static float squared_distance(std::uint64_t key)
  {
    const std::uint32_t bits = static_cast<std::uint32_t>(key >> 32);
    float result;
    std::memcpy(&result, &bits, sizeof result);
    return result;
  }

  // Sorts the first n keys: each goes where the number of smaller ones says, which the compiler counts several at a
  // time.
  void sort_by_rank(std::size_t n)
  {
    std::array<std::uint64_t, MAXIMUM_RANKED> keys;
    std::array<float, MAXIMUM_RANKED> distances;
    for (std::size_t i = 0; i != n; ++i) {
      keys[i] = m_nearest[i];
      distances[i] = squared_distance(keys[i]);
    }
    for (std::size_t i = 0; i != n; ++i)
      m_nearest[rank(distances.data(), n, i)] = keys[i];
  }

  // Of two at the same distance, the first comes first, as keys that are still in the order of the candidates do.
  static std::size_t rank(const float* distances, std::size_t n, std::size_t i)
  {
    const float distance = distances[i];
    std::int32_t result = 0;
    for (std::size_t j = 0; j < n; ++j)
      result += distances[j] < distance ? 1 : 0;
    for (std::size_t j = 0; j < i; ++j)
      result += distances[j] == distance ? 1 : 0;
    return static_cast<std::size_t>(result);
  }

  // A key is the distance, then the position among the candidates, whose order is canonical: the bits
  // of a non-negative float sort like the float.
  std::size_t collect(double squared_radius, Point_index center)
  {
    const float bound = float(squared_radius);
    m_nearest.resize((std::max)(m_nearest.size(), m_candidates.size()));
    std::size_t found = 0;
    for (std::size_t i = 0; i != m_candidates.size(); ++i) {
      std::uint32_t bits;
      std::memcpy(&bits, &m_squared_distances[i], sizeof bits);
      m_nearest[found] = (std::uint64_t(bits) << 32) | m_candidates[i];
      found += (m_squared_distances[i] <= bound && m_candidates[i] != center) ? 1u : 0u;
    }
    return found;
  }

  // Whether single precision does not tell the distances of p from its neighbors apart, because the
  // nearest one is too close for coordinates relative to the leaf, or for the exponent of a float.
  bool is_too_close(std::size_t found, const Local_point& p, const Point_octree_3::Node& leaf,
                    double squared_reach) const
  {
    constexpr double smallest = double((std::numeric_limits<float>::min)());
    if (found == 0)
      return squared_reach < smallest;
    const double nearest = double(squared_distance(m_nearest[0]));
    double resolution = 0.;
    for (std::size_t a = 0; a != 3; ++a)
      resolution = (std::max)(resolution, (p[int(a)] - leaf.box.low[a]) * RELATIVE_RESOLUTION);
    return nearest < (std::max)(resolution * resolution, smallest);
  }

  // Like select().
  std::size_t select_in_double_precision(const Request& request, double squared_reach)
  {
    m_exact.clear();
    for (Point_index i : m_candidates) {
      const double squared = (m_points[i] - m_points[request.point]).squared_length();
      if (squared <= squared_reach && i != request.point)
        m_exact.emplace_back(squared, i);
    }
    const std::size_t found = (std::min)(m_exact.size(), request.size);
    std::partial_sort(m_exact.begin(), m_exact.begin() + std::ptrdiff_t(found), m_exact.end());
    for (std::size_t i = 0; i != found; ++i)
      m_nearest[i] = m_exact[i].second;
    return found;
  }

  // Returns the square of the radius that the offsets cover, at least `squared_radius`.
  double copy_offsets(const Local_point& p, std::size_t n, double squared_radius)
  {
    m_offsets.resize(n);
    m_indices.resize(n);
    for (std::size_t i = 0; i != n; ++i) {
      m_indices[i] = static_cast<Point_index>(m_nearest[i]);
      m_offsets[i] = m_points[m_indices[i]] - p;
    }
    return n == 0 ? squared_radius : (std::max)(squared_radius, m_offsets.back().squared_length());
  }

  const std::vector<Local_point>& m_points;
  const Point_octree_3& m_octree;
  double m_maximum_radius;
  bool m_keeps_boundaries;
  Nearest_search m_search;
  double m_guess_per_neighbor = 0.; // square of the radius that holds the neighbors, for each of them
  static constexpr double NOT_GATHERED = -1.;
  double m_gathered_radius = NOT_GATHERED; // around the box of the leaf, for the present candidates
  Local_box m_gathered_leaf{};
  std::vector<Request> m_pending;
  std::vector<std::uint32_t> m_stack;
  std::vector<Point_index> m_candidates;
  std::vector<float> m_x, m_y, m_z, m_squared_distances;
  std::vector<std::uint64_t> m_nearest;
  // Of the present point: how many of m_nearest are sorted, how many there are, and whether they are all within reach.
  std::size_t m_sorted = 0, m_found = 0;
  bool m_has_all_in_reach = false;
  std::vector<std::pair<double, Point_index> > m_exact;
  std::vector<Point_index> m_indices;
  std::vector<Local_vector> m_offsets;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_NEAREST_NEIGHBORS_H

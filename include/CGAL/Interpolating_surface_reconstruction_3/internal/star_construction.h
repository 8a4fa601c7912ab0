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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STAR_CONSTRUCTION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STAR_CONSTRUCTION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Box_neighborhoods.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Nearest_neighbors.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/parallel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Point_star.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

template <typename NeighborhoodCategory>
struct Neighborhoods;

template <>
struct Neighborhoods<Nearest_neighborhood_tag>
{
  using type = Nearest_neighbors;
};

template <>
struct Neighborhoods<Box_neighborhood_tag>
{
  using type = Box_neighborhoods;
};

// Stars of the points of the leaves [begin, end), in the order of the points; incomplete if
// go_further() returns false.
template <typename StarConstruction, typename GoFurther>
Star_table::Block stars_of_leaves(const std::vector<Local_point>& points, const Point_octree_3& octree,
                                  const StarConstruction& construction, double maximum_radius, bool keeps_boundaries,
                                  std::size_t begin, std::size_t end, const GoFurther& go_further)
{
  // between two polls; some milliseconds
  constexpr std::size_t NEIGHBORS_PER_POLL = 1 << 15;
  std::size_t neighbors = 0;
  typename Neighborhoods<typename StarConstruction::Neighborhood_category>::type neighborhoods(
    points, octree, maximum_radius, keeps_boundaries);
  // A leaf's points may become certain in any order.
  std::vector<std::vector<Point_index> > links(OCTREE_LEAF_SIZE);
  Star_table::Block block;
  Point_star star;
  for (std::size_t l = begin; l != end; ++l) {
    const Point_octree_3::Node& leaf = octree.node(octree.leaves()[l]);
    links.resize((std::max)(links.size(), std::size_t(leaf.end - leaf.begin)));
    neighborhoods.for_each_point(leaf, construction.initial_number_of_neighbors(),
                                 construction.maximum_number_of_neighbors(),
                                 [&](Point_index p, const Star_neighborhood& neighborhood) {
                                   neighbors += neighborhood.size();
                                   const bool is_certain = construction(neighborhood, star);
                                   std::vector<Point_index>& link = links[p - leaf.begin];
                                   link.clear();
                                   for (std::uint32_t j : star.link)
                                     link.push_back(j == Point_star::GAP ? NO_POINT : neighborhoods.indices()[j]);
                                   return is_certain;
                                 });
    for (Point_index p = leaf.begin; p != leaf.end; ++p) {
      const std::vector<Point_index>& link = links[p - leaf.begin];
      block.lengths.push_back(static_cast<std::uint32_t>(link.size()));
      block.neighbors.insert(block.neighbors.end(), link.begin(), link.end());
    }
    if (neighbors > NEIGHBORS_PER_POLL) {
      neighbors = 0;
      if (!go_further())
        return block;
    }
  }
  return block;
}

// The star of every point (thesis 4.3.2 and 4.3.3); no star depends on another.
template <typename ConcurrencyTag, typename StarConstruction, typename Progress>
Star_table construct_stars(const std::vector<Local_point>& points, const Point_octree_3& octree,
                           const StarConstruction& construction, double maximum_radius, Progress& progress,
                           bool keeps_boundaries = false)
{
  constexpr std::size_t LEAVES_PER_BLOCK = 64;
  const std::size_t leaves = octree.leaves().size();
  std::vector<Star_table::Block> blocks((leaves + LEAVES_PER_BLOCK - 1) / LEAVES_PER_BLOCK);
  std::atomic<std::size_t> done{ 0 };
  for_each_block<ConcurrencyTag>(leaves, LEAVES_PER_BLOCK, [&](std::size_t begin, std::size_t end) {
    if (progress.advance(double(done += end - begin) / double(leaves)))
      blocks[begin / LEAVES_PER_BLOCK] = stars_of_leaves(points, octree, construction, maximum_radius, keeps_boundaries,
                                                         begin, end, [&] { return progress.advance(0.); });
  });
  return Star_table(std::move(blocks));
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STAR_CONSTRUCTION_H

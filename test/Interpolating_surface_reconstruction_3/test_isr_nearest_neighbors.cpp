#include "isr_stage_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Nearest_neighbors.h>

#include <ctime>
#include <iostream>

using namespace isr_stage_test;
using ISR::Star_neighborhood;
using ISR::internal::Nearest_neighbors;

constexpr double INFINITE = std::numeric_limits<double>::infinity();
// Neighbors are ranked in single precision, to four digits at least.
constexpr double TOLERANCE = 1e-4;

// Compares a neighborhood with all distances.
void check(const Indexed_points& indexed, Point_index p, const Star_neighborhood& n,
           const std::vector<Point_index>& indices, std::size_t size, double maximum_radius)
{
  assert(n.size() == indices.size() && n.size() <= size);
  std::vector<double> squared;
  for (std::size_t q = 0; q != indexed.points.size(); ++q)
    if (q != p)
      squared.push_back(CGAL::squared_distance(indexed.points[p], indexed.points[q]));
  std::sort(squared.begin(), squared.end());
  std::size_t expected =
    std::size_t(std::upper_bound(squared.begin(), squared.end(), maximum_radius * maximum_radius) - squared.begin());
  const bool is_everything = expected <= size;
  expected = (std::min)(expected, size);
  assert(n.size() == expected);
  std::vector<Point_index> distinct = indices;
  std::sort(distinct.begin(), distinct.end());
  assert(std::adjacent_find(distinct.begin(), distinct.end()) == distinct.end());
  for (std::size_t i = 0; i != n.size(); ++i) {
    assert(indices[i] != p && n[i] == indexed.points[indices[i]] - indexed.points[p]);
    assert(std::abs(n[i].squared_length() - squared[i]) <= TOLERANCE * squared[i]);
  }
  // no unlisted point is closer than the radius
  if (n.size() < squared.size())
    assert(n.squared_radius() <= (1. + TOLERANCE) * (std::max)(squared[n.size()], maximum_radius * maximum_radius));
  if (n.size() < squared.size() && squared[n.size()] <= maximum_radius * maximum_radius)
    assert(n.squared_radius() <= (1. + TOLERANCE) * squared[n.size()]);
  if (n.size() != 0)
    assert(n.squared_radius() >= n[n.size() - 1].squared_length());
  if (is_everything && n.size() < size)
    assert(n.squared_radius() == maximum_radius * maximum_radius);
}

void compare(const std::vector<Local_point>& points, std::size_t size, double maximum_radius = INFINITE)
{
  const Indexed_points indexed(points);
  Nearest_neighbors neighbors(indexed.points, indexed.octree, maximum_radius);
  std::vector<int> visits(points.size(), 0);
  for (std::uint32_t leaf : indexed.octree.leaves())
    neighbors.for_each_point(indexed.octree.node(leaf), size, size, [&](Point_index p, const Star_neighborhood& n) {
      ++visits[p];
      check(indexed, p, n, neighbors.indices(), size, maximum_radius);
      return true;
    });
  assert(std::count(visits.begin(), visits.end(), 1) == std::ptrdiff_t(points.size()));
}

void test_brute_force()
{
  compare({}, 16);
  compare({ Local_point(1, 2, 3) }, 16);
  compare({ Local_point(1, 2, 3), Local_point(1, 2, 4) }, 16);
  for (std::size_t size : { 1u, 6u, 16u, 64u, 2000u }) {
    compare(sphere(600, .02, 1), size);
    compare(random_box(500, 2), size);
    compare(square_grid(20), size);
  }
  compare(random_patch(1000, 3), 16);
  std::vector<Local_point> line;
  for (int i = 0; i != 300; ++i)
    line.emplace_back(i * .01, 0., 0.);
  compare(line, 16);
}

// Of points at the same distance, those that come first in the cloud come first, however many are asked for.
void test_ties()
{
  std::vector<Local_point> grid;
  for (int i = 0; i != 33; ++i)
    for (int j = 0; j != 33; ++j)
      grid.emplace_back(i / 32., j / 32., 0.);
  const Indexed_points indexed(grid);
  for (const std::size_t size : { 2u, 6u, 16u, 30u, 64u }) {
    Nearest_neighbors neighbors(indexed.points, indexed.octree, INFINITE);
    for (Point_index p = 0; p != grid.size(); ++p) {
      std::vector<std::pair<double, Point_index> > all;
      for (Point_index q = 0; q != grid.size(); ++q)
        if (q != p)
          all.emplace_back(CGAL::squared_distance(indexed.points[p], indexed.points[q]), q);
      std::sort(all.begin(), all.end());
      neighbors.for_point(p, size, size, [&](Point_index, const Star_neighborhood& n) {
        assert(n.size() == size);
        for (std::size_t i = 0; i != size; ++i)
          assert(neighbors.indices()[i] == all[i].second);
        return true;
      });
    }
  }
}

void test_maximum_radius()
{
  for (double radius : { 1e-6, .05, .2, 1., 10. })
    compare(sphere(500, .02, 4), 16, radius);
}

// Each cluster's points have neighbors in the cluster, and every one sees those of its own scale.
void test_clusters_of_different_spacing()
{
  std::vector<Local_point> clusters;
  for (int scale = 0; scale != 6; ++scale)
    for (const Local_point& p : sphere(60, .05, std::uint32_t(scale)))
      clusters.push_back(Local_point(3. * scale, 0, 0) + (p - CGAL::ORIGIN) * std::pow(1e-2, scale));
  compare(clusters, 16);
  compare(clusters, 64);
  // few points, in leaves that hold several clusters, far from the leaf's corner
  std::vector<Local_point> pairs;
  for (const Local_point& p : random_box(12, 5)) {
    pairs.push_back(Local_point(.3, .7, .1) + (p - CGAL::ORIGIN) * 1e-8);
    pairs.push_back(Local_point(.9, .2, .8) + (p - CGAL::ORIGIN) * 1e-9);
  }
  compare(pairs, 6);
  // a dense cluster in the upper corner of a leaf of sparse points
  std::vector<Local_point> nested;
  for (int scale = 0; scale != 8; ++scale)
    for (const Local_point& p : random_box(10, std::uint32_t(6 + scale)))
      nested.push_back(Local_point(1, 1, 1) + (p - CGAL::ORIGIN) * std::pow(1e-1, scale));
  compare(nested, 8);
}

// All points are nearer to a center, in whatever scale, than the next ones around it.
void test_scales_around_center()
{
  std::vector<Local_point> points;
  const std::vector<Local_point> directions = random_box(20000, 15);
  for (std::size_t i = 0; i != directions.size(); ++i)
    points.push_back(CGAL::ORIGIN + (directions[i] - CGAL::ORIGIN) * std::pow(2., -40. * double(i) / 20000.));
  const Indexed_points indexed(points);
  for (const double maximum_radius : { INFINITE, 1e-3 }) {
    Nearest_neighbors neighbors(indexed.points, indexed.octree, maximum_radius);
    std::size_t size = 16;
    for (Point_index p = 0; p < points.size(); p += 101)
      neighbors.for_point(p, size, 64, [&](Point_index q, const Star_neighborhood& n) {
        assert(q == p);
        check(indexed, p, n, neighbors.indices(), size, maximum_radius);
        size = size == 16 ? 32 : 16;
        return size == 16;
      });
  }
}

// Coordinates whose squares have no room in single precision.
void test_tiny_spacing()
{
  for (double scale : { 1e-15, 1e-25, 1e-50, 1e-100 }) {
    std::vector<Local_point> points;
    for (const Local_point& p : sphere(300, .02, 14))
      points.push_back(CGAL::ORIGIN + (p - CGAL::ORIGIN) * scale);
    compare(points, 16);
    points.emplace_back(1, 1, 1);
    compare(points, 16);
  }
}

void test_coincident_points()
{
  compare(std::vector<Local_point>(100, Local_point(.1, .2, .3)), 16);
  std::vector<Local_point> points = random_box(100, 20);
  for (std::size_t i = 0; i != 50; ++i)
    points.push_back(points[i]);
  points.insert(points.end(), 40, Local_point(.5, .5, .5));
  compare(points, 16);
}

// More neighbors are asked for until the visitor is content, and not for longer than needed.
void test_growth()
{
  const Indexed_points indexed(sphere(500, .02, 21));
  Nearest_neighbors neighbors(indexed.points, indexed.octree, INFINITE);
  for (std::size_t maximum : { 8u, 40u, 64u, 5000u }) {
    std::vector<std::vector<std::size_t> > sizes(indexed.points.size());
    for (std::uint32_t leaf : indexed.octree.leaves())
      neighbors.for_each_point(indexed.octree.node(leaf), 8, maximum, [&](Point_index p, const Star_neighborhood& n) {
        check(indexed, p, n, neighbors.indices(), n.size(), INFINITE);
        sizes[p].push_back(n.size());
        return p % 3 == 0 && sizes[p].size() == 2;
      });
    for (Point_index p = 0; p != sizes.size(); ++p) {
      std::vector<std::size_t> expected = { 8 };
      while (expected.back() < (std::min<std::size_t>)(maximum, 499) && !(p % 3 == 0 && expected.size() == 2))
        expected.push_back((std::min)({ 2 * expected.back(), maximum, std::size_t(499) }));
      assert(sizes[p] == expected);
    }
  }
}

double seconds_for(const std::vector<Local_point>& points)
{
  const Indexed_points indexed(points);
  const std::clock_t begin = std::clock();
  Nearest_neighbors neighbors(indexed.points, indexed.octree, INFINITE);
  std::size_t visits = 0;
  for (std::uint32_t leaf : indexed.octree.leaves())
    neighbors.for_each_point(indexed.octree.node(leaf), 16, 64, [&](Point_index, const Star_neighborhood& n) {
      ++visits;
      assert(n.size() == 16);
      return true;
    });
  assert(visits == points.size());
  return double(std::clock() - begin) / CLOCKS_PER_SEC;
}

// A far outlier does not make the search quadratic: all pairs would take a hundred times as long.
void test_far_outlier()
{
  std::vector<Local_point> points = sphere(20000, 0., 22);
  const double alone = seconds_for(points);
  points.emplace_back(1e9, 0, 0);
  points.emplace_back(0, -1e9, 1e5);
  assert(seconds_for(points) < 5. * alone + .1);
}

int main()
{
  test_brute_force();
  test_ties();
  test_maximum_radius();
  test_clusters_of_different_spacing();
  test_coincident_points();
  test_growth();
  test_far_outlier();
  test_tiny_spacing();
  test_scales_around_center();
  std::cout << "done" << std::endl;
  return 0;
}

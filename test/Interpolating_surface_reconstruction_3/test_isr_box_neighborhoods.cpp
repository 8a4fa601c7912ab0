#include "isr_stage_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Box_neighborhoods.h>

#include <iostream>

using namespace isr_stage_test;
using ISR::internal::Box_neighborhoods;
using ISR::internal::OCTREE_LEAF_SIZE;

constexpr double INFINITE = std::numeric_limits<double>::infinity();
constexpr std::size_t ALL = 1000000;

// Neighborhoods of all points, after the checks that every neighborhood has to pass.
std::vector<std::vector<Point_index> > neighborhoods(const Indexed_points& indexed, double maximum_radius,
                                                     std::size_t maximum_size)
{
  std::vector<std::vector<Point_index> > result(indexed.points.size());
  std::vector<int> visits(indexed.points.size(), 0);
  Box_neighborhoods boxes(indexed.points, indexed.octree, maximum_radius);
  for (std::uint32_t leaf : indexed.octree.leaves())
    boxes.for_each_point(indexed.octree.node(leaf), 16, maximum_size,
                         [&](Point_index p, const ISR::Star_neighborhood& n) {
                           ++visits[p];
                           assert(n.size() == boxes.indices().size() && n.size() <= maximum_size);
                           for (std::size_t i = 0; i != n.size(); ++i) {
                             assert(boxes.indices()[i] != p);
                             assert(n[i] == indexed.points[boxes.indices()[i]] - indexed.points[p]);
                             assert(n[i].squared_length() <= maximum_radius * maximum_radius);
                             assert(i == 0 || n[i - 1].squared_length() <= n[i].squared_length());
                           }
                           assert(n.squared_radius() == 0.);
                           result[p] = boxes.indices();
                           std::sort(result[p].begin(), result[p].end());
                           assert(std::adjacent_find(result[p].begin(), result[p].end()) == result[p].end());
                           return false; // asking for more is of no use
                         });
  for (int v : visits)
    assert(v == 1);
  return result;
}

bool contains(const std::vector<Point_index>& sorted, Point_index i)
{
  return std::binary_search(sorted.begin(), sorted.end(), i);
}

void test_shared_and_symmetric(const std::vector<Local_point>& points)
{
  const Indexed_points indexed(points);
  const auto all = neighborhoods(indexed, INFINITE, ALL);
  for (std::uint32_t leaf : indexed.octree.leaves()) {
    const Point_octree_3::Node& node = indexed.octree.node(leaf);
    std::vector<Point_index> first = all[node.begin];
    first.push_back(node.begin);
    std::sort(first.begin(), first.end());
    for (Point_index p = node.begin; p != node.end; ++p) {
      assert(contains(first, p));
      std::vector<Point_index> own = all[p];
      own.push_back(p);
      std::sort(own.begin(), own.end());
      assert(own == first);
    }
  }
  for (Point_index p = 0; p != all.size(); ++p)
    for (Point_index q : all[p])
      assert(contains(all[q], p));
}

// The boxes find nearly all points that matter, and far fewer than there are.
void test_nearest_points_on_sphere()
{
  const std::size_t k = 8;
  const Indexed_points indexed(sphere(3000, .01, 3));
  const auto all = neighborhoods(indexed, INFINITE, ALL);
  std::size_t found = 0, total = 0;
  for (Point_index p = 0; p != all.size(); ++p) {
    std::vector<std::pair<double, Point_index> > nearest;
    for (Point_index q = 0; q != all.size(); ++q)
      if (q != p)
        nearest.emplace_back(CGAL::squared_distance(indexed.points[p], indexed.points[q]), q);
    std::partial_sort(nearest.begin(), nearest.begin() + k, nearest.end());
    for (std::size_t i = 0; i != k; ++i)
      found += contains(all[p], nearest[i].second) ? 1u : 0u;
    total += all[p].size();
  }
  assert(double(found) >= .999 * double(k * all.size()));
  assert(total / all.size() < 400);
}

// Cells that are aligned with the points isolate no leaf.
void test_aligned_grid()
{
  for (std::size_t m : { 16u, 31u, 33u, 48u }) {
    const Indexed_points indexed(square_grid(m));
    const auto all = neighborhoods(indexed, INFINITE, ALL);
    for (Point_index p = 0; p != all.size(); ++p) {
      std::size_t adjacent = 0, expected = 0;
      for (Point_index q : all[p])
        adjacent += CGAL::squared_distance(indexed.points[p], indexed.points[q]) == 1. ? 1u : 0u;
      for (Point_index q = 0; q != all.size(); ++q)
        expected += CGAL::squared_distance(indexed.points[p], indexed.points[q]) == 1. ? 1u : 0u;
      assert(adjacent == expected);
    }
  }
}

// Two patches whose leaves are not adjacent do not see each other.
void test_distant_patches()
{
  std::vector<Local_point> points = random_patch(500, 4);
  for (std::size_t i = 0; i != 500; ++i)
    points.push_back(points[i] + Local_vector(20, 0, 0));
  const Indexed_points indexed(points);
  const auto all = neighborhoods(indexed, INFINITE, ALL);
  for (Point_index p = 0; p != all.size(); ++p)
    for (Point_index q : all[p])
      assert((indexed.points[p].x() < 10) == (indexed.points[q].x() < 10));
}

void test_limits()
{
  const Indexed_points indexed(sphere(2000, .02, 5));
  const auto all = neighborhoods(indexed, INFINITE, ALL);
  const auto near_only = neighborhoods(indexed, .1, ALL);
  const auto few = neighborhoods(indexed, INFINITE, 10);
  for (Point_index p = 0; p != all.size(); ++p) {
    std::vector<Point_index> expected;
    for (Point_index q : all[p])
      if (CGAL::squared_distance(indexed.points[p], indexed.points[q]) <= .1 * .1)
        expected.push_back(q);
    assert(near_only[p] == expected);
    assert(few[p].size() == (std::min<std::size_t>)(10, all[p].size()));
    double farthest = 0.;
    for (Point_index q : few[p])
      farthest = (std::max)(farthest, CGAL::squared_distance(indexed.points[p], indexed.points[q]));
    for (Point_index q : all[p])
      assert(contains(few[p], q) || CGAL::squared_distance(indexed.points[p], indexed.points[q]) >= farthest);
  }
}

// A leaf with many coincident points costs every neighbor a bounded number of candidates.
void test_coincident_points()
{
  std::vector<Local_point> points(20000, Local_point(.3, .3, .3));
  const std::vector<Local_point> around = sphere(500, .01, 6);
  points.insert(points.end(), around.begin(), around.end());
  const Indexed_points indexed(points);
  std::size_t total = 0;
  for (const std::vector<Point_index>& n : neighborhoods(indexed, INFINITE, ALL))
    total += n.size();
  assert(total <= indexed.points.size() * 27 * OCTREE_LEAF_SIZE);
  for (const std::vector<Point_index>& n :
       neighborhoods(Indexed_points(std::vector<Local_point>(100, Local_point(1, 1, 1))), INFINITE, ALL))
    assert(n.size() <= OCTREE_LEAF_SIZE);
}

void test_tiny_clouds()
{
  assert(neighborhoods(Indexed_points({}), INFINITE, ALL).empty());
  assert(neighborhoods(Indexed_points({ Local_point(1, 2, 3) }), INFINITE, ALL)[0].empty());
  const auto two = neighborhoods(Indexed_points({ Local_point(1, 2, 3), Local_point(0, 0, 0) }), INFINITE, ALL);
  assert(two[0].size() == 1 && two[1].size() == 1);
}

int main()
{
  test_shared_and_symmetric(sphere(2000, .02, 1));
  test_shared_and_symmetric(random_box(1000, 2));
  test_nearest_points_on_sphere();
  test_aligned_grid();
  test_distant_patches();
  test_limits();
  test_coincident_points();
  test_tiny_clouds();
  std::cout << "done" << std::endl;
  return 0;
}

#include "isr_stage_test_utils.h"

#include <iostream>

using namespace isr_stage_test;
using ISR::internal::bounding_cube;
using ISR::internal::Morton_key;
using ISR::internal::MORTON_LEVELS;
using ISR::internal::Octree_cube;

// Bit by bit.
std::uint64_t naive_key(const Local_point& p, const Octree_cube& cube)
{
  std::uint64_t result = 0;
  std::array<double, 3> low = cube.origin;
  double size = cube.size;
  for (int level = 0; level != MORTON_LEVELS; ++level) {
    size /= 2;
    for (std::size_t a = 3; a-- != 0;) {
      const bool is_upper = p[int(a)] >= low[a] + size;
      low[a] += is_upper ? size : 0.;
      result = 2 * result + (is_upper ? 1 : 0);
    }
  }
  return result;
}

void test_key()
{
  const Octree_cube cube{ { 0., 0., 0. }, 1. };
  const Morton_key key(cube);
  assert(key(Local_point(0, 0, 0)) == 0);
  assert(key(Local_point(1, 1, 1)) == (std::uint64_t(1) << 63) - 1);
  // outside, as rounding may have it
  assert(key(Local_point(-1e-9, 0, 0)) == 0);
  assert(key(Local_point(2, 2, 2)) == (std::uint64_t(1) << 63) - 1);
  for (unsigned int octant = 0; octant != 8; ++octant) {
    const std::uint64_t k = key(Local_point(octant & 1u ? .75 : .25, octant & 2u ? .75 : .25, octant & 4u ? .75 : .25));
    assert(Morton_key::octant(k, 0) == octant);
    assert(Morton_key::octant(k, 1) == 7);
    assert(Morton_key::octant(k, 2) == 0);
  }
  Random random(1);
  for (int i = 0; i != 2000; ++i) {
    const double x = random(0, 1), y = random(0, 1), z = random(0, 1);
    assert(key(Local_point(x, y, z)) == naive_key(Local_point(x, y, z), cube));
  }
}

void test_bounding_cube()
{
  const std::vector<Local_point> points = { Local_point(1, 5, -2), Local_point(3, 5, -7), Local_point(2, 6, 0) };
  const Octree_cube cube = bounding_cube(points.begin(), points.end());
  assert((cube.origin == std::array<double, 3>{ 1., 5., -7. }) && cube.size == 7.);
  assert(bounding_cube(points.begin(), points.begin() + 1).size == 0.);
}

double path_length(const std::vector<Local_point>& points)
{
  double result = 0.;
  for (std::size_t i = 1; i < points.size(); ++i)
    result += std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
  return result;
}

void check_order(std::vector<Local_point> points)
{
  const std::vector<Local_point> sorted = in_morton_order(points);
  if (!points.empty()) {
    const Octree_cube cube = bounding_cube(points.begin(), points.end());
    if (cube.size > 0. && points.size() > ISR::internal::OCTREE_LEAF_SIZE) {
      const Morton_key key(cube);
      for (std::size_t i = 1; i < sorted.size(); ++i)
        assert(key(sorted[i - 1]) <= key(sorted[i]));
    }
  }
  Random random(2);
  random.shuffle(points);
  assert(in_morton_order(points) == sorted);
  std::vector<Local_point> a = points, b = sorted;
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  assert(a == b);
}

void test_order()
{
  check_order({});
  check_order({ Local_point(1, 2, 3) });
  check_order(random_box(24, 3));
  check_order(random_box(25, 4));
  check_order(random_box(5000, 5));
  check_order(sphere(3000, .01, 6));
  check_order(square_grid(50));
  check_order(std::vector<Local_point>(500, Local_point(.1, .2, .3)));
  std::vector<Local_point> coincident = random_box(50, 7);
  for (int i = 0; i != 500; ++i)
    coincident.push_back(coincident[std::size_t(i % 3)]);
  check_order(coincident);
}

// Neighbors in the order are neighbors in space, also next to an outlier that takes all bits of the
// keys, and also in a dense cluster.
void test_locality()
{
  std::vector<Local_point> points = random_box(5000, 8);
  const double alone = path_length(in_morton_order(points));
  assert(alone < path_length(points) / 5);
  points.emplace_back(1e9, 1e9, 1e9);
  std::vector<Local_point> sorted = in_morton_order(points);
  assert(sorted.back() == points.back());
  sorted.pop_back();
  assert(path_length(sorted) < 1.2 * alone);
  // two outliers nested
  points.emplace_back(1e18, 0, 0);
  sorted = in_morton_order(points);
  sorted.resize(5000);
  assert(path_length(sorted) < 1.2 * alone);
}

// Points at all scales that a double has.
void test_exponential_spacing()
{
  std::vector<Local_point> points;
  for (int exponent = 0; exponent != 1000; ++exponent)
    points.emplace_back(std::ldexp(1., -exponent), std::ldexp(1., -exponent), 0.);
  const std::vector<Local_point> sorted = in_morton_order(points);
  for (std::size_t i = 1; i != sorted.size(); ++i)
    assert(sorted[i - 1].x() < sorted[i].x());
  check_order(points);
}

int main()
{
  test_key();
  test_bounding_cube();
  test_order();
  test_locality();
  test_exponential_spacing();
  std::cout << "done" << std::endl;
  return 0;
}

#include "isr_stage_test_utils.h"

#include <array>
#include <iostream>
#include <new>

using namespace isr_stage_test;
using ISR::internal::Local_box;
using ISR::internal::OCTREE_LEAF_SIZE;
using Node = Point_octree_3::Node;

Local_box bounding_box(const std::vector<Local_point>& points, Point_index begin, Point_index end)
{
  Local_box result{ { points[begin].x(), points[begin].y(), points[begin].z() },
                    { points[begin].x(), points[begin].y(), points[begin].z() } };
  for (Point_index i = begin; i != end; ++i)
    result.include(points[i]);
  return result;
}

Local_box cell_box(const Node& n)
{
  const double s = n.cell.size;
  return Local_box{ n.cell.origin, { n.cell.origin[0] + s, n.cell.origin[1] + s, n.cell.origin[2] + s } };
}

void check_node(const Indexed_points& indexed, std::uint32_t i)
{
  const Point_octree_3& octree = indexed.octree;
  const Node& n = octree.node(i);
  assert(n.begin < n.end);
  const Local_box tight = bounding_box(indexed.points, n.begin, n.end);
  assert(n.box.low == tight.low && n.box.high == tight.high);
  assert(cell_box(n).enlarged(1e-6 * n.cell.size).contains(n.box));
  if (n.number_of_children == 0) {
    const bool is_one_place = n.box.low == n.box.high;
    assert(n.end - n.begin <= OCTREE_LEAF_SIZE || is_one_place);
    return;
  }
  assert(n.end - n.begin > OCTREE_LEAF_SIZE);
  assert(n.number_of_children >= 2 && n.number_of_children <= 8);
  Point_index next = n.begin;
  for (std::uint32_t c = n.first_child; c != n.first_child + n.number_of_children; ++c) {
    assert(c > i && octree.node(c).parent == i && octree.node(c).begin == next);
    next = octree.node(c).end;
    assert(octree.node(c).cell.size <= n.cell.size / 2);
  }
  assert(next == n.end);
}

void check(const std::vector<Local_point>& points)
{
  const Indexed_points indexed(points);
  const Point_octree_3& octree = indexed.octree;
  if (points.empty()) {
    assert(octree.nodes().empty() && octree.leaves().empty());
    octree.for_each_leaf_overlapping(Local_box{ { 0, 0, 0 }, { 1, 1, 1 } }, [](const Node&) {
      assert(false);
      return true;
    });
    return;
  }
  assert(octree.node(0).begin == 0 && octree.node(0).end == points.size() && octree.node(0).parent == 0);
  for (std::uint32_t i = 0; i != octree.nodes().size(); ++i)
    check_node(indexed, i);
  assert(octree.nodes().size() <= 2 * octree.leaves().size());
  Point_index next = 0;
  for (std::uint32_t leaf : octree.leaves()) {
    assert(octree.node(leaf).number_of_children == 0 && octree.node(leaf).begin == next);
    next = octree.node(leaf).end;
  }
  assert(next == points.size());
}

void test_invariants()
{
  check({});
  check({ Local_point(1, 2, 3) });
  check(random_box(24, 1));
  check(random_box(25, 2));
  check(random_box(5000, 3));
  check(sphere(5000, 0., 4));
  check(square_grid(40));
  check(std::vector<Local_point>(100, Local_point(1, 1, 1)));
}

// Depth follows the points, not the ratio of the distances.
void test_hard_inputs()
{
  std::vector<Local_point> points = random_box(5000, 5);
  points.emplace_back(1e9, -1e9, 1e9);
  check(points);
  points.insert(points.end(), 1000, Local_point(.25, .25, .25));
  check(points);
  std::vector<Local_point> exponential;
  for (int exponent = 0; exponent != 1000; ++exponent)
    exponential.emplace_back(std::ldexp(1., -exponent), 0., std::ldexp(1., -exponent));
  check(exponential);
  std::vector<Local_point> clusters;
  for (int scale = 0; scale != 6; ++scale)
    for (const Local_point& p : random_box(100, 6))
      clusters.push_back(Local_point(scale, 0, 0) + (p - CGAL::ORIGIN) * std::pow(1e-3, scale));
  check(clusters);
}

void test_overlapping_leaves()
{
  const Indexed_points indexed(sphere(4000, .05, 7));
  Random random(8);
  std::vector<std::uint32_t> stack;
  for (int i = 0; i != 300; ++i) {
    const double x = random(-1, 1), y = random(-1, 1), z = random(-1, 1), r = i % 3 == 0 ? 0. : random(0, 1);
    const Local_box box{ { x - r, y - r, z - r }, { x + r, y + r, z + r } };
    std::vector<Point_index> expected, with_stack, without_stack;
    for (std::uint32_t leaf : indexed.octree.leaves())
      if (indexed.octree.node(leaf).box.overlaps(box))
        expected.push_back(indexed.octree.node(leaf).begin);
    indexed.octree.for_each_leaf_overlapping(box, [&](const Node& n) {
      without_stack.push_back(n.begin);
      return true;
    });
    indexed.octree.for_each_leaf_overlapping(box, stack, [&](const Node& n) {
      with_stack.push_back(n.begin);
      return true;
    });
    assert(with_stack == without_stack);
    std::sort(with_stack.begin(), with_stack.end());
    assert(with_stack == expected);
  }
}

void test_box()
{
  const Local_box box{ { 0, 0, 0 }, { 1, 2, 3 } };
  assert(box.overlaps(Local_box{ { 1, 2, 3 }, { 4, 4, 4 } }));
  assert(!box.overlaps(Local_box{ { 1.1, 0, 0 }, { 4, 4, 4 } }));
  assert(box.contains(box) && box.contains(Local_box{ { .5, .5, .5 }, { .6, .6, .6 } }));
  assert(!box.contains(Local_box{ { .5, .5, .5 }, { .6, .6, 3.1 } }));
  const Local_box large = box.enlarged(1);
  assert((large.low == std::array<double, 3>{ -1, -1, -1 }) && (large.high == std::array<double, 3>{ 2, 3, 4 }));
}

// Whatever was in the memory of the box before.
void test_box_of_points()
{
  for (int value : { 0, 0x7f, 0xc0 }) {
    alignas(Local_box) std::array<unsigned char, sizeof(Local_box)> memory;
    memory.fill(static_cast<unsigned char>(value));
    Local_box& box = *new (memory.data()) Local_box;
    assert(!box.contains(Local_point(0, 0, 0)) && !box.overlaps(Local_box{ { -9, -9, -9 }, { 9, 9, 9 } }));
    box.include(Local_point(1, 2, 3));
    assert((box.low == std::array<double, 3>{ 1, 2, 3 }) && box.high == box.low);
    box.include(Local_point(3, 0, 4));
    assert((box.low == std::array<double, 3>{ 1, 0, 3 }) && (box.high == std::array<double, 3>{ 3, 2, 4 }));
  }
}

int main()
{
  test_box();
  test_box_of_points();
  test_invariants();
  test_hard_inputs();
  test_overlapping_leaves();
  std::cout << "done" << std::endl;
  return 0;
}

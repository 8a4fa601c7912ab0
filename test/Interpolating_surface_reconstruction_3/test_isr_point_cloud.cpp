#include "isr_stage_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_cloud_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>
#include <list>
#include <utility>

using namespace isr_stage_test;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Cloud = ISR::internal::Point_cloud_3<Kernel>;

constexpr double INFINITE = std::numeric_limits<double>::infinity();

template <typename K>
ISR::internal::Point_cloud_3<K> cloud_of(const std::vector<typename K::Point_3>& points)
{
  return ISR::internal::Point_cloud_3<K>(points, CGAL::Identity_property_map<typename K::Point_3>(), K());
}

Cloud cloud_of(const std::vector<Point_3>& points) { return cloud_of<Kernel>(points); }

std::vector<Point_3> random_points(std::size_t n, std::uint32_t seed)
{
  std::vector<Point_3> result;
  for (const Local_point& p : random_box(n, seed))
    result.emplace_back(p.x(), p.y(), p.z());
  return result;
}

double longest_side(const Cloud& cloud)
{
  double result = 0.;
  for (int a = 0; a != 3; ++a) {
    double low = INFINITE, high = -INFINITE;
    for (const Local_point& p : cloud.positions()) {
      low = (std::min)(low, p[a]);
      high = (std::max)(high, p[a]);
    }
    result = (std::max)(result, high - low);
  }
  return result;
}

// Every usable point of the range is there once, under the index of its first occurrence.
void check(const std::vector<Point_3>& points, const Cloud& cloud)
{
  std::vector<std::pair<Point_3, std::size_t> > expected;
  for (std::size_t i = 0; i != points.size(); ++i)
    if (std::isfinite(points[i].x()) && std::isfinite(points[i].y()) && std::isfinite(points[i].z()))
      expected.emplace_back(points[i], i);
  assert(cloud.number_of_non_finite_points() == points.size() - expected.size());
  std::sort(expected.begin(), expected.end());
  const std::size_t finite = expected.size();
  expected.erase(
    std::unique(expected.begin(), expected.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
    expected.end());
  assert(cloud.number_of_duplicates() == finite - expected.size());
  assert(cloud.size() == expected.size() && cloud.positions().size() == expected.size());
  std::vector<std::pair<Point_3, std::size_t> > actual;
  for (Point_index i = 0; i != cloud.size(); ++i) {
    actual.emplace_back(cloud.point(i), cloud.input_index(i));
    assert(&cloud.positions()[i] == &cloud.position(i));
  }
  std::sort(actual.begin(), actual.end());
  assert(actual == expected);
}

void test_empty_and_tiny()
{
  assert(cloud_of({}).size() == 0);
  assert(cloud_of({}).positions().empty());
  const Cloud one = cloud_of({ Point_3(1e300, -7, 0) });
  assert(one.size() == 1 && one.input_index(0) == 0 && one.point(0) == Point_3(1e300, -7, 0));
  assert(std::isfinite(one.position(0).x()) && one.local_length(3.) == 3.);
  const Cloud same = cloud_of(std::vector<Point_3>(50, Point_3(1, 2, 3)));
  assert(same.size() == 1 && same.number_of_duplicates() == 49 && same.input_index(0) == 0);
}

void test_non_finite_points()
{
  std::vector<Point_3> points = random_points(200, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  points[0] = Point_3(nan, 0, 0);
  points[17] = Point_3(0, INFINITE, 0);
  points[18] = Point_3(0, 0, -INFINITE);
  points[199] = Point_3(nan, nan, nan);
  const Cloud cloud = cloud_of(points);
  assert(cloud.number_of_non_finite_points() == 4 && cloud.size() == 196);
  check(points, cloud);
  assert(cloud_of({ Point_3(nan, 0, 0) }).size() == 0);
}

void test_duplicates()
{
  Random random(2);
  std::vector<Point_3> points = random_points(300, 2);
  for (int i = 0; i != 2000; ++i)
    points.push_back(points[random.below(300)]);
  random.shuffle(points);
  const Cloud cloud = cloud_of(points);
  assert(cloud.size() == 300 && cloud.number_of_duplicates() == 2000);
  check(points, cloud);

  const Cloud zeros = cloud_of({ Point_3(1, 1, 1), Point_3(0., -0., 0.), Point_3(-0., 0., -0.), Point_3(0, 0, 0) });
  assert(zeros.size() == 2 && zeros.number_of_duplicates() == 2);
  assert((std::min)(zeros.input_index(0), zeros.input_index(1)) == 0 &&
         zeros.input_index(0) + zeros.input_index(1) == 1);
}

// Coordinates near 1e6 that differ by 1e-3 keep all their differences.
void test_far_from_origin()
{
  Random random(3);
  std::vector<Point_3> points;
  for (int i = 0; i != 400; ++i) {
    const double x = 1e6 + 1e-3 * double(random.below(40)), y = -1e6 + 1e-3 * double(random.below(40)),
                 z = 1e6 - 1e-3 * double(random.below(40));
    points.emplace_back(x, y, z);
  }
  const Cloud cloud = cloud_of(points);
  check(points, cloud);
  assert(longest_side(cloud) >= 1. && longest_side(cloud) < 2.);
  for (Point_index i = 0; i != cloud.size(); ++i) {
    for (int a = 0; a != 3; ++a)
      assert(std::abs(cloud.position(i)[a]) < 2.);
    for (Point_index j = 0; j != cloud.size(); ++j)
      for (int a = 0; a != 3; ++a)
        assert(cloud.position(i)[a] - cloud.position(j)[a] ==
               cloud.local_length(cloud.point(i)[a] - cloud.point(j)[a]));
  }
}

// Differences of positions are exactly the differences of the points, also where a shift to the
// center would round.
void test_positions_are_exact()
{
  using Exact = CGAL::Exact_rational;
  for (double offset : { 0., .1, .3, 1., 5., 1000. }) {
    Random random(4);
    std::vector<Point_3> points;
    for (int i = 0; i != 60; ++i) {
      // all bits of the mantissa in use
      const double x = random(0, 1) / 3 + offset, y = random(1, 4) / 7, z = -random(1, 9) / 11;
      points.emplace_back(x, y, z * 1e-8);
    }
    const Cloud cloud = cloud_of(points);
    const Exact unit(cloud.local_length(1.));
    for (Point_index i = 0; i != cloud.size(); ++i)
      for (Point_index j = 0; j != i; ++j)
        for (int a = 0; a != 3; ++a)
          assert(Exact(cloud.position(i)[a]) - Exact(cloud.position(j)[a]) ==
                 (Exact(cloud.point(i)[a]) - Exact(cloud.point(j)[a])) * unit);
  }
}

void test_denormal_coordinates()
{
  const double tiny = std::numeric_limits<double>::denorm_min();
  std::vector<Point_3> points;
  for (int i = 0; i != 1000; ++i)
    points.emplace_back(i * tiny, (i * 7 % 1000) * tiny, 0.);
  const Cloud cloud = cloud_of(points);
  check(points, cloud);
  assert(cloud.size() == 1000);
  assert(longest_side(cloud) >= .5 && longest_side(cloud) < 2.);
  for (Point_index i = 0; i != cloud.size(); ++i)
    for (Point_index j = 0; j != i; ++j)
      assert(cloud.position(i) != cloud.position(j));
}

void test_huge_coordinates()
{
  std::vector<Point_3> points = random_points(500, 5);
  for (Point_3& p : points)
    p = Point_3(1e308 * p.x(), 1e308 * p.y(), 1e308 * p.z());
  points.emplace_back(1e308, 1e308, 1e308);
  points.emplace_back(-1e308, -1e308, -1e308);
  points.emplace_back((std::numeric_limits<double>::max)(), -(std::numeric_limits<double>::max)(), 0);
  const Cloud cloud = cloud_of(points);
  check(points, cloud);
  assert(longest_side(cloud) >= 1. && longest_side(cloud) < 2.);
  for (const Local_point& p : cloud.positions())
    for (int a = 0; a != 3; ++a)
      assert(std::abs(p[a]) <= 2.);
}

std::vector<Point_3> sequence(const Cloud& cloud)
{
  std::vector<Point_3> result;
  for (Point_index i = 0; i != cloud.size(); ++i)
    result.push_back(cloud.point(i));
  return result;
}

// Duplicates, a grid, a dense cluster and a far outlier: the order is that of the positions alone.
void test_permutation()
{
  std::vector<Point_3> points = random_points(1000, 6);
  points.insert(points.end(), points.begin(), points.begin() + 100);
  for (const Local_point& p : square_grid(12))
    points.emplace_back(p.x(), p.y(), p.z());
  for (const Point_3& p : random_points(200, 7))
    points.emplace_back(.5 + 1e-12 * p.x(), 1e-12 * p.y(), 1e-12 * p.z());
  points.emplace_back(1e9, 0, 0);
  const Cloud cloud = cloud_of(points);
  Random random(8);
  for (int i = 0; i != 5; ++i) {
    random.shuffle(points);
    const Cloud shuffled = cloud_of(points);
    check(points, shuffled);
    assert(sequence(shuffled) == sequence(cloud));
    assert(shuffled.positions() == cloud.positions());
  }
}

void test_power_of_two()
{
  const std::vector<Point_3> points = random_points(1000, 9);
  const Cloud cloud = cloud_of(points);
  for (int exponent : { -900, -20, -1, 1, 3, 60, 1000 }) {
    std::vector<Point_3> scaled;
    for (const Point_3& p : points)
      scaled.emplace_back(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent));
    const Cloud result = cloud_of(scaled);
    assert(result.positions() == cloud.positions());
    for (Point_index i = 0; i != cloud.size(); ++i)
      assert(result.input_index(i) == cloud.input_index(i));
    assert(result.local_length(std::ldexp(1., exponent)) == cloud.local_length(1.));
  }
}

// Of points that only an exact kernel tells apart, the lexicographically smallest one is kept.
void test_exact_kernel()
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Point = Exact::Point_3;
  const Exact::FT third = Exact::FT(1) / Exact::FT(3), tiny = Exact::FT(1e-30);
  std::vector<Point> points;
  for (int i = 0; i != 60; ++i)
    points.emplace_back(third + Exact::FT((i + 7) % 30) * tiny, third, Exact::FT(0));
  points.emplace_back(2, 0, 0);
  const auto cloud = cloud_of<Exact>(points);
  assert(cloud.size() == 2 && cloud.number_of_duplicates() == 59);
  assert(cloud.input_index(0) == 23);
  assert(cloud.point(1) == Point(2, 0, 0));
}

// A double cannot hold the extent of the points and the size of the speck at the same time.
void test_points_that_coincide_in_double()
{
  std::vector<Point_3> points = { Point_3(1e200, 0, 0) };
  for (int i = 0; i != 100; ++i)
    points.emplace_back(std::ldexp(1., -900 - i), 0, 0);
  const Cloud cloud = cloud_of(points);
  assert(cloud.size() == 2 && cloud.number_of_duplicates() == 99);
}

// Points of two places that scaling makes equal, in an order by x that goes back and forth between them.
void test_points_that_coincide_after_scaling()
{
  std::vector<Point_3> points = { Point_3(1e300, 0, 0), Point_3(0, 1e300, 0) };
  for (int i = 0; i != 20; ++i) // not more than an octree leaf holds, or the curve tells the places apart
    points.emplace_back(i * 1e-320, i % 2 == 0 ? 0. : 1e20, i % 3 * 1e-310);
  const Cloud cloud = cloud_of(points);
  assert(cloud.size() == 4 && cloud.number_of_duplicates() == 18);
  std::reverse(points.begin(), points.end());
  const Cloud reversed = cloud_of(points);
  assert(reversed.size() == 4 && reversed.number_of_duplicates() == 18);
  for (Point_index i = 0; i != cloud.size(); ++i)
    assert(reversed.point(i) == cloud.point(i));
}

void test_other_ranges_and_kernels()
{
  using Single = CGAL::Simple_cartesian<float>;
  const auto cloud = cloud_of<Single>({ Single::Point_3(1, 2, 3), Single::Point_3(2, 2, 3), Single::Point_3(1, 2, 3) });
  assert(cloud.size() == 2 && cloud.number_of_duplicates() == 1);

  using Named_point = std::pair<int, Point_3>;
  const std::list<Named_point> points = { { 5, Point_3(0, 0, 0) }, { 6, Point_3(1, 0, 0) } };
  const Cloud mapped(points, CGAL::Second_of_pair_property_map<Named_point>(), Kernel());
  assert(mapped.size() == 2 && mapped.point(1) == Point_3(1, 0, 0));
}

int main()
{
  test_empty_and_tiny();
  test_non_finite_points();
  test_duplicates();
  test_far_from_origin();
  test_positions_are_exact();
  test_denormal_coordinates();
  test_huge_coordinates();
  test_permutation();
  test_power_of_two();
  test_exact_kernel();
  test_points_that_coincide_in_double();
  test_points_that_coincide_after_scaling();
  test_other_ranges_and_kernels();
  std::cout << "done" << std::endl;
  return 0;
}

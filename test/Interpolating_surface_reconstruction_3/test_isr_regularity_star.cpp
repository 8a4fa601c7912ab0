#include "isr_stage_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/Regularity_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Box_neighborhoods.h>

#include <iostream>
#include <set>

using namespace isr_stage_test;
using ISR::Regularity_star_3;
using ISR::internal::Box_neighborhoods;

ISR::Point_star star_of(std::vector<Local_vector> offsets)
{
  std::sort(offsets.begin(), offsets.end(),
            [](const Local_vector& u, const Local_vector& v) { return u.squared_length() < v.squared_length(); });
  ISR::Point_star star;
  star.link.assign(7, 5); // left from another point
  assert(Regularity_star_3()(ISR::Star_neighborhood(offsets.data(), offsets.size(), 0.), star));
  for (std::uint32_t i : star.link)
    assert(i == GAP || i < offsets.size());
  return star;
}

// What every star has to fulfil: no neighbor twice, one gap at most, a unit normal, and turning
// counterclockwise about it.
void check(const Stars& stars)
{
  for (std::size_t p = 0; p != stars.links.size(); ++p) {
    const std::vector<Point_index>& link = stars.links[p];
    const std::set<Point_index> distinct(link.begin(), link.end());
    assert(distinct.size() == link.size());
    assert(link.size() != 1);
    assert(link.size() != 2);
    assert(distinct.count(Point_index(p)) == 0);
    assert(std::abs(stars.normals[p].squared_length() - 1.) < 1e-9);
  }
}

// A star of all points around an inner point of the lattice, an open one at the boundary.
void test_hexagonal_patch()
{
  const std::size_t m = 20;
  const Indexed_points indexed(hexagonal_patch(m));
  const Stars stars = construct_stars<Box_neighborhoods>(indexed, Regularity_star_3());
  check(stars);
  const double edge = 1. / double(m);
  std::size_t inner = 0;
  for (std::size_t p = 0; p != indexed.points.size(); ++p) {
    std::set<Point_index> expected;
    for (std::size_t q = 0; q != indexed.points.size(); ++q)
      if (q != p && CGAL::squared_distance(indexed.points[p], indexed.points[q]) < 1.01 * edge * edge)
        expected.insert(Point_index(q));
    // a zigzag boundary has dents, whose points with five neighbors may close their stars
    if (expected.size() == 6) {
      ++inner;
      assert(stars.is_closed(p));
      assert(std::set<Point_index>(stars.links[p].begin(), stars.links[p].end()) == expected);
    } else if (expected.size() < 5) {
      assert(std::count(stars.links[p].begin(), stars.links[p].end(), GAP) == 1);
    }
    // open or not, the star goes all the way around
    for (Point_index q : expected)
      assert(std::count(stars.links[p].begin(), stars.links[p].end(), q) == 1);
    assert(std::abs(std::abs(stars.normals[p] * tilted_plane_normal()) - 1.) < 1e-9);
    assert(is_counterclockwise(indexed, stars, p));
  }
  assert(inner == (m - 2) * (m - 2));
}

void test_random_patch()
{
  const Indexed_points indexed(random_patch(2000, 1));
  const Stars stars = construct_stars<Box_neighborhoods>(indexed, Regularity_star_3());
  check(stars);
  assert(stars.agreed_share() > .6);
  std::size_t counterclockwise = 0;
  for (std::size_t p = 0; p != indexed.points.size(); ++p)
    counterclockwise += is_counterclockwise(indexed, stars, p) ? 1u : 0u;
  assert(counterclockwise == indexed.points.size());
}

void test_sphere()
{
  const Indexed_points indexed(sphere(3000, .005, 2));
  const Stars stars = construct_stars<Box_neighborhoods>(indexed, Regularity_star_3());
  check(stars);
  assert(stars.agreed_share() > .9);
  for (std::size_t p = 0; p != indexed.points.size(); ++p) {
    assert(stars.is_closed(p));
    assert(std::abs(stars.normals[p] * (indexed.points[p] - CGAL::ORIGIN)) > .95);
    assert(is_counterclockwise(indexed, stars, p));
  }
}

// Points without structure: whatever comes out is a star.
void test_random_box()
{
  const Indexed_points indexed(random_box(2000, 3));
  check(construct_stars<Box_neighborhoods>(indexed, Regularity_star_3()));
}

// Two parallel sheets one and a half spacings apart do not mix.
void test_two_sheets()
{
  std::vector<Local_point> points = hexagonal_patch(16);
  const std::size_t n = points.size();
  for (std::size_t i = 0; i != n; ++i)
    points.push_back(points[i] + tilted_plane_normal() * (1.5 / 16));
  const Indexed_points indexed(points);
  const Stars stars = construct_stars<Box_neighborhoods>(indexed, Regularity_star_3());
  const auto height = [&](std::size_t i) { return (indexed.points[i] - CGAL::ORIGIN) * tilted_plane_normal(); };
  std::size_t inner = 0; // at the rims the sheets may be joined
  for (std::size_t p = 0; p != indexed.points.size(); ++p) {
    const std::vector<Point_index>& link = stars.links[p];
    inner += stars.is_closed(p) && link.size() == 6 &&
                 std::all_of(link.begin(), link.end(),
                             [&](Point_index q) { return std::abs(height(p) - height(q)) < .1 / 16; })
               ? 1u
               : 0u;
  }
  assert(inner >= 2 * 14 * 14);
}

void test_few_neighbors()
{
  assert(star_of({}).link.empty());
  assert(star_of({ Local_vector(1, 0, 0) }).link.empty());
  assert(star_of({ Local_vector(0, 0, 0), Local_vector(0, 0, 0) }).link.empty());
  // collinear
  assert(star_of({ Local_vector(1, 0, 0), Local_vector(-1.5, 0, 0), Local_vector(2, 0, 0) }).link.empty());
  for (const Local_vector& n : { star_of({}).normal, star_of({ Local_vector(1, 0, 0), Local_vector(2, 0, 0) }).normal })
    assert(n.squared_length() == 1.);
  // one triangle
  const ISR::Point_star triangle = star_of({ Local_vector(1, 0, 0), Local_vector(0, 1.1, 0) });
  assert(triangle.link.size() == 3);
  assert(std::abs(triangle.normal.z()) == 1.);
  // three triangles around the center
  const ISR::Point_star closed =
    star_of({ Local_vector(1, 0, 0), Local_vector(-.5, .9, 0), Local_vector(-.5, -.95, 0) });
  assert((std::set<std::uint32_t>(closed.link.begin(), closed.link.end()) == std::set<std::uint32_t>{ 0, 1, 2 }));
}

// Points that coincide with the center in double coordinates are passed over.
void test_coincident_neighbor()
{
  std::vector<Local_vector> offsets(3, Local_vector(0, 0, 0));
  for (int i = 0; i != 6; ++i)
    offsets.emplace_back(std::cos(i * std::acos(.5)), std::sin(i * std::acos(.5)), 0.);
  const ISR::Point_star star = star_of(offsets);
  assert((std::set<std::uint32_t>(star.link.begin(), star.link.end()) == std::set<std::uint32_t>{ 3, 4, 5, 6, 7, 8 }));
}

// The tip of a pyramid: its four neighbors, not the point below.
void test_pyramid()
{
  const ISR::Point_star star =
    star_of({ Local_vector(1, 0, -.6), Local_vector(0, 1.01, -.6), Local_vector(-1.02, 0, -.6),
              Local_vector(0, -1.03, -.6), Local_vector(0, 0, -2) });
  assert((std::set<std::uint32_t>(star.link.begin(), star.link.end()) == std::set<std::uint32_t>{ 0, 1, 2, 3 }));
  assert(std::abs(star.normal.z()) > .99);
}

int main()
{
  test_hexagonal_patch();
  test_random_patch();
  test_sphere();
  test_random_box();
  test_two_sheets();
  test_few_neighbors();
  test_coincident_neighbor();
  test_pyramid();
  std::cout << "done" << std::endl;
  return 0;
}

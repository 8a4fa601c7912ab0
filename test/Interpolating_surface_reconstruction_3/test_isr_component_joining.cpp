#include "isr_surface_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Component_contacts.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Component_joining.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

using namespace isr_test;
using isr_internal::Cell_complex;
using isr_internal::Component_contacts;
using isr_internal::Component_joining;
using isr_internal::Kept_triangulation;
using isr_internal::Point_octree_3;

namespace {

// Two closed cylinders on one axis, of circles of n points, with or without smaller circles on their ends.
Points cylinders(std::size_t n, double height, double gap, bool has_inner_points)
{
  Points points;
  for (double low : { 0., height + gap }) {
    for (const Point& p : wall(n, height).points)
      points.push_back(p + Vector(0, 0, low));
    for (double z : { low, low + height })
      for (std::size_t i = 0; has_inner_points && i != n; ++i)
        points.push_back(on_circle(2. * PI * (double(i) + .5) / double(n), .5, z));
  }
  return points;
}

// The surfaces of the two halves of the points: of the cells with all vertices in one of them.
Triples surfaces_of_halves(const Hand_surface& s)
{
  return surface_of_labels(s, [&](const Cell_complex::Cell& c) {
    if (Cell_complex::is_infinite(c))
      return 0;
    const auto in_first = std::count_if(c.vertices.begin(), c.vertices.end(),
                                        [&](Point_index p) { return 2 * s.cloud.input_index(p) < s.cloud.size(); });
    return in_first == 4 ? 1 : in_first == 0 ? 2 : 0;
  });
}

std::size_t number_of_components(const Hand_surface& s, const Triples& triples)
{
  return Component_contacts(s.cloud.positions(), triangles_of(s, triples)).size();
}

bool join_components(Hand_surface& s)
{
  const Point_octree_3 octree(s.cloud.positions());
  Kept_triangulation triangulation(s.cloud.positions());
  return Component_joining<CGAL::Sequential_tag, Hand_surface::Builder>(s.cloud.positions(), octree, s.builder,
                                                                        triangulation)(no_progress);
}

// Whether the cylinders become one component.
bool are_joined(double height, double gap, bool has_inner_points)
{
  const Points points = cylinders(9, height, gap, has_inner_points);
  Hand_surface s(points);
  const Triples before = surfaces_of_halves(s);
  ISR_CHECK(s.add(before));
  ISR_CHECK_EQUAL(number_of_components(s, before), 2u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(before), 4);
  const bool is_changed = join_components(s);
  const Triples after = s.triangles();
  ISR_CHECK(validation::is_oriented_manifold(points, after, Kernel()));
  ISR_CHECK(validation::boundary_edges(after).empty());
  ISR_CHECK_EQUAL(validation::used_points(after).size(), points.size());
  const std::size_t components = number_of_components(s, after);
  ISR_CHECK_EQUAL(is_changed, components == 1);
  ISR_CHECK_EQUAL(validation::euler_characteristic(after), 2 * int(components));
  ISR_CHECK(!join_components(s)); // nothing is left to do
  return components == 1;
}

void test_cylinders()
{
  begin_case("nearer than their points");
  ISR_CHECK(are_joined(.7, .5, false));
  begin_case("with ends that have points");
  ISR_CHECK(!are_joined(.7, .3, true));
  begin_case("farther than their points");
  ISR_CHECK(!are_joined(.7, 2.5, false));
}

void test_contacts()
{
  begin_case("contacts");
  Mesh mesh = globe(7, 9);
  append(mesh, globe(5, 7, Point(1.6, 0, 0), .5));
  append(mesh, globe(5, 7, Point(9, 0, 0), .5));
  mesh.points.emplace_back(20, 0, 0);
  const Hand_surface s(mesh.points);
  Component_contacts contacts(s.cloud.positions(), triangles_of(s, mesh.triples));
  ISR_CHECK_EQUAL(contacts.size(), 3u);
  ISR_CHECK(!contacts.is_on_surface(s.indices.back()));
  isr_internal::No_cancellation never;
  contacts.find(Point_octree_3(s.cloud.positions()), never);
  const std::size_t of_two = globe(7, 9).points.size() + globe(5, 7).points.size();
  ISR_CHECK_EQUAL(contacts.groups().size(), 1u);
  ISR_CHECK_EQUAL(contacts.groups().front().size(), of_two);
  for (Point_index p : contacts.near())
    ISR_CHECK(s.cloud.input_index(p) < of_two);
  ISR_CHECK(!contacts.near().empty());
}

} // namespace

int main()
{
  test_contacts();
  test_cylinders();
  return result();
}

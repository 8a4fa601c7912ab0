#include "isr_surface_test_utils.h"
#include "isr_test_self_intersections.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Crossing_test.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Sites_around_doubts.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Surface_sides.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/crossing_removal.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_crossings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_exchange.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_rings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_intersection.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

using namespace isr_test;
using isr_internal::Cell_complex;
using isr_internal::Crossing_removal;
using isr_internal::Kept_triangulation;
using isr_internal::Surface_crossings;
using isr_internal::Surface_sides;
using Builder = Hand_surface::Builder;

namespace {

// Whether triangles (0, 1, 2) and (a, b, c) of these points cross.
bool do_cross(const Points& points, const Triple& t)
{
  const bool result = isr_internal::do_triangles_cross(Triple{ 0, 1, 2 }, t, [&](std::size_t v) { return points[v]; });
  for (const Triple& turned : { Triple{ t[1], t[2], t[0] }, Triple{ t[2], t[0], t[1] } })
    ISR_CHECK_EQUAL(
      isr_internal::do_triangles_cross(turned, Triple{ 1, 2, 0 }, [&](std::size_t v) { return points[v]; }), result);
  return result;
}

void test_triangles()
{
  begin_case("two triangles");
  const Points base{ Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0) };
  const auto with = [&](const Points& more) {
    Points points = base;
    append(points, more);
    return points;
  };
  // No common vertex: through it, above it, and touching it with a corner, which counts.
  ISR_CHECK(do_cross(with({ Point(1, 1, -1), Point(1, 1, 1), Point(5, 5, 0) }), Triple{ 3, 4, 5 }));
  ISR_CHECK(!do_cross(with({ Point(1, 1, 1), Point(1, 2, 1), Point(5, 5, 1) }), Triple{ 3, 4, 5 }));
  ISR_CHECK(do_cross(with({ Point(1, 1, 0), Point(1, 2, 1), Point(5, 5, 1) }), Triple{ 3, 4, 5 }));
  // A common vertex.
  ISR_CHECK(!do_cross(with({ Point(-1, 0, 0), Point(0, -1, 0) }), Triple{ 0, 3, 4 }));
  ISR_CHECK(!do_cross(with({ Point(1, 1, 1), Point(1, 2, 1) }), Triple{ 0, 3, 4 }));
  ISR_CHECK(do_cross(with({ Point(2, 1, -1), Point(1, 2, 1) }), Triple{ 0, 3, 4 }));
  ISR_CHECK(do_cross(with({ Point(2, 1, 0), Point(1, 2, 0) }), Triple{ 0, 3, 4 }));
  // A common edge: bent, flat, folded.
  for (const Triple& edge : { Triple{ 0, 1, 3 }, Triple{ 1, 0, 3 }, Triple{ 3, 1, 0 } }) {
    ISR_CHECK(!do_cross(with({ Point(1, 1, 1) }), edge));
    ISR_CHECK(!do_cross(with({ Point(1, -1, 0) }), edge));
    ISR_CHECK(do_cross(with({ Point(1, 1, 0) }), edge));
    // Folded up to less than a double can tell of a determinant.
    ISR_CHECK(!do_cross(with({ Point(1, 1, 1e-300) }), edge));
  }
}

// A globe without symmetries.
Mesh rough_globe(std::size_t rings, std::size_t n)
{
  Mesh mesh = globe(rings, n);
  mesh.points = with_noise(mesh.points, .01, 5);
  return mesh;
}

Triples sorted(Triples triples)
{
  for (Triple& t : triples)
    std::sort(t.begin(), t.end());
  std::sort(triples.begin(), triples.end());
  return triples;
}

// The triangles of a globe at whose south pole a hole is closed without the pole, which is attached to
// the triangle at the other end of the globe.
Triples with_spike(const Mesh& mesh, std::size_t n)
{
  Triples triples(mesh.triples.begin() + std::ptrdiff_t(n), mesh.triples.end());
  for (std::size_t i = 2; i != n; ++i)
    triples.push_back(Triple{ 1, i + 1, i });
  const Triple split = mesh.triples.back();
  triples.erase(std::find(triples.begin(), triples.end(), split));
  for (std::size_t i = 0; i != 3; ++i)
    triples.push_back(Triple{ split[i], split[(i + 1) % 3], 0 });
  return triples;
}

std::size_t crossings_of(const Hand_surface& s, std::size_t first)
{
  isr_internal::No_cancellation never;
  return Surface_crossings<Builder>(s.cloud.positions(), s.builder)(static_cast<Builder::Triangle_index>(first), never)
    .size();
}

// `unclosed` in the order of the input.
bool remove_crossings(Hand_surface& s, std::size_t first = 0, const std::vector<std::size_t>& unclosed = {})
{
  std::vector<Point_index> points;
  for (std::size_t p : unclosed)
    points.push_back(s.indices[p]);
  std::sort(points.begin(), points.end());
  const std::vector<isr_internal::Local_point>& positions = s.cloud.positions();
  const isr_internal::Point_octree_3 octree(positions);
  Kept_triangulation triangulation(positions);
  return Crossing_removal<CGAL::Sequential_tag, Builder>(positions, {}, octree, std::numeric_limits<double>::infinity(),
                                                         s.builder, triangulation)(
    static_cast<Builder::Triangle_index>(first), points, no_progress);
}

// Of a few triangles with a surface, near and far, flat and steep: the same as of all pairs.
void test_few_triangles()
{
  std::size_t crossing = 0, all = 0;
  for (std::uint64_t seed = 1; seed != 9; ++seed) {
    begin_case("few triangles, seed " + std::to_string(seed));
    Mesh mesh = globe(9, 14);
    const std::size_t n = mesh.points.size();
    append(mesh, globe(4, 5, Point(.2, .1, 0.), 8.));
    Random random(seed);
    const std::size_t first = mesh.points.size();
    for (std::size_t i = 0; i != 100; ++i) {
      const Point center = CGAL::ORIGIN + random.uniform(.8, 1.2) * random.unit();
      append(mesh.points, { center, center + .1 * random.unit(), center + .1 * random.unit() });
    }
    Hand_surface s(mesh.points, links_of(n, Triples(mesh.triples.begin(), mesh.triples.begin() + 200)));
    for (const Triple& t : mesh.triples)
      s.add(t[0], t[1], t[2]);
    const isr_internal::Point_octree_3 octree(s.cloud.positions());
    isr_internal::Crossing_test<Builder> crosses(s.cloud.positions(), octree, s.builder);
    for (std::size_t i = 0; i != 200; ++i) {
      Builder::Triangle t;
      for (std::size_t k = 0; k != 3; ++k)
        t[k] = s.indices[i % 2 == 0 ? first + 3 * (i / 2) + k : random.below(mesh.points.size())];
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
        continue;
      bool expected = false;
      s.builder.for_each_triangle([&](const Builder::Triangle& u, auto) {
        expected = expected || isr_internal::do_triangles_cross(t, u, [&](Point_index p) {
                     return isr_internal::exact_point(s.cloud.positions()[p]);
                   });
      });
      ISR_CHECK_EQUAL(crosses(std::vector<Builder::Triangle>{ t }, [](auto) { return true; }), expected);
      ISR_CHECK(!crosses(std::vector<Builder::Triangle>{ t }, [](auto) { return false; }));
      crossing += expected ? 1u : 0u;
      ++all;
      // A triangle that is attached is found from now on.
      if (!expected && s.builder.try_add(t[0], t[1], t[2]) == Triangle_verdict::ADDED) {
        crosses.attach(t);
        ISR_CHECK(crosses(std::vector<Builder::Triangle>{ t }, [](auto) { return true; }));
      }
    }
  }
  ISR_CHECK(crossing > all / 8);
  ISR_CHECK(all - crossing > all / 8);
}

// A triangle on a line, as predicates that are not exact attach it, crosses nothing.
void test_degenerate_triangle()
{
  begin_case("degenerate triangle");
  const Points points{ Point(0, 0, 0),    Point(1, 0, 0),   Point(2, 0, 0),
                       Point(.5, -1, -1), Point(.5, 1, -1), Point(.5, 0, 1) };
  Hand_surface s(points);
  ISR_CHECK(s.add(0, 1, 3) == Triangle_verdict::ADDED);
  auto removed = s.builder.remove(0);
  removed.vertices = Builder::Triangle{ { s.indices[0], s.indices[1], s.indices[2] } };
  s.builder.restore(removed);
  const isr_internal::Point_octree_3 octree(s.cloud.positions());
  isr_internal::Crossing_test<Builder> crosses(s.cloud.positions(), octree, s.builder);
  const std::vector<Builder::Triangle> through{ Builder::Triangle{ { s.indices[3], s.indices[4], s.indices[5] } } };
  ISR_CHECK(!crosses(through, [](auto) { return true; }));
  ISR_CHECK_EQUAL(crosses.take_pairs(), 1u);
}

void test_spike()
{
  begin_case("spike");
  constexpr std::size_t N = 9;
  const Mesh mesh = rough_globe(7, N);
  Hand_surface s(mesh.points);
  ISR_CHECK(s.add(with_spike(mesh, N)));
  ISR_CHECK(has_self_intersection(mesh.points, s.triangles()));
  ISR_CHECK(crossings_of(s, 0) != 0);
  // The spike has been attached last.
  const std::size_t all = s.builder.number_of_stored_triangles();
  ISR_CHECK(crossings_of(s, all - 3) != 0);
  ISR_CHECK_EQUAL(crossings_of(s, all), 0u);
  isr_internal::No_cancellation never;
  std::size_t at_tip = 0, elsewhere = 0;
  const auto is_at_tip = [&](const Builder::Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](Point_index p) { return s.cloud.input_index(p) == 0; });
  };
  Surface_crossings<Builder>(s.cloud.positions(), s.builder)
    .for_each(
      0, is_at_tip, [&](const Builder::Triangle& t, auto) { ++(is_at_tip(t) ? at_tip : elsewhere); }, never);
  ISR_CHECK(at_tip != 0);
  ISR_CHECK_EQUAL(elsewhere, 0u);
  ISR_CHECK(!remove_crossings(s, all));
  ISR_CHECK(remove_crossings(s, all - 3));
  const Triples triples = s.triangles();
  ISR_CHECK(!has_self_intersection(mesh.points, triples));
  ISR_CHECK(validation::is_oriented_manifold(mesh.points, triples, Kernel()));
  ISR_CHECK(validation::boundary_edges(triples).empty());
  ISR_CHECK_EQUAL(validation::euler_characteristic(triples), 2);
  ISR_CHECK_EQUAL(validation::used_points(triples).size(), mesh.points.size());
  // Nothing is left to do.
  ISR_CHECK(!remove_crossings(s));
}

void test_two_components()
{
  begin_case("components that cross");
  Mesh mesh = rough_globe(7, 9);
  append(mesh, globe(5, 7, Point(1.1, .1, .05), .5));
  Hand_surface s(mesh.points);
  ISR_CHECK(s.add(mesh.triples));
  ISR_CHECK(has_self_intersection(mesh.points, s.triangles()));
  ISR_CHECK(remove_crossings(s));
  const Triples triples = s.triangles();
  ISR_CHECK(!has_self_intersection(mesh.points, triples));
  ISR_CHECK(validation::is_oriented_manifold(mesh.points, triples, Kernel()));
  ISR_CHECK(validation::boundary_edges(triples).empty());
}

// Five points next to a globe with the surface of two tetrahedra, which may cross each other: new labels of their cells
// may have no inside. Then the points are left to the globe, but only if they are in one star with its points.
void test_island()
{
  const Mesh mesh = rough_globe(7, 9);
  const std::size_t n = mesh.points.size();
  std::size_t vanished = 0, changed = 0;
  for (std::uint64_t seed = 1; seed != 100; ++seed)
    for (const bool is_among_others : { true, false }) {
      begin_case("island, seed " + std::to_string(seed) + (is_among_others ? "" : ", that no other points are near"));
      Points points = mesh.points;
      Links links = links_of(n, mesh.triples);
      Random random(seed);
      for (std::size_t i = 0; i != 5; ++i) {
        points.push_back(Point(1.2, 0., 0.) + .1 * random.uniform(.5, 1.) * random.unit());
        const auto next = [&](std::size_t k) { return Point_index(is_among_others ? 20 + k : n + (i + k) % 5); };
        links.push_back(Link{ next(1), next(2), next(3) });
      }
      Hand_surface s(points, links);
      Triples island;
      for (std::size_t i = 0; i != 3; ++i) {
        island.push_back(Triple{ n + i, n + (i + 1) % 3, n + 3 });
        island.push_back(Triple{ n + (i + 1) % 3, n + i, n + 4 });
      }
      if (!s.add(island) || crossings_of(s, 0) == 0)
        continue;
      const bool is_changed = remove_crossings(s);
      const std::size_t left = s.triangles().size() - mesh.triples.size();
      ISR_CHECK_EQUAL(crossings_of(s, 0) == 0, is_changed);
      ISR_CHECK(is_changed || !is_among_others);
      ISR_CHECK(left == island.size() || (left == 0 && is_among_others));
      vanished += left == 0 ? 1u : 0u;
      changed += is_changed && left != 0 ? 1u : 0u;
    }
  ISR_CHECK(vanished != 0);
  ISR_CHECK(changed != 0);
}

// A surface for another one with a triangle too many.
void test_exchange()
{
  begin_case("exchange of triangles");
  const Mesh mesh = rough_globe(7, 9);
  Hand_surface s(mesh.points);
  ISR_CHECK(s.add(mesh.triples));
  std::vector<Point_index> points;
  for (Point_index p = 0; p != mesh.points.size(); ++p)
    points.push_back(p);
  std::vector<Builder::Triangle> added;
  s.builder.for_each_triangle([&](const Builder::Triangle& t, auto) { added.push_back(t); });
  added.push_back(Builder::Triangle{ { s.indices[20], s.indices[21], s.indices[40] } });
  isr_internal::No_cancellation never;
  ISR_CHECK(isr_internal::exchange_triangles(s.builder, points, added, never).empty());
  ISR_CHECK(sorted(s.triangles()) == sorted(mesh.triples));
  ISR_CHECK_EQUAL(isr_internal::exchange_triangles(s.builder, points, added, never, 1).size(), mesh.triples.size());
  // One of those that share an edge is left out.
  ISR_CHECK_EQUAL(s.triangles().size(), mesh.triples.size());
  ISR_CHECK(validation::is_oriented_manifold(mesh.points, s.triangles(), Kernel()));
}

// What is right stays as it is, and so do components with a boundary.
void test_left_alone()
{
  begin_case("nothing crosses");
  Mesh mesh = rough_globe(7, 9);
  append(mesh, globe(5, 7, Point(3, 0, 0), .5));
  Hand_surface s(mesh.points);
  ISR_CHECK(s.add(mesh.triples));
  ISR_CHECK(!remove_crossings(s));
  ISR_CHECK(sorted(s.triangles()) == sorted(mesh.triples));

  begin_case("component with a boundary");
  constexpr std::size_t N = 9;
  const Mesh open = rough_globe(7, N);
  Triples triples = with_spike(open, N);
  triples.erase(triples.begin() + 20);
  Hand_surface t(open.points);
  ISR_CHECK(t.add(triples));
  ISR_CHECK(crossings_of(t, 0) != 0);
  ISR_CHECK(!remove_crossings(t));
  ISR_CHECK(sorted(t.triangles()) == sorted(triples));
}

// Holes of four edges in a globe.
void test_unclosed_loops()
{
  const Mesh mesh = rough_globe(7, 9);
  const Triples holes[] = { { mesh.triples[27], mesh.triples[28] }, { mesh.triples[63], mesh.triples[64] } };
  std::vector<std::size_t> corners[2];
  for (int i = 0; i != 2; ++i) {
    for (const Triple& t : holes[i])
      corners[i].insert(corners[i].end(), t.begin(), t.end());
    std::sort(corners[i].begin(), corners[i].end());
    corners[i].erase(std::unique(corners[i].begin(), corners[i].end()), corners[i].end());
    ISR_CHECK_EQUAL(corners[i].size(), 4u);
  }
  const auto remove_triangles = [&](Hand_surface& s, int i) {
    for (const Triple& t : holes[i])
      s.remove(t[0], t[1], t[2]);
  };
  const Links links = links_of(mesh.points.size(), mesh.triples);

  begin_case("loop to be closed");
  Hand_surface s(mesh.points, links);
  remove_triangles(s, 0);
  ISR_CHECK_EQUAL(validation::boundary_edges(s.triangles()).size(), 4u);
  ISR_CHECK(!remove_crossings(s));
  ISR_CHECK(remove_crossings(s, 0, corners[0]));
  const Triples triples = s.triangles();
  ISR_CHECK(!has_self_intersection(mesh.points, triples));
  ISR_CHECK(validation::is_oriented_manifold(mesh.points, triples, Kernel()));
  ISR_CHECK(validation::boundary_edges(triples).empty());
  ISR_CHECK_EQUAL(validation::euler_characteristic(triples), 2);
  ISR_CHECK_EQUAL(validation::used_points(triples).size(), mesh.points.size());

  begin_case("loop to be closed beside one that stays");
  Hand_surface t(mesh.points, links);
  remove_triangles(t, 0);
  remove_triangles(t, 1);
  const Triples before = t.triangles();
  ISR_CHECK(!remove_crossings(t, 0, corners[0]));
  ISR_CHECK(sorted(t.triangles()) == sorted(before));
}

std::vector<isr_internal::Local_point> local_points(const Points& points)
{
  std::vector<isr_internal::Local_point> result;
  for (const Point& p : points)
    result.emplace_back(p.x(), p.y(), p.z());
  return result;
}

Cell_complex cells_of(const std::vector<isr_internal::Local_point>& points)
{
  std::vector<Point_index> sites;
  for (std::size_t p = 0; p != points.size(); ++p)
    sites.push_back(static_cast<Point_index>(p));
  return Cell_complex(points, sites);
}

// The convex hull, facing outward.
std::vector<Surface_sides::Triangle> hull_triangles(const Points& points)
{
  const Cell_complex cells = cells_of(local_points(points));
  std::vector<Surface_sides::Triangle> result;
  for (Cell_complex::Cell_index c = 0; c != cells.size(); ++c)
    for (std::size_t i = 0; i != 4; ++i)
      if (cells[c].vertices[i] == NO_POINT) {
        Surface_sides::Triangle f = Cell_complex::facet(cells[c], i);
        if (i % 2 == 0)
          std::swap(f[0], f[1]);
        result.push_back(f);
      }
  return result;
}

// The convex hull of a sphere, but that a point is attached to a triangle at the other end of it.
Triples sphere_with_spike(const Points& points)
{
  Triples triples;
  std::map<std::size_t, std::size_t> next; // around the point
  std::optional<Triple> split;
  for (Surface_sides::Triangle t : hull_triangles(points)) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    if (t[0] == 0)
      next[t[1]] = t[2];
    else if (!split && std::count(t.begin(), t.end(), points.size() - 1) != 0)
      split = Triple{ t[0], t[1], t[2] };
    else
      triples.push_back(Triple{ t[0], t[1], t[2] });
  }
  const std::size_t first = next.begin()->first;
  for (std::size_t p = next[first]; next[p] != first; p = next[p])
    triples.push_back(Triple{ first, p, next[p] });
  for (std::size_t i = 0; i != 3; ++i)
    triples.push_back(Triple{ (*split)[i], (*split)[(i + 1) % 3], 0 });
  return triples;
}

// Of a large component, only the surface around the crossings is made anew.
void test_large_component()
{
  begin_case("large component");
  const Points points = sphere_fibonacci(36000).points;
  const Triples before = sphere_with_spike(points);
  Hand_surface s(points);
  ISR_CHECK(s.add(before));
  ISR_CHECK(crossings_of(s, 0) != 0);
  ISR_CHECK(remove_crossings(s));
  ISR_CHECK_EQUAL(crossings_of(s, 0), 0u);
  const Triples triples = s.triangles();
  ISR_CHECK(validation::is_oriented_manifold(points, triples, Kernel()));
  ISR_CHECK(validation::boundary_edges(triples).empty());
  ISR_CHECK_EQUAL(validation::euler_characteristic(triples), 2);
  ISR_CHECK_EQUAL(validation::used_points(triples).size(), points.size());
  const Triples sorted_before = sorted(before), sorted_after = sorted(triples);
  Triples kept;
  std::set_intersection(sorted_before.begin(), sorted_before.end(), sorted_after.begin(), sorted_after.end(),
                        std::back_inserter(kept));
  // The spike, the lid, and a diagonal or two are not Delaunay.
  ISR_CHECK(kept.size() + 20 > before.size());
}

// Around one doubt in a component of 4000 points, few of them are sites, all of 100, and all of 6 even without a doubt.
void test_sites()
{
  for (std::size_t n : { 6u, 100u, 4000u }) {
    begin_case("sites around a doubt, of " + std::to_string(n));
    const Points points = sphere_fibonacci(n).points;
    Hand_surface s(points);
    for (const Surface_sides::Triangle& t : hull_triangles(points))
      ISR_CHECK(s.add(t[0], t[1], t[2]) == Triangle_verdict::ADDED);
    const isr_internal::Point_octree_3 octree(s.cloud.positions());
    isr_internal::Sites_around_doubts<Builder> find_sites(s.cloud.positions(), octree,
                                                          std::numeric_limits<double>::infinity(), s.builder);
    isr_internal::No_cancellation never;
    std::vector<unsigned char> is_in_doubt(n, 0);
    is_in_doubt[n / 3] = n == 6 ? 0 : 1;
    std::vector<Point_index> all(n);
    std::iota(all.begin(), all.end(), Point_index(0));
    find_sites.find(all, is_in_doubt, never);
    const std::vector<Point_index>&sites = find_sites.sites(), &incomplete = find_sites.incomplete();
    if (n != 4000) {
      ISR_CHECK(sites == all);
      ISR_CHECK(incomplete.empty());
      continue;
    }
    ISR_CHECK(sites.size() > n / 8 && sites.size() < n / 2);
    ISR_CHECK(std::is_sorted(sites.begin(), sites.end()));
    ISR_CHECK(std::includes(sites.begin(), sites.end(), incomplete.begin(), incomplete.end()));
    const std::vector<unsigned char> is_near =
      isr_internal::mark_rings(s.builder, std::vector<Point_index>{ Point_index(n / 3) }, 4, never);
    for (Point_index p : all)
      ISR_CHECK(is_near[p] == 0 || std::binary_search(sites.begin(), sites.end(), p));
    for (Point_index p : sites) {
      bool is_complete = true;
      s.builder.for_each_triangle_at(p, [&](const Builder::Triangle& t) {
        for (Point_index q : t)
          is_complete = is_complete && std::binary_search(sites.begin(), sites.end(), q);
      });
      ISR_CHECK(is_complete || std::binary_search(incomplete.begin(), incomplete.end(), p));
    }
  }
}

// An ellipsoid with a hollow of the same shape.
void test_sides()
{
  begin_case("sides");
  Points points = globe(9, 12).points;
  for (Point& p : points)
    p = Point(p.x(), 1.1 * p.y(), 1.3 * p.z());
  const std::size_t outer = points.size();
  std::vector<Surface_sides::Triangle> triangles = hull_triangles(points);
  for (std::size_t t = 0, n = triangles.size(); t != n; ++t) {
    const auto inner = [&](std::size_t i) { return static_cast<Point_index>(outer + triangles[t][i]); };
    triangles.push_back({ { inner(0), inner(2), inner(1) } });
  }
  append(points, scaled(points, .3));
  const std::vector<isr_internal::Local_point> positions = local_points(points);
  const Cell_complex cells = cells_of(positions);
  isr_internal::No_cancellation never;
  std::vector<unsigned char> is_in_doubt(points.size(), 0);
  std::vector<Point_index> doubtful(triangles.front().begin(), triangles.front().end());
  for (Point_index p : doubtful)
    is_in_doubt[p] = 1;
  const Surface_sides sides(cells, triangles, is_in_doubt, never);
  // All triangles are facets.
  ISR_CHECK_EQUAL(std::count(is_in_doubt.begin(), is_in_doubt.end(), 1), 3);
  std::size_t unknown = 0;
  for (Cell_complex::Cell_index c = 0; c != cells.size(); ++c) {
    const auto& v = cells[c].vertices;
    const bool is_in_hollow = std::all_of(v.begin(), v.end(), [&](Point_index p) { return p >= outer; });
    // A cell of one doubtful point has a facet without any.
    const bool is_unknown =
      std::count_if(v.begin(), v.end(), [&](Point_index p) { return p != NO_POINT && is_in_doubt[p] != 0; }) > 1;
    const Surface_sides::Side expected = is_unknown ? Surface_sides::Side::UNKNOWN
                                         : is_in_hollow || Cell_complex::is_infinite(cells[c])
                                           ? Surface_sides::Side::OUTSIDE
                                           : Surface_sides::Side::INSIDE;
    ISR_CHECK(sides[c] == expected);
    unknown += is_unknown ? 1u : 0u;
  }
  ISR_CHECK(unknown != 0);

  begin_case("sides of other triangles");
  triangles.push_back({ { 3, 40, 80 } });
  const Surface_sides with_other(cells, triangles, is_in_doubt, never);
  doubtful.insert(doubtful.end(), { 3, 40, 80 });
  for (Point_index p : doubtful)
    ISR_CHECK_EQUAL(int(is_in_doubt[p]), 1);
  ISR_CHECK_EQUAL(std::count(is_in_doubt.begin(), is_in_doubt.end(), 1), 6);
  for (std::size_t t = 0; t != with_other.triangles().size(); ++t)
    ISR_CHECK_EQUAL(with_other.is_facet(t), with_other.triangles()[t] != (Surface_sides::Triangle{ { 3, 40, 80 } }));
}

bool are_equal(const Cell_complex& a, const Cell_complex& b)
{
  bool result = a.size() == b.size() && a.points() == b.points();
  for (std::size_t c = 0; result && c != a.size(); ++c)
    result = a[c].vertices == b[c].vertices && a[c].neighbors == b[c].neighbors;
  return result;
}

// The cells of cospherical points must not depend on what was triangulated before, either.
void test_kept_triangulation()
{
  begin_case("kept triangulation");
  constexpr std::size_t N = 5;
  Points points;
  for (std::size_t k = 0; k != N * N * N; ++k)
    points.emplace_back(double(k % N), double(k / N % N), double(k / N / N));
  const std::vector<isr_internal::Local_point> positions = local_points(points);
  isr_internal::No_cancellation never;
  Kept_triangulation triangulation(positions);
  const auto check = [&](const auto& is_wanted) {
    std::vector<Point_index> wanted;
    for (Point_index p = 0; p != positions.size(); ++p)
      if (is_wanted(p))
        wanted.push_back(p);
    const auto cells = triangulation(wanted, never);
    ISR_CHECK(are_equal(*cells, Cell_complex(positions, wanted, never)));
    return cells->size() != 0;
  };
  ISR_CHECK(check([](Point_index p) { return p % 3 != 0; }));
  ISR_CHECK(check([](Point_index p) { return p % 3 != 0 || p % 2 == 0; })); // grows
  ISR_CHECK(check([](Point_index p) { return p % 5 == 0 || p % 7 == 0; })); // fewer
  ISR_CHECK(check([](Point_index p) { return p % 3 != 0 || p % 2 == 0; })); // the same
  ISR_CHECK(check([](Point_index p) { return p % 11 != 0; }));              // more, but not those
  ISR_CHECK(!check([](Point_index p) { return p < Point_index(N * N); }));  // in a plane
  ISR_CHECK(check([](Point_index) { return true; }));
}

} // namespace

int main()
{
  test_triangles();
  test_few_triangles();
  test_degenerate_triangle();
  test_spike();
  test_two_components();
  test_island();
  test_exchange();
  test_left_alone();
  test_unclosed_loops();
  test_large_component();
  test_sites();
  test_sides();
  test_kept_triangulation();
  return result();
}

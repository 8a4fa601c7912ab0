#include "isr_surface_test_utils.h"
#include "isr_test_self_intersections.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Face_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_loops.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/hole_closing.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/hole_filler.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/island_removal.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/point_insertion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

using namespace isr_test;
using isr_internal::Boundary_loop;
using isr_internal::Boundary_loops;
using isr_internal::Hole_closing;
using isr_internal::Hole_filler;
using isr_internal::Island_removal;
using isr_internal::Point_insertion;
using isr_internal::Point_octree_3;
using Builder = Hand_surface::Builder;

namespace {

constexpr std::size_t UNLIMITED = (std::numeric_limits<std::size_t>::max)();

const auto ignore_verdict = [](const Builder::Triangle&, Triangle_verdict) {};
const auto no_boundary = [](const Boundary_loop&) { return false; };

bool fill(Hand_surface& s, const std::vector<std::size_t>& loop)
{
  Boundary_loop indices;
  for (std::size_t p : loop)
    indices.push_back(s.indices[p]);
  return Hole_filler<Builder>(s.cloud.positions(), s.builder)(indices, ignore_verdict);
}

bool close(Hand_surface& s, std::size_t maximum_size = UNLIMITED)
{
  return Hole_closing<Builder>(s.cloud.positions(), s.builder, maximum_size)(no_boundary, no_progress, ignore_verdict);
}

// In the order of the input.
template <typename IsBoundary>
std::vector<std::size_t> points_of_failed_loops(Hand_surface& s, std::size_t maximum_size,
                                                const IsBoundary& is_boundary)
{
  const Hole_closing<Builder> close(s.cloud.positions(), s.builder, maximum_size);
  std::vector<std::size_t> result;
  for (Point_index p : close.find_open_loops(is_boundary, no_progress).points_of_failed)
    result.push_back(s.cloud.input_index(p));
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Boundary_loop> loops_of(const Hand_surface& s)
{
  return Boundary_loops<Builder>(s.cloud.positions(), s.builder)();
}

bool is_manifold(Hand_surface& s, const Points& points)
{
  return validation::is_oriented_manifold(points, s.triangles(), Kernel());
}

// For surfaces in the plane z = 0: twice the area if all triangles face the same way, else 0.
double double_area_of_flat(const Points& points, const Triples& triples)
{
  double sum = 0., absolute = 0.;
  for (const Triple& t : triples) {
    const double z = CGAL::cross_product(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]).z();
    sum += z;
    absolute += std::abs(z);
  }
  return std::abs(sum) == absolute ? absolute : 0.;
}

bool is_edge(const Triples& triples, std::size_t p, std::size_t q)
{
  return std::any_of(triples.begin(), triples.end(), [&](const Triple& t) {
    return std::count(t.begin(), t.end(), p) + std::count(t.begin(), t.end(), q) == 2;
  });
}

// A hole in a flat sheet, of `size` edges, without points inside.
template <typename IsHole>
void test_flat_hole(const char* name, std::size_t size, const IsHole& is_hole)
{
  begin_case(name);
  const std::size_t m = 9;
  const Mesh mesh = sheet(m, is_hole);
  Hand_surface s(mesh.points);
  ISR_CHECK(s.add(mesh.triples));
  const std::vector<Boundary_loop> loops = loops_of(s);
  ISR_CHECK_EQUAL(loops.size(), 2u);
  ISR_CHECK_EQUAL(loops[0].size(), size);
  ISR_CHECK(Hole_filler<Builder>(s.cloud.positions(), s.builder)(loops[0], ignore_verdict));
  const Triples filled = s.triangles();
  ISR_CHECK_EQUAL(filled.size(), mesh.triples.size() + size - 2);
  ISR_CHECK(is_manifold(s, mesh.points));
  ISR_CHECK_EQUAL(double_area_of_flat(mesh.points, filled), double(2 * m * m));
  ISR_CHECK_EQUAL(validation::boundary_edges(filled).size(), 4 * m);
}

void test_flat_holes()
{
  test_flat_hole("square", 4, [](std::size_t i, std::size_t j) { return i == 4 && j == 4; });
  test_flat_hole("L", 8, [](std::size_t i, std::size_t j) {
    return (i == 4 && j == 4) || (i == 5 && j == 4) || (i == 4 && j == 5);
  });
  test_flat_hole("U", 12,
                 [](std::size_t i, std::size_t j) { return i >= 3 && i <= 5 && (j == 3 || (j == 4 && i != 4)); });
  test_flat_hole("T", 14,
                 [](std::size_t i, std::size_t j) { return (j == 4 && i >= 2 && i <= 6) || (i == 4 && j == 3); });
  test_flat_hole("bar", 16, [](std::size_t i, std::size_t j) { return j == 4 && i >= 1 && i <= 7; });
}

// A filling is planar if it goes on like the surface around it.
void test_planar_filling()
{
  begin_case("planar filling");
  const Mesh flat = sheet(5, [](std::size_t i, std::size_t j) { return i == 2 && j == 2; });
  Hand_surface s(flat.points);
  ISR_CHECK(s.add(flat.triples));
  ISR_CHECK(Hole_filler<Builder>(s.cloud.positions(), s.builder).fill_if_planar(loops_of(s)[0], ignore_verdict));
  ISR_CHECK_EQUAL(s.triangles().size(), 50u);

  const Mesh pipe = wall(4, 3.);
  Hand_surface t(pipe.points);
  ISR_CHECK(t.add(pipe.triples));
  ISR_CHECK(!Hole_filler<Builder>(t.cloud.positions(), t.builder).fill_if_planar(loops_of(t)[0], ignore_verdict));
  ISR_CHECK_EQUAL(t.triangles().size(), 8u);
  ISR_CHECK(Hole_filler<Builder>(t.cloud.positions(), t.builder)(loops_of(t)[0], ignore_verdict));
  ISR_CHECK_EQUAL(t.triangles().size(), 10u);
}

// The boundary of two triangles: the filling must not use their common edge again.
void test_used_chord()
{
  begin_case("a chord that exists elsewhere");
  const Points bent = { Point(0, 0, 0), Point(1, 0, .3), Point(1, 1, 0), Point(0, 1, .3) };
  for (std::size_t first : { 0u, 1u }) {
    Hand_surface s(bent);
    ISR_CHECK(s.add({ { first, first + 1, first + 2 }, { first, first + 2, (first + 3) % 4 } }));
    ISR_CHECK(fill(s, { 0, 1, 2, 3 }));
    ISR_CHECK_EQUAL(s.triangles().size(), 4u);
    ISR_CHECK(is_edge(s.triangles(), 0, 2) && is_edge(s.triangles(), 1, 3));
    ISR_CHECK(is_manifold(s, bent) && loops_of(s).empty());
  }
  const Points flat = { Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0) };
  Hand_surface s(flat);
  ISR_CHECK(s.add({ { 0, 1, 2 }, { 0, 2, 3 } }));
  ISR_CHECK(!fill(s, { 0, 1, 2, 3 }));
  ISR_CHECK_EQUAL(s.triangles().size(), 2u);
}

// A hole in a sheet, and triangles that stand on both its chords.
void test_used_chords()
{
  begin_case("all chords exist elsewhere");
  const Mesh mesh = sheet(5, [](std::size_t i, std::size_t j) { return i == 2 && j == 2; });
  const std::size_t a = 2 * 6 + 2, b = a + 6, c = b + 1, d = a + 1; // around the hole
  Points points = mesh.points;
  points.emplace_back(2.25, 2.5, 3.);
  points.emplace_back(2.75, 2.5, -3.);
  Hand_surface s(points);
  ISR_CHECK(s.add(mesh.triples));
  ISR_CHECK(s.add({ { a, c, 36 }, { b, d, 37 } }));
  const Triples before = s.triangles();
  ISR_CHECK(!fill(s, { a, b, c, d }));
  ISR_CHECK(s.triangles() == before);
  ISR_CHECK((points_of_failed_loops(s, 12, no_boundary) == std::vector<std::size_t>{ a, d, b, c, 36, 37 }));
  ISR_CHECK(close(s, 12)); // the triangles in the way go; the outline of the sheet has 20 edges
  ISR_CHECK(points_of_failed_loops(s, 12, no_boundary).empty());
  ISR_CHECK(is_manifold(s, points));
  ISR_CHECK_EQUAL(loops_of(s).size(), 1u);
  ISR_CHECK_EQUAL(s.triangles().size(), 50u);
}

void test_no_loops()
{
  begin_case("what cannot be filled");
  const Mesh mesh = sheet(2);
  Hand_surface s(mesh.points);
  ISR_CHECK(s.add(mesh.triples));
  ISR_CHECK(!fill(s, { 0, 1 }));
  ISR_CHECK(!fill(s, {}));
  ISR_CHECK(!fill(s, { 0, 1, 2 })); // collinear
  ISR_CHECK(canonical(s.triangles()) == canonical(mesh.triples));
}

// Longer than what is triangulated in the best way.
void test_long_loop()
{
  begin_case("long loops");
  const std::size_t n = 300;
  const Mesh mesh = wall(n, .02);
  Hand_surface s(mesh.points);
  ISR_CHECK(s.add(mesh.triples));
  ISR_CHECK_EQUAL(loops_of(s).size(), 2u);
  close(s);
  ISR_CHECK(loops_of(s).empty());
  ISR_CHECK_EQUAL(s.triangles().size(), 2 * n + 2 * (n - 2));
  ISR_CHECK(is_manifold(s, mesh.points));
  ISR_CHECK_EQUAL(validation::euler_characteristic(s.triangles()), 2);
}

// A ring of a wall at each of the radii, between z = 0 and 1.
Mesh walls(std::size_t n, const std::vector<double>& radii)
{
  Mesh mesh;
  for (double radius : radii) {
    Mesh next = wall(n, 1.);
    for (Point& p : next.points)
      p = Point(radius * p.x(), radius * p.y(), p.z());
    append(mesh, next);
  }
  return mesh;
}

// Adds a triangle of a cap that faces down at the lower end (0) of a wall, up at the upper one (1).
void add_to_cap(Mesh& mesh, std::size_t end, const Triple& t)
{
  mesh.triples.push_back(end == 0 ? Triple{ t[0], t[2], t[1] } : t);
}

// Loops in one plane and inside of each other are the edges of faces with holes.
void test_faces_with_holes()
{
  begin_case("faces of a pipe");
  const std::size_t n = 12;
  const Mesh pipe = walls(n, { 1., .5 });
  Hand_surface s(pipe.points);
  ISR_CHECK(s.add(pipe.triples));
  ISR_CHECK(close(s));
  ISR_CHECK(is_manifold(s, pipe.points));
  ISR_CHECK_EQUAL(s.triangles().size(), 8 * n);
  ISR_CHECK_EQUAL(validation::number_of_components(s.triangles()), 1u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(s.triangles()), 0);

  begin_case("a rod in a pipe");
  const Mesh rod = walls(n, { 1., .5, .25 });
  Hand_surface t(rod.points);
  ISR_CHECK(t.add(rod.triples));
  ISR_CHECK(close(t));
  ISR_CHECK(is_manifold(t, rod.points));
  ISR_CHECK_EQUAL(validation::number_of_components(t.triangles()), 2u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(t.triangles()), 2);

  begin_case("two holes in a disk");
  Mesh disk = walls(n, { 1. });
  for (double x : { -.5, .5 }) {
    Mesh hole = walls(n, { .25 });
    for (Point& p : hole.points)
      p = p + Vector(x, 0., 0.);
    append(disk, hole);
  }
  Hand_surface u(disk.points);
  ISR_CHECK(u.add(disk.triples));
  ISR_CHECK(close(u));
  ISR_CHECK(is_manifold(u, disk.points));
  ISR_CHECK_EQUAL(validation::number_of_components(u.triangles()), 1u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(u.triangles()), -2);

  // The wall of the hole has been closed by caps before.
  begin_case("a plug in a pipe");
  Mesh plug = walls(n, { 1., .5 });
  for (std::size_t end : { 0u, 1u })
    for (std::size_t i = 1; i + 1 != n; ++i)
      add_to_cap(plug, end, Triple{ 2 * n + end, 2 * n + 2 * i + end, 2 * n + 2 * (i + 1) + end });
  Hand_surface w(plug.points);
  ISR_CHECK(w.add(plug.triples));
  ISR_CHECK_EQUAL(loops_of(w).size(), 2u);
  ISR_CHECK(close(w));
  ISR_CHECK(is_manifold(w, plug.points));
  ISR_CHECK_EQUAL(w.triangles().size(), 8 * n);
  ISR_CHECK_EQUAL(validation::number_of_components(w.triangles()), 1u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(w.triangles()), 0);

  // A cap with a point of its own is no cap: what the loop is closed by lies on it.
  begin_case("a rod with a center in a pipe");
  Mesh core = walls(n, { 1., .5 });
  for (std::size_t end : { 0u, 1u }) {
    core.points.push_back(Point(0., 0., double(end)));
    for (std::size_t i = 0; i != n; ++i)
      add_to_cap(core, end, Triple{ 4 * n + end, 2 * n + 2 * i + end, 2 * n + 2 * ((i + 1) % n) + end });
  }
  Hand_surface x(core.points);
  ISR_CHECK(x.add(core.triples));
  ISR_CHECK(close(x));
  ISR_CHECK_EQUAL(x.triangles().size(), 4 * n + 2 * n + 2 * (n - 2));
  ISR_CHECK_EQUAL(validation::number_of_components(x.triangles()), 2u);

  begin_case("a lower pipe");
  Mesh step = walls(n, { 1. });
  append(step, walls(n, { .5 }));
  for (std::size_t i = 2 * n; i != 4 * n; ++i)
    step.points[i] = step.points[i] + Vector(0., 0., .2);
  Hand_surface v(step.points);
  ISR_CHECK(v.add(step.triples));
  ISR_CHECK(close(v));
  ISR_CHECK_EQUAL(validation::number_of_components(v.triangles()), 2u);
  ISR_CHECK_EQUAL(validation::euler_characteristic(v.triangles()), 4);
}

// Rims bound a face, but not where they cross, even if two points that coincide in the plane make up for the vertex that
// this adds to their triangulation.
void test_crossing_rims()
{
  begin_case("crossing rims");
  using isr_internal::Local_point;
  const std::vector<Local_point> points{ Local_point(0, 0, 0),  Local_point(4, 4, 0),  Local_point(4, 0, 0),
                                         Local_point(0, 4, 0),  Local_point(10, 0, 0), Local_point(12, 0, 0),
                                         Local_point(12, 2, 0), Local_point(12, 2, 1) };
  const isr_internal::Face_plane plane{ points[0], points[2], isr_internal::Local_vector(0, 0, 1), 16., 4. };
  const isr_internal::Face_triangulation triangulate(points);
  isr_internal::No_cancellation no_cancellation;
  const auto number_of_triangles = [&](const std::vector<Boundary_loop>& loops) {
    return triangulate(plane, loops, {}, no_cancellation).triangles.size();
  };
  ISR_CHECK_EQUAL(number_of_triangles({ { 0, 2, 1, 3 } }), std::size_t(2));
  ISR_CHECK_EQUAL(number_of_triangles({ { 0, 2, 1, 3 }, { 4, 5, 6 } }), std::size_t(3));
  ISR_CHECK_EQUAL(number_of_triangles({ { 0, 1, 2, 3 } }), std::size_t(0));
  ISR_CHECK_EQUAL(number_of_triangles({ { 4, 5, 6, 7 } }), std::size_t(0));
  ISR_CHECK_EQUAL(number_of_triangles({ { 0, 1, 2, 3 }, { 4, 5, 6, 7 } }), std::size_t(0));
}

// All that could close a flat sheet would lie on it.
void test_flat_sheet()
{
  begin_case("flat sheet");
  const Mesh mesh = sheet(24);
  Hand_surface s(mesh.points);
  ISR_CHECK(s.add(mesh.triples));
  ISR_CHECK(!Hole_filler<Builder>(s.cloud.positions(), s.builder)(loops_of(s)[0], ignore_verdict));
  ISR_CHECK(canonical(s.triangles()) == canonical(mesh.triples));
  ISR_CHECK(!close(s));
  ISR_CHECK(canonical(s.triangles()) == canonical(mesh.triples));
  // The stars that end along the outline tell that it is one.
  Hand_surface t(mesh.points, links_of(mesh.points.size(), mesh.triples));
  ISR_CHECK(close(t));
  ISR_CHECK(canonical(t.triangles()) == canonical(mesh.triples));
}

// Hills and valleys, or one hill; stars end along the outline, which lies in a plane.
template <typename IsHole>
Mesh hills(bool has_valleys, const IsHole& is_hole)
{
  constexpr std::size_t M = 24;
  Mesh mesh = sheet(M, is_hole);
  for (Point& p : mesh.points) {
    const double k = (has_valleys ? 4. : 1.) * PI / double(M);
    p = Point(p.x(), p.y(), 4. * std::sin(k * p.x()) * std::sin(k * p.y()));
  }
  return mesh;
}

Mesh hills(bool has_valleys)
{
  return hills(has_valleys, [](std::size_t, std::size_t) { return false; });
}

// A flat lid closes the outline, but goes through the surface where it passes from hills to valleys.
void test_crossing_lid()
{
  begin_case("a lid that crosses the surface");
  const Mesh valleys = hills(true);
  Hand_surface s(valleys.points, links_of(valleys.points.size(), valleys.triples));
  const std::size_t size = loops_of(s)[0].size();
  Hole_closing<Builder> closing(s.cloud.positions(), s.builder, UNLIMITED);
  for (int time = 0; time != 2; ++time) {
    ISR_CHECK(closing(no_boundary, no_progress, ignore_verdict));
    ISR_CHECK(canonical(s.triangles()) == canonical(valleys.triples));
    ISR_CHECK_EQUAL(loops_of(s)[0].size(), size);
    ISR_CHECK(closing.find_open_loops(no_boundary, no_progress).points_of_failed.empty());
  }
  ISR_CHECK(closing.has_crossing_lids());
  closing.close_with_crossing_lids(no_progress, ignore_verdict);
  ISR_CHECK_EQUAL(s.triangles().size(), valleys.triples.size() + size - 2);

  begin_case("a lid that does not");
  const Mesh hill = hills(false);
  Hand_surface t(hill.points, links_of(hill.points.size(), hill.triples));
  ISR_CHECK(close(t));
  ISR_CHECK_EQUAL(t.triangles().size(), hill.triples.size() + size - 2);

  begin_case("a lid where many stars conflict");
  Mesh conflicts = valleys;
  append(conflicts.points, random_cube(valleys.points.size() / 8, 5));
  Hand_surface u(conflicts.points, links_of(conflicts.points.size(), conflicts.triples));
  ISR_CHECK(close(u));
  ISR_CHECK_EQUAL(u.triangles().size(), valleys.triples.size() + size - 2);
}

// Rings of points around the z axis, each connected to the next one, without symmetries. Each is a radius and a height.
Mesh rings(const std::vector<std::array<double, 2> >& profile)
{
  constexpr std::size_t N = 12;
  Mesh mesh;
  for (std::size_t i = 0; i != profile.size(); ++i)
    for (std::size_t j = 0; j != N; ++j) {
      const double angle = 2. * PI * (double(j) + .5 * double(i % 2)) / double(N);
      mesh.points.emplace_back(profile[i][0] * std::cos(angle), profile[i][0] * std::sin(angle), profile[i][1]);
    }
  for (std::size_t i = 0; i + 1 != profile.size(); ++i)
    for (std::size_t j = 0; j != N; ++j) {
      const std::size_t a = i * N + j, b = i * N + (j + 1) % N, c = a + N, d = b + N;
      mesh.triples.push_back(i % 2 == 0 ? Triple{ a, b, c } : Triple{ a, b, d });
      mesh.triples.push_back(i % 2 == 0 ? Triple{ b, d, c } : Triple{ a, d, c });
    }
  mesh.points = with_noise(mesh.points, .02, 7);
  return mesh;
}

// A lid that crosses the surface stays if a loop that is as long has a lid that does not.
void test_crossing_lid_of_closed_surface()
{
  // From its upper end, the surface leans inward and passes through it.
  begin_case("a lid that crosses, and one that does not");
  const Mesh funnel =
    rings({ { 2., 0. }, { 1.4, .7 }, { .8, .4 }, { .7, -.5 }, { 1.4, -1. }, { 3., -1.6 }, { 5., -3. } });
  Hand_surface s(funnel.points, links_of(funnel.points.size(), funnel.triples));
  ISR_CHECK(!has_self_intersection(funnel.points, s.triangles()));
  ISR_CHECK_EQUAL(loops_of(s).size(), 2u);
  Hole_closing<Builder> closing(s.cloud.positions(), s.builder, UNLIMITED);
  ISR_CHECK(closing(no_boundary, no_progress, ignore_verdict));
  ISR_CHECK(loops_of(s).empty());
  ISR_CHECK(!closing.has_crossing_lids());
  ISR_CHECK_EQUAL(validation::euler_characteristic(s.triangles()), 2);
  ISR_CHECK(has_self_intersection(funnel.points, s.triangles()));

  begin_case("a lid that crosses, and a shorter one that does not");
  const auto is_between = [](std::size_t i) { return 7 <= i && i < 10; };
  const Mesh valleys = hills(true, [&](std::size_t i, std::size_t j) { return is_between(i) && is_between(j); });
  Hand_surface u(valleys.points, links_of(valleys.points.size(), valleys.triples));
  ISR_CHECK_EQUAL(loops_of(u).size(), 2u);
  const std::size_t hole = loops_of(u)[0].size(), outline = loops_of(u)[1].size();
  ISR_CHECK(close(u));
  ISR_CHECK_EQUAL(loops_of(u).size(), 1u);
  ISR_CHECK_EQUAL(loops_of(u)[0].size(), outline);
  ISR_CHECK_EQUAL(u.triangles().size(), valleys.triples.size() + hole - 2);
}

// Loops that are left, but for those that are to stay.
void test_failed_loops()
{
  begin_case("failed loops");
  const std::size_t n = 7;
  const Mesh pipe = wall(n, 1.);
  Hand_surface s(pipe.points, links_of(pipe.points.size(), pipe.triples));
  ISR_CHECK_EQUAL(points_of_failed_loops(s, UNLIMITED, no_boundary).size(), 2 * n);
  ISR_CHECK_EQUAL(points_of_failed_loops(s, n, no_boundary).size(), 2 * n);
  ISR_CHECK(points_of_failed_loops(s, n - 1, no_boundary).empty());
  int loops = 0;
  const auto is_first = [&](const Boundary_loop&) { return loops++ == 0; };
  ISR_CHECK_EQUAL(points_of_failed_loops(s, UNLIMITED, is_first).size(), n);

  // The stars end along the outline, not along the hole.
  begin_case("failed loop of a flat sheet");
  const Mesh flat = sheet(9);
  Hand_surface t(flat.points, links_of(flat.points.size(), flat.triples));
  ISR_CHECK(points_of_failed_loops(t, UNLIMITED, no_boundary).empty());
  const Triple hole = flat.triples[flat.triples.size() / 2];
  t.remove(hole[0], hole[1], hole[2]);
  std::vector<std::size_t> corners(hole.begin(), hole.end());
  std::sort(corners.begin(), corners.end());
  ISR_CHECK(points_of_failed_loops(t, UNLIMITED, no_boundary) == corners);
}

// What holes have left of a sheet whose stars all agree: islands, but for the fan of a point that has kept its star.
void test_islands()
{
  begin_case("islands");
  const std::size_t m = 9, hub = 5 * (m + 1) + 5;
  const Mesh flat = sheet(m);
  Hand_surface s(flat.points, links_of(flat.points.size(), flat.triples));
  Triples fan;
  for (std::size_t i = 0; i != flat.triples.size(); ++i) {
    const Triple& t = flat.triples[i];
    if (std::count(t.begin(), t.end(), hub) != 0)
      fan.push_back(t);
    else if (i != 20) // apart from the fan
      s.remove(t[0], t[1], t[2]);
  }
  ISR_CHECK_EQUAL(s.triangles().size(), 7u);
  Island_removal<Builder> remove_islands(s.builder);
  remove_islands();
  ISR_CHECK(canonical(s.triangles()) == canonical(fan));
}

void test_maximum_size()
{
  begin_case("maximum size");
  // a globe without its south pole, whose loop has 7 edges, and without a quadrangle
  const Mesh mesh = globe(6, 7);
  Triples triples(mesh.triples.begin() + 7, mesh.triples.end());
  triples.erase(triples.begin() + 28, triples.begin() + 30);
  for (const std::size_t size :
       { std::size_t(0), std::size_t(3), std::size_t(4), std::size_t(6), std::size_t(7), UNLIMITED }) {
    Hand_surface s(mesh.points);
    ISR_CHECK(s.add(triples));
    ISR_CHECK_EQUAL(loops_of(s).size(), 2u);
    close(s, size);
    ISR_CHECK_EQUAL(loops_of(s).size(), size < 4 ? 2u : size < 7 ? 1u : 0u);
    ISR_CHECK(is_manifold(s, mesh.points));
    ISR_CHECK_EQUAL(s.triangles().size(), triples.size() + (size < 4 ? 0u : size < 7 ? 2u : 7u));
  }

  begin_case("boundaries stay open");
  Hand_surface s(mesh.points);
  ISR_CHECK(s.add(triples));
  Hole_closing<Builder>(s.cloud.positions(), s.builder, UNLIMITED)(
    [](const Boundary_loop& loop) { return loop.size() == 4; }, no_progress, ignore_verdict);
  const auto left = loops_of(s);
  ISR_CHECK(left.size() == 1 && left[0].size() == 4);
}

void test_largest_fans()
{
  begin_case("the largest fan stays");
  Mesh mesh = sheet(4);
  mesh.points.emplace_back(2, 2, 7);
  mesh.points.emplace_back(3, 3, 8);
  mesh.points.emplace_back(2, 4, 9);
  const Triples flat = mesh.triples;
  Hand_surface s(mesh.points);
  ISR_CHECK(s.add(flat));
  // at a side and at a corner
  ISR_CHECK(s.add({ { 2, 25, 26 }, { 0, 25, 27 } }));
  ISR_CHECK(!is_manifold(s, mesh.points));
  close(s, 0);
  ISR_CHECK(canonical(s.triangles()) == canonical(flat) || canonical(s.triangles()) == canonical(turned(flat)));

  // two triangles at a corner of one
  Mesh corner = sheet(4, [](std::size_t i, std::size_t j) { return i == 0 && j == 0; });
  corner.points = mesh.points;
  const Triples without_corner = corner.triples;
  Hand_surface t(corner.points);
  ISR_CHECK(t.add(without_corner));
  ISR_CHECK(t.add({ { 0, 6, 5 }, { 0, 25, 26 }, { 0, 26, 27 } }));
  close(t, 0);
  ISR_CHECK(is_manifold(t, corner.points));
  ISR_CHECK_EQUAL(t.triangles().size(), without_corner.size() + 2);
}

// Random holes in a globe, many of which touch: whatever it takes, the surface closes.
void test_many_holes()
{
  for (std::uint64_t seed = 1; seed != 7; ++seed) {
    begin_case("many holes, seed " + std::to_string(seed));
    Mesh mesh = globe(14, 20);
    mesh.points = with_noise(mesh.points, .02, seed);
    Random random(seed);
    Hand_surface s(mesh.points, links_of(mesh.points.size(), mesh.triples));
    Triples left = s.triangles();
    for (std::size_t i = 0; i != 30 * seed; ++i) {
      const std::size_t k = random.below(left.size());
      s.remove(left[k][0], left[k][1], left[k][2]);
      left.erase(left.begin() + std::ptrdiff_t(k));
    }
    close(s);
    ISR_CHECK(loops_of(s).empty());
    ISR_CHECK(is_manifold(s, mesh.points));
    ISR_CHECK(!s.triangles().empty());
  }
}

// ---- insertion of points -------------------------------------------------------------------------

// The number of points left over.
std::size_t insert_points(Hand_surface& s)
{
  const Point_octree_3 octree(s.cloud.positions());
  return Point_insertion<Builder>(s.cloud.positions(), octree, std::numeric_limits<double>::infinity(),
                                  s.builder)(no_progress);
}

// `more` triangles are expected; the link of the new point is returned.
std::vector<std::size_t> test_one_point(const char* name, const Point& point, std::size_t more)
{
  begin_case(name);
  const std::size_t m = 6;
  Mesh mesh = sheet(m);
  Links links = links_of(mesh.points.size(), mesh.triples);
  mesh.points.push_back(point);
  const std::size_t added = mesh.points.size() - 1;
  links.emplace_back();
  Hand_surface s(mesh.points, links);
  ISR_CHECK_EQUAL(insert_points(s), 0u);
  const Triples triples = s.triangles();
  ISR_CHECK_EQUAL(triples.size(), mesh.triples.size() + more);
  ISR_CHECK(is_manifold(s, mesh.points));
  ISR_CHECK_EQUAL(validation::number_of_boundary_loops(triples), 1u);
  ISR_CHECK_EQUAL(validation::used_points(triples).size(), mesh.points.size());
  std::set<std::size_t> link;
  for (const Triple& t : triples)
    if (std::count(t.begin(), t.end(), added) != 0)
      link.insert(t.begin(), t.end());
  link.erase(added);
  return std::vector<std::size_t>(link.begin(), link.end());
}

void test_insertion()
{
  using Indices = std::vector<std::size_t>;
  // the triangle (2, 3), (3, 3), (3, 4); point (x, y) of the sheet is 7 x + y
  ISR_CHECK((test_one_point("in a triangle", Point(2.7, 3.3, 0.), 2) == Indices{ 17, 24, 25 }));
  ISR_CHECK((test_one_point("above a triangle", Point(2.7, 3.3, .2), 2) == Indices{ 17, 24, 25 }));
  // shared by the triangles to (2, 4) and (3, 3)
  ISR_CHECK((test_one_point("on an edge", Point(2.5, 3.5, 0.), 2) == Indices{ 17, 18, 24, 25 }));
  ISR_CHECK((test_one_point("on the boundary", Point(3.5, 0., 0.), 1) == Indices{ 21, 28, 29 }));
  ISR_CHECK((test_one_point("beyond the boundary", Point(3.5, -.3, 0.), 1) == Indices{ 21, 28, 29 }));
  ISR_CHECK(test_one_point("far beyond a corner", Point(-30., -20., 0.), 1).size() == 3);
}

// The nearest triangle is that of test_insertion(), but a triangle between it and the point stands in the way.
void test_insertion_without_crossing()
{
  begin_case("crossing where it is nearest");
  Mesh mesh = sheet(6);
  const std::size_t first = mesh.points.size();
  append(mesh.points, { Point(2.6, 3.35, .01), Point(2.6, 3.35, .15), Point(2.65, 3.4, .15) });
  mesh.triples.push_back(Triple{ first, first + 1, first + 2 });
  Links links = links_of(mesh.points.size(), mesh.triples);
  mesh.points.emplace_back(2.95, 3.1, .2);
  links.emplace_back();
  Hand_surface s(mesh.points, links);
  ISR_CHECK_EQUAL(insert_points(s), 0u);
  const Triples triples = s.triangles();
  ISR_CHECK_EQUAL(triples.size(), mesh.triples.size() + 2);
  ISR_CHECK(is_manifold(s, mesh.points));
  ISR_CHECK(!has_self_intersection(mesh.points, triples));
}

void test_insertion_of_many()
{
  for (std::uint64_t seed : { 1u, 2u, 3u }) {
    begin_case("many points, seed " + std::to_string(seed));
    Mesh mesh = globe(9, 12);
    Links links = links_of(mesh.points.size(), mesh.triples);
    Random random(seed);
    for (std::size_t i = 0; i != 300; ++i)
      mesh.points.push_back(CGAL::ORIGIN + random.uniform(.97, 1.03) * random.unit());
    links.resize(mesh.points.size());
    Hand_surface s(mesh.points, links);
    ISR_CHECK_EQUAL(insert_points(s), 0u);
    const Triples triples = s.triangles();
    ISR_CHECK(is_manifold(s, mesh.points));
    ISR_CHECK_EQUAL(validation::used_points(triples).size(), mesh.points.size());
    ISR_CHECK_EQUAL(triples.size(), mesh.triples.size() + 2 * 300);
    ISR_CHECK_EQUAL(validation::euler_characteristic(triples), 2);
  }

  begin_case("points on the lines of a sheet");
  Mesh mesh = sheet(5);
  Links links = links_of(mesh.points.size(), mesh.triples);
  for (std::size_t i = 0; i != 5; ++i)
    for (std::size_t j = 0; j != 5; ++j)
      for (double x : { .25, .5, .75 })
        mesh.points.emplace_back(double(i) + x, double(j) + (j % 2 == 0 ? x : 0.), 0.);
  links.resize(mesh.points.size());
  Hand_surface s(mesh.points, links);
  ISR_CHECK_EQUAL(insert_points(s), 0u);
  ISR_CHECK(is_manifold(s, mesh.points));
  ISR_CHECK_EQUAL(validation::used_points(s.triangles()).size(), mesh.points.size());
  ISR_CHECK_EQUAL(validation::euler_characteristic(s.triangles()), 1);
  ISR_CHECK_EQUAL(double_area_of_flat(mesh.points, s.triangles()), 50.);
}

void test_no_surface_to_insert_into()
{
  begin_case("no surface to insert into");
  const Points points = random_cube(20, 3);
  Hand_surface s(points);
  ISR_CHECK_EQUAL(insert_points(s), 20u);
  ISR_CHECK(s.triangles().empty());
}

} // namespace

int main()
{
  test_flat_holes();
  test_planar_filling();
  test_used_chord();
  test_used_chords();
  test_no_loops();
  test_long_loop();
  test_faces_with_holes();
  test_crossing_rims();
  test_flat_sheet();
  test_crossing_lid();
  test_crossing_lid_of_closed_surface();
  test_failed_loops();
  test_islands();
  test_maximum_size();
  test_largest_fans();
  test_many_holes();
  test_insertion();
  test_insertion_without_crossing();
  test_insertion_of_many();
  test_no_surface_to_insert_into();
  return result();
}

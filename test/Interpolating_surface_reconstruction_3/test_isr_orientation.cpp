#include "isr_surface_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/orientation.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

using namespace isr_test;
using isr_internal::Local_vector;
using Builder = Hand_surface::Builder;
using Surface_orientation = isr_internal::Surface_orientation<Builder>;

namespace {

Triples oriented_triangles(Surface_orientation& orientation, const Hand_surface& s)
{
  Triples result;
  orientation.for_each_oriented_triangle([&](const Builder::Triangle& t) { result.push_back(s.input_triple(t)); });
  ISR_CHECK_EQUAL(orientation.number_of_triangles(), result.size());
  return result;
}

Triples facing_outward(Hand_surface& s)
{
  Surface_orientation orientation(s.cloud.positions(), s.builder);
  orientation.face_outward();
  return oriented_triangles(orientation, s);
}

// Both from stored triangles and from the stars, for both ways to give the surface.
void check_outward(const Mesh& outward)
{
  const Triples expected = canonical(outward.triples);
  for (const Triples& given : { outward.triples, turned(outward.triples) }) {
    Hand_surface stored(outward.points);
    ISR_CHECK(stored.add(given));
    ISR_CHECK(canonical(facing_outward(stored)) == expected);
    Hand_surface agreed(outward.points, links_of(outward.points.size(), given));
    ISR_CHECK(canonical(facing_outward(agreed)) == expected);
  }
}

Mesh tetrahedron(const Points& points)
{
  Mesh mesh{ points, { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } } };
  if (CGAL::orientation(points[0], points[1], points[2], points[3]) == CGAL::NEGATIVE)
    mesh.triples = turned(mesh.triples);
  return mesh;
}

Mesh unit_tetrahedron() { return tetrahedron({ Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1) }); }

Mesh moved(Mesh mesh, double scale, const Vector& by)
{
  mesh.points = translated(scaled(mesh.points, scale), by);
  return mesh;
}

void test_single_components()
{
  begin_case("tetrahedron");
  check_outward(unit_tetrahedron());
  begin_case("sphere");
  check_outward(globe(8, 12));
  begin_case("far from the origin");
  check_outward(moved(globe(8, 12), 1., Vector(1e6, -3e6, 2e6)));
}

void test_several_components()
{
  begin_case("nested components");
  Mesh nested = globe(8, 12);
  append(nested, globe(6, 9, Point(.1, 0, 0), .5));
  append(nested, globe(6, 9, Point(.1, .1, 0), .2));
  check_outward(nested);

  begin_case("one component inside out");
  Mesh mixed = nested;
  mixed.triples = turned(globe(8, 12).triples);
  mixed.triples.insert(mixed.triples.end(), nested.triples.begin() + std::ptrdiff_t(mixed.triples.size()),
                       nested.triples.end());
  Hand_surface s(mixed.points);
  ISR_CHECK(s.add(mixed.triples));
  ISR_CHECK(canonical(facing_outward(s)) == canonical(nested.triples));

  begin_case("a tiny component next to a large one");
  for (const double size : { 1e-3, 1e-6, 1e-9 }) {
    Mesh tiny = globe(8, 12);
    append(tiny, moved(unit_tetrahedron(), size, Vector(1.5, .25, .125)));
    check_outward(tiny);
  }

  begin_case("components far from each other");
  Mesh far = globe(8, 12);
  append(far, moved(unit_tetrahedron(), 1., Vector(1e6, 0, 0)));
  append(far, moved(globe(5, 6), 1., Vector(-1e6, 1e6, 1e6)));
  check_outward(far);
}

// Tetrahedra that are flat but for the rounding of their coordinates: doubles do not tell which way.
void test_nearly_flat()
{
  begin_case("nearly flat tetrahedra");
  Random random(7);
  std::size_t tested = 0;
  while (tested != 40) {
    Points points;
    const Vector u = random.unit(), v = random.unit();
    const Point origin(random.uniform(), random.uniform(), random.uniform());
    for (const auto& c :
         { std::make_pair(0., 0.), std::make_pair(1., .1), std::make_pair(.9, 1.2), std::make_pair(-.1, 1.) })
      points.push_back(origin + c.first * u + c.second * v);
    if (CGAL::coplanar(points[0], points[1], points[2], points[3]))
      continue;
    check_outward(tetrahedron(points));
    ++tested;
  }
}

// A surface without volume has no outside, and any one orientation will do.
void test_no_volume()
{
  begin_case("no volume");
  // the plane z = x + 2 y, in integers and far from the origin
  Mesh mesh = sheet(7);
  for (Point& p : mesh.points)
    p = Point(p.x() + 1000, p.y() - 500, p.x() + 2 * p.y());
  Hand_surface s(mesh.points);
  ISR_CHECK(s.add(mesh.triples));
  const Triples found = facing_outward(s);
  ISR_CHECK(canonical(found) == canonical(mesh.triples) || canonical(found) == canonical(turned(mesh.triples)));
  ISR_CHECK(validation::is_consistently_oriented(found));

  begin_case("no volume next to a component with volume");
  Mesh both = globe(6, 9, Point(1000, -500, 50));
  append(both, mesh);
  Hand_surface t(both.points);
  ISR_CHECK(t.add(turned(both.triples)));
  const Triples oriented = facing_outward(t);
  ISR_CHECK_EQUAL(oriented.size(), both.triples.size());
  ISR_CHECK(validation::is_consistently_oriented(oriented));
  const Triples expected = canonical(globe(6, 9).triples), all = canonical(oriented);
  ISR_CHECK(std::includes(all.begin(), all.end(), expected.begin(), expected.end()));

  begin_case("no surface");
  Hand_surface none(mesh.points);
  ISR_CHECK(facing_outward(none).empty());
}

Triples aligned(Hand_surface& s, const std::function<Vector(std::size_t)>& normal)
{
  Surface_orientation orientation(s.cloud.positions(), s.builder);
  orientation.align_with_normals([&](Point_index p) {
    const Vector n = normal(s.cloud.input_index(p));
    return Local_vector(n.x(), n.y(), n.z());
  });
  return oriented_triangles(orientation, s);
}

void test_normals()
{
  begin_case("normals");
  Mesh mesh = globe(8, 12);
  const std::size_t first = mesh.points.size(), first_triangles = mesh.triples.size();
  const Point center(5, 0, 0);
  append(mesh, globe(6, 9, center));
  const auto outward = [&](std::size_t p) {
    return p < first ? mesh.points[p] - CGAL::ORIGIN : mesh.points[p] - center;
  };
  const Triples expected = canonical(mesh.triples);
  Triples split = turned(mesh.triples);
  std::copy(mesh.triples.begin(), mesh.triples.begin() + std::ptrdiff_t(first_triangles), split.begin());
  for (const Triples& given : { mesh.triples, turned(mesh.triples), split }) {
    Hand_surface s(mesh.points);
    ISR_CHECK(s.add(given));
    ISR_CHECK(canonical(aligned(s, outward)) == expected);
    ISR_CHECK(canonical(aligned(s, [&](std::size_t p) { return -outward(p); })) == canonical(turned(mesh.triples)));
    // each component follows its own normals
    ISR_CHECK(canonical(aligned(s, [&](std::size_t p) { return p < first ? outward(p) : -outward(p); })) ==
              canonical(split));
    // and the majority of them
    ISR_CHECK(canonical(aligned(s, [&](std::size_t p) { return p % 4 == 0 ? -outward(p) : outward(p); })) == expected);
  }

  begin_case("normals of a sheet");
  const Mesh flat = sheet(4);
  for (const double z : { 1., -1. }) {
    Hand_surface s(flat.points);
    ISR_CHECK(s.add(flat.triples));
    for (const Triple& t : aligned(s, [&](std::size_t) { return Vector(.3, 0, z); }))
      ISR_CHECK(
        CGAL::cross_product(flat.points[t[1]] - flat.points[t[0]], flat.points[t[2]] - flat.points[t[0]]).z() * z > 0.);
  }
}

} // namespace

int main()
{
  test_single_components();
  test_several_components();
  test_nearly_flat();
  test_no_volume();
  test_normals();
  return result();
}

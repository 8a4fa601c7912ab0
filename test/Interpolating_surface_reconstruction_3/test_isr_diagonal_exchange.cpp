#include "isr_surface_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Diagonal_exchange.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

using namespace isr_test;
using isr_internal::Diagonal_exchange;
using isr_internal::Point_octree_3;

namespace {

Triples exchange_diagonals(Hand_surface& s)
{
  const Point_octree_3 octree(s.cloud.positions());
  Diagonal_exchange<Hand_surface::Builder>(s.cloud.positions(), octree, s.builder)(no_progress);
  ISR_CHECK(validation::is_edge_manifold(s.triangles()) && validation::is_vertex_manifold(s.triangles()));
  ISR_CHECK(validation::is_consistently_oriented(s.triangles()));
  return s.triangles();
}

bool has_edge(const Triples& triples, std::size_t p, std::size_t q)
{
  return std::any_of(triples.begin(), triples.end(), [&](const Triple& t) {
    return std::count(t.begin(), t.end(), p) + std::count(t.begin(), t.end(), q) == 2;
  });
}

// Points 1 and 3, which are nearer to each other than 0 and 2, are at the given height.
Points rhombus(double height)
{
  return { Point(0, 0, 0), Point(2, .8, height), Point(4, 0, 0), Point(2, -.8, height) };
}

const Triples along_02{ { 0, 1, 2 }, { 0, 2, 3 } };

void test_shorter_diagonal()
{
  begin_case("in a plane");
  Hand_surface flat(rhombus(0.));
  ISR_CHECK(flat.add(along_02));
  ISR_CHECK(has_edge(exchange_diagonals(flat), 1, 3));
  begin_case("that bends less");
  Hand_surface folded(rhombus(.2));
  ISR_CHECK(folded.add(along_02));
  ISR_CHECK(has_edge(exchange_diagonals(folded), 1, 3));
}

void test_crossing()
{
  begin_case("that would cross a triangle");
  Points points = rhombus(.2);
  append(points, Points{ Point(2, 0, .1), Point(1.8, 0, 1), Point(2.2, 0, 1) });
  Hand_surface s(points);
  ISR_CHECK(s.add(along_02) && s.add({ { 4, 5, 6 } }));
  ISR_CHECK(has_edge(exchange_diagonals(s), 0, 2));
}

void test_crease()
{
  begin_case("a crease stays");
  Points points{ Point(0, 0, 0), Point(2, .8, 0), Point(4, 0, 0), Point(2, 0, -.8) };
  append(points, Points{ Point(0, 2, 0), Point(4, 2, 0), Point(0, 0, -2), Point(4, 0, -2) });
  Hand_surface s(points);
  ISR_CHECK(s.add(along_02) && s.add({ { 0, 4, 1 }, { 1, 5, 2 }, { 0, 3, 6 }, { 2, 7, 3 } }));
  ISR_CHECK(has_edge(exchange_diagonals(s), 0, 2));
}

// A roof with its ridge from 0 to 2 that bends by the given angle there, but for the triangles that meet in the edge from
// 1 to 3, whose circles are smaller.
bool has_ridge(double angle, bool has_stars)
{
  const double c = std::cos(angle), s = std::sin(angle);
  const Points points{ Point(0, 0, 0), Point(1, 1, 0), Point(2, 0, 0),           Point(1, -c, -s),
                       Point(0, 2, 0), Point(2, 2, 0), Point(0, -2 * c, -2 * s), Point(2, -2 * c, -2 * s) };
  const Triples triples{ { 0, 1, 3 }, { 1, 2, 3 }, { 0, 4, 1 }, { 1, 5, 2 }, { 0, 3, 6 }, { 2, 7, 3 } };
  Hand_surface surface(points, has_stars ? links_of(points.size(), triples) : Links());
  ISR_CHECK(has_stars || surface.add(triples));
  const Triples result = exchange_diagonals(surface);
  ISR_CHECK_EQUAL(result.size(), triples.size());
  ISR_CHECK(has_edge(result, 0, 2) != has_edge(result, 1, 3));
  return has_edge(result, 0, 2);
}

void test_ridge()
{
  for (bool has_stars : { false, true }) {
    begin_case(has_stars ? "a ridge that stars have cut off" : "a ridge that is cut off");
    ISR_CHECK(has_ridge(CGAL_PI / 2, has_stars));
    ISR_CHECK(has_ridge(CGAL_PI / 4, has_stars));
    begin_case("less than 30 degrees are no ridge");
    ISR_CHECK(!has_ridge(CGAL_PI / 7, has_stars));
    begin_case("smaller circles count more than a sharp ridge");
    ISR_CHECK(!has_ridge(CGAL_PI * .9, has_stars));
  }
}

// The same roof on a closed surface: all of its stars are closed.
void test_ridge_of_closed_surface()
{
  begin_case("a ridge that closed stars have cut off");
  const Points points{ Point(0, 0, 0), Point(1, 1, 0),  Point(2, 0, 0),  Point(1, 0, -1),    Point(0, 2, 0),
                       Point(2, 2, 0), Point(0, 0, -2), Point(2, 0, -2), Point(1, 2.5, -2.5) };
  const Triples triples{ { 0, 1, 3 }, { 1, 2, 3 }, { 0, 4, 1 }, { 1, 5, 2 }, { 0, 3, 6 }, { 2, 7, 3 }, { 4, 0, 8 },
                         { 1, 4, 8 }, { 5, 1, 8 }, { 2, 5, 8 }, { 7, 2, 8 }, { 3, 7, 8 }, { 6, 3, 8 }, { 0, 6, 8 } };
  Hand_surface surface(points, links_of(points.size(), triples));
  ISR_CHECK(surface.builder.open_points().empty());
  const Triples result = exchange_diagonals(surface);
  ISR_CHECK_EQUAL(result.size(), triples.size());
  ISR_CHECK(has_edge(result, 0, 2) && !has_edge(result, 1, 3));
}

// The squares of sheet() become parallelograms. Their diagonals are the longer ones if the shear is positive.
Mesh sheared_sheet(std::size_t m, double shear)
{
  Mesh mesh = sheet(m);
  for (Point& p : mesh.points)
    p = Point(p.x() + shear * p.y(), p.y(), p.z());
  return mesh;
}

void test_sheet(double shear, bool has_stars, bool is_exchanged)
{
  constexpr std::size_t M = 6;
  const Mesh mesh = sheared_sheet(M, shear);
  Hand_surface s(mesh.points, has_stars ? links_of(mesh.points.size(), mesh.triples) : Links());
  ISR_CHECK(has_stars || s.add(mesh.triples));
  const Triples triples = exchange_diagonals(s);
  ISR_CHECK_EQUAL(triples.size(), mesh.triples.size());
  for (std::size_t i = 0; i != M; ++i)
    for (std::size_t j = 0; j != M; ++j) {
      const std::size_t p = i * (M + 1) + j;
      ISR_CHECK_EQUAL(has_edge(triples, p, p + M + 2), !is_exchanged);
      ISR_CHECK_EQUAL(has_edge(triples, p + 1, p + M + 1), is_exchanged);
    }
}

} // namespace

int main()
{
  test_shorter_diagonal();
  test_crossing();
  test_crease();
  test_ridge();
  test_ridge_of_closed_surface();
  begin_case("every parallelogram of a sheet");
  test_sheet(.3, false, true);
  begin_case("none, where diagonals are short");
  test_sheet(-.3, false, false);
  begin_case("squares get the diagonal that spares the last point");
  test_sheet(0., false, true);
  begin_case("stars have decided");
  test_sheet(.3, true, false);
  return result();
}

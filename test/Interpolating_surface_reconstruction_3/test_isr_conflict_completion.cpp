#include "isr_surface_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Local_surface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/conflict_completion.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelling_repair.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/star_construction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

using namespace isr_test;
using isr_internal::Cell_complex;
using isr_internal::Cell_labelling;
using isr_internal::Conflict_completion;
using isr_internal::Labelling_repair;
using isr_internal::Local_point;
using isr_internal::Point_octree_3;
using Builder = Hand_surface::Builder;
using Cell_index = Cell_complex::Cell_index;
using Facet = std::array<Point_index, 3>;

namespace {

std::vector<Local_point> positions_of(const Points& points)
{
  std::vector<Local_point> result;
  for (const Point& p : points)
    result.emplace_back(p.x(), p.y(), p.z());
  return result;
}

std::vector<Point_index> all_of(const Points& points)
{
  std::vector<Point_index> result(points.size());
  std::iota(result.begin(), result.end(), Point_index(0));
  return result;
}

Facet sorted_facet(const Cell_complex& cells, Cell_index c, std::size_t i)
{
  Facet f = Cell_complex::facet(cells[c], i);
  std::sort(f.begin(), f.end());
  return f;
}

// ---- Cell_complex --------------------------------------------------------------------------------

void test_cells()
{
  begin_case("cells");
  const Points points = random_cube(80, 1);
  const std::vector<Local_point> positions = positions_of(points);
  const Cell_complex cells(positions, all_of(points));
  std::map<Facet, std::size_t> cells_of_facet;
  for (Cell_index c = 0; c != cells.size(); ++c) {
    std::set<Point_index> distinct(cells[c].vertices.begin(), cells[c].vertices.end());
    ISR_CHECK_EQUAL(distinct.size(), 4u);
    for (std::size_t i = 0; i != 4; ++i) {
      const Facet f = sorted_facet(cells, c, i);
      ++cells_of_facet[f];
      ISR_CHECK(std::count(f.begin(), f.end(), cells[c].vertices[i]) == 0);
      const Cell_index n = cells[c].neighbors[i];
      std::size_t back = 0;
      for (std::size_t j = 0; j != 4; ++j)
        back += cells[n].neighbors[j] == c && sorted_facet(cells, n, j) == f ? 1u : 0u;
      ISR_CHECK_EQUAL(back, 1u);
    }
    if (Cell_complex::is_infinite(cells[c]))
      continue;
    const auto& v = cells[c].vertices;
    for (const Point& p : points)
      if (CGAL::side_of_oriented_sphere(points[v[0]], points[v[1]], points[v[2]], points[v[3]], p) ==
          CGAL::ON_POSITIVE_SIDE) {
        ISR_CHECK(!"empty sphere");
        break;
      }
  }
  for (const auto& facet : cells_of_facet)
    ISR_CHECK_EQUAL(facet.second, 2u);
  ISR_CHECK(cells.size() > 300);
}

void check_same_cells(const Cell_complex& cells, const Cell_complex& expected)
{
  ISR_CHECK_EQUAL(cells.size(), expected.size());
  for (Cell_index c = 0; c != cells.size() && c != expected.size(); ++c)
    if (cells[c].vertices != expected[c].vertices || cells[c].neighbors != expected[c].neighbors) {
      ISR_CHECK(!"same cells in the same order");
      break;
    }
}

void test_order_of_cells()
{
  // the second has cospherical points
  for (const Points& points : { random_cube(120, 2), box(3, 3, 3).points }) {
    begin_case("order of cells");
    const std::vector<Local_point> positions = positions_of(points);
    std::vector<Point_index> sites = all_of(points);
    const Cell_complex expected(positions, sites);
    for (std::uint64_t seed : { 1u, 2u, 3u }) {
      std::vector<Point_index> order;
      for (std::size_t i : random_order(points.size(), seed))
        order.push_back(sites[i]);
      check_same_cells(Cell_complex(positions, order), expected);
      begin_case("points that join later");
      isr_internal::No_cancellation cancellation_point;
      isr_internal::Site_triangulation triangulation(positions);
      const auto half = order.begin() + std::ptrdiff_t(order.size() / 2);
      std::sort(order.begin(), half);
      std::sort(half, order.end());
      triangulation.insert({ order.begin(), half }, cancellation_point);
      triangulation.insert({ half, order.end() }, cancellation_point);
      check_same_cells(Cell_complex(triangulation, order, cancellation_point), expected);
    }
  }
}

void test_few_cells()
{
  begin_case("points without cells");
  const Points flat = plane_grid(4).points;
  ISR_CHECK_EQUAL(Cell_complex(positions_of(flat), all_of(flat)).size(), 0u);
  const Points line = { Point(0, 0, 0), Point(1, 1, 1), Point(2, 2, 2), Point(4, 4, 4) };
  ISR_CHECK_EQUAL(Cell_complex(positions_of(line), all_of(line)).size(), 0u);
  ISR_CHECK_EQUAL(Cell_complex(positions_of(line), { 1 }).size(), 0u);
  ISR_CHECK_EQUAL(Cell_complex(positions_of(line), {}).size(), 0u);
  begin_case("a helix has too many cells");
  Points helix;
  for (int i = 0; i != 4000; ++i)
    helix.emplace_back(std::cos(.01 * i), std::sin(.01 * i), .001 * i);
  ISR_CHECK_EQUAL(Cell_complex(positions_of(helix), all_of(helix)).size(), 0u);
  const Points sphere = sphere_random(4000, 1).points;
  ISR_CHECK(Cell_complex(positions_of(sphere), all_of(sphere)).size() > sphere.size());
  begin_case("one cell");
  const Points four = { Point(5, 5, 5), Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1) };
  const Cell_complex one(positions_of(four), { 1, 2, 3, 4 });
  ISR_CHECK_EQUAL(one.size(), 5u);
  std::size_t infinite = 0;
  for (Cell_index c = 0; c != one.size(); ++c)
    infinite += Cell_complex::is_infinite(one[c]) ? 1u : 0u;
  ISR_CHECK_EQUAL(infinite, 4u);
}

// ---- Cell_labelling ------------------------------------------------------------------------------

// Cells whose points have their center in a ball around the origin.
std::vector<bool> labels_of_ball(const Cell_complex& cells, const Points& points, double radius)
{
  std::vector<bool> result;
  for (Cell_index c = 0; c != cells.size(); ++c) {
    Vector sum(0, 0, 0);
    if (!Cell_complex::is_infinite(cells[c]))
      for (Point_index p : cells[c].vertices)
        sum = sum + (points[p] - CGAL::ORIGIN) / 4.;
    result.push_back(!Cell_complex::is_infinite(cells[c]) && sum.squared_length() < radius * radius);
  }
  return result;
}

// Whether the labels are those expected, or all of them the others.
bool are_same_up_to_complement(const Cell_complex& cells, const Cell_labelling& labelling,
                               const std::vector<bool>& expected)
{
  std::size_t equal = 0;
  for (Cell_index c = 0; c != cells.size(); ++c)
    equal += labelling.label(c) == expected[c] ? 1u : 0u;
  return equal == 0 || equal == cells.size();
}

void test_labelling()
{
  const Points points = random_cube(300, 4);
  const std::vector<Local_point> positions = positions_of(points);
  const Cell_complex cells(positions, all_of(points));
  const std::vector<bool> expected = labels_of_ball(cells, points, .7);
  ISR_CHECK(std::count(expected.begin(), expected.end(), true) > 100);
  const auto is_separating = [&](Cell_index c, std::size_t i) {
    return expected[c] != expected[cells[c].neighbors[i]];
  };

  begin_case("weights of equal size");
  std::size_t calls = 0;
  const Cell_labelling exact(cells, [&](Cell_index c, std::size_t i) {
    ++calls;
    return is_separating(c, i) ? 1. : -1.;
  });
  ISR_CHECK_EQUAL(calls, 2 * cells.size());
  ISR_CHECK(are_same_up_to_complement(cells, exact, expected));
  for (Cell_index c = 0; c != cells.size(); ++c) {
    ISR_CHECK_EQUAL(exact.gain(c), -4.);
    for (std::size_t i = 0; i != 4; ++i) {
      ISR_CHECK_EQUAL(exact.is_surface(c, i), is_separating(c, i));
      ISR_CHECK_EQUAL(exact.weight(c, i), is_separating(c, i) ? 1. : -1.);
    }
  }

  for (std::uint64_t seed = 1; seed != 6; ++seed) {
    begin_case("weights with noise, seed " + std::to_string(seed));
    Random random(seed);
    std::size_t wrong = 0;
    const Cell_labelling noisy(cells, [&](Cell_index c, std::size_t i) {
      const double sign = is_separating(c, i) ? 1. : -1.;
      if (random.below(20) == 0) {
        ++wrong;
        return -sign * random.uniform(0., .1);
      }
      return sign * random.uniform(.4, 1.5);
    });
    ISR_CHECK(wrong > 50);
    ISR_CHECK(are_same_up_to_complement(cells, noisy, expected));
  }

  begin_case("no single cell wins by a change");
  Random random(9);
  Cell_labelling arbitrary(cells, [&](Cell_index, std::size_t) { return random.uniform(-1., 1.); });
  const auto total = [&] {
    double sum = 0.;
    for (Cell_index c = 0; c != cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i)
        sum += arbitrary.is_surface(c, i) ? arbitrary.weight(c, i) / 2. : 0.;
    return sum;
  };
  for (Cell_index c = 0; c != cells.size(); ++c)
    ISR_CHECK(arbitrary.gain(c) < 1e-8);
  const double before = total();
  for (Cell_index c = 0; c < cells.size(); c += 50) {
    const double gain = arbitrary.gain(c);
    arbitrary.flip(c);
    ISR_CHECK(std::abs(total() - before - gain) < 1e-9);
    ISR_CHECK(std::abs(arbitrary.gain(c) + gain) < 1e-12);
    arbitrary.flip(c);
  }
  for (Cell_index c = 0; c < cells.size(); c += 9)
    arbitrary.flip(c);
  const double disturbed = total();
  arbitrary.relax();
  ISR_CHECK(total() > disturbed);
  for (Cell_index c = 0; c != cells.size(); ++c)
    ISR_CHECK(arbitrary.gain(c) < 1e-8);
}

// A cell that shares two facets with another one: each facet keeps its own weight.
void test_two_common_facets()
{
  begin_case("cells with two common facets");
  const Points points = { Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1) };
  const Cell_complex cells(positions_of(points), { 0, 1, 2, 3 });
  std::map<Facet, double> weights;
  const Cell_labelling labelling(cells, [&](Cell_index c, std::size_t i) {
    return weights[sorted_facet(cells, c, i)] = -1. - double(weights.size());
  });
  ISR_CHECK_EQUAL(weights.size(), 10u);
  for (Cell_index c = 0; c != cells.size(); ++c)
    for (std::size_t i = 0; i != 4; ++i)
      ISR_CHECK_EQUAL(labelling.weight(c, i), weights[sorted_facet(cells, c, i)]);
}

// ---- Labelling_repair ----------------------------------------------------------------------------

// Whether the cells of either label around the point are connected by facets at the point.
bool is_manifold_at(Point_index p, const Cell_complex& cells, const Cell_labelling& labelling)
{
  validation::Disjoint_sets sets(cells.size());
  std::vector<Cell_index> around;
  for (Cell_index c = 0; c != cells.size(); ++c) {
    if (std::count(cells[c].vertices.begin(), cells[c].vertices.end(), p) == 0)
      continue;
    around.push_back(c);
    for (std::size_t i = 0; i != 4; ++i)
      if (cells[c].vertices[i] != p && !labelling.is_surface(c, i))
        sets.unite(c, cells[c].neighbors[i]);
  }
  std::set<std::size_t> roots[2];
  for (Cell_index c : around)
    roots[labelling.label(c) ? 1 : 0].insert(sets.find(c));
  return roots[0].size() == 1 && roots[1].size() == 1;
}

std::size_t number_of_defects(const std::vector<Point_index>& scope, const Cell_complex& cells,
                              const Cell_labelling& labelling)
{
  return static_cast<std::size_t>(
    std::count_if(scope.begin(), scope.end(), [&](Point_index p) { return !is_manifold_at(p, cells, labelling); }));
}

void test_repair_of_random_labels()
{
  for (std::uint64_t seed = 1; seed != 9; ++seed) {
    begin_case("random labels, seed " + std::to_string(seed));
    const Points points = random_cube(20 + 10 * seed, seed);
    const std::vector<Local_point> positions = positions_of(points);
    const Cell_complex cells(positions, all_of(points));
    Random random(seed);
    Cell_labelling labelling(cells, [&](Cell_index, std::size_t) { return random.uniform(-1., 1.); });
    for (Cell_index c = 0; c != cells.size(); ++c)
      if (random.below(2) == 0)
        labelling.flip(c);
    std::vector<Point_index> scope;
    for (Point_index p = 0; p != points.size(); ++p)
      if (seed % 2 == 0 || p % 3 != 0)
        scope.push_back(p);
    const std::size_t before = number_of_defects(scope, cells, labelling);
    ISR_CHECK(before > scope.size() / 2);
    Labelling_repair repair(
      cells, labelling, [&](Point_index p) { return seed % 2 == 0 || p % 3 != 0; }, 1e9);
    const std::size_t after = repair();
    ISR_CHECK_EQUAL(after, number_of_defects(scope, cells, labelling));
    ISR_CHECK(after < before / 2);
  }
}

// Cells of a sphere, some of them with the wrong label.
void test_repair_of_sphere()
{
  for (std::uint64_t seed = 1; seed != 7; ++seed) {
    begin_case("disturbed sphere, seed " + std::to_string(seed));
    const Points points = sphere_random(120, seed).points;
    const std::vector<Local_point> positions = positions_of(points);
    const Cell_complex cells(positions, all_of(points));
    const auto is_finite = [&](Cell_index c) { return !Cell_complex::is_infinite(cells[c]); };
    Cell_labelling labelling(
      cells, [&](Cell_index c, std::size_t i) { return is_finite(c) != is_finite(cells[c].neighbors[i]) ? 1. : -1.; });
    const std::vector<Point_index> scope = all_of(points);
    ISR_CHECK_EQUAL(number_of_defects(scope, cells, labelling), 0u);
    Random random(seed);
    for (std::size_t i = 0; i != 12; ++i)
      labelling.flip(static_cast<Cell_index>(random.below(cells.size())));
    ISR_CHECK(number_of_defects(scope, cells, labelling) > 0);
    const std::size_t after = Labelling_repair(
      cells, labelling, [](Point_index) { return true; }, 10.)();
    ISR_CHECK_EQUAL(after, number_of_defects(scope, cells, labelling));
    ISR_CHECK_EQUAL(after, 0u);
  }
}

void test_repair_that_may_not_lose()
{
  begin_case("no change loses more than allowed");
  const Points points = sphere_random(60, 3).points;
  const std::vector<Local_point> positions = positions_of(points);
  const Cell_complex cells(positions, all_of(points));
  // all cells on one side, for good
  Cell_labelling labelling(cells, [](Cell_index, std::size_t) { return -1.; });
  ISR_CHECK_EQUAL(Labelling_repair(
                    cells, labelling, [](Point_index) { return true; }, .5)(),
                  60u);
  for (Cell_index c = 0; c != cells.size(); ++c)
    ISR_CHECK(labelling.label(c) == labelling.label(0));
  // nothing in the scope
  ISR_CHECK_EQUAL(Labelling_repair(
                    cells, labelling, [](Point_index) { return false; }, 1e9)(),
                  0u);
}

// ---- Conflict_completion -------------------------------------------------------------------------

constexpr double INFINITE = std::numeric_limits<double>::infinity();

// The stars of the points, in the order of the points.
Links stars_of(const Points& points)
{
  const Hand_surface::Cloud cloud(points, CGAL::Identity_property_map<Point>(), Kernel());
  const Point_octree_3 octree(cloud.positions());
  CGAL::Interpolating_surface_reconstruction_3::Default_visitor visitor;
  isr_internal::Progress<decltype(visitor)> progress(std::function<bool(double)>(), visitor);
  progress.begin_stage(CGAL::Interpolating_surface_reconstruction_3::Stage::STARS, 1.);
  const Star_table stars = isr_internal::construct_stars<CGAL::Sequential_tag>(
    cloud.positions(), octree, CGAL::Interpolating_surface_reconstruction_3::Restricted_voronoi_star_3(), INFINITE,
    progress);
  Links links(points.size());
  for (Point_index p = 0; p != stars.size(); ++p)
    for (Star_table::Slot s = stars.begin(p); s != stars.end(p); ++s)
      links[cloud.input_index(p)].push_back(
        stars.neighbor(s) == NO_POINT ? NO_POINT : static_cast<Point_index>(cloud.input_index(stars.neighbor(s))));
  return links;
}

// Returns the number of triangles added.
template <typename ConcurrencyTag = CGAL::Sequential_tag>
std::size_t complete(Hand_surface& s)
{
  const Point_octree_3 octree(s.cloud.positions());
  CGAL::Interpolating_surface_reconstruction_3::Default_visitor visitor;
  isr_internal::Progress<decltype(visitor)> progress(std::function<bool(double)>(), visitor);
  progress.begin_stage(CGAL::Interpolating_surface_reconstruction_3::Stage::COMPLETION, 1.);
  std::size_t added = 0;
  isr_internal::Kept_triangulation triangulation(s.cloud.positions());
  Conflict_completion<ConcurrencyTag, Builder>(s.cloud.positions(), octree, INFINITE, s.builder)(
    progress,
    [&](const Builder::Triangle&, Triangle_verdict verdict) { added += verdict == Triangle_verdict::ADDED ? 1u : 0u; },
    triangulation);
  return added;
}

void test_nothing_to_complete()
{
  begin_case("nothing to complete");
  const Mesh closed = globe(8, 12), open = sheet(8);
  for (const Mesh* mesh : { &closed, &open }) {
    Hand_surface s(mesh->points, links_of(mesh->points.size(), mesh->triples));
    ISR_CHECK_EQUAL(complete(s), 0u);
    ISR_CHECK_EQUAL(s.triangles().size(), mesh->triples.size());
  }
}

// A sphere on which the stars of some points are wrong.
void test_spoilt_stars()
{
  for (std::uint64_t seed = 1; seed != 7; ++seed) {
    begin_case("spoilt stars, seed " + std::to_string(seed));
    const std::size_t n = 600;
    const Points points = with_noise(sphere_fibonacci(n).points, .01, seed);
    Links links = stars_of(points);
    Random random(seed);
    for (std::size_t i = 0; i != 15 * seed; ++i) {
      Link& link = links[random.below(n)];
      const std::size_t kind = random.below(3);
      if (kind == 0 || link.size() < 4)
        link.assign(1, NO_POINT);
      else if (kind == 1)
        link.erase(link.begin() + std::ptrdiff_t(random.below(link.size())));
      else
        std::swap(link[0], link[1]);
    }
    Hand_surface s(points, links);
    const std::size_t before = s.triangles().size();
    ISR_CHECK(s.compatibility.number_of_agreed_points() < n && before < 2 * n - 4);
    const std::size_t added = complete(s);
    const Triples triples = s.triangles();
    ISR_CHECK_EQUAL(triples.size(), before + added);
    ISR_CHECK_EQUAL(triples.size(), 2 * n - 4);
    ISR_CHECK(validation::is_oriented_manifold(points, triples, Kernel()));
    ISR_CHECK_EQUAL(validation::used_points(triples).size(), n);
    ISR_CHECK(validation::boundary_edges(triples).empty());
    ISR_CHECK_EQUAL(validation::number_of_components(triples), 1u);
  }
}

// Many clusters, which threads share.
void test_clusters_side_by_side()
{
  begin_case("clusters side by side");
  const std::size_t n = 3000;
  const Points points = with_noise(sphere_fibonacci(n).points, .005, 3);
  Links links = stars_of(points);
  for (std::size_t p = 0; p < n; p += 150)
    links[p].assign(1, NO_POINT);
  Hand_surface s(points, links);
  ISR_CHECK(s.triangles().size() < 2 * n - 4);
  ISR_CHECK(complete(s) >= 60);
  const Triples triples = s.triangles();
  ISR_CHECK_EQUAL(triples.size(), 2 * n - 4);
  ISR_CHECK(validation::is_oriented_manifold(points, triples, Kernel()));
#ifdef CGAL_LINKED_WITH_TBB
  Hand_surface t(points, links);
  complete<CGAL::Parallel_tag>(t);
  ISR_CHECK(t.triangles() == triples);
#endif
}

void test_local_surface()
{
  begin_case("local surface");
  const Mesh mesh = globe(8, 12);
  Hand_surface s(mesh.points, links_of(mesh.points.size(), mesh.triples));
  const Triples before = s.triangles();
  std::vector<Facet> facets;
  s.builder.for_each_triangle([&](const Builder::Triangle& t, isr_internal::Parity_union_find::Element) {
    facets.push_back(t);
    std::sort(facets.back().begin(), facets.back().end());
  });
  const std::vector<unsigned char> was_conflict(mesh.points.size(), 0);
  isr_internal::Local_surface<Builder> surface(s.builder, was_conflict);
  for (int round = 0; round != 2; ++round) {
    surface.reset();
    for (const Facet& f : facets)
      ISR_CHECK(surface.has_triangle(f) && surface.orientation(f));
    for (Point_index p = 0; p != mesh.points.size(); ++p)
      ISR_CHECK(!surface.is_conflict(p) && surface.is_complete(p));
    std::vector<Point_index> joined;
    const auto on_join = [&](Point_index p) { joined.push_back(p); };
    surface.withdraw({ facets[3], facets[0], facets[3] }, on_join);
    surface.withdraw({ facets[7] }, on_join);
    std::set<Point_index> expected;
    for (std::size_t k : { 0u, 3u, 7u })
      expected.insert(facets[k].begin(), facets[k].end());
    ISR_CHECK_EQUAL(joined.size(), expected.size());
    ISR_CHECK(std::set<Point_index>(joined.begin(), joined.end()) == expected);
    for (Point_index p = 0; p != mesh.points.size(); ++p)
      ISR_CHECK_EQUAL(surface.is_conflict(p), expected.count(p) != 0);
    for (std::size_t k = 0; k != facets.size(); ++k)
      ISR_CHECK_EQUAL(surface.has_triangle(facets[k]), k != 0 && k != 3 && k != 7);
    ISR_CHECK_EQUAL(surface.withdrawn().size(), 3u);
    ISR_CHECK(std::is_sorted(surface.withdrawn().begin(), surface.withdrawn().end()));
  }
  ISR_CHECK(s.triangles() == before);
}

// What is known before is part of the result.
void test_agreed_triangles_stay()
{
  begin_case("agreed triangles stay");
  const Points points = sphere_random(500, 4).points;
  Links links = stars_of(points);
  for (std::size_t p = 0; p != 500; p += 20)
    links[p].clear();
  Hand_surface s(points, links);
  const auto unoriented = [](Triples triples) {
    for (Triple& t : triples)
      std::sort(t.begin(), t.end());
    std::sort(triples.begin(), triples.end());
    return triples;
  };
  const Triples before = unoriented(s.triangles());
  ISR_CHECK(complete(s) > 100);
  const Triples after = unoriented(s.triangles());
  ISR_CHECK(std::includes(after.begin(), after.end(), before.begin(), before.end()));
  ISR_CHECK(validation::is_edge_manifold(s.triangles()) && validation::is_consistently_oriented(s.triangles()));
  ISR_CHECK(after.size() > 980);
}

} // namespace

int main()
{
  test_cells();
  test_order_of_cells();
  test_few_cells();
  test_labelling();
  test_two_common_facets();
  test_repair_of_random_labels();
  test_repair_of_sphere();
  test_repair_that_may_not_lose();
  test_nothing_to_complete();
  test_spoilt_stars();
  test_clusters_side_by_side();
  test_local_surface();
  test_agreed_triangles_stay();
  return result();
}

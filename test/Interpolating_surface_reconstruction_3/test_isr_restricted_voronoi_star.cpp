#include "isr_stage_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Nearest_neighbors.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <iostream>
#include <set>

using namespace isr_stage_test;
using ISR::Restricted_voronoi_star_3;
using ISR::internal::Nearest_neighbors;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<
  Kernel, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<Point_index, Kernel> > >;
using Indices = std::set<Point_index>;

Indices neighbors_of(const Stars& stars, std::size_t p)
{
  Indices result(stars.links[p].begin(), stars.links[p].end());
  result.erase(GAP);
  return result;
}

// Neighbors in the Delaunay triangulation of points on the tilted plane; none if one is infinite.
std::vector<Indices> delaunay_neighbors(const Indexed_points& indexed)
{
  const Local_vector u(2. / 3, 2. / 3, 1. / 3), v(-2. / 3, 1. / 3, 2. / 3);
  std::vector<std::pair<Kernel::Point_2, Point_index> > points;
  for (Point_index i = 0; i != indexed.points.size(); ++i) {
    const Local_vector d = indexed.points[i] - CGAL::ORIGIN;
    points.emplace_back(Kernel::Point_2(d * u, d * v), i);
  }
  const Delaunay delaunay(points.begin(), points.end());
  std::vector<Indices> result(points.size());
  for (auto vertex = delaunay.finite_vertices_begin(); vertex != delaunay.finite_vertices_end(); ++vertex) {
    Indices& neighbors = result[vertex->info()];
    auto it = delaunay.incident_vertices(vertex), end = it;
    bool is_inner = true;
    do {
      is_inner = is_inner && !delaunay.is_infinite(it);
      neighbors.insert(it->info());
    } while (++it != end);
    if (!is_inner)
      neighbors.clear();
  }
  return result;
}

void test_random_patch()
{
  for (std::uint32_t seed : { 1u, 2u, 3u }) {
    const Indexed_points indexed(random_patch(1500, seed));
    const Stars stars = construct_stars<Nearest_neighbors>(indexed, Restricted_voronoi_star_3());
    const std::vector<Indices> expected = delaunay_neighbors(indexed);
    std::size_t inner = 0;
    for (std::size_t p = 0; p != expected.size(); ++p) {
      if (stars.certain[p] && stars.is_closed(p)) {
        ++inner;
        assert(neighbors_of(stars, p) == expected[p]);
      }
      assert(std::abs(std::abs(stars.normals[p] * tilted_plane_normal()) - 1.) < 1e-9);
      assert(is_counterclockwise(indexed, stars, p));
    }
    assert(inner > 1400);
  }
}

void test_hexagonal_patch()
{
  const std::size_t m = 20;
  const Indexed_points indexed(hexagonal_patch(m));
  const Stars stars = construct_stars<Nearest_neighbors>(indexed, Restricted_voronoi_star_3());
  std::size_t inner = 0;
  for (std::size_t p = 0; p != indexed.points.size(); ++p) {
    Indices adjacent;
    for (std::size_t q = 0; q != indexed.points.size(); ++q)
      if (q != p && CGAL::squared_distance(indexed.points[p], indexed.points[q]) < 1.01 / double(m * m))
        adjacent.insert(Point_index(q));
    if (adjacent.size() == 6) {
      ++inner;
      assert(stars.is_closed(p) && neighbors_of(stars, p) == adjacent);
    }
    if (adjacent.size() < 4)
      assert(!stars.is_closed(p));
    const Indices found = neighbors_of(stars, p);
    assert(std::includes(found.begin(), found.end(), adjacent.begin(), adjacent.end()));
    assert(is_counterclockwise(indexed, stars, p));
  }
  assert(inner == (m - 2) * (m - 2));
}

// Cocircular points: the four nearest are in the star, those beyond the diagonals may be.
void test_square_grid()
{
  const Indexed_points indexed(square_grid(20));
  const Stars stars = construct_stars<Nearest_neighbors>(indexed, Restricted_voronoi_star_3());
  for (std::size_t p = 0; p != indexed.points.size(); ++p) {
    const Local_point& c = indexed.points[p];
    if (c.x() == 0 || c.x() == 19 || c.y() == 0 || c.y() == 19) {
      assert(!stars.is_closed(p));
      continue;
    }
    assert(stars.is_closed(p));
    std::size_t nearest = 0;
    for (Point_index q : stars.links[p]) {
      nearest += CGAL::squared_distance(c, indexed.points[q]) == 1. ? 1u : 0u;
      assert(CGAL::squared_distance(c, indexed.points[q]) <= 2.);
    }
    assert(nearest == 4);
  }
}

// The stars of the four corners of a square or rectangle agree on one of its diagonals, in any position.
void test_diagonals_of_squares()
{
  const std::size_t m = 20;
  const double c = std::cos(.7), s = std::sin(.7);
  for (int rotation = 0; rotation != 5; ++rotation) {
    const auto placed = [&](const Local_point& p) {
      switch (rotation) {
      case 0:
        return p;
      case 1:
        return Local_point(p.z(), p.x(), p.y());
      case 2:
        return on_tilted_plane(p.x() / double(m), p.y() / double(m));
      case 3:
        return Local_point(c * p.x() - s * p.y(), s * p.x() + c * p.y(), .1);
      default:
        return Local_point(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.x() / 3.);
      }
    };
    // position on the grid of each point
    std::map<Local_point, std::size_t> position;
    std::vector<Local_point> points;
    for (const Local_point& p : square_grid(m)) {
      points.push_back(placed(p));
      position[points.back()] = std::size_t(p.x()) + m * std::size_t(p.y());
    }
    const Indexed_points indexed(points);
    const Stars stars = construct_stars<Nearest_neighbors>(indexed, Restricted_voronoi_star_3());
    const std::map<std::array<Point_index, 3>, int> votes = stars.votes();
    std::map<std::size_t, std::size_t> triangles_of_square; // by its corner closest to the origin
    for (const auto& v : votes) {
      if (v.second != 3)
        continue;
      std::size_t x = m, y = m, far_x = 0, far_y = 0;
      for (Point_index q : v.first) {
        const std::size_t at = position.at(indexed.points[q]);
        x = (std::min)(x, at % m);
        y = (std::min)(y, at / m);
        far_x = (std::max)(far_x, at % m);
        far_y = (std::max)(far_y, at / m);
      }
      assert(far_x == x + 1 && far_y == y + 1);
      ++triangles_of_square[x + m * y];
    }
    for (std::size_t y = 1; y + 2 != m; ++y)
      for (std::size_t x = 1; x + 2 != m; ++x)
        assert(triangles_of_square[x + m * y] == 2);
  }
}

// The stars of points that are cocircular but for rounding agree on a triangulation of their polygon.
void test_cocircular()
{
  for (std::size_t n : { 5u, 6u, 12u, 40u, 100u })
    for (double angle : { 0., .7, 1.3 }) {
      std::vector<Local_point> points;
      for (std::size_t i = 0; i != n; ++i) {
        const double a = angle + 6.28318530717958647692 * double(i) / double(n);
        points.push_back(angle == 0. ? Local_point(std::cos(a), std::sin(a), 0.)
                                     : on_tilted_plane(std::cos(a), std::sin(a)));
      }
      const Indexed_points indexed(points);
      const Stars stars = construct_stars<Nearest_neighbors>(indexed, Restricted_voronoi_star_3());
      const std::map<std::array<Point_index, 3>, int> votes = stars.votes();
      assert(votes.size() == n - 2);
      assert(std::all_of(votes.begin(), votes.end(), [](const auto& v) { return v.second == 3; }));
    }
}

void test_sphere()
{
  const Indexed_points indexed(sphere(3000, .005, 4));
  const Stars stars = construct_stars<Nearest_neighbors>(indexed, Restricted_voronoi_star_3());
  for (std::size_t p = 0; p != indexed.points.size(); ++p) {
    assert(stars.is_closed(p) && is_counterclockwise(indexed, stars, p));
    assert(std::abs(stars.normals[p] * (indexed.points[p] - CGAL::ORIGIN)) > .99);
  }
  assert(stars.agreed_share() > .9);
}

// A hexagon whose center has nine more neighbors on a sheet to one side below it: they turn the plane of covariance, but
// the star is the hexagon all the same.
void test_star_in_plane_of_its_triangles()
{
  std::vector<Local_vector> neighbors;
  for (int i = 0; i != 6; ++i)
    neighbors.emplace_back(std::cos(i * 1.0471975512), std::sin(i * 1.0471975512), 0.);
  for (int i = 0; i != 9; ++i)
    neighbors.emplace_back(.3 + .25 * (i / 3), .25 * (i % 3) - .25, -.95);
  std::stable_sort(neighbors.begin(), neighbors.end(), [](const Local_vector& a, const Local_vector& b) {
    return a.squared_length() < b.squared_length();
  });
  ISR::Point_star star;
  assert(Restricted_voronoi_star_3()(ISR::Star_neighborhood(neighbors.data(), neighbors.size(), 10.), star));
  assert(star.link.size() == 6);
  for (std::uint32_t i : star.link)
    assert(i != GAP && neighbors[i].z() == 0.);
}

// Rows across a cylinder, a hundred times as far from each other as the points in them: the nearest neighbors are those
// of one row, which bends in a plane across the surface.
void test_rows()
{
  const int rows = 7, row_size = 800;
  std::vector<Local_point> points;
  for (int i = 0; i != rows; ++i)
    for (int j = 0; j != row_size; ++j) {
      const double angle = .0025 * (j + .1 * i);
      points.emplace_back(std::cos(angle), std::sin(angle), .25 * i);
    }
  const Indexed_points indexed(points);
  const Stars stars = construct_stars<Nearest_neighbors>(indexed, Restricted_voronoi_star_3());
  std::size_t inner = 0;
  for (std::size_t p = 0; p != indexed.points.size(); ++p) {
    const Local_point& c = indexed.points[p];
    if (c.z() < .25 || c.z() > .25 * (rows - 2) || c.x() < .2 || c.x() > .9)
      continue;
    ++inner;
    assert(std::abs(stars.normals[p].z()) < .1 && std::abs(stars.normals[p] * Local_vector(c.x(), c.y(), 0.)) > .95);
    assert(stars.is_closed(p));
    for (Point_index q : stars.links[p])
      assert(std::abs(indexed.points[q].z() - c.z()) < .3);
  }
  assert(inner > 500);
}

// A certain star is the star among all points.
void test_certainty()
{
  const Indexed_points indexed(sphere(800, .03, 5));
  Nearest_neighbors neighbors(indexed.points, indexed.octree, std::numeric_limits<double>::infinity());
  const Restricted_voronoi_star_3 construct;
  const std::size_t all = indexed.points.size() - 1;
  ISR::Point_star star;
  for (std::size_t size :
       { Restricted_voronoi_star_3::initial_number_of_neighbors(), std::size_t(24), std::size_t(64) }) {
    std::vector<std::vector<Point_index> > certain(indexed.points.size());
    std::size_t number = 0;
    for (std::uint32_t leaf : indexed.octree.leaves()) {
      neighbors.for_each_point(indexed.octree.node(leaf), size, size,
                               [&](Point_index p, const ISR::Star_neighborhood& n) {
                                 if (construct(n, star)) {
                                   ++number;
                                   for (std::uint32_t i : star.link)
                                     certain[p].push_back(i == GAP ? NO_POINT : neighbors.indices()[i]);
                                 }
                                 return true;
                               });
      neighbors.for_each_point(
        indexed.octree.node(leaf), all, all, [&](Point_index p, const ISR::Star_neighborhood& n) {
          assert(construct(n, star));
          std::vector<Point_index> link;
          for (std::uint32_t i : star.link)
            link.push_back(i == GAP ? NO_POINT : neighbors.indices()[i]);
          assert(certain[p].empty() ||
                 (std::is_permutation(link.begin(), link.end(), certain[p].begin(), certain[p].end())));
          return true;
        });
    }
    assert(number > 700);
  }
}

// Neighborhoods that make no star, and stay free of NaN.
void test_degenerate_neighborhoods()
{
  const double infinity = std::numeric_limits<double>::infinity();
  ISR::Point_star star;
  star.link.assign(3, 1);
  const std::vector<Local_vector> coincident(20, Local_vector(0, 0, 0));
  assert(Restricted_voronoi_star_3()(ISR::Star_neighborhood(nullptr, 0, infinity), star));
  assert(star.link.empty() || star.link == std::vector<std::uint32_t>{ GAP });
  assert(std::isfinite(star.normal * star.normal));
  Restricted_voronoi_star_3()(ISR::Star_neighborhood(coincident.data(), 20, infinity), star);
  assert(std::count(star.link.begin(), star.link.end(), GAP) == std::ptrdiff_t(star.link.size()));
  assert(std::isfinite(star.normal * star.normal));
  std::vector<Local_vector> line;
  for (int i = 1; i != 20; ++i)
    line.emplace_back((i % 2 == 0 ? i : -i) * .1, 0., 0.);
  Restricted_voronoi_star_3()(ISR::Star_neighborhood(line.data(), line.size(), infinity), star);
  assert(std::count(star.link.begin(), star.link.end(), GAP) > 0);
  assert(std::abs(star.normal.x()) < 1e-6);
}

// A cell with more edges than the polygon holds.
void test_many_neighbors()
{
  std::vector<Local_vector> ring;
  for (int i = 0; i != 200; ++i)
    ring.emplace_back(std::cos(i * .0314159), std::sin(i * .0314159), 0.);
  ISR::Point_star star;
  Restricted_voronoi_star_3()(ISR::Star_neighborhood(ring.data(), ring.size(), 1.), star);
  assert(star.link.size() >= 10);
  for (std::uint32_t i : star.link)
    assert(i == GAP || i < 200);
}

int main()
{
  test_random_patch();
  test_hexagonal_patch();
  test_square_grid();
  test_diagonals_of_squares();
  test_cocircular();
  test_sphere();
  test_star_in_plane_of_its_triangles();
  test_rows();
  test_certainty();
  test_degenerate_neighborhoods();
  test_many_neighbors();
  std::cout << "done" << std::endl;
  return 0;
}

#include "isr_surface_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/boundary_loops.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/hole_closing.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

using namespace isr_test;
using isr_internal::Boundary_loop;
using isr_internal::Boundary_loops;
using isr_internal::Hole_closing;
using Builder = Hand_surface::Builder;

namespace {

// No four of them are coplanar.
Points points_in_general_position(std::size_t n, std::uint64_t seed) { return random_cube(n, seed); }

void test_verdicts()
{
  begin_case("verdicts");
  Hand_surface s(points_in_general_position(12, 1));
  ISR_CHECK(s.add(0, 1, 2) == Triangle_verdict::ADDED);
  ISR_CHECK(s.add(0, 1, 2) == Triangle_verdict::DUPLICATE);
  ISR_CHECK(s.add(1, 0, 2) == Triangle_verdict::DUPLICATE);
  ISR_CHECK(s.add(2, 0, 3) == Triangle_verdict::ADDED);
  ISR_CHECK(s.add(0, 2, 4) == Triangle_verdict::EDGE_FULL);
  ISR_CHECK(s.add(4, 0, 2) == Triangle_verdict::EDGE_FULL);
  // two fans at a vertex are fine as long as none of them closes
  ISR_CHECK(s.add(0, 5, 6) == Triangle_verdict::ADDED);
  ISR_CHECK(s.add(1, 0, 3) == Triangle_verdict::VERTEX_FULL);
  ISR_CHECK_EQUAL(s.triangles().size(), 3u);
  s.remove(5, 6, 0);
  ISR_CHECK(s.add(1, 0, 3) == Triangle_verdict::ADDED);
  ISR_CHECK(validation::is_consistently_oriented(s.triangles()));
  ISR_CHECK_EQUAL(s.triangles().size(), 3u);
}

void test_closed_fan_is_full()
{
  begin_case("a vertex with a closed fan is full");
  Hand_surface s(points_in_general_position(8, 2));
  ISR_CHECK(s.add({ { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 } }));
  ISR_CHECK(s.add(0, 4, 5) == Triangle_verdict::VERTEX_FULL);
  ISR_CHECK(s.add(5, 0, 4) == Triangle_verdict::VERTEX_FULL);
  ISR_CHECK(s.add(4, 5, 0) == Triangle_verdict::VERTEX_FULL);
  ISR_CHECK(s.add(4, 5, 1) == Triangle_verdict::ADDED);
}

void test_closed_point_is_full()
{
  begin_case("a point whose star is agreed is full");
  const Mesh mesh = globe(5, 8);
  Hand_surface s(mesh.points, links_of(mesh.points.size(), mesh.triples));
  ISR_CHECK(s.builder.open_points().empty());
  ISR_CHECK(s.add(0, 20, 30) == Triangle_verdict::VERTEX_FULL);
  ISR_CHECK(canonical(s.triangles()) == canonical(mesh.triples) ||
            canonical(s.triangles()) == canonical(turned(mesh.triples)));
}

void test_not_orientable()
{
  for (std::size_t n : { 5u, 7u, 15u }) {
    begin_case("Moebius band of " + std::to_string(n));
    Hand_surface s(points_in_general_position(n, 3));
    Triples triples = moebius_triples(n);
    for (std::size_t i = 0; i + 1 != n; ++i)
      ISR_CHECK(s.add(triples[i][0], triples[i][1], triples[i][2]) == Triangle_verdict::ADDED);
    ISR_CHECK(s.add(triples[n - 1][0], triples[n - 1][1], triples[n - 1][2]) == Triangle_verdict::NOT_ORIENTABLE);
    ISR_CHECK_EQUAL(s.triangles().size(), n - 1);
    ISR_CHECK(validation::is_consistently_oriented(s.triangles()));
  }
}

// Collinear and nearly collinear points; doubles of tenths are seldom on one line.
void test_degenerate()
{
  begin_case("degenerate triangles");
  const double tiny = std::ldexp(1., -52);
  const Points points = { Point(0, 0, 0),    Point(1, 3, 5),    Point(1 / 2., 3 / 2., 5 / 2.),
                          Point(.1, .2, .3), Point(.3, .6, .9), Point(1, 3 + 2 * tiny, 5),
                          Point(7, 21, 35),  Point(-2, 1, 1) };
  Hand_surface s(points);
  ISR_CHECK(s.add(0, 1, 2) == Triangle_verdict::DEGENERATE);
  ISR_CHECK(s.add(6, 2, 1) == Triangle_verdict::DEGENERATE);
  ISR_CHECK(s.add(0, 2, 5) == Triangle_verdict::ADDED);
  const bool is_collinear = CGAL::collinear(points[0], points[3], points[4]);
  ISR_CHECK(!is_collinear); // .1 * 3 is not .3
  ISR_CHECK((s.add(0, 3, 4) == Triangle_verdict::DEGENERATE) == is_collinear);

  begin_case("predicates are exact");
  Random random(6);
  std::size_t collinear = 0, nearly = 0;
  for (std::size_t i = 0; i != 60; ++i) {
    // integers up to 2^26 times a small one: exact; moved by one unit in the last place: not
    const auto integer = [&] { return double(random.below(1u << 26)) + double(1u << 26); };
    const double x = integer(), y = integer(), z = integer(), f = double(3 + random.below(1000));
    const bool is_moved = i % 2 == 0;
    const Points line = { Point(0, 0, 0), Point(x, y, z),
                          Point(f * x, is_moved ? std::nextafter(f * y, 0.) : f * y, f * z) };
    Hand_surface t(line);
    const bool is_degenerate = t.predicates.is_degenerate(t.indices[0], t.indices[1], t.indices[2]);
    ISR_CHECK_EQUAL(is_degenerate, !is_moved);
    ISR_CHECK_EQUAL(is_degenerate, CGAL::collinear(line[0], line[1], line[2]));
    (is_degenerate ? collinear : nearly) += 1;
  }
  ISR_CHECK(collinear == 30 && nearly == 30);
}

void test_folded()
{
  begin_case("folded triangles");
  const double tiny = std::ldexp(1., -50);
  const Points points = { Point(0, 0, 0),  Point(1, 0, 0),    Point(0, 1, 0), Point(1, 1, 0),
                          Point(0, -1, 0), Point(1, 1, tiny), Point(.5, 0, 1) };
  Hand_surface s(points);
  ISR_CHECK(s.add(0, 1, 2) == Triangle_verdict::ADDED);
  ISR_CHECK(s.add(0, 1, 3) == Triangle_verdict::FOLDED);
  ISR_CHECK(s.add(3, 1, 0) == Triangle_verdict::FOLDED);
  ISR_CHECK(s.add(1, 5, 0) == Triangle_verdict::ADDED); // on the same side, but not in the plane
  s.remove(0, 1, 5);
  ISR_CHECK(s.add(4, 0, 1) == Triangle_verdict::ADDED); // on the other side
  s.remove(0, 1, 4);
  ISR_CHECK(s.add(0, 6, 1) == Triangle_verdict::ADDED);

  const auto is_folded = [&](std::size_t p, std::size_t q, std::size_t r, std::size_t t) {
    return s.predicates.is_folded(s.indices[p], s.indices[q], s.indices[r], s.indices[t]);
  };
  ISR_CHECK(is_folded(0, 1, 2, 3) && is_folded(1, 0, 3, 2));
  ISR_CHECK(!is_folded(0, 1, 2, 4) && !is_folded(0, 1, 4, 3));
  ISR_CHECK(!is_folded(0, 1, 2, 5) && !is_folded(0, 1, 2, 6));
}

// The corners of the open points and the stored triangles tell the same.
bool is_storage_consistent(const Builder& builder)
{
  for (Point_index p : builder.open_points())
    for (const auto& corner : builder.corners(p)) {
      if (builder.is_removed(corner.triangle))
        return false;
      Builder::Triangle t = builder.triangle(corner.triangle);
      std::rotate(t.begin(), std::find(t.begin(), t.end(), p), t.end());
      if (t[0] != p || t[1] != corner.a || t[2] != corner.b || builder.find_triangle(p, t[2], t[1]) != corner.triangle)
        return false;
    }
  for (Builder::Triangle_index t = 0; t != builder.number_of_stored_triangles(); ++t)
    if (!builder.is_removed(t))
      for (std::size_t i = 0; i != 3; ++i) {
        const Builder::Triangle& v = builder.triangle(t);
        if (builder.is_open(v[i]) && builder.find_triangle(v[i], v[(i + 1) % 3], v[(i + 2) % 3]) != t)
          return false;
      }
  return true;
}

// Two strips face each other either way, once the triangle is gone and forgotten that has connected them.
void test_reset_orientations()
{
  for (std::size_t n : { 5u, 7u, 15u }) {
    begin_case("Moebius band of " + std::to_string(n) + " that is cut");
    Hand_surface s(points_in_general_position(n, 3));
    Triples triples = moebius_triples(n);
    const Triple cut = triples[n / 2], last = triples[n - 1];
    triples.pop_back();
    ISR_CHECK(s.add(triples));
    s.remove(cut[0], cut[1], cut[2]);
    ISR_CHECK(s.add(last[0], last[1], last[2]) == Triangle_verdict::NOT_ORIENTABLE);
    s.builder.reset_orientations(isr_internal::No_cancellation());
    ISR_CHECK(s.add(last[0], last[1], last[2]) == Triangle_verdict::ADDED);
    ISR_CHECK(validation::is_consistently_oriented(s.triangles()));
    ISR_CHECK(s.add(cut[0], cut[1], cut[2]) == Triangle_verdict::NOT_ORIENTABLE);
    ISR_CHECK(is_storage_consistent(s.builder));
  }
  begin_case("orientations of closed and open points");
  const Mesh mesh = globe(5, 8);
  Hand_surface s(mesh.points, links_of(mesh.points.size(), mesh.triples));
  s.remove(mesh.triples[20][0], mesh.triples[20][1], mesh.triples[20][2]);
  for (int round = 0; round != 2; ++round) {
    s.builder.reset_orientations(isr_internal::No_cancellation());
    const Triples after = s.triangles();
    ISR_CHECK_EQUAL(after.size(), mesh.triples.size() - 1);
    ISR_CHECK(validation::is_consistently_oriented(after));
    std::set<isr_internal::Parity_union_find::Element> parts;
    s.builder.for_each_triangle([&](const Builder::Triangle&, isr_internal::Parity_union_find::Element e) {
      parts.insert(s.builder.orientations().find(e).root);
    });
    ISR_CHECK_EQUAL(parts.size(), 1u);
    // Points that are opened now take over how their stars face.
    s.builder.open(s.indices[mesh.triples[3][0]]);
  }
}

void test_open_and_remove()
{
  begin_case("opening and removing");
  const Mesh mesh = globe(7, 9);
  Hand_surface s(mesh.points, links_of(mesh.points.size(), mesh.triples));
  const Triples all = canonical(s.triangles());
  Random random(4);
  const std::vector<std::size_t> order = random_order(mesh.points.size(), 5);
  for (std::size_t i = 0; i != order.size(); ++i) {
    s.builder.open(s.indices[order[i]]);
    s.builder.open(s.indices[order[i]]); // nothing to do
    ISR_CHECK_EQUAL(s.builder.open_points().size(), i + 1);
    ISR_CHECK(canonical(s.triangles()) == all);
    ISR_CHECK(is_storage_consistent(s.builder));
  }
  ISR_CHECK_EQUAL(s.builder.number_of_stored_triangles(), all.size());

  begin_case("removing from closed points");
  Hand_surface r(mesh.points, links_of(mesh.points.size(), mesh.triples));
  Triples left = canonical(r.triangles());
  while (!left.empty()) {
    const std::size_t i = random.below(left.size());
    const Triple t = left[i];
    r.remove(t[1], t[0], t[2]);
    left.erase(left.begin() + std::ptrdiff_t(i));
    ISR_CHECK(canonical(r.triangles()) == left);
    ISR_CHECK(is_storage_consistent(r.builder));
    if (random.below(3) == 0) { // and back, either way round
      ISR_CHECK(r.add(t[0], t[2], t[1]) == Triangle_verdict::ADDED);
      left = canonical(r.triangles());
      ISR_CHECK(std::count(left.begin(), left.end(), canonical({ t })[0]) +
                  std::count(left.begin(), left.end(), canonical(turned({ t }))[0]) ==
                1);
      if (!validation::is_consistently_oriented(left))
        ISR_CHECK(!"orientation");
    }
  }

  // Some triangles come back in another order: all is as before, and none has another number.
  begin_case("restoring");
  Hand_surface u(mesh.points, links_of(mesh.points.size(), mesh.triples));
  for (int round = 0; round != 20; ++round) {
    std::vector<Builder::Removed_triangle> removed;
    for (int i = 0; i != 9; ++i) {
      const Triples present = u.triangles();
      const Triple t = present[random.below(present.size())];
      u.builder.open(u.indices[t[0]]);
      const auto index = u.builder.find_triangle(u.indices[t[0]], u.indices[t[1]], u.indices[t[2]]);
      removed.push_back(u.builder.remove(index));
      ISR_CHECK_EQUAL(removed.back().index, index);
      ISR_CHECK(u.builder.is_removed(index));
    }
    ISR_CHECK_EQUAL(u.triangles().size(), all.size() - 9);
    const std::size_t stored = u.builder.number_of_stored_triangles();
    std::rotate(removed.begin(), removed.begin() + 4, removed.end());
    for (const Builder::Removed_triangle& t : removed) {
      u.builder.restore(t);
      ISR_CHECK(u.builder.triangle(t.index) == t.vertices);
    }
    ISR_CHECK_EQUAL(u.builder.number_of_stored_triangles(), stored);
    ISR_CHECK(canonical(u.triangles()) == all);
    ISR_CHECK(is_storage_consistent(u.builder));
    ISR_CHECK(std::all_of(u.builder.open_points().begin(), u.builder.open_points().end(),
                          [&](Point_index p) { return u.builder.is_fan_closed(p); }));
  }
}

// At every vertex at most one fan, if one is closed, by definition.
bool are_closed_fans_alone(const Triples& triples)
{
  validation::Disjoint_sets fans = validation::fans_of_corners(triples);
  std::map<std::size_t, std::set<std::size_t> > fans_at, open_fans_at;
  std::map<std::size_t, std::size_t> first_corner;
  for (std::size_t c = 0; c != 3 * triples.size(); ++c)
    fans_at[triples[c / 3][c % 3]].insert(fans.find(c));
  validation::for_each_edge(validation::sorted_sides(triples), [&](auto begin, auto end) {
    if (end - begin == 1)
      for (std::size_t v : begin->vertices)
        for (std::size_t i = 0; i != 3; ++i)
          if (triples[begin->triangle][i] == v)
            open_fans_at[v].insert(fans.find(3 * begin->triangle + i));
  });
  for (const auto& entry : fans_at)
    if (entry.second.size() > 1 && open_fans_at[entry.first].size() != entry.second.size())
      return false;
  return true;
}

void test_random_triangles()
{
  for (std::uint64_t seed = 1; seed != 5; ++seed) {
    begin_case("random triangles, seed " + std::to_string(seed));
    const std::size_t n = 6 + 2 * seed;
    const Points points = points_in_general_position(n, seed);
    Hand_surface s(points);
    Random random(seed);
    std::map<Triangle_verdict, std::size_t> verdicts;
    for (std::size_t step = 0; step != 1200; ++step) {
      const Triples before = s.triangles();
      if (!before.empty() && random.below(8) == 0) {
        const Triple t = before[random.below(before.size())];
        s.remove(t[0], t[1], t[2]);
        if (random.below(4) == 0)
          s.builder.reset_orientations(isr_internal::No_cancellation());
      } else {
        const std::size_t p = random.below(n), q = (p + 1 + random.below(n - 1)) % n;
        std::size_t r = random.below(n);
        while (r == p || r == q)
          r = random.below(n);
        const Triangle_verdict verdict = s.add(p, q, r);
        ++verdicts[verdict];
        ISR_CHECK_EQUAL(s.triangles().size(), before.size() + (verdict == Triangle_verdict::ADDED ? 1u : 0u));
      }
      const Triples after = s.triangles();
      ISR_CHECK(validation::are_indices_valid(after, n));
      ISR_CHECK(validation::is_edge_manifold(after));
      ISR_CHECK(validation::is_consistently_oriented(after));
      ISR_CHECK(are_closed_fans_alone(after));
    }
    ISR_CHECK(is_storage_consistent(s.builder));
    for (Triangle_verdict verdict :
         { Triangle_verdict::ADDED, Triangle_verdict::EDGE_FULL, Triangle_verdict::VERTEX_FULL,
           Triangle_verdict::DUPLICATE, Triangle_verdict::NOT_ORIENTABLE })
      ISR_CHECK(verdicts[verdict] != 0);
    // only fans stand between that and a manifold
    Hole_closing<Builder> close(s.cloud.positions(), s.builder, 0);
    close([](const Boundary_loop&) { return false; }, no_progress, [](const Builder::Triangle&, Triangle_verdict) {});
    ISR_CHECK(validation::is_oriented_manifold(points, s.triangles(), Kernel()));
    ISR_CHECK(!s.triangles().empty());
  }
}

// A fan of n triangles around point 0, attached in random order.
void test_many_triangles_at_a_vertex()
{
  const auto wheel = [](std::size_t n) {
    Points points(1, Point(0, 0, .1));
    for (std::size_t i = 0; i != n; ++i)
      points.push_back(on_circle(2. * PI * double(i) / double(n), 1., 0.));
    return points;
  };
  const auto spoke = [](std::size_t i, std::size_t n) { return Triple{ 0, 1 + i, 1 + (i + 1) % n }; };
  for (const std::size_t n : { 20u, 33u, 200u }) {
    begin_case("a fan of " + std::to_string(n) + " triangles");
    Hand_surface s(wheel(n));
    std::vector<bool> is_present(n, false);
    for (std::size_t i : random_order(n, n)) {
      ISR_CHECK(s.add({ spoke(i, n) }));
      is_present[i] = true;
      std::size_t size = 0, end = i;
      while (size != n && is_present[end]) {
        end = (end + 1) % n;
        ++size;
      }
      for (std::size_t begin = i; size != n && is_present[(begin + n - 1) % n]; ++size)
        begin = (begin + n - 1) % n;
      // from the end of the fan, since the search may go either way from within
      const Builder::Fan fan = s.builder.fan_from(s.indices[0], s.indices[1 + end]);
      ISR_CHECK_EQUAL(fan.size, size);
      const auto fans = std::size_t(std::count_if(is_present.begin(), is_present.end(), [](bool b) { return b; }));
      ISR_CHECK_EQUAL(s.builder.is_fan_closed(s.indices[0]), fans == n);
    }
    ISR_CHECK_EQUAL(s.builder.number_of_boundary_edges(s.indices[0]), 0u);
    ISR_CHECK(s.add(0, 1, 3) == Triangle_verdict::EDGE_FULL);
  }
  begin_case("too many triangles at a vertex");
  const std::size_t n = 2000;
  Hand_surface s(wheel(n));
  std::size_t added = 0;
  for (std::size_t i = 0; i != n; ++i) {
    const Triangle_verdict verdict = s.add(0, 1 + i, 1 + (i + 1) % n);
    ISR_CHECK(verdict == Triangle_verdict::ADDED || (verdict == Triangle_verdict::VERTEX_FULL && i >= 1024));
    added += verdict == Triangle_verdict::ADDED ? 1u : 0u;
  }
  ISR_CHECK_EQUAL(added, 1024u);
}

std::vector<Boundary_loop> loops_of(const Hand_surface& s)
{
  std::vector<Boundary_loop> loops = Boundary_loops<Builder>(s.cloud.positions(), s.builder)();
  for (Boundary_loop& loop : loops)
    for (Point_index& p : loop)
      p = static_cast<Point_index>(s.cloud.input_index(p));
  return loops;
}

std::vector<Point_index> sorted(Boundary_loop loop)
{
  std::sort(loop.begin(), loop.end());
  return loop;
}

void test_loops()
{
  begin_case("boundary loops");
  const Mesh closed = globe(4, 7);
  Hand_surface globe_surface(closed.points);
  ISR_CHECK(globe_surface.add(closed.triples));
  ISR_CHECK(loops_of(globe_surface).empty());

  const Mesh disc = sheet(5);
  Hand_surface disc_surface(disc.points);
  ISR_CHECK(disc_surface.add(disc.triples));
  const auto disc_loops = loops_of(disc_surface);
  ISR_CHECK_EQUAL(disc_loops.size(), 1u);
  ISR_CHECK_EQUAL(disc_loops[0].size(), 20u);
  const auto edges = validation::boundary_edges(disc.triples);
  for (std::size_t i = 0; i != 20; ++i) {
    const std::size_t p = disc_loops[0][i], q = disc_loops[0][(i + 1) % 20];
    ISR_CHECK(std::count(edges.begin(), edges.end(), std::array<std::size_t, 2>{ { p, q } }) +
                std::count(edges.begin(), edges.end(), std::array<std::size_t, 2>{ { q, p } }) ==
              1);
  }

  // the same from agreed stars that have a gap
  Hand_surface agreed(disc.points, links_of(disc.points.size(), disc.triples));
  const auto agreed_loops = loops_of(agreed);
  ISR_CHECK_EQUAL(agreed_loops.size(), 1u);
  ISR_CHECK(agreed_loops.size() == 1 && sorted(agreed_loops[0]) == sorted(disc_loops[0]));

  // short loops first
  const Mesh annulus = sheet(5, [](std::size_t i, std::size_t j) { return i == 2 && j == 2; });
  Hand_surface annulus_surface(annulus.points);
  ISR_CHECK(annulus_surface.add(annulus.triples));
  const auto annulus_loops = loops_of(annulus_surface);
  ISR_CHECK_EQUAL(annulus_loops.size(), 2u);
  ISR_CHECK(annulus_loops.size() == 2 && annulus_loops[0].size() == 4 && annulus_loops[1].size() == 20);
}

void test_loops_across_gaps()
{
  begin_case("loops across the gap between two fans");
  // a disc whose opposite wedges are missing: two squares that meet at the center
  const Mesh mesh = sheet(2, [](std::size_t i, std::size_t j) { return i == j; });
  Hand_surface s(mesh.points);
  ISR_CHECK(s.add(mesh.triples));
  const auto loops = loops_of(s);
  // the outline of each missing square needs its corner: the loops pass from square to square
  ISR_CHECK_EQUAL(loops.size(), 1u);
  ISR_CHECK(loops.size() == 1 && loops[0].size() == 8);
  if (loops.size() == 1 && loops[0].size() == 8) {
    const std::size_t center = 4;
    ISR_CHECK_EQUAL(std::count(loops[0].begin(), loops[0].end(), Point_index(center)), 2);
    // before and after the center: points of different squares
    for (std::size_t i = 0; i != 8; ++i)
      if (loops[0][i] == center) {
        const std::size_t before = loops[0][(i + 7) % 8], after = loops[0][(i + 1) % 8];
        ISR_CHECK((before == 1) + (before == 3) == 1 || (before == 5) + (before == 7) == 1);
        ISR_CHECK_EQUAL((before == 3 || before == 7), (after == 1 || after == 5));
        ISR_CHECK(before + after == 4 || before + after == 12);
      }
  }

  // an hourglass in a closed surface: two holes that touch at a point
  begin_case("two holes that touch");
  const Mesh holes = sheet(6, [](std::size_t i, std::size_t j) { return (i == 2 && j == 2) || (i == 3 && j == 3); });
  Hand_surface h(holes.points);
  ISR_CHECK(h.add(holes.triples));
  const auto hole_loops = loops_of(h);
  ISR_CHECK_EQUAL(hole_loops.size(), 3u);
  ISR_CHECK(hole_loops.size() == 3 && hole_loops[0].size() == 4 && hole_loops[1].size() == 4 &&
            hole_loops[2].size() == 24);
}

} // namespace

int main()
{
  test_verdicts();
  test_closed_fan_is_full();
  test_closed_point_is_full();
  test_not_orientable();
  test_reset_orientations();
  test_degenerate();
  test_folded();
  test_open_and_remove();
  test_random_triangles();
  test_many_triangles_at_a_vertex();
  test_loops();
  test_loops_across_gaps();
  return result();
}

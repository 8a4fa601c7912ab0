#include "isr_surface_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>

#include <array>
#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

using namespace isr_test;
using isr_internal::Parity_union_find;

namespace {

using View = Star_table::View;
constexpr Point_index GAP = NO_POINT;

// No triangle is degenerate, but those of the given vertices.
struct Known_predicates
{
  std::set<Point_index> collinear;
  bool is_degenerate(Point_index p, Point_index q, Point_index r) const
  {
    return collinear.count(p) + collinear.count(q) + collinear.count(r) == 3;
  }
};

Star_compatibility voted(const Star_table& stars, const Known_predicates& predicates = {})
{
  Star_compatibility result(stars);
  result.count_votes<CGAL::Sequential_tag>(predicates);
  result.orient();
  return result;
}

// Agreed triangles that the star of their smallest vertex reports, with the orientation of a star that ties them.
Triples agreed_triangles(Star_compatibility& compatibility)
{
  Triples result;
  for (Point_index p = 0; p != compatibility.stars().size(); ++p)
    compatibility.for_each_agreed_triangle(p, [&](Star_table::Slot s, Point_index, Point_index a, Point_index b) {
      if (p > a || p > b)
        return;
      const Star_compatibility::Tie tie = compatibility.tie(p, s);
      const bool is_flipped = compatibility.orientations().find(tie.star).is_flipped != tie.is_flipped;
      result.push_back(is_flipped ? Triple{ p, b, a } : Triple{ p, a, b });
    });
  return result;
}

// Turns stars over and rotates their links at random; that changes nothing.
Links disguised(Links links, std::uint64_t seed)
{
  Random random(seed);
  for (Link& link : links) {
    if (link.empty())
      continue;
    std::rotate(link.begin(), link.begin() + std::ptrdiff_t(random.below(link.size())), link.end());
    if (random.below(2) == 0)
      std::reverse(link.begin(), link.end());
  }
  return links;
}

void test_table()
{
  begin_case("star table");
  const Star_table stars = star_table({ { 1, 2, 3 }, { 0, 2 }, {}, { 4, GAP, 1, 2, GAP } });
  ISR_CHECK_EQUAL(stars.size(), 4u);
  ISR_CHECK_EQUAL(stars.number_of_slots(), 10u);
  ISR_CHECK(stars.begin(2) == stars.end(2) && stars.begin(3) == 5);
  ISR_CHECK_EQUAL(stars.next(0, 2), stars.begin(0));
  ISR_CHECK_EQUAL(stars.next(3, 9), stars.begin(3));
  ISR_CHECK_EQUAL(stars.neighbor(stars.next(3, 5)), GAP);
  for (Star_table::Slot s : { 0u, 1u, 2u })
    ISR_CHECK(stars.has_triangle(0, s));
  // a link of two is one triangle
  ISR_CHECK(stars.has_triangle(1, 3) && !stars.has_triangle(1, 4));
  for (Star_table::Slot s = 5; s != 10; ++s)
    ISR_CHECK_EQUAL(stars.has_triangle(3, s), s == 7);
  ISR_CHECK(!star_table({ { 7 } }).has_triangle(0, 0));

  ISR_CHECK(stars.view(0, 1, 2) == View::SAME_ORIENTATION);
  ISR_CHECK(stars.view(0, 3, 1) == View::SAME_ORIENTATION);
  ISR_CHECK(stars.view(0, 1, 3) == View::OPPOSITE_ORIENTATION);
  ISR_CHECK(stars.view(0, 2, 1) == View::OPPOSITE_ORIENTATION);
  ISR_CHECK(stars.view(0, 1, 4) == View::ABSENT);
  ISR_CHECK(stars.view(2, 0, 1) == View::ABSENT);
  ISR_CHECK(stars.view(3, 4, 1) == View::ABSENT); // across a gap
  ISR_CHECK(stars.view(3, 2, 1) == View::OPPOSITE_ORIENTATION);
  ISR_CHECK(stars.view(3, 2, 4) == View::ABSENT);
}

void test_table_of_blocks()
{
  begin_case("star table of several blocks");
  std::vector<Star_table::Block> blocks(3);
  blocks[0] = Star_table::Block{ { 2, 0 }, { 5, 6 } };
  blocks[2] = Star_table::Block{ { 1, 3 }, { 7, 1, 2, 3 } };
  const Star_table stars(std::move(blocks));
  ISR_CHECK_EQUAL(stars.size(), 4u);
  ISR_CHECK_EQUAL(stars.number_of_slots(), 6u);
  ISR_CHECK(stars.neighbor(stars.begin(2)) == 7 && stars.neighbor(stars.begin(3)) == 1);
  ISR_CHECK_EQUAL(star_table({}).size(), 0u);
}

void test_votes()
{
  begin_case("votes");
  // the triangle 0 1 2 in all stars, 0 2 3 in two of them, 0 3 1 in one
  const Star_table stars =
    star_table({ { 1, 2, 3 }, { 2, 0, GAP }, { 0, 1, GAP, 3 }, { 9, GAP }, {}, {}, {}, {}, {}, {} });
  Star_compatibility compatibility = voted(stars);
  ISR_CHECK_EQUAL(compatibility.votes(0), 3);
  ISR_CHECK_EQUAL(compatibility.votes(1), 2);
  ISR_CHECK_EQUAL(compatibility.votes(2), 1);
  ISR_CHECK_EQUAL(compatibility.votes(stars.begin(1)), 3);
  ISR_CHECK_EQUAL(compatibility.votes(stars.begin(1) + 1), 0);
  // point 1 is agreed, with a gap, and its triangle with it; 0 has conflicts
  ISR_CHECK(compatibility.is_point_agreed(1) && compatibility.is_point_on_boundary(1));
  ISR_CHECK(!compatibility.is_point_agreed(0) && !compatibility.is_point_agreed(2) &&
            !compatibility.is_point_agreed(3));
  ISR_CHECK(compatibility.is_triangle_agreed(0) && !compatibility.is_triangle_agreed(1));
  ISR_CHECK_EQUAL(compatibility.number_of_agreed_points(), 1u);
  ISR_CHECK(!compatibility.is_star_open(0) && compatibility.is_star_open(2) && compatibility.is_star_open(4));

  begin_case("a degenerate triangle gets no vote");
  Star_compatibility none = voted(stars, Known_predicates{ { 0, 1, 2 } });
  ISR_CHECK_EQUAL(none.votes(0), 0);
  ISR_CHECK_EQUAL(none.number_of_agreed_points(), 0u);
  ISR_CHECK(agreed_triangles(none).empty());
}

// Three votes are not enough if none of the three stars is agreed.
void test_votes_without_agreed_point()
{
  begin_case("three votes without an agreed point");
  const Star_table stars = star_table({ { 1, 2, 3 }, { 2, 0, 4 }, { 0, 1, 5 }, {}, {}, {} });
  Star_compatibility compatibility = voted(stars);
  ISR_CHECK_EQUAL(compatibility.votes(0), 3);
  ISR_CHECK(!compatibility.is_triangle_agreed(0));
}

void test_agreement_of_two()
{
  begin_case("links of two and of one gap");
  // without a gap, a link of two says nothing about the other side
  const Star_table closed = star_table({ { 1, 2 }, { 2, 0 }, { 0, 1 } });
  ISR_CHECK_EQUAL(voted(closed).number_of_agreed_points(), 0u);
  const Star_table open = star_table({ { 1, 2, GAP }, { 2, 0, GAP }, { 0, 1, GAP } });
  ISR_CHECK_EQUAL(voted(open).number_of_agreed_points(), 3u);
  // two gaps are two fans
  const Star_table fans =
    star_table({ { 1, 2, GAP, 3, 4, GAP }, { 2, 0, GAP }, { 0, 1, GAP }, { 4, 0, GAP }, { 0, 3, GAP } });
  Star_compatibility two = voted(fans);
  ISR_CHECK(!two.is_point_agreed(0) && two.is_point_on_boundary(1));
  ISR_CHECK_EQUAL(two.number_of_agreed_points(), 4u);
}

void test_surface(const Mesh& mesh, std::size_t open, const char* name)
{
  begin_case(name);
  for (std::uint64_t seed : { 1u, 2u, 3u }) {
    const Star_table stars = star_table(disguised(links_of(mesh.points.size(), mesh.triples), seed));
    Star_compatibility compatibility = voted(stars);
    ISR_CHECK_EQUAL(compatibility.number_of_agreed_points(), mesh.points.size());
    std::size_t on_boundary = 0;
    for (Point_index p = 0; p != stars.size(); ++p)
      on_boundary += compatibility.is_point_on_boundary(p) ? 1u : 0u;
    ISR_CHECK_EQUAL(on_boundary, open);
    const Triples found = agreed_triangles(compatibility);
    ISR_CHECK(canonical(found) == canonical(mesh.triples) || canonical(found) == canonical(turned(mesh.triples)));
  }
}

void test_spoilt_star()
{
  begin_case("a spoilt star");
  const Mesh mesh = globe(8, 12);
  Links links = links_of(mesh.points.size(), mesh.triples);
  const Point_index spoilt = 40;
  std::swap(links[spoilt][1], links[spoilt][2]);
  const Star_table stars = star_table(links);
  Star_compatibility compatibility = voted(stars);
  const std::set<Point_index> around(links[spoilt].begin(), links[spoilt].end());
  for (Point_index p = 0; p != stars.size(); ++p)
    if (p == spoilt)
      ISR_CHECK(!compatibility.is_point_agreed(p));
    else if (around.count(p) == 0)
      ISR_CHECK(compatibility.is_point_agreed(p));
  // what is agreed is part of the surface
  const Triples expected = canonical(mesh.triples);
  const Triples found = canonical(agreed_triangles(compatibility));
  ISR_CHECK(std::includes(expected.begin(), expected.end(), found.begin(), found.end()));
  ISR_CHECK(found.size() < expected.size() && found.size() + 6 >= expected.size());
}

// The star of a conflicting point may see parts of the surface the other way round, or parts of several surfaces.
void test_star_that_turns_a_fan()
{
  begin_case("a star that turns a fan");
  const Mesh mesh = globe(8, 12);
  Links links = links_of(mesh.points.size(), mesh.triples);
  const Link whole = links[40];
  ISR_CHECK_EQUAL(whole.size(), 6u);
  links[40] = { whole[0], whole[1], whole[2], GAP, whole[5], whole[4], whole[3], GAP };
  for (std::uint64_t seed : { 1u, 2u, 3u }) {
    const Star_table stars = star_table(disguised(links, seed));
    Star_compatibility compatibility = voted(stars);
    const Triples expected = canonical(mesh.triples), turned_over = canonical(turned(mesh.triples));
    const Triples found = canonical(agreed_triangles(compatibility));
    ISR_CHECK_EQUAL(found.size() + 2, expected.size());
    ISR_CHECK(std::includes(expected.begin(), expected.end(), found.begin(), found.end()) ||
              std::includes(turned_over.begin(), turned_over.end(), found.begin(), found.end()));
  }

  begin_case("a star that sees two surfaces");
  Links two = links_of(mesh.points.size(), mesh.triples);
  const auto n = static_cast<Point_index>(two.size());
  for (Point_index p = 0; p != n; ++p) {
    Link link = two[p];
    for (Point_index& q : link)
      q = q == 40 ? 40 : n + q;
    two.push_back(p == 40 ? Link() : link);
  }
  two[40] = { whole[0], whole[1], whole[2], GAP, n + whole[0], n + whole[1], n + whole[2], GAP };
  const Star_table stars = star_table(two);
  Star_compatibility compatibility = voted(stars);
  const auto root = [&](Point_index p) { return compatibility.orientations().find(p).root; };
  for (Point_index p = 0; p != n; ++p)
    if (p != 40) {
      ISR_CHECK(root(n + p) != root(whole[1]));
      if (compatibility.is_point_agreed(p))
        ISR_CHECK_EQUAL(root(p), root(whole[1]));
    }
}

void test_moebius_band()
{
  for (std::size_t n : { 5u, 7u, 21u }) {
    begin_case("Moebius band of " + std::to_string(n) + " triangles");
    Links links(n);
    for (std::size_t i = 0; i != n; ++i)
      for (std::size_t step : { n - 2, n - 1, std::size_t(1), std::size_t(2) })
        links[i].push_back(static_cast<Point_index>((i + step) % n));
    for (Link& link : links)
      link.push_back(GAP);
    for (std::uint64_t seed : { 1u, 2u, 3u }) {
      const Star_table stars = star_table(disguised(links, seed));
      Star_compatibility before(stars);
      before.count_votes<CGAL::Sequential_tag>(Known_predicates());
      ISR_CHECK_EQUAL(before.number_of_agreed_points(), n);
      Star_compatibility after = voted(stars);
      const Triples found = agreed_triangles(after);
      ISR_CHECK(found.size() < n && found.size() + 3 >= n);
      ISR_CHECK(after.number_of_agreed_points() < n);
      ISR_CHECK(validation::is_consistently_oriented(found));
      // a triangle that loses its agreement loses it in all three stars
      std::map<std::array<std::size_t, 3>, int> reports;
      for (Point_index p = 0; p != stars.size(); ++p)
        after.for_each_agreed_triangle(p, [&](Star_table::Slot, Point_index, Point_index a, Point_index b) {
          std::array<std::size_t, 3> t = { p, a, b };
          std::sort(t.begin(), t.end());
          ++reports[t];
        });
      for (const auto& report : reports)
        ISR_CHECK_EQUAL(report.second, 3);
    }
  }
}

// More than one block of points.
void test_parallel()
{
  begin_case("parallel");
  Mesh mesh = globe(100, 90);
  Links links = links_of(mesh.points.size(), mesh.triples);
  Random random(5);
  for (std::size_t i = 0; i != 300; ++i) {
    Link& link = links[random.below(links.size())];
    std::swap(link[0], link[random.below(link.size())]);
  }
  const Star_table stars = star_table(disguised(links, 4));
  Star_compatibility sequential(stars), parallel(stars);
  sequential.count_votes<CGAL::Sequential_tag>(Known_predicates());
  parallel.count_votes<CGAL::Parallel_if_available_tag>(Known_predicates());
  for (Star_table::Slot s = 0; s != stars.number_of_slots(); ++s)
    if (sequential.votes(s) != parallel.votes(s) || sequential.is_triangle_agreed(s) != parallel.is_triangle_agreed(s))
      ISR_CHECK(!"slots differ");
  for (Point_index p = 0; p != stars.size(); ++p)
    if (sequential.is_point_agreed(p) != parallel.is_point_agreed(p))
      ISR_CHECK(!"points differ");
  ISR_CHECK(sequential.number_of_agreed_points() < stars.size());
  ISR_CHECK(sequential.number_of_agreed_points() > stars.size() / 2);
}

// Breadth first search on the accepted ties is the definition.
void test_parity_union_find()
{
  begin_case("parity union find");
  for (std::uint64_t seed = 0; seed != 40; ++seed) {
    Random random(seed);
    const std::size_t n = 3 + random.below(30);
    Parity_union_find sets(n / 2);
    for (std::size_t i = n / 2; i != n; ++i)
      ISR_CHECK_EQUAL(std::size_t(sets.add()), i);
    std::vector<std::vector<std::pair<std::size_t, bool> > > ties(n);
    const auto search = [&](std::size_t from) { // 0, 1: parity; 2: not connected
      std::vector<int> parity(n, 2);
      std::queue<std::size_t> queue;
      parity[from] = 0;
      for (queue.push(from); !queue.empty(); queue.pop())
        for (const auto& tie : ties[queue.front()])
          if (parity[tie.first] == 2) {
            parity[tie.first] = parity[queue.front()] ^ (tie.second ? 1 : 0);
            queue.push(tie.first);
          }
      return parity;
    };
    for (std::size_t step = 0; step != 2 * n; ++step) {
      const std::size_t a = random.below(n), b = random.below(n);
      const bool is_flipped = random.below(2) == 0;
      const int before = search(a)[b];
      const bool is_possible = before == 2 || (before == 1) == is_flipped;
      ISR_CHECK_EQUAL(sets.unite(static_cast<Point_index>(a), static_cast<Point_index>(b), is_flipped), is_possible);
      if (is_possible) {
        ties[a].emplace_back(b, is_flipped);
        ties[b].emplace_back(a, is_flipped);
      }
    }
    for (std::size_t a = 0; a != n; ++a) {
      const std::vector<int> parity = search(a);
      const auto unchanged = static_cast<const Parity_union_find&>(sets).find(static_cast<Point_index>(a));
      const auto root = sets.find(static_cast<Point_index>(a));
      ISR_CHECK(unchanged.root == root.root && unchanged.is_flipped == root.is_flipped);
      for (std::size_t b = 0; b != n; ++b) {
        const auto other = sets.find(static_cast<Point_index>(b));
        ISR_CHECK_EQUAL(other.root == root.root, parity[b] != 2);
        if (parity[b] != 2)
          ISR_CHECK_EQUAL(other.is_flipped != root.is_flipped, parity[b] == 1);
      }
      ISR_CHECK(sets.find(root.root).root == root.root && !sets.find(root.root).is_flipped);
    }
  }
}

} // namespace

int main()
{
  test_table();
  test_table_of_blocks();
  test_votes();
  test_votes_without_agreed_point();
  test_agreement_of_two();
  test_surface(globe(6, 9), 0, "closed surface");
  test_surface(sheet(6), 24, "surface with boundary");
  test_spoilt_star();
  test_star_that_turns_a_fan();
  test_moebius_band();
  test_parallel();
  test_parity_union_find();
  return result();
}

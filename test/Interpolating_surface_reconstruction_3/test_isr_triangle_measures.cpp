#include "isr_stage_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/triangle_measures.h>

#include <iostream>

using namespace isr_stage_test;
using namespace ISR::internal;

const double DEGREE = std::acos(-1.) / 180.;

bool is_near(double a, double b) { return std::abs(a - b) < 1e-12; }

void test_regularity()
{
  const Local_point o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), equilateral(.5, std::sqrt(.75), 0);
  assert(is_near(regularity(o, x, equilateral), 1.5));
  assert(is_near(regularity(o, x, y), std::sqrt(2.)));
  assert(is_near(regularity(o, x, Local_point(3, 0, 0)), 1.));
  assert(is_near(regularity(o, o, y), 1.));
  assert(regularity(x, x, x) == 0.);
  // as vectors from an origin
  assert(is_near(regularity(x - o, y - o, o - o), std::sqrt(2.)));

  Random random(1);
  for (int i = 0; i != 1000; ++i) {
    const double a = random(0, 180), b = random(0, 180 - a);
    const double sa = std::sin(a * DEGREE), sb = std::sin(b * DEGREE), sc = std::sin((a + b) * DEGREE);
    // law of sines: the side ab is sc long, the side at a with angle a is sb long
    const Local_point p(0, 0, 1), q(sc, 0, 1), r(sb * std::cos(a * DEGREE), sb * sa, 1);
    const double expected = std::cos(a * DEGREE) + std::cos(b * DEGREE) - std::cos((a + b) * DEGREE);
    const double result = regularity(p, q, r);
    assert(std::abs(result - expected) < 1e-7);
    assert(result <= 1.5 + 1e-12 && result >= 1. - 1e-12);
    assert(is_near(result, regularity(q, r, p)) && is_near(result, regularity(r, q, p)));
  }
}

void test_small_triangles()
{
  for (double s : { 1e-100, 1e-150, 1e-200, 0. }) {
    const Local_point o(0, 0, 0), x(s, 0, 0), y(0, s, 0);
    assert(std::isfinite(regularity(o, x, y)));
    assert(std::isfinite(cosine_of_supplementary_angle(o, x, y, Local_point(0, 0, s))));
    assert(is_first_more_regular(o, x, y, y));
  }
  assert(
    is_near(regularity(Local_point(0, 0, 0), Local_point(1e-100, 0, 0), Local_point(0, 1e-100, 0)), std::sqrt(2.)));
}

// Fig. 3.2: the candidate next to A wins in (a), the one next to B in (b); the order of the two
// candidates and of the ends of the edge does not matter.
void test_relative_regularity()
{
  const Local_point a(0, 0, 0), b(1, 0, 0);
  const Local_point next_to_a(.3, .8, 0), next_to_b(1.5, 1.3, 0);
  // brute force over both diagonals
  const double with_first = (std::min)(regularity(a, b, next_to_a), regularity(b, next_to_a, next_to_b));
  const double with_second = (std::min)(regularity(a, b, next_to_b), regularity(a, next_to_a, next_to_b));
  assert(with_first > with_second);
  assert(is_first_more_regular(a, b, next_to_a, next_to_b));
  assert(!is_first_more_regular(a, b, next_to_b, next_to_a));
  assert(is_first_more_regular(b, a, next_to_a, next_to_b));
  assert(!is_first_more_regular(b, a, next_to_b, next_to_a));

  Random random(2);
  int compared = 0;
  for (int i = 0; i != 1000; ++i) {
    const Local_point p(random(-1, .4), random(.3, 1), random(-.2, .2)),
      q(random(.6, 2), random(.3, 1), random(-.2, .2));
    // one next to a, the other next to b: the star decides the other case before
    if (cosine(b - a, p - a) >= cosine(b - a, q - a) || cosine(a - b, q - b) >= cosine(a - b, p - b))
      continue;
    ++compared;
    const bool expected =
      (std::min)(regularity(a, b, p), regularity(b, p, q)) >= (std::min)(regularity(a, b, q), regularity(a, p, q));
    assert(is_first_more_regular(a, b, p, q) == expected);
    assert(is_first_more_regular(b, a, p, q) == expected);
  }
  assert(compared > 500);
  // a mirrored pair is a tie: the first stays
  const Local_point left(0, 1, 0), right(1, 1, 0);
  assert(is_first_more_regular(a, b, left, right) && is_first_more_regular(a, b, right, left));
}

void test_supplementary_angle()
{
  const Local_point a(0, 0, 0), b(1, 0, 0), c(.5, 1, 0);
  for (int angle = 0; angle <= 180; angle += 5) {
    const Local_point d(.3, -std::cos(angle * DEGREE), std::sin(angle * DEGREE));
    const double expected = std::cos(angle * DEGREE);
    assert(is_near(cosine_of_supplementary_angle(a, b, c, d), expected));
    assert(is_near(cosine_of_supplementary_angle(b, a, d, c), cosine_of_supplementary_angle(a, b, c, d)));
    assert(is_near(cosine_of_supplementary_angle(a, b, d, c), expected));
  }
  assert(cosine_of_supplementary_angle(a, b, c, Local_point(2, 0, 0)) == -1.);
  assert(cosine_of_supplementary_angle(a, a, c, b) == -1.);
}

void test_planarity_degree()
{
  const Local_vector center(0, 0, 0);
  for (double height : { 0., .1, .5, 1. }) {
    std::vector<Local_vector> ring;
    for (int i = 0; i != 6; ++i)
      ring.emplace_back(std::cos(60. * i * DEGREE), std::sin(60. * i * DEGREE), height);
    const auto position = [&](std::uint32_t i) { return ring[i]; };
    double expected = 1.;
    for (std::size_t i = 0; i != 6; ++i) {
      const Local_vector n = CGAL::cross_product(ring[i], ring[(i + 1) % 6]),
                         m = CGAL::cross_product(ring[(i + 1) % 6], ring[(i + 2) % 6]);
      expected = (std::min)(expected, n * m / std::sqrt(n.squared_length() * m.squared_length()));
    }
    const std::vector<std::uint32_t> closed = { 0, 1, 2, 3, 4, 5 }, open = { GAP, 0, 1, 2 }, rotated = { 1, 2, GAP, 0 };
    assert(is_near(planarity_degree(center, closed, position), expected));
    assert(is_near(planarity_degree(center, open, position), expected));
    assert(is_near(planarity_degree(center, rotated, position), expected));
    // one bad pair decides
    ring[3] = Local_vector(-1, 0, 5);
    assert(planarity_degree(center, closed, position) < expected);
    assert(is_near(planarity_degree(center, open, position), expected));
  }
  const auto axis = [](std::uint32_t i) { return i == 0 ? Local_vector(1, 0, 0) : Local_vector(0, 1, 0); };
  assert(planarity_degree(center, std::vector<std::uint32_t>{ 0, 1, GAP }, axis) == -1.);
  assert(planarity_degree(center, std::vector<std::uint32_t>{ 0, 1 }, axis) == -1.);
  assert(planarity_degree(center, std::vector<std::uint32_t>{ GAP }, axis) == -1.);
  assert(planarity_degree(center, std::vector<std::uint32_t>{}, axis) == -1.);
}

void test_minimum_planarity()
{
  for (int a = 0; a <= 180; a += 4)
    for (int b = 1; b <= 180; b += 4)
      for (int c = 2; c <= 180; c += 4) {
        if (a + b == 90 || b + c == 90 || c + a == 90)
          continue; // a matter of rounding
        const bool expected = a + b < 90 && b + c < 90 && c + a < 90;
        assert(fulfils_minimum_planarity(std::cos(a * DEGREE), std::cos(b * DEGREE), std::cos(c * DEGREE)) == expected);
      }
  assert(fulfils_minimum_planarity(1., 1., 1.));
  assert(!fulfils_minimum_planarity(0., 1., 1.));
  assert(fulfils_minimum_planarity(std::cos(89. * DEGREE), MISSING_NEIGHBOR_COSINE, MISSING_NEIGHBOR_COSINE));
  assert(!fulfils_minimum_planarity(std::cos(91. * DEGREE), MISSING_NEIGHBOR_COSINE, MISSING_NEIGHBOR_COSINE));
  assert(!fulfils_minimum_planarity(-1., 1., 1.));
}

int main()
{
  test_regularity();
  test_small_triangles();
  test_relative_regularity();
  test_supplementary_angle();
  test_planarity_degree();
  test_minimum_planarity();
  std::cout << "done" << std::endl;
  return 0;
}

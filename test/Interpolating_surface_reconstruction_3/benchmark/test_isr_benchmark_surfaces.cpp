// The generated models of the benchmark: samples are on the surface, and distances are exact.

#undef NDEBUG

#include "models/Double_torus.h"
#include "models/noise.h"
#include "models/Polyhedron.h"
#include "models/sampling.h"
#include "models/Sphere.h"
#include "models/Tube.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

using namespace isr_benchmark;

void check_sample(const Surface& surface, std::size_t n)
{
  const std::vector<Point> points = sample(surface, n, 1);
  assert(points.size() > n * 8 / 10 && points.size() < n * 13 / 10);
  for (const Point& p : points)
    assert(surface.distance(p) < 1e-9);
  const double spacing = std::sqrt(surface.area() / double(n));
  for (std::size_t i = 0; i != points.size(); ++i)
    for (std::size_t j = 0; j != i; ++j)
      assert(CGAL::squared_distance(points[i], points[j]) > 0.5 * spacing * spacing);
  assert(sample(surface, n, 1) == points);
  assert(sample(surface, n, 2) != points);
}

// The distance to many points of the surface is a bound from above, and not far above.
void check_distances(const Surface& surface, double offset)
{
  CGAL::Random random(7);
  const std::vector<Point> points = surface.random_points(20000, random);
  const double slack = 4. * std::sqrt(surface.area() / 20000.);
  for (const Point& q : surface.random_points(50, random)) {
    const Point p = q + Vector(random.get_double(-offset, offset), random.get_double(-offset, offset),
                               random.get_double(-offset, offset));
    double bound = std::numeric_limits<double>::infinity();
    for (const Point& r : points)
      bound = (std::min)(bound, std::sqrt(CGAL::squared_distance(p, r)));
    assert(surface.distance(p) <= bound * (1 + 1e-9));
    assert(bound <= std::sqrt(surface.distance(p) * surface.distance(p) + slack * slack) + slack * slack);
  }
}

void check(const Surface& surface, double offset)
{
  check_sample(surface, 1000);
  check_distances(surface, offset);
}

// Every coordinate moves by up to the share of the mean edge, which is 4 / 3 here, and some by almost as much.
void check_noise()
{
  Model model;
  for (int i = 0; i != 100; ++i) {
    const std::size_t n = model.points.size();
    model.triangles.push_back(Triangle{ { n, n + 1, n + 2 } });
    for (const Point& p : { Point(0., 0., i), Point(1., 0., i), Point(0., 4. / 3., i) })
      model.points.push_back(p);
  }
  assert(std::abs(mean_edge_length(model) - 4. / 3.) < 1e-12);
  Model moved = model, again = model, other = model, same = model;
  add_noise(moved, .3, 1);
  add_noise(again, .3, 1);
  add_noise(other, .3, 2);
  add_noise(same, 0., 1);
  assert(moved.points == again.points && moved.points != other.points);
  assert(moved.triangles == model.triangles && same.points == model.points);
  double most = 0.;
  for (std::size_t i = 0; i != model.points.size(); ++i)
    for (int axis = 0; axis != 3; ++axis)
      most = (std::max)(most, std::abs(moved.points[i][axis] - model.points[i][axis]));
  assert(most <= .4 && most > .39);
}

int main()
{
  check_noise();
  check(Sphere(), 0.3);
  check(Tube(trefoil, 0.4), 0.2);
  check(Tube(figure_eight_knot, 0.35), 0.15);
  check(Double_torus(), 0.03);
  Polyhedron box;
  box.add_box(Point(0, 0, 0), Point(1, 1, 1));
  check(box, 0.3);
  assert(std::abs(box.area() - 6.) < 1e-12);
  assert(box.distance(Point(0.5, 0.5, 1.25)) == 0.25);
  // known areas: a sphere, and a tube by the length of its center curve
  assert(std::abs(Sphere().area() - 4. * CGAL_PI) < 1e-12);
  const Tube torus(
    [](double t) {
      return std::array<Vector, 3>{ Vector(2. * std::cos(t), 2. * std::sin(t), 0.),
                                    Vector(-2. * std::sin(t), 2. * std::cos(t), 0.),
                                    Vector(-2. * std::cos(t), -2. * std::sin(t), 0.) };
    },
    0.5);
  assert(std::abs(torus.area() - 4. * CGAL_PI * CGAL_PI) < 1e-9);
  assert(std::abs(torus.distance(Point(3., 0., 0.)) - 0.5) < 1e-12);
  check(torus, 0.3);
  return 0;
}

// Draws the figures of the manual that come from the algorithms: isr_figures OUTPUT_FOLDER

#include "Svg_picture.h"

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Linear_implicit_function_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Regularity_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>
#include <CGAL/Interpolating_surface_reconstruction_3/linear_implicit_weights.h>
#include <CGAL/ctc_reconstruction.h>
#include <CGAL/lis_reconstruction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace isr = CGAL::Interpolating_surface_reconstruction_3;
namespace params = CGAL::parameters;

namespace {

// A grid with random offsets, seen from above; `height(x, y)` is the third coordinate.
template <typename Height>
Points jittered_terrain(int n, double jitter, const Height& height)
{
  std::mt19937 random(7);
  const auto offset = [&] { return jitter * (double(random()) / double(std::mt19937::max()) - .5); };
  Points points;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double x = (2. * i + offset()) / n - 1., y = (2. * j + offset()) / n - 1.;
      points.emplace_back(x, y, height(x, y));
    }
  return points;
}

Point_2 from_above(const Point_3& p) { return Point_2(p.x(), p.y()); }

// The star of a point, by the public interface alone: positions of its neighbors, or `GAP`.
std::vector<std::size_t> star(const Points& points, std::size_t center, std::size_t gap)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i != points.size(); ++i)
    if (i != center)
      order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return CGAL::compare_distance_to_point(points[center], points[a], points[b]) == CGAL::SMALLER;
  });
  std::vector<isr::Star_neighborhood::Vector_3> offsets;
  for (std::size_t i : order) {
    const Vector_3 v = points[i] - points[center];
    offsets.emplace_back(v.x(), v.y(), v.z());
  }
  isr::Point_star result;
  isr::Restricted_voronoi_star_3()(
    isr::Star_neighborhood(offsets.data(), offsets.size(), std::numeric_limits<double>::infinity()), result);
  std::vector<std::size_t> link;
  for (std::uint32_t i : result.link)
    link.push_back(i == isr::Point_star::GAP ? gap : order[i]);
  return link;
}

// A star with the cell whose sides it has; the polygon of a plane has the circumcenters as its corners.
void draw_star(const Points& points, std::size_t center, Picture& picture)
{
  const std::vector<std::size_t> link = star(points, center, points.size());
  const Point_2 p = from_above(points[center]);
  std::vector<Point_2> cell;
  for (std::size_t i = 0; i != link.size(); ++i) {
    const Point_2 a = from_above(points[link[i]]), b = from_above(points[link[(i + 1) % link.size()]]);
    picture.polygon({ p, a, b }, "#dbe7f5", "#345", 1.2);
    cell.push_back(CGAL::circumcenter(p, a, b));
  }
  picture.polygon(cell, "none", "#c40", 2.);
  for (std::size_t i : link)
    picture.line(p, from_above(points[i]), "#345", 1.2);
  for (const Point_3& q : points)
    picture.dot(from_above(q), 3., "#777");
  for (std::size_t i : link)
    picture.dot(from_above(points[i]), 4., "#036");
  picture.dot(p, 5., "#c40");
}

// All triangles of all stars, by the number of stars that have them; those of one vote are below.
void draw_votes(const Points& points, Picture& picture)
{
  std::map<Triangle, std::size_t> votes;
  for (std::size_t p = 0; p != points.size(); ++p) {
    const std::vector<std::size_t> link = star(points, p, points.size());
    for (std::size_t i = 0; i != link.size(); ++i) {
      Triangle t{ { p, link[i], link[(i + 1) % link.size()] } };
      std::sort(t.begin(), t.end());
      if (t[2] != points.size())
        ++votes[t];
    }
  }
  const std::array<const char*, 4> fill{ { "", "#f2c14e", "#f78154", "#dbe7f5" } };
  for (const std::size_t count : { 3u, 2u, 1u })
    for (const auto& t : votes)
      if (t.second == count)
        picture.polygon(
          { from_above(points[t.first[0]]), from_above(points[t.first[1]]), from_above(points[t.first[2]]) },
          fill[count]);
  for (const Point_3& p : points)
    picture.dot(from_above(p), 1.6, "#333");
}

void stars_and_votes(const std::string& folder)
{
  Picture picture(2);
  draw_star(jittered_terrain(6, .9, [](double, double) { return 0.; }), 24, picture);
  picture.select_panel(1);
  draw_votes(jittered_terrain(16, .9, [](double x, double y) { return x + .4 * y > .1 ? .3 : 0.; }), picture);
  picture.save(folder + "/stars.svg");
}

// Blue inside, orange outside, the darker the farther.
std::string color_of(double value, double step)
{
  const int level = (std::min)(5, static_cast<int>(std::abs(value) / step));
  const int dark = 245 - 22 * level, middle = 248 - 12 * level;
  std::ostringstream result;
  if (value < 0.)
    result << "rgb(" << dark << ',' << middle << ",255)";
  else
    result << "rgb(255," << middle << ',' << dark << ')';
  return result.str();
}

using Sample = std::pair<Point_3, Vector_3>;
using Outline = std::vector<std::array<double, 2> >;

auto sample_maps()
{
  return params::point_map(CGAL::First_of_pair_property_map<Sample>())
    .normal_map(CGAL::Second_of_pair_property_map<Sample>());
}

// Samples of an outline in the plane y = 0 that is extruded along y, with outward normals.
std::vector<Sample> extruded(const Outline& outline, double spacing, int rows)
{
  std::vector<Sample> samples;
  for (std::size_t side = 0; side != outline.size(); ++side) {
    const auto& a = outline[side];
    const auto& b = outline[(side + 1) % outline.size()];
    const double dx = b[0] - a[0], dz = b[1] - a[1];
    const int steps = static_cast<int>(std::lround(std::hypot(dx, dz) / spacing));
    for (int i = 0; i != steps; ++i)
      for (int j = -rows; j <= rows; ++j) {
        const double t = (i + .5) / steps;
        samples.emplace_back(Point_3(a[0] + t * dx, spacing * j, a[1] + t * dz), Vector_3(dz, 0, -dx));
      }
  }
  return samples;
}

// Two arms, `gap` apart.
Outline bracket(double gap)
{
  return { { { -.8, -.5 } },      { { .8, -.5 } },      { { .8, -.3 } }, { { -.5, -.3 } },
           { { -.5, gap - .3 } }, { { .8, gap - .3 } }, { { .8, .5 } },  { { -.8, .5 } } };
}

// The function of the samples in the plane y = 0, and the samples there.
template <typename Weight>
void draw_slice(const std::vector<Sample>& samples, double color_step, Picture& picture)
{
  const isr::Linear_implicit_function_3<Kernel, Weight> function(samples, sample_maps());
  constexpr int CELLS = 110;
  const auto coordinate = [](int i) { return 2. * i / CELLS - 1.; };
  for (int j = 0; j != CELLS; ++j) // runs of one color
    for (int begin = 0, end = 0; begin != CELLS; begin = end) {
      const auto color = [&](int i) {
        return color_of(function(Point_3(coordinate(i) + 1. / CELLS, 0, coordinate(j) + 1. / CELLS)), color_step);
      };
      const std::string fill = color(begin);
      while (end != CELLS && color(end) == fill)
        ++end;
      picture.polygon({ Point_2(coordinate(begin), coordinate(j)), Point_2(coordinate(end), coordinate(j)),
                        Point_2(coordinate(end), coordinate(j + 1)), Point_2(coordinate(begin), coordinate(j + 1)) },
                      fill, fill, .3);
    }
  for (const Sample& s : samples)
    if (s.first.y() == 0.) {
      const Vector_3 n = s.second / std::sqrt(s.second.squared_length());
      const Point_2 p(s.first.x(), s.first.z());
      picture.line(p, Point_2(p.x() + .07 * n.x(), p.y() + .07 * n.z()), "#333", 1.);
      picture.dot(p, 2.2, "#333");
    }
}

void implicit_slice(const std::string& folder)
{
  Picture picture(1);
  draw_slice<isr::Interpolating_weight>(extruded(bracket(.3), .1, 6), .06, picture);
  picture.save(folder + "/implicit.svg");
}

// Two arms that are half a spacing apart: the weight of the thesis, and the default.
void weights(const std::string& folder)
{
  const std::vector<Sample> samples = extruded(bracket(.05), .1, 6);
  Picture picture(2);
  draw_slice<isr::Quadratic_weight>(samples, .008, picture);
  picture.select_panel(1);
  draw_slice<isr::Interpolating_weight>(samples, .008, picture);
  picture.save(folder + "/weights.svg");
}

// n points of the unit sphere, on a spiral.
Points spiral(std::size_t n)
{
  constexpr double GOLDEN_ANGLE = 2.399963229728653;
  Points points;
  for (std::size_t k = 0; k != n; ++k) {
    const double i = double(k), z = 1. - (2. * i + 1.) / double(n), r = std::sqrt(1. - z * z);
    points.emplace_back(r * std::cos(i * GOLDEN_ANGLE), r * std::sin(i * GOLDEN_ANGLE), z);
  }
  return points;
}

Points scaled(Points points, double factor)
{
  for (Point_3& p : points)
    p = CGAL::ORIGIN + factor * (p - CGAL::ORIGIN);
  return points;
}

// With a small hole in the bottom.
Points bowl(std::size_t n)
{
  Points points = spiral(n);
  points.erase(std::remove_if(points.begin(), points.end(),
                              [](const Point_3& p) {
                                return p.z() >= .1 || CGAL::squared_distance(p, Point_3(.1, .35, -.93)) <= .05;
                              }),
               points.end());
  return points;
}

template <typename NamedParameters>
Triangles ctc(const Points& points, const NamedParameters& np)
{
  Triangles triangles;
  CGAL::ctc_reconstruction(points, std::back_inserter(triangles), np);
  return triangles;
}

// Closed by default, and with the rim kept.
void boundary_policy(const std::string& folder)
{
  const Points points = bowl(700);
  Picture picture(2);
  draw_surface(points, ctc(points, params::default_values()), picture);
  picture.select_panel(1);
  draw_surface(points, ctc(points, params::keep_boundaries(true)), picture);
  picture.save(folder + "/boundaries.svg");
}

// A bowl: the loop of its rim has more than 8 edges.
void hole_size(const std::string& folder)
{
  const Points points = bowl(400);
  Picture picture(2);
  draw_surface(points, ctc(points, params::default_values()), picture);
  picture.select_panel(1);
  draw_surface(points, ctc(points, params::maximum_hole_size(8)), picture);
  picture.save(folder + "/hole_size.svg");
}

// The halves of a ball, three spacings apart: neighbors without limit, and up to twice the spacing.
void neighbor_radius(const std::string& folder)
{
  Points points = scaled(spiral(500), .86);
  points.erase(std::remove_if(points.begin(), points.end(), [](const Point_3& p) { return std::abs(p.x()) < .2; }),
               points.end());
  Picture picture(2);
  draw_surface(points, ctc(points, params::default_values()), picture);
  picture.select_panel(1);
  draw_surface(points, ctc(points, params::neighbor_radius(.28)), picture);
  picture.save(folder + "/neighbor_radius.svg");
}

// Collects the triangles that come after those on which the stars agree.
struct Completed_triangles : isr::Default_visitor
{
  std::set<Triangle> triangles;

  static Triangle sorted(Triangle t)
  {
    std::sort(t.begin(), t.end());
    return t;
  }
  void on_triangle(const Triangle& t, isr::Triangle_verdict) { triangles.insert(sorted(t)); }
};

// Blue: triangles of agreed stars. Orange: triangles of the completion.
template <typename Stars>
void draw_agreement(const Points& points, const Stars& stars, Picture& picture)
{
  Completed_triangles completed;
  const Triangles triangles = ctc(points, params::star_construction(stars).visitor(std::ref(completed)));
  draw_surface(points, triangles, picture, [&](const Triangle& t, bool) {
    return completed.triangles.count(Completed_triangles::sorted(t)) == 0 ? BLUE : ORANGE;
  });
}

// A ball with waves and irregular samples.
void star_constructions(const std::string& folder)
{
  std::mt19937 random(7);
  const auto offset = [&] { return .12 * (double(random()) / double(std::mt19937::max()) - .5); };
  Points points;
  for (const Point_3& p : spiral(450)) {
    const Vector_3 v(p.x() + offset(), p.y() + offset(), p.z() + offset());
    const double radius = .72 + .2 * std::sin(7. * p.x()) * std::cos(7. * p.y());
    points.push_back(CGAL::ORIGIN + radius / std::sqrt(v.squared_length()) * v);
  }
  Picture picture(2);
  draw_agreement(points, isr::Restricted_voronoi_star_3(), picture);
  picture.select_panel(1);
  draw_agreement(points, isr::Regularity_star_3(), picture);
  picture.save(folder + "/star_construction.svg");
}

// LIS of samples with normals, in a panel.
template <typename NamedParameters>
void draw_lis(const std::vector<Sample>& samples, const NamedParameters& np, Picture& picture)
{
  Points vertices;
  Triangles triangles;
  CGAL::lis_reconstruction(samples, vertices, triangles, np);
  draw_surface(vertices, triangles, picture);
}

// A ball of few samples, and the vertices that LIS adds.
void grid_spacing(const std::string& folder)
{
  std::vector<Sample> samples;
  for (const Point_3& p : scaled(spiral(120), .86))
    samples.emplace_back(p, p - CGAL::ORIGIN);
  Picture picture(2);
  draw_lis(samples, sample_maps(), picture);
  picture.select_panel(1);
  draw_lis(samples, sample_maps().grid_spacing(.2), picture);
  picture.save(folder + "/grid_spacing.svg");
}

// CTC: a bowl that is oriented by its normals. LIS: arms one spacing apart, without normals and with them.
void normals(const std::string& folder)
{
  const Points points = bowl(500);
  Picture picture(4);
  std::size_t panel = 0;
  for (const double sign : { 1., -1. }) {
    std::vector<Vector_3> normals_of_points;
    for (const Point_3& p : points)
      normals_of_points.push_back(sign * (p - CGAL::ORIGIN));
    picture.select_panel(panel++);
    std::vector<Sample> samples;
    for (std::size_t i = 0; i != points.size(); ++i)
      samples.emplace_back(points[i], normals_of_points[i]);
    Triangles triangles;
    CGAL::ctc_reconstruction(samples, std::back_inserter(triangles),
                             params::combine(sample_maps(), params::keep_boundaries(true)));
    draw_surface(points, triangles, picture);
  }
  std::vector<Sample> samples = extruded(bracket(.1), .1, 4);
  for (Sample& s : samples) // the gap faces the viewer
    s = Sample(Point_3(s.first.x(), s.first.z(), s.first.y()), Vector_3(s.second.x(), s.second.z(), s.second.y()));
  picture.select_panel(2);
  draw_lis(samples, params::point_map(CGAL::First_of_pair_property_map<Sample>()), picture);
  picture.select_panel(3);
  draw_lis(samples, sample_maps(), picture);
  picture.save(folder + "/normals.svg");
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2) {
    std::cerr << "usage: isr_figures OUTPUT_FOLDER" << std::endl;
    return EXIT_FAILURE;
  }
  try {
    stars_and_votes(argv[1]);
    implicit_slice(argv[1]);
    boundary_policy(argv[1]);
    hole_size(argv[1]);
    neighbor_radius(argv[1]);
    star_constructions(argv[1]);
    grid_spacing(argv[1]);
    normals(argv[1]);
    weights(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

// Draws the figures of the manual that come from the algorithms: isr_figures OUTPUT_FOLDER

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Linear_implicit_function_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>
#include <CGAL/ctc_reconstruction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace isr = CGAL::Interpolating_surface_reconstruction_3;
namespace params = CGAL::parameters;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Points = std::vector<Point_3>;
using Triangle = std::array<std::size_t, 3>;
using Triangles = std::vector<Triangle>;

constexpr double PANEL = 280.;

// A picture of panels of the size PANEL, one beside the other; coordinates of a panel are from -1 to 1.
class Picture
{
public:
  explicit Picture(std::size_t panels) : m_panels(panels)
  {
    m_body.precision(1);
    m_body.setf(std::ios::fixed);
  }

  void select_panel(std::size_t panel) { m_panel = panel; }

  void polygon(const std::vector<Point_2>& points, const std::string& fill, const std::string& stroke = "#333",
               double width = .6)
  {
    m_body << "<polygon points=\"";
    for (const Point_2& p : points)
      m_body << x(p) << ',' << y(p) << ' ';
    m_body << "\" fill=\"" << fill << "\" stroke=\"" << stroke << "\" stroke-width=\"" << width << "\"/>\n";
  }

  void line(const Point_2& p, const Point_2& q, const std::string& stroke, double width)
  {
    m_body << "<line x1=\"" << x(p) << "\" y1=\"" << y(p) << "\" x2=\"" << x(q) << "\" y2=\"" << y(q) << "\" stroke=\""
           << stroke << "\" stroke-width=\"" << width << "\"/>\n";
  }

  void dot(const Point_2& p, double radius, const std::string& fill)
  {
    m_body << "<circle cx=\"" << x(p) << "\" cy=\"" << y(p) << "\" r=\"" << radius << "\" fill=\"" << fill << "\"/>\n";
  }

  void save(const std::string& filename) const
  {
    std::ofstream out(filename);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << PANEL * double(m_panels) << "\" height=\"" << PANEL
        << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
        << m_body.str() << "</svg>\n";
    if (!out.flush())
      throw std::runtime_error("cannot write " + filename);
  }

private:
  double x(const Point_2& p) const { return PANEL * (double(m_panel) + .5 + .48 * p.x()); }
  double y(const Point_2& p) const { return PANEL * (.5 - .48 * p.y()); }

  std::size_t m_panels, m_panel = 0;
  std::ostringstream m_body;
};

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
std::string color_of(double value)
{
  const int level = (std::min)(5, static_cast<int>(std::abs(value) / .06));
  const int dark = 245 - 22 * level, middle = 248 - 12 * level;
  std::ostringstream result;
  if (value < 0.)
    result << "rgb(" << dark << ',' << middle << ",255)";
  else
    result << "rgb(255," << middle << ',' << dark << ')';
  return result.str();
}

// A bracket of two plates, extruded along y: the function in the plane y = 0, and the samples there.
void implicit_slice(const std::string& folder)
{
  using Sample = std::pair<Point_3, Vector_3>;
  using Function = isr::Linear_implicit_function_3<Kernel>;
  const std::vector<std::array<double, 2> > outline{ { { -.8, -.5 } }, { { .8, -.5 } }, { { .8, -.3 } },
                                                     { { -.5, -.3 } }, { { -.5, .0 } }, { { .8, .0 } },
                                                     { { .8, .5 } },   { { -.8, .5 } } };
  constexpr double SPACING = .1;
  std::vector<Sample> samples;
  for (std::size_t side = 0; side != outline.size(); ++side) {
    const auto& a = outline[side];
    const auto& b = outline[(side + 1) % outline.size()];
    const double dx = b[0] - a[0], dz = b[1] - a[1], length = std::hypot(dx, dz);
    const int steps = static_cast<int>(std::lround(length / SPACING));
    for (int i = 0; i != steps; ++i)
      for (int j = -6; j <= 6; ++j) {
        const double t = (i + .5) / steps;
        samples.emplace_back(Point_3(a[0] + t * dx, SPACING * j, a[1] + t * dz), Vector_3(dz, 0, -dx));
      }
  }
  const Function function(samples, params::point_map(CGAL::First_of_pair_property_map<Sample>())
                                     .normal_map(CGAL::Second_of_pair_property_map<Sample>()));
  constexpr int CELLS = 140;
  const auto coordinate = [](int i) { return 2. * i / CELLS - 1.; };
  Picture picture(1);
  for (int j = 0; j != CELLS; ++j) // runs of one color
    for (int begin = 0, end = 0; begin != CELLS; begin = end) {
      const auto color = [&](int i) {
        return color_of(function(Point_3(coordinate(i) + 1. / CELLS, 0, coordinate(j) + 1. / CELLS)));
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
  picture.save(folder + "/implicit.svg");
}

// Seen obliquely from above; the far triangles are drawn first.
void draw_surface(const Points& points, Triangles triangles, Picture& picture)
{
  const Vector_3 to_viewer(0., -.62, .78), up(0., .78, .62);
  const auto depth = [&](const Triangle& t) {
    return (points[t[0]] - CGAL::ORIGIN) * to_viewer + (points[t[1]] - CGAL::ORIGIN) * to_viewer +
           (points[t[2]] - CGAL::ORIGIN) * to_viewer;
  };
  const auto projected = [&](const Point_3& p) { return Point_2(p.x(), up * (p - CGAL::ORIGIN) + .15); };
  std::sort(triangles.begin(), triangles.end(),
            [&](const Triangle& a, const Triangle& b) { return depth(a) < depth(b); });
  for (const Triangle& t : triangles) {
    const Vector_3 n = CGAL::unit_normal(points[t[0]], points[t[1]], points[t[2]]);
    const int light = static_cast<int>(120. + 125. * std::abs(n * Vector_3(.36, -.48, .8)));
    std::ostringstream fill;
    fill << "rgb(" << light - 20 << ',' << light - 10 << ',' << light << ')';
    picture.polygon({ projected(points[t[0]]), projected(points[t[1]]), projected(points[t[2]]) }, fill.str(), "#345",
                    .4);
  }
}

// A bowl with a small hole in its bottom: closed by default, and with its rim kept.
void boundary_policy(const std::string& folder)
{
  constexpr double GOLDEN_ANGLE = 2.399963229728653, N = 700.;
  Points points;
  for (double i = 0.; i < N; ++i) {
    const double z = 1. - (2. * i + 1.) / N, r = std::sqrt(1. - z * z);
    const Point_3 p(r * std::cos(i * GOLDEN_ANGLE), r * std::sin(i * GOLDEN_ANGLE), z);
    if (z < .1 && CGAL::squared_distance(p, Point_3(.1, .35, -.93)) > .05)
      points.push_back(p);
  }
  Picture picture(2);
  const auto draw = [&](std::size_t panel, const auto& np) {
    Triangles triangles;
    CGAL::ctc_reconstruction(points, std::back_inserter(triangles), np);
    picture.select_panel(panel);
    draw_surface(points, triangles, picture);
  };
  draw(0, params::default_values());
  draw(1, params::keep_boundaries(true));
  picture.save(folder + "/boundaries.svg");
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
  } catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

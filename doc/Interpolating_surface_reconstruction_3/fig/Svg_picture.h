// Pictures of points, polygons and surfaces as SVG, for the figures of the manual.

#ifndef ISR_DOC_SVG_PICTURE_H
#define ISR_DOC_SVG_PICTURE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

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

// Factors of red, green and blue.
using Tint = std::array<double, 3>;

constexpr Tint BLUE{ { .82, .95, 1.08 } }, ORANGE{ { 1.08, .86, .55 } };

// Seen obliquely from above; the far triangles are drawn first. `tint(triangle, is_front)` is a color.
template <typename TintOf>
void draw_surface(const Points& points, Triangles triangles, Picture& picture, const TintOf& tint)
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
    const double light = 105. + 125. * std::abs(n * Vector_3(.36, -.48, .8));
    const Tint color = tint(t, n * to_viewer > 0.);
    std::ostringstream fill;
    fill << "rgb(" << int(light * color[0]) << ',' << int(light * color[1]) << ',' << int(light * color[2]) << ')';
    picture.polygon({ projected(points[t[0]]), projected(points[t[1]]), projected(points[t[2]]) }, fill.str(), "#345",
                    .4);
  }
}

// Blue outside, orange inside.
inline void draw_surface(const Points& points, const Triangles& triangles, Picture& picture)
{
  draw_surface(points, triangles, picture, [](const Triangle&, bool is_front) { return is_front ? BLUE : ORANGE; });
}

#endif // ISR_DOC_SVG_PICTURE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/ctc_reconstruction.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;

// A point as a scanner's library may define it.
struct Scan_point
{
  float x, y, z;
  float intensity;
};

// Makes a point of CGAL of it, on the fly.
struct Scan_point_map
{
  using key_type = Scan_point;
  using value_type = Point_3;
  using reference = Point_3;
  using category = boost::readable_property_map_tag;

  friend Point_3 get(const Scan_point_map&, const Scan_point& p) { return Point_3(p.x, p.y, p.z); }
};

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  std::vector<Point_3> positions;
  if (!CGAL::IO::read_points(filename, std::back_inserter(positions))) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  std::vector<Scan_point> scan;
  for (const Point_3& p : positions)
    scan.push_back(Scan_point{ float(p.x()), float(p.y()), float(p.z()), 1.f });

  std::vector<std::array<std::size_t, 3> > triangles;
  CGAL::ctc_reconstruction(scan, std::back_inserter(triangles), CGAL::parameters::point_map(Scan_point_map()));

  std::cout << scan.size() << " points, " << triangles.size() << " triangles" << std::endl;
  return triangles.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}

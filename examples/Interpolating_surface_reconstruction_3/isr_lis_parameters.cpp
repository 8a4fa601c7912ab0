#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>
#include <CGAL/lis_reconstruction.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Sample = std::pair<Point_3, Vector_3>;

namespace params = CGAL::parameters;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/sphere.xyz";
  std::vector<Point_3> points;
  if (!CGAL::IO::read_points(filename, std::back_inserter(points))) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  // Normals of a sphere; scanners and normal estimation give them for other surfaces.
  std::vector<Sample> samples;
  for (const Point_3& p : points)
    samples.emplace_back(p, p - CGAL::ORIGIN);

  // No edge shall be longer than the spacing: vertices are added between the samples.
  std::vector<Point_3> vertices;
  std::vector<std::array<std::size_t, 3> > triangles;
  const auto maps = params::point_map(CGAL::First_of_pair_property_map<Sample>())
                      .normal_map(CGAL::Second_of_pair_property_map<Sample>());
  CGAL::lis_reconstruction(samples, vertices, triangles, maps.grid_spacing(0.1));
  std::cout << samples.size() << " samples, " << vertices.size() << " vertices, " << triangles.size() << " triangles"
            << std::endl;

  // Openings stay open.
  std::vector<Point_3> open_vertices;
  std::vector<std::array<std::size_t, 3> > open_triangles;
  CGAL::lis_reconstruction(samples, open_vertices, open_triangles,
                           params::combine(maps, params::keep_boundaries(true)));
  return vertices.size() > open_vertices.size() ? EXIT_SUCCESS : EXIT_FAILURE;
}

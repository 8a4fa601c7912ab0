#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Linear_implicit_function_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/adaptive_linear_implicit_isosurface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/linear_implicit_isosurface.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace isr = CGAL::Interpolating_surface_reconstruction_3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  CGAL::Point_set_3<Point_3> points;
  if (!CGAL::IO::read_point_set(filename, points)) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Cells as small as the spacing of the points asks for, everywhere.
  const isr::Linear_implicit_function_3<Kernel> function(points, points.parameters());
  std::vector<Point_3> vertices;
  std::vector<std::array<std::size_t, 3> > triangles;
  const std::size_t cells = isr::adaptive_linear_implicit_isosurface(function, vertices, triangles);
  std::cout << points.size() << " points, " << triangles.size() << " triangles in " << cells << " cells" << std::endl;

  // The method of the thesis: its weight, and a grid whose step is the smallest radius of a star.
  const isr::Linear_implicit_function_3<Kernel, isr::Quadratic_weight> thesis_function(points, points.parameters());
  std::vector<Point_3> thesis_vertices;
  std::vector<std::array<std::size_t, 3> > thesis_triangles;
  const std::size_t cubes = isr::linear_implicit_isosurface(thesis_function, thesis_vertices, thesis_triangles);
  std::cout << "on a grid: " << thesis_triangles.size() << " triangles in " << cubes << " cubes" << std::endl;

  return CGAL::IO::write_polygon_soup("isosurface.off", vertices, triangles) ? EXIT_SUCCESS : EXIT_FAILURE;
}

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/ctc_reconstruction.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

namespace params = CGAL::parameters;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/bowl.xyz";
  std::vector<Point_3> points;
  if (!CGAL::IO::read_points(filename, std::back_inserter(points))) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Closes no loop of more than 8 edges; the rim of the bowl has more.
  Mesh limited_holes;
  CGAL::ctc_reconstruction(points, limited_holes, params::maximum_hole_size(8));

  // Connects no points that are farther apart than about this; the unit is that of the points.
  Mesh limited_edges;
  CGAL::ctc_reconstruction(points, limited_edges, params::keep_boundaries(true).neighbor_radius(0.5));
  std::cout << "maximum_hole_size: " << limited_holes.number_of_faces() << " triangles, "
            << (CGAL::is_closed(limited_holes) ? "closed" : "open") << "\n"
            << "neighbor_radius: " << limited_edges.number_of_faces() << " triangles" << std::endl;

  // A value that makes no sense is an error of the caller.
  try {
    CGAL::ctc_reconstruction(points, limited_edges, params::neighbor_radius(-1.));
  } catch (const std::invalid_argument& error) {
    std::cout << error.what() << std::endl;
    return EXIT_SUCCESS;
  }
  return EXIT_FAILURE;
}

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/ctc_reconstruction.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/bowl.xyz";
  std::vector<Point_3> points;
  if (!CGAL::IO::read_points(filename, std::back_inserter(points))) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Mesh closed;
  CGAL::ctc_reconstruction(points, closed);

  // Leaves the rim of the bowl open.
  Mesh open;
  CGAL::ctc_reconstruction(points, open, CGAL::parameters::keep_boundaries(true));

  std::cout << "by default " << closed.number_of_faces() << " triangles, "
            << (CGAL::is_closed(closed) ? "closed" : "open") << "\n"
            << "with keep_boundaries " << open.number_of_faces() << " triangles, "
            << (CGAL::is_closed(open) ? "closed" : "open") << std::endl;
  return EXIT_SUCCESS;
}

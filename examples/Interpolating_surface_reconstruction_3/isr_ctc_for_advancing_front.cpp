#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Interpolating_surface_reconstruction_3/triangles_to_surface_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/ctc_reconstruction.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Triangles = std::vector<std::array<std::size_t, 3> >;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  std::vector<Point_3> points;
  if (!CGAL::IO::read_points(filename, std::back_inserter(points))) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  //! [before]
  Triangles front;
  CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(), std::back_inserter(front));
  //! [before]

  //! [after]
  Triangles triangles;
  CGAL::ctc_reconstruction(points, std::back_inserter(triangles));
  //! [after]

  // Both are positions in `points`, so that all that follows stays as it is.
  CGAL::Surface_mesh<Point_3> mesh;
  const bool is_mesh = CGAL::Interpolating_surface_reconstruction_3::triangles_to_surface_mesh(points, triangles, mesh);
  std::cout << front.size() << " triangles by advancing front, " << mesh.number_of_faces() << " by ctc_reconstruction"
            << std::endl;
  return is_mesh ? EXIT_SUCCESS : EXIT_FAILURE;
}

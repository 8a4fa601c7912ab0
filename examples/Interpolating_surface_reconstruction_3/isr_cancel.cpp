#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/ctc_reconstruction.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  std::vector<Point_3> points;
  if (!CGAL::IO::read_points(filename, std::back_inserter(points))) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Gives up half way, as a user might by a button.
  const auto callback = [](double progress) {
    std::cout << static_cast<int>(100 * progress) << " %" << std::endl;
    return progress < 0.5;
  };
  CGAL::Surface_mesh<Point_3> mesh;
  const bool is_complete = CGAL::ctc_reconstruction(points, mesh, CGAL::parameters::callback(callback));

  std::cout << (is_complete ? "complete" : "cancelled") << ", " << mesh.number_of_faces() << " triangles" << std::endl;
  return !is_complete && mesh.is_empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}

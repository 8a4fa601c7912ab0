#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/pcr_reconstruction.h>

#include <array>
#include <cstddef>
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

  std::vector<std::array<std::size_t, 3> > triangles;
  CGAL::pcr_reconstruction(points, std::back_inserter(triangles));

  std::cout << points.size() << " points, " << triangles.size() << " triangles" << std::endl;
  return CGAL::IO::write_polygon_soup("pcr.off", points, triangles) ? EXIT_SUCCESS : EXIT_FAILURE;
}

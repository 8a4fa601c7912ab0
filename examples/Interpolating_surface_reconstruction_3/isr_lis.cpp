#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/lis_reconstruction.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  CGAL::Point_set_3<Point_3> points;
  if (!CGAL::IO::read_point_set(filename, points)) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // The parameters of a point set hold its normals; without, they are estimated.
  CGAL::Surface_mesh<Point_3> mesh;
  CGAL::lis_reconstruction(points, mesh, points.parameters());

  std::cout << mesh.number_of_vertices() << " of " << points.size() << " points in " << mesh.number_of_faces()
            << " triangles" << std::endl;
  return CGAL::IO::write_PLY("lis.ply", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}

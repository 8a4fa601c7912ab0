#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/ctc_reconstruction.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  CGAL::Point_set_3<Point_3> points;
  if (!CGAL::IO::read_point_set(filename, points)) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Normals that point to the origin: the surface is oriented as they are, inside out.
  points.add_normal_map();
  for (const auto& index : points)
    points.normal(index) = Vector_3(points.point(index), CGAL::ORIGIN);

  CGAL::Surface_mesh<Point_3> mesh;
  CGAL::ctc_reconstruction(points, mesh,
                           CGAL::parameters::combine(points.parameters(), CGAL::parameters::maximum_hole_size(64)));

  std::cout << mesh.number_of_vertices() << " of " << points.size() << " points in " << mesh.number_of_faces()
            << " triangles" << std::endl;
  return CGAL::IO::write_PLY("inside_out.ply", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}

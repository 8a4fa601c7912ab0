#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Color.h>
#include <CGAL/IO/read_ply_points.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/ctc_reconstruction.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Byte_color = std::array<unsigned char, 3>;
using Colored_point = std::pair<Point_3, Byte_color>;
using Point_map = CGAL::First_of_pair_property_map<Colored_point>;
using Color_map = CGAL::Second_of_pair_property_map<Colored_point>;
using Mesh = CGAL::Surface_mesh<Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/colored_sphere.ply";
  std::ifstream in(filename, std::ios::binary);
  std::vector<Colored_point> points;
  if (!CGAL::IO::read_PLY_with_properties(in, std::back_inserter(points), CGAL::make_ply_point_reader(Point_map()),
                                          std::make_tuple(
                                            Color_map(),
                                            [](unsigned char r, unsigned char g, unsigned char b) {
                                              return Byte_color{ r, g, b };
                                            },
                                            CGAL::IO::PLY_property<unsigned char>("red"),
                                            CGAL::IO::PLY_property<unsigned char>("green"),
                                            CGAL::IO::PLY_property<unsigned char>("blue")))) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Mesh mesh;
  CGAL::ctc_reconstruction(points, mesh, CGAL::parameters::point_map(Point_map()));

  // The mesh remembers which point each vertex is.
  const auto input_index = mesh.add_property_map<Mesh::Vertex_index, std::size_t>("v:input_index").first;
  const auto color = mesh.add_property_map<Mesh::Vertex_index, CGAL::IO::Color>("v:color").first;
  for (Mesh::Vertex_index v : mesh.vertices()) {
    const Byte_color& c = points[input_index[v]].second;
    color[v] = CGAL::IO::Color(c[0], c[1], c[2]);
  }

  std::cout << mesh.number_of_faces() << " triangles with colors" << std::endl;
  return CGAL::IO::write_OFF("colored.off", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}

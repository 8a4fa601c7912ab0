#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Linear_implicit_function_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/make_mesh_3.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Function = CGAL::Interpolating_surface_reconstruction_3::Linear_implicit_function_3<Kernel>;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  CGAL::Point_set_3<Point_3> points;
  if (!CGAL::IO::read_point_set(filename, points)) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // The function is negative inside, as the mesh generator expects it.
  const Function function(points, points.parameters());
  const CGAL::Bbox_3 box = function.bbox();
  const Point_3 low(box.xmin(), box.ymin(), box.zmin()), high(box.xmax(), box.ymax(), box.zmax());
  const double diagonal = std::sqrt(CGAL::squared_distance(low, high));
  const Domain domain = Domain::create_implicit_mesh_domain(
    function, Kernel::Sphere_3(CGAL::midpoint(low, high), diagonal * diagonal));

  const Criteria criteria(Criteria::Facet_criteria(25, .03 * diagonal, .003 * diagonal),
                          Criteria::Cell_criteria(3, .1 * diagonal));
  const Complex mesh = CGAL::make_mesh_3<Complex>(domain, criteria);

  std::cout << mesh.number_of_facets_in_complex() << " triangles around "
            << mesh.number_of_cells_in_complex() << " tetrahedra" << std::endl;
  std::ofstream out("lis_function.off");
  mesh.output_boundary_to_off(out);
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}

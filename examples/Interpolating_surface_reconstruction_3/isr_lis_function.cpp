#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Linear_implicit_function_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/make_mesh_3.h>

#if __has_include(<CGAL/Isosurfacing_3/marching_cubes_3.h>) // from CGAL 6.1 on
#define ISR_HAS_ISOSURFACING
#include <CGAL/Isosurfacing_3/Cartesian_grid_3.h>
#include <CGAL/Isosurfacing_3/Marching_cubes_domain_3.h>
#include <CGAL/Isosurfacing_3/Value_function_3.h>
#include <CGAL/Isosurfacing_3/marching_cubes_3.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Function = CGAL::Interpolating_surface_reconstruction_3::Linear_implicit_function_3<Kernel>;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

#ifdef ISR_HAS_ISOSURFACING
// The surface of the function on a grid, by marching cubes.
void contour(const Function& function)
{
  using Grid = CGAL::Isosurfacing::Cartesian_grid_3<Kernel>;
  using Values = CGAL::Isosurfacing::Value_function_3<Grid>;
  using Contour_domain = CGAL::Isosurfacing::Marching_cubes_domain_3<Grid, Values>;

  CGAL::Bbox_3 box = function.bbox();
  box.scale(1.1);
  const Grid grid(box, CGAL::make_array<std::size_t>(50, 50, 50));
  const Values values(function, grid);
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  CGAL::Isosurfacing::marching_cubes(Contour_domain(grid, values), 0., points, triangles);
  std::cout << triangles.size() << " triangles by marching cubes" << std::endl;
}
#endif

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
#ifdef ISR_HAS_ISOSURFACING
  contour(function);
#endif

  const CGAL::Bbox_3 box = function.bbox();
  const Point_3 low(box.xmin(), box.ymin(), box.zmin()), high(box.xmax(), box.ymax(), box.zmax());
  const double diagonal = std::sqrt(CGAL::squared_distance(low, high));
  const Domain domain =
    Domain::create_implicit_mesh_domain(function, Kernel::Sphere_3(CGAL::midpoint(low, high), diagonal * diagonal));

  const Criteria criteria(Criteria::Facet_criteria(25, .03 * diagonal, .003 * diagonal),
                          Criteria::Cell_criteria(3, .1 * diagonal));
  const Complex mesh = CGAL::make_mesh_3<Complex>(domain, criteria);

  std::cout << mesh.number_of_facets_in_complex() << " triangles around " << mesh.number_of_cells_in_complex()
            << " tetrahedra" << std::endl;
  std::ofstream out("lis_function.off");
  mesh.output_boundary_to_off(out);
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}

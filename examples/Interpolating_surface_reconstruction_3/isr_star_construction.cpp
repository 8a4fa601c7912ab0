#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Regularity_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>
#include <CGAL/ctc_reconstruction.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace isr = CGAL::Interpolating_surface_reconstruction_3;
namespace params = CGAL::parameters;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Triangles = std::vector<std::array<std::size_t, 3> >;

// Tells at how many points the stars agree.
struct Agreement : isr::Default_visitor
{
  std::size_t agreed_points = 0;

  void on_stage_end(isr::Stage stage, std::size_t items)
  {
    if (stage == isr::Stage::COMPATIBILITY)
      agreed_points = items;
  }
};

template <typename StarConstruction>
std::size_t agreement(const std::vector<Point_3>& points, const StarConstruction& stars, Triangles& triangles)
{
  Agreement visitor;
  CGAL::ctc_reconstruction(points, std::back_inserter(triangles),
                           params::star_construction(stars).visitor(std::ref(visitor)));
  return visitor.agreed_points;
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  std::vector<Point_3> points;
  if (!CGAL::IO::read_points(filename, std::back_inserter(points))) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  Triangles by_cells, by_regularity;
  std::cout << "points on whose stars all neighbors agree: "
            << agreement(points, isr::Restricted_voronoi_star_3(), by_cells) << " with the default, "
            << agreement(points, isr::Regularity_star_3(), by_regularity) << " with the star of the thesis, of "
            << points.size() << std::endl;
  return by_cells.empty() || by_regularity.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}

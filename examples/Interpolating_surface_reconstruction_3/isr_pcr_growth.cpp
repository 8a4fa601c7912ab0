#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/pcr_reconstruction.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace isr = CGAL::Interpolating_surface_reconstruction_3;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Triangle = std::array<std::size_t, 3>;

// Keeps the triangles in the order in which the growth attaches them.
struct Growth_recorder : isr::Default_visitor
{
  std::vector<Triangle> triangles;
  bool is_growing = false;

  void on_stage_begin(isr::Stage stage) { is_growing = stage == isr::Stage::GROWING; }
  void on_triangle(const Triangle& triangle, isr::Triangle_verdict verdict)
  {
    if (is_growing && verdict == isr::Triangle_verdict::ADDED)
      triangles.push_back(triangle);
  }
};

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  std::vector<Point_3> points;
  if (!CGAL::IO::read_points(filename, std::back_inserter(points))) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Growth_recorder recorder;
  std::vector<Triangle> surface;
  CGAL::pcr_reconstruction(points, std::back_inserter(surface), CGAL::parameters::visitor(std::ref(recorder)));

  // growth_1.off to growth_8.off: the surface at equal steps of its growth.
  constexpr std::size_t STEPS = 8;
  for (std::size_t step = 1; step <= STEPS; ++step) {
    const std::vector<Triangle> grown(recorder.triangles.begin(),
                                      recorder.triangles.begin() +
                                        std::ptrdiff_t(recorder.triangles.size() * step / STEPS));
    if (!CGAL::IO::write_polygon_soup("growth_" + std::to_string(step) + ".off", points, grown))
      return EXIT_FAILURE;
  }
  std::cout << recorder.triangles.size() << " triangles in the growth, " << surface.size() << " in the surface"
            << std::endl;
  return EXIT_SUCCESS;
}

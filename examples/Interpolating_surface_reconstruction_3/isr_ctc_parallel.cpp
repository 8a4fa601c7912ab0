#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Real_timer.h>
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

template <typename ConcurrencyTag>
Triangles timed_reconstruction(const std::vector<Point_3>& points, const char* name)
{
  Triangles triangles;
  CGAL::Real_timer timer;
  timer.start();
  CGAL::ctc_reconstruction<ConcurrencyTag>(points, std::back_inserter(triangles));
  std::cout << name << ": " << timer.time() << " s" << std::endl;
  return triangles;
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  std::vector<Point_3> points;
  if (!CGAL::IO::read_points(filename, std::back_inserter(points))) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  const Triangles one_by_one = timed_reconstruction<CGAL::Sequential_tag>(points, "sequential");
  const Triangles at_once = timed_reconstruction<CGAL::Parallel_if_available_tag>(points, "parallel");

  std::cout << (one_by_one == at_once ? "the same " : "different ") << at_once.size() << " triangles" << std::endl;
  return one_by_one == at_once ? EXIT_SUCCESS : EXIT_FAILURE;
}

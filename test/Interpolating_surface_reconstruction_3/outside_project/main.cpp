#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/ctc_reconstruction.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

int main()
{
  using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

  const std::vector<Point_3> octahedron = { Point_3(1, 0, 0),  Point_3(-1, 0, 0), Point_3(0, 1, 0),
                                            Point_3(0, -1, 0), Point_3(0, 0, 1),  Point_3(0, 0, -1) };
  std::vector<std::array<std::size_t, 3> > triangles;
  CGAL::ctc_reconstruction<CGAL::Parallel_if_available_tag>(octahedron, std::back_inserter(triangles));

  std::cout << triangles.size() << " triangles" << std::endl;
  return triangles.size() == 8 ? EXIT_SUCCESS : EXIT_FAILURE;
}

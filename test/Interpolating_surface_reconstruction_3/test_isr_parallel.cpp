#include "isr_stage_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/internal/parallel.h>

#include <iostream>

using CGAL::Interpolating_surface_reconstruction_3::internal::for_each_block;

// Every block once, whoever works on it.
template <typename ConcurrencyTag>
void test_blocks()
{
  for (std::size_t n : { 0u, 1u, 7u, 8u, 9u, 1000u })
    for (std::size_t block_size : { 1u, 8u, 2000u }) {
      std::vector<int> visits(n, 0);
      std::vector<std::size_t> ends(n, 0); // of the block that begins here
      for_each_block<ConcurrencyTag>(n, block_size, [&](std::size_t begin, std::size_t end) {
        ends[begin] = end;
        for (std::size_t i = begin; i != end; ++i)
          ++visits[i];
      });
      for (std::size_t i = 0; i != n; ++i) {
        assert(visits[i] == 1);
        assert(ends[i] == (i % block_size == 0 ? (std::min)(n, i + block_size) : 0));
      }
    }
}

int main()
{
  test_blocks<CGAL::Sequential_tag>();
  test_blocks<CGAL::Parallel_if_available_tag>();
#ifdef CGAL_LINKED_WITH_TBB
  test_blocks<CGAL::Parallel_tag>();
#endif
  std::cout << "done" << std::endl;
  return 0;
}

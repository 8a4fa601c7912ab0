// Copyright (c) 2026  The authors of Interpolating_surface_reconstruction_3.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s) : The authors of Interpolating_surface_reconstruction_3

#ifndef ISR_BENCHMARK_MEASURES_PEAK_MEMORY_H
#define ISR_BENCHMARK_MEASURES_PEAK_MEMORY_H

#include <sys/resource.h>

#include <cstddef>
#include <fstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace isr_benchmark {

// Growth of the resident set from construction to its peak. Reading a file may have left a higher
// peak than the memory in use, so free memory is returned and the peak reset first (Linux only;
// elsewhere the growth of the peak is a lower bound).
class Peak_memory
{
public:
  Peak_memory()
  {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    std::ofstream("/proc/self/clear_refs") << "5" << std::flush;
    m_before = peak();
  }

  std::size_t growth_in_bytes() const
  {
    const std::size_t now = peak();
    return now > m_before ? now - m_before : 0;
  }

  // Of the whole process, as far as it was reset above: getrusage() still knows the process before exec().
  static std::size_t peak()
  {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
      if (word == "VmHWM:") {
        std::size_t kilobytes = 0;
        status >> kilobytes;
        return kilobytes * 1024;
      }
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  }

private:
  std::size_t m_before;
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MEASURES_PEAK_MEMORY_H

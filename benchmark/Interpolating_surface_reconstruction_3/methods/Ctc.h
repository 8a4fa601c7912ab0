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

#ifndef ISR_BENCHMARK_METHODS_CTC_H
#define ISR_BENCHMARK_METHODS_CTC_H

#include "Method.h"

#include <CGAL/ctc_reconstruction.h>

#include <iterator>

namespace isr_benchmark {

class Ctc : public Method
{
public:
  explicit Ctc(bool keep_boundaries = false) : m_keep_boundaries(keep_boundaries) { }

  std::string key() const override { return "ctc"; }
  std::string title() const override { return "CTC"; }
  std::string description() const override { return "CGAL::ctc_reconstruction() with its defaults"; }
  bool is_ours() const override { return true; }
  bool uses_threads() const override { return true; }

  Reconstruction operator()(const Model& model, std::size_t threads) const override
  {
    return with_threads(threads, [&](auto tag) {
      Reconstruction result;
      CGAL::ctc_reconstruction<decltype(tag)>(model.points, std::back_inserter(result.triangles),
                                              CGAL::parameters::keep_boundaries(m_keep_boundaries));
      return result;
    });
  }

private:
  bool m_keep_boundaries;
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_METHODS_CTC_H

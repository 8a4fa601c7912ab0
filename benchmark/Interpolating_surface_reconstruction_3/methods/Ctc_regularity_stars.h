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

#ifndef ISR_BENCHMARK_METHODS_CTC_REGULARITY_STARS_H
#define ISR_BENCHMARK_METHODS_CTC_REGULARITY_STARS_H

#include "Method.h"

#include <CGAL/ctc_reconstruction.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Regularity_star_3.h>

#include <iterator>

namespace isr_benchmark {

class Ctc_regularity_stars : public Method
{
public:
  std::string key() const override { return "ctc-thesis"; }
  std::string title() const override { return "CTC, thesis's stars"; }
  std::string description() const override
  {
    return "CGAL::ctc_reconstruction() with star_construction(Regularity_star_3): stars by the regularity "
           "function (3.3.1, Eq. 3.1 and 3.2), all later stages as for CTC";
  }
  bool is_ours() const override { return true; }
  bool uses_threads() const override { return true; }

  Reconstruction operator()(const Model& model, std::size_t threads) const override
  {
    using Star = CGAL::Interpolating_surface_reconstruction_3::Regularity_star_3;
    return with_threads(threads, [&](auto tag) {
      Reconstruction result;
      CGAL::ctc_reconstruction<decltype(tag)>(model.points, std::back_inserter(result.triangles),
                                              CGAL::parameters::star_construction(Star()));
      return result;
    });
  }
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_METHODS_CTC_REGULARITY_STARS_H

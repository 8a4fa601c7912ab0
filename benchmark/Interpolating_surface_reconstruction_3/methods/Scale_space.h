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

#ifndef ISR_BENCHMARK_METHODS_SCALE_SPACE_H
#define ISR_BENCHMARK_METHODS_SCALE_SPACE_H

#include "Method.h"

#include <CGAL/Scale_space_reconstruction_3/Alpha_shape_mesher.h>
#include <CGAL/Scale_space_reconstruction_3/Weighted_PCA_smoother.h>
#include <CGAL/Scale_space_surface_reconstruction_3.h>

namespace isr_benchmark {

class Scale_space : public Method
{
public:
  std::string key() const override { return "scale-space"; }
  std::string title() const override { return "Scale space"; }
  std::string description() const override
  {
    return "CGAL::Scale_space_surface_reconstruction_3 as in the first example of its manual: increase_scale(4) "
           "with Weighted_PCA_smoother(12, 300), reconstruct_surface() with Alpha_shape_mesher on the smoother's "
           "squared radius; both sides of a facet are output where both are free (Digne et al. 2011)";
  }
  bool uses_threads() const override { return true; }

  Reconstruction operator()(const Model& model, std::size_t threads) const override
  {
    return with_threads(threads, [&](auto tag) {
      using Smoother =
        CGAL::Scale_space_reconstruction_3::Weighted_PCA_smoother<Kernel, CGAL::Default_diagonalize_traits<double, 3>,
                                                                  decltype(tag)>;
      using Mesher = CGAL::Scale_space_reconstruction_3::Alpha_shape_mesher<Kernel>;
      CGAL::Scale_space_surface_reconstruction_3<Kernel> reconstruction(model.points.begin(), model.points.end());
      Smoother smoother;
      reconstruction.increase_scale(4, smoother);
      reconstruction.reconstruct_surface(Mesher(smoother.squared_radius()));
      Reconstruction result;
      for (auto facet = reconstruction.facets_begin(); facet != reconstruction.facets_end(); ++facet)
        result.triangles.push_back(Triangle{ (*facet)[0], (*facet)[1], (*facet)[2] });
      return result;
    });
  }
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_METHODS_SCALE_SPACE_H

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

// Any points and parameters: every guarantee of a reconstruction holds. The first byte chooses the
// algorithm.

#include "isr_fuzz_input.h"

#include "../isr_test_algorithms.h"

namespace {

using isr_fuzz::Byte_stream;
using isr_fuzz::Points;
namespace params = CGAL::parameters;
namespace validation = isr_test::validation;

template <typename Algorithm, typename NamedParameters>
void reconstruct(Algorithm algorithm, const Points& points, const NamedParameters& np)
{
  isr_test::Counting_visitor visitor;
  const isr_test::Triples triples =
    isr_test::triangles_of(algorithm, points, params::combine(np, params::visitor(std::ref(visitor))));
  ISR_FUZZ_REQUIRE(validation::is_oriented_manifold(points, triples, isr_test::Kernel()));
  ISR_FUZZ_REQUIRE(validation::used_points(triples).size() + visitor.unused + visitor.duplicates + visitor.non_finite ==
                   points.size());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Byte_stream in(data, size);
  const std::size_t algorithm = in.below(4);
  const bool keeps_boundaries = in.below(2) == 0;
  const std::size_t maximum_hole_size = in.below(4) == 0 ? in.below(16) : 1000;
  const double neighbor_radius = in.below(4) == 0 ? std::abs(in.small()) : 0.;
  const Points points = isr_fuzz::read_points(in, 60);

  const auto common =
    params::combine(params::keep_boundaries(keeps_boundaries), params::neighbor_radius(neighbor_radius));
  const auto all = params::combine(common, params::maximum_hole_size(maximum_hole_size));
  if (algorithm == 0)
    reconstruct(isr_test::Ctc(), points, all);
  else if (algorithm == 1)
    reconstruct(isr_test::Pcr(), points, all);
  else if (algorithm == 2)
    reconstruct(isr_test::Lis<isr_test::No_normals>(), points, common);
  else
    reconstruct(isr_test::Lis<isr_test::Radial_normals>(), points, common);
  return 0;
}

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

#ifndef ISR_TEST_CTC_H
#define ISR_TEST_CTC_H

#include "isr_test_reconstruction.h"

#include <CGAL/ctc_reconstruction.h>

#include <cstddef>
#include <functional>
#include <iterator>

namespace isr_test {

template <typename ConcurrencyTag = CGAL::Sequential_tag, typename PointRange, typename NamedParameters>
Triples ctc(const PointRange& points, const NamedParameters& np)
{
  Triples triples;
  CGAL::ctc_reconstruction<ConcurrencyTag>(points, std::back_inserter(triples), np);
  return triples;
}

template <typename PointRange>
Triples ctc(const PointRange& points)
{
  Triples triples;
  CGAL::ctc_reconstruction(points, std::back_inserter(triples));
  return triples;
}

// Reconstructs and checks what holds for any input: an oriented manifold on valid indices without
// degenerate triangles, and a visitor that can account for every point.
template <typename NamedParameters>
Triples checked_ctc(const Points& points, Counting_visitor& visitor, const NamedParameters& np)
{
  const Triples triples = ctc(points, params::combine(np, params::visitor(std::ref(visitor))));
  check_guarantees(points, triples, visitor);
  return triples;
}

inline Triples checked_ctc(const Points& points)
{
  Counting_visitor visitor;
  return checked_ctc(points, visitor, params::keep_boundaries(false));
}

} // namespace isr_test

#endif // ISR_TEST_CTC_H

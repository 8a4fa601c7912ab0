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

#ifndef ISR_TEST_PCR_H
#define ISR_TEST_PCR_H

#include "isr_test_reconstruction.h"

#include <CGAL/pcr_reconstruction.h>

#include <functional>
#include <iterator>

namespace isr_test {

template <typename ConcurrencyTag = CGAL::Sequential_tag, typename PointRange, typename NamedParameters>
Triples pcr(const PointRange& points, const NamedParameters& np)
{
  Triples triples;
  CGAL::pcr_reconstruction<ConcurrencyTag>(points, std::back_inserter(triples), np);
  return triples;
}

template <typename PointRange>
Triples pcr(const PointRange& points)
{
  Triples triples;
  CGAL::pcr_reconstruction(points, std::back_inserter(triples));
  return triples;
}

// Reconstructs and checks the guarantees.
template <typename Visitor, typename NamedParameters>
Triples checked_pcr(const Points& points, Visitor& visitor, const NamedParameters& np)
{
  const Triples triples = pcr(points, params::combine(np, params::visitor(std::ref(visitor))));
  check_guarantees(points, triples, visitor);
  return triples;
}

inline Triples checked_pcr(const Points& points)
{
  Counting_visitor visitor;
  return checked_pcr(points, visitor, params::keep_boundaries(false));
}

} // namespace isr_test

#endif // ISR_TEST_PCR_H

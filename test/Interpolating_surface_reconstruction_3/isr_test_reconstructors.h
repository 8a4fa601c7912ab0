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

// The reconstructors of the defaults, and those of the other stars. Where ISR_TEST_SHARED_RECONSTRUCTORS is defined,
// they are those of a library, and not compiled again for every program.

#ifndef ISR_TEST_RECONSTRUCTORS_H
#define ISR_TEST_RECONSTRUCTORS_H

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Any_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Ctc_reconstructor_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Lis_reconstructor_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Pcr_reconstructor_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/tags.h>

// Not included: programs shall show that they include the public headers they use.
namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
class Regularity_star_3;
class Restricted_voronoi_star_3;
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#define ISR_TEST_RECONSTRUCTOR(name, tag, star)                                                                        \
  CGAL::Interpolating_surface_reconstruction_3::internal::name<                                                        \
    tag, CGAL::Exact_predicates_inexact_constructions_kernel, CGAL::Interpolating_surface_reconstruction_3::star,      \
    CGAL::Interpolating_surface_reconstruction_3::internal::Any_visitor>

#ifdef ISR_TEST_SHARED_RECONSTRUCTORS
extern template class ISR_TEST_RECONSTRUCTOR(Ctc_reconstructor_3, CGAL::Sequential_tag, Restricted_voronoi_star_3);
extern template class ISR_TEST_RECONSTRUCTOR(Pcr_reconstructor_3, CGAL::Sequential_tag, Restricted_voronoi_star_3);
extern template class ISR_TEST_RECONSTRUCTOR(Lis_reconstructor_3, CGAL::Sequential_tag, Restricted_voronoi_star_3);
extern template class ISR_TEST_RECONSTRUCTOR(Ctc_reconstructor_3, CGAL::Sequential_tag, Regularity_star_3);
extern template class ISR_TEST_RECONSTRUCTOR(Pcr_reconstructor_3, CGAL::Sequential_tag, Regularity_star_3);
#ifdef CGAL_LINKED_WITH_TBB
extern template class ISR_TEST_RECONSTRUCTOR(Ctc_reconstructor_3, CGAL::Parallel_tag, Restricted_voronoi_star_3);
extern template class ISR_TEST_RECONSTRUCTOR(Pcr_reconstructor_3, CGAL::Parallel_tag, Restricted_voronoi_star_3);
extern template class ISR_TEST_RECONSTRUCTOR(Lis_reconstructor_3, CGAL::Parallel_tag, Restricted_voronoi_star_3);
extern template class ISR_TEST_RECONSTRUCTOR(Ctc_reconstructor_3, CGAL::Parallel_tag, Regularity_star_3);
#endif
#endif

#endif // ISR_TEST_RECONSTRUCTORS_H

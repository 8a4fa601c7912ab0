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

// The reconstructors of the defaults. Where ISR_TEST_SHARED_RECONSTRUCTORS is defined, they are those of a library,
// and not compiled again for every test.

#ifndef ISR_TEST_RECONSTRUCTORS_H
#define ISR_TEST_RECONSTRUCTORS_H

#include "isr_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Any_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Ctc_reconstructor_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Lis_reconstructor_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Pcr_reconstructor_3.h>

#include <CGAL/tags.h>

#define ISR_TEST_RECONSTRUCTOR(name, tag)                                                                              \
  CGAL::Interpolating_surface_reconstruction_3::internal::name<                                                        \
    tag, isr_test::Kernel, CGAL::Interpolating_surface_reconstruction_3::Restricted_voronoi_star_3,                    \
    CGAL::Interpolating_surface_reconstruction_3::internal::Any_visitor>

#ifdef ISR_TEST_SHARED_RECONSTRUCTORS
extern template class ISR_TEST_RECONSTRUCTOR(Ctc_reconstructor_3, CGAL::Sequential_tag);
extern template class ISR_TEST_RECONSTRUCTOR(Pcr_reconstructor_3, CGAL::Sequential_tag);
extern template class ISR_TEST_RECONSTRUCTOR(Lis_reconstructor_3, CGAL::Sequential_tag);
#ifdef CGAL_LINKED_WITH_TBB
extern template class ISR_TEST_RECONSTRUCTOR(Ctc_reconstructor_3, CGAL::Parallel_tag);
extern template class ISR_TEST_RECONSTRUCTOR(Pcr_reconstructor_3, CGAL::Parallel_tag);
extern template class ISR_TEST_RECONSTRUCTOR(Lis_reconstructor_3, CGAL::Parallel_tag);
#endif
#endif

#endif // ISR_TEST_RECONSTRUCTORS_H

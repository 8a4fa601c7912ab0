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

#include "isr_test_utils.h" // first: it turns assertions on

#include "isr_test_reconstructors.h"

#include <CGAL/Interpolating_surface_reconstruction_3/Regularity_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>

template class ISR_TEST_RECONSTRUCTOR(Ctc_reconstructor_3, CGAL::Sequential_tag, Restricted_voronoi_star_3);
template class ISR_TEST_RECONSTRUCTOR(Pcr_reconstructor_3, CGAL::Sequential_tag, Restricted_voronoi_star_3);
template class ISR_TEST_RECONSTRUCTOR(Lis_reconstructor_3, CGAL::Sequential_tag, Restricted_voronoi_star_3);
template class ISR_TEST_RECONSTRUCTOR(Ctc_reconstructor_3, CGAL::Sequential_tag, Regularity_star_3);
template class ISR_TEST_RECONSTRUCTOR(Pcr_reconstructor_3, CGAL::Sequential_tag, Regularity_star_3);
#ifdef CGAL_LINKED_WITH_TBB
template class ISR_TEST_RECONSTRUCTOR(Ctc_reconstructor_3, CGAL::Parallel_tag, Restricted_voronoi_star_3);
template class ISR_TEST_RECONSTRUCTOR(Pcr_reconstructor_3, CGAL::Parallel_tag, Restricted_voronoi_star_3);
template class ISR_TEST_RECONSTRUCTOR(Lis_reconstructor_3, CGAL::Parallel_tag, Restricted_voronoi_star_3);
template class ISR_TEST_RECONSTRUCTOR(Ctc_reconstructor_3, CGAL::Parallel_tag, Regularity_star_3);
#endif

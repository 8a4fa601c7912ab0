// Copyright (c) 2026  The authors of Interpolating_surface_reconstruction_3.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org)
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Stand-in for the header that CGAL generates from Installation/include/CGAL/license/gpl_package_list.txt.

#ifndef CGAL_LICENSE_INTERPOLATING_SURFACE_RECONSTRUCTION_3_H
#define CGAL_LICENSE_INTERPOLATING_SURFACE_RECONSTRUCTION_3_H

#include <CGAL/config.h>
#include <CGAL/license.h>

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_COMMERCIAL_LICENSE

#if defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("\nThe macro CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_COMMERCIAL_LICENSE is not defined."
                    "\nYou use the Interpolating Surface Reconstruction package under the terms of the GPLv3+.")
#endif

#ifdef CGAL_LICENSE_ERROR
#error                                                                                                                 \
  "The macro CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_COMMERCIAL_LICENSE is not defined. You use the Interpolating Surface Reconstruction package under the terms of the GPLv3+."
#endif

#endif

#endif // CGAL_LICENSE_INTERPOLATING_SURFACE_RECONSTRUCTION_3_H

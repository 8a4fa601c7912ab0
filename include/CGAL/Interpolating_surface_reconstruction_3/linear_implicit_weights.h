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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_LINEAR_IMPLICIT_WEIGHTS_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_LINEAR_IMPLICIT_WEIGHTS_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <algorithm>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

The weight of the thesis (Eq. 5.5): it falls off quadratically from 1 at a sample to 0 at the mean radius
of its star. The function does not interpolate: at a sample, the planes of its neighbors count as well.

\cgalModels{LinearImplicitWeight}
*/
struct Quadratic_weight
{
  /// returns 1.
  double support() const { return 1.; }

  /// returns `1 - ratio`.
  double operator()(double ratio, double /* agreement */) const { return 1. - ratio; }

  /// returns -1.
  double derivative(double /* ratio */, double /* agreement */) const { return -1.; }
};

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

The default weight: it grows without bound towards a sample, so that the function is zero there, reaches
twice as far as that of the thesis, and is the larger the better the normal of the sample agrees with
that of the sample nearest to the point of evaluation. Samples of another sheet of the surface, whose
normals point the other way, have no weight.

\cgalModels{LinearImplicitWeight}
*/
struct Interpolating_weight
{
  /// returns 2.
  double support() const { return 2.; }

  /// returns \f$ ((1 - \rho) / \rho)^2 \f$ times the agreement, or 0 if that is negative.
  double operator()(double ratio, double agreement) const
  {
    const double w = (1. - ratio) / ratio;
    return w * w * (std::max)(agreement, 0.);
  }

  /// returns the derivative with respect to the ratio.
  double derivative(double ratio, double agreement) const
  {
    return -2. * (1. - ratio) / (ratio * ratio * ratio) * (std::max)(agreement, 0.);
  }
};

} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_LINEAR_IMPLICIT_WEIGHTS_H

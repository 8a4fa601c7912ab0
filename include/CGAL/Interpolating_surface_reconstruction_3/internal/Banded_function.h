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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BANDED_FUNCTION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BANDED_FUNCTION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Any_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Lis_reconstructor_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Surface_band.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/isosurface_call.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// A linear implicit function at the surface of lis_reconstruction() through its samples, and the signed distance from
// that surface outside of the band around it. Without a closed surface, as for samples in a plane, the function.
template <typename ConcurrencyTag, typename Function>
class Banded_function
{
public:
  explicit Banded_function(const Function& function)
    : m_function(function), m_band(function.pieces().positions(), function.pieces().normals(), triangles(function))
  { }

  double operator()(const std::array<double, 3>& x) const
  {
    const Local_point p = m_function.cloud().local_point(x[0], x[1], x[2]);
    // Beside points at the upper end of the range of `double` are places that overflow.
    if (!m_band.is_empty() && std::isfinite((p - Local_point(0, 0, 0)).squared_length())) {
      const Surface_band::Place place = m_band(p);
      const double distance = m_function.cloud().global_length(place.signed_distance);
      if (std::abs(place.signed_distance) >= place.width)
        return distance;
      // By the square, halfway across the band, where a round surface is, the function decides nearly alone.
      const double part = place.signed_distance / place.width, share = part * part;
      return share * distance + (1. - share) * function_at(x);
    }
    return function_at(x);
  }

  double largest_width() const { return m_function.cloud().global_length(m_band.largest_width()); }

private:
  double function_at(const std::array<double, 3>& x) const
  {
    return CGAL::to_double(m_function(point_at(x, m_function.geom_traits())));
  }

  static std::vector<Surface_band::Triangle> triangles(const Function& function)
  {
    using Traits = std::decay_t<decltype(function.geom_traits())>;
    using Star_construction = Restricted_voronoi_star_3;
    Stored_visitor<Default_visitor> visitor;
    Progress<Any_visitor> progress(std::function<bool(double)>(), visitor);
    const Star_construction construction;
    Lis_options options;
    options.encloses_sheets = true; // a distance has a sign on closed surfaces only
    Lis_surface surface;
    Lis_reconstructor_3<ConcurrencyTag, Traits, Star_construction, Any_visitor>(
      function.cloud(), function.pieces().normals(), construction, options, progress)(surface);
    return std::move(surface.triangles);
  }

  const Function& m_function;
  const Surface_band m_band;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_BANDED_FUNCTION_H

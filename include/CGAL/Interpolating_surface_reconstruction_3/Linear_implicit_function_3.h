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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_LINEAR_IMPLICIT_FUNCTION_3_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_LINEAR_IMPLICIT_FUNCTION_3_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Any_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Linear_pieces.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/chart_normals.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/samples_with_normals.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/star_construction.h>
#include <CGAL/Interpolating_surface_reconstruction_3/linear_implicit_weights.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {

/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Ref

The linear implicit function of points with normals: the heights over the tangent planes at the points,
blended by weights; negative inside, positive outside, a length in the unit of the points.

With the default weight, the function is zero at every point that is used. Farther from the points than
the weights reach, it is the height over the tangent plane at the nearest point. It is continuous but
where the nearest point changes: there its weights change with the agreement of the normals.

The constructor finds the star of every point, whose mean radius is the unit of the weights, in
\f$ O(n \log n) \f$ time; an evaluation takes \f$ O(\log n) \f$ time on samples of a surface. Copies share
their data, and any number of threads may evaluate them. The function can be passed to mesh generators
of \cgal; from \cgal 6.1 on, it is a value function and, by `gradient()`, a gradient field of the package
\ref PkgIsosurfacing3 as well.

The function is from chapter 5 (Eq. 5.1 to 5.6) of the thesis cited in the user manual.

\tparam Traits a model of `InterpolatingReconstructionTraits_3`
\tparam Weight a model of `LinearImplicitWeight`

\sa `CGAL::lis_reconstruction()`
*/
template <typename Traits, typename Weight = Interpolating_weight>
class Linear_implicit_function_3
{
public:
  /// The number type.
  using FT = typename Traits::FT;
  /// The point type.
  using Point_3 = typename Traits::Point_3;
  /// The vector type.
  using Vector_3 = typename Traits::Vector_3;

  /*!
  prepares the function of points with normals.

  Points with a coordinate that is not a finite number, points with a normal that is zero or not finite,
  and points equal to an earlier one are set aside. Without a point, the function is 1 everywhere.

  \tparam PointRange a model of `ForwardRange`, with at most \f$ 2^{32}-2 \f$ elements
  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

  \param points the points
  \param np optional named parameters; those marked * start a pack or are joined by
  `parameters::combine()`
  \param weight the weight

  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{a property map from the elements of `points` to points}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `Traits::Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{a property map from the elements of `points` to normals of any length that
        point outside}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `Traits::Vector_3`}
      \cgalParamDefault{none: the normals of a surface by `ctc_reconstruction()`}
    \cgalParamNEnd
    \cgalParamNBegin{geom_traits}
      \cgalParamDescription{an instance of the geometric traits class}
      \cgalParamType{`Traits`}
      \cgalParamDefault{`Traits()`}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{the largest distance between neighbors in a star, in the unit of the points;
        `0` means no limit}
      \cgalParamType{`Traits::FT`}
      \cgalParamDefault{`0`}
      \cgalParamExtra{`std::invalid_argument` is thrown if it is negative or not finite}
    \cgalParamNEnd
    \cgalParamNBegin{star_construction}
      \cgalParamDescription{* how the star of a point is made}
      \cgalParamType{a model of `StarConstruction_3`}
      \cgalParamDefault{`Restricted_voronoi_star_3`}
    \cgalParamNEnd
  \cgalNamedParamsEnd
  */
  template <typename PointRange, typename NamedParameters = parameters::Default_named_parameters>
  explicit Linear_implicit_function_3(const PointRange& points,
                                      const NamedParameters& np = parameters::default_values(),
                                      const Weight& weight = Weight())
    : m_weight(weight)
  {
    static_assert(
      internal::Only_allowed<NamedParameters, internal_np::point_t, internal_np::normal_t, internal_np::geom_traits_t,
                             internal_np::neighbor_radius_t, internal_np::star_construction_t>::value,
      "a named parameter is not known to this function");
    using Types = internal::Call_types<PointRange, NamedParameters>;
    const double neighbor_radius = internal::checked_neighbor_radius(
      CGAL::to_double(parameters::choose_parameter(parameters::get_parameter(np, internal_np::neighbor_radius), 0.)));
    const auto construction = parameters::choose_parameter<typename Types::Star_construction>(
      parameters::get_parameter(np, internal_np::star_construction));
    const Traits traits = parameters::choose_parameter<Traits>(parameters::get_parameter(np, internal_np::geom_traits));
    auto cloud = internal::read_samples<Types>(points, np, traits, [] { return true; });
    std::vector<internal::Local_vector> normals = internal::read_sample_normals<Types>(points, np, cloud);
    if (normals.empty())
      normals =
        internal::chart_normals<Sequential_tag>(cloud, construction, neighbor_radius, [](double) { return true; });
    m_data = std::make_shared<const Data>(std::move(cloud), normals, construction, neighbor_radius);
  }

  /// returns the value at `p`.
  FT operator()(const Point_3& p) const
  {
    return m_data->is_empty() ? FT(1) : FT(m_data->cloud.global_length(m_data->pieces(local_point(p), m_weight).value));
  }

  /// returns the gradient at `p`, but for its jumps; the normal at points of the range.
  Vector_3 gradient(const Point_3& p) const
  {
    const internal::Local_vector g =
      m_data->is_empty() ? internal::Local_vector(0, 0, 0) : m_data->pieces(local_point(p), m_weight).gradient;
    return m_data->cloud.traits().construct_vector_3_object()(FT(g.x()), FT(g.y()), FT(g.z()));
  }

  /// returns the smallest mean radius of a star, or 0 if there are fewer than two points.
  FT smallest_radius() const
  {
    const std::vector<double>& radii = m_data->pieces.radii();
    return radii.empty() ? FT(0) : FT(m_data->cloud.global_length(*std::min_element(radii.begin(), radii.end())));
  }

  /// calls `visit(p)` for each point that is used.
  template <typename Visit>
  void for_each_point(Visit visit) const
  {
    for (internal::Point_index p = 0; p != m_data->cloud.size(); ++p)
      visit(m_data->cloud.point(p));
  }

  /// returns the geometric traits.
  const Traits& geom_traits() const { return m_data->cloud.traits(); }

  /// returns a bounding box of the points that are used.
  Bbox_3 bbox() const { return m_data->bbox; }

  /// \cond SKIP_IN_MANUAL
  double largest_radius() const
  {
    const std::vector<double>& radii = m_data->pieces.radii();
    return radii.empty() ? 0. : m_data->cloud.global_length(*std::max_element(radii.begin(), radii.end()));
  }

  // Calls visit(p, radius) for each point that is used, with the mean radius of its star.
  template <typename Visit>
  void for_each_sample(Visit visit) const
  {
    for (internal::Point_index p = 0; p != m_data->cloud.size(); ++p)
      visit(m_data->cloud.point(p), m_data->cloud.global_length(m_data->pieces.radii()[p]));
  }

  const internal::Point_cloud_3<Traits>& cloud() const { return m_data->cloud; }
  const internal::Linear_pieces& pieces() const { return m_data->pieces; }

  double sum_of_squared_radii() const
  {
    double sum = 0.;
    for (double radius : m_data->pieces.radii())
      sum += m_data->cloud.global_length(radius) * m_data->cloud.global_length(radius);
    return sum;
  }
  /// \endcond

private:
  using Cloud = internal::Point_cloud_3<Traits>;

  struct Data
  {
    template <typename StarConstruction>
    Data(Cloud samples, const std::vector<internal::Local_vector>& normals, const StarConstruction& construction,
         double neighbor_radius)
      : cloud(std::move(samples)), pieces(cloud.positions(), normals, radii(cloud, construction, neighbor_radius))
    {
      for (internal::Point_index p = 0; p != cloud.size(); ++p)
        bbox = bbox + cloud.traits().construct_bbox_3_object()(cloud.point(p));
    }

    bool is_empty() const { return cloud.size() == 0; }

    template <typename StarConstruction>
    static std::vector<double> radii(const Cloud& cloud, const StarConstruction& construction, double neighbor_radius)
    {
      internal::Stored_visitor<Default_visitor> visitor;
      internal::Progress<internal::Any_visitor> progress(std::function<bool(double)>(), visitor);
      const internal::Point_octree_3 octree(cloud.positions());
      const double maximum =
        neighbor_radius > 0. ? cloud.local_length(neighbor_radius) : std::numeric_limits<double>::infinity();
      return internal::star_radii(cloud.positions(), internal::construct_stars<Sequential_tag>(
                                                       cloud.positions(), octree, construction, maximum, progress));
    }

    const Cloud cloud;
    const internal::Linear_pieces pieces;
    Bbox_3 bbox;
  };

  internal::Local_point local_point(const Point_3& p) const
  {
    auto c = m_data->cloud.traits().construct_cartesian_const_iterator_3_object()(p);
    const double x = CGAL::to_double(*c++), y = CGAL::to_double(*c++), z = CGAL::to_double(*c);
    return m_data->cloud.local_point(x, y, z);
  }

  std::shared_ptr<const Data> m_data;
  Weight m_weight;
};

} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_LINEAR_IMPLICIT_FUNCTION_3_H

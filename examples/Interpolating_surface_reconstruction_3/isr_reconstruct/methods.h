#ifndef ISR_RECONSTRUCT_METHODS_H
#define ISR_RECONSTRUCT_METHODS_H

#include "point_file.h"
#include "point_properties.h"

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>
#include <CGAL/ctc_reconstruction.h>
#include <CGAL/lis_reconstruction.h>
#include <CGAL/pcr_reconstruction.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <string>

namespace isr {

struct Reconstruction_options
{
  std::string method = "ctc";
  bool keep_boundaries = false;
  std::size_t maximum_hole_size = (std::numeric_limits<std::size_t>::max)();
  double neighbor_radius = 0.; // none
  double grid_spacing = 0.;    // no finer than the points
  std::size_t threads = 1;
  bool use_normals = true;
};

// What the summary says about the points.
struct Point_counter : CGAL::Interpolating_surface_reconstruction_3::Default_visitor
{
  void on_points_set_aside(std::size_t duplicate_points, std::size_t non_finite_points)
  {
    duplicates = duplicate_points;
    non_finite = non_finite_points;
  }

  void on_points_unused(std::size_t unused_points) { unused = unused_points; }

  std::size_t duplicates = 0, non_finite = 0, unused = 0;
};

using Callback = std::function<bool(double)>;

namespace internal {

struct Ctc
{
  static auto parameters(const Reconstruction_options& options)
  {
    return CGAL::parameters::maximum_hole_size(options.maximum_hole_size);
  }

  template <typename ConcurrencyTag, typename NamedParameters>
  static bool run(const Point_set& points, Mesh& mesh, const NamedParameters& np)
  {
    return CGAL::ctc_reconstruction<ConcurrencyTag>(points, mesh, np);
  }
};

struct Pcr
{
  static auto parameters(const Reconstruction_options& options)
  {
    return CGAL::parameters::maximum_hole_size(options.maximum_hole_size);
  }

  template <typename ConcurrencyTag, typename NamedParameters>
  static bool run(const Point_set& points, Mesh& mesh, const NamedParameters& np)
  {
    return CGAL::pcr_reconstruction<ConcurrencyTag>(points, mesh, np);
  }
};

struct Lis
{
  static auto parameters(const Reconstruction_options& options)
  {
    return CGAL::parameters::grid_spacing(options.grid_spacing);
  }

  template <typename ConcurrencyTag, typename NamedParameters>
  static bool run(const Point_set& points, Mesh& mesh, const NamedParameters& np)
  {
    return CGAL::lis_reconstruction<ConcurrencyTag>(points, mesh, np);
  }
};

template <typename Method, typename NamedParameters>
bool run_on_threads(const Point_set& points, Mesh& mesh, std::size_t threads, const NamedParameters& np)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (threads > 1) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return Method::template run<CGAL::Parallel_tag>(points, mesh, np);
  }
#else
  static_cast<void>(threads);
#endif
  return Method::template run<CGAL::Sequential_tag>(points, mesh, np);
}

template <typename Method>
bool run(const Point_set& points, Mesh& mesh, const Reconstruction_options& options, Point_counter& counter,
         const Callback& callback)
{
  namespace parameters = CGAL::parameters;

  const auto np = parameters::combine(Method::parameters(options), parameters::keep_boundaries(options.keep_boundaries),
                                      parameters::point_map(points.point_map())
                                        .neighbor_radius(options.neighbor_radius)
                                        .callback(callback)
                                        .visitor(std::ref(counter)));
  if (options.use_normals && points.has_normal_map())
    return run_on_threads<Method>(points, mesh, options.threads,
                                  parameters::combine(np, parameters::normal_map(points.normal_map())));
  return run_on_threads<Method>(points, mesh, options.threads, np);
}

using Method = bool (*)(const Point_set&, Mesh&, const Reconstruction_options&, Point_counter&, const Callback&);

} // namespace internal

// The methods by the name that --method takes.
inline const std::map<std::string, internal::Method>& methods()
{
  static const std::map<std::string, internal::Method> all = { { "ctc", internal::run<internal::Ctc> },
                                                               { "pcr", internal::run<internal::Pcr> },
                                                               { "lis", internal::run<internal::Lis> } };
  return all;
}

} // namespace isr

#endif // ISR_RECONSTRUCT_METHODS_H

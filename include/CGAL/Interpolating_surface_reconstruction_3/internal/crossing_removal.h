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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CROSSING_REMOVAL_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CROSSING_REMOVAL_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Kept_triangulation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Label_search.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Surface_sides.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelled_surface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/orientation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_area.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_crossings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_exchange.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_rings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/vertex_normals.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Replaces closed components that cross themselves or each other, as holes can make them that are closed without
// regard to what is near, and those with holes that could not be closed. Delaunay facets do not cross: the cells of
// the points of a component are labelled by the side of the surface on which they are and, around crossings and
// holes, by the linear implicit function of its normals (thesis 5.2); then the surface between the labels is bent as
// little as possible there.
template <typename ConcurrencyTag, typename Builder>
class Crossing_removal
{
public:
  using Triangle = typename Builder::Triangle;

  // `normals` of the points orient the components, or none, which then face outward.
  Crossing_removal(const std::vector<Local_point>& points, const std::vector<Local_vector>& normals, Builder& builder,
                   Kept_triangulation& triangulation)
    : m_points(points), m_given_normals(normals), m_builder(builder), m_triangulation(triangulation)
  { }

  // Only triangles stored from `first` on may cross others; the increasing points `unclosed` are on holes that could
  // not be closed. Returns whether the surface has changed. Points may be left out, and small holes left. Ends early if
  // cancelled.
  template <typename Progress>
  bool operator()(typename Builder::Triangle_index first, const std::vector<Point_index>& unclosed, Progress& progress)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    bool is_changed = false;
    try {
      find_small_components(cancellation_point);
      if (!find_crossings(first, unclosed, cancellation_point))
        return false;
      find_normals(progress);
      find_doubts(cancellation_point);
      m_is_visited.assign(m_points.size(), 0);
      for (const Crossing& crossing : m_crossings)
        if (collect_component(crossing.first, cancellation_point) && m_component.size() <= m_points_left &&
            is_closed_but_for(unclosed)) {
          m_points_left -= m_component.size();
          is_changed = replace(reconstruct(progress, cancellation_point), cancellation_point) || is_changed;
        }
    } catch (const Cancelled&) {
    }
    return is_changed;
  }

private:
  using Crossing = typename Surface_crossings<Builder>::Crossing;
  using Triangles = std::vector<Triangle>;

  // Triangles around those that cross which may be wrong, too.
  static constexpr int RINGS_IN_DOUBT = 2;

  // A surface of so many times the area has sheets where there was none.
  static constexpr double MAXIMUM_GROWTH = 2.;

  // Of the components that are replaced, all together: it costs several times what all else does.
  static constexpr std::size_t MAXIMUM_POINTS = Kept_triangulation::MAXIMUM_POINTS;

  // The replacement of a component may touch itself, but only at few points: the most triangles that are left out there,
  // in parts of all.
  static constexpr std::size_t PART_LEFT_OUT = 64;

  // Changes of labels that the search may try at each point in doubt.
  static constexpr std::size_t SEARCH_EFFORT_PER_POINT = 256;

  // Marks the points of components that are not too large to be replaced: crossings of others need not be found.
  template <typename CancellationPoint>
  void find_small_components(CancellationPoint& cancellation_point)
  {
    m_is_small.assign(m_points.size(), 1);
    if (m_points.size() <= MAXIMUM_POINTS)
      return;
    Parity_union_find components(m_points.size());
    m_builder.for_each_triangle([&](const Triangle& t, auto) {
      cancellation_point();
      components.unite(t[0], t[1], false);
      components.unite(t[0], t[2], false);
    });
    std::vector<std::size_t> sizes(m_points.size(), 0);
    for (Point_index p = 0; p != m_points.size(); ++p)
      ++sizes[components.find(p).root];
    for (Point_index p = 0; p != m_points.size(); ++p)
      m_is_small[p] = sizes[components.find(p).root] <= MAXIMUM_POINTS ? 1 : 0;
  }

  // From either side; false if there are none. Points on holes, and what their stars see, are treated as crossing.
  template <typename CancellationPoint>
  bool find_crossings(typename Builder::Triangle_index first, const std::vector<Point_index>& unclosed,
                      CancellationPoint& cancellation_point)
  {
    const auto is_suspect = [&](Triangle t) {
      std::sort(t.begin(), t.end());
      return !std::binary_search(m_kept.begin(), m_kept.end(), t);
    };
    m_crossings = Surface_crossings<Builder>(m_points, m_builder)(
      first, is_suspect, [&](const Triangle& t) { return m_is_small[t[0]] != 0; }, cancellation_point);
    m_kept.clear();
    const Star_table& stars = m_builder.compatibility().stars();
    for (Point_index p : unclosed)
      for (Star_table::Slot s = stars.begin(p); s != stars.end(p); ++s)
        if (stars.neighbor(s) != NO_POINT)
          m_crossings.emplace_back(p, stars.neighbor(s));
    for (std::size_t i = 0, n = m_crossings.size(); i != n; ++i)
      m_crossings.emplace_back(m_crossings[i].second, m_crossings[i].first);
    std::sort(m_crossings.begin(), m_crossings.end());
    return !m_crossings.empty();
  }

  // Also the triangles, oriented.
  template <typename Progress>
  void find_normals(Progress& progress)
  {
    m_triangles = oriented_triangles(m_points, m_given_normals, m_builder, [&] { return progress.advance(0.); });
    m_normals = vertex_normals(m_points, m_triangles);
  }

  template <typename CancellationPoint>
  void find_doubts(CancellationPoint& cancellation_point)
  {
    std::vector<Point_index> points;
    for (const Crossing& crossing : m_crossings)
      points.push_back(crossing.first);
    m_is_in_doubt = mark_rings(m_builder, points, RINGS_IN_DOUBT, cancellation_point);
  }

  // The points of the component around p and of those that cross it; false if that has been done.
  template <typename CancellationPoint>
  bool collect_component(Point_index p, CancellationPoint& cancellation_point)
  {
    if (m_is_visited[p])
      return false;
    m_component.clear();
    visit(p);
    for (std::size_t i = 0; i != m_component.size(); ++i) {
      cancellation_point();
      const Point_index q = m_component[i];
      m_builder.for_each_triangle_at(q, [&](const Triangle& t) {
        for (Point_index r : t)
          visit(r);
      });
      for (auto it = std::lower_bound(m_crossings.begin(), m_crossings.end(), Crossing(q, 0));
           it != m_crossings.end() && it->first == q; ++it)
        visit(it->second);
    }
    std::sort(m_component.begin(), m_component.end());
    return true;
  }

  void visit(Point_index p)
  {
    if (!m_is_visited[p]) {
      m_is_visited[p] = 1;
      m_component.push_back(p);
    }
  }

  bool is_closed_but_for(const std::vector<Point_index>& unclosed) const
  {
    return std::none_of(m_component.begin(), m_component.end(), [&](Point_index p) {
      return m_builder.is_open(p) && m_builder.number_of_boundary_edges(p) != 0 &&
             !std::binary_search(unclosed.begin(), unclosed.end(), p);
    });
  }

  // A surface through the points of the component, empty if there is none that is not much larger.
  template <typename Progress, typename CancellationPoint>
  Triangles reconstruct(Progress& progress, CancellationPoint& cancellation_point)
  {
    const std::shared_ptr<const Cell_complex> kept = m_triangulation(m_component, cancellation_point);
    const Cell_complex& cells = *kept;
    if (cells.size() == 0)
      return Triangles();
    Triangles old;
    std::copy_if(m_triangles.begin(), m_triangles.end(), std::back_inserter(old),
                 [&](const Triangle& t) { return std::binary_search(m_component.begin(), m_component.end(), t[0]); });
    const double old_area = surface_area(m_points, old);
    Oriented_labelling labelling = label(cells, std::move(old), progress, cancellation_point);
    make_nearly_manifold(cells, labelling, cancellation_point);
    bend_less(cells, labelling, cancellation_point);
    make_nearly_manifold(cells, labelling, cancellation_point);
    Triangles result = facets_between_labels(cells, labelling, cancellation_point);
    return surface_area(m_points, result) > MAXIMUM_GROWTH * old_area ? Triangles() : result;
  }

  template <typename Progress, typename CancellationPoint>
  Oriented_labelling label(const Cell_complex& cells, Triangles triangles, Progress& progress,
                           CancellationPoint& cancellation_point)
  {
    const Surface_sides sides(cells, std::move(triangles), m_is_in_doubt, cancellation_point);
    return label_by_sides<ConcurrencyTag>(cells, sides, m_points, m_normals, progress, cancellation_point);
  }

  template <typename CancellationPoint>
  void bend_less(const Cell_complex& cells, Oriented_labelling& labelling, CancellationPoint& cancellation_point)
  {
    const auto is_in_doubt = [&](Cell_complex::Cell_index c) {
      const auto& vertices = cells[c].vertices;
      return std::any_of(vertices.begin(), vertices.end(), [&](Point_index p) { return m_is_in_doubt[p] != 0; });
    };
    Label_search<Oriented_labelling> search(
      cells, m_points, labelling, is_in_doubt, is_in_doubt, [](auto...) { return false; }, [](auto) { return true; },
      cancellation_point);
    const auto doubts =
      std::count_if(m_component.begin(), m_component.end(), [&](Point_index p) { return m_is_in_doubt[p] != 0; });
    Search_effort effort{ SEARCH_EFFORT_PER_POINT * static_cast<std::size_t>(doubts), 0 };
    search(effort, cancellation_point);
  }

  // Exchanges the triangles of the component for the given ones, or none. Returns whether it did.
  template <typename CancellationPoint>
  bool replace(Triangles added, CancellationPoint& cancellation_point)
  {
    if (added.empty())
      return false;
    Triangles removed =
      exchange_triangles(m_builder, m_component, added, cancellation_point, added.size() / PART_LEFT_OUT);
    if (removed.empty())
      return false;
    keep(std::move(removed), std::move(added));
    return true;
  }

  // Remembers the triangles that are in both surfaces: their crossings have been found before.
  void keep(Triangles old, Triangles replacement)
  {
    for (Triangles* triangles : { &old, &replacement }) {
      for (Triangle& t : *triangles)
        std::sort(t.begin(), t.end());
      std::sort(triangles->begin(), triangles->end());
    }
    const auto middle = static_cast<std::ptrdiff_t>(m_kept.size());
    std::set_intersection(old.begin(), old.end(), replacement.begin(), replacement.end(), std::back_inserter(m_kept));
    std::inplace_merge(m_kept.begin(), m_kept.begin() + middle, m_kept.end());
  }

  const std::vector<Local_point>& m_points;
  const std::vector<Local_vector>& m_given_normals;
  Builder& m_builder;
  Kept_triangulation& m_triangulation;
  std::vector<Crossing> m_crossings; // from either side, sorted
  Triangles m_triangles;             // of the surface as it was, oriented
  Triangles m_kept;                  // by replacements since then, sorted, with increasing vertices
  std::vector<Local_vector> m_normals;
  std::size_t m_points_left = MAXIMUM_POINTS;
  std::vector<unsigned char> m_is_small, m_is_in_doubt, m_is_visited; // of each point
  std::vector<Point_index> m_component;                               // the current one, increasing
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CROSSING_REMOVAL_H

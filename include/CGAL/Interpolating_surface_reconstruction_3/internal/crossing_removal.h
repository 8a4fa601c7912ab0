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
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Label_search.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Oriented_labelling.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/cell_signs.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/label_relaxation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/labelled_surface.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/orientation.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/surface_crossings.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/vertex_normals.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Replaces closed components that cross themselves or each other by the linear implicit surface of their
// normals (thesis 5.2), bent as little as possible: it consists of Delaunay facets, which do not cross.
template <typename ConcurrencyTag, typename Builder>
class Crossing_removal
{
public:
  using Triangle = typename Builder::Triangle;

  // `normals` of the points orient the components, or none, which then face outward.
  Crossing_removal(const std::vector<Local_point>& points, const std::vector<Local_vector>& normals, Builder& builder)
    : m_points(points), m_given_normals(normals), m_builder(builder)
  { }

  // Only triangles stored from `first` on may cross others. Returns whether the surface has changed. Ends early if
  // cancelled.
  template <typename Progress>
  bool operator()(typename Builder::Triangle_index first, Progress& progress)
  {
    Cancellation_point<Progress> cancellation_point(progress);
    bool is_changed = false;
    try {
      find_crossings(first, cancellation_point);
      for (const auto& crossing : m_crossings)
        if (collect_component(crossing.first) && is_closed())
          is_changed = replace(reconstruct(progress, cancellation_point), cancellation_point) || is_changed;
    } catch (const Cancelled&) {
    }
    return is_changed;
  }

private:
  using Triangles = std::vector<Triangle>;

  // Changes of labels that the search may try: enough for a few thousand points, and some for every point where
  // there are more.
  static constexpr std::size_t SEARCH_EFFORT = 500000, SEARCH_EFFORT_PER_POINT = 10;

  // From either side.
  template <typename CancellationPoint>
  void find_crossings(typename Builder::Triangle_index first, CancellationPoint& cancellation_point)
  {
    m_crossings = Surface_crossings<Builder>(m_points, m_builder)(first, cancellation_point);
    const std::size_t n = m_crossings.size();
    for (std::size_t i = 0; i != n; ++i)
      m_crossings.emplace_back(m_crossings[i].second, m_crossings[i].first);
    std::sort(m_crossings.begin(), m_crossings.end());
    if (n == 0)
      return;
    m_is_visited.assign(m_points.size(), 0);
    find_normals();
  }

  void find_normals()
  {
    Surface_orientation<Builder> orientation(m_points, m_builder);
    if (m_given_normals.empty())
      orientation.face_outward();
    else
      orientation.align_with_normals([&](Point_index p) { return m_given_normals[p]; });
    Triangles triangles;
    orientation.for_each_oriented_triangle([&](const Triangle& t) { triangles.push_back(t); });
    m_normals = vertex_normals(m_points, triangles);
  }

  // The points of the components around p and of those that cross these; false if that has been done.
  bool collect_component(Point_index p)
  {
    if (m_is_visited[p])
      return false;
    m_component.clear();
    visit(p);
    for (std::size_t i = 0; i != m_component.size(); ++i) {
      m_builder.for_each_triangle_at(m_component[i], [&](const Triangle& t) {
        for (Point_index q : t)
          visit(q);
      });
      for (auto it = std::lower_bound(m_crossings.begin(), m_crossings.end(),
                                      typename Surface_crossings<Builder>::Crossing(m_component[i], 0));
           it != m_crossings.end() && it->first == m_component[i]; ++it)
        visit(it->second);
    }
    return true;
  }

  void visit(Point_index p)
  {
    if (!m_is_visited[p]) {
      m_is_visited[p] = 1;
      m_component.push_back(p);
    }
  }

  bool is_closed() const
  {
    return std::none_of(m_component.begin(), m_component.end(),
                        [&](Point_index p) { return m_builder.is_open(p) && m_builder.number_of_boundary_edges(p) != 0; });
  }

  // A surface through the points of the component, empty if there is none.
  template <typename Progress, typename CancellationPoint>
  Triangles reconstruct(Progress& progress, CancellationPoint& cancellation_point)
  {
    const Cell_complex cells(m_points, m_component, cancellation_point);
    if (cells.size() == 0)
      return Triangles();
    const Cell_signs signs(cells, m_points, m_normals);
    Oriented_labelling labelling(cells, m_points, m_normals,
                                 signs.template compute<ConcurrencyTag>([&] { return progress.advance(0.); }));
    relax_labels(cells, labelling, cancellation_point);
    make_manifold(cells, labelling, cancellation_point);
    bend_less(cells, labelling, cancellation_point);
    make_manifold(cells, labelling, cancellation_point);
    return facets_between_labels(cells, labelling, cancellation_point);
  }

  template <typename CancellationPoint>
  void bend_less(const Cell_complex& cells, Oriented_labelling& labelling, CancellationPoint& cancellation_point)
  {
    const auto always = [](auto...) { return true; };
    Label_search<Oriented_labelling> search(
      cells, m_points, labelling, always, always, [](auto...) { return false; }, always, cancellation_point);
    std::size_t effort = SEARCH_EFFORT + SEARCH_EFFORT_PER_POINT * m_component.size();
    search(effort, cancellation_point);
  }

  // Exchanges the triangles of the component for the given ones, or none. Returns whether it did.
  template <typename CancellationPoint>
  bool replace(Triangles added, CancellationPoint& cancellation_point)
  {
    if (added.empty())
      return false;
    Triangles removed;
    for (Point_index p : m_component) {
      cancellation_point();
      m_builder.open(p);
      m_builder.for_each_triangle_at(p, [&](const Triangle& t) {
        if (t[0] < t[1] && t[0] < t[2])
          removed.push_back(t);
      });
    }
    for (const Triangle& t : removed)
      remove(t);
    std::sort(added.begin(), added.end());
    for (std::size_t i = 0; i != added.size(); ++i)
      if (m_builder.try_add(added[i][0], added[i][1], added[i][2]) != Triangle_verdict::ADDED) {
        while (i-- != 0)
          remove(added[i]);
        for (const Triangle& t : removed)
          m_builder.restore(t);
        return false;
      }
    return true;
  }

  void remove(const Triangle& t) { m_builder.remove(m_builder.find_triangle(t[0], t[1], t[2])); }

  const std::vector<Local_point>& m_points;
  const std::vector<Local_vector>& m_given_normals;
  Builder& m_builder;
  std::vector<typename Surface_crossings<Builder>::Crossing> m_crossings; // from either side, sorted
  std::vector<Local_vector> m_normals;
  std::vector<unsigned char> m_is_visited; // of each point
  std::vector<Point_index> m_component;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CROSSING_REMOVAL_H

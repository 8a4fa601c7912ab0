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
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Sites_around_doubts.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Surface_sides.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/island_removal.h>
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
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Makes closed components that cross themselves or each other anew around the crossings, as holes can make them that are
// closed without regard to what is near, and those with holes that could not be closed around these. Delaunay facets do
// not cross: the cells of the points of a component are labelled by the side of the surface on which they are and,
// around crossings and holes, by the linear implicit function of its normals (thesis 5.2); then the surface between the
// labels is bent as little as possible there. Of a large component with few crossings, the points around these and some
// of the others are enough.
template <typename ConcurrencyTag, typename Builder>
class Crossing_removal
{
public:
  using Triangle = typename Builder::Triangle;

  // `normals` of the points orient the components, or none, which then face outward.
  Crossing_removal(const std::vector<Local_point>& points, const std::vector<Local_vector>& normals,
                   const Point_octree_3& octree, double maximum_radius, Builder& builder,
                   Kept_triangulation& triangulation)
    : m_points(points), m_given_normals(normals), m_builder(builder), m_triangulation(triangulation),
      m_sites(points, octree, maximum_radius, builder)
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
      if (!find_crossings(first, unclosed, cancellation_point))
        return false;
      m_builder.reset_orientations(cancellation_point);
      find_normals(progress);
      find_doubts(cancellation_point);
      m_is_unsure.assign(m_points.size(), 0);
      m_is_visited.assign(m_points.size(), 0);
      for (const Crossing& crossing : m_crossings)
        if (collect_component(crossing.first, cancellation_point) && is_closed_but_for(unclosed))
          is_changed = replace_part(progress, cancellation_point) || is_changed;
    } catch (const Cancelled&) {
    }
    return is_changed;
  }

  // Found by the last call, from either side, and with the points on holes.
  std::size_t number_of_crossings() const { return m_crossings.size(); }

private:
  using Crossing = typename Surface_crossings<Builder>::Crossing;
  using Triangles = std::vector<Triangle>;

  // Triangles around those that cross which may be wrong, too.
  static constexpr int RINGS_IN_DOUBT = 2;

  // A surface of so many times the area has sheets where there was none.
  static constexpr double MAXIMUM_GROWTH = 2.;

  // The replacement of a component may touch itself, but only at few points: the most triangles that are left out there,
  // in parts of all.
  static constexpr std::size_t PART_LEFT_OUT = 64;

  // Changes of labels that the search may try at each point in doubt.
  static constexpr std::size_t SEARCH_EFFORT_PER_POINT = 256;

  // From either side; false if there are none. Points on holes, and what their stars see, are treated as crossing.
  template <typename CancellationPoint>
  bool find_crossings(typename Builder::Triangle_index first, const std::vector<Point_index>& unclosed,
                      CancellationPoint& cancellation_point)
  {
    m_crossings = Surface_crossings<Builder>(m_points, m_builder)(first, cancellation_point);
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

  // Also the triangles, oriented, each from its smallest point on, in order.
  template <typename Progress>
  void find_normals(Progress& progress)
  {
    m_triangles = oriented_triangles(m_points, m_given_normals, m_builder, [&] { return progress.advance(0.); });
    m_normals = vertex_normals(m_points, m_triangles);
    for (Triangle& t : m_triangles)
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(m_triangles.begin(), m_triangles.end());
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

  // What of the component gives way to what.
  struct Exchange
  {
    Triangles removed, added;
  };

  // Makes the component anew where it is in doubt, unless it becomes much larger. Returns whether it has changed.
  template <typename Progress, typename CancellationPoint>
  bool replace_part(Progress& progress, CancellationPoint& cancellation_point)
  {
    m_sites.find(m_component, m_is_in_doubt, cancellation_point);
    const std::shared_ptr<const Cell_complex> kept = m_triangulation(m_sites.sites(), cancellation_point);
    const Cell_complex& cells = *kept;
    if (cells.size() == 0)
      return false;
    for (Point_index p : m_sites.sites())
      m_is_unsure[p] = m_is_in_doubt[p];
    for (Point_index p : m_sites.incomplete())
      m_is_unsure[p] = 1;
    const Surface_sides sides(cells, triangles_of_sites(), m_is_unsure, cancellation_point);
    doubt_triangles_without_facet(sides);
    Oriented_labelling labelling =
      label_by_sides<ConcurrencyTag>(cells, sides, m_points, m_normals, progress, cancellation_point);
    make_nearly_manifold(cells, labelling, cancellation_point);
    bend_less(cells, labelling, cancellation_point);
    make_nearly_manifold(cells, labelling, cancellation_point);
    Exchange exchange = find_exchange(cells, sides, labelling, cancellation_point);
    const double area = surface_area(m_points, sides.triangles()),
                 growth = surface_area(m_points, exchange.added) - surface_area(m_points, exchange.removed);
    const std::size_t size = sides.triangles().size() + exchange.added.size() - exchange.removed.size();
    return (!exchange.added.empty() || is_vanishing_island(exchange, sides)) &&
           area + growth <= MAXIMUM_GROWTH * area &&
           exchange_triangles(m_builder, exchange.removed, std::move(exchange.added), size / PART_LEFT_OUT,
                              cancellation_point);
  }

  // Whether all of the component goes, which is no body then, and its points belong to what is around.
  bool is_vanishing_island(const Exchange& exchange, const Surface_sides& sides) const
  {
    return exchange.removed.size() == sides.triangles().size() && m_sites.incomplete().empty() &&
           are_among_others(m_builder.compatibility().stars(), m_component);
  }

  // Those of the surface between sites.
  Triangles triangles_of_sites() const
  {
    const std::vector<Point_index>& sites = m_sites.sites();
    const auto is_site = [&](Point_index p) { return std::binary_search(sites.begin(), sites.end(), p); };
    Triangles result;
    for (Point_index p : sites)
      for (auto t = std::lower_bound(m_triangles.begin(), m_triangles.end(), Triangle{ { p, 0, 0 } });
           t != m_triangles.end() && (*t)[0] == p; ++t)
        if (is_site((*t)[1]) && is_site((*t)[2]))
          result.push_back(*t);
    return result;
  }

  // But those at incomplete sites.
  void doubt_triangles_without_facet(const Surface_sides& sides)
  {
    const std::vector<Point_index>& incomplete = m_sites.incomplete();
    const auto is_incomplete = [&](Point_index p) {
      return std::binary_search(incomplete.begin(), incomplete.end(), p);
    };
    for (std::size_t k = 0; k != sides.triangles().size(); ++k) {
      const Triangle& t = sides.triangles()[k];
      if (!sides.is_facet(k) && std::none_of(t.begin(), t.end(), is_incomplete))
        for (Point_index p : t)
          m_is_in_doubt[p] = 1;
    }
  }

  template <typename Vertices>
  static bool has_marked(const Vertices& vertices, const std::vector<unsigned char>& is_marked)
  {
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](Point_index p) { return p != NO_POINT && is_marked[p] != 0; });
  }

  template <typename CancellationPoint>
  void bend_less(const Cell_complex& cells, Oriented_labelling& labelling, CancellationPoint& cancellation_point)
  {
    const auto is_in_doubt = [&](Cell_complex::Cell_index c) { return has_marked(cells[c].vertices, m_is_in_doubt); };
    Label_search<Oriented_labelling> search(
      cells, m_points, labelling, is_in_doubt, is_in_doubt, [](auto...) { return false; }, [](auto) { return true; },
      cancellation_point);
    const auto doubts =
      std::count_if(m_component.begin(), m_component.end(), [&](Point_index p) { return m_is_in_doubt[p] != 0; });
    Search_effort effort{ SEARCH_EFFORT_PER_POINT * static_cast<std::size_t>(doubts), 0 };
    search(effort, cancellation_point);
  }

  // Where the labels may give another surface than before, triangles that are not between labels go and facets that are
  // come: at points in doubt, beside cells whose labels have left their sides, and between cells of unknown sides.
  template <typename CancellationPoint>
  Exchange find_exchange(const Cell_complex& cells, const Surface_sides& sides, const Oriented_labelling& labelling,
                         CancellationPoint& cancellation_point) const
  {
    const Triangles& old = sides.triangles();
    std::vector<unsigned char> goes(old.size(), 0);
    for (std::size_t k = 0; k != old.size(); ++k)
      goes[k] = !sides.is_facet(k) && has_marked(old[k], m_is_in_doubt) ? 1 : 0;
    Exchange result;
    for (Cell_complex::Cell_index c = 0; c != cells.size(); ++c)
      for (std::size_t i = 0; i != 4; ++i) {
        cancellation_point();
        const Cell_complex::Cell_index n = cells[c].neighbors[i];
        const Triangle f = Cell_complex::facet(cells[c], i);
        if (n < c || Cell_complex::is_infinite(f) || !may_differ(c, n, f, sides, labelling))
          continue;
        // Seen from its cell, a facet of even index is in counterclockwise order.
        Triangle outward = labelling.label(c) == (i % 2 == 0) ? f : Triangle{ { f[0], f[2], f[1] } };
        std::rotate(outward.begin(), std::min_element(outward.begin(), outward.end()), outward.end());
        const auto reversed = find(old, Triangle{ { outward[0], outward[2], outward[1] } });
        if (reversed != old.size())
          goes[reversed] = 1;
        const auto same = find(old, outward);
        if (labelling.is_surface(c, i) && same == old.size())
          result.added.push_back(outward);
        else if (!labelling.is_surface(c, i) && same != old.size())
          goes[same] = 1;
      }
    for (std::size_t k = 0; k != old.size(); ++k)
      if (goes[k] != 0)
        result.removed.push_back(old[k]);
    return result;
  }

  // Whether the labels of a facet's cells may differ where the surface was not, or the other way round.
  bool may_differ(Cell_complex::Cell_index c, Cell_complex::Cell_index n, const Triangle& f, const Surface_sides& sides,
                  const Oriented_labelling& labelling) const
  {
    using Side = Surface_sides::Side;
    const auto has_left_its_side = [&](Cell_complex::Cell_index d) {
      return sides[d] != Side::UNKNOWN && (sides[d] == Side::INSIDE) != labelling.label(d);
    };
    return has_marked(f, m_is_in_doubt) || has_left_its_side(c) || has_left_its_side(n) ||
           (sides[c] == Side::UNKNOWN && sides[n] == Side::UNKNOWN && !has_marked(f, m_is_unsure));
  }

  // The position of a triangle among sorted ones, or their number.
  static std::size_t find(const Triangles& triangles, const Triangle& t)
  {
    const auto it = std::lower_bound(triangles.begin(), triangles.end(), t);
    return it != triangles.end() && *it == t ? static_cast<std::size_t>(it - triangles.begin()) : triangles.size();
  }

  const std::vector<Local_point>& m_points;
  const std::vector<Local_vector>& m_given_normals;
  Builder& m_builder;
  Kept_triangulation& m_triangulation;
  std::vector<Crossing> m_crossings; // from either side, sorted
  Triangles m_triangles;             // of the surface as it was, oriented, in order
  std::vector<Local_vector> m_normals;
  std::vector<unsigned char> m_is_in_doubt, m_is_unsure, m_is_visited; // of each point
  std::vector<Point_index> m_component;                                // the current one, increasing
  Sites_around_doubts<Builder> m_sites;                                // of the component
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_CROSSING_REMOVAL_H

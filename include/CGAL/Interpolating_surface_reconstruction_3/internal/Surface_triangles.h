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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_TRIANGLES_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_TRIANGLES_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/star_compatibility.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// The triangles of a surface and its neighborhoods; what may be attached is for Manifold_builder to say.
//
// Points are closed or open. At a closed point the surface is the agreed star and nothing is stored;
// at an open point the triangles are stored and change. Points on which the stars do not agree are
// open from the beginning, so that the work is proportional to the conflicts.
class Surface_triangles
{
public:
  using Triangle_index = std::uint32_t;
  using Triangle = std::array<Point_index, 3>;

  static constexpr Triangle_index NO_TRIANGLE = NO_POINT;

  // The triangle at an open point, as the edge (a, b) of the link: oriented (point, a, b).
  struct Corner
  {
    Triangle_index triangle;
    Point_index a, b;
  };
  using Corners = boost::container::small_vector<Corner, 7>;

  explicit Surface_triangles(Star_compatibility& compatibility)
    : m_compatibility(compatibility), m_slots(compatibility.stars().size(), NO_POINT)
  {
    for (Point_index p = 0; p != m_slots.size(); ++p)
      if (!compatibility.is_point_agreed(p) || compatibility.is_point_on_boundary(p))
        open(p);
  }

  const Star_compatibility& compatibility() const { return m_compatibility; }
  Point_index number_of_points() const { return static_cast<Point_index>(m_slots.size()); }

  bool is_open(Point_index p) const { return m_slots[p] != NO_POINT; }
  // Points that are open, in the order in which they were opened.
  const std::vector<Point_index>& open_points() const { return m_open_points; }

  // Makes the triangles at a closed point changeable.
  void open(Point_index p)
  {
    if (is_open(p))
      return;
    m_slots[p] = static_cast<Point_index>(m_open_points.size());
    m_open_points.push_back(p);
    m_corners.emplace_back();
    m_compatibility.for_each_agreed_triangle(p, [&](Star_table::Slot s, Point_index, Point_index a, Point_index b) {
      Triangle_index t = is_open(a) ? find_triangle(a, b, p) : is_open(b) ? find_triangle(b, p, a) : NO_TRIANGLE;
      if (t == NO_TRIANGLE) {
        t = static_cast<Triangle_index>(m_triangles.size());
        const Star_compatibility::Tie tie = m_compatibility.tie(p, s);
        m_triangles.push_back(
          Stored_triangle{ tie.is_flipped ? Triangle{ { p, b, a } } : Triangle{ { p, a, b } }, tie.star });
      }
      m_corners.back().push_back(corner(t, p));
    });
  }

  const Corners& corners(Point_index p) const { return m_corners[m_slots[p]]; }
  // Vertices of a stored triangle, oriented like its orientation element.
  const Triangle& triangle(Triangle_index t) const { return m_triangles[t].vertices; }
  bool is_removed(Triangle_index t) const { return m_triangles[t].vertices[0] == NO_POINT; }
  std::size_t number_of_stored_triangles() const { return m_triangles.size(); }

  // Orientation of a stored triangle against the representative of its connected part.
  Parity_union_find::Oriented_root orientation(Triangle_index t)
  {
    return m_compatibility.orientations().find(m_triangles[t].orientation);
  }
  Parity_union_find& orientations() { return m_compatibility.orientations(); }

  // Number of triangles at the edge between an open point and another one.
  int number_of_triangles(Point_index p, Point_index q) const
  {
    int result = 0;
    for (const Corner& c : corners(p))
      result += (c.a == q || c.b == q) ? 1 : 0;
    return result;
  }

  // The triangle of the open point p with the vertices q and r, or NO_TRIANGLE.
  Triangle_index find_triangle(Point_index p, Point_index q, Point_index r) const
  {
    for (const Corner& c : corners(p))
      if ((c.a == q && c.b == r) || (c.a == r && c.b == q))
        return c.triangle;
    return NO_TRIANGLE;
  }

  // Orientation of the triangle (p, q, r) against the representative of its connected part, if the
  // surface has the triangle. Several threads may ask.
  std::optional<Parity_union_find::Oriented_root> orientation(Point_index p, Point_index q, Point_index r) const
  {
    const Parity_union_find& orientations = compatibility().orientations();
    if (!is_open(p)) {
      const Star_table::View view = m_compatibility.stars().view(p, q, r);
      if (view == Star_table::View::ABSENT)
        return std::nullopt;
      const Parity_union_find::Oriented_root star = orientations.find(p);
      return Parity_union_find::Oriented_root{ star.root,
                                               star.is_flipped != (view == Star_table::View::OPPOSITE_ORIENTATION) };
    }
    for (const Corner& c : corners(p))
      if ((c.a == q && c.b == r) || (c.a == r && c.b == q)) {
        const Parity_union_find::Oriented_root stored = orientations.find(m_triangles[c.triangle].orientation);
        return Parity_union_find::Oriented_root{ stored.root, stored.is_flipped != (c.a == r) };
      }
    return std::nullopt;
  }

  // Calls visit(triangle) for the triangles at a point, open or closed.
  template <typename Visit>
  void for_each_triangle_at(Point_index p, Visit visit) const
  {
    if (is_open(p))
      for (const Corner& c : corners(p))
        visit(Triangle{ { p, c.a, c.b } });
    else
      m_compatibility.for_each_agreed_triangle(p, [&](Star_table::Slot, Point_index, Point_index a, Point_index b) {
        visit(Triangle{ { p, a, b } });
      });
  }

  // The third vertex of a triangle at the edge (p, q) of an open point p, or NO_POINT.
  Point_index opposite_vertex(Point_index p, Point_index q) const
  {
    for (const Corner& c : corners(p))
      if (c.a == q || c.b == q)
        return c.a == q ? c.b : c.a;
    return NO_POINT;
  }

  // Number of boundary edges at an open point: two of each fan that is not closed.
  std::size_t number_of_boundary_edges(Point_index p) const
  {
    std::size_t result = 0;
    if (corners(p).size() > MAXIMUM_SEARCHED_DEGREE) {
      const std::vector<Link_end> ends = sorted_link_ends(p);
      for (std::size_t i = 0; i != ends.size(); ++i)
        result +=
          (i == 0 || ends[i - 1].first != ends[i].first) && (i + 1 == ends.size() || ends[i + 1].first != ends[i].first)
            ? 1u
            : 0u;
      return result;
    }
    for (const Corner& c : corners(p))
      result += (number_of_triangles(p, c.a) == 1 ? 1u : 0u) + (number_of_triangles(p, c.b) == 1 ? 1u : 0u);
    return result;
  }

  // Whether an open point has a closed fan; then it has no other.
  bool is_fan_closed(Point_index p) const
  {
    // In a closed fan every neighbor occurs twice.
    Point_index parity = 0;
    for (const Corner& c : corners(p))
      parity ^= c.a ^ c.b;
    return parity == 0 && !corners(p).empty() && number_of_boundary_edges(p) == 0;
  }

  // A triangle that was removed, and how it was stored.
  struct Removed_triangle
  {
    Triangle_index index;
    Triangle vertices;
  };

  // Detaches a stored triangle and opens its vertices.
  Removed_triangle remove(Triangle_index t)
  {
    const Triangle vertices = m_triangles[t].vertices;
    for (Point_index p : vertices)
      open(p);
    for (Point_index p : vertices) {
      Corners& list = m_corners[m_slots[p]];
      list.erase(std::find_if(list.begin(), list.end(), [&](const Corner& c) { return c.triangle == t; }));
    }
    m_triangles[t].vertices[0] = NO_POINT;
    return Removed_triangle{ t, vertices };
  }

  // Attaches a triangle again whose removal did not lead anywhere. Nothing is checked: an agreed triangle may be one that
  // the gate would refuse, such as one that is folded onto another.
  void restore(const Removed_triangle& t)
  {
    m_triangles[t.index].vertices = t.vertices;
    for (Point_index p : t.vertices)
      m_corners[m_slots[p]].push_back(corner(t.index, p));
  }

  // Forgets how parts of the surface face each other that only removed triangles have connected. `cancellation_point()` is
  // called again and again and may throw: the surface is of no use then.
  template <typename Cancellation_point>
  void reset_orientations(Cancellation_point&& cancellation_point)
  {
    orientations() = Parity_union_find(m_slots.size());
    for (Stored_triangle& t : m_triangles)
      if (t.vertices[0] != NO_POINT)
        t.orientation = orientations().add();
    for (Point_index p = 0; p != m_slots.size(); ++p) {
      cancellation_point();
      if (is_open(p))
        orient_fans(p);
      else
        orient_star(p);
    }
  }

  // Calls visit(triangle, orientation element) for every triangle of the surface in canonical order;
  // the triangle is oriented like the element.
  template <typename Visit>
  void for_each_triangle(Visit visit) const
  {
    for (Point_index p = 0; p != m_slots.size(); ++p)
      if (!is_open(p))
        m_compatibility.for_each_agreed_triangle(p, [&](Star_table::Slot, Point_index, Point_index a, Point_index b) {
          if (!is_open(a) && !is_open(b) && p < a && p < b)
            visit(Triangle{ { p, a, b } }, p);
        });
    for (const Stored_triangle& t : m_triangles)
      if (t.vertices[0] != NO_POINT)
        visit(t.vertices, t.orientation);
  }

  // The path of link edges through the neighbor `from` of an open point: its other end and length.
  struct Fan
  {
    Point_index end;
    std::size_t size;
  };

  Fan fan_from(Point_index p, Point_index from) const
  {
    Fan fan{ from, 0 };
    Triangle_index last = NO_TRIANGLE;
    const Corners& list = corners(p);
    if (list.size() > MAXIMUM_SEARCHED_DEGREE)
      return fan_among_many(p, from);
    for (std::size_t i = 0; i != list.size();) {
      const Corner& c = list[i];
      if (c.triangle != last && (c.a == fan.end || c.b == fan.end)) {
        fan.end = c.a == fan.end ? c.b : c.a;
        last = c.triangle;
        ++fan.size;
        if (fan.end == from)
          return fan;
        i = 0;
      } else {
        ++i;
      }
    }
    return fan;
  }

protected:
  // A triangle next to a new one, and whether the new one, as given, is oriented against it.
  struct Adjacent
  {
    Triangle_index triangle = NO_TRIANGLE;
    bool is_flipped = false;
  };

  std::array<Adjacent, 3> adjacent_triangles(Point_index p, Point_index q, Point_index r) const
  {
    return std::array<Adjacent, 3>{ { adjacent(p, q), adjacent(q, r), adjacent(r, p) } };
  }

  // The triangle at the directed edge (p, q) of a new triangle: in agreement it has the edge (q, p).
  Adjacent adjacent(Point_index p, Point_index q) const
  {
    for (const Corner& c : corners(p))
      if (c.a == q || c.b == q)
        return Adjacent{ c.triangle, c.a == q };
    return Adjacent();
  }

  // Attaches a triangle without asking whether the surface stays a manifold.
  void add(Point_index p, Point_index q, Point_index r)
  {
    const std::array<Adjacent, 3> adjacent = adjacent_triangles(p, q, r);
    Stored_triangle stored{ Triangle{ { p, q, r } }, 0 };
    const auto first =
      std::find_if(adjacent.begin(), adjacent.end(), [](const Adjacent& a) { return a.triangle != NO_TRIANGLE; });
    if (first == adjacent.end()) {
      stored.orientation = orientations().add();
    } else {
      stored.orientation = m_triangles[first->triangle].orientation;
      if (first->is_flipped)
        std::swap(stored.vertices[1], stored.vertices[2]);
      for (auto it = first + 1; it != adjacent.end(); ++it)
        if (it->triangle != NO_TRIANGLE)
          orientations().unite(stored.orientation, m_triangles[it->triangle].orientation,
                               first->is_flipped != it->is_flipped);
    }
    const Triangle_index t = static_cast<Triangle_index>(m_triangles.size());
    m_triangles.push_back(stored);
    for (Point_index v : stored.vertices)
      m_corners[m_slots[v]].push_back(corner(t, v));
  }

private:
  // Up to so many triangles at a vertex, searching them all is faster than sorting them.
  static constexpr std::size_t MAXIMUM_SEARCHED_DEGREE = 32;

  struct Stored_triangle
  {
    Triangle vertices;
    Parity_union_find::Element orientation;
  };

  // Relates the triangles next to each other at an open point.
  void orient_fans(Point_index p)
  {
    const Corners& list = corners(p);
    const std::vector<Link_end> ends = sorted_link_ends(p);
    for (std::size_t i = 1; i < ends.size(); ++i)
      if (ends[i].first == ends[i - 1].first) {
        const Corner &c = list[ends[i - 1].second], &d = list[ends[i].second];
        orientations().unite(m_triangles[c.triangle].orientation, m_triangles[d.triangle].orientation,
                             (c.a == ends[i].first) == (d.a == ends[i].first));
      }
  }

  // Relates the star of a closed point to its triangles, or to the stars of their points.
  void orient_star(Point_index p)
  {
    m_compatibility.for_each_agreed_triangle(p, [&](Star_table::Slot, Point_index, Point_index a, Point_index b) {
      for (const Triangle& t : { Triangle{ { a, b, p } }, Triangle{ { b, p, a } } })
        if (!is_open(t[0])) {
          const Star_table::View view = m_compatibility.stars().view(t[0], t[1], t[2]);
          orientations().unite(p, t[0], view == Star_table::View::OPPOSITE_ORIENTATION);
        } else if (const Triangle_index stored = find_triangle(t[0], t[1], t[2]); stored != NO_TRIANGLE) {
          orientations().unite(p, m_triangles[stored].orientation, corner(stored, p).a != a);
        }
    });
  }

  // A neighbor of a point, and the position of one of the corners with it.
  using Link_end = std::pair<Point_index, std::size_t>;

  std::vector<Link_end> sorted_link_ends(Point_index p) const
  {
    std::vector<Link_end> ends;
    const Corners& list = corners(p);
    ends.reserve(2 * list.size());
    for (std::size_t i = 0; i != list.size(); ++i) {
      ends.emplace_back(list[i].a, i);
      ends.emplace_back(list[i].b, i);
    }
    std::sort(ends.begin(), ends.end());
    return ends;
  }

  // fan_from() at a point of many triangles.
  Fan fan_among_many(Point_index p, Point_index from) const
  {
    Fan fan{ from, 0 };
    const Corners& list = corners(p);
    const std::vector<Link_end> ends = sorted_link_ends(p);
    std::size_t last = list.size();
    while (true) {
      auto it = std::lower_bound(ends.begin(), ends.end(), Link_end(fan.end, 0));
      if (it != ends.end() && it->second == last)
        ++it;
      if (it == ends.end() || it->first != fan.end)
        return fan;
      last = it->second;
      fan.end = list[last].a == fan.end ? list[last].b : list[last].a;
      ++fan.size;
      if (fan.end == from)
        return fan;
    }
  }

  Corner corner(Triangle_index t, Point_index p) const
  {
    const Triangle& v = m_triangles[t].vertices;
    return v[0] == p ? Corner{ t, v[1], v[2] } : v[1] == p ? Corner{ t, v[2], v[0] } : Corner{ t, v[0], v[1] };
  }

  Star_compatibility& m_compatibility;
  std::vector<Point_index> m_slots;
  std::vector<Point_index> m_open_points;
  std::vector<Corners> m_corners;
  std::vector<Stored_triangle> m_triangles;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_SURFACE_TRIANGLES_H

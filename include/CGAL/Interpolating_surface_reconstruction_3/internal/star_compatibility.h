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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STAR_COMPATIBILITY_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STAR_COMPATIBILITY_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Parity_union_find.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Star_table.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/parallel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// How compatible the stars are (thesis 4.2.1): for each triangle of each star, the number of its
// vertices whose stars contain it. A point is agreed if all triangles of its star have three
// votes, and the star is closed or has one gap, at the boundary of the surface; a triangle is agreed
// if it has three votes and touches an agreed point. At an agreed point the surface is the star, and
// an edge has at most two agreed triangles, because a star has two triangles at an edge.
class Star_compatibility
{
public:
  using Slot = Star_table::Slot;

  explicit Star_compatibility(const Star_table& stars)
    : m_stars(stars), m_slots(stars.number_of_slots(), 0), m_agreement(stars.size(), Agreement::NONE),
      m_orientations(stars.size())
  { }

  // A triangle that is degenerate gets no vote. Ends early, with votes missing, if go_further() is false;
  // it is called concurrently.
  template <typename ConcurrencyTag, typename Predicates, typename GoFurther>
  void count_votes(const Predicates& predicates, const GoFurther& go_further)
  {
    for_each_block<ConcurrencyTag>(m_stars.size(), POINTS_PER_BLOCK, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p != end && (p != begin || go_further()); ++p)
        count_votes_at(static_cast<Point_index>(p), predicates);
    });
    for_each_block<ConcurrencyTag>(m_stars.size(), POINTS_PER_BLOCK, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p != end && (p != begin || go_further()); ++p)
        find_agreed_triangles_at(static_cast<Point_index>(p));
    });
  }

  template <typename ConcurrencyTag, typename Predicates>
  void count_votes(const Predicates& predicates)
  {
    count_votes<ConcurrencyTag>(predicates, [] { return true; });
  }

  // Ties agreed triangles together that share an edge; one that would make the surface non-orientable loses its
  // agreement. A star in conflict may see parts of the surface from different sides: at its point, only triangles side
  // by side are tied. Ends early if go_further() is false.
  template <typename GoFurther>
  void orient(const GoFurther& go_further)
  {
    for (Point_index p = 0; p != m_stars.size() && (p % POINTS_PER_BLOCK != 0 || go_further()); ++p)
      for_each_agreed_triangle(p, [&](Slot s, Point_index, Point_index a, Point_index b) {
        if (p < a && p < b && !tie_stars(p, s))
          revoke_agreement(p, a, b);
      });
    for (Point_index p = 0; p != m_stars.size() && (p % POINTS_PER_BLOCK != 0 || go_further()); ++p)
      if (!is_oriented(p))
        tie_side_by_side(p);
  }

  void orient()
  {
    orient([] { return true; });
  }

  const Star_table& stars() const { return m_stars; }

  bool is_point_agreed(Point_index p) const
  {
    return m_agreement[p] == Agreement::WITH_GAP || m_agreement[p] == Agreement::CLOSED;
  }
  // Whether the point is agreed and its star has a gap.
  bool is_point_on_boundary(Point_index p) const { return m_agreement[p] == Agreement::WITH_GAP; }
  std::size_t number_of_agreed_points() const
  {
    return static_cast<std::size_t>(std::count(m_agreement.begin(), m_agreement.end(), Agreement::WITH_GAP) +
                                    std::count(m_agreement.begin(), m_agreement.end(), Agreement::CLOSED));
  }

  bool is_star_open(Point_index p) const
  {
    for (Slot s = m_stars.begin(p); s != m_stars.end(p); ++s)
      if (m_stars.neighbor(s) == NO_POINT)
        return true;
    return m_stars.begin(p) == m_stars.end(p);
  }

  int votes(Slot s) const { return m_slots[s] & VOTES; }
  bool is_triangle_agreed(Slot s) const { return (m_slots[s] & AGREED) != 0; }

  // Calls visit(slot, p, a, b) for the agreed triangles of the star of p, oriented like that star.
  template <typename Visit>
  void for_each_agreed_triangle(Point_index p, Visit visit) const
  {
    for (Slot s = m_stars.begin(p); s != m_stars.end(p); ++s)
      if (is_triangle_agreed(s))
        visit(s, p, m_stars.neighbor(s), m_stars.neighbor(m_stars.next(p, s)));
  }

  // A star that ties an agreed triangle of the star of p, and whether the two see the triangle from different sides.
  struct Tie
  {
    Point_index star;
    bool is_flipped;
  };

  Tie tie(Point_index p, Slot s) const
  {
    if (is_oriented(p))
      return Tie{ p, false };
    const Point_index a = m_stars.neighbor(s), b = m_stars.neighbor(m_stars.next(p, s));
    return is_oriented(a) ? Tie{ a, (m_slots[s] & FIRST_IS_FLIPPED) != 0 }
                          : Tie{ b, (m_slots[s] & SECOND_IS_FLIPPED) != 0 };
  }

  // Orientations of the stars that tie triangles, as far as these tie them to each other.
  Parity_union_find& orientations() { return m_orientations; }
  const Parity_union_find& orientations() const { return m_orientations; }

private:
  enum class Agreement : unsigned char
  {
    NONE,
    REVOKED, // was agreed before the stars were tied
    WITH_GAP,
    CLOSED
  };

  static constexpr std::size_t POINTS_PER_BLOCK = 4096;

  static constexpr std::uint8_t VOTES = 3, FIRST_IS_FLIPPED = 4, SECOND_IS_FLIPPED = 8, AGREED = 16;

  template <typename Predicates>
  void count_votes_at(Point_index p, const Predicates& predicates)
  {
    std::size_t triangles = 0, agreed = 0;
    for (Slot s = m_stars.begin(p); s != m_stars.end(p); ++s) {
      m_slots[s] = 0;
      if (!m_stars.has_triangle(p, s))
        continue;
      const Point_index a = m_stars.neighbor(s), b = m_stars.neighbor(m_stars.next(p, s));
      if (!predicates.is_degenerate(p, a, b))
        m_slots[s] = ballot(m_stars.view(a, b, p), m_stars.view(b, p, a));
      ++triangles;
      agreed += votes(s) == 3 ? 1u : 0u;
    }
    const std::size_t size = m_stars.end(p) - m_stars.begin(p);
    m_agreement[p] = agreed == 0 || agreed != triangles ? Agreement::NONE
                     : triangles == size && size > 2    ? Agreement::CLOSED
                     : triangles + 2 == size            ? Agreement::WITH_GAP
                                                        : Agreement::NONE;
  }

  void find_agreed_triangles_at(Point_index p)
  {
    for (Slot s = m_stars.begin(p); s != m_stars.end(p); ++s)
      if (votes(s) == 3 && (is_point_agreed(p) || is_point_agreed(m_stars.neighbor(s)) ||
                            is_point_agreed(m_stars.neighbor(m_stars.next(p, s)))))
        m_slots[s] |= AGREED;
  }

  static std::uint8_t ballot(Star_table::View first, Star_table::View second)
  {
    int result = 1;
    if (first != Star_table::View::ABSENT)
      ++result;
    if (second != Star_table::View::ABSENT)
      ++result;
    if (first == Star_table::View::OPPOSITE_ORIENTATION)
      result |= FIRST_IS_FLIPPED;
    if (second == Star_table::View::OPPOSITE_ORIENTATION)
      result |= SECOND_IS_FLIPPED;
    return static_cast<std::uint8_t>(result);
  }

  // Whether the star of the point is agreed or was, so that it is one oriented part of a surface.
  bool is_oriented(Point_index p) const { return m_agreement[p] != Agreement::NONE; }

  // Ties those of an agreed triangle of the star of p; false if it is non-orientable.
  bool tie_stars(Point_index p, Slot s)
  {
    const Tie first = tie(p, s);
    bool is_orientable = true;
    const auto tie_to_first = [&](Point_index q, std::uint8_t is_flipped) {
      if (q != first.star && is_oriented(q))
        is_orientable =
          m_orientations.unite(first.star, q, first.is_flipped != ((m_slots[s] & is_flipped) != 0)) && is_orientable;
    };
    tie_to_first(m_stars.neighbor(s), FIRST_IS_FLIPPED);
    tie_to_first(m_stars.neighbor(m_stars.next(p, s)), SECOND_IS_FLIPPED);
    return is_orientable;
  }

  // Ties the agreed triangles at a conflicting point that follow each other in its star.
  void tie_side_by_side(Point_index p)
  {
    for (Slot s = m_stars.begin(p); s != m_stars.end(p); ++s) {
      const Slot t = m_stars.next(p, s);
      if (!is_triangle_agreed(s) || !is_triangle_agreed(t))
        continue;
      const Tie first = tie(p, s), second = tie(p, t);
      if (!m_orientations.unite(first.star, second.star, first.is_flipped != second.is_flipped))
        revoke_agreement(p, m_stars.neighbor(s), m_stars.neighbor(t));
    }
  }

  void revoke_agreement(Point_index p, Point_index q, Point_index r)
  {
    revoke(p, q, r);
    revoke(q, r, p);
    revoke(r, p, q);
  }

  void revoke(Point_index center, Point_index a, Point_index b)
  {
    for (Slot s = m_stars.begin(center); s != m_stars.end(center); ++s) {
      const Point_index c = m_stars.neighbor(s), d = m_stars.neighbor(m_stars.next(center, s));
      if ((c == a && d == b) || (c == b && d == a))
        m_slots[s] = static_cast<std::uint8_t>(m_slots[s] & ~AGREED);
    }
    if (m_agreement[center] != Agreement::NONE)
      m_agreement[center] = Agreement::REVOKED;
  }

  const Star_table& m_stars;
  std::vector<std::uint8_t> m_slots;
  std::vector<Agreement> m_agreement;
  Parity_union_find m_orientations;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_STAR_COMPATIBILITY_H

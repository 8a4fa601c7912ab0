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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ANY_VISITOR_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ANY_VISITOR_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/Default_visitor.h>

#include <array>
#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

template <typename Visitor>
Visitor& unwrap(Visitor& visitor)
{
  return visitor;
}

template <typename Visitor>
Visitor& unwrap(std::reference_wrapper<Visitor>& visitor)
{
  return visitor.get();
}

// A visitor of a type that the algorithms do not know: they are compiled once for all visitors of a program.
class Any_visitor
{
public:
  virtual ~Any_visitor() = default;

  virtual void on_reconstruction_begin(std::size_t number_of_points) = 0;
  virtual void on_points_set_aside(std::size_t duplicates, std::size_t non_finite) = 0;
  virtual void on_stage_begin(Stage stage) = 0;
  virtual bool go_further() = 0;
  virtual void on_triangle(const std::array<std::size_t, 3>& triangle, Triangle_verdict verdict) = 0;
  virtual void on_stage_end(Stage stage, std::size_t items) = 0;
  virtual void on_points_unused(std::size_t unused) = 0;
  virtual void on_reconstruction_end(bool cancelled) = 0;
};

// Passes everything on to a visitor, or to the one that a `std::reference_wrapper` refers to.
template <typename Visitor>
class Stored_visitor final : public Any_visitor
{
public:
  explicit Stored_visitor(Visitor visitor = Visitor()) : m_visitor(std::move(visitor)) { }

  void on_reconstruction_begin(std::size_t number_of_points) override
  {
    internal::unwrap(m_visitor).on_reconstruction_begin(number_of_points);
  }
  void on_points_set_aside(std::size_t duplicates, std::size_t non_finite) override
  {
    internal::unwrap(m_visitor).on_points_set_aside(duplicates, non_finite);
  }
  void on_stage_begin(Stage stage) override { internal::unwrap(m_visitor).on_stage_begin(stage); }
  bool go_further() override { return internal::unwrap(m_visitor).go_further(); }
  void on_triangle(const std::array<std::size_t, 3>& triangle, Triangle_verdict verdict) override
  {
    internal::unwrap(m_visitor).on_triangle(triangle, verdict);
  }
  void on_stage_end(Stage stage, std::size_t items) override { internal::unwrap(m_visitor).on_stage_end(stage, items); }
  void on_points_unused(std::size_t unused) override { internal::unwrap(m_visitor).on_points_unused(unused); }
  void on_reconstruction_end(bool cancelled) override { internal::unwrap(m_visitor).on_reconstruction_end(cancelled); }

private:
  Visitor m_visitor;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_ANY_VISITOR_H

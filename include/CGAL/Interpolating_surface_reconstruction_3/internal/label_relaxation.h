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

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_RELAXATION_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_RELAXATION_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

#include <CGAL/Interpolating_surface_reconstruction_3/internal/Cell_complex.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Progress.h>

#include <queue>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// A cell that wins by changing its label.
struct Label_change
{
  double gain;
  Cell_complex::Cell_index cell;

  bool operator<(const Label_change& other) const
  {
    return gain < other.gain || (gain == other.gain && cell > other.cell);
  }
};

// Changes single cells as long as that wins, the one that wins most first; returns them in this
// order. `Labelling` has gain(c), what changing cell c wins, smallest_gain(c), below which that is a
// rounding error, may_gain(c), false only if gain(c) is not positive, and flip(c). `cancellation_point()` is called again and again and may throw.
template <typename Labelling, typename Cancellation_point = No_cancellation>
std::vector<Cell_complex::Cell_index> relax_labels(const Cell_complex& cells, Labelling& labelling,
                                                   Cancellation_point&& cancellation_point = Cancellation_point())
{
  using Cell_index = Cell_complex::Cell_index;
  std::vector<Cell_index> changed;
  std::priority_queue<Label_change> queue;
  const auto push = [&](Cell_index c) {
    const double gain = labelling.gain(c);
    if (gain > 0. && gain > labelling.smallest_gain(c))
      queue.push(Label_change{ gain, c });
  };
  for (Cell_index c = 0; c != cells.size(); ++c) {
    cancellation_point();
    if (labelling.may_gain(c))
      push(c);
  }
  while (!queue.empty()) {
    cancellation_point();
    const Label_change change = queue.top();
    queue.pop();
    if (labelling.gain(change.cell) != change.gain)
      continue;
    labelling.flip(change.cell);
    changed.push_back(change.cell);
    for (Cell_index n : cells[change.cell].neighbors)
      push(n);
  }
  return changed;
}

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_LABEL_RELAXATION_H

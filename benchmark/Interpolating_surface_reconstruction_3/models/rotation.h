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

#ifndef ISR_BENCHMARK_MODELS_ROTATION_H
#define ISR_BENCHMARK_MODELS_ROTATION_H

#include "model_files.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Random.h>

#include <Eigen/Geometry>

namespace isr_benchmark {

// All rotations are equally likely: normalized, a random point of the unit ball is a random quaternion.
inline CGAL::Aff_transformation_3<Kernel> random_rotation(unsigned int seed)
{
  CGAL::Random random(seed);
  const auto coordinate = [&] { return random.get_double(-1., 1.); };
  Eigen::Vector4d q;
  do
    q = Eigen::Vector4d(coordinate(), coordinate(), coordinate(), coordinate());
  while (q.squaredNorm() > 1. || q.squaredNorm() == 0.);
  const Eigen::Matrix3d m = Eigen::Quaterniond(q.normalized()).toRotationMatrix();
  return CGAL::Aff_transformation_3<Kernel>(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1),
                                            m(2, 2));
}

inline void transform(Model& model, const CGAL::Aff_transformation_3<Kernel>& transformation)
{
  for (Point& p : model.points)
    p = transformation(p);
  for (Vector& n : model.normals)
    n = transformation(n);
}

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_MODELS_ROTATION_H

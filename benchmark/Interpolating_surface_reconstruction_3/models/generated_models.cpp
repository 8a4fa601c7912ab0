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

#include "generated_models.h"

#include "Double_torus.h"
#include "Polyhedron.h"
#include "sampling.h"
#include "Sphere.h"
#include "Tube.h"

#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>

namespace isr_benchmark {

namespace {

// Distances between the solids are in units of the spacing of n points, so that they stay hard
// whatever n is.
std::unique_ptr<Polyhedron> make_polyhedron(const std::string& shape, std::size_t n)
{
  auto result = std::make_unique<Polyhedron>();
  if (shape == "boxes") { // two unit cubes, one spacing apart
    const double gap = std::sqrt(12. / double(n));
    result->add_box(Point(0, 0, 0), Point(1, 1, 1));
    result->add_box(Point(1 + gap, 0, 0), Point(2 + gap, 1, 1));
  } else if (shape == "plates") { // two plates one spacing thick, one spacing apart
    const double thickness = std::sqrt(4. / double(n));
    result->add_box(Point(0, 0, 0), Point(1, 1, thickness));
    result->add_box(Point(0, 0, 2 * thickness), Point(1, 1, 3 * thickness));
  } else if (shape == "wedge") { // an edge of 10 degrees
    result->add_prism({ { 0, 0 }, { 1, 0 }, { 1, std::tan(CGAL_PI / 18) } }, 0, 0.5);
  } else
    throw std::invalid_argument(shape + ": no such generated model");
  return result;
}

std::unique_ptr<Surface> make_surface(const std::string& shape, std::size_t n)
{
  if (shape == "sphere")
    return std::make_unique<Sphere>();
  if (shape == "knot")
    return std::make_unique<Tube>(trefoil, 0.4);
  if (shape == "loop")
    return std::make_unique<Tube>(figure_eight_knot, 0.35);
  if (shape == "doubletorus")
    return std::make_unique<Double_torus>();
  return make_polyhedron(shape, n);
}

} // namespace

Surface_model generate_model(const std::string& description)
{
  std::istringstream in(description);
  std::string shape, points, seed;
  std::getline(in, shape, ':');
  std::getline(in, points, ':');
  std::getline(in, seed);
  const std::size_t n = std::stoul(points);
  if (n == 0)
    throw std::invalid_argument(description + ": no points");
  Surface_model result;
  result.seed = static_cast<unsigned int>(std::stoul(seed));
  result.surface = make_surface(shape, n);
  result.model.name = description;
  result.model.points = sample(*result.surface, n, result.seed);
  return result;
}

} // namespace isr_benchmark

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

#ifndef ISR_TEST_SELF_INTERSECTIONS_H
#define ISR_TEST_SELF_INTERSECTIONS_H

#include "isr_test_utils.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <cstdint>

namespace isr_test {

// Of a manifold.
inline bool has_self_intersection(const Points& points, const Triples& triples)
{
  using Surface = CGAL::Surface_mesh<Point>;
  Surface mesh;
  for (const Point& p : points)
    mesh.add_vertex(p);
  for (const Triple& t : triples)
    mesh.add_face(Surface::Vertex_index(std::uint32_t(t[0])), Surface::Vertex_index(std::uint32_t(t[1])),
                  Surface::Vertex_index(std::uint32_t(t[2])));
  return CGAL::Polygon_mesh_processing::does_self_intersect(mesh);
}

} // namespace isr_test

#endif // ISR_TEST_SELF_INTERSECTIONS_H

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

// The "fresh" meshes of the manual's section "How Well Does It Work": closed meshes made from others by edge collapse and
// by isotropic remeshing, so that no sampling of a model is the only one that is known.

#include "models/model_files.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMS = CGAL::Surface_mesh_simplification;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

constexpr std::size_t MINIMUM_SIZE = 100, MAXIMUM_SIZE = 30000; // in vertices

// Where a mesh bends by more, in degrees, remeshing leaves a crease.
constexpr double CREASE = 45.;

const char* const USAGE =
  "usage: isr_derived_meshes FOLDER FILE_OR_FOLDER...\n"
  "\n"
  "Makes four meshes of each closed mesh of at most 30,000 vertices in the files (.off, .ply), and\n"
  "writes those of at least 100 to FOLDER that are closed and do not cross themselves:\n"
  "NAME_c5.off and NAME_c2.off, edges collapsed until a half and a fifth of them are left;\n"
  "NAME_r1.off and NAME_r2.off, remeshed to once and twice the mean length of an edge.\n";

// Stops when this part of the edges is left.
struct Share_of_edges
{
  double share;

  template <typename FT, typename Profile>
  bool operator()(const FT&, const Profile&, std::size_t initial, std::size_t current) const
  {
    return double(current) < share * double(initial);
  }
};

bool is_usable(const Mesh& mesh)
{
  return mesh.number_of_vertices() >= MINIMUM_SIZE && CGAL::is_closed(mesh) && !PMP::does_self_intersect(mesh);
}

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0.;
  for (const Mesh::Edge_index e : mesh.edges())
    sum += PMP::edge_length(mesh.halfedge(e), mesh);
  return sum / double(mesh.number_of_edges());
}

Mesh collapsed(Mesh mesh, double share)
{
  SMS::edge_collapse(mesh, Share_of_edges{ share });
  return mesh;
}

Mesh remeshed(Mesh mesh, double length, bool keeps_points_on_creases)
{
  const auto is_crease = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_crease", false).first;
  PMP::detect_sharp_edges(mesh, CREASE, is_crease);
  PMP::split_long_edges(mesh.edges(), length * 4. / 3., mesh, CGAL::parameters::edge_is_constrained_map(is_crease));
  PMP::isotropic_remeshing(mesh.faces(), length, mesh,
                           CGAL::parameters::edge_is_constrained_map(is_crease)
                             .protect_constraints(keeps_points_on_creases)
                             .number_of_iterations(3));
  return mesh;
}

void write(Mesh mesh, const std::filesystem::path& file)
{
  mesh.collect_garbage();
  if (!is_usable(mesh))
    std::cout << "  " << file.filename().string() << " is not closed, crosses itself or is small\n";
  else if (!CGAL::IO::write_polygon_mesh(file.string(), mesh, CGAL::parameters::stream_precision(17)))
    throw std::runtime_error(file.string() + ": cannot be written");
}

void derive(const std::filesystem::path& file, const std::filesystem::path& folder)
{
  Mesh mesh;
  if (!PMP::IO::read_polygon_mesh(file.string(), mesh) || mesh.is_empty())
    return;
  PMP::triangulate_faces(mesh);
  mesh.collect_garbage();
  if (mesh.number_of_vertices() > MAXIMUM_SIZE || !is_usable(mesh))
    return;
  const std::string name = file.stem().string();
  std::cout << name << ", " << mesh.number_of_vertices() << " vertices" << std::endl;
  const double length = mean_edge_length(mesh);
  write(collapsed(mesh, .5), folder / (name + "_c5.off"));
  write(collapsed(mesh, .2), folder / (name + "_c2.off"));
  // Creases that edges of the wanted length fit on keep their points.
  write(remeshed(mesh, length, true), folder / (name + "_r1.off"));
  write(remeshed(mesh, 2. * length, false), folder / (name + "_r2.off"));
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 3) {
    std::cerr << USAGE;
    return EXIT_FAILURE;
  }
  try {
    std::filesystem::create_directories(argv[1]);
    for (const std::filesystem::path& file : isr_benchmark::find_model_files({ argv + 2, argv + argc }))
      derive(file, argv[1]);
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

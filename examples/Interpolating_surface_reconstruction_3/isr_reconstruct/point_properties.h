#ifndef ISR_RECONSTRUCT_POINT_PROPERTIES_H
#define ISR_RECONSTRUCT_POINT_PROPERTIES_H

#include "point_file.h"

#include <CGAL/IO/Color.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace isr {

using Mesh = CGAL::Surface_mesh<Point_3>;

namespace internal {

// Where in the range of points each vertex of the mesh comes from; beyond the range if it was added. The map is taken off the mesh,
// whose files then have the properties of the input and no other.
inline std::vector<std::size_t> take_input_indices(Mesh& mesh)
{
  auto input_index = mesh.add_property_map<Mesh::Vertex_index, std::size_t>("v:input_index").first;
  std::vector<std::size_t> indices;
  indices.reserve(mesh.number_of_vertices());
  for (Mesh::Vertex_index v : mesh.vertices())
    indices.push_back(input_index[v]);
  mesh.remove_property_map(input_index);
  return indices;
}

// Copies the property `name` of the points if its type is T. The bare name, without CGAL's "v:",
// cannot meet one of the mesh's own properties, and is the name in a PLY file.
template <typename T>
void copy_property(Point_set& points, const std::string& name, const std::vector<std::size_t>& input_indices,
                   Mesh& mesh)
{
  auto source = points.add_property_map<T>(name);
  if (source.second) {
    points.remove_property_map(source.first);
    return;
  }
  auto target = mesh.add_property_map<Mesh::Vertex_index, T>(name, T()).first;
  for (Mesh::Vertex_index v : mesh.vertices())
    if (input_indices[v] < points.size())
      target[v] = source.first[*(points.begin() + static_cast<std::ptrdiff_t>(input_indices[v]))];
}

inline void copy_normals(const Point_set& points, const std::vector<std::size_t>& input_indices, Mesh& mesh)
{
  if (!points.has_normal_map())
    return;
  auto normal = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal", CGAL::NULL_VECTOR).first;
  for (Mesh::Vertex_index v : mesh.vertices())
    if (input_indices[v] < points.size())
      normal[v] = points.normal(*(points.begin() + static_cast<std::ptrdiff_t>(input_indices[v])));
}

} // namespace internal

// Copies the normals and all numeric properties of the points to the vertices that they became.
inline void carry_properties(Point_set& points, Mesh& mesh)
{
  const std::vector<std::size_t> input_indices = internal::take_input_indices(mesh);
  internal::copy_normals(points, input_indices, mesh);
  for (const std::string& name : points.properties()) {
    internal::copy_property<std::int8_t>(points, name, input_indices, mesh);
    internal::copy_property<std::uint8_t>(points, name, input_indices, mesh);
    internal::copy_property<std::int16_t>(points, name, input_indices, mesh);
    internal::copy_property<std::uint16_t>(points, name, input_indices, mesh);
    internal::copy_property<std::int32_t>(points, name, input_indices, mesh);
    internal::copy_property<std::uint32_t>(points, name, input_indices, mesh);
    internal::copy_property<float>(points, name, input_indices, mesh);
    internal::copy_property<double>(points, name, input_indices, mesh);
  }
}

// Joins the properties red, green and blue into the color that formats other than PLY know.
inline void join_colors(Mesh& mesh)
{
  const auto red = mesh.add_property_map<Mesh::Vertex_index, std::uint8_t>("red");
  const auto green = mesh.add_property_map<Mesh::Vertex_index, std::uint8_t>("green");
  const auto blue = mesh.add_property_map<Mesh::Vertex_index, std::uint8_t>("blue");
  if (red.second || green.second || blue.second)
    return;
  auto color = mesh.add_property_map<Mesh::Vertex_index, CGAL::IO::Color>("v:color").first;
  for (Mesh::Vertex_index v : mesh.vertices())
    color[v] = CGAL::IO::Color(red.first[v], green.first[v], blue.first[v]);
}

} // namespace isr

#endif // ISR_RECONSTRUCT_POINT_PROPERTIES_H

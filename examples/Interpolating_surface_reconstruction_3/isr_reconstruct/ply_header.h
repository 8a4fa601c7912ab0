#ifndef ISR_RECONSTRUCT_PLY_HEADER_H
#define ISR_RECONSTRUCT_PLY_HEADER_H

#include "exit_status.h"

#include <istream>
#include <map>
#include <sstream>
#include <string>

namespace isr {

// CGAL reads the coordinates of PLY vertices as one floating-point type and does not check that
// they have it. Throws for a header that it would misread, and leaves the stream at its begin.
inline void check_ply_header(std::istream& in)
{
  std::map<std::string, std::string> vertex_types;
  bool in_vertex = false, has_element = false, has_end = false;
  std::string line;
  while (!has_end && std::getline(in, line)) {
    std::istringstream words(line);
    std::string keyword, first, second;
    words >> keyword >> first >> second;
    has_element = has_element || keyword == "element";
    if (keyword == "property" && !has_element)
      throw Failure(BROKEN_INPUT, "the PLY header has a property before the first element");
    if (keyword == "element")
      in_vertex = first == "vertex" || first == "vertices";
    else if (keyword == "property" && in_vertex && first != "list")
      vertex_types[second] = first;
    has_end = keyword == "end_header";
  }
  if (!has_end)
    throw Failure(BROKEN_INPUT, "the PLY header has no end");

  const auto is_float = [&](const char* name) {
    return vertex_types[name] == "float" || vertex_types[name] == "float32";
  };
  const auto is_double = [&](const char* name) {
    return vertex_types[name] == "double" || vertex_types[name] == "float64";
  };
  const auto are_float = [&](const char* a, const char* b, const char* c) {
    return is_float(a) && is_float(b) && is_float(c);
  };
  const auto are_double = [&](const char* a, const char* b, const char* c) {
    return is_double(a) && is_double(b) && is_double(c);
  };
  if (!are_float("x", "y", "z") && !are_double("x", "y", "z"))
    throw Failure(BROKEN_INPUT, "the PLY vertices have no x, y, z of one type, float or double");
  const bool has_normals = vertex_types.count("nx") + vertex_types.count("ny") + vertex_types.count("nz") == 3;
  if (has_normals && !are_float("nx", "ny", "nz") && !(are_double("nx", "ny", "nz") && is_double("x")))
    throw Failure(BROKEN_INPUT, "the PLY normals are not of the type of the coordinates");

  in.clear();
  in.seekg(0);
}

} // namespace isr

#endif // ISR_RECONSTRUCT_PLY_HEADER_H

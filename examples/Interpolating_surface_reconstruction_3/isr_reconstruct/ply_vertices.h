#ifndef ISR_RECONSTRUCT_PLY_VERTICES_H
#define ISR_RECONSTRUCT_PLY_VERTICES_H

#include "exit_status.h"

#include <algorithm>
#include <cstddef>
#include <istream>
#include <limits>
#include <map>
#include <sstream>
#include <streambuf>
#include <string>
#include <vector>

namespace isr {

// The number of characters from here to the end of a stream, or the largest number if it cannot tell.
inline std::size_t remaining_size(std::istream& in)
{
  const std::streampos here = in.tellg();
  if (here != std::streampos(-1) && in.seekg(0, std::ios::end)) {
    const std::streamoff size = in.tellg() - here;
    in.seekg(here);
    return static_cast<std::size_t>(size);
  }
  in.clear();
  return (std::numeric_limits<std::size_t>::max)();
}

// The items of a PLY file that come one after the other.
struct Ply_element
{
  // Whether `size` characters can hold the items: CGAL allocates memory for as many as are announced,
  // and loops over items without properties even at the end of the file.
  bool is_possible(std::size_t size) const
  {
    return number_of_items == 0 || (number_of_properties != 0 && number_of_items <= size / number_of_properties);
  }
  std::size_t number_of_items = 0, number_of_properties = 0;
};

// Reads the header of a PLY file and returns the part of it up to the vertices, as CGAL's reader is to
// see it: what stands behind the vertices is not read at all, and a list, whose announced length CGAL
// would allocate whatever it is, is refused. Throws for a header that CGAL would misread, which reads
// coordinates as one floating-point type and does not check that they have it, and for one that announces
// more than the file holds.
inline std::string read_ply_vertex_header(std::istream& in)
{
  std::map<std::string, std::string> vertex_types;
  std::string header, line;
  bool in_vertex = false, has_vertex = false, has_end = false;
  std::vector<Ply_element> elements;
  while (!has_end && std::getline(in, line)) {
    std::istringstream words(line);
    std::string keyword, first, second;
    words >> keyword >> first >> second;
    has_end = keyword == "end_header";
    if (keyword == "element") {
      in_vertex = !has_vertex && (first == "vertex" || first == "vertices");
      if (!has_vertex) {
        elements.emplace_back();
        std::istringstream(second) >> elements.back().number_of_items;
      }
    } else if (keyword == "property" && elements.empty()) {
      throw Failure(BROKEN_INPUT, "the PLY header has a property before the first element");
    }
    const bool is_behind_vertices = has_vertex && !in_vertex;
    has_vertex = has_vertex || in_vertex;
    if (is_behind_vertices && (keyword == "element" || keyword == "property"))
      continue;
    if (keyword == "property" && first == "list")
      throw Failure(BROKEN_INPUT, "the PLY header has a list in or before the vertices");
    if (keyword == "property")
      ++elements.back().number_of_properties;
    if (keyword == "property" && in_vertex)
      vertex_types[second] = first;
    header += line + '\n';
  }
  if (!has_end)
    throw Failure(BROKEN_INPUT, "the PLY header has no end");
  const std::size_t size = remaining_size(in);
  for (const Ply_element& element : elements)
    if (!element.is_possible(size))
      throw Failure(BROKEN_INPUT, "the PLY header announces more than the file holds");

  const auto are = [&](const std::vector<std::string>& names, const std::string& type, const std::string& synonym) {
    return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
      return vertex_types.count(name) != 0 && (vertex_types[name] == type || vertex_types[name] == synonym);
    });
  };
  const std::vector<std::string> coordinates = { "x", "y", "z" }, normal = { "nx", "ny", "nz" };
  const bool are_double = are(coordinates, "double", "float64");
  if (!are_double && !are(coordinates, "float", "float32"))
    throw Failure(BROKEN_INPUT, "the PLY vertices have no x, y, z of one type, float or double");
  const bool has_normals =
    std::all_of(normal.begin(), normal.end(), [&](const std::string& name) { return vertex_types.count(name) != 0; });
  if (has_normals && !are(normal, "float", "float32") && !(are_double && are(normal, "double", "float64")))
    throw Failure(BROKEN_INPUT, "the PLY normals are not of the type of the coordinates");
  return header;
}

// A text, and behind it the rest of a stream.
class Prefixed_streambuf : public std::streambuf
{
public:
  Prefixed_streambuf(const std::string& prefix, std::istream& rest)
    : m_buffer(prefix.begin(), prefix.end()), m_rest(*rest.rdbuf())
  {
    setg(m_buffer.data(), m_buffer.data(), m_buffer.data() + m_buffer.size());
  }

protected:
  int_type underflow() override
  {
    // The first character is peeked at, so that an interrupted file buffer can end here.
    constexpr std::streamsize MAXIMUM_CHUNK = 1 << 16;
    if (traits_type::eq_int_type(m_rest.sgetc(), traits_type::eof()))
      return traits_type::eof();
    const std::streamsize n = (std::min)(MAXIMUM_CHUNK, (std::max)(std::streamsize(1), m_rest.in_avail()));
    m_buffer.resize(static_cast<std::size_t>(n));
    const std::streamsize found = m_rest.sgetn(m_buffer.data(), n);
    setg(m_buffer.data(), m_buffer.data(), m_buffer.data() + found);
    return traits_type::to_int_type(*gptr());
  }

private:
  std::vector<char> m_buffer;
  std::streambuf& m_rest;
};

} // namespace isr

#endif // ISR_RECONSTRUCT_PLY_VERTICES_H

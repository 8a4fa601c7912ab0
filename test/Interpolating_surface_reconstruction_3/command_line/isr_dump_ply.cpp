// Prints the names of the vertex properties of a binary little-endian PLY file, then their values,
// one vertex a line. Written without CGAL, so that it can check what CGAL wrote.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

template <typename T>
double read(std::istream& in)
{
  T value;
  in.read(reinterpret_cast<char*>(&value), sizeof(value));
  return static_cast<double>(value);
}

double read(std::istream& in, const std::string& type)
{
  if (type == "char")
    return read<std::int8_t>(in);
  if (type == "uchar")
    return read<std::uint8_t>(in);
  if (type == "short")
    return read<std::int16_t>(in);
  if (type == "ushort")
    return read<std::uint16_t>(in);
  if (type == "int")
    return read<std::int32_t>(in);
  if (type == "uint")
    return read<std::uint32_t>(in);
  if (type == "float")
    return read<float>(in);
  return read<double>(in);
}

int main(int argc, char* argv[])
{
  std::ifstream in(argc > 1 ? argv[1] : "", std::ios::binary);
  std::vector<std::pair<std::string, std::string> > properties;
  std::size_t vertices = 0;
  bool in_vertex = false;
  for (std::string line; std::getline(in, line) && line != "end_header";) {
    std::istringstream words(line);
    std::string keyword, first, second;
    words >> keyword >> first >> second;
    if (keyword == "element") {
      in_vertex = first == "vertex";
      vertices = in_vertex ? std::stoul(second) : vertices;
    } else if (keyword == "property" && in_vertex)
      properties.emplace_back(first, second);
  }

  for (const auto& property : properties)
    std::cout << property.second << ' ';
  std::cout << '\n';
  std::cout.precision(9);
  for (std::size_t i = 0; i != vertices; ++i) {
    for (const auto& property : properties)
      std::cout << read(in, property.first) << ' ';
    std::cout << '\n';
  }
  return in ? EXIT_SUCCESS : EXIT_FAILURE;
}

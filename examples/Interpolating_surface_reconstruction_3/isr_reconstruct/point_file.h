#ifndef ISR_RECONSTRUCT_POINT_FILE_H
#define ISR_RECONSTRUCT_POINT_FILE_H

#include "exit_status.h"
#include "file_extension.h"
#include "interruption.h"
#include "ply_vertices.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace isr {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Point_set = CGAL::Point_set_3<Point_3>;

namespace internal {

// Keeps what CGAL's readers say on std::cerr, for a message of one line.
class Captured_cerr
{
public:
  Captured_cerr() : m_previous(std::cerr.rdbuf(m_text.rdbuf())) { }
  Captured_cerr(const Captured_cerr&) = delete;
  Captured_cerr& operator=(const Captured_cerr&) = delete;
  ~Captured_cerr() { std::cerr.rdbuf(m_previous); }

  std::string first_line() const
  {
    const std::string text = m_text.str();
    return text.substr(0, text.find('\n'));
  }

private:
  std::ostringstream m_text;
  std::streambuf* m_previous;
};

inline bool read_xyz(std::istream& in, Point_set& points) { return CGAL::IO::read_XYZ(in, points); }

inline bool read_ply(std::istream& in, Point_set& points)
{
  Prefixed_streambuf buffer(read_ply_vertex_header(in), in);
  std::istream vertices(&buffer);
  return CGAL::IO::read_PLY(vertices, points);
}

// The number of vertices that an OFF header announces; CGAL's reader accepts fewer.
inline std::size_t announced_off_vertices(std::istream& in)
{
  const auto next_line = [&in] {
    std::string line;
    while (std::getline(in, line) && (line.empty() || line[0] == '#'))
      ;
    return line;
  };
  next_line(); // the signature
  std::size_t n = 0;
  std::istringstream(next_line()) >> n;
  in.clear();
  in.seekg(0);
  return n;
}

inline bool read_off(std::istream& in, Point_set& points)
{
  const std::size_t announced = announced_off_vertices(in);
  if (!CGAL::IO::read_OFF(in, points))
    return false;
  if (points.size() != announced)
    throw Failure(BROKEN_INPUT, std::to_string(points.size()) + " of " + std::to_string(announced) + " points found");
  return true;
}

inline bool read_obj(std::istream& in, Point_set& points)
{
  std::vector<Point_3> vertices;
  std::vector<std::vector<std::size_t> > faces;
  // A file without faces is not a mesh, but its points have been read to the end of the file.
  if (!CGAL::IO::read_OBJ(in, vertices, faces, CGAL::parameters::verbose(true)) && !in.eof())
    return false;
  points.reserve(vertices.size());
  for (const Point_3& p : vertices)
    points.insert(p);
  return true;
}

#ifdef CGAL_LINKED_WITH_LASLIB
inline bool read_las(std::istream& in, Point_set& points) { return CGAL::IO::read_LAS(in, points); }
#endif

using Reader = bool (*)(std::istream&, Point_set&);

inline const std::map<std::string, Reader>& readers()
{
  static const std::map<std::string, Reader> all = {
    { ".ply", read_ply }, { ".xyz", read_xyz }, { ".pwn", read_xyz }, { ".off", read_off }, { ".obj", read_obj },
#ifdef CGAL_LINKED_WITH_LASLIB
    { ".las", read_las },
#endif
  };
  return all;
}

} // namespace internal

inline std::string point_file_extensions()
{
  std::string names;
  for (const auto& reader : internal::readers())
    names += (names.empty() ? "" : " ") + reader.first;
  return names;
}

inline void check_point_file_extension(const std::filesystem::path& path)
{
  if (internal::readers().count(file_extension(path)) == 0)
    throw Failure(UNKNOWN_EXTENSION,
                  "cannot read '" + path.string() + "': its extension is none of " + point_file_extensions());
}

// Reads the points of a file of any known extension, with normals and PLY properties.
inline Point_set read_points(const std::filesystem::path& path)
{
  const std::string begin_of_message = "cannot read '" + path.string() + "': ";
  Interruptible_filebuf buffer;
  errno = 0;
  if (std::filesystem::is_directory(path))
    throw Failure(UNREADABLE_INPUT, begin_of_message + "it is a directory");
  if (!buffer.open(path, std::ios::in | std::ios::binary))
    throw Failure(UNREADABLE_INPUT, begin_of_message + std::strerror(errno));

  std::istream in(&buffer);
  if (in.peek() == std::istream::traits_type::eof() && !is_interrupted())
    throw Failure(EMPTY_INPUT, begin_of_message + "the file is empty");

  Point_set points;
  std::string reason;
  bool is_complete = false;
  {
    const internal::Captured_cerr cerr;
    try {
      is_complete = internal::readers().at(file_extension(path))(in, points);
      reason = cerr.first_line();
    } catch (const std::exception& error) {
      // also out of memory: the number of points in a broken header may be anything
      reason = error.what();
    }
  }
  throw_if_interrupted();
  if (!is_complete)
    throw Failure(BROKEN_INPUT, begin_of_message + (reason.empty() ? "the file is broken or incomplete" : reason));
  if (points.empty())
    throw Failure(EMPTY_INPUT, begin_of_message + "the file has no points");
  return points;
}

} // namespace isr

#endif // ISR_RECONSTRUCT_POINT_FILE_H

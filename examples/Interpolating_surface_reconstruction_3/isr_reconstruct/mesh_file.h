#ifndef ISR_RECONSTRUCT_MESH_FILE_H
#define ISR_RECONSTRUCT_MESH_FILE_H

#include "exit_status.h"
#include "file_extension.h"
#include "output_file.h"
#include "point_properties.h"

#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/STL.h>

#include <filesystem>
#include <limits>
#include <map>
#include <ostream>
#include <string>

namespace isr {

namespace internal {

inline bool write_ply(std::ostream& out, Mesh& mesh)
{
  CGAL::IO::set_binary_mode(out);
  return CGAL::IO::write_PLY(out, mesh);
}

inline bool write_off(std::ostream& out, Mesh& mesh)
{
  join_colors(mesh);
  return CGAL::IO::write_OFF(out, mesh);
}

inline bool write_obj(std::ostream& out, Mesh& mesh) { return CGAL::IO::write_OBJ(out, mesh); }

inline bool write_stl(std::ostream& out, Mesh& mesh)
{
  CGAL::IO::set_binary_mode(out);
  return CGAL::IO::write_STL(out, mesh);
}

using Writer = bool (*)(std::ostream&, Mesh&);

inline const std::map<std::string, Writer>& writers()
{
  static const std::map<std::string, Writer> all = {
    { ".ply", write_ply }, { ".off", write_off }, { ".obj", write_obj }, { ".stl", write_stl }
  };
  return all;
}

} // namespace internal

inline std::string mesh_file_extensions()
{
  std::string names;
  for (const auto& writer : internal::writers())
    names += (names.empty() ? "" : " ") + writer.first;
  return names;
}

inline void check_mesh_file_extension(const std::filesystem::path& path)
{
  if (internal::writers().count(file_extension(path)) == 0)
    throw Failure(UNKNOWN_EXTENSION,
                  "cannot write '" + path.string() + "': its extension is none of " + mesh_file_extensions());
}

// Writes the mesh in the format that the extension of the file names.
inline void write_mesh(Mesh& mesh, Output_file& file)
{
  // as many digits as it takes to read the same coordinates again
  file.stream().precision(std::numeric_limits<double>::max_digits10);
  const bool is_written = internal::writers().at(file_extension(file.path()))(file.stream(), mesh);
  file.finish();
  if (!is_written)
    throw Failure(UNWRITABLE_OUTPUT, "cannot write '" + file.path().string() + "'");
}

} // namespace isr

#endif // ISR_RECONSTRUCT_MESH_FILE_H

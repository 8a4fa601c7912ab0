#ifndef ISR_RECONSTRUCT_COMMAND_LINE_H
#define ISR_RECONSTRUCT_COMMAND_LINE_H

#include "exit_status.h"
#include "mesh_file.h"
#include "methods.h"
#include "point_file.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <thread>

#ifndef CGAL_ISR_VERSION
#define CGAL_ISR_VERSION "unknown"
#endif

namespace isr {

struct Command_line
{
  std::string input, output, stats;
  Reconstruction_options reconstruction;
  bool is_quiet = false;
  bool wants_help = false, wants_version = false;
};

namespace internal {

inline std::string method_names()
{
  std::string names;
  for (const auto& method : methods())
    names += (names.empty() ? "" : ", ") + method.first;
  return names;
}

inline std::size_t default_threads()
{
#ifdef CGAL_LINKED_WITH_TBB
  return (std::max)(1u, std::thread::hardware_concurrency());
#else
  return 1;
#endif
}

inline boost::program_options::options_description visible_options()
{
  namespace po = boost::program_options;
  po::options_description options("Options");
  options.add_options()("method", po::value<std::string>()->default_value("ctc")->value_name("NAME"),
                        ("how to reconstruct: " + method_names()).c_str())(
    "keep-boundaries", "leave loops open that the sampling shows to be boundaries of the surface")(
    "maximum-hole-size", po::value<long long>()->value_name("N"),
    "ctc: close only loops of at most N edges; 0 closes none (default: close all)")(
    "grid-spacing", po::value<double>()->value_name("H"),
    "lis: add vertices until no edge is longer than H, in the unit of the points (default: none)")(
    "neighbor-radius", po::value<double>()->value_name("R"),
    "connect no points farther apart than about R, in the unit of the points (default: no limit)")(
    "ignore-normals", "do not use the normals of the input, if it has any")(
    "threads", po::value<long long>()->default_value(static_cast<long long>(default_threads()))->value_name("N"),
    "number of threads; the mesh does not depend on it")("stats", po::value<std::string>()->value_name("FILE"),
                                                         "write the summary to FILE as JSON")(
    "quiet", "print no summary and no progress bar")("help", "print this text")("version", "print the version");
  return options;
}

inline std::size_t to_count(const std::string& name, long long value, long long least)
{
  if (value < least)
    throw Failure(BAD_OPTION, "option '--" + name + "' must be at least " + std::to_string(least));
  return static_cast<std::size_t>(value);
}

inline Reconstruction_options to_reconstruction_options(const boost::program_options::variables_map& values)
{
  Reconstruction_options options;
  options.method = values["method"].as<std::string>();
  if (methods().count(options.method) == 0)
    throw Failure(BAD_OPTION, "unknown method '" + options.method + "', known: " + method_names());
  options.keep_boundaries = values.count("keep-boundaries") != 0;
  options.use_normals = values.count("ignore-normals") == 0;
  if (values.count("maximum-hole-size") != 0)
    options.maximum_hole_size = to_count("maximum-hole-size", values["maximum-hole-size"].as<long long>(), 0);
  if (values.count("neighbor-radius") != 0)
    options.neighbor_radius = values["neighbor-radius"].as<double>();
  if (values.count("grid-spacing") != 0)
    options.grid_spacing = values["grid-spacing"].as<double>();
  if (!(options.grid_spacing >= 0.) || !std::isfinite(options.grid_spacing))
    throw Failure(BAD_OPTION, "option '--grid-spacing' must be a finite number, at least 0");
  if (!(options.neighbor_radius >= 0.) || !std::isfinite(options.neighbor_radius))
    throw Failure(BAD_OPTION, "option '--neighbor-radius' must be a finite number, at least 0");
  options.threads = to_count("threads", values["threads"].as<long long>(), 1);
#ifndef CGAL_LINKED_WITH_TBB
  if (options.threads > 1)
    throw Failure(BAD_OPTION, "this program was built without TBB and runs on one thread only");
#endif
  return options;
}

} // namespace internal

inline void print_help(std::ostream& out)
{
  out << "Usage: isr_reconstruct INPUT OUTPUT [options]\n\n"
         "Connects the points of INPUT to a triangle mesh and writes it to OUTPUT. The vertices of\n"
         "the mesh are points of the input, unchanged, unless --grid-spacing adds some; edges have one or\n"
         "two triangles. Method lis needs normals, or estimates them.\n\n"
         "INPUT   points, by extension: "
      << point_file_extensions()
      << "\n"
         "        Of a mesh the vertices are read. Normals in the input orient the surface.\n"
         "OUTPUT  a mesh, by extension: "
      << mesh_file_extensions()
      << "\n"
         "        .ply gets the normals, the colors and all other numbers that a .ply input has at\n"
         "        its vertices; .off gets the normals and colors. .stl rounds the coordinates.\n\n"
      << internal::visible_options()
      << "\nExamples:\n"
         "  isr_reconstruct scan.xyz mesh.ply\n"
         "  isr_reconstruct terrain.ply terrain.off --keep-boundaries --stats terrain.json\n\n"
         "Exit status:\n"
         "    0  the mesh is written\n"
         "    1  unexpected error\n"
         "    2  bad option or missing argument\n"
         "    3  INPUT is missing or may not be read\n"
         "    4  the extension of INPUT or OUTPUT is unknown\n"
         "    5  INPUT has no points\n"
         "    6  INPUT is broken, incomplete, or not what its extension says\n"
         "    7  no surface was found\n"
         "    8  OUTPUT, or the file of --stats, cannot be written\n"
         "  130  interrupted, for example by Ctrl-C\n"
         "Except for status 0 no output file is created or changed.\n";
}

inline void print_version(std::ostream& out)
{
  out << "isr_reconstruct " << CGAL_ISR_VERSION << ", CGAL " << CGAL_VERSION_STR
#ifdef CGAL_LINKED_WITH_TBB
      << ", with TBB\n";
#else
      << ", without TBB\n";
#endif
}

inline Command_line parse_command_line(int argc, char** argv)
{
  namespace po = boost::program_options;
  po::options_description all = internal::visible_options();
  all.add_options()("input", po::value<std::string>())("output", po::value<std::string>());
  po::positional_options_description positions;
  positions.add("input", 1).add("output", 1);

  po::variables_map values;
  try {
    po::store(po::command_line_parser(argc, argv).options(all).positional(positions).run(), values);
  } catch (const po::error& error) {
    throw Failure(BAD_OPTION, std::string(error.what()) + "; see --help");
  }

  Command_line result;
  result.wants_help = values.count("help") != 0;
  result.wants_version = values.count("version") != 0;
  if (result.wants_help || result.wants_version)
    return result;
  if (values.count("input") == 0 || values.count("output") == 0)
    throw Failure(BAD_OPTION, "INPUT and OUTPUT are needed; see --help");
  result.input = values["input"].as<std::string>();
  result.output = values["output"].as<std::string>();
  result.stats = values.count("stats") != 0 ? values["stats"].as<std::string>() : std::string();
  result.is_quiet = values.count("quiet") != 0;
  result.reconstruction = internal::to_reconstruction_options(values);
  return result;
}

} // namespace isr

#endif // ISR_RECONSTRUCT_COMMAND_LINE_H

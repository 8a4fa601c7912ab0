// Reconstructs a surface through the points of a file and writes it as a mesh; see --help.

#include "isr_reconstruct/command_line.h"
#include "isr_reconstruct/exit_status.h"
#include "isr_reconstruct/interruption.h"
#include "isr_reconstruct/mesh_file.h"
#include "isr_reconstruct/methods.h"
#include "isr_reconstruct/output_file.h"
#include "isr_reconstruct/point_file.h"
#include "isr_reconstruct/point_properties.h"
#include "isr_reconstruct/progress_bar.h"
#include "isr_reconstruct/summary.h"

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

namespace {

void check_distinct_files(const isr::Command_line& arguments)
{
  namespace fs = std::filesystem;
  const auto are_same = [](const std::string& a, const std::string& b) {
    return !a.empty() && !b.empty() && fs::weakly_canonical(fs::absolute(a)) == fs::weakly_canonical(fs::absolute(b));
  };
  if (are_same(arguments.input, arguments.output) || are_same(arguments.input, arguments.stats) ||
      are_same(arguments.output, arguments.stats))
    throw isr::Failure(isr::BAD_OPTION, "input, output and statistics must be different files");
}

void reconstruct(const isr::Point_set& points, const isr::Command_line& arguments, isr::Point_counter& counter,
                 isr::Mesh& mesh)
{
  isr::Progress_bar bar(!arguments.is_quiet);
  const auto callback = [&bar](double fraction) {
    bar.show(fraction);
    return !isr::is_interrupted();
  };
  const isr::Reconstruction_options& options = arguments.reconstruction;
  if (!isr::methods().at(options.method)(points, mesh, options, counter, callback))
    throw isr::Failure(isr::INTERRUPTED, "interrupted");
}

void run(const isr::Command_line& arguments)
{
  isr::check_point_file_extension(arguments.input);
  isr::check_mesh_file_extension(arguments.output);
  check_distinct_files(arguments);

  // The input is checked first, and the outputs are opened before any time is spent on it.
  isr::Point_set points = isr::read_points(arguments.input);
  isr::Output_file output(arguments.output);
  std::optional<isr::Output_file> stats;
  if (!arguments.stats.empty())
    stats.emplace(arguments.stats);

  isr::Point_counter counter;
  isr::Mesh mesh;
  CGAL::Real_timer timer;
  timer.start();
  reconstruct(points, arguments, counter, mesh);
  timer.stop();
  if (mesh.number_of_faces() == 0)
    throw isr::Failure(isr::NO_SURFACE, "no surface found in '" + arguments.input +
                                          "': " + std::to_string(points.size()) + " points, of which " +
                                          std::to_string(counter.duplicates) + " are duplicates and " +
                                          std::to_string(counter.non_finite) + " are not finite");

  const isr::Summary summary =
    isr::summarize(arguments.input, arguments.output, arguments.reconstruction, points, counter, mesh, timer.time());
  isr::carry_properties(points, mesh);
  isr::write_mesh(mesh, output);
  if (stats) {
    summary.write_json(stats->stream());
    stats->finish();
    stats->commit();
  }
  output.commit();
  if (!arguments.is_quiet)
    summary.print(std::cout);
}

// One line, whatever the message.
int report(isr::Exit_status status, std::string message)
{
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "isr_reconstruct: " << message << std::endl;
  return status;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const isr::Command_line arguments = isr::parse_command_line(argc, argv);
    if (arguments.wants_help)
      isr::print_help(std::cout);
    else if (arguments.wants_version)
      isr::print_version(std::cout);
    else {
      isr::catch_interruptions();
      run(arguments);
    }
    return isr::SUCCESS;
  } catch (const isr::Failure& failure) {
    return report(failure.status(), failure.what());
  } catch (const std::exception& error) {
    return report(isr::UNEXPECTED, error.what());
  }
}

#ifndef ISR_RECONSTRUCT_SUMMARY_H
#define ISR_RECONSTRUCT_SUMMARY_H

#include "methods.h"
#include "point_properties.h"

#include <cstddef>
#include <cstdio>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace isr {

struct Mesh_counts
{
  std::size_t components = 0, boundary_loops = 0, boundary_edges = 0;
  std::ptrdiff_t euler_characteristic = 0;
};

inline std::size_t count_components(const Mesh& mesh)
{
  std::vector<bool> is_visited(mesh.number_of_faces(), false);
  std::vector<Mesh::Face_index> stack;
  const auto visit = [&](Mesh::Face_index f) {
    if (!is_visited[f])
      stack.push_back(f);
    is_visited[f] = true;
  };

  std::size_t components = 0;
  for (Mesh::Face_index seed : mesh.faces()) {
    if (is_visited[seed])
      continue;
    ++components;
    visit(seed);
    while (!stack.empty()) {
      const Mesh::Face_index face = stack.back();
      stack.pop_back();
      for (Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(face)))
        if (!mesh.is_border(mesh.opposite(h)))
          visit(mesh.face(mesh.opposite(h)));
    }
  }
  return components;
}

inline Mesh_counts count(const Mesh& mesh)
{
  Mesh_counts counts;
  counts.components = count_components(mesh);
  std::vector<bool> is_visited(mesh.number_of_halfedges(), false);
  for (Mesh::Halfedge_index h : mesh.halfedges()) {
    if (!mesh.is_border(h))
      continue;
    ++counts.boundary_edges;
    if (is_visited[h])
      continue;
    ++counts.boundary_loops;
    for (Mesh::Halfedge_index i = h; !is_visited[i]; i = mesh.next(i))
      is_visited[i] = true;
  }
  counts.euler_characteristic = static_cast<std::ptrdiff_t>(mesh.number_of_vertices()) -
                                static_cast<std::ptrdiff_t>(mesh.number_of_edges()) +
                                static_cast<std::ptrdiff_t>(mesh.number_of_faces());
  return counts;
}

inline std::size_t peak_memory_in_bytes()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return static_cast<std::size_t>(usage.ru_maxrss);
#else
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024; // Linux and the BSDs count in KiB
#endif
}

// What is printed at the end, and written as JSON: each entry once, for both.
class Summary
{
public:
  void add_text(const std::string& key, const std::string& label, const std::string& value)
  {
    m_entries.push_back({ key, label, value, true });
  }

  template <typename Number>
  void add_number(const std::string& key, const std::string& label, Number value)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic()); // JSON has no other decimal separator
    text << value;
    m_entries.push_back({ key, label, text.str(), false });
  }

  void print(std::ostream& out) const
  {
    for (const Entry& entry : m_entries)
      out << entry.label << ": " << std::string(LABEL_WIDTH - entry.label.size(), ' ') << entry.value << '\n';
    out.flush();
  }

  void write_json(std::ostream& out) const
  {
    out << "{\n";
    for (std::size_t i = 0; i != m_entries.size(); ++i) {
      const Entry& entry = m_entries[i];
      out << "  " << quoted(entry.key) << ": " << (entry.is_text ? quoted(entry.value) : entry.value)
          << (i + 1 == m_entries.size() ? "\n" : ",\n");
    }
    out << "}\n";
  }

private:
  static constexpr std::size_t LABEL_WIDTH = 24;

  struct Entry
  {
    std::string key, label, value;
    bool is_text;
  };

  static std::string quoted(const std::string& text)
  {
    std::string result = "\"";
    for (const char c : text) {
      if (static_cast<unsigned char>(c) < 0x20) {
        char escaped[7];
        std::snprintf(escaped, sizeof(escaped), "\\u%04x", static_cast<unsigned int>(c));
        result += escaped;
        continue;
      }
      if (c == '"' || c == '\\')
        result += '\\';
      result += c;
    }
    return result + '"';
  }

  std::vector<Entry> m_entries;
};

inline Summary summarize(const std::string& input, const std::string& output, const Reconstruction_options& options,
                         const Point_set& points, const Point_counter& counter, const Mesh& mesh, double seconds)
{
  const Mesh_counts counts = count(mesh);
  Summary summary;
  summary.add_text("input", "input", input);
  summary.add_text("output", "output", output);
  summary.add_text("method", "method", options.method);
  summary.add_number("threads", "threads", options.threads);
  summary.add_number("points_read", "points read", points.size());
  summary.add_number("points_duplicate", "set aside, duplicate", counter.duplicates);
  summary.add_number("points_non_finite", "set aside, not finite", counter.non_finite);
  summary.add_number("points_unused", "points unused", counter.unused);
  summary.add_number("vertices", "vertices", mesh.number_of_vertices());
  summary.add_number("triangles", "triangles", mesh.number_of_faces());
  summary.add_number("components", "components", counts.components);
  summary.add_number("boundary_loops", "boundary loops", counts.boundary_loops);
  summary.add_number("boundary_edges", "boundary edges", counts.boundary_edges);
  summary.add_number("euler_characteristic", "Euler characteristic", counts.euler_characteristic);
  summary.add_number("seconds", "seconds", seconds);
  summary.add_number("points_per_second", "points per second",
                     seconds > 0. ? static_cast<std::size_t>(static_cast<double>(points.size()) / seconds) : 0);
  summary.add_number("peak_memory_bytes", "peak memory, bytes", peak_memory_in_bytes());
  return summary;
}

} // namespace isr

#endif // ISR_RECONSTRUCT_SUMMARY_H

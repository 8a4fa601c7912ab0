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

#ifndef ISR_BENCHMARK_COMPARISON_REPORT_H
#define ISR_BENCHMARK_COMPARISON_REPORT_H

#include "mesh_statistics.h"
#include "surface_metrics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace isr_benchmark {

struct Row
{
  std::string model, method;
  double minimum_seconds = 0., median_seconds = 0.;
  bool has_times = false;
  double speedup = 0.; // time of the advancing front over the time of this method; 0: unknown
  Mesh_statistics statistics;
  bool has_intersections = false;
  std::size_t intersections = 0;
  bool has_metrics = false;
  Surface_metrics metrics;

  void set_times(std::vector<double> seconds)
  {
    if (seconds.empty())
      return;
    std::sort(seconds.begin(), seconds.end());
    minimum_seconds = seconds.front();
    median_seconds = seconds[seconds.size() / 2];
    has_times = true;
  }
};

struct Model_rows
{
  bool has_reference = false;
  Row reference;
  std::vector<Row> found; // the advancing front first, if it was run
};

// Prints one line a model and method as they come, and counts and sums at the end.
class Report
{
public:
  Report(std::ostream& out, const std::string& csv_file)
    : m_out(out)
  {
    if (!csv_file.empty()) {
      m_csv.open(csv_file);
      if (!m_csv)
        throw std::runtime_error(csv_file + ": cannot be written");
    }
    std::vector<std::string> titles;
    for (const Column& column : columns())
      titles.push_back(column.title);
    print(titles);
  }

  void add(Model_rows rows)
  {
    const bool has_baseline = rows.found.front().method == "AF" && rows.found.front().has_times;
    for (Row& row : rows.found)
      if (has_baseline && row.has_times)
        row.speedup = rows.found.front().minimum_seconds / row.minimum_seconds;
    if (rows.has_reference)
      print(cells(rows.reference));
    for (const Row& row : rows.found)
      print(cells(row));
    m_out << std::flush;
    m_models.push_back(rows);
  }

  void summarize() const
  {
    if (m_models.empty())
      return;
    m_out << '\n';
    for (std::size_t m = 0; m != m_models.front().found.size(); ++m)
      summarize(m);
  }

private:
  struct Column { const char* title; int width; };

  static const std::vector<Column>& columns()
  {
    static const std::vector<Column> result = {
      { "model", -18 }, { "method", -9 }, { "min_s", 8 }, { "med_s", 8 }, { "AF/x", 6 },
      { "triangles", 9 }, { "used", 7 }, { "points", 7 }, { "comp", 5 }, { "b_edges", 7 }, { "loops", 5 },
      { "euler", 6 }, { "nm_e", 5 }, { "nm_v", 5 }, { "degen", 5 }, { "orient", 6 }, { "outward", 7 },
      { "crossings", 9 }, { "H%", 9 }, { "mean%", 9 }, { "RMS%", 9 }, { "SD%", 9 } };
    return result;
  }

  template <typename T>
  static std::string text(const T& value) { return std::to_string(value); }

  static std::string text(double value, int digits)
  {
    std::ostringstream out;
    out << std::fixed << std::setprecision(digits) << value;
    return out.str();
  }

  static std::vector<std::string> cells(const Row& row)
  {
    const std::string none = "-";
    const Mesh_statistics& s = row.statistics;
    const auto metric = [&](double value) { return row.has_metrics ? text(value, 5) : none; };
    return { row.model, row.method,
             row.has_times ? text(row.minimum_seconds, 4) : none,
             row.has_times ? text(row.median_seconds, 4) : none,
             row.speedup > 0. ? text(row.speedup, 2) : none,
             text(s.triangles), text(s.used_points), text(s.distinct_points), text(s.components),
             text(s.boundary_edges), text(s.boundary_loops), text(s.euler_characteristic),
             text(s.nonmanifold_edges), text(s.nonmanifold_vertices), text(s.degenerate_triangles),
             s.is_oriented ? "yes" : "no",
             text(s.outward_components) + "/" + text(s.closed_components),
             row.has_intersections ? text(row.intersections) : none,
             metric(row.metrics.hausdorff), metric(row.metrics.mean), metric(row.metrics.root_mean_square),
             metric(row.metrics.standard_deviation) };
  }

  void print(const std::vector<std::string>& values)
  {
    for (std::size_t i = 0; i != values.size(); ++i) {
      const int width = columns()[i].width;
      m_out << (i == 0 ? "" : " ") << (width < 0 ? std::left : std::right) << std::setw(std::abs(width))
            << values[i];
      if (m_csv)
        m_csv << (i == 0 ? "" : ",") << values[i];
    }
    m_out << '\n';
    if (m_csv)
      m_csv << '\n' << std::flush;
  }

  // Equal distances may differ in the last digits of their sums.
  static bool is_not_above(double a, double b) { return a <= b * (1 + 1e-9) + 1e-12; }

  void summarize(std::size_t m) const
  {
    std::size_t closed = 0, manifold = 0, oriented = 0, all_used = 0, references = 0, closed_references = 0;
    std::size_t exact = 0, closed_exact = 0, counted = 0, without_crossings = 0, crossings = 0;
    std::size_t compared = 0, hausdorff = 0, mean = 0, timed = 0;
    double seconds = 0., log_speedup = 0.;
    Surface_metrics sum;
    for (const Model_rows& rows : m_models) {
      const Row& row = rows.found[m];
      const Row& baseline = rows.found.front();
      const Mesh_statistics& s = row.statistics;
      closed += s.is_closed() ? 1u : 0u;
      manifold += s.is_manifold() ? 1u : 0u;
      oriented += s.is_oriented && s.outward_components == s.closed_components ? 1u : 0u;
      all_used += s.used_points == s.distinct_points ? 1u : 0u;
      if (rows.has_reference) {
        const bool is_exact = has_same_topology(s, rows.reference.statistics);
        ++references;
        exact += is_exact ? 1u : 0u;
        if (rows.reference.statistics.is_closed()) {
          ++closed_references;
          closed_exact += is_exact ? 1u : 0u;
        }
      }
      if (row.has_intersections) {
        ++counted;
        crossings += row.intersections;
        without_crossings += row.intersections == 0 ? 1u : 0u;
      }
      if (row.has_metrics) {
        ++compared;
        hausdorff += is_not_above(row.metrics.hausdorff, baseline.metrics.hausdorff) ? 1u : 0u;
        mean += is_not_above(row.metrics.mean, baseline.metrics.mean) ? 1u : 0u;
        sum.hausdorff += row.metrics.hausdorff;
        sum.mean += row.metrics.mean;
        sum.root_mean_square += row.metrics.root_mean_square;
      }
      if (row.speedup > 0.) {
        ++timed;
        log_speedup += std::log(row.speedup);
      }
      seconds += row.minimum_seconds;
    }
    const Row& first = m_models.front().found[m];
    const std::string& baseline = m_models.front().found.front().method;
    m_out << "summary " << first.method << " over " << m_models.size() << " models: closed " << closed
          << ", manifold " << manifold << ", oriented and outward " << oriented << ", all points used "
          << all_used << ", seconds " << text(seconds, 3);
    if (timed != 0)
      m_out << ", AF/" << first.method << " time " << text(std::exp(log_speedup / double(timed)), 2)
            << " (geometric mean)";
    m_out << '\n';
    if (references != 0)
      m_out << "  exact topology: " << closed_exact << " of " << closed_references << " closed references, "
            << exact << " of all " << references << '\n';
    if (counted != 0)
      m_out << "  free of self-intersection: " << without_crossings << " of " << counted << ", pairs in all "
            << crossings << '\n';
    if (compared != 0)
      m_out << "  H not above " << baseline << ": " << hausdorff << ", mean not above " << baseline << ": " << mean
            << " of " << compared << "; sum of H " << text(sum.hausdorff, 4) << ", of means "
            << text(sum.mean, 5) << ", of RMS " << text(sum.root_mean_square, 5) << '\n';
  }

  std::ostream& m_out;
  std::ofstream m_csv;
  std::vector<Model_rows> m_models;
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_COMPARISON_REPORT_H

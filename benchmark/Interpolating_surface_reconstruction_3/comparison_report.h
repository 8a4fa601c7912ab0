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

#include "measures/mesh_statistics.h"
#include "measures/surface_metrics.h"

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
  Report(std::ostream& out, const std::string& csv_file) : m_out(out)
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
  struct Column
  {
    const char* title;
    int width;
  };

  static const std::vector<Column>& columns()
  {
    static const std::vector<Column> result = { { "model", -18 }, { "method", -9 },   { "min_s", 8 }, { "med_s", 8 },
                                                { "AF/x", 6 },    { "triangles", 9 }, { "used", 7 },  { "points", 7 },
                                                { "comp", 5 },    { "b_edges", 7 },   { "loops", 5 }, { "euler", 6 },
                                                { "nm_e", 5 },    { "nm_v", 5 },      { "degen", 5 }, { "orient", 6 },
                                                { "outward", 7 }, { "crossings", 9 }, { "H%", 9 },    { "mean%", 9 },
                                                { "RMS%", 9 },    { "SD%", 9 } };
    return result;
  }

  template <typename T>
  static std::string text(const T& value)
  {
    return std::to_string(value);
  }

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
    return { row.model,
             row.method,
             row.has_times ? text(row.minimum_seconds, 4) : none,
             row.has_times ? text(row.median_seconds, 4) : none,
             row.speedup > 0. ? text(row.speedup, 2) : none,
             text(s.triangles),
             text(s.used_points),
             text(s.distinct_points),
             text(s.components),
             text(s.boundary_edges),
             text(s.boundary_loops),
             text(s.euler_characteristic),
             text(s.nonmanifold_edges),
             text(s.nonmanifold_vertices),
             text(s.degenerate_triangles),
             s.is_oriented ? "yes" : "no",
             text(s.outward_components) + "/" + text(s.closed_components),
             row.has_intersections ? text(row.intersections) : none,
             metric(row.metrics.hausdorff),
             metric(row.metrics.mean),
             metric(row.metrics.root_mean_square),
             metric(row.metrics.standard_deviation) };
  }

  void print(const std::vector<std::string>& values)
  {
    for (std::size_t i = 0; i != values.size(); ++i) {
      const int width = columns()[i].width;
      m_out << (i == 0 ? "" : " ") << (width < 0 ? std::left : std::right) << std::setw(std::abs(width)) << values[i];
      if (m_csv)
        m_csv << (i == 0 ? "" : ",") << values[i];
    }
    m_out << '\n';
    if (m_csv)
      m_csv << '\n' << std::flush;
  }

  // Equal distances may differ in the last digits of their sums.
  static bool is_not_above(double a, double b) { return a <= b * (1 + 1e-9) + 1e-12; }

  // Counts and sums of one method over the models.
  struct Summary
  {
    std::size_t closed = 0, manifold = 0, outward = 0, all_used = 0;
    std::size_t references = 0, exact = 0, closed_references = 0, exact_closed = 0;
    std::size_t tested = 0, without_intersections = 0, intersections = 0;
    std::size_t compared = 0, hausdorff_not_above = 0, mean_not_above = 0, timed = 0;
    double seconds = 0., log_speedup = 0.;
    Surface_metrics sum;

    void add(const Row& row, const Row& baseline)
    {
      const Mesh_statistics& s = row.statistics;
      closed += s.is_closed() ? 1u : 0u;
      manifold += s.is_manifold() ? 1u : 0u;
      outward += s.is_oriented && s.outward_components == s.closed_components ? 1u : 0u;
      all_used += s.used_points == s.distinct_points ? 1u : 0u;
      seconds += row.minimum_seconds;
      if (row.speedup > 0.) {
        ++timed;
        log_speedup += std::log(row.speedup);
      }
      if (row.has_intersections) {
        ++tested;
        intersections += row.intersections;
        without_intersections += row.intersections == 0 ? 1u : 0u;
      }
      if (row.has_metrics)
        add_metrics(row.metrics, baseline.metrics);
    }

    void add_metrics(const Surface_metrics& found, const Surface_metrics& baseline)
    {
      ++compared;
      hausdorff_not_above += is_not_above(found.hausdorff, baseline.hausdorff) ? 1u : 0u;
      mean_not_above += is_not_above(found.mean, baseline.mean) ? 1u : 0u;
      sum.hausdorff += found.hausdorff;
      sum.mean += found.mean;
      sum.root_mean_square += found.root_mean_square;
    }

    void add_topology(const Mesh_statistics& found, const Mesh_statistics& reference)
    {
      const std::size_t is_exact = has_same_topology(found, reference) ? 1u : 0u;
      ++references;
      exact += is_exact;
      if (reference.is_closed()) {
        ++closed_references;
        exact_closed += is_exact;
      }
    }
  };

  void summarize(std::size_t m) const
  {
    Summary s;
    for (const Model_rows& rows : m_models) {
      s.add(rows.found[m], rows.found.front());
      if (rows.has_reference)
        s.add_topology(rows.found[m].statistics, rows.reference.statistics);
    }
    print(s, m_models.front().found[m].method, m_models.front().found.front().method);
  }

  void print(const Summary& s, const std::string& method, const std::string& baseline) const
  {
    m_out << "summary " << method << " over " << m_models.size() << " models: closed " << s.closed << ", manifold "
          << s.manifold << ", oriented and outward " << s.outward << ", all points used " << s.all_used << ", seconds "
          << text(s.seconds, 3);
    if (s.timed != 0)
      m_out << ", AF/" << method << " time " << text(std::exp(s.log_speedup / double(s.timed)), 2)
            << " (geometric mean)";
    m_out << '\n';
    if (s.references != 0)
      m_out << "  exact topology: " << s.exact_closed << " of " << s.closed_references << " closed references, "
            << s.exact << " of all " << s.references << '\n';
    if (s.tested != 0)
      m_out << "  free of self-intersection: " << s.without_intersections << " of " << s.tested << ", pairs in all "
            << s.intersections << '\n';
    if (s.compared == 0)
      return;
    m_out << "  over " << s.compared << " references: ";
    if (baseline != method)
      m_out << "H not above " << baseline << ": " << s.hausdorff_not_above << ", mean not above " << baseline << ": "
            << s.mean_not_above << "; ";
    m_out << "sum of H " << text(s.sum.hausdorff, 4) << ", of means " << text(s.sum.mean, 5) << ", of RMS "
          << text(s.sum.root_mean_square, 5) << '\n';
  }

  std::ostream& m_out;
  std::ofstream m_csv;
  std::vector<Model_rows> m_models;
};

} // namespace isr_benchmark

#endif // ISR_BENCHMARK_COMPARISON_REPORT_H

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs compare: the rows of the paper's Table 1 for the given curves.

#include "Commands.h"
#include "Output_file.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <map>

namespace bounding_arcs_tool {
namespace {

// Of the repetitions, in milliseconds.
struct Times {
  double least = 0, median = 0;

  Times() = default;
  explicit Times(std::vector<double> all) {
    std::sort(all.begin(), all.end());
    least = all.front();
    median = all[all.size() / 2];
  }
  void add(const Times& other) {
    least += other.least;
    median += other.median;
  }
};

struct Row {
  std::size_t place;  // of the curve among all, ALL for their sums
  std::string curve;
  std::size_t beziers, spirals;
  Method method;
  double eps;
  Times segmentation;  // control points to spiral segments
  Times build;         // these to the hierarchy
  Times regions;       // these to the hierarchy and the arcs of its leaves in memory
  Hierarchy_size size;
};

constexpr std::size_t ALL = std::numeric_limits<std::size_t>::max();

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

Times measure_segmentation(const Loaded_curve& curve, const Options& options) {
  std::vector<double> times;
  for (std::size_t i = 0; i < options.repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const auto segmented = segment(curve.record, options.kernel);
    times.push_back(milliseconds_since(start));
  }
  return Times(times);
}

Row measure(std::size_t place, const Loaded_curve& curve, const Times& segmentation, Method method, double eps,
            const Options& options) {
  std::vector<double> builds, regions;
  Hierarchy_size size{};
  for (std::size_t i = 0; i < options.repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const auto hierarchy = build_hierarchy(curve, method, eps, options);
    builds.push_back(milliseconds_since(start));
    size = hierarchy->size();
  }
  for (std::size_t i = 0; i < options.repeat; ++i) {  // apart, as arcs would take the caches from the builds
    const auto start = std::chrono::steady_clock::now();
    const auto hierarchy = build_hierarchy(curve, method, eps, options);
    const double build = milliseconds_since(start);
    hierarchy->make_arcs();  // memory that was used before is not paid for, neither here nor in the build
    const auto made = std::chrono::steady_clock::now();
    hierarchy->make_arcs();
    regions.push_back(build + milliseconds_since(made));
  }
  return {place,
          curve.record.name,
          curve.segmented->number_of_beziers(),
          curve.segmented->number_of_spirals(),
          method,
          eps,
          segmentation,
          Times(builds),
          Times(regions),
          size};
}

// Sums over all curves, for each method and eps.
std::vector<Row> totals(const std::vector<Row>& rows) {
  std::vector<Row> sums;
  for (const Row& row : rows) {
    const auto sum = std::find_if(sums.begin(), sums.end(),
                                  [&](const Row& s) { return s.method == row.method && s.eps == row.eps; });
    if (sum == sums.end()) {
      sums.push_back(row);
      sums.back().curve = "all";
      sums.back().place = ALL;
      continue;
    }
    sum->beziers += row.beziers;
    sum->spirals += row.spirals;
    sum->segmentation.add(row.segmentation);
    sum->build.add(row.build);
    sum->regions.add(row.regions);
    sum->size.regions += row.size.regions;
    sum->size.arcs += row.size.arcs;
    sum->size.nodes += row.size.nodes;
    sum->size.bytes += row.size.bytes;
  }
  return sums;
}

void write_table(std::ostream& out, const std::vector<Row>& rows) {
  // for the ratios: the first method's row of the same curve and eps
  std::map<std::pair<std::size_t, double>, const Row*> reference;
  std::size_t width = 5;
  for (const Row& row : rows) {
    reference.emplace(std::make_pair(row.place, row.eps), &row);
    width = std::max(width, table_name(row.curve).size());
  }
  char line[400];
  std::snprintf(line, sizeof line, "%-*s %7s %7s  %8s %-6s %9s %9s %9s %9s %9s %9s %9s %9s %8s\n",
                static_cast<int>(width), "curve", "beziers", "spirals", "eps", "method", "cut ms", "build ms",
                "arcs ms", "sum ms", "regions", "arcs", "nodes", "ns/region", "regions:");
  out << line;
  for (const Row& row : rows) {
    const Row& first = *reference.at({row.place, row.eps});
    std::snprintf(line, sizeof line, "%-*s %7zu %7zu  %8g %-6s %9.4f %9.4f %9.4f %9.4f %9zu %9zu %9zu %9.1f %8.3f\n",
                  static_cast<int>(width), table_name(row.curve).c_str(), row.beziers, row.spirals, row.eps,
                  name_of(row.method), row.segmentation.least, row.build.least, row.regions.least - row.build.least,
                  row.segmentation.least + row.regions.least, row.size.regions, row.size.arcs, row.size.nodes,
                  1e6 * row.regions.least / static_cast<double>(row.size.regions),
                  static_cast<double>(row.size.regions) / static_cast<double>(first.size.regions));
    out << line;
  }
  out << "\ncut: control points to spiral segments; build: these to the hierarchy; arcs: those of its leaf regions, "
         "in\n"
         "memory; the shortest of all repetitions, and their sum. ns/region: of build and arcs.\n"
         "regions: is the number of leaf regions over that of the first method at the same eps.\n";
}

void write_times(std::ostream& out, const char* name, const Times& times) {
  out << ",\"" << name << "\":{\"min\":" << number(times.least) << ",\"median\":" << number(times.median) << '}';
}

void write_json(std::ostream& out, const std::vector<Row>& rows) {
  out << "{\"rows\":[";
  const char* separator = "\n";
  for (const Row& row : rows) {
    out << separator << "{\"curve\":" << json_string(row.curve) << ",\"beziers\":" << row.beziers
        << ",\"spirals\":" << row.spirals << ",\"method\":\"" << name_of(row.method)
        << "\",\"eps\":" << number(row.eps);
    write_times(out, "segmentation_ms", row.segmentation);
    write_times(out, "time_ms", row.build);
    write_times(out, "regions_ms", row.regions);
    out << ",\"regions\":" << row.size.regions << ",\"arcs\":" << row.size.arcs << ",\"nodes\":" << row.size.nodes
        << '}';
    separator = ",\n";
  }
  out << "]}\n";
}

}  // namespace

int run_compare(const Options& options) {
  const std::vector<Loaded_curve> curves = load_curves(options);
  std::vector<Row> rows;
  {
    Progress_line progress("measuring, rows");
    const std::size_t all = curves.size() * options.methods.size() * options.eps.size();
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const Times segmentation = measure_segmentation(curves[i], options);
      for (const double eps : options.eps)
        for (const Method method : options.methods) {
          rows.push_back(measure(i, curves[i], segmentation, method, eps, options));
          progress(rows.size(), all);
        }
    }
  }
  Output_file output(options.output);
  if (options.format == Format::JSON) {
    write_json(output.stream(), rows);
  } else {
    const std::vector<Row> sums = totals(rows);
    if (curves.size() > 1) rows.insert(rows.end(), sums.begin(), sums.end());
    write_table(output.stream(), rows);
  }
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool

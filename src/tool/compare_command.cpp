// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs compare: the rows of the paper's Table 1 for the given curves.

#include "Comparison.h"
#include "Output_file.h"

#include <algorithm>
#include <cstdio>
#include <map>

namespace bounding_arcs_tool {
namespace {

void write_table(std::ostream& out, const std::vector<Comparison_row>& rows) {
  // for the ratios: the first method's row of the same curve and eps
  std::map<std::pair<std::size_t, double>, const Comparison_row*> reference;
  std::size_t width = 5;
  for (const Comparison_row& row : rows) {
    reference.emplace(std::make_pair(row.place, row.eps), &row);
    width = std::max(width, table_name(row.curve).size());
  }
  char line[400];
  std::snprintf(line, sizeof line, "%-*s %7s %7s  %8s %-12s %9s %9s %9s %9s %9s %9s %9s %9s %8s\n",
                static_cast<int>(width), "curve", "beziers", "spirals", "eps", "method", "cut ms", "build ms",
                "arcs ms", "sum ms", "regions", "arcs", "nodes", "ns/region", "regions:");
  out << line;
  for (const Comparison_row& row : rows) {
    const Comparison_row& first = *reference.at({row.place, row.eps});
    std::snprintf(line, sizeof line, "%-*s %7zu %7zu  %8s %-12s %9.4f %9.4f %9.4f %9.4f %9zu %9zu %9zu %9.1f %8.3f\n",
                  static_cast<int>(width), table_name(row.curve).c_str(), row.beziers, row.spirals,
                  number(row.eps).c_str(), name_of(row.method), row.segmentation.least, row.build.least,
                  row.regions.least - row.build.least, row.segmentation.least + row.regions.least, row.size.regions,
                  row.size.arcs, row.size.nodes, 1e6 * row.regions.least / static_cast<double>(row.size.regions),
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

void write_json(std::ostream& out, const std::vector<Comparison_row>& rows) {
  out << "{\"rows\":[";
  const char* separator = "\n";
  for (const Comparison_row& row : rows) {
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
  std::vector<Comparison_row> rows;
  {
    Progress_line progress("measuring, rows");
    rows = comparison(curves, options, [&](std::size_t done, std::size_t all) { progress(done, all); });
  }
  Output_file output(options.output);
  if (options.format == Format::JSON) {
    write_json(output.stream(), rows);
  } else {
    const std::vector<Comparison_row> sums = totals(rows);
    if (curves.size() > 1) rows.insert(rows.end(), sums.begin(), sums.end());
    write_table(output.stream(), rows);
  }
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool

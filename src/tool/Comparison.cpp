// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Comparison.h"

#include <chrono>

namespace bounding_arcs_tool {
namespace {

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

Comparison_row measure(std::size_t place, const Loaded_curve& curve, const Times& segmentation, Method method,
                       double eps, const Options& options) {
  std::vector<double> builds, regions;
  Hierarchy_size size{};
  double thickness = 0;
  for (std::size_t i = 0; i < options.repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const auto hierarchy = build_hierarchy(curve, method, eps, options);
    builds.push_back(milliseconds_since(start));
    size = hierarchy->size();
    thickness = hierarchy->bound();
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
          size,
          thickness};
}

}  // namespace

std::vector<Comparison_row> comparison(const std::vector<Loaded_curve>& curves, const Options& options,
                                       const Progress& done) {
  std::vector<Comparison_row> rows;
  const std::size_t all = curves.size() * options.methods.size() * options.eps.size();
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Times segmentation = measure_segmentation(curves[i], options);
    for (const double eps : options.eps)
      for (const Method method : options.methods) {
        rows.push_back(measure(i, curves[i], segmentation, method, eps, options));
        if (done) done(rows.size(), all);
      }
  }
  return rows;
}

std::vector<Comparison_row> totals(const std::vector<Comparison_row>& rows) {
  std::vector<Comparison_row> sums;
  for (const Comparison_row& row : rows) {
    const auto sum = std::find_if(sums.begin(), sums.end(),
                                  [&](const Comparison_row& s) { return s.method == row.method && s.eps == row.eps; });
    if (sum == sums.end()) {
      sums.push_back(row);
      sums.back().curve = "all";
      sums.back().place = Comparison_row::ALL;
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
    sum->thickness = std::max(sum->thickness, row.thickness);
  }
  return sums;
}

}  // namespace bounding_arcs_tool

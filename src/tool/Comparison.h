// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is measured of methods and tolerances: the rows of the paper's Table 1 for given curves.

#ifndef BOUNDING_ARCS_TOOL_COMPARISON_H
#define BOUNDING_ARCS_TOOL_COMPARISON_H

#include "Commands.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// The times of repetitions, in milliseconds.
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

struct Comparison_row {
  static constexpr std::size_t ALL = std::numeric_limits<std::size_t>::max();

  std::size_t place;  ///< of the curve among all, ALL for their sums
  std::string curve;
  std::size_t beziers, spirals;
  Method method;
  double eps;
  Times segmentation;  ///< control points to spiral segments
  Times build;         ///< these to the hierarchy
  Times regions;       ///< these to the hierarchy and the arcs of its leaves in memory
  Hierarchy_size size;
  double thickness;  ///< the largest of a leaf
};

/// A row for each curve, eps and method, in this order. `done` is called with the number of rows.
/// \throws Input_error when an eps cannot be reached
[[nodiscard]] std::vector<Comparison_row> comparison(const std::vector<Loaded_curve>& curves, const Options& options,
                                                     const Progress& done);
/// Sums over all curves, for each method and eps.
[[nodiscard]] std::vector<Comparison_row> totals(const std::vector<Comparison_row>& rows);

}  // namespace bounding_arcs_tool

#endif

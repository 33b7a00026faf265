// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The trees of one curve and method for several tolerances as one: as pieces are halved, that of a larger tolerance is
// the upper part of that of a smaller one.

#ifndef BOUNDING_ARCS_TOOL_REPORT_NESTED_TREES_H
#define BOUNDING_ARCS_TOOL_REPORT_NESTED_TREES_H

#include "../Commands.h"

#include "Page_scale.h"

#include <string>
#include <vector>

namespace bounding_arcs_tool {

struct Nested_node {
  std::size_t level;  ///< 0 over a whole spiral segment
  int leaf;           ///< the number of the smallest tolerance for which it is a leaf, -1 for none
  std::size_t end;    ///< where the nodes below it end; they begin behind it
  Output_region region;
};

/// How size and thickness change from one level to the next: sums of logarithms over pieces that are halved.
struct Halvings {
  std::size_t count = 0;
  double size = 0, thickness = 0;                ///< of the pieces
  double size_change = 0, thickness_change = 0;  ///< from these to the mean of their halves
};

class Nested_trees {
 public:
  /// \param eps from large to small, not empty \throws Input_error when one cannot be reached
  Nested_trees(const Loaded_curve& curve, Method method, const std::vector<double>& eps, const Options& options);

  /// Each before those below it, the first half before the second.
  [[nodiscard]] const std::vector<Nested_node>& nodes() const { return nodes_; }
  /// Four numbers a spiral segment: where it starts and where it ends.
  [[nodiscard]] std::string ends_json(const Page_scale& scale) const;
  /// For each node its leaf, thickness, inner and outer chain and, where it is a leaf for no or not for the last
  /// tolerance, the point in which it is halved. A chain is a bulge, or the list of a joint and two bulges.
  [[nodiscard]] std::string nodes_json(const Page_scale& scale) const;
  /// Adds to the sums of each level. Pieces of no size or thickness tell nothing.
  void add_halvings(std::vector<Halvings>& levels) const;

 private:
  std::vector<Nested_node> nodes_;
};

}  // namespace bounding_arcs_tool

#endif

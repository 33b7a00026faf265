// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What Offset_source_2 (offset/Offset_source_2.h) keeps: arcs of closed and open curves, in the unit of the tree.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_OFFSET_SOURCES_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_OFFSET_SOURCES_H

#include "Filled_outline.h"
#include "Offset_job.h"
#include "Source_arcs.h"

#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>
#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include "../tree/Segment_hierarchy.h"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Arcs of curves, ready for offsets at any number of distances.
class Offset_sources {
 public:
  Offset_sources(const Bounding_arc_tree_2& tree, const Offset_job& job);
  Offset_sources(const std::vector<Offset_chain>& chains, const Offset_job& job);

  /// See Offset_source_2.
  [[nodiscard]] Offset at(double d) const;
  [[nodiscard]] Offset outline() const;
  [[nodiscard]] std::vector<std::uint32_t> left_out() const;
  [[nodiscard]] std::size_t number_of_arcs() const { return all_.arcs.size(); }

 private:
  void add_segments(const Segment_hierarchy& segments);
  void add_curves(const Segment_hierarchy& segments, std::size_t first, std::size_t last);
  void add_curve(std::vector<Chain_arc_2> arcs, const std::vector<Bezier_spiral_2<double>>& spirals,
                 std::uint32_t curve, bool is_closed, const Xy<double>& start);
  void add_arcs(const std::vector<Chain_arc_2>& arcs, const std::vector<Bezier_spiral_2<double>>& spirals,
                std::uint32_t curve, bool is_closed, const Xy<double>& start, double eps);
  void part_closed_and_open();
  [[nodiscard]] const Source_arcs& closed() const { return has_both_ ? closed_ : all_; }
  [[nodiscard]] const Filled_outline& filled() const;
  [[nodiscard]] Offset unmoved(const Source_arcs& sources, double error) const;
  [[nodiscard]] Offset in_unit_at(double d, double error) const;
  [[nodiscard]] Offset out(Offset offset) const;
  void finish_status(Offset& offset) const;

  [[nodiscard]] Offset_job checked(Offset_job job) const;

  Unit unit_;  // of all that follows
  Offset_job job_;
  Source_arcs all_, closed_, open_;  // the last two only where there are both
  bool has_both_ = false, has_closed_ = false;
  mutable std::mutex mutex_;
  mutable std::optional<Filled_outline> filled_;  // not needed for d > 0
  double chain_error_ = 0;
  bool is_resolved_ = true;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of boolean/boolean_operations.h.
//
//   trees -> one list of segments -> overlay -> faces that are inside -> loops of edges round them -> chains of parts

#include "../overlay/Overlay.h"
#include "../overlay/United_curves.h"
#include "Region_loops.h"

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

/// What operands fill, told from face to face by what is crossed between them.
class Filled_faces {
 public:
  Filled_faces(const std::vector<Fill_rule>& rules, const United_curves& united, const Overlay& overlay)
      : rules_(rules), united_(united), cut_(overlay.cut()), winding_(rules.size(), 0) {}

  /// Goes over an edge from the left of a side.
  void cross(Edge_side s) {
    for (std::uint32_t e = edge_of(s); e != NO_NUMBER; e = cut_.next_member(e)) {
      const Cut_edge& edge = cut_.edges()[e];
      // the left of an edge has one more than its right
      add(united_.operands[edge.curve], edge.is_against == is_reversed(s) ? -1 : 1);
    }
  }
  [[nodiscard]] bool is_of(Outline_2::Operation operation) const {
    switch (operation) {
      case Outline_2::Operation::UNION:
        return filled_ > 0;
      case Outline_2::Operation::INTERSECTION:
        return filled_ == rules_.size();
      case Outline_2::Operation::DIFFERENCE:
        return filled_ == 1 && is_filled_by(0);
      case Outline_2::Operation::SYMMETRIC_DIFFERENCE:
        return filled_ % 2 == 1;
    }
    return false;
  }

 private:
  [[nodiscard]] bool is_filled_by(std::size_t operand) const { return is_filled(rules_[operand], winding_[operand]); }
  void add(std::uint32_t operand, int number) {
    const bool was_filled = is_filled_by(operand);
    winding_[operand] += number;
    if (was_filled != is_filled_by(operand)) filled_ += was_filled ? std::size_t(-1) : 1;
  }

  const std::vector<Fill_rule>& rules_;  // by operand
  const United_curves& united_;
  const Cut_curves& cut_;
  std::vector<int> winding_;  // by operand
  std::size_t filled_ = 0;    // how many are
};

/// A loop of sides as a chain of parts.
[[nodiscard]] Outline_2::Chain chain_of(const Region_loop& loop, const Overlay& overlay, const United_curves& united) {
  Outline_2::Chain chain{{}, loop.is_ccw, loop.parent};
  const auto point = [&](std::uint32_t bezier, const Bracket& end, std::uint32_t cut) {
    return united.unit.out(cut != NO_NUMBER ? overlay.points()[overlay.cut().cuts()[cut].vertex]
                                            : overlay.curves().evaluator(bezier)(end.lower).point);
  };
  for (const Edge_side s : loop.sides) {
    std::vector<Bezier_span> spans = overlay.cut().spans_of(edge_of(s));
    if (is_reversed(s)) std::reverse(spans.begin(), spans.end());
    for (const Bezier_span& span : spans) {
      const Operand_bezier& at = united.beziers[span.bezier];
      Outline_2::Part part{at.operand,
                           at.curve,
                           at.bezier,
                           span.from,
                           span.to,
                           is_reversed(s),
                           point(span.bezier, span.from, span.first_cut),
                           point(span.bezier, span.to, span.last_cut)};
      if (part.is_reversed) {
        std::swap(part.from, part.to);
        std::swap(part.start, part.end);
      }
      chain.parts.push_back(part);
    }
  }
  return chain;
}

}  // namespace

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

Outline_2 boolean_operation(const std::vector<const Bounding_arc_tree_2*>& trees, Outline_2::Operation operation,
                            const Fill_rules& fill_rules) {
  if (trees.empty()) return {};
  std::vector<Fill_rule> rules;
  for (std::size_t i = 0; i < trees.size(); ++i) rules.push_back(fill_rules.of(i, trees.size()));
  for (const Bounding_arc_tree_2* tree : trees) internal::check_closed(tree->drawing());
  const internal::United_curves united = internal::united_curves(trees, internal::Lone_points::DROPPED);
  const internal::Overlay overlay(*united.segments);
  if (overlay.open()) return {{}, Outline_2::Status::UNDECIDED, internal::undecided_meeting(*overlay.open(), united)};
  std::vector<char> inside(overlay.number_of_faces(), 0);
  internal::Filled_faces filled(rules, united, overlay);
  overlay.for_each_face([&](internal::Edge_side s) { filled.cross(s); },
                        [&](std::uint32_t face) { inside[face] = filled.is_of(operation) ? 1 : 0; });
  const auto loops = internal::region_loops(overlay, inside, internal::Loops_at_vertices::SPLIT);
  if (united.forest) united.forest->drop_boxes();
  Outline_2 result;
  result.chains.reserve(loops.size());
  for (const internal::Region_loop& loop : loops) result.chains.push_back(internal::chain_of(loop, overlay, united));
  return result;
}

}  // namespace CGAL::Bounding_arcs

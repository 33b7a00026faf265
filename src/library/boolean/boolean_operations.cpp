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

[[nodiscard]] bool is_of(Boolean_operation operation, std::size_t filled, bool is_first_filled, std::size_t operands) {
  switch (operation) {
    case Boolean_operation::UNION:
      return filled > 0;
    case Boolean_operation::INTERSECTION:
      return filled == operands;
    case Boolean_operation::DIFFERENCE:
      return is_first_filled && filled == 1;
    case Boolean_operation::SYMMETRIC_DIFFERENCE:
      return filled % 2 == 1;
  }
  return false;
}

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
  [[nodiscard]] std::size_t number_filled() const { return filled_; }
  [[nodiscard]] bool is_filled_by(std::size_t operand) const { return is_filled(rules_[operand], winding_[operand]); }

 private:
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

/// Turns loops of sides into chains of parts.
class Chain_writer {
 public:
  Chain_writer(const Overlay& overlay, const United_curves& united)
      : overlay_(overlay), cut_(overlay.cut()), unit_(united.unit), beziers_(united.beziers) {}

  [[nodiscard]] Outline_2::Chain chain(const Region_loop& loop) const {
    Outline_2::Chain chain;
    chain.is_ccw = loop.is_ccw;
    chain.parent = loop.parent;
    for (const Edge_side s : loop.sides) add(s, chain.parts);
    return chain;
  }

 private:
  void add(Edge_side s, std::vector<Outline_2::Part>& parts) const {
    std::vector<Bezier_span> spans = cut_.spans_of(edge_of(s));
    if (is_reversed(s)) std::reverse(spans.begin(), spans.end());
    for (const Bezier_span& span : spans) {
      const Operand_bezier& at = beziers_[span.bezier];
      const Xy<double> from = point(span.bezier, span.from, span.first_cut),
                       to = point(span.bezier, span.to, span.last_cut);
      if (is_reversed(s)) parts.push_back({at.operand, at.curve, at.bezier, span.to, span.from, true, to, from});
      else parts.push_back({at.operand, at.curve, at.bezier, span.from, span.to, false, from, to});
    }
  }
  [[nodiscard]] Xy<double> point(std::uint32_t bezier, const Bracket& end, std::uint32_t cut) const {
    return unit_.out(cut != NO_NUMBER ? overlay_.points()[cut_.cuts()[cut].vertex]
                                      : overlay_.curves().evaluator(bezier)(end.lower).point);
  }

  const Overlay& overlay_;
  const Cut_curves& cut_;
  const Unit& unit_;
  const std::vector<Operand_bezier>& beziers_;
};

/// \param is_inside bool(const Filled_faces&)
template <class IsInside>
[[nodiscard]] Outline_2 outline_of(const std::vector<const Bounding_arc_tree_2*>& trees, const Fill_rules& fill_rules,
                                   const IsInside& is_inside) {
  std::vector<Fill_rule> rules;
  for (std::size_t i = 0; i < trees.size(); ++i) rules.push_back(fill_rules.of(i, trees.size()));
  for (const Bounding_arc_tree_2* tree : trees) check_closed(tree->drawing());
  const United_curves united = united_curves(trees, Lone_points::DROPPED);
  const Overlay overlay(*united.segments);
  Outline_2 result;
  if (overlay.open()) {
    result.status = Outline_2::Status::UNDECIDED;
    result.undecided = undecided_meeting(*overlay.open(), united);
    return result;
  }
  std::vector<char> inside(overlay.number_of_faces(), 0);
  Filled_faces filled(rules, united, overlay);
  overlay.for_each_face([&](Edge_side s) { filled.cross(s); },
                        [&](std::uint32_t face) { inside[face] = is_inside(filled) ? 1 : 0; });
  const std::vector<Region_loop> loops = region_loops(overlay, inside, Loops_at_vertices::SPLIT);
  if (united.forest) united.forest->drop_boxes();
  const Chain_writer writer(overlay, united);
  result.chains.reserve(loops.size());
  for (const Region_loop& loop : loops) result.chains.push_back(writer.chain(loop));
  return result;
}

}  // namespace

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

Outline_2 boolean_operation(const std::vector<const Bounding_arc_tree_2*>& trees, Boolean_operation operation,
                            const Fill_rules& rules) {
  if (trees.empty()) return {};
  return internal::outline_of(trees, rules, [&](const internal::Filled_faces& filled) {
    return internal::is_of(operation, filled.number_filled(), filled.is_filled_by(0), trees.size());
  });
}

}  // namespace CGAL::Bounding_arcs

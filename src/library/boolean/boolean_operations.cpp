// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of boolean/boolean_operations.h.
//
//   operands -> one drawing -> common points -> edges -> windings of both sides -> edges of the boundary -> loops

#include "plane_faces.h"

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/boolean/internal/Outline_loops.h>
#include <CGAL/Bounding_arcs_2/boolean/internal/United_curves.h>
#include <CGAL/Bounding_arcs_2/boolean/internal/curve_of_part.h>
#include <CGAL/Bounding_arcs_2/query/Intersection_search.h>
#include <CGAL/Bounding_arcs_2/query/closed_curves.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
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

/// Turns loops of edges into chains of parts.
class Chain_writer {
 public:
  Chain_writer(const Edge_pieces& pieces, const Unit& unit, const std::vector<Operand_bezier>& beziers)
      : pieces_(pieces), unit_(unit), beziers_(beziers) {}

  [[nodiscard]] Outline_chain chain(const Edge_loop& loop) const {
    Outline_chain chain;
    chain.is_ccw = loop.is_ccw;
    chain.parent = loop.parent;
    for (const Directed_edge& e : loop.edges) add(e, chain.parts);
    return chain;
  }

 private:
  void add(const Directed_edge& e, std::vector<Outline_part>& parts) const {
    std::vector<Bezier_span> spans = pieces_.cut().spans_of(e.edge);
    if (e.is_reversed) std::reverse(spans.begin(), spans.end());
    for (const Bezier_span& s : spans) {
      const Operand_bezier& at = beziers_[s.bezier];
      Outline_part part{at.operand, at.curve, at.bezier, s.from, s.to, point(s.bezier, s.from), point(s.bezier, s.to)};
      if (e.is_reversed) {
        std::swap(part.from, part.to);
        std::swap(part.start, part.end);
      }
      parts.push_back(part);
    }
    const Cut_edge& edge = pieces_.cut().edges()[e.edge];
    if (edge.first == Cut_edge::NONE) return;
    Xy<double> start = vertex(edge.first), end = vertex(edge.last);
    if (e.is_reversed) std::swap(start, end);
    parts[parts.size() - spans.size()].start = start;
    parts.back().end = end;
  }
  [[nodiscard]] Xy<double> vertex(std::uint32_t cut) const {
    return unit_.out(pieces_.point(pieces_.cut().cuts()[cut].vertex));
  }
  [[nodiscard]] Xy<double> point(std::uint32_t bezier, const Bracket& t) const {
    return unit_.out(pieces_.curves().evaluator(bezier)(t.middle()).point);
  }

  const Edge_pieces& pieces_;
  const Unit& unit_;
  const std::vector<Operand_bezier>& beziers_;
};

/// Curves of all operands together, and what they have in common.
class Overlay {
 public:
  Overlay(const std::vector<Outline_operand>& operands, Decisions decisions)
      : united_(united_curves(operands, Lone_points::DROPPED, decisions)), operands_(operands.size()),
        // With each part of an overlap by itself, curves that run together are all cut where one of them has a joint.
        common_(Intersection_search(united_.curves.in_unit()).all(false)) {}

  /// \param is_inside, are_split see Outline_loops
  template <class IsInside> [[nodiscard]] Outline_2 outline(const IsInside& is_inside, bool are_split) const {
    Outline_2 result;
    result.status = Outline_status::UNDECIDED;
    const auto is_open = [](const Intersection_2<>& p) { return p.kind == Intersection_kind::UNDECIDED; };
    const auto open = std::find_if(common_.points.begin(), common_.points.end(), is_open);
    if (open != common_.points.end()) {
      result.undecided = {united_.curves.unit().out(open->point), operand_of(open->a), operand_of(open->b)};
      return result;
    }
    try_nearest_cuts([&](double nearest) { return add_outline(nearest, is_inside, are_split, result); });
    return result;
  }

 private:
  [[nodiscard]] Undecided_meeting::Of operand_of(const Curve_range& r) const {
    const Operand_bezier& at = united_.beziers[united_.curves.in_unit().number_of_bezier(r.curve, r.bezier)];
    return {at.operand, at.curve, at.bezier};
  }
  template <class IsInside>
  [[nodiscard]] bool add_outline(double nearest, const IsInside& is_inside, bool are_split, Outline_2& result) const {
    const Cut_curves cut(united_.curves.in_unit(), common_, nearest);
    if (!cut.is_consistent()) return false;
    const Edge_pieces pieces(cut);
    Edge_rays rays(pieces);
    const Edge_windings windings(pieces, rays, united_.operands, operands_);
    if (!windings.is_decided()) return false;
    Outline_loops loops(pieces, rays, windings, is_inside, are_split, nearest > NEAREST_CUTS);
    if (!loops.is_decided()) return false;
    result.status =
        cut.is_resolved() && loops.is_resolved() ? Outline_status::COMPLETE : Outline_status::RESOLUTION_REACHED;
    const Chain_writer writer(pieces, united_.curves.unit(), united_.beziers);
    for (const Edge_loop& loop : loops.loops()) result.chains.push_back(writer.chain(loop));
    return true;
  }

  United_curves united_;
  std::size_t operands_;
  Intersections_2<> common_;
};

[[nodiscard]] Overlay overlay(const std::vector<Outline_operand>& operands, Decisions decisions) {
  for (const Outline_operand& o : operands) check_closed(*o.drawing);
  return Overlay(operands, decisions);
}

}  // namespace

Outline_2 outline(const std::vector<Outline_operand>& operands, Boolean_operation operation, Fill_rule rule,
                  Decisions decisions) {
  const auto is_inside = [&](const auto& winding) {
    std::size_t filled = 0;
    for (std::size_t k = 0; k < operands.size(); ++k) filled += is_filled(rule, winding(k)) ? 1 : 0;
    return is_of(operation, filled, is_filled(rule, winding(0)), operands.size());
  };
  return overlay(operands, decisions).outline(is_inside, true);
}

Outline_2 region_outline(const Outline_operand& operand, Fill_rule rule, Decisions decisions) {
  return overlay({operand}, decisions).outline([&](const auto& winding) { return is_filled(rule, winding(0)); }, false);
}

Drawing_2<double> outline_drawing(const Outline_2& outline, const std::vector<const Drawing_2<double>*>& operands) {
  Drawing_2<double> result;
  for (std::size_t i = 0; i < outline.chains.size(); ++i) {
    std::vector<Bezier_curve_2<double>> chain;
    for (const Outline_part& part : outline.chains[i].parts) {
      const auto& given = operands.at(part.operand)->curves()[part.curve].beziers[part.bezier];
      chain.push_back(curve_of_part(given, part.from, part.to, part.start, part.end));
    }
    result.add(std::move(chain), "outline " + std::to_string(i + 1));
  }
  return result;
}

}  // namespace CGAL::Bounding_arcs::internal

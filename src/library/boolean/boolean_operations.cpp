// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of boolean/boolean_operations.h.
//
//   operands -> one drawing -> common points -> edges -> windings of both sides -> edges of the boundary -> loops

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/boolean/internal/Outline_loops.h>
#include <CGAL/Bounding_arcs_2/query/Intersection_search.h>
#include <CGAL/Bounding_arcs_2/query/closed_curves.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

/// The place that a Bezier piece of all operands together has in its own.
struct Operand_bezier {
  std::uint32_t operand, curve, bezier;
};

/// All operands as one drawing, without pieces that are single points.
template <class NT> struct United_drawing {
  Drawing_2<NT> drawing;
  std::vector<Operand_bezier> beziers;  // numbered through
  std::vector<std::uint32_t> operands;  // by curve

  /// \param piece Bezier_curve_2<NT>(curve, bezier)
  template <class Piece> void add(std::uint32_t operand, const Drawing_2<double>& given, const Piece& piece) {
    for (std::uint32_t c = 0; c < given.curves().size(); ++c) {
      const auto& curve = given.curves()[c];
      std::vector<Bezier_curve_2<NT>> chain;
      for (std::uint32_t b = 0; b < curve.beziers.size(); ++b) {
        Bezier_curve_2<NT> p = piece(c, b);
        const auto& points = p.control_points();
        if (std::all_of(points.begin(), points.end(), [&](const Xy<NT>& q) { return q == points.front(); })) continue;
        beziers.push_back({operand, c, b});
        chain.push_back(std::move(p));
      }
      if (chain.empty()) continue;
      drawing.add(std::move(chain), curve.name);
      operands.push_back(operand);
    }
  }
};

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

[[nodiscard]] Outline_2 outline(const Drawing_hierarchy& united, const std::vector<Operand_bezier>& beziers,
                                const std::vector<std::uint32_t>& operand_of_curve, std::size_t operands,
                                Boolean_operation operation, Fill_rule rule) {
  Outline_2 result;
  const Segment_hierarchy& curves = united.in_unit();
  // With each part of an overlap by itself, curves that run together are all cut where one of them has a joint.
  const Intersections_2<> common = Intersection_search(curves).all(false);
  result.status = Outline_status::UNDECIDED;
  const auto is_open = [](const Intersection_2<>& p) { return p.kind == Intersection_kind::UNDECIDED; };
  if (std::any_of(common.points.begin(), common.points.end(), is_open)) return result;
  const Cut_curves cut(curves, common);
  if (!cut.is_consistent()) return result;
  const Edge_pieces pieces(cut);
  Edge_rays rays(pieces);
  const Edge_windings windings(pieces, rays, operand_of_curve, operands);
  if (!windings.is_decided()) return result;
  const auto is_inside = [&](const auto& winding) {
    std::size_t filled = 0;
    for (std::size_t k = 0; k < operands; ++k) filled += is_filled(rule, winding(k)) ? 1 : 0;
    return is_of(operation, filled, is_filled(rule, winding(0)), operands);
  };
  Outline_loops loops(pieces, rays, windings, is_inside);
  if (!loops.is_decided()) return result;
  result.status = cut.is_resolved() ? Outline_status::COMPLETE : Outline_status::RESOLUTION_REACHED;
  const Chain_writer writer(pieces, united.unit(), beziers);
  for (const Edge_loop& loop : loops.loops()) result.chains.push_back(writer.chain(loop));
  return result;
}

}  // namespace

Outline_2 outline(const std::vector<Outline_operand>& operands, Boolean_operation operation, Fill_rule rule,
                  Decisions decisions) {
  bool is_rounded = false;
  for (const Outline_operand& o : operands) {
    check_closed(*o.drawing);
    is_rounded = is_rounded || o.exact != nullptr;
  }
  if (!is_rounded) {
    United_drawing<double> united;
    for (std::uint32_t i = 0; i < operands.size(); ++i) {
      const Drawing_2<double>& drawing = *operands[i].drawing;
      united.add(i, drawing, [&](std::uint32_t c, std::uint32_t b) { return drawing.curves()[c].beziers[b]; });
    }
    return outline(Drawing_hierarchy(std::move(united.drawing), decisions), united.beziers, united.operands,
                   operands.size(), operation, rule);
  }
  United_drawing<Exact_rational> united;
  for (std::uint32_t i = 0; i < operands.size(); ++i) {
    const Outline_operand& o = operands[i];
    united.add(i, *o.drawing, [&](std::uint32_t c, std::uint32_t b) {
      if (o.exact == nullptr) return exact_bezier(o.drawing->curves()[c].beziers[b]);
      const Segment_hierarchy& curves = o.exact->in_unit();
      const auto in_unit = curves.exact_bezier(curves.number_of_bezier(c, b));
      std::vector<Xy<Exact_rational>> points;
      for (const auto& p : in_unit.control_points())
        points.push_back({o.exact->unit().exactly_out(p.x), o.exact->unit().exactly_out(p.y)});
      return Bezier_curve_2<Exact_rational>(std::move(points), in_unit.weights());
    });
  }
  return outline(Drawing_hierarchy(united.drawing, decisions), united.beziers, united.operands, operands.size(),
                 operation, rule);
}

Drawing_2<double> outline_drawing(const Outline_2& outline, const std::vector<const Drawing_2<double>*>& operands) {
  Drawing_2<double> result;
  for (std::size_t i = 0; i < outline.chains.size(); ++i) {
    std::vector<Bezier_curve_2<double>> chain;
    for (const Outline_part& part : outline.chains[i].parts) {
      const auto& given = operands.at(part.operand)->curves()[part.curve].beziers[part.bezier];
      const double low = (part.is_reversed() ? part.to : part.from).middle(),
                   high = (part.is_reversed() ? part.from : part.to).middle();
      Bezier_curve_2<double> piece = low == 0 && high == 1 ? given : given.subcurve(low, high);
      if (part.is_reversed()) piece = piece.reversed();
      auto points = piece.control_points();
      points.front() = part.start;
      points.back() = part.end;
      chain.emplace_back(std::move(points), piece.weights());
    }
    result.add(std::move(chain), "outline " + std::to_string(i + 1));
  }
  return result;
}

}  // namespace CGAL::Bounding_arcs::internal

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of boolean/boolean_operations.h.
//
//   operands -> one drawing -> common points -> edges -> windings of both sides -> edges of the boundary -> loops

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/boolean/internal/Outline_loops.h>
#include <CGAL/Bounding_arcs_2/boolean/internal/curve_of_part.h>
#include <CGAL/Bounding_arcs_2/query/Intersection_search.h>
#include <CGAL/Bounding_arcs_2/query/closed_curves.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
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

/// Curves of all operands together, cut where they meet, with the winding numbers on both sides of the edges.
class Overlay {
 public:
  Overlay(Drawing_hierarchy united, std::vector<Operand_bezier> beziers,
          const std::vector<std::uint32_t>& operand_of_curve, std::size_t operands)
      : united_(std::move(united)), beziers_(std::move(beziers)) {
    const Segment_hierarchy& curves = united_.in_unit();
    // With each part of an overlap by itself, curves that run together are all cut where one of them has a joint.
    const Intersections_2<> common = Intersection_search(curves).all(false);
    const auto is_open = [](const Intersection_2<>& p) { return p.kind == Intersection_kind::UNDECIDED; };
    if (std::any_of(common.points.begin(), common.points.end(), is_open)) return;
    cut_.emplace(curves, common);
    if (!cut_->is_consistent()) return;
    pieces_.emplace(*cut_);
    rays_.emplace(*pieces_);
    windings_.emplace(*pieces_, *rays_, operand_of_curve, operands);
    is_decided_ = windings_->is_decided();
  }
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  /// \param is_inside, are_split see Outline_loops
  template <class IsInside> [[nodiscard]] Outline_2 outline(const IsInside& is_inside, bool are_split) {
    Outline_2 result;
    result.status = Outline_status::UNDECIDED;
    if (!is_decided_) return result;
    Outline_loops loops(*pieces_, *rays_, *windings_, is_inside, are_split);
    if (!loops.is_decided()) return result;
    result.status = cut_->is_resolved() ? Outline_status::COMPLETE : Outline_status::RESOLUTION_REACHED;
    const Chain_writer writer(*pieces_, united_.unit(), beziers_);
    for (const Edge_loop& loop : loops.loops()) result.chains.push_back(writer.chain(loop));
    return result;
  }
  /// Calls visit(winding), see Outline_loops, for both sides of each edge.
  template <class Visit> void for_each_side(const Visit& visit) const {
    for (std::uint32_t e = 0; is_decided_ && e < cut_->edges().size(); ++e) {
      if (cut_->edges()[e].representative != e) continue;
      visit([&](std::size_t k) { return windings_->left(e, k); });
      visit([&](std::size_t k) { return windings_->right(e, k); });
    }
  }

 private:
  Drawing_hierarchy united_;
  std::vector<Operand_bezier> beziers_;
  std::optional<Cut_curves> cut_;
  std::optional<Edge_pieces> pieces_;
  std::optional<Edge_rays> rays_;
  std::optional<Edge_windings> windings_;
  bool is_decided_ = false;
};

[[nodiscard]] Bezier_curve_2<Exact_rational> exact_piece(const Outline_operand& o, std::uint32_t c, std::uint32_t b) {
  if (o.exact == nullptr) return exact_bezier(o.drawing->curves()[c].beziers[b]);
  const Segment_hierarchy& curves = o.exact->in_unit();
  const auto in_unit = curves.exact_bezier(curves.number_of_bezier(c, b));
  std::vector<Xy<Exact_rational>> points;
  for (const auto& p : in_unit.control_points())
    points.push_back({o.exact->unit().exactly_out(p.x), o.exact->unit().exactly_out(p.y)});
  return Bezier_curve_2<Exact_rational>(std::move(points), in_unit.weights());
}

/// \param with_frame the last curve is an operand by itself
template <class NT, class Piece>
[[nodiscard]] std::unique_ptr<Overlay> overlay(const std::vector<Outline_operand>& operands, bool with_frame,
                                               Decisions decisions, const Piece& piece) {
  United_drawing<NT> united;
  for (std::uint32_t i = 0; i < operands.size(); ++i)
    united.add(i, *operands[i].drawing, [&](std::uint32_t c, std::uint32_t b) { return piece(operands[i], c, b); });
  if (with_frame && !united.operands.empty()) ++united.operands.back();
  return std::make_unique<Overlay>(Drawing_hierarchy(std::move(united.drawing), decisions), std::move(united.beziers),
                                   united.operands, operands.size() + (with_frame ? 1 : 0));
}
[[nodiscard]] std::unique_ptr<Overlay> overlay(const std::vector<Outline_operand>& operands, bool with_frame,
                                               Decisions decisions) {
  bool is_rounded = false;
  for (const Outline_operand& o : operands) {
    check_closed(*o.drawing);
    is_rounded = is_rounded || o.exact != nullptr;
  }
  if (is_rounded) return overlay<Exact_rational>(operands, with_frame, decisions, exact_piece);
  return overlay<double>(
      operands, with_frame, decisions,
      [](const Outline_operand& o, std::uint32_t c, std::uint32_t b) { return o.drawing->curves()[c].beziers[b]; });
}

}  // namespace

Outline_2 outline(const std::vector<Outline_operand>& operands, Boolean_operation operation, Fill_rule rule,
                  Decisions decisions) {
  const auto is_inside = [&](const auto& winding) {
    std::size_t filled = 0;
    for (std::size_t k = 0; k < operands.size(); ++k) filled += is_filled(rule, winding(k)) ? 1 : 0;
    return is_of(operation, filled, is_filled(rule, winding(0)), operands.size());
  };
  return overlay(operands, false, decisions)->outline(is_inside, true);
}

Outline_2 region_outline(const Outline_operand& operand, Fill_rule rule, Decisions decisions) {
  return overlay({operand}, false, decisions)
      ->outline([&](const auto& winding) { return is_filled(rule, winding(0)); }, false);
}

std::vector<Outline_2> framed_outlines(const Outline_operand& operand, Decisions decisions) {
  constexpr std::size_t CURVES = 0, FRAME = 1;
  const auto all = overlay({operand}, true, decisions);
  std::set<int> numbers;
  all->for_each_side([&](const auto& winding) {
    if (winding(FRAME) != 0) numbers.insert(winding(CURVES));
  });
  std::vector<Outline_2> result;
  for (const int number : numbers)
    result.push_back(
        all->outline([&](const auto& winding) { return winding(FRAME) != 0 && winding(CURVES) == number; }, false));
  if (result.empty()) result.push_back(all->outline([](const auto&) { return false; }, false));
  return result;
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

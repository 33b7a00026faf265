// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of boolean/boolean_operations.h.
//
//   operands -> one drawing -> overlay -> faces that are inside -> loops of edges round them -> chains of parts

#include "../overlay/Overlay.h"
#include "../overlay/United_curves.h"
#include "plane_faces.h"

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/query/closed_curves.h>

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
  Filled_faces(const std::vector<Outline_operand>& operands, const United_curves& united, const Overlay& overlay)
      : operands_(operands), united_(united), cut_(overlay.cut()), winding_(operands.size(), 0) {}

  /// Goes over an edge from the left of a side.
  void cross(Edge_side s) {
    for (std::uint32_t e = edge_of(s); e != NO_NUMBER; e = cut_.next_member(e)) {
      const Cut_edge& edge = cut_.edges()[e];
      // the left of an edge has one more than its right
      add(united_.operands[edge.curve], edge.is_against == is_reversed(s) ? -1 : 1);
    }
  }
  [[nodiscard]] std::size_t number_filled() const { return filled_; }
  [[nodiscard]] bool is_filled_by(std::size_t operand) const {
    return is_filled(operands_[operand].rule, winding_[operand]);
  }

 private:
  void add(std::uint32_t operand, int number) {
    const bool was_filled = is_filled_by(operand);
    winding_[operand] += number;
    if (was_filled != is_filled_by(operand)) filled_ += was_filled ? std::size_t(-1) : 1;
  }

  const std::vector<Outline_operand>& operands_;
  const United_curves& united_;
  const Cut_curves& cut_;
  std::vector<int> winding_;  // by operand
  std::size_t filled_ = 0;    // how many are
};

/// A closed way along sides of edges, each of which has the region to its left.
struct Region_loop {
  std::vector<Edge_side> sides;
  bool is_ccw = true;
  std::optional<std::size_t> parent;  ///< the innermost loop around it
};

/// What loops do where they come to a vertex again.
enum class Loops_at_vertices { SPLIT, GO_ON };

/// The boundary of a region that is made of faces: loops of edges, with the region to their left.
class Loop_tracer {
 public:
  Loop_tracer(const Overlay& overlay, const std::vector<char>& is_inside, Loops_at_vertices at_vertices)
      : overlay_(overlay), edges_(overlay.cut().edges()), is_inside_(is_inside),
        are_split_(at_vertices == Loops_at_vertices::SPLIT), loop_of_(2 * edges_.size(), NO_NUMBER) {
    trace();
    nest();
  }
  [[nodiscard]] std::vector<Region_loop>& loops() { return loops_; }

 private:
  [[nodiscard]] bool is_inside(Edge_side s) const { return is_inside_[overlay_.face_of(s)] != 0; }
  /// Whether the region is on this side of the edge alone.
  [[nodiscard]] bool is_on_boundary(Edge_side s) const { return is_inside(s) && !is_inside(other_side(s)); }
  [[nodiscard]] bool has_ends(Edge_side s) const { return edges_[edge_of(s)].first != NO_NUMBER; }
  [[nodiscard]] std::uint32_t start_of(Edge_side s) const { return overlay_.vertex_at(edge_of(s), !is_reversed(s)); }

  // The first side of the boundary clockwise from the end of another one.
  [[nodiscard]] Edge_side next(Edge_side s) const {
    Edge_side on = overlay_.next(s);
    while (!is_on_boundary(on)) on = overlay_.next(other_side(on));
    return on;
  }

  void trace() {
    std::vector<char> is_done(loop_of_.size(), 0);
    std::vector<std::uint32_t> place(overlay_.cut().number_of_vertices(),
                                     NO_NUMBER);  // of the open side that starts there
    std::vector<Edge_side> open;
    for (Edge_side first = 0; first < loop_of_.size(); ++first) {
      if (!overlay_.cut().is_representative(edge_of(first)) || is_done[first] != 0 || !is_on_boundary(first)) continue;
      Edge_side s = first;
      do {
        is_done[s] = 1;
        if (has_ends(s) && are_split_) {
          std::uint32_t& at = place[start_of(s)];
          if (at != NO_NUMBER) close(open, at, place);
          at = static_cast<std::uint32_t>(open.size());
        }
        open.push_back(s);
        s = next(s);
      } while (s != first);
      close(open, 0, place);
    }
  }
  // Takes a loop off the open sides, from one of these on.
  void close(std::vector<Edge_side>& open, std::uint32_t from, std::vector<std::uint32_t>& place) {
    Region_loop loop;
    loop.sides.assign(open.begin() + from, open.end());
    open.resize(from);
    for (const Edge_side s : loop.sides) {
      loop_of_[s] = loop_of_[other_side(s)] = static_cast<std::uint32_t>(loops_.size());
      if (has_ends(s)) place[start_of(s)] = NO_NUMBER;
    }
    loops_.push_back(std::move(loop));
  }

  // From face to face: the loops around one are a stack, as no two cross.
  void nest() {
    std::vector<std::uint32_t> around;
    std::vector<char> is_known(loops_.size(), 0);
    const auto cross = [&](Edge_side s) {
      const std::uint32_t loop = loop_of_[s];
      if (loop == NO_NUMBER) return;
      if (!around.empty() && around.back() == loop) {
        around.pop_back();
        return;
      }
      if (is_known[loop] == 0) {
        is_known[loop] = 1;
        loops_[loop].is_ccw = is_inside(other_side(s));
        if (!around.empty()) loops_[loop].parent = around.back();
      }
      around.push_back(loop);
    };
    overlay_.for_each_face(cross, [](std::uint32_t) {});
  }

  const Overlay& overlay_;
  const std::vector<Cut_edge>& edges_;
  const std::vector<char>& is_inside_;
  bool are_split_;
  std::vector<std::uint32_t> loop_of_;  // by side
  std::vector<Region_loop> loops_;
};

/// Turns loops of sides into chains of parts.
class Chain_writer {
 public:
  Chain_writer(const Overlay& overlay, const United_curves& united)
      : overlay_(overlay), cut_(overlay.cut()), unit_(united.curves.unit()), beziers_(united.beziers) {}

  [[nodiscard]] Outline_chain chain(const Region_loop& loop) const {
    Outline_chain chain;
    chain.is_ccw = loop.is_ccw;
    chain.parent = loop.parent;
    for (const Edge_side s : loop.sides) add(s, chain.parts);
    return chain;
  }

 private:
  void add(Edge_side s, std::vector<Outline_part>& parts) const {
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
[[nodiscard]] Outline_2 outline_of(const std::vector<Outline_operand>& operands, Decisions decisions,
                                   Loops_at_vertices at_vertices, const IsInside& is_inside) {
  for (const Outline_operand& o : operands) check_closed(*o.drawing);
  United_curves united = united_curves(operands, Lone_points::DROPPED, decisions);
  const Overlay overlay(united.curves.in_unit());
  Outline_2 result;
  if (overlay.open()) {
    result.status = Outline_status::UNDECIDED;
    result.undecided = undecided_meeting(*overlay.open(), united);
    return result;
  }
  std::vector<char> inside(overlay.number_of_faces(), 0);
  Filled_faces filled(operands, united, overlay);
  overlay.for_each_face([&](Edge_side s) { filled.cross(s); },
                        [&](std::uint32_t face) { inside[face] = is_inside(filled) ? 1 : 0; });
  const std::vector<Region_loop> loops = std::move(Loop_tracer(overlay, inside, at_vertices).loops());
  united.curves.drop_segments();
  const Chain_writer writer(overlay, united);
  result.chains.reserve(loops.size());
  for (const Region_loop& loop : loops) result.chains.push_back(writer.chain(loop));
  return result;
}

}  // namespace

Outline_2 outline(const std::vector<Outline_operand>& operands, Boolean_operation operation, Decisions decisions) {
  if (operands.empty()) return {};
  return outline_of(operands, decisions, Loops_at_vertices::SPLIT, [&](const Filled_faces& filled) {
    return is_of(operation, filled.number_filled(), filled.is_filled_by(0), operands.size());
  });
}

Outline_2 region_outline(const Outline_operand& operand, Decisions decisions) {
  return outline_of({operand}, decisions, Loops_at_vertices::GO_ON,
                    [](const Filled_faces& filled) { return filled.is_filled_by(0); });
}

}  // namespace CGAL::Bounding_arcs::internal

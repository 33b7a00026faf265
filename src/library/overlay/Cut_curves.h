// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves, cut where they meet: vertices, and edges between them.
//
//       cut 0        cut 1
//   ------+------------+------        edge 0 of a curve runs from its cut 0 to its cut 1, the last one of a closed
//      vertex 5      vertex 2         curve through its start back to cut 0
//
// A closed curve that meets none is one edge without a vertex. An open curve has cuts at its ends.
// Places on a curve that are equal are one cut; cuts that a common point makes one are at one vertex.
// Edges that run through the same points are one class, with one of them, the least, as its representative.

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_CUT_CURVES_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_CUT_CURVES_H

#include "Meeting_places.h"

#include "../query/join_intersections.h"
#include "../tree/Segment_hierarchy.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

inline constexpr std::uint32_t NO_NUMBER = (std::numeric_limits<std::uint32_t>::max)();

/// Sets of numbers below a count (Tarjan 1975), with the least one as that by which a set is known. A number takes four
/// bytes, where Boost's sets take sixteen: each piece of a large drawing has one.
class Joined_sets {
 public:
  explicit Joined_sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  [[nodiscard]] std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    parent_[(std::max)(i, j)] = (std::min)(i, j);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// The side to the left of an edge, as it runs or against that: 2 times the edge's number, plus 1 against it.
using Edge_side = std::uint32_t;
[[nodiscard]] inline Edge_side side_of(std::uint32_t edge, bool is_reversed) {
  return 2 * edge + (is_reversed ? 1 : 0);
}
[[nodiscard]] inline Edge_side other_side(Edge_side s) { return s ^ 1U; }
[[nodiscard]] inline std::uint32_t edge_of(Edge_side s) { return s / 2; }
[[nodiscard]] inline bool is_reversed(Edge_side s) { return s % 2 == 1; }

/// Where a curve is cut.
struct Curve_cut {
  Joint_place at;
  std::uint32_t vertex;
  Place_number place;  ///< one of its places; NO_NUMBER where the parameter is 0 or 1
};

/// A part of a Bezier piece between two cuts, or a cut and an end of the piece.
struct Bezier_span {
  std::uint32_t bezier;
  Bracket from, to;
  std::uint32_t first_cut, last_cut;  ///< NO_NUMBER at an end of the piece without a cut
};

/// A part of a curve without a vertex inside.
struct Cut_edge {
  std::uint32_t curve;
  std::uint32_t first, last;     ///< cuts at its ends; NO_NUMBER of a curve without cuts
  std::uint32_t representative;  ///< the edge that stands for its class
  bool is_against = false;       ///< runs against that one
};

class Cut_curves {
 public:
  /// \param at_joints whether curves are cut where Bezier pieces meet, too
  Cut_curves(const Segment_hierarchy& curves, bool at_joints);

  [[nodiscard]] const Segment_hierarchy& curves() const { return curves_; }
  [[nodiscard]] Meeting_places& places() const { return places_; }
  [[nodiscard]] const std::vector<Curve_cut>& cuts() const { return cuts_; }
  [[nodiscard]] std::uint32_t number_of_vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<Cut_edge>& edges() const { return edges_; }
  [[nodiscard]] bool is_representative(std::uint32_t edge) const { return edges_[edge].representative == edge; }
  /// The edges that begin and end at a cut; NO_NUMBER at an end of an open curve.
  [[nodiscard]] std::uint32_t edge_after(std::uint32_t cut) const { return after_[cut]; }
  [[nodiscard]] std::uint32_t edge_before(std::uint32_t cut) const { return before_[cut]; }
  /// Cuts on a Bezier piece, in its order.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> cuts_of_bezier(std::uint32_t bezier) const {
    return {first_on_[bezier], first_on_[bezier + 1]};
  }
  /// The edge of a curve that runs before a cut, given as one after its first cut; and behind its last one.
  [[nodiscard]] std::uint32_t edge_at(std::size_t curve, std::uint32_t cut_behind) const;
  /// The parts of Bezier pieces that an edge runs through, in its direction.
  [[nodiscard]] std::vector<Bezier_span> spans_of(std::uint32_t edge) const;
  /// Whether all of a Bezier piece is one point.
  [[nodiscard]] bool is_point(std::uint32_t bezier) const { return curves_.is_point(bezier); }
  /// The exact parameter of a cut. \pre decisions are exact
  [[nodiscard]] const Exact_parameter& parameter(std::uint32_t cut) const { return parameter(cuts_[cut].at.t, cut); }
  /// The exact parameters between which a span is. \pre decisions are exact
  [[nodiscard]] const Exact_parameter& start_of(const Bezier_span& s) const { return parameter(s.from, s.first_cut); }
  [[nodiscard]] const Exact_parameter& end_of(const Bezier_span& s) const { return parameter(s.to, s.last_cut); }
  /// Cuts by vertex: those of vertex v are from first_at(v) up to first_at(v + 1).
  [[nodiscard]] const std::vector<std::uint32_t>& cuts_by_vertex() const { return by_vertex_; }
  [[nodiscard]] std::uint32_t first_at(std::uint32_t vertex) const { return first_at_[vertex]; }
  /// The curves of a class, as edges: the next one of the same class; NO_NUMBER behind the last one.
  [[nodiscard]] std::uint32_t next_member(std::uint32_t edge) const { return next_member_[edge]; }

  /// A place that doubles leave open, or its order. Then there is nothing else.
  [[nodiscard]] const std::optional<Place_number>& undecided() const { return undecided_; }

 private:
  void add_cuts(bool at_joints);
  [[nodiscard]] bool add_cuts_inside(std::uint32_t bezier, const std::vector<Place_number>& places,
                                     std::vector<std::uint32_t>& nodes);
  [[nodiscard]] std::uint32_t node_of(Place_number p) const;
  [[nodiscard]] const Exact_parameter& parameter(const Bracket& at, std::uint32_t cut) const;
  [[nodiscard]] std::uint32_t cut_of(Place_number p) const { return cut_of_node_[node_of(p)]; }
  void number_vertices(const std::vector<std::uint32_t>& nodes);
  void add_edges();
  void join_edges();
  [[nodiscard]] std::vector<std::uint32_t> edges_between(std::uint32_t from, std::uint32_t to) const;

  const Segment_hierarchy& curves_;
  mutable Meeting_places places_;  // its exact numbers are made when they are asked for
  // While cuts and edges are made. Nodes are the joints by Bezier piece, the ends of open curves, the places of
  // meetings.
  std::uint32_t first_place_;
  std::vector<std::uint32_t> node_behind_;  // a Bezier piece
  Joined_sets nodes_;
  std::vector<std::uint32_t> cut_of_node_;  // NO_NUMBER of those that are no cuts

  std::vector<Curve_cut> cuts_;  // in the order of the curves
  std::vector<Cut_edge> edges_;
  std::vector<std::uint32_t> first_on_;                // cuts by Bezier piece
  std::vector<std::uint32_t> first_cut_, first_edge_;  // by curve
  std::vector<std::uint32_t> after_, before_;          // edges by cut
  std::vector<std::uint32_t> by_vertex_, first_at_;    // cuts by vertex
  std::vector<std::uint32_t> next_member_;             // by edge
  std::uint32_t vertices_ = 0;
  std::optional<Place_number> undecided_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

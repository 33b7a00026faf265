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
// Edges that run through the same points are one class, with one of them, the least, as its representative.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_CUT_CURVES_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_CUT_CURVES_H

#include <CGAL/Bounding_arcs_2/boolean/internal/Cut_places.h>
#include <CGAL/Bounding_arcs_2/query/Curve_joints.h>
#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>
#include <CGAL/Bounding_arcs_2/tree/Segment_hierarchy.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A part of a Bezier piece.
struct Bezier_span {
  std::uint32_t bezier;
  Bracket from, to;
};

/// A part of a curve without a vertex inside.
struct Cut_edge {
  std::uint32_t curve;
  std::uint32_t first, last;     ///< cuts at its ends; NONE of a curve without cuts
  std::uint32_t representative;  ///< the edge that stands for its class
  bool is_against = false;       ///< runs against that one

  static constexpr std::uint32_t NONE = (std::numeric_limits<std::uint32_t>::max)();
};

/// An edge as a loop or a ring goes along it.
struct Directed_edge {
  std::uint32_t edge = 0;
  bool is_reversed = false;
};

/// A crossing of two edges' ends, where nothing else meets.
struct Plain_crossing {
  std::uint32_t cut_a = Cut_edge::NONE, cut_b = Cut_edge::NONE;
  bool is_plain = false;
};

class Cut_curves {
 public:
  /// \param nearest see Cut_places
  /// \pre nothing in common is undecided
  Cut_curves(const Segment_hierarchy& curves, const Intersections_2<>& common, double nearest = NEAREST_CUTS)
      : curves_(curves) {
    Cut_places places(curves, common, nearest);
    is_resolved_ = places.is_resolved();
    cut_of_place_ = std::move(places.cut_of_place());
    cuts_ = std::move(places.cuts());
    first_on_.assign(curves.number_of_beziers() + 1, 0);
    for (const Curve_cut& c : cuts_) ++first_on_[c.place.bezier + 1];
    for (std::size_t b = 0; b < curves.number_of_beziers(); ++b) first_on_[b + 1] += first_on_[b];
    sort_by_vertex(places.number_of_vertices());
    add_edges();
    join_edges(common);
    find_plain_crossings(common);
  }

  [[nodiscard]] const Segment_hierarchy& curves() const { return curves_; }
  [[nodiscard]] const std::vector<Curve_cut>& cuts() const { return cuts_; }
  [[nodiscard]] std::size_t number_of_vertices() const { return crossings_.size(); }
  [[nodiscard]] const std::vector<Cut_edge>& edges() const { return edges_; }
  /// The edges that begin and end at a cut; NONE at an end of an open curve.
  [[nodiscard]] std::uint32_t edge_after(std::uint32_t cut) const { return after_[cut]; }
  [[nodiscard]] std::uint32_t edge_before(std::uint32_t cut) const { return before_[cut]; }
  /// Cuts on a Bezier piece, in its order.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> cuts_of_bezier(std::uint32_t bezier) const {
    return {first_on_[bezier], first_on_[bezier + 1]};
  }
  /// The edge of a curve behind a number of all cuts; the cut before the first one of a closed curve is its last one.
  [[nodiscard]] std::uint32_t edge_at(std::size_t curve, std::uint32_t cut_behind) const {
    const std::uint32_t first = first_cut_[curve], last = first_cut_[curve + 1];
    if (first == last) return first_edge_[curve];
    if (!curves_.drawing().curves()[curve].is_closed)  // its ends may be some ulp within
      return first_edge_[curve] + std::clamp(cut_behind, first + 1, last - 1) - 1 - first;
    return first_edge_[curve] + (cut_behind == first ? last - 1 : cut_behind - 1) - first;
  }
  /// The parts of Bezier pieces that an edge runs through, in its direction.
  [[nodiscard]] std::vector<Bezier_span> spans_of(std::uint32_t edge) const {
    const Cut_edge& e = edges_[edge];
    const std::uint32_t first = curves_.number_of_bezier(e.curve, 0),
                        end = curves_.number_of_bezier(e.curve, curves_.drawing().curves()[e.curve].beziers.size());
    std::vector<Bezier_span> spans;
    const auto add = [&spans](std::uint32_t bezier, const Bracket& from, const Bracket& to) {
      if (from.upper < to.lower) spans.push_back({bezier, from, to});
    };
    constexpr Bracket START{0, 0}, END{1, 1};
    if (e.first == Cut_edge::NONE) {
      for (std::uint32_t b = first; b < end; ++b) add(b, START, END);
      return spans;
    }
    const Joint_place &from = cuts_[e.first].place, &to = cuts_[e.last].place;
    const bool is_through_start = e.last <= e.first;
    if (!is_through_start && from.bezier == to.bezier) {
      add(from.bezier, from.t, to.t);
      return spans;
    }
    add(from.bezier, from.t, END);
    for (std::uint32_t b = from.bezier + 1; b < (is_through_start ? end : to.bezier); ++b) add(b, START, END);
    if (is_through_start)
      for (std::uint32_t b = first; b < to.bezier; ++b) add(b, START, END);
    add(to.bezier, START, to.t);
    return spans;
  }
  /// Whether an edge leads back to where it starts within some ulp of there.
  [[nodiscard]] bool is_short_loop(std::uint32_t edge) const {
    const Cut_edge& e = edges_[edge];
    if (e.first == Cut_edge::NONE || cuts_[e.first].vertex != cuts_[e.last].vertex) return false;
    double extent = 0;
    for (const Bezier_span& s : spans_of(edge)) {
      const Bezier_evaluator& curve = curves_.evaluator(s.bezier);
      const double most = most_extent(curve, s.from.lower, s.to.upper);
      if (most > 0) extent += most / curve.coordinate_size();  // of a point in the origin that is 0
      if (!(extent <= SHORT_LOOP)) return false;
    }
    return true;
  }
  [[nodiscard]] const Plain_crossing& crossing(std::uint32_t vertex) const { return crossings_[vertex]; }
  /// Cuts by vertex: those of vertex v are from first_at(v) up to first_at(v + 1).
  [[nodiscard]] const std::vector<std::uint32_t>& cuts_by_vertex() const { return by_vertex_; }
  [[nodiscard]] std::uint32_t first_at(std::uint32_t vertex) const { return first_at_[vertex]; }
  /// Whether overlaps have the same edges on both sides.
  [[nodiscard]] bool is_consistent() const { return is_consistent_; }
  /// Whether places of one cut are the same point, not different ones that doubles hardly tell apart.
  [[nodiscard]] bool is_resolved() const { return is_resolved_; }

 private:
  void sort_by_vertex(std::uint32_t vertices) {
    crossings_.resize(vertices);
    by_vertex_.resize(cuts_.size());
    first_at_.assign(vertices + 1, 0);
    for (const Curve_cut& c : cuts_) ++first_at_[c.vertex + 1];
    for (std::size_t v = 0; v < vertices; ++v) first_at_[v + 1] += first_at_[v];
    std::vector<std::uint32_t> next(first_at_.begin(), first_at_.end() - 1);
    for (std::uint32_t c = 0; c < cuts_.size(); ++c) by_vertex_[next[cuts_[c].vertex]++] = c;
  }

  void add_edges() {
    const std::size_t curves = curves_.drawing().curves().size();
    after_.assign(cuts_.size(), Cut_edge::NONE);
    before_.assign(cuts_.size(), Cut_edge::NONE);
    std::uint32_t cut = 0;
    for (std::uint32_t curve = 0; curve < curves; ++curve) {
      const std::uint32_t first = cut;
      const std::uint32_t end = curves_.number_of_bezier(curve, curves_.drawing().curves()[curve].beziers.size());
      while (cut < cuts_.size() && cuts_[cut].place.bezier < end) ++cut;
      first_cut_.push_back(first);
      first_edge_.push_back(static_cast<std::uint32_t>(edges_.size()));
      const bool is_closed = curves_.drawing().curves()[curve].is_closed;
      for (std::uint32_t c = first; c < cut && (is_closed || c + 1 < cut); ++c) {
        const auto number = static_cast<std::uint32_t>(edges_.size());
        const std::uint32_t last = c + 1 < cut ? c + 1 : first;
        after_[c] = number;
        before_[last] = number;
        edges_.push_back({curve, c, last, number});
      }
      if (first == cut) {
        const auto number = static_cast<std::uint32_t>(edges_.size());
        edges_.push_back({curve, Cut_edge::NONE, Cut_edge::NONE, number});
      }
    }
    first_cut_.push_back(cut);
  }

  // The edges of an overlap, between two cuts of a curve. Where these are one, it has all edges or none: it is as long
  // as its only piece, or shorter than what joined its ends.
  [[nodiscard]] std::vector<std::uint32_t> edges_between(std::uint32_t from, std::uint32_t to, double width) const {
    std::vector<std::uint32_t> result;
    constexpr double HALF = 0.5;
    if (from == to && width < HALF) return result;
    std::uint32_t c = from;
    do {
      if (after_[c] == Cut_edge::NONE) break;  // the end of an open curve
      result.push_back(after_[c]);
      c = edges_[after_[c]].last;
    } while (c != to);
    return result;
  }
  // A curve that is a point has an edge, and a curve through it has none there.
  void drop_points(std::vector<std::uint32_t>& edges) const {
    const auto is_point = [this](std::uint32_t e) {
      const auto& pieces = curves_.drawing().curves()[edges_[e].curve].beziers;
      const auto& points = pieces.front().control_points();
      return pieces.size() == 1 &&
             std::all_of(points.begin(), points.end(), [&](const Xy<double>& q) { return q == points.front(); });
    };
    edges.erase(std::remove_if(edges.begin(), edges.end(), is_point), edges.end());
  }
  void join_edges(const Intersections_2<>& common) {
    std::vector<std::vector<std::pair<std::uint32_t, bool>>> same(common.overlaps.empty() ? 0 : edges_.size());
    for (std::size_t i = 0; i < common.overlaps.size(); ++i) {
      const Overlap_2& o = common.overlaps[i];
      const std::uint32_t* c = &cut_of_place_[2 * (common.points.size() + 2 * i)];  // a_from, b_from, a_to, b_to
      const bool is_against = o.is_backwards;
      const double width_a = o.a_to.t.lower - o.a_from.t.upper, width_b = std::fabs(o.b_to.t.lower - o.b_from.t.lower);
      auto a = edges_between(c[0], c[2], width_a),
           b = is_against ? edges_between(c[3], c[1], width_b) : edges_between(c[1], c[3], width_b);
      if (a.size() != b.size()) drop_points(a), drop_points(b);
      is_consistent_ = is_consistent_ && a.size() == b.size();
      for (std::size_t k = 0; k < (std::min)(a.size(), b.size()); ++k) {
        const std::uint32_t other = is_against ? b[b.size() - 1 - k] : b[k];
        same[a[k]].emplace_back(other, is_against);
        same[other].emplace_back(a[k], is_against);
      }
    }
    std::vector<char> is_done(same.size(), 0);
    std::vector<std::uint32_t> todo;
    for (std::uint32_t e = 0; e < same.size(); ++e) {
      if (is_done[e] != 0) continue;
      is_done[e] = 1;
      todo.push_back(e);
      while (!todo.empty()) {
        const std::uint32_t at = todo.back();
        todo.pop_back();
        for (const auto& [other, is_against] : same[at]) {
          if (is_done[other] != 0) continue;
          is_done[other] = 1;
          edges_[other].representative = e;
          edges_[other].is_against = edges_[at].is_against != is_against;
          todo.push_back(other);
        }
      }
    }
  }

  void find_plain_crossings(const Intersections_2<>& common) {
    for (std::size_t i = 0; i < common.points.size(); ++i) {
      const std::uint32_t a = cut_of_place_[2 * i], b = cut_of_place_[2 * i + 1], vertex = cuts_[a].vertex;
      if (first_at_[vertex + 1] - first_at_[vertex] != 2 || a == b) continue;
      const bool is_at_joint = cuts_[a].place.is_start() || cuts_[b].place.is_start();
      crossings_[vertex] = {a, b, common.points[i].kind == Intersection_kind::TRANSVERSAL && !is_at_joint};
    }
  }

  const Segment_hierarchy& curves_;
  std::vector<std::uint32_t> cut_of_place_;
  std::vector<Curve_cut> cuts_;  // in the order of the curves
  std::vector<Cut_edge> edges_;
  std::vector<std::uint32_t> first_on_;                // cuts by Bezier piece
  std::vector<std::uint32_t> first_cut_, first_edge_;  // by curve
  std::vector<std::uint32_t> after_, before_;          // edges by cut
  std::vector<std::uint32_t> by_vertex_, first_at_;    // cuts by vertex
  std::vector<Plain_crossing> crossings_;              // by vertex
  bool is_consistent_ = true, is_resolved_ = true;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

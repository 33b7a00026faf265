// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The spiral pieces of edges: segments, cut where curves are. All pieces at a vertex have one point there, so that
// chains of edges are closed, whatever curves they are on.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_EDGE_PIECES_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_EDGE_PIECES_H

#include <CGAL/Bounding_arcs_2/boolean/internal/Cut_curves.h>
#include <CGAL/Bounding_arcs_2/tree/Segment_hierarchy.h>
#include <CGAL/Bounding_arcs_2/tree/Spiral_piece_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A piece of an edge.
struct Edge_piece {
  std::uint32_t edge = 0;
  Spiral_piece_2 piece;
  double error = 0;  ///< how far its samples may be from the exact curve
};

class Edge_pieces {
 public:
  explicit Edge_pieces(const Cut_curves& cut) : cut_(cut), curves_(cut.curves()) {
    first_segment_.assign(curves_.number_of_beziers() + 1, 0);
    for (std::uint32_t s = 0; s < curves_.number_of_segments(); ++s) ++first_segment_[curves_.bezier_of(s) + 1];
    for (std::size_t b = 0; b < curves_.number_of_beziers(); ++b) first_segment_[b + 1] += first_segment_[b];
    points_.resize(cut.number_of_vertices());
    std::vector<char> is_given(points_.size(), 0);
    for (const bool is_start : {true, false})  // control points are exact
      for (const Curve_cut& c : cut.cuts()) {
        if (c.place.is_start() != is_start || is_given[c.vertex] != 0) continue;
        points_[c.vertex] = curves_.evaluator(c.place.bezier)(c.t()).point;
        is_given[c.vertex] = 1;
      }
  }

  [[nodiscard]] const Segment_hierarchy& curves() const { return curves_; }
  [[nodiscard]] const Cut_curves& cut() const { return cut_; }
  [[nodiscard]] const Xy<double>& point(std::uint32_t vertex) const { return points_[vertex]; }

  /// Calls visit(Edge_piece) for each part of a segment, in its order.
  template <class Visit> void for_each_of_segment(std::uint32_t segment, const Visit& visit) const {
    const Spiral_piece_2& whole = curves_.piece(segment);
    const std::uint32_t bezier = curves_.bezier_of(segment);
    const std::size_t curve = curves_.place(segment).curve;
    const auto range = cut_.cuts_of_bezier(bezier);
    std::uint32_t cut = range.first;
    const std::uint32_t end = range.second;
    const auto& cuts = cut_.cuts();
    while (cut < end && cuts[cut].t() < whole.first.t) ++cut;
    Edge_piece part{0, {segment, whole.first, whole.first}, curves_.error(segment)};
    double moved = 0;
    if (cut < end && cuts[cut].t() == whole.first.t) moved = move(part.piece.first, cuts[cut++].vertex);
    const auto add = [&](const Spiral_sample& last, double moved_last) {
      part.edge = cut_.edge_at(curve, cut);
      part.piece.last = last;
      part.error = curves_.error(segment) + (std::max)(moved, moved_last);
      visit(part);
      part.piece.first = last;
      moved = moved_last;
    };
    for (; cut < end && cuts[cut].t() < whole.last.t; ++cut) {
      Spiral_sample at = curves_.sample(segment, cuts[cut].t());
      const double moved_here = move(at, cuts[cut].vertex);
      add(at, moved_here);
    }
    Spiral_sample last = whole.last;
    const double moved_last = cut < end && cuts[cut].t() == last.t ? move(last, cuts[cut].vertex) : 0;
    add(last, moved_last);
  }

  /// Calls visit(Edge_piece) for the pieces of an edge in its direction until that returns false.
  template <class Visit> void for_each_of_edge(std::uint32_t edge, const Visit& visit) const {
    bool goes_on = true;
    for (const Bezier_span& span : cut_.spans_of(edge)) {
      const double low = span.from.middle(), high = span.to.middle();
      for (std::uint32_t s = first_segment_[span.bezier]; s < first_segment_[span.bezier + 1] && goes_on; ++s)
        for_each_of_segment(s, [&](const Edge_piece& p) {
          if (goes_on && low <= p.piece.first.t && p.piece.last.t <= high) goes_on = visit(p);
        });
    }
  }
  /// The widest of the first pieces of an edge, one with a double between its parameters if there is any.
  [[nodiscard]] Edge_piece widest_of(std::uint32_t edge) const {
    constexpr int MOST = 8;
    int count = 0;
    double best = -1;
    Edge_piece result;
    for_each_of_edge(edge, [&](const Edge_piece& p) {
      const Xy<double> chord = p.piece.last.point - p.piece.first.point;
      const double t = p.piece.first.t + (p.piece.last.t - p.piece.first.t) / 2;
      constexpr double LEAST = -0.5;
      const double size = p.piece.first.t < t && t < p.piece.last.t
                              ? (std::min)(std::fabs(chord.x), std::fabs(chord.y)) +
                                    0x1p-10 * (std::max)(std::fabs(chord.x), std::fabs(chord.y))
                              : LEAST;
      if (size > best) {
        best = size;
        result = p;
      }
      return ++count < MOST;
    });
    return result;
  }

 private:
  // How far a sample's point was moved to that of its vertex.
  [[nodiscard]] double move(Spiral_sample& sample, std::uint32_t vertex) const {
    const Xy<double> way = points_[vertex] - sample.point;
    sample.point = points_[vertex];
    return std::fabs(way.x) + std::fabs(way.y);
  }

  const Cut_curves& cut_;
  const Segment_hierarchy& curves_;
  std::vector<std::uint32_t> first_segment_;  // by Bezier piece
  std::vector<Xy<double>> points_;            // by vertex
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

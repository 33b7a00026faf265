// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order of edges around a vertex, counterclockwise.
//
// Directions tell it, but for edges that leave in directions which doubles do not tell apart.  For two such edges, A
// and B, a point p of A is compared with B exactly, at the same x, or y where they are steeper: neither meets the other
// between the vertex and there, and both are monotone.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_VERTEX_ORDER_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_VERTEX_ORDER_H

#include <CGAL/Bounding_arcs_2/boolean/internal/Edge_pieces.h>
#include <CGAL/Bounding_arcs_2/query/exact_crossings.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// An end of an edge.
struct Edge_end {
  std::uint32_t edge = 0;
  bool is_start = true;
};

class Vertex_order {
 public:
  explicit Vertex_order(const Edge_pieces& pieces) : pieces_(pieces), curves_(pieces.curves()) {}

  /// Sorts ends at one vertex counterclockwise.
  /// \return false where that is not decided
  [[nodiscard]] bool sort(std::vector<Edge_end>& ends) const {
    std::vector<Way> ways;
    ways.reserve(ends.size());
    for (const Edge_end& e : ends) ways.push_back(way_of(e));
    std::sort(ways.begin(), ways.end(), [](const Way& p, const Way& q) { return p.angle < q.angle; });
    const std::size_t n = ways.size();
    std::size_t first = 0;  // behind a gap
    while (first < n && is_close(ways[(first + n - 1) % n], ways[first], first == 0)) ++first;
    if (first == n) return false;
    std::rotate(ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(first), ways.end());
    for (std::size_t i = 0; i < n;) {
      std::size_t j = i + 1;
      while (j < n && is_close(ways[j - 1], ways[j], j == n - first)) ++j;
      for (std::size_t k = i + 1; k < j; ++k)  // few of them: by insertion
        for (std::size_t l = k; l > i; --l) {
          const std::optional<bool> is_before = is_clockwise_of(ways[l], ways[l - 1]);
          if (!is_before) return false;
          if (!*is_before) break;
          std::swap(ways[l], ways[l - 1]);
        }
      i = j;
    }
    for (std::size_t i = 0; i < n; ++i) ends[i] = ways[i].end;
    return true;
  }

 private:
  static constexpr double PI = 3.141592653589793;

  // How an edge leaves the vertex: along its first piece.  A vertex may be some ulp before the end of a segment or of a
  // Bezier piece; then the next one tells where the edge goes.
  struct Way {
    Edge_end end;
    std::uint32_t bezier;
    double from, to;  // parameters, from the vertex on
    double angle, error;
  };

  [[nodiscard]] Way way_of(const Edge_end& end) const {
    std::vector<Spiral_piece_2> pieces;  // from the vertex on
    pieces_.for_each_of_edge(end.edge, [&](const Edge_piece& p) {
      pieces.push_back(p.piece);
      return !end.is_start || pieces.size() < 2;
    });
    if (!end.is_start) std::reverse(pieces.begin(), pieces.end());
    constexpr double FEW_ULP = 0x1p-48;
    const bool goes_on = pieces.size() > 1 && pieces[0].last.t - pieces[0].first.t <= FEW_ULP,
               is_over_joint = goes_on && curves_.bezier_of(pieces[0].segment) != curves_.bezier_of(pieces[1].segment);
    const Spiral_piece_2 &first = pieces[is_over_joint ? 1 : 0], &last = pieces[goes_on ? 1 : 0];
    const Spiral_sample& at = end.is_start ? first.first : first.last;
    const std::uint32_t bezier = curves_.bezier_of(first.segment);
    const Xy<double> way = end.is_start ? at.tangent : Xy<double>{-at.tangent.x, -at.tangent.y};
    const Cut_edge& edge = pieces_.cut().edges()[end.edge];
    const Curve_cut& cut = pieces_.cut().cuts()[end.is_start ? edge.first : edge.last];
    double error = at.tangent_error + 16 * HALF_ULP;
    const double to = end.is_start ? last.last.t : last.first.t;
    if (!is_over_joint && !(error < 1) && curves_.decisions() != Decisions::DOUBLE &&
        has_cusp(curves_.exact_bezier(bezier), cut.place.t))
      return way_from_cusp(end, bezier, cut, at.t, to);
    if (const double range = cut.place.t.upper - cut.place.t.lower + cut.moved; range > 0)  // there the tangent turns
      error += 2 * range * turn_rate(bezier, at, to);
    return {end, bezier, at.t, to, std::atan2(way.y, way.x), error < 1 ? 2 * error : PI};
  }
  // From a cusp that is no double, where C' = 0: both ways leave it along C''.
  [[nodiscard]] Way way_from_cusp(const Edge_end& end, std::uint32_t bezier, const Curve_cut& cut, double from,
                                  double to) const {
    const Bezier_evaluator& curve = curves_.evaluator(bezier);
    const Curve_jet jet = curve(cut.t());
    constexpr double TURNS = 16;  // the third derivative over the bound of C'', by the degree
    const double error = (curve.second_error() + cut.place.t.width() * TURNS * curve.degree() * curve.second_bound()) /
                         euclidean_norm(jet.second);
    return {end, bezier, from, to, std::atan2(jet.second.y, jet.second.x), error < 1 ? 2 * error : PI};
  }
  // How fast the tangent turns by the parameter, at a cusp beside it: there speed is 0 and curvature infinite.
  [[nodiscard]] double turn_rate(std::uint32_t bezier, const Spiral_sample& at, double to) const {
    const Bezier_evaluator& curve = curves_.evaluator(bezier);
    const double rate = euclidean_norm(curve(at.t).first) * at.most_curvature;
    if (std::isfinite(rate)) return rate;
    constexpr double BESIDE = 1.0 / 16, ROOM = 2;
    const Curve_jet jet = curve(at.t + BESIDE * (to - at.t));
    return ROOM * std::fabs(cross(jet.first, jet.second)) / dot(jet.first, jet.first);
  }
  // Whether doubles do not tell q from p, the one before it.
  [[nodiscard]] static bool is_close(const Way& p, const Way& q, bool is_past_turn) {
    constexpr double TURN = 6.283185307179586;
    return q.angle - p.angle + (is_past_turn ? TURN : 0) <= p.error + q.error;
  }

  // Whether p is clockwise of q. \return nothing where it stays open
  [[nodiscard]] std::optional<bool> is_clockwise_of(const Way& p, const Way& q) const {
    if (curves_.decisions() == Decisions::DOUBLE) return std::nullopt;
    const auto curve_p = curves_.exact_bezier(p.bezier), curve_q = curves_.exact_bezier(q.bezier);
    const Exact_point end_q = curve_q.point(Exact_rational(q.to)), start_q = curve_q.point(Exact_rational(q.from));
    const Exact_point way = end_q - start_q;
    const bool by_x = std::fabs(std::cos(q.angle)) >= std::fabs(std::sin(q.angle));  // both rise or fall
    const auto along = [by_x](const Exact_point& v) { return by_x ? v.x : v.y; };
    const int sign = static_cast<int>(CGAL::sign(along(way)));
    if (sign == 0) return std::nullopt;
    constexpr int MOST = 200;
    Exact_rational t(p.to);
    for (int i = 0; i < MOST; ++i) {
      t = (t + Exact_rational(p.from)) / Exact_rational(2);
      const Exact_point at = curve_p.point(t);
      const Exact_rational reach = along(Exact_point(at - start_q));
      if (static_cast<int>(CGAL::sign(reach)) != sign) return std::nullopt;
      if (CGAL::abs(reach) >= CGAL::abs(along(way))) continue;
      // whether q is to the left of p's point, seen in direction +y or +x
      const Exact_rational low((std::min)(q.from, q.to)), high((std::max)(q.from, q.to));
      Seen_curve seen = restricted(seen_from(at, curve_q), low, high);
      if (have_common_root(seen.x, seen.y)) return std::nullopt;
      if (by_x) std::swap(seen.x, seen.y);
      const bool is_beyond = crossings(seen) != 0;  // above it, or to the right of it
      return by_x ? is_beyond == (sign > 0) : is_beyond != (sign > 0);
    }
    return std::nullopt;
  }

  const Edge_pieces& pieces_;
  const Segment_hierarchy& curves_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a ray crosses: from a point of each connected part of the curves to the right.
//
//   a segment that is beside the point's height, or clearly crosses it: in doubles
//   a piece with a segment that doubles leave open: its crossings as roots of a polynomial, compared with its cuts
//
// Points at the ray's height count as below it, as if the ray was higher by less than any number.

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_COMPONENT_RAYS_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_COMPONENT_RAYS_H

#include "Cut_curves.h"

#include "../query/Winding_search.h"
#include "../tree/Box_tree.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/FPU.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// An edge that a ray crosses.
struct Edge_hit {
  std::uint32_t edge;    ///< the representative of its class
  int number;            ///< crossings upwards less those downwards
  std::uint32_t bezier;  ///< where
};
/// A ray from a point of an edge, but for what it crosses there.
struct Edge_ray {
  std::uint32_t edge = 0;    ///< the representative of its class
  bool starts_left = false;  ///< whether the ray is on the left of it, where it starts
  std::vector<Edge_hit> hits;
};

class Component_rays {
 public:
  explicit Component_rays(const Cut_curves& cut) : cut_(cut), curves_(cut.curves()) {
    const std::size_t curves = curves_.drawing().curves().size();
    Joined_sets sets(curves);
    const auto curve_of = [&](std::uint32_t c) {
      const std::uint32_t after = cut.edge_after(c);
      return cut.edges()[after != NO_NUMBER ? after : cut.edge_before(c)].curve;
    };
    for (std::uint32_t v = 0; v < cut.number_of_vertices(); ++v)
      for (std::uint32_t i = cut.first_at(v) + 1; i < cut.first_at(v + 1); ++i)
        sets.join(curve_of(cut.cuts_by_vertex()[i]), curve_of(cut.cuts_by_vertex()[i - 1]));
    for (std::uint32_t curve = 0; curve < curves; ++curve) {
      const std::uint32_t least = sets.find(curve);
      component_.push_back(least == curve ? static_cast<std::uint32_t>(boxes_.size()) : component_[least]);
      if (least == curve) boxes_.emplace_back();
    }
    longest_.assign(boxes_.size(), NO_NUMBER);
    std::vector<double> size(boxes_.size(), -1);
    for (std::uint32_t s = 0; s < curves_.number_of_segments(); ++s) {
      const std::uint32_t component = component_[curves_.place(s).curve];
      boxes_[component] += curves_.box(curves_.piece(s));
      const Xy<double> chord = curves_.piece(s).last.point - curves_.piece(s).first.point;
      constexpr double LEVEL = 0x1p-20;  // a level segment has ends of others at its height
      const double own = std::fabs(chord.y) + LEVEL * std::fabs(chord.x);
      if (own <= size[component]) continue;
      size[component] = own;
      longest_[component] = s;
    }
    box_tree_ = Box_tree(boxes_);
  }

  [[nodiscard]] std::size_t number_of_components() const { return boxes_.size(); }
  [[nodiscard]] std::uint32_t component_of(std::uint32_t curve) const { return component_[curve]; }
  /// A ray from a component's curves.
  /// \return nothing where doubles leave it open and there are no exact decisions
  [[nodiscard]] std::optional<Edge_ray> from(std::uint32_t component) const {
    const std::optional<Origin> clear = origin_on(longest_[component]);
    const bool is_exact = curves_.decisions() == Decisions::EXACT;
    if (!clear && !is_exact) return std::nullopt;
    const Origin o = clear ? *clear : origin_between_cuts(component);
    Edge_ray ray;
    std::vector<std::uint32_t> open;  // Bezier pieces
    Asked_point q(curves_.evaluator(o.bezier)(o.t).point);
    q.error = clear ? curves_.error(o.segment) : 0;
    const int rise = clear ? clear_rise(o, q) : 0;
    if (rise != 0) set_start(rise, 0, o.edge, ray);
    std::optional<Exact_point> exact;
    const auto make_exact = [&] {
      const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
      const Exact_curve& curve = cut_.places().curve(curves_, o.bezier);
      const Exact_rational t = o.exact_t ? *o.exact_t : Exact_rational(o.t);
      exact = curve.point(t);
      if (rise != 0) return;
      const auto sign = [&](const Univariate& n) {
        return static_cast<int>(CGAL::sign(value_at(derivative_numerator(n, curve.piece().w), t)));
      };
      set_start(sign(curve.piece().y), sign(curve.piece().x), o.edge, ray);
    };
    if (!clear) {
      make_exact();
      q = Asked_point(*exact);
    }
    if (rise == 0) open.push_back(o.bezier);
    add_clear_hits(q, rise != 0 ? o.segment : NO_NUMBER, ray.hits, open);
    std::sort(open.begin(), open.end());
    open.erase(std::unique(open.begin(), open.end()), open.end());
    if (!open.empty() && !is_exact) return std::nullopt;
    const auto is_open = [&](const Edge_hit& h) { return std::binary_search(open.begin(), open.end(), h.bezier); };
    ray.hits.erase(std::remove_if(ray.hits.begin(), ray.hits.end(), is_open), ray.hits.end());
    if (!open.empty() && !exact) make_exact();
    for (const std::uint32_t bezier : open) add_exact_hits(*exact, bezier, ray);
    return ray;
  }

 private:
  /// Where a ray starts.
  struct Origin {
    std::uint32_t bezier = 0, edge = 0;
    std::uint32_t segment = NO_NUMBER;  ///< whose samples are the ends of a part with the parameter in it
    double t = 0;
    std::optional<Exact_rational> exact_t;  ///< where it is no double
  };

  // The middle of the longest part of a segment between cuts.
  [[nodiscard]] std::optional<Origin> origin_on(std::uint32_t segment) const {
    const Spiral_piece_2 whole = curves_.piece(segment);
    Origin o;
    o.bezier = curves_.bezier_of(segment);
    o.segment = segment;
    const auto [first, end] = cut_.cuts_of_bezier(o.bezier);
    double widest = 0, from = whole.first.t;
    const auto take = [&](double to, std::uint32_t cut_behind) {
      const double t = from + (to - from) / 2;
      if (!(to - from > widest) || !(from < t && t < to)) return;
      widest = to - from;
      o.t = t;
      o.edge = cut_.edge_at(curves_.place(segment).curve, cut_behind);
    };
    std::uint32_t cut = first;
    for (; cut < end && cut_.cuts()[cut].at.t.lower < whole.last.t; ++cut) {
      const Bracket& t = cut_.cuts()[cut].at.t;
      if (t.upper <= whole.first.t) continue;
      if (t.lower > from) take(t.lower, cut);
      from = (std::max)(from, t.upper);
    }
    take(whole.last.t, cut);
    return widest > 0 ? std::optional(o) : std::nullopt;
  }
  // A rational parameter on any edge of the component.
  [[nodiscard]] Origin origin_between_cuts(std::uint32_t component) const {
    const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
    Origin o;
    for (std::uint32_t e = 0; e < cut_.edges().size(); ++e) {
      if (component_[cut_.edges()[e].curve] != component || cut_.edges()[e].representative == NO_NUMBER) continue;
      const Bezier_span span = cut_.spans_of(e).front();
      o.bezier = span.bezier;
      o.edge = e;
      o.exact_t = number_between(cut_.start_of(span), cut_.end_of(span));
      const Exact_curve& curve = cut_.places().curve(curves_, o.bezier);
      if (!curve.piece().is_point()) break;
    }
    return o;
  }
  /// The sign of the rise at the origin where that is clear, along the whole segment.
  [[nodiscard]] int clear_rise(const Origin& o, const Asked_point& q) const {
    constexpr double CLEAR = 4;  // times the error
    const Spiral_piece_2 piece = curves_.piece(o.segment);
    const double before = q.point.y - piece.first.point.y, after = piece.last.point.y - q.point.y;
    if (before > CLEAR * q.error && after > CLEAR * q.error) return 1;
    return before < -CLEAR * q.error && after < -CLEAR * q.error ? -1 : 0;
  }
  // \param own_segment crosses the ray's height at its start alone
  void add_clear_hits(const Asked_point& q, std::uint32_t own_segment, std::vector<Edge_hit>& hits,
                      std::vector<std::uint32_t>& open) const {
    const double left = q.point.x - q.error, right = q.point.x + q.error, low = q.point.y - q.error,
                 high = q.point.y + q.error;
    const auto meets_ray = [&](const CGAL::Bbox_2& box) {
      return box.ymin() <= high && low <= box.ymax() && left <= box.xmax();
    };
    const auto holds_point = [&](const CGAL::Bbox_2& box) { return meets_ray(box) && box.xmin() <= right; };
    double end = right;  // of the ray
    for_each_item(
        box_tree_, [&](const Box_tree::Node& node, std::size_t k) { return holds_point(node.box(k)); },
        [&](const Box_tree::Node& node, std::size_t k) {
          end = (std::max)(end, node.x_high[k]);
          return true;
        });
    const auto is_met = [&](const Box_tree::Node& node, std::size_t k) {
      return meets_ray(node.box(k)) && node.x_low[k] <= end;
    };
    for_each_item(curves_.boxes(), is_met, [&](const Box_tree::Node& node, std::size_t k) {
      const std::uint32_t segment = node.child[k];
      if (segment == own_segment || !holds_point(boxes_[component_[curves_.place(segment).curve]])) return true;
      const Spiral_piece_2 piece = curves_.piece(segment);
      const std::uint32_t bezier = curves_.bezier_of(segment);
      // ends may be others' ends, or cuts, too: all of them are on the same side of the exact height
      const auto is_near_end = [&](const Spiral_sample& s) {
        const double error = s.t == 0 || s.t == 1 ? curves_.rounding(bezier) : curves_.error(segment);
        return std::fabs(s.point.y - q.point.y) <= q.error + error;
      };
      const std::optional<std::uint32_t> edge = edge_of_crossing(q, segment);
      Winding_search search(curves_, q, Decisions::DOUBLE);
      const int number = search.crossings_of(piece, curves_.error(segment));
      if (search.is_undecided() || !edge || is_near_end(piece.first) || is_near_end(piece.last)) {
        open.push_back(bezier);
      } else if (number != 0 && cut_.is_representative(*edge)) {
        hits.push_back({*edge, number, bezier});
      }
      return true;
    });
  }
  // The edge at which a segment, which is monotone, crosses a height, if it does; nothing where a cut is next to it.
  [[nodiscard]] std::optional<std::uint32_t> edge_of_crossing(const Asked_point& q, std::uint32_t segment) const {
    const Spiral_piece_2 piece = curves_.piece(segment);
    const std::uint32_t bezier = curves_.bezier_of(segment);
    const auto [first, end] = cut_.cuts_of_bezier(bezier);
    const bool is_below = piece.first.point.y < q.point.y;
    std::uint32_t behind = NO_NUMBER, cut = first;
    for (; cut < end; ++cut) {
      const Bracket& t = cut_.cuts()[cut].at.t;
      if (t.upper < piece.first.t || (t.is_single() && t.lower == piece.first.t)) continue;
      if (t.lower >= piece.last.t) break;
      const Bezier_evaluator& curve = curves_.evaluator(bezier);
      const Curve_jet jet = curve(t.middle());
      const double speed = euclidean_norm(jet.first) + curve.first_error() + t.width() * curve.second_bound(),
                   error = curves_.error(segment) + q.error + t.width() * speed;
      if (!(std::fabs(jet.point.y - q.point.y) > 2 * error)) return std::nullopt;
      if (behind == NO_NUMBER && (jet.point.y < q.point.y) != is_below) behind = cut;
    }
    return cut_.edge_at(curves_.place(segment).curve, behind != NO_NUMBER ? behind : cut);
  }
  // Crossings of a whole Bezier piece. At a cut the edge counts that is above it.
  void add_exact_hits(const Exact_point& q, std::uint32_t bezier, Edge_ray& ray) const {
    const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
    const Integer_piece& piece = cut_.places().curve(curves_, bezier).piece();
    const Univariate x = moved(piece.x, piece.w, q.x), y = moved(piece.y, piece.w, q.y);
    if (y.is_zero()) return;
    const auto [first, end] = cut_.cuts_of_bezier(bezier);
    const std::size_t curve = curves_.curve_of_bezier(bezier);
    const auto add = [&](std::uint32_t cut_behind, int number) {
      const std::uint32_t edge = cut_.edge_at(curve, cut_behind);
      if (cut_.is_representative(edge)) ray.hits.push_back({edge, number, bezier});
    };
    for (const Exact_zero& zero : exact_zeros(y)) {
      if (Real_root(zero.t).sign_of(x) <= 0) continue;  // behind the start, or through it: of its own class
      const Exact_parameter at(zero.t);
      std::uint32_t cut = first;
      int order = 1;
      while (cut < end && (order = at.compare(cut_.parameter(cut))) > 0) ++cut;
      if (zero.sign_before > 0) add(cut, -1);
      if (zero.sign_behind > 0) add(cut < end && order == 0 ? cut + 1 : cut, 1);
    }
  }
  void set_start(int rise, int level, std::uint32_t edge, Edge_ray& ray) const {
    const Cut_edge& e = cut_.edges()[edge];
    ray.edge = e.representative;
    // to the right of what rises, and above what is level
    const bool is_left = rise != 0 ? rise < 0 : level > 0;
    ray.starts_left = is_left != e.is_against;
  }

  const Cut_curves& cut_;
  const Segment_hierarchy& curves_;
  std::vector<std::uint32_t> component_;  // by curve
  std::vector<CGAL::Bbox_2> boxes_;       // by component
  std::vector<std::uint32_t> longest_;    // segment, by component
  Box_tree box_tree_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lines between an axis's samples, each with what both feet run along.
//
//   s --------------> t       The region is to the left of the boundary: left feet run from t to s along it, right ones
//   left    <----             from s to t.
//   right   ---->

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_LINES_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_LINES_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_boundary.h>
#include <CGAL/Bounding_arcs_2/tree/Segment_hierarchy.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// What a foot runs along from one disc to another one: a part of a segment, or a point.
struct Foot_run {
  std::uint32_t segment = 0;
  double from = 0, to = 0;  ///< t
  bool is_point = false;
  Xy<double> point{};  ///< where it is one

  /// Whether the curve's parameter grows in the direction of the run.
  [[nodiscard]] bool is_growing() const { return from < to; }
};

/// A line between the centers of two discs.
struct Axis_line {
  Touching_disc first, last;
  Foot_run left, right;                            ///< both from the first disc to the last one
  double share = 1;                                ///< of a line between samples, where this is a part of one
  Touching_disc beyond[2] = {{{}, -1}, {{}, -1}};  ///< the edge's samples before and behind, or of radius -1
  const std::vector<Xy<double>>* others[2] = {nullptr, nullptr};  ///< points of curves, touched by a vertex at an end
};

/// Finds what feet run along.
class Foot_runs {
 public:
  /// \param room lengths below are nothing
  Foot_runs(const Segment_hierarchy& curves, double room) : curves_(curves), room_(room) {
    first_.assign(curves.number_of_beziers() + 1, 0);
    for (std::uint32_t i = 0; i < curves.number_of_segments(); ++i) ++first_[curves.bezier_of(i) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  }

  /// A place nearer to where a center is on the normal, of the same segment; ends of segments stay.  Distances hardly
  /// change along the boundary, so feet may be off where discs are not.
  [[nodiscard]] Curve_place on_normal(const Curve_place& p, const Xy<double>& center) const {
    const std::uint32_t bezier = curves_.number_of_bezier(p.curve, p.bezier);
    const Bezier_evaluator& curve = curves_.evaluator(bezier);
    const auto aside = [&](const Curve_jet& j) { return dot(center - j.point, j.first); };
    const Curve_jet jet = curve(p.t);
    const double square = dot(jet.first, jet.first), steep = square - dot(center - jet.point, jet.second);
    if (!(std::fabs(aside(jet)) > room_ * std::sqrt(square)) || !(steep > 0)) return p;
    const Spiral_piece_2& piece = curves_.piece(segment_at(bezier, p.t));
    if (p.t <= piece.first.t || p.t >= piece.last.t) return p;
    Curve_place moved = p;
    moved.t = std::clamp(p.t + aside(jet) / steep, piece.first.t, piece.last.t);  // a step of Newton's
    return std::fabs(aside(curve(moved.t))) < 0.5 * std::fabs(aside(jet)) ? moved : p;
  }

  /// \return nothing where two feet are on no common segment
  [[nodiscard]] std::optional<Foot_run> between(const Curve_place& a, const Curve_place& b) const {
    if (a.curve != b.curve) return std::nullopt;
    if (a.bezier == b.bezier && a.t == b.t) return point_run(a);
    const Names of_a = names(a), of_b = names(b);
    std::optional<Foot_run> best;
    for (int i = 0; i < of_a.count; ++i)
      for (int k = 0; k < of_b.count; ++k) {
        if (of_a.all[i].bezier != of_b.all[k].bezier) continue;
        const auto run = on_piece(of_a.all[i], of_b.all[k]);
        // a closed curve of one piece has two ways: segments turn by a right angle at most
        if (run && (!best || std::fabs(run->to - run->from) < std::fabs(best->to - best->from))) best = run;
      }
    return best;
  }
  [[nodiscard]] Xy<double> point(const Curve_place& p) const {
    return curves_.evaluator(curves_.number_of_bezier(p.curve, p.bezier))(p.t).point;
  }

 private:
  struct Names {
    Curve_place all[2];
    int count;
  };
  [[nodiscard]] bool are_same(const Curve_place& p, const Curve_place& q) const {
    return (p.bezier == q.bezier && p.t == q.t) || euclidean_norm(point(p) - point(q)) <= room_;
  }
  // A place at a joint is on two pieces.
  [[nodiscard]] Names names(const Curve_place& p) const {
    constexpr double NEAR = 0x1p-10;
    Names names{{p, p}, 1};
    const auto& curve = curves_.drawing().curves()[p.curve];
    const auto count = static_cast<std::uint32_t>(curve.beziers.size());
    const bool is_first = p.t < NEAR;
    if (!is_first && p.t < 1 - NEAR) return names;
    const bool is_at_end = is_first ? p.bezier == 0 : p.bezier + 1 == count;
    if (is_at_end && !curve.is_closed) return names;
    const Curve_place end{p.curve, p.bezier, is_first ? 0.0 : 1.0};
    if (!are_same(p, end)) return names;
    names.all[1] = {p.curve, (p.bezier + (is_first ? count - 1 : 1)) % count, is_first ? 1.0 : 0.0};
    names.count = 2;
    return names;
  }
  [[nodiscard]] std::uint32_t segment_at(std::uint32_t bezier, double t) const {
    std::uint32_t s = first_[bezier];
    while (s + 1 < first_[bezier + 1] && curves_.piece(s).last.t < t) ++s;
    return s;
  }
  [[nodiscard]] Foot_run point_run(const Curve_place& p) const {
    Foot_run run;
    run.is_point = true, run.point = point(p);
    return run;
  }
  // On the segment that has the middle; an end may be past that by nothing.
  [[nodiscard]] std::optional<Foot_run> on_piece(const Curve_place& a, const Curve_place& b) const {
    const std::uint32_t bezier = curves_.number_of_bezier(a.curve, a.bezier);
    const double middle = a.t + 0.5 * (b.t - a.t);
    const std::uint32_t s = segment_at(bezier, middle);
    const double low = curves_.piece(s).first.t, high = curves_.piece(s).last.t;
    const Curve_place first{a.curve, a.bezier, std::clamp(a.t, low, high)},
        last{b.curve, b.bezier, std::clamp(b.t, low, high)};
    if (are_same(a, b)) return point_run(a);
    if (!are_same(a, first) || !are_same(b, last)) return std::nullopt;
    Foot_run run;
    run.segment = s, run.from = first.t, run.to = last.t;
    return run;
  }

  const Segment_hierarchy& curves_;
  double room_;
  std::vector<std::uint32_t> first_;  // segments of each Bezier piece
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

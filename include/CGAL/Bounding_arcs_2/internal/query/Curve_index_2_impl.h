// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How an index is made: segments of each Bezier piece, samples at their ends, fat arcs, boxes.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_CURVE_INDEX_2_IMPL_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_CURVE_INDEX_2_IMPL_H

#include <CGAL/Bounding_arcs_2/internal/convert.h>
#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>
#include <CGAL/Bounding_arcs_2/tree/box_of_piece.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL::Bounding_arcs {

namespace internal {

inline Drawing_2<double> rounded_drawing(const Drawing_2<Exact_rational>& drawing) {
  Drawing_2<double> result;
  const auto numbers = [](const std::vector<Exact_rational>& exact) {
    std::vector<double> rounded;
    for (const Exact_rational& x : exact) rounded.push_back(convert<double>(x));
    return rounded;
  };
  for (const auto& curve : drawing.curves()) {
    std::vector<Bezier_curve_2<double>> chain;
    for (const auto& piece : curve.beziers) {
      std::vector<Xy<double>> points;
      for (const auto& p : piece.control_points()) points.push_back({convert<double>(p.x), convert<double>(p.y)});
      chain.emplace_back(std::move(points), numbers(piece.weights()));
    }
    result.add(std::move(chain), curve.name, numbers(curve.parameters));
  }
  return result;
}

// How far a curve may be from the one with rounded numbers, 0 where they were doubles. Points of a rational curve with
// weights within relative errors of u are combinations of the same control points with coefficients within 2 u; their
// sum of parts moves the point by 4 u of the coordinates' size at most.
inline double rounding_error(const Bezier_evaluator& curve, const Bezier_curve_2<Exact_rational>& exact,
                             const Bezier_curve_2<double>& rounded) {
  bool is_same = true;
  for (std::size_t i = 0; i < exact.control_points().size(); ++i) {
    const auto& p = exact.control_points()[i];
    const auto& q = rounded.control_points()[i];
    is_same = is_same && p.x == Exact_rational(q.x) && p.y == Exact_rational(q.y);
  }
  for (std::size_t i = 0; i < exact.weights().size(); ++i)
    is_same = is_same && exact.weights()[i] == Exact_rational(rounded.weights()[i]);
  if (is_same) return 0;
  constexpr double OF_COORDINATES = 1.5, OF_WEIGHTS = 6;
  return (OF_COORDINATES + (curve.is_rational() ? OF_WEIGHTS : 0)) * ARC_HALF_ULP * curve.coordinate_size();
}

}  // namespace internal

inline Curve_index_2::Curve_index_2(const Drawing_2<double>& drawing, Query_decisions decisions)
    : drawing_(drawing), decisions_(decisions) {
  build(nullptr);
}
inline Curve_index_2::Curve_index_2(const Drawing_2<Exact_rational>& drawing, Query_decisions decisions)
    : drawing_(internal::rounded_drawing(drawing)), decisions_(decisions) {
  build(&drawing);
}

inline void Curve_index_2::build(const Drawing_2<Exact_rational>* exact) {
  for (std::size_t i = 0; i < drawing_.curves().size(); ++i) {
    const auto& curve = drawing_.curves()[i];
    first_bezier_.push_back(static_cast<std::uint32_t>(evaluators_.size()));
    for (std::size_t j = 0; j < curve.beziers.size(); ++j) {
      evaluators_.emplace_back(curve.beziers[j]);
      if (exact == nullptr) continue;
      exact_.push_back(exact->curves()[i].beziers[j]);
      roundings_.push_back(internal::rounding_error(evaluators_.back(), exact_.back(), curve.beziers[j]));
    }
  }
  const std::vector<Bezier_spiral_2<double>> spirals = spiral_segments(drawing_);
  for (auto* column : {&errors_}) column->reserve(spirals.size());
  roots_.reserve(spirals.size());
  fats_.reserve(spirals.size());
  for (const Bezier_spiral_2<double>& s : spirals) {
    const std::uint32_t bezier = first_bezier_[s.place().curve] + s.place().bezier;
    add_segment(s, bezier, rounding(bezier));
  }
  std::vector<CGAL::Bbox_2> boxes;
  boxes.reserve(roots_.size());
  for (const Spiral_piece_2& p : roots_) boxes.push_back(box(p));
  boxes_ = internal::Box_tree(boxes);
}

// Ends of segments are rounded once, next to the true point, and so are cuts: an ulp each.
inline void Curve_index_2::add_segment(const Bezier_spiral_2<double>& spiral, std::uint32_t bezier, double rounding) {
  const auto segment = static_cast<std::uint32_t>(roots_.size());
  const internal::Bezier_evaluator& curve = evaluators_[bezier];
  constexpr double OF_ENDS_AND_CUTS = 4 * ARC_HALF_ULP;
  errors_.push_back(curve.point_error() + spiral.cut_error() + OF_ENDS_AND_CUTS * curve.coordinate_size() + rounding);
  places_.push_back(spiral.place());
  bezier_of_.push_back(bezier);
  is_straight_.push_back(spiral.is_straight() ? 1 : 0);
  Spiral_piece_2 piece{segment, sample(segment, spiral.first()), sample(segment, spiral.last())};
  mend_end(spiral, piece);
  roots_.push_back(piece);
  fats_.push_back(fat(piece));
}

inline Spiral_sample Curve_index_2::sample_of(std::uint32_t segment, double t, const internal::Curve_jet& jet) const {
  const internal::Bezier_evaluator& curve = evaluators_[bezier_of_[segment]];
  const double speed = euclidean_norm(jet.first);
  Spiral_sample s;
  s.t = t;
  s.point = jet.point;
  if (is_straight_[segment] != 0) {          // derivatives have no direction where a line turns back
    if (segment >= roots_.size()) return s;  // the ends get theirs in mend_end
    s.tangent = roots_[segment].first.tangent;
    s.tangent_error = roots_[segment].first.tangent_error;
    return s;
  }
  // that of rounded control points is of the degree times twice their rounding
  const double turned = static_cast<double>(2 * curve.degree()) * (rounding(bezier_of_[segment]));
  const double error = curve.first_error() + turned;
  constexpr double CERTAIN = 4;  // times its error: a direction within a quarter
  if (!(speed >= CERTAIN * error)) {
    s.tangent_error = s.most_curvature = std::numeric_limits<double>::infinity();
    if (speed > 0) s.tangent = (1 / speed) * jet.first;
    return s;
  }
  s.tangent = (1 / speed) * jet.first;
  s.tangent_error = error / speed + 4 * ARC_HALF_ULP;
  // |C' x C''| / |C'|^3, each factor with its error
  const double second = curve.second_error() + 2 * static_cast<double>(curve.degree()) * turned;
  const double across = std::fabs(cross(jet.first, jet.second)) +
                        (speed * second + error * (euclidean_norm(jet.second) + second)) +
                        8 * ARC_HALF_ULP * speed * euclidean_norm(jet.second);
  const double least = speed - error;
  s.most_curvature = across / (least * least * least) * (1 + 16 * ARC_HALF_ULP);
  return s;
}

// Next to a cusp doubles do not tell the direction of C', the accurate shape does. A segment that is no longer than
// its error is taken for its box (see fat_arc).
inline void Curve_index_2::mend_end(const Bezier_spiral_2<double>& spiral, Spiral_piece_2& piece) const {
  constexpr double GOOD = 0x1p-24;  // directions as good as this need no mending
  if (!spiral.is_straight() && piece.first.tangent_error <= GOOD && piece.last.tangent_error <= GOOD) return;
  if (spiral.is_straight()) {
    const Xy<double> chord = piece.last.point - piece.first.point;
    const double length = std::hypot(chord.x, chord.y);
    for (Spiral_sample* s : {&piece.first, &piece.last}) {
      if (length > 0) s->tangent = {chord.x / length, chord.y / length};
      s->tangent_error = 2 * errors_[piece.segment] / length + 4 * ARC_HALF_ULP;
    }
    return;
  }
  const Chord_shape_2<double> shape = spiral.accurate_shape(spiral.first(), spiral.last(), {false, false});
  const auto mend = [&](Spiral_sample& s, const Xy<double>& tangent) {
    const double length = std::hypot(tangent.x, tangent.y);
    if (s.tangent_error <= GOOD || !(length > 0)) return;
    s.tangent = {tangent.x / length, tangent.y / length};
    // of rounded control points the direction at a cusp may be another one
    s.tangent_error = roundings_.empty() ? 8 * ARC_HALF_ULP : s.tangent_error;
  };
  mend(piece.first, shape.tangent0);
  mend(piece.last, shape.tangent1);
}

inline const Bezier_curve_2<double>& Curve_index_2::bezier(std::uint32_t number) const {
  const auto after = std::upper_bound(first_bezier_.begin(), first_bezier_.end(), number);
  const auto curve = static_cast<std::size_t>(after - first_bezier_.begin()) - 1;
  return drawing_.curves()[curve].beziers[number - first_bezier_[curve]];
}

inline Curve_index_2::Exact_bezier Curve_index_2::exact_bezier(std::uint32_t bezier) const {
  if (!exact_.empty()) return exact_[bezier];
  const Bezier_curve_2<double>& piece = this->bezier(bezier);
  std::vector<Xy<Exact_rational>> points;
  std::vector<Exact_rational> weights;
  for (const Xy<double>& p : piece.control_points()) points.push_back({Exact_rational(p.x), Exact_rational(p.y)});
  for (const double w : piece.weights()) weights.emplace_back(w);
  return Exact_bezier(std::move(points), std::move(weights));
}

}  // namespace CGAL::Bounding_arcs

#endif

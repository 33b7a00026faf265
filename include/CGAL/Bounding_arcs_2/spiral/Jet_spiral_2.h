// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spiral segments of any curve that can tell its point and first two derivatives: clothoids, offsets, a user's own.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_JET_SPIRAL_2_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_JET_SPIRAL_2_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/frame/bezier_chord_shape.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL::Bounding_arcs {

/// A spiral segment of a curve of one's own: a model of SpiralSegment_2 for a model of BoundableCurve_2 over double.
/// `Curve` has `End_jet_2<double> jet(double t) const`. Each coordinate of point, first and second derivative is within
/// `relative_error` times the larger coordinate of that vector of the true one. The caller answers for [first, last]
/// being a spiral: monotone in x, y, tangent angle and curvature, C' != 0.
/// \guarantee as good as the jets: thickness bounds include `relative_error`, and differences of end points cancel
///   for short pieces
template <class Curve> class Jet_spiral_2 {
 public:
  using Number_type = double;
  using Exact_number_type = Bounded_double;  // a curve known in double only has no exact form

  Jet_spiral_2(Curve curve, double first, double last, double relative_error)
      : curve_(std::move(curve)), first_(first), last_(last), relative_error_(relative_error) {
    for (const double t : {first, last})
      size_ = (std::max)({size_, std::fabs(curve_.jet(t).point.x), std::fabs(curve_.jet(t).point.y)});
  }

  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double last() const { return last_; }
  template <class T = double> [[nodiscard]] Xy<T> point(double t) const { return convert<T>(curve_.jet(t).point); }
  [[nodiscard]] double point_error() const { return relative_error_ * size_; }
  [[nodiscard]] double cut_error() const { return 0; }  // the caller's cuts are what they are

  template <class T> [[nodiscard]] Chord_shape_2<T> shape(double t0, double t1, const Shape_parts& = {}) const {
    return chord_frame(jet<T>(t0), jet<T>(t1)).shape;
  }
  template <class T = double>
  [[nodiscard]] Chord_frame_2<T> frame(double t0, double t1, const Shape_parts& = {}) const {
    return chord_frame(jet<T>(t0), jet<T>(t1));
  }

 private:
  template <class T> [[nodiscard]] End_jet_2<T> jet(double t) const {
    const End_jet_2<double> j = curve_.jet(t);
    const auto vector = [this](const Xy<double>& v) {
      const double error = relative_error_ * (std::max)(std::fabs(v.x), std::fabs(v.y));
      if constexpr (std::is_same_v<T, Bounded_double>) return Xy<T>{T(v.x, error), T(v.y, error)};
      else return Xy<T>{T(v.x), T(v.y)};
    };
    return {vector(j.point), vector(j.first), vector(j.second)};
  }

  Curve curve_;
  double first_, last_, relative_error_;
  double size_ = 0;
};

}  // namespace CGAL::Bounding_arcs

#endif

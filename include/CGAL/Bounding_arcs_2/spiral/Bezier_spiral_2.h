// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The spiral segments of Bezier curves: a model of the concept SpiralSegment_2 (doc/concepts.md).

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_BEZIER_SPIRAL_2_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_BEZIER_SPIRAL_2_H

#include <CGAL/Bounding_arcs_2/spiral/make_batch_curve.h>
#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/internal/Exact_number.h>
#include <CGAL/Bounding_arcs_2/spiral/accurate_shape.h>
#include <CGAL/Bounding_arcs_2/spiral/bezier_chord_shape.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {
namespace internal {

/// Rounding in the floating type NT would show in T: T is exact, an enclosure, or a floating type of more digits.
template <class T, class NT>
inline constexpr bool holds_more_v =
    std::is_floating_point_v<NT> &&
    (!std::is_floating_point_v<T> || std::numeric_limits<T>::digits > std::numeric_limits<NT>::digits);

/// A Bezier curve with the difference tables of every number type that constructions ask it for.
template <class NT>
class Tabulated_bezier {
 public:
  using Exact = typename Exact_number<NT>::Type;
  using Plain = std::conditional_t<std::is_floating_point_v<NT>, NT, double>;

  explicit Tabulated_bezier(Bezier_curve_2<NT> curve)
      : curve_(std::move(curve)),
        plain_(curve_, length_unit(curve_)),
        bounded_(curve_, length_unit(curve_)) {
    for (const Xy<NT>& p : curve_.control_points())
      for (const double x : {CGAL::to_double(p.x), CGAL::to_double(p.y)}) size_ = (std::max)(size_, std::fabs(x));
  }

  [[nodiscard]] const Bezier_curve_2<NT>& curve() const { return curve_; }
  /// The largest |coordinate| of a control point.
  [[nodiscard]] double coordinate_size() const { return size_; }

  template <class T>
  [[nodiscard]] const Taylor_table<T>& table() const {
    if constexpr (std::is_same_v<T, Plain>) {
      return plain_;
    } else if constexpr (std::is_same_v<T, Bounded_double>) {
      return bounded_;
    } else if constexpr (std::is_same_v<T, Double_double>) {
      std::call_once(twofold_made_, [this] { twofold_.emplace(curve_, plain_.unit()); });
      return *twofold_;
    } else {
      static_assert(std::is_same_v<T, Exact>, "tables are kept for floating types and for Exact_number<NT>");
      std::call_once(exact_made_, [this] { exact_.emplace(exact_curve(), plain_.unit()); });
      return *exact_;
    }
  }

  /// The curve over the exact number type, every control point converted without error.
  [[nodiscard]] const Bezier_curve_2<Exact>& exact_curve() const {
    std::call_once(exact_curve_made_, [this] { exact_curve_.emplace(make_exact_curve()); });
    return *exact_curve_;
  }

 private:
  [[nodiscard]] Bezier_curve_2<Exact> make_exact_curve() const {
    std::vector<Xy<Exact>> points;
    std::vector<Exact> weights;
    for (const Xy<NT>& p : curve_.control_points())
      points.push_back({Exact_number<NT>::make(p.x), Exact_number<NT>::make(p.y)});
    for (const NT& w : curve_.weights()) weights.push_back(Exact_number<NT>::make(w));
    return Bezier_curve_2<Exact>(std::move(points), std::move(weights));
  }

  Bezier_curve_2<NT> curve_;
  double size_ = 0;
  Taylor_table<Plain> plain_;
  Taylor_table<Bounded_double> bounded_;
  mutable std::once_flag exact_curve_made_, exact_made_, twofold_made_;
  mutable std::optional<Bezier_curve_2<Exact>> exact_curve_;
  mutable std::optional<Taylor_table<Double_double>> twofold_;
  mutable std::optional<Taylor_table<Exact>> exact_;
};

}  // namespace internal

/// A spiral segment [first(), last()] of a Bezier curve, and the chord shapes of its pieces.
/// Cheap to copy: segments of one curve share it.
template <class NT>
class Bezier_spiral_2 {
 public:
  using Number_type = NT;
  using Exact_number_type = typename Exact_number<NT>::Type;

  Bezier_spiral_2(std::shared_ptr<const internal::Tabulated_bezier<NT>> curve, double first, double last,
                  End_orders orders, bool is_straight)
      : curve_(std::move(curve)),
        first_(first),
        last_(last),
        start_(curve_->curve().point(NT(first))),
        end_(curve_->curve().point(NT(last))),
        orders_(orders),
        is_straight_(is_straight) {
    if constexpr (std::is_floating_point_v<NT>) {
      const double u = std::numeric_limits<NT>::epsilon() / 2;
      point_error_ = (3 * curve_->curve().degree() + 1) * (curve_->curve().is_rational() ? 2 : 1) * u * curve_->coordinate_size();
    }
    if (!is_straight) batch_ = internal::make_batch_curve(curve_->template table<internal::Double_double>(), first, last);
  }

  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double last() const { return last_; }
  [[nodiscard]] bool is_straight() const { return is_straight_; }
  /// What batches read of the segment; its pieces are bounded one by one where it has degree 0.
  [[nodiscard]] const internal::Batch_curve& batch_curve() const { return batch_; }
  [[nodiscard]] const Bezier_curve_2<NT>& curve() const { return curve_->curve(); }
  [[nodiscard]] Bezier_curve_2<Exact_number_type> exact_curve() const { return curve_->exact_curve(); }

  /// The curve point at t, the same bits whichever piece asks for it.
  /// \guarantee exact where T or NT is an exact type: a curve over floating numbers is evaluated exactly where T holds
  ///   more than NT, so that the ends of a frame are those of its exact shape; else see point_error
  template <class T = NT>
  [[nodiscard]] Xy<T> point(double t) const {
    if constexpr (internal::holds_more_v<T, NT>) {
      return internal::convert<T>(curve_->exact_curve().point(Exact_number_type(t)));
    } else {
      if (t == first_) return internal::convert<T>(start_);
      return internal::convert<T>(t == last_ ? end_ : curve().point(NT(t)));
    }
  }

  /// A bound on the rounding error of each coordinate of `point` over NT if that is a floating type, 0 over exact ones.
  /// \guarantee (3 degree + 1) u max|P| for polynomial curves, twice that for rational ones (de Casteljau)
  [[nodiscard]] double point_error() const { return point_error_; }

  /// The table of differences behind the shapes over T, one of the number types that tables are kept for.
  template <class T>
  [[nodiscard]] const Taylor_table<T>& table() const { return curve_->template table<T>(); }
  [[nodiscard]] const Taylor_table<Exact_number_type>& exact_table() const { return table<Exact_number_type>(); }
  /// The largest |coordinate| of a control point.
  [[nodiscard]] double coordinate_size() const { return curve_->coordinate_size(); }
  /// How C' behaves at the ends of the piece [t0, t1].
  [[nodiscard]] End_orders orders(double t0, double t1) const {
    return {t0 == first_ ? orders_.start : 1, t1 == last_ ? orders_.end : 1};
  }

  /// The shape of [t0, t1] over number type T: from tables of T for double (NT where that floats), Bounded_double and
  /// Exact_number_type, else converted from the exact shape.
  template <class T>
  [[nodiscard]] Chord_shape_2<T> shape(double t0, double t1, const Shape_parts& parts = {}) const {
    using Curve = internal::Tabulated_bezier<NT>;
    if constexpr (!std::is_same_v<T, typename Curve::Plain> && !std::is_same_v<T, internal::Bounded_double> &&
                  !std::is_same_v<T, internal::Double_double> &&
                  !std::is_same_v<T, Exact_number_type>)
      return convert_shape<T>(shape<Exact_number_type>(t0, t1, parts));
    else
      return shape_from_table<T>(t0, t1, parts);
  }

  /// The shape of [t0, t1] over double, every member within 2 ulp of the true one (vectors in their larger coordinate),
  /// and every sign the true one.  Evaluated in double-doubles and, where their error bound asks for it, exactly.
  [[nodiscard]] Chord_shape_2<double> accurate_shape(double t0, double t1, const Shape_parts& parts = {}) const {
    const auto f = shape<internal::Double_double>(t0, t1, parts);
    if (internal::is_accurate(f, parts.curvature))
      return convert_shape<double>(f, [](const internal::Double_double& x) { return x.hi; });
    return convert_shape<double>(shape<Exact_number_type>(t0, t1, parts));
  }

  /// The frame of [t0, t1] over T; over double from the accurate shape.
  template <class T = NT>
  [[nodiscard]] Chord_frame_2<T> frame(double t0, double t1, const Shape_parts& parts = {}) const {
    if constexpr (std::is_same_v<T, double>) return {point<T>(t0), point<T>(t1), accurate_shape(t0, t1, parts)};
    else return {point<T>(t0), point<T>(t1), shape<T>(t0, t1, parts)};
  }

 private:
  template <class T>
  [[nodiscard]] Chord_shape_2<T> shape_from_table(double t0, double t1, const Shape_parts& parts) const {
    Chord_shape_2<T> f = bezier_chord_shape(curve_->template table<T>(), T(t0), T(t1), parts, orders(t0, t1));
    if (is_straight_) {
      f.cross0 = f.cross1 = f.cross_change = f.curvature0 = f.curvature1 = f.kneser0 = f.kneser1 = T(0);
      f.infinite0 = f.infinite1 = false;
      orient(f);
    }
    return f;
  }

  std::shared_ptr<const internal::Tabulated_bezier<NT>> curve_;
  double first_, last_;
  Xy<NT> start_, end_;
  End_orders orders_;
  bool is_straight_;
  double point_error_ = 0;  // kept, as trees ask each segment for it and should not have to visit its curve
  internal::Batch_curve batch_;
};

namespace internal {

// The order of the first derivative that does not vanish at an end: one more than the control points that coincide.
template <class NT>
[[nodiscard]] int end_order(const std::vector<Xy<NT>>& points, bool at_start) {
  const std::size_t n = points.size();
  std::size_t k = 1;
  while (k + 1 < n && (at_start ? points[k] == points[0] : points[n - 1 - k] == points[n - 1])) ++k;
  return static_cast<int>(k);
}

}  // namespace internal

/// The spiral segments of a curve, in order, tiling [0, 1] without a gap.
/// \guarantee no cut is missed: see spiral_parameters
template <class NT>
[[nodiscard]] std::vector<Bezier_spiral_2<NT>> spiral_segments(const Bezier_curve_2<NT>& curve) {
  const Spiral_parameters cuts = spiral_parameters(curve);
  const auto shared = std::make_shared<const internal::Tabulated_bezier<NT>>(curve);
  constexpr int CUSP_ORDER = 2;  // an ordinary cusp; higher orders inside a curve are not told apart
  std::vector<Bezier_spiral_2<NT>> spirals;
  double first = 0;
  int start = internal::end_order(curve.control_points(), true);
  for (std::size_t i = 0; i < cuts.breaks.size(); ++i) {
    const int order = cuts.singular[i] ? CUSP_ORDER : 1;
    spirals.emplace_back(shared, first, cuts.breaks[i], End_orders{start, order}, cuts.is_straight);
    first = cuts.breaks[i];
    start = order;
  }
  spirals.emplace_back(shared, first, 1.0, End_orders{start, internal::end_order(curve.control_points(), false)},
                       cuts.is_straight);
  return spirals;
}

}  // namespace CGAL::Bounding_arcs

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The spiral segments of Bezier curves: a model of the concept SpiralSegment_2 (doc/concepts.md).  A segment is two
// parameters and its curve, which it shares with the others of that curve (Tabulated_bezier); place() says which curve
// of a drawing that is.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_BEZIER_SPIRAL_2_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_BEZIER_SPIRAL_2_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/curve/served_range.h>
#include <CGAL/Bounding_arcs_2/frame/accurate_shape.h>
#include <CGAL/Bounding_arcs_2/frame/bezier_chord_shape.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/Tabulated_bezier.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {
/// Rounding in the floating type NT would show in T: T is exact, an enclosure, or a floating type of more digits.
template <class T, class NT>
inline constexpr bool holds_more_v = std::is_floating_point_v<NT> &&
                                     (!std::is_floating_point_v<T> ||
                                      std::numeric_limits<T>::digits > std::numeric_limits<NT>::digits);

/// A spiral segment [first(), last()] of a Bezier curve, and the chord shapes of its pieces.
/// Cheap to copy: segments of one curve share it.
/// \code
/// for (const Bezier_spiral_2<double>& spiral : spiral_segments(curve))
///   std::cout << "from " << spiral.first() << " to " << spiral.last() << '\n';
/// \endcode
template <class NT> class Bezier_spiral_2 {
 public:
  using Number_type = NT;
  using Exact_number_type = typename Exact_number<NT>::Type;

  /// The points of a segment at first() and last(), as Tabulated_bezier rounds them.
  struct End_points {
    Xy<NT> start, end;
  };

  Bezier_spiral_2(const std::shared_ptr<const Tabulated_bezier<NT>>& curve, double first, double last,
                  const End_orders& orders, bool is_straight, const Segment_place& place = {})
      : Bezier_spiral_2(curve, first, last, orders, is_straight, place,
                        [&](double from, double to) { return internal::kept_local_curve_of(*curve, from, to); },
                        {curve->end_point(first), curve->end_point(last)}) {}
  /// Makes a segment; segments of a curve can share what makes their local curves, and the points in which they meet.
  /// \param local_curves local_curves(first, last) -> Kept_local_curve
  template <class LocalCurves>
  Bezier_spiral_2(std::shared_ptr<const Tabulated_bezier<NT>> curve, double first, double last,
                  const End_orders& orders, bool is_straight, const Segment_place& place,
                  const LocalCurves& local_curves, const End_points& points);

  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double last() const { return last_; }
  [[nodiscard]] bool is_straight() const { return is_straight_; }
  /// Which Bezier piece of which curve it is a part of, and why it ends where it does.
  [[nodiscard]] const Segment_place& place() const { return place_; }
  /// The segment about its middle in doubles, with error bounds; of kind 0 where there is none.
  [[nodiscard]] Segment_curve local_curve() const { return {local_, local_key_, first_, last_, curve_->unit()}; }
  [[nodiscard]] const Bezier_curve_2<NT>& curve() const { return curve_->curve(); }
  [[nodiscard]] Bezier_curve_2<Exact_number_type> exact_curve() const;

  /// The curve point at t, the same bits whichever piece asks for it.
  /// \guarantee exact where T or NT is an exact type: a curve over floating numbers is evaluated exactly where T holds
  ///   more than NT, so that the ends of a frame are those of its exact shape; else see point_error
  template <class T = NT> [[nodiscard]] Xy<T> point(double t) const {
    if constexpr (holds_more_v<T, NT>) {
      return convert<T>(curve_->exact_curve().point(Exact_number_type(t)));
    } else {
      if (t == first_) return convert<T>(points_.start);
      return convert<T>(t == last_ ? points_.end : curve().point(NT(t)));
    }
  }

  /// The curve point at t as that of an end, see Tabulated_bezier.
  [[nodiscard]] Xy<NT> end_point(double t) const { return curve_->end_point(t); }
  /// A bound on the rounding error of each coordinate of `point` over NT if that is a floating type, 0 over exact ones.
  /// \guarantee (3 degree + 1) u max|P| for polynomial curves, twice that for rational ones (de Casteljau)
  [[nodiscard]] double point_error() const { return point_error_; }
  /// How far the curve runs within the width of a cut beside first() and last(): where weights differ much, parameters
  /// are coarser than coordinates, and what happens there may be missing. 0 for polynomial curves, where it is some
  /// ulp.
  [[nodiscard]] double cut_error() const { return cut_error_; }

  /// The table of differences behind the shapes over T, one of the number types that tables are kept for.
  template <class T> [[nodiscard]] const Taylor_table<T>& table() const { return curve_->template table<T>(); }
  [[nodiscard]] const Taylor_table<Exact_number_type>& exact_table() const { return table<Exact_number_type>(); }
  /// The largest |coordinate| of a control point.
  [[nodiscard]] double coordinate_size() const { return curve_->coordinate_size(); }
  /// How C' behaves at the ends of the piece [t0, t1].
  [[nodiscard]] End_orders orders(double t0, double t1) const {
    End_orders r;
    if (t0 == first_) {
      r.start = orders_.start;
      r.start_bend = orders_.start_bend;
    }
    if (t1 == last_) {
      r.end = orders_.end;
      r.end_bend = orders_.end_bend;
    }
    return r;
  }

  /// The shape of [t0, t1] over number type T: from tables of T for double (NT where that floats), Bounded_double and
  /// Exact_number_type, else converted from the exact shape.
  template <class T> [[nodiscard]] Chord_shape_2<T> shape(double t0, double t1, const Shape_parts& parts = {}) const {
    using Curve = Tabulated_bezier<NT>;
    if constexpr (!std::is_same_v<T, typename Curve::Plain> && !std::is_same_v<T, Bounded_double> &&
                  !std::is_same_v<T, Double_double> && !std::is_same_v<T, Exact_number_type>)
      return shape<Exact_number_type>(t0, t1, parts).template over<T>();
    else return shape_from_table<T>(t0, t1, parts);
  }

  /// The shape of [t0, t1] over double, every member within 0.51 ulp of the true one (vectors in their larger
  /// coordinate), and every sign the true one.  Evaluated in double-doubles and, where their error bound asks for it,
  /// exactly.
  [[nodiscard]] Chord_shape_2<double> accurate_shape(double t0, double t1, const Shape_parts& parts = {}) const;

  /// The frame of [t0, t1] over T; over double from the accurate shape.
  template <class T = NT>
  [[nodiscard]] Chord_frame_2<T> frame(double t0, double t1, const Shape_parts& parts = {}) const {
    if constexpr (std::is_same_v<T, double>) return {point<T>(t0), point<T>(t1), accurate_shape(t0, t1, parts)};
    else return {point<T>(t0), point<T>(t1), shape<T>(t0, t1, parts)};
  }

 private:
  // An end of the curve, t, where control points coincide: its tangent vector is 0, and no batch takes it for a
  // direction.
  [[nodiscard]] bool is_double_end(double t, double end) const;
  // An upper bound of the distance of C(t) from the curve's points up to CUT_WIDTH before (side -1) or behind it (+1).
  [[nodiscard]] double way_beside(double t, int side) const;

  template <class T>
  [[nodiscard]] Chord_shape_2<T> shape_from_table(double t0, double t1, const Shape_parts& parts) const;

  std::shared_ptr<const Tabulated_bezier<NT>> curve_;
  double first_, last_;
  End_points points_;
  End_orders orders_;
  Segment_place place_;
  bool is_straight_;
  Stored_local_curve::Key local_key_;
  double cut_error_ = 0;
  double point_error_ = 0;  // kept, as trees ask each segment for it and should not have to visit its curve
  Stored_local_curve local_;
};

template <class NT>
template <class LocalCurves>
Bezier_spiral_2<NT>::Bezier_spiral_2(std::shared_ptr<const Tabulated_bezier<NT>> curve, double first, double last,
                                     const End_orders& orders, bool is_straight, const Segment_place& place,
                                     const LocalCurves& local_curves, const End_points& points)
    : curve_(std::move(curve)), first_(first), last_(last), points_(points), orders_(orders), place_(place),
      is_straight_(is_straight) {
  if constexpr (std::is_floating_point_v<NT>) {
    const double u = std::numeric_limits<NT>::epsilon() / 2;
    point_error_ =
        (3 * curve_->curve().degree() + 1) * (curve_->curve().is_rational() ? 2 : 1) * u * curve_->coordinate_size();
  }
  if (curve_->curve().is_rational()) cut_error_ = (std::max)(way_beside(first, 1), way_beside(last, -1));
  // the local curve takes the tangents at the ends for what they are
  const bool has_tangents =
      (orders.start == 1 || is_double_end(first, 0)) && (orders.end == 1 || is_double_end(last, 1));
  if (is_straight || !has_tangents) return;
  Kept_local_curve local = local_curves(first, last);
  local_ = std::move(local.numbers);
  local_key_ = local.key;
}

template <class NT> auto Bezier_spiral_2<NT>::exact_curve() const -> Bezier_curve_2<Exact_number_type> {
  return curve_->exact_curve();
}

template <class NT>
Chord_shape_2<double> Bezier_spiral_2<NT>::accurate_shape(double t0, double t1, const Shape_parts& parts) const {
  const auto f = shape<Double_double>(t0, t1, parts);
  if (is_accurate(f, parts.curvature))
    return in_range(f).template over<double>([](const Double_double& x) { return x.hi; });
  return in_range(shape<Exact_number_type>(t0, t1, parts)).template over<double>([](const Exact_number_type& x) {
    return to_double_double(x).hi;
  });
}

template <class NT> bool Bezier_spiral_2<NT>::is_double_end(double t, double end) const {
  const auto& p = curve_->curve().control_points();
  return t == end && p.size() > 1 && (end == 0 ? p[0] == p[1] : p[p.size() - 1] == p[p.size() - 2]);
}

template <class NT> double Bezier_spiral_2<NT>::way_beside(double t, int side) const {
  using Plain = typename Tabulated_bezier<NT>::Plain;
  const Taylor_table<Plain>& table = curve_->template table<Plain>();
  const double other = std::clamp(t + side * CUT_WIDTH, 0.0, 1.0);
  const auto piece = internal::relative_piece(table, Plain(t), Plain(other));
  Plain way = 0, weight = piece.w[0];
  for (std::size_t k = 1; k < piece.m.size(); ++k) {
    way += stable_norm(piece.m[k]);
    weight -= std::fabs(piece.w[k]);
  }
  const auto error = static_cast<double>(way / (piece.w[0] * weight) * Plain(table.unit()));
  return weight > 0 && !std::isnan(error) ? error : std::numeric_limits<double>::infinity();
}

template <class NT>
template <class T>
Chord_shape_2<T> Bezier_spiral_2<NT>::shape_from_table(double t0, double t1, const Shape_parts& parts) const {
  Chord_shape_2<T> f = bezier_chord_shape(curve_->template table<T>(), T(t0), T(t1), parts, orders(t0, t1));
  if (is_straight_) {  // the chord, whose direction derivatives need not have where the curve turns back on itself
    f.tangent0 = f.tangent1 = f.chord;
    f.tangent_change = {};
    f.cross0 = f.cross1 = f.cross_change = f.curvature0 = f.curvature1 = f.kneser0 = f.kneser1 = T(0);
    f.infinite0 = f.infinite1 = false;
    internal::orient(f);
  }
  return f;
}

namespace internal {

// The curve's Taylor vectors about t, up to a common factor, each times its power of a unit parameter. They are made
// from the piece between t and half a unit beside it, inside [0, 1]: outside, the weight may vanish.
template <class T> [[nodiscard]] Coefficients<Xy<T>> taylor_vectors(const Taylor_table<T>& table, double t) {
  const double step = t < 0.5 ? 0.5 : -0.5;
  auto about_t = relative_piece(table, T(t), T(T(t) + T(step))).m;
  double factor = 1;
  for (std::size_t k = 1; k < about_t.size(); ++k) {
    factor /= step;
    about_t[k] = T(factor) * about_t[k];
  }
  return about_t;
}

// The order of the first derivative that does not vanish within CUT_WIDTH of t, as far as its Taylor vector and the
// next tell: a tangent that turns within that width tells nothing of the curve beside it.
[[nodiscard]] std::int16_t tangent_order(const Taylor_table<Double_double>& table, double t);

// The width of parameter within which a bend is none if the next one exceeds it; see End_orders. A fold whose control
// points are rounded has a third derivative of some ulp, and is no cusp for that. Wider, and curvatures are off by more
// than proofs widen them by (2^-44); 32 times narrower, and folds of degree 6 are taken for cusps.
inline constexpr double BEND_WIDTH = 0x1p-46;

template <class Exact>
[[nodiscard]] std::int16_t bend_order(const Taylor_table<Exact>& table, double t, std::int16_t order) {
  const auto about_t = taylor_vectors(table, t);
  const auto first = static_cast<std::size_t>(order);
  const auto size = [&](std::size_t j) {
    return j < about_t.size() ? Exact(CGAL::abs(Exact(cross(about_t[first], about_t[j])))) : Exact(0);
  };
  for (std::size_t j = first + 1; j < about_t.size(); ++j)
    if (size(j) > Exact(static_cast<double>(j + 1) * BEND_WIDTH) * size(j + 1)) return static_cast<std::int16_t>(j);
  return 0;
}

// Appends the spiral segments of a curve between its cuts. \pre it is served
// \param tangent_order_at tangent_order_at(t), see End_orders
template <class NT, class Order, class LocalCurves>
void add_segments(const std::shared_ptr<const Tabulated_bezier<NT>>& shared, const Spiral_parameters& cuts,
                  const Segment_place& place, const Order& tangent_order_at, const LocalCurves& local_curves,
                  std::vector<Bezier_spiral_2<NT>>& spirals) {
  struct End {
    double t;
    Xy<NT> point;
    std::int16_t order, bend;
    Cut_reason reason;
  };
  const auto end_at = [&](double t, Cut_reason reason) {
    const std::int16_t order = tangent_order_at(t);
    const bool may_bend = order > 1 && !cuts.is_straight;
    return End{
        t, shared->end_point(t), order,
        may_bend ? bend_order(shared->template table<typename Exact_number<NT>::Type>(), t, order) : std::int16_t(0),
        reason};
  };
  End first = end_at(0, place.first);
  const auto add = [&](const End& last) {
    spirals.emplace_back(shared, first.t, last.t, End_orders{first.order, last.order, first.bend, last.bend},
                         cuts.is_straight, Segment_place{place.curve, place.bezier, first.reason, last.reason},
                         local_curves, typename Bezier_spiral_2<NT>::End_points{first.point, last.point});
    first = last;
  };
  for (std::size_t i = 0; i < cuts.breaks.size(); ++i) add(end_at(cuts.breaks[i], cuts.reasons[i]));
  add(end_at(1, place.last));
}

template <class NT>
void add_spiral_segments(const Bezier_curve_2<NT>& curve, const Spiral_parameters& cuts, const Segment_place& place,
                         std::vector<Bezier_spiral_2<NT>>& spirals) {
  const auto shared = std::make_shared<const Tabulated_bezier<NT>>(curve);
  const auto& table = shared->template table<Double_double>();
  add_segments(
      shared, cuts, place, [&](double t) { return tangent_order(table, t); },
      [&](double first, double last) { return kept_local_curve(table, first, last); }, spirals);
}
template <>
void add_spiral_segments(const Bezier_curve_2<double>& curve, const Spiral_parameters& cuts, const Segment_place& place,
                         std::vector<Bezier_spiral_2<double>>& spirals);

}  // namespace internal

/// The spiral segments of a curve, in order, tiling [0, 1] without a gap.
/// \param place of the curve as a whole: its numbers, and what its ends are
/// \guarantee no cut is missed: see spiral_parameters
/// \throws std::invalid_argument for curves out of the range that is served (served_range.h)
template <class NT>
[[nodiscard]] std::vector<Bezier_spiral_2<NT>> spiral_segments(const Bezier_curve_2<NT>& curve,
                                                               const Segment_place& place = {}) {
  std::vector<Bezier_spiral_2<NT>> spirals;
  internal::check_served(curve);
  internal::add_spiral_segments(curve, spiral_parameters(curve), place, spirals);
  return spirals;
}

namespace internal {
/// Returns what a Bezier piece of a curve is, whose numbers are these.
/// \param curve as Drawing_2 has them
template <class Curve>
[[nodiscard]] Segment_place bezier_place(const Curve& curve, std::uint32_t number, std::uint32_t bezier) {
  const auto at = [&](bool is_end) { return is_end && !curve.is_closed ? Cut_reason::END : Cut_reason::JOINT; };
  return {number, bezier, at(bezier == 0), at(bezier + 1 == curve.beziers.size())};
}

/// Returns the spiral segments of the curves [first, last) of a drawing, in order, between cuts that are told.
/// \param cuts Spiral_parameters of curve i and its Bezier piece j, cuts(i, j)
template <class NT, class Cuts>
[[nodiscard]] std::vector<Bezier_spiral_2<NT>> spirals_between(const Drawing_2<NT>& drawing, std::size_t first,
                                                               std::size_t last, const Cuts& cuts) {
  constexpr std::size_t USUAL = 3;  // segments of a Bezier curve
  last = (std::min)(last, drawing.curves().size());
  std::size_t beziers = 0;
  for (std::size_t i = first; i < last; ++i) beziers += drawing.curves()[i].beziers.size();
  std::vector<Bezier_spiral_2<NT>> spirals;
  spirals.reserve(USUAL * beziers);
  for (std::size_t i = first; i < last; ++i) {
    const auto& curve = drawing.curves()[i];
    for (std::size_t j = 0; j < curve.beziers.size(); ++j)
      internal::add_spiral_segments(curve.beziers[j], cuts(i, j),
                                    bezier_place(curve, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)),
                                    spirals);
  }
  return spirals;
}
}  // namespace internal

/// Returns the spiral segments of the curves [first, last) of a drawing, in order; of all where none are named.
template <class NT>
[[nodiscard]] std::vector<Bezier_spiral_2<NT>> spiral_segments(
    const Drawing_2<NT>& drawing, std::size_t first = 0, std::size_t last = (std::numeric_limits<std::size_t>::max)()) {
  return internal::spirals_between(drawing, first, last, [&](std::size_t i, std::size_t j) {
    const Bezier_curve_2<NT>& piece = drawing.curves()[i].beziers[j];
    internal::check_served(piece);
    return spiral_parameters(piece);
  });
}

/// Returns the spiral segments of a B-spline curve.
template <class NT> [[nodiscard]] std::vector<Bezier_spiral_2<NT>> spiral_segments(const B_spline_curve_2<NT>& curve) {
  Drawing_2<NT> drawing;
  drawing.add(curve);
  return spiral_segments(drawing);
}

#ifndef DOXYGEN
// compiled in the library
extern template class Tabulated_bezier<double>;
extern template const Taylor_table<double>& Tabulated_bezier<double>::table() const;
extern template const Taylor_table<Bounded_double>& Tabulated_bezier<double>::table() const;
extern template const Taylor_table<Double_double>& Tabulated_bezier<double>::table() const;
extern template const Taylor_table<Exact_rational>& Tabulated_bezier<double>::table() const;
extern template class Bezier_spiral_2<double>;
extern template Chord_shape_2<double> Bezier_spiral_2<double>::shape_from_table(double, double,
                                                                                const Shape_parts&) const;
extern template Chord_shape_2<Bounded_double> Bezier_spiral_2<double>::shape_from_table(double, double,
                                                                                        const Shape_parts&) const;
extern template Chord_shape_2<Double_double> Bezier_spiral_2<double>::shape_from_table(double, double,
                                                                                       const Shape_parts&) const;
extern template Chord_shape_2<Exact_rational> Bezier_spiral_2<double>::shape_from_table(double, double,
                                                                                        const Shape_parts&) const;
extern template std::vector<Bezier_spiral_2<double>> spiral_segments(const Bezier_curve_2<double>&,
                                                                     const Segment_place&);
extern template std::vector<Bezier_spiral_2<double>> spiral_segments(const Drawing_2<double>&, std::size_t,
                                                                     std::size_t);
#endif

}  // namespace CGAL::Bounding_arcs

#endif

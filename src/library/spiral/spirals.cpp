// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spiral segments of Bezier curves over double, once for all programs.

#include "accurate_point.h"
#include "make_local_curve.h"

#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace CGAL::Bounding_arcs {

template void internal::check_served(const Bezier_curve_2<double>&);

template <> Xy<double> Tabulated_bezier<double>::end_point(double t) const {
  constexpr double MOST = 0x1p900, LEAST = 0x1p-900;  // beyond, products of parts leave the range of double
  constexpr double MOST_WEIGHT = 0x1p60, LEAST_WEIGHT = 0x1p-60;
  const bool is_rational = curve_.is_rational(), is_quick = curve_kind(curve_.degree(), is_rational) != 0,
             is_in_range = size_ <= MOST && size_ >= LEAST;
  if (is_quick && is_in_range && curve_.degree() >= 1) {
    if (!is_rational) return accurate_point(curve_, t);
    const auto [least, most] = std::minmax_element(curve_.weights().begin(), curve_.weights().end());
    if (*least >= LEAST_WEIGHT && *most <= MOST_WEIGHT) return accurate_rational_point(curve_, t);
  }
  return curve_.point(t);
}

namespace internal {
namespace {

/// Makes the local curves of the segments of one curve, which must outlive it.
class Local_curves {
 public:
  explicit Local_curves(const Tabulated_bezier<double>& curve) : curve_(curve) {
    if (curve.curve().degree() == 3 && !curve.curve().is_rational()) cubic_.emplace(curve.curve(), curve.unit());
  }

  [[nodiscard]] Kept_local_curve operator()(double first, double last) const {
    if (cubic_) return kept((*cubic_)(first, last));
    return kept_local_curve(curve_.table<Double_double>(), first, last);
  }

 private:
  const Tabulated_bezier<double>& curve_;
  std::optional<Cubic_local_curves> cubic_;
};

// Whether C' is found in doubles so far from 0 that tangent_order is 1, a filter for it. With differences of control
// points up to L and n the degree, C' / n comes from n - 1 rounds of three roundings and one of the differences, each
// of u L at most; C'' / 2 is n (n - 1) L at most and asked to be n / (2 CUT_WIDTH) = n / (8 u) times smaller.
bool has_ordinary_tangent(const Bezier_curve_2<double>& curve, double t) {
  constexpr double LEAST_SIZE = 0x1p-900;  // below, roundings are not in proportion
  constexpr double BLENDS = 3, SUBTRACTION = 1, BEND = 8, SECOND_ORDER = 1, PER_DEGREE = 13, U = HALF_ULP;
  static_assert(PER_DEGREE == BLENDS + SUBTRACTION + BEND + SECOND_ORDER && BEND * U == 2 * CUT_WIDTH,
                "update the derivation above");
  if (curve.is_rational()) return false;
  const auto& p = curve.control_points();
  boost::container::small_vector<Xy<double>, 8> d(p.size() - 1);
  double size = 0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    d[i] = p[i + 1] - p[i];
    size = (std::max)({size, std::fabs(d[i].x), std::fabs(d[i].y)});
  }
  const double s = 1 - t;
  for (std::size_t n = d.size() - 1; n > 0; --n)
    for (std::size_t i = 0; i < n; ++i) d[i] = s * d[i] + t * d[i + 1];
  return size > LEAST_SIZE && (std::max)(std::fabs(d[0].x), std::fabs(d[0].y)) > PER_DEGREE * curve.degree() * U * size;
}

}  // namespace

// The order of the first derivative that does not vanish within CUT_WIDTH of t, as far as its Taylor vector and the
// next tell: a tangent that turns within that width tells nothing of the curve beside it.
std::int16_t tangent_order(const Taylor_table<Double_double>& table, double t) {
  const auto about_t = taylor_vectors(table, t);
  const auto size = [&](std::size_t k) {
    return k < about_t.size() ? (std::max)(std::fabs(about_t[k].x.hi), std::fabs(about_t[k].y.hi)) : 0.0;
  };
  for (std::size_t k = 1; k < about_t.size(); ++k)
    if (size(k) > static_cast<double>(k + 1) * CUT_WIDTH * size(k + 1)) return static_cast<std::int16_t>(k);
  return 1;  // a point
}

template <> Kept_local_curve kept_local_curve_of(const Tabulated_bezier<double>& curve, double first, double last) {
  return Local_curves(curve)(first, last);
}

template <>
void add_spiral_segments(const Bezier_curve_2<double>& curve, const Spiral_parameters& cuts, const Segment_place& place,
                         std::vector<Bezier_spiral_2<double>>& spirals) {
  const auto shared = std::make_shared<const Tabulated_bezier<double>>(curve);
  const auto order = [&](double t) {
    return has_ordinary_tangent(curve, t) ? std::int16_t(1) : tangent_order(shared->table<Double_double>(), t);
  };
  add_segments(shared, cuts, place, order, Local_curves(*shared), spirals);
}

}  // namespace internal

template class Tabulated_bezier<double>;
template const Taylor_table<double>& Tabulated_bezier<double>::table() const;
template const Taylor_table<Bounded_double>& Tabulated_bezier<double>::table() const;
template const Taylor_table<Double_double>& Tabulated_bezier<double>::table() const;
template const Taylor_table<Exact_rational>& Tabulated_bezier<double>::table() const;

template class Bezier_spiral_2<double>;
template Chord_shape_2<double> Bezier_spiral_2<double>::shape_from_table(double, double, const Shape_parts&) const;
template Chord_shape_2<Bounded_double> Bezier_spiral_2<double>::shape_from_table(double, double,
                                                                                 const Shape_parts&) const;
template Chord_shape_2<Double_double> Bezier_spiral_2<double>::shape_from_table(double, double,
                                                                                const Shape_parts&) const;
template Chord_shape_2<Exact_rational> Bezier_spiral_2<double>::shape_from_table(double, double,
                                                                                 const Shape_parts&) const;
template std::vector<Bezier_spiral_2<double>> spiral_segments(const Bezier_curve_2<double>&, const Segment_place&);
template std::vector<Bezier_spiral_2<double>> spiral_segments(const Drawing_2<double>&, std::size_t, std::size_t);

}  // namespace CGAL::Bounding_arcs

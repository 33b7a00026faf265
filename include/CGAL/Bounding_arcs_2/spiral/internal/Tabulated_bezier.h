// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the spiral segments of one Bezier curve share: the curve, its difference tables in every number type that is
// asked for, and what makes their local curves.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_TABULATED_BEZIER_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_TABULATED_BEZIER_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/frame/Taylor_table.h>
#include <CGAL/Bounding_arcs_2/frame/bezier_chord_shape.h>
#include <CGAL/Bounding_arcs_2/number/Bounded_double.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/Made_once.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/Stored_local_curve.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A Bezier curve with the difference tables of every number type that constructions ask it for.
template <class NT> class Tabulated_bezier {
 public:
  using Exact = typename Exact_number<NT>::Type;
  using Plain = std::conditional_t<std::is_floating_point_v<NT>, NT, double>;

  explicit Tabulated_bezier(Bezier_curve_2<NT> curve);

  [[nodiscard]] const Bezier_curve_2<NT>& curve() const { return curve_; }
  /// The largest |coordinate| of a control point.
  [[nodiscard]] double coordinate_size() const { return size_; }
  /// The unit of all tables.
  [[nodiscard]] double unit() const { return unit_; }

  template <class T> [[nodiscard]] const Taylor_table<T>& table() const;
  /// A point in which segments may end, rounded from twice the digits where that is quick.
  [[nodiscard]] Xy<NT> end_point(double t) const { return curve_.point(NT(t)); }

  /// The curve over the exact number type, every control point converted without error.
  [[nodiscard]] const Bezier_curve_2<Exact>& exact_curve() const {
    return exact_curve_([this] { return make_exact_curve(); });
  }

 private:
  [[nodiscard]] Bezier_curve_2<Exact> make_exact_curve() const;

  Bezier_curve_2<NT> curve_;
  double size_ = 0, unit_;
  internal::Made_once<Bezier_curve_2<Exact>> exact_curve_;
  internal::Made_once<Taylor_table<Plain>> plain_;
  internal::Made_once<Taylor_table<Bounded_double>> bounded_;
  internal::Made_once<Taylor_table<Double_double>> twofold_;
  internal::Made_once<Taylor_table<Exact>> exact_;
};

template <class NT>
Tabulated_bezier<NT>::Tabulated_bezier(Bezier_curve_2<NT> curve)
    : curve_(std::move(curve)), unit_(length_unit(curve_)) {
  for (const Xy<NT>& p : curve_.control_points())
    for (const double x : {CGAL::to_double(p.x), CGAL::to_double(p.y)}) size_ = (std::max)(size_, std::fabs(x));
}

template <class NT> template <class T> const Taylor_table<T>& Tabulated_bezier<NT>::table() const {
  // for T only, as not every number type of a curve has a conversion to the exact one
  const auto make = [this](const auto& curve) { return [&curve, this] { return Taylor_table<T>(curve, unit_); }; };
  if constexpr (std::is_same_v<T, Plain>) {
    return plain_(make(curve_));
  } else if constexpr (std::is_same_v<T, Bounded_double>) {
    return bounded_(make(curve_));
  } else if constexpr (std::is_same_v<T, Double_double>) {
    return twofold_(make(curve_));
  } else {
    static_assert(std::is_same_v<T, Exact>, "tables are kept for floating types and for Exact_number<NT>");
    return exact_(make(exact_curve()));
  }
}

template <> Xy<double> Tabulated_bezier<double>::end_point(double t) const;

template <class NT> auto Tabulated_bezier<NT>::make_exact_curve() const -> Bezier_curve_2<Exact> {
  std::vector<Xy<Exact>> points;
  std::vector<Exact> weights;
  for (const Xy<NT>& p : curve_.control_points())
    points.push_back({Exact_number<NT>::make(p.x), Exact_number<NT>::make(p.y)});
  for (const NT& w : curve_.weights()) weights.push_back(Exact_number<NT>::make(w));
  return Bezier_curve_2<Exact>(std::move(points), std::move(weights));
}

namespace internal {

/// Expands a curve about the middle of a segment; no kind where its degree has none.
[[nodiscard]] Kept_local_curve kept_local_curve(const Taylor_table<Double_double>& table, double first, double last);
/// Expands the curve of a table.
template <class NT>
[[nodiscard]] Kept_local_curve kept_local_curve_of(const Tabulated_bezier<NT>& curve, double first, double last) {
  return kept_local_curve(curve.template table<Double_double>(), first, last);
}
template <> Kept_local_curve kept_local_curve_of(const Tabulated_bezier<double>& curve, double first, double last);

}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The unit in which a drawing is searched: a power of two near its largest coordinate, so that products of some lengths
// are far from both ends of the range of double.  Numbers are the same bits in any unit.  A drawing whose largest
// coordinate is between 2^-40 and 2^41 has the unit 1: nothing is scaled, and nothing is lost in time.
//
//   drawing, points, tolerances  --in-->  search near unit size  --out-->  points, bounds

#ifndef CGAL_BOUNDING_ARCS_2_CURVE_UNIT_H
#define CGAL_BOUNDING_ARCS_2_CURVE_UNIT_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// The unit in which a drawing is searched: a power of two near its largest coordinate, so that products of some
/// lengths are far from both ends of the range of double. Numbers are the same bits in any unit.
class Unit {
 public:
  Unit() = default;
  /// Returns the unit of numbers of which the largest has this size.
  [[nodiscard]] static Unit of_size(double largest) {
    constexpr int ORDINARY = 40;  // six lengths and as many small details of them stay normal numbers
    Unit unit;
    if (largest > 0 && std::isfinite(largest)) unit.exponent_ = std::ilogb(largest);
    return std::abs(unit.exponent_) <= ORDINARY ? Unit() : unit;
  }

  [[nodiscard]] bool is_one() const { return exponent_ == 0; }
  friend bool operator==(const Unit& a, const Unit& b) { return a.exponent_ == b.exponent_; }
  friend bool operator<(const Unit& a, const Unit& b) { return a.exponent_ < b.exponent_; }

  /// A length in this unit; with the power 2 an area, with -1 a curvature.
  [[nodiscard]] double in(double x, int power = 1) const { return is_one() ? x : std::scalbn(x, -power * exponent_); }
  [[nodiscard]] Xy<double> in(const Xy<double>& p) const { return {in(p.x), in(p.y)}; }
  /// Back again.
  [[nodiscard]] double out(double x, int power = 1) const { return is_one() ? x : std::scalbn(x, power * exponent_); }
  [[nodiscard]] Xy<double> out(const Xy<double>& p) const { return {out(p.x), out(p.y)}; }
  /// Whether a number comes back as it was.
  [[nodiscard]] bool keeps(double x) const { return out(in(x)) == x; }
  [[nodiscard]] bool keeps(const Xy<double>& p) const { return keeps(p.x) && keeps(p.y); }

  /// Exact numbers in this unit, and back again.
  template <class NT> [[nodiscard]] NT exactly_in(const NT& x) const { return exactly_times(x, -exponent_); }
  template <class NT> [[nodiscard]] NT exactly_out(const NT& x) const { return exactly_times(x, exponent_); }

  /// A tolerance, which no unit makes 0 or infinite.
  [[nodiscard]] double tolerance_in(double x, int power = 1) const {
    constexpr double LEAST = 0x1p-1000, MOST = 0x1p500;
    if (is_one() || !(x > 0) || !std::isfinite(x)) return x;
    return std::clamp(in(x, power), LEAST, MOST);
  }
  /// Lower and upper bounds back again, which are rounded outwards at the ends of the range of double.
  template <class Bounds> [[nodiscard]] Bounds bounds_out(Bounds b, int power = 1) const {
    if (is_one()) return b;
    constexpr double INFINITE = std::numeric_limits<double>::infinity();
    const auto rounded = [&](double x, double to) {
      const double y = out(x, power);
      return in(y, power) == x ? y : std::nextafter(y, to);
    };
    b.lower = b.lower >= 0 ? (std::max)(0.0, rounded(b.lower, -INFINITE)) : rounded(b.lower, -INFINITE);
    b.upper = rounded(b.upper, INFINITE);
    return b;
  }

 private:
  template <class NT> [[nodiscard]] static NT exactly_times(NT x, int exponent) {
    constexpr int STEP = 1000;  // of powers that are doubles
    for (; exponent > STEP; exponent -= STEP) x = NT(x * NT(std::ldexp(1.0, STEP)));
    for (; exponent < -STEP; exponent += STEP) x = NT(x * NT(std::ldexp(1.0, -STEP)));
    return exponent == 0 ? x : NT(x * NT(std::ldexp(1.0, exponent)));
  }

  int exponent_ = 0;
};

/// Returns the unit of a curve's weights, of which only ratios matter.
template <class NT> [[nodiscard]] Unit unit_of_weights(const Bezier_curve_2<NT>& curve) {
  double most = 0;
  for (const NT& w : curve.weights()) most = (std::max)(most, CGAL::to_double(w));
  return Unit::of_size(most);
}

/// The curve in a unit, and its weights in theirs.
template <class NT> [[nodiscard]] Bezier_curve_2<NT> scaled(const Bezier_curve_2<NT>& curve, const Unit& unit) {
  const auto in = [](const NT& x, const Unit& u) {
    if constexpr (std::is_same_v<NT, double>) return u.in(x);
    else return u.exactly_in(x);
  };
  std::vector<Xy<NT>> points;
  points.reserve(curve.control_points().size());
  for (const Xy<NT>& p : curve.control_points()) points.push_back({in(p.x, unit), in(p.y, unit)});
  std::vector<NT> weights;
  const Unit of_weights = unit_of_weights(curve);
  for (const NT& w : curve.weights()) weights.push_back(in(w, of_weights));
  return Bezier_curve_2<NT>(std::move(points), std::move(weights));
}
/// The drawing in a unit; over double rounded where numbers leave its range, see keeps().
template <class NT> [[nodiscard]] Drawing_2<NT> scaled(const Drawing_2<NT>& drawing, const Unit& unit) {
  Drawing_2<NT> result;
  for (const auto& curve : drawing.curves()) {
    std::vector<Bezier_curve_2<NT>> chain;
    chain.reserve(curve.beziers.size());
    for (const auto& piece : curve.beziers) chain.push_back(scaled(piece, unit));
    result.add(std::move(chain), curve.name, curve.parameters);
  }
  return result;
}
/// Whether all points are the same in a unit.
[[nodiscard]] inline bool keeps(const Unit& unit, const Bezier_curve_2<double>& curve) {
  const auto& points = curve.control_points();
  return std::all_of(points.begin(), points.end(), [&](const Xy<double>& p) { return unit.keeps(p); });
}
/// Returns the same of all curves of a drawing.
[[nodiscard]] inline bool keeps(const Unit& unit, const Drawing_2<double>& drawing) {
  for (const auto& curve : drawing.curves())
    for (const auto& piece : curve.beziers)
      if (!keeps(unit, piece)) return false;
  return true;
}
/// Whether scaling changes nothing.
[[nodiscard]] inline bool is_ordinary(const Unit& unit, const Bezier_curve_2<double>& curve) {
  return unit.is_one() && unit_of_weights(curve).is_one();
}
/// Returns the same of all curves of a drawing.
[[nodiscard]] inline bool is_ordinary(const Unit& unit, const Drawing_2<double>& drawing) {
  for (const auto& curve : drawing.curves())
    for (const auto& piece : curve.beziers)
      if (!is_ordinary(unit, piece)) return false;
  return true;
}
}  // namespace CGAL::Bounding_arcs::internal

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A piece of a spiral segment in other numbers: in MPFR enclosures of any precision, from the exact differences of the
// control points, which is quick, or where that leaves a sign open from the exact shape; and in plain numbers.

#ifndef BOUNDING_ARCS_STUDY_ENCLOSED_PIECE_H
#define BOUNDING_ARCS_STUDY_ENCLOSED_PIECE_H

#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>

#include <CGAL/Uncertain.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::study {

/// Bits that enclosures start with and that they end with; each step doubles them.
inline constexpr mpfr_prec_t FIRST_PRECISION = 256, LAST_PRECISION = 1 << 14;

/// A piece of a spiral segment of which enclosures are asked, one precision after the other.
class Enclosed_piece {
 public:
  Enclosed_piece(const Bezier_spiral_2<double>& spiral, double t0, double t1) : spiral_(spiral), t0_(t0), t1_(t1) {}

  /// The exact shape, whose signs are always told.
  [[nodiscard]] const Chord_shape_2<CGAL::Exact_rational>& exact_shape() {
    if (!exact_) exact_ = spiral_.shape<CGAL::Exact_rational>(t0_, t1_);
    return *exact_;
  }
  /// The shape in numbers of so many bits; the same object until another precision is asked for.
  [[nodiscard]] const Chord_shape_2<Mpfr_interval>& shape(mpfr_prec_t bits) {
    if (bits != bits_) enclosure_ = enclosure(bits);
    bits_ = bits;
    return enclosure_;
  }
  /// The shape in the place of the piece.
  [[nodiscard]] Chord_frame_2<Mpfr_interval> frame(mpfr_prec_t bits) {
    const auto curve = this->curve(bits);
    return {curve.point(t0(bits)), curve.point(t1(bits)), shape(bits)};
  }
  /// The curve and its parameters in such numbers.
  [[nodiscard]] Bezier_curve_2<Mpfr_interval> curve(mpfr_prec_t bits) const {
    std::vector<Xy<Mpfr_interval>> points;
    std::vector<Mpfr_interval> weights;
    for (const Xy<double>& p : spiral_.curve().control_points())
      points.push_back({number(p.x, bits), number(p.y, bits)});
    for (const double w : spiral_.curve().weights()) weights.push_back(number(w, bits));
    return Bezier_curve_2<Mpfr_interval>(std::move(points), std::move(weights));
  }
  [[nodiscard]] Mpfr_interval t0(mpfr_prec_t bits) const { return number(t0_, bits); }
  [[nodiscard]] Mpfr_interval t1(mpfr_prec_t bits) const { return number(t1_, bits); }

 private:
  [[nodiscard]] static Mpfr_interval number(const CGAL::Exact_rational& x, mpfr_prec_t bits) {
    return Mpfr_interval(x, bits);
  }
  [[nodiscard]] Chord_shape_2<Mpfr_interval> enclosure(mpfr_prec_t bits) {
    const auto enclosed = [bits](const CGAL::Exact_rational& x) { return number(x, bits); };
    if (!exact_ && !spiral_.is_straight()) {
      const Taylor_table<Mpfr_interval> table(spiral_.exact_table(), enclosed);
      try {
        return bezier_chord_shape(table, t0(bits), t1(bits), {}, spiral_.orders(t0_, t1_));
      } catch (const CGAL::Uncertain_conversion_exception&) {  // a sign that is 0, or too near to it
      }
    }
    return exact_shape().template over<Mpfr_interval>(enclosed);
  }

  const Bezier_spiral_2<double>& spiral_;
  double t0_, t1_;
  std::optional<Chord_shape_2<CGAL::Exact_rational>> exact_;
  mpfr_prec_t bits_ = 0;
  Chord_shape_2<Mpfr_interval> enclosure_;
};

/// The piece [t0, t1] in its place, in T, of a curve in T whose unit of lengths has a number there: as a program
/// without this library's care has it, with no more digits than T.
template <class T>
[[nodiscard]] Chord_frame_2<T> plain_frame(const Bezier_curve_2<T>& curve, const Bezier_spiral_2<double>& spiral,
                                           double t0, double t1, const Shape_parts& parts = {}) {
  const double unit = length_unit(spiral.curve());
  return {curve.point(T(t0)), curve.point(T(t1)),
          bezier_chord_shape(Taylor_table<T>(curve, unit), T(t0), T(t1), parts, spiral.orders(t0, t1))};
}

}  // namespace CGAL::Bounding_arcs::study

#endif

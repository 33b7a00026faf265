// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Area and first moments of closed curves: an exact number, of polynomial pieces and of the chords of rational ones,
// and bounds of what is between these chords and the curves (Rational_part.h). The area between an arc and its chord.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_AREA_SUM_H
#define BOUNDING_ARCS_LIBRARY_QUERY_AREA_SUM_H

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/convert.h>
#include "../curve/Rational_part.h"
#include "../curve/green.h"
#include "../tree/Segment_hierarchy.h"

#include <boost/container/small_vector.hpp>

#include <cmath>
#include <cstdint>
#include <optional>

namespace CGAL::Bounding_arcs::internal {

class Area_sum {
 public:
  Area_sum(const Segment_hierarchy& curves, bool with_moments) {
    if (curves.empty()) return;
    origin_ = curves.piece(0).first.point;
    const auto origin = convert<Exact_rational>(origin_);
    for (std::uint32_t b = 0; b < curves.number_of_beziers(); ++b) {
      const auto curve = curves.exact_bezier(b);
      if (!curve.is_rational()) {
        exact_ += moments_along(curve, origin, with_moments);
        continue;
      }
      const Rational_part part(curve, 0, 1);
      const auto from = convert<Exact_rational>(part.from()), to = convert<Exact_rational>(part.to());
      exact_ += moments_along(curve.control_points().front(), from, origin);
      exact_ += moments_along(from, to, origin);
      exact_ += moments_along(to, curve.control_points().back(), origin);
      const Bounded_moments m = part.beside_chord(origin_);
      least_ += {Exact_rational(m.area.inf()), Exact_rational(m.x.inf()), Exact_rational(m.y.inf())};
      most_ += {Exact_rational(m.area.sup()), Exact_rational(m.x.sup()), Exact_rational(m.y.sup())};
    }
  }

  [[nodiscard]] const Exact_moments& exact() const { return exact_; }
  [[nodiscard]] const Exact_moments& least() const { return least_; }
  [[nodiscard]] const Exact_moments& most() const { return most_; }
  /// What moments are about.
  [[nodiscard]] const Xy<double>& origin() const { return origin_; }

 private:
  Xy<double> origin_;
  Exact_moments exact_, least_, most_;
};

/// 60 times the area between a piece and the segments from an origin to its ends.  With control points P_i seen from
/// any origin the area of a piece of degree n is a sum over i < j of cross(P_i, P_j) with rational factors, which are
/// those of twice the integral of B_i B_j' (Green).
/// \pre a polynomial of degree at most 3
[[nodiscard]] inline Double_double sixty_areas(const Bezier_curve_2<double>& curve, const Xy<double>& origin) {
  // of (0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3): 30 for a segment, 10 (2, 1, 2), 3 (6, 3, 1, 3, 3, 6)
  static constexpr double FACTORS[3][3][4] = {
      {{0, 30}}, {{0, 20, 10}, {0, 0, 20}}, {{0, 18, 9, 3}, {0, 0, 9, 9}, {0, 0, 0, 18}}};
  boost::container::small_vector<Double_double, 4> x, y;
  for (const Xy<double>& p : curve.control_points()) {
    x.push_back(Double_double::two_sum(p.x, -origin.x));
    y.push_back(Double_double::two_sum(p.y, -origin.y));
  }
  Double_double sum;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    Double_double to_x, to_y;
    for (std::size_t j = i + 1; j < x.size(); ++j) {
      const Double_double factor = FACTORS[x.size() - 2][i][j];
      to_x = to_x + factor * x[j];
      to_y = to_y + factor * y[j];
    }
    sum = sum + (x[i] * to_y - y[i] * to_x);
  }
  return sum;
}

/// The area inside closed polynomial curves in pairs of doubles.
/// \return two neighbouring doubles with the exact area between them, or nothing where that is not told, as where it is
///   a double itself, of rational curves, of high degrees and of numbers that are no doubles
/// \pre closed curves
[[nodiscard]] inline std::optional<Bracket> double_double_area(const Segment_hierarchy& curves) {
  constexpr int MOST_DEGREE = 3;
  Double_double sum;
  const Xy<double> origin = curves.piece(0).first.point;
  for (std::uint32_t b = 0; b < curves.number_of_beziers(); ++b) {
    const Bezier_curve_2<double>& curve = curves.bezier(b);
    if (curve.is_rational() || curve.degree() > MOST_DEGREE || curves.rounding(b) != 0) return std::nullopt;
    sum = sum + sixty_areas(curve, origin);
  }
  const Double_double area = sum / Double_double(60);
  // as hi + lo rounds to hi, the exact one is between it and a neighbour
  const bool is_beyond = area.lo > 0;
  const double beside = std::nextafter(area.hi, is_beyond ? HUGE_VAL : -HUGE_VAL);
  const Double_double before = area - Double_double(area.hi), behind = Double_double(beside) - area;
  if (!before.sign() || !behind.sign() || *before.sign() != *behind.sign() || *before.sign() == 0) return std::nullopt;
  return is_beyond ? Bracket{area.hi, beside} : Bracket{beside, area.hi};
}

// The area between an arc and its chord. Over a chord of length L an arc with bulge b has, between them,
//   A = L^2 / (8 b^2) ((1 + b^2)^2 atan b - b (1 - b^2))
//     = L^2 b / 3 (1 + b^2 / 5 - b^4 / 35 + ... + (-1)^k 3 b^(2k-2) / ((2k+1) (2k-1) (2k-3)) + ...),
// from circular sectors with the angle 4 atan b.  It grows with |b|, and is positive for a left turn: run through on
// the arc instead of the chord, a counterclockwise curve has more inside.

/// The factors of the series above, by k; a table, as quotients are not made while it is compiled where rounding
/// counts.
struct Lens_series {
  static constexpr int LAST_TERM = 10;
  double of[LAST_TERM + 1] = {};
  constexpr Lens_series() {
    for (int k = 2; k <= LAST_TERM; ++k) of[k] = (k % 2 == 0 ? 3.0 : -3.0) / ((2 * k + 1) * (2 * k - 1) * (2 * k - 3));
  }
};
inline constexpr Lens_series LENS_SERIES;

/// A / L^2.
/// \guarantee within 100 u of itself: the series errs by its first term left out, 2^-51 of itself, and 20 roundings;
///   the other form has differences that are at least b^2 of what they are made of, which multiplies 6 roundings by 16
[[nodiscard]] inline double lens_share(double b) {
  constexpr double SERIES = 0.25, FLAT = 0x1p-10;  // below that, b^6 is nothing beside 1
  const double square = b * b;
  if (std::fabs(b) > SERIES) {
    const double m = 1 + square;
    return (m * m * std::atan(b) - b * (1 - square)) / (8 * square);
  }
  double sum = 0;
  for (int k = std::fabs(b) < FLAT ? 3 : Lens_series::LAST_TERM; k >= 2; --k) sum = square * (LENS_SERIES.of[k] + sum);
  return b / 3 * (1 + sum);
}
}  // namespace CGAL::Bounding_arcs::internal

#endif

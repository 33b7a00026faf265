// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Area and first moments of closed curves: an exact number and bounds of what is to be added.
//
// Polynomial pieces are integrated exactly.  A rational piece has samples. The chords between these are integrated
// exactly, and between chord and curve is a lens (Lens.h).  The moment of the lens is that of the lens under the arc
// with the mean bulge but for the areas' difference, times the largest coordinate.  The centroid of a lens is over the
// middle of the chord, at 0.4 of its height for flat arcs, growing to 4 / (3 pi) for half a circle.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_AREA_SUM_H
#define BOUNDING_ARCS_LIBRARY_QUERY_AREA_SUM_H

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include "../curve/green.h"
#include "../tree/Segment_hierarchy.h"
#include "Lens.h"
#include "query_units.h"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Area_sum {
 public:
  /// \param tolerance of the area, and of moments divided by the extent
  Area_sum(const Segment_hierarchy& curves, bool with_moments, double tolerance)
      : curves_(curves), with_moments_(with_moments), extent_(extent_of(curves)),
        limit_(most_pieces(curves.number_of_segments())) {
    if (curves.empty()) return;
    origin_ = curves.piece(0).first.point;
    exact_origin_ = exactly(origin_);
    std::vector<Spiral_piece_2> rational;
    for (std::uint32_t s = 0; s < curves.number_of_segments(); ++s) {
      const std::uint32_t bezier = curves.bezier_of(s);
      const bool is_first = s == 0 || curves.bezier_of(s - 1) != bezier;
      if (curves.evaluator(bezier).is_rational()) rational.push_back(curves.piece(s));
      else if (is_first) exact_ += moments_along(curves.exact_bezier(bezier), exact_origin_, with_moments);
      if (is_first && curves.evaluator(bezier).is_rational()) add_ways_to_ends(bezier);
    }
    const auto open = [this](const Spiral_piece_2& p) { return open_of(p); };
    for (const Spiral_piece_2& p : refine_sum(curves, rational, tolerance, open, limit_)) add(p);
  }

  [[nodiscard]] const Exact_moments& exact() const { return exact_; }
  [[nodiscard]] const Exact_moments& least() const { return least_; }
  [[nodiscard]] const Exact_moments& most() const { return most_; }
  /// Whether pieces were left as they were, as there were too many.
  [[nodiscard]] bool is_limited() const { return limit_.is_reached(); }
  /// What moments are about.
  [[nodiscard]] const Xy<double>& origin() const { return origin_; }

 private:
  struct Lens_moments {
    Bracket area, x, y;
  };

  [[nodiscard]] static Xy<Exact_rational> exactly(const Xy<double>& p) {
    return {Exact_rational(p.x), Exact_rational(p.y)};
  }

  // Where control points are no doubles, chords begin and end beside them.
  void add_ways_to_ends(std::uint32_t bezier) {
    if (curves_.rounding(bezier) == 0) return;
    const auto curve = curves_.exact_bezier(bezier);
    const Bezier_evaluator& rounded = curves_.evaluator(bezier);
    exact_ += moments_along(curve.control_points().front(), exactly(rounded(0).point), exact_origin_);
    exact_ += moments_along(exactly(rounded(1).point), curve.control_points().back(), exact_origin_);
  }

  [[nodiscard]] Open_part open_of(const Spiral_piece_2& p) const {
    const Lens lens(p, curves_.error(p.segment));
    const Lens_moments m = lens_moments(lens);
    const double width = m.area.width() + (with_moments_ ? (m.x.width() + m.y.width()) / extent_ : 0);
    // coordinates are no larger than the extent and a chord: moments leave open up to four times as much as the area
    return {width, lens.is_short() || width <= 2 * (with_moments_ ? 9 : 1) * lens.area_floor()};
  }
  void add(const Spiral_piece_2& p) {
    exact_ += moments_along(exactly(p.first.point), exactly(p.last.point), exact_origin_);
    const Lens_moments m = lens_moments(Lens(p, curves_.error(p.segment)));
    least_ += {Exact_rational(m.area.lower), Exact_rational(m.x.lower), Exact_rational(m.y.lower)};
    most_ += {Exact_rational(m.area.upper), Exact_rational(m.x.upper), Exact_rational(m.y.upper)};
  }

  [[nodiscard]] Lens_moments lens_moments(const Lens& lens) const {
    Lens_moments m{lens.area(), {0, 0}, {0, 0}};
    if (!with_moments_) return m;
    const double bulge = lens.has_bulges ? 0.5 * (lens.bulge.lower + lens.bulge.upper) : 0;
    const double area = lens.chord * lens.chord * lens_share(bulge), height = 0.5 * std::fabs(bulge) * lens.chord;
    constexpr double HEIGHT = 0.41225, HEIGHT_OPEN = 0.0123;  // 0.4 to 4 / (3 pi)
    const Xy<double> a = lens.from - origin_, b = lens.to - origin_;
    const Xy<double> center = 0.5 * (a + b) - (0.5 * bulge * HEIGHT) * perp(Xy<double>(lens.to - lens.from));
    const double farthest =
        (std::max)({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y)}) + lens.chord + 4 * lens.error;
    // 160 u: of the area 100, of the center and the product less than 20
    const double room = (m.area.width() * farthest + std::fabs(area) * HEIGHT_OPEN * height) * ROUNDED_UP<16> +
                        160 * HALF_ULP * std::fabs(area) * farthest;
    m.x = {area * center.x - room, area * center.x + room};
    m.y = {area * center.y - room, area * center.y + room};
    return m;
  }

  const Segment_hierarchy& curves_;
  bool with_moments_;
  double extent_;
  Xy<double> origin_;
  Xy<Exact_rational> exact_origin_;
  Exact_moments exact_, least_, most_;
  Work_limit limit_;
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

}  // namespace CGAL::Bounding_arcs::internal

#endif

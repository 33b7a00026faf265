// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The area of a face: of the parts of curves along its boundaries, by Green's theorem. Polynomial parts are summed up
// exactly, rational ones as their chords and bounds of what is between chord and curve (Rational_part.h).
//
// A part is taken between doubles in the middle of the brackets of its ends' parameters. Where parts meet, segments
// lead from one to the next. What that changes there is the area within a closed curve: along the first part to
// its double, straight to that of the next part, along this back to the place. With w the width of a bracket and D a
// bound of |C'|, its length is at most 2 (w1 D1 + w2 D2), and the area within a closed curve of length L, each part
// counted as often as it is run round, is at most L^2 / (4 pi) (Banchoff and Pohl 1971): less than a third of the
// square of the sum in brackets. A rational part begins and ends at rounded points, and its chord has what is between
// these and the curve: by so much the way is longer, which counts as w D does.

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_BOUNDARY_SUM_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_BOUNDARY_SUM_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include "../curve/Rational_part.h"
#include "../curve/green.h"
#include "../query/query_units.h"

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <optional>

namespace CGAL::Bounding_arcs::internal {

/// Sums up the area of a face from its boundaries, each of which is parts of Bezier pieces.
class Boundary_sum {
 public:
  /// Adds the next part of a boundary, with the face on its left.
  /// \param from, to hold the parameters where it starts and ends; they may be the same bracket
  void add(const Bezier_curve_2<Exact_rational>& bezier, const Bracket& from, const Bracket& to) {
    const double start = from.middle(), end = to.middle();
    const bool is_certain = from.is_single() && to.is_single();
    const Exact_rational speed = is_certain ? Exact_rational(0) : speed_bound(bezier);
    const auto open = [&](const Bracket& t) {
      return Exact_rational((Exact_rational(t.upper) - Exact_rational(t.lower)) * speed);
    };
    End first{{}, open(from)}, last{{}, open(to)};
    if (bezier.is_rational()) {
      const Rational_part part(bezier, start, end);
      first.point = {Exact_rational(part.from().x), Exact_rational(part.from().y)};
      last.point = {Exact_rational(part.to().x), Exact_rational(part.to().y)};
      const auto beside = part.beside_chord({0, 0}).area;
      by_chords_ += CGAL::Interval_nt<true>(beside.inf(), beside.sup());
      first.open += Exact_rational(part.rounding());
      last.open += Exact_rational(part.rounding());
      add_segment(first.point, last.point);
    } else {
      first.point = bezier.point(Exact_rational(start));
      last.point = bezier.point(Exact_rational(end));
      const auto [low, high] = std::minmax(start, end);
      if (low < high) {
        const auto part = bezier.subcurve(Exact_rational(low), Exact_rational(high));
        const Exact_rational area = moments_along(part, {Exact_rational(0), Exact_rational(0)}, false).area;
        exact_ += start < end ? area : Exact_rational(-area);
      }
    }
    if (last_) join(*last_, first);
    else first_ = first;
    last_ = last;
  }
  /// Ends a boundary, which goes on from its last part to its first one.
  void close() {
    if (last_) join(*last_, *first_);
    first_ = last_ = std::nullopt;
  }
  /// \guarantee certified; the lower bound is not below 0
  [[nodiscard]] Measure_bounds bounds(double eps) const {
    // A face is an open set that is not empty, and bounded: its area is above 0, whatever rounding leaves open of it.
    const Exact_rational lower = exact_ + Exact_rational(by_chords_.inf()) - open_,
                         upper = exact_ + Exact_rational(by_chords_.sup()) + open_;
    return measured((std::max)(CGAL::to_interval(lower).first, 0.0), CGAL::to_interval(upper).second, eps, false);
  }

 private:
  using Point = Xy<Exact_rational>;
  /// Where a part starts or ends, and how far that may be from the true place, along the part.
  struct End {
    Point point;
    Exact_rational open;
  };

  void join(const End& end, const End& start) {
    add_segment(end.point, start.point);
    const Exact_rational sum = end.open + start.open;
    open_ += Exact_rational(sum * sum / Exact_rational(3));
  }
  void add_segment(const Point& from, const Point& to) {
    if (!(from == to)) exact_ += Exact_rational(cross(from, to) / Exact_rational(2));
  }
  /// |x| + |y|, no less than the length.
  [[nodiscard]] static Exact_rational size_of(const Xy<Exact_rational>& v) {
    return Exact_rational(CGAL::abs(v.x) + CGAL::abs(v.y));
  }
  /// A bound of |C'|. With N the numerator about the first control point, W the weight and D the largest distance from
  /// that point, C' = (N' - W' C) / W is at most (|N'| + |W'| D) / the least weight.
  [[nodiscard]] static Exact_rational speed_bound(const Bezier_curve_2<Exact_rational>& curve) {
    const auto& p = curve.control_points();
    Exact_rational numerator(0), change_of_weight(0), farthest(0), least = curve.weight(0);
    Xy<Exact_rational> before{Exact_rational(0), Exact_rational(0)};
    for (int i = 1; i <= curve.degree(); ++i) {
      const Exact_rational weight = curve.weight(i);
      const Xy<Exact_rational> way = p[static_cast<std::size_t>(i)] - p[0], at = weight * way;
      numerator = (std::max)(numerator, size_of(at - before));
      change_of_weight = (std::max)(change_of_weight, Exact_rational(CGAL::abs(weight - curve.weight(i - 1))));
      farthest = (std::max)(farthest, size_of(way));
      least = (std::min)(least, weight);
      before = at;
    }
    return Exact_rational(Exact_rational(curve.degree()) * (numerator + change_of_weight * farthest) / least);
  }

  Exact_rational exact_{0}, open_{0};
  std::optional<End> first_, last_;       // of the boundary that is not closed yet
  CGAL::Interval_nt<true> by_chords_{0};  // between rational parts and their chords
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/measures.h.

#include "Area_sum.h"
#include "query_units.h"

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include "../curve/exact_bezier.h"
#include "../polynomial/Gauss_rule.h"
#include "../tree/Segment_hierarchy.h"
#include "Foot.h"

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

// The length of a drawing between two bounds: each piece of a spiral segment is integrated (Speed_integral), and is
// between its chord and arcs that touch it (length_between_arcs), which tells more next to cusps and of pieces that are
// short.

namespace CGAL::Bounding_arcs::internal {

// B-splines of a drawing in doubles with the Bezier pieces that they have in exact numbers: inserted knots are rounded
// in doubles, by which an area differs in its last digits.

using Exact_chain = std::vector<Bezier_curve_2<Exact_rational>>;

[[nodiscard]] inline bool is_same(const Exact_chain& a, const Exact_chain& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].control_points() != b[i].control_points() || a[i].weights() != b[i].weights()) return false;
  return true;
}

/// \param keep_closed a curve that is closed in doubles only keeps its pieces as they are
/// \return nothing where no piece is rounded
/// \complexity some hundred microseconds a piece of a B-spline
[[nodiscard]] inline std::optional<Drawing_2<Exact_rational>> exact_b_splines(const Drawing_2<double>& drawing,
                                                                              bool keep_closed) {
  Drawing_2<Exact_rational> exact;
  bool is_rounded = false;
  for (const auto& curve : drawing.curves()) is_rounded = is_rounded || curve.b_spline;
  if (!is_rounded) return std::nullopt;
  is_rounded = false;
  for (const auto& curve : drawing.curves()) {
    Exact_chain chain;
    for (const auto& piece : curve.beziers) chain.push_back(exact_bezier(piece));
    if (curve.b_spline) {
      Exact_chain pieces = curve.b_spline->over<Exact_rational>().bezier_pieces();
      const bool is_closed = pieces.front().control_points().front() == pieces.back().control_points().back();
      if ((is_closed || !curve.is_closed || !keep_closed) && !is_same(chain, pieces)) {
        chain = std::move(pieces);
        is_rounded = true;
      }
    }
    exact.add(std::move(chain), curve.name);
  }
  return is_rounded ? std::optional(std::move(exact)) : std::nullopt;
}

// Length of a part of a Bezier piece: its speed integrated by 16 nodes (Gauss), with a certified bound of what that
// misses.
//
// With t = m + h s, the part is over s in [-1, 1].  Seen from C(m) and with its weight in m as 1, the piece is N / W,
// W(0) = 1, and its speed |H| / W^2 with H = N' W - N W'.  Let a_k, w_k bound the coefficients of s^k in N and W, and
//   A = a_1 R + a_2 R^2 + ...,  V = w_1 R + w_2 R^2 + ....
// For complex s with |s| <= R,  |H(s) - H(0)| <= A' (1 + V) + A V' - a_1  and  |W(s) - 1| <= V.  Where the former is at
// most 3/4 of c = |H(0)|, the speed in m, and the latter at most 1/4, neither vanishes and so the root of H times its
// conjugate is analytic; |H| / W^2 is at most (7/4 c) / (3/4)^2 < 4 c, which is the M of Gauss_rule.h.

/// Integrates the speed of one Bezier piece, over the parts of it that are asked about.
class Speed_integral {
 public:
  Speed_integral(const Segment_hierarchy& curves, std::uint32_t bezier)
      : curve_(curves.evaluator(bezier)), speed_error_(derivative_error(curves, bezier)) {
    // nodes and where they are round by 4 u of the parameter
    speed_error_ += 4 * HALF_ULP * curve_.second_bound();
    bound_coefficients(curves.bezier(bezier));
  }

  /// \return nothing where the speed changes too much
  [[nodiscard]] std::optional<Bracket> over(double t0, double t1) const {
    const double h = (t1 - t0) / 2, middle = t0 + h;
    const Speed speed = speed_at(middle);
    const double share = missed_share(speed, h);
    if (!(share <= MOST_SHARE)) return std::nullopt;
    double sum = 0;
    for (const auto& [x, weight] : Gauss_rule::NODES)
      sum += weight * (euclidean_norm(curve_(middle - h * x).first) + euclidean_norm(curve_(middle + h * x).first));
    const double length = h * sum, room = share * (2 * h) * (speed.norm + speed_error_) + floor(t0, t1, length);
    return Bracket{(std::max)(0.0, length - room), length + room};
  }
  /// An upper bound of the length: the speed in the middle, and what it may change by.
  [[nodiscard]] double most(double t0, double t1) const {
    const double h = (t1 - t0) / 2;
    return 2 * h * (euclidean_norm(curve_(t0 + h).first) + speed_error_ + h * curve_.second_bound()) * ROUNDED_UP<16>;
  }
  /// What rounding leaves open of a part, to each side: 2 u of each norm, of sums and products less than 24.
  [[nodiscard]] double floor(double t0, double t1, double length) const {
    return ((t1 - t0) * speed_error_ + 32 * HALF_ULP * length) * ROUNDED_UP<16>;
  }

 private:
  static constexpr double MOST_SHARE = 1e-8;
  // The speed at a parameter.
  struct Speed {
    double norm, weight;
  };

  // Bounds a_k and w_k for h = 1 and no scaling of weights: differences of order k of coefficients, times binomials.
  // Seen from C(m), which is no farther from the first control point than one of them, coefficients have that distance
  // times those of W more.
  void bound_coefficients(const Bezier_curve_2<double>& curve) {
    const auto& p = curve.control_points();
    const std::size_t n = p.size() - 1;
    boost::container::small_vector<Xy<double>, 4> numerator;
    double farthest = 0, size = 0, binomial = 1;
    for (std::size_t i = 0; i <= n; ++i) {
      const double w = curve.weight(static_cast<int>(i));
      weights_.push_back(w);
      numerator.push_back(w * (p[i] - p[0]));
      farthest = (std::max)(farthest, euclidean_norm(p[i] - p[0]));
      size = (std::max)(size, w);
    }
    auto differences = weights_;
    double rounding = 4 * HALF_ULP * size;  // over `farthest` or 1; twice as much in each difference
    for (std::size_t k = 1; k <= n; ++k) {
      double of_numerator = 0, of_weight = 0;
      for (std::size_t i = 0; i + k <= n; ++i) {
        numerator[i] = numerator[i + 1] - numerator[i];
        differences[i] = differences[i + 1] - differences[i];
        of_numerator = (std::max)(of_numerator, euclidean_norm(numerator[i]));
        of_weight = (std::max)(of_weight, std::fabs(differences[i]));
      }
      binomial = binomial * static_cast<double>(n + 1 - k) / static_cast<double>(k);
      rounding *= 2;
      const bool is_rational = curve.is_rational();
      const double w = is_rational ? of_weight + rounding : 0;
      constexpr double UP = 1 + 0x1p-40;
      numerator_.push_back(binomial * (of_numerator + (w + rounding) * farthest) * UP);
      denominator_.push_back(binomial * w * UP);
    }
  }
  [[nodiscard]] Speed speed_at(double t) const {
    auto w = weights_;
    if (curve_.is_rational())
      for (std::size_t k = w.size(); k-- > 1;)
        for (std::size_t i = 0; i < k; ++i) w[i] = (1 - t) * w[i] + t * w[i + 1];
    return {euclidean_norm(curve_(t).first), w.front()};
  }

  // The share of the widest ellipse that the speed is analytic in; infinite if there is none. A' and so on are over h.
  [[nodiscard]] double missed_share(const Speed& speed, double h) const {
    constexpr double DOWN = 1 - 0x1p-40;
    const double least_weight = speed.weight * DOWN, least_speed = (speed.norm - speed_error_) * DOWN;
    for (const Gauss_rule::Ellipse& e : Gauss_rule::ELLIPSES) {
      const double x = h * e.half_axis;
      double a = 0, a_slope = 0, v = 0, v_slope = 0, power = 1;
      for (std::size_t k = 0; k < numerator_.size(); ++k, power *= x) {
        const double order = static_cast<double>(k + 1);
        a += numerator_[k] * power * x;
        a_slope += order * numerator_[k] * power;
        v += denominator_[k] * power * x;
        v_slope += order * denominator_[k] * power;
      }
      const double change = (a_slope - numerator_[0] + (a_slope * v + a * v_slope) / least_weight) / least_weight;
      if (change <= 0.75 * least_speed && v <= 0.25 * least_weight) return 2 * e.missed;  // M h is 2 c (2 h)
    }
    return std::numeric_limits<double>::infinity();
  }

  const Bezier_evaluator& curve_;
  double speed_error_;
  boost::container::small_vector<double, 4> weights_, numerator_, denominator_;  // the latter from order 1 on
};

// Length of a piece of a spiral: it lies between those of the arcs that touch it in its ends, as the three are convex
// curves one inside the other. Over a chord of length L an arc with bulge b is  L (1 + b^2) atan(b) / b  long, which
// grows with |b|.

[[nodiscard]] static double length_share(double b) {
  constexpr double FLAT = 0x1p-30;  // below, atan b is b, and b^2 nothing beside 1
  return std::fabs(b) < FLAT ? 1 : (1 + b * b) * (std::atan(b) / b);
}

/// Bounds of the length of a piece whose points may be off by e, by its chord and these arcs. As in fat_arc a bulge
/// errs by 1.1 times what the angles do; the chord by 2 e, and as much is for slivers beside the ends.
[[nodiscard]] static Bracket length_between_arcs(const Spiral_piece_2& piece, double e) {
  constexpr double DOWN = ROUNDED_DOWN<16>, UP = ROUNDED_UP<16>;
  const End_bulges bulges(piece, e);
  const Xy<double> way = piece.last.point - piece.first.point;
  const double chord = bulges.length, box = std::fabs(way.x) + std::fabs(way.y);
  if (!bulges.are_known()) return {(std::max)(0.0, chord * DOWN - 4 * e), box * UP + 4 * e};
  const double room = 1.1 * bulges.angle_error,
               low = std::clamp((std::min)(bulges.first, bulges.last) - room, -1.0, 1.0),
               high = std::clamp((std::max)(bulges.first, bulges.last) + room, -1.0, 1.0);
  const double b0 = std::fabs(low), b1 = std::fabs(high);
  const double least = low < 0 && high > 0 ? 0 : (std::min)(b0, b1), most = (std::max)(b0, b1);
  return {(std::max)(0.0, chord * length_share(least) * DOWN - 4 * e),
          (std::min)(chord * length_share(most), box) * UP + 4 * e};
}

/// What a piece leaves open of a sum.
struct Open_part {
  double width = 0;
  bool is_final = true;  ///< halving does not help
};

/// Returns pieces of a drawing fine enough for a sum over them: the one that leaves most open is halved, until all
/// together leave open no more than a tolerance, or halving does not help, or there are as many as a limit allows.
/// \param open gives the Open_part of a piece
/// \param limit of halvings; where it is reached the rest stays as it is
/// \return the pieces in any order
template <class Open>
[[nodiscard]] static std::vector<Spiral_piece_2> refine_sum(const Segment_hierarchy& curves,
                                                            const std::vector<Spiral_piece_2>& pieces, double tolerance,
                                                            const Open& open, Work_limit& limit) {
  struct Entry {
    Open_part open;
    Spiral_piece_2 piece;
  };
  const auto is_less = [](const Entry& a, const Entry& b) { return a.open.width < b.open.width; };
  std::vector<Spiral_piece_2> done;
  std::vector<Entry> heap;
  double sum = 0;
  heap.reserve(pieces.size());
  for (const Spiral_piece_2& p : pieces) heap.push_back({open(p), p});
  for (const Entry& e : heap) sum += e.open.width;
  std::make_heap(heap.begin(), heap.end(), is_less);
  while (!heap.empty() && !(sum <= tolerance)) {
    if (!heap.front().open.is_final && !limit.spend()) break;
    std::pop_heap(heap.begin(), heap.end(), is_less);
    const Entry widest = heap.back();
    heap.pop_back();
    const auto middle = widest.open.is_final ? std::optional<Spiral_halves_2>() : halves(curves, widest.piece);
    if (!middle) {
      done.push_back(widest.piece);
      continue;
    }
    const Entry parts[2] = {{open(middle->first), middle->first}, {open(middle->second), middle->second}};
    sum += (parts[0].open.width + parts[1].open.width) - widest.open.width;
    for (const Entry& e : parts) {
      heap.push_back(e);
      std::push_heap(heap.begin(), heap.end(), is_less);
    }
  }
  for (const Entry& e : heap) done.push_back(e.piece);
  return done;
}

class Length_sum {
 public:
  Length_sum(const Segment_hierarchy& curves, double tolerance)
      : curves_(curves), limit_(most_pieces(curves.number_of_segments())) {
    for (std::uint32_t b = 0; b < curves.number_of_beziers(); ++b) speeds_.emplace_back(curves, b);
    std::vector<Spiral_piece_2> pieces;
    for (std::uint32_t s = 0; s < curves.number_of_segments(); ++s) pieces.push_back(curves.piece(s));
    const auto open = [this](const Spiral_piece_2& p) { return open_of(p); };
    for (const Spiral_piece_2& p : refine_sum(curves, pieces, tolerance, open, limit_)) {
      const Bracket r = length_of(p);
      lower_ = lower_ + Double_double(r.lower);
      upper_ = upper_ + Double_double(r.upper);
    }
  }

  [[nodiscard]] const Double_double& lower() const { return lower_; }
  [[nodiscard]] const Double_double& upper() const { return upper_; }

  /// Whether pieces were left as they were, as there were too many.
  [[nodiscard]] bool is_limited() const { return limit_.is_reached(); }

 private:
  [[nodiscard]] const Speed_integral& speed_of(const Spiral_piece_2& p) const {
    return speeds_[curves_.bezier_of(p.segment)];
  }
  [[nodiscard]] double point_error(const Spiral_piece_2& p) const {
    const std::uint32_t bezier = curves_.bezier_of(p.segment);
    return curves_.evaluator(bezier).point_error() + curves_.rounding(bezier);
  }
  [[nodiscard]] Bracket length_of(const Spiral_piece_2& p) const {
    // between exact parameters, cuts' errors are of no matter
    const Bracket of_arcs = length_between_arcs(p, curves_.error(p.segment));
    Bracket r{(std::max)(of_arcs.lower, euclidean_norm(p.last.point - p.first.point) * DOWN - 2 * point_error(p)),
              (std::min)(of_arcs.upper, speed_of(p).most(p.first.t, p.last.t))};
    if (const auto integral = speed_of(p).over(p.first.t, p.last.t))
      r = {(std::max)(r.lower, integral->lower), (std::min)(r.upper, integral->upper)};
    return r;
  }
  [[nodiscard]] Open_part open_of(const Spiral_piece_2& p) const {
    const Bracket r = length_of(p);
    const double floor = (std::max)(speed_of(p).floor(p.first.t, p.last.t, r.upper), point_error(p));  // to each side
    return {r.width(), r.width() <= 4 * floor};
  }

  static constexpr double DOWN = ROUNDED_DOWN<16>;

  const Segment_hierarchy& curves_;
  std::vector<Speed_integral> speeds_;  // of Bezier pieces
  Double_double lower_, upper_;
  Work_limit limit_;
};

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

Measure_bounds length(const Bounding_arc_tree_2& curves, double eps) {
  check_tolerance(eps);
  if (curves.empty()) return {0, 0};
  if (const auto exact = internal::exact_b_splines(curves.drawing(), false))
    return length(Bounding_arc_tree_2(*exact), eps);
  const double asked = curves.unit().tolerance_in(eps);
  const internal::Length_sum sum(curves.in_unit(), asked);
  return curves.unit().bounds_out(measured(-(-sum.lower()).upper(), sum.upper().upper(), asked, sum.is_limited()));
}

[[nodiscard]] static Measure_bounds area(const Segment_hierarchy& curves, double eps) {
  if (const auto found = internal::double_double_area(curves)) return measured(found->lower, found->upper, eps, false);
  const internal::Area_sum sum(curves, false);
  const Exact_rational lower = sum.exact().area + sum.least().area, upper = sum.exact().area + sum.most().area;
  return measured(CGAL::to_interval(lower).first, CGAL::to_interval(upper).second, eps, false);
}

Measure_bounds area(const Bounding_arc_tree_2& curves, double eps) {
  check_tolerance(eps);
  internal::check_closed(curves.drawing());
  if (curves.empty()) return {0, 0};
  if (const auto exact = internal::exact_b_splines(curves.drawing(), true))
    return area(Bounding_arc_tree_2(*exact), eps);
  constexpr int OF_AREAS = 2;
  return curves.unit().bounds_out(area(curves.in_unit(), curves.unit().tolerance_in(eps, OF_AREAS)), OF_AREAS);
}

// \param tolerance relative to the extent
[[nodiscard]] static std::optional<Centroid_bounds> centroid(const Segment_hierarchy& curves, double tolerance) {
  const internal::Area_sum sum(curves, true);
  const auto range = [](const Exact_rational& low, const Exact_rational& high) {
    return CGAL::Interval_nt<true>(CGAL::to_interval(low).first, CGAL::to_interval(high).second);
  };
  const Exact_moments &m = sum.exact(), &low = sum.least(), &high = sum.most();
  const auto all = range(m.area + low.area, m.area + high.area);
  if (all.do_overlap(0)) return std::nullopt;
  const auto x = range(m.x + low.x, m.x + high.x) / all + CGAL::Interval_nt<true>(sum.origin().x),
             y = range(m.y + low.y, m.y + high.y) / all + CGAL::Interval_nt<true>(sum.origin().y);
  const double asked = tolerance * internal::extent_of(curves);
  return Centroid_bounds{measured(x.inf(), x.sup(), asked, false), measured(y.inf(), y.sup(), asked, false)};
}

std::optional<Centroid_bounds> centroid(const Bounding_arc_tree_2& curves, double eps) {
  check_tolerance(eps);
  internal::check_closed(curves.drawing());
  if (curves.empty()) return std::nullopt;
  if (const auto exact = internal::exact_b_splines(curves.drawing(), true))
    return centroid(Bounding_arc_tree_2(*exact), eps);
  const auto found = centroid(curves.in_unit(), eps);
  if (!found) return std::nullopt;
  return Centroid_bounds{curves.unit().bounds_out(found->x), curves.unit().bounds_out(found->y)};
}

}  // namespace CGAL::Bounding_arcs

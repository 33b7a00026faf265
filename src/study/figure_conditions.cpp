// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Condition numbers of exact figures, of regions and of one's own formulas, by differences in many bits.

#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/study/Formula_study.h>
#include <CGAL/Bounding_arcs_2/study/Stability_study.h>
#include <CGAL/Bounding_arcs_2/study/Textbook.h>
#include "figure_errors.h"

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {
namespace study {

// A number changes by 2^-SHARE of itself.  What rounding leaves of figures in CONDITION_BITS is far below, and so is
// the second order of the change.
constexpr int SHARE = 200, SMALL = 40;
constexpr mpfr_prec_t CONDITION_BITS = 1024;

using Feet = std::vector<Xy<Mpfr_interval>>;

/// The sum over all numbers of how much a figure changes, in units of 2^-SHARE.
class Condition_sum {
 public:
  Condition_sum(const Exact_figures& exact, const Feet& feet)
      : exact_(exact), feet_(feet), normals_(exact.circles.size()), centers_(exact.circles.size()),
        radii_(exact.circles.size()), joints_(exact.joints.size()), bisectors_(feet.size()) {}

  /// Adds what a change of one number does to bisectors; where one is not narrow there is nothing to tell.
  void add(const Feet& changed) {
    if (changed.size() != feet_.size()) bisectors_.clear();
    for (std::size_t i = 0; i < bisectors_.size(); ++i) bisectors_[i] += change(changed[i], feet_[i]);
  }
  /// Adds what a change of one number does. Returns whether the figures are of the same kind.
  [[nodiscard]] bool add(const Exact_figures& changed) {
    if (changed.form != exact_.form || changed.joints.size() != joints_.size()) return false;
    for (std::size_t i = 0; i < exact_.circles.size(); ++i) {
      const auto &c = exact_.circles[i], &d = changed.circles[i];
      normals_[i] += share(abs(cross(c.normal, d.normal)), dot(c.normal, c.normal));
      if (c.is_line || d.is_line) return false;
      centers_[i] += change(d.center, c.center);
      radii_[i] += change(d.radius, c.radius);
    }
    for (std::size_t i = 0; i < joints_.size(); ++i) joints_[i] += change(changed.joints[i], exact_.joints[i]);
    thickness_ += change(changed.thickness, exact_.thickness);
    return true;
  }
  /// Whether all figures changed by small shares of themselves.
  [[nodiscard]] bool is_first_order() const {
    const Figure_conditions c = largest();
    return (std::max)({c.normal, c.bisector, c.center, c.radius, c.joint, c.thickness}) <
           std::ldexp(1.0, SHARE - SMALL);
  }
  [[nodiscard]] Figure_conditions largest() const {
    return {largest(centers_), largest(radii_), largest(joints_), thickness_, largest(normals_), largest(bisectors_)};
  }

 private:
  [[nodiscard]] static double share(const Mpfr_interval& difference, const Mpfr_interval& exact) {
    return (Mpfr_interval(std::ldexp(1.0, SHARE)) * difference / exact).middle();
  }
  [[nodiscard]] static double change(const Mpfr_interval& x, const Mpfr_interval& exact) {
    return share(abs(x - exact), abs(exact));
  }
  [[nodiscard]] static double change(const Xy<Mpfr_interval>& p, const Xy<Mpfr_interval>& exact) {
    return share(length_about_zero(p - exact), sqrt(dot(exact, exact)));
  }
  [[nodiscard]] static double largest(const std::vector<double>& sums) {
    return sums.empty() ? 0 : *std::max_element(sums.begin(), sums.end());
  }

  const Exact_figures& exact_;
  const Feet& feet_;
  std::vector<double> normals_, centers_, radii_, joints_, bisectors_;
  double thickness_ = 0;
};

/// A piece of a curve in many bits, placed in the origin.
[[nodiscard]] static Chord_frame_2<Mpfr_interval> frame_of(const Bezier_curve_2<CGAL::Exact_rational>& curve,
                                                           double unit, double t0, double t1) {
  const auto number = [](const CGAL::Exact_rational& x) { return Mpfr_interval(x, CONDITION_BITS); };
  const Taylor_table<Mpfr_interval> table(Taylor_table<CGAL::Exact_rational>(curve, unit), number);
  return bezier_chord_shape(table, number(t0), number(t1), {}).at_origin();
}

template <class Construction, class Textbook>
[[nodiscard]] std::optional<Figure_conditions> conditions(const Bezier_spiral_2<double>& spiral, double t0, double t1,
                                                          Region_form form) {
  using Exact = CGAL::Exact_rational;
  const End_orders orders = spiral.orders(t0, t1);
  if (spiral.is_straight() || orders.start != 1 || orders.end != 1) return std::nullopt;
  const Bezier_curve_2<Exact> curve = spiral.exact_curve();
  const double unit = length_unit(spiral.curve());
  const Exact factor = Exact(1) + Exact(std::ldexp(1.0, -SHARE));
  try {
    const auto feet_of = [](const auto& frame) {
      return Textbook::HAS_BISECTORS ? narrow_feet<Textbook>(frame) : Feet();
    };
    const Chord_frame_2<Mpfr_interval> frame = frame_of(curve, unit, t0, t1);
    const Exact_figures exact = region_figures(Construction(), frame);
    if (exact.form != form || !is_narrow(exact)) return std::nullopt;
    const Feet feet = feet_of(frame);
    Condition_sum sum(exact, feet);
    std::vector<Xy<Exact>> points = curve.control_points();
    std::vector<Exact> weights = curve.weights();
    const auto moves = [&](Exact& number) {
      if (number == 0) return true;
      const Exact before = number;
      number = before * factor;
      const auto changed = frame_of(Bezier_curve_2<Exact>(points, weights), unit, t0, t1);
      const bool is_same = sum.add(region_figures(Construction(), changed));
      if (!feet.empty()) sum.add(feet_of(changed));
      number = before;
      return is_same;
    };
    for (Xy<Exact>& p : points)
      if (!moves(p.x) || !moves(p.y)) return std::nullopt;
    for (Exact& w : weights)
      if (!moves(w)) return std::nullopt;
    return sum.is_first_order() ? std::optional<Figure_conditions>(sum.largest()) : std::nullopt;
  } catch (const CGAL::Uncertain_conversion_exception&) {  // a sign that is 0 here, or where a number changes
    return std::nullopt;
  }
}

[[nodiscard]] static Mpfr_interval in_many_bits(const CGAL::Exact_rational& x) {
  return Mpfr_interval(x, CONDITION_BITS);
}

// A piece of a curve whose numbers are no doubles, in enclosures.
[[nodiscard]] static Formula_piece<Mpfr_interval> piece_in_many_bits(
    const std::vector<Xy<CGAL::Exact_rational>>& points, const std::vector<CGAL::Exact_rational>& weights,
    const Bezier_spiral_2<double>& spiral, double t0, double t1) {
  std::vector<Xy<Mpfr_interval>> p;
  std::vector<Mpfr_interval> w;
  for (const Xy<CGAL::Exact_rational>& q : points) p.push_back({in_many_bits(q.x), in_many_bits(q.y)});
  for (const CGAL::Exact_rational& x : weights) w.push_back(in_many_bits(x));
  const Bezier_curve_2<CGAL::Exact_rational> curve(points, weights);
  const Taylor_table<Mpfr_interval> table(Taylor_table<CGAL::Exact_rational>(curve, length_unit(spiral.curve())),
                                          in_many_bits);
  return {Bezier_curve_2<Mpfr_interval>(std::move(p), std::move(w)), in_many_bits(t0), in_many_bits(t1),
          bezier_chord_shape(table, in_many_bits(t0), in_many_bits(t1), {}, spiral.orders(t0, t1))};
}

// The condition number of each figure: the sum over all numbers of how much it changes, as a share of itself.
// Nothing where a comparison is open, or a number changes what figures there are.
[[nodiscard]] static std::map<std::string, double> formula_conditions(const Enclosed_formula& formula,
                                                                      const Bezier_spiral_2<double>& spiral, double t0,
                                                                      double t1) {
  const Bezier_curve_2<CGAL::Exact_rational> curve = spiral.exact_curve();
  std::vector<Xy<CGAL::Exact_rational>> points = curve.control_points();
  std::vector<CGAL::Exact_rational> weights = curve.weights();
  const CGAL::Exact_rational factor = CGAL::Exact_rational(1) + CGAL::Exact_rational(std::ldexp(1.0, -SHARE));
  std::map<std::string, double> sums;
  try {
    const Enclosed_figures exact = formula(piece_in_many_bits(points, weights, spiral, t0, t1));
    const auto moves = [&](CGAL::Exact_rational& x) {
      if (x == 0) return true;
      const CGAL::Exact_rational before = x;
      x = before * factor;
      const Enclosed_figures changed = formula(piece_in_many_bits(points, weights, spiral, t0, t1));
      x = before;
      if (changed.size() != exact.size()) return false;
      for (std::size_t i = 0; i < exact.size(); ++i) {
        const Mpfr_interval change = length_about_zero(changed[i].value - exact[i].value);
        sums[exact[i].name] +=
            (Mpfr_interval(std::ldexp(1.0, SHARE)) * change / length_about_zero(exact[i].value)).middle();
      }
      return true;
    };
    for (Xy<CGAL::Exact_rational>& p : points)
      if (!moves(p.x) || !moves(p.y)) return {};
    for (CGAL::Exact_rational& w : weights)
      if (!moves(w)) return {};
    for (const Named_figure<Mpfr_interval>& f : exact)
      if (f.is_verdict || !(sums[f.name] < std::ldexp(1.0, SHARE - SMALL))) sums.erase(f.name);
  } catch (const CGAL::Uncertain_conversion_exception&) {  // a sign that is 0 here, or where a number changes
    return {};
  }
  return sums;
}

void add_formula_conditions(const Enclosed_formula& formula, std::vector<Stability_row>& rows) {
  std::map<std::pair<std::string, std::size_t>, std::map<std::string, double>> known;  // by piece
  for (Stability_row& row : rows) {
    const auto place = known.try_emplace({row.family, row.number});
    if (place.second) {
      const auto spiral = spiral_holding(Bezier_curve_2<double>(row.control_points, row.weights), row.t0, row.t1);
      if (spiral) place.first->second = formula_conditions(formula, *spiral, row.t0, row.t1);
    }
    const auto condition = place.first->second.find(row.quantity);
    if (condition != place.first->second.end()) row.condition = condition->second;
  }
}

}  // namespace study

std::optional<Figure_conditions> figure_conditions(const Bezier_spiral_2<double>& spiral, double t0, double t1,
                                                   const std::string& method) {
  if (method == Bca::NAME) return study::conditions<Bca, Textbook_bca>(spiral, t0, t1, Region_form::BCA);
  if (method == Spiral_fat_arc::NAME)
    return study::conditions<Spiral_fat_arc, Textbook_spiral_fat_arc>(spiral, t0, t1, Region_form::SPIRAL_FAT_ARC);
  if (method != Bilens::NAME) return std::nullopt;
  return study::conditions<Bilens, Textbook_bilens>(spiral, t0, t1, Region_form::BILENS);
}

}  // namespace CGAL::Bounding_arcs

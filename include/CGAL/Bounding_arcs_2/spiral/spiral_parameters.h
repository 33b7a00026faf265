// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parameters that cut a Bezier curve into spiral segments: between neighbouring ones both coordinates are
// monotone and curvature is monotone and keeps its sign, but for slivers beside a cut as short as rounding. They are
// roots in (0,1) of x', y', curvature and its derivative; of several roots within CUT_WIDTH one is the cut.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_SPIRAL_PARAMETERS_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_SPIRAL_PARAMETERS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include <CGAL/Bounding_arcs_2/polynomial/Interval_isolation.h>
#include <CGAL/Bounding_arcs_2/polynomial/Root_isolator.h>
#include <CGAL/Bounding_arcs_2/polynomial/proportional_numbers.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/Cubic_roots.h>

#include <CGAL/FPU.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

// The roots of a curve's four numerators, and the cuts that are made of them.

namespace CGAL::Bounding_arcs::internal {

/// The number of curves that this thread has cut into spiral segments so far.
[[nodiscard]] inline std::size_t& cut_count() {
  thread_local std::size_t count = 0;
  return count;
}

// A Bezier curve's numerators in three number types, each made when first asked for: intervals decide nearly always,
// double-double numbers round the roots, exact numbers are left for the rest.

/// The numbers of a curve, in double-double numbers and, when asked for, in exact ones.
template <class NT> class Layered_curve {
  using Exact = typename Exact_number<NT>::Type;
  using Integers = Proportional_integers<Exact>;

 public:
  using Ring = typename Integers::Ring;

  explicit Layered_curve(const Bezier_curve_2<NT>& curve) : curve_(curve) {
    const auto& w = curve.weights();
    is_rational_ = std::adjacent_find(w.begin(), w.end(), [](const NT& a, const NT& b) { return a != b; }) != w.end();
    fine_ = make_fine();
  }

  const Curve_numbers<Double_double>& fine() const { return fine_; }
  const Curve_numbers<Ring>& exact() {
    if (!exact_) exact_ = from_exact(&Integers::make);
    return *exact_;
  }

 private:
  // Differences of doubles below this size do not overflow.
  static constexpr double LARGE = 0x1p1000;
  static constexpr bool IS_DOUBLE = std::is_same_v<NT, double> || std::is_same_v<NT, float>;

  [[nodiscard]] Curve_numbers<Double_double> make_fine() const {
    if constexpr (IS_DOUBLE) {
      const auto is_small = [](const Xy<NT>& q) {
        return std::abs(double(q.x)) < LARGE && std::abs(double(q.y)) < LARGE;
      };
      const auto& p = curve_.control_points();
      if (std::all_of(p.begin(), p.end(), is_small)) return from_doubles();
    }
    return from_exact(&normalized<Exact>);
  }

  // Pairs of indices of control points whose differences are wanted.
  [[nodiscard]] std::size_t base(std::size_t i) const { return is_rational_ ? 0 : i - 1; }
  [[nodiscard]] std::size_t first() const { return is_rational_ ? 0 : 1; }

  // All differences, those of x before those of y, as `difference` makes them.
  template <class T, class Difference> [[nodiscard]] std::vector<T> differences(Difference difference) const {
    const auto& p = curve_.control_points();
    std::vector<T> r;
    for (std::size_t i = first(); i < p.size(); ++i) r.push_back(difference(p[i].x, p[base(i)].x));
    for (std::size_t i = first(); i < p.size(); ++i) r.push_back(difference(p[i].y, p[base(i)].y));
    return r;
  }

  template <class T> static Curve_numbers<T> assembled(const std::vector<T>& xy, std::vector<T> w) {
    const auto middle = xy.begin() + static_cast<std::ptrdiff_t>(xy.size() / 2);
    return {std::vector<T>(xy.begin(), middle), std::vector<T>(middle, xy.end()), std::move(w)};
  }

  [[nodiscard]] Curve_numbers<Double_double> from_doubles() const {
    std::vector<Double_double> xy = differences<Double_double>(
        [](const NT& a, const NT& b) { return Double_double::two_sum(double(a), -double(b)); });
    std::vector<Double_double> w;
    if (is_rational_)
      for (const NT& x : curve_.weights()) w.push_back(Double_double(double(x)));
    normalize(xy);
    normalize(w);
    return assembled(xy, std::move(w));
  }

  template <class Convert> [[nodiscard]] auto from_exact(Convert convert) const {
    std::vector<Exact> xy = differences<Exact>(
        [](const NT& a, const NT& b) { return Exact(Exact_number<NT>::make(a) - Exact_number<NT>::make(b)); });
    std::vector<Exact> w;
    if (is_rational_)
      for (const NT& x : curve_.weights()) w.push_back(Exact_number<NT>::make(x));
    return assembled(convert(std::move(xy)), convert(std::move(w)));
  }

  const Bezier_curve_2<NT>& curve_;
  bool is_rational_ = false;
  Curve_numbers<Double_double> fine_;
  std::optional<Curve_numbers<Ring>> exact_;
};

/// One of the four polynomials of a curve in three number types, as `isolate_layered_roots` wants it.
template <class NT> class Layered_numerator {
 public:
  using Ring = typename Layered_curve<NT>::Ring;

  Layered_numerator(Layered_curve<NT>& curve, Numerator which) : curve_(curve), which_(which) {}

  Bernstein_polynomial<Unprotected_interval> enclosure() const {
    const auto widened = [](const std::vector<Double_double>& a) {
      std::vector<Unprotected_interval> r;
      r.reserve(a.size());
      for (const Double_double& x : a) r.push_back(Bounding_arcs::enclosure(x));
      return r;
    };
    const auto& c = curve_.fine();
    return make(Curve_numbers<Unprotected_interval>{widened(c.x), widened(c.y), widened(c.w)});
  }
  const Bernstein_polynomial<Double_double>& fine() {
    if (!fine_) fine_ = make(curve_.fine());
    return *fine_;
  }
  const Bernstein_polynomial<Ring>& exact() {
    if (!exact_) exact_ = make(curve_.exact());
    return *exact_;
  }

 private:
  template <class T> Bernstein_polynomial<T> make(const Curve_numbers<T>& c) const {
    return Numerator_builder<T>(c)(which_);
  }

  Layered_curve<NT>& curve_;
  Numerator which_;
  std::optional<Bernstein_polynomial<Double_double>> fine_;
  std::optional<Bernstein_polynomial<Ring>> exact_;
};

using Numerator_roots = std::array<Unit_roots, NUMERATOR_COUNT>;

[[nodiscard]] inline bool vanishes_at(const Unit_roots& u, double t) {
  return u.is_zero || std::binary_search(u.roots.begin(), u.roots.end(), t);
}

// Roots thinned out so that no two are within CUT_WIDTH of each other or of an end: common roots of x' and y' stay in
// preference to roots of either, these in preference to the others, else the first of them. A root left out is within
// CUT_WIDTH of one that stays or of an end.
[[nodiscard]] inline Short_list<double> separated_cuts(const Numerator_roots& roots) {
  Short_list<double> cuts;
  const auto add = [&cuts](double t) {
    const auto next = std::lower_bound(cuts.begin(), cuts.end(), t);
    const double below = next == cuts.begin() ? 0 : *std::prev(next), above = next == cuts.end() ? 1 : *next;
    if (t - below > CUT_WIDTH && above - t > CUT_WIDTH) cuts.insert(next, t);
  };
  const auto add_roots = [&](Numerator a, Numerator b) {
    const Short_list<double>&p = roots[a].roots, &q = roots[b].roots;
    Short_list<double> both;
    std::merge(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(both));
    for (const double t : both) add(t);
  };
  for (const double t : roots[SPEED_X].roots)
    if (vanishes_at(roots[SPEED_Y], t)) add(t);
  add_roots(SPEED_X, SPEED_Y);
  add_roots(INFLECTION, CURVATURE_CHANGE);
  return cuts;
}

/// Knows no roots.
struct No_root_filter {
  template <class Curve> explicit No_root_filter(const Curve&) {}
  std::optional<Unit_roots> operator()(Numerator) const { return std::nullopt; }
};
template <class NT> using Root_filter = std::conditional_t<std::is_same_v<NT, double>, Cubic_roots, No_root_filter>;

// The roots of all four numerators; in rounding to nearest.
template <class NT, class Filter = Root_filter<NT>> Numerator_roots numerator_roots(const Bezier_curve_2<NT>& curve) {
  const Filter filter(curve);
  std::optional<Layered_curve<NT>> layered;
  Numerator_roots roots;
  for (const Numerator which : {SPEED_X, SPEED_Y, INFLECTION, CURVATURE_CHANGE}) {
    if (std::optional<Unit_roots> known = filter(which)) {
      roots[which] = std::move(*known);
      continue;
    }
    if (!layered) layered.emplace(curve);
    Layered_numerator<NT> polynomial(*layered, which);
    roots[which] = isolate_layered_roots(polynomial);
  }
  return roots;
}

/// Whether a curve turns back where no break is kept.
template <class NT>
[[nodiscard]] bool has_hidden_tip(const Bezier_curve_2<NT>& curve, const Numerator_roots& roots,
                                  const Short_list<double>& breaks) {
  const Unit_roots &x = roots[SPEED_X], &y = roots[SPEED_Y];
  const auto is_near_root = [](const Unit_roots& u, double t) {
    return u.is_zero ||
           std::any_of(u.roots.begin(), u.roots.end(), [t](double s) { return std::fabs(s - t) <= 2 * CUT_WIDTH; });
  };
  const auto& p = curve.control_points();
  const std::size_t n = p.size() - 1;
  const auto is_hidden = [&](double t) {
    const bool is_at_equal = (t <= CUT_WIDTH && p[0] == p[1]) || (t >= 1 - CUT_WIDTH && p[n] == p[n - 1]);
    const bool is_cusp = vanishes_at(y, t) && std::find(breaks.begin(), breaks.end(), t) != breaks.end();
    return !is_at_equal && !is_cusp && is_near_root(y, t);
  };
  if (x.is_zero && y.is_zero) return false;
  const Unit_roots& of = x.is_zero ? y : x;
  return std::any_of(of.roots.begin(), of.roots.end(), is_hidden);
}

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

/// Where a curve stops being a spiral segment, and what it is when it never starts being one.
struct Spiral_parameters {
  Short_list<double> breaks;       ///< in increasing order, more than 2^-51 apart and away from 0 and 1
  Short_list<Cut_reason> reasons;  ///< one a break; the first that holds in the order of CUSP, X, Y, INFLECTION, VERTEX
  bool is_point = false;           ///< all control points are equal
  bool is_straight = false;        ///< curvature is zero throughout, or the curve is a point
  bool is_circular = false;        ///< curvature is constant and not zero
  bool has_hidden_tip = false;  ///< x' and y' vanish where no break is kept, but not at an end of equal control points
};

template <class NT> [[nodiscard]] bool is_finite(const Bezier_curve_2<NT>& curve) {
  if constexpr (std::is_floating_point_v<NT>) {
    const auto& p = curve.control_points();
    const auto& w = curve.weights();
    return std::all_of(p.begin(), p.end(), [](const Xy<NT>& q) { return std::isfinite(q.x) && std::isfinite(q.y); }) &&
           std::all_of(w.begin(), w.end(), [](const NT& x) { return std::isfinite(x); });
  } else {
    return true;
  }
}

/// The parameters in (0,1) that cut a curve into spiral segments, and whether it is a point, straight or circular.
/// These are distinct roots of x', y', curvature and its derivative, each rounded to the nearest double. Roots closer
/// than rounding are one cut. One is kept of those within 2^-51 of each other: if possible a common root of x' and y',
/// else a root of either, else the first. None is kept within 2^-51 of an end. A straight curve is cut where x' or y'
/// changes sign or vanishes only; one folded back on itself turns at a cusp. A cusp is told as one if x' and y' vanish
/// at the same double. A cusp that rounding has pulled apart is cut where either vanishes first, and beyond 2^-51
/// wherever else its tight turn has roots. A point has no breaks and counts as straight, too.
/// \param curve any degree, polynomial or rational, over a floating type, a rational or another exact field
/// \throws std::invalid_argument unless all coordinates and weights are finite
/// \guarantee exact: no root is missed, each, rounded to the nearest double, is a break or within 2^-51 of a break or
///   an end; each break is a correctly rounded root; breaks are more than 2^-51 apart and from the ends; `is_...` are
///   decided exactly. Numbers of type double, float, long double are taken for what they are; others must have exact
///   field operations, signs and to_interval. A pair of complex roots as near to the real axis as rounding can tell may
///   add one break, and never hides one.
/// \complexity polynomials of degree up to 4 n - 7, for rational curves 8 n - 11, in interval arithmetic; exact
///   arithmetic for multiple roots, roots shared by an end and identically vanishing polynomials
template <class NT> [[nodiscard]] Spiral_parameters spiral_parameters(const Bezier_curve_2<NT>& curve) {
  if (!is_finite(curve)) throw std::invalid_argument(expected("curve", "finite coordinates and weights", "inf or nan"));
  ++internal::cut_count();
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  const internal::Numerator_roots roots = internal::numerator_roots(curve);
  const auto vanishes = [&roots](internal::Numerator which, double t) {
    return internal::vanishes_at(roots[which], t);
  };
  Spiral_parameters r;
  r.breaks = internal::separated_cuts(roots);
  for (const double t : r.breaks) {
    const bool is_x = vanishes(internal::SPEED_X, t), is_y = vanishes(internal::SPEED_Y, t);
    r.reasons.push_back(is_x && is_y                        ? Cut_reason::CUSP
                        : is_x                              ? Cut_reason::X
                        : is_y                              ? Cut_reason::Y
                        : vanishes(internal::INFLECTION, t) ? Cut_reason::INFLECTION
                                                            : Cut_reason::VERTEX);
  }
  r.is_point = roots[internal::SPEED_X].is_zero && roots[internal::SPEED_Y].is_zero;
  r.is_straight = roots[internal::INFLECTION].is_zero;
  r.is_circular = roots[internal::CURVATURE_CHANGE].is_zero && !r.is_straight;
  r.has_hidden_tip = internal::has_hidden_tip(curve, roots, r.breaks);
  return r;
}

// compiled in the library
extern template Spiral_parameters spiral_parameters(const Bezier_curve_2<double>&);

}  // namespace CGAL::Bounding_arcs

#endif

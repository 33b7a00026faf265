// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exact stage of queries: common points of pieces A and B are the common zeros of
//   f(t,s) = xA(t) wB(s) - wA(t) xB(s)   and   g(t,s) = yA(t) wB(s) - wA(t) yB(s)   in [0,1]^2.
// A common factor of f and g is where they run together; the other zeros are isolated.

#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12
// GCC takes the last owner of one of CGAL's shared polynomials for one of several, and warns
#pragma GCC diagnostic ignored "-Wuse-after-free"
#endif

#include "exact_intersections.h"
#include "Common_zeros.h"
#include "Level_arcs.h"

#include "../curve/Integer_piece.h"
#include "../polynomial/Integer_polynomial.h"
#include "../spiral/spiral_cuts.h"

#include <CGAL/FPU.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

// The common factor of two equations in t and s, mostly of degree one in each: two pieces of one curve then differ by a
// fractional linear change of parameter, which three pairs of parameters determine.

/// p at t = number, a polynomial in s.
[[nodiscard]] inline Univariate at_number(const Bivariate& p, const Integer& t) {
  std::vector<Integer> c;
  for (int j = 0; j <= p.degree(); ++j) c.push_back(coefficient(p, j).evaluate(t));
  return polynomial(c);
}

using Bilinear_row = std::array<Integer, 4>;  // of t s, t, s and 1

/// What is orthogonal to three rows.
[[nodiscard]] inline Bilinear_row orthogonal(const std::vector<Bilinear_row>& rows) {
  Bilinear_row r;
  for (std::size_t skipped = 0; skipped < 4; ++skipped) {
    std::array<std::size_t, 3> c{};
    for (std::size_t i = 0, k = 0; i < 4; ++i)
      if (i != skipped) c[k++] = i;
    const auto product = [&](std::size_t i, std::size_t j, std::size_t k) {
      return Integer(Integer(rows[0][c[i]] * rows[1][c[j]]) * rows[2][c[k]]);
    };
    Integer sum = product(0, 1, 2);
    sum += product(1, 2, 0);
    sum += product(2, 0, 1);
    sum -= product(0, 2, 1);
    sum -= product(1, 0, 2);
    sum -= product(2, 1, 0);
    r[skipped] = skipped % 2 == 0 ? sum : Integer(-sum);
  }
  return r;
}

/// A common factor of degree one in t and in s, where it is easily found; there may be more to the greatest one.
[[nodiscard]] inline std::optional<Bivariate> bilinear_factor(const Bivariate& f, const Bivariate& g) {
  constexpr int PLACES = 12;  // a few have other common roots, at loops
  std::vector<Bilinear_row> rows;
  for (int i = 1; i <= PLACES && rows.size() < 3; ++i) {
    const Integer t(i);
    const Univariate common = CGAL::gcd(at_number(f, t), at_number(g, t));
    if (common.degree() != 1) continue;
    const Integer n = -coefficient(common, 0), d = coefficient(common, 1);  // the root s = n / d
    rows.push_back({Integer(t * n), Integer(t * d), n, d});
  }
  if (rows.size() < 3) return std::nullopt;
  const Bilinear_row r = orthogonal(rows);
  const Univariate constant = polynomial<Integer>({r[3], r[1]}), linear = polynomial<Integer>({r[2], r[0]});
  const bool is_proper = Integer(r[0] * r[3]) != Integer(r[1] * r[2]);  // else it is a product
  if (!is_proper || !at_fraction(f, -constant, linear).is_zero() || !at_fraction(g, -constant, linear).is_zero())
    return std::nullopt;
  return primitive_part(polynomial<Univariate>({constant, linear}));
}

namespace internal {

/// Two equations, and what elimination needs to know of them.
struct Equations {
  Bivariate f, g;
  Univariate divisor;
  int degree;                                              // of the resultant, at most
  Bivariate diagonal = Bivariate(Univariate(Integer(1)));  // t - s for a piece with itself

  [[nodiscard]] bool is_with_itself() const { return diagonal.degree() > 0; }
  [[nodiscard]] int s_degree() const { return (std::max)(f.degree(), g.degree()); }
};

/// Divides both equations by one polynomial in t and s, none of whose factors is in t alone. What divided all entries
/// of Bezout's matrix still does, as products of that polynomial with itself divide the others.
[[nodiscard]] static Equations divided(const Equations& e, const Bivariate& by) {
  Equations r = e;
  r.f = CGAL::integral_division(e.f, by);
  r.g = CGAL::integral_division(e.g, by);
  const int entries = CGAL::degree(r.f, 0) + CGAL::degree(r.g, 0) - e.divisor.degree();
  r.degree = (std::max)(0, r.s_degree() * entries);
  return r;
}

/// Bezout's matrix is a combination of x, y and w of the first piece, times w.
[[nodiscard]] static Equations equations(const Integer_piece& a, const Integer_piece& b) {
  return {primitive_part(crossed(a.x, a.w, b.x, b.w)), primitive_part(crossed(a.y, a.w, b.y, b.w)), primitive_part(a.w),
          a.degree() * b.degree()};
}
/// The equations of a piece with itself hold for t = s, which is divided out.
[[nodiscard]] static Equations equations(const Integer_piece& a) {
  const std::vector<Univariate> c{polynomial<Integer>({Integer(0), Integer(1)}), Univariate(Integer(-1))};
  Equations e = divided(equations(a, a), polynomial(c));
  e.diagonal = polynomial(c);
  return e;
}

[[nodiscard]] static auto order_of(const Bracket& p, const Bracket& q) {
  return std::tie(p.lower, p.upper, q.lower, q.upper);
}
static void sort(Piece_intersections& found) {
  std::sort(found.points.begin(), found.points.end(),
            [](const auto& p, const auto& q) { return order_of(p.a, p.b) < order_of(q.a, q.b); });
  std::sort(found.overlaps.begin(), found.overlaps.end(),
            [](const auto& p, const auto& q) { return order_of(p.a_from, p.b_from) < order_of(q.a_from, q.b_from); });
}

/// What it is for the pieces in the other order; an overlap along which the other piece falls is run through backwards.
[[nodiscard]] static Piece_intersections exchanged(Piece_intersections found) {
  for (Piece_intersections::Intersection& p : found.points) std::swap(p.a, p.b);
  for (Piece_intersections::Overlap& o : found.overlaps) {
    o = {o.b_from, o.b_to, o.a_from, o.a_to};
    if (order_of(o.a_to, o.a_to) < order_of(o.a_from, o.a_from)) o = {o.a_to, o.a_from, o.b_to, o.b_from};
  }
  sort(found);
  return found;
}

/// The zeros in [0,1]^2.
class Zero_set {
 public:
  /// \param which of a piece with itself
  explicit Zero_set(const Equations& e, Parameter_order which = Parameter_order::RISING)
      : which_(e.is_with_itself() ? which : Parameter_order::ANY) {
    if (e.s_degree() == 0) return;
    if (!add_isolated(e, e.diagonal)) add_shared(e);
  }
  [[nodiscard]] Exact_meetings exact() && { return std::move(found_); }
  /// As the lists that users get.
  [[nodiscard]] Piece_intersections result() && {
    Piece_intersections result;
    for (Exact_meeting& p : found_.points) result.points.push_back({p.t.range(), p.s, p.kind});
    for (Exact_overlap& o : found_.overlaps)
      result.overlaps.push_back({o.t_from.range(), o.t_to.range(), o.s_from.range(), o.s_to.range()});
    sort(result);
    return result;
  }

 private:
  // Not where the equations have a common factor.
  [[nodiscard]] bool add_isolated(const Equations& e, const Bivariate& excluded) {
    Elimination elimination = Eliminator(e.f, e.g, e.divisor, e.degree).result();
    if (elimination.resultant.is_zero()) return false;
    Common_zeros zeros(e.f, e.g, std::move(elimination), excluded, which_);
    found_.points.insert(found_.points.end(), zeros.points().begin(), zeros.points().end());
    return true;
  }
  void add_shared(const Equations& e) {
    const std::optional<Bivariate> bilinear = bilinear_factor(e.f, e.g);
    if (bilinear && add_shared(e, *bilinear)) return;
    (void)add_shared(e, primitive_part(CGAL::gcd(e.f, e.g)));
  }
  // Not where the equations have more in common.
  [[nodiscard]] bool add_shared(const Equations& e, const Bivariate& common) {
    const Bivariate whole = common * e.diagonal;
    const Equations rest = divided(e, common);
    if (rest.s_degree() > 0 && !add_isolated(rest, whole)) return false;
    add_arcs(whole);
    return true;
  }
  void add_arcs(const Bivariate& h) {
    Level_arcs level(level_functions(h));
    const auto is_taken = [this](Level_point& p, bool or_equal) {
      const int side = which_ == Parameter_order::FALLING ? p.s.compare(p.t) : p.t.compare(p.s);
      return side < 0 || (or_equal && side == 0);
    };
    for (Level_arc& arc : level.arcs()) {
      if (which_ != Parameter_order::ANY && !is_taken(arc.from, false) &&
          !(is_taken(arc.from, true) && is_taken(arc.to, false)))
        continue;
      found_.overlaps.push_back({arc.from.t, arc.to.t, arc.from.s, arc.to.s});
    }
    for (Level_point& p : level.isolated())
      if (which_ == Parameter_order::ANY || is_taken(p, false))
        found_.points.push_back({p.t, p.s.range(), Intersection_kind::TANGENTIAL});
  }

  Parameter_order which_;
  Exact_meetings found_;
};

[[nodiscard]] static bool are_boxes_apart(const Bezier_curve_2<Exact_rational>& a,
                                          const Bezier_curve_2<Exact_rational>& b) {
  const auto is_apart = [&](auto less) {
    const auto [a_low, a_high] = std::minmax_element(a.control_points().begin(), a.control_points().end(), less);
    const auto [b_low, b_high] = std::minmax_element(b.control_points().begin(), b.control_points().end(), less);
    return less(*a_high, *b_low) || less(*b_high, *a_low);
  };
  return is_apart([](const auto& p, const auto& q) { return p.x < q.x; }) ||
         is_apart([](const auto& p, const auto& q) { return p.y < q.y; });
}

/// Overlaps of a single point with whatever of a piece is on it. \param is_first whether the first piece is that point
[[nodiscard]] static Piece_intersections point_overlaps(const Integer_piece& a, const Xy<Exact_rational>& p,
                                                        bool is_first) {
  Piece_intersections r;
  const Bracket zero{0, 0}, one{1, 1};
  const auto add = [&](const Bracket& from, const Bracket& to) {
    r.overlaps.push_back(is_first ? Piece_intersections::Overlap{zero, one, from, to}
                                  : Piece_intersections::Overlap{from, to, zero, one});
  };
  if (a.is_point() && moved(a.x, a.w, p.x).is_zero() && moved(a.y, a.w, p.y).is_zero()) add(zero, one);
  for (Real_root& t : exact_roots_at(a, p)) add(t.range(), t.range());
  return r;
}

}  // namespace internal

std::vector<Real_root> exact_roots_at(const Integer_piece& a, const Xy<Exact_rational>& p) {
  const Univariate x = moved(a.x, a.w, p.x), y = moved(a.y, a.w, p.y);
  if (x.is_zero() && y.is_zero()) return {};
  return unit_roots(CGAL::gcd(x, y));
}

std::vector<Exact_zero> exact_zeros(const Univariate& p) {
  std::vector<Real_root> roots = unit_roots(p);
  std::vector<Exact_zero> zeros;
  const auto is_end = [](const Real_root& t, int end) { return t.is_dyadic() && t.lower() == Exact_rational(end); };
  const auto sign_between = [&p](const Exact_rational& low, const Exact_rational& high) {
    return static_cast<int>(CGAL::sign(value_at(p, Exact_rational((low + high) / Exact_rational(2)))));
  };
  int before = 0;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const bool is_last = i + 1 == roots.size();
    while (!is_last && roots[i].upper() >= roots[i + 1].lower()) {
      roots[i].refine();
      roots[i + 1].refine();
    }
    if (i == 0) before = is_end(roots[i], 0) ? -1 : sign_between(Exact_rational(0), roots[i].lower());
    const int behind = is_last && is_end(roots[i], 1)
                           ? -1
                           : sign_between(roots[i].upper(), is_last ? Exact_rational(1) : roots[i + 1].lower());
    zeros.push_back({roots[i], std::exchange(before, behind), behind});
  }
  return zeros;
}

Exact_meetings exact_meetings(const Integer_piece& a, const Integer_piece& b) {
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  return internal::Zero_set(internal::equations(a, b)).exact();
}
Exact_meetings exact_meetings(const Integer_piece& a, Parameter_order order) {
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  return internal::Zero_set(internal::equations(a), order).exact();
}

Univariate places_of(const Integer_piece& a, const Integer_piece& b, const Univariate& roots) {
  if (roots.degree() == 0) return Univariate(Integer(1));
  std::vector<Univariate> constants;
  for (int i = 0; i <= roots.degree(); ++i) constants.emplace_back(coefficient(roots, i));
  const Bivariate in_s = polynomial(constants);
  return CGAL::gcd(CGAL::resultant(in_s, crossed(a.x, a.w, b.x, b.w)),
                   CGAL::resultant(in_s, crossed(a.y, a.w, b.y, b.w)));
}

Piece_intersections exact_intersections(const Bezier_curve_2<Exact_rational>& a,
                                        const Bezier_curve_2<Exact_rational>& b) {
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  if (internal::are_boxes_apart(a, b)) return {};
  const Integer_piece p(a), q(b);
  if (p.is_point()) return internal::point_overlaps(q, a.control_points().front(), true);
  if (q.is_point()) return internal::point_overlaps(p, b.control_points().front(), false);
  // Over a point of a straight piece there are several parameters, which is the slow case for the second piece.
  if (q.is_straight() && !p.is_straight())
    return internal::exchanged(internal::Zero_set(internal::equations(q, p)).result());
  return internal::Zero_set(internal::equations(p, q)).result();
}

Piece_intersections exact_self_intersections(const Bezier_curve_2<Exact_rational>& a) {
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  const Integer_piece p(a);
  if (p.is_point()) return {};
  return internal::Zero_set(internal::equations(p)).result();
}

// The direction is that of both ends together. C' is a combination of its control points, and the curve rises in the
// direction where none of them falls, and one rises.
bool runs_ahead(const Bezier_curve_2<Exact_rational>& a, double t0, double t1) {
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  using Interval = internal::Unprotected_interval;
  const auto derivative = [&](const internal::Cut_numbers& numbers, internal::Numerator which) {
    const auto whole = internal::layered_numerator(numbers, which).enclosure();
    return whole.restricted(Interval(t0), Interval(1) - Interval(t0), Interval(t1), Interval(1) - Interval(t1))
        .scaled_coefficients();
  };
  return internal::with_cut_numbers(a, [&](const internal::Cut_numbers& numbers) {
    (void)numbers.fine();  // while numbers round to the nearest
    const Protect_FPU_rounding<true> upward;
    const auto x = derivative(numbers, internal::SPEED_X), y = derivative(numbers, internal::SPEED_Y);
    const auto middle = [](const Interval& p, const Interval& q) {
      return (p.inf() + p.sup()) / 4 + (q.inf() + q.sup()) / 4;
    };
    const Interval ahead_x(middle(x.front(), x.back())), ahead_y(middle(y.front(), y.back()));
    bool rises = false;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Interval rise = ahead_x * x[i] + ahead_y * y[i];
      if (rise.inf() < 0) return false;
      rises = rises || rise.inf() > 0;
    }
    return rises;
  });
}

// A curve over [t0, t1] as seen from a point, times its weight: X = sum w (P.x - q.x) B, Y = sum w (P.y - q.y) B.
struct Seen_curve {
  Exact_polynomial x, y;
};
static Seen_curve seen_from(const Exact_point& q, const Bezier_curve_2<Exact_rational>& curve, const Exact_rational& t0,
                            const Exact_rational& t1) {
  Exact_polynomial::Coefficients x, y;
  for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
    const Exact_point way = curve.control_points()[i] - q;
    const Exact_rational weight = curve.weight(static_cast<int>(i));
    x.push_back(Exact_rational(weight * way.x));
    y.push_back(Exact_rational(weight * way.y));
  }
  const Exact_rational s0 = Exact_rational(1 - t0), s1 = Exact_rational(1 - t1);
  return {Exact_polynomial(std::move(x)).restricted(t0, s0, t1, s1),
          Exact_polynomial(std::move(y)).restricted(t0, s0, t1, s1)};
}

// 1 from below the point to its height or above it, -1 the other way round.
static int rise(const Exact_rational& from_y, const Exact_rational& to_y) {
  return static_cast<int>(from_y < 0) - static_cast<int>(to_y < 0);
}

// The crossings of a seen curve without a common root of X and Y: halves are cut until X or Y has one sign on each.
static int crossings(const Seen_curve& c) {
  const auto &x = c.x.scaled_coefficients(), &y = c.y.scaled_coefficients();
  const auto is_negative = [](const Exact_rational& v) { return CGAL::is_negative(v); };
  const auto is_positive = [](const Exact_rational& v) { return CGAL::is_positive(v); };
  if (std::none_of(y.begin(), y.end(), is_negative) || std::all_of(y.begin(), y.end(), is_negative)) return 0;
  if (std::none_of(x.begin(), x.end(), is_positive)) return 0;
  if (std::none_of(x.begin(), x.end(), is_negative)) return rise(y.front(), y.back());
  const auto xs = c.x.halves(), ys = c.y.halves();
  return crossings({xs.first, ys.first}) + crossings({xs.second, ys.second});
}

// From b to a as many, with the other sign, even where it runs through the point.
static int segment_crossings(const Exact_point& q, const Exact_point& a, const Exact_point& b) {
  const Exact_point u = a - q, v = b - q;
  const int way = rise(u.y, v.y);
  return way != 0 && static_cast<int>(CGAL::sign(cross(u, v))) == way ? way : 0;
}

// Whether two polynomials have a common root in [0, 1], or both vanish everywhere.
static bool have_common_root(const Exact_polynomial& a, const Exact_polynomial& b) {
  const Univariate divisor = CGAL::gcd(to_powers(a), to_powers(b));
  return divisor.is_zero() || !unit_roots(divisor).empty();
}

Exact_crossings exact_crossings(const Exact_point& q, const Bezier_curve_2<Exact_rational>& curve, double t0, double t1,
                                const Exact_point& a, const Exact_point& b) {
  const Exact_rational first(t0), last(t1);
  const Seen_curve seen = seen_from(q, curve, first, last);
  Exact_crossings r;
  r.is_on = have_common_root(seen.x, seen.y);
  r.number = segment_crossings(q, a, curve.point(first)) + segment_crossings(q, curve.point(last), b);
  if (r.is_on) r.passing = rise(seen.y.scaled_coefficients().front(), seen.y.scaled_coefficients().back());
  else r.number += crossings(seen);
  return r;
}

}  // namespace CGAL::Bounding_arcs

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of arrangement/internal/Exact_place.h.

#include <CGAL/Bounding_arcs_2/arrangement/internal/Exact_place.h>
#include <CGAL/Bounding_arcs_2/curve/exact_bezier.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/query/meeting_places.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

Exact_range values_over(const Univariate& p, const Exact_range& t) {
  Exact_range value{Exact_rational(0), Exact_rational(0)};
  for (int i = p.degree(); i >= 0; --i) {
    const Exact_rational c(coefficient(p, i));
    value = {Exact_rational(value.lower * (CGAL::is_negative(value.lower) ? t.upper : t.lower) + c),
             Exact_rational(value.upper * (CGAL::is_negative(value.upper) ? t.lower : t.upper) + c)};
  }
  return value;
}

std::optional<Exact_range> quotients_over(const Univariate& n, const Univariate& d, const Exact_range& t) {
  const Exact_range p = values_over(n, t), q = values_over(d, t);
  if (!CGAL::is_positive(q.lower)) return std::nullopt;
  return Exact_range{Exact_rational(p.lower / (CGAL::is_negative(p.lower) ? q.lower : q.upper)),
                     Exact_rational(p.upper / (CGAL::is_negative(p.upper) ? q.upper : q.lower))};
}

Real_root real_root_of(double value) {
  constexpr int DIGITS = 53;
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(value, &exponent), DIGITS);
  exponent -= DIGITS;
  const Integer integer(mantissa);
  return exponent >= 0 ? Real_root(Integer(integer * power_of_two(exponent)), 0) : Real_root(integer, -exponent);
}

namespace {

/// The root of a polynomial in a bracket. \pre there is one
[[nodiscard]] Real_root root_in(const Univariate& p, const Bracket& t) {
  if (!p.is_zero())
    for (Real_root& root : unit_roots(p)) {
      const Bracket r = root.range();
      if (r.lower <= t.upper && t.lower <= r.upper) return root;
    }
  throw std::logic_error(expected("common point of curves", "an exact parameter", "none"));
}

[[nodiscard]] Real_root parameter(const Integer_piece& a, const Integer_piece& b, bool is_overlap_end,
                                  const Bracket& t) {
  return t.lower == t.upper ? real_root_of(t.lower) : root_in(meeting_places(a, b, is_overlap_end), t);
}

/// The numerator of p(from + u (to - from)), u in [0,1], in Bernstein's form; from and to over 2^k.
[[nodiscard]] Bernstein_polynomial<Integer> over_range(const Univariate& p, const Integer& from, const Integer& to,
                                                       int k) {
  const Univariate way = polynomial<Integer>({from, Integer(to - from)});
  Univariate value(Integer(0));
  Integer power(1);
  for (int i = p.degree(); i >= 0; --i) {
    value = value * way + Univariate(Integer(coefficient(p, i) * power));
    power *= power_of_two(k);
  }
  return to_bernstein(value, p.degree());
}

[[nodiscard]] Integer floor_of(const Exact_rational& x) {
  const auto [n, d] = decomposed(x);
  Integer q = n / d;  // towards 0
  if (Integer(q * d) > n) q -= 1;
  return q;
}

/// n(t) / d(t) as a number of its own. \pre d is positive on [0,1]
[[nodiscard]] Real_root coordinate_at(const Univariate& n, const Univariate& d, Real_root& t) {
  Univariate common = CGAL::gcd(n, d);  // elsewhere on the curve; all numbers would be roots of the resultant
  if (CGAL::sign(Integer(coefficient(common, 0))) == CGAL::NEGATIVE) common = -common;
  const Univariate x = CGAL::integral_division(n, common), w = CGAL::integral_division(d, common);
  std::vector<Univariate> by_t;  // x(t) - x w(t), coefficients in x
  for (int j = 0; j <= (std::max)(x.degree(), w.degree()); ++j)
    by_t.push_back(polynomial<Integer>({coefficient(x, j), Integer(-coefficient(w, j))}));
  const Univariate m = t.polynomial();
  std::vector<Univariate> constants;
  for (int j = 0; j <= m.degree(); ++j) constants.emplace_back(coefficient(m, j));
  const Univariate all = CGAL::resultant(polynomial(constants), polynomial(by_t));
  const auto roots = std::make_shared<const Univariate>(square_free(all));
  constexpr int FIRST_BITS = 64, SPARE_BITS = 8;
  for (int bits = FIRST_BITS;; bits *= 2) {
    t.refine_to(bits);
    const std::optional<Exact_range> range = quotients_over(x, w, {t.lower(), t.upper()});
    if (!range) continue;
    const int k = bits + SPARE_BITS;
    const Exact_rational scale(power_of_two(k));
    const Integer low = floor_of(range->lower * scale), high = floor_of(range->upper * scale) + Integer(1);
    if (range->lower == range->upper && Exact_rational(low) == range->lower * scale) return {low, k};
    const Integer from = low - Integer(1);
    const auto over = over_range(*roots, from, high, k);
    const auto& c = over.scaled_coefficients();
    if (c.front() == Integer(0) || c.back() == Integer(0) || sign_variations(over).most() != 1) continue;
    return {roots, from, high, k};
  }
}

}  // namespace

Univariate turn_polynomial(const Integer_piece& piece, bool is_vertical) {
  const Univariate& x = is_vertical ? piece.y : piece.x;
  return odd_part(CGAL::differentiate(x) * piece.w - x * CGAL::differentiate(piece.w));
}

Exact_place& exact_place(const Arranged_point& p) {
  if (!p.exact && p.turning_bezier) {
    const auto owner = p.turning.lock();
    const auto piece = owner ? owner->exact() : std::make_shared<const Integer_piece>(exact_bezier(*p.turning_bezier));
    const Bracket& t = p.places.front().t;
    p.exact = std::make_shared<Exact_place>(
        Exact_place{piece,
                    t.is_single() ? real_root_of(t.lower) : root_in(turn_polynomial(*piece, p.x.is_single()), t),
                    {},
                    {},
                    {}});
  } else if (!p.exact) {
    const auto& piece = p.curve->exact();
    p.exact = std::make_shared<Exact_place>(
        Exact_place{piece, parameter(*piece, *p.other->exact(), p.is_overlap_end, p.places.front().t), {}, {}, {}});
  }
  return *p.exact;
}

Real_root& exact_coordinate(const Arranged_point& p, bool is_x) {
  const Bracket& known = is_x ? p.x : p.y;
  if (p.is_double() && !p.exact) p.exact = std::make_shared<Exact_place>(Exact_place{{}, Real_root(0, 0), {}, {}, {}});
  Exact_place& place = exact_place(p);
  std::optional<Real_root>& number = is_x ? place.x : place.y;
  if (!number) {
    if (known.lower == known.upper) number = real_root_of(known.lower);
    else number = coordinate_at(is_x ? place.piece->x : place.piece->y, place.piece->w, place.t);
  }
  return *number;
}

Real_root* exact_parameter(const Arranged_point& p, const Arranged_place& place) {
  const auto is_place = [&](std::size_t i) {
    return p.places[i].curve == place.curve && p.places[i].t.touches(place.t);
  };
  if (is_place(0)) return &exact_place(p).t;
  if (!p.other || !is_place(1)) return nullptr;
  std::optional<Real_root>& s = exact_place(p).s;
  if (!s) s = parameter(*p.other->exact(), *p.curve->exact(), p.is_overlap_end, p.places[1].t);
  return &*s;
}

Exact_range coordinate_range(const Arranged_point& p, bool is_x, int bits) {
  const Bracket& known = is_x ? p.x : p.y;
  if (known.lower == known.upper) return {Exact_rational(known.lower), Exact_rational(known.lower)};
  Exact_place& place = exact_place(p);
  for (;; bits *= 2) {
    place.t.refine_to(bits);
    const auto& [x, y, w] = *place.piece;
    if (auto range = quotients_over(is_x ? x : y, w, {place.t.lower(), place.t.upper()})) return *range;
  }
}

}  // namespace CGAL::Bounding_arcs::internal

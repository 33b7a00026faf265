// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of number/Mpfr_interval.h.

#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>

#include <cmath>
#include <limits>

namespace CGAL::Bounding_arcs {

double Mpfr_interval::relative_width() const {
  if (mpfr_equal_p(lo_.get(), hi_.get()) != 0) return 0;
  const int sign = this->certain_sign();
  if (sign == 0 || mpfr_number_p(lo_.get()) == 0 || mpfr_number_p(hi_.get()) == 0)
    return std::numeric_limits<double>::infinity();
  internal::Mpfr_number x(precision());
  mpfr_sub(x.get(), hi_.get(), lo_.get(), MPFR_RNDU);
  mpfr_div(x.get(), x.get(), sign > 0 ? lo_.get() : hi_.get(), MPFR_RNDA);
  return std::fabs(mpfr_get_d(x.get(), MPFR_RNDA));
}

Mpfr_interval operator-(const Mpfr_interval& a) {
  Mpfr_interval r(Mpfr_interval::Precision{a.precision()});
  mpfr_neg(r.lo_.get(), a.hi_.get(), MPFR_RNDD);
  mpfr_neg(r.hi_.get(), a.lo_.get(), MPFR_RNDU);
  return r;
}
Mpfr_interval operator+(const Mpfr_interval& a, const Mpfr_interval& b) {
  Mpfr_interval r(Mpfr_interval::Precision{Mpfr_interval::joint(a, b)});
  mpfr_add(r.lo_.get(), a.lo_.get(), b.lo_.get(), MPFR_RNDD);
  mpfr_add(r.hi_.get(), a.hi_.get(), b.hi_.get(), MPFR_RNDU);
  return r;
}
Mpfr_interval operator-(const Mpfr_interval& a, const Mpfr_interval& b) {
  Mpfr_interval r(Mpfr_interval::Precision{Mpfr_interval::joint(a, b)});
  mpfr_sub(r.lo_.get(), a.lo_.get(), b.hi_.get(), MPFR_RNDD);
  mpfr_sub(r.hi_.get(), a.hi_.get(), b.lo_.get(), MPFR_RNDU);
  return r;
}
Mpfr_interval operator*(const Mpfr_interval& a, const Mpfr_interval& b) {
  return Mpfr_interval::by_signs(a, b, b.lo_, b.hi_, mpfr_mul);
}
// The reciprocal of b has b's ends in the other order.
Mpfr_interval operator/(const Mpfr_interval& a, const Mpfr_interval& b) {
  return b.certain_sign() == 0 ? Mpfr_interval::whole(Mpfr_interval::joint(a, b))
                               : Mpfr_interval::by_signs(a, b, b.hi_, b.lo_, mpfr_div);
}
Mpfr_interval sqrt(const Mpfr_interval& a) {
  if (a.lo_.sign() < 0) return Mpfr_interval::whole(a.precision());
  Mpfr_interval r(Mpfr_interval::Precision{a.precision()});
  mpfr_sqrt(r.lo_.get(), a.lo_.get(), MPFR_RNDD);
  mpfr_sqrt(r.hi_.get(), a.hi_.get(), MPFR_RNDU);
  return r;
}
Mpfr_interval max BOOST_PREVENT_MACRO_SUBSTITUTION(const Mpfr_interval& a, const Mpfr_interval& b) {
  Mpfr_interval r(Mpfr_interval::Precision{Mpfr_interval::joint(a, b)});
  mpfr_max(r.lo_.get(), a.lo_.get(), b.lo_.get(), MPFR_RNDD);
  mpfr_max(r.hi_.get(), a.hi_.get(), b.hi_.get(), MPFR_RNDU);
  return r;
}
Mpfr_interval joined(const Mpfr_interval& a, const Mpfr_interval& b) {
  Mpfr_interval r(Mpfr_interval::Precision{Mpfr_interval::joint(a, b)});
  mpfr_min(r.lo_.get(), a.lo_.get(), b.lo_.get(), MPFR_RNDD);
  mpfr_max(r.hi_.get(), a.hi_.get(), b.hi_.get(), MPFR_RNDU);
  return r;
}
CGAL::Uncertain<bool> operator<(const Mpfr_interval& a, const Mpfr_interval& b) {
  const int sign = (b - a).certain_sign();
  if (sign > 0) return true;
  return mpfr_greaterequal_p(a.lo_.get(), b.hi_.get()) != 0 ? CGAL::Uncertain<bool>(false)
                                                            : CGAL::Uncertain<bool>::indeterminate();
}
CGAL::Uncertain<bool> operator!=(const Mpfr_interval& a, const Mpfr_interval& b) {
  const Mpfr_interval difference = b - a;
  if (mpfr_zero_p(difference.lo_.get()) != 0 && mpfr_zero_p(difference.hi_.get()) != 0) return false;
  return (b - a).certain_sign() != 0 ? CGAL::Uncertain<bool>(true) : CGAL::Uncertain<bool>::indeterminate();
}

Mpfr_interval Mpfr_interval::whole(mpfr_prec_t precision) {
  Mpfr_interval r(Precision{precision});
  mpfr_set_inf(r.lo_.get(), -1);
  mpfr_set_inf(r.hi_.get(), 1);
  return r;
}

// With one sign certain each bound comes from one pair of ends; otherwise the lower one from a low and a high end,
// the upper one from two of a kind.
Mpfr_interval Mpfr_interval::by_signs(const Mpfr_interval& a, const Mpfr_interval& b,
                                      const internal::Mpfr_number& b_low, const internal::Mpfr_number& b_high,
                                      Operation operation) {
  const mpfr_prec_t precision = joint(a, b);
  const int s = a.certain_sign(), t = b.certain_sign();
  Mpfr_interval r(Precision{precision});
  bool is_open = false;
  const auto set = [&](internal::Mpfr_number& x, const internal::Mpfr_number& p, const internal::Mpfr_number& q,
                       mpfr_rnd_t mode) {
    operation(x.get(), p.get(), q.get(), mode);
    is_open = is_open || mpfr_nan_p(x.get()) != 0;
  };
  set(r.lo_, t < 0 || (t == 0 && s > 0) ? a.hi_ : a.lo_, s < 0 || (t >= 0 && s == 0) ? b_high : b_low, MPFR_RNDD);
  set(r.hi_, t < 0 || (t == 0 && s < 0) ? a.lo_ : a.hi_, s < 0 || (t < 0 && s == 0) ? b_low : b_high, MPFR_RNDU);
  if (s == 0 && t == 0) {
    internal::Mpfr_number x(precision);
    set(x, a.hi_, b_low, MPFR_RNDD);
    mpfr_min(r.lo_.get(), r.lo_.get(), x.get(), MPFR_RNDD);
    set(x, a.lo_, b_low, MPFR_RNDU);
    mpfr_max(r.hi_.get(), r.hi_.get(), x.get(), MPFR_RNDU);
  }
  return is_open ? whole(precision) : r;
}

}  // namespace CGAL::Bounding_arcs

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intervals of MPFR numbers of any precision, every operation rounded outward.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_MPFR_INTERVAL_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_MPFR_INTERVAL_H

#include <CGAL/Bounding_arcs_2/number/convert.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <gmp.h>
#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Bounding_arcs {

namespace internal {
/// An mpfr_t that owns its memory.
class Mpfr_number {
 public:
  explicit Mpfr_number(mpfr_prec_t precision) { mpfr_init2(value_, precision); }
  Mpfr_number(const Mpfr_number& other) : Mpfr_number(mpfr_get_prec(other.value_)) {
    mpfr_set(value_, other.value_, MPFR_RNDN);
  }
  Mpfr_number& operator=(const Mpfr_number& other) {
    if (this == &other) return *this;
    mpfr_set_prec(value_, mpfr_get_prec(other.value_));
    mpfr_set(value_, other.value_, MPFR_RNDN);
    return *this;
  }
  // What a number's memory was taken from may only be destroyed or assigned to by moving.
  Mpfr_number(Mpfr_number&& other) noexcept {
    value_[0] = other.value_[0];
    other.value_[0]._mpfr_d = nullptr;
  }
  Mpfr_number& operator=(Mpfr_number&& other) noexcept {
    std::swap(value_[0], other.value_[0]);
    return *this;
  }
  ~Mpfr_number() {
    if (value_[0]._mpfr_d != nullptr) mpfr_clear(value_);
  }
  [[nodiscard]] mpfr_ptr get() { return value_; }
  [[nodiscard]] mpfr_srcptr get() const { return value_; }
  [[nodiscard]] int sign() const { return mpfr_nan_p(value_) ? 0 : mpfr_sgn(value_); }

 private:
  mpfr_t value_;
};

// The mpq_t inside CGAL::Exact_rational, which is one of three types as CGAL was configured.
template <class Rational> [[nodiscard]] auto rational_data(const Rational& x) -> decltype(x.mpq()) { return x.mpq(); }
template <class Rational> [[nodiscard]] auto rational_data(const Rational& x) -> decltype(x.get_mpq_t()) {
  return x.get_mpq_t();
}
template <class Rational> [[nodiscard]] auto rational_data(const Rational& x) -> decltype(x.backend().data()) {
  return x.backend().data();
}
}  // namespace internal

/// Whether numbers of a type have enclosures of any precision.
template <class T, class = void> inline constexpr bool has_enclosures_v = false;
template <class T>
inline constexpr bool has_enclosures_v<
    T, std::void_t<decltype(mpfr_set_q(nullptr, internal::rational_data(std::declval<const T&>()), MPFR_RNDD))>> = true;

/// [lower, upper] with endpoints of one precision; operations take the larger of their operands' precisions.
/// \guarantee every operation encloses the exact result; division by an interval that holds 0, and square roots of
///   intervals below 0, give the whole line
class Mpfr_interval {
 public:
  /// The precision in bits of integers, which are exact in it; the smallest that operations can end up with.
  static constexpr mpfr_prec_t LEAST_PRECISION = 64;

  Mpfr_interval(int value = 0) : Mpfr_interval(Precision{LEAST_PRECISION}) {  // NOLINT: integers are exact
    mpfr_set_si(lo_.get(), value, MPFR_RNDD);
    mpfr_set_si(hi_.get(), value, MPFR_RNDU);
  }
  /// An exact double. \pre finite
  explicit Mpfr_interval(double value) : Mpfr_interval(Precision{LEAST_PRECISION}) {
    CGAL_precondition(std::isfinite(value));
    mpfr_set_d(lo_.get(), value, MPFR_RNDD);
    mpfr_set_d(hi_.get(), value, MPFR_RNDU);
  }
  /// Takes a long double of at most 64 bits, exactly. \pre finite
  explicit Mpfr_interval(long double value) : Mpfr_interval(Precision{LEAST_PRECISION}) {
    mpfr_set_ld(lo_.get(), value, MPFR_RNDD);
    mpfr_set_ld(hi_.get(), value, MPFR_RNDU);
  }
  Mpfr_interval(const CGAL::Exact_rational& value, mpfr_prec_t precision)
      : Mpfr_interval(internal::rational_data(value), precision) {}
  template <class Rational, class = std::enable_if_t<has_enclosures_v<Rational>>>
  Mpfr_interval(const Rational& value, mpfr_prec_t precision)
      : Mpfr_interval(internal::rational_data(value), precision) {}

  /// +1 or -1 where every value has that sign, else 0.
  [[nodiscard]] int certain_sign() const { return lo_.sign() > 0 ? 1 : (hi_.sign() < 0 ? -1 : 0); }
  /// The nearest doubles that enclose it, infinite where there are none.
  [[nodiscard]] double lower() const { return mpfr_get_d(lo_.get(), MPFR_RNDD); }
  [[nodiscard]] double upper() const { return mpfr_get_d(hi_.get(), MPFR_RNDU); }
  [[nodiscard]] double middle() const {
    return (mpfr_get_d(lo_.get(), MPFR_RNDN) + mpfr_get_d(hi_.get(), MPFR_RNDN)) / 2;
  }
  /// The width over the least magnitude; 0 for a single number, infinity for other intervals that hold 0 or are
  /// unbounded.
  [[nodiscard]] double relative_width() const;

  friend Mpfr_interval operator-(const Mpfr_interval& a);
  friend Mpfr_interval operator+(const Mpfr_interval& a, const Mpfr_interval& b);
  friend Mpfr_interval operator-(const Mpfr_interval& a, const Mpfr_interval& b);
  friend Mpfr_interval operator*(const Mpfr_interval& a, const Mpfr_interval& b);
  friend Mpfr_interval operator/(const Mpfr_interval& a, const Mpfr_interval& b);
  friend Mpfr_interval sqrt(const Mpfr_interval& a);
  friend Mpfr_interval max BOOST_PREVENT_MACRO_SUBSTITUTION(const Mpfr_interval& a, const Mpfr_interval& b);
  /// The interval that holds both.
  friend Mpfr_interval joined(const Mpfr_interval& a, const Mpfr_interval& b);
  friend Mpfr_interval abs(const Mpfr_interval& a) { return max BOOST_PREVENT_MACRO_SUBSTITUTION(a, -a); }
  friend CGAL::Uncertain<bool> operator<(const Mpfr_interval& a, const Mpfr_interval& b);
  friend CGAL::Uncertain<bool> operator>(const Mpfr_interval& a, const Mpfr_interval& b) { return b < a; }
  friend CGAL::Uncertain<bool> operator==(const Mpfr_interval& a, const Mpfr_interval& b) { return !(a != b); }
  friend CGAL::Uncertain<bool> operator!=(const Mpfr_interval& a, const Mpfr_interval& b);

 private:
  struct Precision {
    mpfr_prec_t bits;
  };
  Mpfr_interval(mpq_srcptr value, mpfr_prec_t precision) : Mpfr_interval(Precision{precision}) {
    mpfr_set_q(lo_.get(), value, MPFR_RNDD);
    mpfr_set_q(hi_.get(), value, MPFR_RNDU);
  }
  explicit Mpfr_interval(Precision p) : lo_(p.bits), hi_(p.bits) {}
  [[nodiscard]] mpfr_prec_t precision() const { return mpfr_get_prec(lo_.get()); }
  [[nodiscard]] static mpfr_prec_t joint(const Mpfr_interval& a, const Mpfr_interval& b) {
    return (std::max)(a.precision(), b.precision());
  }
  [[nodiscard]] static Mpfr_interval whole(mpfr_prec_t precision);
  using Operation = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
  [[nodiscard]] static Mpfr_interval by_signs(const Mpfr_interval& a, const Mpfr_interval& b,
                                              const internal::Mpfr_number& b_low, const internal::Mpfr_number& b_high,
                                              Operation operation);

  internal::Mpfr_number lo_, hi_;
};

}  // namespace CGAL::Bounding_arcs

#endif

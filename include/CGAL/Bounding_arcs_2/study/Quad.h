// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers of 113 bits, __float128 where a compiler has it: a class, as functions of the standard library take no such
// number.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_QUAD_H
#define CGAL_BOUNDING_ARCS_2_STUDY_QUAD_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <cmath>

#if defined(__SIZEOF_FLOAT128__) || defined(DOXYGEN)

/// \cond
__extension__ typedef __float128 bounding_arcs_float128;  // NOLINT: an alias with `using` would be warned of
/// \endcond

namespace CGAL::Bounding_arcs {

/// A __float128 with what formulas under study need. Nothing is to be linked for it: arithmetic is the compiler's, and
/// a formula of one's own that calls functions of libquadmath links that with -lquadmath.
/// \code
/// study.add<__float128>("quad");  // add<Quad> is the same
/// \endcode
/// \guarantee sums, products and quotients are rounded to nearest; square roots are within 1 ulp, 2^-112 of them
class Quad {
 public:
  using Value = bounding_arcs_float128;

  Quad(Value x = 0) : value_(x) {}  // NOLINT: a number type converts from int and from double

  [[nodiscard]] Value value() const { return value_; }
  explicit operator double() const { return static_cast<double>(value_); }

  friend Quad operator-(const Quad& a) { return Quad(-a.value_); }
  friend Quad operator+(const Quad& a, const Quad& b) { return Quad(a.value_ + b.value_); }
  friend Quad operator-(const Quad& a, const Quad& b) { return Quad(a.value_ - b.value_); }
  friend Quad operator*(const Quad& a, const Quad& b) { return Quad(a.value_ * b.value_); }
  friend Quad operator/(const Quad& a, const Quad& b) { return Quad(a.value_ / b.value_); }
  // Two steps of Newton's from the root in long double, whose exponents have the same range. The last one is off by
  // half an ulp of the product r r, which is a quarter of one in r, and by the rounding of the sum.
  friend Quad sqrt(const Quad& a) {
    const Value x = a.value_;
    if (!(x > 0) || x - x != 0) return x < 0 ? Quad((x - x) / (x - x)) : a;
    Value r = std::sqrt(static_cast<long double>(x));
    for (int step = 0; step < 2; ++step) r += (x - r * r) / (2 * r);
    return Quad(r);
  }
  friend Quad abs(const Quad& a) { return a.value_ < 0 ? -a : a; }
  friend bool operator<(const Quad& a, const Quad& b) { return a.value_ < b.value_; }
  friend bool operator>(const Quad& a, const Quad& b) { return a.value_ > b.value_; }
  friend bool operator==(const Quad& a, const Quad& b) { return a.value_ == b.value_; }
  friend bool operator!=(const Quad& a, const Quad& b) { return !(a == b); }

 private:
  Value value_;
};

namespace study {

/// The class that a formula gets for a number type.
template <class NT> struct Studied_type { using Type = NT; };
/// Quad for __float128.
template <> struct Studied_type<bounding_arcs_float128> { using Type = Quad; };

}  // namespace study
}  // namespace CGAL::Bounding_arcs

#else

namespace CGAL::Bounding_arcs::study {
template <class NT> struct Studied_type { using Type = NT; };
}  // namespace CGAL::Bounding_arcs::study

#endif

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the constructions ask of a number type: whether it has square roots, a power of two near a number, and
// conversions that keep the value.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_NUMBER_TYPES_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_NUMBER_TYPES_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace CGAL::Bounding_arcs {

/// True for number types whose CGAL traits have an exact or correctly rounded square root.
template <class NT>
inline constexpr bool has_square_root_v =
    !std::is_same_v<typename CGAL::Algebraic_structure_traits<NT>::Sqrt, CGAL::Null_functor>;

/// sqrt of the number type's own namespace, or of std for fundamental types.
template <class NT> [[nodiscard]] NT square_root(const NT& x) {
  using std::sqrt;
  return NT(sqrt(x));
}

/// -1, 0 or +1.
template <class NT> [[nodiscard]] int sign_of(const NT& x) { return x > NT(0) ? 1 : (x < NT(0) ? -1 : 0); }

/// x < y for certain: for enclosures and bounded numbers every value of x is less than every value of y.
template <class NT> [[nodiscard]] bool certainly_less(const NT& x, const NT& y) { return CGAL::certainly(x < y); }

/// |x|, by comparison with 0.
template <class NT> [[nodiscard]] NT absolute(const NT& x) { return x < NT(0) ? NT(-x) : x; }

/// The larger of two numbers; of two enclosures an enclosure of it.
template <class NT> [[nodiscard]] NT larger(const NT& x, const NT& y) {
  using std::max;
  return NT(max BOOST_PREVENT_MACRO_SUBSTITUTION(x, y));
}

/// The result of a choice between x and y that is open: for enclosures an enclosure of both, for other numbers y.
template <class NT> [[nodiscard]] auto joined(const NT& x, const NT& y) -> decltype(NT(x.inf(), y.sup())) {
  return NT((std::min)(x.inf(), y.inf()), (std::max)(x.sup(), y.sup()));
}
template <class NT, class... None> [[nodiscard]] NT joined(const NT&, const NT& y, None...) { return y; }

/// x, known to lie between 0 and limit(): numbers without an error bound stay what they are.
template <class NT, class Limit> [[nodiscard]] NT limited(const NT& x, const Limit&) { return x; }

/// A unit in the last place of x >= 0: from it to the next double.
[[nodiscard]] inline double ulp_of(double x) {
  std::uint64_t bits;  // those of the next number are one more
  std::memcpy(&bits, &x, sizeof bits);
  ++bits;
  double next;
  std::memcpy(&next, &bits, sizeof next);
  return next - x;
}

}  // namespace CGAL::Bounding_arcs

#endif

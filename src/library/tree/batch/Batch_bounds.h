// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a batch tells of a piece's thickness, and how its error bounds are added up.
//
// Why errors add up.  A formula here is a product of powers of factors, or a sum of terms of one sign of such products,
// where a sum is no worse than its worst term.  If each factor is off by (1 + e_i) with small e_i, the result is by
// prod (1 + e_i)^w_i, which is exp(S) at most in either direction, S = sum |w_i e_i| (1 + max e_i).  S is below 2^-8 in
// double and below 2^-5 in float (LARGEST_SUM), so exp(S) - 1 - S <= 0.52 S^2 (with_second_order), and the constants
// are rounded up by more than that.  The few differences are treated where they occur.  Roundings of a formula itself
// are Local_precision::OPERATION_ROUNDINGS, and are part of each sum, as are omitted terms of series.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_BATCH_BOUNDS_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_BATCH_BOUNDS_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include "../../spiral/Local_figures.h"
#include "Batch_questions.h"

#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL::Bounding_arcs::filter {

/// What derivations count in: the relative error of a figure that is at least its least value (rho), and of an N or
/// kneser of certain sign (epsilon).
template <class Real> inline constexpr double RHO = 1 / double(Local_precision<Real>::DIGITS);
template <class Real> inline constexpr double EPSILON = 1 / double(Local_precision<Real>::CERTAIN);
/// Roundings of a formula, in parts of rho.
template <class Real> inline constexpr double OF_OPERATIONS = Local_precision<Real>::OPERATION_ROUNDINGS;

template <class Real> inline constexpr double LARGEST_SUM = 0;
template <> inline constexpr double LARGEST_SUM<double> = 0x1p-8;
template <> inline constexpr double LARGEST_SUM<float> = 0x1p-5;

/// exp(sum) - 1 at most.
template <class Real> [[nodiscard]] constexpr double with_second_order(double sum) {
  return sum <= LARGEST_SUM<Real> ? sum + 0.52 * sum * sum : std::numeric_limits<double>::infinity();
}
/// Whether a constant is no less than what its derivation needs, and no more than `most` times that: then constant and
/// derivation are to be changed together.
[[nodiscard]] constexpr bool covers(double constant, double needed, double most = 1.25) {
  return constant >= needed && constant <= most * needed;
}

template <class Real> [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Real smaller(Real x, Real y) { return x < y ? x : y; }

/// Whether the osculating circle at one end holds that at the other for certain, as on spirals: whether
///   r0 r1 = N^2 |T0|^2 |T1|^2 / (l0 l1 cos^2 delta kneser0 kneser1) < 1,
/// which is 1/4 on short ones. Otherwise a single piece falls back to BCA, as slivers across a vertex do that ends of
/// segments may hold; so this is asked in all forms.
/// \param product (T0.D)(T1.D), or l0 l1 cos^2 delta, which is no less
/// \pre N and the knesers have certain signs
template <class Real>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE bool are_nested(Real numerator, Real product, const Local_ends<Real>& e) {
  // above the errors of N, twice, of both knesers, and of two squares and two dots
  constexpr double ERROR = 4 * EPSILON<Real> + (2 + 2 + OF_OPERATIONS<Real>)*RHO<Real>, ROOM = 3.5;
  constexpr Real MARGIN = 1 + Real(0x1p-4);
  static_assert(double(MARGIN) >= 1 + with_second_order<Real>(ERROR), "update the derivation above");
  static_assert(!std::is_same_v<Real, float> || covers(double(MARGIN) - 1, ROOM * ERROR), "MARGIN has this room");
  return MARGIN * (numerator * numerator) * (e.square0 * e.square1) <= product * (e.kneser0 * e.kneser1);
}

/// A thickness is scale (value +- value relative +- absolute). Where `holds` is false, or lengths leave the range of
/// double, the bracket is -1 and infinity: the formula tells nothing.
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Bracket scaled_bounds(double scale, double value, double relative,
                                                              double absolute, bool holds) {
  const double middle = scale * value,
               error = middle * relative + scale * absolute + Local_precision<double>::UNDERFLOW_LENGTH;
  const double lower = middle - error, upper = middle + error;
  const bool is_finite = upper < std::numeric_limits<double>::infinity();
  return {(holds & is_finite) ? lower : -1.0, (holds & is_finite) ? upper : std::numeric_limits<double>::infinity()};
}

// The figures of a batch's pieces in float: made in one loop and used in the next, as turns of loops with short chains
// of operations overlap, and those of one long loop do not.
//
// Float decides nearly all pieces, and those that it cannot are decided again in double, so its formulas are short:
// products under one or two fraction bars, no series, and one bound E of the relative error for all pieces (ROUGH_ERROR
// of each method) instead of one for each.  E counts the worst that all figures can do together; on random pieces it is
// used up to a twentieth, on pieces sought for it up to a fifteenth.

/// The figures of up to 64 pieces.
struct alignas(BATCH_ALIGNMENT) Rough_figures {
  float chord_square[BATCH_SIZE], p[BATCH_SIZE], r[BATCH_SIZE], a[BATCH_SIZE], d[BATCH_SIZE];
  float square0[BATCH_SIZE], square1[BATCH_SIZE], turn_rate0[BATCH_SIZE], turn_rate1[BATCH_SIZE], kneser0[BATCH_SIZE],
      kneser1[BATCH_SIZE];

  CGAL_BOUNDING_ARCS_INLINE void set(std::size_t j, const Local_piece<float>& g) {
    chord_square[j] = g.chord_square;
    p[j] = g.p;
    r[j] = g.r;
    a[j] = g.a;
    d[j] = g.d;
  }
  CGAL_BOUNDING_ARCS_INLINE void set(std::size_t j, const Local_piece<float>& g, const Local_ends<float>& e) {
    set(j, g);
    square0[j] = e.square0;
    square1[j] = e.square1;
    turn_rate0[j] = e.turn_rate0;
    turn_rate1[j] = e.turn_rate1;
    kneser0[j] = e.kneser0;
    kneser1[j] = e.kneser1;
  }
  /// What was set. \param half half the pieces' length
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Local_piece<float> piece(std::size_t j, float half) const {
    Local_piece<float> g{};
    g.half = half;
    g.square = half * half;
    g.chord_square = chord_square[j];
    g.p = p[j];
    g.r = r[j];
    g.a = a[j];
    g.d = d[j];
    return g;
  }
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Local_ends<float> ends(std::size_t j) const {
    return {square0[j], square1[j], turn_rate0[j], turn_rate1[j], kneser0[j], kneser1[j]};
  }
};

}  // namespace CGAL::Bounding_arcs::filter

#endif

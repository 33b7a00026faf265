// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a batch tells of a piece's thickness.

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_BATCH_BOUNDS_H
#define CGAL_BOUNDING_ARCS_2_FILTER_BATCH_BOUNDS_H

#include <CGAL/Bounding_arcs_2/spiral/Local_curve.h>

#include <cstddef>
#include <limits>

namespace CGAL::Bounding_arcs::filter {

inline constexpr std::size_t BATCH_SIZE = 64;
inline constexpr std::size_t BATCH_ALIGNMENT = 64;  ///< of arrays: bytes of the widest register

template <class Real> [[nodiscard, gnu::always_inline]] inline Real smaller(Real x, Real y) { return x < y ? x : y; }

/// Whether the osculating circle at one end holds that at the other for certain, as on spirals: r0 r1 = N^2 |T0|^2
/// |T1|^2 / (P k0 k1), with P = l0 l1 cos^2 delta or less, is 1/4 on short ones. \pre N and the knesers have certain
/// signs
template <class Real>
[[nodiscard, gnu::always_inline]] inline bool are_nested(Real numerator, Real product, const Local_ends<Real>& e) {
  constexpr Real MARGIN = 1 + Real(0x1p-4);  // above the errors of N and knesers, both twice
  return MARGIN * (numerator * numerator) * (e.square0 * e.square1) <= product * (e.kneser0 * e.kneser1);
}

/// lower <= thickness <= upper; -1 and infinity where the formula does not hold.
struct Batch_bounds {
  double lower, upper;
};

/// scale (value +- value relative +- absolute); nothing where `holds` is false, or lengths leave the range of double.
[[nodiscard, gnu::always_inline]] inline Batch_bounds scaled_bounds(double scale, double value, double relative,
                                                                    double absolute, bool holds) {
  const double middle = scale * value,
               error = middle * relative + scale * absolute + Local_precision<double>::UNDERFLOW_LENGTH;
  const double lower = middle - error, upper = middle + error;
  const bool is_finite = upper < std::numeric_limits<double>::infinity();
  return {(holds & is_finite) ? lower : -1.0, (holds & is_finite) ? upper : std::numeric_limits<double>::infinity()};
}

}  // namespace CGAL::Bounding_arcs::filter

#endif

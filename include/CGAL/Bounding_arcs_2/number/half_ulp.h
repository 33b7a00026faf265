// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The unit of rounding errors, and factors that make up for a few of them.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_HALF_ULP_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_HALF_ULP_H

namespace CGAL::Bounding_arcs {

/// u, half an ulp of 1: an operation rounded to nearest is exact but for a factor of 1 + d, |d| <= u, above underflow.
inline constexpr double HALF_ULP = 0x1p-53;

/// A positive number that has been rounded K - 2 times at most is no less than the exact one after it is multiplied by
/// ROUNDED_UP<K>, and no greater after ROUNDED_DOWN<K>. The product is rounded, too:
///   (1 - u)^(K-1) (1 + K u) >= (1 - (K-1) u) (1 + K u) = 1 + u - K (K-1) u^2 >= 1,
///   (1 + u)^(K-1) (1 - K u) <= (1 + (K-1) u + K^2 u^2) (1 - K u) <= 1 - u + K^2 u^2 <= 1.
template <int K> inline constexpr double ROUNDED_UP = 1 + K* HALF_ULP;
template <int K> inline constexpr double ROUNDED_DOWN = 1 - K* HALF_ULP;

}  // namespace CGAL::Bounding_arcs

#endif

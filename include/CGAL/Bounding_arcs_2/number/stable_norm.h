// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The length of a vector whose squares may be too large or too small, with the same bits on all machines.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_STABLE_NORM_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_STABLE_NORM_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Bounding_arcs {

/// The length of a vector with coordinates in floating point. `std::hypot` differs by an ulp between C libraries.
/// \guarantee within 2 u of itself, u half an ulp of 1: each square and their sum err by u, the root halves these and
///   adds u. Only a length below the least normal number errs by more, by half of the least number above 0
template <class FT> [[nodiscard]] FT stable_norm(const Xy<FT>& v) {
  using Limits = std::numeric_limits<FT>;
  // What a square loses by underflow is at most 2 u^2 of LEAST.
  constexpr FT LEAST = Limits::min() / Limits::epsilon(), MOST = Limits::max();
  const FT square = dot(v, v);
  if (std::isnan(square)) return square;
  if (LEAST < square && square <= MOST) return std::sqrt(square);
  const FT larger = (std::max)(std::fabs(v.x), std::fabs(v.y));
  if (!(larger > FT(0)) || std::isinf(larger)) return larger;
  const int exponent = std::ilogb(larger);
  const Xy<FT> scaled{std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent)};
  return std::scalbn(std::sqrt(dot(scaled, scaled)), exponent);
}

}  // namespace CGAL::Bounding_arcs

#endif

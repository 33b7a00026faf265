// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The measure by which leaves of about equal thickness are made: a thickness rounded up to few digits, so that it is
// the same whoever bounded the thickness, and breaks are where they are without a filter and in every kernel.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_THICKNESS_MEASURE_H
#define CGAL_BOUNDING_ARCS_2_TREE_THICKNESS_MEASURE_H

#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace CGAL::Bounding_arcs {

/// Digits of measures: moves breaks by 2^-13 / 3 of a piece; twice as many would leave more open.
inline constexpr int MEASURE_BITS = 12;
/// x >= 0 rounded up to MEASURE_BITS significant bits.
[[nodiscard]] inline double rounded_measure(double x) {
  constexpr std::uint64_t REST = (std::uint64_t(1) << (53 - MEASURE_BITS)) - 1;
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits = (bits + REST) & ~REST;
  std::memcpy(&x, &bits, sizeof bits);
  return x;
}

/// \param upper an upper bound of the piece's thickness, as a rule within 2^-20 of it
/// \param bound decides pieces against an eps
/// \return at least the thickness, at most eps where `upper` is; the least number of MEASURE_BITS bits that is, but
///   where `upper` is farther above the thickness
template <class Piece, class Bound>
[[nodiscard]] double thickness_measure(double upper, const Piece& piece, double eps, const Bound& bound) {
  constexpr double CLOSE = 0x1p-20;
  double measure = rounded_measure(upper);
  const double less = rounded_measure(upper * (1 - CLOSE));
  if (less < measure && bound(piece, less).within) measure = less;
  return upper <= eps ? (std::min)(measure, eps) : measure;
}

/// The traits' Bound_thickness_2 over floating numbers; for exact ones the filtered kernel's, which decides the same
/// and bounds thickness in doubles.
template <class Traits> class Measure_bound {
  struct In_double {
    typename Traits::Construction construction;
    template <class Source> [[nodiscard]] Thickness_bound operator()(const Source& source, double eps) const {
      return bound_thickness<double, true>(construction, source, eps);
    }
  };
  static constexpr bool IS_FLOATING = std::is_floating_point_v<typename Traits::FT>;
  [[nodiscard]] static auto bound_of(const Traits& traits) {
    if constexpr (IS_FLOATING) return traits.bound_thickness_2_object();
    else return In_double{traits.construction()};
  }

 public:
  explicit Measure_bound(const Traits& traits) : bound_(bound_of(traits)) {}
  template <class Source> [[nodiscard]] Thickness_bound operator()(const Source& source, double eps) const {
    return bound_(source, eps);
  }

 private:
  decltype(bound_of(std::declval<const Traits&>())) bound_;
};

}  // namespace CGAL::Bounding_arcs

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a spiral segment lies on the curves of a drawing, and why it ends there.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_SEGMENT_PLACE_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_SEGMENT_PLACE_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Why a spiral segment ends where it does.
enum class Cut_reason : std::uint8_t {
  END,         ///< an end of an open curve
  JOINT,       ///< of two Bezier pieces of a curve, or where curves meet
  CUSP,        ///< C' vanishes
  X,           ///< x' vanishes
  Y,           ///< y' vanishes
  INFLECTION,  ///< curvature vanishes
  VERTEX       ///< the derivative of curvature vanishes
};

// Cuts at most this far apart, or from an end, are one: four spacings of doubles below 1. Points of the curve that near
// differ by up to |C'| 2^-51 <= 2 n 2^-51 max|P|, n the degree, about what rounding takes from two of them.
// Ten times wider swallows segments whose ends are different points; ten times narrower leaves slivers at the cusps
// that rounding of control points has pulled apart, and where curvature is zero on a knot of a B-spline.
inline constexpr double CUT_WIDTH = 0x1p-51;

/// A segment's Bezier piece, by number, and what its ends are.
struct Segment_place {
  std::uint32_t curve = 0, bezier = 0;
  Cut_reason first = Cut_reason::END, last = Cut_reason::END;
};

/// A point of a drawing: what every answer about one can say.
struct Curve_place {
  std::uint32_t curve, bezier;
  double t;  ///< of the Bezier piece, in [0, 1]

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Curve_place& answer) {
    return out << answer.curve << ' ' << answer.bezier << ' ' << answer.t;
  }
};

namespace internal {

/// The range of segments of one curve. \pre segments are in the order of their curves
template <class Spiral> struct Segments_of_curve {
  std::size_t begin, end;
  bool is_closed;

  Segments_of_curve(const std::vector<Spiral>& spirals, std::size_t i) {
    const auto curve = [](const Spiral& s) { return s.place().curve; };
    const std::uint32_t own = curve(spirals[i]);
    const auto at = [&](auto is_before) {
      return static_cast<std::size_t>(std::partition_point(spirals.begin(), spirals.end(), is_before) -
                                      spirals.begin());
    };
    begin = at([&](const Spiral& s) { return curve(s) < own; });
    end = at([&](const Spiral& s) { return curve(s) <= own; });
    is_closed = spirals[begin].place().first == Cut_reason::JOINT;
  }
};

}  // namespace internal

/// The segment that follows segment i along its curve, which is the first one behind the last of a closed curve.
/// \param spirals in the order of their curves, as a drawing gives them
/// \return nothing at the end of an open curve
/// \complexity logarithmic in the number of segments
template <class Spiral>
[[nodiscard]] std::optional<std::size_t> segment_after(const std::vector<Spiral>& spirals, std::size_t i) {
  const internal::Segments_of_curve<Spiral> curve(spirals, i);
  if (i + 1 < curve.end) return i + 1;
  return curve.is_closed ? std::optional(curve.begin) : std::nullopt;
}
/// The segment before it, the other way round.
template <class Spiral>
[[nodiscard]] std::optional<std::size_t> segment_before(const std::vector<Spiral>& spirals, std::size_t i) {
  const internal::Segments_of_curve<Spiral> curve(spirals, i);
  if (i > curve.begin) return i - 1;
  return curve.is_closed ? std::optional(curve.end - 1) : std::nullopt;
}

}  // namespace CGAL::Bounding_arcs

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is a piece's region thin enough?  Plain double, double with its error bound, interval, exact: the first that decides.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_THICKNESS_BOUND_H
#define CGAL_BOUNDING_ARCS_2_REGION_THICKNESS_BOUND_H

#include <CGAL/Bounding_arcs_2/frame/Tight_frame_2.h>
#include <CGAL/Bounding_arcs_2/frame/accurate_shape.h>
#include <CGAL/Bounding_arcs_2/frame/bezier_chord_shape.h>
#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/number/Root_number.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Bounding_arcs {

/// \guarantee certified: upper >= the thickness of the exact region over the exact piece, and upper <= eps if within.
///   Over floating types without exact decisions the region is the one of the form (turn, tight end, step back to BCA)
///   that the rounded numbers take; where rounding leaves no bound of its thickness, upper bounds the distance between
///   the region's boundaries instead (see triangle_height). Where decisions are exact the form is too.
struct Thickness_bound {
  bool within = false;
  double upper = std::numeric_limits<double>::infinity();
  bool was_exact = false;  ///< more than double with an error bound was needed
  int bits = 53;           ///< of the numbers that decided, doubles or longer enclosures; 0 of exact expressions
};

/// Whether a kernel over floating numbers decides exactly.
template <class Kernel, class = void> inline constexpr bool has_exact_decisions_v = false;
template <class Kernel>
inline constexpr bool
    has_exact_decisions_v<Kernel, std::void_t<typename Kernel::Linear_kernel::Has_filtered_predicates_tag>> =
        Kernel::Linear_kernel::Has_filtered_predicates_tag::value&& std::is_floating_point_v<typename Kernel::FT>;

/// The parts of a chord shape that a construction reads.
template <class Construction> [[nodiscard]] Shape_parts shape_parts() {
  return {Construction::NEEDS_CURVATURE, Construction::NEEDS_CONTROL_POINTS};
}

/// A double that is at least the thickness, whatever the branch the value took; infinity where it makes no sense.
inline double certified_upper(const Bounded_double& thickness) {
  const double upper = thickness.upper();
  return std::isnan(upper) ? std::numeric_limits<double>::infinity() : (std::max)(0.0, upper);
}

namespace internal {
/// An interval that holds the thickness; all numbers from 0 where a comparison in it is open.
template <class Construction, class NT>
[[nodiscard]] CGAL::Interval_nt<true> thickness_interval(const Construction& construction,
                                                         const Chord_shape_2<NT>& shape) {
  using Interval = CGAL::Interval_nt<true>;
  const Interval all(0, std::numeric_limits<double>::infinity());
  try {
    const Interval thickness = construction.thickness(shape.template over<Interval>());
    return CGAL::is_finite(thickness) && CGAL::is_valid(thickness) ? thickness : all;
  } catch (const CGAL::Uncertain_conversion_exception&) {
    return all;
  }
}
}  // namespace internal

/// The thickness in an enclosure of `bits` bits, nothing where these leave open which formula holds.
template <class Construction, class Exact>
[[nodiscard]] std::optional<Mpfr_interval> thickness_enclosure(const Construction& construction,
                                                               const Chord_shape_2<Exact>& shape, mpfr_prec_t bits) {
  try {
    return construction.thickness(
        shape.template over<Mpfr_interval>([bits](const Exact& x) { return Mpfr_interval(x, bits); }));
  } catch (const CGAL::Uncertain_conversion_exception&) {
    return std::nullopt;
  }
}

namespace internal {
/// Decided by an interval of doubles, by enclosures of more and more bits and, where thickness may equal eps, by an
/// expression with square roots.
template <class Exact, class Construction>
[[nodiscard]] Thickness_bound bound_exactly(const Construction& construction, const Chord_shape_2<Exact>& shape,
                                            double eps) {
  const CGAL::Interval_nt<true> range = thickness_interval(construction, shape);
  double upper = range.sup();
  const auto answer = [&upper](bool within, int bits = 53) {
    return Thickness_bound{within, (std::max)(0.0, upper), true, bits};
  };
  if (upper <= eps) return answer(true);
  if (range.inf() > eps && upper < std::numeric_limits<double>::infinity()) return answer(false);
  if constexpr (has_enclosures_v<Exact>) {
    constexpr mpfr_prec_t FIRST = 128, LAST = 4096;  // beyond, numbers of these formulas are equal or hardly ever met
    for (mpfr_prec_t bits = FIRST; bits <= LAST; bits *= 4) {
      const std::optional<Mpfr_interval> thickness = thickness_enclosure(construction, shape, bits);
      if (!thickness) continue;
      upper = (std::min)(upper, thickness->upper());
      if (upper <= eps) return answer(true, static_cast<int>(bits));
      if (thickness->lower() >= eps && CGAL::certainly(Mpfr_interval(CGAL::Exact_rational(eps), bits) < *thickness))
        return answer(false, static_cast<int>(bits));
    }
  }
  using Root = std::conditional_t<has_square_root_v<Exact>, Exact, Root_number>;
  const Root thickness = construction.thickness(shape.template over<Root>());
  upper = (std::min)(upper, CGAL::to_interval(thickness).second);
  const bool within = !(Root(eps) < thickness);
  if (within) upper = (std::min)(upper, eps);
  return answer(within, 0);
}

/// The height over the chord of the triangle of chord and end tangents, which holds both boundaries: the outer one is
/// nowhere farther than that from the chord, and the inner one lies between.  With half-angle tangents up to b it is at
/// most c b / (1 - b^2), and as a spiral turns by at most a right angle never more than c.
inline double triangle_height(const Chord_shape_2<Bounded_double>& f) {
  const Chord_angles_2<Bounded_double> g = f.angles();
  const Bounded_double b = larger(abs(g.bulge0), abs(g.bulge1)), c = g.chord * f.unit;
  const double height = certified_upper(c * b / (Bounded_double(1) - b * b)), chord = certified_upper(c);
  return b.upper() < 0.5 ? (std::min)(height, chord) : chord;
}

/// Whether a number's sign is certain.
[[nodiscard]] inline bool is_signed(const Bounded_double& x) { return x.lower() > 0 || x.upper() < 0; }
/// Whether a double-double's sign is certain.
[[nodiscard]] inline bool is_signed(const Double_double& x) { return x.sign().value_or(0) != 0; }
}  // namespace internal

/// Whether a construction takes lines and arcs for something else, so that rounding must not: it then has a member
/// NEEDS_CERTAIN_TURN, true.
template <class Construction, class = void> inline constexpr bool needs_certain_turn_v = false;
template <class Construction>
inline constexpr bool needs_certain_turn_v<Construction, std::void_t<decltype(Construction::NEEDS_CERTAIN_TURN)>> =
    Construction::NEEDS_CERTAIN_TURN;

namespace internal {
/// Whether turn, tight end and steps back to a simpler region would be the same in exact arithmetic.
/// \tparam NT Bounded_double or Double_double
template <class Construction, class NT> [[nodiscard]] bool is_form_certain(const Chord_shape_2<NT>& f) {
  if (!is_signed(dot(f.tangent0, f.chord)) || !is_signed(dot(f.tangent1, f.chord))) return false;
  if (needs_certain_turn_v<Construction> && (!is_signed(f.cross0 + f.cross1) || !is_signed(f.sine_change)))
    return false;
  if (!Construction::NEEDS_CURVATURE) return true;
  if (!f.proper || !is_signed(f.cross0 + f.cross1) || !is_signed(f.square_change)) return false;
  if ((!f.infinite0 && !is_signed(f.kneser0)) || (!f.infinite1 && !is_signed(f.kneser1))) return false;
  const Tight_frame_2<NT> t = tight_frame(f);
  return t.usable && is_signed(t.sin_delta) &&
         (t.infinite || is_signed(NT(1) - t.sin_delta / t.a * (t.sin_delta / t.b)));
}
}  // namespace internal

/// Whether a segment has shapes in double-doubles.
template <class Spiral, class = void> inline constexpr bool has_accurate_shape_v = false;
template <class Spiral>
inline constexpr bool
    has_accurate_shape_v<Spiral, std::void_t<decltype(std::declval<const Spiral&>().accurate_shape(0.0, 1.0))>> = true;

/// The exact thickness of the piece [t0, t1] rounded up: from double-doubles, and from enclosures over the exact shape
/// where these leave more than some ulp open.
/// \tparam Spiral Bezier_spiral_2
/// \guarantee certified, and at most 16 ulp above, of sizes above 2^-900, but where 4096 bits do not tell the formula:
///   nothing is returned then
/// \complexity about two microseconds for a cubic, some ten in exact arithmetic
template <class Construction, class Spiral>
[[nodiscard]] std::optional<double> sharp_thickness(const Construction& construction, const Spiral& spiral, double t0,
                                                    double t1) {
  constexpr double SHARP = 0x1p-51;  // half of 8 ulp at most
  const auto parts = shape_parts<Construction>();
  const auto shape = in_range(spiral.template shape<Double_double>(t0, t1, parts));
  if (internal::is_form_certain<Construction>(shape)) {
    const Double_double thickness = construction.thickness(shape);
    if (thickness.hi > 0x1p-900 && thickness.err <= SHARP * thickness.hi) return thickness.upper();
  }
  using Exact = typename Spiral::Exact_number_type;
  if constexpr (has_enclosures_v<Exact>) {
    const Chord_shape_2<Exact> exact = spiral.template shape<Exact>(t0, t1, parts);
    for (mpfr_prec_t bits = 128; bits <= 4096; bits *= 2) {
      const std::optional<Mpfr_interval> thickness = thickness_enclosure(construction, exact, bits);
      if (!thickness) continue;
      const double lower = thickness->lower(), upper = (std::max)(0.0, thickness->upper());
      if (upper == 0 || upper - lower <= 4 * SHARP * upper) return upper;
    }
  }
  return std::nullopt;
}

/// Decisions of floating kernels: a bounded number tells as a rule, and the exact shape where it leaves the form open
/// or, for exact decisions, the comparison.
template <class FT, bool ExactDecisions, class Construction, class ShapeSource>
[[nodiscard]] Thickness_bound bound_thickness(const Construction& construction, const ShapeSource& source, double eps) {
  using Exact = typename ShapeSource::Exact_number_type;
  constexpr bool HAS_EXACT_SHAPE = !std::is_same_v<Exact, Bounded_double>;
  static_assert(
      (std::is_floating_point_v<FT> && !ExactDecisions) || HAS_EXACT_SHAPE,
      "a curve that is known in double only has no exact decisions: use a kernel such as Simple_cartesian<double>");
  const auto parts = shape_parts<Construction>();
  const auto decide_exactly = [&] {
    if constexpr (HAS_EXACT_SHAPE)
      return internal::bound_exactly(construction, source.template shape<Exact>(parts), eps);
    else return Thickness_bound{};
  };
  if constexpr (!std::is_floating_point_v<FT>) {
    return decide_exactly();
  } else {
    const Chord_shape_2<Bounded_double> shape = source.template shape<Bounded_double>(parts);
    if constexpr (HAS_EXACT_SHAPE)
      if (!internal::is_form_certain<Construction>(shape)) return decide_exactly();
    const Bounded_double thickness = construction.thickness(shape);
    double upper = certified_upper(thickness);
    if (upper <= eps) return {true, upper, false};
    // Regions of arcs are no thicker than their chords: where one seems to be, rounding has taken all digits.
    const double chord = stable_norm(Xy<double>{shape.chord.x.value(), shape.chord.y.value()}) * shape.unit.value();
    const bool is_lost = !(upper <= chord);
    if constexpr (HAS_EXACT_SHAPE) {
      if (is_lost || (ExactDecisions && !(thickness.lower() > eps))) return decide_exactly();
      return {false, upper, false};
    } else {
      // The triangle of the end tangents still bounds it.
      const bool is_unbounded = !(upper < std::numeric_limits<double>::infinity());
      if (is_lost) upper = (std::min)(upper, internal::triangle_height(shape));
      return {is_unbounded && upper <= eps, upper, false};
    }
  }
}

}  // namespace CGAL::Bounding_arcs

#endif

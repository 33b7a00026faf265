// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is a piece's region thin enough?  Plain double, double with its error bound, interval, exact: the first that decides.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_THICKNESS_BOUND_H
#define CGAL_BOUNDING_ARCS_2_REGION_THICKNESS_BOUND_H

#include <CGAL/Bounding_arcs_2/internal/core_numbers.h>
#include <CGAL/Bounding_arcs_2/region/Tight_frame_2.h>
#include <CGAL/Bounding_arcs_2/spiral/bezier_chord_shape.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL::Bounding_arcs {

/// \guarantee certified: upper >= the thickness of the exact region over the exact piece, and upper <= eps if within.
///   Over floating types without exact decisions the region is the one of the form (turn, tight end, step back to BCA)
///   that the rounded numbers take; where rounding leaves no bound of its thickness, upper bounds the distance between the
///   region's boundaries instead (see triangle_height). Where decisions are exact the form is too.
struct Thickness_bound {
  bool within = false;
  double upper = std::numeric_limits<double>::infinity();
  bool was_exact = false;  ///< more than double with an error bound was needed
};

namespace internal {

template <class Kernel, class = void>
inline constexpr bool has_exact_decisions_v = false;
template <class Kernel>
inline constexpr bool has_exact_decisions_v<Kernel, std::void_t<typename Kernel::Linear_kernel::Has_filtered_predicates_tag>> =
    Kernel::Linear_kernel::Has_filtered_predicates_tag::value && std::is_floating_point_v<typename Kernel::FT>;

template <class Construction>
[[nodiscard]] Shape_parts shape_parts() {
  return {Construction::NEEDS_CURVATURE, Construction::NEEDS_CONTROL_POINTS};
}

/// A double that is at least the thickness, whatever the branch the value took; infinity where it makes no sense.
inline double certified_upper(const Bounded_double& thickness) {
  const double upper = thickness.upper();
  return std::isnan(upper) ? std::numeric_limits<double>::infinity() : upper;
}

template <class Construction, class NT>
[[nodiscard]] CGAL::Interval_nt<true> thickness_interval(const Construction& construction, const Chord_shape_2<NT>& shape) {
  using Interval = CGAL::Interval_nt<true>;
  const Interval all(0, std::numeric_limits<double>::infinity());
  try {
    const Interval thickness = construction.thickness(convert_shape<Interval>(shape));
    return CGAL::is_finite(thickness) && CGAL::is_valid(thickness) ? thickness : all;
  } catch (const CGAL::Uncertain_conversion_exception&) {
    return all;
  }
}

// By the exact shape over Exact, a type with exact field operations.
template <class Exact, class Construction, class ShapeSource>
[[nodiscard]] Thickness_bound bound_exactly(const Construction& construction, const ShapeSource& source, double eps) {
  const Chord_shape_2<Exact> shape = source.template shape<Exact>(shape_parts<Construction>());
  CGAL::Interval_nt<true> range = thickness_interval(construction, shape);
  if (range.sup() <= eps) return {true, range.sup(), true};
  if (range.inf() > eps) return {false, range.sup(), true};
  if constexpr (has_square_root_v<Exact>) {
    const Exact thickness = construction.thickness(shape);
    return {!(Exact(eps) < thickness), (std::min)(range.sup(), CGAL::to_interval(thickness).second), true};
  } else {
    const CORE::Expr thickness = construction.thickness(convert_shape<CORE::Expr>(shape));
    const bool within = !(CORE::Expr(eps) < thickness);
    return {within, within ? eps : (std::min)(range.sup(), CGAL::to_interval(thickness).second), true};
  }
}

/// The height over the chord of the triangle of chord and end tangents, which holds both boundaries: the outer one is
/// nowhere farther than that from the chord, and the inner one lies between.  With half-angle tangents up to b it is at
/// most c b / (1 - b^2), and as a spiral turns by at most a right angle never more than c.
inline double triangle_height(const Chord_shape_2<Bounded_double>& f) {
  const Chord_angles_2<Bounded_double> g = chord_angles(f);
  const Bounded_double b = larger(abs(g.bulge0), abs(g.bulge1)), c = g.chord * f.unit;
  const double height = certified_upper(c * b / (Bounded_double(1) - b * b)), chord = certified_upper(c);
  return b.upper() < 0.5 ? (std::min)(height, chord) : chord;
}

/// Whether turn, tight end and the step back to BCA would be the same in exact arithmetic.
inline bool is_form_certain(const Chord_shape_2<Bounded_double>& f) {
  const auto is_signed = [](const Bounded_double& x) { return x.lower() > 0 || x.upper() < 0; };
  if (!f.proper || !is_signed(f.cross0 + f.cross1) || !is_signed(f.square_change)) return false;
  if ((!f.infinite0 && !is_signed(f.kneser0)) || (!f.infinite1 && !is_signed(f.kneser1))) return false;
  const Tight_frame_2<Bounded_double> t = tight_frame(f);
  return t.usable && is_signed(t.sin_delta) && (t.infinite || is_signed(Bounded_double(1) - t.sin_delta / t.a * (t.sin_delta / t.b)));
}

template <class FT, bool ExactDecisions, class Construction, class ShapeSource>
[[nodiscard]] Thickness_bound bound_thickness(const Construction& construction, const ShapeSource& source, double eps) {
  using Exact = typename ShapeSource::Exact_number_type;
  static_assert((std::is_floating_point_v<FT> && !ExactDecisions) || !std::is_same_v<Exact, Bounded_double>,
                "a curve that is known in double only has no exact decisions: use a kernel such as Simple_cartesian<double>");
  if constexpr (!std::is_floating_point_v<FT>) {
    return bound_exactly<Exact>(construction, source, eps);
  } else {
    const auto parts = shape_parts<Construction>();
    const Chord_shape_2<Bounded_double> shape = source.template shape<Bounded_double>(parts);
    if constexpr (ExactDecisions && Construction::NEEDS_CURVATURE)
      if (!is_form_certain(shape)) return bound_exactly<Exact>(construction, source, eps);
    const Bounded_double thickness = construction.thickness(shape);
    double upper = certified_upper(thickness);
    if (upper <= eps) return {true, upper, false};
    // Where rounding takes all digits of a piece's curvature the triangle of its end tangents still bounds it.
    const bool is_lost = !(upper < std::numeric_limits<double>::infinity());
    const double chord = std::hypot(shape.chord.x.value(), shape.chord.y.value()) * shape.unit.value();
    if (!ExactDecisions && !(upper <= chord)) upper = (std::min)(upper, triangle_height(shape));
    if (is_lost && upper <= eps) return {true, upper, false};
    if constexpr (ExactDecisions) {
      if (!(thickness.lower() > eps)) return bound_exactly<Exact>(construction, source, eps);
    }
    return {false, upper, false};
  }
}

}  // namespace internal
}  // namespace CGAL::Bounding_arcs

#endif

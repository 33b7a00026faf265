// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of verify/verify_region.h.

#include "Osculating_proof.h"
#include "Thickness_proof.h"
#include "prove_outline.h"
#include "with_curvature_bounds.h"

#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <optional>

namespace CGAL::Bounding_arcs {
namespace verify {
namespace {

using internal::Exact_piece;
using internal::Proven_construction;
using internal::Region_question;

/// What is left out at the ends of a piece, as shares of its parameters.
struct Trims {
  Rational start{0}, end{0};
};

Proof prove_strict_piece(const Proven_construction& construction, const Containment_piece& piece,
                         const Chord_shape_2<Rational>& f, const Parameter_range& range) {
  if (!f.proper) return prove_bca(piece, f, range);
  constexpr mpfr_prec_t FIRST = 128, LAST = 4096;  // bits
  for (mpfr_prec_t precision = FIRST; precision <= LAST; precision *= 2) {
    try {
      const Osculating_proof proof(construction, piece, f, range, precision);
      if (proof.form() == Region_form::BCA) return prove_bca(piece, f, range);
      const Proof result = proof.contained();
      if (result != Proof::UNDECIDED) return result;
    } catch (const CGAL::Uncertain_conversion_exception&) {  // a comparison of intervals: try a higher precision
    }
  }
  return Proof::UNDECIDED;
}

// The region is the one that the construction makes of the shape, whatever it steps back to.
// \param reached set to the largest distance of the points left out from the ends that they are next to, in units of
//   the shape
Proof prove_containment(const Proven_construction& construction, const Exact_piece& exact, const Trims& trims = {},
                        double* reached = nullptr) {
  const Chord_shape_2<Rational>& f = exact.shape;
  const Containment_piece piece = containment_piece(exact.piece, f);
  const Rational &at_tight = f.tight_first ? trims.start : trims.end,
                 &at_flat = f.tight_first ? trims.end : trims.start;
  const Parameter_range range{at_tight, Rational(1 - at_flat)};
  if (reached != nullptr)
    *reached = (std::max)(reach(piece.tight, {Rational(0), range.low}), reach(piece.flat, {range.high, Rational(1)}));
  if (construction.polygon || construction.strip) return prove_outline(construction, piece, f, range);
  if (construction.needs_curvature) return prove_strict_piece(construction, piece, f, range);
  return construction.exact ? prove_between_arcs(construction, piece, f, range) : prove_bca(piece, f, range);
}

// Parameters of cuts are roots rounded to double, and of roots within CUT_WIDTH one is the cut: at an end that was cut,
// or that is the curve's own, the piece may hold that much of parameter that is not part of the spiral. The region then
// holds all but what is within a distance of the end, which is tried from there on up to `limit`.
std::optional<double> prove_but_for_ends(const Proven_construction& construction, const Region_question& piece,
                                         double limit) {
  constexpr double GROWTH = 8,
                   LARGEST = 0x1p-39;  // of parameters; at a cut a curve departs from its region like a power of them
  const bool at_first = piece.t0 == piece.first, at_last = piece.t1 == piece.last;
  for (double width = CUT_WIDTH; width <= LARGEST && width < (piece.t1 - piece.t0) / 4; width *= GROWTH) {
    const Rational share = Rational(width) / Rational(Rational(piece.t1) - Rational(piece.t0));
    double distance = 0;
    const Proof proof = prove_containment(construction, piece.exact,
                                          {at_first ? share : Rational(0), at_last ? share : Rational(0)}, &distance);
    distance *= CGAL::to_interval(piece.exact.shape.unit).second * (1 + 0x1p-50);
    if (!(distance <= limit)) break;
    if (proof == Proof::PROVEN) return distance;
  }
  return std::nullopt;
}

}  // namespace
}  // namespace verify

namespace internal {

using verify::Proof;

Region_proof prove_region(const Proven_construction& construction, const Region_question& piece, double eps) {
  const Exact_piece& exact = piece.exact;
  const Proof proof = verify::prove_containment(construction, exact);
  if (proof == Proof::PROVEN) return {Containment::PROVEN, 0};
  if (piece.t0 == piece.first || piece.t1 == piece.last) {
    if (construction.needs_curvature && exact.shape.proper)
      for (const double slack : verify::SLIVER_SLACKS) {
        const Exact_piece widened{exact.piece, verify::with_curvature_bounds(exact.shape, slack)};
        if (construction.most_thickness(widened.shape) > eps) break;
        if (verify::prove_containment(construction, widened) == Proof::PROVEN)
          return {Containment::PROVEN_AS_SLIVER, 0};
      }
    if (const auto slack = verify::prove_but_for_ends(construction, piece, eps / 2))
      return {Containment::PROVEN_AS_SLIVER, *slack};
    // where a cut stands for several roots the piece need not be a spiral at all, by what coordinates and cuts do not
    // resolve
    if (piece.outside) {
      const double limit = (std::min)(eps / 2, piece.resolution), slack = piece.outside(limit / 2);
      if (slack <= limit) return {Containment::PROVEN_AS_SLIVER, slack};
    }
  }
  return {proof == Proof::DISPROVED ? Containment::DISPROVED : Containment::UNDECIDED, 0};
}

std::optional<bool> prove_thickness(const Proven_construction& construction, const Chord_shape_2<Exact_rational>& shape,
                                    double thickness) {
  const Exact_rational length = Exact_rational(thickness) / shape.unit;
  if (construction.polygon || construction.strip) return verify::prove_outline_thickness(construction, shape, length);
  return verify::prove_thickness(
      [&](mpfr_prec_t bits) { return construction.enclosed(verify::enclosed_frame(shape, bits)); }, length);
}

}  // namespace internal
}  // namespace CGAL::Bounding_arcs

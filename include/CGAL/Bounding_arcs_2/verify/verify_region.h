// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is a curve piece inside its bounding region?  Proven, not sampled: the region is the exact one over the exact curve
// that the given control points and parameters define.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_VERIFY_REGION_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_VERIFY_REGION_H

#include <CGAL/Bounding_arcs_2/frame/bezier_chord_shape.h>
#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>
#include <CGAL/Bounding_arcs_2/region/Region_outline_2.h>
#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/verify/outside_bound.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>

namespace CGAL::Bounding_arcs {

/// What came of the proof that a region holds its piece.
enum class Containment {
  PROVEN,            ///< the piece lies in the method's region
  PROVEN_AS_SLIVER,  ///< proven but for the rounding of a cut at an end, see Region_proof::slack
  DISPROVED,         ///< the piece leaves the region
  UNDECIDED          ///< not decided within the highest precision
};

/// What is proven of a region.
struct Region_proof {
  Containment containment = Containment::UNDECIDED;
  /// How near to the region all of the piece is, where it is PROVEN_AS_SLIVER. With 0 the piece is in the region with
  /// the curvatures at its ends widened, by 2^-44 of what they differ from the chord circles' where that will do.
  double slack = 0;
  [[nodiscard]] bool holds() const {
    return containment == Containment::PROVEN || containment == Containment::PROVEN_AS_SLIVER;
  }
};

namespace internal {

/// What proofs ask of a construction: the boundaries that it makes of a frame, in one of these ways. A construction of
/// BCA needs none but `enclosed`.
struct Proven_construction {
  bool needs_curvature;
  std::function<Region_boundary_2<Mpfr_interval>(const Chord_frame_2<Mpfr_interval>&)> enclosed;
  std::function<Region_boundary_2<Exact_rational>(const Chord_frame_2<Exact_rational>&)> exact;   ///< of one arc a side
  std::function<Region_outline_2<Exact_rational>(const Chord_frame_2<Exact_rational>&)> polygon;  ///< of segments
  std::function<Region_outline_2<Mpfr_interval>(const Chord_frame_2<Mpfr_interval>&)> strip;      ///< of arcs, too
  std::function<double(const Chord_shape_2<Exact_rational>&)> most_thickness;

  template <class Construction>
  explicit Proven_construction(const Construction& construction) : needs_curvature(Construction::NEEDS_CURVATURE) {
    const auto boundary = [&construction](const auto& frame) { return construction.boundary(frame); };
    if constexpr (has_outline_v<Construction>) {
      if constexpr (Construction::BOUNDARY_NEEDS_SQUARE_ROOT) strip = boundary;
      else polygon = boundary;
    } else {
      enclosed = boundary;
      if constexpr (!Construction::NEEDS_CURVATURE && !std::is_base_of_v<Bca, Construction>) exact = boundary;
    }
    most_thickness = [&construction](const auto& shape) { return thickness_interval(construction, shape).sup(); };
  }
};

/// A piece and the shape that its region is made from, with exact numbers.
struct Exact_piece {
  Relative_piece<Exact_rational> piece;
  Chord_shape_2<Exact_rational> shape;
};

/// What is asked of a piece of a spiral segment.
struct Region_question {
  Exact_piece exact;
  double t0, t1, first, last;
  double resolution;  ///< some ulp of the coordinates, or what the rounding of a cut's parameter comes to if more
  std::function<double(double goal)> outside;  ///< outside_bound of the region in doubles; none of outlines
};

[[nodiscard]] Region_proof prove_region(const Proven_construction& construction, const Region_question& piece,
                                        double eps);
/// \return nothing where an outline steps back to BCA
[[nodiscard]] std::optional<bool> prove_thickness(const Proven_construction& construction,
                                                  const Chord_shape_2<Exact_rational>& shape, double thickness);

}  // namespace internal

/// Whether the piece [t0, t1] of a spiral segment lies in its region.
/// \tparam Construction Bca, Spiral_fat_arc, Bilens, one of the latter two in Near_circular_to_bca, one with regions
///   that have outlines, or one whose sides are an arc each and need no curvature
/// \tparam Spiral Bezier_spiral_2 over a number type whose exact type is CGAL::Exact_rational
/// \param eps the thickness that a region widened for a sliver may not exceed; a slack is at most half of it
/// \guarantee PROVEN and PROVEN_AS_SLIVER are proofs: exact rational arithmetic for BCA, for the others rational
///   arithmetic and MPFR intervals of up to 4096 bits
/// \complexity some ten microseconds for BCA of a cubic, some hundred for the others
template <class Construction, class Spiral>
[[nodiscard]] Region_proof verify_region(const Spiral& spiral, double t0, double t1,
                                         double eps = std::numeric_limits<double>::infinity(),
                                         const Construction& construction = {}) {
  static_assert(has_outline_v<Construction> || !Construction::NEEDS_CONTROL_POINTS, "no proof for this construction");
  static_assert(std::is_same_v<typename Spiral::Exact_number_type, Exact_rational>,
                "verification needs rational curves");
  constexpr double ULPS = 8, CUTS = 16;
  const auto parts = shape_parts<Construction>();
  internal::Region_question piece{
      {internal::relative_piece(spiral.exact_table(), Exact_rational(t0), Exact_rational(t1)),
       spiral.template shape<Exact_rational>(t0, t1, parts)},
      t0,
      t1,
      spiral.first(),
      spiral.last(),
      (std::max)(ULPS * ulp_of(spiral.coordinate_size()), CUTS * spiral.cut_error()),
      {}};
  if constexpr (!has_outline_v<Construction>)
    piece.outside = [&](double goal) {
      const auto boundary = construction.boundary(spiral.accurate_shape(t0, t1, parts).at_origin());
      return outside_bound(spiral, t0, t1, boundary, goal, verify::Boundary_origin::PIECE);
    };
  return internal::prove_region(internal::Proven_construction(construction), piece, eps);
}

/// Whether no point of the outer boundary of the piece's exact region is farther from the inner boundary than
/// `thickness`.
/// \guarantee true is a proof, from the boundaries alone, in MPFR intervals of up to 8192 bits; where the two lengths
///   are equal as far as these tell, it is taken as true
template <class Construction, class Spiral>
[[nodiscard]] bool verify_thickness(const Spiral& spiral, double t0, double t1, double thickness,
                                    const Construction& construction = {}) {
  const auto shape = spiral.template shape<Exact_rational>(t0, t1, shape_parts<Construction>());
  if (shape.chord == Xy<Exact_rational>{}) return spiral.is_straight() && thickness >= 0;  // a point
  if (shape.runs_ahead && !shape.proper && shape.sine_change == 0) return thickness >= 0;  // a line or an arc, twice
  const auto holds = internal::prove_thickness(internal::Proven_construction(construction), shape, thickness);
  return holds ? *holds : verify_thickness<Bca>(spiral, t0, t1, thickness);
}

}  // namespace CGAL::Bounding_arcs

#endif

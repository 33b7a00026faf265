// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Proofs for regions with outlines: that a curve piece is inside and that the two sides are near to each other, from
// the outline alone and not by what it came from.  Polygons in exact numbers, by the half planes of their edges and by
// distances of corners.  Strips in intervals: the curve stays between the normals at the ends and to its side of each
// arc, where a parameter range on either side of the joint's normal tells which arcs count.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_PROVE_OUTLINE_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_PROVE_OUTLINE_H

#include <CGAL/Bounding_arcs_2/region/Region_outline_2.h>
#include "Thickness_proof.h"
#include "prove_bca.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

/// The piece keeps to the left of the line from p to q. \param tight_end where the piece's tight end is, as p and q are
[[nodiscard]] inline Proof prove_left_of(const Containment_piece& piece, const Xy<Rational>& tight_end,
                                         const Xy<Rational>& p, const Xy<Rational>& q, const Parameter_range& range) {
  const End_view& v = piece.tight;
  const Xy<Rational> line = q - p;
  const std::vector<Integer> c =
      cleared<Rational>({line.x, line.y, Rational(cross(line, tight_end - p) / v.scale)}).numbers;
  return prove_nonnegative_but_at_ends(c[0] * v.y - c[1] * v.x + c[2] * v.weight, range);
}

/// Whether both sides of a polygon are chains between the same two points: others have no inside.
[[nodiscard]] inline bool is_closed(const Region_outline_2<Rational>& outline) {
  for (const auto* side : {&outline.inner, &outline.outer}) {
    if (side->empty()) return false;
    for (std::size_t i = 1; i < side->size(); ++i)
      if ((*side)[i - 1].to != (*side)[i].from) return false;
  }
  return outline.inner.front().from == outline.outer.front().from && outline.inner.back().to == outline.outer.back().to;
}

/// Inside of all edges.
[[nodiscard]] inline Proof prove_in_polygon(const Containment_piece& piece, const Chord_shape_2<Rational>& f,
                                            const Region_outline_2<Rational>& outline, const Parameter_range& range) {
  if (!is_closed(outline)) return Proof::DISPROVED;
  const Xy<Rational> tight_end = f.tight_first ? Xy<Rational>{} : f.chord;
  for (const auto& [from, to] : internal::edges_around(outline))
    if (const Proof proof = prove_left_of(piece, tight_end, from, to, range); proof != Proof::PROVEN) return proof;
  return Proof::PROVEN;
}

/// Whether an outline has the sides of a strip: one arc or two, between segments that both have.
[[nodiscard]] inline bool is_strip(const Region_outline_2<Mpfr_interval>& outline) {
  const std::size_t size = outline.outer.size();
  return (size == 3 || size == 4) && outline.inner.size() == size;
}

/// A piece and the strip about it.
class Strip_proof : Piece_in_intervals {
 public:
  using Chain = std::vector<Boundary_piece_2<Mpfr_interval>>;

  Strip_proof(const Piece_in_intervals& piece, const Region_outline_2<Mpfr_interval>& outline)
      : Piece_in_intervals(piece), outline_(outline) {}

  [[nodiscard]] Proof contained() const {
    if (!is_strip(outline_)) return Proof::UNDECIDED;
    const Chain& outer = outline_.outer;
    const Boundary_piece_2<Mpfr_interval>&first = outer[1], &last = outer[outer.size() - 2];
    const Polynomial from_start = ahead(direction_at(first, first.from), true),
                     to_end = ahead(-direction_at(last, last.to), false);
    const auto strict = [&](const Polynomial& p) { return prove_between(p, range_.low, range_.high); };
    if (strict(from_start) != Proof::PROVEN || strict(to_end) != Proof::PROVEN) return Proof::UNDECIDED;
    return outer.size() == 3 ? prove_arcs(1, range_.low, range_.high) : prove_both_arcs();
  }

 private:
  // How far the curve is ahead of its start or behind its end along v, without the root there.
  [[nodiscard]] Polynomial ahead(const Xy<Mpfr_interval>& v, bool at_start) const {
    const bool at_tight = at_start == f_.tight_first;
    const End_view& end = at_tight ? piece_.tight : piece_.flat;
    const std::size_t n = common_zeros(end.x, end.y, at_tight);
    return without_roots(v.x * interval(end.x) + v.y * interval(end.y), at_tight ? n : 0, at_tight ? 0 : n);
  }
  // Positive to the left of an arc's circle.
  [[nodiscard]] Polynomial left_of(const Contact_circle_2<Mpfr_interval>& c) const {
    const Xy<Mpfr_interval> o = c.point - tight_end_, n = c.normal + c.curvature * o;
    const Mpfr_interval two(2), level = two * dot(c.normal, o) + c.curvature * dot(o, o);
    return two * scale_ * (weight_ * (n.x * x_ + n.y * y_)) - c.curvature * scale_ * scale_ * (x_ * x_ + y_ * y_) -
           level * (weight_ * weight_);
  }
  // To the right sides of the two arcs of that number, for parameters between low and high.
  [[nodiscard]] Proof prove_arcs(std::size_t i, const Rational& low, const Rational& high) const {
    const Mpfr_interval side(outline_.inner_is_left ? 1 : -1);
    if (prove_between(side * left_of(outline_.outer[i].support), low, high) != Proof::PROVEN) return Proof::UNDECIDED;
    return prove_between(-side * left_of(outline_.inner[i].support), low, high);
  }
  // The curve passes the joint's normal within a range of parameters, in which it keeps to the sides of all four arcs.
  [[nodiscard]] Proof prove_both_arcs() const {
    const auto& first = outline_.outer[1];
    const Xy<Mpfr_interval> v = direction_at(first, first.to);
    const Polynomial past = passed(v, first.to);
    const Polynomial to_flat = f_.tight_first ? past : Mpfr_interval(-1) * past;  // rises from the tight end on
    Rational low = range_.low, high = range_.high;
    constexpr int HALVINGS = 9;  // the widest range about the joint in which neighbours of a thin strip hold the curve
    for (int i = 0; i < HALVINGS; ++i) {
      const Rational s = (low + high) / 2;
      const int sign = sign_at(to_flat, s);
      if (sign == 0) break;
      (sign < 0 ? low : high) = s;
    }
    const Rational width = high - low;
    low = (std::max)(range_.low, Rational(low - width));
    high = (std::min)(range_.high, Rational(high + width));
    const std::size_t at_tight = f_.tight_first ? 1 : 2, at_flat = 3 - at_tight;
    const bool holds = prove_between(Mpfr_interval(-1) * to_flat, range_.low, low) == Proof::PROVEN &&
                       prove_between(to_flat, high, range_.high) == Proof::PROVEN &&
                       prove_arcs(at_tight, range_.low, high) == Proof::PROVEN &&
                       prove_arcs(at_flat, low, range_.high) == Proof::PROVEN;
    return holds ? Proof::PROVEN : Proof::UNDECIDED;
  }

  const Region_outline_2<Mpfr_interval>& outline_;
};

/// |p - s|^2, s the nearest point of a segment.
[[nodiscard]] inline Rational squared_distance(const Xy<Rational>& p, const Boundary_piece_2<Rational>& segment) {
  const Xy<Rational> d = segment.to - segment.from, v = p - segment.from;
  const Rational along = dot(d, v), square = dot(d, d);
  if (along <= 0) return dot(v, v);
  if (along >= square) return dot(p - segment.to, p - segment.to);
  const Rational across = cross(d, v);
  return across * across / square;
}

/// Every point of the outer side of a polygon is within `length` of one segment of the inner side: the distance from a
/// segment is convex, so that the ends of a part tell, and edges are halved where no one segment does.
[[nodiscard]] inline bool prove_polygon_thickness(const Region_outline_2<Rational>& outline, const Rational& length) {
  constexpr int MOST_PARTS = 400;
  if (!is_closed(outline)) return false;
  const Rational most = length * length;
  int parts = 0;
  const auto holds = [&](const Xy<Rational>& p, const Xy<Rational>& q, const auto& again) -> bool {
    for (const Boundary_piece_2<Rational>& s : outline.inner)
      if (squared_distance(p, s) <= most && squared_distance(q, s) <= most) return true;
    if (++parts > MOST_PARTS) return false;
    const Xy<Rational> middle = Rational(Rational(1) / 2) * (p + q);
    return again(p, middle, again) && again(middle, q, again);
  };
  return std::all_of(outline.outer.begin(), outline.outer.end(),
                     [&](const Boundary_piece_2<Rational>& edge) { return holds(edge.from, edge.to, holds); });
}

/// Every point of the outer side of a strip is within `length` of the inner side: ends and joints lie on common
/// normals, and between these arcs are as far apart as their circles are.
[[nodiscard]] inline bool prove_strip_thickness(const Region_outline_2<Mpfr_interval>& outline,
                                                const Mpfr_interval& length) {
  if (!is_strip(outline)) return false;
  for (std::size_t i = 1; i + 1 < outline.outer.size(); ++i) {
    const Oriented_arc outer(outline.outer[i]), inner(outline.inner[i]);
    Mpfr_interval apart = circle_deviation(outer, inner);
    for (const auto& [p, q] : {std::pair(outer.from, inner.from), std::pair(outer.to, inner.to)}) {
      apart = apart + abs(dot(outer.tangent_at(p), q - p));  // 0 but for rounding
      if ((length - sqrt(dot(q - p, q - p))).certain_sign() < 0) return false;
    }
    if ((length - apart).certain_sign() <= 0) return false;
  }
  return true;  // the segments at the ends are no longer than what is between the arcs there
}

/// What is proven of the outline that a construction makes of a shape, with lengths in units of the shape.
/// \param of_polygon Proof(outline), in exact numbers
/// \param of_strip Proof(outline, bits), in intervals, of which precision rises until it is PROVEN
/// \return nothing where the region steps back to BCA
template <class Of_polygon, class Of_strip>
[[nodiscard]] std::optional<Proof> proof_of_outline(const internal::Proven_construction& construction,
                                                    Chord_shape_2<Rational> shape, const Of_polygon& of_polygon,
                                                    const Of_strip& of_strip) {
  if (construction.polygon) {
    shape.unit = 1;
    const auto outline = construction.polygon(shape.at_origin());
    if (outline.form == Outline_form::BCA) return std::nullopt;
    return of_polygon(outline);
  }
  constexpr mpfr_prec_t FIRST = 128, LAST = 2048;
  for (mpfr_prec_t bits = FIRST; bits <= LAST; bits *= 4) {
    try {
      const auto outline = construction.strip(enclosed_frame(shape, bits));
      if (outline.form == Outline_form::BCA) return std::nullopt;
      if (of_strip(outline, bits) == Proof::PROVEN) return Proof::PROVEN;
    } catch (const CGAL::Uncertain_conversion_exception&) {  // the form is open
    }
  }
  return Proof::UNDECIDED;
}

/// The piece is in the region within its outline, or in the BCA where that is what it steps back to.
[[nodiscard]] inline Proof prove_outline(const internal::Proven_construction& construction,
                                         const Containment_piece& piece, const Chord_shape_2<Rational>& f,
                                         const Parameter_range& range) {
  const std::optional<Proof> proof = proof_of_outline(
      construction, f, [&](const auto& outline) { return prove_in_polygon(piece, f, outline, range); },
      [&](const auto& outline, mpfr_prec_t bits) {
        return Strip_proof({piece, f, range, bits}, outline).contained();
      });
  return proof ? *proof : prove_bca(piece, f, range);
}

/// Whether no point of the outer side of the exact outline is farther from the inner side than `length`, in units of
/// the shape; nothing where the region steps back to BCA.
[[nodiscard]] inline std::optional<bool> prove_outline_thickness(const internal::Proven_construction& construction,
                                                                 const Chord_shape_2<Rational>& shape,
                                                                 const Rational& length) {
  const auto proof_if = [](bool holds) { return holds ? Proof::PROVEN : Proof::UNDECIDED; };
  const std::optional<Proof> proof = proof_of_outline(
      construction, shape, [&](const auto& outline) { return proof_if(prove_polygon_thickness(outline, length)); },
      [&](const auto& outline, mpfr_prec_t bits) {
        return proof_if(prove_strip_thickness(outline, Mpfr_interval(length, bits)));
      });
  return proof ? std::optional(*proof == Proof::PROVEN) : std::nullopt;
}

}  // namespace CGAL::Bounding_arcs::verify

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An oriented circle or line in contact form, and boundaries made of arcs and segments on such circles.
// Curvature 0 is a line: nothing is divided by before a centre is asked for.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_CONTACT_CIRCLE_2_H
#define CGAL_BOUNDING_ARCS_2_REGION_CONTACT_CIRCLE_2_H

#include <CGAL/Bounding_arcs_2/curve/Xy.h>
#include <CGAL/Bounding_arcs_2/internal/number_types.h>

#include <array>
#include <cassert>

namespace CGAL::Bounding_arcs {

/// The circle through `point` with left normal `normal` there and signed curvature `curvature` / |normal|
/// (positive: it turns left and its centre lies on the side of the normal).  The normal need not have length 1, so
/// that circles with rational centre and squared radius stay free of square roots.
template <class NT>
struct Contact_circle_2 {
  Xy<NT> point, normal;
  NT curvature{0};

  [[nodiscard]] bool is_line() const { return curvature == NT(0); }
  /// \pre not a line
  [[nodiscard]] Xy<NT> center() const { return point + to_center(); }
  /// From the quotient, as the square of a normal may be less than the least number. \pre not a line
  [[nodiscard]] NT squared_radius() const { return dot(to_center(), to_center()); }
  /// A number with the sign of q's side: positive to the left, 0 on the circle, negative to the right.
  /// \guarantee exact over a field; no division
  [[nodiscard]] NT side(const Xy<NT>& q) const {
    const Xy<NT> v = q - point;
    return NT(NT(2) * dot(normal, v) - curvature * dot(v, v));
  }
  /// The normal of the circle's family of concentric ones at q, towards the centre of a left turn; of the length of `normal`
  /// where q is on the circle.
  [[nodiscard]] Xy<NT> normal_at(const Xy<NT>& q) const { return normal - curvature * (q - point); }

 private:
  [[nodiscard]] Xy<NT> to_center() const { return {NT(normal.x / curvature), NT(normal.y / curvature)}; }
};

/// A circular arc or segment `from` -> `to` that follows its support's orientation.
template <class NT>
struct Boundary_piece_2 {
  Xy<NT> from, to;
  Contact_circle_2<NT> support;

  [[nodiscard]] bool is_segment() const { return support.is_line(); }
  /// True for a counterclockwise arc. \pre not a segment
  [[nodiscard]] bool is_ccw() const { return support.curvature > NT(0); }
};

/// tan of a quarter of the angle that a piece turns through, positive for a left turn and 0 for a segment: with the two ends it
/// defines the piece, and nothing of it is large where the piece is flat. Needs square roots.
/// \pre the support's point is one of the piece's ends
template <class NT>
[[nodiscard]] NT bulge(const Boundary_piece_2<NT>& piece) {
  if (piece.is_segment()) return NT(0);
  const Xy<NT> chord = piece.to - piece.from;
  if (chord == Xy<NT>{}) return NT(0);  // shorter than its numbers tell
  const bool at_start = piece.support.point == piece.from;
  const Xy<NT> tangent = -perp(piece.support.normal);
  const NT height = at_start ? cross(tangent, chord) : cross(chord, tangent);
  return NT(height / (internal::square_root(NT(dot(tangent, tangent) * dot(chord, chord))) + dot(tangent, chord)));
}

/// One side of a region: one or two pieces from the segment's start to its end.
template <class NT>
class Boundary_chain_2 {
 public:
  Boundary_chain_2() = default;
  explicit Boundary_chain_2(const Boundary_piece_2<NT>& only) : pieces_{only, {}}, size_(1) {}
  Boundary_chain_2(const Boundary_piece_2<NT>& first, const Boundary_piece_2<NT>& second)
      : pieces_{first, second}, size_(2) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Boundary_piece_2<NT>& operator[](std::size_t i) const {
    assert(i < size_);
    return pieces_[i];
  }
  [[nodiscard]] auto begin() const { return pieces_.begin(); }
  [[nodiscard]] auto end() const { return pieces_.begin() + static_cast<std::ptrdiff_t>(size_); }

 private:
  std::array<Boundary_piece_2<NT>, 2> pieces_;
  std::size_t size_ = 0;
};

/// Which construction a region came out as: a method steps back to a simpler one where its own is not defined.
enum class Region_form { BCA, SPIRAL_FAT_ARC, BILENS, CHORD_AND_CIRCLE };

/// The two sides of a region; inner is the side of the curve's centres of curvature.
template <class NT>
struct Region_boundary_2 {
  Boundary_chain_2<NT> inner, outer;
  Region_form form = Region_form::BCA;
};

}  // namespace CGAL::Bounding_arcs

#endif

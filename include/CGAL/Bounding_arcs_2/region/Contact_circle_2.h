// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An oriented circle or line in contact form, and boundaries made of arcs and segments on such circles.
// Curvature 0 is a line: nothing is divided by before a center is asked for.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_CONTACT_CIRCLE_2_H
#define CGAL_BOUNDING_ARCS_2_REGION_CONTACT_CIRCLE_2_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/assertions.h>

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace CGAL::Bounding_arcs {

/// The circle through `point` with left normal `normal` there and signed curvature `curvature` / |normal|
/// (positive: it turns left and its center lies on the side of the normal).  The normal need not have length 1, so
/// that circles with rational center and squared radius stay free of square roots.
template <class NT> struct Contact_circle_2 {
  Xy<NT> point, normal;
  NT curvature{0};

  [[nodiscard]] bool is_line() const { return curvature == NT(0); }
  /// \pre not a line
  [[nodiscard]] Xy<NT> center() const { return point + to_center(); }
  /// The radius squared, by the quotient, as the square of a normal may be less than the least number. \pre not a line
  [[nodiscard]] NT squared_radius() const { return dot(to_center(), to_center()); }
  /// A number with the sign of q's side: positive to the left, 0 on the circle, negative to the right.
  /// \guarantee exact over a field; no division
  [[nodiscard]] NT side(const Xy<NT>& q) const {
    const Xy<NT> v = q - point;
    return NT(NT(2) * dot(normal, v) - curvature * dot(v, v));
  }
  /// The normal of the circle's family of concentric ones at q, towards the center of a left turn; of the length of
  /// `normal` where q is on the circle.
  [[nodiscard]] Xy<NT> normal_at(const Xy<NT>& q) const { return normal - curvature * (q - point); }

 private:
  [[nodiscard]] Xy<NT> to_center() const { return {NT(normal.x / curvature), NT(normal.y / curvature)}; }
};

/// A circular arc or segment `from` -> `to` that follows its support's orientation.
template <class NT> struct Boundary_piece_2 {
  Xy<NT> from, to;
  Contact_circle_2<NT> support;

  [[nodiscard]] bool is_segment() const { return support.is_line(); }
  /// True for a counterclockwise arc. \pre not a segment
  [[nodiscard]] bool is_ccw() const {
    CGAL_precondition(!is_segment());
    return support.curvature > NT(0);
  }
  /// Converts to an exact number type that holds these numbers.
  template <class Target> [[nodiscard]] Boundary_piece_2<Target> over() const {
    static_assert(!std::is_floating_point_v<NT>, "a boundary in floating numbers misses its ends; hand over its arcs");
    const auto point = [](const Xy<NT>& q) { return Xy<Target>{Target(q.x), Target(q.y)}; };
    return {point(from), point(to), {point(support.point), point(support.normal), Target(support.curvature)}};
  }
};

/// One side of a region: one or two pieces from the segment's start to its end.
template <class NT> class Boundary_chain_2 {
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

/// The bulge: tan of a quarter of the angle that a piece of a chain turns through, positive for a left turn and 0 for a
/// segment. With the two ends it defines the piece, and no number is large where the piece is flat. Needs square roots.
/// \param is_smooth the pieces touch at their joint
/// \guarantee over double, some u times the larger of itself and its piece's share of the chain's length
/// \pre the support's points are the chain's ends
template <class NT> [[nodiscard]] NT bulge(const Boundary_chain_2<NT>& chain, std::size_t i, bool is_smooth) {
  const Boundary_piece_2<NT>& piece = chain[i];
  if (piece.is_segment()) return NT(0);
  const Xy<NT> chord = piece.to - piece.from, whole = chain[chain.size() - 1].to - chain[0].from;
  const bool at_start = i == 0 && (chain.size() == 2 || piece.support.point == piece.from);
  const Xy<NT> tangent = -perp(piece.support.normal);
  if constexpr (std::is_floating_point_v<NT>) {
    // of a piece much shorter than the chain the chord has lost its digits, but not its tangents
    constexpr NT SHORT = NT(0x1p-40);
    if (chain.size() == 2 && dot(chord, chord) < SHORT * dot(whole, whole)) {
      const Contact_circle_2<NT>& support = is_smooth ? chain[1 - i].support : piece.support;
      const Xy<NT> joint = -perp(support.normal_at(chain[0].to)), &from = at_start ? tangent : joint,
                   &to = at_start ? joint : tangent;
      const NT half = cross(from, to) / (stable_norm(from) * stable_norm(to) + dot(from, to));
      return half / (1 + std::sqrt(1 + half * half));
    }
  }
  const NT height = at_start ? cross(tangent, chord) : cross(chord, tangent);
  if (height == NT(0)) return NT(0);             // a point
  if constexpr (std::is_floating_point_v<NT>) {  // squares of short tangents would be lost
    return height / (stable_norm(tangent) * stable_norm(chord) + dot(tangent, chord));
  } else {
    return NT(height / (square_root(NT(dot(tangent, tangent) * dot(chord, chord))) + dot(tangent, chord)));
  }
}

/// Which construction a region came out as: a method steps back to a simpler one where its own is not defined.
enum class Region_form { BCA, SPIRAL_FAT_ARC, BILENS, CHORD_AND_CIRCLE };

/// The two sides of a region; inner is the side of the curve's centers of curvature.
template <class NT> struct Region_boundary_2 {
  Boundary_chain_2<NT> inner, outer;
  Region_form form = Region_form::BCA;
};

}  // namespace CGAL::Bounding_arcs

#endif

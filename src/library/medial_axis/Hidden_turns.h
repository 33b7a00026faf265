// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turns that are too tight to be seen.
//
// A curve whose handle is beside its node turns there by any angle. With the handle at the distance d, and the next
// control point at L, it does so within about d^2 / L: for d = 1e-9 L that is less than coordinates tell, and yet
// derivatives in doubles tell it well.  Normals of discs at the node would point anywhere, and a curvature of 1e18 is
// no leaf. So from such an end of a segment a curve counts as the line that touches it as far away as it is beside that
// line by next to nothing:
//
//     node .__                          what it turns by before is a part of the corner at the node
//             `--.________ s ___        height: the most by which it is beside the tangent at s
//
// So it does where most of that is turned within the first quarter of those parameters, a sixteenth of the way. An arc
// of a circle turns everywhere alike, and where the handle is in the node a turn grows as its length's root: these stay
// what they are.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_HIDDEN_TURNS_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_HIDDEN_TURNS_H

#include "../tree/Segment_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace CGAL::Bounding_arcs::internal {

/// A segment as it is seen.
struct Seen_segment {
  Spiral_piece_2 piece;  ///< the samples at its ends have the tangent and the curvature from where it is seen
  double from, to;       ///< parameters: before the first and behind the last one it is a line
};

class Hidden_turns {
 public:
  /// \param size the largest |coordinate|
  /// \param height lengths below are nothing
  Hidden_turns(const Segment_hierarchy& curves, double size, double height) : curves_(curves), most_(height) {
    constexpr double SHARP = 0x1p20;  // curvature, times the size: few segments are looked at
    for (std::uint32_t s = 0; s < curves.number_of_segments(); ++s) {
      const Spiral_piece_2 piece = curves.piece(s);
      if ((std::max)(piece.first.most_curvature, piece.last.most_curvature) * size > SHARP && !curves.is_straight(s))
        find(piece);
    }
  }
  /// How far curves may be beside what is seen of them; 0 where no turns are hidden.
  [[nodiscard]] double height() const { return seen_.empty() ? 0 : most_; }
  /// \return null where a segment is seen as it is
  [[nodiscard]] const Seen_segment* seen(std::uint32_t segment) const {
    if (seen_.empty()) return nullptr;
    const auto found = seen_.find(segment);
    return found == seen_.end() ? nullptr : &found->second;
  }

 private:
  void find(const Spiral_piece_2& piece) {
    const Spiral_sample first = seen_end(piece, piece.first, piece.last),
                        last = seen_end(piece, piece.last, piece.first);
    if (first.t == piece.first.t && last.t == piece.last.t) return;
    Seen_segment seen{piece, first.t, last.t};
    const auto see = [](const Spiral_sample& s, Spiral_sample& end) {
      const Spiral_sample at = end;
      end = s;
      end.t = at.t, end.point = at.point;
    };
    if (first.t < last.t) {
      see(first, seen.piece.first), see(last, seen.piece.last);
    } else {  // all of it is a line, and goes on as it does where it is seen
      seen.from = piece.last.t;
      see(first.t == piece.last.t ? first : last, seen.piece.first);
      see(seen.piece.first, seen.piece.last);
    }
    seen_.emplace(piece.segment, seen);
  }
  // From where on a segment is seen, looked at from an end of it.
  [[nodiscard]] Spiral_sample seen_end(const Spiral_piece_2& piece, const Spiral_sample& end,
                                       const Spiral_sample& other) const {
    constexpr double LEAST_TURN = 0x1p-21;  // as of tips
    const double sign = end.t < other.t ? 1 : -1;
    const auto turn = [&](const Spiral_sample& s) {
      return std::fabs(std::atan2(cross(end.tangent, s.tangent), dot(end.tangent, s.tangent)));
    };
    const auto is_line_from = [&](const Spiral_sample& s) {
      const Xy<double> chord = s.point - end.point;
      return euclidean_norm(chord) <= most_ ||
             (std::fabs(cross(s.tangent, chord)) <= most_ && sign * dot(s.tangent, chord) > 0);
    };
    if (!(turn(other) >= LEAST_TURN)) return end;
    double near = is_line_from(other) ? other.t : end.t, far = other.t;
    constexpr int STEPS = 60;  // bits of a parameter, and some
    for (int i = 0; i < STEPS && near != far; ++i) {
      const double t = near + 0.5 * (far - near);
      (is_line_from(curves_.sample(piece.segment, t)) ? near : far) = t;
    }
    const Spiral_sample s = curves_.sample(piece.segment, near),
                        before = curves_.sample(piece.segment, end.t + (near - end.t) / 4);
    return turn(s) >= LEAST_TURN && 2 * turn(before) >= turn(s) ? s : end;
  }

  const Segment_hierarchy& curves_;
  double most_;
  std::unordered_map<std::uint32_t, Seen_segment> seen_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

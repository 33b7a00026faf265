// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a curve piece leaves a region, over one number type: exact rationals or double-doubles with error bounds.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_OUTSIDE_PROOF_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_OUTSIDE_PROOF_H

#include <CGAL/Bounding_arcs_2/verify/outside_bound.h>
#include "Seen_boundary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

/// All lengths are in units of the curve's table, from the boundary's start. The curve is cut in three: heads and tails
/// that lie near an end point, and a body that lies between the normals at the ends of all arcs.  Where a point of the
/// body is beyond an arc its foot is on that arc, so its distance from the region is at most that from the circle.
template <class NT> class Outside_proof {
 public:
  /// \param goal a distance, in units of the plane, below which nobody cares how small the bound is
  template <class FT>
  Outside_proof(const internal::Proven_piece& piece, const Region_boundary_2<FT>& boundary, double goal,
                Boundary_origin origin = Boundary_origin::PLANE)
      : unit_(piece.table<NT>().unit()), boundary_(boundary, unit_),
        piece_(weighted_piece(piece, origin == Boundary_origin::PLANE ? point_from(piece, boundary_.origin)
                                                                      : NT(-1 / unit_) * boundary_.origin)),
        squares_(piece_) {
    if (std::is_same_v<NT, Double_double>) slack_ = NOISE * length_range(boundary_.end).upper;
    goal_ = (std::max)(goal / unit_ * ROUND_DOWN * ROUND_DOWN - 2 * slack_, slack_);
  }

  /// An upper bound of the largest distance of a point of the piece from the region, in units of the plane.
  [[nodiscard]] double bound() const { return bounds().most; }

  /// That bound with a distance that a point is seen to have, about: no bound rests on the distance, and 0 says
  /// nothing.
  struct Bounds {
    double most, seen;
  };
  [[nodiscard]] Bounds bounds() const {
    const double from_ends = (std::min)(farthest_from({}, piece_), farthest_from(boundary_.end, piece_));
    if (boundary_.is_point()) return {from_ends * unit_ * ROUND_UP, 0};
    if (boundary_.is_disc) {  // which has no ends that a point may lie behind
      const Outside disc = beyond_chain(boundary_.outer, piece_, squares_, false);
      return {(std::min)(from_ends, disc.most + 2 * slack_) * unit_ * ROUND_UP, disc.least * unit_};
    }
    const Outside parts = from_region();
    double least = (std::min)(from_ends, parts.most);
    if (least > (std::max)(goal_, SMALL * from_ends)) least = (std::min)(least, from_flat_region());
    if (least > (std::max)(goal_, MUCH * parts.least))  // else no other way gives much less
      least = (std::min)(least, from_pinned_piece(least));
    return {least * unit_ * ROUND_UP, (std::max)(parts.least, parts.ends) * unit_};
  }

  /// Whether a bound is well above this number type's own errors.
  [[nodiscard]] bool is_significant(double bound) const { return bound > SIGNIFICANT / NOISE * slack_ * unit_; }

 private:
  using Polynomial = Bernstein_polynomial<NT>;
  struct End {
    double share;     ///< of the parameters
    double distance;  ///< at most, of that part from the end point
    double least;     ///< about that distance of the curve's own end
  };

  /// The largest distance of some points from the region: no more than `most`, and about `least` or more; `ends` is
  /// about how far the piece's own ends are from the region's.
  struct Outside {
    double most = INFINITE, least = 0, ends = 0;
  };

  // Shares of the chord: what end normals may be passed by, well above the errors of double-doubles and well below
  // those of doubles (passing them by that much adds at most twice as much to a distance), and what a bound must exceed
  // for this to be less than a hundredth of it.
  static constexpr double NOISE = 0x1p-75, SIGNIFICANT = 0x1p-66;
  static constexpr int HALVINGS =
      6;  // of curve pieces and of shares, for signs and sizes that one or two decide as a rule
  static constexpr double SMALL = 0x1p-40;  // of the piece: bounds below it need no other
  // Factors over a known distance at which a search ends, and above which another way is tried; and over what
  // ends are apart, above which they are moved.
  static constexpr double CLOSE = 1.05, MUCH = 1.2, FAR = 16;

  [[nodiscard]] Outside from_region() const {
    const End head = cut_end(true), tail = cut_end(false);
    if (!(head.share + tail.share < 1)) return {};
    const Weighted_piece<NT> body = piece_.part(NT(head.share), NT(NT(1) - NT(tail.share)));
    const Piece_squares<NT> squares = head.share + tail.share > 0 ? Piece_squares<NT>(body) : squares_;
    const Outside outer = beyond_chain(boundary_.outer, body, squares, boundary_.has_corner),
                  inner = beyond_chain(boundary_.inner, body, squares, false);
    return {((std::max)({head.distance, tail.distance, outer.most, inner.most}) + 2 * slack_) * ROUND_UP,
            (std::max)(outer.least, inner.least), (std::max)(head.least, tail.least)};
  }

  // Where an arc leaves an end at nearly a right angle to the curve's way, what the ends of both are apart is much of
  // that way. So the piece is moved, by no more than that, to have the boundary's ends; infinite where it has
  // them or that is of no use to a bound known otherwise.
  [[nodiscard]] double from_pinned_piece(double otherwise) const {
    const auto end = [&](const Polynomial& p, bool at_start) {
      return at_start ? p.scaled_coefficients().front() : p.scaled_coefficients().back();
    };
    const auto way_to = [&](const Xy<NT>& p, bool at_start) {
      const NT share = NT(1) / end(piece_.weight, at_start);
      return p - share * Xy<NT>{end(piece_.x, at_start), end(piece_.y, at_start)};
    };
    const Xy<NT> head = way_to({}, true), tail = way_to(boundary_.end, false);
    const double most = (std::max)(length_range(head).upper, length_range(tail).upper);
    if (most == 0 || (otherwise <= FAR * most && goal_ <= most)) return INFINITE;
    const auto moved = [&](const Polynomial& p, const NT& at_start, const NT& at_end) {
      return p + Polynomial::from_scaled({at_start, at_end}) * piece_.weight;
    };
    Outside_proof pinned(*this);
    pinned.piece_.x = moved(piece_.x, head.x, tail.x);
    pinned.piece_.y = moved(piece_.y, head.y, tail.y);
    pinned.piece_.weight = piece_.weight.elevated(pinned.piece_.x.degree());  // coefficients are compared one by one
    pinned.squares_ = Piece_squares<NT>(pinned.piece_);
    return (pinned.from_region().most + most) * ROUND_UP;
  }

  // Where piece and region are flat beside their chord no normals are needed: at the same place along the chord, or at
  // an end, a point of the curve has one of each chain within the heights of both and its own overshoot.
  [[nodiscard]] double from_flat_region() const {
    const Xy<NT>& chord = boundary_.end;
    const double length = length_range(chord).lower;
    double curve = 0;
    for (std::size_t i = 0; i < piece_.weight.scaled_coefficients().size(); ++i) {
      const NT& w = piece_.weight.scaled_coefficients()[i];
      const Xy<NT> q{piece_.x.scaled_coefficients()[i], piece_.y.scaled_coefficients()[i]};
      const double before = range_of(dot(chord, q)).lower,
                   behind = range_of(NT(w * dot(chord, chord) - dot(chord, q))).lower;
      if (!(length > 0) || !(range_of(w).lower > 0)) return INFINITE;
      const double overshoot = (std::max)({0.0, -before, -behind});
      curve = (std::max)(
          curve, (most_of(range_of(cross(chord, q))) + 2 * overshoot) / (length * range_of(w).lower) * ROUND_UP);
    }
    return (curve + (std::min)(height(boundary_.inner, length), height(boundary_.outer, length)) + 2 * slack_) *
           ROUND_UP;
  }
  // An upper bound of the distance of every point of a chain from the chord, and of the chord's from it; infinite if it
  // turns too much.
  [[nodiscard]] double height(const Seen_chain<NT>& chain, double length) const {
    const std::size_t n = chain.circles.size();
    double sum = n == 2 ? most_of(range_of(cross(boundary_.end, chain.joint))) / length : 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Seen_circle<NT>& c = chain.circles[i];
      const Xy<NT> from = i == 0 ? Xy<NT>{} : chain.joint, to = i + 1 == n ? boundary_.end : chain.joint,
                   way = to - from;
      const double ahead = most_of(range_of(cross(c.normal, way))), aside = most_of(range_of(dot(c.normal, way)));
      if (!(aside < ahead) || !(range_of(dot(way, boundary_.end)).lower > 0)) return INFINITE;
      // an arc that leaves its chord by an angle up to a half of a right one is at most sin / 2 times as high as the
      // chord is long
      sum += aside / c.length.lower;
      for (const Xy<NT>& end : {from, to}) {
        const Xy<NT> v = end - c.point;
        sum += c.distance(most_of(range_of(NT(c.curvature * dot(v, v) - NT(2) * dot(c.normal, v)))));
      }
    }
    return sum * ROUND_UP;
  }

  // What is cut off at an end: the body must be ahead of both chains' normals there or, less where an arc leaves the
  // chord at nearly a right angle, ahead of the perpendicular to the chord, and of each chain's normal unless it is not
  // yet beyond that chain's circle.
  [[nodiscard]] End cut_end(bool at_start) const {
    const NT sign(at_start ? 1 : -1);
    const auto is_positive = [&](const Polynomial& p, double from, double to) {
      return prove_nonnegative(between(p, from, to, at_start), HALVINGS) == Proof::PROVEN;
    };
    std::vector<Polynomial> ahead_of, inside;
    for (const Seen_chain<NT>* chain : {&boundary_.outer, &boundary_.inner}) {
      const std::size_t i = at_start ? 0 : chain->circles.size() - 1;
      ahead_of.push_back(
          sign * chain->past_normal(piece_, i, at_start ? Xy<NT>{} : boundary_.end, at_start ? slack_ : -slack_));
      inside.push_back(NT(-1) * squares_.excess(chain->circles[i]));
    }
    const End whole = least_cut(at_start, [&](double share) {
      return is_positive(ahead_of[0], share, 1) && is_positive(ahead_of[1], share, 1);
    });
    if (whole.distance <= (std::max)(goal_, MUCH * whole.least)) return whole;
    const Polynomial along_chord =
        sign * piece_.linear(boundary_.end, at_start ? NT(0) : NT(-dot(boundary_.end, boundary_.end)));
    const End part = least_cut(at_start, [&](double share) {
      if (share > whole.share || !is_positive(along_chord, share, 1)) return false;
      for (std::size_t k = 0; k < inside.size(); ++k)
        if (!is_positive(ahead_of[k], share, 1) && !is_positive(inside[k], share, whole.share)) return false;
      return true;
    });
    return part.distance < whole.distance ? part : whole;
  }

  // The least share, about, of which holds(share) is true.
  template <class Holds> [[nodiscard]] End least_cut(bool at_start, const Holds& holds) const {
    constexpr double LARGEST = 0.25, LEAST = 0x1p-90;
    if (holds(0)) return {0, 0, 0};
    const auto distance_of = [&](double share) {
      const auto cut = [&](const Polynomial& p) { return between(p, 0, share, at_start); };
      return farthest_from(at_start ? Xy<NT>{} : boundary_.end,
                           Weighted_piece<NT>{cut(piece_.x), cut(piece_.y), cut(piece_.weight)});
    };
    const double least = distance_of(LEAST);
    double too_little = 0, share = (std::max)(LEAST, 2 * least / length_range(boundary_.end).lower);
    for (; share < LARGEST && !holds(share); share *= 4) too_little = share;
    if (!(share < LARGEST)) return {1, INFINITE, least};
    double distance = distance_of(share);
    for (int i = 0; i < HALVINGS && distance > (std::max)(goal_, CLOSE * least); ++i) {
      const double middle = (too_little + share) / 2;
      (holds(middle) ? share : too_little) = middle;
      distance = distance_of(share);
    }
    return {share, distance, least};
  }
  // The polynomial between two shares of the parameters, counted from the start or from the end.
  [[nodiscard]] static Polynomial between(const Polynomial& p, double from, double to, bool at_start) {
    const NT a(from), b(to), one(1);
    return at_start ? Weighted_piece<NT>::part(p, a, b) : Weighted_piece<NT>::part(p, NT(one - b), NT(one - a));
  }

  [[nodiscard]] Outside beyond_chain(const Seen_chain<NT>& chain, const Weighted_piece<NT>& body,
                                     const Piece_squares<NT>& squares, bool is_corner) const {
    Chain_excess<NT> excess;
    for (const Seen_circle<NT>& c : chain.circles) excess.pieces.push_back(squares.excess(c));
    excess.square = squares.weight;
    const bool has_joint = chain.circles.size() == 2;
    if (has_joint && !is_corner) excess.past = chain.past_normal(body, 0, chain.joint);
    Farthest_beyond<NT> search(chain.circles, goal_);
    const double distance = search(excess), least = search.known_distance();
    if (!has_joint || distance == 0) return {distance, least};
    return {is_corner ? beside_corner(chain, body, distance) : beside_joint(chain, distance), least};
  }

  // A point is told by the first circle's normal at the joint which circle it belongs to.  Where its foot on the second
  // circle lies before that normal it is in a wedge of the two normals' angle, and the distance grows by one over its
  // cosine; the square of that is for the circle's bending.
  [[nodiscard]] static double beside_joint(const Seen_chain<NT>& chain, double distance) {
    const Xy<NT> first = chain.circles[0].normal_at(chain.joint), second = chain.circles[1].normal_at(chain.joint);
    const Bracket angle = range_of(cross(first, second));
    const double sine =
        (std::max)(-angle.lower, angle.upper) / (length_range(first).lower * chain.circles[1].length.lower) * ROUND_UP;
    if (!(sine < 0.5)) return INFINITE;
    const double square = 1 + sine * sine / (1 - sine * sine);
    return distance * square * square * ROUND_UP;
  }

  // Both circles bound the region on both sides of its outer corner.  No point of the body is past the first one's
  // normal and before the second one's; where that is not proven a point beyond one of them may have its foot past the
  // corner. It is then in the wedge between the normals, near the corner, and farther from that normal by the wedge's
  // angle at most.
  [[nodiscard]] static double beside_corner(const Seen_chain<NT>& chain, const Weighted_piece<NT>& body,
                                            double distance) {
    const Xy<NT> first = chain.circles[0].normal_at(chain.joint), second = chain.circles[1].normal_at(chain.joint);
    const Bracket length0 = length_range(first), length1 = length_range(second), sine = range_of(cross(first, second));
    const Polynomial past0 = chain.past_normal(body, 0, chain.joint), past1 = chain.past_normal(body, 1, chain.joint);
    if (prove_nonnegative(NT(length0.upper / length1.upper) * past1 - past0, HALVINGS) == Proof::PROVEN)
      return distance;
    const double reach = farthest_from(chain.joint, body);
    double from_corner = 0;
    for (const Seen_circle<NT>& c : chain.circles) {
      const Xy<NT> v = chain.joint - c.point;
      const double off =
          -range_of(NT(c.curvature * dot(v, v) - NT(2) * dot(c.normal, v))).lower;  // of the corner, inside
      const double bend = -range_of(c.curvature).lower * reach * reach;  // of a circle that leaves its tangent outwards
      from_corner = (std::max)(from_corner, ((std::max)(off, 0.0) + (std::max)(bend, 0.0)) / c.length.lower);
    }
    const double cosine = range_of(dot(first, second)).lower / (length0.upper * length1.upper);
    if (!(cosine > 0)) return INFINITE;
    const double wedge = (std::max)(-sine.lower, sine.upper) / (length0.lower * length1.lower);
    return (distance + 2 * wedge * (distance + from_corner) * std::sqrt(2 / (1 + cosine))) * ROUND_UP;
  }

  double unit_, goal_ = 0, slack_ = 0;
  Seen_boundary<NT> boundary_;
  Weighted_piece<NT> piece_;
  Piece_squares<NT> squares_;
};

}  // namespace CGAL::Bounding_arcs::verify

#endif

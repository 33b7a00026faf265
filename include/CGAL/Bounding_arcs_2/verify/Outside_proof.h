// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve piece against a region's boundary over one number type, exact rationals or double-doubles with error bounds.
// The boundary is taken as it stands: circles need not pass through joints and ends, nor touch each other.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_OUTSIDE_PROOF_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_OUTSIDE_PROOF_H

#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>
#include <CGAL/Bounding_arcs_2/verify/Farthest_beyond.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// All lengths are in units of the curve's table, from the boundary's start. The curve is cut in three: heads and tails
/// that lie near an end point, and a body that lies between the normals at the ends of all arcs.  Where a point of the
/// body is beyond an arc its foot is on that arc, so its distance from the region is at most that from the circle.
template <class NT>
class Outside_proof {
 public:
  /// \param goal a distance, in units of the plane, below which nobody cares how small the bound is
  template <class Spiral, class FT>
  Outside_proof(const Spiral& spiral, double t0, double t1, const Region_boundary_2<FT>& boundary, double goal)
      : unit_(spiral.template table<NT>().unit()), origin_(number_from<NT>(boundary.inner[0].from)),
        piece_(weighted_piece(spiral, t0, t1, origin_)), end_(seen(boundary.inner[boundary.inner.size() - 1].to)),
        corner_(boundary.form == Region_form::SPIRAL_FAT_ARC) {
    const int turn = turn_of(boundary);
    outer_ = seen(boundary.outer, turn);
    inner_ = seen(boundary.inner, -turn);
    if (std::is_same_v<NT, Double_double>) slack_ = NOISE * length_range(end_).upper;
    goal_ = (std::max)(goal / unit_ * ROUND_DOWN * ROUND_DOWN - 2 * slack_, slack_);
  }

  /// At least the largest distance of a point of the piece from the region, in units of the plane.
  [[nodiscard]] double bound() const {
    const double from_ends = (std::min)(farthest_from({}, piece_), farthest_from(end_, piece_));
    const bool is_point = !(outer_.least_length() > 0 && inner_.least_length() > 0);
    return (is_point ? from_ends : (std::min)(from_ends, from_region())) * unit_ * ROUND_UP;
  }

  /// Whether a bound is well above this number type's own errors.
  [[nodiscard]] bool is_significant(double bound) const { return bound > SIGNIFICANT / NOISE * slack_ * unit_; }

 private:
  using Polynomial = Bernstein_polynomial<NT>;
  struct Seen_chain {
    std::vector<Seen_circle<NT>> circles;  ///< with normals to the inside of the region, of length about 1
    Xy<NT> joint;                          ///< where there are two
    int side = 1;                          ///< +1 where these are left normals
    [[nodiscard]] double least_length() const { return (std::min)(circles.front().length.lower, circles.back().length.lower); }
  };
  struct End {
    double share;     ///< of the parameters
    double distance;  ///< at most, of that part from the end point
  };

  // Shares of the chord: what end normals may be passed by, well above the errors of double-doubles and well below those
  // of doubles (passing them by that much adds at most twice as much to a distance), and what a bound must exceed for
  // this to be less than a hundredth of it.
  static constexpr double NOISE = 0x1p-75, SIGNIFICANT = 0x1p-66;
  static constexpr double CLOSE = 1.05;  // bounds of ends need not be closer to the least one than by this factor

  template <class FT>
  [[nodiscard]] Xy<NT> seen(const Xy<FT>& p) const { return NT(1 / unit_) * (number_from<NT>(p) - origin_); }

  template <class FT>
  [[nodiscard]] Seen_chain seen(const Boundary_chain_2<FT>& chain, int side) const {
    Seen_chain r;
    r.side = side;
    for (const Boundary_piece_2<FT>& p : chain) {
      const auto size = static_cast<double>((std::max)(std::fabs(p.support.normal.x), std::fabs(p.support.normal.y)));
      const NT factor(size > 0 ? std::ldexp(side, -std::clamp(std::ilogb(size), -1000, 1000)) : side);
      const Xy<NT> normal = factor * number_from<NT>(p.support.normal);
      const NT k = p.is_segment() ? NT(0) : NT(NT(unit_) * NT(factor * number_from<NT>(p.support.curvature)));
      r.circles.push_back({seen(p.support.point), normal, k, length_range(normal)});
    }
    if (chain.size() == 2) r.joint = seen(chain[0].to);
    return r;
  }

  // +1 for a left turn: the sign of the largest curvature, which is the tight end's.
  template <class FT>
  [[nodiscard]] static int turn_of(const Region_boundary_2<FT>& boundary) {
    FT largest(0);
    for (const auto* chain : {&boundary.outer, &boundary.inner})
      for (const auto& p : *chain) {
        const FT k = p.support.curvature / std::hypot(p.support.normal.x, p.support.normal.y);
        if (std::fabs(k) > std::fabs(largest)) largest = k;
      }
    return largest < 0 ? -1 : +1;
  }

  // The way from p along the chain's i-th circle, positive past its normal at p, with an allowance.
  [[nodiscard]] Polynomial ahead(const Seen_chain& chain, std::size_t i, const Xy<NT>& p, double allowance) const {
    return ahead(piece_, chain, i, p, allowance);
  }
  [[nodiscard]] static Polynomial ahead(const Weighted_piece<NT>& piece, const Seen_chain& chain, std::size_t i, const Xy<NT>& p,
                                        double allowance) {
    const Xy<NT> n = chain.circles[i].normal_at(p), along = NT(-chain.side) * perp(n);
    const Range length = length_range(n);
    return piece.linear(along, NT(NT(allowance * length.lower) - dot(along, p)));
  }

  // The convex hull of control points bounds the distance.
  [[nodiscard]] static double farthest_from(const Xy<NT>& p, const Weighted_piece<NT>& piece) {
    double r = 0;
    for (std::size_t i = 0; i < piece.weight.scaled_coefficients().size(); ++i) {
      const NT& w = piece.weight.scaled_coefficients()[i];
      const Xy<NT> q{piece.x.scaled_coefficients()[i], piece.y.scaled_coefficients()[i]};
      r = (std::max)(r, length_range(Xy<NT>(q - w * p)).upper / range_of(w).lower * ROUND_UP);
    }
    return r;
  }

  // The least part, about, after which all of the polynomials are positive up to the other end.
  [[nodiscard]] End cut_end(const std::vector<Polynomial>& strips, bool at_start) const {
    constexpr int HALVINGS = 6;         // of bodies; of shares, which begin within a factor 4
    constexpr double LARGEST = 0.25, LEAST = 0x1p-90;
    const auto part = [&](double share) {
      return at_start ? piece_.part(NT(0), NT(share)) : piece_.part(NT(NT(1) - NT(share)), NT(1));
    };
    const auto holds = [&](double share) {
      const NT from(at_start ? share : 0), to = NT(1) - NT(at_start ? 0 : share);
      return std::all_of(strips.begin(), strips.end(), [&](const Polynomial& p) {
        return proves_nonnegative(share == 0 ? p : Weighted_piece<NT>::part(p, from, to), HALVINGS);
      });
    };
    if (holds(0)) return {0, 0};
    const Xy<NT> point = at_start ? Xy<NT>{} : end_;
    const double least = farthest_from(point, part(LEAST));
    double share = (std::max)(LEAST, 2 * least / length_range(end_).lower);
    double too_little = 0;
    for (; share < LARGEST && !holds(share); share *= 4) too_little = share;
    if (!(share < LARGEST)) return {1, INFINITE};
    double distance = farthest_from(point, part(share));
    for (int i = 0; i < HALVINGS && distance > (std::max)(goal_, CLOSE * least); ++i) {
      const double middle = (too_little + share) / 2;
      if (!holds(middle)) too_little = middle;
      else share = middle;
      distance = farthest_from(point, part(share));
    }
    return {share, distance};
  }

  [[nodiscard]] double beyond_chain(const Seen_chain& chain, const Weighted_piece<NT>& body, const Piece_squares<NT>& squares,
                                    bool is_corner) const {
    Chain_excess<NT> excess;
    for (const Seen_circle<NT>& c : chain.circles) excess.pieces.push_back(squares.excess(c));
    excess.square = squares.weight;
    const bool has_joint = chain.circles.size() == 2;
    if (has_joint && !is_corner) excess.past = ahead(body, chain, 0, chain.joint, 0);
    const double distance = Farthest_beyond<NT>(chain.circles, goal_)(excess);
    if (!has_joint || distance == 0) return distance;
    return is_corner ? beside_corner(chain, body, distance) : beside_joint(chain, distance);
  }

  // A point is told by the first circle's normal at the joint which circle it belongs to.  Where its foot on the second
  // circle lies before that normal it is in a wedge of the two normals' angle, and the distance grows by one over its cosine;
  // the square of that is for the circle's bending.
  [[nodiscard]] static double beside_joint(const Seen_chain& chain, double distance) {
    const Xy<NT> first = chain.circles[0].normal_at(chain.joint), second = chain.circles[1].normal_at(chain.joint);
    const Range angle = range_of(cross(first, second));
    const double sine = (std::max)(-angle.lower, angle.upper) / (length_range(first).lower * chain.circles[1].length.lower) * ROUND_UP;
    if (!(sine < 0.5)) return INFINITE;
    const double square = 1 + sine * sine / (1 - sine * sine);
    return distance * square * square * ROUND_UP;
  }

  // Both circles bound the region on both sides of its outer corner.  No point of the body is past the first one's normal
  // and before the second one's; where that is not proven the feet may lie past the corner, which is then at most one
  // over the cosine of half its angle as far away as the circles through it would be.
  [[nodiscard]] static double beside_corner(const Seen_chain& chain, const Weighted_piece<NT>& body, double distance) {
    constexpr int HALVINGS = 6;
    const Xy<NT> first = chain.circles[0].normal_at(chain.joint), second = chain.circles[1].normal_at(chain.joint);
    const double length0 = length_range(first).upper, length1 = length_range(second).upper;
    const Polynomial past0 = ahead(body, chain, 0, chain.joint, 0), past1 = ahead(body, chain, 1, chain.joint, 0);
    if (proves_nonnegative(NT(length0 / length1) * past1 - past0, HALVINGS)) return distance;
    double gap = 0;
    for (const Seen_circle<NT>& c : chain.circles) {
      const Xy<NT> v = chain.joint - c.point;
      const Range off = range_of(NT(c.curvature * dot(v, v) - NT(2) * dot(c.normal, v)));
      gap = (std::max)(gap, (std::max)(-off.lower, off.upper) / c.length.lower);
      if (!(range_of(c.curvature).lower >= 0)) return INFINITE;  // a circle that bends away from the corner
    }
    const double cosine = range_of(dot(first, second)).lower / (length0 * length1);
    return cosine > 0 ? (distance + gap) * std::sqrt(2 / (1 + cosine)) * ROUND_UP : INFINITE;
  }

  [[nodiscard]] double from_region() const {
    std::vector<Polynomial> after, before;
    for (const Seen_chain* chain : {&outer_, &inner_}) {
      after.push_back(ahead(*chain, 0, {}, slack_));
      before.push_back(NT(-1) * ahead(*chain, chain->circles.size() - 1, end_, -slack_));
    }
    const End head = cut_end(after, true), tail = cut_end(before, false);
    if (!(head.share + tail.share < 1)) return INFINITE;
    const Weighted_piece<NT> body = piece_.part(NT(head.share), NT(NT(1) - NT(tail.share)));
    const Piece_squares<NT> squares(body);
    const double beyond = (std::max)(beyond_chain(outer_, body, squares, corner_), beyond_chain(inner_, body, squares, false));
    return ((std::max)({head.distance, tail.distance, beyond}) + 2 * slack_) * ROUND_UP;
  }

  double unit_, goal_ = 0, slack_ = 0;
  Xy<NT> origin_;
  Weighted_piece<NT> piece_;
  Xy<NT> end_;
  bool corner_;
  Seen_chain outer_, inner_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

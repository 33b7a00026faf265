// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Proofs that no point of a region's outer boundary is farther from its inner boundary than a length, by its two chains
// alone and not by the formula that the length came from.
//
// The normal at the inner joint cuts an outer arc at most once.  On each side of it the points' feet are on one inner
// arc, and along an arc of less than a half turn the signed distance to a circle has no more than one extremum between
// the ends, on the line of centers: there it is the deviation of the two circles, |e| / (|k - k'| + sqrt((k - k')^2 + k
// k' e)) with e their Lie product.  Arcs for which any of that is open are halved; parts that are short beside the room
// left, at the ends of boundaries whose rounding shows, are within their length of their middle's distance.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_THICKNESS_PROOF_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_THICKNESS_PROOF_H

#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

/// A boundary piece with the square roots taken that its distances need.
struct Oriented_arc {
  Xy<Mpfr_interval> from, to, point, normal;  ///< normal of length 1, at point
  Mpfr_interval curvature;
  bool is_segment;

  explicit Oriented_arc(const Boundary_piece_2<Mpfr_interval>& p)
      : from(p.from), to(p.to), point(p.support.point), normal(p.support.normal), curvature(p.support.curvature),
        is_segment(p.is_segment()) {
    const Mpfr_interval length = sqrt(dot(normal, normal));
    normal = Mpfr_interval(1) / length * normal;
    curvature = curvature / length;
  }
  [[nodiscard]] Xy<Mpfr_interval> normal_at(const Xy<Mpfr_interval>& q) const {
    return normal - curvature * (q - point);
  }
  [[nodiscard]] Xy<Mpfr_interval> tangent_at(const Xy<Mpfr_interval>& q) const { return -perp(normal_at(q)); }
  /// k |v|^2 - 2 n v, v = q - point: 0 on the circle.
  [[nodiscard]] Mpfr_interval excess(const Xy<Mpfr_interval>& q) const {
    const Xy<Mpfr_interval> v = q - point;
    return curvature * dot(v, v) - Mpfr_interval(2) * dot(normal, v);
  }
  [[nodiscard]] Mpfr_interval distance(const Xy<Mpfr_interval>& q) const {
    const Mpfr_interval e = excess(q), one(1);
    return abs(e) / (one + sqrt(max BOOST_PREVENT_MACRO_SUBSTITUTION(one + curvature * e, Mpfr_interval(0))));
  }
};

/// The deviation of two circles that run side by side, from their Lie product.
[[nodiscard]] inline Mpfr_interval circle_deviation(const Oriented_arc& a, const Oriented_arc& b) {
  const Mpfr_interval two(2);
  const Xy<Mpfr_interval> d = b.point - a.point, turned = b.normal - a.normal;
  const Mpfr_interval product = a.curvature * b.curvature * dot(d, d) + two * a.curvature * dot(d, b.normal) -
                                two * b.curvature * dot(d, a.normal) + dot(turned, turned);
  const Mpfr_interval change = b.curvature - a.curvature,
                      square = change * change + a.curvature * b.curvature * product;
  return abs(product) / (abs(change) + sqrt(max BOOST_PREVENT_MACRO_SUBSTITUTION(square, Mpfr_interval(0))));
}

/// Whether every point of `outer` is within `length` of `inner`; chains of one or two pieces that run the same way,
/// those of the inner one tangent at their joint but for rounding.
class Thickness_proof {
 public:
  /// \param has_common_start,has_common_end the two chains start, end in one point
  Thickness_proof(const Region_boundary_2<Mpfr_interval>& region, const Mpfr_interval& length,
                  bool has_common_start = true, bool has_common_end = true)
      : length_(length), has_common_start_(has_common_start), has_common_end_(has_common_end) {
    for (const auto& piece : region.inner) inner_.emplace_back(piece);
    for (const auto& piece : region.outer) outer_.emplace_back(piece);
  }

  static constexpr int MOST_PARTS = 200;

  /// \param parts how often arcs are halved at most
  [[nodiscard]] bool holds(int parts = MOST_PARTS) const {
    if (is_flat()) return true;
    constexpr int DEPTH = 60;
    for (std::size_t i = 0; i < outer_.size(); ++i) {
      const Oriented_arc& arc = outer_[i];
      if (!holds_halved(arc, bulge_of(arc), has_common_start_ && i == 0, has_common_end_ && i + 1 == outer_.size(),
                        DEPTH, parts))
        return false;
    }
    return true;
  }

 private:
  using Point = Xy<Mpfr_interval>;
  [[nodiscard]] static bool is_positive(const Mpfr_interval& x) { return x.certain_sign() > 0; }
  [[nodiscard]] bool is_within(const Mpfr_interval& distance) const { return is_positive(length_ - distance); }

  // Both chains are so near to the chord that they share that nothing else matters: at the same place along the chord,
  // or at an end, a point of the outer one has one of the inner one within the heights of both and the outer one's
  // overshoot.
  [[nodiscard]] bool is_flat() const {
    if (!has_common_start_ || !has_common_end_) return false;
    const Point chord = outer_.back().to - outer_.front().from;
    const Mpfr_interval length = sqrt(dot(chord, chord)), tenth = Mpfr_interval(1) / Mpfr_interval(10);
    Mpfr_interval heights(0);
    for (const auto* chain : {&outer_, &outer_, &inner_}) {
      for (const Oriented_arc& arc : *chain) {
        const Point half = Mpfr_interval(1) / Mpfr_interval(2) * (arc.to - arc.from);
        const Mpfr_interval bulge = abs(bulge_of(arc));
        if (!is_positive(tenth - bulge)) return false;
        heights = heights + bulge * sqrt(dot(half, half));
      }
      const Point joint = chain->front().to - chain->front().from;
      if (chain->size() == 1) continue;
      if (!is_positive(dot(joint, chord)) || !is_positive(dot(chord - joint, chord))) return false;
      heights = heights + abs(cross(chord, joint)) / length;
    }
    return is_within(heights);
  }
  [[nodiscard]] static Mpfr_interval bulge_of(const Oriented_arc& arc) {
    const Point chord = arc.to - arc.from, tangent = arc.tangent_at(arc.from);
    return cross(tangent, chord) / (sqrt(dot(chord, chord)) + dot(tangent, chord));
  }
  [[nodiscard]] bool holds_halved(const Oriented_arc& arc, const Mpfr_interval& bulge, bool is_first, bool is_last,
                                  int depth, int& parts) const {
    const Point half = Mpfr_interval(1) / Mpfr_interval(2) * (arc.to - arc.from),
                middle = arc.from + half - bulge * perp(half);
    const Mpfr_interval one(1), square = bulge * bulge;
    if (is_positive(one - square) && holds_for(arc, is_first, is_last)) return true;
    if (is_short(middle, sqrt((one + square) * dot(half, half)))) return true;
    if (depth == 0 || --parts < 0) return false;
    const Mpfr_interval half_bulge = bulge / (one + sqrt(one + square));
    Oriented_arc first = arc, second = arc;
    first.to = second.from = middle;
    return holds_halved(first, half_bulge, is_first, false, depth - 1, parts) &&
           holds_halved(second, half_bulge, false, is_last, depth - 1, parts);
  }
  // Within the length even with the distance from the middle to an end, which no point of an arc of less than a half
  // turn is farther from the middle than.
  [[nodiscard]] bool is_short(const Point& middle, const Mpfr_interval& reach) const {
    for (const Oriented_arc& inner : inner_) {
      const bool has_foot = is_positive(dot(middle - inner.from, inner.tangent_at(inner.from))) &&
                            is_positive(dot(inner.to - middle, inner.tangent_at(inner.to)));
      if (has_foot && is_within(reach + inner.distance(middle))) return true;
      for (const Point& end : {inner.from, inner.to})
        if (is_within(reach + sqrt(dot(middle - end, middle - end)))) return true;
    }
    return false;
  }
  // The normals at the inner chain's ends and joint cut the plane; the outer piece stays between the first and the
  // last.
  [[nodiscard]] bool holds_for(const Oriented_arc& outer, bool is_first, bool is_last) const {
    const Oriented_arc &begin = inner_.front(), &end = inner_.back();
    const Point start = begin.tangent_at(begin.from), stop = -end.tangent_at(end.to);
    if (!is_ahead(outer, begin.from, start, is_first, is_last) || !is_ahead(outer, end.to, stop, is_first, is_last))
      return false;
    if (inner_.size() == 1) return holds_between(outer, outer.from, outer.to, begin);
    // Before the first circle's normal at the joint feet are on that circle's arc, behind the second's on the other.
    // Where rounding leaves a wedge between the two the joint is nearest, and where the two overlap either arc will do.
    const Point &joint = begin.to, first = begin.tangent_at(joint), second = end.tangent_at(joint);
    if (is_ahead(outer, joint, -first, false, false) && holds_between(outer, outer.from, outer.to, begin)) return true;
    if (is_ahead(outer, joint, second, false, false) && holds_between(outer, outer.from, outer.to, end)) return true;
    const std::optional<Point> to_wedge = passes(outer, joint, first), from_wedge = passes(outer, joint, second);
    if (to_wedge && from_wedge) {
      if (holds_between(outer, outer.from, *to_wedge, begin) && holds_around(outer, *to_wedge, *from_wedge, joint) &&
          holds_between(outer, *from_wedge, outer.to, end))
        return true;
      if (!is_positive(dot(*to_wedge - *from_wedge, first))) return false;
      const auto splits_at = [&](const Point& q) {
        return holds_between(outer, outer.from, q, begin) && holds_between(outer, q, outer.to, end);
      };
      return splits_at(*from_wedge) || splits_at(*to_wedge);
    }
    if (to_wedge && is_ahead(outer, joint, -second, false, false))
      return holds_between(outer, outer.from, *to_wedge, begin) && holds_around(outer, *to_wedge, outer.to, joint);
    if (from_wedge && is_ahead(outer, joint, first, false, false))
      return holds_around(outer, outer.from, *from_wedge, joint) && holds_between(outer, *from_wedge, outer.to, end);
    return is_ahead(outer, joint, first, false, false) && is_ahead(outer, joint, -second, false, false) &&
           holds_around(outer, outer.from, outer.to, joint);
  }
  // Where the piece passes the normal at the joint of a circle with this tangent there, if its ends are on either side.
  [[nodiscard]] static std::optional<Point> passes(const Oriented_arc& outer, const Point& joint,
                                                   const Point& tangent) {
    if (!is_positive(dot(joint - outer.from, tangent)) || !is_positive(dot(outer.to - joint, tangent)))
      return std::nullopt;
    return crossing(outer, joint, perp(tangent));
  }
  // On the part of the outer piece between p and q the joint is within the length.
  [[nodiscard]] bool holds_around(const Oriented_arc& outer, const Point& p, const Point& q, const Point& joint) const {
    const auto distance = [&](const Point& r) { return sqrt(dot(r - joint, r - joint)); };
    if (!is_within(distance(p)) || !is_within(distance(q))) return false;
    const Mpfr_interval slope_p = dot(outer.tangent_at(p), p - joint), slope_q = dot(outer.tangent_at(q), q - joint);
    return is_positive(-slope_p) || is_positive(slope_q) ||
           is_within(distance(p) + Mpfr_interval(2) * sqrt(dot(q - p, q - p)));
  }
  // All of the piece is in the half plane of p in the direction v: both ends are, or are p itself, and the way along v,
  // which changes its sense once at most in less than a half turn, does not fall first and rise then, or hardly: within
  // a right angle it falls nowhere faster than at that end, and no longer than twice the chord.
  [[nodiscard]] static bool is_ahead(const Oriented_arc& outer, const Point& p, const Point& v, bool is_first,
                                     bool is_last) {
    const Mpfr_interval from = dot(outer.from - p, v), to = dot(outer.to - p, v);
    if ((!is_first && !is_positive(from)) || (!is_last && !is_positive(to))) return false;
    const Point begin = outer.tangent_at(outer.from), end = outer.tangent_at(outer.to), chord = outer.to - outer.from;
    const Mpfr_interval rise = dot(begin, v), fall = -dot(end, v);
    if (is_positive(rise) || is_positive(fall)) return true;
    const Mpfr_interval most = Mpfr_interval(2) * sqrt(dot(chord, chord));
    return is_positive(dot(begin, end)) && (is_positive(from - most * abs(rise)) || is_positive(to - most * abs(fall)));
  }
  // On the part of the outer piece between p and q, whose feet are on the inner one.
  [[nodiscard]] bool holds_between(const Oriented_arc& outer, const Point& p, const Point& q,
                                   const Oriented_arc& inner) const {
    if (!is_within(inner.distance(p)) || !is_within(inner.distance(q))) return false;
    if (outer.is_segment && inner.is_segment) return true;
    // of the distance by the way along the outer piece, over a length near 1: A cos(angle - angle0) along an arc
    const Mpfr_interval slope_p = dot(outer.tangent_at(p), inner.normal_at(p)),
                        slope_q = dot(outer.tangent_at(q), inner.normal_at(q));
    if (slope_p.certain_sign() * slope_q.certain_sign() > 0) return true;  // no extremum between
    const Mpfr_interval near_p = dot(outer.normal_at(p), inner.normal_at(p)),
                        near_q = dot(outer.normal_at(q), inner.normal_at(q));
    if (!is_positive(near_p) || !is_positive(near_q)) return false;  // the extremum may be on the far side
    if (is_within(circle_deviation(outer, inner))) return true;
    // circles that are one: turning by a right angle at most, A is no more than twice the larger slope, nor the way
    // than twice the chord
    const Mpfr_interval slope = max BOOST_PREVENT_MACRO_SUBSTITUTION(abs(slope_p), abs(slope_q)),
                        half = Mpfr_interval(1) / Mpfr_interval(2);
    return is_positive(near_p - half) && is_positive(near_q - half) &&
           is_positive(dot(outer.tangent_at(p), outer.tangent_at(q)) + half) &&
           is_within(inner.distance(p) + Mpfr_interval(8) * slope * sqrt(dot(q - p, q - p)));
  }
  // The point, near a given one, where the line through that along a normal of length 1 meets the circle of a piece.
  [[nodiscard]] static std::optional<Point> crossing(const Oriented_arc& outer, const Point& point,
                                                     const Point& normal) {
    const Mpfr_interval excess = outer.excess(point), half = dot(outer.normal_at(point), normal);
    const Mpfr_interval root = half * half + outer.curvature * excess * Mpfr_interval(-1) * dot(normal, normal);
    if (!is_positive(half) || !is_positive(root)) return std::nullopt;
    return point + excess / (half + sqrt(root)) * normal;
  }

  Mpfr_interval length_;
  bool has_common_start_, has_common_end_;
  std::vector<Oriented_arc> inner_, outer_;
};

/// Proves the thickness with as many bits as it takes. Where the most bits leave it open by no more than EQUAL, the
/// lengths are taken as equal. More bits prove at once what many halvings do not prove with too few, so these are for
/// what is left.
/// \param boundary bits -> Region_boundary_2<Mpfr_interval>
template <class Boundary>
[[nodiscard]] bool prove_thickness(const Boundary& boundary, const CGAL::Exact_rational& length) {
  constexpr mpfr_prec_t FIRST = 128, LAST = 8192;
  constexpr int FEW_PARTS = 4;
  const CGAL::Exact_rational EQUAL(0x1p-1000);
  for (const int parts : {FEW_PARTS, Thickness_proof::MOST_PARTS})
    for (mpfr_prec_t bits = FIRST; bits <= LAST; bits *= 4) {
      try {
        const Region_boundary_2<Mpfr_interval> region = boundary(bits);
        if (Thickness_proof(region, Mpfr_interval(length, bits)).holds(parts)) return true;
        if (bits == LAST &&
            Thickness_proof(region, Mpfr_interval(CGAL::Exact_rational(length + EQUAL), bits)).holds(parts))
          return true;
      } catch (const CGAL::Uncertain_conversion_exception&) {  // the form is open
      }
    }
  return false;
}

}  // namespace CGAL::Bounding_arcs::verify

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far the true axis is from the line between two discs, by the fat arcs of both parts of the boundary.
//
// Let a and b be the distances from the circles of both arcs, and w the half widths together.  A disc of the axis with
// its center x and a foot on one part is no larger than what the other part leaves: |a - b| <= w at x.  Along the line,
// with the share s, the direction v, the normal n and the length h, and at the height z above it,
//   a - b = (the same between both ends) - s (1 - s) h^2 / 2 (a'' - b'') + z (A - B),   A = n.grad a,  B = n.grad b,
// where a'' and b'' are along v: minus the curvature of the circle about the arc's center through the place, times A^2.
// So with what ends miss, e, and with everything taken at its worst near the line,
//   |z| <= (h^2 / 8 |a'' - b''| + w + e) / |A - B|,
// and the radius is off the line's by h^2 / 8 |a'' B - b'' A| / |A - B| and what w and e make of it.
// What is worst near the line: the gradient turns by the curvature times the way, and curvatures k become k / (1 - k
// way).

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_LINE_PROVER_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_LINE_PROVER_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include "Line_parts.h"
#include "Rolled_discs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace CGAL::Bounding_arcs::internal {

// How much the distance from an arc's circle changes about a place: its gradient, and its second derivative along a
// line. What is between two discs of an axis is bounded by these.

struct Sight_change {
  double turn;      // of the gradient, at most
  Bracket second;   // the second derivative along the line
  double tightest;  // curvature of a circle about the arc's center, at most

  [[nodiscard]] double most_second() const { return (std::max)(std::fabs(second.lower), std::fabs(second.upper)); }
};

/// Along the line by `way` the gradient turns by its part across it times the curvature, across by the curvature.
/// \param across the gradient's part across the line
/// \param way, reach how far places are along the line and across
[[nodiscard]] inline Sight_change sight_change(const Arc_sight& s, double across, double way, double reach) {
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  const double k = std::fabs(s.curvature), most = k / (1 - k * (way + reach)), square = across * across;
  if (!(k * (way + reach) < 0.5) || !(most * way < 0.75)) return {INFINITE, {-INFINITE, INFINITE}, INFINITE};
  const double turn = most * (std::fabs(across) * way + reach) / (1 - most * way);
  const double bend = most * (2 * std::fabs(across) * turn + turn * turn) + k * most * (way + reach) * square;
  const double value = -s.curvature * square;
  return {turn, {value - bend, value + bend}, most};
}

class Line_prover {
 public:
  Line_prover(const Segment_hierarchy& curves, double size) : parts_(curves, size), rolled_(parts_), size_(size) {}
  Line_prover(const Line_prover&) = delete;
  Line_prover& operator=(const Line_prover&) = delete;

  static constexpr double UNBOUNDED = Line_parts::UNBOUNDED;

  struct Result {
    double bound = UNBOUNDED;  ///< certified
    double seen = 0;           ///< about how far the axis is from the line's middle
    double off = 0;            ///< how far its ends are from the whole line
    bool is_in_order = true;   ///< both cells
  };
  [[nodiscard]] Result prove(const Axis_line& line) const { return prove(line, line); }
  /// \param whole the line that the bound is from, of which the other one is between two discs
  [[nodiscard]] Result prove(const Axis_line& line, const Axis_line& whole) const {
    const Part a = parts_.part(line.left, true), b = parts_.part(line.right, false);
    Result result;
    result.is_in_order = is_in_order(line, a) && is_in_order(line, b);
    const Band band(line, a, b, size_);
    result.seen = band.seen();
    const double beside = beside_feet(line, a) + beside_feet(line, b);
    if (&line != &whole) result.off = (std::max)(off_line(line.first, whole), off_line(line.last, whole));
    const double by_band = (std::min)(band.bound(), rolled_.bound_between_corners(line, whole, a, b)) + result.off,
                 by_line = (std::min)(by_band, rolled_.bound(line, whole, a, b, result.off)) + beside;
    const double by_tip = rolled_.tip_bound(line, a, b);
    result.bound = result.is_in_order ? (std::min)(by_line, by_tip) : by_tip;
    result.is_in_order = result.is_in_order || by_tip < UNBOUNDED;
    return result;
  }

  /// The disc half way between, by a search for the second foot; nothing where it is not found.
  struct Middle {
    Touching_disc disc;
    Foot_run left[2], right[2];
  };
  [[nodiscard]] std::optional<Middle> middle(const Axis_line& line) const {
    const bool is_half_of_left =
        line.right.is_point || (!line.left.is_point && length(line.left) >= length(line.right));
    const Foot_run &half = is_half_of_left ? line.left : line.right, &other = is_half_of_left ? line.right : line.left;
    if (half.is_point) return between_points(line);
    const double t = half.from + 0.5 * (half.to - half.from);
    const bool is_against = is_half_of_left;  // the boundary's direction
    const Boundary_jet p = jet(half, t, is_against);
    Boundary_jet q{};
    double u = 0;
    Touching_disc disc{};
    if (other.is_point) {
      const Xy<double> way = other.point - p.point;
      const double height = dot(way, p.normal());
      if (!(height > 0)) return std::nullopt;
      disc.radius = dot(way, way) / (2 * height);
      disc.center = p.point + disc.radius * p.normal();
    } else {
      // (q - p).(Tq - Tp) grows in the direction of the boundary
      double low = is_against ? other.from : other.to, high = is_against ? other.to : other.from;
      constexpr int STEPS = 52;
      for (int i = 0; i < STEPS; ++i) {
        u = low + 0.5 * (high - low);
        if (u == low || u == high) break;
        q = jet(other, u, !is_against);
        if (!(dot(q.point - p.point, q.tangent - p.tangent) > 0)) low = u;
        else high = u;
      }
      q = jet(other, u, !is_against);
      disc = disc_of(p, q);
    }
    if (!(disc.radius > 0)) return std::nullopt;
    const auto halves = [](const Foot_run& run, double at, Foot_run(&result)[2]) {
      result[0] = result[1] = run;
      if (!run.is_point) result[0].to = result[1].from = at;
    };
    Middle result{disc, {}, {}};
    halves(line.left, is_half_of_left ? t : u, result.left);
    halves(line.right, is_half_of_left ? u : t, result.right);
    return result;
  }

 private:
  using Part = Line_part;
  // On the line of places that are as far from both.
  [[nodiscard]] static std::optional<Middle> between_points(const Axis_line& line) {
    const Xy<double>&p = line.left.point, &q = line.right.point, way = q - p;
    const double square = dot(way, way);
    if (!(square > 0)) return std::nullopt;
    Xy<double> center = line.first.center + 0.5 * (line.last.center - line.first.center);
    const double off = dot(center - p, way) / square - 0.5;
    center = center - off * way;
    return Middle{{center, euclidean_norm(center - p)}, {line.left, line.left}, {line.right, line.right}};
  }
  [[nodiscard]] double length(const Foot_run& run) const {
    return euclidean_norm(parts_.sample(run.segment, run.to).point - parts_.sample(run.segment, run.from).point);
  }
  // In the direction of the boundary.
  [[nodiscard]] Boundary_jet jet(const Foot_run& run, double t, bool is_against) const {
    const Spiral_sample s = parts_.sample(run.segment, t);
    return {s.point, run.is_growing() == is_against ? -s.tangent : s.tangent, 1, 0};
  }

  class Band {
   public:
    Band(const Axis_line& line, const Part& a, const Part& b, double size)
        : line_(line), a_(a), b_(b), way_(line.last.center - line.first.center), length_(euclidean_norm(way_)) {
      const Xy<double> middle = line.first.center + 0.5 * way_;
      of_a_ = sight(middle, a.fat.arc), of_b_ = sight(middle, b.fat.arc);
      constexpr double LEAST = 0x1p-30;  // of the size: there the direction is not to be had from centers
      const Xy<double> across = of_a_.gradient - of_b_.gradient;
      const Xy<double> v = length_ > LEAST * size ? way_ : perp(across);
      const double norm = euclidean_norm(v);
      along_ = (1 / norm) * v;
      const Xy<double> n = perp(along_);
      a_across_ = dot(n, of_a_.gradient), b_across_ = dot(n, of_b_.gradient), slant_ = std::fabs(dot(along_, across));
      radius_ = 0.5 * (line.first.radius + line.last.radius);
      miss_ = (std::max)(miss(line.first), miss(line.last));
      // the distances of an end from both circles, see ARC_DISTANCE_ERROR; the rest is relative to lengths above
      slack_ = 2 * ARC_DISTANCE_ERROR *
               (radius_ + length_ + euclidean_norm(a.fat.arc.to - a.fat.arc.from) +
                euclidean_norm(b.fat.arc.to - b.fat.arc.from));
    }
    [[nodiscard]] double seen() const {
      const double height = (of_b_.distance - of_a_.distance) / (a_across_ - b_across_);
      const double off = of_a_.distance + height * a_across_ - radius_;
      const double sum = std::fabs(height) + std::fabs(off);
      return std::isfinite(sum) ? sum : 0;
    }
    // The bound holds where it is no larger than the reach that it was made with.
    [[nodiscard]] double bound() const {
      double reach =
          1.1 * seen() + 2 * (slack_ + miss_ + a_.fat.radius + b_.fat.radius) / std::fabs(a_across_ - b_across_);
      constexpr int TRIALS = 12;
      for (int i = 0; i < TRIALS; ++i) {
        const double found = bound(reach);
        if (found <= reach || !std::isfinite(found)) return found * ROUNDED_UP<64>;
        reach = 1.25 * found;
      }
      return UNBOUNDED;
    }

   private:
    [[nodiscard]] double miss(const Touching_disc& d) const {
      return (std::max)(std::fabs(sight(d.center, a_.fat.arc).distance - d.radius),
                        std::fabs(sight(d.center, b_.fat.arc).distance - d.radius));
    }
    // The largest difference of two numbers.
    [[nodiscard]] static double apart(const Bracket& a, const Bracket& b) {
      return (std::max)(a.upper - b.lower, b.upper - a.lower);
    }
    [[nodiscard]] static Bracket times(double x, const Bracket& a) {
      return x < 0 ? Bracket{x * a.upper, x * a.lower} : Bracket{x * a.lower, x * a.upper};
    }
    [[nodiscard]] double bound(double reach) const {
      // rays along normals of the boundary pass the line beside its ends by what the height makes of it
      const Sight_change near_a = sight_change(of_a_, a_across_, 0.5 * length_, reach),
                         near_b = sight_change(of_b_, b_across_, 0.5 * length_, reach);
      const double slope = (std::min)(std::fabs(a_across_) - near_a.turn, std::fabs(b_across_) - near_b.turn);
      if (!(slope > 0)) return UNBOUNDED;
      const double past = 2 * reach / slope, way = 0.5 * length_ + past;
      const Sight_change a = sight_change(of_a_, a_across_, way, reach), b = sight_change(of_b_, b_across_, way, reach);
      const double between = std::fabs(a_across_ - b_across_) - a.turn - b.turn;
      if (!(between > 0)) return UNBOUNDED;
      const double square = (length_ * length_ + 4 * past * (length_ + past)) / 8;
      const double up = apart(a.second, b.second);
      const double off = apart(times(b_across_, a.second), times(a_across_, b.second)) + a.most_second() * b.turn +
                         b.most_second() * a.turn;
      // along a ray that passes the line at an end a foot is moved by twice the height at most
      const double moved = 2 * reach + (a.turn + b.turn) * past;
      // past the ends what they miss changes as a - b does along the line
      const double wide = a_.fat.radius + b_.fat.radius + 2 * miss_ + slant_ * past + slack_ +
                          (std::max)(over(moved, of_a_.curvature > 0 ? a.tightest : 0, reach),
                                     over(moved, of_b_.curvature > 0 ? b.tightest : 0, reach));
      // A center that is past an end by g is at least as high as slope g there, and at most g (h + past) / 2 times the
      // bend and what ends miss. It is no nearer to the line than to the end, whose radius differs by no more than g.
      const double missed = 2 * wide / between, rise = 0.5 * (length_ + past) * up / between,
                   gap = slope > rise ? (std::min)(past, missed / (slope - rise)) : past;
      return (square * (up + off) + 2 * wide) / between + wide + 2 * gap;
    }
    // A foot may be past the end of its arc. Where the center is moved by m along the arc's circles, the foot on the
    // arc's own, of curvature k, is so by m / (1 - k d), and the end is farther than that circle by half of
    // m^2 / (d (1 - k d)) = m^2 (1 / d + K), K the curvature in the center. No foot is past a corner, where the disc is
    // a point.
    [[nodiscard]] double over(double moved, double bend, double reach) const {
      double most = 0;
      for (const Touching_disc* d : {&line_.first, &line_.last}) {
        if (!(d->radius > 0)) continue;
        const double distance = d->radius - 2 * reach, aside = moved * (1 + bend * (radius_ + length_));
        most = (std::max)(most, distance > 0 ? (std::min)(aside, 0.5 * moved * moved * (1 / distance + bend)) : aside);
      }
      return most;
    }

    const Axis_line& line_;
    const Part &a_, &b_;
    Xy<double> way_, along_{};
    double length_, a_across_ = 0, b_across_ = 0, slant_ = 0, radius_ = 0, miss_ = 0, slack_ = 0;
    Arc_sight of_a_{}, of_b_{};
  };

  // A line to a foot that is not normal there moves the cell's side; and where the boundary is more curved than the
  // disc, a branch as long as both curvatures tell may be missing.
  [[nodiscard]] double beside_feet(const Axis_line& line, const Part& p) const {
    if (p.is_point) return 0;
    double sum = 0;
    for (const bool is_first : {true, false}) {
      const Touching_disc& d = is_first ? line.first : line.last;
      const Spiral_sample& s = p.at(is_first);
      const double aside = std::fabs(dot(d.center - s.point, s.tangent)) + d.radius * s.tangent_error;
      const double excess = p.fat.arc.bulge > 0 && d.radius > 0 ? s.most_curvature * d.radius - 1 : 0;
      constexpr double LONGER = 4;  // than the radii differ
      sum += 2 * aside + (excess > 0 ? LONGER * d.radius * excess : 0);
    }
    return sum;
  }

  [[nodiscard]] static double off_line(const Touching_disc& d, const Axis_line& whole) {
    const Xy<double> chord = whole.last.center - whole.first.center, way = d.center - whole.first.center;
    const double square = dot(chord, chord), share = square > 0 ? std::clamp(dot(way, chord) / square, 0.0, 1.0) : 0;
    const double radius = whole.first.radius + share * (whole.last.radius - whole.first.radius);
    return euclidean_norm(way - share * chord) + std::fabs(d.radius - radius);
  }

  // Whether a cell is not turned inside out. Its corners are the feet p and q and the centers c and d behind them.
  [[nodiscard]] bool is_in_order(const Axis_line& line, const Part& part) const {
    const Xy<double>&p = part.begin.point, &q = part.end.point;
    const Xy<double>&c = part.is_left ? line.last.center : line.first.center,
          &d = part.is_left ? line.first.center : line.last.center;
    constexpr double THIN = 0x1p-40;  // of the size, for all parts of a line together
    if (euclidean_norm(q - p) + euclidean_norm(d - c) <= THIN * size_ * line.share) return true;
    const bool is_by_first = is_left(p, q, d) && is_left(p, d, c), is_by_second = is_left(p, q, c) && is_left(q, d, c);
    if (!is_by_first && !is_by_second) return false;
    const double b = part.fat.arc.bulge;
    if (part.is_point || !(b < 0)) return true;
    // an arc to the inside of its chord is below the tangents at its ends
    const Xy<double> chord = q - p, apex = p + 0.5 * chord - (b / (1 - b * b)) * perp(chord);
    return is_left(q, d, apex) && is_left(d, c, apex) && is_left(c, p, apex);
  }
  [[nodiscard]] bool is_left(const Xy<double>& p, const Xy<double>& q, const Xy<double>& r) const {
    constexpr double ROUNDING = 0x1p-44;  // of the size: cells that are thinner there are as good as in order
    const Xy<double> way = q - p, other = r - p;
    return cross(way, other) >= -ROUNDING * size_ * (std::max)(euclidean_norm(way), euclidean_norm(other));
  }

  Line_parts parts_;
  Rolled_discs rolled_;
  double size_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

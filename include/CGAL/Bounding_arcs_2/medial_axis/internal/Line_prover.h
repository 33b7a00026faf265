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

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_LINE_PROVER_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_LINE_PROVER_H

#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_lines.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Line_prover {
 public:
  Line_prover(const Segment_hierarchy& curves, double size) : curves_(curves), size_(size) {
    for (std::uint32_t i = 0; i < curves.number_of_segments(); ++i) error_ = (std::max)(error_, curves.error(i));
  }

  static constexpr double UNBOUNDED = std::numeric_limits<double>::infinity();

  struct Result {
    double bound = UNBOUNDED;  ///< certified
    double seen = 0;           ///< about how far the axis is from the line's middle
    double off = 0;            ///< how far its ends are from the whole line
    bool is_in_order = true;   ///< both cells
  };
  [[nodiscard]] Result prove(const Axis_line& line) const { return prove(line, line); }
  /// \param whole the line that the bound is from, of which the other one is between two discs
  [[nodiscard]] Result prove(const Axis_line& line, const Axis_line& whole) const {
    const Part a = part(line.left, true), b = part(line.right, false);
    Result result;
    result.is_in_order = is_in_order(line, a) && is_in_order(line, b);
    const Band band(line, a, b, size_);
    result.seen = band.seen();
    const double beside = beside_feet(line, a) + beside_feet(line, b);
    if (&line != &whole) result.off = (std::max)(off_line(line.first, whole), off_line(line.last, whole));
    const double by_line = (std::min)(band.bound() + result.off, rolled_bound(line, whole, a, b, result.off)) + beside;
    const double by_tip = tip_bound(line, a, b);
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
        if (!(dot(q.point - p.point, q.tangent - p.tangent) > 0)) (is_against ? low : low) = u;
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
  // A part of the boundary in its direction: a fat arc, or a point, and samples at both ends.
  struct Part {
    bool is_point = false, is_left = false;
    std::uint32_t segment = 0;
    Fat_arc_2 fat{};
    Spiral_sample begin, end;
    double error = 0;  // of its points
    [[nodiscard]] const Spiral_sample& at(bool is_first) const { return is_first != is_left ? begin : end; }
  };
  [[nodiscard]] Part part(const Foot_run& run, bool is_left) const {
    Part p;
    p.is_left = is_left, p.is_point = run.is_point, p.segment = run.segment;
    if (run.is_point) {
      p.begin.point = p.end.point = p.fat.arc.from = p.fat.arc.to = run.point;
      p.fat.radius = 8 * HALF_ULP * size_;
      return p;
    }
    const bool is_growing = run.is_growing() != is_left;
    const double begin = is_left ? run.to : run.from, end = is_left ? run.from : run.to;
    p.error = curves_.error(run.segment);
    p.begin = sample(run.segment, begin), p.end = sample(run.segment, end);
    p.fat = curves_.region(is_growing ? Spiral_piece_2{run.segment, p.begin, p.end}
                                      : Spiral_piece_2{run.segment, p.end, p.begin});
    if (!is_growing) {
      p.fat.arc = reversed(p.fat.arc);
      p.begin.tangent = -p.begin.tangent, p.end.tangent = -p.end.tangent;
    }
    // a piece that is hardly longer than the error
    if (p.fat.radius >= euclidean_norm(p.fat.arc.to - p.fat.arc.from)) {
      p.is_point = true;
      p.fat.arc.from = p.fat.arc.to = 0.5 * (p.begin.point + p.end.point);
    }
    return p;
  }
  [[nodiscard]] Spiral_sample sample(std::uint32_t segment, double t) const {
    const Spiral_piece_2& piece = curves_.piece(segment);
    return t == piece.first.t ? piece.first : (t == piece.last.t ? piece.last : curves_.sample(segment, t));
  }
  [[nodiscard]] double length(const Foot_run& run) const {
    return euclidean_norm(sample(run.segment, run.to).point - sample(run.segment, run.from).point);
  }
  // In the direction of the boundary.
  [[nodiscard]] Boundary_jet jet(const Foot_run& run, double t, bool is_against) const {
    const Spiral_sample s = sample(run.segment, t);
    return {s.point, run.is_growing() == is_against ? -s.tangent : s.tangent, 1, 0};
  }

  // What an arc's circle is from a place: the distance, its gradient, and the curvature of the circle through it.
  struct Sight {
    double distance;
    Xy<double> gradient;
    double curvature;
  };
  [[nodiscard]] static Sight sight(const Xy<double>& q, const Part& p) {
    if (p.is_point) {
      const Xy<double> way = q - p.fat.arc.from;
      const double d = euclidean_norm(way);
      return {d, (1 / d) * way, -1 / d};
    }
    const double b = p.fat.arc.bulge;
    const Arc_view v = view(q, p.fat.arc);
    return {2 * v.side / ((1 + b * b) * v.chord + v.apart), (-1 / v.apart) * v.w, 4 * b / v.apart};
  }

  class Band {
   public:
    Band(const Axis_line& line, const Part& a, const Part& b, double size)
        : line_(line), a_(a), b_(b), way_(line.last.center - line.first.center), length_(euclidean_norm(way_)) {
      const Xy<double> middle = line.first.center + 0.5 * way_;
      of_a_ = sight(middle, a), of_b_ = sight(middle, b);
      constexpr double LEAST = 0x1p-30;  // of the size: there the direction is not to be had from centers
      const Xy<double> across = of_a_.gradient - of_b_.gradient;
      const Xy<double> v = length_ > LEAST * size ? way_ : perp(across);
      const double norm = euclidean_norm(v);
      along_ = (1 / norm) * v;
      const Xy<double> n = perp(along_);
      a_across_ = dot(n, of_a_.gradient), b_across_ = dot(n, of_b_.gradient);
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
      return (std::max)(std::fabs(sight(d.center, a_).distance - d.radius),
                        std::fabs(sight(d.center, b_).distance - d.radius));
    }
    struct Worst {
      double turn;      // of the gradient
      double bend;      // of a'' or b''
      double most;      // |a''| or |b''|
      double value;     // in the middle
      double tightest;  // curvature
    };
    // Along the line by `way` the gradient turns by its part across it times the curvature, across by the curvature.
    [[nodiscard]] static Worst worst(const Sight& s, double across, double way, double reach) {
      const double k = std::fabs(s.curvature), most = k / (1 - k * (way + reach)), square = across * across;
      if (!(k * (way + reach) < 0.5) || !(most * way < 0.75)) return {UNBOUNDED, UNBOUNDED, UNBOUNDED, 0, UNBOUNDED};
      const double turn = most * (std::fabs(across) * way + reach) / (1 - most * way);
      const double bend = most * (2 * std::fabs(across) * turn + turn * turn) + k * most * (way + reach) * square;
      return {turn, bend, k * square + bend, -s.curvature * square, most};
    }
    [[nodiscard]] double bound(double reach) const {
      // rays along normals of the boundary pass the line beside its ends by what the height makes of it
      const Worst near_a = worst(of_a_, a_across_, 0.5 * length_, reach),
                  near_b = worst(of_b_, b_across_, 0.5 * length_, reach);
      const double slope = (std::min)(std::fabs(a_across_) - near_a.turn, std::fabs(b_across_) - near_b.turn);
      if (!(slope > 0)) return UNBOUNDED;
      const double past = 2 * reach / slope, way = 0.5 * length_ + past;
      const Worst a = worst(of_a_, a_across_, way, reach), b = worst(of_b_, b_across_, way, reach);
      const double between = std::fabs(a_across_ - b_across_) - a.turn - b.turn;
      if (!(between > 0)) return UNBOUNDED;
      const double square = (length_ * length_ + 4 * past * (length_ + past)) / 8;
      const double up = std::fabs(a.value - b.value) + a.bend + b.bend;
      const double off = std::fabs(a.value * b_across_ - b.value * a_across_) + a.bend * std::fabs(b_across_) +
                         a.most * b.turn + b.bend * std::fabs(a_across_) + b.most * a.turn;
      // along a ray that passes the line at an end a foot is moved by twice the height at most
      const double moved = 2 * reach + (a.turn + b.turn) * past;
      const double wide = a_.fat.radius + b_.fat.radius + 2 * miss_ + slack_ +
                          (std::max)(over(moved, of_a_.curvature > 0 ? a.tightest : 0, reach),
                                     over(moved, of_b_.curvature > 0 ? b.tightest : 0, reach));
      return (square * (up + off) + 2 * wide) / between + wide;
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
    double length_, a_across_ = 0, b_across_ = 0, radius_ = 0, miss_ = 0, slack_ = 0;
    Sight of_a_{}, of_b_{};
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

  // Next to a leaf, and where gradients meet.  At p, at most l from the foot p0 of one of the line's discs, with the
  // normal n and along curvatures k,
  //   p + r n - (p0 + r0 n0) = (r - r0) n + e,   |e| <= l |1 - k r0|  and  |e| <= l + r0 |n - n0|,
  // at a corner |e| <= r0 |n - n0|.  The line's disc of the same radius has its center at (r - r0) m from that one's, m
  // the way of centers for one unit of radius; so centers are apart by (r - r0) |n - m| and e. Where the line is too
  // short its last disc is compared. How large r may be is told by largest_disc.
  // And r >= r0 - |e|: the normal meets the line in a place c0 + s (c1 - c0) = p + r' n with r' <= r, and then
  // r' - r0 = s n.(c1 - c0) - n.e, where n.(c1 - c0) >= 0. Smaller discs than r0 are compared with that one's.
  [[nodiscard]] double rolled_bound(const Axis_line& line, const Axis_line& whole, const Part& a, const Part& b,
                                    double off) const {
    double least = UNBOUNDED;
    if (a.is_point && b.is_point) return least;
    const Xy<double> way = line.last.center - line.first.center;
    for (const bool is_first : {true, false}) {
      const Touching_disc &near = is_first ? line.first : line.last, &end = is_first ? whole.first : whole.last;
      const bool is_of_whole = near.center == end.center && near.radius == end.radius;
      const Axis_line& compared = is_of_whole ? whole : line;
      const Touching_disc& other = is_first ? compared.last : compared.first;
      double most = 0;
      for (const Part* p : {&a, &b}) {
        const Turning turning = turning_of(*p, p == &a ? b : a, line, is_first);
        const double ahead = (is_first ? 1 : -1) * dot(turning.normal, way);
        const double rise = other.radius - near.radius, growth = std::fabs(turning.largest_disc - near.radius);
        // discs that are larger than the line's last one are compared with that
        const double up = rise > 0 ? (std::min)(growth, rise) : 0;
        const Xy<double> slope = up > 0 ? (1 / rise) * (other.center - near.center) : turning.normal;
        const double aside = up * (euclidean_norm(turning.normal - slope) + turning.angle) + 2 * (growth - up);
        const double sum = turning.apart + (std::max)(aside, 2 * (std::min)(turning.apart, near.radius));
        const bool is_bounded = ahead >= turning.angle * euclidean_norm(way) && turning.largest_disc < UNBOUNDED;
        most = is_bounded && sum < UNBOUNDED ? (std::max)(most, sum) : UNBOUNDED;
        if (!(most < UNBOUNDED)) break;
      }
      least = (std::min)(least, (most + (is_of_whole ? 0 : off)) * ROUNDED_UP<16> + 16 * HALF_ULP * size_);
    }
    return least;
  }
  // What touches a part: the normal in the foot, by what it turns, |e|, and the largest radius.
  struct Turning {
    Xy<double> normal;
    double angle, apart, largest_disc;
  };
  // A part without an inflection that turns by less than half a turn is at most its chord over the cosine of half the
  // angle long.
  struct Bent {
    double length, angle;
  };
  [[nodiscard]] static Bent bent_between(const Spiral_sample& s, const Spiral_sample& t, double error) {
    const double errors = s.tangent_error + t.tangent_error, turn = euclidean_norm(s.tangent + t.tangent) - errors;
    if (!(turn > 1)) return {UNBOUNDED, UNBOUNDED};
    return {2 * (euclidean_norm(s.point - t.point) + 2 * error) / turn * ROUNDED_UP<16>,
            euclidean_norm(s.tangent - t.tangent) + errors};
  }
  [[nodiscard]] Turning turning_of(const Part& p, const Part& other, const Axis_line& line, bool is_first) const {
    const Touching_disc &disc = is_first ? line.first : line.last, &end = is_first ? line.last : line.first;
    const double r = disc.radius;
    if (!p.is_point) {
      const Spiral_sample &s = p.at(is_first), &t = p.at(!is_first);
      const auto [way, angle] = bent_between(s, t, p.error);
      if (!(way < UNBOUNDED)) return {perp(s.tangent), UNBOUNDED, UNBOUNDED, UNBOUNDED};
      const double miss = euclidean_norm(s.point + r * perp(s.tangent) - disc.center) + r * s.tangent_error + p.error;
      return {perp(s.tangent), angle, (std::min)(way * most_apart(p, s, t, r), way + r * angle) + miss,
              (std::min)(largest_disc(p, other, is_first),
                         largest_beside({t.point, perp(t.tangent), way, angle, p.error}, line))};
    }
    // a cell that begins in the corner is a line
    const Xy<double>&corner = p.begin.point, way = other.at(!is_first).point - corner;
    const Xy<double> last = (1 / euclidean_norm(end.center - corner)) * (end.center - corner),
                     first = r > 0 ? (1 / euclidean_norm(disc.center - corner)) * (disc.center - corner) : last;
    const double turn = r > 0 ? euclidean_norm(last - first) * OF_ARC + p.fat.radius / r : 0,
                 height = (std::min)(dot(first, way), dot(last, way)) - 16 * HALF_ULP * size_ - 2 * other.error;
    const double through = height > 0 ? dot(way, way) / (2 * height) * ROUNDED_UP<16> : UNBOUNDED;
    return {first, turn, r * turn + 2 * p.fat.radius,
            (std::min)(through, largest_beside({corner, last, 2 * p.fat.radius, turn, p.fat.radius}, line))};
  }
  // Nor does a disc hold another point q of the curves, such as one that a vertex touches.  With the way l from p1 and
  // the angle a by which normals turn,  |q - p| <= |q - p1| + l,  n.(q - p) >= n1.(q - p1) - l - a (|q - p1| + l).
  struct Touched_part {
    Xy<double> point, normal;  // in the far end
    double way, angle, error;
  };
  [[nodiscard]] double largest_beside(const Touched_part& p, const Axis_line& line) const {
    double least = UNBOUNDED;
    for (const std::vector<Xy<double>>* points : line.others)
      for (std::size_t i = 0; points != nullptr && i < points->size(); ++i) {
        const double error = p.error + error_ + 4 * HALF_ULP * size_;
        const Xy<double> far = (*points)[i] - p.point;
        const double reach = euclidean_norm(far) + p.way + error,
                     height = dot(p.normal, far) - p.way - p.angle * reach - 2 * error;
        if (height > 0) least = (std::min)(least, reach * reach / (2 * height) * ROUNDED_UP<16>);
      }
    return least;
  }
  static constexpr double OF_ARC = 1.6;  // times its chord, up to half a turn
  // The largest |1 - k r| of a part, whose curvatures are between those at its ends.
  [[nodiscard]] static double most_apart(const Part& p, const Spiral_sample& s, const Spiral_sample& t, double r) {
    const double sign = p.fat.arc.bulge < 0 ? -1 : 1;
    double most = 0;
    for (const double k : {s.least_curvature, s.most_curvature, t.least_curvature, t.most_curvature})
      most = (std::max)(most, r > 0 ? std::fabs(1 - sign * k * r) : 1);
    return most;
  }
  // No disc that touches a part is larger than its circle of curvature.  Nor is one larger than the disc that touches
  // the part's far end p1 and goes through the other part's, q: that has the radius |q - p1|^2 / (2 n1.(q - p1)).
  // For let a disc of radius r that holds no q roll from its place towards p1.  Its center moves by (1 - k r) T, and
  // |q - c|^2 grows by 2 (1 - k r) T.(p - q): as long as k r <= 1 and q is behind.  So it holds no q at p1, either.
  // k r <= 1 is so where curvature falls towards p1, as it was so at first.  Or it is so for all r up to the bound.
  // T.(p - q) is T.(p - p0) >= 0 and T.(p0 - q), p0 the leaf's foot.  The latter has its least value at an end, T
  // turning one way.  Where its sign is not known it is at least -|p0 - q|.  A part that turns by 60 degrees at most
  // has T.(p - p0) >= l / 2 at the length l. So T.(p - q) is negative up to l = 2 |p0 - q| alone, which takes no more
  // than 2 |p0 - q|^2 off |q - c|^2.
  [[nodiscard]] double largest_disc(const Part& p, const Part& other, bool is_first) const {
    const Spiral_sample &foot = p.at(is_first), &end = p.at(!is_first);
    const bool is_convex = p.fat.arc.bulge > 0;
    const double most = (std::max)(foot.most_curvature, end.most_curvature),
                 least = (std::min)(foot.least_curvature, end.least_curvature),
                 widest = is_convex && least > 0 ? 1 / least : UNBOUNDED;
    const Xy<double> q = other.at(!is_first).point, far = q - end.point, near = q - foot.point,
                     ahead = (&foot == &p.begin ? 1.0 : -1.0) * foot.tangent,
                     on = (&end == &p.end ? 1.0 : -1.0) * end.tangent;
    const double error = p.error + other.error + 4 * HALF_ULP * size_, behind = euclidean_norm(near) + error,
                 unsure = error + behind * (foot.tangent_error + end.tangent_error), turn = dot(ahead, on);
    const double height = dot(perp(end.tangent), far) - end.tangent_error * euclidean_norm(far) - 2 * error;
    const bool is_behind = dot(ahead, near) < -unsure && dot(on, near) < -unsure;
    constexpr double COSINE = 0.51;  // of 60 degrees, and rounding
    if (!(height > 0) || !(is_behind ? turn > 0 : is_convex && turn > COSINE)) return widest;
    const double reach = euclidean_norm(far) + error, late = is_behind ? 0 : behind;
    const double through = (reach * reach + 2 * late * late) / (2 * height) * ROUNDED_UP<16>;
    const bool rolls = !is_convex || falls(p, foot, end) || most * through < 1;
    return rolls ? (std::min)(widest, through) : widest;
  }

  // Whether curvature falls from a foot on, which is not known in the foot where the curve stands still there.
  [[nodiscard]] bool falls(const Part& p, const Spiral_sample& foot, const Spiral_sample& end) const {
    const auto is_above = [&](const Spiral_sample& s) { return end.most_curvature <= s.least_curvature; };
    return is_above(foot) || (std::isinf(foot.most_curvature) && is_above(sample(p.segment, 0.5 * (foot.t + end.t))));
  }

  // In a tip, whose sides x and y end in the corner o, both cells may be one: the line to the corner, which often
  // crosses a side, is no part of it.
  //
  //            y1 ____y____        The boundary runs along x to o, and along y away from it.  A line meets a spiral
  //        c    |          --- o   segment twice at most.  So the chord meets none of the sides again if o is on the
  //            x1 ____x____---     side of it where both leave.  Sides do not cross, so it closes the tip, and with the
  //                                triangle from it to c it is the cell.
  // Let l be the longest way along a side, and p a place on y.  The normal there leaves the tip
  //   in a side, at most 2 l away, which a disc that touches in p does not hold: its radius is at most l;
  //   or in the chord, in z, with the center before z: the radius is at most |z - p| <= 2 l;
  //   or beyond z.  The disc holds neither x1 nor y1, so |p - z| <= |z - x1| and |z - y1|.  With D the chord's length,
  //   |p - x1| <= D and |p - y1| <= D, so n.(x1 - p) >= n1.(x1 - y1) - 2 D a, a the angle by which y turns, and the
  //   radius is at most D^2 / (2 n.(x1 - p)).
  // From the corner, a disc of radius 0, that is at most l and twice the radius.
  [[nodiscard]] double tip_bound(const Axis_line& line, const Part& a, const Part& b) const {
    const bool is_first = line.first.radius == 0;
    if (a.is_point || b.is_point || (!is_first && line.last.radius != 0)) return UNBOUNDED;
    const Part &x = is_first ? a : b, &y = is_first ? b : a;
    const Xy<double>&o = x.end.point, &c = is_first ? line.last.center : line.first.center;
    const Xy<double> chord = x.begin.point - y.end.point;
    const double error = 2 * error_ + 4 * HALF_ULP * size_, length = euclidean_norm(chord) + error,
                 tangent_error = (std::max)(x.begin.tangent_error, y.end.tangent_error) + TANGENT_ROUNDING;
    const auto is_left = [&](const Xy<double>& way, double off) { return cross(chord, way) > length * off; };
    const Xy<double> way = o - y.end.point;
    const double room = error * (2 + euclidean_norm(way) / length);
    constexpr double NEAR = 0x1p-44;
    if (!(euclidean_norm(o - y.begin.point) <= NEAR * size_) || !is_left(way, room) ||
        !is_left(x.begin.tangent, tangent_error + error / length) ||
        !is_left(-y.end.tangent, tangent_error + error / length) || !is_left(y.end.point - c, -2 * error))
      return UNBOUNDED;
    double longest = 0, radius = 0;
    for (const Part* p : {&x, &y}) {
      const Spiral_sample &end = p == &x ? x.begin : y.end, &corner = p == &x ? x.end : y.begin;
      const Bent bent = bent_between(end, corner, p->error);
      const double height =
          std::fabs(dot(perp(end.tangent), chord)) - error - length * (end.tangent_error + 2 * bent.angle);
      if (!(height > 0)) return UNBOUNDED;
      longest = (std::max)(longest, bent.length + NEAR * size_);
      radius = (std::max)(radius, length * length / (2 * height));
    }
    // between sides that are nearly parallel the center is on the chord, or past it within rounding
    return (longest + 2 * (std::max)(2 * longest, radius) + 4 * error) * ROUNDED_UP<16>;
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
    const Xy<double> way = q - p;
    return cross(way, r - p) >= -ROUNDING * size_ * euclidean_norm(way);
  }

  const Segment_hierarchy& curves_;
  double size_, error_ = 0;  // of any point
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

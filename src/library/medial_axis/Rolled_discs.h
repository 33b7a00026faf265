// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far the true axis is from the line between two discs, by the largest discs that touch the parts of the boundary.
//
// These bounds are for where gradients meet, and a band about the bisector has no width to tell: next to leaves, next
// to corners of hardly an angle, and in tips.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_ROLLED_DISCS_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_ROLLED_DISCS_H

#include "Line_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Rolled_discs {
 public:
  explicit Rolled_discs(const Line_parts& parts) : parts_(parts) {}

  // Next to a leaf, and where gradients meet.  At p, at most l from the foot p0 of one of the line's discs, with the
  // normal n and along curvatures k,
  //   p + r n - (p0 + r0 n0) = (r - r0) n + e,   |e| <= l |1 - k r0|  and  |e| <= l + r0 |n - n0|,
  // at a corner |e| <= r0 |n - n0|.  The line's disc of the same radius has its center at (r - r0) m from that one's, m
  // the way of centers for one unit of radius; so centers are apart by (r - r0) |n - m| and e. Where the line is too
  // short the next one follows, and then a last disc. How large r may be is told by largest_disc.
  // And r >= r0 - |e|: the normal meets the line in a place c0 + s (c1 - c0) = p + r' n with r' <= r, and then
  // r' - r0 = s n.(c1 - c0) - n.e, where n.(c1 - c0) >= 0. Smaller discs than r0 are compared with that one's.
  [[nodiscard]] double bound(const Axis_line& line, const Axis_line& whole, const Line_part& a, const Line_part& b,
                             double off) const {
    double least = UNBOUNDED;
    if (a.is_point && b.is_point) return least;
    const Xy<double> way = line.last.center - line.first.center;
    for (const bool is_first : {true, false}) {
      const Touching_disc &near = is_first ? line.first : line.last, &end = is_first ? whole.first : whole.last;
      const bool is_of_whole = near == end;
      const Axis_line& compared = is_of_whole ? whole : line;
      const Touching_disc &other = is_first ? compared.last : compared.first,
                          &far = is_first ? whole.last : whole.first;
      const Touching_disc& next = other == far ? whole.beyond[is_first ? 1 : 0] : far;
      double most = 0;
      for (const Line_part* p : {&a, &b}) {
        const Turning turning = turning_of(*p, p == &a ? b : a, line, is_first);
        const double ahead = (is_first ? 1 : -1) * dot(turning.normal, way);
        const double rise = other.radius - near.radius, growth = std::fabs(turning.largest_disc - near.radius);
        // discs that are larger than the line's last one are compared with those of the next line, and with its last
        // one
        const double up = rise > 0 ? (std::min)(growth, rise) : 0, rest = growth - up,
                     over = up > 0 && next.radius > other.radius ? (std::min)(rest, next.radius - other.radius) : 0;
        const auto apart = [&](const Touching_disc& c, const Touching_disc& d) {
          return euclidean_norm(turning.normal - (1 / (d.radius - c.radius)) * (d.center - c.center)) + turning.angle;
        };
        const double aside =
            (up > 0 ? up * apart(near, other) : 0) + (over > 0 ? over * apart(other, next) : 0) + 2 * (rest - over);
        const double sum = turning.apart + (std::max)(aside, 2 * (std::min)(turning.apart, near.radius));
        const bool is_bounded = ahead >= turning.angle * euclidean_norm(way) && turning.largest_disc < UNBOUNDED;
        // in a gap of hardly more than roundings all is small: a center is no farther than the disc from its foot
        const double small = turning.way + near.radius + 2 * (std::max)(turning.largest_disc, near.radius);
        most = (std::max)(most, is_bounded ? (std::min)(sum, small) : small);
        if (!(most < UNBOUNDED)) break;
      }
      least = (std::min)(least, (most + (is_of_whole ? 0 : off)) * ROUNDED_UP<16> + 16 * HALF_ULP * parts_.size());
    }
    return least;
  }
  // How far the true axis is from the line between two discs that touch two corners, however near these are to each
  // other.
  //
  // Let p be a corner, q the other one, and H = (c - p).(q - p) / |q - p| the height of a place c of the line.  The ray
  // from p through c meets the bisector, where H is g = |q - p| / 2, in x = p + (c - p) g / H.  All of these x are on a
  // line that is off the given one by |g - H| at ends, and they go past an end by |c - p| |g - H| / H.  The disc about
  // x has the radius |x - p|, a convex function.  So its chord is off by what ends miss, and by the height of the
  // corner of its tangents: with slopes a and b at ends, m of the chord, l (m - a) (b - m) / (b - a).
  //
  // Corners are where doubles have them: `moved` of an axis counts what crossings are rounded by.
  //
  // As rays turn one way, no x is farther past an end than that of the end itself, by t.  Where the line goes on there,
  // as the whole of which it is a half or as the next one, with the direction v and m of radii for a unit of length: a
  // place on the bisector is off it by t |u - v|, u the ray's direction, and its radius by t (1 - m), and the bisector
  // turns from the ray by g / |c - p| at most.  Past a vertex discs are not larger than what else it touches leaves, on
  // rays that turn from the end's by no more than t g / |c - p|^2.
  // \param whole as for Line_prover
  [[nodiscard]] double bound_between_corners(const Axis_line& line, const Axis_line& whole, const Line_part& a,
                                             const Line_part& b) const {
    const auto is_corner = [](const Line_part& p) { return p.is_point && p.begin.point == p.end.point; };
    if (!is_corner(a) || !is_corner(b)) return UNBOUNDED;
    constexpr double UNIT = 8 * HALF_ULP;  // more than the roundings of a product with a way
    const Xy<double> way = line.last.center - line.first.center;
    const double length = euclidean_norm(way), chord = length > 0 ? (line.last.radius - line.first.radius) / length : 0;
    double most = 0;
    for (const bool is_left : {true, false}) {
      const Xy<double>&corner = is_left ? a.begin.point : b.begin.point,
            across = (is_left ? b.begin.point : a.begin.point) - corner;
      const double gap = euclidean_norm(across);
      if (!(gap > 0)) return UNBOUNDED;
      double off = 0, miss = 0, apart[2], past = 0;  // apart: slopes at ends from the chord's
      for (const int i : {0, 1}) {
        const Touching_disc &d = i == 0 ? line.first : line.last, &end = i == 0 ? whole.first : whole.last;
        const Xy<double> to = d.center - corner;
        const double away = euclidean_norm(to);
        if (!(away > 0)) return UNBOUNDED;
        // the ray meets the bisector beyond the place, and the bisector turns from the ray, by no more than that
        const double slope = length > 0 ? dot(to, way) / (away * length) : 0, error = UNIT * away,
                     height = dot(to, across) / gap, least = height - error,
                     off_here = std::fabs(0.5 * gap - height) + error,
                     beyond = least > 0 ? away * off_here / least : UNBOUNDED,
                     turn = OF_ARC * (std::min)(1.0, 0.5 * gap / away) + UNIT;
        off = (std::max)(off, off_here);
        miss = (std::max)(miss, std::fabs(away - d.radius) + error);
        apart[i] = (std::max)(0.0, i == 0 ? chord - slope : slope - chord) + UNIT;
        double most_past = 2 * beyond;
        if (d == end && line.others[i] != nullptr) {
          // the largest disc with its center on the ray, or on one that turns from it by no more than that
          const double angle = (std::min)(beyond / away, 1.0) * turn,
                       largest = largest_beside({corner, (1 / away) * to, 0, angle + 4 * HALF_ULP, 0}, *line.others[i]);
          most_past = (std::min)(most_past, 2 * ((std::max)(0.0, largest - away) + error));
        } else {
          const Touching_disc& on = !(d == end) ? end : whole.beyond[i];
          const double reach = euclidean_norm(on.center - d.center);
          if (on.radius >= 0 && beyond <= reach && reach > 0) {
            const double aside = euclidean_norm((1 / away) * to - (1 / reach) * (on.center - d.center)),
                         grows = std::fabs(1 - (on.radius - d.radius) / reach);
            most_past = (std::min)(most_past, beyond * (aside + grows + 2 * turn));
          }
        }
        past = (std::max)(past, most_past);
      }
      const double sag = length * apart[0] * apart[1] / (apart[0] + apart[1]);
      most = (std::max)(most, 2 * off + sag + 3 * miss + past);
    }
    return most * ROUNDED_UP<64>;
  }
  // In a tip, whose sides x and y end in the corner o, both cells may be one: the line to the corner, which often
  // crosses a side, is no part of it.
  //
  //            y1 ____y____        The boundary runs along x to o, and along y away from it.  A line meets a spiral
  //        c    |          --- o   segment twice at most.  So the chord meets none of the sides again if o is on the
  //            x1 ____x____---     side of it where both leave.  Sides do not cross, so it closes the tip, and with the
  //                                triangle from it to c it is the cell.
  // Let l be the longest way along a side, D the chord's length, a what directions along both sides, from the chord on,
  // differ by, and p a place on y.  No place of the tip is farther from p along the normal n there than 2 l, nor than
  // w = D + 2 l a: along y, the chord and x.  The normal leaves the tip
  //   in a side, which a disc that touches in p does not hold: its radius is at most w / 2;
  //   or in the chord, in z, with the center before z: the radius is at most |z - p| <= w;
  //   or beyond z.  The disc holds neither x1 nor y1, so |p - z| <= |z - x1| and |z - y1|.
  //   |p - x1| <= D and |p - y1| <= D, so n.(x1 - p) >= n1.(x1 - y1) - 2 D a, a the angle by which y turns, and the
  //   radius is at most D^2 / (2 n.(x1 - p)).
  // From the corner, a disc of radius 0, that is at most l and twice the radius.  From the line it is at most what x1
  // and y1 are from c, l a, by which a side is off its chord, and the larger one of both radii, and the radius.
  [[nodiscard]] double tip_bound(const Axis_line& line, const Line_part& a, const Line_part& b) const {
    const bool is_first = line.first.radius == 0;
    if (a.is_point || b.is_point || (!is_first && line.last.radius != 0)) return UNBOUNDED;
    const Line_part &x = is_first ? a : b, &y = is_first ? b : a;
    const Xy<double>&o = x.end.point, &c = is_first ? line.last.center : line.first.center;
    const Xy<double> chord = x.begin.point - y.end.point;
    const double error = 2 * parts_.error() + 4 * HALF_ULP * parts_.size(), length = euclidean_norm(chord) + error,
                 tangent_error = (std::max)(x.begin.tangent_error, y.end.tangent_error) + TANGENT_ROUNDING;
    const auto is_left = [&](const Xy<double>& way, double off) { return cross(chord, way) > length * off; };
    const Xy<double> way = o - y.end.point;
    const double room = error * (2 + euclidean_norm(way) / length);
    constexpr double NEAR = 0x1p-44;
    if (!(euclidean_norm(o - y.begin.point) <= NEAR * parts_.size()) || !is_left(way, room) ||
        !is_left(x.begin.tangent, tangent_error + error / length) ||
        !is_left(-y.end.tangent, tangent_error + error / length) || !is_left(y.end.point - c, -2 * error))
      return UNBOUNDED;
    double longest = 0, radius = 0, turn = euclidean_norm(x.begin.tangent + y.end.tangent) + 2 * tangent_error;
    for (const Line_part* p : {&x, &y}) {
      const Spiral_sample &end = p == &x ? x.begin : y.end, &corner = p == &x ? x.end : y.begin;
      const Bent bent = bent_between(end, corner, p->error);
      const double height =
          std::fabs(dot(perp(end.tangent), chord)) - error - length * (end.tangent_error + 2 * bent.angle);
      if (!(height > 0)) return UNBOUNDED;
      longest = (std::max)(longest, bent.length + NEAR * parts_.size());
      radius = (std::max)(radius, length * length / (2 * height));
      turn += bent.angle;
    }
    const double from_center = (std::max)(euclidean_norm(x.begin.point - c), euclidean_norm(y.end.point - c)),
                 own = is_first ? line.last.radius : line.first.radius;
    radius = (std::max)((std::min)(2 * longest, length + 2 * longest * turn), radius);
    // between sides that are nearly parallel the center is on the chord, or past it within rounding
    const double from_corner = longest + 2 * radius,
                 from_line = from_center + longest * turn + NEAR * parts_.size() + radius + (std::max)(own, radius);
    return ((std::min)(from_corner, from_line) + 4 * error) * ROUNDED_UP<16>;
  }

 private:
  static constexpr double UNBOUNDED = Line_parts::UNBOUNDED;

  // What touches a part: the normal in the foot, by what it turns, |e|, the largest radius, and the way of feet.
  struct Turning {
    Xy<double> normal;
    double angle, apart, largest_disc, way;
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
  [[nodiscard]] Turning turning_of(const Line_part& p, const Line_part& other, const Axis_line& line,
                                   bool is_first) const {
    const Touching_disc &disc = is_first ? line.first : line.last, &end = is_first ? line.last : line.first;
    const double r = disc.radius;
    if (!p.is_point) {
      const Spiral_sample &s = p.at(is_first), &t = p.at(!is_first);
      const auto [way, angle] = bent_between(s, t, p.error);
      if (!(way < UNBOUNDED)) return {perp(s.tangent), UNBOUNDED, UNBOUNDED, UNBOUNDED, UNBOUNDED};
      const double miss = euclidean_norm(s.point + r * perp(s.tangent) - disc.center) + r * s.tangent_error + p.error;
      return {perp(s.tangent), angle, (std::min)(way * most_apart(p, s, t, r), way + r * angle) + miss,
              (std::min)({largest_disc(p, other, is_first), largest_beside(touched(p, s, way, angle), other, line),
                          largest_beside(touched(p, t, way, angle), other, line)}),
              way};
    }
    // a cell that begins in the corner is a line
    const Xy<double>&corner = p.begin.point, way = other.at(!is_first).point - corner;
    const Xy<double> last = (1 / euclidean_norm(end.center - corner)) * (end.center - corner),
                     first = r > 0 ? (1 / euclidean_norm(disc.center - corner)) * (disc.center - corner) : last;
    // directions err by the error over the radius
    const double error = p.fat.radius + other.error + 4 * HALF_ULP * parts_.size(), reach = euclidean_norm(way) + error,
                 shortest = r > 0 ? (std::min)(r, end.radius) : end.radius,
                 turn = euclidean_norm(last - first) * OF_ARC + error / shortest,
                 height = (std::min)(dot(first, way), dot(last, way)) - error * (2 + reach / shortest);
    const double through = height > 0 ? reach * reach / (2 * height) * ROUNDED_UP<16> : UNBOUNDED;
    return {first, turn, r * turn + 2 * p.fat.radius,
            (std::min)(through, largest_beside({corner, last, 2 * p.fat.radius, turn, p.fat.radius}, other, line)),
            2 * p.fat.radius};
  }
  // A disc that touches a part in p holds no other point q of the curves, such as an end of the other part, or one that
  // a vertex touches.  With the way l from an end p1 of the part, and the angle a by which normals turn, p is off the
  // tangent in p1 by l a at most, so  |q - p| <= |q - p1| + l,  n.(q - p) >= n1.(q - p1) - a (|q - p1| + 2 l).
  struct Touched_part {
    Xy<double> point, normal;  // in the end
    double way, angle, error;
  };
  [[nodiscard]] static Touched_part touched(const Line_part& p, const Spiral_sample& end, double way, double angle) {
    return {end.point, perp(end.tangent), way, angle + end.tangent_error, p.error};
  }
  [[nodiscard]] double largest_beside(const Touched_part& p, const Line_part& other, const Axis_line& line) const {
    double least = largest_beside(p, {other.begin.point, other.end.point}, other.is_point ? other.fat.radius : 0);
    for (const std::vector<Xy<double>>* points : line.others)
      if (points != nullptr) least = (std::min)(least, largest_beside(p, *points));
    return least;
  }
  [[nodiscard]] double largest_beside(const Touched_part& p, const std::vector<Xy<double>>& points,
                                      double more_error = 0) const {
    double least = UNBOUNDED;
    for (const Xy<double>& q : points) {
      const double error = p.error + parts_.error() + more_error + 4 * HALF_ULP * parts_.size();
      const Xy<double> far = q - p.point;
      const double reach = euclidean_norm(far) + p.way + error,
                   height = dot(p.normal, far) - 2 * error - p.angle * (reach + p.way);
      if (height > 0) least = (std::min)(least, reach * reach / (2 * height) * ROUNDED_UP<16>);
    }
    return least;
  }
  static constexpr double OF_ARC = 1.6;  // times its chord, up to half a turn
  // The largest |1 - k r| of a part, whose curvatures are between those at its ends.
  [[nodiscard]] static double most_apart(const Line_part& p, const Spiral_sample& s, const Spiral_sample& t, double r) {
    const double sign = p.fat.arc.bulge < 0 ? -1 : 1;
    double most = 0;
    for (const double k : {s.least_curvature, s.most_curvature, t.least_curvature, t.most_curvature})
      most = (std::max)(most, r > 0 ? std::fabs(1 - sign * k * r) : 1);
    return most;
  }
  // A disc that touches a part is no larger than its circle of curvature, and no larger than the disc that touches the
  // part's far end p1 and goes through the other part's, q: that has the radius |q - p1|^2 / (2 n1.(q - p1)).
  // For let a disc of radius r that holds no q roll from its place towards p1.  Its center moves by (1 - k r) T, and
  // |q - c|^2 grows by 2 (1 - k r) T.(p - q): as long as k r <= 1 and q is behind.  So it holds no q at p1, either.
  // k r <= 1 is so where curvature falls towards p1, as it was so at first.  Or it is so for all r up to the bound.
  // T.(p - q) is T.(p - p0) >= 0 and T.(p0 - q), p0 the leaf's foot.  The latter has its least value at an end, T
  // turning one way.  Where its sign is not known it is at least -|p0 - q|.  A part that turns by 60 degrees at most
  // has T.(p - p0) >= l / 2 at the length l. So T.(p - q) is negative up to l = 2 |p0 - q| alone, which takes no more
  // than 2 |p0 - q|^2 off |q - c|^2.
  [[nodiscard]] double largest_disc(const Line_part& p, const Line_part& other, bool is_first) const {
    const Spiral_sample &foot = p.at(is_first), &end = p.at(!is_first);
    const bool is_convex = p.fat.arc.bulge > 0;
    const double most = (std::max)(foot.most_curvature, end.most_curvature),
                 least = (std::min)(foot.least_curvature, end.least_curvature),
                 widest = is_convex && least > 0 ? 1 / least : UNBOUNDED;
    const Xy<double> q = other.at(!is_first).point, far = q - end.point, near = q - foot.point,
                     ahead = (&foot == &p.begin ? 1.0 : -1.0) * foot.tangent,
                     on = (&end == &p.end ? 1.0 : -1.0) * end.tangent;
    const double error = p.error + other.error + 4 * HALF_ULP * parts_.size(), behind = euclidean_norm(near) + error,
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
  [[nodiscard]] bool falls(const Line_part& p, const Spiral_sample& foot, const Spiral_sample& end) const {
    const auto is_above = [&](const Spiral_sample& s) { return end.most_curvature <= s.least_curvature; };
    return is_above(foot) ||
           (std::isinf(foot.most_curvature) && is_above(parts_.sample(p.segment, 0.5 * (foot.t + end.t))));
  }

  const Line_parts& parts_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

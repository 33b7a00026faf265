// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far the true axis is from the line between two discs that touch two corners, however near these are to each
// other.
//
// Let p be a corner, q the other one, and H = (c - p).(q - p) / |q - p| the height of a place c of the line.  The ray
// from p through c meets the bisector, where H is g = |q - p| / 2, in x = p + (c - p) g / H.  All of these x are on a
// line that is off the given one by |g - H| at ends, and they go past an end by |c - p| |g - H| / H.  The disc about x
// has the radius |x - p|, a convex function.  So its chord is off by what ends miss, and by the height of the corner of
// its tangents: with slopes a and b at ends, m of the chord, l (m - a) (b - m) / (b - a).
//
// Corners are where doubles have them: `moved` of an axis counts what crossings are rounded by.
//
// Past an end that is between two halves of one line there is that line.  Past a sample there is the next line: by t,
// x = c + t u with the ray's direction u, and with that line's direction v and its growth m of radii x is off it by
// t |u - v|, and its radius by t (1 - m).  Past a vertex discs are not larger than what else it touches leaves.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_BOUND_BETWEEN_CORNERS_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_BOUND_BETWEEN_CORNERS_H

#include <CGAL/Bounding_arcs_2/medial_axis/internal/Rolled_discs.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Bounding_arcs::internal {

class Corner_sight {
 public:
  static constexpr double UNIT = 8 * HALF_ULP;  // more than the roundings of a product with a way

  Corner_sight(const Xy<double>& corner, const Xy<double>& other) : corner_(corner), across_(other - corner) {
    gap_ = euclidean_norm(across_);
  }
  [[nodiscard]] bool are_apart() const { return gap_ > 0; }
  [[nodiscard]] Xy<double> way_to(const Xy<double>& c) const { return c - corner_; }
  [[nodiscard]] const Xy<double>& corner() const { return corner_; }
  /// At least |g - H|.
  [[nodiscard]] double off(const Xy<double>& c) const { return std::fabs(0.5 * gap_ - height(c)) + error(c); }
  /// How far past c its ray meets the bisector, at most.
  [[nodiscard]] double past(const Xy<double>& c) const {
    const double least = height(c) - error(c);
    return least > 0 ? euclidean_norm(way_to(c)) * off(c) / least : Line_parts::UNBOUNDED;
  }

 private:
  [[nodiscard]] double height(const Xy<double>& c) const { return dot(way_to(c), across_) / gap_; }
  [[nodiscard]] double error(const Xy<double>& c) const { return UNIT * euclidean_norm(way_to(c)); }

  Xy<double> corner_, across_;
  double gap_ = 0;
};

/// \param whole as for Line_prover
[[nodiscard]] inline double bound_between_corners(const Axis_line& line, const Axis_line& whole, const Line_part& a,
                                                  const Line_part& b, const Rolled_discs& rolled) {
  const auto is_corner = [](const Line_part& p) { return p.is_point && p.begin.point == p.end.point; };
  if (!is_corner(a) || !is_corner(b)) return Line_parts::UNBOUNDED;
  const auto is_same = [](const Touching_disc& c, const Touching_disc& d) {
    return c.center == d.center && c.radius == d.radius;
  };
  const Xy<double> way = line.last.center - line.first.center;
  const double length = euclidean_norm(way), chord = length > 0 ? (line.last.radius - line.first.radius) / length : 0;
  double most = 0;
  for (const bool is_left : {true, false}) {
    const Corner_sight corner(is_left ? a.begin.point : b.begin.point, is_left ? b.begin.point : a.begin.point);
    if (!corner.are_apart()) return Line_parts::UNBOUNDED;
    double off = 0, miss = 0, apart[2], past = 0;  // apart: slopes at ends from the chord's
    for (const int i : {0, 1}) {
      const Touching_disc &d = i == 0 ? line.first : line.last, &end = i == 0 ? whole.first : whole.last,
                          &next = whole.beyond[i];
      const Xy<double> to = corner.way_to(d.center);
      const double away = euclidean_norm(to), slope = length > 0 ? dot(to, way) / (away * length) : 0;
      off = (std::max)(off, corner.off(d.center));
      miss = (std::max)(miss, std::fabs(away - d.radius) + Corner_sight::UNIT * away);
      apart[i] = (std::max)(0.0, i == 0 ? chord - slope : slope - chord) + Corner_sight::UNIT;
      double beyond = corner.past(d.center);
      if (!is_same(d, end)) {
        beyond = beyond < Line_parts::UNBOUNDED ? 2 * beyond * apart[i] : beyond;
      } else if (line.others[i] != nullptr) {
        const double largest = rolled.largest_at_corner(corner.corner(), d.center, *line.others[i]);
        beyond = 2 * (std::min)(beyond, (std::max)(0.0, largest - away) + Corner_sight::UNIT * away);
      } else if (const double reach = euclidean_norm(next.center - d.center); next.radius > 0 && beyond <= reach) {
        const Xy<double> turn = (1 / away) * to - (1 / reach) * (next.center - d.center);
        beyond *= euclidean_norm(turn) + std::fabs(1 - (next.radius - d.radius) / reach);
      } else {
        beyond *= 2;
      }
      past = (std::max)(past, beyond);
    }
    const double sag = length * apart[0] * apart[1] / (apart[0] + apart[1]);
    most = (std::max)(most, 2 * off + sag + 3 * miss + past);
  }
  return most * ROUNDED_UP<64>;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif

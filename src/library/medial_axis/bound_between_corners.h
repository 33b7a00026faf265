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
// As rays turn one way, no x is farther past an end than that of the end itself, by t.  Where the line goes on there,
// as the whole of which it is a half or as the next one, with the direction v and m of radii for a unit of length: a
// place on the bisector is off it by t |u - v|, u the ray's direction, and its radius by t (1 - m), and the bisector
// turns from the ray by g / |c - p| at most.  Past a vertex discs are not larger than what else it touches leaves, on
// rays that turn from the end's by no more than t g / |c - p|^2.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_BOUND_BETWEEN_CORNERS_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_BOUND_BETWEEN_CORNERS_H

#include "Rolled_discs.h"

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
  [[nodiscard]] double turn_to_bisector(const Xy<double>& c) const {
    constexpr double OF_ARC = 1.6;  // an angle of a quarter turn at most, times its sine
    return OF_ARC * (std::min)(1.0, 0.5 * gap_ / euclidean_norm(way_to(c))) + UNIT;
  }
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
      const Touching_disc &d = i == 0 ? line.first : line.last, &end = i == 0 ? whole.first : whole.last;
      const Xy<double> to = corner.way_to(d.center);
      const double away = euclidean_norm(to);
      if (!(away > 0)) return Line_parts::UNBOUNDED;
      const double slope = length > 0 ? dot(to, way) / (away * length) : 0,
                   turn = corner.turn_to_bisector(d.center);  // at most, of the bisector from the ray
      off = (std::max)(off, corner.off(d.center));
      miss = (std::max)(miss, std::fabs(away - d.radius) + Corner_sight::UNIT * away);
      apart[i] = (std::max)(0.0, i == 0 ? chord - slope : slope - chord) + Corner_sight::UNIT;
      const double beyond = corner.past(d.center);
      double most_past = 2 * beyond;
      if (is_same(d, end) && line.others[i] != nullptr) {
        const double angle = (std::min)(beyond / away, 1.0) * turn;
        const double largest = rolled.largest_at_corner(corner.corner(), d.center, angle, *line.others[i]);
        most_past = (std::min)(most_past, 2 * ((std::max)(0.0, largest - away) + Corner_sight::UNIT * away));
      } else {
        const Touching_disc& on = !is_same(d, end) ? end : whole.beyond[i];
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

}  // namespace CGAL::Bounding_arcs::internal

#endif

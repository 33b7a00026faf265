// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Voronoi diagram of a polyline along closed curves, by Boost.Polygon, and what is the same in it and in an axis:
//
//      f                 centers c with two feet f, g that are seen under a large angle. Kinks of a polyline have edges
//       \   angle        of their own, along which that is the angle by which it turns, nearly 0.
//        c------- g
//
// Let the distances from two sets S and T differ by h at most, and let a disc (c, r) touch S in feet seen under the
// angle a. At t from c the distance from the nearer foot is at most r + t cos(a/2) + t^2 sin^2(a/2) / (2r). If within B
// of c no two feet in T are seen under b < a or more, where b <= 2 pi / 3, the gradient of the distance from T is
// longer than cos(b/2) there (the cosine of half of the angle of all feet), so that following it for the length B leads
// to a point whose distance from T has grown by B cos(b/2) (Lieutier 2004). Both distances differ by h at both ends,
// thus
//
//     B D - B^2 sin^2(a/2) / (2r) <= 2h     where D = cos(b/2) - cos(a/2),
//
// which is false of B = 4h / D where r > 4h sin^2(a/2) / D^2: less than B from c there is a point with feet in T seen
// under b. (The stability of Chazal, Lieutier 2005, with angles; there a general h leaves sqrt(h).)

#ifndef BOUNDING_ARCS_TEST_POLYLINE_VORONOI_H
#define BOUNDING_ARCS_TEST_POLYLINE_VORONOI_H

#include "query_drawings.h"

#include <boost/polygon/segment_data.hpp>
#include <boost/polygon/voronoi.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

/// Angles and lengths of the comparison above.
struct Stability {
  double h;     ///< by how much distances differ
  double a, b;  ///< radians: of what is looked for, and of what it is looked for in
  [[nodiscard]] double gain() const { return std::cos(b / 2) - std::cos(a / 2); }
  [[nodiscard]] double bound() const { return 4 * h / gain(); }
  [[nodiscard]] double least_radius() const { return 4 * h * std::pow(std::sin(a / 2) / gain(), 2); }
};

struct Disc {
  Point center;
  double radius;
};
/// A straight piece of an axis, with the radii at its ends.
struct Axis_piece {
  Disc from, to;
};

/// The angle under which two points are seen.
inline double angle_at(const Point& c, const Point& f, const Point& g) {
  return std::atan2(std::fabs(cross(f - c, g - c)), dot(f - c, g - c));
}
inline Point nearest_on(const Point& a, const Point& b, const Point& q) {
  const Point way = b - a;
  const double square = dot(way, way);
  return square > 0 ? a + std::clamp(dot(q - a, way) / square, 0.0, 1.0) * way : a;
}

/// Points along a curve, the last one the end of the piece: chords have all control points within h, so that chord and
/// curve are within h of each other.
inline void add_polyline(const Bezier& piece, double h, std::vector<Point>& points) {
  const auto& p = piece.control_points();
  const bool is_near = std::all_of(p.begin(), p.end(), [&](const Point& q) {
    const Point d = q - nearest_on(p.front(), p.back(), q);
    return std::hypot(d.x, d.y) <= h;
  });
  if (is_near) return points.push_back(p.back());
  const auto halves = piece.split(0.5);
  add_polyline(halves.first, h, points);
  add_polyline(halves.second, h, points);
}

class Polyline_voronoi {
 public:
  /// \param h how far the polyline may be from the curves, which are closed
  /// \param angle in (0, pi); halved for what is searched in
  Polyline_voronoi(const Drawing& drawing, double h, double angle)
      : unit_(2 * size_of(drawing) * std::exp2(-30)),
        stability_{h + unit_, angle, angle / 2} {  // points are within half of a unit across and along of integers
    for (const auto& curve : drawing.curves()) {
      std::vector<Point> points;
      for (const Bezier& piece : curve.beziers) add_polyline(piece, h, points);
      add_closed(points);
    }
    boost::polygon::construct_voronoi(segments_.begin(), segments_.end(), &diagram_);
    for (const auto& e : diagram_.edges())
      if (e.is_primary() && e.is_finite() && &e < e.twin()) add_pieces(e);
  }

  [[nodiscard]] const Stability& stability() const { return stability_; }
  /// Along the edges, to where feet are seen under the angle b; from its parabolas they are within h.
  [[nodiscard]] const std::vector<Axis_piece>& pieces() const { return pieces_; }
  /// Ends of these whose feet are seen under the angle a, both inside and outside of the curves.
  [[nodiscard]] const std::vector<Disc>& discs() const { return discs_; }

 private:
  using Integer_point = boost::polygon::point_data<std::int32_t>;
  using Integer_segment = boost::polygon::segment_data<std::int32_t>;
  using Diagram = boost::polygon::voronoi_diagram<double>;

  void add_closed(const std::vector<Point>& points) {
    const auto rounded = [this](double x) { return static_cast<std::int32_t>(std::lround(x / unit_)); };
    Integer_point before(rounded(points.back().x), rounded(points.back().y));
    for (const Point& p : points) {
      const Integer_point q(rounded(p.x), rounded(p.y));
      if (q != before) segments_.emplace_back(before, q);
      before = q;
    }
  }
  [[nodiscard]] Point point(const Integer_point& p) const { return {unit_ * p.x(), unit_ * p.y()}; }

  // A segment, or one of its ends, whose points are the same then.
  struct Site {
    Point a, b;
    [[nodiscard]] bool is_point() const { return a == b; }
    [[nodiscard]] Point foot(const Point& q) const { return nearest_on(a, b, q); }
  };
  [[nodiscard]] Site site(const Diagram::cell_type& cell) const {
    const Integer_segment& s = segments_[cell.source_index()];
    const Point low = point(s.low()), high = point(s.high());
    if (cell.contains_segment()) return {low, high};
    return cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT ? Site{low, low}
                                                                                         : Site{high, high};
  }

  void add_pieces(const Diagram::edge_type& e) {
    Site of = site(*e.cell()), across = site(*e.twin()->cell());
    if (of.is_point()) std::swap(of, across);
    const Point p{unit_ * e.vertex0()->x(), unit_ * e.vertex0()->y()};
    const Point q{unit_ * e.vertex1()->x(), unit_ * e.vertex1()->y()};
    const auto angle = [&](const Point& c) { return angle_at(c, of.foot(c), across.foot(c)); };
    const auto disc = [&](const Point& c) {
      const Point d = c - of.foot(c);
      return Disc{c, std::hypot(d.x, d.y)};
    };
    // Along a parabola with the focus f, of radius r(1 - cos b)/2 at the vertex where feet are seen under b at r, a
    // chord of the length s is within s^2 / (8 r (1 - cos b)).
    const double least = (std::min)(disc(p).radius, disc(q).radius);
    const double step = std::sqrt(8 * stability_.h * least * (1 - std::cos(stability_.b)));
    const double length = std::hypot(q.x - p.x, q.y - p.y);
    const int count = !e.is_curved() || !(length > step) ? 1 : static_cast<int>((std::min)(length / step + 1, 1e4));
    const Point middle = 0.5 * (of.foot(across.a) + across.a);  // feet are opposite there; two segments have one angle
    Point last = p;
    for (int k = 1; k <= count; ++k) {
      const Point next = k == count ? q : on_parabola(of, across.a, p, q, static_cast<double>(k) / count);
      const double largest = (std::max)({angle(last), angle(next), angle(nearest_on(last, next, middle))});
      if (largest >= stability_.b) pieces_.push_back({disc(last), disc(next)});
      if (angle(next) >= stability_.a) discs_.push_back(disc(next));
      if (k == 1 && angle(last) >= stability_.a) discs_.push_back(disc(last));
      last = next;
    }
  }
  // As far from f as from the line of a segment, above the share of the way there between the feet of p and q.
  [[nodiscard]] static Point on_parabola(const Site& line, const Point& f, const Point& p, const Point& q,
                                         double share) {
    const Point way = line.b - line.a, u = (1 / std::hypot(way.x, way.y)) * way, n = perp(u);
    const double x = (1 - share) * dot(p - line.a, u) + share * dot(q - line.a, u);
    const double fx = dot(f - line.a, u), fy = dot(f - line.a, n);
    return line.a + x * u + (((x - fx) * (x - fx) + fy * fy) / (2 * fy)) * n;
  }

  double unit_;
  Stability stability_;
  std::vector<Integer_segment> segments_;
  Diagram diagram_;
  std::vector<Axis_piece> pieces_;
  std::vector<Disc> discs_;
};

}  // namespace bounding_arcs_test

#endif

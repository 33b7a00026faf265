// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the check of an axis asks of curves: points and tangents in intervals, and whether a disc has a curve in it. All
// of it is by de Casteljau's algorithm on control points.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_AXIS_CHECKER_CURVES_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_AXIS_CHECKER_CURVES_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include <CGAL/Bounding_arcs_2/verify/verify_axis.h>
#include <CGAL/Interval_nt.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

/// Rounding is to be protected by who calls.
using Checked_number = CGAL::Interval_nt<false>;
using Checked_vector = Xy<Checked_number>;

[[nodiscard]] inline Checked_vector checked(const Xy<double>& p) { return {Checked_number(p.x), Checked_number(p.y)}; }
[[nodiscard]] inline Checked_number length(const Checked_vector& v) {
  return CGAL::sqrt(CGAL::square(v.x) + CGAL::square(v.y));
}
/// A point in the middle of its enclosure.
[[nodiscard]] inline Xy<double> middle(const Checked_vector& p) { return {CGAL::to_double(p.x), CGAL::to_double(p.y)}; }
/// The most that the number can be.
[[nodiscard]] inline double most_of(const Checked_number& x) {
  return (std::max)(std::fabs(x.inf()), std::fabs(x.sup()));
}

struct Checked_point {
  Checked_vector point, derivative;
};

/// Control points with their weights, multiplied.
template <class NT> struct Homogeneous_piece {
  struct Point {
    Xy<NT> p;
    NT w;
  };
  boost::container::small_vector<Point, 4> points;

  Homogeneous_piece() = default;
  explicit Homogeneous_piece(const Bezier_curve_2<double>& curve) {
    for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
      const Xy<double>& p = curve.control_points()[i];
      const NT w(curve.weight(static_cast<int>(i)));
      points.push_back({{NT(w * NT(p.x)), NT(w * NT(p.y))}, w});
    }
  }
  static Point between(const Point& a, const Point& b, const NT& t) {
    const NT s = NT(1) - t;
    return {s * a.p + t * b.p, NT(s * a.w + t * b.w)};
  }
  [[nodiscard]] Xy<NT> euclidean(std::size_t i) const {
    return {NT(points[i].p.x / points[i].w), NT(points[i].p.y / points[i].w)};
  }
};

/// A point and the derivative there.
[[nodiscard]] inline Checked_point point_at(const Bezier_curve_2<double>& curve, double t) {
  using Piece = Homogeneous_piece<Checked_number>;
  Piece piece(curve);
  auto& p = piece.points;
  const Checked_number s(t);
  for (std::size_t n = p.size() - 1; n > 1; --n)
    for (std::size_t i = 0; i < n; ++i) p[i] = Piece::between(p[i], p[i + 1], s);
  const Piece::Point at = Piece::between(p[0], p[1], s);
  const Checked_number degree(curve.degree());
  const Checked_vector point{at.p.x / at.w, at.p.y / at.w}, change = degree * (p[1].p - p[0].p);
  const Checked_number turn = degree * (p[1].w - p[0].w);
  const Checked_vector moved = change - turn * point;
  return {point, {moved.x / at.w, moved.y / at.w}};
}

/// A bound of how far a part of a piece, between two parameters, is from the line that touches the piece at the first
/// one: no point is farther than its control points.
[[nodiscard]] inline double distance_from_tangent(const Bezier_curve_2<double>& curve, double t, double other) {
  const Bezier_curve_2<double> part = curve.subcurve((std::min)(t, other), (std::max)(t, other));
  const Checked_point at = point_at(curve, t);
  const Checked_number speed = length(at.derivative);
  if (!(speed.inf() > 0)) return std::numeric_limits<double>::infinity();
  double most = 0;
  for (const Xy<double>& p : part.control_points())
    most = (std::max)(most, most_of(cross(checked(p) - at.point, at.derivative) / speed));
  return most;
}

/// All Bezier pieces under a tree of boxes.
class Curves_in_boxes {
 public:
  explicit Curves_in_boxes(const Drawing_2<double>& drawing) {
    for (std::uint32_t c = 0; c < drawing.curves().size(); ++c)
      for (std::uint32_t b = 0; b < drawing.curves()[c].beziers.size(); ++b) {
        const Bezier_curve_2<double>& piece = drawing.curves()[c].beziers[b];
        leaves_.push_back({Homogeneous_piece<double>(piece), {}, c, b});
        for (const Xy<double>& p : piece.control_points()) {
          leaves_.back().box.add(p);
          size_ = (std::max)({size_, std::fabs(p.x), std::fabs(p.y)});
        }
      }
    if (!leaves_.empty()) build(0, leaves_.size());
  }
  [[nodiscard]] double size() const { return size_; }

  /// How far a curve is known to be in a disc; 0 where none is, and the radius where that was not told.
  [[nodiscard]] double depth_in(const Xy<double>& center, double radius) const {
    return radius > 0 && !leaves_.empty() ? depth_in({center, radius, 16 * HALF_ULP * size_}, 0) : 0;
  }
  /// On each piece that is within a distance of a point, the place that is nearest.
  [[nodiscard]] std::vector<Curve_place> places_near(const Xy<double>& p, double room) const {
    std::vector<Curve_place> result;
    if (!leaves_.empty()) add_places_near(p, room, 0, result);
    return result;
  }
  /// How often curves run counterclockwise round a point, counted on the ray to the right. \pre it is on none
  [[nodiscard]] int winding_number(const Xy<double>& q) const {
    int sum = 0;
    for (const Leaf& leaf : leaves_) sum += crossings(leaf.piece, q, 0);
    return sum;
  }

 private:
  struct Extent {
    double x0 = INFINITE, y0 = INFINITE, x1 = -INFINITE, y1 = -INFINITE;
    void add(const Xy<double>& p) {
      x0 = (std::min)(x0, p.x), y0 = (std::min)(y0, p.y), x1 = (std::max)(x1, p.x), y1 = (std::max)(y1, p.y);
    }
    void add(const Extent& b) { add(Xy<double>{b.x0, b.y0}), add(Xy<double>{b.x1, b.y1}); }
    [[nodiscard]] double distance(const Xy<double>& p) const {
      return std::hypot((std::max)({x0 - p.x, p.x - x1, 0.0}), (std::max)({y0 - p.y, p.y - y1, 0.0}));
    }
  };
  struct Leaf {
    Homogeneous_piece<double> piece;
    Extent box;
    std::uint32_t curve, bezier;
  };
  struct Node {
    Extent box;
    std::size_t begin, end, second = 0;  // of leaves; the first child is next
  };
  struct Disc {
    Xy<double> center;
    double radius, rounding;
  };
  static constexpr double INFINITE = std::numeric_limits<double>::infinity();
  static constexpr int MOST_HALVINGS = 50;

  void build(std::size_t begin, std::size_t end) {
    const std::size_t at = nodes_.size();
    nodes_.push_back({{}, begin, end});
    for (std::size_t i = begin; i < end; ++i) nodes_[at].box.add(leaves_[i].box);
    if (end - begin <= 2) return;
    const Extent& b = nodes_[at].box;
    const bool by_x = b.x1 - b.x0 > b.y1 - b.y0;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto first = leaves_.begin();
    const auto to = [&](std::size_t i) { return first + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(to(begin), to(middle), to(end), [by_x](const Leaf& l, const Leaf& m) {
      return by_x ? l.box.x0 + l.box.x1 < m.box.x0 + m.box.x1 : l.box.y0 + l.box.y1 < m.box.y0 + m.box.y1;
    });
    build(begin, middle);
    nodes_[at].second = nodes_.size();
    build(middle, end);
  }
  [[nodiscard]] double depth_in(const Disc& disc, std::size_t at) const {
    const Node& node = nodes_[at];
    if (node.box.distance(disc.center) >= disc.radius) return 0;
    double depth = 0;
    if (node.second != 0) return (std::max)(depth_in(disc, at + 1), depth_in(disc, node.second));
    for (std::size_t i = node.begin; i < node.end; ++i) depth = (std::max)(depth, depth_of(leaves_[i].piece, disc, 0));
    return depth;
  }
  // No point of a piece is nearer in a direction than the nearest control point.
  [[nodiscard]] static double depth_of(const Homogeneous_piece<double>& piece, const Disc& disc, int halvings) {
    const std::size_t n = piece.points.size();
    const Xy<double> first = piece.euclidean(0), last = piece.euclidean(n - 1);
    const Xy<double> middle = 0.5 * (first + last) - disc.center;
    const double far = std::hypot(middle.x, middle.y);
    if (far > 0) {
      double least = INFINITE;
      for (std::size_t i = 0; i < n; ++i) least = (std::min)(least, dot(piece.euclidean(i) - disc.center, middle));
      if (least / far >= disc.radius + disc.rounding) return 0;
    }
    for (const Xy<double>& p : {first, last}) {
      const double depth = disc.radius - std::hypot(p.x - disc.center.x, p.y - disc.center.y);
      if (depth > disc.rounding) return depth;
    }
    if (halvings == MOST_HALVINGS) return disc.radius;
    const auto [left, right] = halves(piece);
    const double depth = depth_of(left, disc, halvings + 1);
    return depth > 0 ? depth : depth_of(right, disc, halvings + 1);
  }
  void add_places_near(const Xy<double>& p, double room, std::size_t at, std::vector<Curve_place>& result) const {
    const Node& node = nodes_[at];
    if (node.box.distance(p) > room) return;
    if (node.second != 0) {
      add_places_near(p, room, at + 1, result);
      add_places_near(p, room, node.second, result);
      return;
    }
    for (std::size_t i = node.begin; i < node.end; ++i) {
      Nearest found{room, std::nullopt};
      find_nearest(leaves_[i].piece, p, 0, 1, found);
      if (found.t) result.push_back({leaves_[i].curve, leaves_[i].bezier, *found.t});
    }
  }
  /// A place that is nearest to a point.
  struct Nearest {
    double distance;
    std::optional<double> t;
  };
  static Extent box_of(const Homogeneous_piece<double>& piece) {
    Extent box;
    for (std::size_t i = 0; i < piece.points.size(); ++i) box.add(piece.euclidean(i));
    return box;
  }
  static void find_nearest(const Homogeneous_piece<double>& piece, const Xy<double>& p, double low, double high,
                           Nearest& found) {
    constexpr double SHORT = 0x1p-50;  // of a parameter
    const double away = box_of(piece).distance(p);
    if (found.t ? away >= found.distance : away > found.distance) return;
    const double t = low + 0.5 * (high - low);
    if (high - low <= SHORT) {
      found = {away, t};
      return;
    }
    const auto [left, right] = halves(piece);
    const bool is_left_first = box_of(left).distance(p) <= box_of(right).distance(p);
    if (is_left_first) find_nearest(left, p, low, t, found);
    find_nearest(right, p, t, high, found);
    if (!is_left_first) find_nearest(left, p, low, t, found);
  }
  [[nodiscard]] static int crossings(const Homogeneous_piece<double>& piece, const Xy<double>& q, int halvings) {
    bool is_above = true, is_below = true, is_left = true, is_right = true;
    for (std::size_t i = 0; i < piece.points.size(); ++i) {
      const Xy<double> p = piece.euclidean(i);
      (p.y > q.y ? is_below : is_above) = false;
      (p.x > q.x ? is_left : is_right) = false;
    }
    if (is_above || is_below || is_left) return 0;
    if (is_right || halvings == MOST_HALVINGS) {
      const bool starts_above = piece.euclidean(0).y > q.y,
                 ends_above = piece.euclidean(piece.points.size() - 1).y > q.y;
      return static_cast<int>(ends_above) - static_cast<int>(starts_above);
    }
    const auto [left, right] = halves(piece);
    return crossings(left, q, halvings + 1) + crossings(right, q, halvings + 1);
  }
  [[nodiscard]] static std::pair<Homogeneous_piece<double>, Homogeneous_piece<double>> halves(
      Homogeneous_piece<double> right) {
    Homogeneous_piece<double> left = right;
    const std::size_t n = right.points.size();
    for (std::size_t k = 1; k < n; ++k) {
      for (std::size_t i = 0; i + k < n; ++i)
        right.points[i] = Homogeneous_piece<double>::between(right.points[i], right.points[i + 1], 0.5);
      left.points[k] = right.points[0];
    }
    return {left, right};
  }

  std::vector<Leaf> leaves_;
  std::vector<Node> nodes_;
  double size_ = 0;
};

// On which sides of curves an axis has a region, for its check: by winding numbers of its own.

struct Curve_sides {
  bool left, right;
};

[[nodiscard]] inline bool is_a_point(const Bezier_curve_2<double>& b) {
  const auto& p = b.control_points();
  return std::all_of(p.begin(), p.end(), [&](const Xy<double>& q) { return q == p.front(); });
}

/// What is filled next to the middle of the piece whose ends are farthest apart.
/// \param is_in tells of a winding number whether points with it are inside
template <class Is_in>
[[nodiscard]] Curve_sides filled_sides(const std::vector<Bezier_curve_2<double>>& pieces, const Curves_in_boxes& boxes,
                                       const Is_in& is_in) {
  const auto way = [](const Bezier_curve_2<double>& b) {
    return stable_norm(b.control_points().back() - b.control_points().front());
  };
  const auto longest = std::max_element(
      pieces.begin(), pieces.end(),
      [&](const Bezier_curve_2<double>& a, const Bezier_curve_2<double>& b) { return way(a) < way(b); });
  const Checked_point p = point_at(*longest, 0.5);
  const Xy<double> at = middle(p.point), tangent = middle(p.derivative);
  // far from the origin a drawing is less than a billionth of its coordinates
  double extent = 0;
  for (const Xy<double>& q : longest->control_points())
    extent = (std::max)(extent, stable_norm(q - longest->control_points().front()));
  const double step = (std::min)(0x1p-30 * boxes.size(), 0x1p-12 * extent) / stable_norm(tangent);
  const auto is_inside = [&](double s) { return is_in(boxes.winding_number(at + s * perp(tangent))); };
  return {is_inside(step), is_inside(-step)};
}

/// The sides of each curve that discs touch from: in a frame both. Without one a curve with both sides filled bounds
/// nothing.
[[nodiscard]] inline std::vector<Curve_sides> sides_of_curves(const Drawing_2<double>& drawing,
                                                              const Axis_verification::Options& options) {
  const Curves_in_boxes boxes(drawing);
  const CGAL::Protect_FPU_rounding<true> protection;
  const std::size_t count = drawing.curves().size();
  std::vector<Curve_sides> result(count, {false, false});
  for (std::size_t i = 0; i < count; ++i) {
    const auto& pieces = drawing.curves()[i].beziers;
    const bool is_frame = options.is_framed && i + 1 == count;
    if (pieces.size() == 1 && is_a_point(pieces.front())) continue;
    if (is_frame) result[i] = filled_sides(pieces, boxes, [](int number) { return number != 0; });
    else if (options.is_framed) result[i] = {true, true};
    else {
      const Curve_sides filled =
          filled_sides(pieces, boxes, [&](int number) { return is_filled(options.rule, number); });
      if (!(filled.left && filled.right)) result[i] = filled;
    }
  }
  return result;
}

/// The curves that discs may touch. Points are among them.
[[nodiscard]] inline Drawing_2<double> with_a_side(const Drawing_2<double>& drawing,
                                                   const std::vector<Curve_sides>& sides) {
  Drawing_2<double> result;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto& pieces = drawing.curves()[i].beziers;
    const bool is_point = pieces.size() == 1 && is_a_point(pieces.front());
    if (is_point || sides[i].left || sides[i].right) result.add(pieces);
  }
  return result;
}

}  // namespace CGAL::Bounding_arcs::verify

#endif

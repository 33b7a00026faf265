// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets of one side of open curves, beside normals: the ends of those that no curve comes near to are what such an
// offset is, from the first of a curve to its last, and nothing else is.

#include "cases.h"
#include "offset_checks.h"

#include <CGAL/Bounding_arcs_2/arc/arc_beziers.h>
#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace test_side_offsets {
namespace {

using namespace bounding_arcs_test;
using Curve = ba::Drawing_2<double>::Curve;

constexpr double ROUNDING = 1e-12;  // of coordinates and distances of about 1

/// The unit tangent at t, seen from the right or from the left.
Point tangent(const Bezier& bezier, double t, bool after) {
  const Point way = bezier.end_jet(t, after)->first;
  return (1 / ba::euclidean_norm(way)) * way;
}

/// A place of a curve with a unit normal on the side asked for.
struct Normal {
  Point foot, way;
};

class Side_check {
 public:
  Side_check(const Drawing& drawing, double d, const Offset_options& options)
      : drawing_(drawing), index_(open_curves(drawing), ba::Decisions::DOUBLE), d_(d), eps_(options.eps),
        sign_(options.side == ba::Offset::Side::LEFT ? 1 : -1), offset_(offset_curves(drawing, d, options)) {
    constexpr int SAMPLES = 128;  // of a Bezier piece
    for (const Curve& curve : drawing.curves()) {
      std::vector<Sample>& samples = samples_.emplace_back();
      const int count = curve.is_closed ? -1 : SAMPLES * static_cast<int>(curve.beziers.size());
      for (int i = 0; i <= count; ++i) {
        const auto b = static_cast<std::size_t>((std::max)(i - 1, 0) / SAMPLES);
        const double t = double(i) / SAMPLES - double(b);
        samples.push_back({normal(curve.beziers[b], t, t < 1), 0});
      }
      for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const double step = ba::euclidean_norm(samples[i + 1].normal.foot - samples[i].normal.foot);
        for (const std::size_t k : {i, i + 1}) samples[k].step = (std::max)(samples[k].step, step);
      }
    }
  }

  void expect_offset_of_side() {
    EXPECT_EQ(offset_.status, ba::Offset::Status::COMPLETE);
    EXPECT_LE(offset_.error, eps_);
    for (const auto& chain : offset_.chains) {
      for (std::size_t i = 0; i + 1 < chain.pieces.size(); ++i)
        EXPECT_EQ(chain.pieces[i].arc.to, chain.pieces[i + 1].arc.from);
      if (!is_of_closed(chain)) chains_.push_back(chain);
    }
    Offset of_side = offset_;
    of_side.chains = chains_;
    if (const auto error = ba::offset_error(index_, of_side, eps_ / 16)) {
      EXPECT_GE(error->nearest.lower, -eps_ * 17 / 16);
      EXPECT_LE(error->farthest.upper, eps_ * 17 / 16);
    }
    for (const auto& chain : chains_)
      for (const auto& piece : chain.pieces) expect_on_side(piece);
    const ba::Bounding_arc_tree_2 result(of_side.drawing(), ba::Decisions::DOUBLE);
    for (std::size_t c = 0; c < samples_.size(); ++c)
      if (!drawing_.curves()[c].is_closed) expect_nothing_missing(c, result);
  }
  [[nodiscard]] std::size_t tried() const { return tried_; }
  [[nodiscard]] double length() const {
    double sum = 0;
    for (const auto& chain : chains_)
      for (const auto& piece : chain.pieces) sum += ba::length(piece.arc);
    return sum;
  }

 private:
  struct Sample {
    Normal normal;
    double step;  // to its neighbours
  };
  static Drawing open_curves(const Drawing& drawing) {
    Drawing result;
    for (const Curve& curve : drawing.curves())
      if (!curve.is_closed) result.add(curve.beziers);
    return result;
  }
  [[nodiscard]] bool is_of_closed(const ba::Offset::Chain& chain) const {
    return drawing_.curves()[chain.pieces.front().source.curve].is_closed;
  }
  [[nodiscard]] Normal normal(const Bezier& b, double t, bool after) const {
    return {b.point(t), sign_ * perp(tangent(b, t, after))};
  }

  // Points are ends of normals, about the places that a piece tells.
  void expect_on_side(const ba::Offset::Piece& piece) const {
    EXPECT_NE(piece.kind, ba::Offset::Kind::CAP);
    const Curve& curve = drawing_.curves()[piece.source.curve];
    const Bezier& bezier = curve.beziers[piece.source.bezier];
    const double t = piece.source.t;
    const bool is_corner = t == 0 || t == 1, is_join = piece.kind == ba::Offset::Kind::JOIN;
    const std::size_t before = piece.source.bezier - (t == 0 ? 1 : 0);
    ASSERT_TRUE(!is_join || !is_corner || before + 1 < curve.beziers.size());
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Point p = ba::point(piece.arc, share);
      if (!is_join) {
        const std::uint32_t last = piece.bezier_of_end();
        EXPECT_LT(piece.source.bezier + t, last + piece.t_end);
        bool is_on = false;  // one of the Bezier pieces that it comes from
        for (std::uint32_t k = piece.source.bezier; k <= last && !is_on; ++k) {
          const Bezier& b = curve.beziers[k];
          const double begin = k == piece.source.bezier ? t : 0, end = k == last ? piece.t_end : 1;
          is_on = from_normals(b, p, begin, end) <= 2 * eps_ || has_legs(b, p) || runs_along_round(b, p);
        }
        EXPECT_TRUE(is_on) << p.x << ' ' << p.y;
      } else if (is_corner) {
        const Normal a = normal(curve.beziers[before], 1, false), b = normal(curve.beziers[before + 1], 0, true);
        const Point to = p - a.foot;
        EXPECT_NEAR(ba::euclidean_norm(to), d_, eps_);
        EXPECT_GE(dot(a.way + b.way, to), -eps_);
        EXPECT_GE(-sign_ * cross(a.way, to), -eps_);
        EXPECT_GE(sign_ * cross(b.way, to), -eps_);
      } else {  // where a curve turns within eps it is one, too
        EXPECT_NEAR(ba::euclidean_norm(p - bezier.point(t)), d_, 2 * eps_);
      }
    }
  }
  // Whether a curve that turns back is as near with both of its sides, so that within eps of it either leg is nearer.
  [[nodiscard]] bool has_legs(const Bezier& bezier, const Point& p) const {
    constexpr int SAMPLES = 256;
    bool is_here = false, is_there = false;
    for (int i = 0; i <= SAMPLES; ++i) {
      const Normal n = normal(bezier, double(i) / SAMPLES, i < SAMPLES);
      if (ba::euclidean_norm(p - n.foot) > d_ + 2 * eps_) continue;
      (dot(n.way, p - n.foot) > 0 ? is_here : is_there) = true;
    }
    return is_here && is_there;
  }
  // Whether a point is as far from an end of the piece as from another point whose normal leads to it: a piece that
  // bends in its last bit has an offset that meets the circle about its end, a cap's or a join's, at so small an angle
  // that either is within eps of the other for longer than that.
  [[nodiscard]] bool runs_along_round(const Bezier& bezier, const Point& p) const {
    const auto is_round = [&](const Point& end) { return std::fabs(ba::euclidean_norm(p - end) - d_) <= 2 * eps_; };
    if (!is_round(bezier.control_points().front()) && !is_round(bezier.control_points().back())) return false;
    constexpr int SAMPLES = 256;
    for (int i = 0; i <= SAMPLES; ++i) {
      const Normal n = normal(bezier, double(i) / SAMPLES, i < SAMPLES);
      if (ba::euclidean_norm(p - n.foot) <= d_ + 2 * eps_ && dot(n.way, p - n.foot) >= d_ - 2 * eps_) return true;
    }
    return false;
  }
  // The distance from the nearest end of a normal with a parameter in a range, or a little beyond, as parameters of
  // pieces are interpolated.
  [[nodiscard]] double from_normals(const Bezier& bezier, const Point& p, double t0, double t1) const {
    constexpr int STEPS = 32;
    const double beyond = (t1 - t0) / 2 + 0.25, low = (std::max)(t0 - beyond, 0.0), high = (std::min)(t1 + beyond, 1.0);
    const double middle = (t0 + t1) / 2;
    double least = HUGE_VAL;
    approach(bezier, p, middle, middle, least);
    for (int i = 0; i < STEPS; ++i)
      approach(bezier, p, low + (high - low) * i / STEPS, low + (high - low) * (i + 1) / STEPS, least);
    return least;
  }
  // Between the ends of two normals others are taken to be about as near as they are to each other.
  void approach(const Bezier& bezier, const Point& p, double t0, double t1, double& least) const {
    const auto end = [&](double t) {
      const Normal n = normal(bezier, (std::min)(t, 1.0), t < 1);
      return n.foot + d_ * n.way;
    };
    const Point a = end(t0), b = end(t1);
    const double apart = ba::euclidean_norm(b - a),
                 nearer = (std::min)(ba::euclidean_norm(a - p), ba::euclidean_norm(b - p));
    least = (std::min)(least, nearer);
    constexpr double LEAST = 1e-12;
    if (least <= eps_ || nearer - 2 * apart > least || apart < eps_ / 64 || t1 - t0 < LEAST) return;
    const double middle = (t0 + t1) / 2;
    const bool is_first_nearer = ba::euclidean_norm(a - p) < ba::euclidean_norm(b - p);
    if (is_first_nearer) approach(bezier, p, t0, middle, least);
    approach(bezier, p, middle, t1, least);
    if (!is_first_nearer) approach(bezier, p, t0, middle, least);
  }

  void expect_nothing_missing(std::size_t curve, const ba::Bounding_arc_tree_2& result) const {
    constexpr int NORMALS = 48;
    const auto& beziers = drawing_.curves()[curve].beziers;
    const double end = double(beziers.size());
    for (std::size_t i = 0; i < beziers.size(); ++i) {
      const double begin = double(i);
      for (int k = 1; k < NORMALS; ++k) {
        const double t = double(k) / NORMALS;
        expect_near(curve, begin + t, normal(beziers[i], t, true), result);
      }
      if (i == 0) continue;
      const Normal a = normal(beziers[i - 1], 1, false), b = normal(beziers[i], 0, true);
      const double turn = std::atan2(cross(a.way, b.way), dot(a.way, b.way));
      for (int k = 0; k <= NORMALS && sign_ * turn < 0; ++k) {  // round the outer side of a corner
        const double c = std::cos(turn * k / NORMALS), s = std::sin(turn * k / NORMALS);
        expect_near(curve, begin, {a.foot, c * a.way + s * perp(a.way)}, result);
      }
    }
    const auto is_end_near = [&](const Normal& n, bool is_start) {
      const Point p = n.foot + d_ * n.way;
      return std::any_of(chains_.begin(), chains_.end(), [&](const ba::Offset::Chain& c) {
        const Point at = is_start ? c.pieces.front().arc.from : c.pieces.back().arc.to;
        return !c.is_closed && ba::euclidean_norm(at - p) <= eps_;
      });
    };
    const Normal first = normal(beziers.front(), 0, true), last = normal(beziers.back(), 1, false);
    EXPECT_TRUE(!is_clear(curve, 0, first) || is_end_near(first, true));
    EXPECT_TRUE(!is_clear(curve, end, last) || is_end_near(last, false));
  }
  // Whether a disc that touches the curve from that side is empty, and from its middle, at the distance, nothing is as
  // near but the curve about that place: so whatever an offset is within its error, it has a point on the normal, which
  // comes from that side.
  [[nodiscard]] bool is_clear(std::size_t curve, double t, const Normal& n) const {
    const Point p = n.foot + d_ * n.way;
    const double more = d_ + 4 * eps_;
    if (ba::closest_point(index_, p)->distance.lower < d_ - ROUNDING) return false;
    if (ba::closest_point(index_, n.foot + more * n.way)->distance.lower < more - ROUNDING) return false;
    const auto is_near = [&](const Sample& s) { return ba::euclidean_norm(s.normal.foot - p) <= more + s.step; };
    const auto is_on_side = [&](const Sample& s) { return dot(s.normal.way, p - s.normal.foot) > 0; };
    for (std::size_t c = 0; c < samples_.size(); ++c) {
      std::size_t first = 0, last = samples_[c].size();
      if (c == curve) {
        const double share = t / double(drawing_.curves()[c].beziers.size());
        first = last = static_cast<std::size_t>(std::lround(share * double(samples_[c].size() - 1)));
        while (first > 0 && is_near(samples_[c][first - 1])) --first;
        while (last < samples_[c].size() && is_near(samples_[c][last])) ++last;
      } else {
        first = last;
      }
      // caps are about ends
      const bool is_of_end = c == curve && (first == 0 || last == samples_[c].size());
      if (is_of_end && t != 0 && t != double(drawing_.curves()[c].beziers.size())) return false;
      const auto begin = samples_[c].begin(), end = samples_[c].end();
      const auto at = [&](std::size_t i) { return begin + static_cast<std::ptrdiff_t>(i); };
      if (!std::all_of(at(first), at(last), is_on_side)) return false;  // legs of a curve that turns back
      if (std::any_of(begin, at(first), is_near) || std::any_of(at(last), end, is_near)) return false;
    }
    return true;
  }
  void expect_near(std::size_t curve, double t, const Normal& n, const ba::Bounding_arc_tree_2& result) const {
    if (!is_clear(curve, t, n)) return;
    ++tried_;
    const Point p = n.foot + d_ * n.way;
    const auto nearest = ba::closest_point(result, p);
    ASSERT_TRUE(nearest);
    ASSERT_LE(nearest->distance.upper, offset_.error + ROUNDING) << p.x << ' ' << p.y;
  }

  const Drawing& drawing_;
  ba::Bounding_arc_tree_2 index_;
  double d_, eps_;
  int sign_;
  Offset offset_;
  std::vector<std::vector<Sample>> samples_;  // of each open curve
  mutable std::size_t tried_ = 0;
  std::vector<ba::Offset::Chain> chains_;
};

// Both sides and the caps are the boundary of the band; what is on both sides, where curves run back, is told by each.
// \return how many normals had to be there
std::size_t expect_sides(const Drawing& drawing, double d, double eps, bool runs_back = false) {
  Offset_options options = within(eps);
  const Offset band = offset_curves(drawing, d, options);
  double length = 0;
  std::size_t tried = 0;
  for (const auto& chain : band.chains)
    for (const auto& piece : chain.pieces)
      if (piece.kind != ba::Offset::Kind::CAP && !drawing.curves()[piece.source.curve].is_closed)
        length += ba::length(piece.arc);
  for (const ba::Offset::Side side : {ba::Offset::Side::LEFT, ba::Offset::Side::RIGHT}) {
    SCOPED_TRACE(side == ba::Offset::Side::LEFT ? "left" : "right");
    options.side = side;
    Side_check check(drawing, d, options);
    check.expect_offset_of_side();
    length -= check.length();
    tried += check.tried();
  }
  const auto& curves = drawing.curves();
  const bool are_open = std::none_of(curves.begin(), curves.end(), [](const Curve& c) { return c.is_closed; });
  if (runs_back && are_open) EXPECT_LE(length, 1e-9);
  else EXPECT_NEAR(are_open ? length : 0, 0, 1e-9);
  return tried;
}

TEST(SideOffsets, MissNothingOfRandomDrawings) {
  std::mt19937 random(44);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto point = [&] { return Point{unit(random), unit(random)}; };
  std::size_t tried = 0;
  for (int k = 0; k < cases(100); ++k) {
    Drawing drawing;
    for (std::size_t c = 0; c < 1 + random() % 3; ++c) {
      std::vector<Bezier> chain;
      Point at = point();
      for (std::size_t i = 0; i < 1 + random() % 3; ++i) {
        std::vector<Point> p{at};
        for (std::size_t n = 1 + random() % 3; n > 0; --n) p.push_back(point());
        at = p.back();
        chain.emplace_back(p);
      }
      drawing.add(chain);
    }
    if (k % 8 == 0) drawing.add(circle(point(), 0.5));  // which open curves do not see
    const double eps = k % 2 == 0 ? 1e-3 : 1e-6, d = 0.01 + 0.5 * std::fabs(unit(random));
    SCOPED_TRACE(std::to_string(k) + ", d " + std::to_string(d) + ", eps " + std::to_string(eps));
    tried += expect_sides(drawing, d, eps);
    if (HasFailure()) return;
  }
  EXPECT_GT(tried, static_cast<std::size_t>(50 * cases(100)));  // normals
}

TEST(SideOffsets, MissNothingOfPolygonsOnAGrid) {
  std::mt19937 random(45);
  for (int k = 0; k < cases(100); ++k) {
    Drawing drawing;
    for (std::size_t c = 0; c < 1 + random() % 2; ++c) {
      std::vector<Point> corners;
      for (std::size_t count = 2 + random() % 4; corners.size() < count;) {
        const Point p{double(random() % 5), double(random() % 5)};
        if (corners.empty() || corners.back() != p) corners.push_back(p);
      }
      if (corners.front() == corners.back()) corners.pop_back();
      if (corners.size() > 1) drawing = both(drawing, polygon(corners, false));
    }
    if (drawing.curves().empty()) continue;
    const double d = 0.25 * double(1 + random() % 6);
    SCOPED_TRACE(std::to_string(k) + ", d " + std::to_string(d));
    expect_sides(drawing, d, k % 2 == 0 ? 1e-3 : 1e-6, true);
    if (HasFailure()) return;
  }
}

// Of parts that lie on each other those on the side asked for are told, and what others end at is no end.
TEST(SideOffsets, OfCurvesThatRunBackHaveNoGaps) {
  const Drawing line = polygon({{0, 0}, {10, 0}, {5, 0}, {15, 0}, {20, 5}}, false);
  std::vector<Bezier> arcs;
  for (const auto& [from, to, bulge] : {std::tuple<Point, Point, double>{{10, 0}, {-10, 0}, 1},
                                        {{-10, 0}, {0, 10}, 1 - std::sqrt(2)},
                                        {{0, 10}, {0, -10}, 1}})
    for (const Bezier& b : ba::arc_beziers<double>(from, to, bulge)) arcs.push_back(b);
  const auto ways = [&](const Drawing& drawing, ba::Offset::Side side, const Point& p) {
    Offset_options options = within(1e-3);
    options.side = side;
    const Offset offset = offset_curves(drawing, 1, options);
    expect_sound(offset);
    double nearest = HUGE_VAL;
    std::size_t pieces = 0;
    for (const auto& chain : offset.chains) {
      for (const auto& piece : chain.pieces)
        nearest = (std::min)(nearest, std::fabs(ba::signed_distance(p, piece.arc)));
      pieces += chain.pieces.size();
    }
    EXPECT_LE(nearest, 1e-3) << p.x << ' ' << p.y;
    return pieces;
  };
  for (const double x : {0.5, 4.5, 5.5, 7.5, 9.5, 12.0}) {
    EXPECT_LE(ways(line, ba::Offset::Side::LEFT, {x, 1}), 4U);
    if (x > 5 && x < 10) {
      EXPECT_LE(ways(line, ba::Offset::Side::LEFT, {x, -1}), 4U);
    }
  }
  for (const double angle : {0.3, 1.7, 2.0, 2.9, 3.6, 4.5}) {
    const Point way{std::cos(angle), std::sin(angle)};
    EXPECT_LE(ways(drawing_of(arcs), ba::Offset::Side::LEFT, 9 * way), 12U);
    EXPECT_LE(ways(drawing_of(arcs), ba::Offset::Side::BOTH, 11 * way), 24U);
  }
}

TEST(SideOffsets, LeavesOutThinLoops) {
  const Drawing nearly_closed = polygon({{0, 0}, {4, 0}, {4, 1}, {0, 1}, {0, 0.25}}, false);
  for (const ba::Offset::Side side : {ba::Offset::Side::BOTH, ba::Offset::Side::LEFT}) {
    Offset_options options = within(1e-3);
    options.side = side;
    const double wide = 4 * options.eps, thin = options.eps / 64;  // inside
    const std::size_t outside = side == ba::Offset::Side::BOTH ? 1 : 0;
    EXPECT_EQ(offset_curves(nearly_closed, (1 - wide) / 2, options).chains.size(), outside + 1);
    EXPECT_EQ(offset_curves(nearly_closed, (1 - thin) / 2, options).chains.size(), outside);
  }
}

}  // namespace
}  // namespace test_side_offsets

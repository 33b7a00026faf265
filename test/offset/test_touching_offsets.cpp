// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets whose parts touch, end on each other or lie on each other: cusps, curves on a grid, distances that are a
// radius of curvature or half a width; joins and caps of all kinds against the union of their shapes; and what is made
// of several offsets.

#include "cases.h"
#include "offset_checks.h"

#include <CGAL/Bounding_arcs_2/arc/arc_beziers.h>
#include <CGAL/Bounding_arcs_2/offset/offset_bracket.h>
#include <CGAL/Bounding_arcs_2/offset/offset_series.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_touching_offsets {
namespace {

using namespace bounding_arcs_test;

constexpr double PI = 3.14159265358979323846;

Point on_grid(std::mt19937& random) {
  return {static_cast<double>(random() % 5) - 2, static_cast<double>(random() % 5) - 2};
}
std::vector<Point> corners_on_grid(std::mt19937& random, std::size_t count) {
  std::vector<Point> corners{on_grid(random)};
  while (corners.size() < count) {
    const Point p = on_grid(random);
    if (p != corners.back() && p != corners.front()) corners.push_back(p);
  }
  return corners;
}
// Circles, polygons, cubics and cusps whose numbers have few digits, so that distances of a quarter make all coincide.
Drawing drawing_on_grid(std::mt19937& random) {
  Drawing drawing;
  const std::size_t count = 1 + random() % 3;
  while (drawing.curves().size() < count) {
    const Point p = on_grid(random);
    switch (random() % 4) {
      case 0:
        drawing.add(circle(p, 0.5 * static_cast<double>(1 + random() % 4)));
        break;
      case 1:
        drawing = both(drawing, polygon(corners_on_grid(random, 3 + random() % 4), random() % 2 == 0));
        break;
      case 2:
        drawing.add(Bezier({p, on_grid(random), on_grid(random), p + Point{1, 0}}));
        break;
      default:
        drawing.add(Bezier({p, p + Point{1, 1}, p + Point{0, 1}, p + Point{1, 0}}));
    }
  }
  return drawing;
}

TEST(TouchingOffsets, AreSoundForDrawingsOnAGrid) {
  std::mt19937 random(41);
  for (int k = 0; k < cases(200); ++k) {
    const Drawing drawing = drawing_on_grid(random);
    const auto& curves = drawing.curves();
    const bool are_closed = std::all_of(curves.begin(), curves.end(), [](const auto& c) { return c.is_closed; });
    const double eps = k % 2 == 0 ? 1e-3 : 1e-6, size = 0.25 * static_cast<double>(1 + random() % 8);
    const double d = are_closed && random() % 2 == 0 ? -size : size;
    SCOPED_TRACE(std::to_string(k) + ", d " + std::to_string(d));
    const Offset offset = offset_curves(drawing, d, within(eps));
    expect_sound(offset);
    expect_at_distance(drawing, offset, eps);
    if (are_closed) expect_same_points(drawing, offset, eps, true);
    if (HasFailure()) return;
  }
}

TEST(TouchingOffsets, KeepDrawingsThatWereLostOnce) {
  // a side's offset touches a join in the middle of both, which signs took for two crossings the other way round
  const Drawing touching =
      both(drawing_of(Bezier({{-1, 1}, {0, 1}, {2, 2}, {2, -1}})), polygon({{2, -2}, {4, -2}, {4, 0}, {2, 0}}));
  const Offset one = offset_curves(touching, 0.5, within(1e-3));
  expect_sound(one);
  EXPECT_EQ(winding(one, {3, -1}), 1);
  // joins of three curves that share a corner lie on each other, and only two of them touch a fourth
  const Drawing joins = both(both(polygon({{-1, 1}, {1, 0}}), drawing_of(Bezier({{1, -2}, {-1, 2}, {0, 0}, {-1, -1}}))),
                             polygon({{-1, -2}, {0, -2}, {0, 1}, {-1, 1}}));
  for (const ba::Fill_rule rule : {ba::Fill_rule::NONZERO, ba::Fill_rule::EVEN_ODD}) {
    Offset_options options = within(1e-4);
    options.rule = rule;
    expect_sound(offset_curves(joins, 1.25, options));
  }
  // a curve that runs back on itself: all its parts have to be cut where one of them is
  const Drawing line = drawing_of(Bezier({{1, -1}, {-2, 2}, {2, -2}, {0, 0}}));
  const Offset band = offset_curves(line, 1.25, within(1e-6));
  expect_sound(band);
  expect_at_distance(line, band, 1e-6);
  // a round join does not reach over a straight cap that is nearer than the distance
  Offset_options butt = within(1e-5);
  butt.cap = ba::Offset::Cap::BUTT;
  const Offset hook = offset_curves(polygon({{0, 0}, {3, 0}, {3, 1}}, false), 1.5, butt);
  expect_sound(hook);
  EXPECT_EQ(winding(hook, {3, 1.3}), 0);
  // points on an arc's chord are inside once
  const Drawing disc = drawing_of(circle({-2, -1}, 2));
  EXPECT_EQ(winding(offset_source(disc, within(1e-6)).at(0), {-1, 0}), 1);
}

TEST(TouchingOffsets, AreSoundForCusps) {
  const Drawing cusp = drawing_of(Bezier({{0, 0}, {1, 1}, {0, 1}, {1, 0}}));
  const Drawing back = drawing_of(std::vector<Bezier>{Bezier({{-1, 0}, {0, 0.5}, {0, 0}}), Bezier({{0, 0}, {0, 1}})});
  for (const Drawing& drawing : {cusp, back})
    for (const double eps : {1e-2, 1e-4, 1e-7})
      for (double d = 1.0 / 64; d <= 4; d *= 2) {
        SCOPED_TRACE(std::to_string(d) + " eps " + std::to_string(eps));
        const Offset offset = offset_curves(drawing, d, within(eps));
        expect_sound(offset);
        expect_at_distance(drawing, offset, eps);
        expect_same_points(drawing, offset, eps, false);
      }
}

TEST(TouchingOffsets, AreSoundAtSpecialDistances) {
  // an ellipse inwards by its least radius of curvature: all normals end before they meet
  const double a = 2, b = 1, s = std::sqrt(0.5), perimeter = 9.688448220547675, least = b * b / a;
  std::vector<Bezier> ellipse;
  const Point axes[5] = {{a, 0}, {0, b}, {-a, 0}, {0, -b}, {a, 0}};
  for (int i = 0; i < 4; ++i) ellipse.push_back(Bezier({axes[i], axes[i] + axes[i + 1], axes[i + 1]}, {1, s, 1}));
  for (const double eps : {1e-4, 1e-7}) {
    const Offset inner = offset_curves(drawing_of(ellipse), -least, within(eps));
    expect_sound(inner);
    EXPECT_NEAR(area_of(inner), PI * (a * b + least * least) - perimeter * least, eps * perimeter);
    expect_at_distance(drawing_of(ellipse), inner, eps);
  }
  // half the width of a stadium, whose ends are of that radius, and of a rectangle: an axis is left, which has no area
  const std::vector<Bezier> right = circle({1, 0}, 0.5), left = circle({-1, 0}, 0.5);
  const Drawing stadium = drawing_of(std::vector<Bezier>{segment({-1, -0.5}, {1, -0.5}), right[3], right[0],
                                                         segment({1, 0.5}, {-1, 0.5}), left[1], left[2]});
  for (const double d : {0.5 - 1e-4, 0.5, 0.5 + 1e-4}) {
    const Offset axis = offset_curves(stadium, -d, within(1e-6));
    expect_sound(axis);
    EXPECT_NEAR(area_of(axis), d < 0.5 ? 4 * (0.5 - d) + PI * (0.5 - d) * (0.5 - d) : 0, 1e-5) << d;
    EXPECT_TRUE(d <= 0.5 || axis.chains.empty());
  }
  const Drawing strip = polygon({{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}});
  EXPECT_NEAR(area_of(offset_curves(strip, -0.5, within(1e-6))), 0, 1e-5);
  EXPECT_EQ(offset_curves(strip, -0.5, within(1e-6)).status, ba::Offset::Status::COMPLETE);
  // two discs that touch at the distance, and a hole that is just filled
  const Drawing pair = both(drawing_of(circle({-1, 0}, 0.5)), drawing_of(circle({1, 0}, 0.5)));
  const Offset touching = offset_curves(pair, 0.5, within(1e-6));
  expect_sound(touching);
  EXPECT_NEAR(area_of(touching), 2 * PI, 1e-5);
  expect_at_distance(pair, touching, 1e-6);
  EXPECT_NEAR(area_of(offset_curves(pair, -0.5, within(1e-6))), 0, 1e-5);
  // zero takes outlines as they are, of an eight too, whose area cancels
  const Drawing eight = polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  EXPECT_EQ(offset_curves(eight, 0, within(1e-6)).chains.size(), 1U);
  const Offset same = offset_curves(both(strip, backwards(moved(strip, 0.5, {0, 0}))), 0, within(1e-6));
  expect_sound(same);
  EXPECT_NEAR(area_of(same), 2 - 0.5, 1e-15);
  EXPECT_TRUE(offset_curves(drawing_of(segment({0, 0}, {1, 0})), 0, within(1e-6)).chains.empty());
  // a curve that runs there and back encloses nothing
  const Drawing there_and_back = polygon({{0, 0}, {1, 0}});
  EXPECT_TRUE(offset_curves(there_and_back, -0.25, within(1e-6)).chains.empty());
  EXPECT_NEAR(area_of(offset_curves(there_and_back, 0.25, within(1e-6))), 0.5 + PI / 16, 1e-9);
}

TEST(TouchingOffsets, AreCirclesAroundAPoint) {
  const Drawing point = drawing_of(Bezier({{1, 1}, {1, 1}, {1, 1}}));
  for (const double d : {2.0, -2.0, 1e-3}) {
    const Offset circle = offset_curves(point, d, within(1e-6));
    expect_sound(circle);
    EXPECT_NEAR(area_of(circle), PI * d * d, 1e-12);
    if (d > 0) expect_at_distance(point, circle, 1e-6);  // else it has no outline
  }
  EXPECT_TRUE(offset_curves(point, 0, within(1e-6)).chains.empty());
  Offset_options options = within(1e-6);
  options.cap = ba::Offset::Cap::BUTT;
  EXPECT_TRUE(offset_curves(point, 2, options).chains.empty());
  options = within(1e-6);
  options.side = ba::Offset::Side::LEFT;  // it has none
  EXPECT_TRUE(offset_curves(point, 2, options).chains.empty());
}

// The union of shapes that a stroke is, one by one: rectangles of segments, both sides of each corner, caps.
class Stroke {
 public:
  Stroke(const std::vector<Point>& corners, bool is_closed, double d, const Offset_options& options)
      : d_(d), options_(options), corners_(corners) {
    if (is_closed) corners_.push_back(corners.front());
    is_closed_ = is_closed;
  }
  [[nodiscard]] bool holds(const Point& q) const {
    const std::size_t n = corners_.size() - 1;
    for (std::size_t i = 0; i < n; ++i) {
      const Point u = unit(i), z = q - corners_[i], across = perp(u);
      const double along = dot(u, z), length = ba::euclidean_norm(corners_[i + 1] - corners_[i]);
      const bool is_square = options_.cap == ba::Offset::Cap::SQUARE && !is_closed_;
      const double before = is_square && i == 0 ? d_ : 0, behind = is_square && i + 1 == n ? d_ : 0;
      if (along >= -before && along <= length + behind && std::fabs(dot(across, z)) <= d_) return true;
      if ((is_closed_ || i > 0) && in_join(unit(i == 0 ? n - 1 : i - 1), u, z)) return true;
    }
    if (is_closed_ || options_.cap != ba::Offset::Cap::ROUND) return false;
    const Point first = q - corners_.front(), last = q - corners_.back();
    return (ba::euclidean_norm(first) <= d_ && dot(unit(0), first) <= 0) ||
           (ba::euclidean_norm(last) <= d_ && dot(unit(n - 1), last) >= 0);
  }

 private:
  [[nodiscard]] Point unit(std::size_t i) const {
    const Point way = corners_[i + 1] - corners_[i];
    return (1 / ba::euclidean_norm(way)) * way;
  }
  // z seen from the corner between directions u and v
  [[nodiscard]] bool in_join(const Point& u, const Point& v, const Point& z) const {
    const double side = cross(u, v) > 0 ? -1 : 1;  // the outer one
    const Point p = (side * d_) * perp(u), q = (side * d_) * perp(v);
    const bool is_between = side * cross(p, z) <= 0 && side * cross(q, z) >= 0;  // of less than half a turn
    if (!is_between || dot(p + q, z) < 0) return false;
    if (options_.join == ba::Offset::Join::ROUND) return ba::euclidean_norm(z) <= d_;
    const Point middle = 0.5 * (p + q);
    const double share = dot(middle, middle) / (d_ * d_), along = dot(middle, z);
    if (share < 1e-12) return false;  // of a curve that turns back
    const bool is_miter =
        options_.join == ba::Offset::Join::MITER && 1 <= options_.miter_limit * options_.miter_limit * share;
    return is_miter ? dot(p, z) <= d_ * d_ && dot(q, z) <= d_ * d_ : along <= dot(middle, middle);
  }

  double d_;
  Offset_options options_;
  std::vector<Point> corners_;
  bool is_closed_;
};

TEST(TouchingOffsets, OfPolygonsWithAllJoinsAndCapsAreStrokes) {
  std::mt19937 random(42);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < cases(300); ++k) {
    Offset_options options = within(k % 2 == 0 ? 1e-3 : 1e-5);
    options.join = static_cast<ba::Offset::Join>(random() % 3);
    options.cap = static_cast<ba::Offset::Cap>(random() % 3);
    const double d = k % 3 == 0 ? 1 + unit(random) : 0.25 * static_cast<double>(1 + random() % 8);
    const std::vector<Point> corners = corners_on_grid(random, 2 + random() % 5);
    const Drawing drawing = polygon(corners, false);
    const Stroke stroke(corners, false, d, options);
    SCOPED_TRACE(std::to_string(k) + ", d " + std::to_string(d));
    const Offset offset = offset_curves(drawing, d, options);
    expect_sound(offset);
    for (int i = 0; i < 150; ++i) {
      const Point q{4.5 * unit(random), 4.5 * unit(random)};
      const double room = 4 * options.eps;
      const bool wanted = stroke.holds(q);
      bool is_clear = true;
      for (int j = 0; j < 8; ++j)
        is_clear = is_clear && stroke.holds(q + room * Point{std::cos(j * PI / 4), std::sin(j * PI / 4)}) == wanted;
      ASSERT_TRUE(!is_clear || winding(offset, q) == (wanted ? 1 : 0)) << q.x << ' ' << q.y << " wanted " << wanted;
    }
  }
}

TEST(TouchingOffsets, OfSeveralDistancesAreThoseOfEach) {
  const Drawing drawing = both(rectangle(3, 2), drawing_of(circle({1, 1}, 0.5)));
  const ba::Offset_source_2 source = offset_source(drawing, within(1e-6));
  const std::vector<double> distances{0.25, -0.125, 0, 2};
  const std::vector<Offset> series = source.at(distances);
  ASSERT_EQ(series.size(), distances.size());
  for (std::size_t i = 0; i < series.size(); ++i) {
    EXPECT_EQ(series[i].distance, distances[i]);
    EXPECT_EQ(area_of(series[i]), area_of(source.at(distances[i])));
  }
}

TEST(OffsetBracket, HasTheOffsetBetween) {
  std::mt19937 random(43);
  for (int k = 0; k < 6; ++k) {
    const Drawing drawing = k < 4 ? drawing_of(closed_curve(random, {0, 0}, 3 + random() % 5))
                                  : drawing_of(Bezier({{0, 0}, {1, 1}, {0, 1}, {1, 0}}));
    const ba::Bounding_arc_tree_2 index(drawing, ba::Decisions::DOUBLE);
    const double eps = k % 2 == 0 ? 1e-3 : 1e-6, d = k < 4 && k % 2 == 0 ? -0.125 : 0.25, size = std::fabs(d);
    const ba::Offset::Bounds bracket = ba::offset_bracket(ba::Bounding_arc_tree_2(drawing), d, eps);
    expect_sound(bracket.inside);
    expect_sound(bracket.outside);
    const double slack = 1e-3 * eps;
    const auto inside = ba::offset_error(index, bracket.inside, slack),
               outside = ba::offset_error(index, bracket.outside, slack);
    ASSERT_TRUE(inside && outside);
    // distances to the curves: what is outside is nearer to them where d < 0
    const auto& near = d < 0 ? outside : inside;
    const auto& far = d < 0 ? inside : outside;
    const double of_near = std::fabs((d < 0 ? bracket.outside : bracket.inside).distance),
                 of_far = std::fabs((d < 0 ? bracket.inside : bracket.outside).distance);
    EXPECT_LE(of_near + near->farthest.upper, size + slack);
    EXPECT_GE(of_near + near->nearest.lower, size - eps / 2 - slack);
    EXPECT_GE(of_far + far->nearest.lower, size - slack);
    EXPECT_LE(of_far + far->farthest.upper, size + eps / 2 + slack);
    EXPECT_LT(area_of(bracket.inside), area_of(bracket.outside));
  }
  EXPECT_THROW((void)ba::offset_bracket(ba::Bounding_arc_tree_2(rectangle(1, 1)), 1e-7, 1e-6), std::invalid_argument);
  Offset_options bevel = within(1e-6);
  bevel.join = ba::Offset::Join::BEVEL;
  EXPECT_THROW((void)ba::offset_bracket(ba::Bounding_arc_tree_2(rectangle(1, 1)), 1, 1e-6, bevel),
               std::invalid_argument);
}

TEST(Sleeve, IsRoundTheRegionAndNoFarther) {
  for (const double bulge : {0.3, 0.01, 1e-5}) {  // between an arc and two that meet
    ba::Arc_region_2 region;
    region.from = {0, 0};
    region.to = {1, 0};
    region.inner = {1, {-bulge, 0}, {}};
    region.outer = {2, {0, 0}, {0.5, 1.5 * bulge}};
    region.widening = 0;
    const double d = 0.25, eps = 1e-4;
    const Offset offset = ba::sleeve(region, d, eps);
    expect_sound(offset);
    ASSERT_EQ(offset.chains.size(), 1U);
    const ba::Arc_2 inner{region.from, region.to, -bulge};
    const Drawing boundary = drawing_of(std::vector<Bezier>{ba::arc_beziers(inner.from, inner.to, inner.bulge).front(),
                                                            segment(region.to, region.outer.joint),
                                                            segment(region.outer.joint, region.from)});
    const ba::Bounding_arc_tree_2 index(boundary, ba::Decisions::DOUBLE);
    const auto error = ba::offset_error(index, offset, eps / 1024);
    ASSERT_TRUE(error);
    EXPECT_GE(offset.distance + error->nearest.lower, d - eps / 512);
    EXPECT_LE(offset.distance + error->farthest.upper, d + eps + eps / 512);
    EXPECT_EQ(winding(offset, {0.5, bulge}), 1);
    region.widening = 0.125;
    EXPECT_NEAR(ba::sleeve(region, d, eps).distance, offset.distance + 0.125, 1e-15);
  }
  EXPECT_THROW((void)ba::sleeve({}, 0, 1e-3), std::invalid_argument);
}

// In the coordinates of a country: what is left of an arc is a point, and as far from the last one as coordinates tell.
TEST(TouchingOffsets, OfCirclesFarAwayByTheirRadiusVanish) {
  const Point at{2600036.481, 1200083.367}, beyond{2600034.081, 1200080.167},
      left{2600033.8580688685, 1200083.1724419217}, right{2600036.7039311314, 1200080.3615580783};
  const std::vector<double> narrow{1, 0.7534246575342466, 1}, wide{1, 0.6575342465753425, 1};
  Drawing drawing;
  drawing.add({Bezier({at, {2600035.084636364, 1200084.4142727274}, left}, narrow),
               Bezier({left, {2600032.2476666667, 1200081.5420000001}, beyond}, wide),
               Bezier({beyond, {2600035.477363636, 1200079.1197272725}, right}, narrow),
               Bezier({right, {2600038.314333333, 1200081.9919999999}, at}, wide)});
  for (const double eps : {5e-6, 1e-5, 2e-5, 1e-4}) {
    const Offset inset = ba::offset(ba::Bounding_arc_tree_2(drawing), -2, eps);
    EXPECT_EQ(inset.status, Offset::Status::COMPLETE);
    EXPECT_TRUE(inset.chains.empty());
  }
}

// A circle from its point on the left in four pieces, of which the middle ones are longer.
std::vector<Bezier> uneven_circle(const Point& center, double radius) {
  const Point to = {-0.1352975, -0.9908050}, left{-radius, 0}, below = radius * to;
  const std::vector<double> narrow{1, 0.7534246575342466, 1}, wide{1, 0.6575342465753425, 1};
  const auto at = [&](const Point& p, double sign) { return center + sign * p; };
  std::vector<Bezier> chain;
  for (const double sign : {1.0, -1.0}) {
    chain.push_back(Bezier({at(left, sign), at({-radius, -0.8727272725 * radius}, sign), at(below, sign)}, narrow));
    chain.push_back(Bezier({at(below, sign), at({radius, -1.1458333 * radius}, sign), at(-1.0 * left, sign)}, wide));
  }
  return chain;
}
// Both tips of what is between the offsets are cut off where these are some roundings apart, and not four times as far.
TEST(TouchingOffsets, OfCirclesThatTouchAreWithinTheirError) {
  const Point at{2600000004.5, 1200000010};
  Drawing drawing;
  drawing.add(uneven_circle(at, 2));
  drawing.add(uneven_circle(at - Point{0, 8.5}, 2.5));
  for (const double eps : {1.4e-3, 1.7e-3, 2e-3}) {
    const Offset offset = ba::offset(ba::Bounding_arc_tree_2(drawing), 2, eps);
    ASSERT_EQ(offset.status, Offset::Status::COMPLETE);
    const auto found = ba::offset_error(ba::Bounding_arc_tree_2(drawing), offset, eps / 64);
    ASSERT_TRUE(found);
    EXPECT_LE(found->farthest.upper, offset.error + eps / 64);
  }
}

TEST(OffsetSeries, InsetsEndWhereNothingIsLeft) {
  const Drawing drawing = both(rectangle(3, 2), drawing_of(Bezier({{1, 1}, {1, 1}})));  // points vanish at once
  const std::vector<Offset> insets = ba::insets(ba::Bounding_arc_tree_2(drawing), 0.3, 1e-6);
  ASSERT_EQ(insets.size(), 3U);
  for (std::size_t k = 0; k < insets.size(); ++k) {
    const double d = 0.3 * static_cast<double>(k + 1);
    EXPECT_NEAR(area_of(insets[k]), (3 - 2 * d) * (2 - 2 * d), 1e-12);
  }
  EXPECT_TRUE(ba::insets(ba::Bounding_arc_tree_2(drawing_of(Bezier({{1, 1}, {1, 1}}))), 0.3, 1e-6).empty());
  EXPECT_THROW((void)ba::insets(ba::Bounding_arc_tree_2(drawing), 0, 1e-6), std::invalid_argument);
}

TEST(OffsetSeries, OpensAndClosesByRoundingCorners) {
  const double r = 0.25, corner = (1 - PI / 4) * r * r;
  const Drawing ell = polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}});
  const Offset opened = ba::opening(ba::Bounding_arc_tree_2(ell), r, 1e-6),
               closed = ba::closing(ba::Bounding_arc_tree_2(ell), r, 1e-6);
  expect_sound(opened);
  expect_sound(closed);
  EXPECT_NEAR(area_of(opened), 5 - 5 * corner, 1e-8);
  EXPECT_NEAR(area_of(closed), 5 + corner, 1e-8);
  EXPECT_EQ(ba::opening(ba::Bounding_arc_tree_2(ell), 0.55, 1e-6).chains.size(),
            1U);  // what the arms meet in holds a wider disc
  EXPECT_TRUE(ba::opening(ba::Bounding_arc_tree_2(ell), 0.6, 1e-6).chains.empty());
}

}  // namespace
}  // namespace test_touching_offsets

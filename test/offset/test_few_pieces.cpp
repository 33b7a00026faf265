// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many pieces offsets have: one for each line and arc of shapes as parts have them, and none that is short. They
// are at the distance as before.

#include "bulge_loops.h"
#include "cases.h"
#include "exact_sweep.h"
#include "offset_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace test_few_pieces {
namespace {

using namespace bounding_arcs_test;

constexpr double PI = 3.141592653589793;

// A part's outline in the plane of a file, at any place, size and angle.
struct Frame {
  Point origin, along;
  [[nodiscard]] Point operator()(double x, double y) const { return origin + (x * along + y * perp(along)); }
};

// As readers make an ARC: quadratics of at most a quarter of a circle, by sines and cosines.
void add_arc(std::vector<Bezier>& chain, const Frame& at, const Point& center, double radius, double from,
             double turn) {
  const int count = static_cast<int>(std::ceil(std::fabs(turn) / (PI / 2) - 1e-9));
  const double step = turn / count, cosine = std::cos(step / 2);
  const auto on = [&](double angle, double r) {
    return at(center.x + r * std::cos(angle), center.y + r * std::sin(angle));
  };
  for (int i = 0; i < count; ++i) {
    const double a = from + i * step, b = i + 1 == count ? from + turn : a + step;
    chain.push_back(Bezier({chain.empty() ? on(a, radius) : chain.back().control_points().back(),
                            on((a + b) / 2, radius / cosine), on(b, radius)},
                           {1, cosine, 1}));
  }
}
void close(std::vector<Bezier>& chain) {
  const Bezier& last = chain.back();
  std::vector<Point> p = last.control_points();
  p.back() = chain.front().control_points().front();
  chain.back() = Bezier(p, last.weights());
}

enum class Form { ARCS, BULGES };

// A rectangle of w by h with round corners: a slot where their diameter is h, a circle where it is w, too.
// \param start the number of its first Bezier piece, of arcs
Drawing rounded(double w, double h, double r, const Frame& at, Form form, std::ptrdiff_t start) {
  const Point centers[4] = {{w - r, r}, {w - r, h - r}, {r, h - r}, {r, r}};
  const auto is_same = [](double a, double b) { return std::fabs(a - b) < 1e-9 * a; };
  if (form == Form::BULGES) {
    std::vector<Point> corners;
    std::vector<double> bulges;
    const auto add = [&](const Point& p, double bulge) {
      corners.push_back(at(p.x, p.y));
      bulges.push_back(bulge);
    };
    const bool is_slot = is_same(h, 2 * r);
    for (int k = 0; k < 4; k += is_slot ? 2 : 1) {
      const double a = (k - 1) * PI / 2, turn = is_slot ? PI : PI / 2;
      const Point& last = centers[is_slot ? k + 1 : k];
      add(centers[k] + r * Point{std::cos(a), std::sin(a)}, is_slot ? 1 : std::tan(PI / 8));
      if (!is_same(w, 2 * r) || !is_slot) add(last + r * Point{std::cos(a + turn), std::sin(a + turn)}, 0);
    }
    return drawing_of(Arc_loops{loop_of(corners, bulges)});
  }
  std::vector<Bezier> chain;
  for (int k = 0; k < 4; ++k) {
    const double a = (k - 1) * PI / 2;
    const Point& c = centers[k];
    const Point start = at(c.x + r * std::cos(a), c.y + r * std::sin(a));
    const bool has_side = k % 2 == 0 ? !is_same(w, 2 * r) : !is_same(h, 2 * r);
    if (!chain.empty() && has_side) chain.push_back(segment(chain.back().control_points().back(), start));
    add_arc(chain, at, c, r, a, PI / 2);
  }
  if (!is_same(w, 2 * r)) chain.push_back(segment(chain.back().control_points().back(), chain[0].control_points()[0]));
  else close(chain);
  std::rotate(chain.begin(), chain.begin() + start % static_cast<std::ptrdiff_t>(chain.size()), chain.end());
  return drawing_of(chain);
}

struct Part {
  Drawing drawing;
  double size;
  std::string text;
};
double log_uniform(std::mt19937& random, double low, double high) {
  return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(random));
}
Frame random_frame(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const double angle = random() % 3 == 0 ? 0 : PI * unit(random);
  return {{size * unit(random), size * unit(random)}, {size * std::cos(angle), size * std::sin(angle)}};
}
// What rounding leaves room for.
double random_eps(std::mt19937& random, double size, double d) {
  return (std::max)(2e-11 * size, (std::min)(log_uniform(random, 1e-10, 1e-3), std::fabs(d) / 16));
}

void expect_few(const Drawing& drawing, double d, double eps, std::size_t count) {
  SCOPED_TRACE("d " + std::to_string(d) + ", eps " + std::to_string(eps));
  const Offset offset = offset_curves(drawing, d, within(eps));
  EXPECT_TRUE(offset.is_valid());
  expect_sound(offset);
  EXPECT_LE(offset.error, eps);
  EXPECT_TRUE(do_not_cross(offset.chains));
  ASSERT_EQ(offset.chains.size(), 1U);
  EXPECT_EQ(offset.chains[0].pieces.size(), count);
  expect_at_distance(drawing, offset, eps);
}

TEST(FewPieces, OfCirclesSlotsAndRoundedRectangles) {
  for (int k = 0; k < cases(200); ++k) {
    SCOPED_TRACE(k);
    std::mt19937 random(static_cast<unsigned>(k));
    const double size = log_uniform(random, 1e-3, 1e6), h = log_uniform(random, 0.1, 1);
    const Frame at = random_frame(random, size);
    const Form form = random() % 2 == 0 ? Form::ARCS : Form::BULGES;
    const int shape = static_cast<int>(random() % 3);  // a circle, a slot, or corners
    const double w = shape == 0 ? h : 1 + h, r = shape == 2 ? h * (0.1 + 0.3 * log_uniform(random, 0.1, 1)) : h / 2;
    Drawing drawing = rounded(w, h, r, at, form, random() % 8);
    if (random() % 2 == 0) drawing = backwards(drawing);
    const double out = size * log_uniform(random, 0.01, 3), in = size * log_uniform(random, 0.01, 0.95) * r;
    const std::size_t count = shape == 0 ? 2 : (shape == 1 ? 4 : 8);
    expect_few(drawing, out, random_eps(random, size, out), count);
    expect_few(drawing, -in, random_eps(random, size, in), count);
    const Offset rounded_off = offset_curves(drawing, out, within(1e-16 * size));  // less than coordinates resolve
    EXPECT_EQ(rounded_off.status, ba::Offset::Status::RESOLUTION_REACHED);
    EXPECT_LE(rounded_off.error, 1e-11 * (size + out));
    ASSERT_EQ(rounded_off.chains.size(), 1U);
    EXPECT_EQ(rounded_off.chains[0].pieces.size(), count);
    if (HasFailure()) return;
  }
}

// The sides that are on one line are one, however many Bezier pieces they are, and corners of joins are one arc each.
TEST(FewPieces, OfPolygonsWithPointsOnTheirSides) {
  for (int k = 0; k < cases(50); ++k) {
    SCOPED_TRACE(k);
    std::mt19937 random(static_cast<unsigned>(k));
    const double size = log_uniform(random, 1e-3, 1e6);
    const Frame at = random_frame(random, size);
    const std::size_t count = 3 + random() % 4;
    std::vector<Point> corners;
    for (std::size_t i = 0; i < count; ++i) {
      const double a = 2 * PI * static_cast<double>(i) / static_cast<double>(count);
      corners.push_back({std::cos(a), std::sin(a)});
    }
    std::vector<Bezier> chain;
    for (std::size_t i = 0; i < count; ++i) {
      const Point &p = corners[i], &q = corners[(i + 1) % count];
      const auto on = [&](double t) {
        const Point x = t == 1 ? q : p + t * (q - p);
        return at(x.x, x.y);
      };
      if (i % 2 == 0) chain.push_back(segment(on(0), on(0.25))), chain.push_back(segment(on(0.25), on(1)));
      else chain.push_back(Bezier({on(0), on(0.5), on(0.6), on(1)}));  // straight
    }
    close(chain);
    const double d = size * log_uniform(random, 0.02, 0.3), eps = random_eps(random, size, d);
    expect_few(drawing_of(chain), d, eps, 2 * count);
    expect_few(drawing_of(chain), -d, eps, count);
    if (HasFailure()) return;
  }
}

// Sides of miters and square caps are led on.
TEST(FewPieces, OfMitersAndSquareCapsAreLines) {
  for (const double angle : {0.0, 0.7}) {
    const Frame at{{3, -2}, {std::cos(angle), std::sin(angle)}};
    const std::vector<Point> corners{at(0, 0), at(4, 0), at(4, 2), at(0, 2)};
    for (const double eps : {1e-3, 1e-9}) {
      Offset_options options = within(eps);
      options.join = ba::Offset::Join::MITER;
      options.cap = ba::Offset::Cap::SQUARE;
      const Offset grown = offset_curves(polygon(corners), 0.5, options),
                   band = offset_curves(polygon({corners[0], corners[1]}, false), 0.5, options);
      for (const Offset& offset : {grown, band}) {
        EXPECT_TRUE(offset.is_valid());
        expect_sound(offset);
        ASSERT_EQ(offset.chains.size(), 1U);
        EXPECT_EQ(offset.chains[0].pieces.size(), 4U);
        for (const auto& piece : offset.chains[0].pieces) EXPECT_EQ(piece.arc.bulge, 0);
      }
      EXPECT_NEAR(area_of(grown), 15, 1e-12);
      EXPECT_NEAR(area_of(band), 5, 1e-12);
      for (const auto& piece : grown.chains[0].pieces) {
        EXPECT_EQ(piece.kind, ba::Offset::Kind::CURVE);
        EXPECT_FALSE(piece.is_round);
        EXPECT_EQ(piece.source.bezier, piece.bezier_of_end());
        EXPECT_EQ(std::fabs(piece.t_end - piece.source.t), 1);
      }
      options.side = ba::Offset::Side::RIGHT;
      const Offset side = offset_curves(polygon({corners[0], corners[1], corners[2]}, false), 0.5, options);
      ASSERT_EQ(side.chains.size(), 1U);
      ASSERT_EQ(side.chains[0].pieces.size(), 2U);
      for (const auto& piece : side.chains[0].pieces) EXPECT_FALSE(piece.is_round);
    }
  }
}

// Each line and each arc of up to half a circle of an open curve is one piece on its side, where nothing is trimmed.
TEST(FewPieces, AreThoseOfAChainOfLinesAndArcs) {
  constexpr double LEAST_RADIUS = 0.5, DISTANCE = 0.125;
  for (int k = 0; k < cases(100); ++k) {
    SCOPED_TRACE(k);
    std::mt19937 random(static_cast<unsigned>(k));
    std::uniform_real_distribution<double> unit(0, 1);
    const double size = log_uniform(random, 1e-3, 1e6);
    const Frame at = random_frame(random, size);
    std::vector<Bezier> chain;
    Point p{0, 0};
    double angle = 0;
    std::vector<std::size_t> ends;         // the numbers of their last Bezier pieces
    for (std::size_t i = 0; i < 5; ++i) {  // tangents go on; it winds outwards, so that it never meets itself
      if (i % 2 == 0) {
        const Point q = p + (1 + unit(random)) * Point{std::cos(angle), std::sin(angle)};
        chain.push_back(segment(chain.empty() ? at(p.x, p.y) : chain.back().control_points().back(), at(q.x, q.y)));
        p = q;
      } else {
        const double r = LEAST_RADIUS * (1 + 4 * static_cast<double>(i)), turn = (i == 1 ? 1 : -1) * PI * unit(random);
        const Point to_center = (turn > 0 ? r : -r) * Point{-std::sin(angle), std::cos(angle)}, c = p + to_center;
        add_arc(chain, at, c, r, std::atan2(-to_center.y, -to_center.x), turn);
        angle += turn;
        p = c + (turn > 0 ? r : -r) * Point{std::sin(angle), -std::cos(angle)};
      }
      ends.push_back(chain.size() - 1);
    }
    Offset_options options = within(random_eps(random, 8 * size, DISTANCE * size));
    for (const ba::Offset::Side side : {ba::Offset::Side::LEFT, ba::Offset::Side::RIGHT}) {
      options.side = side;
      const Offset offset = offset_curves(drawing_of(chain), DISTANCE * size, options);
      EXPECT_TRUE(offset.is_valid());
      ASSERT_EQ(offset.chains.size(), 1U);
      ASSERT_EQ(offset.chains[0].pieces.size(), ends.size());
      for (std::size_t i = 0; i < ends.size(); ++i) {
        const ba::Offset::Piece& piece = offset.chains[0].pieces[i];
        EXPECT_EQ(piece.arc.bulge == 0, i % 2 == 0);
        EXPECT_EQ(piece.source.bezier, i == 0 ? 0 : ends[i - 1] + 1);
        EXPECT_EQ(piece.bezier_of_end(), ends[i]);
        EXPECT_NEAR(piece.source.t, 0, 1e-12);
        EXPECT_NEAR(piece.t_end, 1, 1e-12);
      }
      expect_at_distance(drawing_of(chain), offset, options.eps);
    }
    if (HasFailure()) return;
  }
}

// Ends of other pieces stay ends, so that chains that touch in one do not cross there.
TEST(FewPieces, KeepEndsInWhichOthersTouch) {
  for (int k = 0; k < cases(60); ++k) {
    SCOPED_TRACE(k);
    std::mt19937 random(static_cast<unsigned>(k));
    Drawing drawing;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point center{double(random() % 5), double(random() % 5)};
      drawing.add(circle(center, 0.25 * double(1 + random() % 4)));
    }
    for (const double d : {0.25, 0.5, -0.25, 1.0}) {
      const Offset offset = offset_curves(drawing, d, within(1e-4));
      EXPECT_NE(offset.status, ba::Offset::Status::UNRESOLVED);
      EXPECT_TRUE(offset.is_valid());
      EXPECT_TRUE(do_not_cross(offset.chains));
      expect_at_distance(drawing, offset, 1e-4);
    }
    if (HasFailure()) return;
  }
}

// A circle, and a square whose corner is on it, as they are.
TEST(FewPieces, KeepAnEndInWhichACurveTouches) {
  const Drawing square = polygon({{0, 1}, {1, 2}, {0, 3}, {-1, 2}}),
                drawing = both(drawing_of(circle({0, 0}, 1)), square);
  EXPECT_EQ(offset_curves(drawing_of(circle({0, 0}, 1)), 0, within(1e-4)).chains[0].pieces.size(), 2U);
  const Offset offset = offset_curves(drawing, 0, within(1e-4));
  const auto& pieces = offset.chains[0].pieces;
  EXPECT_TRUE(std::any_of(pieces.begin(), pieces.end(), [](const auto& p) { return p.arc.from == Point{0, 1}; }));
  const Drawing runs_back = polygon({{0, 0}, {10, 0}, {5, 0}, {5, 5}});  // neighbours on one line that turn
  EXPECT_EQ(offset_curves(runs_back, 0, within(1e-4)).chains[0].pieces.size(), 4U);
}

// Splines whose offsets are cut next to ends of their arcs.
TEST(FewPieces, AreNotShort) {
  std::size_t pieces = 0;
  for (int k = 0; k < cases(100); ++k) {
    SCOPED_TRACE(k);
    std::mt19937 random(static_cast<unsigned>(k));
    const Drawing drawing = drawing_of(closed_curve(random, {0, 0}, 5 + random() % 60));
    const double eps = log_uniform(random, 1e-4, 1e-2);
    for (const double d : {0.05, -0.05, 0.2}) {
      const Offset offset = offset_curves(drawing, d, within(eps));
      expect_sound(offset);
      EXPECT_TRUE(offset.is_valid());
      EXPECT_LE(offset.error, eps);
      EXPECT_TRUE(do_not_cross(offset.chains));
      for (const auto& chain : offset.chains)
        for (const auto& p : chain.pieces) {
          ++pieces;
          EXPECT_GE(ba::length(p.arc), eps / 16) << "d " << d << ", eps " << eps;
        }
      expect_at_distance(drawing, offset, eps);
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(pieces, static_cast<std::size_t>(cases(100)));
}

}  // namespace
}  // namespace test_few_pieces

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joining: shapes that are cut into curves, shuffled, reversed and moved become the shapes again; what is not clear is
// left apart, and nothing is moved farther than asked.

#include <CGAL/Bounding_arcs_2/curve/join_curves.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace test_join_curves {
namespace {

using namespace CGAL::Bounding_arcs;
using Piece = Bezier_curve_2<double>;
using Points = std::vector<Xy<double>>;

Piece segment(double x0, double y0, double x1, double y1) { return Piece({{x0, y0}, {x1, y1}}); }
Drawing_2<double> drawing_of(const std::vector<Piece>& pieces) {
  Drawing_2<double> drawing;
  for (const Piece& piece : pieces) drawing.add(piece, "c" + std::to_string(drawing.curves().size()));
  return drawing;
}
const Xy<double>& start(const Drawing_2<double>::Curve& curve) {
  return curve.beziers.front().control_points().front();
}
const Xy<double>& end(const Drawing_2<double>::Curve& curve) { return curve.beziers.back().control_points().back(); }

TEST(JoinCurves, MakesALoopOfLinesThatRunEitherWay) {
  const auto joined = join_curves(drawing_of({segment(0, 0, 4, 0), segment(4, 3, 4, 0), segment(4, 3, 0, 0)}), 0);
  ASSERT_EQ(joined.drawing.curves().size(), 1u);
  const auto& curve = joined.drawing.curves().front();
  EXPECT_TRUE(curve.is_closed);
  EXPECT_EQ(curve.name, "c0");
  EXPECT_EQ(start(curve), (Xy<double>{0, 0}));
  ASSERT_EQ(joined.parts.front().size(), 3u);
  EXPECT_FALSE(joined.parts.front()[0].is_reversed);
  EXPECT_EQ(joined.parts.front()[1].curve, 1u);
  EXPECT_TRUE(joined.parts.front()[1].is_reversed);
  EXPECT_EQ(joined.joints, 3u);
  EXPECT_EQ(joined.moved, 0);
  EXPECT_EQ(joined.joined, std::vector<std::size_t>{0});
}

TEST(JoinCurves, AChainHasTheDirectionAndTheNameOfItsFirstPart) {
  const auto joined = join_curves(drawing_of({segment(2, 0, 1, 0), segment(2, 0, 3, 1), segment(0, 0, 1, 0)}), 0);
  ASSERT_EQ(joined.drawing.curves().size(), 1u);
  const auto& curve = joined.drawing.curves().front();
  EXPECT_FALSE(curve.is_closed);
  EXPECT_EQ(curve.name, "c0");
  EXPECT_EQ(start(curve), (Xy<double>{3, 1}));
  EXPECT_EQ(end(curve), (Xy<double>{0, 0}));
}

TEST(JoinCurves, LeavesApartWhatIsFartherThanEps) {
  const auto loose = drawing_of({segment(0, 0, 4, 0), segment(4, 0.01, 4, 3)});
  EXPECT_EQ(join_curves(loose, 0.009).drawing.curves().size(), 2u);
  const auto joined = join_curves(loose, 0.01);
  EXPECT_EQ(joined.drawing.curves().size(), 1u);
  EXPECT_EQ(joined.moved, 0.01);
  EXPECT_EQ(joined.drawing.curves()[0].beziers[1].control_points().front(), (Xy<double>{4, 0}))
      << "the later one moves";
}

TEST(JoinCurves, LeavesApartMoreThanTwoEndsAndTellsWhere) {
  // A diagonal between two corners of a square: which way round is not clear.
  const auto joined = join_curves(drawing_of({segment(0, 0, 1, 0), segment(1, 0, 1, 1), segment(1, 1, 0, 1),
                                              segment(0, 1, 0, 0), segment(0, 0, 1, 1)}),
                                  0);
  EXPECT_EQ(joined.drawing.curves().size(), 3u);
  EXPECT_EQ(joined.crowded, (Points{{0, 0}, {1, 1}}));
  EXPECT_EQ(joined.joints, 2u);
}

TEST(JoinCurves, WhatGoesOnStraightGoesFirstWhereMoreThanTwoMeet) {
  // Two circles that cross, cut where they do: arcs of 240 and 120 degrees about (0, 0) and (1, 0), in cubics.
  const auto arc = [](double x, double from, double to) {
    std::vector<Piece> pieces;
    const double step = (to - from) / 4, k = 4 / 3. * std::tan(step / 4);
    for (int i = 0; i < 4; ++i) {
      const double a = from + i * step, b = a + step;
      const Xy<double> center{x, 0}, p{std::cos(a), std::sin(a)}, q{std::cos(b), std::sin(b)};
      const Xy<double> start = pieces.empty() ? center + p : pieces.back().control_points().back();
      pieces.push_back(Piece({start, center + p + k * perp(p), center + q - k * perp(q), center + q}));
    }
    return pieces;
  };
  constexpr double THIRD = 1.0471975511965977;
  Drawing_2<double> loose;
  loose.add(arc(0, -THIRD, THIRD), "left, inner");
  loose.add(arc(1, 2 * THIRD, 4 * THIRD), "right, inner");
  loose.add(arc(1, 4 * THIRD, 8 * THIRD), "right, outer");
  loose.add(arc(0, THIRD, 5 * THIRD), "left, outer");
  const auto joined = join_curves(loose, 1e-9);
  ASSERT_EQ(joined.drawing.curves().size(), 2u);
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(joined.drawing.curves()[i].is_closed);
    EXPECT_EQ(joined.parts[i][1].curve, i == 0 ? 3u : 2u);
  }
  EXPECT_TRUE(joined.crowded.empty());
}

TEST(JoinCurves, AtAJunctionTheLineThatEndsThereIsLeft) {
  const auto junction = join_curves(drawing_of({segment(0, 0, 4, 0), segment(4, 0, 4, 3), segment(4, 0, 9, 0)}), 0);
  ASSERT_EQ(junction.drawing.curves().size(), 2u);
  EXPECT_EQ(junction.parts[0].size(), 2u);
  EXPECT_EQ(junction.parts[0][1].curve, 2u);
  EXPECT_TRUE(junction.crowded.empty());
  const auto with_corner =
      join_curves(drawing_of({segment(0, 0, 4, 0), segment(4, 0, 4, 3), segment(4, 0, 9, 0), segment(4, 0, 5, 3)}), 0);
  EXPECT_EQ(with_corner.drawing.curves().size(), 2u) << "two are left, which are joined then";
  EXPECT_EQ(with_corner.joints, 2u);
}

TEST(JoinCurves, WhatGoesOnInSeveralIsAmbiguous) {
  const auto fork = drawing_of({segment(0, 0, 4, 0), segment(4, 0, 8, 0.06), segment(4, 0, 8, 0.2)});
  EXPECT_EQ(join_curves(fork, 0).drawing.curves().size(), 3u) << "1 and 3 degrees";
  EXPECT_EQ(join_curves(fork, 0).crowded, (Points{{4, 0}}));
  const auto bent = drawing_of({segment(0, 0, 4, 0), segment(4, 0, 8, 0.08), segment(4, 0, 8, 4)});
  EXPECT_EQ(join_curves(bent, 0).crowded.size(), 1u) << "1.1 degrees are a corner";
  // Ends that may have been moved by half of eps tell less of short lines.
  const auto clear = drawing_of({segment(0, 0, 4, 0), segment(4.01, 0, 8, 0), segment(4, 0.01, 8, 4)});
  EXPECT_EQ(join_curves(clear, 0.02).drawing.curves().size(), 2u);
  EXPECT_EQ(join_curves(clear, 0.08).crowded.size(), 1u);
}

TEST(JoinCurves, ClosesALoopWhateverElseEndsThere) {
  const auto joined =
      join_curves(drawing_of({segment(0, 0, 4, 0), segment(4, 0, 4, 3), segment(4, 3, 0, 0), segment(4, 3, 9, 9)}), 0);
  ASSERT_EQ(joined.drawing.curves().size(), 2u);
  EXPECT_TRUE(joined.drawing.curves()[0].is_closed);
  EXPECT_FALSE(joined.drawing.curves()[1].is_closed);
  EXPECT_TRUE(joined.crowded.empty());
}

TEST(JoinCurves, TakesTheNearestFirst) {
  // The same, then what rounding parts, then what is within eps; a line that is shorter than eps is no obstacle.
  const auto joined =
      join_curves(drawing_of({segment(0, 0, 4, 0), segment(4, 0, 4, 0.05), segment(4, 0.05, 0, 3)}), 0.1);
  ASSERT_EQ(joined.drawing.curves().size(), 1u);
  EXPECT_EQ(joined.moved, 0);
  const auto three =
      join_curves(drawing_of({segment(0, 0, 4, 0), segment(4, 1e-14, 8, 1), segment(4, 0.05, 8, 9)}), 0.1);
  ASSERT_EQ(three.drawing.curves().size(), 2u);
  EXPECT_EQ(three.moved, 1e-14);
}

TEST(JoinCurves, TakesEndsOfOneLayerFirst) {
  const auto loose = drawing_of({segment(0, 0, 4, 0), segment(4, 0, 4, 3), segment(4, 0, 9, 9), segment(9, 9, 9, 0)});
  EXPECT_EQ(join_curves(loose, 0).crowded.size(), 1u);
  const auto joined = join_curves(loose, 0, {7, 7, 8, 9});
  ASSERT_EQ(joined.drawing.curves().size(), 2u);
  EXPECT_EQ(joined.parts[0].size(), 2u);
  EXPECT_EQ(joined.parts[0][1].curve, 1u);
  EXPECT_EQ(joined.parts[1].size(), 2u) << "of two layers, where each has one end";
}

TEST(JoinCurves, MovesLinesAndNotArcs) {
  const double w = std::sqrt(0.5);
  const Piece arc({{1, 0}, {1, 1}, {0, 1}}, {1, w, 1});
  const auto joined = join_curves(drawing_of({arc, segment(1e-3, 1, -4, 1)}), 0.01);
  ASSERT_EQ(joined.drawing.curves().size(), 1u);
  EXPECT_EQ(joined.drawing.curves()[0].beziers[0].control_points(), arc.control_points());
  EXPECT_EQ(start(joined.drawing.curves()[0]), (Xy<double>{1, 0}));
  const auto other = join_curves(drawing_of({segment(-4, 1, 1e-3, 1), arc}), 0.01);
  EXPECT_EQ(other.drawing.curves()[0].beziers[1].control_points(), (Points{{0, 1}, {1, 1}, {1, 0}}));
}

TEST(JoinCurves, ClosedCurvesAndThoseAloneStayAsTheyAre) {
  Drawing_2<double> drawing;
  drawing.add(B_spline_curve_2<double>(2, {{0, 0}, {1, 2}, {2, 0}, {3, 1}}, {0, 0, 0, 1, 2, 2, 2}), "open");
  drawing.add({segment(5, 0, 6, 0), segment(6, 0, 6, 1), segment(6, 1, 5, 0)}, "closed", {0, 2, 5, 9});
  const auto joined = join_curves(drawing, 0.5);
  ASSERT_EQ(joined.drawing.curves().size(), 2u);
  EXPECT_NE(joined.drawing.curves()[0].b_spline, nullptr);
  EXPECT_EQ(joined.drawing.curves()[1].parameters, (std::vector<double>{0, 2, 5, 9}));
  EXPECT_TRUE(joined.joined.empty());
}

TEST(JoinCurves, ClosesOneCurveUnlessItWouldBecomeAPoint) {
  const Piece hook({{0, 0}, {5, 5}, {-5, 5}, {0, 1e-3}});
  const auto joined = join_curves(drawing_of({hook, segment(20, 0, 20.005, 0)}), 0.01);
  ASSERT_EQ(joined.drawing.curves().size(), 2u);
  EXPECT_TRUE(joined.drawing.curves()[0].is_closed);
  EXPECT_FALSE(joined.drawing.curves()[1].is_closed);
  const auto small = join_curves(drawing_of({segment(0, 0, 1, 0), segment(1, 0, 1, 1)}), 2);
  ASSERT_EQ(small.drawing.curves().size(), 1u);
  EXPECT_FALSE(small.drawing.curves()[0].is_closed) << "nothing would be left of it";
}

TEST(JoinCurves, TwoCurvesOneUponTheOtherMakeNoLoop) {
  const auto joined = join_curves(drawing_of({segment(0, 0, 4, 0), segment(4, 0, 0, 0)}), 1e-3);
  EXPECT_EQ(joined.drawing.curves().size(), 2u);
  EXPECT_EQ(joined.joints, 0u);
  const auto lens = join_curves(drawing_of({Piece({{0, 0}, {2, 1}, {4, 0}}), segment(4, 0, 0, 0)}), 1e-3);
  EXPECT_EQ(lens.drawing.curves().size(), 1u);
}

TEST(JoinCurves, LeavesApartLinesWithAShortOneBetween) {
  for (const double gap : {0.0, 0.1}) {
    const auto joined = join_curves(
        drawing_of({segment(0, 0, 10, 0), segment(10 + gap, 0, 10.6, 0), segment(10.6 + gap, 0, 20, 0)}), 1, {0, 0, 0});
    const bool is_clear = gap == 0;  // ends that are one are joined first
    EXPECT_EQ(joined.drawing.curves().size(), is_clear ? 1u : 3u);
    EXPECT_EQ(joined.crowded.empty(), is_clear);
    EXPECT_EQ(joined.moved, 0);
  }
}

TEST(JoinCurves, ACurveShorterThanEpsIsJoinedToAnother) {
  const auto joined = join_curves(drawing_of({segment(0, 0, 0.005, 0), segment(0.012, 0, 4, 0)}), 0.01);
  EXPECT_EQ(joined.drawing.curves().size(), 1u) << "its own other end is no third one";
}

TEST(JoinCurves, APieceThatBecomesAPointIsLeftOut) {
  Drawing_2<double> drawing = drawing_of({segment(4, 0, 4, 3)});
  drawing.add({segment(0, 0, 4, 0), segment(4, 0, 4.005, 0)}, "with a hook");
  const auto joined = join_curves(drawing, 0.01);
  ASSERT_EQ(joined.drawing.curves().size(), 1u);
  EXPECT_EQ(joined.drawing.curves()[0].beziers.size(), 2u);
}

// What is left of a square without the circle in it: where two corners touch, all tangents are on one line.
TEST(JoinCurves, TellsOutlinesThatTouchApartByTheirOrder) {
  std::vector<Piece> corners;
  for (const auto& [x, y] : Points{{2, 2}, {-2, 2}, {-2, -2}, {2, -2}}) {
    corners.emplace_back(Points{{x, 0}, {x, y}, {0, y}}, std::vector<double>{1, std::sqrt(0.5), 1});
    corners.push_back(segment(x, y, 0, y));
    corners.push_back(segment(x, y, x, 0));
  }
  for (const double eps : {0.0, 1e-6}) {
    const auto joined = join_curves(drawing_of(corners), eps);
    ASSERT_EQ(joined.drawing.curves().size(), 4u);
    EXPECT_TRUE(joined.crowded.empty());
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_TRUE(joined.drawing.curves()[i].is_closed);
      ASSERT_EQ(joined.parts[i].size(), 3u);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(joined.parts[i][k].curve, 3 * i + k);
      EXPECT_TRUE(joined.parts[i][1].is_reversed);
    }
  }
  // arcs whose ends are off by rounding
  std::vector<Piece> rounded = corners;
  for (std::size_t i = 0; i < rounded.size(); i += 3) {
    Points points = rounded[i].control_points();
    points.front().y += 1e-14, points.back().x -= 1e-14;
    rounded[i] = Piece(points, rounded[i].weights());
  }
  EXPECT_EQ(join_curves(drawing_of(rounded), 1e-6).drawing.curves().size(), 4u);
  // nothing tells them apart where they do not follow each other
  std::vector<Piece> mixed;
  for (std::size_t i = 0; i < corners.size(); ++i) mixed.push_back(corners[5 * i % corners.size()]);
  EXPECT_EQ(join_curves(drawing_of(mixed), 0).crowded.size(), 4u);
  // what runs there and back is no outline
  const auto twice = join_curves(drawing_of({segment(0, 0, 4, 0), segment(4, 0, 0, 0), segment(4, 0, 4, 3)}), 0);
  EXPECT_EQ(twice.joints, 0u);
}

TEST(JoinCurves, ErrorsOfACurveCountForItsOwnEndsAlone) {
  const auto loose = drawing_of({segment(0, 0, 4, 0), segment(4, 0.05, 4, 3), segment(4, 3.05, 0, 3)});
  EXPECT_EQ(join_curves(loose, 0.01, {}, {0, 0, 0.04}).drawing.curves().size(), 2u);
  EXPECT_EQ(join_curves(loose, 0.01, {}, {0, 0.04, 0}).drawing.curves().size(), 1u);
  EXPECT_EQ(join_curves(loose, 0.01, {}, {0.02, 0.02, 0}).drawing.curves().size(), 2u) << "two errors";
  // ends within the distance go first, whatever the errors of others reach
  const auto crowd = drawing_of({segment(0, 0, 4, 0), segment(4, 0.01, 4, 3), segment(4, 0.05, 8, 9)});
  const auto joined = join_curves(crowd, 0.01, {}, {0, 0, 1});
  EXPECT_EQ(joined.drawing.curves().size(), 2u);
  EXPECT_EQ(joined.parts[0].size(), 2u);
}

TEST(JoinCurves, RefusesWhatIsNoDistance) {
  const auto drawing = drawing_of({segment(0, 0, 1, 1)});
  EXPECT_THROW((void)join_curves(drawing, -1e-9), std::invalid_argument);
  EXPECT_THROW((void)join_curves(drawing, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW((void)join_curves(drawing, std::numeric_limits<double>::infinity()), std::invalid_argument);
  EXPECT_THROW((void)join_curves(drawing, 1, {1, 2}), std::invalid_argument);
  EXPECT_THROW((void)join_curves(drawing, 1, {}, {1, 2}), std::invalid_argument);
  EXPECT_THROW((void)join_curves(drawing, 1, {}, {-1}), std::invalid_argument);
  EXPECT_TRUE(join_curves({}, 1).drawing.curves().empty());
}

// Closed shapes on a grid, each of lines, arcs and cubics between corners.
std::vector<std::vector<Piece>> random_shapes(std::mt19937_64& random, double unit, const Xy<double>& origin) {
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<std::vector<Piece>> shapes;
  for (int i = 0; i < 6; ++i) {
    Points corners;
    const int count = 3 + static_cast<int>(random() % 6);
    for (int k = 0; k < count; ++k) {
      const double angle = 6.283185307179586 * (k + 0.6 * part(random)) / count, r = unit * (1 + part(random));
      corners.push_back({origin.x + 5 * unit * i + r * std::cos(angle), origin.y + r * std::sin(angle)});
    }
    std::vector<Piece> shape;
    for (int k = 0; k < count; ++k) {
      const Xy<double>&p = corners[k], &q = corners[(k + 1) % count];
      const Xy<double> top = 0.5 * (p + q) + 0.3 * part(random) * perp(q - p);
      switch (random() % 3) {
        case 0:
          shape.push_back(Piece({p, q}));
          break;
        case 1:
          shape.push_back(Piece({p, top, q}, {1, 0.5 + part(random), 1}));
          break;
        default:
          shape.push_back(Piece({p, top, 0.5 * (top + q), q}));
      }
    }
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

TEST(JoinCurves, ShapesThatAreCutShuffledReversedAndMovedAreTheShapesAgain) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    std::mt19937_64 random(seed);
    const double unit = std::ldexp(1, static_cast<int>(random() % 61) - 30), eps = 0.01 * unit;
    const Xy<double> origin = random() % 2 == 0 ? Xy<double>{0, 0} : Xy<double>{1e6 * unit, -1e6 * unit};
    const auto shapes = random_shapes(random, unit, origin);
    std::vector<Piece> pieces;
    std::uniform_real_distribution<double> off(-eps / 4, eps / 4);
    for (const auto& shape : shapes)
      for (const Piece& piece : shape) {
        Points points = piece.control_points();
        for (Xy<double>* end : {&points.front(), &points.back()})
          if (random() % 2 == 0) *end = *end + Xy<double>{off(random), off(random)};
        const Piece moved(points, piece.weights());
        pieces.push_back(random() % 2 == 0 ? moved : moved.reversed());
      }
    std::shuffle(pieces.begin(), pieces.end(), random);
    const auto joined = join_curves(drawing_of(pieces), eps);
    ASSERT_EQ(joined.drawing.curves().size(), shapes.size()) << "seed " << seed;
    ASSERT_LE(joined.moved, eps) << "seed " << seed;
    std::size_t count = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const auto& curve = joined.drawing.curves()[i];
      ASSERT_TRUE(curve.is_closed) << "seed " << seed;
      ASSERT_EQ(curve.beziers.size(), joined.parts[i].size()) << "seed " << seed;
      count += curve.beziers.size();
      for (std::size_t k = 0; k < curve.beziers.size(); ++k) {
        const Joined_curves::Part& part = joined.parts[i][k];
        const Piece before = part.is_reversed ? pieces[part.curve].reversed() : pieces[part.curve];
        ASSERT_EQ(before.weights(), curve.beziers[k].weights()) << "seed " << seed;
        for (const double t : {0.0, 0.1, 0.5, 0.8, 1.0}) {
          const Xy<double> p = before.point(t), q = curve.beziers[k].point(t);
          ASSERT_LE(std::hypot(p.x - q.x, p.y - q.y), eps * (1 + 1e-6) + 1e-9 * unit) << "seed " << seed;
        }
      }
    }
    ASSERT_EQ(count, pieces.size()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace test_join_curves

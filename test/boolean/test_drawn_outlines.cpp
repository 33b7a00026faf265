// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outlines as drawings: how far rounding moved them, what is too small to be drawn, and that they can be combined
// again.

#include "cases.h"
#include "closed_drawings.h"
#include "outline_checks.h"

#include "../../src/library/curve/exact_bezier.h"

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace test_drawn_outlines {

using namespace bounding_arcs_test;
using Drawn_outline = ba::Outline_2::Drawn;
using Exact = CGAL::Exact_rational;

constexpr Boolean_operation OPERATIONS[] = {Boolean_operation::UNION, Boolean_operation::INTERSECTION,
                                            Boolean_operation::DIFFERENCE, Boolean_operation::SYMMETRIC_DIFFERENCE};

/// The same with each coordinate moved by two ulp at most, 0 by some of 1/8; ends that were one stay one.
Drawing nudged(const Drawing& drawing, std::mt19937& random) {
  const auto move = [&random](double x) {
    constexpr double ULP_OF_EIGHTH = 0x1p-55;
    for (std::size_t i = random() % 3; i > 0; --i) {
      const double sign = random() % 2 == 0 ? 1 : -1;
      x = x == 0 ? sign * ULP_OF_EIGHTH : std::nextafter(x, sign * std::numeric_limits<double>::infinity());
    }
    return x;
  };
  Drawing result;
  for (const auto& curve : drawing.curves()) {
    std::vector<Bezier> chain;
    for (const Bezier& b : curve.beziers) {
      std::vector<Point> points;
      for (const Point& p : b.control_points()) points.push_back({move(p.x), move(p.y)});
      if (!chain.empty()) points.front() = chain.back().control_points().back();
      if (chain.size() + 1 == curve.beziers.size())
        points.back() = chain.empty() ? points.front() : chain.front().control_points().front();
      chain.emplace_back(std::move(points), b.weights());
    }
    result.add(std::move(chain));
  }
  return result;
}
Drawing nudged_lattice_drawing(std::mt19937& random) {
  constexpr double UNITS[] = {1, 0.1, 1.0 / 3, 0.74, 3.7};
  return nudged(random_lattice_drawing(random, 3, {UNITS[random() % 5], 0, 0}), random);
}

Drawn_outline drawn(const Operands& operands, Boolean_operation operation,
                    const Fill_rules& rules = Fill_rule::NONZERO) {
  return ba::drawn_outline(operands.trees(), operands.outline(operation, rules));
}

std::size_t number_of_pieces(const Drawing& drawing) {
  std::size_t count = 0;
  for (const auto& curve : drawing.curves()) count += curve.beziers.size();
  return count;
}

/// Chains are closed, as many as curves, and nested as the outline's.
void expect_drawn(const Drawn_outline& found, const std::string& name) {
  ASSERT_EQ(found.drawing.curves().size(), found.outline.chains.size()) << name;
  EXPECT_EQ(found.outline.status, ba::Outline_2::Status::COMPLETE) << name;
  EXPECT_TRUE(std::isfinite(found.moved)) << name;
  for (std::size_t i = 0; i < found.outline.chains.size(); ++i) {
    const auto& chain = found.outline.chains[i];
    const auto& curve = found.drawing.curves()[i];
    EXPECT_TRUE(curve.is_closed) << name;
    ASSERT_EQ(curve.beziers.size(), chain.parts.size()) << name;
    for (std::size_t k = 0; k < chain.parts.size(); ++k) {
      EXPECT_EQ(curve.beziers[k].control_points().front(), chain.parts[k].start) << name;
      EXPECT_EQ(curve.beziers[k].control_points().back(), chain.parts[k].end) << name;
    }
    if (chain.parent) {
      ASSERT_LT(*chain.parent, found.outline.chains.size()) << name;
      EXPECT_NE(chain.is_ccw, found.outline.chains[*chain.parent].is_ccw) << name;
    } else {
      EXPECT_TRUE(chain.is_ccw) << name;
    }
  }
}

double exact_distance(const ba::Xy<Exact>& p, const ba::Xy<Exact>& q) {
  return std::sqrt(CGAL::to_double((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y)));
}

// Points of parts at any parameters in the brackets of their ends, and between them, against the curves that are drawn.
TEST(DrawnOutlines, AreMovedByNoMoreThanTheySay) {
  constexpr int POINTS = 4;
  double largest = 0, least_slack = std::numeric_limits<double>::infinity();
  for (int i = 0; i < cases(40) && !HasFailure(); ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    const Operands operands({nudged_lattice_drawing(random), nudged_lattice_drawing(random)});
    const Drawn_outline found = drawn(operands, OPERATIONS[i % 4]);
    const std::string name = "case " + std::to_string(i);
    expect_drawn(found, name);
    EXPECT_LE(found.moved, 1e-11) << name;
    largest = (std::max)(largest, found.moved);
    for (std::size_t c = 0; c < found.outline.chains.size(); ++c)
      for (std::size_t k = 0; k < found.outline.chains[c].parts.size(); ++k) {
        const ba::Outline_2::Part& part = found.outline.chains[c].parts[k];
        const auto given =
            ba::exact_bezier(operands.drawings()[part.operand]->curves()[part.curve].beziers[part.bezier]);
        const auto written = ba::exact_bezier(found.drawing.curves()[c].beziers[k]);
        const Exact from = part.from.middle(), to = part.to.middle();
        for (const double start : {part.from.lower, part.from.upper})
          for (int j = 0; j <= POINTS; ++j) {
            const Exact share = Exact(j) / Exact(POINTS),
                        t = (Exact(1) - share) * Exact(start) + share * Exact(part.to.upper);
            const Exact s = from == to ? Exact(0) : Exact((t - from) / (to - from));  // as far as it goes
            const Exact on = s < 0 ? Exact(0) : (s > 1 ? Exact(1) : s);
            const double miss = exact_distance(given.point(t), written.point(on));
            EXPECT_LE(miss, found.moved) << name << " chain " << c << " part " << k;
            if (found.moved > 0) least_slack = (std::min)(least_slack, found.moved / (std::max)(miss, 1e-300));
          }
      }
  }
  EXPECT_GT(largest, 0);
  RecordProperty("slack", std::to_string(least_slack));
}

// Pieces that are small beside their coordinates, each cut at a double: nothing but rounding moves what is cut out.
TEST(DrawnOutlines, CountTheRoundingOfCuts) {
  constexpr double SIZE = 0.01, SEEN = 0.02;  // bounds of roundings that are a fiftieth of these are seen
  constexpr int POINTS = 8;
  std::mt19937 random(1);
  std::uniform_real_distribution<> unit(0, 1);
  double largest = 0;
  for (int i = 0; i < cases(300); ++i) {
    std::vector<Point> points(3 + static_cast<std::size_t>(i % 3));
    for (Point& p : points) {
      p.x = 1 + SIZE * unit(random);
      p.y = 1 + SIZE * unit(random);
    }
    const Drawing drawing = drawing_of(Bezier(points));
    const double cut = unit(random);
    const auto given = ba::exact_bezier(drawing.curves().front().beziers.front());
    const ba::Xy<Exact> from = given.point(Exact(cut));
    const Point start{CGAL::to_double(from.x), CGAL::to_double(from.y)};
    Outline_2 outline;
    outline.chains.push_back({{{0, 0, 0, {cut, cut}, {1, 1}, false, start, points.back()}}, true, std::nullopt});
    const Drawn_outline found =
        ba::drawn_outline(Operands({drawing}).trees(), outline, {false});  // no chain, as it is open
    const auto written = ba::exact_bezier(found.drawing.curves().front().beziers.front());
    for (int j = 0; j <= POINTS; ++j) {
      const Exact share = Exact(j) / Exact(POINTS);
      const double miss =
          exact_distance(given.point((Exact(1) - share) * Exact(cut) + share), written.point(share)) / found.moved;
      EXPECT_LE(miss, 1) << "case " << i;
      largest = (std::max)(largest, miss);
    }
  }
  EXPECT_GT(largest, SEEN);
}

TEST(DrawnOutlines, AreNotMovedWhereNothingIsCut) {
  const Operands tiles({drawing_of(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})), drawing_of(circle({7, 0.5}, 2))});
  EXPECT_EQ(drawn(tiles, Boolean_operation::UNION).moved, 0);
  EXPECT_EQ(drawn(tiles, Boolean_operation::INTERSECTION).moved, 0);
}

// A chain that is rounded to a line and back, and one to a polyline and back, with what is around and inside of it.
TEST(DrawnOutlines, LeaveOutChainsThatBoundNothing) {
  const std::vector<Point> way{{0, 0}, {2, 1}, {3, 5}};
  const Operands operands({drawing_of(polygon({{0, 0}, {2, 1}, {3, 5}}))});
  const auto edge = [](std::uint32_t i, bool is_reversed, const Point& start, const Point& end) {
    const ba::Bracket zero{0, 0}, one{1, 1};
    return ba::Outline_2::Part{0, 0, i, is_reversed ? one : zero, is_reversed ? zero : one, is_reversed, start, end};
  };
  Outline_2 outline;
  outline.chains.push_back({{edge(0, false, way[0], way[1]), edge(0, true, way[1], way[0])}, true, std::nullopt});
  outline.chains.push_back({{edge(0, false, way[0], way[1]), edge(1, false, way[1], way[2]),
                             edge(1, true, way[2], way[1]), edge(0, true, way[1], way[0])},
                            true,
                            std::nullopt});
  outline.chains.push_back(
      {{edge(0, false, way[0], way[1]), edge(1, false, way[1], way[2]), edge(2, false, way[2], way[0])}, true, 1});
  const Drawn_outline found = ba::drawn_outline(operands.trees(), outline);
  ASSERT_EQ(found.drawing.curves().size(), 1u);
  EXPECT_EQ(found.drawing.curves()[0].beziers.size(), 3u);
  EXPECT_FALSE(found.outline.chains[0].parent) << "what was around it is left out";
  EXPECT_EQ(ba::drawn_outline(operands.trees(), outline, {false}).drawing.curves().size(), 3u);
}

// Curves that meet at a small angle, where the place of a crossing is known a million times worse than coordinates: a
// crescent, and a loop that is 2e-8 wide and 5e-3 long.
TEST(DrawnOutlines, KeepWhatIsMoreThanRounding) {
  for (const double center : {0.0, 1.0, 100.0, 10000.0}) {
    const double shift = 3.2e-5 * std::sqrt((std::max)(1.0, center));
    const Operands circles({drawing_of(circle({center, center}, 1)), drawing_of(circle({center + shift, center}, 1))});
    const Outline_2 outline = circles.outline(Boolean_operation::DIFFERENCE, Fill_rule::NONZERO);
    const Drawn_outline found = ba::drawn_outline(circles.trees(), outline);
    EXPECT_EQ(number_of_pieces(found.drawing), parts_of(outline, false).size()) << center;
  }
  const Point node{-47.993, 27.421}, start{-45.866, -56.369}, end{16.664, 97.823};
  const Operands path({drawing_of(std::vector<Bezier>{Bezier({end, {-16.084, 110.22}, {-28.876, 74.56}, node}),
                                                      Bezier({node, {-31.229, 68.76}, {-54.223, -43.001}, start}),
                                                      segment(start, end)})});
  EXPECT_EQ(drawn(path, Boolean_operation::UNION, Fill_rule::EVEN_ODD).drawing.curves().size(), 2u);
}

// Of nudged drawings many edges, and some chains, are shorter than doubles tell.
TEST(DrawnOutlines, LeaveOutWhatDoublesDoNotTellFromAPoint) {
  std::size_t parts = 0, chains = 0;
  for (int i = 0; i < cases(60) && !HasFailure(); ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    const Drawing first = nudged_lattice_drawing(random);
    const Operands operands({first, nudged(first, random)});
    const Fill_rules rule = Fill_rule::NONZERO;
    const Outline_2 outline = operands.outline(Boolean_operation::SYMMETRIC_DIFFERENCE, rule);
    const Drawn_outline found = ba::drawn_outline(operands.trees(), outline),
                        whole = ba::drawn_outline(operands.trees(), outline, {false});
    const std::string name = "case " + std::to_string(i);
    expect_drawn(found, name);
    expect_drawn(whole, name);
    EXPECT_GE(found.moved, whole.moved) << name;
    EXPECT_LE(found.moved, 8 * whole.moved)
        << name;  // both sides of a sliver, how far these are apart, and what is drawn
    EXPECT_EQ(parts_of(whole.outline, false), parts_of(outline, false)) << name;
    std::size_t given = 0;
    for (const Outline_2::Chain& chain : outline.chains) given += chain.parts.size();
    EXPECT_EQ(number_of_pieces(whole.drawing), given) << name;
    for (const auto& curve : found.drawing.curves())
      for (const Bezier& b : curve.beziers) {
        double size = 0;
        for (const Point& p : b.control_points())
          size = (std::max)(size, ba::stable_norm(p - b.control_points().front()));
        EXPECT_TRUE(b.control_points().front() != b.control_points().back() || size > 1e-9) << name << ' ' << size;
      }
    parts += number_of_pieces(whole.drawing) - number_of_pieces(found.drawing);
    chains += whole.drawing.curves().size() - found.drawing.curves().size();
  }
  EXPECT_GT(parts, chains);
  EXPECT_GT(chains, 0u);
}

/// How much an area may be off where its boundary is moved: by that times the length of the boundary. Nearly all of
/// what a boundary is moved over is within that; ends have the rest, and fill rules count it twice.
double area_slack(const Drawn_outline& outline) {
  double length = 0;
  for (const auto& curve : outline.drawing.curves())
    for (const Bezier& b : curve.beziers)
      for (std::size_t i = 1; i < b.control_points().size(); ++i)
        length += ba::stable_norm(b.control_points()[i] - b.control_points()[i - 1]);
  return 2 * outline.moved * (length + outline.moved);
}
/// The area by Gauss's rule of three points, which is exact for cubics; certified areas of so many digits take seconds.
double area(const Drawn_outline& outline) {
  using Real = long double;
  const Real node = std::sqrt(Real(0.6));
  Real sum = 0;
  for (const auto& curve : outline.drawing.curves())
    for (const Bezier& b : curve.beziers) {
      std::vector<ba::Xy<Real>> points;
      for (const Point& p : b.control_points()) points.push_back({p.x, p.y});
      const ba::Bezier_curve_2<Real> precise(std::move(points), {b.weights().begin(), b.weights().end()});
      const auto rate =
          [&](Real t) {  // x y' - y x' by the hodograph of halves: (p, q) of the parts before and behind t
            const auto [before, behind] = precise.split(t);
            const auto& p = before.control_points();
            const auto& q = behind.control_points();
            const Real w = b.is_rational() ? behind.weights()[1] / behind.weights()[0] : 1;
            return Real(b.degree()) * w / (1 - t) * ba::cross(p.back(), q[1] - q[0]);
          };
      const int parts = b.is_rational() ? 512 : 1;
      for (int i = 0; i < parts; ++i) {
        const Real half = Real(0.5) / parts, middle = (2 * i + 1) * half;
        sum += half / 9 * (5 * rate(middle - half * node) + 8 * rate(middle) + 5 * rate(middle + half * node));
      }
    }
  return static_cast<double>(sum / 2);
}

/// What ten operations, each on the result of the one before, make of areas.
void combine_ten_times(unsigned seed) {
  constexpr std::size_t MANY = 40;       // copies that are moved by some ulp make several times as many
  constexpr double OF_MEASURED = 1e-12;  // areas up to some hundred, each within 1e-13 of that
  std::mt19937 random(seed);
  Drawing drawing = nudged_lattice_drawing(random);
  Fill_rule rule = random() % 2 == 0 ? Fill_rule::NONZERO : Fill_rule::EVEN_ODD;
  for (int step = 0; step < 10; ++step) {
    const std::string name = "seed " + std::to_string(seed) + " step " + std::to_string(step);
    const bool is_copy = random() % 4 == 0 && number_of_pieces(drawing) < MANY;
    const Drawing other = is_copy ? nudged(drawing, random) : nudged_lattice_drawing(random);
    const Fill_rules rules{rule, random() % 2 == 0 ? Fill_rule::NONZERO : Fill_rule::EVEN_ODD};
    const Operands both({drawing, other});
    std::vector<Drawn_outline> results;
    for (const Boolean_operation operation : OPERATIONS) {
      results.push_back(drawn(both, operation, rules));
      expect_drawn(results.back(), name);
    }
    const Drawn_outline own = drawn(Operands({drawing}), Boolean_operation::UNION, rules.of(0, 2)),
                        others = drawn(Operands({other}), Boolean_operation::UNION, rules.of(1, 2));
    double slack = area_slack(own) + area_slack(others) + OF_MEASURED;
    for (const Drawn_outline& r : results) slack += area_slack(r);
    const double united = area(results[0]), common = area(results[1]), rest = area(results[2]),
                 either = area(results[3]);
    EXPECT_NEAR(united + common, area(own) + area(others), slack) << name;
    EXPECT_NEAR(rest + common, area(own), slack) << name;
    EXPECT_NEAR(either + common, united, slack) << name;
    const Drawn_outline& next = results[random() % 4];
    const Fill_rule next_rule = random() % 2 == 0 ? Fill_rule::NONZERO : Fill_rule::EVEN_ODD;
    const Drawn_outline read = drawn(Operands({next.drawing}), Boolean_operation::UNION, next_rule);
    EXPECT_NEAR(area(read), area(next), area_slack(next) + area_slack(read) + OF_MEASURED) << name;
    if (::testing::Test::HasFailure()) return;
    drawing = next.drawing;
    rule = next_rule;
  }
}

/// How many pieces there are when a drawing is combined with one other again and again.
std::size_t pieces_after_combining(unsigned seed, bool drops_slivers) {
  constexpr std::size_t TOO_MANY = 200;
  std::mt19937 random(seed);
  Drawing drawing = nudged_lattice_drawing(random);
  const Drawing other = nudged_lattice_drawing(random);
  for (int step = 0; step < 6 && number_of_pieces(drawing) < TOO_MANY; ++step) {
    const Operands both({drawing, other});
    const Boolean_operation operation =
        random() % 2 == 0 ? Boolean_operation::UNION : Boolean_operation::SYMMETRIC_DIFFERENCE;
    drawing = ba::drawn_outline(both.trees(), both.outline(operation, Fill_rule::EVEN_ODD), {drops_slivers}).drawing;
  }
  return number_of_pieces(drawing);
}

// What is rounded runs along what it was made of. All of these are made of the same few curves.
TEST(DrawnOutlines, DoNotGrowByTheirOwnSlivers) {
  constexpr std::size_t MANY = 80;
  std::size_t most = 0;
  for (int i = 0; i < cases(8); ++i) {
    const std::size_t count = pieces_after_combining(static_cast<unsigned>(i), true);
    EXPECT_LE(count, MANY) << "seed " << i;
    most = (std::max)(most, pieces_after_combining(static_cast<unsigned>(i), false));
  }
  EXPECT_GT(most, 2 * MANY) << "of those with slivers";
}

// All joints of a copy are beside those of what it was made of, so that ways along it go over joints.
TEST(DrawnOutlines, DoNotGrowByCopiesOfThemselves) {
  std::mt19937 of_lattice(1);
  const Drawing lattice = nudged_lattice_drawing(of_lattice);
  const Drawing starts[] = {drawing_of(polygon({{0.1, 0.2}, {1.3, 0.15}, {0.7, 1.1}})),
                            drawing_of(circle({0.3, 0.4}, 1)), lattice};
  for (const Drawing& start : starts) {
    std::mt19937 random(1);
    Drawing drawing = drawn(Operands({start}), Boolean_operation::UNION).drawing;
    const std::size_t count = number_of_pieces(drawing);
    for (int step = 0; step < 10; ++step)
      drawing = drawn(Operands({drawing, nudged(drawing, random)}), Boolean_operation::UNION).drawing;
    EXPECT_LE(number_of_pieces(drawing), 4 * count);  // a corner more now and then
  }
}

TEST(DrawnOutlines, AreCombinedAgainAndAgain) {
  for (int i = 0; i < cases(8) && !HasFailure(); ++i) combine_ten_times(static_cast<unsigned>(i));
}

}  // namespace test_drawn_outlines

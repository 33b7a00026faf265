// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains of offsets do not cross, exactly: with rational circles through their ends, by a sweep over them; and as they
// do not, winding numbers tell which of them are regions and which are holes, and in what.
// Usage: test_offsets [FILE...]; files are asked for at d = +-0.01, +-0.05, +-0.2 of their size and eps = 1e-4,
// 1e-6 of it, instead of the tests' own, their distances are bracketed, too, and what is returned is whether any
// failed.

#include "exact_sweep.h"
#include "offset_checks.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace test_simple_offsets {
namespace {

namespace ba = CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
using Chains = std::vector<ba::Offset::Chain>;

// A box about an arc, which is no farther from its chord than the diameter of its circle.
CGAL::Bbox_2 box_about(const ba::Arc_2& arc) {
  const ba::Xy<double>&p = arc.from, &q = arc.to;
  const double far = std::hypot(q.x - p.x, q.y - p.y) * (1 + arc.bulge * arc.bulge);
  return {std::min(p.x, q.x) - far, std::min(p.y, q.y) - far, std::max(p.x, q.x) + far, std::max(p.y, q.y) + far};
}

// A loop with its box, and how often it runs round a point.
struct Loop {
  explicit Loop(const ba::Offset::Chain& c) : chain(&c) {
    for (const auto& p : c.pieces) box += box_about(p.arc);
  }
  [[nodiscard]] int winding(const ba::Xy<double>& x) const {
    if (x.x < box.xmin() || x.x > box.xmax() || x.y < box.ymin() || x.y > box.ymax()) return 0;
    int sum = 0;
    for (const auto& p : chain->pieces) sum += winding_of(p.arc, x);
    return sum;
  }
  const ba::Offset::Chain* chain;
  CGAL::Bbox_2 box;
};

// Whether chains that do not cross are closed, run round regions, whose outsides have nothing around them or a hole,
// and round holes, which have a region around them, and know the innermost one around them.
bool is_nested(const Chains& chains) {
  const std::vector<Loop> loops(chains.begin(), chains.end());
  for (const Loop& inner : loops) {
    const auto& pieces = inner.chain->pieces;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (pieces[i].arc.to != pieces[(i + 1) % pieces.size()].arc.from) return false;
    const ba::Xy<double> x = ba::point(pieces.front().arc, 0.5);
    std::vector<const Loop*> around;
    int sum = 0;
    for (const Loop& outer : loops) {
      const int winding = &outer == &inner ? 0 : outer.winding(x);
      if (winding != 0) around.push_back(&outer);
      sum += winding;
    }
    if (!inner.chain->is_closed || sum != (inner.chain->is_ccw ? 0 : 1)) return false;
    if (inner.chain->parent.has_value() == around.empty()) return false;
    // what is around the parent is all but itself
    const auto is_parent = [&](const Loop* p) { return p->chain == &chains[*inner.chain->parent]; };
    if (!around.empty() && std::none_of(around.begin(), around.end(), is_parent)) return false;
    for (const Loop* p : around)
      if (!is_parent(p) && p->winding(chains[*inner.chain->parent].pieces.front().arc.from) == 0) return false;
    // an area's sign is what its chain is by the winding number of a point beside it
    const ba::Xy<double> along = pieces.front().arc.to - pieces.front().arc.from;
    constexpr double ASIDE = 1e-6;  // of a chord, far more than rounding and less than chains are apart
    const int left = inner.winding(x + ASIDE * ba::perp(along)), right = inner.winding(x - ASIDE * ba::perp(along));
    if (left - right != 1 || left + right != (inner.chain->is_ccw ? 1 : -1)) return false;
  }
  return true;
}

ba::Drawing_2<double> read(const std::string& file) { return ba::drawing<double>(ba::read_curve_file(file).curves); }

TEST(SimpleOffsets, SeesCrossings) {
  ba::Offset::Chain chain;
  for (const ba::Arc_2& arc : {ba::Arc_2{{0, 0}, {2, 0}, 0.5}, {{2, 0}, {1, -2}, 0}, {{1, -2}, {0, 0}, 0}})
    chain.pieces.push_back({arc, {}, 1, ba::Offset::Kind::CURVE, true});
  ba::Offset offset;
  offset.chains.push_back(chain);
  EXPECT_TRUE(do_not_cross(offset.chains));
  offset.chains.push_back(chain);
  EXPECT_FALSE(do_not_cross(offset.chains));
  offset.chains.pop_back();
  offset.chains.back().pieces[0].arc.bulge = 1;  // half a circle, which leaves the triangle
  EXPECT_FALSE(do_not_cross(offset.chains));
}

TEST(SimpleOffsets, SeesWrongNesting) {
  const auto loop = [](double size, bool is_ccw, std::optional<std::size_t> parent) {
    ba::Offset::Chain chain;
    const ba::Xy<double> right{size, 0}, left{-size, 0};
    for (const ba::Arc_2& arc : {ba::Arc_2{right, left, is_ccw ? 1.0 : -1.0}, {left, right, is_ccw ? 1.0 : -1.0}})
      chain.pieces.push_back({arc, {}, 1, ba::Offset::Kind::CURVE, true});
    chain.is_ccw = is_ccw;
    chain.parent = parent;
    return chain;
  };
  const Chains ring{loop(2, true, {}), loop(1, false, 0), loop(0.5, true, 1)};
  EXPECT_TRUE(is_nested(ring));
  EXPECT_FALSE(is_nested({ring[0], loop(1, true, 0)}));             // a region in a region
  EXPECT_FALSE(is_nested({ring[0], loop(1, false, {})}));           // a hole of nothing
  EXPECT_FALSE(is_nested({ring[0], ring[1], loop(0.5, true, 0)}));  // an island of the region around its hole
  Chains wrong = ring;
  wrong[2].is_ccw = false;
  EXPECT_FALSE(is_nested(wrong));
  wrong = ring;
  wrong[0].pieces[0].arc.to.x += 1;
  EXPECT_FALSE(is_nested(wrong));
}

TEST(SimpleOffsets, DoNotCrossForBundledCurves) {
  for (const char* name : {"a_wrench", "e_cat", "f_crow", "h_maple_leaf"})  // the cat has a hole outwards
    for (const double eps : {2e-4, 2e-6}) {
      const ba::Offset_source_2 source =
          offset_source(read(std::string(BOUNDING_ARCS_EXAMPLE_DATA) + "/" + name + ".json"), within(eps));
      for (const double d : {0.02, -0.02, 0.1, -0.1, 0.4, -0.4}) {
        const ba::Offset offset = source.at(d);
        EXPECT_TRUE(do_not_cross(offset.chains)) << name << ' ' << d << " eps " << eps;
        EXPECT_TRUE(is_nested(offset.chains)) << name << ' ' << d << " eps " << eps;
      }
    }
}

// Two ends of a strip that is as wide as two distances, whose sides bend away at its end.
ba::Drawing_2<double> dumbbell(double angle, const ba::Xy<double>& center) {
  const double c = std::cos(angle), s = std::sin(angle);
  std::vector<ba::Bezier_curve_2<double>> chain;
  for (const double sign : {1.0, -1.0}) {
    const auto at = [&](double x, double y) { return center + sign * ba::Xy<double>{c * x - s * y, s * x + c * y}; };
    const auto add = [&](std::vector<ba::Xy<double>> points, std::vector<double> weights = {}) {
      chain.emplace_back(std::move(points), std::move(weights));
    };
    add({at(-1, -0.5), at(1, -0.5)});
    add({at(1, -0.5), at(2, -0.5), at(2, -1.5)}, {1, 1, 2});
    add({at(2, -1.5), at(4, -1.5)});
    add({at(4, -1.5), at(4, 1.5)});
    add({at(4, 1.5), at(2, 1.5)});
    add({at(2, 1.5), at(2, 0.5), at(1, 0.5)}, {1, 1, 2});
  }
  ba::Drawing_2<double> drawing;
  drawing.add(std::move(chain));
  return drawing;
}

TEST(SimpleOffsets, DoNotCrossWhereStripsVanishBetweenTheirEnds) {
  for (int k = 0; k < 24; ++k)
    for (const double eps : {1e-3, 1e-6}) {
      const ba::Offset offset = offset_curves(dumbbell(0.1 + 0.26 * k, {310.7, -802.1}), -0.5, within(eps));
      EXPECT_EQ(offset.status, ba::Offset::Status::COMPLETE);
      EXPECT_EQ(offset.chains.size(), 2U);
      EXPECT_TRUE(do_not_cross(offset.chains)) << k << " eps " << eps;
      EXPECT_TRUE(is_nested(offset.chains)) << k << " eps " << eps;
      EXPECT_LE(offset.error, eps);
    }
}

// The chains that closed curves made, or the others, as an offset of their own.
Chains chains_of(const ba::Offset& offset, const ba::Drawing_2<double>& drawing, bool is_closed) {
  Chains chains;
  std::vector<std::size_t> at(offset.chains.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    at[i] = chains.size();
    const auto& chain = offset.chains[i];
    if (drawing.curves()[chain.pieces.front().source.curve].is_closed == is_closed) chains.push_back(chain);
  }
  for (auto& chain : chains)
    if (chain.parent) chain.parent = at[*chain.parent];
  return chains;
}

// Whether each point is within eps of its distance; inwards, closed and open curves each by themselves.
bool is_at_distance(const ba::Drawing_2<double>& drawing, double d, double eps) {
  std::vector<ba::Drawing_2<double>> parts(2);
  for (const auto& curve : drawing.curves()) parts[d < 0 && !curve.is_closed].add(curve.beziers);
  for (const auto& part : parts)
    if (!part.curves().empty()) bounding_arcs_test::expect_at_distance(part, offset_curves(part, d, within(eps)), eps);
  return !testing::UnitTest::GetInstance()->ad_hoc_test_result().Failed();  // by now, of any file
}

int failures_of(const std::string& file) {
  const ba::Drawing_2<double> drawing = read(file);
  CGAL::Bbox_2 box;
  for (const auto& c : drawing.curves())
    for (const auto& b : c.beziers)
      for (const auto& p : b.control_points()) box += CGAL::Bbox_2(p.x, p.y, p.x, p.y);
  const double size = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  int failures = 0;
  for (const double eps : {1e-4, 1e-6}) {
    const ba::Offset_source_2 source = offset_source(drawing, within(eps * size));
    for (const double d : {0.01, -0.01, 0.05, -0.05, 0.2, -0.2}) {
      const ba::Offset offset = source.at(d * size);
      std::vector<Chains> parts{offset.chains};
      // inwards, closed curves and bands do not see each other
      if (d < 0) parts = {chains_of(offset, drawing, true), chains_of(offset, drawing, false)};
      const bool is_complete = offset.status == ba::Offset::Status::COMPLETE,
                 is_free = std::all_of(parts.begin(), parts.end(), do_not_cross),
                 is_sorted = std::all_of(parts.begin(), parts.end(), is_nested),
                 is_far = is_at_distance(drawing, d * size, eps * size);
      failures += is_complete && is_free && is_sorted && is_far ? 0 : 1;
      std::printf("%s: eps %g, distance %g, %zu chains:%s%s%s%s\n", file.c_str(), eps, d, offset.chains.size(),
                  is_complete ? "" : " not complete", is_free ? " simple" : " they cross",
                  is_sorted ? ", nested" : ", nested wrongly", is_far ? ", as far" : ", not as far");
      std::fflush(stdout);
    }
  }
  return failures;
}

}  // namespace
}  // namespace test_simple_offsets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (argc == 1) return RUN_ALL_TESTS();
  int failures = 0;
  for (int i = 1; i < argc; ++i) failures += test_simple_offsets::failures_of(argv[i]);
  return failures > 0;
}

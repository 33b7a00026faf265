// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Batches of up to 64 pieces: the same bits on every instruction set, and the same as of pieces by themselves.

#include "../../../src/library/tree/batch/Bca_batch.h"
#include "../../../src/library/tree/batch/Bilens_batch.h"
#include "../../../src/library/tree/batch/Piece_decisions.h"
#include "../../../src/library/tree/batch/Spiral_fat_arc_batch.h"
#include "../../../src/library/tree/batch/bound_batch.h"
#include "batch_families.h"
#include "bundled_spirals.h"
#include "trees.h"

#include <CGAL/Bounding_arcs_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <type_traits>
#include <vector>

namespace test_batches {
namespace {

using namespace bounding_arcs_test;
using Instruction_set = ba::Build_options::Instruction_set;
using ba::filter::Batch_decision;
using ba::filter::Batch_pieces;

constexpr unsigned SEED = 602;

template <class Construction> class Batches : public testing::Test {};
using Constructions = testing::Types<ba::Bca, ba::Bilens, ba::Spiral_fat_arc>;
TYPED_TEST_SUITE(Batches, Constructions);

struct Answer {
  Batch_decision decision;  // with upper bounds wanted, and
  Batch_decision quick;     // without
  double upper[ba::filter::BATCH_SIZE] = {};
};

template <class Construction>
Answer answer(Instruction_set set, const Spiral& spiral, const Batch_pieces& pieces, double eps) {
  Answer a;
  ba::Local_form<float> rough;
  const ba::Local_curve& local = spiral.local_curve();
  const bool is_rough = ba::filter::make_rough_form(local, rough);
  const ba::filter::Batch_curve curve{local, is_rough ? &rough : nullptr};
  const auto batch =
      ba::filter::Batch_functions::of<typename ba::filter::Formulas<Construction>::Type>(set).many(local.kind);
  a.decision = batch(curve, pieces, eps, a.upper);
  a.quick = batch(curve, pieces, eps, nullptr);
  return a;
}

// Calls a check with pieces of a segment and an eps about which their thicknesses lie.
template <class Construction, class Check> void for_batches(Check check) {
  std::mt19937 random(SEED);
  for (const Family family : ALL_FAMILIES)
    for (const Piece& piece : batch_pieces(family, SEED, 100)) {
      const std::size_t count = 1 + random() % ba::filter::BATCH_SIZE;
      const double first = piece.t0, last = piece.t1, step = (last - first) / static_cast<double>(count);
      if (!(first + step > first)) continue;
      const Batch_pieces pieces{count, nullptr, nullptr, first, step, last, 0};
      Answer a = answer<Construction>(Instruction_set::BASE, piece.spiral, pieces, 0);
      std::nth_element(a.upper, a.upper + count / 2, a.upper + count);
      if (!(a.upper[count / 2] < HUGE_VAL)) continue;  // most are left open
      SCOPED_TRACE(text(piece) + " in " + std::to_string(count));
      check(piece.spiral, pieces, a.upper[count / 2]);
    }
}

void expect_same(const Batch_decision& a, const Batch_decision& b) {
  EXPECT_EQ(a.within, b.within);
  EXPECT_EQ(a.above, b.above);
  EXPECT_EQ(a.largest, b.largest);
}
void expect_same(const Answer& a, const Answer& b, std::size_t count) {
  expect_same(a.decision, b.decision);
  expect_same(a.quick, b.quick);
  EXPECT_EQ(std::memcmp(a.upper, b.upper, count * sizeof(double)), 0);
}

// The sets of this machine and build, which may be BASE alone.
TYPED_TEST(Batches, AreTheSameBitsInAllInstructionSets) {
  for (const Instruction_set set : {Instruction_set::AVX2, Instruction_set::AVX512}) {
    if (!ba::Build_options::is_available(set)) continue;
    SCOPED_TRACE(static_cast<int>(set));
    for_batches<TypeParam>([&](const Spiral& spiral, const Batch_pieces& pieces, double eps) {
      expect_same(answer<TypeParam>(set, spiral, pieces, eps),
                  answer<TypeParam>(Instruction_set::BASE, spiral, pieces, eps), pieces.count);
    });
  }
}

TYPED_TEST(Batches, DecideAsTheBoundsOfSinglePiecesDo) {
  int within = 0, above = 0;
  for_batches<TypeParam>([&](const Spiral& spiral, const Batch_pieces& pieces, double eps) {
    const Answer all = answer<TypeParam>(Instruction_set::BEST, spiral, pieces, eps);
    const ba::Local_curve curve = spiral.local_curve();
    const auto of_one =
        ba::filter::Batch_functions::of<typename ba::filter::Formulas<TypeParam>::Type>(Instruction_set::BEST)
            .one(curve.kind);
    double largest = 0;
    for (std::size_t i = 0; i < pieces.count; ++i) {
      const double breaks[2] = {pieces.begin(static_cast<int>(i)), pieces.end(static_cast<int>(i))};
      const Answer one = answer<TypeParam>(Instruction_set::BEST, spiral, Batch_pieces::between(breaks, 1), eps);
      EXPECT_EQ(one.upper[0], all.upper[i]);
      const ba::Bracket bounds = of_one(curve, breaks[0], breaks[1], eps, false);
      if (all.upper[i] < HUGE_VAL) {
        EXPECT_EQ(bounds.upper, all.upper[i]);
      }
      const bool is_close = ba::filter::is_close(bounds.lower, bounds.upper);  // as upper bounds are wanted
      EXPECT_EQ(is_close && bounds.upper <= eps, (all.decision.within >> i & 1) != 0);
      EXPECT_EQ(is_close && bounds.lower > eps, (all.decision.above >> i & 1) != 0);
      EXPECT_EQ(one.decision.within, all.decision.within >> i & 1);
      EXPECT_EQ(one.decision.above, all.decision.above >> i & 1);
      EXPECT_EQ((all.decision.within >> i & 1) != 0, all.upper[i] <= eps);
      if (all.upper[i] <= eps) largest = (std::max)(largest, all.upper[i]);
      within += static_cast<int>(one.decision.within);
      above += static_cast<int>(one.decision.above);
    }
    EXPECT_EQ(all.decision.largest, largest);
    EXPECT_EQ(all.decision.within & all.decision.above, 0u);
  });
  EXPECT_GT(within, 1000);
  EXPECT_GT(above, 1000);
}

// Deciding in float first never decides otherwise, and where double does not either leaves nothing open that double
// decides.
TYPED_TEST(Batches, DecideTheSameWithoutUpperBounds) {
  int rough = 0;
  for_batches<TypeParam>([&](const Spiral& spiral, const Batch_pieces& pieces, double eps) {
    const Answer a = answer<TypeParam>(Instruction_set::BEST, spiral, pieces, eps);
    EXPECT_EQ(a.quick.within & a.decision.above, 0u);
    EXPECT_EQ(a.quick.above & a.decision.within, 0u);
    EXPECT_EQ((a.decision.within | a.decision.above) & ~(a.quick.within | a.quick.above), 0u);
    EXPECT_EQ((a.quick.within | a.quick.above) & ~pieces.all(), 0u);
    EXPECT_LE(a.quick.largest, eps);
    ba::Local_form<float> form;
    rough += ba::filter::make_rough_form(spiral.local_curve(), form) && pieces.may_be_rough() ? 1 : 0;
    for (std::size_t i = 0; i < pieces.count; ++i)
      if ((a.quick.within & a.decision.within) >> i & 1) {
        EXPECT_GE(a.quick.largest, a.upper[i] * (1 - 1e-6));
      }
  });
  EXPECT_GT(rough, 100);
}

// Also where eps in float is rounded up. An eps well above all thicknesses has them bounded in float, and is then put
// next to them.
TYPED_TEST(Batches, GiveNoLargerThicknessThanEps) {
  int many = 0;
  for_batches<TypeParam>([&](const Spiral& spiral, const Batch_pieces& pieces, double eps) {
    const double largest = answer<TypeParam>(Instruction_set::BEST, spiral, pieces, 16 * eps).quick.largest;
    for (int k = 0; k < 8; ++k) {
      const double near = largest * (1 - k * 0x1p-27);
      const Answer a = answer<TypeParam>(Instruction_set::BEST, spiral, pieces, near);
      EXPECT_LE(a.quick.largest, near);
      EXPECT_LE(a.decision.largest, near);
      many += a.quick.within != 0;
    }
  });
  EXPECT_GT(many, 1000);
}

// Segments of several kinds side by side, at an eps about which some of their pieces lie. A level is known where all
// its pieces can be decided, and where upper bounds are kept these have to be close.
TYPED_TEST(Batches, DecideFirstLevelsSideBySideAsPieceByPiece) {
  using Formula = typename ba::filter::Formulas<TypeParam>::Type;
  std::vector<Spiral> spirals;
  for (const Family family : ALL_FAMILIES)
    for (const Piece& piece : batch_pieces(family, SEED, 40)) spirals.push_back(piece.spiral);
  const auto add = [&](const Bezier& curve, double first, double last) {
    spirals.emplace_back(std::make_shared<const ba::Tabulated_bezier<double>>(curve), first, last, ba::End_orders{},
                         false);
  };
  for (int k = 0; k < 20; ++k) {  // nearly circles, whose thickness has few digits, and pieces thinner than can be had
    add(Bezier({{1, 0}, {1, 1}, {0, 1}}, {1, 1, 2 + std::ldexp(1.0, -20 - k)}), 0.1, 0.4);
    add(Bezier({{0, 0}, {1, 0}, {2, 1}, {2, 3}}), 0.25, 0.25 + std::ldexp(1.0, -10 - k));
  }
  std::mt19937 random(SEED);
  std::shuffle(spirals.begin(), spirals.end(), random);
  std::size_t levels = 0, above = 0, within = 0, unknown = 0, loose = 0, out_of_reach = 0;
  for (const Instruction_set set : {Instruction_set::BASE, Instruction_set::AVX2, Instruction_set::AVX512}) {
    if (!ba::Build_options::is_available(set)) continue;
    const auto functions = ba::filter::Batch_functions::of<Formula>(set);
    for (const double eps : {1e-2, 1e-4, 1e-6, 1e-12, 1e-30})
      for (const bool are_kept : {false, true}) {
        ba::filter::Look_ahead ahead;
        ahead.decide(functions, spirals.data(), spirals.size(), eps, are_kept);
        for (const Spiral& spiral : spirals) {
          const ba::filter::Segment_top top = ahead.top(spiral);
          const ba::internal::Spiral_grid grid(spiral.first(), spiral.last());
          const ba::Local_curve curve = spiral.local_curve();
          double largest = 0;
          std::uint64_t there = 1;
          for (int level = 0; level < top.levels(); ++level) {
            std::uint64_t halves = 0;
            for (std::uint64_t place = 0; there >> place != 0; ++place) {
              if ((there >> place & 1) == 0) continue;
              const ba::Bracket b = functions.one(curve.kind)(curve, grid.parameter(level, place),
                                                              grid.parameter(level, place + 1), eps, true);
              const bool is_above = (top.above(level) >> place & 1) != 0;
              EXPECT_EQ(is_above, b.lower > ba::internal::reachable(eps, spiral));
              EXPECT_TRUE(is_above || b.upper <= ba::internal::reachable(eps, spiral));
              EXPECT_EQ(top.thickness(level, place), b.upper);
              EXPECT_TRUE(!are_kept || ba::filter::is_close(b.lower, b.upper));
              loose += ba::filter::is_close(b.lower, b.upper) ? 0 : 1;
              out_of_reach += b.lower > eps && !is_above ? 1 : 0;
              if (!is_above) largest = (std::max)(largest, b.upper);
              if (is_above) halves |= std::uint64_t(3) << 2 * place;
              ++(is_above ? above : within);
            }
            EXPECT_EQ(top.above(level) & ~there, 0u);
            there = halves;
          }
          EXPECT_GE(top.largest(), largest);
          levels += static_cast<std::size_t>(top.levels());
          unknown += curve.kind != 0 && top.levels() == 0 ? 1 : 0;
        }
      }
  }
  EXPECT_GT(above, 1000u);
  EXPECT_GT(within, 1000u);
  EXPECT_GT(levels, spirals.size());
  EXPECT_GT(unknown, 0u) << "nothing is undecided";
  EXPECT_GT(loose, 0u) << "no bounds are loose where nobody keeps them";
  EXPECT_GT(out_of_reach, 0u) << "every eps is reachable";
}

// Where parameters have no room for more halvings. From its vertex on a parabola's pieces get thicker, the last most.
TEST(LevelStrategy, BoundsAllPiecesOfTheLastLevel) {
  const auto curve = std::make_shared<const ba::Tabulated_bezier<double>>(Bezier({{-1, 1}, {0, -1}, {1, 1}}));
  const Spiral spiral(curve, 0.5, 0.5 + 0x1p-46, {}, false);
  const int levels = ba::internal::Spiral_grid(spiral.first(), spiral.last()).levels();
  ASSERT_TRUE(levels > 3 && levels <= 6) << levels;  // a batch
  const ba::Bca_traits_2<Kernel> traits;
  const auto bound = traits.bound_thickness_2_object();
  const auto batches =
      ba::filter::Batch_functions::of<typename ba::filter::Formulas<ba::Bca>::Type>(Instruction_set::BEST);
  const ba::filter::Open_piece open = [&](double begin, double end, double eps) {
    return bound(ba::Piece_source<Spiral>{spiral, begin, end}, eps);
  };
  ba::filter::Piece_decisions decide(open, batches, spiral.local_curve());
  ASSERT_TRUE(decide.has_batches());
  ba::internal::Region_nodes nodes(false);
  ba::Decision_counts counts;
  constexpr double THIN = 1e-66;  // thinner than any piece, but not so thin that the whole is hopeless
  ba::filter::Level_strategy levels_of;
  const ba::filter::Segment_top nothing;
  static_cast<void>(levels_of.begin(nothing, nodes, counts));
  const ba::internal::Subdivision all = levels_of.finish(decide, nothing, THIN, 100000, nodes, counts);
  EXPECT_EQ(nodes.size(), (std::size_t(2) << levels) - 1);
  const double last = spiral.last(), before = last - (last - spiral.first()) / std::ldexp(1.0, levels);
  EXPECT_GE(all.bound, ba::Bca::thickness(spiral.shape<double>(before, last)) * (1 - 1e-9));
}

#ifndef BOUNDING_ARCS_WITHOUT_FILTER
// Bounds of whole segments are seldom close, but need not be where nobody keeps them.
TEST(LevelStrategy, LeavesFewPiecesOfBundledCurvesOpen) {
  using Traits = ba::Spiral_fat_arc_traits_2<Kernel>;
  std::size_t in_batches = 0, one_by_one = 0;
  for (const Bundled_curve& c : bundled_curves()) {
    const ba::Region_hierarchy_2<Traits, Spiral> tree(c.spirals, 1e-4);
    in_batches += tree.decisions().batch;
    one_by_one += tree.decisions().bounded + tree.decisions().exact;
  }
  EXPECT_GT(in_batches, 4000u);
  EXPECT_LT(one_by_one * 200, in_batches);
}
#endif

}  // namespace
}  // namespace test_batches

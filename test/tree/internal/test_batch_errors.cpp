// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether a batch's bounds hold for figures as wrong as their errors say, one figure after the other.  Errors of real
// segments are so small, and their bounds so safe, that a term left out of a formula's error would hardly ever be seen;
// here errors are as large as formulas serve, and figures are changed by as much.

#include "../../../src/library/tree/batch/Bca_batch.h"
#include "../../../src/library/tree/batch/Bilens_arcs.h"
#include "../../../src/library/tree/batch/Bilens_batch.h"
#include "../../../src/library/tree/batch/Spiral_fat_arc_arcs.h"
#include "../../../src/library/tree/batch/Spiral_fat_arc_batch.h"
#include "../../../src/library/tree/batch/bound_batch.h"
#include "batch_families.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include "../../../src/library/tree/batch/Batch_functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace test_batch_errors {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
using Precision = Local_precision<double>;
using Bounds = CGAL::Bounding_arcs::Bracket;

constexpr unsigned SEED = 607;
constexpr double SHARES[] = {0.5 / Precision::CERTAIN, 0x1p-6 / Precision::CERTAIN};  // of figures, by which they err
constexpr double ROOM = 1.001;  // errors are bounds, and products of them are rounded

struct Figures {
  Local_piece<double> piece;
  Local_ends<double> ends;
};
enum class Wrong { NUMERATOR, MEAN_RATE, TIGHT_RATE, FLAT_RATE, TIGHT_KNESER, FLAT_KNESER };
constexpr Wrong ALL_WRONG[] = {Wrong::NUMERATOR, Wrong::MEAN_RATE,    Wrong::TIGHT_RATE,
                               Wrong::FLAT_RATE, Wrong::TIGHT_KNESER, Wrong::FLAT_KNESER};

// Changes one figure, and sets the errors to what it is changed by.
Local_form<double> make_wrong(Figures& f, Wrong wrong, double share) {
  auto& [g, e] = f;
  Local_form<double> form;
  form.numerator_error =
      4 * Precision::HALF_ULP * (std::fabs(g.a * g.r) + std::fabs(g.d * g.p));  // where a or d change
  // those of crosses are beside dots what dots err by (Local_form)
  const auto set_rate_error = [&](double change) {
    form.turn_rate_error = ROOM * std::fabs(change);
    form.least_turn_rate = Precision::TURN_RATE_DIGITS * form.turn_rate_error;
    form.least_dot = Precision::DIGITS * g.half * form.turn_rate_error;
  };
  const auto change_kneser = [&](double& kneser) {
    form.kneser_error = ROOM * std::fabs(share) * kneser;
    kneser += share * kneser;
  };
  switch (wrong) {
    case Wrong::NUMERATOR: {  // N = a r + d p
      const double change = share * (g.a * g.r + g.d * g.p);
      form.numerator_error += ROOM * std::fabs(change);
      set_rate_error(g.half * change / g.p);
      g.d += change / g.p;
      break;
    }
    case Wrong::MEAN_RATE: {  // with d so that N is as it was
      const double change = share * g.a;
      set_rate_error(std::fabs(change) + std::fabs(g.half * g.r * change / g.p));
      g.a += change;
      g.d -= g.r * change / g.p;
      break;
    }
    case Wrong::TIGHT_RATE:
      set_rate_error(share * e.turn_rate0);
      e.turn_rate0 += share * e.turn_rate0;
      break;
    case Wrong::FLAT_RATE:
      set_rate_error(share * e.turn_rate1);
      e.turn_rate1 += share * e.turn_rate1;
      break;
    case Wrong::TIGHT_KNESER:
      change_kneser(e.kneser0);
      break;
    case Wrong::FLAT_KNESER:
      change_kneser(e.kneser1);
  }
  return form;
}

template <class Use> void for_figures(const Use& use) {
  for (const Family family : {Family::PLAIN, Family::NEAR_CIRCULAR, Family::NEAR_VERTEX, Family::RATIONAL})
    for (const Piece& piece : batch_pieces(family, SEED)) {
      const Local_curve& curve = piece.spiral.local_curve();
      const double half = 0.5 * (piece.t1 - piece.t0), tau = curve.direction * ((piece.t0 - curve.middle) + half);
      use(for_kind(curve.kind, [&](auto kind) {
        Figures f;
        f.piece = local_piece<kind()>(curve.form.coefficients, tau, half);
        f.ends = local_ends<kind()>(curve.form.coefficients, tau, f.piece);
        return f;
      }));
    }
}

template <class Construction> class Batch_errors : public testing::Test {};
using Constructions = testing::Types<Bca, Bilens, Spiral_fat_arc>;
TYPED_TEST_SUITE(Batch_errors, Constructions);

template <class Method, bool WIDE> std::map<Wrong, int> expect_held() {
  constexpr double ROUNDING = 1e-7;  // of bounds where nothing is wrong: 16 rho, 1e-9, in parts of figures that cancel
  std::map<Wrong, int> held;
  for_figures([&](const Figures& right) {
    for (const Wrong wrong : ALL_WRONG)
      for (const double share : {SHARES[0], -SHARES[0], SHARES[1], -SHARES[1]}) {
        Figures changed = right;
        const Local_form<double> form = make_wrong(changed, wrong, share);
        const Bounds b = filter::bound_figures<Method, WIDE>(form, right.piece, right.ends),
                     truth = filter::bound_figures<Method, WIDE>(Local_form<double>(), changed.piece, changed.ends);
        if (!(truth.upper < HUGE_VAL) || !(b.upper < HUGE_VAL || b.lower > 0)) continue;
        ++held[wrong];
        EXPECT_LE(truth.upper, b.upper * (1 + ROUNDING)) << static_cast<int>(wrong) << " " << share;
        EXPECT_GE(truth.upper, b.lower * (1 - ROUNDING)) << static_cast<int>(wrong) << " " << share;
      }
  });
  return held;
}

TYPED_TEST(Batch_errors, AreHeldByBoundsOfWidePieces) {
  const auto held = expect_held<typename filter::Formulas<TypeParam>::Type, true>();
  for (const Wrong wrong : ALL_WRONG) EXPECT_GT(held.at(wrong), 100) << static_cast<int>(wrong);
}
TYPED_TEST(Batch_errors, AreHeldByBoundsOfNarrowPieces) {
  const auto held = expect_held<typename filter::Formulas<TypeParam>::Type, false>();
  // a turn rate has all its digits there
  for (const Wrong wrong : {Wrong::TIGHT_KNESER, Wrong::FLAT_KNESER}) EXPECT_GT(held.at(wrong), 100);
}

// Signs, and digits of what is divided by, have to be certain even where there is all the room for errors.
template <class Arcs, bool WIDE> void expect_certain_arcs() {
  constexpr double ALL_ROOM = 1e100, HALF_OF_CERTAIN = 2 / Precision::CERTAIN;
  const auto holds = [](const Local_form<double>& form, const Figures& f) {
    if constexpr (filter::HAS_JOINTS<Arcs>) return Arcs::template of<WIDE>(form, f.piece, f.ends, ALL_ROOM).holds;
    else return Arcs::template of<WIDE>(form, f.piece, ALL_ROOM).holds;
  };
  int count = 0;
  for_figures([&](const Figures& f) {
    const auto& [g, e] = f;
    if (!holds({}, f)) return;
    ++count;
    Local_form<double> form;
    form.least_dot = 1.01 * std::min(g.p - g.half * g.r, g.p + g.half * g.r);
    EXPECT_FALSE(holds(form, f));
    form = {};
    form.least_square = 1.01 * g.chord_square;
    EXPECT_FALSE(holds(form, f));
    if constexpr (filter::HAS_JOINTS<Arcs>) {
      form = {};
      form.numerator_error = HALF_OF_CERTAIN * (g.a * g.r + g.d * g.p);
      EXPECT_FALSE(holds(form, f));
      form = {};
      form.kneser_error = HALF_OF_CERTAIN * std::min(e.kneser0, e.kneser1);
      EXPECT_FALSE(holds(form, f));
      form = {};
      form.least_tangent = 1.01 * std::min(e.square0, e.square1);
      EXPECT_FALSE(holds(form, f));
    }
    if constexpr (filter::FORM<Arcs> == Region_form::SPIRAL_FAT_ARC) {
      form = {};
      form.least_turn_rate = 1.01 * e.turn_rate0;
      EXPECT_FALSE(holds(form, f));
    }
  });
  EXPECT_GT(count, 100);
}

TYPED_TEST(Batch_errors, LeaveArcsOpenWhereSignsAreNotCertain) {
  using Arcs = typename filter::Formulas<TypeParam>::Arcs;
  expect_certain_arcs<Arcs, false>();
  expect_certain_arcs<Arcs, true>();
}

// How far the sides over the unit chord are apart in points of either.
double distance_of(const filter::Joint_side& a, const filter::Joint_side& b) {
  const auto arcs = [](const filter::Joint_side& s) {
    return std::array<Arc_2, 2>{Arc_2{{0, 0}, {s.x, s.y}, s.tight}, Arc_2{{s.x, s.y}, {1, 0}, s.flat}};
  };
  double most = 0;
  for (const auto& [from, to] : {std::pair(arcs(a), arcs(b)), std::pair(arcs(b), arcs(a))})
    for (const Arc_2& arc : from)
      for (int i = 0; i <= 8; ++i) {
        const Point p = point(arc, i / 8.0);
        most = std::max(most, std::min(std::fabs(signed_distance(p, to[0])), std::fabs(signed_distance(p, to[1]))));
      }
  return most;
}

// Arcs with joints are given away where there is room for what errors move their sides by, and no less.
template <class Arcs> void expect_room_for_errors() {
  constexpr double STEP = 1.25, LEAST = 0x1p-48, MOST = 0x1p-8;  // of the chord; roundings are far below
  std::map<Wrong, int> count;
  for_figures([&](const Figures& right) {
    const double chord = 2 * right.piece.half * std::sqrt(right.piece.chord_square);
    const auto arcs = [&](const Local_form<double>& form, const Figures& f, double room) {
      return Arcs::template of<true>(form, f.piece, f.ends, room * chord);
    };
    for (const Wrong wrong : ALL_WRONG)
      for (const double share : {SHARES[0], -SHARES[0]}) {
        Figures changed = right;
        const Local_form<double> form = make_wrong(changed, wrong, share);
        double room = LEAST;
        while (room < MOST && !arcs(form, right, room).holds) room *= STEP;
        if (room >= MOST || !arcs({}, changed, MOST).holds) continue;
        ++count[wrong];
        const std::pair a{arcs(form, right, room), arcs({}, changed, MOST)};
        const double moved =
            std::max(distance_of(a.first.inner, a.second.inner), distance_of(a.first.outer, a.second.outer));
        EXPECT_LE(moved, room + 0x1p-46) << static_cast<int>(wrong) << " " << share;
      }
  });
  for (const Wrong wrong : {Wrong::NUMERATOR, Wrong::TIGHT_KNESER, Wrong::FLAT_KNESER}) EXPECT_GT(count[wrong], 100);
}

TEST(BilensArcs, AreGivenWhereThereIsRoomForErrors) { expect_room_for_errors<filter::Bilens_arcs>(); }
TEST(SpiralFatArcArcs, AreGivenWhereThereIsRoomForErrors) { expect_room_for_errors<filter::Spiral_fat_arc_arcs>(); }

}  // namespace
}  // namespace test_batch_errors

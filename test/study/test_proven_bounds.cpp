// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What Gappa has proven holds on random spirals: so hypotheses of hint files, which it takes as they are, are true
// there. The worst errors are properties of the test's report.

#include "frame_figures.h"
#include "proven_goals.h"

#include "cases.h"
#include "random_spirals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace test_proven_bounds {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;

constexpr unsigned SEED = 20261121;

Chord_shape_2<long double> exact_shape(const Piece& p) {
  return convert_shape<long double>(p.spiral.shape<Exact>(p.t0, p.t1, {true, false}), [](const Exact& x) {
    const Double_double d = to_double_double(x);
    return static_cast<long double>(d.hi) + d.lo;
  });
}

TEST(ProvenBounds, HoldOnRandomSpirals) {
  const std::map<std::string, Goal> goals = proven_goals();
  std::map<std::string, double> worst;
  for (const Piece& piece : random_pieces(SEED, static_cast<std::size_t>(cases(3000)), 12)) {
    const auto f = piece.spiral.accurate_shape(piece.t0, piece.t1, {true, false});
    if (!f.proper || !f.tight_first || f.infinite0 || !f.turns_one_way) continue;
    const auto rounded = frame_figures(f);
    const auto exact = frame_figures(exact_shape(piece));
    for (const auto& [name, x] : rounded) {
      const auto goal = goals.find(name);
      if (goal == goals.end()) continue;
      const Figure<long double>& y = exact.at(name);
      const long double off = std::fabs(x.value - y.value) / (goal->second.is_relative ? std::fabs(y.size) : 1);
      const auto in_u = static_cast<double>(off / HALF_ULP);
      EXPECT_LE(in_u, goal->second.bound) << name << " of " << piece;
      worst[name] = std::max(worst[name], in_u);
    }
  }
  for (const auto& [name, u] : worst) {
    RecordProperty(name, std::to_string(u) + " of " + std::to_string(goals.at(name).bound));
    std::cout << name << ' ' << u << ' ' << goals.at(name).bound << '\n';
  }
}

}  // namespace
}  // namespace test_proven_bounds

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs of meetings beside the plain way, and how many meetings are looked at for each.

#include "../../../src/library/overlay/Meeting_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace test_meeting_places {
namespace {

using CGAL::Bounding_arcs::Bracket;
using CGAL::Bounding_arcs::internal::Meeting;
using CGAL::Bounding_arcs::internal::Meeting_runs;

constexpr std::size_t COUNT = 10000, MOST_BESIDE = 4;

/// Groups of meetings of two pieces each, next to each other on the first one; pieces have some groups. A bracket may
/// reach over others, which do not touch each other.
std::vector<Meeting> meetings(std::mt19937& random) {
  std::vector<Meeting> all;
  const auto after = [](double t, unsigned steps) {
    for (; steps > 0; --steps) t = std::nextafter(t, 2);
    return t;
  };
  const auto below = [&random](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  constexpr std::uint32_t PIECES = 30, PLACES = 64;
  std::set<std::array<std::uint32_t, 3>> used;
  while (all.size() < COUNT) {
    const std::array<std::uint32_t, 3> group{below(PIECES), below(PIECES), below(PLACES)};
    if (!used.insert(group).second) continue;
    const double t = group[2] / double(PLACES);
    const std::size_t size = 1 + below(MOST_BESIDE);
    const Bracket wide{t, after(t, 2)}, low{t, t}, high{after(t, 2), after(t, 2)}, middle{after(t, 1), after(t, 1)};
    const std::array<Bracket, MOST_BESIDE> brackets{wide, low, high, middle};
    for (std::size_t i = 0; i < size; ++i) all.push_back({{group[0], group[1]}, {brackets[i], {0.25, 0.75}}});
  }
  std::shuffle(all.begin(), all.end(), random);
  return all;
}

}  // namespace

TEST(MeetingRuns, HoldWhatTouchesAndLittleElse) {
  std::mt19937 random(1);
  const std::vector<Meeting> all = meetings(random);
  const Meeting_runs runs(all, all.size());
  std::size_t looked_at = 0;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    std::set<std::uint32_t> run;
    for (const std::uint32_t m : runs.run_of(i)) run.insert(m);
    looked_at += run.size();
    ASSERT_TRUE(run.count(i) == 1 && run.size() <= MOST_BESIDE);
    for (std::uint32_t j = 0; j < all.size(); ++j) {
      const bool touches = all[i].bezier == all[j].bezier && all[i].t[0].touches(all[j].t[0]);
      ASSERT_TRUE(!touches || run.count(j) == 1);
    }
  }
  EXPECT_LE(looked_at, MOST_BESIDE * all.size());
}

// Ends of overlaps are in no run.
TEST(MeetingRuns, HoldThoseThatAreCountedAlone) {
  const std::vector<Meeting> all(3, {{0, 1}, {Bracket{0.5, 0.5}, Bracket{0.5, 0.5}}});
  const Meeting_runs runs(all, 2);
  const auto run = runs.run_of(1);
  EXPECT_EQ(std::vector<std::uint32_t>(run.begin(), run.end()), (std::vector<std::uint32_t>{0, 1}));
}

}  // namespace test_meeting_places

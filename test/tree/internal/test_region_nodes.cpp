// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nodes packed into words, against the same ones kept one by one: whatever their number and place, each has the bit and
// the thickness it was given, and the number of split ones before it. The parameters of halves.

#include "cases.h"

#include <CGAL/Bounding_arcs_2/tree/Region_nodes.h>
#include <CGAL/Bounding_arcs_2/tree/Spiral_grid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace test_region_nodes {
namespace {

using bounding_arcs_test::FEW_CASES;
using CGAL::Bounding_arcs::internal::Region_nodes;

/// Nodes and what they should be.
class Checked_nodes {
 public:
  explicit Checked_nodes(bool keeps_thickness) : nodes_(keeps_thickness) {}

  void append_random(std::size_t count) {
    std::uint64_t split = 0;
    std::vector<double> thickness;
    for (std::size_t i = 0; i < count; ++i) {
      const bool bit = random_() % 3 != 0;
      split |= std::uint64_t(bit) << i;
      add(bit, static_cast<double>(random_()));
      thickness.push_back(thickness_.back());
    }
    nodes_.append(thickness.data(), split, count);
  }
  // By 61, so that words are filled at every place.
  void append_many(std::size_t count) {
    for (; count > 0; count -= (std::min<std::size_t>)(count, 61)) append_random((std::min<std::size_t>)(count, 61));
  }
  void append_none(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) add(false, 0);
    nodes_.append(nullptr, 0, count);
  }
  void append_split(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) add(true, 0);
    for (; count > 64; count -= 64) nodes_.append(nullptr, ~std::uint64_t(0), 64);
    nodes_.append(nullptr, ~std::uint64_t(0) >> (64 - count), count);
  }
  void append(const Checked_nodes& other, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) add(other.split_[i], other.thickness_[i]);
    nodes_.append(other.nodes_, begin, end);
  }
  template <class ConcurrencyTag> void append_all(const std::vector<Checked_nodes>& others) {
    const std::vector<std::size_t> begins = nodes_.append_all<ConcurrencyTag>(
        others.size(), [&](std::size_t i) -> const Region_nodes& { return others[i].nodes_; });
    ASSERT_EQ(begins.size(), others.size() + 1);
    for (std::size_t i = 0; i < others.size(); ++i) {
      EXPECT_EQ(begins[i], split_.size());
      for (std::size_t j = 0; j < others[i].split_.size(); ++j) add(others[i].split_[j], others[i].thickness_[j]);
    }
    EXPECT_EQ(begins.back(), split_.size());
  }
  template <class ConcurrencyTag = CGAL::Sequential_tag> void expect_kept() {
    ASSERT_EQ(nodes_.size(), split_.size());
    nodes_.complete();
    std::size_t splits = 0;
    for (std::size_t i = 0; i < split_.size(); ++i) {
      ASSERT_EQ(nodes_.is_split(i), split_[i]) << "node " << i << " of " << split_.size();
      ASSERT_EQ(nodes_.splits_before(i), splits) << "node " << i << " of " << split_.size();
      if (nodes_.keeps_thickness()) {
        ASSERT_EQ(nodes_.thickness(i), thickness_[i]);
      }
      splits += split_[i];
    }
  }

 private:
  void add(bool split, double thickness) {
    split_.push_back(split);
    thickness_.push_back(thickness);
  }

  std::mt19937_64 random_{31};
  Region_nodes nodes_;
  std::vector<bool> split_;
  std::vector<double> thickness_;
};

TEST(RegionNodes, KeepEachNodeOfEveryShortRow) {
  for (std::size_t first = 1; first <= 64; ++first)
    for (const std::size_t second : {1u, 2u, 31u, 63u, 64u}) {
      Checked_nodes nodes(true);
      for (const std::size_t count : {first, second, first, second}) nodes.append_random(count);
      nodes.expect_kept();
    }
}

TEST(RegionNodes, KeepManySplitOnes) {
  for (std::size_t first = 1; first <= 64; ++first)
    for (const std::size_t count : {1u, 63u, 64u, 65u, 1000u}) {
      Checked_nodes nodes(false);
      nodes.append_random(first);
      nodes.append_split(count);
      nodes.append_random(7);
      nodes.expect_kept();
    }
}

TEST(RegionNodes, TakePartsOfOthers) {
  Checked_nodes other(true);
  for (const std::size_t count : {64u, 1u, 64u, 50u, 64u, 64u, 13u, 64u}) other.append_random(count);
  const std::size_t size = 384;  // six words and no bit more
  for (const bool keeps_thickness : {true, false})
    for (std::size_t before = 0; before <= 64; before += 4)
      for (const std::size_t begin : {0u, 1u, 63u, 64u, 65u, 383u})
        for (const std::size_t end :
             {std::size_t(0), begin, begin + 1, begin + 63, begin + 64, begin + 65, size - 1, size}) {
          if (end < begin || end > size) continue;
          Checked_nodes nodes(keeps_thickness);
          if (before > 0) nodes.append_random(before);
          nodes.append(other, begin, end);
          nodes.append_random(5);
          nodes.expect_kept();
        }
}

template <class ConcurrencyTag> void expect_all_of_many() {
  std::mt19937 random(32);
  std::vector<Checked_nodes> others;
  for (int i = 0; i < 700; ++i) {  // mostly less than a word, some empty, a few long
    others.emplace_back(true);
    const std::size_t size = random() % 10 == 0 ? random() % 900 : random() % 30;
    for (std::size_t made = 0; made < size; made += 60)
      others.back().append_random((std::min<std::size_t>)(size - made, 60));
  }
  for (const bool keeps_thickness : {true, false})
    for (const std::size_t before : {0u, 1u, 63u, 64u}) {
      Checked_nodes nodes(keeps_thickness);
      if (before > 0) nodes.append_random(before);
      nodes.append_all<ConcurrencyTag>(others);
      nodes.expect_kept<ConcurrencyTag>();
      nodes.append_random(5);
      nodes.expect_kept();
    }
}
TEST(RegionNodes, TakeAllOfManyOthers) { expect_all_of_many<CGAL::Sequential_tag>(); }
#ifdef CGAL_LINKED_WITH_TBB
TEST(RegionNodes, TakeAllOfManyOthersInParallel) { expect_all_of_many<CGAL::Parallel_tag>(); }
#endif

// Ranks are summed up range by range; sizes about the ends of ranges and past several of them.
template <class ConcurrencyTag> void expect_ranks_of_many() {
  for (const std::size_t size : {32767u, 32768u, 32769u, 65535u, 65536u, 65537u, 98304u, 98305u, 200003u}) {
    SCOPED_TRACE(size);
    Checked_nodes nodes(false);
    nodes.append_many(size);
    nodes.expect_kept<ConcurrencyTag>();
  }
  Checked_nodes nodes(false);  // a range without any between ranges that are all split
  nodes.append_split(40001);
  for (int i = 0; i < 700; ++i) nodes.append_none(63);
  nodes.append_split(70000);
  nodes.expect_kept<ConcurrencyTag>();
}
TEST(RegionNodes, CountSplitOnesBeforeAnyOfManyNodes) { expect_ranks_of_many<CGAL::Sequential_tag>(); }
#ifdef CGAL_LINKED_WITH_TBB
TEST(RegionNodes, CountSplitOnesBeforeAnyOfManyNodesInParallel) { expect_ranks_of_many<CGAL::Parallel_tag>(); }
#endif

TEST(RegionNodes, TakeLongPartsOfOthersAtOddPlaces) {
  Checked_nodes other(true);
  other.append_many(150001);
  for (const bool keeps_thickness : {true, false})
    for (const std::size_t before : {1u, 37u, 63u, 64u, 129u}) {
      if (FEW_CASES && before != 37) continue;
      for (const std::size_t begin : {1u, 63u, 12345u, 70003u}) {
        if (FEW_CASES && begin < 12345) continue;
        for (const std::size_t end : {70067u, 137777u, 150001u}) {
          SCOPED_TRACE(testing::Message() << begin << " to " << end << " after " << before);
          Checked_nodes nodes(keeps_thickness);
          nodes.append_many(before);
          nodes.append(other, begin, end);
          nodes.append(other, end - 1, end);
          nodes.append(other, begin, begin + 65);
          ASSERT_NO_FATAL_FAILURE(nodes.expect_kept());
        }
      }
    }
}

template <class ConcurrencyTag> void expect_all_of_long_ones() {
  std::vector<Checked_nodes> others;
  for (const std::size_t size : {70001u, 0u, 3u, 65537u, 32768u, 1u, 40003u}) {
    others.emplace_back(true);
    others.back().append_many(size);
  }
  for (const bool keeps_thickness : {true, false}) {
    Checked_nodes nodes(keeps_thickness);
    nodes.append_many(41);
    nodes.append_all<ConcurrencyTag>(others);
    nodes.expect_kept<ConcurrencyTag>();
  }
}
TEST(RegionNodes, TakeAllOfLongOthers) { expect_all_of_long_ones<CGAL::Sequential_tag>(); }
#ifdef CGAL_LINKED_WITH_TBB
TEST(RegionNodes, TakeAllOfLongOthersInParallel) { expect_all_of_long_ones<CGAL::Parallel_tag>(); }
#endif

TEST(RegionNodes, HaveNoRankLeftFromBefore) {
  Checked_nodes nodes(false);
  for (int i = 0; i < 40; ++i) {
    nodes.append_random(61);
    nodes.expect_kept();
  }
}

// Also where the difference of both ends is rounded down, and from their sum they are not had back.
TEST(SpiralGrid, EndsWhereTheSegmentDoes) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit;
  int rounded = 0;
  for (int i = 0; i < 1000; ++i) {
    const double first = unit(random) / 2, last = (1 + unit(random)) / 2;
    const CGAL::Bounding_arcs::internal::Spiral_grid grid(first, last);
    rounded += first + (last - first) < last;
    for (int level = 0; level <= grid.levels(); ++level) {
      EXPECT_EQ(grid.parameter(level, 0), first);
      EXPECT_EQ(grid.parameter(level, std::uint64_t(1) << level), last) << level;
      EXPECT_LT(grid.parameter(level, (std::uint64_t(1) << level) - 1), last) << level;
    }
  }
  EXPECT_GT(rounded, 0);
}

}  // namespace
}  // namespace test_region_nodes

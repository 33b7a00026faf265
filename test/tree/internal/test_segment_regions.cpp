// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Regions of a segment by itself, and of segments side by side.

#include "cases.h"
#include "trees.h"
#include "various_spirals.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/tree/Region_columns.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Segment_regions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace test_segment_regions {
namespace {

using namespace bounding_arcs_test;
using Instruction_set = ba::Build_options::Instruction_set;
using ba::Region_columns;
using ba::internal::Region_source;
using ba::internal::Segment_regions;

template <class Traits> class SegmentRegions : public testing::Test {};
using All = testing::Types<ba::Bca_traits_2<Kernel>, ba::Spiral_fat_arc_traits_2<Kernel>, ba::Bilens_traits_2<Kernel>>;
TYPED_TEST_SUITE(SegmentRegions, All);

// Segments of few leaves are made side by side with others, and are to have the bits that they have by themselves:
// whatever their neighbours, and whichever of them a lane is left to.
TYPED_TEST(SegmentRegions, AreTheSameBitsSideBySideAsOneByOne) {
  std::size_t few = 0, many = 0, coarse = 0;
  const auto spirals = various_spirals(7, 40);
  for (const double eps : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
    if (bounding_arcs_test::FEW_CASES && eps < 1e-2) break;
    const ba::Region_hierarchy_2<TypeParam, Spiral> tree(spirals, eps);
    Region_columns all;
    make_regions(tree, all);
    Region_columns one = all;
    Segment_regions regions(Region_source(tree.traits().construction(), tree.spirals(), Instruction_set::BEST));
    regions.resize(one, all.t.size() + Segment_regions::PADDING);
    for (auto* column : {&one.x, &one.y, &one.inner.bulge, &one.outer.bulge})
      std::fill(column->begin(), column->end(), -7);
    for (std::size_t i = 0; i < tree.spirals().size(); ++i) {
      const std::size_t row = all.first[i], count = all.first[i + 1] - row - 1;
      regions.open(i, count == 1);
      EXPECT_EQ(regions.make(one, row, count), all.widening[i]);
      const auto expect_same = [&](const std::vector<double>& a, const std::vector<double>& b) {
        for (std::size_t j = row; !a.empty() && j <= row + count; ++j)
          if (a[j] != b[j]) ADD_FAILURE() << i << " of " << count << ": " << a[j] << " and " << b[j];
      };
      expect_same(all.x, one.x);
      expect_same(all.y, one.y);
      for (const auto side : {&Region_columns::inner, &Region_columns::outer})
        for (const auto column : {&ba::Region_columns::Side::bulge, &ba::Region_columns::Side::joint_x,
                                  &ba::Region_columns::Side::joint_y, &ba::Region_columns::Side::second_bulge})
          expect_same((all.*side).*column, (one.*side).*column);
      ++(count <= 2 ? few : many);
      coarse += all.widening[i] > 64 * ba::ulp_of(tree.spirals()[i].coordinate_size()) ? 1 : 0;
    }
  }
  EXPECT_GT(few, 100u);
  EXPECT_GT(many, 100u);
  EXPECT_GT(coarse, 0u);
}

}  // namespace
}  // namespace test_segment_regions

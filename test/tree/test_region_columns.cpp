// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Regions in hand: a row a leaf in curve order, points that neighbours share, the same bits on every instruction set,
// and regions that hold the exact curve within their widening.

#include "bundled_spirals.h"
#include "cases.h"
#include "degenerate_curves.h"
#include "trees.h"
#include "various_spirals.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/tree/Region_columns.h>
#include <CGAL/Bounding_arcs_2/verify/outside_bound.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <random>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace test_region_columns {
namespace {

using namespace bounding_arcs_test;
using ba::Build_options;
using Instruction_set = ba::Build_options::Instruction_set;
using ba::Node_handle;
using ba::Region_columns;

template <class Traits> using Tree = ba::Region_hierarchy_2<Traits, Spiral>;

template <class Traits>
Region_columns regions_of(const Tree<Traits>& tree, Instruction_set set = Instruction_set::BEST) {
  Region_columns columns;
  make_regions(tree, columns, set);
  return columns;
}

template <class Traits> class Regions : public testing::Test {};
using All = testing::Types<ba::Bca_traits_2<Kernel>, ba::Spiral_fat_arc_traits_2<Kernel>, ba::Bilens_traits_2<Kernel>>;
TYPED_TEST_SUITE(Regions, All);

TYPED_TEST(Regions, HaveARowALeafInCurveOrder) {
  for (const Build_options::Nodes kind : {Build_options::Nodes::STORED, Build_options::Nodes::EQUALIZED})
    for (const double eps : {1e-1, 1e-4}) {
      const Tree<TypeParam> tree(various_spirals(1, 12), eps, nodes_of_kind(kind));
      const Region_columns columns = regions_of(tree);
      EXPECT_EQ(columns.number_of_regions(), tree.number_of_leaves());
      std::size_t row = 0, segment = 0;
      tree.for_each_leaf([&](const Node_handle& h) {
        const ba::Region_node node = tree.node(h);
        if (node.spiral != segment) {
          ++row;  // the end of the segment before
          ++segment;
        }
        ASSERT_EQ(columns.first[segment + 1] > row, true);
        EXPECT_EQ(columns.t[row], node.t0);
        EXPECT_EQ(columns.t[row + 1], node.t1);
        ++row;
      });
      EXPECT_EQ(row + 1, columns.first.back());
    }
}

TYPED_TEST(Regions, MeetInTheSamePoints) {
  std::mt19937 random(2);
  for (int degree = 2; degree <= 7; ++degree) {
    const Bezier curve = random_curve(random, degree, false);
    const Tree<TypeParam> tree(ba::spiral_segments(curve), 1e-3);
    const Region_columns columns = regions_of(tree);
    const std::size_t segments = tree.spirals().size();
    EXPECT_EQ((Point{columns.x[0], columns.y[0]}), curve.control_points().front());
    EXPECT_EQ((Point{columns.x.back(), columns.y.back()}), curve.control_points().back());
    for (std::size_t i = 1; i < segments; ++i) {
      const std::size_t row = columns.first[i];
      EXPECT_EQ((Point{columns.x[row - 1], columns.y[row - 1]}), (Point{columns.x[row], columns.y[row]})) << degree;
    }
  }
}

TYPED_TEST(Regions, AreTheSameBitsOnEveryInstructionSet) {
  const Tree<TypeParam> tree(various_spirals(3, 20), 1e-5);
  const Region_columns base = regions_of(tree, Instruction_set::BASE);
  for (const Instruction_set set : {Instruction_set::AVX2, Instruction_set::AVX512}) {
    const Region_columns other = regions_of(tree, set);
    EXPECT_EQ(base.x, other.x);
    EXPECT_EQ(base.y, other.y);
    for (const auto side : {&Region_columns::inner, &Region_columns::outer})
      for (const auto column : {&ba::Region_columns::Side::bulge, &ba::Region_columns::Side::joint_x,
                                &ba::Region_columns::Side::joint_y, &ba::Region_columns::Side::second_bulge})
        EXPECT_EQ((base.*side).*column, (other.*side).*column);
  }
}

// The proof of every region, and how many there were.
template <class Traits> std::size_t expect_all_proven(const std::vector<Spiral>& spirals, double eps) {
  const Tree<Traits> tree(spirals, eps);
  const Region_columns columns = regions_of(tree);
  for (std::size_t i = 0; i < spirals.size(); ++i)
    for (std::size_t row = columns.first[i]; row + 1 < columns.first[i + 1]; ++row) {
      const auto boundary = boundary_of(columns.region(row));
      const double widening = columns.widening[i];
      EXPECT_TRUE(ba::is_within(spirals[i], columns.t[row], columns.t[row + 1], boundary, widening))
          << text(Piece{spirals[i], columns.t[row], columns.t[row + 1]}) << ", segment [" << spirals[i].first() << ", "
          << spirals[i].last() << "], widening " << widening << ", needed "
          << ba::outside_bound(spirals[i], columns.t[row], columns.t[row + 1], boundary, widening);
    }
  return columns.number_of_regions();
}

TYPED_TEST(Regions, HoldTheExactCurveWithinTheirWidening) {
  for (const double eps : {1e-1, 1e-3, 1e-6}) {
    const std::vector<Spiral> spirals = various_spirals(static_cast<unsigned>(eps * 1e7), cases(eps < 1e-5 ? 6 : 40));
    EXPECT_GE(expect_all_proven<TypeParam>(spirals, eps), spirals.size());
  }
}

#ifndef BOUNDING_ARCS_WITHOUT_FILTER
// Eight ulp of the largest coordinate. Pieces as long as whole drawings take some more where sides have joints.
TYPED_TEST(Regions, OfTheBundledCurvesAreWithinEightUlp) {
  const double eps = std::is_same_v<TypeParam, ba::Bca_traits_2<Kernel>> ? 1e-4 : 1e-6;
  for (const Bundled_curve& curve : bundled_curves()) {
    const Region_columns columns = regions_of(Tree<TypeParam>(curve.spirals, eps));
    std::size_t wider = 0;
    for (std::size_t i = 0; i < curve.spirals.size(); ++i) {
      const double size = curve.spirals[i].coordinate_size(), ulp = std::nextafter(size, HUGE_VAL) - size;
      EXPECT_GE(columns.widening[i], 8 * ulp);
      EXPECT_LE(columns.widening[i], 12 * ulp);
      wider += columns.widening[i] != 8 * ulp;
    }
    EXPECT_LE(wider, columns.inner.joint_x.empty() ? 0u : 2u) << curve.name;
    expect_all_proven<TypeParam>(curve.spirals, 1e-3);
  }
}

// Where error bounds of coarse pieces need more than eight ulp there is room for 64 more, and few are left for single
// ones.
TEST(CoarseRegions, HaveASecondRoom) {
  std::size_t wide = 0;
  for (const Bundled_curve& curve : bundled_curves()) {
    const Region_columns columns = regions_of(Tree<ba::Spiral_fat_arc_traits_2<Kernel>>(curve.spirals, 1e-3));
    for (std::size_t i = 0; i < curve.spirals.size(); ++i) {
      const double size = curve.spirals[i].coordinate_size(), ulp = std::nextafter(size, HUGE_VAL) - size;
      EXPECT_LE(columns.widening[i], 76 * ulp);
      wide += columns.widening[i] >= 72 * ulp;
    }
  }
  EXPECT_GE(wide, 100U);
}

// Of cusps, folds and thin curves, wherever the region made by itself is proven: cuts at a vertex where curvature
// changes quickly leave pieces that are not.
TYPED_TEST(Regions, OfDegenerateCurvesHoldThemWhereSingleOnesDo) {
  std::size_t proven = 0;
  for (const Kind kind : {Kind::PALINDROME, Kind::NEAR_CUSP, Kind::THIN}) {
    Degenerate_curves curves(7);
    for (int i = 0; i < 16; ++i) {
      const Bezier curve = curves(kind);
      const Tree<TypeParam> tree(ba::spiral_segments(curve), curves.eps(curve));
      const Region_columns batches = regions_of(tree), singles = regions_of(tree, Instruction_set::NONE);
      for (std::size_t j = 0; j < tree.spirals().size(); ++j)
        for (std::size_t row = batches.first[j]; row + 1 < batches.first[j + 1]; ++row) {
          if (batches.outer.bulge[row] == singles.outer.bulge[row]) continue;  // not from a batch
          const auto is_within = [&](const Region_columns& columns) {
            return ba::is_within(tree.spirals()[j], columns.t[row], columns.t[row + 1],
                                 boundary_of(columns.region(row)), columns.widening[j]);
          };
          if (!is_within(singles)) continue;
          EXPECT_TRUE(is_within(batches)) << name(kind) << ' ' << i << ", row " << row;
          ++proven;
        }
    }
  }
  EXPECT_GT(proven, 20u);
}

// How far two sides over nearly the same ends are from each other, at most.
double distance(const ba::Arc_region_2& a, const ba::Arc_region_2& b, ba::Arc_region_2::Side ba::Arc_region_2::*side) {
  const auto length = [](const Point& v) { return std::hypot(v.x, v.y); };
  const ba::Arc_region_2::Side &p = a.*side, &q = b.*side;
  EXPECT_EQ(p.size, q.size);
  double most = (std::max)(length(a.from - b.from), length(a.to - b.to));
  const Point ends[] = {a.from, p.size == 2 ? p.joint : a.to, a.to};
  if (p.size == 2) most = (std::max)(most, length(p.joint - q.joint));
  double bent = 0;
  for (std::size_t i = 0; i < p.size; ++i)
    bent = (std::max)(bent, length(ends[i + 1] - ends[i]) / 2 * std::fabs(p.bulges[i] - q.bulges[i]));
  return most + bent;
}

TYPED_TEST(Regions, AreWhatSinglePiecesGive) {
  for (const double eps : {1e-2, 1e-4, 1e-7}) {
    const std::vector<Spiral> spirals = various_spirals(5, eps < 1e-5 ? cases(10) : 30);
    const Tree<TypeParam> tree(spirals, eps);
    const Region_columns batches = regions_of(tree), singles = regions_of(tree, Instruction_set::NONE);
    EXPECT_EQ(batches.form, singles.form);
    std::size_t other = 0;
    for (std::size_t i = 0; i < spirals.size(); ++i)
      for (std::size_t row = batches.first[i]; row + 1 < batches.first[i + 1]; ++row) {
        const ba::Arc_region_2 a = batches.region(row), b = singles.region(row);
        const double most = batches.widening[i] + singles.widening[i];
        EXPECT_LE(distance(a, b, &ba::Arc_region_2::inner), most);
        EXPECT_LE(distance(a, b, &ba::Arc_region_2::outer), most);
        other += a.outer.bulges[0] != b.outer.bulges[0] || a.outer.joint.x != b.outer.joint.x;
      }
    EXPECT_GT(other, batches.number_of_regions() / 10) << "batches made none of them";
  }
}
#endif

// The inner side ends in an arc of 1e-13 of its length, from which its ends, but not its tangents, tell nothing.
TEST(ArcRegion, KeepsTheBulgeOfATinyArcBesideASegment) {
  const std::vector<Point> control{{0, 0}, {1e-7, 0}, {1, 1}, {3, 4}};
  const auto region_of = [](const std::vector<Point>& points) {
    const std::vector<Spiral> spirals = ba::spiral_segments(Bezier(points));
    EXPECT_EQ(spirals.size(), 1u);
    return arc_region(ba::Spiral_fat_arc(), spirals[0], 0, 1, points.front(), points.back());
  };
  const ba::Arc_region_2 forth = region_of(control), back = region_of({control.rbegin(), control.rend()});
  ASSERT_EQ(forth.form, ba::Region_form::SPIRAL_FAT_ARC);
  const double expected = std::tan(std::atan2(4, 3) / 4);  // from the tangent to the other end
  EXPECT_NEAR(forth.inner.bulges[0], expected, 1e-12);
  EXPECT_NEAR(back.inner.bulges[1], -expected, 1e-12);
  EXPECT_EQ(forth.inner.bulges[1], 0);
  EXPECT_EQ(back.inner.bulges[0], 0);
}

// Where products of differences leave the range of doubles a region is made in more bits: a BCA over the chord would be
// up to half as thick as that is long.
template <class Traits> void expect_thin(const Bezier& curve, double eps) {
  const Tree<Traits> tree(ba::spiral_segments(curve), eps);
  const Region_columns columns = regions_of(tree);
  std::size_t leaf = 0;
  tree.for_each_leaf([&](const Node_handle& h) {
    const std::uint32_t spiral = tree.node(h).spiral;
    const ba::Arc_region_2 r = columns.region(leaf++ + spiral, spiral);  // a row more a segment, for its end
    EXPECT_TRUE(r.is_finite());
    if (r.inner.size == 2 || r.outer.size == 2) return;
    const double thickness = std::hypot(r.to.x - r.from.x, r.to.y - r.from.y) / 2 *
                             std::fabs(r.inner.bulges[0] - r.outer.bulges[0]);  // in the middle
    EXPECT_LE(thickness, eps * (1 + 0x1p-40)) << text(Piece{tree.spirals()[spiral], columns.t[leaf - 1 + spiral], 1});
  });
}

TEST(ArcRegion, IsThinWhereOneEndIsManyTimesAsLongAsTheOther) {
  const auto expect_all_thin = [](const Bezier& curve, double eps) {
    expect_thin<ba::Spiral_fat_arc_traits_2<Kernel>>(curve, eps);
    expect_thin<ba::Bilens_traits_2<Kernel>>(curve, eps);
  };
  expect_all_thin(Bezier({{1, 1e-155}, {5e-156, 1e-150}, {3e-161, 1e-155}, {0, 0}}), 1e-3);
  expect_all_thin(Bezier({{0, 1e-40}, {3.4e-41, 1e-60}, {1e-55, 0}, {1e91, -1e-40}, {-1e-50, -1e100}}), 1e94);
  constexpr double SIZES[] = {1, 1, 1, 0.1, 1e-9, 1e-50, 1e-100, 1e-140, 1e-150, 1e-152, 1e-155, 1e-160};
  std::mt19937 random(61);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto coordinate = [&] {
    const double x = random() % 3 > 0 ? unit(random) : static_cast<double>(random() % 3) - 1;
    return x * SIZES[random() % std::size(SIZES)];
  };
  for (int i = 0; i < cases(300); ++i) {
    std::vector<Point> points;
    for (std::size_t n = 3 + random() % 4; n > 0; --n) {
      const double x = coordinate();
      points.push_back({x, coordinate()});
    }
    expect_all_thin(Bezier(points), 1e-3);
  }
}

// Weights so different that parameters are coarser than coordinates.
TEST(RegionColumns, WidenForCutsOfUnevenWeights) {
  const std::vector<Spiral> spirals = ba::spiral_segments(Bezier({{0, 0}, {1, 0}, {1, 1}}, {1, 0x1p20, 1}));
  const Region_columns columns = regions_of(Tree<ba::Bca_traits_2<Kernel>>(spirals, 1e-3));
  for (std::size_t i = 0; i < spirals.size(); ++i) {
    EXPECT_GT(spirals[i].cut_error(), 1000 * spirals[i].point_error()) << i;
    EXPECT_GE(columns.widening[i], spirals[i].cut_error()) << i;
  }
}

// Where curvature is infinite the inner side is one piece, and the outer one has a joint all the same.
TEST(RegionColumns, TellTheFormWhereOnlyOneSideHasAJoint) {
  const std::vector<Spiral> spirals = ba::spiral_segments(Bezier({{0, 0}, {0, 0}, {1, 0}, {3, 3}}));  // 3 (t^2, t^3)
  const ba::Arc_region_2 fat = regions_of(Tree<ba::Spiral_fat_arc_traits_2<Kernel>>(spirals, 1)).region(0),
                         lens = regions_of(Tree<ba::Bilens_traits_2<Kernel>>(spirals, 1)).region(0);
  for (const auto* region : {&fat, &lens}) {
    EXPECT_EQ(region->inner.size, 1u);
    EXPECT_EQ(region->outer.size, 2u);
  }
  EXPECT_EQ(fat.form, ba::Region_form::SPIRAL_FAT_ARC);
  EXPECT_EQ(lens.form, ba::Region_form::BILENS);
}

TEST(RegionColumns, KeepNothingOfTheTreeBefore) {
  const std::vector<Spiral> spirals = various_spirals(6, 5);
  const Tree<ba::Bca_traits_2<Kernel>> tree(spirals, 1e-3);
  Region_columns columns = regions_of(Tree<ba::Bilens_traits_2<Kernel>>(spirals, 1e-2));
  EXPECT_FALSE(columns.inner.joint_x.empty());
  make_regions(tree, columns);
  const Region_columns fresh = regions_of(tree);
  EXPECT_EQ(columns.form, fresh.form);
  for (std::size_t i = 0; i < spirals.size(); ++i)
    for (std::size_t row = fresh.first[i]; row + 1 < fresh.first[i + 1]; ++row)
      for (const auto side : {&ba::Arc_region_2::inner, &ba::Arc_region_2::outer}) {
        const ba::Arc_region_2::Side is = columns.region(row).*side, expected = fresh.region(row).*side;
        EXPECT_EQ(is.size, expected.size);
        EXPECT_EQ(is.bulges[0], expected.bulges[0]);
      }
}

TEST(RegionColumns, AreNotMadeOfLazyNodes) {
  const Tree<ba::Bca_traits_2<Kernel>> tree(various_spirals(6, 2), 1e-2, nodes_of_kind(Build_options::Nodes::LAZY));
  EXPECT_THROW(regions_of(tree), std::invalid_argument);
}

struct Parabola {
  [[nodiscard]] ba::End_jet_2<double> jet(double t) const { return {{t, t * t}, {1, 2 * t}, {0, 2}}; }
};

TEST(RegionColumns, AreMadeOfCurvesOfOnesOwn) {
  using Own = ba::Jet_spiral_2<Parabola>;
  const ba::Region_hierarchy_2<ba::Bca_traits_2<Kernel>, Own> tree({Own({}, 0, 1, 1e-15)}, 1);
  Region_columns columns;
  make_regions(tree, columns);
  ASSERT_EQ(columns.number_of_regions(), 1u);
  const double at_start = std::atan(1.0), at_end = std::atan(1.0 / 3);  // between the chord and the end tangents
  EXPECT_NEAR(columns.outer.bulge[0], std::tan(at_start / 2), 1e-14);
  EXPECT_NEAR(columns.inner.bulge[0], std::tan(at_end / 2), 1e-14);
  EXPECT_GE(columns.widening[0], 1e-15);
  EXPECT_LE(columns.widening[0], 1e-14);
}

TEST(RegionColumns, OfAnEmptyTreeAreEmpty) {
  const Region_columns columns = regions_of(Tree<ba::Bca_traits_2<Kernel>>({}, 1));
  EXPECT_EQ(columns.number_of_regions(), 0u);
}

}  // namespace
}  // namespace test_region_columns

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Regions of single nodes are the bits of those of all leaves, for all methods and kinds of nodes, in whatever order
// and by whichever registers.

#include "trees.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/tree/Region_columns.h>
#include <CGAL/Bounding_arcs_2/tree/Region_reader.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace test_region_reader {
namespace {

using namespace bounding_arcs_test;
using ba::Arc_region_2;
using ba::Build_options;
using Instruction_set = ba::Build_options::Instruction_set;
using ba::Node_handle;

template <class Traits> using Tree = ba::Region_hierarchy_2<Traits, Spiral>;

void expect_same_side(const ba::Arc_region_2::Side& a, const ba::Arc_region_2::Side& b) {
  ASSERT_EQ(a.size, b.size);
  for (std::size_t i = 0; i < a.size; ++i) EXPECT_EQ(a.bulges[i], b.bulges[i]);
  if (a.size == 2) {
    EXPECT_EQ(a.joint, b.joint);
  }
}
void expect_same(const Arc_region_2& a, const Arc_region_2& b) {
  EXPECT_EQ(a.from, b.from);
  EXPECT_EQ(a.to, b.to);
  EXPECT_EQ(a.form, b.form);
  EXPECT_LE(a.widening, b.widening);  // columns have one a segment, for all of its regions
  expect_same_side(a.inner, b.inner);
  expect_same_side(a.outer, b.outer);
}

// Segments of curves of all degrees, also rational ones, and of one with a cusp, whose pieces have no batches.
std::vector<Spiral> various_spirals(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Spiral> spirals = ba::spiral_segments(Bezier({{0, 0}, {0, 0}, {1, 0}, {3, 3}}));
  for (int i = 0; i < 14; ++i)
    for (const Spiral& s : ba::spiral_segments(random_curve(random, 2 + i % 5, i % 7 == 6))) spirals.push_back(s);
  return spirals;
}

template <class Traits> class RegionReader : public testing::Test {};
using All = testing::Types<ba::Bca_traits_2<Kernel>, ba::Spiral_fat_arc_traits_2<Kernel>, ba::Bilens_traits_2<Kernel>>;
TYPED_TEST_SUITE(RegionReader, All);

TYPED_TEST(RegionReader, GivesTheBitsOfColumns) {
  for (const Build_options::Nodes kind : {Build_options::Nodes::STORED, Build_options::Nodes::EQUALIZED})
    for (const Instruction_set set : {Instruction_set::NONE, Instruction_set::BASE, Instruction_set::BEST}) {
      const Tree<TypeParam> tree(various_spirals(1), 1e-4, nodes_of_kind(kind));
      ba::Region_columns columns;
      make_regions(tree, columns, set);
      ba::Region_reader<Tree<TypeParam>> reader(tree, set);
      std::size_t row = 0, segment = 0;
      reader.for_each_leaf([&](const Node_handle& h, const Arc_region_2& region) {
        if (h.spiral != segment) row = columns.first[segment = h.spiral];
        expect_same(region, columns.region(row));
        expect_same(region, columns.region(row, segment));
        EXPECT_EQ(columns.row_of(tree.node(h)), row);
        static_cast<void>(reader.region(tree.segment_root(0)));  // which must not change what is visited next
        ++row;
      });
      EXPECT_EQ(row + 1, columns.first.back());
    }
}

// Of nodes that are no leaves and of lazy ones: the regions of a tree of which they are leaves.
TYPED_TEST(RegionReader, GivesTheBitsOfColumnsAboveLeaves) {
  const std::vector<Spiral> spirals = various_spirals(2);
  const Tree<TypeParam> coarse(spirals, 1e-2), fine(spirals, 1e-5),
      lazy(spirals, 1e-5, nodes_of_kind(Build_options::Nodes::LAZY));
  ba::Region_columns columns;
  make_regions(coarse, columns);
  ba::Region_reader<Tree<TypeParam>> of_fine(fine), of_lazy(lazy);
  std::vector<Node_handle> leaves;
  coarse.for_each_leaf([&](const Node_handle& h) { leaves.push_back(h); });
  std::size_t row = 0, above = 0;
  for (const Node_handle& leaf : leaves) {
    if (leaf.place == 0) row = columns.first[leaf.spiral];
    const auto find = [&](const Tree<TypeParam>& tree) {
      Node_handle h = tree.segment_root(leaf.spiral);
      for (int level = 0; level < leaf.level; ++level) {
        const bool is_second = (leaf.place >> (leaf.level - level - 1) & 1) != 0;
        Node_handle children[2];
        std::size_t count = 0;
        tree.for_each_child(h, [&](const Node_handle& child) { children[count++] = child; });
        EXPECT_EQ(count, 2u);
        h = children[is_second ? 1 : 0];
      }
      return h;
    };
    const Node_handle h = find(fine);
    above += !h.is_leaf;
    expect_same(of_fine.region(h), columns.region(row));
    expect_same(of_lazy.region(find(lazy)), columns.region(row));
    ++row;
  }
  EXPECT_GT(above, leaves.size() / 2);
}

TYPED_TEST(RegionReader, GivesChildrenAsSingleNodes) {
  for (const Build_options::Nodes kind :
       {Build_options::Nodes::STORED, Build_options::Nodes::EQUALIZED, Build_options::Nodes::LAZY}) {
    const Tree<TypeParam> tree(various_spirals(3), 1e-3, nodes_of_kind(kind));
    ba::Region_reader<Tree<TypeParam>> reader(tree), other(tree);
    std::size_t nodes = 0;
    tree.traverse([&](const Node_handle& h) {
      if (!h.is_region) return true;
      std::vector<Node_handle> children;
      tree.for_each_child(h, [&](const Node_handle& child) { children.push_back(child); });
      std::size_t i = 0;
      reader.for_each_child(h, [&](const Node_handle& child, const Arc_region_2& region) {
        ASSERT_LT(i, children.size());
        EXPECT_EQ(child.place, children[i].place);
        EXPECT_EQ(child.index, children[i].index);
        EXPECT_EQ(child.is_leaf, children[i].is_leaf);
        expect_same(other.region(children[i++]), region);
        static_cast<void>(reader.region(h));  // which must not change what is visited next
      });
      EXPECT_EQ(i, children.size());
      nodes += i;
      return true;
    });
    EXPECT_GT(nodes, 100u);
  }
}

// What was read last is another segment's with other neighbours.
TYPED_TEST(RegionReader, GivesTheSameInAnyOrder) {
  const Tree<TypeParam> tree(various_spirals(4), 1e-3);
  ba::Region_columns columns;
  make_regions(tree, columns);
  std::vector<Node_handle> leaves;
  tree.for_each_leaf([&](const Node_handle& h) { leaves.push_back(h); });
  std::vector<std::size_t> rows;
  for (std::size_t i = 0, segment = 0, row = 0; i < leaves.size(); ++i, ++row) {
    if (leaves[i].spiral != segment) row = columns.first[segment = leaves[i].spiral];
    rows.push_back(row);
  }
  ba::Region_reader<Tree<TypeParam>> reader(tree);
  std::mt19937 random(5);
  for (std::size_t i = 0; i < 2 * leaves.size(); ++i) {
    const std::size_t j = random() % leaves.size();
    expect_same(reader.region(leaves[j]), columns.region(rows[j]));
  }
}

struct Parabola {
  [[nodiscard]] ba::End_jet_2<double> jet(double t) const { return {{t, t * t}, {1, 2 * t}, {0, 2}}; }
};

TEST(RegionReaders, ReadCurvesOfOnesOwn) {
  using Own = ba::Region_hierarchy_2<ba::Bca_traits_2<Kernel>, ba::Jet_spiral_2<Parabola>>;
  const Own tree({ba::Jet_spiral_2<Parabola>({}, 0, 1, 1e-15)}, 1e-3);
  ba::Region_columns columns;
  make_regions(tree, columns);
  ba::Region_reader<Own> reader(tree);
  std::size_t row = 0;
  reader.for_each_leaf(
      [&](const Node_handle&, const Arc_region_2& region) { expect_same(region, columns.region(row++)); });
  EXPECT_EQ(row, columns.number_of_regions());
}

}  // namespace
}  // namespace test_region_reader

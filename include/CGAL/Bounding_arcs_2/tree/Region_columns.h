// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The regions of all leaves in hand: their arcs in doubles, in columns (see region/Arc_region_2.h).

#ifndef CGAL_BOUNDING_ARCS_2_TREE_REGION_COLUMNS_H
#define CGAL_BOUNDING_ARCS_2_TREE_REGION_COLUMNS_H

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/Region_node.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Segment_regions.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The regions of all leaves of a tree in doubles, in columns.
/// Leaf j of segment i, in curve order, is row first[i] + j: the piece from t to the t of the next row, from the point
/// (x, y) to that of the next row. The last row of a segment is its end, without a region: zeros. Equal points of
/// neighbours, of neighbouring segments also, are the same bits.
/// \code
/// Region_columns columns;
/// make_regions(regions, columns);  // of a tree with an eps, over doubles
/// for (std::size_t row = columns.first[0]; row + 1 < columns.first[1]; ++row)
///   std::cout << columns.x[row] << ' ' << columns.y[row] << ' ' << columns.inner.bulge[row] << '\n';
/// \endcode
struct Region_columns {
  /// One side of regions. The joints and second bulges of methods whose sides have one arc each are left empty. Where a
  /// region of another method has one arc, its joint is its end and its second bulge 0.
  struct Side {
    std::vector<double> bulge, joint_x, joint_y, second_bulge;
  };

  std::vector<std::size_t> first;  ///< the first row of each segment, and the number of rows
  std::vector<double> t, x, y;
  Side inner, outer;
  Region_form form = Region_form::BCA;  ///< of regions with two arcs a side
  std::vector<double>
      widening;  ///< of each segment: the exact curve is within it of its regions, in units of the plane

  [[nodiscard]] std::size_t number_of_regions() const { return first.empty() ? 0 : t.size() - (first.size() - 1); }
  /// The row of a leaf: that which begins where the leaf does. Nodes are kept level by level, so their own indices do
  /// not tell it. \complexity logarithmic in the leaves of a segment
  [[nodiscard]] std::size_t row_of(const Region_node& leaf) const {
    const auto at = [this](std::size_t i) { return t.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto row = std::lower_bound(at(first[leaf.spiral]), at(first[leaf.spiral + 1]), leaf.t0);
    return static_cast<std::size_t>(row - t.begin());
  }
  /// The region of a row that is not the last of a segment.
  [[nodiscard]] Arc_region_2 region(std::size_t row) const {
    const auto behind = std::upper_bound(first.begin(), first.end(), row);
    return region(row, static_cast<std::size_t>(behind - first.begin()) - 1);
  }
  /// Returns the region of a row whose segment is known.
  [[nodiscard]] Arc_region_2 region(std::size_t row, std::size_t segment) const {
    const auto side = [&](const Side& c) {
      if (c.joint_x.empty()) return Arc_region_2::Side{1, {c.bulge[row], 0}, {}};
      const Xy<double> joint{c.joint_x[row], c.joint_y[row]};
      if (joint == Xy<double>{x[row + 1], y[row + 1]}) return Arc_region_2::Side{1, {c.bulge[row], 0}, {}};
      return Arc_region_2::Side{2, {c.bulge[row], c.second_bulge[row]}, joint};
    };
    Arc_region_2 r{{x[row], y[row]}, {x[row + 1], y[row + 1]}, side(inner), side(outer)};
    if (r.inner.size == 2 || r.outer.size == 2) r.form = form;
    r.widening = widening[segment];
    return r;
  }
};

/// Makes the regions of all leaves of a tree over double.
/// \param to what it held is lost but its memory: new memory costs several times what the arcs in it do
/// \param set registers that batches run in; the results are the same bits
/// \throws std::invalid_argument for lazy nodes, whose leaves are not kept
/// \complexity linear; over curves that batches serve (doc/batches.md) some nanoseconds a region, over others
///   microseconds
template <class Tree>
void make_regions(const Tree& tree, Region_columns& to,
                  Build_options::Instruction_set set = Build_options::Instruction_set::BEST) {
  static_assert(std::is_same_v<typename Tree::Traits::FT, double>, "exact regions are asked for one by one");
  if (tree.nodes() == Build_options::Nodes::LAZY)
    throw std::invalid_argument(expected("tree", "nodes that are kept", "lazy ones"));
  to.first.assign(1, 0);
  to.first.reserve(tree.spirals().size() + 1);
  for (std::size_t i = 0; i < tree.spirals().size(); ++i)
    to.first.push_back(to.first.back() + tree.number_of_leaves(i) + 1);
  typename Tree::Leaf_room room;
  internal::make_rows(
      internal::Region_source(tree.traits().construction(), tree.spirals(), set),
      [&](std::size_t i, double* ends) { tree.write_leaf_ends(i, room, ends); }, to);
}

}  // namespace CGAL::Bounding_arcs

#endif

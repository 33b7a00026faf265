// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The regions of all leaves in hand: their arcs in doubles, in columns (see region/Arc_region_2.h).

#ifndef CGAL_BOUNDING_ARCS_2_TREE_REGION_COLUMNS_H
#define CGAL_BOUNDING_ARCS_2_TREE_REGION_COLUMNS_H

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/Region_node.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Default_decider.h>
#ifndef BOUNDING_ARCS_WITHOUT_FILTER
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Arcs_ahead.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Batch_functions.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs {

/// One side of regions. The joints and second bulges of methods whose sides have one arc each are left empty. Where a
/// region of another method has one arc, its joint is its end and its second bulge 0.
struct Side_columns {
  std::vector<double> bulge, joint_x, joint_y, second_bulge;
};

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
  std::vector<std::size_t> first;  ///< the first row of each segment, and the number of rows
  std::vector<double> t, x, y;
  Side_columns inner, outer;
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
    const auto side = [&](const Side_columns& c) {
      if (c.joint_x.empty()) return Arc_side_2{1, {c.bulge[row], 0}, {}};
      const Xy<double> joint{c.joint_x[row], c.joint_y[row]};
      if (joint == Xy<double>{x[row + 1], y[row + 1]}) return Arc_side_2{1, {c.bulge[row], 0}, {}};
      return Arc_side_2{2, {c.bulge[row], c.second_bulge[row]}, joint};
    };
    Arc_region_2 r{{x[row], y[row]}, {x[row + 1], y[row + 1]}, side(inner), side(outer)};
    if (r.inner.size == 2 || r.outer.size == 2) r.form = form;
    r.widening = widening[segment];
    return r;
  }
};

/// How far the exact curve may be from regions that are made one by one. Each coordinate of both ends errs by
/// `point_error` and half an ulp. Bulges and joints move arcs by less than that, and so do cuts that are rounded
/// (tree/internal/batch/Arc_points.h has the terms). Coordinates of spirals are largest at their ends.
template <class Spiral> [[nodiscard]] double widening_of_single_regions(const Spiral& spiral) {
  constexpr double OF_ENDS = 2, OF_BULGES = 1, OF_CUTS = 1;
  double size = 0;
  for (const double t : {spiral.first(), spiral.last()}) {
    const Xy<double> p = spiral.template point<double>(t);
    size = (std::max)({size, std::fabs(p.x), std::fabs(p.y)});
  }
  return (OF_ENDS + OF_BULGES + OF_CUTS) * (spiral.point_error() + ulp_of(size) / 2) + spiral.cut_error();
}

/// Looks at no segment ahead: where there are no batches.
template <class Spiral> struct Nothing_ahead {
  explicit Nothing_ahead(Instruction_set) {}
  static void look(const Spiral*, std::size_t, const std::size_t*, const double*) {}
  [[nodiscard]] static bool make(std::size_t, Region_columns&, double&) { return false; }
  [[nodiscard]] static std::nullopt_t points(std::size_t) { return std::nullopt; }
};

/// Makes the regions of some pieces of one segment: of all leaves, or of single nodes (Region_reader.h).
template <class Construction, class Spiral> class Segment_regions {
  static constexpr bool HAS_JOINTS = !std::is_same_v<Construction, Bca>;
#ifndef BOUNDING_ARCS_WITHOUT_FILTER
  using Arcs = typename filter::Formulas<Construction>::Arcs;
  static constexpr bool HAS_BATCHES = !std::is_void_v<Arcs>;
  using Filter = filter::Arc_filter<Arcs>;
  using Points = filter::Both_points;
#endif

 public:
#ifdef BOUNDING_ARCS_WITHOUT_FILTER
  struct Points {};
  using Ahead = Nothing_ahead<Spiral>;
  static constexpr std::size_t PADDING = 0;
#else
  /// Who looks at the segments that come next.
  using Ahead = std::conditional_t<HAS_BATCHES && filter::are_served_v<Spiral>, filter::Arcs_ahead<Arcs, Spiral>,
                                   Nothing_ahead<Spiral> >;
  static constexpr std::size_t PADDING = filter::ARC_PADDING;
#endif
  /// Construction and segment must outlive the object.
  /// \param is_whole it is asked for the whole segment as one piece alone
  /// \param points what was found of it ahead
  Segment_regions(const Construction& construction, const Spiral& spiral, [[maybe_unused]] Instruction_set set,
                  [[maybe_unused]] bool is_whole = false,
                  [[maybe_unused]] const std::optional<Points>& points = std::nullopt)
      : construction_(&construction), spiral_(&spiral), start_(spiral.template point<double>(spiral.first())),
        end_(spiral.template point<double>(spiral.last())) {
#ifndef BOUNDING_ARCS_WITHOUT_FILTER
    if constexpr (HAS_BATCHES) {
      if (points) filter_.emplace(set, spiral, *points);
      else filter_.emplace(set, spiral, is_whole);
      if (filter_->serves()) return;
      filter_.reset();
    }
#endif
    widening_ = widening_of_single_regions(spiral);
  }

  /// Room for so many rows, of which the last PADDING are only worked in.
  static void resize(Region_columns& to, std::size_t size) {
    for (auto* column : {&to.t, &to.x, &to.y, &to.inner.bulge, &to.outer.bulge}) column->resize(size);
    for (auto* side : {&to.inner, &to.outer})
      for (auto* column : {&side->joint_x, &side->joint_y, &side->second_bulge}) column->resize(HAS_JOINTS ? size : 0);
  }
  /// Sets rows row, ..., row + count - 1 and the points behind them, from the parameters that they have.
  /// \return how far the exact curve may be from these regions
  double make(Region_columns& to, std::size_t row, std::size_t count) const {
    std::vector<std::size_t> open;
    double widening = widening_;
    const bool is_made = make_many(to, row, count, open, widening);
    const auto set_point = [&](std::size_t j, const Xy<double>& p) {
      to.x[j] = p.x;
      to.y[j] = p.y;
    };
    for (std::size_t j = row; !is_made && j <= row + count; ++j) {
      set_point(j, spiral_->template point<double>(to.t[j]));
      if (j < row + count) open.push_back(j);
    }
    if (to.t[row] == spiral_->first()) set_point(row, start_);
    if (to.t[row + count] == spiral_->last()) set_point(row + count, end_);
    for (const std::size_t j : open) make_one(to, j);
    for (auto* side : {&to.inner, &to.outer})  // batches leave numbers of no meaning there
      for (auto* column : {&side->bulge, &side->joint_x, &side->joint_y, &side->second_bulge})
        if (!column->empty()) (*column)[row + count] = 0;
    return widening;
  }

 private:
  // In batches, but for those that are left open. \return false if there are none, and no points
  [[nodiscard]] bool make_many([[maybe_unused]] Region_columns& to, [[maybe_unused]] std::size_t row,
                               [[maybe_unused]] std::size_t count, [[maybe_unused]] std::vector<std::size_t>& open,
                               [[maybe_unused]] double& widening) const {
#ifndef BOUNDING_ARCS_WITHOUT_FILTER
    if constexpr (HAS_BATCHES) {
      if (!filter_) return false;
      const auto places = [row](Side_columns& c) {
        if constexpr (!HAS_JOINTS) return filter::Side_places{&c.bulge[row], nullptr, nullptr, nullptr};
        else return filter::Side_places{&c.bulge[row], &c.joint_x[row], &c.joint_y[row], &c.second_bulge[row]};
      };
      widening = filter_->make(&to.t[row], count, {&to.x[row], &to.y[row], places(to.inner), places(to.outer)},
                               [&](std::size_t j) { open.push_back(row + j); });
      if (open.size() < count) to.form = filter::FORM<Arcs>;
      if (open.empty()) return true;
      double longest = 0;
      for (const std::size_t j : open)
        longest = (std::max)(longest, stable_norm(Xy<double>{to.x[j + 1] - to.x[j], to.y[j + 1] - to.y[j]}));
      widening = filter_->with_single(widening, longest);
      return true;
    }
#endif
    return false;
  }
  void make_one(Region_columns& to, std::size_t j) const {
    const Arc_region_2 r =
        arc_region(*construction_, *spiral_, to.t[j], to.t[j + 1], {to.x[j], to.y[j]}, {to.x[j + 1], to.y[j + 1]});
    const auto set_side = [&](const Arc_side_2& side, Side_columns& columns) {
      columns.bulge[j] = side.bulges[0];
      if constexpr (HAS_JOINTS) {
        const Xy<double> joint = side.size == 2 ? side.joint : r.to;
        columns.joint_x[j] = joint.x;
        columns.joint_y[j] = joint.y;
        columns.second_bulge[j] = side.bulges[1];
      }
    };
    if (r.form != Region_form::BCA) to.form = r.form;
    set_side(r.inner, to.inner);
    set_side(r.outer, to.outer);
  }

  const Construction* construction_;
  const Spiral* spiral_;
#ifndef BOUNDING_ARCS_WITHOUT_FILTER
  std::optional<Filter> filter_;  // where it serves
#endif
  Xy<double> start_, end_;
  double widening_ = 0;
};

/// Makes the regions of all leaves of a tree over double.
/// \param to what it held is lost but its memory: new memory costs several times what the arcs in it do
/// \param set registers that batches run in; the results are the same bits
/// \throws std::invalid_argument for lazy nodes, whose leaves are not kept
/// \complexity linear; over curves that batches serve (doc/batches.md) some nanoseconds a region, over others
///   microseconds
template <class Tree>
void make_regions(const Tree& tree, Region_columns& to, Instruction_set set = Instruction_set::BEST) {
  using Regions = Segment_regions<typename Tree::Traits::Construction, typename Tree::Spiral>;
  static_assert(std::is_same_v<typename Tree::Traits::FT, double>, "exact regions are asked for one by one");
  if (tree.nodes() == Node_kind::LAZY)
    throw std::invalid_argument(expected("tree", "nodes that are kept", "lazy ones"));
  const auto& spirals = tree.spirals();
  to.first.assign(1, 0);
  to.first.reserve(spirals.size() + 1);
  for (std::size_t i = 0; i < spirals.size(); ++i) to.first.push_back(to.first.back() + tree.number_of_leaves(i) + 1);
  const std::size_t rows = to.first.back();
  Regions::resize(to, rows + Regions::PADDING);
  to.form = Region_form::BCA;
  to.widening.resize(spirals.size());
  typename Tree::Leaf_room room;
  typename Regions::Ahead ahead(set);
  constexpr std::size_t AHEAD = 64;  // segments
  for (std::size_t i = 0; i < spirals.size(); ++i) {
    if (i % AHEAD == 0) {
      const std::size_t count = (std::min)(AHEAD, spirals.size() - i);
      for (std::size_t j = i; j < i + count; ++j) {
        to.t[to.first[j]] = spirals[j].first();
        tree.write_leaf_ends(j, room, &to.t[to.first[j] + 1]);
      }
      ahead.look(&spirals[i], count, &to.first[i], to.t.data());
    }
    if (ahead.make(i % AHEAD, to, to.widening[i])) continue;
    const std::size_t row = to.first[i], count = to.first[i + 1] - row - 1;
    const Regions regions(tree.traits().construction(), spirals[i], set, count == 1, ahead.points(i % AHEAD));
    to.widening[i] = regions.make(to, row, count);
  }
  Regions::resize(to, rows);
}

}  // namespace CGAL::Bounding_arcs

#endif

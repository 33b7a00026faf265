// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the regions in hand of segments with few leaves, eight segments at a time, and finds for others what their
// batches need.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_ARCS_AHEAD_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_ARCS_AHEAD_H

#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/Region_columns.h>
#include "Batch_functions.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::filter {

// Makes the regions in hand of a segment's pieces in batches, where there are formulas and a local curve; what it
// leaves open is made one by one (tree/Region_columns.h).

/// Places that a batch writes beyond those asked for, at most.
inline constexpr std::size_t ARC_PADDING = GROUP<double>;

/// What arc_room asks of a segment's points.
[[nodiscard]] inline Point_sizes point_sizes(const Bezier_spiral_2<double>& spiral) {
  constexpr double OF_SINGLE = 4;  // of point errors: widening_of_single_regions (tree/Region_columns.h)
  const double size = spiral.coordinate_size();
  return {size, ulp_of(size), OF_SINGLE * spiral.point_error(), spiral.cut_error()};
}

/// Points of a segment, for its usual pieces and for coarse ones.
struct Both_points {
  Arc_points usual, coarse;

  Both_points() = default;
  Both_points(const Local_curve& curve, const Xy<double>& at_middle, const Arc_room& r)
      : usual(arc_points(curve, at_middle, r.widening, r.room)),
        coarse(arc_points(curve, at_middle, r.coarse_widening, r.coarse_room)) {}
};

/// Makes the regions in hand of a segment's pieces in batches, where there are formulas and a local curve.
template <class Arcs> class Arc_filter {
 public:
  /// \param is_whole the segment is asked for as one piece: its ends are known, and bulges need no points
  Arc_filter(Instruction_set set, const Bezier_spiral_2<double>& spiral, bool is_whole)
      : Arc_filter(set, spiral, Both_points()) {
    if (!serves()) return;
    const Arc_room room = arc_room<Arcs>(curve_, point_sizes(spiral));
    const bool needs_middle = !is_whole || HAS_JOINTS<Arcs>;
    points_ = {curve_, needs_middle ? spiral.end_point(curve_.middle) : Xy<double>(), room};
    if (!(points_.usual.room > 0)) many_ = nullptr;
  }
  /// \param points as the other constructor finds them, with room
  Arc_filter(Instruction_set set, const Bezier_spiral_2<double>& spiral, const Both_points& points)
      : curve_(spiral.local_curve()), points_(points),
        many_(function_for(set, [](auto isa) { return &arc_function<decltype(isa), Arcs>; })(curve_.kind)),
        few_(few_function<Arcs>(curve_.kind)) {}
  /// Whether it makes points and regions of the segment at all.
  [[nodiscard]] bool serves() const { return many_ != nullptr; }

  /// Writes points and bulges of pieces, see arc_batch, and calls open(i) for those whose bulges it leaves open.
  /// \return how far the exact curve may be from the regions of the others
  /// \pre serves(); behind breaks and places there is room for ARC_PADDING more
  template <class Open>
  double make(const double* breaks, std::size_t count, const Arc_places& to, const Open& open) const {
    constexpr std::size_t FEW = 2;  // up to which a loop without wide registers is quicker
    const Arc_function function = count <= FEW ? few_ : many_;
    double widening = points_.usual.widening;
    for (std::size_t i = 0; i < count; i += BATCH_SIZE) {
      std::uint64_t left =
          function(curve_, points_.usual, breaks + i, (std::min)(count - i, BATCH_SIZE), behind(to, i));
      for (std::size_t j = i; left != 0; ++j, left >>= 1) {
        if ((left & 1) == 0) continue;
        if (few_(curve_, points_.coarse, breaks + j, 1, behind(to, j)) != 0) open(j);
        else widening = points_.coarse.widening;
      }
    }
    return widening;
  }
  /// What the widening is with regions over its points that were made one by one, from shapes exact to half an ulp by
  /// formulas without cancellation: their joints and bulges err by the roundings of no more than 64 operations.
  /// \param widening of the others \param chord the longest of these pieces has
  [[nodiscard]] double with_single(double widening, double chord) const {
    constexpr double OF_SINGLE = 64 * Local_precision<double>::HALF_ULP;
    return (std::max)(widening, points_.usual.widening + OF_SINGLE * chord / 2 - points_.usual.room * curve_.form.unit);
  }

 private:
  [[nodiscard]] static Arc_places behind(const Arc_places& to, std::size_t i) {
    const auto side = [i](const Side_places& s) {
      if constexpr (!HAS_JOINTS<Arcs>) return Side_places{s.bulge + i, nullptr, nullptr, nullptr};
      else return Side_places{s.bulge + i, s.joint_x + i, s.joint_y + i, s.second_bulge + i};
    };
    return {to.x + i, to.y + i, side(to.inner), side(to.outer)};
  }

  Local_curve curve_;
  Both_points points_;
  Arc_function many_;  ///< makes arcs in groups of eight pieces
  Arc_function few_;   ///< piece by piece, which is quicker for one or two
};

/// Makes the regions in hand of segments with few leaves.
template <class Arcs> class Arcs_ahead {
  using Spiral = Bezier_spiral_2<double>;

 public:
  explicit Arcs_ahead(Instruction_set set)
      : lanes_(function_for(set, [](auto isa) { return &lanes_function<decltype(isa), Arcs>; })) {}

  /// Looks at segments first[0], ..., first[count - 1], and forgets those before.
  /// \param rows the first row of each segment and, behind them, where the last one ends
  /// \param t the parameters of rows
  void look(const Spiral* first, std::size_t count, const std::size_t* rows, const double* t) {
    first_ = first;
    rows_ = rows;
    slots_.assign(count, NONE);
    answers_.clear();
    answers_.reserve(count / LANES + 1);
    Few_question question;
    Few_question& q = question;
    const auto set = [&](std::size_t lane, std::size_t i) {
      const std::size_t leaves = leaves_of(i);
      const Point_sizes sizes = point_sizes(first[i]);
      q.coordinate_size.of[lane] = sizes.coordinate_size;
      q.ulp.of[lane] = sizes.ulp;
      q.most_widening.of[lane] = sizes.most_widening;
      q.cut_error.of[lane] = sizes.cut_error;
      for (std::size_t k = 0; k <= FEW_LEAVES; ++k) q.breaks[k].of[lane] = t[rows[i] + (std::min)(k, leaves)];
      set_middle(q, lane, first[i], leaves > 1 || HAS_JOINTS<Arcs>);
    };
    const auto ask = [&](int kind, const std::size_t* places, std::size_t size) {
      if (const Lanes_function function = lanes_(kind)) {
        std::size_t with[FEW_LEAVES + 1] = {};  // so many leaves
        for (std::size_t lane = 0; lane < size; ++lane) {
          slots_[places[lane]] = LANES * answers_.size() + lane;
          if (leaves_of(places[lane]) <= FEW_LEAVES) ++with[leaves_of(places[lane])];
        }
        q.most_leaves = best_most(with, size);
        function(q, answers_.emplace_back());
      }
      q.has_cubics = false;
    };
    for_lanes(
        first, count, q.curves, [](std::size_t) { return true; }, set, ask);
  }
  /// Sets the rows of segment i, if that has few leaves, all of which could be made.
  /// Batches write beyond their rows, so segments are to be made in their order.
  [[nodiscard]] bool make(std::size_t i, Region_columns& columns, double& widening) const {
    if (slots_[i] == NONE) return false;
    const std::size_t leaves = leaves_of(i), lane = slots_[i] % LANES;
    const Few_answer& a = answers_[slots_[i] / LANES];
    if (leaves > a.most_leaves) return false;
    double fails = 0;
    for (std::size_t k = 0; k < leaves; ++k) fails = (std::max)(fails, a.leaves[k].fails.of[lane]);
    if (!(a.room.of[lane] > 0) || fails > 1) return false;
    widening = fails > 0 ? a.coarse_widening.of[lane] : a.widening.of[lane];
    const std::size_t row = rows_[i], last = row + leaves;
    const auto set_point = [&](std::size_t j, const Xy<double>& p) {
      columns.x[j] = p.x;
      columns.y[j] = p.y;
    };
    set_point(row, first_[i].point(first_[i].first()));
    set_point(last, first_[i].point(first_[i].last()));
    for (std::size_t k = 0; k < leaves; ++k) {
      const Leaf_lanes& leaf = a.leaves[k];
      if (k > 0) set_point(row + k, {leaf.x.of[lane], leaf.y.of[lane]});
      set_side(lane, leaf.inner, columns.inner, row + k);
      set_side(lane, leaf.outer, columns.outer, row + k);
    }
    for (auto* side : {&columns.inner, &columns.outer}) {
      side->bulge[last] = 0;
      if constexpr (HAS_JOINTS<Arcs>) side->joint_x[last] = side->joint_y[last] = side->second_bulge[last] = 0;
    }
    columns.form = FORM<Arcs>;
    return true;
  }
  /// The points of segment i where they leave room for arcs.
  [[nodiscard]] std::optional<Both_points> points(std::size_t i) const {
    const std::size_t lane = slots_[i] % LANES;
    if (slots_[i] == NONE || !(answers_[slots_[i] / LANES].room.of[lane] > 0)) return std::nullopt;
    const Few_answer& a = answers_[slots_[i] / LANES];
    return Both_points(first_[i].local_curve(), {a.middle_x.of[lane], a.middle_y.of[lane]},
                       {a.widening.of[lane], a.room.of[lane], a.coarse_widening.of[lane], a.coarse_room.of[lane]});
  }

 private:
  [[nodiscard]] std::size_t leaves_of(std::size_t i) const { return rows_[i + 1] - rows_[i] - 1; }
  // How many leaves a segment may have for its arcs to be made side by side. Each leaf takes all lanes. The arcs of
  // another segment are a batch of its own, which takes as long as two and a half leaves.
  [[nodiscard]] static std::size_t best_most(const std::size_t (&with)[FEW_LEAVES + 1], std::size_t others) {
    std::size_t best = 0, least = 5 * others;
    for (std::size_t most = 1; most <= FEW_LEAVES; ++most) {
      others -= with[most];
      if (const std::size_t cost = 2 * most + 5 * others; cost < least) {
        least = cost;
        best = most;
      }
    }
    return best;
  }
  static void set_middle(Few_question& q, std::size_t lane, const Spiral& spiral, bool is_wanted) {
    const auto& p = spiral.curve().control_points();
    const bool is_cubic = is_wanted && p.size() == 4 && !spiral.curve().is_rational();
    q.is_cubic.of[lane] = is_cubic ? 1 : 0;
    q.has_cubics = q.has_cubics || is_cubic;
    for (std::size_t k = 0; k < 4; ++k) {
      q.control_x[k].of[lane] = is_cubic ? p[k].x : 0;
      q.control_y[k].of[lane] = is_cubic ? p[k].y : 0;
    }
    const Xy<double> middle = is_wanted && !is_cubic ? spiral.end_point(q.curves.middle.of[lane]) : Xy<double>();
    q.middle_x.of[lane] = middle.x;
    q.middle_y.of[lane] = middle.y;
  }
  static void set_side(std::size_t lane, const Side_lanes& from, Region_columns::Side& to, std::size_t j) {
    to.bulge[j] = from.bulge.of[lane];
    if constexpr (HAS_JOINTS<Arcs>) {
      to.joint_x[j] = from.joint_x.of[lane];
      to.joint_y[j] = from.joint_y.of[lane];
      to.second_bulge[j] = from.second_bulge.of[lane];
    }
  }

  Lanes_function (*lanes_)(int kind);
  static constexpr std::size_t NONE = ~std::size_t(0);
  const Spiral* first_ = nullptr;
  const std::size_t* rows_ = nullptr;
  std::vector<std::size_t> slots_;  // of each segment: eight times the place of its answer, and its lane there
  std::vector<Few_answer> answers_;
};

}  // namespace CGAL::Bounding_arcs::filter

#endif

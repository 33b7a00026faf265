// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the regions in hand of a segment's pieces in batches, where there are formulas and a local curve; what it
// leaves open is made one by one (tree/Region_columns.h).

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_ARC_FILTER_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_ARC_FILTER_H

#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Batch_function.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Filtered_decider.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace CGAL::Bounding_arcs::filter {

/// Places that a batch writes beyond those asked for, at most.
inline constexpr std::size_t ARC_PADDING = GROUP<double>;

/// What arc_room asks of a segment's points.
template <class Spiral> [[nodiscard]] Point_sizes point_sizes(const Spiral& spiral) {
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

/// Whether segments of a type have what batches need.
template <class Spiral>
inline constexpr bool are_served_v = has_local_curve_v<Spiral>&& std::is_same_v<typename Spiral::Number_type, double>;

/// Makes the regions in hand of a segment's pieces in batches, where there are formulas and a local curve.
template <class Arcs> class Arc_filter {
 public:
  /// \param is_whole the segment is asked for as one piece: its ends are known, and bulges need no points
  template <class Spiral>
  Arc_filter(Instruction_set set, const Spiral& spiral, bool is_whole) : Arc_filter(set, spiral, Both_points()) {
    if constexpr (are_served_v<Spiral>) {
      if (!serves()) return;
      for_kind(curve_.kind, [&](auto of_kind) {
        const Arc_room room = arc_room<Arcs, of_kind()>(curve_.form, curve_.half, point_sizes(spiral));
        const bool needs_middle = !is_whole || Arcs::HAS_JOINTS;
        points_ = {curve_, needs_middle ? spiral.end_point(curve_.middle) : Xy<double>(), room};
      });
      if (!(points_.usual.room > 0)) many_ = nullptr;
    }
  }
  /// \param points as the other constructor finds them, with room
  template <class Spiral>
  Arc_filter(Instruction_set set, const Spiral& spiral, const Both_points& points)
      : curve_(local_curve_of(spiral)), points_(points) {
    if constexpr (are_served_v<Spiral>) {
      const Arc_functions<Arcs> functions(set);
      many_ = functions.of_many(curve_.kind);
      few_ = functions.of_few(curve_.kind);
    }
  }
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
  template <class Spiral> [[nodiscard]] static Local_curve local_curve_of(const Spiral& spiral) {
    if constexpr (has_local_curve_v<Spiral>) return spiral.local_curve();
    else return {};
  }
  [[nodiscard]] static Arc_places behind(const Arc_places& to, std::size_t i) {
    const auto side = [i](const Side_places& s) {
      if constexpr (!Arcs::HAS_JOINTS) return Side_places{s.bulge + i, nullptr, nullptr, nullptr};
      else return Side_places{s.bulge + i, s.joint_x + i, s.joint_y + i, s.second_bulge + i};
    };
    return {to.x + i, to.y + i, side(to.inner), side(to.outer)};
  }

  Local_curve curve_;
  Both_points points_;
  Arc_function many_ = nullptr, few_ = nullptr;
};

}  // namespace CGAL::Bounding_arcs::filter

#endif

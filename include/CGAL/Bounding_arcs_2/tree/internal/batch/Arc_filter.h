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

/// Makes the regions in hand of a segment's pieces in batches, where there are formulas and a local curve.
template <class Arcs> class Arc_filter {
 public:
  /// \param is_whole the segment is asked for as one piece: its ends are known, and bulges need no points
  template <class Spiral>
  Arc_filter(Instruction_set set, const Spiral& spiral, bool is_whole = false) : curve_(local_curve_of(spiral)) {
    if constexpr (has_local_curve_v<Spiral> && std::is_same_v<typename Spiral::Number_type, double>) {
      functions_ = arc_functions<Arcs>(set, curve_);
      if (!serves()) return;
      constexpr double OF_SINGLE = 4;  // of point errors: widening_of_single_regions (tree/Region_columns.h)
      const double size = spiral.coordinate_size();
      const Xy<double> middle = is_whole && !Arcs::HAS_JOINTS ? Xy<double>{} : spiral.end_point(curve_.middle);
      points_ = arc_points<Arcs>(curve_, middle, size, OF_SINGLE * spiral.point_error());
      if (!(points_.room > 0)) functions_ = {};
      wide_points_ = points_;
      wide_points_.widening += COARSE_ROOM_ULPS * ulp_of(size);
      wide_points_.room += COARSE_ROOM_ULPS * ulp_of(size) / curve_.form.unit;
      // What may be missing beside cuts counts where it is more than polynomial curves may have, whose |C'| is at most
      // twice the degree times the largest coordinate.
      const double of_polynomials = CUT_WIDTH * (2 * degree_of_kind(curve_.kind) * size);
      if (spiral.cut_error() > of_polynomials)
        for (Arc_points* points : {&points_, &wide_points_}) points->widening += spiral.cut_error();
    }
  }
  /// Whether it makes points and regions of the segment at all.
  [[nodiscard]] bool serves() const { return functions_.of_many != nullptr; }

  /// Writes points and bulges of pieces, see arc_batch, and calls open(i) for those whose bulges it leaves open.
  /// \return how far the exact curve may be from the regions of the others
  /// \pre serves(); behind breaks and places there is room for ARC_PADDING more
  template <class Open>
  double make(const double* breaks, std::size_t count, const Arc_places& to, const Open& open) const {
    constexpr std::size_t FEW = 2;  // up to which a loop without wide registers is quicker
    const Arc_function function = count <= FEW ? functions_.of_few : functions_.of_many;
    double widening = points_.widening;
    for (std::size_t i = 0; i < count; i += BATCH_SIZE) {
      std::uint64_t left = function(curve_, points_, breaks + i, (std::min)(count - i, BATCH_SIZE), behind(to, i));
      for (std::size_t j = i; left != 0; ++j, left >>= 1) {
        if ((left & 1) == 0) continue;
        if (functions_.of_few(curve_, wide_points_, breaks + j, 1, behind(to, j)) != 0) open(j);
        else widening = wide_points_.widening;
      }
    }
    return widening;
  }
  /// What the widening is with regions over its points that were made one by one, from shapes exact to half an ulp by
  /// formulas without cancellation: their joints and bulges err by the roundings of no more than 64 operations.
  /// \param widening of the others \param chord the longest of these pieces has
  [[nodiscard]] double with_single(double widening, double chord) const {
    constexpr double OF_SINGLE = 64 * Local_precision<double>::HALF_ULP;
    return (std::max)(widening, points_.widening + OF_SINGLE * chord / 2 - points_.room * curve_.form.unit);
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
  Arc_points points_, wide_points_;
  Arc_functions functions_;
};

}  // namespace CGAL::Bounding_arcs::filter

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves of a drawing that bound what a rule fills. An axis is made of these alone, and its places have the numbers
// of all curves.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_BOUNDING_CURVES_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_BOUNDING_CURVES_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/tree/Drawing_hierarchy.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Bounding_curves {
 public:
  /// \param curves must outlive this
  /// \param left_out numbers of curves that bound nothing
  Bounding_curves(const Drawing_hierarchy& curves, std::vector<std::uint32_t> left_out)
      : all_(&curves), left_out_(std::move(left_out)) {
    if (left_out_.empty()) return;
    const auto count = static_cast<std::uint32_t>(curves.drawing().curves().size());
    std::vector<bool> is_left_out(count, false);
    for (const std::uint32_t i : left_out_)
      if (i < count) is_left_out[i] = true;
    for (std::uint32_t i = 0; i < count; ++i)
      if (!is_left_out[i]) numbers_.push_back(i);
    bounding_ = curves.without(is_left_out);
  }

  [[nodiscard]] const Drawing_hierarchy& all() const { return *all_; }
  [[nodiscard]] const Drawing_hierarchy& curves() const { return bounding_ ? *bounding_ : *all_; }
  /// The number of a bounding curve among all.
  [[nodiscard]] std::uint32_t number_among_all(std::uint32_t curve) const {
    return bounding_ ? numbers_[curve] : curve;
  }
  /// The number of one of all curves among the bounding ones; nothing if it is left out.
  [[nodiscard]] std::optional<std::uint32_t> number_among_bounding(std::uint32_t curve) const {
    if (!bounding_) return curve;
    const auto at = std::lower_bound(numbers_.begin(), numbers_.end(), curve);
    if (at == numbers_.end() || *at != curve) return std::nullopt;
    return static_cast<std::uint32_t>(at - numbers_.begin());
  }
  /// Gives places of an axis of the bounding curves the numbers of all.
  [[nodiscard]] Medial_axis_2 among_all(Medial_axis_2 axis) const {
    if (!bounding_) return axis;
    for (Medial_vertex& v : axis.vertices)
      for (Curve_place& p : v.touches) p.curve = numbers_[p.curve];
    for (Medial_edge& e : axis.edges)
      for (Medial_sample& s : e.samples) s.left.curve = numbers_[s.left.curve], s.right.curve = numbers_[s.right.curve];
    axis.left_out = left_out_;
    return axis;
  }

 private:
  const Drawing_hierarchy* all_;
  std::vector<std::uint32_t> left_out_, numbers_;  // the latter of bounding curves
  std::optional<Drawing_hierarchy> bounding_;      // where some are left out
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

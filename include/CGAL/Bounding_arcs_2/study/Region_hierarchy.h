// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The segments of a drawing with regions of any of the eight kinds: what searches are templates over.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_REGION_HIERARCHY_H
#define CGAL_BOUNDING_ARCS_2_STUDY_REGION_HIERARCHY_H

#include <CGAL/Bounding_arcs_2/study/regions_in_hand.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::study {

/// Regions of segments are kept, those of pieces made where a search asks for them, and both are counted.
template <class Construction> class Region_hierarchy : public internal::Segment_hierarchy {
 public:
  using Region = decltype(region_in_hand<Construction>(std::declval<const Segment_hierarchy&>(),
                                                       std::declval<const Spiral_piece_2&>()));

  explicit Region_hierarchy(const internal::Segment_hierarchy& curves) : Segment_hierarchy(curves) {
    regions_.reserve(number_of_segments());
    for (std::uint32_t i = 0; i < number_of_segments(); ++i)
      regions_.push_back(region_in_hand<Construction>(*this, piece(i)));
  }
  [[nodiscard]] const Region& region(std::uint32_t segment) const {
    ++asked_;
    return regions_[segment];
  }
  [[nodiscard]] Region region(const Spiral_piece_2& piece) const {
    ++asked_;
    return region_in_hand<Construction>(*this, piece);
  }
  /// How many regions were asked for.
  [[nodiscard]] std::size_t asked() const { return asked_; }

 private:
  std::vector<Region> regions_;
  mutable std::size_t asked_ = 0;
};

}  // namespace CGAL::Bounding_arcs::study

#endif

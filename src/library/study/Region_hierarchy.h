// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The segments of a drawing with regions of any of the eight kinds: what searches are templates over.

#ifndef BOUNDING_ARCS_LIBRARY_STUDY_REGION_HIERARCHY_H
#define BOUNDING_ARCS_LIBRARY_STUDY_REGION_HIERARCHY_H

#include "regions_in_hand.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::study {

/// Regions of segments are kept, those of pieces made where a search asks for them, and both are counted.
/// \tparam Region_ of a piece in hand: searches are compiled once for all kinds that have one form
template <class Region_> class Region_hierarchy : public Segment_hierarchy {
 public:
  using Region = Region_;
  using Make = Region (*)(const Segment_hierarchy&, const Spiral_piece_2&);

  Region_hierarchy(const Segment_hierarchy& curves, Make make) : Segment_hierarchy(curves), make_(make) {
    regions_.reserve(number_of_segments());
    for (std::uint32_t i = 0; i < number_of_segments(); ++i) regions_.push_back(make(*this, piece(i)));
  }
  [[nodiscard]] const Region& region(std::uint32_t segment) const {
    ++asked_;
    return regions_[segment];
  }
  [[nodiscard]] Region region(const Spiral_piece_2& piece) const {
    ++asked_;
    return make_(*this, piece);
  }
  /// How many regions were asked for.
  [[nodiscard]] std::size_t asked() const { return asked_; }

 private:
  Make make_;
  std::vector<Region> regions_;
  mutable std::size_t asked_ = 0;
};

}  // namespace CGAL::Bounding_arcs::study

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for the k curves of a drawing that are nearest to a point: that for the nearest point, with an upper bound
// for each curve that was met and the k-th of them for others.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_NEAREST_CURVES_SEARCH_H
#define BOUNDING_ARCS_LIBRARY_QUERY_NEAREST_CURVES_SEARCH_H

#include <CGAL/Bounding_arcs_2/query/Closest_search.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/tree/Segment_hierarchy.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Nearest_curves_search {
 public:
  /// \pre k > 0
  Nearest_curves_search(const Segment_hierarchy& curves, const Xy<double>& q, std::size_t k)
      : curves_(curves), q_(q), count_((std::min)(k, curves.drawing().curves().size())) {
    CGAL_precondition(k > 0);
    for_each_near(curves.boxes(), *this);
  }
  [[nodiscard]] std::vector<Closest_point<>> result() const {
    return {met_.begin(), met_.begin() + static_cast<std::ptrdiff_t>((std::min)(count_, met_.size()))};
  }

  // What boxes are asked for, see for_each_near.
  [[nodiscard]] const Xy<double>& point() const { return q_; }
  [[nodiscard]] double squared_reach() const { return most_square(most()); }
  [[nodiscard]] bool goes_on(double squared_distance) const { return squared_distance <= squared_reach(); }
  void look_at(std::uint32_t segment) {
    const std::uint32_t curve = curves_.place(segment).curve;
    const auto own =
        std::find_if(met_.begin(), met_.end(), [&](const Closest_point<>& p) { return p.place.curve == curve; });
    Closest_search search(curves_, q_, own == met_.end() ? most() : own->distance.upper);
    search.look_at(segment);
    const auto found = search.result();
    if (own == met_.end()) {
      if (found) met_.push_back(*found);
    } else {
      const double lower = (std::min)(own->distance.lower, search.lower());
      const Query_status before = own->status;
      if (found) *own = *found;
      own->distance.lower = lower;
      if (before != Query_status::COMPLETE || search.is_limited()) own->status = Query_status::LIMIT_REACHED;
    }
    if (found)
      std::sort(met_.begin(), met_.end(),
                [](const Closest_point<>& p, const Closest_point<>& r) { return p.distance.upper < r.distance.upper; });
  }

 private:
  [[nodiscard]] double most() const {
    return met_.size() < count_ ? std::numeric_limits<double>::infinity() : met_[count_ - 1].distance.upper;
  }

  const Segment_hierarchy& curves_;
  Xy<double> q_;
  std::size_t count_;
  std::vector<Closest_point<>> met_;  // the nearest point of each curve that was met, sorted
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

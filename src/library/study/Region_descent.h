// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The closest point by regions alone.

#ifndef BOUNDING_ARCS_LIBRARY_STUDY_REGION_DESCENT_H
#define BOUNDING_ARCS_LIBRARY_STUDY_REGION_DESCENT_H

#include "../query/Closest_search.h"
#include "../query/Work_limit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL::Bounding_arcs::study {

/// The closest point by regions alone: pieces are halved until the bracket is as narrow as asked. The library's own
/// search ends as soon as a piece has one nearest point for certain, by Newton's steps, whatever region it has; here
/// the region does all, so that the order of its thickness tells.
template <class Curves> class Region_descent {
 public:
  /// \param eps how wide the bracket may be, beside what doubles leave open; it is wider where that takes more than
  ///   2^16 halvings
  Region_descent(const Curves& curves, const Xy<double>& q, double eps) : curves_(curves), q_(q), eps_(eps) {}

  [[nodiscard]] Bracket search() {
    for_each_near(curves_.boxes(), *this);
    return {(std::min)(lower_, upper_), upper_};
  }

  // What boxes are asked for, see for_each_near.
  [[nodiscard]] const Xy<double>& point() const { return q_; }
  [[nodiscard]] double squared_reach() const { return most_square(upper_); }
  [[nodiscard]] bool goes_on(double squared_distance) const { return squared_distance <= squared_reach(); }
  void look_at(std::uint32_t segment) { look_at(curves_.piece(segment), distance_bounds(q_, curves_.region(segment))); }

 private:
  void look_at(const Spiral_piece_2& piece, const Bracket& d) {
    upper_ = (std::min)(upper_, d.upper);
    const double enough = (std::max)(eps_, distance_resolution(curves_.error(piece.segment), upper_));
    const bool goes_on = d.lower < upper_ - enough && limit_.spend();
    const auto parts = goes_on ? halves(curves_, piece) : std::nullopt;
    if (!parts) {
      lower_ = (std::min)(lower_, d.lower);
      return;
    }
    const Bracket first = distance_bounds(q_, curves_.region(parts->first)),
                  second = distance_bounds(q_, curves_.region(parts->second));
    const bool is_first_nearer = first.lower <= second.lower;
    if (is_first_nearer) look_at(parts->first, first);
    look_at(parts->second, second);
    if (!is_first_nearer) look_at(parts->first, first);
  }

  const Curves& curves_;
  Xy<double> q_;
  double eps_, upper_ = HUGE_VAL, lower_ = HUGE_VAL;
  Work_limit limit_{std::size_t(1) << 16};  // halvings, far more than a box needs at 1e-6
};

}  // namespace CGAL::Bounding_arcs::study

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The length of a drawing between two bounds: each piece of a spiral segment is integrated (Speed_integral.h), and is
// between its chord and arcs that touch it (Lens.h), which tells more next to cusps and of pieces that are short.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_LENGTH_SUM_H
#define BOUNDING_ARCS_LIBRARY_QUERY_LENGTH_SUM_H

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/tree/Segment_hierarchy.h>
#include "Lens.h"
#include "Speed_integral.h"
#include "refine_sum.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Length_sum {
 public:
  Length_sum(const Segment_hierarchy& curves, double tolerance)
      : curves_(curves), limit_(most_pieces(curves.number_of_segments())) {
    for (std::uint32_t b = 0; b < curves.number_of_beziers(); ++b) speeds_.emplace_back(curves, b);
    std::vector<Spiral_piece_2> pieces;
    for (std::uint32_t s = 0; s < curves.number_of_segments(); ++s) pieces.push_back(curves.piece(s));
    const auto open = [this](const Spiral_piece_2& p) { return open_of(p); };
    for (const Spiral_piece_2& p : refine_sum(curves, pieces, tolerance, open, limit_)) {
      const Bracket r = length_of(p);
      lower_ = lower_ + Double_double(r.lower);
      upper_ = upper_ + Double_double(r.upper);
    }
  }

  [[nodiscard]] const Double_double& lower() const { return lower_; }
  [[nodiscard]] const Double_double& upper() const { return upper_; }

  /// Whether pieces were left as they were, as there were too many.
  [[nodiscard]] bool is_limited() const { return limit_.is_reached(); }

 private:
  [[nodiscard]] const Speed_integral& speed_of(const Spiral_piece_2& p) const {
    return speeds_[curves_.bezier_of(p.segment)];
  }
  [[nodiscard]] double point_error(const Spiral_piece_2& p) const {
    const std::uint32_t bezier = curves_.bezier_of(p.segment);
    return curves_.evaluator(bezier).point_error() + curves_.rounding(bezier);
  }
  [[nodiscard]] Bracket length_of(const Spiral_piece_2& p) const {
    // between exact parameters, cuts' errors are of no matter
    const Bracket of_arcs = Lens(p, curves_.error(p.segment)).length();
    Bracket r{(std::max)(of_arcs.lower, euclidean_norm(p.last.point - p.first.point) * DOWN - 2 * point_error(p)),
              (std::min)(of_arcs.upper, speed_of(p).most(p.first.t, p.last.t))};
    if (const auto integral = speed_of(p).over(p.first.t, p.last.t))
      r = {(std::max)(r.lower, integral->lower), (std::min)(r.upper, integral->upper)};
    return r;
  }
  [[nodiscard]] Open_part open_of(const Spiral_piece_2& p) const {
    const Bracket r = length_of(p);
    const double floor = (std::max)(speed_of(p).floor(p.first.t, p.last.t, r.upper), point_error(p));  // to each side
    return {r.width(), r.width() <= 4 * floor};
  }

  static constexpr double DOWN = ROUNDED_DOWN<16>;

  const Segment_hierarchy& curves_;
  std::vector<Speed_integral> speeds_;  // of Bezier pieces
  Double_double lower_, upper_;
  Work_limit limit_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The area of a face: of the parts of curves along its boundaries, by Green's theorem. Polynomial parts are summed up
// exactly, rational ones as their chords and bounds of what is between chord and curve (Rational_part.h).
//
// A part is taken between doubles in the middle of the brackets of its ends' parameters. Where parts meet, segments
// lead from one to the next. What that changes there is the area within a closed curve: along the first part to
// its double, straight to that of the next part, along this back to the place. With w the width of a bracket and D a
// bound of |C'|, its length is at most 2 (w1 D1 + w2 D2), and the area within a closed curve of length L, each part
// counted as often as it is run round, is at most L^2 / (4 pi) (Banchoff and Pohl 1971): less than a third of the
// square of the sum in brackets. A rational part begins and ends at rounded points, and its chord has what is between
// these and the curve: by so much the way is longer, which counts as w D does.

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_BOUNDARY_SUM_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_BOUNDARY_SUM_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <CGAL/Interval_nt.h>

#include <optional>

namespace CGAL::Bounding_arcs::internal {

/// Sums up the area of a face from its boundaries, each of which is parts of Bezier pieces.
class Boundary_sum {
 public:
  /// Adds the next part of a boundary, with the face on its left.
  /// \param from, to hold the parameters where it starts and ends; they may be the same bracket
  void add(const Bezier_curve_2<Exact_rational>& bezier, const Bracket& from, const Bracket& to);
  /// Ends a boundary, which goes on from its last part to its first one.
  void close();
  /// \guarantee certified; the lower bound is not below 0
  [[nodiscard]] Measure_bounds bounds(double eps) const;

 private:
  using Point = Xy<Exact_rational>;
  /// Where a part starts or ends, and how far that may be from the true place, along the part.
  struct End {
    Point point;
    Exact_rational open;
  };

  void join(const End& end, const End& start);
  void add_segment(const Point& from, const Point& to);

  Exact_rational exact_{0}, open_{0};
  std::optional<End> first_, last_;       // of the boundary that is not closed yet
  CGAL::Interval_nt<true> by_chords_{0};  // between rational parts and their chords
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

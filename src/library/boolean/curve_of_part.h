// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts of Bezier pieces as curves in doubles.

#ifndef BOUNDING_ARCS_LIBRARY_BOOLEAN_CURVE_OF_PART_H
#define BOUNDING_ARCS_LIBRARY_BOOLEAN_CURVE_OF_PART_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <utility>

namespace CGAL::Bounding_arcs::internal {

/// Cuts a part out of a piece, in doubles. One that is shorter than these tell is straight.
/// \param from, to hold the parameters of its ends
/// \param is_reversed whether it runs against the piece
/// \param start, end its ends, which it gets bit for bit
[[nodiscard]] inline Bezier_curve_2<double> curve_of_part(const Bezier_curve_2<double>& piece, const Bracket& from,
                                                          const Bracket& to, bool is_reversed, const Xy<double>& start,
                                                          const Xy<double>& end) {
  const double low = (is_reversed ? to : from).middle(), high = (is_reversed ? from : to).middle();
  if (!(low < high)) return Bezier_curve_2<double>({start, end});
  Bezier_curve_2<double> part = low == 0 && high == 1 ? piece : piece.subcurve(low, high);
  if (is_reversed) part = part.reversed();
  auto points = part.control_points();
  points.front() = start;
  points.back() = end;
  return Bezier_curve_2<double>(std::move(points), part.weights());
}

}  // namespace CGAL::Bounding_arcs::internal

#endif

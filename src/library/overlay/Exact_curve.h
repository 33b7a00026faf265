// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A Bezier piece in exact numbers, and how two of them leave a common point.

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_EXACT_CURVE_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_EXACT_CURVE_H

#include "Exact_parameter.h"

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include "../curve/Integer_piece.h"
#include "../query/exact_intersections.h"

#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A Bezier piece in exact numbers, with what is found out of it once.
class Exact_curve {
 public:
  explicit Exact_curve(Bezier_curve_2<Exact_rational> bezier);

  [[nodiscard]] const Bezier_curve_2<Exact_rational>& bezier() const { return bezier_; }
  [[nodiscard]] const Integer_piece& piece() const { return piece_; }
  /// Whether it runs along a line from one end to the other, x and y linear in the parameter.
  [[nodiscard]] bool is_segment() const { return piece_.degree() == 1 && piece_.w.degree() == 0; }
  [[nodiscard]] Exact_point point(const Exact_rational& t) const;
  /// Parameters inside at which x or y turns, in rising order, some perhaps twice.
  [[nodiscard]] const std::vector<Exact_parameter>& turns();

 private:
  Bezier_curve_2<Exact_rational> bezier_;
  Integer_piece piece_;
  std::optional<std::vector<Exact_parameter>> turns_;
};

/// Where two segments that are not parallel meet, on the line of the first one.
/// \return nothing of other curves
[[nodiscard]] std::optional<Exact_parameter> crossing_of_segments(const Exact_curve& a, const Exact_curve& b);

/// The first way of a curve from a place on it, along which x and y are monotone.
struct Exact_way {
  Exact_curve* curve;
  const Exact_parameter* from;
  Exact_rational to;   ///< a parameter on it
  int x_sign, y_sign;  ///< 1 where the coordinate rises from the place on, -1 where it falls, 0 where it stays

  /// Counterclockwise: 0 to the right, 1 up to the right, 2 up, ... 7 down to the right.
  [[nodiscard]] int sector() const;
};
/// \param end where the curve meets others or ends; the way goes towards it
/// \pre the piece is no point between the two
[[nodiscard]] Exact_way exact_way(Exact_curve& curve, const Exact_parameter& from, const Exact_parameter& end);

/// Whether q is counterclockwise of p, both of which leave one point within one sector.
/// \pre they have no other common point
/// \guarantee exact
[[nodiscard]] bool is_counterclockwise_of(const Exact_way& q, const Exact_way& p);

}  // namespace CGAL::Bounding_arcs::internal

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A chain of parts as a chain of curves in doubles, without what rounding does not tell from nothing.
//
// Curves that were rounded run along what they were made of and cross it several times. Between the crossings are
// slivers, and at each crossing an outline changes from one curve to the other. Combined again and again, both
// multiply. So a part that is within rounding
//   - of a point is left out,
//   - of the part before it, which it goes back along, is left out with that,
//   - of the curve that the chain left and comes back to is a part of that curve, as is a whole way of parts.
// Rounding is here what a bound tells of cutting the very parts that are compared; parts that are not cut are not
// rounded. How well the place of a crossing is known does not count: where curves meet at a small angle that is far
// more, and what is there is real.

#ifndef BOUNDING_ARCS_LIBRARY_BOOLEAN_CHAIN_DRAWER_H
#define BOUNDING_ARCS_LIBRARY_BOOLEAN_CHAIN_DRAWER_H

#include "rounded_part.h"

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <cstddef>
#include <deque>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A part with its curve in doubles.
struct Drawn_part {
  Outline_2::Part part;
  Bezier_curve_2<double> curve;
  double error = 0;     ///< how far the curve is from the part, point by point
  double rounding = 0;  ///< what of it rounding alone may make, of any of the given parts that it stands for
  double replaced = 0;  ///< how far the part is from parts in whose place it stands
};

class Chain_drawer {
 public:
  explicit Chain_drawer(const std::vector<const Bounding_arc_tree_2*>& trees);

  /// Draws a new chain as it is.
  void start(const std::vector<Outline_2::Part>& chain);
  /// Leaves out what rounding does not tell from nothing, maybe all.
  /// \complexity linear in the number of parts for drawings as they are
  void drop_slivers();
  [[nodiscard]] const std::deque<Drawn_part>& parts() const { return parts_; }
  /// How far the curves are from the parts given, and how far apart the sides were of what was left out.
  [[nodiscard]] double moved() const;

 private:
  [[nodiscard]] const Bezier_curve_2<double>& piece_of(const Outline_2::Part& part) const;
  [[nodiscard]] Exact_ends given_ends(const Outline_2::Part& part) const;
  [[nodiscard]] Drawn_part drawn(const Outline_2::Part& part, const Exact_ends& exact) const;
  void redraw(Drawn_part& drawn, const Outline_2::Part& part) const;
  void start_at(Drawn_part& drawn, const Xy<double>& p) const;
  void put(Drawn_part part);
  void close();
  [[nodiscard]] bool is_reduced();
  [[nodiscard]] bool goes_on();
  [[nodiscard]] bool goes_back();
  [[nodiscard]] bool comes_back();
  [[nodiscard]] bool bounds_nothing();
  void join(std::size_t first, double replaced);
  [[nodiscard]] std::vector<Outline_2::Part> parts_between(const Outline_2::Part& a, const Outline_2::Part& b) const;

  const std::vector<const Bounding_arc_tree_2*>& trees_;
  std::vector<double> roundings_;  // by tree
  std::deque<Drawn_part> parts_;
  double left_out_ = 0;  // the largest distance between sides
};

}  // namespace CGAL::Bounding_arcs::internal

#endif

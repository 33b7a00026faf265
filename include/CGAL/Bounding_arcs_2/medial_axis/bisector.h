// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bisector of two curves: the centers of discs that touch both.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_BISECTOR_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_BISECTOR_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <memory>
#include <optional>
#include <ostream>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Discs between two curves: each touches the first one from the left, and the other one.
/// \code
/// const Bezier_curve_2<double> line({{-1, -3}, {1, -3}});
/// const Bisector_2 bisector(line, tree, 10);  // discs up to the radius 10
/// if (const auto disc = bisector.disc(0.5)) std::cout << disc->center.y << ' ' << disc->radius << '\n';
/// \endcode
class Bisector_2 {
 public:
  /// A disc that touches a curve, on its left, and another one.
  struct Sample {
    Xy<double> center;
    double radius = 0;
    double t = 0;           ///< where it touches the first curve
    Curve_place touches{};  ///< where it touches the other one

    /// Writes the members in their order, with a blank between.
    friend std::ostream& operator<<(std::ostream& out, const Sample& answer) {
      return out << answer.center << ' ' << answer.radius << ' ' << answer.t << ' ' << answer.touches;
    }
  };

  /// \param a reverse it for its other side
  /// \param b must outlive this; it may be of many curves, whose nearest one counts
  /// \param largest the largest radius to look for
  /// \throws std::invalid_argument for a radius that is not positive or above LARGEST_QUERIED, and for a curve out of
  ///   the range of queries
  Bisector_2(const Bezier_curve_2<double>& a, const Bounding_arc_tree_2& b, double largest);

  /// The disc that touches `a` in t from the left and touches `b`, of which no point is in it.
  /// \return nothing where that would be larger than `largest` or than the radius of curvature of `a`, and so have `a`
  ///   in it, and where C' = 0
  /// \guarantee no bound is told; the radius is within some roundings of coordinates over 1 - cos of the angle between
  ///   both places, seen from the center
  /// \source the ball that shrinks to the nearest point until there is none in it: Ma, Bae, Choi 2012; here for curves
  ///   instead of points, where each step squares the error
  [[nodiscard]] std::optional<Sample> disc(double t) const;

  /// The bisector as chains of discs, in the order of `a`; each ends where discs do.
  /// \param eps how far the bisector may be from the lines between samples, and radii from what is between theirs
  /// \throws std::invalid_argument for an eps that is not positive
  /// \guarantee that lines are within eps is an estimate, from discs half-way. Samples are no nearer to each other than
  ///   2^-18 of the parameters of `a`, and chains over less than 1/64 of these may be missing
  /// \complexity about eps^(-1/2) discs, each of some closest points
  [[nodiscard]] std::vector<std::vector<Sample>> sample(double eps) const;

 private:
  [[nodiscard]] Sample out(const Sample& s) const;
  [[nodiscard]] std::optional<Sample> disc_in_unit(double t) const;

  internal::Unit unit_;  // of all that follows
  Bezier_curve_2<double> a_;
  std::shared_ptr<const Segment_hierarchy> b_;
  double largest_;
};

}  // namespace CGAL::Bounding_arcs

#endif

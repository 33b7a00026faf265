// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A check of offsets: how far the distances of all their points are from |d|, by the hierarchy and not by samples.

#ifndef CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_ERROR_H
#define CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_ERROR_H

#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <optional>

namespace CGAL::Bounding_arcs {

/// The rational quadratic of an arc.  Its ends are the arc's; its middle control point errs by less than 8 ulp of the
/// coordinates and the chord's length, and the curve by no more.
/// \pre it turns by at most a quarter of a circle
[[nodiscard]] Bezier_curve_2<double> quadratic_of(const Arc_2& arc);

/// The round pieces of the chains as a drawing, those that are joined as one curve. Larger ones than a quarter of a
/// circle are two quadratics.
[[nodiscard]] Drawing_2<double> drawing_of(const Offset& offset);

/// The distances of all points of an offset's round pieces from the curves, less |d|.
struct Offset_error {
  Bracket nearest;   ///< of the point that is nearest to the curves, negative if nearer than |d|
  Bracket farthest;  ///< of the point that is farthest from them
};

/// Returns how far an offset's points are from where they should be.
/// \param tree of the curves that were offset: where d < 0, of the open ones, or of what bounds what the closed ones
///   enclose, which is drawing_of(Offset_source_2::outline()) where parts of them are inside
/// \param eps how wide brackets may be, a length
/// \return nothing for an offset without round pieces or a drawing without curves
/// \guarantee certified for the arcs as they are given, but for their quadratics' rounding
/// \complexity as for distance() and hausdorff_distance() of curves that are parallel: the cube root of 1 / eps
[[nodiscard]] std::optional<Offset_error> offset_error(const Bounding_arc_tree_2& tree, const Offset& offset,
                                                       double eps);

}  // namespace CGAL::Bounding_arcs

#endif

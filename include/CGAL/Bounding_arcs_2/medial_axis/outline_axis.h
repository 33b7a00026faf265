// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The medial axis of what closed curves enclose that may cross or touch: that of their outline, which is made of parts
// of the curves.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_OUTLINE_AXIS_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_OUTLINE_AXIS_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/compiled_axes.h>
#include <CGAL/Bounding_arcs_2/tree/tree_declaration.h>

#include <vector>

namespace CGAL::Bounding_arcs {

/// The medial axis of the outline of curves that may cross.
struct Outline_axis {
  Medial_axis_2 axis;         ///< of `outline`: its places are of these curves
  Drawing_2<double> outline;  ///< parts of the given curves, which have a region to their left and may meet at joints
  double error = 0;           ///< how far parts may be from the curves, as they are cut in doubles
  /// Where a Bezier piece of the outline is on the curves.
  struct Source {
    Curve_place begin;
    double t_end;
  };
  std::vector<std::vector<Source>> sources;  ///< of each piece of each curve of the outline

  /// About where a place of the outline is on the curves.
  [[nodiscard]] Curve_place on_curves(const Curve_place& p) const {
    const Source& source = sources[p.curve][p.bezier];
    Curve_place place = source.begin;
    place.t += p.t * (source.t_end - place.t);
    return place;
  }
};

/// Returns the medial axis of the outline of what closed curves enclose. Curves may cross, touch and run together.
/// Where they do not meet, and in a frame, `medial_axis` has the axis without cutting them.
/// \tparam ConcurrencyTag CGAL::Sequential_tag or CGAL::Parallel_tag, which needs TBB; the axis is the same
/// \guarantee the outline is cut out as boolean_operation does it, and is within `error` of the curves. Its axis is as
///   good as medial_axis makes it. UNRESOLVED, without an axis, where the kernel's decisions leave open how curves meet
/// \throws std::invalid_argument as medial_axis, and for a frame
template <class ConcurrencyTag = CGAL::Sequential_tag, class Traits, class Spiral, class Decider>
[[nodiscard]] Outline_axis outline_axis(const Bounding_arc_tree_2<Traits, Spiral, Decider>& tree, double eps,
                                        const Medial_axis_options& options = {}) {
  return internal::outline_axis(tree.curves(), internal::axis_job<ConcurrencyTag>(eps, options),
                                Bounding_arc_tree_2<Traits, Spiral, Decider>::DECISIONS);
}

}  // namespace CGAL::Bounding_arcs

#endif

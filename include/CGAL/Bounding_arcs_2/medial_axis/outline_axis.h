// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The medial axis of what closed curves enclose that may cross or touch: that of their outline, as chains of arcs
// within a tolerance.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_OUTLINE_AXIS_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_OUTLINE_AXIS_H

#include <CGAL/Bounding_arcs_2/curve/arc_beziers.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The medial axis of the outline of curves that may cross.
struct Outline_axis {
  Medial_axis_2 axis;         ///< of `outline`: its places are of these curves
  Drawing_2<double> outline;  ///< a curve a chain, of rational quadratics
  double error = 0;           ///< how far the outline may be from the curves
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

/// The medial axis of the outline of what closed curves enclose. Where curves do not cross, `medial_axis` has that of
/// the curves themselves.
/// \param options eps is halved: the outline is within one half of the curves, the axis of it sampled to the other
/// \guarantee the outline is within `error` of the curves, its axis is as good as medial_axis makes it. How near that
///   is to the axis of the curves is not said: small kinks between arcs have branches of their own, for which there is
///   `pruned`
/// \throws std::invalid_argument as medial_axis, and where a curve is open
[[nodiscard]] inline Outline_axis outline_axis(const Drawing_2<double>& drawing,
                                               const Medial_axis_options& options = {}) {
  if (!(options.eps > 0)) throw std::invalid_argument("a tolerance above 0 is needed");
  check_closed(drawing);
  Outline_axis result;
  Offset_options of_outline;
  of_outline.eps = options.eps / 2;
  of_outline.rule = options.rule;
  const Offset outline = Offset_source_2(drawing, of_outline).outline();
  result.error = outline.error;
  for (const Offset_chain& chain : outline.chains) {
    std::vector<Bezier_curve_2<double>> pieces;
    std::vector<Outline_axis::Source> sources;
    for (const Offset_piece& p : chain.pieces) {
      if (p.arc.from == p.arc.to) continue;
      auto parts = arc_beziers<double>(p.arc.from, p.arc.to, p.arc.bulge);
      const double step = (p.t_end - p.source.t) / static_cast<double>(parts.size());
      Curve_place place = p.source;
      for (auto& part : parts) {
        pieces.push_back(std::move(part));
        sources.push_back({place, place.t + step});
        place.t += step;
      }
    }
    if (pieces.empty()) continue;
    result.outline.add(std::move(pieces));
    result.sources.push_back(std::move(sources));
  }
  Medial_axis_options of_axis = options;
  of_axis.eps = options.eps / 2;
  of_axis.rule = Fill_rule::NONZERO;
  result.axis = internal::axis_of_uncrossed(Curve_index_2(result.outline), of_axis);
  if (outline.status == Offset_status::UNRESOLVED) result.axis.status = Medial_axis_status::UNRESOLVED;
  return result;
}

}  // namespace CGAL::Bounding_arcs

#endif

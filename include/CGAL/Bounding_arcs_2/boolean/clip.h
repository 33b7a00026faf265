// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves, cut where they meet those of a region: parts inside of it, outside of it, and along its curves.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_CLIP_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_CLIP_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/overlay/overlay.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <cstdint>
#include <optional>
#include <ostream>
#include <vector>

namespace CGAL::Bounding_arcs {

/// All parts of some curves, in the order of the curves. The parts of a piece cover it.
/// \code
/// for (const Clipped_2::Part& part : clip(hatching, region).parts)  // clip.h
///   if (part.side == CGAL::ON_BOUNDED_SIDE) std::cout << part.start << " to " << part.end << '\n';
/// \endcode
struct Clipped_2 {
  using Status = Overlay_2::Status;

  /// A part of one Bezier piece on one side of a region.
  struct Part {
    std::uint32_t curve = 0;                ///< of the drawing
    std::uint32_t bezier = 0;               ///< of that curve
    Bracket from, to;                       ///< hold the parameters of start and end, which rise
    Xy<double> start, end;                  ///< these points but for rounding; parts of a piece share them bit for bit
    Bounded_side side = ON_UNBOUNDED_SIDE;  ///< on the boundary: along a curve of the region, whatever that fills

    /// Returns the part as a curve: cut out in doubles, with the part's ends bit for bit.
    /// \param drawing that of the tree that was clipped
    [[nodiscard]] Bezier_curve_2<double> cut_from(const Drawing_2<double>& drawing) const;

    /// Writes the members in their order, with a blank between.
    friend std::ostream& operator<<(std::ostream& out, const Part& answer) {
      return out << answer.curve << ' ' << answer.bezier << ' ' << answer.from << ' ' << answer.to << ' '
                 << answer.start << ' ' << answer.end;
    }
  };

  std::vector<Part> parts;
  Status status = Status::COMPLETE;
  std::optional<Overlay_2::Undecided> undecided;  ///< the first one, of curves as operand 0 and the region as operand 1

  /// Writes a line for each part.
  friend std::ostream& operator<<(std::ostream& out, const Clipped_2& all) {
    for (const Part& one : all.parts) out << one << '\n';
    return out;
  }
};

/// Cuts the curves of a tree, open ones and closed ones, where they meet those of a region.
/// \param region a tree of closed curves
/// \param rule says what these fill
/// \return all parts, in the order of the curves, with the side that each is on
/// \guarantee with exact decisions parts and sides are those of the exact curves, and the status is
///   COMPLETE. Parts may be shorter than doubles tell. Else the status tells what doubles left open
/// \throws std::invalid_argument for an open curve of the region, and for curves out of the range of queries
/// \complexity that of intersections, and log n for each part but for what a ray from it crosses
[[nodiscard]] Clipped_2 clip(const Bounding_arc_tree_2& curves, const Bounding_arc_tree_2& region,
                             Fill_rule rule = Fill_rule::NONZERO);

}  // namespace CGAL::Bounding_arcs

#endif

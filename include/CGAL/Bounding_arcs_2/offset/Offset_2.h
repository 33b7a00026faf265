// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is asked of an offset, and what it is: chains of arcs and segments, each of which knows where it comes from.

#ifndef CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_2_H
#define CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_2_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <ostream>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The offset of a drawing at one distance: chains of arcs and segments that do not cross.
/// \code
/// const Offset grown = offset(tree, 0.1, 1e-4);  // outwards; -0.1 is inwards
/// for (const Offset::Chain& chain : grown.chains)
///   for (const Offset::Piece& piece : chain.pieces) std::cout << piece.arc.from.x << ' ' << piece.arc.bulge << '\n';
/// \endcode
/// Chains round regions run counterclockwise, chains round holes clockwise, and `parent` nests them. An offset inwards
/// may have no chains: nothing is left. Each piece is an arc by its ends and bulge, and names the place of the curve
/// that it is the offset of.
///
/// Look at `status`. COMPLETE says that `error` is at most the tolerance, and that no loop is missing but such as
/// appear or vanish within the tolerance. UNRESOLVED says that chains may be missing; `unresolved` has a place.
///
/// Chains become polygons of CGAL by offset_polygons() of exchange/general_polygon.h, and path data of SVG by
/// svg_path() of exchange/svg_path.h. To offset them again, make an Offset_source_2 of them.
struct Offset {
  /// What goes round a corner on its outer side.
  enum class Join : std::uint8_t {
    ROUND,  ///< an arc about the corner: all is at one distance
    MITER,  ///< the tangents until they meet, or BEVEL above the limit
    BEVEL   ///< the segment between the ends
  };

  /// What goes round an end of an open curve.
  enum class Cap : std::uint8_t {
    ROUND,  ///< half a circle
    BUTT,   ///< the segment through the end
    SQUARE  ///< the same, farther by the distance
  };

  /// What of the band around curves. With LEFT or RIGHT closed curves have a band, too, and enclose nothing: the left
  /// of one that runs counterclockwise is its inset, its right the outset.
  enum class Side : std::uint8_t {
    BOTH,  ///< its whole boundary, closed chains; of closed curves the boundary of what they enclose, grown or shrunk
    LEFT,  ///< what of the band's boundary comes from the left of the curve, seen along it: open chains, or whole loops
    RIGHT
  };

  /// How curves are offset: joins, caps, sides and the fill rule. The defaults give round joins and caps, both sides,
  /// and the nonzero rule: all points of the offset are then at the distance |d|.
  /// \code
  /// Offset::Options options;
  /// options.join = Offset::Join::MITER;
  /// const Offset grown = offset(tree, 0.1, 1e-4, options);
  /// \endcode
  struct Options {
    Join join = Join::ROUND;
    double miter_limit = 4;  ///< the largest distance of a miter's tip from its corner, over |d|; at least 1
    Cap cap = Cap::ROUND;
    Side side = Side::BOTH;
    Fill_rule rule = Fill_rule::NONZERO;
  };

  /// What an arc of an offset is the offset of.
  enum class Kind : std::uint8_t { CURVE, JOIN, CAP };

  /// An arc or a segment of an offset, and what it is the offset of.
  struct Piece {
    Arc_2 arc;
    Curve_place source;  ///< of its start; t is interpolated within an arc's [t0, t1]
    double t_end = 0;    ///< of its end
    Kind kind = Kind::CURVE;
    bool is_round = true;  ///< at the distance |d|; segments of miters, bevels and straight caps are not, nor are lines
                           ///< that miters and caps lead on
    std::int32_t bezier_step = 0;  ///< how many Bezier pieces behind that of its start its end is, or before it

    /// The Bezier piece that the end is the offset of.
    [[nodiscard]] std::uint32_t bezier_of_end() const {
      return source.bezier + static_cast<std::uint32_t>(bezier_step);
    }
  };

  /// Pieces that follow each other.
  struct Chain {
    std::vector<Piece> pieces;          ///< each starts where the one before ends, bit for bit
    bool is_closed = true;              ///< else a chain of one side of a curve; chains of one side run as curves do
    bool is_ccw = true;                 ///< the outside of a region; holes run clockwise
    double area = 0;                    ///< of what it encloses, negative if clockwise
    std::optional<std::size_t> parent;  ///< the innermost chain around it

    /// Writes the arcs of a chain as those of an Arc_chain are written.
    friend std::ostream& operator<<(std::ostream& out, const Chain& chain);
  };

  /// What came of an offset.
  enum class Status : std::uint8_t {
    COMPLETE,
    RESOLUTION_REACHED,  ///< eps is below what coordinates resolve; `error` was reached
    UNRESOLVED           ///< parts of the offset touch in a way that could not be told apart: chains may be missing
  };

  struct Error;   ///< how far points are from where they should be, offset_bracket.h
  struct Bounds;  ///< two offsets with the true one between them, offset_bracket.h

  double distance = 0;
  std::vector<Chain> chains;
  double error = 0;  ///< points of round pieces are at |d| +- error from the curves, or what of them bounds
  Status status = Status::COMPLETE;
  std::optional<Xy<double>> unresolved;  ///< a place where parts touch so, where `status` is UNRESOLVED
  Side side = Side::BOTH;                ///< what was asked for

  /// Tells whether the offset is in order, without the curves that it is of. Numbers are finite, and parameters are
  /// in [0, 1]. Pieces of a chain follow each other bit for bit, and closed chains come back to where they start.
  /// `is_ccw` says what the area says. Where `side` is BOTH regions and holes take turns from a chain to its parent,
  /// whose box holds it.
  /// \complexity linear in the pieces
  [[nodiscard]] bool is_valid() const;

  /// The round pieces of the chains as a drawing, those that are joined as one curve: rational quadratics, two of an
  /// arc larger than a quarter of a circle. Their ends are the arcs'. Their middle control points err by less than 8
  /// ulp of the coordinates and the chord's length, and the curves by no more.
  [[nodiscard]] Drawing_2<double> drawing() const;

  /// Writes a line for each piece of each chain, as Chain does, and an empty line behind the chain.
  friend std::ostream& operator<<(std::ostream& out, const Offset& all) {
    for (const Chain& one : all.chains) out << one << '\n';
    return out;
  }
};

}  // namespace CGAL::Bounding_arcs

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Union, intersection and difference of what drawings fill. The result is made of parts of the given curves.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_BOOLEAN_OPERATIONS_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_BOOLEAN_OPERATIONS_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/overlay/overlay.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The boundary of a region, as unite(), intersection(), difference() and symmetric_difference() return it: closed
/// chains with the region to their left.
/// \code
/// const Outline_2 united = unite(tree, other);  // trees of closed curves, boolean_operations.h
/// for (const Outline_2::Chain& chain : united.chains)
///   for (const Outline_2::Part& part : chain.parts) std::cout << part.start.x << ' ' << part.start.y << '\n';
/// \endcode
/// Chains are made of parts of the given curves; nothing is fitted. A part names its curve, and has a bracket of the
/// parameter at each end. Chains round regions run counterclockwise, chains round holes clockwise, and `parent` nests
/// them. No chains are an ordinary result: the region is empty.
///
/// `status` is COMPLETE for trees with exact decisions, which are the default. The outline is then that of the exact
/// curves, to the last bit.
///
/// Take drawn_outline() to go on with the result: it makes curves of the parts, and tells how far rounding moved them.
/// The new drawing can be combined, offset and written. Take clip() to cut open curves by a region, and overlay() for
/// all faces and not one region.
struct Outline_2 {
  using Status = Overlay_2::Status;

  /// What of several drawings makes a region.
  enum class Operation : std::uint8_t {
    UNION,                ///< what any of them fills
    INTERSECTION,         ///< what all of them fill
    DIFFERENCE,           ///< what the first one fills and none of the others
    SYMMETRIC_DIFFERENCE  ///< what an odd number of them fills
  };

  /// A part of one Bezier piece.
  struct Part {
    std::uint32_t operand = 0;  ///< the number of the drawing, in the order in which they were given
    std::uint32_t curve = 0;    ///< of that drawing
    std::uint32_t bezier = 0;   ///< of that curve
    Bracket from, to;           ///< hold the parameters of start and end, which may be nearer than doubles tell
    bool is_reversed = false;   ///< whether the chain runs against the curve: `from` is above `to`
    Xy<double> start, end;      ///< these points but for rounding; neighbours share them bit for bit

    /// Writes the members in their order, with a blank between.
    friend std::ostream& operator<<(std::ostream& out, const Part& answer) {
      return out << answer.operand << ' ' << answer.curve << ' ' << answer.bezier << ' ' << answer.from << ' '
                 << answer.to << ' ' << answer.start << ' ' << answer.end;
    }
  };

  /// A closed chain that does not meet itself but at single vertices.
  struct Chain {
    std::vector<Part> parts;            ///< each starts where the one before ends, the first where the last one ends
    bool is_ccw = true;                 ///< the outside of a region; holes run clockwise
    std::optional<std::size_t> parent;  ///< the innermost chain around it

    /// Writes a line for each part.
    friend std::ostream& operator<<(std::ostream& out, const Chain& all) {
      for (const Part& one : all.parts) out << one << '\n';
      return out;
    }
  };

  struct Drawn;  ///< an outline as a drawing, below

  std::vector<Chain> chains;
  Status status = Status::COMPLETE;
  std::optional<Overlay_2::Undecided> undecided;  ///< the first one, where `status` is UNDECIDED and that is known

  /// Writes a line for each part of each chain, and an empty line behind the chain.
  friend std::ostream& operator<<(std::ostream& out, const Outline_2& all) {
    for (const Chain& one : all.chains) out << one << '\n';
    return out;
  }
};

/// An outline as a drawing in doubles, and what that is of.
/// \code
/// const Outline_2::Drawn rest = drawn_outline({&a, &b}, difference(a, b));
/// std::cout << rest.drawing.curves().size() << " curves, moved by " << rest.moved << " at most\n";
/// \endcode
struct Outline_2::Drawn {
  /// How an outline becomes a drawing.
  struct Options {
    /// Leaves out what is within rounding of nothing. A part may be within rounding of a point, or go back along the
    /// part before it. A chain may go along another curve between two parts of one curve: then these are one part.
    /// Else results that are combined again and again have more slivers each time. Rounding is what cutting may
    /// do to the parts in question, some hundred units in the last place, and 0 where no curve is cut.
    bool drops_slivers = true;
  };

  Drawing_2<double> drawing;  ///< piece k of curve i is part k of chain i of `outline`
  Outline_2 outline;          ///< what is drawn: without parts and chains that were left out, and with parts made one
  double moved = 0;  ///< points of the plane that are farther than that from the outline have the side that they had
};

/// Returns the boundary of what the closed curves of several trees fill together:
/// boolean_operation({&a, &b, &c}, Outline_2::Operation::UNION).
/// \param operation what of them makes the region; the first tree is the one that others are subtracted from
/// \param rules what the curves of all trees fill, or of each tree in turn
/// \return chains of parts of the given curves, with the region to their left. Curves that run together are one part
/// \guarantee with exact decisions the outline is that of the exact curves, to the last bit. If a tree has others, the
///   status tells whether doubles left something open
/// \throws std::invalid_argument for an open curve, for curves out of the range of queries, and for another number of
///   rules than of trees
/// \complexity (n + k) log n for n Bezier pieces and k common points, and exact arithmetic where curves touch or
///   overlap
[[nodiscard]] Outline_2 boolean_operation(const std::vector<const Bounding_arc_tree_2*>& trees,
                                          Outline_2::Operation operation, const Fill_rules& rules = Fill_rule::NONZERO);

/// Returns the boundary of what a tree's curves fill, without crossings. See boolean_operation.
[[nodiscard]] inline Outline_2 outline(const Bounding_arc_tree_2& tree, const Fill_rules& rules = Fill_rule::NONZERO) {
  return boolean_operation({&tree}, Outline_2::Operation::UNION, rules);
}
/// Returns the boundary of what either tree fills. See boolean_operation.
[[nodiscard]] inline Outline_2 unite(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b,
                                     const Fill_rules& rules = Fill_rule::NONZERO) {
  return boolean_operation({&a, &b}, Outline_2::Operation::UNION, rules);
}
/// Returns the boundary of what both trees fill. See boolean_operation.
[[nodiscard]] inline Outline_2 intersection(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b,
                                            const Fill_rules& rules = Fill_rule::NONZERO) {
  return boolean_operation({&a, &b}, Outline_2::Operation::INTERSECTION, rules);
}
/// Returns the boundary of what the first tree fills and the second one does not. See boolean_operation.
[[nodiscard]] inline Outline_2 difference(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b,
                                          const Fill_rules& rules = Fill_rule::NONZERO) {
  return boolean_operation({&a, &b}, Outline_2::Operation::DIFFERENCE, rules);
}
/// Returns the boundary of what one tree fills and not the other. See boolean_operation.
[[nodiscard]] inline Outline_2 symmetric_difference(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b,
                                                    const Fill_rules& rules = Fill_rule::NONZERO) {
  return boolean_operation({&a, &b}, Outline_2::Operation::SYMMETRIC_DIFFERENCE, rules);
}

/// Returns an outline as a drawing that can be written, read and combined again, and how far rounding moved it:
/// drawn_outline({&a, &b}, unite(a, b)). Its curves are chains, made of Bezier pieces that are parts of the given ones.
/// \param trees those that the outline was made of, in their order
/// \guarantee `moved` is certified. It counts the brackets of ends, the rounding of cuts, and that of trees whose
///   numbers are no doubles. Points of the plane that are farther than that from the outline keep their side
/// \complexity linear in the number of parts
[[nodiscard]] Outline_2::Drawn drawn_outline(const std::vector<const Bounding_arc_tree_2*>& trees,
                                             const Outline_2& outline, const Outline_2::Drawn::Options& options = {});

}  // namespace CGAL::Bounding_arcs

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The way of a conical bit along a medial axis: where it touches both sides, and the flat bottoms that it leaves.

#ifndef BOUNDING_ARCS_TOOL_TOOLPATH_V_CARVING_H
#define BOUNDING_ARCS_TOOL_TOOLPATH_V_CARVING_H

#include "Tool_pass.h"

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// A conical bit. Its tip goes as deep as the radius of the disc that it touches, times `depth`.
struct V_bit {
  double depth = 0;                                       ///< of a unit of radius; 0 to stay at height 0
  double most = std::numeric_limits<double>::infinity();  ///< how deep it may go

  /// The radius of the largest disc that it may touch.
  [[nodiscard]] double largest() const { return depth > 0 ? most / depth : std::numeric_limits<double>::infinity(); }
};
/// A bit with an angle at its tip, in degrees. \param most how deep it may go, 0 for any depth
[[nodiscard]] V_bit v_bit(double angle, double most);

/// What a bit carves.
struct V_carving {
  std::vector<Tool_pass> branches;  ///< along the axis, with heights
  std::vector<Tool_pass> pockets;  ///< outlines of flat bottoms: where the axis has larger discs than the bit may touch
  std::vector<Tool_pass> flats;    ///< of another tool, which clears what they enclose

  /// All passes of the bit, in their order.
  [[nodiscard]] std::vector<Tool_pass> of_bit() const;
};

/// Returns the branches of an axis in the order in which they are cut: part by part, each from its longest branch on;
/// then what starts nearest to the bit. Pockets come islands first, inside out.
/// \param tree what the axis is of
/// \param flat the diameter of a flat tool for what is flat, or 0: passes half of it apart, the first one half of it
///   within the outlines
/// \param file its name in messages
/// \guarantee depths are within axis.eps times bit.depth of those at which the bit touches, and so are the outlines of
///   pockets
/// \throws Input_error where there is no such inset
[[nodiscard]] V_carving v_carving(const CGAL::Bounding_arcs::Bounding_arc_tree_2& tree,
                                  const CGAL::Bounding_arcs::Medial_axis_2& axis, const V_bit& bit, double flat,
                                  const std::string& file);

}  // namespace bounding_arcs_tool

#endif

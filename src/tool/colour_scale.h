// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours that stand for sizes in pictures, and the scale below a picture that tells them.

#ifndef BOUNDING_ARCS_TOOL_COLOUR_SCALE_H
#define BOUNDING_ARCS_TOOL_COLOUR_SCALE_H

#include "svg_paths.h"

#include <ostream>
#include <string>

namespace bounding_arcs_tool {

/// The colour of a share of the largest size: from dark blue for 0 to light yellow for 1.
[[nodiscard]] std::string colour_of_share(double share);

/// A scale below a picture, which has ROOM more for it.
class Colour_scale {
 public:
  static constexpr double ROOM = 60, HEIGHT = 14;  ///< pixels
  static constexpr const char* STYLE = ".k{font-size:14px;text-anchor:middle}";

  explicit Colour_scale(const Sheet& sheet) : width_(sheet.width), top_(sheet.height - HEIGHT) {}

  /// Draws colours from 0 to 1, with numbers from 0 to the largest and what they are.
  void draw(std::ostream& out, double largest, const std::string& what) const;
  /// The x of a share.
  [[nodiscard]] double place(double share) const { return Sheet::MARGIN + (width_ - 2 * Sheet::MARGIN) * share; }
  [[nodiscard]] double top() const { return top_; }

 private:
  double width_, top_;
};

}  // namespace bounding_arcs_tool

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws the subpaths of one SVG shape as chains of Bezier curves.
// Invariant: neighbours in a subpath share their end control point bit for bit; all coordinates are finite.

#ifndef BOUNDING_ARCS_TOOL_SVG_OUTLINE_H
#define BOUNDING_ARCS_TOOL_SVG_OUTLINE_H

#include "Svg_transform.h"

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>

#include <string_view>
#include <utility>
#include <vector>

namespace bounding_arcs_tool {

using CGAL::Bounding_arcs::Bezier_curve_2;

/// A connected part of a shape, at least one piece.
struct Svg_subpath {
  std::vector<Bezier_curve_2<double>> beziers;
  bool closed = false;  ///< ended by a close command

  [[nodiscard]] const Xy<double>& start() const { return beziers.front().control_points().front(); }
  [[nodiscard]] const Xy<double>& end() const { return beziers.back().control_points().back(); }
  /// Whether a line from its end to its start would have it enclose anything: a straight line encloses nothing.
  [[nodiscard]] bool can_be_closed() const {
    return start() != end() && (beziers.size() > 1 || beziers.front().degree() > 1);
  }
};

/// The elliptical arc of a path: \param x_rotation in degrees.
struct Svg_arc {
  double rx, ry, x_rotation;
  bool large, sweep;
};

/// Takes drawing commands in the coordinates of the shape and keeps the curves in those of the drawing.
class Svg_outline {
 public:
  using Point = Xy<double>;

  explicit Svg_outline(const Svg_transform& transform) : transform_(transform) {}

  /// The current point in the coordinates of the shape.
  [[nodiscard]] const Point& current() const { return current_; }
  /// What was drawn; the outline is not used any more.
  [[nodiscard]] std::vector<Svg_subpath> subpaths() && { return std::move(subpaths_); }

  void move_to(const Point& p);
  void line_to(const Point& p) { curve_to({p}); }
  /// A Bezier curve from the current point through the other control points to the last one.
  /// \throws Svg_error when a coordinate exceeds MAXIMUM_COORDINATE in the drawing
  void curve_to(const std::vector<Point>& points, std::vector<double> weights = {});
  /// The arc from the current point to p, in pieces of at most 90 degrees; radii that are too small are scaled up, a
  /// zero radius gives a line, and p equal to the current point nothing.
  /// \source W3C, Scalable Vector Graphics 1.1, appendix F.6; the center is not computed, see the body
  void arc_to(const Svg_arc& arc, const Point& p);
  /// A quarter of an ellipse from the current point to p, tangent there to the lines through `corner`.
  void quarter_to(const Point& corner, const Point& p);
  /// A line to the start of the subpath unless the current point is there; the next command starts a new one there.
  void close();

 private:
  [[nodiscard]] Point placed(const Point& p) const;

  Svg_transform transform_;
  Point start_, current_;                // of the shape
  Point placed_start_, placed_current_;  // the same in the drawing
  bool subpath_open_ = false;
  std::vector<Svg_subpath> subpaths_;
};

/// Draws the data of a path element.
/// \throws Svg_error
void draw_path_data(std::string_view data, Svg_outline& outline);

}  // namespace bounding_arcs_tool

#endif

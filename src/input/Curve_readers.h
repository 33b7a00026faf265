// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readers of the formats of curve files.

#ifndef BOUNDING_ARCS_TOOL_CURVE_READERS_H
#define BOUNDING_ARCS_TOOL_CURVE_READERS_H

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <string>
#include <string_view>
#include <vector>

namespace bounding_arcs_tool {

using CGAL::Bounding_arcs::Curve_file;
using CGAL::Bounding_arcs::Curve_record;
using CGAL::Bounding_arcs::Input_error;

/// The curves of a JSON text: one object, or {"curves": [...]}, which may be none.
///
/// An object holds "type": "bezier", "bspline" or "nurbs"; "degree": 1 to 32; "control_points": [[x, y], ...]; and, all
/// optional, "name", "layer", "colour", "weights", "knots", "closed", "periodic", "part", "delta". Other keys are
/// ignored, a key given twice is an error. The document may hold "unit_in_mm" and "y_is_down" beside "curves" or in the
/// object.
/// * A bezier has degree + 1 control points, perhaps weights, no knots, and is never periodic.
/// * A bspline or nurbs must have "knots": a list as B_spline_curve_2 takes it, or "uniform", which
///   without "periodic" is 0, 1, 2, ...: unclamped.
/// * A nurbs must have weights; a bspline with weights is read as a nurbs.
/// * A curve may have "delta", a number above 0: it is a member of a family that a study is of.
/// * A bezier may have "part", the two parameters of the part that a study is of; others take the whole curve.
/// * "closed" is information only: nothing is added to close a curve.
/// \param stem the name of a curve without one; in a list followed by "." and its place from 1
/// \throws Input_error
[[nodiscard]] Curve_file read_json_curves(const std::string& text, const std::string& file, const std::string& stem);

/// The curves of an SVG text: one record of type PATH a subpath with at least one piece, in document order.
///
/// Read are path, rect, circle, ellipse, line, polyline and polygon within svg, g, a and switch (its first child that
/// asks for no extension and for no language or English), and what use elements refer to, wherever it stands. Other
/// elements play no part: what defs, symbol, clipPath, pattern and the like hold counts only where it is used.
/// * display, visibility, fill, fill-rule, transform and transform-origin are read of style attributes, else of
///   attributes. Style sheets, stroke, clipping and markers play no part, nor does geometry in style attributes.
/// * The fill tells what open subpaths have inside, and nothing else: none and transparent, nothing. Where a style
/// sheet
///   sets it, it is known of elements alone that set it in their style attribute.
/// * Coordinates are in the user units of the root element, y as in the file: its width, height and viewBox only
///   say what per cent means, and how long a unit is. Transforms apply, and the viewports of nested svg and symbol
///   elements.
/// * Lines become curves of degree 1, elliptical arcs rational quadratics of at most 90 degrees each (exact but for
///   rounding to double).
/// * Units are px, pt, pc, mm, cm, in, q at 96 to the inch; em, rem and ex are 16, 16 and 8 units; per cent is of
///   the viewport.
/// * Entities that the file declares are replaced by their text.
/// * A record is named after the id of its element, else after the element and its number from 1 among those of that
///   name that were read, such as path3; if it has several subpaths, followed by "." and the subpath's number from 1.
/// * The rule is that of most closed or filled shapes which have several subpaths or cross themselves; where there are
///   none of these, nonzero.
/// * Notes tell what viewers show and is left out, such as text; what is hidden, unless the options ask for it; shapes
///   and viewports without size; elements with an error in them, with all that they hold. They tell properties, too,
///   that change the picture and were not read.
/// \throws Input_error for XML that is not well-formed, for more than a million elements and pieces that use
/// elements add, and without a curve: then for the first error of an element, if there is one
[[nodiscard]] Curve_file read_svg_curves(const std::string& text, const std::string& file,
                                         const Curve_file::Options& options);

/// The curves of a DXF text: one record of type PATH an entity, in document order.
///
/// Read are LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE and POLYLINE with bulges, SPLINE with weights or through fit points,
/// and what INSERT places of blocks. z plays no part: the drawing is seen from above. Arcs become rational quadratics
/// of some 90 degrees each at most (exact but for rounding to double), lines curves of degree 1.
/// * A record is named after its layer, with a number where the layer has several; on layer 0 after kind and number.
/// * A spline that a knot cuts, as it is there degree + 1 times, is several records where it has a gap.
/// * Notes tell what is left out: other entities, those that have no curve in the plane or wrong groups, and, unless
///   the options ask for them, those in paper space, invisible ones and those on layers that are off or frozen.
/// * The length of a unit is that of $INSUNITS in the header.
/// * What blocks have counts where they are inserted, each entity once.
/// \throws Input_error for a text that is not made of groups, for more than a million entities, and without a curve
[[nodiscard]] Curve_file read_dxf_curves(std::string_view text, const std::string& file,
                                         const Curve_file::Options& options);

}  // namespace bounding_arcs_tool

#endif

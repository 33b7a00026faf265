// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A result as a drawing to be written: what DXF and plain SVG files are made of.

#ifndef BOUNDING_ARCS_TOOL_WRITTEN_WRITTEN_DRAWING_H
#define BOUNDING_ARCS_TOOL_WRITTEN_WRITTEN_DRAWING_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace bounding_arcs_tool {

/// What a drawing says of a curve beside its course.
struct Curve_look {
  std::string layer;  ///< empty for none
  CGAL::Bounding_arcs::Curve_record::Colour colour;
};
[[nodiscard]] Curve_look look_of(const CGAL::Bounding_arcs::Curve_record& record);
/// The look as members of a JSON object, a comma behind each: "layer" and "colour", where there are any.
[[nodiscard]] std::string json_members(const Curve_look& look);
/// The unit and direction of y of a drawing, likewise: "unit_in_mm" and "y_is_down".
[[nodiscard]] std::string json_members(double unit_in_mm, bool y_is_down);

using Written_piece = std::variant<CGAL::Bounding_arcs::Arc_2, CGAL::Bounding_arcs::Bezier_curve_2<double>>;
[[nodiscard]] CGAL::Bounding_arcs::Xy<double> start_of(const Written_piece& piece);
[[nodiscard]] CGAL::Bounding_arcs::Xy<double> end_of(const Written_piece& piece);

/// A Bezier curve as it is best written: a segment or an arc where it is one but for rounding.
[[nodiscard]] Written_piece written_piece(const CGAL::Bounding_arcs::Bezier_curve_2<double>& curve);

/// Pieces with a name. Where one does not start at the end of the one before, another line begins. Heights are for DXF.
struct Written_curve {
  std::string name;
  Curve_look look;
  std::vector<Written_piece> pieces;
  double height = 0;                 ///< z of all pieces, where `heights` has none
  std::vector<double> heights = {};  ///< z of each vertex of segments that follow each other: one more than pieces
};
/// The arc that two arcs are, the second behind the first: none where they are of two circles, or more than half of
/// one.
/// \guarantee the way moves by at most 2^-44 of the arc's chord
[[nodiscard]] std::optional<CGAL::Bounding_arcs::Arc_2> arc_of_both(const CGAL::Bounding_arcs::Arc_2& a,
                                                                    const CGAL::Bounding_arcs::Arc_2& b);
/// Appends a piece. Arcs of one circle that follow each other become one, up to half of it: readers and approximations
/// cut them.
void add_piece(std::vector<Written_piece>& pieces, const Written_piece& piece);
[[nodiscard]] Written_curve written_curve(const std::string& name, const Curve_look& look,
                                          const std::vector<CGAL::Bounding_arcs::Bezier_curve_2<double>>& pieces);

struct Written_drawing {
  bool y_is_down = false;
  double unit_in_mm = 0;                                           ///< 0 for none
  std::optional<CGAL::Bounding_arcs::Curve_file::Page> page = {};  ///< of SVG, as it was read
  std::vector<Written_curve> curves = {};
};

/// Calls a function of the first and the last piece but one of each run of pieces that follow each other.
void for_each_run(const std::vector<Written_piece>& pieces,
                  const std::function<void(const Written_piece* first, const Written_piece* last)>& visit);

}  // namespace bounding_arcs_tool

#endif

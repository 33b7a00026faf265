// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs query: what is asked of drawings, a file a question.

#ifndef BOUNDING_ARCS_TOOL_QUERY_QUERY_COMMAND_H
#define BOUNDING_ARCS_TOOL_QUERY_QUERY_COMMAND_H

#include "../Hierarchy.h"
#include "../reading.h"
#include "../stream/record_stream.h"
#include "../written/Written_drawing.h"
#include "Query_answer.h"

#include <CGAL/Bounding_arcs_2/query/point_location.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bounding_arcs_tool {

struct Query_options {
  std::string file, other, points, kernel = "filtered", format = "json", output;
  double eps = 0;          ///< 0: the default of the query
  bool is_signed = false;  ///< distances are less than 0 inside
  Stream_options stream;   ///< of queries of one file
  Reading_words reading;
};

/// A file's drawing, ready for queries.
struct Query_drawing {
  std::string file;
  bool flips = true;  ///< y of the plane is upwards
  std::unique_ptr<Bounding_arc_tree_2> curves;
  CGAL::Bounding_arcs::Fill_rule rule = CGAL::Bounding_arcs::Fill_rule::NONZERO;  ///< what closed curves enclose
  std::vector<std::size_t> numbers = {};  ///< of each curve among those of the file; empty where all are there
  double unit_in_mm = 0;                  ///< 0 where the file tells none
  std::optional<CGAL::Bounding_arcs::Curve_file::Page> page = {};
  std::vector<Curve_look> looks = {};  ///< of each curve of the file

  /// How a curve of the drawing is shown.
  [[nodiscard]] Curve_look look_of(std::size_t curve) const {
    return number_of(curve) < looks.size() ? looks[number_of(curve)] : Curve_look{};  // a frame has none
  }
  [[nodiscard]] File_unit unit() const { return {file, unit_in_mm}; }
  /// The number in the file of a curve of the drawing.
  [[nodiscard]] std::size_t number_of(std::size_t curve) const { return numbers.empty() ? curve : numbers[curve]; }
};
/// Loads all curves of a file, and tells what was left out. \throws Input_error
[[nodiscard]] Query_drawing load_drawing(const std::string& path, const std::string& kernel,
                                         const Reading_words& words);
/// Loads the closed curves of a file for what needs an inside. Open ones that an SVG file fills are closed by a line,
/// others are left out; both is told, too.
/// \throws Input_error also where no curve is closed
[[nodiscard]] Query_drawing load_closed_drawing(const std::string& path, const std::string& kernel,
                                                const Reading_words& words);
/// Makes the drawing of the closed curves of a file that was read, and tells its notes.
[[nodiscard]] Query_drawing closed_drawing(const std::string& file, CGAL::Bounding_arcs::Curve_file&& read,
                                           const std::string& kernel, const Reading_words& words);
/// Makes the drawing of curves that were read. \param file its name in messages
[[nodiscard]] Query_drawing query_drawing(const std::string& file, const std::vector<Curve_record>& records,
                                          const std::string& kernel, CGAL::Bounding_arcs::Fill_rule rule);
/// The drawing of a record of a stream, which has the rule of JSON where none is told.
[[nodiscard]] Query_drawing record_drawing(const std::vector<Curve_record>& records, const std::string& kernel,
                                           const Reading_words& words);

/// A place as JSON, with the number of its curve in the file.
[[nodiscard]] Json json_of(const Query_drawing& drawing, const Curve_place& place);
/// A place in a table: the curve's name, its number in the file and the Bezier piece.
[[nodiscard]] std::string name_of_place(const Query_drawing& drawing, const Curve_place& place);
/// Two numbers a line, with space or a comma between; empty lines and what follows # are left out.
/// \throws Input_error
[[nodiscard]] std::vector<Xy<double>> read_points(const std::string& path);

/// \param more what to say of it besides
/// \throws Input_error for an open curve
void check_closed(const Query_drawing& drawing, const std::string& more = "");
/// \throws Input_error for a drawing without curves, which nothing is near to
void check_has_curve(const Query_drawing& drawing);
[[nodiscard]] const char* name_of(CGAL::Uncertain<CGAL::Bounded_side> side);

// The questions; files are Query_options' file and, where there are two, other.
[[nodiscard]] Query_answer closest_query(const Query_drawing& drawing, const std::vector<Xy<double>>& points);
/// Distances with a sign and sides. \throws Input_error for an open curve
[[nodiscard]] Query_answer signed_query(const Query_drawing& drawing, const std::vector<Xy<double>>& points);
[[nodiscard]] Query_answer intersect_query(const Query_drawing& a, const Query_drawing& b);
[[nodiscard]] Query_answer self_intersect_query(const Query_drawing& a);
/// \param eps the bracket's width, of `distance` in parts of it; 0 for a default
[[nodiscard]] Query_answer distance_query(const Query_drawing& a, const Query_drawing& b, double eps);
[[nodiscard]] Query_answer hausdorff_query(const Query_drawing& a, const Query_drawing& b, double eps);
[[nodiscard]] Query_answer hull_query(const Query_drawing& drawing, double eps);
/// \throws Input_error for an open curve
[[nodiscard]] Query_answer locate_query(const Query_drawing& drawing, const std::vector<Xy<double>>& points);

CLI::App* add_query_command(CLI::App& app, Query_options& options);
int run_query(const CLI::App& command, const Query_options& options);

}  // namespace bounding_arcs_tool

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subcommands, one source file each, and what they share.

#ifndef BOUNDING_ARCS_TOOL_COMMANDS_H
#define BOUNDING_ARCS_TOOL_COMMANDS_H

#include "Hierarchy.h"
#include "number_text.h"
#include "reading.h"
#include "stream/record_stream.h"

#include <array>
#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

enum class Format { TABLE, JSON, SVG, CSV };  // TABLE is text

/// What the command line says. Each subcommand reads its own part.
struct Options {
  std::vector<std::string> files;
  Reading_words reading;
  std::string output;
  Format format = Format::TABLE;
  Kernel kernel = Kernel::DOUBLE;
  Split split = Split::MIDPOINT;
  std::vector<Method> methods;  ///< build and verify take the first
  std::vector<double> eps;
  std::size_t repeat = 5;
  std::size_t max_regions = 20'000'000;
  Stream_options stream;   ///< of build
  bool certified = false;  ///< verify proves the rounded and widened regions
};

/// Each returns the exit status; bad input is thrown as Input_error.
int run_build(const Options& options);
int run_compare(const Options& options);
int run_orders(const Options& options);
int run_compared_queries(const Options& options);
int run_verify(const Options& options);

/// A curve of one of the files, cut into spirals.
struct Loaded_curve {
  std::string file;
  Curve_record record;
  std::unique_ptr<Segmented_curve> segmented;
};

/// What `work` makes of a curve. \throws Input_error for one that can be read but is out of the range that the library
/// serves
template <class Work>
auto served(const std::string& file, const std::string& name, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::invalid_argument& error) {
    throw Input_error(file, "curve \"" + name + "\"", error.what());
  }
}

/// The curves of one file, cut into spirals. \throws Input_error
[[nodiscard]] std::vector<Loaded_curve> cut_curves(const std::string& file, std::vector<Curve_record>&& records,
                                                   Kernel kernel);
/// All curves of all files, in order, read by read_told. \throws Input_error
[[nodiscard]] std::vector<Loaded_curve> load_curves(const Options& options);

/// The hierarchy of a curve. \throws Input_error when eps cannot be reached
[[nodiscard]] std::unique_ptr<Curve_hierarchy> build_hierarchy(const Loaded_curve& curve, Method method, double eps,
                                                               const Options& options, const Progress& progress = {});

/// Shows "WHAT: done of all" on standard error while that is a terminal and the work takes its time.
class Progress_line {
 public:
  /// What is said where it is not a terminal: once, when seconds have gone and more are to come, how many.
  enum class Long_work { SILENT, ANNOUNCED };
  explicit Progress_line(std::string what, Long_work long_work = Long_work::SILENT);
  ~Progress_line();  ///< wipes the line
  Progress_line(const Progress_line&) = delete;
  Progress_line& operator=(const Progress_line&) = delete;
  void operator()(std::size_t done, std::size_t all);

 private:
  void announce(std::size_t done, std::size_t all);

  std::string what_;
  bool shown_ = false, is_to_announce_;
  double start_, last_;
};

/// What is said where rounding keeps results from an eps.
[[nodiscard]] std::string below_resolution(double eps, double reached);

/// The text as a JSON string with its quotes.
[[nodiscard]] std::string json_string(const std::string& text);

/// A name for a column of a table: on one line, with control characters escaped, cut where it is very long.
[[nodiscard]] std::string table_name(const std::string& name);

/// Arcs and segments as text. Pieces share their ends with those next to them: the last few points are kept as text.
class Piece_text {
 public:
  /// Appends the members of a piece as a JSON object, without its braces.
  void add_members(std::string& text, const Arc_2& piece);

 private:
  struct Point_text {
    Xy<double> point{};
    std::array<char, NUMBER_ROOM + 32> text{};
    std::size_t size = 0;
  };
  char* write_end(char* to, const Xy<double>& p);

  std::array<Point_text, 4> points_;  // as many as a region of two arcs a side and the one before it have in common
  std::size_t next_ = 0;
};
/// Appends where on a curve something is, as members of a JSON object: its Bezier piece and parameters of that.
void add_span_members(std::string& text, std::size_t bezier, double t0, double t1);
/// A piece as fields of CSV.
constexpr const char* PIECE_COLUMNS = "x_from,y_from,x_to,y_to,bulge";
[[nodiscard]] std::string piece_fields(const Arc_2& piece);

/// SVG of hierarchies, one group a curve (draw_svg.cpp).
struct Drawn_curve {
  const Loaded_curve* curve;
  const Curve_hierarchy* hierarchy;
};
/// Colours of a method, told apart also by the colour-blind (Okabe and Ito 2008).
struct Palette {
  const char* fill;
  const char* stroke;
};
[[nodiscard]] Palette palette(Method method);
void draw_svg(std::ostream& out, const std::vector<Drawn_curve>& curves, const char* method, const Palette& colours,
              double eps);

}  // namespace bounding_arcs_tool

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "query_command.h"

#include "../Commands.h"
#include "../Elapsed_line.h"
#include "../Output_file.h"
#include "../loose_ends.h"
#include "../option_words.h"
#include "../usage.h"

#include <CGAL/Bounding_arcs_2/curve/served_range.h>

#include <CLI/CLI.hpp>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <system_error>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

const char* const ONE_FILE = "A curve file, JSON, SVG or DXF; - reads standard input";

void add_forms(CLI::App& query, Query_options& options) {
  query
      .add_option(
          "--kernel", options.kernel,
          "filtered, exact: the curves that the file's numbers define, every verdict right, by exact arithmetic\n"
          "where doubles do not tell; double: a verdict that doubles do not tell is \"undecided\"")
      ->check(one_of({"double", "filtered", "exact"}))
      ->capture_default_str();
  add_output(query, {"json", "csv", "svg", "table"}, options.format, options.output,
             "; svg shows the answer on the curves");
}

CLI::App* add_query(CLI::App& command, const char* name, const char* what, Query_options& options, bool of_two,
                    const char* footer) {
  CLI::App* query = command.add_subcommand(name, what);
  query->add_option(of_two ? "A" : "FILE", options.file, ONE_FILE)->required();
  if (of_two) query->add_option("B", options.other, "The other one")->required();
  add_reading_options(*query, options.reading);
  add_forms(*query, options);
  if (!of_two) add_stream_options(*query, options.stream, options.format);
  query->footer(footer);
  return query;
}

void add_points(CLI::App& query, Query_options& options) {
  query.add_option("--points", options.points, "A file of points, two numbers a line; - reads standard input")
      ->required();
}

void add_eps(CLI::App& query, Query_options& options, const char* what) {
  query.add_option("--eps", options.eps, what)->check(CLI::Validator(check_tolerance, "", "eps"))->type_name("NUMBER");
}

Query_answer answer_of_one(const std::string& query, const Query_drawing& a, const std::vector<Xy<double>>& points,
                           const Query_options& options) {
  if (query == "closest") return options.is_signed ? signed_query(a, points) : closest_query(a, points);
  if (query == "hull") return hull_query(a, options.eps);
  if (query == "locate") return locate_query(a, points);
  return self_intersect_query(a);
}

Query_answer answer_of_two(const std::string& query, const Query_drawing& a, const Query_drawing& b,
                           const Query_options& options) {
  if (query == "distance") return distance_query(a, b, options.eps);
  return query == "hausdorff" ? hausdorff_query(a, b, options.eps) : intersect_query(a, b);
}

double coordinate(const std::string& file, std::size_t line, const char* text, char** end) {
  const double x = std::strtod(text, end);
  const std::string place = "line " + std::to_string(line);
  if (*end == text || !std::isfinite(x))
    throw Input_error(file, place, "expected two numbers such as 0.5 -1e3, found \"" + table_name(text) + "\"");
  if (std::fabs(x) > ba::LARGEST_QUERIED)
    throw Input_error(file, place, "expected coordinates up to 2^500 (3e150), found " + number(x));
  return x;
}

}  // namespace

std::vector<Xy<double>> read_points(const std::string& path) {
  const std::string file = path == "-" ? "stdin" : path;
  std::ifstream opened;
  if (path != "-") {
    opened.open(path);
    if (!opened) throw Input_error(file, "points", "cannot be opened: " + std::generic_category().message(errno));
  }
  std::istream& in = path == "-" ? std::cin : opened;
  std::vector<Xy<double>> points;
  std::string text;
  const auto skip = [](const char* p, bool comma) {
    while (*p == ' ' || *p == '\t' || *p == '\r') ++p;
    if (comma && *p == ',') ++p;
    return p;
  };
  for (std::size_t line = 1; std::getline(in, text); ++line) {
    text.erase((std::min)(text.find('#'), text.size()));
    const char* p = skip(text.c_str(), false);
    if (*p == '\0' && p == text.c_str() + text.size()) continue;
    char* end = nullptr;
    const double x = coordinate(file, line, p, &end);
    const double y = coordinate(file, line, skip(end, true), &end);
    if (skip(end, false) != text.c_str() + text.size())
      throw Input_error(file, "line " + std::to_string(line),
                        "expected two numbers, found more: \"" + table_name(text) + "\"");
    points.push_back({x, y});
  }
  if (in.bad()) throw Input_error(file, "points", "cannot be read: " + std::generic_category().message(errno));
  return points;
}

Query_drawing load_drawing(const std::string& path, const std::string& kernel, const Reading_words& words) {
  const ba::Curve_file file = read_told(path, words);
  Query_drawing drawing = query_drawing(name_of_file(path), file.curves, kernel, fill_rule(words.rule, file.rule));
  drawing.unit_in_mm = file.unit_in_mm;
  drawing.page = file.page;
  return drawing;
}

Query_drawing load_closed_drawing(const std::string& path, const std::string& kernel, const Reading_words& words) {
  return closed_drawing(name_of_file(path), read_joined(path, words), kernel, words);
}

Query_drawing closed_drawing(const std::string& file, ba::Curve_file&& read, const std::string& kernel,
                             const Reading_words& words) {
  const ba::Fill_rule rule = fill_rule(words.rule, read.rule);
  const std::size_t filled = close_filled(read.curves);
  if (filled > 0)
    read.notes.push_back({filled, filled == 1 ? "open curve" : "open curves",
                          "closed by a straight line, as SVG fills what is open", true});
  Query_drawing all = query_drawing(file, read.curves, kernel, rule);
  all.unit_in_mm = read.unit_in_mm;
  all.page = read.page;
  std::vector<Curve_record> closed;
  std::vector<std::size_t> numbers;
  bool is_unknown = false;  // whether open ones are filled
  for (std::size_t i = 0; i < read.curves.size(); ++i) {
    if (!all.curves->drawing().curves()[i].is_closed) {
      is_unknown = is_unknown || read.curves[i].filling == Curve_record::UNKNOWN;
      continue;
    }
    closed.push_back(std::move(read.curves[i]));
    numbers.push_back(i);
  }
  if (numbers.empty()) check_closed(all, is_unknown ? "; a style sheet, which is not read, may fill it" : "");
  const std::size_t open = read.curves.size() - numbers.size();
  if (open > 0) {
    ba::Curve_file::Note note = loose_ends(all.curves->drawing()).note();
    if (is_unknown) note.reason = "perhaps filled by a style sheet, which is not read";
    if (words.skips_open) tell(file, "left out: " + ba::Curve_file::text_of(note));
    else read.notes.push_back(std::move(note));
  }
  tell_notes(file, read.notes, words);
  if (open == 0) return all;
  Query_drawing drawing = query_drawing(file, closed, kernel, rule);
  drawing.flips = all.flips;
  drawing.unit_in_mm = all.unit_in_mm;
  drawing.page = all.page;
  drawing.looks = std::move(all.looks);
  drawing.numbers = std::move(numbers);
  return drawing;
}

Query_drawing record_drawing(const std::vector<Curve_record>& records, const std::string& kernel,
                             const Reading_words& words) {
  return query_drawing(RECORD_NAME, records, kernel, fill_rule(words.rule, ba::Fill_rule::NONZERO));
}

Query_drawing query_drawing(const std::string& file, const std::vector<Curve_record>& records,
                            const std::string& kernel, ba::Fill_rule rule) {
  Query_drawing drawing;
  drawing.file = file;
  drawing.rule = rule;
  for (const Curve_record& record : records) {
    drawing.flips = drawing.flips && !record.y_is_down;
    drawing.looks.push_back(look_of(record));
  }
  const auto index_of = [](const std::vector<Curve_record>& some, const std::string& name) {
    return name == "double"
               ? std::make_unique<Bounding_arc_tree_2>(ba::drawing<double>(some), ba::Decisions::DOUBLE)
               : std::make_unique<Bounding_arc_tree_2>(ba::drawing<CGAL::Exact_rational>(some), ba::Decisions::EXACT);
  };
  try {
    drawing.curves = index_of(records, kernel);
  } catch (const std::invalid_argument&) {  // which curve it is, and the reason
    for (const Curve_record& record : records)
      served(drawing.file, record.name, [&] { return index_of({record}, kernel); });
    throw;
  }
  return drawing;
}

Json json_of(const Query_drawing& drawing, const Curve_place& place) {
  Json json = json_of(*drawing.curves, place);
  json["curve"] = drawing.number_of(place.curve);
  return json;
}

std::string name_of_place(const Query_drawing& drawing, const Curve_place& place) {
  return table_name(drawing.curves->drawing().curves()[place.curve].name) + " " +
         std::to_string(drawing.number_of(place.curve)) + "." + std::to_string(place.bezier);
}

CLI::App* add_query_command(CLI::App& app, Query_options& options) {
  CLI::App* command = app.add_subcommand("query", "Ask: closest points, intersections, and more");
  command->require_subcommand(1);
  command->footer("`bounding_arcs query SUBCOMMAND --help` shows examples of each.\n");
  CLI::App* closest =
      add_query(*command, "closest", "The point of the curves nearest to each of some points", options, false,
                "Distances are brackets [lower, upper] that hold the true one.\nExamples:\n"
                "  echo 0.5 0.25 | bounding_arcs query closest curve.json --points -\n"
                "  echo 0.5 0.25 | bounding_arcs query closest curve.json --points - --signed\n"
                "  bounding_arcs query closest drawing.svg --points points.txt --format csv -o found.csv\n");
  add_points(*closest, options);
  CLI::Option* is_signed = closest->add_flag("--signed", options.is_signed,
                                             "Distances less than 0 inside, and the side; open curves are left out");
  add_rule(*closest, options.reading.rule)->needs(is_signed);
  CLI::App* distance =
      add_query(*command, "distance", "The least distance of two drawings, and where it is", options, true,
                "Examples:\n"
                "  bounding_arcs query distance a.json b.json\n"
                "  bounding_arcs query distance a.json b.json --eps 1e-6 --format svg -o nearest.svg\n");
  add_eps(*distance, options,
          "How wide the bracket may be, in units of the coordinates; without it 1e-12 of the distance");
  CLI::App* hausdorff = add_query(
      *command, "hausdorff", "The Hausdorff distance of two drawings: how far a point of one may be from the other",
      options, true,
      "\"directed\" has that from A to B and that from B to A; the points are those of the larger one.\nExamples:\n"
      "  bounding_arcs query hausdorff a.json b.json --eps 1e-9\n");
  add_eps(*hausdorff, options,
          "How wide the bracket may be, in units of the coordinates; without it 1e-9 of the drawings' extent");
  CLI::App* hull =
      add_query(*command, "hull", "The convex hull, width, diameter and smallest enclosing circle", options, false,
                "The hull is parts of curves and segments that touch them, counterclockwise.\nExamples:\n"
                "  bounding_arcs query hull curve.json\n"
                "  bounding_arcs query hull drawing.svg --eps 1e-3 --format svg -o hull.svg\n");
  add_eps(*hull, options,
          "How wide brackets may be, in units of the coordinates; without it 1e-6 of the drawing's extent");
  CLI::App* locate =
      add_query(*command, "locate", "Whether points are inside, outside or on closed curves", options, false,
                "\"winding\" is how often the curves run counterclockwise round the point; none is told on a curve.\n"
                "Examples:\n"
                "  echo 0.5 0.25 | bounding_arcs query locate curve.json --points -\n"
                "  bounding_arcs query locate glyphs.svg --points points.txt --rule evenodd --kernel exact\n");
  add_points(*locate, options);
  add_rule(*locate, options.reading.rule);
  add_query(
      *command, "intersect", "All common points of two drawings, and parts that they share", options, true,
      "Each point has the curve, the Bezier piece and a range of the parameter t on both, and is transversal or,\n"
      "where tangents are parallel, tangential. Parts that run together are overlaps.\nExamples:\n"
      "  bounding_arcs query intersect a.json b.json\n"
      "  bounding_arcs query intersect a.json b.json --kernel exact --format svg -o common.svg\n");
  add_query(*command, "self-intersect", "All points that the curves of a drawing pass more than once", options, false,
            "Of one curve with itself, and of two curves. Joints of neighbours do not count.\nExamples:\n"
            "  bounding_arcs query self-intersect loop.json --format table\n"
            "  bounding_arcs query self-intersect --stream --jobs 8 records.jsonl -o results.jsonl\n");
  return command;
}

int run_query(const CLI::App& command, const Query_options& options) {
  const std::string name = command.get_subcommands().front()->get_name();
  check_inputs({options.file, options.other, options.points});
  const std::vector<Xy<double>> points =
      options.points.empty() ? std::vector<Xy<double>>() : read_points(options.points);
  if (options.stream.is_on) {
    const auto answer = [&](std::vector<Curve_record>&& records, std::ostream& out) {
      write_json(out, answer_of_one(name, record_drawing(records, options.kernel, options.reading), points, options));
    };
    return run_stream(options.stream, options.file, options.output, answer);
  }
  const bool needs_inside = options.is_signed || name == "locate";
  const Query_drawing a = needs_inside ? load_closed_drawing(options.file, options.kernel, options.reading)
                                       : load_drawing(options.file, options.kernel, options.reading);
  std::vector<const Bounding_arc_tree_2*> drawings{a.curves.get()};
  Query_drawing b;
  if (!options.other.empty()) {
    Reading_words reading = options.reading;
    reading.keep_unit(a.unit());
    b = load_drawing(options.other, options.kernel, reading);
    reading.keep_unit(b.unit());
    drawings.push_back(b.curves.get());
  }
  std::optional<Elapsed_line> elapsed;
  if (points.empty()) elapsed.emplace(name);  // else points are counted
  const Query_answer answer =
      options.other.empty() ? answer_of_one(name, a, points, options) : answer_of_two(name, a, b, options);
  elapsed.reset();
  Output_file output(options.output);
  if (options.format == "json") write_json(output.stream(), answer);
  else if (options.format == "csv") write_csv(output.stream(), answer);
  else if (options.format == "table") write_table(output.stream(), answer);
  else write_svg(output.stream(), answer, drawings, a.flips);
  output.commit();
  if (answer.is_limited)
    std::cerr << "bounding_arcs: " << options.file
              << ": the search ended at its limit; its brackets are right, but wider\n";
  return 0;
}

}  // namespace bounding_arcs_tool

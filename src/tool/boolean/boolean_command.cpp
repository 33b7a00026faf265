// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs boolean: union, intersection and differences of what drawings fill, made of parts of their curves.

#include "boolean_command.h"

#include "path_pieces.h"
#include "written_path.h"

#include "../../input/Input_text.h"
#include "../Commands.h"
#include "../Elapsed_line.h"
#include "../Output_file.h"
#include "../dxf/write_dxf.h"
#include "../option_words.h"
#include "../query/query_command.h"
#include "../svg_paths.h"
#include "../usage.h"
#include "../written/write_plain_svg.h"

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

const std::map<std::string, ba::Outline_2::Operation> OPERATIONS{
    {"union", ba::Outline_2::Operation::UNION},
    {"intersection", ba::Outline_2::Operation::INTERSECTION},
    {"difference", ba::Outline_2::Operation::DIFFERENCE},
    {"symmetric-difference", ba::Outline_2::Operation::SYMMETRIC_DIFFERENCE}};

// Other words for the operations.
std::string with_main_word(std::string& operation) {
  static const std::map<std::string, std::string> OTHERS{{"or", "union"},
                                                         {"and", "intersection"},
                                                         {"intersect", "intersection"},
                                                         {"subtract", "difference"},
                                                         {"xor", "symmetric-difference"},
                                                         {"symdiff", "symmetric-difference"}};
  if (const auto found = OTHERS.find(operation); found != OTHERS.end()) operation = found->second;
  return "";
}

/// What a file's curves fill; those of a stream are combined with the same others.
using Operand = std::shared_ptr<const Query_drawing>;
Operand operand(Query_drawing drawing) { return std::make_shared<const Query_drawing>(std::move(drawing)); }

/// What was computed, and of what.
struct Combined {
  std::vector<Operand> operands;
  ba::Outline_2::Drawn drawn;

  [[nodiscard]] bool y_is_down() const {
    return std::any_of(operands.begin(), operands.end(), [](const Operand& d) { return !d->flips; });
  }
  [[nodiscard]] double unit_in_mm() const {
    for (const Operand& operand : operands)
      if (operand->unit_in_mm > 0) return operand->unit_in_mm;
    return 0;
  }
};

Combined combined(const Boolean_words& words, std::vector<Operand> given) {
  Combined made;
  made.operands = std::move(given);
  std::vector<const ba::Bounding_arc_tree_2*> trees;
  std::vector<const ba::Drawing_2<double>*> drawings;
  std::vector<ba::Fill_rule> rules;
  for (const Operand& d : made.operands) {
    trees.push_back(d->curves.get());
    drawings.push_back(&d->curves->drawing());
    rules.push_back(d->rule);
  }
  std::optional<Elapsed_line> elapsed;
  if (!words.stream.is_on) elapsed.emplace(words.operation);
  const ba::Outline_2 outline =
      ba::boolean_operation(trees, OPERATIONS.at(words.operation), ba::Fill_rules(std::move(rules)));
  if (outline.status == ba::Outline_2::Status::UNDECIDED)
    throw Input_error(made.operands.front()->file, words.operation,
                      message_of_undecided(outline.undecided, drawings, words.kernel));
  made.drawn = ba::drawn_outline(trees, outline);
  return made;
}

void write_json(std::ostream& out, const Combined& made, const std::string& operation) {
  out << "{\"operation\":\"" << operation << "\",\"status\":\"complete\",\"moved\":" << number(made.drawn.moved) << ','
      << json_members(made.unit_in_mm(), made.y_is_down()) << "\"curves\":[";
  const char* between_chains = "\n";
  for (std::size_t i = 0; i < made.drawn.outline.chains.size(); ++i) {
    const ba::Outline_2::Chain& chain = made.drawn.outline.chains[i];
    const auto& curve = made.drawn.drawing.curves()[i];
    const ba::Outline_2::Part& first = chain.parts.front();
    const Query_drawing& drawn = *made.operands[first.operand];
    out << between_chains << "{\"name\":" << json_string(drawn.curves->drawing().curves()[first.curve].name) << ','
        << json_members(drawn.look_of(first.curve)) << "\"type\":\"path\",\"closed\":true,\"orientation\":\""
        << (chain.is_ccw ? "ccw" : "cw") << "\",\"parent\":";
    if (chain.parent) out << *chain.parent;
    else out << "null";
    out << ',';
    write_pieces(out, chain.parts.size(), [&](std::size_t k) {
      const ba::Outline_2::Part& part = chain.parts[k];
      Json piece = piece_json(curve.beziers[k]), source = {{"operand", part.operand}};
      const Query_drawing& from = *made.operands[part.operand];
      source.update(source_json(part, from.number_of(part.curve), from.curves->drawing().curves()[part.curve].name));
      piece["source"] = std::move(source);
      return piece;
    });
    out << '}';
    between_chains = ",\n";
  }
  out << "]}\n";
}

void write_closed_path(std::ostream& out, const View& view, const ba::Drawing_2<double>::Curve& curve) {
  bool is_first = true;
  for (const auto& piece : curve.beziers) {
    const std::string path = curve_path(view, piece);  // begins with "M" and a point
    out << (is_first ? path : path.substr(path.find_first_of("LQCA")));
    is_first = false;
  }
  out << 'Z';
}

void draw(std::ostream& out, const Combined& made, const std::string& operation) {
  Box box;
  bool flips = true;
  for (const Operand& operand : made.operands) {
    flips = flips && operand->flips;
    for (const auto& curve : operand->curves->drawing().curves())
      for (const auto& piece : curve.beziers) box.add(piece);
  }
  const Sheet sheet(box, flips);
  char text[900];
  std::snprintf(text, sizeof text,
                "<svg %s width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n"
                "<title>%s: %zu chains</title>\n"
                "<style>path{vector-effect:non-scaling-stroke;stroke-linejoin:round}\n"
                ".a{fill:none;stroke:#999;stroke-width:1}\n"
                ".r{fill:#0072b2;fill-opacity:.25;fill-rule:evenodd;stroke:#0072b2;stroke-width:2}</style>\n"
                "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n"
                "<text x=\"%.0f\" y=\"36\" font-family=\"sans-serif\" font-size=\"20\" fill=\"#333\">%s: %zu "
                "chains</text>\n"
                "<text x=\"%.0f\" y=\"58\" font-family=\"sans-serif\" font-size=\"14\" fill=\"#777\">grey: the curves "
                "given; blue: the region</text>\n",
                SVG_NAMESPACES, sheet.width, sheet.height, sheet.width, sheet.height, operation.c_str(),
                made.drawn.outline.chains.size(), Sheet::MARGIN, operation.c_str(), made.drawn.outline.chains.size(),
                Sheet::MARGIN);
  out << text << layer_start("operands");
  for (const Operand& operand : made.operands)
    for (const auto& curve : operand->curves->drawing().curves()) {
      out << "<g><title>" << escaped(curve.name) << "</title><path class=\"a\" d=\"";
      write_closed_path(out, sheet.view, curve);
      out << "\"/></g>\n";
    }
  out << "</g>\n" << layer_start("region") << "<path class=\"r\" d=\"";
  for (const auto& curve : made.drawn.drawing.curves()) write_closed_path(out, sheet.view, curve);
  out << "\"/>\n</g>\n</svg>\n";
}

// A chain has the name and the look of the curve of its first part.
Written_drawing written(const Combined& made, const Boolean_words& words) {
  Written_drawing drawing;
  drawing.y_is_down = made.y_is_down();
  drawing.unit_in_mm = made.unit_in_mm();
  for (const Operand& operand : made.operands)
    if (!drawing.page) drawing.page = operand->page;
  for (std::size_t i = 0; i < made.drawn.outline.chains.size(); ++i) {
    const ba::Outline_2::Part& part = made.drawn.outline.chains[i].parts.front();
    const Query_drawing& from = *made.operands[part.operand];
    drawing.curves.push_back(written_path(from.file, from.curves->drawing().curves()[part.curve].name,
                                          from.look_of(part.curve), made.drawn.drawing.curves()[i].beziers,
                                          words.path));
  }
  return drawing;
}

}  // namespace

CLI::App* add_boolean_command(CLI::App& app, Boolean_words& words) {
  CLI::App* command =
      app.add_subcommand("boolean", "Union, intersection and differences of closed curves, on the curves themselves");
  command
      ->add_option("OPERATION", words.operation,
                   "union, intersection, difference or symmetric-difference; or, and, subtract and xor are these, too")
      ->required()
      ->check(one_of(names_of(OPERATIONS)))
      ->transform(CLI::Validator(with_main_word, "", "operation"));
  command->add_option("FILES", words.files, "Curve files, JSON, SVG or DXF, one an operand; - reads standard input")
      ->required();
  add_rule(*command, words.reading.rule);
  add_reading_options(*command, words.reading);
  command
      ->add_option("--kernel", words.kernel,
                   "double: fast, and refused where doubles do not tell; filtered, exact: the curves that the file's\n"
                   "numbers define, every decision right")
      ->check(one_of({"double", "filtered", "exact"}))
      ->capture_default_str();
  add_output(*command, {"json", "svg", "dxf"}, words.format, words.output, "; dxf has splines, or arcs within --eps");
  add_path_options(*command, words.path);
  add_dxf_entities(*command, words.dxf);
  add_stream_options(*command, words.stream, words.format);
  command->footer(
      "What a file's closed curves fill is an operand, by the file's own rule without --rule. Open curves are left "
      "out,\n"
      "but those that an SVG file fills are closed. \"difference\" is the first file without the others, \"union\" of "
      "one\n"
      "file its outline without crossings. Pieces of the result are parts of the given curves, with their \"source\".\n"
      "Chains have the region to their left. JSON output can be read as a curve file, as often as one likes; \"moved\" "
      "is\n"
      "how far rounding moved the curves at most.\n"
      "With --stream the first file has a record a line, and each is combined with the others.\n"
      "Examples:\n"
      "  bounding_arcs boolean union a.json b.json -o both.json\n"
      "  bounding_arcs boolean difference plate.svg holes.svg --format svg -o plate_with_holes.svg\n"
      "  bounding_arcs boolean union drawing.svg logo.svg --plain -o both.svg\n"
      "  bounding_arcs boolean union drawing.svg | bounding_arcs offset - --distance -1 --eps 0.01\n"
      "  bounding_arcs boolean intersection a.dxf b.dxf -o common.dxf\n"
      "  bounding_arcs boolean intersection a.json b.json --format dxf --eps 1e-4 -o common.dxf\n"
      "  bounding_arcs boolean difference --stream --jobs 8 glyphs.jsonl stencil.json -o cut.jsonl\n");
  return command;
}

int run_boolean(const Boolean_words& words) {
  check_inputs(words.files);
  check_path_words(words.path, words.format);
  std::vector<Operand> others;
  Reading_words reading = words.reading;
  for (std::size_t i = words.stream.is_on ? 1 : 0; i < words.files.size(); ++i) {
    others.push_back(operand(load_closed_drawing(words.files[i], words.kernel, reading)));
    reading.keep_unit(others.back()->unit());
  }
  if (words.stream.is_on) {
    const auto answer = [&](std::vector<Curve_record>&& records, std::ostream& out) {
      std::vector<Operand> all{operand(record_drawing(records, words.kernel, words.reading))};
      check_closed(*all.front());
      all.insert(all.end(), others.begin(), others.end());
      write_json(out, combined(words, std::move(all)), words.operation);
    };
    return run_stream(words.stream, words.files.front(), words.output, answer);
  }
  if (words.format == "dxf") tell_units_of_dxf(reading.unit);
  const Combined made = combined(words, std::move(others));
  Output_file output(words.output);
  if (words.format == "json") write_json(output.stream(), made, words.operation);
  else if (words.format == "dxf") write_dxf(output.stream(), written(made, words), dxf_entities(words.dxf));
  else if (words.path.is_plain) write_plain_svg(output.stream(), written(made, words));
  else draw(output.stream(), made, words.operation);
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool

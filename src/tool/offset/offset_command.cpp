// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs offset: offset curves without self-intersections, as JSON or a picture.

#include "offset_command.h"

#include "../Commands.h"
#include "../Elapsed_line.h"
#include "../Output_file.h"
#include "../dxf/write_dxf.h"
#include "../loose_ends.h"
#include "../option_words.h"
#include "../query/query_command.h"
#include "../svg_paths.h"
#include "../toolpath/order_passes.h"
#include "../usage.h"
#include "../written/write_plain_svg.h"

#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <stdexcept>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

std::vector<double> numbers_of(const std::string& list) {
  std::vector<double> numbers;
  for (const std::string& word : words_between_commas(list)) numbers.push_back(std::strtod(word.c_str(), nullptr));
  return numbers;
}
}  // namespace

std::string check_distances(const std::string& list) {
  for (const std::string& word : words_between_commas(list)) {
    char* end = nullptr;
    const double d = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !std::isfinite(d)) return expected("a number such as 0.1 or -0.1", word);
  }
  return "";
}

namespace {

double eps_of(const Offset_words& words) { return std::strtod(words.eps.c_str(), nullptr); }

ba::Offset::Options options_of(const Offset_words& words) {
  static const std::map<std::string, ba::Offset::Join> JOINS{
      {"round", ba::Offset::Join::ROUND}, {"miter", ba::Offset::Join::MITER}, {"bevel", ba::Offset::Join::BEVEL}};
  static const std::map<std::string, ba::Offset::Cap> CAPS{
      {"round", ba::Offset::Cap::ROUND}, {"butt", ba::Offset::Cap::BUTT}, {"square", ba::Offset::Cap::SQUARE}};
  static const std::map<std::string, ba::Offset::Side> SIDES{
      {"both", ba::Offset::Side::BOTH}, {"left", ba::Offset::Side::LEFT}, {"right", ba::Offset::Side::RIGHT}};
  ba::Offset::Options options;
  options.join = JOINS.at(words.join);
  options.miter_limit = words.miter_limit;
  options.cap = CAPS.at(words.cap);
  options.side = SIDES.at(words.side);
  return options;
}

// Within an eps as large as the distance anything is right, an empty result, too. At distance 0 curves do not move.
void check_eps(const Offset_words& words) {
  const double eps = eps_of(words);
  for (const double d : numbers_of(words.distances))
    if (d != 0 && eps >= std::fabs(d))
      throw Usage_error("--eps", "less than the size of --distance " + number(d), number(eps));
}

const char* const KINDS[] = {"curve", "join", "cap"};

void write_csv(std::ostream& out, const std::vector<ba::Offset>& offsets, const ba::Drawing_2<double>& drawing) {
  out << "distance,chain,of,curve,bezier,t,t_end,bezier_end," << PIECE_COLUMNS << '\n';
  for (const ba::Offset& offset : offsets)
    for (std::size_t i = 0; i < offset.chains.size(); ++i)
      for (const ba::Offset::Piece& p : offset.chains[i].pieces)
        out << number(offset.distance) << ',' << i << ',' << KINDS[static_cast<int>(p.kind)] << ','
            << csv_field(drawing.curves()[p.source.curve].name) << ',' << p.source.bezier << ',' << number(p.source.t)
            << ',' << number(p.t_end) << ',' << p.bezier_of_end() << ',' << piece_fields(p.arc) << '\n';
}

void write_chain(std::ostream& out, const ba::Offset::Chain& chain, const ba::Drawing_2<double>& drawing) {
  out << "{\"closed\":" << (chain.is_closed ? "true" : "false") << ",\"orientation\":\""
      << (chain.is_ccw ? "ccw" : "cw") << "\",\"parent\":";
  if (chain.parent) out << *chain.parent;
  else out << "null";
  out << ",\"area\":" << number(chain.area) << ",\"pieces\":[";
  std::string text;
  Piece_text pieces;
  const char* separator = "\n{";
  for (const ba::Offset::Piece& p : chain.pieces) {
    text = separator;
    pieces.add_members(text, p.arc);
    out << text << ",\"of\":\"" << KINDS[static_cast<int>(p.kind)] << "\",\"source\":{\"curve\":" << p.source.curve
        << ",\"name\":" << json_string(drawing.curves()[p.source.curve].name) << ",\"bezier\":" << p.source.bezier
        << ",\"t\":" << number(p.source.t) << ",\"t_end\":" << number(p.t_end)
        << ",\"bezier_end\":" << p.bezier_of_end() << "}}";
    separator = ",\n{";
  }
  out << "]}";
}

void write_json(std::ostream& out, const std::vector<ba::Offset>& offsets, const ba::Drawing_2<double>& drawing,
                double eps, const std::string& members = "") {
  out << "{\"eps\":" << number(eps) << ',' << members << "\"offsets\":[";
  const char* between_offsets = "\n";
  for (const ba::Offset& offset : offsets) {
    out << between_offsets << "{\"distance\":" << number(offset.distance) << ",\"error\":" << number(offset.error)
        << ",\"chains\":[";
    const char* between_chains = "\n";
    for (const ba::Offset::Chain& chain : offset.chains) {
      out << between_chains;
      write_chain(out, chain, drawing);
      between_chains = ",\n";
    }
    out << "]}";
    between_offsets = ",\n";
  }
  out << "]}\n";
}

void draw(std::ostream& out, const std::vector<ba::Offset>& offsets, const ba::Drawing_2<double>& drawing, double eps,
          bool flips) {
  Box box;
  std::size_t chains = 0;
  for (const auto& curve : drawing.curves())
    for (const auto& piece : curve.beziers)
      for (const Xy<double>& p : piece.control_points()) box.add(p);
  for (const ba::Offset& offset : offsets) {
    chains += offset.chains.size();
    for (const ba::Offset::Chain& chain : offset.chains)
      for (const ba::Offset::Piece& p : chain.pieces) {
        box.add(p.arc.from);
        box.add(p.arc.to);
        box.add(middle(p.arc));
      }
  }
  const Sheet sheet(box, flips);
  const auto is_drawn = [&](bool shrunk) {
    return std::any_of(offsets.begin(), offsets.end(),
                       [&](const ba::Offset& o) { return (o.distance < 0) == shrunk && !o.chains.empty(); });
  };
  const std::string eps_text = short_number(eps);
  char text[700];
  std::snprintf(
      text, sizeof text,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n"
      "<title>offsets within %s: %zu chains</title>\n"
      "<style>path{fill:none;vector-effect:non-scaling-stroke;stroke-linejoin:round}\n"
      ".c{stroke:#888;stroke-width:2.5}\n.o{stroke:#0072b2;stroke-width:1.4}\n.i{stroke:#d55e00;stroke-width:1.4}"
      "</style>\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n"
      "<text x=\"%.0f\" y=\"36\" font-family=\"sans-serif\" font-size=\"20\" fill=\"#333\">offsets within %s: %zu "
      "chains</text>\n"
      "<text x=\"%.0f\" y=\"58\" font-family=\"sans-serif\" font-size=\"14\" fill=\"#777\">grey: the "
      "curve%s%s%s</text>\n",
      sheet.width, sheet.height, sheet.width, sheet.height, eps_text.c_str(), chains, Sheet::MARGIN, eps_text.c_str(),
      chains, Sheet::MARGIN, drawing.curves().size() == 1 ? "" : "s", is_drawn(false) ? "; blue: grown" : "",
      is_drawn(true) ? "; orange: shrunk" : "");
  out << text;
  for (const auto& curve : drawing.curves()) {
    out << "<g><title>" << escaped(curve.name) << "</title>\n<path class=\"c\" d=\"";
    for (const auto& piece : curve.beziers) out << curve_path(sheet.view, piece);
    out << "\"/></g>\n";
  }
  for (const ba::Offset& offset : offsets) {
    out << "<g><title>" << short_number(offset.distance) << "</title>\n<path class=\""
        << (offset.distance < 0 ? 'i' : 'o') << "\" d=\"";
    for (const ba::Offset::Chain& chain : offset.chains) {
      out << "M" << sheet.view(chain.pieces.front().arc.from);
      for (const ba::Offset::Piece& p : chain.pieces) out << step(sheet.view, p.arc, true);
      if (chain.is_closed) out << "Z";
    }
    out << "\"/></g>\n";
  }
  out << "</svg>\n";
}

// A pass a chain.
std::vector<Tool_pass> tool_passes(const std::vector<ba::Offset>& offsets, double depth) {
  std::vector<Tool_pass> passes;
  for (const ba::Offset& offset : offsets)
    for (const ba::Offset::Chain& chain : offset.chains) {
      passes.push_back({"offset " + number(offset.distance), {}, -depth});
      for (const ba::Offset::Piece& piece : chain.pieces) passes.back().pieces.push_back(piece.arc);
    }
  return inside_out(passes);
}

ba::Offset served_offset(const ba::Offset_source_2& source, double d, const std::string& file) {
  try {
    return source.at(d);
  } catch (const std::invalid_argument& error) {
    throw Input_error(file, "offset", error.what());
  }
}

ba::Offset offset_at(const ba::Offset_source_2& source, double d, double eps, const std::string& file) {
  ba::Offset offset = served_offset(source, d, file);
  if (offset.status == ba::Offset::Status::RESOLUTION_REACHED)
    throw Input_error(file, "offset", below_resolution(eps, offset.error));
  if (offset.status == ba::Offset::Status::UNRESOLVED)
    throw Input_error(file, "offset",
                      "at distance " + number(d) + " its parts touch " +
                          (offset.unresolved ? "at about " + place_text(*offset.unresolved) + " " : "") +
                          "in a way that cannot be told apart; change the distance a little");
  return offset;
}

// What is offset.
struct Offset_input {
  std::string file;
  ba::Drawing_2<double> drawing;
  ba::Fill_rule rule = ba::Fill_rule::NONZERO;
  bool flips = true;  // y of the plane is upwards
  double unit_in_mm = 0;
  std::optional<ba::Curve_file::Page> page = {};
  std::vector<Curve_look> looks = {};  // of each curve
};
Offset_input offset_input(const Offset_words& words) {
  const ba::Curve_file read = read_told(words.file, words.reading);
  Offset_input input{name_of_file(words.file), ba::drawing<double>(read.curves),
                     fill_rule(words.reading.rule, read.rule)};
  for (const Curve_record& record : read.curves) {
    input.flips = input.flips && !record.y_is_down;
    input.looks.push_back(look_of(record));
  }
  input.unit_in_mm = read.unit_in_mm;
  input.page = read.page;
  return input;
}

// A layer a distance; a chain has the name and the colour of the curve that its first piece is an offset of.
Written_drawing written(const std::vector<ba::Offset>& offsets, const Offset_input& input) {
  Written_drawing drawing{!input.flips, input.unit_in_mm, input.page};
  for (const ba::Offset& offset : offsets)
    for (const ba::Offset::Chain& chain : offset.chains) {
      const std::size_t source = chain.pieces.front().source.curve;
      drawing.curves.push_back(
          {input.drawing.curves()[source].name, {"offset_" + number(offset.distance), input.looks[source].colour}, {}});
      for (const ba::Offset::Piece& piece : chain.pieces) drawing.curves.back().pieces.push_back(piece.arc);
    }
  return drawing;
}

// Ends that meet are those of an outline, as a rule, which is not what is offset; an open curve among closed ones may
// be a note.
void tell_loose_ends(const std::string& file, const ba::Drawing_2<double>& drawing, const Reading_words& words) {
  const Loose_ends ends = loose_ends(drawing);
  if (ends.gaps > 0) tell_change(file, ends.text(), words);
  else if (ends.open > 0 && ends.open < drawing.curves().size())
    tell_change(file,
                "taken for open: " + ends.text() + "; --skip-open leaves " + (ends.open == 1 ? "it" : "them") + " out",
                words);
}

ba::Offset_source_2 served_source(const std::string& file, const ba::Drawing_2<double>& drawing, double eps,
                                  const ba::Offset::Options& options) {
  try {
    return ba::Offset_source_2(ba::Bounding_arc_tree_2(drawing), eps, options);
  } catch (const std::invalid_argument& error) {
    for (const auto& curve : drawing.curves())  // which curve it is, and the reason
      (void)served(file, curve.name, [&] {
        ba::Drawing_2<double> one;
        one.add(curve.beziers);
        return ba::Offset_source_2(ba::Bounding_arc_tree_2(one), eps, options);
      });
    throw Input_error(file, "offset", error.what());
  }
}

// \param is_stream a record of one shows no progress
std::vector<ba::Offset> offsets_of(const Offset_words& words, const std::string& file,
                                   const ba::Drawing_2<double>& drawing, ba::Fill_rule rule, bool is_stream) {
  const double eps = eps_of(words);
  ba::Offset::Options options = options_of(words);
  options.rule = rule;
  std::optional<Elapsed_line> elapsed;
  const auto show = [&](const std::string& what) {
    if (!is_stream) elapsed.emplace(what);
  };
  show("preparing offsets");
  const ba::Offset_source_2 source = served_source(file, drawing, eps, options);
  elapsed.reset();
  std::vector<ba::Offset> offsets;
  const std::vector<double> distances = numbers_of(words.distances);
  const bool is_inwards = std::any_of(distances.begin(), distances.end(), [](double d) { return d < 0; });
  if (is_inwards && options.side == ba::Offset::Side::BOTH && !is_stream)
    tell_left_out(file, "offset", source.left_out().size(), rule);
  for (const double d : distances) {
    show("offset " + std::to_string(offsets.size() + 1) + " of " + std::to_string(distances.size()));
    offsets.push_back(offset_at(source, d, eps, file));
  }
  return offsets;
}

}  // namespace

CLI::App* add_offset_command(CLI::App& app, Offset_words& words) {
  CLI::App* offset = app.add_subcommand("offset", "Offset curves and whole drawings, without self-intersections");
  offset->add_option("FILE", words.file, "A curve file, JSON, SVG or DXF; - reads standard input")->required();
  offset
      ->add_option("--distance", words.distances,
                   "How far, several with commas between: above 0 grows what closed curves enclose, below 0 shrinks\n"
                   "it, whatever their direction; open curves, and outlines of loose lines, get the band\naround them")
      ->required()
      ->check(CLI::Validator(check_distances, "", "distance"))
      ->type_name("LIST");
  offset
      ->add_option("--eps", words.eps,
                   "How far from the distance points of the result may be, in units of the coordinates")
      ->required()
      ->check(CLI::Validator(check_tolerance, "", "eps"))
      ->type_name("NUMBER");
  offset->add_option("--join", words.join, "What goes round corners")
      ->check(one_of({"round", "miter", "bevel"}))
      ->capture_default_str();
  offset
      ->add_option("--miter-limit", words.miter_limit,
                   "A miter whose tip is farther than that times the distance becomes a bevel")
      ->check(number_in(1, 1e6))
      ->capture_default_str();
  offset->add_option("--cap", words.cap, "What goes round ends of open curves")
      ->check(one_of({"round", "butt", "square"}))
      ->capture_default_str();
  offset
      ->add_option("--side", words.side,
                   "Of open curves the whole boundary of the band, or what is to the left or the right of the curve")
      ->check(one_of({"both", "left", "right"}))
      ->capture_default_str();
  add_rule(*offset, words.reading.rule);
  add_reading_options(*offset, words.reading);
  add_output(*offset, {"json", "csv", "svg", "dxf", "gcode"}, words.format, words.output);
  add_plain(*offset, words.is_plain);
  add_dxf_entities(*offset, words.dxf);
  add_gcode_options(*offset, words.gcode, true);
  add_stream_options(*offset, words.stream, words.format);
  offset->footer(
      "The result is chains of arcs and segments. Closed ones run counterclockwise around what they enclose and\n"
      "clockwise around holes; \"parent\" is the number of the chain around one. Each piece has its \"source\": the\n"
      "curve, and the Bezier pieces and parameters of its start and end. What is on one circle or line is one piece, "
      "but\n"
      "arcs are at most half circles; a circle is two, and a CIRCLE in DXF. All points of round pieces are within eps\n"
      "of the distance from the curves, which is certified. What vanishes leaves no chain.\n"
      "G-code has a pass a chain, islands first, inside out: each chain comes before what is around it. Of those that\n"
      "may come next it is the one that starts nearest to the tool. Lines stand for arcs that rounding would break.\n"
      "Examples:\n"
      "  bounding_arcs offset curve.json --distance 0.05 --eps 1e-5\n"
      "  bounding_arcs offset drawing.svg --distance -1,-2,-3 --eps 0.01 --format svg -o pocket.svg\n"
      "  bounding_arcs offset part.dxf --units mm --distance -1 --eps 0.01 -o inset.dxf\n"
      "  bounding_arcs offset drawing.svg --distance -1 --eps 0.01 --plain -o inset.svg\n"
      "  bounding_arcs offset part.dxf --distance -1.5,-2.5,-3.5 --eps 0.01 --feed 600 --depth 2 -o pocket.nc\n"
      "  bounding_arcs offset path.svg --distance 2 --eps 1e-3 --cap square --join miter -o outline.json\n"
      "  bounding_arcs offset path.svg --distance 2 --eps 1e-3 --side left\n"
      "  bounding_arcs offset --distance 2 --eps 1e-3 --stream - < records.jsonl > results.jsonl\n");
  return offset;
}

std::vector<Offset_outline> offset_outlines(const Offset_words& words, const Query_drawing& loaded) {
  std::vector<Offset_outline> outlines;
  tell_loose_ends(loaded.file, loaded.curves->drawing(), words.reading);
  const std::vector<ba::Offset> offsets = offsets_of(words, loaded.file, loaded.curves->drawing(), loaded.rule, false);
  for (const ba::Offset& offset : offsets) {
    outlines.push_back({offset.distance, {}});
    for (const ba::Offset::Chain& chain : offset.chains) {
      outlines.back().chains.emplace_back();
      for (const ba::Offset::Piece& p : chain.pieces) outlines.back().chains.back().push_back(p.arc);
    }
  }
  return outlines;
}

int run_offset(const Offset_words& words) {
  check_eps(words);
  check_plain(words.is_plain, words.format);
  const bool is_gcode = words.format == "gcode";
  if (is_gcode) check_gcode_words(words.gcode);
  const double eps = eps_of(words);
  if (words.stream.is_on) {
    const auto answer = [&](std::vector<Curve_record>&& records, std::ostream& out) {
      const ba::Drawing_2<double> drawing = ba::drawing<double>(records);
      const ba::Fill_rule rule = fill_rule(words.reading.rule, ba::Fill_rule::NONZERO);
      write_json(out, offsets_of(words, RECORD_NAME, drawing, rule, true), drawing, eps);
    };
    return run_stream(words.stream, words.file, words.output, answer);
  }
  const Offset_input input = offset_input(words);
  const ba::Drawing_2<double>& drawing = input.drawing;
  tell_loose_ends(input.file, drawing, words.reading);
  if (words.format == "dxf") tell_units_of_dxf({input.file, input.unit_in_mm});
  const Gcode_setup setup =
      is_gcode ? gcode_setup(words.gcode, {input.file, input.unit_in_mm}, !input.flips) : Gcode_setup{};
  const std::vector<ba::Offset> offsets = offsets_of(words, input.file, drawing, input.rule, false);
  Output_file output(words.output);
  if (words.format == "json")
    write_json(output.stream(), offsets, drawing, eps, json_members(input.unit_in_mm, !input.flips));
  else if (words.format == "dxf") write_dxf(output.stream(), written(offsets, input), dxf_entities(words.dxf));
  else if (words.is_plain) write_plain_svg(output.stream(), written(offsets, input));
  else if (words.format == "csv") write_csv(output.stream(), offsets, drawing);
  else if (is_gcode) write_gcode(output.stream(), input.file, tool_passes(offsets, setup.depth), setup);
  else draw(output.stream(), offsets, drawing, eps, input.flips);
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool

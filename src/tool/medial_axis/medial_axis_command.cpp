// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs medial-axis: the medial axis of what closed curves enclose, or the Voronoi diagram of curves in a
// frame, as JSON or a picture.

#include "medial_axis_command.h"

#include "axis_cells.h"
#include "found_axis.h"
#include "write_axis.h"

#include "../Commands.h"
#include "../Output_file.h"
#include "../dxf/write_dxf.h"
#include "../option_words.h"
#include "../query/query_command.h"
#include "../svg_paths.h"
#include "../toolpath/v_carving.h"
#include "../toolpath/write_carving.h"
#include "../usage.h"
#include "../written/write_plain_svg.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

// Items of a list with what goes between them.
template <class Items, class Write>
void write_list(std::ostream& out, const Items& items, const char* between, const Write& write) {
  const char* separator = "";
  for (const auto& item : items) {
    out << separator;
    write(item);
    separator = between;
  }
}
std::string pair_of(const Xy<double>& p) { return number(p.x) + "," + number(p.y); }

void write_json(std::ostream& out, const Found_axis& found, const Query_drawing& loaded,
                const Medial_axis_words& words) {
  const ba::Medial_axis_2& axis = found.axis;
  const Bounding_arc_tree_2& curves = *loaded.curves;
  const double depth = words.v_bit > 0 ? 1 / std::tan(words.v_bit * DEGREE / 2) : 0;  // of a unit of radius
  const auto place = [&](const Curve_place& p) { out << json_of(loaded, p).dump(); };
  out << "{\"eps\":" << number(axis.eps) << ",\"moved\":" << number(axis.moved);
  if (words.is_framed) out << ",\"frame\":" << curves.drawing().curves().size() - 1;
  out << ",\"regions\":" << axis.regions << ",\"holes\":" << axis.holes << ",\"error\":" << number(axis.error)
      << ",\"rule\":\"" << name_of(loaded.rule) << "\"";
  if (axis.status == ba::Medial_axis_2::Status::UNRESOLVED) {
    out << ",\"status\":\"unresolved\",\"unresolved\":[";
    write_list(out, axis.unresolved, ",", [&](const Xy<double>& p) { out << "[" << pair_of(p) << "]"; });
    out << "]";
  } else out << ",\"status\":\"complete\"";
  if (!axis.left_out.empty()) {
    out << ",\"left_out\":[";
    write_list(out, axis.left_out, ",", [&](std::uint32_t curve) { out << loaded.number_of(curve); });
    out << "]";
  }
  if (words.v_bit > 0) out << ",\"v_bit\":" << number(words.v_bit);
  if (found.proof)
    out << ",\"proof\":{\"proven\":" << (found.proof->is_proven() ? "true" : "false")
        << ",\"tiled\":" << (found.proof->is_tiled ? "true" : "false")
        << ",\"euler\":" << (found.proof->is_euler ? "true" : "false") << "}";
  out << ",";
  if (words.with_cells) write_cells(out, ba::voronoi_cells(curves, axis), curves);
  out << "\"vertices\":[\n";
  write_list(out, axis.vertices, ",\n", [&](const ba::Medial_axis_2::Vertex& v) {
    out << "{\"point\":[" << pair_of(v.center) << "],\"radius\":" << number(v.radius) << ",\"touches\":[";
    write_list(out, v.touches, ",", place);
    out << "]}";
  });
  out << "],\"edges\":[\n";
  write_list(out, axis.edges, ",\n", [&](const ba::Medial_axis_2::Edge& e) {
    const ba::Medial_axis_2::Sample& middle = e.samples[e.samples.size() / 2];
    out << "{\"from\":" << e.from << ",\"to\":" << e.to << ",\"sites\":[";
    place(middle.left);
    out << ",";
    place(middle.right);
    out << "]";
    if (found.proof) {
      const ba::Medial_axis_2::Certificate::Edge& proven =
          found.proof->edges[static_cast<std::size_t>(&e - axis.edges.data())];
      const bool is_proven = proven.status == ba::Medial_axis_2::Certificate::Status::PROVEN;
      out << ",\"status\":\"" << (is_proven ? "PROVEN" : "ESTIMATED") << "\"";
      if (!is_proven) out << ",\"reason\":\"" << ba::Medial_axis_2::Certificate::name_of(proven.reason) << "\"";
      if (std::isfinite(proven.bound)) out << ",\"bound\":" << number(proven.bound);
    }
    out << ",\"polyline\":[";
    write_list(out, e.samples, ",", [&](const ba::Medial_axis_2::Sample& s) {
      out << "[" << pair_of(s.center) << "," << number(s.radius);
      if (words.v_bit > 0) out << "," << number(0 - s.radius * depth);
      out << "]";
    });
    out << "]";
    if (words.with_feet) {
      out << ",\"feet\":[";
      write_list(out, e.samples, ",", [&](const ba::Medial_axis_2::Sample& s) {
        const Curve_place p = s.left, q = s.right;
        out << "[[" << loaded.number_of(p.curve) << "," << p.bezier << "," << number(p.t) << "],["
            << loaded.number_of(q.curve) << "," << q.bezier << "," << number(q.t) << "]]";
      });
      out << "]";
    }
    if (words.with_conics) {
      out << ",\"conics\":[";
      write_list(out, found.conics[static_cast<std::size_t>(&e - axis.edges.data())], ",",
                 [&](const ba::Medial_axis_2::Conic& conic) {
                   out << "{\"control_points\":[";
                   write_list(out, conic.points, ",", [&](const Xy<double>& p) { out << "[" << pair_of(p) << "]"; });
                   out << "],\"weights\":[1," << number(conic.weight) << ",1],\"error\":" << number(conic.error) << "}";
                 });
      out << "]";
    }
    out << "}";
  });
  out << "]}\n";
}

std::string title_of(const Found_axis& found) {
  const ba::Medial_axis_2& axis = found.axis;
  const std::string open = axis.unresolved.empty() ? "" : ", open at " + std::to_string(axis.unresolved.size());
  return "medial axis: " + std::to_string(axis.vertices.size()) + " vertices, " + std::to_string(axis.edges.size()) +
         " edges" + open;
}

void draw(std::ostream& out, const Found_axis& found, const Query_drawing& loaded, const Medial_axis_words& words) {
  const ba::Medial_axis_2& axis = found.axis;
  const ba::Drawing_2<double>& drawing = loaded.curves->drawing();
  Box box;
  for (const auto& curve : drawing.curves())
    for (const auto& piece : curve.beziers)
      for (const Xy<double>& p : piece.control_points()) box.add(p);
  const Sheet sheet(box, loaded.flips);
  const std::string title = title_of(found);
  char text[900];
  std::snprintf(text, sizeof text,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n"
                "<title>%s</title>\n"
                "<style>path,circle{fill:none;stroke-linejoin:round}\n.c{stroke:#888;stroke-width:2.5}\n"
                ".a{stroke:#0072b2;stroke-width:1.6}\n.f{stroke:#9ac6e0;stroke-width:1.2}\n"
                ".d{stroke:#d55e00;stroke-width:0.8;stroke-opacity:0.7}\n"
                ".v{fill:#0072b2}\n.u{stroke:#d55e00;stroke-width:2}</style>\n<rect width=\"100%%\" height=\"100%%\" "
                "fill=\"#fff\"/>\n"
                "<text x=\"%.0f\" y=\"36\" font-family=\"sans-serif\" font-size=\"20\" fill=\"#333\">%s</text>\n",
                sheet.width, sheet.height, sheet.width, sheet.height, title.c_str(), Sheet::MARGIN, title.c_str());
  out << text;
  if (words.with_cells) draw_cells(out, ba::voronoi_cells(*loaded.curves, axis), found, *loaded.curves, sheet);
  for (const auto& curve : drawing.curves()) {
    out << "<g><title>" << escaped(curve.name) << "</title>\n<path class=\"c\" d=\"";
    for (const auto& piece : curve.beziers) out << curve_path(sheet.view, piece);
    out << "\"/></g>\n";
  }
  const auto circle = [&](const char* kind, const Xy<double>& center, double radius) {
    const Xy<double> c = sheet.view.place(center);
    std::snprintf(text, sizeof text, "<circle class=\"%s\" cx=\"%.7g\" cy=\"%.7g\" r=\"%.7g\"/>\n", kind, c.x, c.y,
                  radius);
    out << text;
  };
  if (words.with_discs)
    for (const ba::Medial_axis_2::Vertex& v : axis.vertices) circle("d", v.center, v.radius * sheet.view.scale);
  for (const ba::Medial_axis_2::Edge& e : axis.edges) {
    const ba::Medial_axis_2::Sample& middle = e.samples[e.samples.size() / 2];
    const std::size_t frame = drawing.curves().size() - 1;
    const bool is_of_frame = words.is_framed && (middle.left.curve == frame || middle.right.curve == frame);
    out << "<path class=\"" << (is_of_frame ? 'f' : 'a') << "\" d=\"";
    const char* command = "M";
    for (const ba::Medial_axis_2::Sample& s : e.samples) {
      out << command << sheet.view(s.center);
      command = "L";
    }
    out << "\"/>\n";
  }
  constexpr double DOT = 6;
  Dot_width dots;
  for (const ba::Medial_axis_2::Edge& e : axis.edges)
    dots.add(sheet.view, axis.vertices[e.from].center, axis.vertices[e.to].center);
  const double dot = dots(DOT);
  for (const ba::Medial_axis_2::Vertex& v : axis.vertices) circle("v", v.center, dot / 2);
  for (const Xy<double>& p : axis.unresolved) circle("u", p, 2 * DOT);
  out << "</svg>\n";
}

}  // namespace

void add_frame_option(CLI::App& command, Medial_axis_words& words) {
  command
      .add_option_function<double>(
          "--frame", [&words](double margin) { words.margin = margin, words.is_framed = true; },
          "The Voronoi diagram of all curves, open ones too, within a rectangle around their control points with\n"
          "that margin, in units of the coordinates; where no number follows, a tenth of the drawing's larger side")
      ->expected(0, 1)
      ->default_str("0")
      ->type_name("[MARGIN]")
      ->check(number_in(0, 1e300));
}

CLI::App* add_medial_axis_command(CLI::App& app, Medial_axis_words& words) {
  CLI::App* command = app.add_subcommand("medial-axis", "The medial axis of what closed curves enclose");
  command->add_option("FILE", words.file, "A curve file, JSON, SVG or DXF; - reads standard input")->required();
  command
      ->add_option("--eps", words.eps,
                   "How far the axis may be from the lines between samples, in units of the coordinates")
      ->required()
      ->check(CLI::Validator(check_tolerance, "", "eps"))
      ->type_name("NUMBER");
  CLI::Option* prune =
      command
          ->add_option(
              "--prune", words.prune,
              "Leave branches out whose discs stick out by less than that, in units of the coordinates, of the\n"
              "disc where they begin")
          ->check(number_in(0, 1e300));
  CLI::Option* prune_angle =
      command
          ->add_option(
              "--prune-angle", words.prune_angle,
              "Leave ends out where the places that discs touch are seen from the center under less than that,\n"
              "in degrees")
          ->check(number_in(0, 114));
  add_frame_option(*command, words);
  add_rule(*command, words.reading.rule);
  add_reading_options(*command, words.reading);
  command
      ->add_option("--v-bit", words.v_bit,
                   "Write z of each sample, too: how deep a conical bit with that angle at its tip goes, in degrees")
      ->check(number_in(1, 179));
  command
      ->add_option("--max-depth", words.max_depth,
                   "How deep the bit may go, in units of the coordinates, for dxf, csv, svg and gcode: what is wider\n"
                   "has a flat bottom there, whose outline is written as a pocket")
      ->check(CLI::Validator(check_tolerance, "", "depth"))
      ->type_name("NUMBER");
  command
      ->add_option("--flat-tool", words.flat_tool,
                   "The diameter of a flat tool that clears flat bottoms, in units of the coordinates: passes half of\n"
                   "that apart. They are added to dxf, csv and svg; gcode, which is of one tool, has them alone.\n"
                   "Without it pockets are outlines only")
      ->check(CLI::Validator(check_tolerance, "", "diameter"))
      ->type_name("NUMBER");
  add_output(*command, {"json", "csv", "svg", "dxf", "gcode"}, words.format, words.output);
  add_plain(*command, words.is_plain);
  add_gcode_options(*command, words.gcode, false);
  add_stream_options(*command, words.stream, words.format);
  command->add_flag("--discs", words.with_discs, "Draw the discs of the vertices, too");
  command->add_flag("--feet", words.with_feet, "Write the two places that the disc of each sample touches");
  command->add_flag("--conics", words.with_conics,
                    "Write each edge as conics, too, rational quadratic Bezier curves: far fewer than samples");
  command
      ->add_flag("--cells", words.with_cells,
                 "Write of each curve the places that are nearest to it, between runs of it and edges; draw them")
      ->excludes(prune)
      ->excludes(prune_angle);
  command
      ->add_flag("--prove", words.is_proving,
                 "Write of each edge a proven bound of its distance from the true axis, or why there is none")
      ->excludes(prune)
      ->excludes(prune_angle);
  command->footer(
      "A vertex has the places that its disc touches: three or more, one at a maximum of curvature, or a convex\n"
      "corner. An edge has samples [x, y, r] from vertex to vertex and, as \"sites\", the places to its left and "
      "right\n"
      "that the disc of its middle sample touches. With --frame \"frame\" is the frame's number among the curves: "
      "edges\n"
      "with a site on it would not be there without. Curves that cross or touch have the axis of what they fill, or\n"
      "in a frame of all parts that they cut it into. \"moved\" is how far the drawing that has exactly this axis may\n"
      "be from the one that is given: the least distances are of rounding. With --prove an edge's \"bound\" is that of "
      "centers and radii together; verify-axis checks what is written with --feet.\n"
      "A cell of --cells has a run of its curve and its \"rim\": parts of edges, each with its number, the first and "
      "the\n"
      "last sample, and the number of the curve on the other side.\n"
      "With --conics an edge's \"conics\" are bisectors of the arcs that stand for the curves; each has an estimate of "
      "its\n"
      "error, at most eps.\n"
      "A curve whose sides the rule fills both bounds nothing: \"left_out\" has its number among the curves.\n"
      "With --v-bit samples are [x, y, r, z], z = -r / tan(ANGLE/2): along them the bit touches both sides "
      "(V-carving).\n"
      "G-code, and CSV, DXF and SVG with --v-bit, have the axis as few long paths with z: part by part, each from its\n"
      "longest branch on, then what starts nearest to the bit. A path begins at its upper end, or where the bit is:\n"
      "between two flat bottoms it plunges. Behind them come pockets, the outlines of what is flat at --max-depth,\n"
      "islands first, inside out: what they enclose is left to be cleared, by --flat-tool. Depths are within eps.\n"
      "Where discs cannot be told apart a part of the axis is left out: \"status\" is then \"unresolved\", "
      "\"unresolved\"\n"
      "tells the places, pictures have circles there, and the exit status is 1.\n"
      "Examples:\n"
      "  bounding_arcs medial-axis curve.json --eps 1e-6\n"
      "  bounding_arcs medial-axis drawing.svg --eps 0.01 --frame --cells --format svg -o voronoi.svg\n"
      "  bounding_arcs medial-axis drawing.svg --eps 0.01 --prune 0.5 --format svg --discs -o axis.svg\n"
      "  bounding_arcs medial-axis part.dxf --eps 0.01 --conics -o axis.dxf\n"
      "  bounding_arcs medial-axis letters.svg --eps 0.01 --v-bit 60 -o carving.json\n"
      "  bounding_arcs medial-axis letters.svg --eps 0.01 --v-bit 60 --max-depth 3 -o carving.svg\n"
      "  bounding_arcs medial-axis letters.svg --eps 0.01 --v-bit 60 --max-depth 3 --feed 600 -o carving.nc\n"
      "  bounding_arcs medial-axis letters.svg --eps 0.01 --v-bit 60 --max-depth 3 --flat-tool 2 --feed 600 -o "
      "flat.nc\n"
      "  bounding_arcs medial-axis --eps 1 --stream --jobs 8 glyphs.jsonl -o axes.jsonl\n");
  return command;
}

Query_answer medial_axis_answer(const Medial_axis_words& words, const Query_drawing& drawing) {
  const Query_drawing loaded =
      with_frame({drawing.file, drawing.flips, std::make_unique<Bounding_arc_tree_2>(drawing.curves->drawing()),
                  drawing.rule, drawing.numbers},
                 words);
  const Found_axis found = axis_of(loaded, words);
  const ba::Medial_axis_2& axis = found.axis;
  Query_answer answer;
  answer.title = title_of(found);
  for (const ba::Medial_axis_2::Edge& e : axis.edges) {
    answer.marks.push_back({Mark::LINE, {}});
    for (const ba::Medial_axis_2::Sample& s : e.samples) answer.marks.back().points.push_back(s.center);
  }
  answer.columns = {"x", "y", "radius"};
  for (const ba::Medial_axis_2::Vertex& v : axis.vertices) {
    answer.rows.push_back({digits(v.center.x), digits(v.center.y), digits(v.radius)});
    answer.marks.push_back({Mark::DOT, {v.center}});
  }
  return answer;
}

void give_margins(std::vector<std::string>& words) {
  const auto is_number = [](const std::string& word) {
    char* end = nullptr;
    std::strtod(word.c_str(), &end);
    return !word.empty() && *end == '\0';
  };
  for (std::size_t i = 0; i + 1 < words.size() && words[i] != "--"; ++i)
    if (words[i] == "--frame" && !is_number(words[i + 1])) words[i] = "--frame=0";
}

namespace {

// Refuses words that do not go with paths of a tool, or with other forms.
void check_carving(const Medial_axis_words& words, bool is_carving) {
  if (words.max_depth > 0 && words.v_bit == 0) throw Usage_error("--max-depth", "--v-bit beside it", "none");
  if (words.max_depth > 0 && !is_carving)
    throw Usage_error("--format", "dxf, csv, svg or gcode with --max-depth", words.format);
  if (words.flat_tool > 0 && words.max_depth == 0) throw Usage_error("--flat-tool", "--max-depth beside it", "none");
  if (words.max_depth > 0 && words.is_framed) throw Usage_error("--max-depth", "no frame beside it", "--frame");
  if (is_carving && words.with_conics) throw Usage_error("--conics", "no path of a tool beside it", words.format);
  if (words.format != "gcode") return;
  if (words.v_bit == 0) throw Usage_error("--v-bit", "an angle with --format gcode", "none");
  check_gcode_words(words.gcode);
}

// Radii are so much more exact that depths are within eps.
Medial_axis_words with_eps_of_radii(const Medial_axis_words& words, const V_bit& bit) {
  Medial_axis_words result = words;
  const double eps = std::strtod(words.eps.c_str(), nullptr), finer = eps / (std::max)(1.0, bit.depth);
  result.eps = number(finer);
  if (finer >= bit.largest())
    throw Usage_error("--eps", "less than the bit is wide at --max-depth, " + number(2 * bit.largest()), number(eps));
  return result;
}

void write_carving(const Medial_axis_words& words, std::ostream& out, const V_carving& carving,
                   const Query_drawing& loaded) {
  if (words.format == "csv") write_carving_csv(out, carving);
  else if (words.format == "dxf") write_dxf(out, written_carving(carving, !loaded.flips, loaded.unit_in_mm));
  else if (words.format == "svg") draw_carving(out, carving, loaded.curves->drawing(), loaded.flips);
  else write_carving_gcode(out, loaded.file, carving, gcode_setup(words.gcode, loaded.unit(), !loaded.flips));
}

int run_carving(const Medial_axis_words& words) {
  const V_bit bit = v_bit(words.v_bit, words.max_depth);
  const Medial_axis_words finer = with_eps_of_radii(words, bit);
  const Query_drawing loaded = load_axis_drawing(finer);
  if (words.format == "dxf") tell_units_of_dxf(loaded.unit());
  const Found_axis axis = shown_axis_of(loaded, finer);
  const V_carving carving = v_carving(*loaded.curves, axis.axis, bit, words.flat_tool, loaded.file);
  if (words.flat_tool > 0 && carving.flats.empty())
    throw Input_error(loaded.file, "--flat-tool",
                      "expected a diameter that has room in what is flat, found " + number(words.flat_tool));
  Output_file output(words.output);
  write_carving(words, output.stream(), carving, loaded);
  output.commit();
  if (!carving.pockets.empty() && carving.flats.empty())
    tell(loaded.file, count_text(carving.pockets.size(), "outline") + " of flat bottoms at the depth " +
                          number(words.max_depth) + ", the inset at " + short_number(bit.largest()) +
                          ": what they enclose is left to be cleared");
  return tell_of_axis(loaded, axis, "medial-axis");
}

}  // namespace

int run_medial_axis(const Medial_axis_words& words) {
  const bool is_table_or_dxf = words.format == "csv" || words.format == "dxf";
  const bool is_picture = words.format == "svg" && !words.is_plain && !words.is_framed;
  const bool is_carving = words.format == "gcode" || ((is_table_or_dxf || is_picture) && words.v_bit > 0);
  check_carving(words, is_carving);
  check_plain(words.is_plain, words.format);
  if (is_carving) return run_carving(words);
  if (words.stream.is_on) {
    const auto answer = [&](std::vector<Curve_record>&& records, std::ostream& out) {
      const Query_drawing loaded = with_frame(record_drawing(records, "double", words.reading), words);
      write_json(out, axis_of(loaded, words), loaded, words);
    };
    return run_stream(words.stream, words.file, words.output, answer);
  }
  const Query_drawing loaded = load_axis_drawing(words);
  const Found_axis axis = shown_axis_of(loaded, words);
  if (words.format == "dxf") tell_units_of_dxf(loaded.unit());
  Output_file output(words.output);
  if (words.format == "json") write_json(output.stream(), axis, loaded, words);
  else if (words.format == "csv") write_axis_csv(output.stream(), axis, loaded);
  else if (words.format == "dxf") write_dxf(output.stream(), written_axis(axis, loaded, false));
  else if (words.is_plain) write_plain_svg(output.stream(), written_axis(axis, loaded, true));
  else draw(output.stream(), axis, loaded, words);
  output.commit();
  return tell_of_axis(loaded, axis, "medial-axis");
}

}  // namespace bounding_arcs_tool

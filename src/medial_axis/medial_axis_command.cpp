// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs medial-axis: the medial axis of what closed curves enclose, as JSON or a picture.

#include "medial_axis_command.h"

#include "../Commands.h"
#include "../Output_file.h"
#include "../option_words.h"
#include "../query/query_command.h"
#include "../svg_paths.h"

#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/medial_axis/pruned.h>

#include <CLI/CLI.hpp>

#include <cstdlib>
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

void write_json(std::ostream& out, const ba::Medial_axis_2& axis, const Curve_index_2& index, bool with_feet) {
  const auto place = [&](const Curve_place& p) { out << json_of(index, p).dump(); };
  out << "{\"eps\":" << number(axis.eps) << ",\"regions\":" << axis.regions << ",\"holes\":" << axis.holes
      << ",\"error\":" << number(axis.error) << ",\"vertices\":[\n";
  write_list(out, axis.vertices, ",\n", [&](const ba::Medial_vertex& v) {
    out << "{\"point\":[" << pair_of(v.centre) << "],\"radius\":" << number(v.radius) << ",\"touches\":[";
    write_list(out, v.touches, ",", place);
    out << "]}";
  });
  out << "],\"edges\":[\n";
  write_list(out, axis.edges, ",\n", [&](const ba::Medial_edge& e) {
    const ba::Medial_sample& middle = e.samples[e.samples.size() / 2];
    out << "{\"from\":" << e.from << ",\"to\":" << e.to << ",\"sites\":[";
    place(middle.left);
    out << ",";
    place(middle.right);
    out << "],\"polyline\":[";
    write_list(out, e.samples, ",",
               [&](const ba::Medial_sample& s) { out << "[" << pair_of(s.centre) << "," << number(s.radius) << "]"; });
    out << "]";
    if (with_feet) {
      out << ",\"feet\":[";
      write_list(out, e.samples, ",", [&](const ba::Medial_sample& s) {
        out << "[[" << s.left.curve << "," << s.left.bezier << "," << number(s.left.t) << "],[" << s.right.curve << ","
            << s.right.bezier << "," << number(s.right.t) << "]]";
      });
      out << "]";
    }
    out << "}";
  });
  out << "]}\n";
}

std::string title_of(const ba::Medial_axis_2& axis) {
  return "medial axis: " + std::to_string(axis.vertices.size()) + " vertices, " + std::to_string(axis.edges.size()) +
         " edges";
}

void draw(std::ostream& out, const ba::Medial_axis_2& axis, const ba::Drawing_2<double>& drawing, bool flips,
          bool with_discs) {
  Box box;
  for (const auto& curve : drawing.curves())
    for (const auto& piece : curve.beziers)
      for (const Xy<double>& p : piece.control_points()) box.add(p);
  const Sheet sheet(box, flips);
  const std::string title = title_of(axis);
  char text[900];
  std::snprintf(text, sizeof text,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n"
                "<title>%s</title>\n"
                "<style>path,circle{fill:none;stroke-linejoin:round}\n.c{stroke:#888;stroke-width:2.5}\n"
                ".a{stroke:#0072b2;stroke-width:1.6}\n.d{stroke:#d55e00;stroke-width:0.8;stroke-opacity:0.7}\n"
                ".v{fill:#0072b2}</style>\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n"
                "<text x=\"%.0f\" y=\"36\" font-family=\"sans-serif\" font-size=\"20\" fill=\"#333\">%s</text>\n",
                sheet.width, sheet.height, sheet.width, sheet.height, title.c_str(), Sheet::MARGIN, title.c_str());
  out << text;
  for (const auto& curve : drawing.curves()) {
    out << "<g><title>" << escaped(curve.name) << "</title>\n<path class=\"c\" d=\"";
    for (const auto& piece : curve.beziers) out << curve_path(sheet.view, piece);
    out << "\"/></g>\n";
  }
  const auto circle = [&](const char* kind, const Xy<double>& centre, double radius) {
    const Xy<double> c = sheet.view.place(centre);
    std::snprintf(text, sizeof text, "<circle class=\"%s\" cx=\"%.7g\" cy=\"%.7g\" r=\"%.7g\"/>\n", kind, c.x, c.y,
                  radius);
    out << text;
  };
  if (with_discs)
    for (const ba::Medial_vertex& v : axis.vertices) circle("d", v.centre, v.radius * sheet.view.scale);
  for (const ba::Medial_edge& e : axis.edges) {
    out << "<path class=\"a\" d=\"";
    const char* command = "M";
    for (const ba::Medial_sample& s : e.samples) {
      out << command << sheet.view(s.centre);
      command = "L";
    }
    out << "\"/>\n";
  }
  constexpr double DOT = 6;
  Dot_width dots;
  for (const ba::Medial_edge& e : axis.edges)
    dots.add(sheet.view, axis.vertices[e.from].centre, axis.vertices[e.to].centre);
  const double dot = dots(DOT);
  for (const ba::Medial_vertex& v : axis.vertices) circle("v", v.centre, dot / 2);
  out << "</svg>\n";
}

ba::Medial_axis_2 axis_of(const Query_drawing& loaded, const Medial_axis_words& words) {
  ba::Medial_axis_options options;
  options.eps = std::strtod(words.eps.c_str(), nullptr);
  options.rule = words.rule == "nonzero" ? ba::Fill_rule::NONZERO : ba::Fill_rule::EVEN_ODD;
  ba::Medial_axis_2 axis;
  try {
    axis = ba::medial_axis(*loaded.index, options);
  } catch (const std::invalid_argument& error) {
    throw Input_error(loaded.file, "medial-axis", error.what());
  }
  if (axis.status == ba::Medial_axis_status::CROSSING)
    throw Input_error(loaded.file, "medial-axis",
                      "curves cross or touch, themselves or each other; query self-intersect tells where");
  if (axis.status == ba::Medial_axis_status::UNRESOLVED)
    throw Input_error(loaded.file, "medial-axis", "discs that touch several places cannot be told apart in doubles");
  if (axis.eps > options.eps) {
    char text[120];
    std::snprintf(text, sizeof text, "eps %g is below what its coordinates resolve; least is %.2g", options.eps,
                  axis.eps);
    throw Input_error(loaded.file, "medial-axis", text);
  }
  return words.prune > 0 ? ba::pruned(std::move(axis), words.prune) : axis;
}

}  // namespace

CLI::App* add_medial_axis_command(CLI::App& app, Medial_axis_words& words) {
  CLI::App* command = app.add_subcommand("medial-axis", "The medial axis of what closed curves enclose");
  command->add_option("FILE", words.file, "A curve file, JSON, SVG or DXF; - reads standard input")->required();
  command
      ->add_option("--eps", words.eps,
                   "How far the axis may be from the lines between samples, in units of the coordinates")
      ->required()
      ->check(CLI::Validator(check_tolerance, "", "eps"))
      ->type_name("NUMBER");
  command
      ->add_option("--prune", words.prune,
                   "Leave branches out whose discs stick out by less than that, in units of the coordinates, of the\n"
                   "disc where they begin")
      ->check(CLI::Range(0.0, 1e300));
  command->add_option("--rule", words.rule, "Which points closed curves enclose, as in SVG")
      ->check(CLI::IsMember({"nonzero", "evenodd"}))
      ->capture_default_str();
  command->add_option("--format", words.format, "Form of the output")
      ->check(CLI::IsMember({"json", "svg"}))
      ->capture_default_str();
  add_stream_options(*command, words.stream, words.format);
  command->add_flag("--discs", words.with_discs, "Draw the discs of the vertices, too");
  command->add_flag("--feet", words.with_feet, "Write the two places that the disc of each sample touches");
  command->add_option("-o,--output", words.output,
                      "Write to this file, whole or not at all, instead of standard output");
  command->footer(
      "A vertex has the places that its disc touches: three or more, one at a maximum of curvature, or a convex\n"
      "corner. An edge has samples [x, y, r] from vertex to vertex and, as \"sites\", the places to its left and "
      "right\n"
      "that the disc of its middle sample touches.\n"
      "Examples:\n"
      "  bounding_arcs medial-axis curve.json --eps 1e-6\n"
      "  bounding_arcs medial-axis drawing.svg --eps 0.01 --prune 0.5 --format svg --discs -o axis.svg\n"
      "  bounding_arcs medial-axis --eps 1 --stream --jobs 8 glyphs.jsonl -o axes.jsonl\n");
  return command;
}

Query_answer medial_axis_answer(const Medial_axis_words& words, const Query_drawing& loaded) {
  const ba::Medial_axis_2 axis = axis_of(loaded, words);
  Query_answer answer;
  answer.title = title_of(axis);
  for (const ba::Medial_edge& e : axis.edges) {
    answer.marks.push_back({Mark::LINE, {}});
    for (const ba::Medial_sample& s : e.samples) answer.marks.back().points.push_back(s.centre);
  }
  answer.columns = {"x", "y", "radius"};
  for (const ba::Medial_vertex& v : axis.vertices) {
    answer.rows.push_back({digits(v.centre.x), digits(v.centre.y), digits(v.radius)});
    answer.marks.push_back({Mark::DOT, {v.centre}});
  }
  return answer;
}

int run_medial_axis(const Medial_axis_words& words) {
  if (words.stream.is_on) {
    const auto answer = [&](std::vector<Curve_record>&& records, std::ostream& out) {
      const Query_drawing drawing = query_drawing(RECORD_NAME, records, "double");
      write_json(out, axis_of(drawing, words), *drawing.index, words.with_feet);
    };
    return run_stream(words.stream, words.file, words.output, answer);
  }
  const Query_drawing loaded = load_drawing(words.file, "double");
  const ba::Medial_axis_2 axis = axis_of(loaded, words);
  Output_file output(words.output);
  if (words.format == "json") write_json(output.stream(), axis, *loaded.index, words.with_feet);
  else draw(output.stream(), axis, loaded.index->drawing(), loaded.flips, words.with_discs);
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool

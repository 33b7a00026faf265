// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs arrange: what curves cut the plane into, vertices, edges and faces with their areas.

#include "arrange_command.h"

#include "../Commands.h"
#include "../Elapsed_line.h"
#include "../Output_file.h"
#include "../boolean/path_pieces.h"
#include "../option_words.h"
#include "../query/Query_answer.h"
#include "../query/query_command.h"
#include "../svg_paths.h"
#include "../usage.h"

#include <CGAL/Bounding_arcs_2/overlay/overlay.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

/// What the curves of some files cut the plane into.
struct Arranged {
  std::vector<Query_drawing> files;
  ba::Overlay_2 cells;
  std::vector<std::size_t> degrees;                      // of vertices
  std::vector<std::optional<ba::Measure_bounds>> areas;  // of faces that are bounded

  [[nodiscard]] const ba::Drawing_2<double>::Curve& curve_of(const ba::Overlay_2::Source& source) const {
    return files[source.operand].curves->drawing().curves()[source.curve];
  }
};

Arranged arranged(const Arrange_words& words) {
  Arranged made;
  Box box;
  Reading_words reading = words.reading;
  for (const std::string& file : words.files) {
    made.files.push_back(load_drawing(file, "filtered", reading));
    reading.keep_unit(made.files.back().unit());
  }
  std::vector<const Bounding_arc_tree_2*> trees;
  for (const Query_drawing& file : made.files) {
    const Bounding_arc_tree_2& curves = *file.curves;
    trees.push_back(&curves);
    for (const auto& curve : curves.drawing().curves())
      for (const auto& piece : curve.beziers) box.add(piece);
  }
  ba::Overlay_2::Options options;
  options.at_joints = true;
  const Elapsed_line elapsed("arranging");
  made.cells = ba::overlay(trees, options);
  made.degrees.resize(made.cells.vertices.size(), 0);
  for (const ba::Overlay_2::Edge& e : made.cells.edges)
    for (const std::uint32_t vertex : {*e.from, *e.to}) ++made.degrees[vertex];
  constexpr double OF_BOX = 1e-9;
  const double extent = (std::max)(box.x1 - box.x0, box.y1 - box.y0),
               eps = words.eps.empty() ? OF_BOX * extent * extent : std::strtod(words.eps.c_str(), nullptr);
  for (std::uint32_t f = 0; f < made.cells.faces.size(); ++f)
    made.areas.push_back(made.cells.faces[f].is_bounded ? std::optional(made.cells.face_area(trees, f, eps))
                                                        : std::nullopt);
  return made;
}

/// Pieces are cut where they join, so that an edge is a part of one.
const ba::Overlay_2::Part& part_of(const ba::Overlay_2::Source& source) { return source.parts.front(); }

template <class List, class Record>
void write_list(std::ostream& out, const char* name, const List& list, Record record) {
  out << '"' << name << "\":[";
  const char* between = "\n";
  for (std::size_t i = 0; i < list.size(); ++i) {
    out << between << record(i).dump(-1, ' ', false, Json::error_handler_t::replace);
    between = ",\n";
  }
  out << "\n]";
}

Json bracket_json(const ba::Bracket& b) { return {b.lower, b.upper}; }

Json json_of_source(const Arranged& made, const ba::Overlay_2::Source& source) {
  const std::size_t number = made.files[source.operand].number_of(source.curve);
  Json json{{"file", source.operand}};
  json.update(source_json(part_of(source), number, made.curve_of(source).name));
  return json;
}

void write_json(std::ostream& out, const Arranged& made) {
  out << "{";
  write_list(out, "vertices", made.cells.vertices, [&](std::size_t i) {
    const ba::Overlay_2::Vertex& v = made.cells.vertices[i];
    return Json{
        {"point", json_of(v.point)}, {"x", bracket_json(v.x)}, {"y", bracket_json(v.y)}, {"degree", made.degrees[i]}};
  });
  out << ",\n";
  write_list(out, "edges", made.cells.edges, [&](std::size_t i) {
    const ba::Overlay_2::Edge& e = made.cells.edges[i];
    Json edge{{"from", *e.from},
              {"to", *e.to},
              {"left", e.left},
              {"right", e.right},
              {"source", json_of_source(made, e.sources.front())}};
    for (std::size_t k = 1; k < e.sources.size(); ++k) edge["also"].push_back(json_of_source(made, e.sources[k]));
    return edge;
  });
  out << ",\n";
  write_list(out, "faces", made.cells.faces, [&](std::size_t i) {
    Json face{{"bounded", made.cells.faces[i].is_bounded}, {"area", nullptr}, {"boundaries", Json::array()}};
    if (made.areas[i]) face["area"] = {made.areas[i]->lower, made.areas[i]->upper};
    for (const auto& boundary : made.cells.faces[i].boundaries) {
      Json edges = Json::array();
      for (const ba::Overlay_2::Side& s : boundary) edges.push_back({{"edge", s.edge}, {"forwards", !s.is_reversed}});
      face["boundaries"].push_back(std::move(edges));
    }
    return face;
  });
  out << "}\n";
}

std::string title_of(const Arranged& made) {
  const auto count = [](std::size_t n, const char* one, const char* many) {
    return std::to_string(n) + ' ' + (n == 1 ? one : many);
  };
  return "arrangement: " + count(made.cells.vertices.size(), "vertex", "vertices") + ", " +
         count(made.cells.edges.size(), "edge", "edges") + ", " + count(made.cells.faces.size(), "face", "faces");
}

// The part of the curve that an edge is, for a path that goes on from its start.
std::string edge_path(const View& view, const Arranged& made, const ba::Overlay_2::Side& side) {
  const ba::Overlay_2::Source& source = made.cells.edges[side.edge].sources.front();
  const double from = part_of(source).from.middle(), to = part_of(source).to.middle();
  if (!(from < to)) return {};
  const auto curve = made.curve_of(source).beziers[part_of(source).bezier].subcurve(from, to);
  return curve_path(view, side.is_reversed ? curve.reversed() : curve);
}

// A colour of each face that has an area.
std::vector<const char*> colours(const Arranged& made) {
  std::vector<std::set<std::size_t>> neighbours(made.cells.faces.size());
  for (const ba::Overlay_2::Edge& e : made.cells.edges) {
    if (e.left == e.right || !made.areas[e.left] || !made.areas[e.right]) continue;
    neighbours[e.left].insert(e.right);
    neighbours[e.right].insert(e.left);
  }
  return colours_apart(neighbours);
}

void draw(std::ostream& out, const Arranged& made) {
  Box box;
  bool flips = true;
  for (const Query_drawing& file : made.files) {
    flips = flips && file.flips;
    for (const auto& curve : file.curves->drawing().curves())
      for (const auto& piece : curve.beziers) box.add(piece);
  }
  const Sheet sheet(box, flips);
  const std::string title = title_of(made);
  char text[900];
  std::snprintf(
      text, sizeof text,
      "<svg %s width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n"
      "<title>%s</title>\n"
      "<style>path{stroke-linejoin:round}\n"
      ".f{fill-opacity:.35;fill-rule:evenodd}\n.e{fill:none;stroke:#444;stroke-width:1.5}\n"
      ".v{fill:#d55e00}.t{fill:#999}</style>\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n"
      "<text x=\"%.0f\" y=\"36\" font-family=\"sans-serif\" font-size=\"20\" fill=\"#333\">%s</text>\n"
      "<text x=\"%.0f\" y=\"58\" font-family=\"sans-serif\" font-size=\"14\" fill=\"#777\">orange: where curves "
      "meet or end; grey: where pieces join</text>\n",
      SVG_NAMESPACES, sheet.width, sheet.height, sheet.width, sheet.height, title.c_str(), Sheet::MARGIN, title.c_str(),
      Sheet::MARGIN);
  out << text << layer_start("faces");
  const std::vector<const char*> colour = colours(made);
  for (std::size_t i = 0; i < made.cells.faces.size(); ++i) {
    if (!made.areas[i]) continue;
    out << "<path class=\"f\" fill=\"" << colour[i] << "\" d=\"";
    for (const auto& boundary : made.cells.faces[i].boundaries) {
      bool is_first = true;
      for (const ba::Overlay_2::Side& side : boundary) {
        const std::string path = edge_path(sheet.view, made, side);
        if (path.empty()) continue;
        out << (is_first ? path : path.substr(path.find_first_of("LQCA")));
        is_first = false;
      }
      if (!is_first) out << 'Z';
    }
    out << "\"><title>face " << i << ": area " << digits(made.areas[i]->lower) << "</title></path>\n";
  }
  out << "</g>\n" << layer_start("edges");
  for (std::uint32_t i = 0; i < made.cells.edges.size(); ++i)
    out << "<path class=\"e\" d=\"" << edge_path(sheet.view, made, {i, false}) << "\"><title>edge " << i << " of "
        << escaped(made.curve_of(made.cells.edges[i].sources.front()).name) << "</title></path>\n";
  out << "</g>\n" << layer_start("vertices");
  for (std::size_t i = 0; i < made.cells.vertices.size(); ++i) {
    const Xy<double> c = sheet.view.place(made.cells.vertices[i].point);
    const bool is_cut = made.degrees[i] == 2;
    std::snprintf(text, sizeof text, "<circle class=\"%c\" cx=\"%.7g\" cy=\"%.7g\" r=\"%g\"/>\n", is_cut ? 't' : 'v',
                  c.x, c.y, is_cut ? 2.0 : 3.5);
    out << text;
  }
  out << "</g>\n</svg>\n";
}

}  // namespace

CLI::App* add_arrange_command(CLI::App& app, Arrange_words& words) {
  CLI::App* command = app.add_subcommand(
      "arrange", "What curves, open or closed, cut the plane into: vertices, edges, faces with their areas");
  command->add_option("FILES", words.files, "Curve files, JSON, SVG or DXF; - reads standard input")->required();
  add_reading_options(*command, words.reading);
  command
      ->add_option("--eps", words.eps,
                   "How far the bounds of an area may be apart, in squared units of the coordinates; without it\n"
                   "1e-9 of the square around the curves")
      ->check(CLI::Validator(check_tolerance, "", "eps"))
      ->type_name("NUMBER");
  add_output(*command, {"json", "svg"}, words.format, words.output);
  command->footer(
      "All that meets is found, whatever meets there, and told apart exactly. Edges are parts of Bezier pieces "
      "between\n"
      "places where curves meet or pieces join. Curves that run together are one edge. Face 0 is the unbounded one. A\n"
      "face is to the left of its boundaries, and its area is between two bounds.\n"
      "Examples:\n"
      "  bounding_arcs arrange drawing.svg -o cells.json\n"
      "  bounding_arcs arrange a.json b.json --format svg -o cells.svg\n");
  return command;
}

int run_arrange(const Arrange_words& words) {
  check_inputs(words.files);
  const Arranged made = arranged(words);
  Output_file output(words.output);
  if (words.format == "json") write_json(output.stream(), made);
  else draw(output.stream(), made);
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool

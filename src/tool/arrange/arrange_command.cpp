// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs arrange: what curves cut the plane into, vertices, edges and faces with their areas.

#include "arrange_command.h"

#include "../Commands.h"
#include "../Output_file.h"
#include "../option_words.h"
#include "../query/query_command.h"
#include "../svg_paths.h"
#include "../usage.h"

#include <CGAL/Arrangement_2.h>
#include <CGAL/Bounding_arcs_2/arrangement/Arr_curve_traits_2.h>
#include <CGAL/Bounding_arcs_2/arrangement/face_area.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

using Arrangement = CGAL::Arrangement_2<ba::Arr_curve_traits_2>;
using Vertex = Arrangement::Vertex_const_handle;
using Halfedge = Arrangement::Halfedge_const_handle;
using Face = Arrangement::Face_const_handle;
using Boundary = std::vector<Halfedge>;

/// An arrangement whose vertices, edges and faces have numbers, in the order of the lists.
struct Arranged {
  std::vector<Query_drawing> files;
  std::vector<std::size_t> first_curve;  // of each file, in the numbers of the arrangement's curves
  Arrangement arrangement;
  std::vector<Vertex> vertices;
  std::vector<Halfedge> edges;  // as parameters rise
  std::vector<Face> faces;
  std::vector<std::optional<ba::Measure_bounds>> areas;  // of faces that are bounded
  std::unordered_map<const void*, std::size_t> number;   // of each of them, by its address

  template <class Handle> [[nodiscard]] std::size_t number_of(Handle handle) const { return number.at(&*handle); }
};

[[nodiscard]] bool is_rising(const Halfedge& e) {
  return (e->direction() == CGAL::ARR_LEFT_TO_RIGHT) == e->curve().is_rising();
}
[[nodiscard]] std::vector<Boundary> boundaries(const Face& face) {
  std::vector<Boundary> result;
  const auto add = [&](Arrangement::Ccb_halfedge_const_circulator first) {
    result.emplace_back();
    auto edge = first;
    do result.back().push_back(edge);
    while (++edge != first);
  };
  for (auto outer = face->outer_ccbs_begin(); outer != face->outer_ccbs_end(); ++outer) add(*outer);
  for (auto inner = face->inner_ccbs_begin(); inner != face->inner_ccbs_end(); ++inner) add(*inner);
  return result;
}

void number_cells(Arranged& made) {
  const Arrangement& arrangement = made.arrangement;
  for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v) {
    made.number[&*v] = made.vertices.size();
    made.vertices.push_back(v);
  }
  for (auto e = arrangement.edges_begin(); e != arrangement.edges_end(); ++e) {
    const Halfedge edge = e;
    made.number[&*edge] = made.number[&*edge->twin()] = made.edges.size();
    made.edges.push_back(is_rising(edge) ? edge : Halfedge(edge->twin()));
  }
  // the unbounded face is the first one
  for (const bool is_unbounded : {true, false})
    for (auto f = arrangement.faces_begin(); f != arrangement.faces_end(); ++f) {
      if (f->is_unbounded() != is_unbounded) continue;
      made.number[&*f] = made.faces.size();
      made.faces.push_back(f);
    }
}

Arranged arranged(const Arrange_words& words) {
  Arranged made;
  std::vector<ba::Arr_curve_2> curves;
  Box box;
  std::size_t count = 0;
  for (const std::string& file : words.files) {
    made.files.push_back(load_drawing(file, "double", words.reading));
    made.first_curve.push_back(count);
    for (const auto& curve : made.files.back().curves->drawing().curves()) {
      for (std::size_t i = 0; i < curve.beziers.size(); ++i) {
        curves.emplace_back(curve.beziers[i], count, i);
        box.add(curve.beziers[i]);
      }
      ++count;
    }
  }
  std::vector<File_unit> units;
  for (const Query_drawing& file : made.files) units.push_back(file.unit());
  tell_units(units);
  try {
    CGAL::insert(made.arrangement, curves.begin(), curves.end());
  } catch (const std::logic_error&) {
    throw Input_error(words.files.front(), "arrange", "curves meet in a way that could not be told apart");
  }
  number_cells(made);
  constexpr double OF_BOX = 1e-9;
  const double extent = (std::max)(box.x1 - box.x0, box.y1 - box.y0),
               eps = words.eps.empty() ? OF_BOX * extent * extent : std::strtod(words.eps.c_str(), nullptr);
  for (const Face& face : made.faces)
    made.areas.push_back(face->is_unbounded() ? std::nullopt : std::optional(ba::face_area(face, eps)));
  return made;
}

/// Where an edge comes from.
struct Source {
  std::size_t file, curve;  // the curve in its file
  const ba::Drawing_2<double>::Curve* of;
  ba::Bracket from, to;
};
Source source(const Arranged& made, const Halfedge& edge) {
  const auto& part = edge->curve();
  const std::size_t curve = part.curve().curve();
  const auto after = std::upper_bound(made.first_curve.begin(), made.first_curve.end(), curve);
  const auto file = static_cast<std::size_t>(after - made.first_curve.begin()) - 1;
  const ba::Bracket &left = part.left_parameter(), &right = part.right_parameter();
  const std::size_t own = curve - made.first_curve[file];
  return {file, own, &made.files[file].curves->drawing().curves()[own], part.is_rising() ? left : right,
          part.is_rising() ? right : left};
}

Json json_of(const ba::Bracket& b) { return {b.lower, b.upper}; }

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

void write_json(std::ostream& out, const Arranged& made) {
  out << "{";
  write_list(out, "vertices", made.vertices, [&](std::size_t i) {
    const auto& p = made.vertices[i]->point();
    return Json{{"point", {p.x().middle(), p.y().middle()}},
                {"x", json_of(p.x())},
                {"y", json_of(p.y())},
                {"degree", made.vertices[i]->degree()}};
  });
  out << ",\n";
  write_list(out, "edges", made.edges, [&](std::size_t i) {
    const Halfedge& e = made.edges[i];
    const Source s = source(made, e);
    return Json{{"from", made.number_of(e->source())},
                {"to", made.number_of(e->target())},
                {"left", made.number_of(e->face())},
                {"right", made.number_of(e->twin()->face())},
                {"source",
                 {{"file", s.file},
                  {"curve", s.curve},
                  {"name", s.of->name},
                  {"bezier", e->curve().curve().piece()},
                  {"from", json_of(s.from)},
                  {"to", json_of(s.to)}}}};
  });
  out << ",\n";
  write_list(out, "faces", made.faces, [&](std::size_t i) {
    Json face{{"bounded", made.areas[i].has_value()}, {"area", nullptr}, {"boundaries", Json::array()}};
    if (made.areas[i]) face["area"] = {made.areas[i]->lower, made.areas[i]->upper};
    for (const Boundary& boundary : boundaries(made.faces[i])) {
      Json edges = Json::array();
      for (const Halfedge& e : boundary) edges.push_back({{"edge", made.number_of(e)}, {"forwards", is_rising(e)}});
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
  return "arrangement: " + count(made.vertices.size(), "vertex", "vertices") + ", " +
         count(made.edges.size(), "edge", "edges") + ", " + count(made.faces.size(), "face", "faces");
}

// The part of the curve that an edge is, for a path that goes on from its start.
std::string edge_path(const View& view, const Halfedge& edge) {
  const auto& part = edge->curve();
  const double t0 = (std::min)(part.left_parameter().middle(), part.right_parameter().middle()),
               t1 = (std::max)(part.left_parameter().middle(), part.right_parameter().middle());
  if (!(t0 < t1)) return {};
  const auto curve = part.curve().bezier().subcurve(t0, t1);
  return curve_path(view, is_rising(edge) ? curve : curve.reversed());
}

// A colour of each face that has an area.
std::vector<const char*> colours(const Arranged& made) {
  std::vector<std::set<std::size_t>> neighbours(made.faces.size());
  for (std::size_t i = 0; i < made.faces.size(); ++i)
    for (const Boundary& boundary : boundaries(made.faces[i]))
      for (const Halfedge& e : boundary) {
        const std::size_t k = made.number_of(e->twin()->face());
        if (made.areas[i] && made.areas[k]) neighbours[i].insert(k);
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
      "meet or end; grey: where they are cut, as x turns or a piece ends</text>\n",
      SVG_NAMESPACES, sheet.width, sheet.height, sheet.width, sheet.height, title.c_str(), Sheet::MARGIN, title.c_str(),
      Sheet::MARGIN);
  out << text << layer_start("faces");
  const std::vector<const char*> colour = colours(made);
  for (std::size_t i = 0; i < made.faces.size(); ++i) {
    if (!made.areas[i]) continue;
    out << "<path class=\"f\" fill=\"" << colour[i] << "\" d=\"";
    for (const Boundary& boundary : boundaries(made.faces[i])) {
      bool is_first = true;
      for (const Halfedge& edge : boundary) {
        const std::string path = edge_path(sheet.view, edge);
        if (path.empty()) continue;
        out << (is_first ? path : path.substr(path.find_first_of("LQC")));
        is_first = false;
      }
      if (!is_first) out << 'Z';
    }
    out << "\"><title>face " << i << ": area " << digits(made.areas[i]->lower) << "</title></path>\n";
  }
  out << "</g>\n" << layer_start("edges");
  for (std::size_t i = 0; i < made.edges.size(); ++i) {
    const Source s = source(made, made.edges[i]);
    out << "<path class=\"e\" d=\"" << edge_path(sheet.view, made.edges[i]) << "\"><title>edge " << i << " of "
        << escaped(s.of->name) << "</title></path>\n";
  }
  out << "</g>\n" << layer_start("vertices");
  for (std::size_t i = 0; i < made.vertices.size(); ++i) {
    const auto& p = made.vertices[i]->point();
    const Xy<double> c = sheet.view.place({p.x().middle(), p.y().middle()});
    const bool is_cut = made.vertices[i]->degree() == 2;
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
      "All that meets is found, whatever meets there, and told apart exactly. Edges are parts of Bezier pieces that\n"
      "are monotone in x, so that there are vertices of degree 2 where x turns. Face 0 is the unbounded one. A face "
      "is\n"
      "to the left of its boundaries, and its area is between two bounds.\n"
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

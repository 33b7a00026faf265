// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs clip: the parts of curves inside or outside of what others fill.

#include "clip_command.h"

#include "path_pieces.h"

#include "../Commands.h"
#include "../Elapsed_line.h"
#include "../Output_file.h"
#include "../option_words.h"
#include "../query/query_command.h"
#include "../svg_paths.h"
#include "../usage.h"
#include "../written/write_plain_svg.h"

#include <CGAL/Bounding_arcs_2/boolean/clip.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <tuple>
#include <utility>
#include <vector>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

/// Parts that follow each other on a curve, on one side of the region.
struct Clipped_path {
  std::vector<ba::Clipped_2::Part> parts;
  std::vector<ba::Bezier_curve_2<double>> pieces;  // of each part
};
struct Clipped {
  Query_drawing curves, region;
  std::vector<Clipped_path> paths;

  [[nodiscard]] bool y_is_down() const { return !(curves.flips && region.flips); }
  [[nodiscard]] double unit_in_mm() const { return curves.unit_in_mm > 0 ? curves.unit_in_mm : region.unit_in_mm; }
};

[[nodiscard]] bool goes_on(const ba::Clipped_2::Part& part, const ba::Clipped_2::Part& next) {
  return part.curve == next.curve && part.side == next.side && part.end == next.start;
}

// The last path of a closed curve goes on with the first one.
void join_ends(std::vector<Clipped_path>& paths) {
  std::vector<Clipped_path> joined;
  for (std::size_t first = 0; first < paths.size();) {
    std::size_t last = first;
    while (last + 1 < paths.size() && paths[last + 1].parts.front().curve == paths[first].parts.front().curve) ++last;
    if (last > first && goes_on(paths[last].parts.back(), paths[first].parts.front())) {
      Clipped_path &head = paths[last], &tail = paths[first];
      head.parts.insert(head.parts.end(), tail.parts.begin(), tail.parts.end());
      head.pieces.insert(head.pieces.end(), tail.pieces.begin(), tail.pieces.end());
      std::swap(head, tail);
      joined.insert(joined.end(), &paths[first], &paths[last]);
    } else {
      joined.insert(joined.end(), &paths[first], &paths[last] + 1);
    }
    first = last + 1;
  }
  paths = std::move(joined);
}

Clipped clipped(const Clip_words& words) {
  Reading_words reading = words.reading;
  Clipped made;
  made.curves = load_drawing(words.file, words.kernel, reading);
  reading.keep_unit(made.curves.unit());
  made.region = load_closed_drawing(words.region, words.kernel, reading);
  reading.keep_unit(made.region.unit());
  const Elapsed_line elapsed("clipping");
  const ba::Clipped_2 found = ba::clip(*made.curves.curves, *made.region.curves, made.region.rule);
  if (found.status == ba::Outline_2::Status::UNDECIDED)
    throw Input_error(
        words.file, "clip",
        message_of_undecided(found.undecided, {&made.curves.curves->drawing(), &made.region.curves->drawing()},
                             words.kernel));
  const ba::Drawing_2<double>& drawing = made.curves.curves->drawing();
  for (const ba::Clipped_2::Part& part : found.parts) {
    if (words.keep != name_of(part.side)) continue;
    if (made.paths.empty() || !goes_on(made.paths.back().parts.back(), part)) made.paths.emplace_back();
    made.paths.back().parts.push_back(part);
    made.paths.back().pieces.push_back(part.cut_from(drawing));
  }
  join_ends(made.paths);
  return made;
}

void write_json(std::ostream& out, const Clipped& made, const std::string& side) {
  out << "{\"side\":\"" << side << "\",\"status\":\"complete\"," << json_members(made.unit_in_mm(), made.y_is_down())
      << "\"curves\":[";
  const char* between_paths = "\n";
  for (const Clipped_path& path : made.paths) {
    const auto& curve = made.curves.curves->drawing().curves()[path.parts.front().curve];
    const bool is_closed = path.parts.front().start == path.parts.back().end;
    out << between_paths << "{\"name\":" << json_string(curve.name) << ','
        << json_members(made.curves.look_of(path.parts.front().curve))
        << "\"type\":\"path\",\"closed\":" << (is_closed ? "true" : "false") << ",";
    write_pieces(out, path.parts.size(), [&](std::size_t i) {
      Json piece = piece_json(path.pieces[i]);
      piece["source"] = source_json(path.parts[i], path.parts[i].curve, curve.name);
      return piece;
    });
    out << "}";
    between_paths = ",\n";
  }
  out << "]}\n";
}

void write_csv(std::ostream& out, const Clipped& made) {
  out << "path,curve,name,bezier,t,t_end,x_from,y_from,x_to,y_to\n";
  for (std::size_t i = 0; i < made.paths.size(); ++i)
    for (const ba::Clipped_2::Part& part : made.paths[i].parts) {
      const auto& curve = made.curves.curves->drawing().curves()[part.curve];
      out << i << ',' << part.curve << ',' << csv_field(curve.name) << ',' << part.bezier;
      for (const ba::Bracket& t : {part.from, part.to}) out << ',' << number(t.lower + (t.upper - t.lower) / 2);
      for (const Xy<double>& p : {part.start, part.end}) out << ',' << number(p.x) << ',' << number(p.y);
      out << '\n';
    }
}

Written_drawing written(const Clipped& made, const Path_words& words) {
  Written_drawing drawing{made.y_is_down(), made.unit_in_mm(), made.curves.page};
  for (const Clipped_path& path : made.paths) {
    const std::size_t curve = path.parts.front().curve;
    drawing.curves.push_back(written_path(made.curves.file, made.curves.curves->drawing().curves()[curve].name,
                                          made.curves.look_of(curve), path.pieces, words));
  }
  return drawing;
}

void draw(std::ostream& out, const Clipped& made, const std::string& side) {
  Box box;
  for (const Query_drawing* d : {&made.curves, &made.region})
    for (const auto& curve : d->curves->drawing().curves())
      for (const auto& piece : curve.beziers) box.add(piece);
  const Sheet sheet(box, made.curves.flips && made.region.flips);
  char text[700];
  std::snprintf(
      text, sizeof text,
      "<svg %s width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n<title>%s: %zu parts</title>\n"
      "<style>path{fill:none;stroke-linejoin:round}\n.c{stroke:#bbb;stroke-width:1}\n"
      ".b{stroke:#e69f00;stroke-width:1.5}\n.r{stroke:#0072b2;stroke-width:2.5}</style>\n"
      "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n"
      "<text x=\"%.0f\" y=\"36\" font-family=\"sans-serif\" font-size=\"20\" fill=\"#333\">%s: %zu parts</text>\n"
      "<text x=\"%.0f\" y=\"58\" font-family=\"sans-serif\" font-size=\"14\" fill=\"#777\">grey: the curves; "
      "orange: the region's; blue: the parts</text>\n",
      SVG_NAMESPACES, sheet.width, sheet.height, sheet.width, sheet.height, side.c_str(), made.paths.size(),
      Sheet::MARGIN, side.c_str(), made.paths.size(), Sheet::MARGIN);
  out << text;
  const auto write = [&](const char* kind, const ba::Bezier_curve_2<double>& piece) {
    out << "<path class=\"" << kind << "\" d=\"" << curve_path(sheet.view, piece) << "\"/>\n";
  };
  for (const auto& [layer, kind, drawing] :
       {std::tuple("curves", "c", &made.curves), std::tuple("region", "b", &made.region)}) {
    out << layer_start(layer);
    for (const auto& curve : drawing->curves->drawing().curves())
      for (const auto& piece : curve.beziers) write(kind, piece);
    out << "</g>\n";
  }
  out << layer_start("parts");
  for (const Clipped_path& path : made.paths)
    for (const auto& piece : path.pieces) write("r", piece);
  out << "</g>\n</svg>\n";
}

}  // namespace

CLI::App* add_clip_command(CLI::App& app, Clip_words& words) {
  CLI::App* command =
      app.add_subcommand("clip", "The parts of curves, open or closed, that are inside or outside of a region");
  command->add_option("FILE", words.file, "The curves, JSON, SVG or DXF; - reads standard input")->required();
  command->add_option("REGION", words.region, "Closed curves, and open ones that an SVG file fills")->required();
  command->add_option("--keep", words.keep, "Which parts; on are those along curves of the region")
      ->check(one_of({"inside", "outside", "on"}))
      ->capture_default_str();
  add_rule(*command, words.reading.rule);
  add_reading_options(*command, words.reading);
  command
      ->add_option("--kernel", words.kernel,
                   "double: fast, and refused where doubles do not tell; filtered, exact: the curves that the file's\n"
                   "numbers define, every decision right")
      ->check(one_of({"double", "filtered", "exact"}))
      ->capture_default_str();
  add_output(*command, {"json", "csv", "svg", "dxf"}, words.format, words.output,
             "; dxf has splines, or arcs within --eps");
  add_path_options(*command, words.path);
  add_dxf_entities(*command, words.dxf);
  command->footer(
      "Parts that follow each other on a curve are one path. JSON output can be read as a curve file.\n"
      "Examples:\n"
      "  bounding_arcs clip hatching.svg region.svg -o strokes.json\n"
      "  bounding_arcs clip roads.json lake.json --keep outside --format svg -o dry.svg\n"
      "  bounding_arcs clip hatching.svg region.svg --plain -o strokes.svg\n"
      "  bounding_arcs clip roads.dxf lake.dxf --keep outside -o dry.dxf\n");
  return command;
}

int run_clip(const Clip_words& words) {
  check_inputs({words.file, words.region});
  check_path_words(words.path, words.format);
  const Clipped made = clipped(words);
  if (words.format == "dxf") tell_units_of_dxf(made.curves.unit_in_mm > 0 ? made.curves.unit() : made.region.unit());
  Output_file output(words.output);
  if (words.format == "json") write_json(output.stream(), made, words.keep);
  else if (words.format == "csv") write_csv(output.stream(), made);
  else if (words.format == "dxf") write_dxf(output.stream(), written(made, words.path), dxf_entities(words.dxf));
  else if (words.path.is_plain) write_plain_svg(output.stream(), written(made, words.path));
  else draw(output.stream(), made, words.keep);
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs build: the leaf regions of hierarchies, as JSON, CSV or a picture.

#include "Commands.h"
#include "Output_file.h"
#include "option_words.h"

#include <cmath>

namespace bounding_arcs_tool {
namespace {

using Hierarchies = std::vector<std::unique_ptr<Curve_hierarchy>>;

void add_chain(std::string& text, const Output_chain& chain, Piece_text& pieces) {
  text += '[';
  for (const Arc_2& piece : chain) {
    text += &piece == &chain.front() ? "{" : ",{";
    pieces.add_members(text, piece);
    text += '}';
  }
  text += ']';
}

void add_region(std::string& text, const Output_region& region, Piece_text& pieces) {
  text += '{';
  add_span_members(text, region.bezier, region.t0, region.t1);
  text += ",\"thickness\":";
  add_number(text, region.thickness);
  if (region.widening) text += ",\"widening\":" + (std::isfinite(*region.widening) ? number(*region.widening) : "null");
  text += ",\"inner\":";
  add_chain(text, region.inner, pieces);
  text += ",\"outer\":";
  add_chain(text, region.outer, pieces);
  text += '}';
}

void write_json(std::ostream& out, const std::vector<Drawn_curve>& curves, const Options& options) {
  out << "{\"method\":\"" << name_of(options.methods.front()) << "\",\"eps\":" << number(options.eps.front())
      << ",\"kernel\":\"" << name_of(options.kernel) << "\",\"curves\":[";
  const char* between_curves = "\n";
  for (const Drawn_curve& c : curves) {
    out << between_curves << "{\"name\":" << json_string(c.curve->record.name)
        << ",\"beziers\":" << c.curve->segmented->number_of_beziers()
        << ",\"spirals\":" << c.curve->segmented->number_of_spirals() << ",\"regions\":[";
    std::string text;
    Piece_text pieces;
    const char* between_regions = "\n";
    const auto write = [&](const Output_region& region) {
      text = between_regions;
      add_region(text, region, pieces);
      out << text;
      between_regions = ",\n";
    };
    if (options.certified)
      served(c.curve->file, c.curve->record.name, [&] { c.hierarchy->for_each_certified_region(write); });
    else c.hierarchy->for_each_region(write);
    out << "]}";
    between_curves = ",\n";
  }
  out << "]}\n";
}

// A line for each piece of the boundaries.
void write_csv(std::ostream& out, const std::vector<Drawn_curve>& curves) {
  out << "curve,bezier,t0,t1,thickness,boundary," << PIECE_COLUMNS << '\n';
  for (const Drawn_curve& c : curves)
    c.hierarchy->for_each_region([&](const Output_region& region) {
      for (const bool is_inner : {true, false})
        for (const Arc_2& piece : is_inner ? region.inner : region.outer)
          out << csv_field(c.curve->record.name) << ',' << region.bezier << ',' << number(region.t0) << ','
              << number(region.t1) << ',' << number(region.thickness) << (is_inner ? ",inner," : ",outer,")
              << piece_fields(piece) << '\n';
    });
}

// A hierarchy a curve; the records of a stream show no progress.
Hierarchies hierarchies_over(const std::vector<Loaded_curve>& curves, const Options& options) {
  Hierarchies hierarchies;
  for (const Loaded_curve& curve : curves) {
    std::optional<Progress_line> line;
    Progress progress;
    if (!options.stream.is_on) {
      line.emplace("building " + curve.record.name + ", spirals");
      progress = [&](std::size_t done, std::size_t all) { (*line)(done, all); };
    }
    hierarchies.push_back(build_hierarchy(curve, options.methods.front(), options.eps.front(), options, progress));
  }
  return hierarchies;
}

void write(std::ostream& out, const std::vector<Loaded_curve>& curves, const Hierarchies& hierarchies,
           const Options& options) {
  std::vector<Drawn_curve> drawn;
  for (std::size_t i = 0; i < curves.size(); ++i) drawn.push_back({&curves[i], hierarchies[i].get()});
  const Method method = options.methods.front();
  if (options.format == Format::SVG) draw_svg(out, drawn, name_of(method), palette(method), options.eps.front());
  else if (options.format == Format::CSV) write_csv(out, drawn);
  else write_json(out, drawn, options);
}

}  // namespace

int run_build(const Options& options) {
  if (options.stream.is_on) {
    const auto answer = [&](std::vector<Curve_record>&& records, std::ostream& out) {
      const auto curves = cut_curves(RECORD_NAME, std::move(records), options.kernel);
      write(out, curves, hierarchies_over(curves, options), options);
    };
    return run_stream(options.stream, options.files.front(), options.output, answer);
  }
  const std::vector<Loaded_curve> curves = load_curves(options);
  const Hierarchies hierarchies = hierarchies_over(curves, options);
  Output_file output(options.output);
  write(output.stream(), curves, hierarchies, options);
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool

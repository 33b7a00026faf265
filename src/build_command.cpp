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

void write_chain(std::ostream& out, const std::vector<Output_piece>& chain) {
  out << '[';
  const char* separator = "";
  for (const Output_piece& piece : chain) {
    out << separator << '{' << piece_members(piece) << '}';
    separator = ",";
  }
  out << ']';
}

void write_region(std::ostream& out, const Output_region& region) {
  out << "{\"bezier\":" << region.bezier << ",\"t\":[" << number(region.t0) << ',' << number(region.t1)
      << "],\"thickness\":" << number(region.thickness);
  if (region.widening) out << ",\"widening\":" << (std::isfinite(*region.widening) ? number(*region.widening) : "null");
  out << ",\"inner\":";
  write_chain(out, region.inner);
  out << ",\"outer\":";
  write_chain(out, region.outer);
  out << '}';
}

void write_json(std::ostream& out, const std::vector<Drawn_curve>& curves, const Options& options) {
  out << "{\"method\":\"" << name_of(options.methods.front()) << "\",\"eps\":" << number(options.eps.front())
      << ",\"kernel\":\"" << name_of(options.kernel) << "\",\"curves\":[";
  const char* between_curves = "\n";
  for (const Drawn_curve& c : curves) {
    out << between_curves << "{\"name\":" << json_string(c.curve->record.name)
        << ",\"beziers\":" << c.curve->segmented->number_of_beziers()
        << ",\"spirals\":" << c.curve->segmented->number_of_spirals() << ",\"regions\":[";
    const char* between_regions = "\n";
    const auto write = [&](const Output_region& region) {
      out << between_regions;
      write_region(out, region);
      between_regions = ",\n";
    };
    if (options.certified) c.hierarchy->for_each_certified_region(write);
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
        for (const Output_piece& piece : is_inner ? region.inner : region.outer)
          out << csv_field(c.curve->record.name) << ',' << region.bezier << ',' << number(region.t0) << ','
              << number(region.t1) << ',' << number(region.thickness) << (is_inner ? ",inner," : ",outer,")
              << piece_fields(piece) << '\n';
    });
}

}  // namespace

int run_build(const Options& options) {
  const std::vector<Loaded_curve> curves = load_curves(options);
  std::vector<std::unique_ptr<Curve_hierarchy>> hierarchies;
  std::vector<Drawn_curve> drawn;
  for (const Loaded_curve& curve : curves) {
    Progress_line progress("building " + curve.record.name + ", spirals");
    hierarchies.push_back(build_hierarchy(curve, options.methods.front(), options.eps.front(), options,
                                          [&](std::size_t done, std::size_t all) { progress(done, all); }));
    drawn.push_back({&curve, hierarchies.back().get()});
  }
  Output_file output(options.output);
  const Method method = options.methods.front();
  if (options.format == Format::SVG)
    draw_svg(output.stream(), drawn, name_of(method), palette(method), options.eps.front());
  else if (options.format == Format::CSV) write_csv(output.stream(), drawn);
  else write_json(output.stream(), drawn, options);
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool

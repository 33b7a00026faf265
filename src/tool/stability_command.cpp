// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs stability: how many digits each method, formula and kernel keeps on families of spirals.

#include "Commands.h"
#include "Output_file.h"

#include <CGAL/Bounding_arcs_2/study/Stability_study.h>
#include <CGAL/Bounding_arcs_2/study/stability_families.h>

namespace bounding_arcs_tool {
namespace {

using namespace CGAL::Bounding_arcs;

std::vector<Study_piece> family(const std::string& name, const Options& options) {
  if (name == "near-linear") return near_linear_family();
  if (name == "near-circular") return near_circular_family();
  if (name == "subdivision") return subdivision_family();
  return random_family(options.count, options.seed);
}

// Every spiral of the curves in the files, counted from 0.
std::vector<Study_piece> spirals_of_files(const Options& options) {
  std::vector<Study_piece> pieces;
  for (const std::string& file : options.files)
    for (const Curve_record& record : read_curves(file))
      for (const Bezier_curve_2<double>& curve : bezier_pieces<double>(record))
        for (const Bezier_spiral_2<double>& spiral :
             served(file == "-" ? "stdin" : file, record.name, [&] { return spiral_segments(curve); }))
          pieces.push_back({"curves", static_cast<double>(pieces.size()), spiral, spiral.first(), spiral.last()});
  return pieces;
}

std::vector<Stability_row> measure(std::vector<Study_piece> pieces, const std::string& name) {
  Progress_line progress("measuring " + name + ", spirals", Progress_line::Long_work::ANNOUNCED);
  Worst_rows worst(name != "random");
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    worst.add(pieces[i].family, pieces[i].delta, stability_rows(pieces[i].spiral, pieces[i].t0, pieces[i].t1));
    progress(i + 1, pieces.size());
  }
  return worst.rows();
}

void write_csv(std::ostream& out, const std::vector<Stability_row>& rows) {
  out << "family,delta,method,formula,kernel,quantity,rel_error,abs_error,outside\n";
  for (const Stability_row& r : rows)
    out << r.family << ',' << number(r.delta) << ',' << r.method << ',' << r.formula << ',' << r.kernel << ','
        << r.quantity << ',' << number(r.rel_error) << ',' << number(r.abs_error) << ',' << number(r.outside) << '\n';
}

void write_json(std::ostream& out, const std::vector<Stability_row>& rows) {
  out << "{\"rows\":[";
  const char* separator = "\n";
  for (const Stability_row& r : rows) {
    out << separator << "{\"family\":\"" << r.family << "\",\"delta\":" << number(r.delta) << ",\"method\":\""
        << r.method << "\",\"formula\":\"" << r.formula << "\",\"kernel\":\"" << r.kernel << "\",\"quantity\":\""
        << r.quantity << "\",\"rel_error\":" << number(r.rel_error) << ",\"abs_error\":" << number(r.abs_error)
        << ",\"outside\":" << number(r.outside) << '}';
    separator = ",\n";
  }
  out << "]}\n";
}

std::vector<Stability_row> study(const Options& options) {
  std::vector<Stability_row> rows;
  const auto append = [&](const std::vector<Stability_row>& more) {
    rows.insert(rows.end(), more.begin(), more.end());
  };
  if (!options.files.empty()) append(measure(spirals_of_files(options), "curves"));
  for (const std::string& name : options.families) append(measure(family(name, options), name));
  return rows;
}

}  // namespace

void draw_stability(std::ostream& out, const Options& options) { draw_stability(out, study(options)); }

int run_stability(const Options& options) {
  const std::vector<Stability_row> rows = study(options);
  Output_file output(options.output);
  if (options.format == Format::JSON) write_json(output.stream(), rows);
  else if (options.format == Format::SVG) draw_stability(output.stream(), rows);
  else write_csv(output.stream(), rows);
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool

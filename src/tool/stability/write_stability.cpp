// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of a study of stability as CSV and JSON, and their worst curves as a file of curves.

#include "study_stability.h"

#include "../Commands.h"
#include "../option_words.h"

#include <CGAL/Bounding_arcs_2/tree/Build_options.h>

#include <cstdio>
#include <map>
#include <string>

namespace bounding_arcs_tool {
namespace {

using CGAL::Bounding_arcs::Build_options;
using CGAL::Bounding_arcs::Stability_row;

// The members of a curve's object behind its name.
std::string curve_members(const Stability_row& row) {
  std::string text = "\"type\":\"bezier\",\"degree\":" + std::to_string(row.control_points.size() - 1);
  const char* separator = ",\"control_points\":[";
  for (const Xy<double>& p : row.control_points) {
    text += separator + ("[" + number(p.x)) + "," + number(p.y) + "]";
    separator = ",";
  }
  separator = "],\"weights\":[";
  for (const double w : row.weights) {
    text += separator + number(w);
    separator = ",";
  }
  return text + "],\"part\":[" + number(row.t0) + "," + number(row.t1) + "]";
}

// The command that gives a row again. Its curve has no apostrophe, so that a shell takes it between two of these.
std::string command_of(const Stability_row& row, const Stability_options& options) {
  return "bounding_arcs stability --methods " + row.method + " --formulas " + row.formula + " --kernels " + row.kernel +
         " --quantities " + row.quantity + (options.with_condition ? " --condition" : "") + " --curve '{" +
         curve_members(row) + "}'";
}

// Families that are made of random numbers have a seed.
bool has_seed(const Stability_row& row) { return row.family == "random" || row.family == "hunt"; }

std::string three_digits(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

std::string name_of_curve(const Stability_row& row) {
  return row.family + " " + std::to_string(row.number) + ", delta " + three_digits(row.delta) + ": " + row.method +
         " " + row.formula + " " + row.kernel + " " + row.quantity + ", relative error " + three_digits(row.rel_error);
}

const char* best_instruction_set() {
  if (Build_options::is_available(Build_options::Instruction_set::AVX512)) return "avx512";
  return Build_options::is_available(Build_options::Instruction_set::AVX2) ? "avx2" : "base";
}

}  // namespace

Provenance provenance() {
  return {"bounding_arcs " BOUNDING_ARCS_VERSION, BOUNDING_ARCS_COMPILER, BOUNDING_ARCS_FLAGS, best_instruction_set()};
}

void write_provenance(std::ostream& out) {
  const Provenance made = provenance();
  out << "# version: " << made.version << "\n# compiler: " << made.compiler << "\n# flags: " << made.flags
      << "\n# instruction set: " << made.instruction_set << '\n';
}

std::string provenance_members() {
  const Provenance made = provenance();
  return "\"version\":" + json_string(made.version) + ",\"compiler\":" + json_string(made.compiler) +
         ",\"flags\":" + json_string(made.flags) + ",\"instruction_set\":" + json_string(made.instruction_set);
}

void write_stability_csv(std::ostream& out, const std::vector<Stability_row>& rows, const Stability_options& options) {
  write_provenance(out);
  out << "family,delta,method,formula,kernel,quantity,rel_error,abs_error,condition,number,seed,curve,command\n";
  for (const Stability_row& r : rows)
    out << r.family << ',' << number(r.delta) << ',' << r.method << ',' << r.formula << ',' << r.kernel << ','
        << r.quantity << ',' << number(r.rel_error) << ',' << number(r.abs_error) << ','
        << (r.condition ? number(*r.condition) : "") << ',' << r.number << ','
        << (has_seed(r) ? std::to_string(options.seed) : "") << ',' << csv_field("{" + curve_members(r) + "}") << ','
        << csv_field(command_of(r, options)) << '\n';
}

void write_stability_json(std::ostream& out, const std::vector<Stability_row>& rows, const Stability_options& options) {
  out << '{' << provenance_members() << ",\n\"rows\":[";
  const char* separator = "\n";
  for (const Stability_row& r : rows) {
    out << separator << "{\"family\":\"" << r.family << "\",\"delta\":" << number(r.delta) << ",\"method\":\""
        << r.method << "\",\"formula\":\"" << r.formula << "\",\"kernel\":\"" << r.kernel << "\",\"quantity\":\""
        << r.quantity << "\",\"rel_error\":" << number(r.rel_error) << ",\"abs_error\":" << number(r.abs_error)
        << ",\"condition\":" << (r.condition ? number(*r.condition) : "null") << ",\"number\":" << r.number
        << ",\"seed\":" << (has_seed(r) ? std::to_string(options.seed) : "null") << ",\"curve\":{" << curve_members(r)
        << "},\"command\":" << json_string(command_of(r, options)) << '}';
    separator = ",\n";
  }
  out << "]}\n";
}

void write_worst_curves(std::ostream& out, const std::vector<Stability_row>& rows) {
  std::map<std::string, const Stability_row*> worst;
  std::vector<std::string> keys;  // in the order of the rows
  for (const Stability_row& r : rows) {
    const std::string key = r.family + ' ' + r.method + ' ' + r.formula + ' ' + r.kernel + ' ' + r.quantity;
    const auto place = worst.emplace(key, &r);
    if (place.second) keys.push_back(key);
    else if (place.first->second->rel_error < r.rel_error) place.first->second = &r;
  }
  out << "{\"curves\":[";
  const char* separator = "\n";
  for (const std::string& key : keys) {
    const Stability_row& row = *worst.at(key);
    out << separator << "{\"name\":" << json_string(name_of_curve(row)) << ',' << curve_members(row) << '}';
    separator = ",\n";
  }
  out << "]}\n";
}

}  // namespace bounding_arcs_tool

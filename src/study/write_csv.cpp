// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of a study as CSV.

#include <CGAL/Bounding_arcs_2/study/Stability_study.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cstdio>

namespace CGAL::Bounding_arcs {
namespace {

// A double in as few digits as give it back.
[[nodiscard]] std::string text(double x) {
  char digits[40];
  for (const int precision : {15, 17}) {
    std::snprintf(digits, sizeof digits, "%.*g", precision, x);
    if (std::strtod(digits, nullptr) == x) break;
  }
  return digits;
}

[[nodiscard]] std::string text(const Double_double& x) {
  using Number = boost::multiprecision::cpp_bin_float_50;
  constexpr int DIGITS = 32;
  return Number(Number(x.hi) + x.lo).str(DIGITS);
}
[[nodiscard]] std::string text(const std::optional<Figure_value>& x) {
  if (!x) return "";
  return x->is_point ? text(x->value.x) + ' ' + text(x->value.y) : text(x->value.x);
}

// A field with a comma, a quotation mark or an end of line stands in quotation marks.
[[nodiscard]] std::string field(const std::string& words) {
  if (words.find_first_of(",\"\n") == std::string::npos) return words;
  std::string quoted = "\"";
  for (const char c : words) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

// The curve as a record of a file of curves.
[[nodiscard]] std::string record(const Stability_row& row) {
  std::string json =
      R"({"type":"bezier","degree":)" + std::to_string(row.control_points.size() - 1) + R"(,"control_points":[)";
  const char* separator = "";
  for (const Xy<double>& p : row.control_points) {
    json += separator + ("[" + text(p.x)) + "," + text(p.y) + "]";
    separator = ",";
  }
  json += "]";
  separator = R"(,"weights":[)";
  for (const double w : row.weights) {
    json += separator + text(w);
    separator = ",";
  }
  if (!row.weights.empty()) json += "]";
  return json + R"(,"part":[)" + text(row.t0) + "," + text(row.t1) + "]}";
}

}  // namespace

void write_csv(std::ostream& out, const std::vector<Stability_row>& rows) {
  out << "family,delta,method,formula,kernel,quantity,rel_error,abs_error,computed,exact,frame,placement,condition,"
         "number,curve\n";
  for (const Stability_row& r : rows)
    out << field(r.family) << ',' << text(r.delta) << ',' << field(r.method) << ',' << field(r.formula) << ','
        << field(r.kernel) << ',' << field(r.quantity) << ',' << text(r.rel_error) << ',' << text(r.abs_error) << ','
        << text(r.computed) << ',' << text(r.exact) << ',' << field(r.frame) << ',' << field(r.placement) << ','
        << (r.condition ? text(*r.condition) : "") << ',' << r.number << ','
        << (r.control_points.empty() ? "" : field(record(r))) << '\n';
}

}  // namespace CGAL::Bounding_arcs

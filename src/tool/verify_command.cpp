// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs verify: proves that every leaf region holds its piece of the curve, the exact region or, with
// --certified, the one in rounded numbers with its widening.

#include "Commands.h"
#include "Output_file.h"

#include <algorithm>
#include <cstdio>

namespace bounding_arcs_tool {
namespace {

struct Result {
  const Loaded_curve* curve;
  double eps;
  Verification verification;
};

void write_json(std::ostream& out, const std::vector<Result>& results, const Options& options) {
  Verification all;
  for (const Result& r : results) {
    all.regions += r.verification.regions;
    all.proven += r.verification.proven;
    all.slivers += r.verification.slivers;
    all.slack = (std::max)(all.slack, r.verification.slack);
    all.widening = (std::max)(all.widening, r.verification.widening);
    all.widening_ulps = (std::max)(all.widening_ulps, r.verification.widening_ulps);
  }
  out << "{\"method\":\"" << name_of(options.methods.front()) << "\",\"kernel\":\"" << name_of(options.kernel)
      << "\",\"regions\":" << all.regions << ",\"proven\":" << all.proven;
  if (options.certified)
    out << ",\"widening\":" << number(all.widening) << ",\"widening_ulp\":" << number(all.widening_ulps);
  else out << ",\"slivers\":" << all.slivers << ",\"slack\":" << number(all.slack);
  out << ",\"failed\":[";
  const char* separator = "\n";
  for (const Result& r : results)
    for (const Unproven_region& region : r.verification.failed) {
      out << separator << "{\"curve\":" << json_string(r.curve->record.name) << ",\"eps\":" << number(r.eps)
          << ",\"bezier\":" << region.bezier << ",\"t\":[" << number(region.t0) << ',' << number(region.t1)
          << "],\"reason\":" << json_string(region.reason) << '}';
      separator = ",\n";
    }
  out << "]}\n";
}

void write_failed(std::ostream& out, const Verification& verification) {
  for (const Unproven_region& region : verification.failed)
    out << "  piece " << region.bezier << ", t in [" << number(region.t0) << ", " << number(region.t1)
        << "]: " << region.reason << '\n';
}

void write_table(std::ostream& out, const std::vector<Result>& results, Method method) {
  char line[300];
  std::size_t slivers = 0;
  double slack = 0;
  out << "method             eps    regions     proven   of them slivers     failed  curve\n";
  for (const Result& r : results) {
    const Verification& v = r.verification;
    std::snprintf(line, sizeof line, "%-12s %9s %10zu %10zu %17zu %10zu  ", name_of(method), number(r.eps).c_str(),
                  v.regions, v.proven, v.slivers, v.failed.size());
    out << line << table_name(r.curve->record.name) << '\n';
    slivers += v.slivers;
    slack = (std::max)(slack, v.slack);
    write_failed(out, v);
  }
  if (slivers > 0)
    out << "\nSlivers: a cut's parameter is a root rounded to double, so the piece holds a few ulps of parameter past "
           "it; proven with\n"
           "the curvatures at its ends widened, by 2^-44 of what they tell where that will do, or to be within "
        << number(slack) << "\nof its region.\n";
}

void write_certified_table(std::ostream& out, const std::vector<Result>& results, Method method) {
  char line[300];
  out << "method             eps    regions     proven     failed  largest widening   in ulp  curve\n";
  for (const Result& r : results) {
    const Verification& v = r.verification;
    std::snprintf(line, sizeof line, "%-12s %9s %10zu %10zu %10zu  %16.3g %8.3g  ", name_of(method),
                  number(r.eps).c_str(), v.regions, v.proven, v.failed.size(), v.widening, v.widening_ulps);
    out << line << table_name(r.curve->record.name) << '\n';
    write_failed(out, v);
  }
}

}  // namespace

int run_verify(const Options& options) {
  const std::vector<Loaded_curve> curves = load_curves(options);
  const Method method = options.methods.front();
  std::vector<Result> results;
  bool all_proven = true;
  for (const Loaded_curve& curve : curves)
    for (const double eps : options.eps) {
      Progress_line progress("proving " + table_name(curve.record.name) + ", regions");
      const auto hierarchy = build_hierarchy(curve, method, eps, options);
      const auto show = [&](std::size_t done, std::size_t all) { progress(done, all); };
      results.push_back({&curve, eps, options.certified ? hierarchy->verify_certified(show) : hierarchy->verify(show)});
      all_proven = all_proven && results.back().verification.failed.empty();
    }
  Output_file output(options.output);
  if (options.format == Format::JSON) write_json(output.stream(), results, options);
  else if (options.certified) write_certified_table(output.stream(), results, method);
  else write_table(output.stream(), results, method);
  output.commit();
  return all_proven ? 0 : 1;
}

}  // namespace bounding_arcs_tool

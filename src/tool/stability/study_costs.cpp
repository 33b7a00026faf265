// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs stability --costs: what exact numbers cost on the families.

#include "Study_table.h"
#include "study_stability.h"

#include <CGAL/Bounding_arcs_2/study/Cost_study.h>

#include <cmath>

namespace bounding_arcs_tool {
namespace {

using namespace CGAL::Bounding_arcs;

constexpr std::size_t PIECES = 6, REPEAT = 5;  // of a delta, at most

std::string count(std::size_t x) { return x == 0 ? "" : std::to_string(x); }
std::string ratio(double x) { return x == 0 ? "" : (x < 100 ? digits(x, 2) : std::to_string(std::lround(x))); }
std::string share(std::size_t part, const Stage_counts& counts) {
  return digits(static_cast<double>(part) / static_cast<double>(counts.all()), 2);
}

}  // namespace

Study_table cost_table(const Stability_options& options) {
  Study_table table{{"family", "delta", "method", "rational bits", "root bits", "stable bits", "textbook bits",
                     "expression bits", "separation bits", "stable time", "bounded time", "enclosure time",
                     "rational time", "expression time", "by bounded", "by interval", "by enclosure", "by expression"}};
  for_each_delta(options, PIECES, [&](const std::vector<Study_piece>& pieces) {
    for (const Cost_row& r : cost_rows(pieces, REPEAT)) {
      if (!Stability_choice::names(options.choice.methods, r.method)) continue;
      const Stage_counts& d = r.decisions;
      table.rows.push_back({r.family, digits(r.delta, 2), r.method, count(r.rational_bits), count(r.root_bits),
                            count(r.stable_bits), count(r.textbook_bits), count(r.expression_bits),
                            count(r.separation_bits), ratio(r.stable_time), ratio(r.bounded_time),
                            ratio(r.enclosure_time), ratio(r.rational_time), ratio(r.expression_time),
                            share(d.bounded, d), share(d.interval, d), share(d.enclosure, d), share(d.expression, d)});
    }
  });
  return table;
}

}  // namespace bounding_arcs_tool

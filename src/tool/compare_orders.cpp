// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs compare --orders: how fast thickness falls with the size of pieces, beside what theory says.

#include "Commands.h"
#include "Output_file.h"

#include <algorithm>
#include <cstdio>

namespace bounding_arcs_tool {
namespace {

struct Row {
  Method method;
  std::vector<double> orders;  // sorted
  double smallest = 0, largest = 0;
};

// The power of the size that thickness falls with, where curvature and its slope are not 0 and no tangent is along an
// axis: doc/compared_methods.md.
int order_in_theory(Method method) {
  if (method == Method::BOX) return 1;
  return method == Method::ORIENTED_BOX || method == Method::HULL ? 2 : 3;
}

Row row_of(const std::vector<Loaded_curve>& curves, Method method) {
  Row row{method, {}};
  for (const Loaded_curve& curve : curves)
    for (const Fitted_order& fit : curve.segmented->orders(method)) {
      row.smallest = row.orders.empty() ? fit.smallest : std::min(row.smallest, fit.smallest);
      row.largest = std::max(row.largest, fit.largest);
      row.orders.push_back(fit.order);
    }
  std::sort(row.orders.begin(), row.orders.end());
  return row;
}

void write_table(std::ostream& out, const std::vector<Row>& rows) {
  out << "method        theory    median     least      most   spirals  sizes\n";
  char line[200];
  for (const Row& row : rows) {
    if (row.orders.empty()) continue;
    std::snprintf(line, sizeof line, "%-12s %7d %9.4f %9.4f %9.4f %9zu  %.2g to %.2g\n", name_of(row.method),
                  order_in_theory(row.method), row.orders[row.orders.size() / 2], row.orders.front(), row.orders.back(),
                  row.orders.size(), row.smallest, row.largest);
    out << line;
  }
  out << "\nThe power of the distance of a piece's ends that thickness falls with, fitted at the middle of each "
         "spiral\n"
         "segment that is no line or arc over pieces of 2^-12 to 2^-24 of its parameters, in 128 bits.\n";
}

void write_json(std::ostream& out, const std::vector<Row>& rows) {
  out << "{\"orders\":[";
  const char* separator = "\n";
  for (const Row& row : rows) {
    out << separator << "{\"method\":\"" << name_of(row.method) << "\",\"theory\":" << order_in_theory(row.method)
        << ",\"spirals\":" << row.orders.size();
    if (!row.orders.empty())
      out << ",\"median\":" << number(row.orders[row.orders.size() / 2]) << ",\"least\":" << number(row.orders.front())
          << ",\"most\":" << number(row.orders.back()) << ",\"sizes\":[" << number(row.smallest) << ','
          << number(row.largest) << ']';
    out << '}';
    separator = ",\n";
  }
  out << "]}\n";
}

}  // namespace

int run_orders(const Options& options) {
  const std::vector<Loaded_curve> curves = load_curves(options);
  std::vector<Row> rows;
  {
    Progress_line progress("fitting orders, methods");
    for (const Method method : options.methods) {
      rows.push_back(row_of(curves, method));
      progress(rows.size(), options.methods.size());
    }
  }
  Output_file output(options.output);
  if (options.format == Format::JSON) write_json(output.stream(), rows);
  else write_table(output.stream(), rows);
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool

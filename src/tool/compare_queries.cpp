// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs compare --queries: what the same searches cost over regions of each method.

#include "Commands.h"
#include "Output_file.h"

#include <CGAL/Bounding_arcs_2/study/Search_study.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <stdexcept>

namespace bounding_arcs_tool {
namespace {

using CGAL::Bounding_arcs::Drawing_2;
using CGAL::Bounding_arcs::Search_cost;
using CGAL::Bounding_arcs::Search_report;
using CGAL::Bounding_arcs::Search_tasks;

constexpr std::size_t POINTS = 16;  // in a row of a lattice

/// Sums over all curves.
struct Query_row {
  Method method;
  double eps;
  Search_cost regions{}, closest{}, descent{}, intersections{}, distance{}, hausdorff{};
  std::size_t bytes = 0, curves = 0;
};

struct Compared_question {
  const char* name;
  const char* title;  // of the picture's panel
  Search_cost Query_row::*cost;
  std::size_t asked;  // for each curve
};
const Compared_question QUESTIONS[] = {
    {"closest", "Closest point", &Query_row::closest, POINTS* POINTS},
    {"alone", "Closest point, by regions alone", &Query_row::descent, POINTS* POINTS},
    {"intersections", "Common points of two curves", &Query_row::intersections, 1},
    {"distance", "Least distance of two curves", &Query_row::distance, 1},
    {"hausdorff", "Hausdorff distance of two curves", &Query_row::hausdorff, 1},
};

void add(Search_cost& sum, const Search_cost& cost) {
  sum.seconds += cost.seconds;
  sum.regions += cost.regions;
}
void add(Query_row& row, const Search_report& report) {
  add(row.regions, report.regions);
  add(row.closest, report.closest);
  add(row.descent, report.descent);
  add(row.intersections, report.intersections);
  add(row.distance, report.distance);
  add(row.hausdorff, report.hausdorff);
  row.bytes += report.bytes;
  ++row.curves;
}

struct Mean_cost {
  double microseconds, regions;
};
Mean_cost mean(const Query_row& row, const Compared_question& question) {
  const Search_cost& cost = row.*question.cost;
  const auto count = static_cast<double>(question.asked * row.curves);
  return {1e6 * cost.seconds / count, static_cast<double>(cost.regions) / count};
}
// Both are means of one segment's region.
double nanoseconds(const Query_row& row) {
  return 1e9 * row.regions.seconds / static_cast<double>(row.regions.regions);
}
double bytes(const Query_row& row) { return static_cast<double>(row.bytes) / static_cast<double>(row.regions.regions); }

// \throws std::runtime_error where a method comes to other answers than the first one
std::vector<Query_row> query_rows(const std::vector<Loaded_curve>& curves, const Options& options) {
  std::vector<Query_row> rows;
  Progress_line progress("measuring, rows");
  const std::size_t all = options.eps.size() * options.methods.size() * curves.size();
  for (const double eps : options.eps) {
    const std::size_t first = rows.size();
    for (const Method method : options.methods) rows.push_back({method, eps});
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const Loaded_curve& curve = curves[c];
      const auto tasks = served(curve.file, curve.record.name, [&] {
        Drawing_2<double> drawing;
        drawing.add(curve.record.bezier_pieces<double>());
        return search_tasks(drawing, POINTS, eps);
      });
      Search_report reference;
      for (std::size_t m = 0; m < options.methods.size(); ++m) {
        const Search_report report = served(curve.file, curve.record.name,
                                            [&] { return search_report(options.methods[m], tasks, options.repeat); });
        if (m == 0) reference = report;
        else if (!have_same_answers(reference, report))
          throw Input_error(curve.file, "curve \"" + curve.record.name + "\"",
                            std::string("--queries: expected the answers of ") + name_of(options.methods[0]) +
                                ", found others by " + name_of(options.methods[m]));
        add(rows[first + m], report);
        progress((first * curves.size()) + c * options.methods.size() + m + 1, all);
      }
    }
  }
  return rows;
}

void write_table(std::ostream& out, const std::vector<Query_row>& rows) {
  char line[300];
  std::snprintf(line, sizeof line, "%8s %-12s %9s %6s %16s %16s %16s %16s %16s\n", "eps", "method", "ns/region",
                "bytes", "closest point", "alone", "common points", "distance", "Hausdorff");
  out << line;
  for (const Query_row& row : rows) {
    std::snprintf(line, sizeof line, "%8s %-12s %9.1f %6.0f", number(row.eps).c_str(), name_of(row.method),
                  nanoseconds(row), bytes(row));
    out << line;
    for (const Compared_question& question : QUESTIONS) {
      const Mean_cost m = mean(row, question);
      std::snprintf(line, sizeof line, " %8.2f %7.1f", m.microseconds, m.regions);
      out << line;
    }
    out << '\n';
  }
  out << "\nMicroseconds and regions that were asked for, a question: the shortest of all repetitions, the mean of "
         "all\n"
         "curves. ns/region and bytes are of the regions of spiral segments. alone: closest points by halving pieces\n"
         "until the regions tell them to eps, without Newton's steps. All methods came to the same answers.\n";
}

void write_json(std::ostream& out, const std::vector<Query_row>& rows) {
  out << "{\"queries\":[";
  const char* separator = "\n";
  for (const Query_row& row : rows) {
    out << separator << "{\"method\":\"" << name_of(row.method) << "\",\"eps\":" << number(row.eps)
        << ",\"curves\":" << row.curves << ",\"segments\":" << row.regions.regions
        << ",\"region_ns\":" << number(nanoseconds(row)) << ",\"region_bytes\":" << number(bytes(row));
    for (const Compared_question& question : QUESTIONS) {
      const Mean_cost m = mean(row, question);
      out << ",\"" << question.name << "\":{\"us\":" << number(m.microseconds) << ",\"regions\":" << number(m.regions)
          << '}';
    }
    out << '}';
    separator = ",\n";
  }
  out << "]}\n";
}

// A panel a question, a bar a method: as long as its time beside that of the first, in powers of two.
void draw(std::ostream& out, const std::vector<Query_row>& rows, std::size_t methods) {
  constexpr double BAR = 16, LEFT = 110, WIDTH = 260, GAP = 40, TOP = 84, MOST = 6;  // octaves to either side: 1, MOST
  const double height = BAR * static_cast<double>(methods), panel = height + 46, step = WIDTH / (MOST + 1);
  char text[400];
  const std::size_t sets = rows.size() / methods, questions = std::size(QUESTIONS);
  const double whole_width = LEFT + static_cast<double>(sets) * (WIDTH + GAP) + 110,
               whole_height = TOP + static_cast<double>(questions) * panel;
  std::snprintf(text, sizeof text,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n",
                whole_width, whole_height, whole_width, whole_height);
  out << text
      << "<title>Searches over regions of each method</title>\n"
         "<style>text{font-family:sans-serif;font-size:11px;fill:#333}.h{font-size:17px}.q{font-weight:bold}"
         ".g{stroke:#ddd}.o{stroke:#555}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
         "<text class=\"h\" x=\"12\" y=\"26\">What the same search costs over each kind of region</text>\n"
         "<text x=\"12\" y=\"44\">Times beside the first method's, at the dark line; each line is twice the one "
         "before.</text>\n<text x=\"12\" y=\"60\">At the bars: microseconds, and regions asked for.</text>\n";
  for (std::size_t q = 0; q < questions; ++q)
    for (std::size_t s = 0; s < sets; ++s) {
      const double x = LEFT + static_cast<double>(s) * (WIDTH + GAP), y = TOP + static_cast<double>(q) * panel;
      const Query_row* first = &rows[s * methods];
      std::snprintf(text, sizeof text, "<text class=\"q\" x=\"%.1f\" y=\"%.1f\">%s, eps %s</text>\n", x, y + 12,
                    QUESTIONS[q].title, number(first->eps).c_str());
      out << text;
      for (int octave = -1; octave <= static_cast<int>(MOST); ++octave) {
        const double at = x + step * (octave + 1);
        std::snprintf(text, sizeof text, "<path class=\"%c\" d=\"M%.1f %.1fv%.1f\"/>", octave == 0 ? 'o' : 'g', at,
                      y + 18, height);
        out << text;
      }
      out << '\n';
      for (std::size_t m = 0; m < methods; ++m) {
        const Mean_cost mean_of = mean(first[m], QUESTIONS[q]), reference = mean(first[0], QUESTIONS[q]);
        const double octaves = std::clamp(std::log2(mean_of.microseconds / reference.microseconds), -1.0, MOST),
                     top = y + 18 + BAR * static_cast<double>(m);
        std::snprintf(text, sizeof text,
                      "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\"/>"
                      "<text x=\"%.1f\" y=\"%.1f\">%.3g, %.3g</text>\n",
                      x, top + 2, step * (octaves + 1), BAR - 4, palette(first[m].method).stroke,
                      x + step * (octaves + 1) + 4, top + BAR - 4, mean_of.microseconds, mean_of.regions);
        out << text;
        if (s > 0) continue;
        std::snprintf(text, sizeof text, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">%s</text>\n", x - 8,
                      top + BAR - 4, name_of(first[m].method));
        out << text;
      }
    }
  out << "</svg>\n";
}

}  // namespace

int run_compared_queries(const Options& options) {
  const std::vector<Loaded_curve> curves = load_curves(options);
  if (curves.empty()) throw Input_error(options.files.front(), "curves", "expected at least one to ask, found none");
  const std::vector<Query_row> rows = query_rows(curves, options);
  Output_file output(options.output);
  if (options.format == Format::JSON) write_json(output.stream(), rows);
  else if (options.format == Format::SVG) draw(output.stream(), rows, options.methods.size());
  else write_table(output.stream(), rows);
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool

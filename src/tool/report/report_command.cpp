// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs report: one page that shows, lets compare and lets look into the regions of drawings.

#include "report_command.h"

#include "../Output_file.h"
#include "../offset/offset_command.h"
#include "../option_words.h"
#include "../stability/stability_command.h"
#include "../usage.h"
#include "File_report.h"
#include "page_parts.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <sstream>

namespace bounding_arcs_tool {
namespace {

// The tolerances from large to small, each once.
std::vector<double> tolerances_of(const std::string& words) {
  std::vector<double> eps;
  if (words.empty()) return eps;
  for (const std::string& word : words_between_commas(words)) eps.push_back(std::strtod(word.c_str(), nullptr));
  std::sort(eps.begin(), eps.end(), std::greater<>());
  eps.erase(std::unique(eps.begin(), eps.end()), eps.end());
  return eps;
}

Options options_of(const Report_words& words) {
  Options options;
  options.eps = tolerances_of(words.eps);
  options.kernel = kernels_by_name().at(words.kernel);
  for (const Method method : methods_between_commas(words.methods))
    if (std::find(options.methods.begin(), options.methods.end(), method) == options.methods.end())
      options.methods.push_back(method);
  options.repeat = words.repeat;
  options.max_regions = words.max_regions;
  return options;
}

std::string stability_picture(const Report_words& words) {
  Stability_options options;
  for (const std::string& name : words.families)
    if (name != "none") options.families.push_back(name);
  if (options.families.empty()) return "";
  options.choice.kernels = {"double"};  // what is drawn
  options.choice.quantities = {"center", "radius", "joint", "thickness"};
  std::ostringstream out;
  draw_stability(out, study_stability(options));
  return out.str();
}

// The parts of the page in their order, with what is between them.
void write_page(std::ostream& out, const std::string& title, const std::string& data) {
  out << page_parts::HEAD << "<title>" << page_text(title) << "</title>\n<style>\n"
      << page_parts::STYLE << "</style>\n"
      << page_parts::BODY << "<script type=\"application/json\" id=\"data\">" << data << "</script>\n<script>\n"
      << page_parts::SCRIPT << "</script>\n</body>\n</html>\n";
}

}  // namespace

CLI::App* add_report_command(CLI::App& app, Report_words& words) {
  CLI::App* report =
      app.add_subcommand("report", "One page to look into drawings, regions and comparisons, in a browser");
  report->add_option("FILES", words.files, "Curve files, JSON, SVG or DXF; - reads standard input")->required();
  add_output(*report, "html", words.output);
  report
      ->add_option("--eps", words.eps,
                   "Largest thickness of a leaf region, in units of the coordinates; several with commas between.\n"
                   "Without it 1e-1, ..., 1e-6 of each drawing's extent, in two digits")
      ->check(CLI::Validator(check_tolerances, "", "eps"))
      ->type_name("NUMBER");
  report->add_option("--methods", words.methods, "Methods to show side by side, with commas between")
      ->check(CLI::Validator(check_methods, "", "methods"))
      ->type_name("LIST")
      ->capture_default_str();
  report->add_option("--kernel", words.kernel, "As for build")
      ->check(one_of({"double", "filtered", "exact"}))
      ->capture_default_str();
  report
      ->add_option("--query", words.queries,
                   "What is asked of each drawing, several with commas between; closest and locate need --points")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of({"self-intersect", "hull", "closest", "locate"}));
  report->add_option("--points", words.points, "A file of points, two numbers a line");
  report->add_option("--offset", words.distances, "Show offsets of each drawing, by distances with commas between")
      ->check(CLI::Validator(check_distances, "", "distance"))
      ->type_name("LIST");
  report->add_flag("--medial-axis", words.with_medial_axis, "Show the medial axis of what closed curves enclose");
  add_rule(*report, words.reading.rule);
  add_reading_options(*report, words.reading);
  report
      ->add_option(
          "--stability", words.families,
          "Families whose stability is plotted, several with commas between: near-linear and near-circular, which\n"
          "take half a minute, subdivision, or none")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of({"near-linear", "near-circular", "subdivision", "none"}))
      ->default_str("subdivision");
  report->add_option("--repeat", words.repeat, "Measure each row of the table this often; the least is shown")
      ->check(whole_number_in(1, 1000000))
      ->capture_default_str();
  report->add_option("--max-size", words.max_size, "About how large the page may be, in MiB")
      ->check(number_in(0.1, 1000))
      ->capture_default_str();
  report
      ->add_option("--max-regions", words.max_regions,
                   "Give up above this number of regions a curve, leaves and those above them")
      ->check(whole_number_in(1, 4'000'000'000))
      ->capture_default_str();
  report->footer(
      "The page is one file and needs no network: drawings to pan and zoom, sliders for eps and for the levels of the\n"
      "trees, methods side by side, the table of compare, how thickness falls with size, the plots of stability, and\n"
      "answers to queries. Offsets and axes are within the middle one of the tolerances, offsets within an eighth of\n"
      "their distance, too. What would make the page too large is left out, the finest regions\n"
      "first, and the page says so.\n"
      "Examples:\n"
      "  bounding_arcs report examples/data/*.json -o report.html\n"
      "  bounding_arcs report --eps 1,0.1,0.01 --query self-intersect,hull drawing.svg -o report.html\n"
      "  bounding_arcs report --methods bca --offset 0.02,-0.02 --medial-axis curve.json -o report.html\n"
      "  bounding_arcs report --max-size 50 --stability none glyphs.svg -o large.html\n");
  return report;
}

int run_report(const Report_words& words) {
  check_inputs(words.files);
  const bool needs_points = std::any_of(words.queries.begin(), words.queries.end(), [](const std::string& query) {
    return query == "closest" || query == "locate";
  });
  if (needs_points && words.points.empty())
    throw Usage_error("--points", "a file of points for queries closest and locate", "none");
  if (!needs_points && !words.points.empty())
    throw Usage_error("--points", "query closest or locate beside it", "neither");
  const Options options = options_of(words);
  check_yardsticks(options.methods, options.kernel, false, false);
  std::vector<CGAL::Bounding_arcs::Curve_file> read;  // what is wrong is told before plots are measured for seconds
  Reading_words reading = words.reading;
  for (const std::string& file : words.files) {
    read.push_back(read_told(file, reading));
    reading.keep_unit({name_of_file(file), read.back().unit_in_mm});
    if (read.back().curves.empty()) throw Input_error(file, "curves", "expected at least one to look into, found none");
  }
  constexpr double MIB = 1048576;
  const std::string picture = stability_picture(words);
  auto room = static_cast<std::size_t>(words.max_size * MIB);
  const std::size_t fixed = picture.size() + page_parts::SCRIPT.size() + page_parts::STYLE.size();
  room -= std::min(room, fixed);
  std::string files;
  for (std::size_t i = 0; i < words.files.size(); ++i) {  // what one leaves is for those behind it
    const std::string text =
        file_json(name_of_file(words.files[i]), std::move(read[i]), words, options, room / (words.files.size() - i));
    room -= std::min(room, text.size());
    files += (i > 0 ? ",\n" : "") + text;
  }
  std::string methods;
  for (const Method method : options.methods)
    methods += (methods.empty() ? "\"" : ",\"") + std::string(name_of(method)) + "\"";
  const std::string data = "{\"methods\":[" + methods + "],\"kernel\":\"" + words.kernel +
                           "\",\"repeat\":" + std::to_string(words.repeat) + ",\"stability\":" + page_string(picture) +
                           ",\n\"files\":[" + files + "]}";
  std::string title = "Bounding arcs: " + words.files.front();
  if (words.files.size() > 1) title += " and " + std::to_string(words.files.size() - 1) + " more";
  Output_file output(words.output);
  write_page(output.stream(), title, data);
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool

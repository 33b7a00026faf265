// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line: options and dispatch. Exit status 0, 1 for bad input or a failed check, 2 for wrong usage.

#include "Commands.h"
#include "Output_file.h"
#include "arcs_command.h"
#include "arrange/arrange_command.h"
#include "boolean/boolean_command.h"
#include "boolean/clip_command.h"
#include "info/info_command.h"
#include "medial_axis/medial_axis_command.h"
#include "medial_axis/thickness_command.h"
#include "medial_axis/verify_axis_command.h"
#include "offset/offset_command.h"
#include "option_words.h"
#include "query/query_command.h"
#include "report/report_command.h"
#include "stability/stability_command.h"
#include "usage.h"

#include "../input/Input_text.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace bounding_arcs_tool;

constexpr int FAILURE = 1, USAGE = 2;

const std::map<std::string, Split> SPLITS{{"midpoint", Split::MIDPOINT}, {"optimal", Split::OPTIMAL}};

// The words as CLI11 holds them, turned into Options after parsing.
struct Words {
  std::vector<std::string> files;
  std::string method, methods = "bca,bilens,sfa", eps, kernel = "double", format, split = "midpoint";
};

void add_common(CLI::App& command, Words& words, Options& options, const std::vector<std::string>& formats) {
  command.add_option("FILES", words.files, "Curve files, JSON, SVG or DXF; - reads standard input")->required();
  add_reading_options(command, options.reading);
  add_output(command, formats, words.format, options.output);
  command
      .add_option("--kernel", words.kernel,
                  "double: fast; filtered: double with exact decisions; exact: rational numbers and square roots")
      ->check(one_of(names_of(kernels_by_name())))
      ->capture_default_str();
  command
      .add_option("--split", words.split,
                  "Where pieces are cut: midpoint, of their parameters; optimal, for the fewest regions")
      ->check(one_of(names_of(SPLITS)))
      ->capture_default_str();
  command
      .add_option("--max-regions", options.max_regions,
                  "Give up above this number of regions a curve, leaves and those above them")
      ->check(whole_number_in(1, 4'000'000'000))
      ->capture_default_str();
}

void add_method(CLI::App& command, Words& words) {
  command
      .add_option(
          "--method", words.method,
          "bca, sfa (spiral fat arcs) or bilens; to compare with, for the double kernel: fat-arc, fat-biarc, box\n"
          "(axis-aligned), oriented-box (along the chord), hull (of control points)")
      ->required()
      ->check(one_of(names_of(methods_by_name())));
}

CLI::Option* add_eps(CLI::App& command, Words& words, const std::string& many) {
  return command
      .add_option("--eps", words.eps, "Largest thickness of a leaf region, in units of the coordinates" + many)
      ->check(CLI::Validator(check_tolerances, "", "eps"))
      ->type_name("NUMBER");
}

Format format_of(const std::string& name) {
  if (name == "json") return Format::JSON;
  if (name == "svg") return Format::SVG;
  return name == "csv" ? Format::CSV : Format::TABLE;
}

int run(int argc, char** argv) {
  CLI::App app(
      "Encloses planar freeform curves in circular arcs: bounding circular arcs (BCA), spiral fat arcs (SFA), bilens.");
  app.name("bounding_arcs");
  app.require_subcommand(1);
  app.set_version_flag("--version", "bounding_arcs " BOUNDING_ARCS_VERSION, "Print the version and exit");
  app.footer(
      "Curve files are JSON, for example\n"
      "  {\"name\":\"arch\",\"type\":\"bezier\",\"degree\":2,\"control_points\":[[0,0],[0.5,0],[1,1]]}\n"
      "or SVG or DXF drawings. `bounding_arcs SUBCOMMAND --help` shows examples of each subcommand.\n");
  Options options;
  Words build_words, compare_words, verify_words;

  CLI::App* build = app.add_subcommand("build", "Build hierarchies and write their leaf regions");
  add_common(*build, build_words, options, {"json", "csv", "svg"});
  add_method(*build, build_words);
  add_eps(*build, build_words, "")->required();
  build->add_flag("--certified", options.certified,
                  "Add to each region its widening: the exact curve is that near to the region as it is written; where "
                  "that of the method's region is above 64 ulp of the coordinates, write the BCA");
  add_stream_options(*build, options.stream, build_words.format);
  build->footer(
      "Examples:\n"
      "  bounding_arcs build --method bca --eps 1e-4 curve.json -o regions.json\n"
      "  bounding_arcs build --method bca --eps 1e-4 --certified curve.json -o certified.json\n"
      "  bounding_arcs build --method bilens --eps 0.02 --format svg curve.json -o picture.svg\n"
      "  bounding_arcs build --method sfa --eps 1e-6 --kernel exact drawing.svg\n"
      "  bounding_arcs build --method bca --eps 1e-8 --split optimal curve.json -o fewest.json\n"
      "  bounding_arcs build --method bca --eps 1e-4 --stream --jobs 8 records.jsonl -o results.jsonl\n");

  CLI::App* compare = app.add_subcommand("compare", "Compare the methods: time, regions, arcs, for each curve and eps");
  add_common(*compare, compare_words, options, {"table", "json", "svg"});
  compare_words.eps = "1e-5,1e-8,1e-10";
  CLI::Option* compared_eps = add_eps(*compare, compare_words, "; several with commas between")->capture_default_str();
  compare
      ->add_option(
          "--methods", compare_words.methods,
          "Methods to compare, with commas between, of bca, sfa, bilens, fat-arc, fat-biarc, box, oriented-box\n"
          "and hull; the first is the reference of ratios")
      ->check(CLI::Validator(check_methods, "", "methods"))
      ->type_name("LIST")
      ->capture_default_str();
  CLI::Option* orders = compare->add_flag(
      "--orders", "Tell how fast thickness falls with the size of pieces, in place of times and numbers of regions");
  CLI::Option* queries = compare->add_flag(
      "--queries",
      "Tell what the same searches cost over regions of each method: closest points, common points, least distance "
      "and\n"
      "Hausdorff distance of each curve and moved ones; eps is that of distances, 1e-6 where it is not given");
  compare->add_option("--repeat", options.repeat, "Measure each row this often; the least and the median are shown")
      ->check(whole_number_in(1, 1000000))
      ->capture_default_str();
  compare->footer(
      "Examples:\n"
      "  bounding_arcs compare examples/data/*.json\n"
      "  bounding_arcs compare --eps 1e-4,1e-6 --methods bca,bilens --repeat 20 curve.json\n"
      "  bounding_arcs compare --eps 1e-3 --methods bca,fat-arc,fat-biarc,oriented-box,hull,box curve.json\n"
      "  bounding_arcs compare --orders --methods bca,sfa,bilens,fat-arc,fat-biarc,oriented-box,hull,box curve.json\n"
      "  bounding_arcs compare --queries --methods bca,sfa,bilens,fat-arc,fat-biarc,oriented-box,hull,box curve.json\n"
      "  bounding_arcs compare --format json curve.json -o table.json\n");

  CLI::App* verify = app.add_subcommand(
      "verify", "Prove that every leaf region holds its piece of the curve and is no thicker than told");
  add_common(*verify, verify_words, options, {"table", "json"});
  add_method(*verify, verify_words);
  add_eps(*verify, verify_words, "; several with commas between")->required();
  verify->add_flag(
      "--certified", options.certified,
      "Prove the regions as build --certified writes them, in rounded numbers and each moved outward by its own "
      "widening, and show the largest widening");
  verify->footer(
      "Exit status 1 when a region is not proven. Proofs are exact; nothing is sampled.\n"
      "With --certified a region is what the boundary in doubles encloses, and all points as near to that as its\n"
      "widening, which is reported in units of the coordinates and in units in the last place (ulp) of the\n"
      "largest one.\n"
      "Examples:\n"
      "  bounding_arcs verify --method sfa --eps 1e-6 --certified curve.json\n"
      "  bounding_arcs verify --method bca --eps 1e-6 curve.json\n"
      "  bounding_arcs verify --method bilens --eps 1e-3,1e-6 --format json examples/data/*.json\n");

  Stability_options stability_options;
  CLI::App* stability = add_stability_command(app, stability_options);
  Arcs_options arcs_options;
  CLI::App* arcs = add_arcs_command(app, arcs_options);
  Query_options query_options;
  Boolean_words boolean_words;
  CLI::App* boolean = add_boolean_command(app, boolean_words);
  Clip_words clip_words;
  CLI::App* clip = add_clip_command(app, clip_words);
  Arrange_words arrange_words;
  CLI::App* arrange = add_arrange_command(app, arrange_words);
  Offset_words offset_words;
  CLI::App* offset = add_offset_command(app, offset_words);
  Medial_axis_words axis_words;
  CLI::App* axis = add_medial_axis_command(app, axis_words);
  Verify_axis_words verify_axis_words;
  CLI::App* verify_axis = add_verify_axis_command(app, verify_axis_words);
  Thickness_words thickness_words;
  CLI::App* thickness = add_thickness_command(app, thickness_words);
  CLI::App* query = add_query_command(app, query_options);
  Info_words info_words;
  CLI::App* info = add_info_command(app, info_words);
  Report_words report_words;
  CLI::App* report = add_report_command(app, report_words);

  try {
    std::vector<std::string> words(argv + 1, argv + argc);
    give_margins(words);
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    app.parse(std::move(words));
    check_words(app);
  } catch (const CLI::Success& help) {
    Output_file output("");
    app.exit(help, output.stream());
    output.commit();
    return 0;
  } catch (const CLI::ParseError& error) {
    std::cerr << "bounding_arcs: " << usage_text(app, error) << "\n";
    return USAGE;
  }
  if (stability->parsed()) return run_stability(stability_options);
  if (arcs->parsed()) return run_arcs(arcs_options);
  if (boolean->parsed()) return run_boolean(boolean_words);
  if (clip->parsed()) return run_clip(clip_words);
  if (arrange->parsed()) return run_arrange(arrange_words);
  if (offset->parsed()) return run_offset(offset_words);
  if (axis->parsed()) return run_medial_axis(axis_words);
  if (verify_axis->parsed()) return run_verify_axis(verify_axis_words);
  if (thickness->parsed()) return run_thickness(thickness_words);
  if (info->parsed()) return run_info(info_words);
  if (query->parsed()) return run_query(*query, query_options);
  if (report->parsed()) return run_report(report_words);
  if (build->parsed() && build_words.eps.find(',') != std::string::npos)
    throw Usage_error("--eps", "one tolerance", in_quotes(build_words.eps));
  if (build->parsed() && options.certified && build_words.format != "json")
    throw Usage_error("--format", "json with --certified, as no other form has widenings", build_words.format);
  const Words& words = build->parsed() ? build_words : (compare->parsed() ? compare_words : verify_words);
  options.files = words.files;
  options.format = format_of(words.format);
  options.kernel = kernels_by_name().at(words.kernel);
  options.split = SPLITS.at(words.split);
  options.eps.clear();
  for (const std::string& eps : words_between_commas(words.eps))
    options.eps.push_back(std::strtod(eps.c_str(), nullptr));
  options.methods = methods_between_commas(compare->parsed() ? words.methods : words.method);
  check_inputs(options.files);
  check_yardsticks(options.methods, options.kernel, options.split == Split::OPTIMAL, options.certified);
  if (compare->parsed() && options.format == Format::SVG && queries->count() == 0)
    throw Usage_error("--format", "table or json without --queries", "svg");
  if (orders->count() + queries->count() > 0) {
    const std::string table = orders->count() > 0 ? "--orders" : "--queries";
    if (options.kernel != Kernel::DOUBLE) throw Usage_error("--kernel", "double with " + table, words.kernel);
    if (orders->count() > 0 && queries->count() > 0) throw Usage_error("--orders", "one table", "--queries beside it");
    if (orders->count() > 0) return run_orders(options);
    if (compared_eps->count() == 0) options.eps = {1e-6};
    return run_compared_queries(options);
  }
  return build->parsed() ? run_build(options) : (compare->parsed() ? run_compare(options) : run_verify(options));
}

}  // namespace

int main(int argc, char** argv) {
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is an error of the write, not the end of the program
#endif
  // CGAL's common divisors of polynomials make remarks there ("UNLUCKY PRIME !!"); results have streams of their own.
  std::cout.setstate(std::ios_base::failbit);
  try {
    return run(argc, argv);
  } catch (const Usage_error& error) {
    std::cerr << "bounding_arcs: " << error.what() << "\n";
    return USAGE;
  } catch (const std::bad_alloc&) {
    std::cerr << "bounding_arcs: out of memory\n";
  } catch (const std::exception& error) {
    std::cerr << "bounding_arcs: " << error.what() << "\n";
  }
  return FAILURE;
}

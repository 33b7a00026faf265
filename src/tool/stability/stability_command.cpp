// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs stability: how many digits each method, formula and kernel keeps on families of spirals.

#include "stability_command.h"

#include "../Commands.h"
#include "../Output_file.h"
#include "../option_words.h"
#include "../usage.h"
#include "study_stability.h"

#include <CGAL/Bounding_arcs_2/study/Worst_case_hunt.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <limits>

namespace bounding_arcs_tool {
namespace {

using namespace CGAL::Bounding_arcs;

CLI::Option* add_words(CLI::App& command, const std::string& name, std::vector<std::string>& words,
                       const std::string& help, const std::vector<std::string>& known) {
  return command.add_option(name, words, help)->delimiter(',')->allow_extra_args(false)->check(one_of(known));
}

void add_choice(CLI::App& command, Stability_choice& choice) {
  add_words(
      command, "--methods", choice.methods,
      "Only rows of these, several with commas between; without it bca, sfa and bilens. fat-arc, fat-biarc, box,\n"
      "oriented-box and hull have rows of thickness",
      {"bca", "sfa", "bilens", "fat-arc", "fat-biarc", "box", "oriented-box", "hull"});
  add_words(command, "--formulas", choice.formulas, "Only rows of these", {"textbook", "stable"});
  add_words(command, "--kernels", choice.kernels, "Only rows of these; one takes half the time of all",
            {"float", "double", "long-double", "filtered"});
  add_words(command, "--quantities", choice.quantities, "Only rows of these",
            {"normal", "bisector", "center", "radius", "joint", "thickness", "outside"});
}

void add_hunt(CLI::App& command, Stability_options& options) {
  CLI::Option* seconds =
      command
          .add_option("--hunt", options.hunt_seconds,
                      "In place of families, climb for so many seconds by steps of ulps to the worst cases of the\n"
                      "chosen figures, one after the other; without a choice, those of stable formulas in double")
          ->check(number_in(0.001, 1e6))
          ->type_name("SECONDS");
  command.add_option("--hunt-steps", options.hunt_steps, "As --hunt, for so many steps, some 1000 a second")
      ->check(whole_number_in(1, 1'000'000'000))
      ->excludes(seconds);
}

bool is_hunt(const Stability_options& options) { return options.hunt_seconds > 0 || options.hunt_steps > 0; }

// What a hunt and a study without words are of.
Stability_options completed(Stability_options options) {
  const bool has_curves = !options.files.empty() || !options.curve.empty();
  if (is_hunt(options)) {
    Stability_choice& choice = options.choice;
    if (choice.formulas.empty()) choice.formulas = {"stable"};
    if (choice.kernels.empty()) choice.kernels = {"double"};
    if (choice.quantities.empty()) choice.quantities = {"center", "radius", "joint", "thickness"};
  } else if (options.families.empty() && !has_curves) {
    options.families = {"near-linear", "near-circular", "subdivision"};
  }
  // Neither table nor plot has a place for outside, which takes most of the time.
  if (options.choice.quantities.empty() && options.format == "markdown")
    options.choice.quantities = {"normal", "bisector", "center", "radius", "joint", "thickness"};
  if (options.choice.quantities.empty() && options.format == "svg")
    options.choice.quantities = {"center", "radius", "joint", "thickness"};
  return options;
}

bool is_of_tables(const Stability_options& options) {
  return options.is_of_costs || options.is_of_consequences || options.is_of_verdicts;
}

Study_table table_of(const Stability_options& options) {
  if (options.is_of_costs) return cost_table(options);
  return options.is_of_verdicts ? verdict_table() : consequence_table(options);
}

const char* name_of_table(const Stability_options& options) {
  if (options.is_of_costs) return "--costs";
  return options.is_of_verdicts ? "--verdicts" : "--consequences";
}

void check_table(const Stability_options& options) {
  const char* const table = name_of_table(options);
  if (is_hunt(options)) throw Usage_error(table, "no hunt beside it", "--hunt");
  if (!options.worst.empty()) throw Usage_error(table, "no file of worst curves", "--worst");
  if (options.is_of_verdicts) return;
  if (options.format == "svg")
    throw Usage_error("--format", "csv, json or markdown with " + std::string(table), options.format);
  for (const std::string& m : options.choice.methods)
    if (m != "bca" && m != "sfa" && m != "bilens")
      throw Usage_error("--methods", "bca, sfa or bilens with " + std::string(table), m);
}

void check_hunt(const Stability_options& options) {
  const char* const what = "curves that it makes itself";
  if (!options.families.empty()) throw Usage_error("--hunt", what, "--family");
  if (!options.files.empty()) throw Usage_error("--hunt", what, "FILES");
  if (!options.curve.empty()) throw Usage_error("--hunt", what, "--curve");
  if (!Worst_case_hunt::has_figures(completed(options).choice))
    throw Usage_error("--quantities", "figures of the methods and formulas that are chosen",
                      "none: a BCA has no joint, only textbook formulas of BCA and bilens have bisectors, and "
                      "yardsticks have thickness alone");
}

}  // namespace

CLI::App* add_stability_command(CLI::App& app, Stability_options& options) {
  CLI::App* command = app.add_subcommand("stability", "Measure how many digits each method, formula and kernel keeps");
  command->add_option(
      "FILES", options.files,
      "Curve files, JSON, SVG or DXF, whose spirals are a family \"curves\" too; - reads standard input");
  add_reading_options(*command, options.reading);
  command->add_option("--curve", options.curve, "A JSON curve, as in a file, that is in this family")
      ->type_name("JSON");
  add_words(*command, "--family", options.families,
            "near-linear, near-circular, subdivision or random, several with commas between; without it, and without\n"
            "curves, all but random",
            {"near-linear", "near-circular", "subdivision", "random"});
  add_output(*command, {"csv", "json", "svg", "markdown"}, options.format, options.output,
             "; svg plots the rows of double, markdown has a table of steps by family and delta");
  command->add_option("--count", options.count, "Random spirals to measure, some 300 a second")
      ->check(whole_number_in(1, 100'000'000))
      ->capture_default_str();
  command->add_option("--seed", options.seed, "Seed of the random spirals, and of a hunt")
      ->check(whole_number_in(0, (std::numeric_limits<unsigned>::max)()))
      ->capture_default_str();
  add_choice(*command, options.choice);
  add_hunt(*command, options);
  command->add_flag("--condition", options.with_condition,
                    "Tell the condition number of each figure: about so many units roundoff it is uncertain by the\n"
                    "rounding of the input alone. A row whose error is far above has lost digits by its formula");
  CLI::Option* costs = command->add_flag(
      "--costs", options.is_of_costs,
      "In place of errors, tell what it costs to be exact: bits of rationals, of corners (Root_of_2) and of\n"
      "enclosures, times over that of double, and which stage of the filter decides, for some deltas");
  command
      ->add_flag(
          "--consequences", options.is_of_consequences,
          "In place of errors, tell what goes wrong where rounded figures are believed: the share of thicknesses\n"
          "on the wrong side of a tolerance, of pieces that are not held, and of wrong numbers of regions")
      ->excludes(costs);
  command
      ->add_flag(
          "--verdicts", options.is_of_verdicts,
          "In place of errors, ask predicates at 256 x 256 neighbouring doubles: side of arc, tangency and point\n"
          "location. It counts where rounded figures are wrong; svg draws them beside exact verdicts")
      ->excludes(costs)
      ->excludes("--consequences");
  command->add_option("--worst", options.worst,
                      "Write the curve of the worst row of each family, method, formula, kernel and quantity to this "
                      "file, JSON");
  command->add_option("--jobs", options.jobs, "Threads that measure; what is found does not depend on them")
      ->check(whole_number_in(1, 1024))
      ->capture_default_str();
  command->footer(
      "A row is the worst of a family's curves at one delta; of random spirals and for all delta, the worst of all.\n"
      "It has that curve, and the command that gives the row again. The formulas are those of the paper (textbook) "
      "and\n"
      "of this library (stable). Quantities are steps on the way to a thickness; normal is a direction, bisector a "
      "line\n"
      "of the textbook's. Errors are against exact arithmetic. Quantity outside is a proven bound of how far "
      "the\n"
      "exact curve leaves the rounded region. Certified regions, see verify --certified, are widened by it: no curve\n"
      "leaves them.\n"
      "Examples:\n"
      "  bounding_arcs stability --family near-linear -o near_linear.csv\n"
      "  bounding_arcs stability --format svg -o stability.svg\n"
      "  bounding_arcs stability --format markdown --formulas textbook --kernels double --condition\n"
      "  bounding_arcs stability --costs --format markdown\n"
      "  bounding_arcs stability --consequences -o consequences.csv\n"
      "  bounding_arcs stability --verdicts --format svg -o verdicts.svg\n"
      "  bounding_arcs stability --family random --count 100000 --seed 7 --kernels double --worst worst.json\n"
      "  bounding_arcs stability --hunt 60 --methods bca --quantities thickness --worst found.json\n"
      "  bounding_arcs stability --format json examples/data/a_wrench.json\n");
  return command;
}

int run_stability(const Stability_options& words) {
  check_inputs(words.files);
  if (is_of_tables(words)) check_table(words);
  else if (is_hunt(words)) check_hunt(words);
  const Stability_options options = completed(words);
  if (is_of_tables(options)) {
    Output_file output(options.output);
    if (options.format == "svg") draw_verdicts(output.stream());
    else write_table(output.stream(), table_of(options), options.format);
    output.commit();
    return 0;
  }
  std::vector<Stability_row> rows = is_hunt(options) ? hunt_stability(options) : study_stability(options);
  if (options.with_condition) add_conditions(rows);
  if (!options.worst.empty()) {  // one file after the other: there is one unfinished file at a time
    Output_file worst(options.worst);
    write_worst_curves(worst.stream(), rows);
    worst.commit();
  }
  Output_file output(options.output);
  if (options.format == "json") write_stability_json(output.stream(), rows, options);
  else if (options.format == "svg") draw_stability(output.stream(), rows);
  else if (options.format == "markdown") write_stability_table(output.stream(), rows);
  else write_stability_csv(output.stream(), rows, options);
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool

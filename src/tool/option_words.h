// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words of the command line that several subcommands take. Checks return what is wrong, or nothing, as CLI11 wants.

#ifndef BOUNDING_ARCS_TOOL_OPTION_WORDS_H
#define BOUNDING_ARCS_TOOL_OPTION_WORDS_H

#include "Hierarchy.h"
#include "dxf/write_dxf.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
class Validator;
}  // namespace CLI

namespace bounding_arcs_tool {

[[nodiscard]] std::vector<std::string> words_between_commas(const std::string& list);

/// Tells what is wrong with a tolerance, a positive number.
[[nodiscard]] std::string check_tolerance(const std::string& word);
/// Tells what is wrong with several, with commas between.
[[nodiscard]] std::string check_tolerances(const std::string& list);

/// Checks one number from least to most; CLI11's own check takes nan, which is neither below nor above any number.
[[nodiscard]] CLI::Validator number_in(double least, double most);
[[nodiscard]] CLI::Validator whole_number_in(std::size_t least, std::size_t most);
/// Checks a word of a list.
[[nodiscard]] CLI::Validator one_of(const std::vector<std::string>& words);

/// The names of a map from names.
template <class Map> [[nodiscard]] std::vector<std::string> names_of(const Map& map) {
  std::vector<std::string> names;
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}

/// The form of output that a file's ending stands for, "" where it stands for none.
[[nodiscard]] std::string form_of_ending(const std::string& path);
/// Adds --output for a subcommand with one form, whose file has no ending that stands for another form.
void add_output(CLI::App& command, const std::string& form, std::string& path);
/// Adds --format and --output. Without --format the ending of the file decides: one that stands for no form leaves the
/// first form, one that stands for a form that is not there is wrong usage.
/// \param forms the forms that are there; the first becomes `format`
/// \param what more of the help of --format
void add_output(CLI::App& command, const std::vector<std::string>& forms, std::string& format, std::string& path,
                const std::string& what = "");

/// What methods and kernels are called.
[[nodiscard]] const std::map<std::string, Method>& methods_by_name();
[[nodiscard]] const std::map<std::string, Kernel>& kernels_by_name();
/// Tells what is wrong with several methods, with commas between.
[[nodiscard]] std::string check_methods(const std::string& list);
[[nodiscard]] std::vector<Method> methods_between_commas(const std::string& list);
/// Refuses options for the methods that others are compared with: these are there for the double kernel, in hierarchies
/// halved at midpoints and without certified regions. \throws Usage_error
void check_yardsticks(const std::vector<Method>& methods, Kernel kernel, bool is_split_optimal, bool is_certified);

/// Adds the option --rule: nonzero or evenodd. The word may be even-odd, too, and becomes evenodd; empty without it.
CLI::Option* add_rule(CLI::App& command, std::string& word);
/// The rule that a word names. \param otherwise that of an empty word
[[nodiscard]] CGAL::Bounding_arcs::Fill_rule fill_rule(const std::string& word,
                                                       CGAL::Bounding_arcs::Fill_rule otherwise);

/// What a rule is called.
[[nodiscard]] const char* name_of(CGAL::Bounding_arcs::Fill_rule rule);

/// Adds the flag --plain.
void add_plain(CLI::App& command, bool& is_plain);
/// Throws where it is asked for beside another format than svg. \throws Usage_error
void check_plain(bool is_plain, const std::string& format);

/// Adds the option --dxf-entities: polylines or arcs.
void add_dxf_entities(CLI::App& command, std::string& word);
[[nodiscard]] Dxf_entities dxf_entities(const std::string& word);

/// A field of a line of CSV, quoted where it has to be.
[[nodiscard]] std::string csv_field(const std::string& text);

}  // namespace bounding_arcs_tool

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "option_words.h"

#include "number_text.h"
#include "usage.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace bounding_arcs_tool {

std::vector<std::string> words_between_commas(const std::string& list) {
  std::vector<std::string> words(1);
  for (const char c : list) {
    if (c == ',') words.emplace_back();
    else words.back() += c;
  }
  return words;
}

std::string check_tolerance(const std::string& word) {
  char* end = nullptr;
  const double eps = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !std::isfinite(eps) || eps <= 0)
    return expected("one positive number such as 1e-6", word);
  return "";
}

std::string check_tolerances(const std::string& list) {
  for (const std::string& word : words_between_commas(list))
    if (std::string wrong = check_tolerance(word); !wrong.empty()) return wrong;
  return "";
}

CLI::Validator number_in(double least, double most) {
  const std::string from = number(least), to = number(most);
  const auto check = [=](const std::string& word) -> std::string {
    char* end = nullptr;
    const double x = std::strtod(word.c_str(), &end);
    if (!word.empty() && *end == '\0' && x >= least && x <= most) return "";
    return expected("a number from " + from + " to " + to, word);
  };
  return CLI::Validator(check, "NUMBER in [" + from + " - " + to + "]");
}

CLI::Validator whole_number_in(std::size_t least, std::size_t most) {
  const std::string from = std::to_string(least), to = std::to_string(most);
  const auto check = [=](const std::string& word) -> std::string {
    std::size_t x = 0;
    const char* const end = word.data() + word.size();
    const auto [last, status] = std::from_chars(word.data(), end, x);
    if (status == std::errc() && last == end && x >= least && x <= most) return "";
    return expected("a whole number from " + from + " to " + to, word);
  };
  return CLI::Validator(check, "NUMBER in [" + from + " - " + to + "]");
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto check = [=](const std::string& word) -> std::string {
    return std::find(words.begin(), words.end(), word) != words.end() ? "" : expected(one_of_text(words), word);
  };
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "{" : ",") + word;
  return CLI::Validator(check, all + "}");
}

namespace {

struct Form_ending {
  const char *form, *ending;
};
constexpr Form_ending ENDINGS[] = {{"json", ".json"}, {"svg", ".svg"},     {"csv", ".csv"},   {"dxf", ".dxf"},
                                   {"table", ".txt"}, {"markdown", ".md"}, {"html", ".html"}, {"gcode", ".gcode"},
                                   {"gcode", ".nc"},  {"gcode", ".ngc"}};

std::string endings_of(const std::vector<std::string>& forms) {
  std::vector<std::string> endings;
  for (const std::string& form : forms)
    for (const Form_ending& e : ENDINGS)
      if (form == e.form) endings.emplace_back(e.ending);
  return one_of_text(endings);
}

// \param given the option --format, and what it sets; nullptr where there is one form
void add_output_option(CLI::App& command, const std::vector<std::string>& forms, const CLI::Option* given,
                       std::string* format, std::string& path) {
  const auto take = [=](const std::string& output) -> std::string {
    if (output.empty()) return expected("a file name", output);
    const std::string form = form_of_ending(output);
    if (form.empty() || (given != nullptr && given->count() > 0)) return "";
    if (std::find(forms.begin(), forms.end(), form) == forms.end())
      return expected("a name in " + endings_of(forms) + (given != nullptr ? ", or --format" : ""), output);
    if (format != nullptr) *format = form;
    return "";
  };
  command.add_option("-o,--output", path, "Write to this file, whole or not at all, instead of standard output")
      ->check(CLI::Validator(take, "", "output"));
}

}  // namespace

std::string form_of_ending(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const Form_ending& e : ENDINGS)
    if (ending == e.ending) return e.form;
  return "";
}

void add_output(CLI::App& command, const std::string& form, std::string& path) {
  add_output_option(command, {form}, nullptr, nullptr, path);
}

void add_output(CLI::App& command, const std::vector<std::string>& forms, std::string& format, std::string& path,
                const std::string& what) {
  format = forms.front();
  const CLI::Option* given =
      command
          .add_option("--format", format,
                      "Form of the output" + what + "; without it the ending of --output decides" +
                          (std::find(forms.begin(), forms.end(), "svg") != forms.end()
                               ? ";\nsvg is a picture, which has coordinates of its own"
                               : ""))
          ->check(one_of(forms))
          ->capture_default_str();
  add_output_option(command, forms, given, &format, path);
}

const std::map<std::string, Method>& methods_by_name() {
  static const std::map<std::string, Method> METHODS = [] {
    std::map<std::string, Method> methods;
    for (const Method method : all_methods()) methods.emplace(name_of(method), method);
    return methods;
  }();
  return METHODS;
}

const std::map<std::string, Kernel>& kernels_by_name() {
  static const std::map<std::string, Kernel> KERNELS{
      {"double", Kernel::DOUBLE}, {"filtered", Kernel::FILTERED}, {"exact", Kernel::EXACT}};
  return KERNELS;
}

std::string check_methods(const std::string& list) {
  for (const std::string& word : words_between_commas(list))
    if (methods_by_name().count(word) == 0) {
      std::vector<std::string> all;
      for (const Method method : all_methods()) all.emplace_back(name_of(method));
      return expected(one_of_text(all), word);
    }
  return "";
}

std::vector<Method> methods_between_commas(const std::string& list) {
  std::vector<Method> methods;
  for (const std::string& word : words_between_commas(list)) methods.push_back(methods_by_name().at(word));
  return methods;
}

void check_yardsticks(const std::vector<Method>& methods, Kernel kernel, bool is_split_optimal, bool is_certified) {
  for (const Method method : methods) {
    if (!is_yardstick(method)) continue;
    const std::string name = name_of(method);
    if (kernel != Kernel::DOUBLE) throw Usage_error("--kernel", "double with method " + name, name_of(kernel));
    if (is_split_optimal) throw Usage_error("--split", "midpoint with method " + name, "optimal");
    if (is_certified) throw Usage_error("--certified", "method bca, sfa or bilens", name);
  }
}

namespace {

// What is left to the check of the option is spelled as SVG does.
std::string with_one_spelling(std::string& rule) {
  if (rule == "even-odd") rule = "evenodd";
  return "";
}

}  // namespace

CLI::Option* add_rule(CLI::App& command, std::string& word) {
  return command
      .add_option("--rule", word,
                  "What closed curves enclose, as in SVG: where the winding number is not 0, or where it is odd;\n"
                  "even-odd is evenodd, too. Without it the file's own: evenodd for DXF, the fill-rule of SVG, else "
                  "nonzero")
      ->check(one_of({"nonzero", "evenodd"}))
      ->transform(CLI::Validator(with_one_spelling, "", "rule"));
}

CGAL::Bounding_arcs::Fill_rule fill_rule(const std::string& word, CGAL::Bounding_arcs::Fill_rule otherwise) {
  using CGAL::Bounding_arcs::Fill_rule;
  if (word.empty()) return otherwise;
  return word == "nonzero" ? Fill_rule::NONZERO : Fill_rule::EVEN_ODD;
}

const char* name_of(CGAL::Bounding_arcs::Fill_rule rule) {
  return rule == CGAL::Bounding_arcs::Fill_rule::NONZERO ? "nonzero" : "evenodd";
}

void add_plain(CLI::App& command, bool& is_plain) {
  command.add_flag("--plain", is_plain,
                   "Make SVG a drawing again: the result alone, in the coordinates and on the page of what was\n"
                   "read, arcs as arcs, with names as ids, layers and colours");
}

void check_plain(bool is_plain, const std::string& format) {
  if (is_plain && format != "svg") throw Usage_error("--format", "svg with --plain, which no other form has", format);
}

void add_dxf_entities(CLI::App& command, std::string& word) {
  command
      .add_option("--dxf-entities", word,
                  "What DXF has: polylines, one with bulges a chain, exact; or arcs, each piece an ARC or LINE")
      ->check(one_of({"polylines", "arcs"}))
      ->capture_default_str();
}

Dxf_entities dxf_entities(const std::string& word) {
  return word == "arcs" ? Dxf_entities::ARCS : Dxf_entities::POLYLINES;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace bounding_arcs_tool

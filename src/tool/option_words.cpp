// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "option_words.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>

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
  if (word.find(',') != std::string::npos) return "one tolerance is needed, not \"" + word + "\"";
  char* end = nullptr;
  const double eps = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !std::isfinite(eps) || eps <= 0)
    return "a positive number such as 1e-6 is needed, not \"" + word + "\"";
  return "";
}

std::string check_tolerances(const std::string& list) {
  for (const std::string& word : words_between_commas(list))
    if (std::string wrong = check_tolerance(word); !wrong.empty()) return wrong;
  return "";
}

CLI::Validator number_in(double least, double most) {
  char range[80];
  std::snprintf(range, sizeof range, "NUMBER in [%g - %g]", least, most);
  const auto check = [=](const std::string& word) -> std::string {
    char* end = nullptr;
    const double x = std::strtod(word.c_str(), &end);
    if (!word.empty() && *end == '\0' && x >= least && x <= most) return "";
    char wanted[80];
    std::snprintf(wanted, sizeof wanted, "a number from %g to %g is needed, not ", least, most);
    return wanted + ('"' + word + '"');
  };
  return CLI::Validator(check, range);
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
      std::string all;
      for (const Method method : all_methods()) all += (all.empty() ? "" : ", ") + std::string(name_of(method));
      return "\"" + word + "\" is none of " + all;
    }
  return "";
}

std::vector<Method> methods_between_commas(const std::string& list) {
  std::vector<Method> methods;
  for (const std::string& word : words_between_commas(list)) methods.push_back(methods_by_name().at(word));
  return methods;
}

std::string check_yardsticks(const std::vector<Method>& methods, Kernel kernel, bool is_split_optimal,
                             bool is_certified) {
  for (const Method method : methods) {
    if (!is_yardstick(method)) continue;
    const std::string name = name_of(method);
    if (kernel != Kernel::DOUBLE) return "--kernel: " + name + " is there for the double kernel only";
    if (is_split_optimal) return "--split: " + name + " has pieces halved at midpoints only";
    if (is_certified) return "--certified: only bca, sfa and bilens have certified regions, not " + name;
  }
  return "";
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
      ->check(CLI::IsMember({"nonzero", "evenodd"}))
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

void add_dxf_entities(CLI::App& command, std::string& word) {
  command
      .add_option("--dxf-entities", word,
                  "What DXF has: polylines, one with bulges a chain, exact; or arcs, each piece an ARC or LINE")
      ->check(CLI::IsMember({"polylines", "arcs"}))
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

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The steps of a formula, and the definitions of a Gappa script that they make: in lower case rounded, in capitals
// exact.

#ifndef BOUNDING_ARCS_TEST_RECORDING_H
#define BOUNDING_ARCS_TEST_RECORDING_H

#include <cctype>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

/// A step by its operation and by the names of what it is made of, which may be numbers; an input by its name.
struct Step {
  enum Kind { INPUT, NEGATION, ROOT, SUM, DIFFERENCE, PRODUCT, QUOTIENT };
  Kind kind;
  std::string first, second;
  bool is_exact;  ///< nothing is rounded: an exact input, a product with a power of two, or the quotient by one
};

/// The steps of a formula in the order in which they are taken. Equal steps are one.
class Recording {
 public:
  /// Adds a step unless it is there. \return its name
  std::string add(const Step& step) {
    const auto [place, is_new] =
        names_.emplace(std::tuple(step.kind, step.first, step.second), "s" + std::to_string(steps_.size()));
    if (is_new) {
      if (step.kind == Step::INPUT) place->second = step.first;
      steps_.emplace_back(place->second, step);
    }
    return place->second;
  }
  /// Gives a step the name that hints have for it.
  void call(const std::string& step, const std::string& name) { called_[step] = name; }

  /// Writes all that leads to results. Inputs of no error are exact.
  void write(std::ostream& out, const std::vector<std::string>& results) const {
    const std::set<std::string> needed = needed_for(results);
    std::set<std::string> exact;  // steps and inputs without error, which have one name only
    out << "@rnd = float<53, ne>;\n";
    for (const auto& [name, step] : steps_) {
      const auto is_exact = [&](const std::string& s) { return s.empty() || is_number(s) || exact.count(s) != 0; };
      if (step.is_exact && (step.kind == Step::INPUT || (is_exact(step.first) && is_exact(step.second))))
        exact.insert(name);
      if (step.kind == Step::INPUT || needed.count(name) == 0) continue;
      const auto rounded = [&](const std::string& s) { return shown(s); };
      const auto unrounded = [&](const std::string& s) { return is_exact(s) ? shown(s) : capitals(shown(s)); };
      out << shown(name) << (step.is_exact ? " = " : " rnd= ") << formula(step, rounded) << ";\n";
      if (!is_exact(name)) out << unrounded(name) << " = " << formula(step, unrounded) << ";\n";
    }
  }
  /// The inputs that are rounded. Numbers that lead to no result are there, too.
  [[nodiscard]] std::vector<std::string> rounded_inputs() const {
    std::vector<std::string> inputs;
    for (const auto& [name, step] : steps_)
      if (step.kind == Step::INPUT && !step.is_exact) inputs.push_back(name);
    return inputs;
  }
  /// The name of the exact number.
  [[nodiscard]] static std::string capitals(std::string name) {
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return name;
  }

 private:
  [[nodiscard]] static bool is_number(const std::string& operand) {
    return std::isalpha(static_cast<unsigned char>(operand[0])) == 0;
  }
  [[nodiscard]] std::string shown(const std::string& name) const {
    const auto found = called_.find(name);
    return found == called_.end() ? name : found->second;
  }
  template <class Named> [[nodiscard]] static std::string formula(const Step& step, const Named& named) {
    if (step.kind == Step::NEGATION) return "-" + named(step.first);
    if (step.kind == Step::ROOT) return "sqrt(" + named(step.first) + ")";
    const std::map<Step::Kind, std::string> signs{
        {Step::SUM, " + "}, {Step::DIFFERENCE, " - "}, {Step::PRODUCT, " * "}, {Step::QUOTIENT, " / "}};
    return named(step.first) + signs.at(step.kind) + named(step.second);
  }
  [[nodiscard]] std::set<std::string> needed_for(const std::vector<std::string>& results) const {
    std::set<std::string> needed(results.begin(), results.end());
    for (auto step = steps_.rbegin(); step != steps_.rend(); ++step)
      if (needed.count(step->first) != 0) needed.insert({step->second.first, step->second.second});
    return needed;
  }

  std::vector<std::pair<std::string, Step>> steps_;
  std::map<std::tuple<Step::Kind, std::string, std::string>, std::string> names_;
  std::map<std::string, std::string> called_;
};

}  // namespace bounding_arcs_test

#endif

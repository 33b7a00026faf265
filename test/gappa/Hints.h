// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hint files: what Gappa is asked beside the definitions of a formula. A file is the rest of a script, in which some
// words are replaced:
//   %             the number of an end, 0 or 1: the script is proven for both
//   &             the number of the other end
//   INPUTS        the errors of all inputs that are rounded
//   PROVEN(name)  the goals of another file, for both ends where it is about ends
//   3.5u          3.5 times 2^-53, as an integer times 2^-63 that is no larger

#ifndef BOUNDING_ARCS_TEST_HINTS_H
#define BOUNDING_ARCS_TEST_HINTS_H

#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace bounding_arcs_test {

inline std::string replaced(std::string text, const std::string& old, const std::string& by) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + by.size()))
    text.replace(at, old.size(), by);
  return text;
}

/// The hint files of a folder.
class Hints {
 public:
  explicit Hints(std::string folder) : folder_(std::move(folder)) {}

  /// The rest of a formula's script for one end.
  /// \throws std::runtime_error for a file that cannot be read or has no goal
  [[nodiscard]] std::string script(const std::string& name, const std::string& inputs, char end) const {
    std::string text = replaced(read(name), "&", end == '0' ? "1" : "0");
    text = replaced(replaced(text, "%", std::string(1, end)), "INPUTS", inputs);
    const std::string word = "PROVEN(";  // goals hold no such word
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at)) {
      const std::size_t close = text.find(')', at), first = at + word.size();
      text.replace(at, close + 1 - at, goals(text.substr(first, close - first)));
    }
    return with_units(text);
  }

 private:
  [[nodiscard]] static std::string with_units(std::string text) {
    std::smatch found;
    while (std::regex_search(text, found, std::regex(R"(\b([0-9.]+)u\b)")))
      text = found.prefix().str() + std::to_string(static_cast<long>(std::stod(found[1]) * 1024)) + "b-63" +
             found.suffix().str();
    return text;
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream file((folder_.empty() ? "." : folder_) + '/' + name + ".g");
    std::stringstream text;
    std::string line;
    while (std::getline(file, line)) text << line.substr(0, line.find('#')) << '\n';
    if (text.str().empty()) throw std::runtime_error(folder_ + '/' + name + ".g: no hints can be read");
    return text.str();
  }
  [[nodiscard]] std::string goals(const std::string& name) const {
    const std::string text = read(name);
    const std::size_t arrow = text.find("->"), end = text.find('}', arrow);
    if (end == std::string::npos) throw std::runtime_error(folder_ + '/' + name + ".g: no goal");
    const std::string goal = text.substr(arrow + 2, end - arrow - 2);
    if (goal.find('%') == std::string::npos) return goal;
    return replaced(goal, "%", "0") + " /\\ " + replaced(goal, "%", "1");
  }

  std::string folder_;
};

}  // namespace bounding_arcs_test

#endif

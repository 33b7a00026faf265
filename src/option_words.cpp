// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "option_words.h"

#include <cmath>
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

}  // namespace bounding_arcs_tool

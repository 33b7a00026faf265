// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The goals of all hint files, which Gappa proves.

#ifndef BOUNDING_ARCS_TEST_PROVEN_GOALS_H
#define BOUNDING_ARCS_TEST_PROVEN_GOALS_H

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>

namespace bounding_arcs_test {

/// Returns bounds of errors in parts of 2^-53 by the names of figures. What they are relative to is the figure's size.
inline std::map<std::string, double> proven_goals() {
  std::map<std::string, double> goals;
  const std::regex goal(R"(\|\(?(\w+)(%?) -/? (\w+)%?(\) / [^|]+)?\| <= ([0-9.]+)u)");
  for (const auto& file : std::filesystem::directory_iterator(BOUNDING_ARCS_HINT_FILES)) {
    if (file.path().extension() != ".g") continue;
    std::ifstream in(file.path());
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    for (std::sregex_iterator i(text.begin(), text.end(), goal), end; i != end; ++i) {
      std::string exact = (*i)[1];
      std::transform(exact.begin(), exact.end(), exact.begin(), [](unsigned char c) { return std::toupper(c); });
      if ((*i)[3] != exact) continue;  // beside another step of a proof
      for (const char* which : {"0", "1"})
        goals[(*i)[1].str() + ((*i)[2].length() != 0 ? which : "")] = std::stod((*i)[5]);
    }
  }
  return goals;
}

}  // namespace bounding_arcs_test

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Many seeded cases, of which a test tells how many are wrong, in what, and the first one of each kind. A long run
// tells the slowest one, too, with its checks, and the slowest operation alone. It goes on where another one ended:
// BOUNDING_ARCS_FIRST is the first seed.

#ifndef BOUNDING_ARCS_TEST_COUNTED_FAULTS_H
#define BOUNDING_ARCS_TEST_COUNTED_FAULTS_H

#include "cases.h"
#include "longest_call.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <map>
#include <random>
#include <string>

namespace bounding_arcs_test {

/// \param check throws what is wrong: a kind, a colon, and more
template <class Check> void expect_no_faults(int count, const Check& check) {
  struct Kind {
    int cases = 0;
    std::string first;
  };
  std::map<std::string, Kind> faults;
  int wrong = 0, slowest = 0;
  std::clock_t most = 0;
  const char* const text_of_first = std::getenv("BOUNDING_ARCS_FIRST");
  const int first_seed = text_of_first == nullptr ? 0 : std::atoi(text_of_first);
  for (int seed = first_seed; seed < first_seed + cases(count); ++seed) {
    const std::clock_t start = std::clock();
    try {
      std::mt19937 random(static_cast<unsigned>(seed));
      check(random);
    } catch (const std::exception& e) {
      ++wrong;
      const std::string text = e.what();
      Kind& kind = faults[text.substr(0, text.find(':'))];
      if (kind.cases++ == 0) kind.first = "seed " + std::to_string(seed) + ", " + text;
    }
    if (const std::clock_t taken = std::clock() - start; taken > most) {
      most = taken;
      slowest = seed;
    }
  }
  const int all = cases(count);
  if (std::getenv("BOUNDING_ARCS_CASES") != nullptr) {
    std::cout << wrong << " of " << all << " wrong";
    for (const auto& [kind, of] : faults) std::cout << ", " << of.cases << " " << kind;
    std::cout << "; seed " << slowest << " took " << static_cast<double>(most) / CLOCKS_PER_SEC << " s";
    if (longest_call() > 0) std::cout << ", no operation over " << longest_call() << " s";
    std::cout << '\n';
  }
  for (const auto& [kind, of] : faults)
    ADD_FAILURE() << of.cases << " of " << all << ", the first one of them: " << of.first;
}

}  // namespace bounding_arcs_test

#endif

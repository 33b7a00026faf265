// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the Gappa script of a formula: its steps as the library takes them, and a hint file.
// Usage: gappa_scripts HINT_FILE END     END is 0 or 1, where the file asks for an end

#include "Hints.h"
#include "arc_formulas.h"
#include "frame_formulas.h"

#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace bounding_arcs_test;

// A formula gives its results, and names their steps.
const std::map<std::string, std::function<Recorded_results(Recording&)>> FORMULAS{
    {"length", lengths},
    {"bulge", bulges},
    {"change", change},
    {"bca_thickness", bca_thickness},
    {"bca_circle", bca_circle},
    {"half_angles", half_angles},
    {"sin_delta", sin_delta},
    {"hypotenuse", bulges},
    {"bilens_cosine", [](Recording&) { return Recorded_results{}; }},
    {"bilens_errors", [](Recording&) { return Recorded_results{}; }},  // of numbers, whatever steps they are from
    {"bilens_parts", bilens_thickness},
    {"bilens_sensitivity", [](Recording&) { return Recorded_results{}; }},
    {"bilens_roundings", bilens_thickness},
    {"bilens_thickness", [](Recording&) { return Recorded_results{}; }},
    {"bilens_circle", bilens_circle},
    {"arc_curvature", arc_curvature},
    {"arc_distance", arc_distance},
    {"arc_products", arc_distance},
    {"arc_side", arc_distance},
    {"arc_sums", arc_distance},
    {"arc_moved", arc_distance},
    {"arc_below", arc_distance},
    {"cubic_sample", cubic_sample},
    {"tight_bends", tight_bends}};

void write_script(const std::filesystem::path& file, char end) {
  const auto formula = FORMULAS.find(file.stem().string());
  if (formula == FORMULAS.end()) throw std::runtime_error(file.string() + ": no formula has this name");
  Recording recording;
  std::vector<std::string> results;
  for (const Recorded& x : formula->second(recording)) results.push_back(x.name());
  recording.write(std::cout, results);
  std::string inputs;
  for (const std::string& x : recording.rounded_inputs())
    inputs += (inputs.empty() ? "|" : " /\\ |") + x + " -/ " + Recording::capitals(x) + "| <= " + INPUT_ERROR;
  std::cout << Hints(file.parent_path().string()).script(formula->first, inputs, end);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    if (count != 3) throw std::runtime_error("usage: gappa_scripts HINT_FILE END");
    write_script(arguments[1], *arguments[2]);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the Gappa script of a formula: its steps as the library takes them, and a hint file.
// Usage: gappa_scripts HINT_FILE END     END is 0 or 1, where the file asks for an end

#include "Hints.h"
#include "frame_formulas.h"

#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace bounding_arcs_test;

// What a member of a chord shape is off by, in parts of itself: half an ulp and what is_accurate() leaves beside it.
const char* const INPUT_ERROR = "1.015625u";

using Formula = std::function<Recorded_results(const Recorded_shape&)>;
const std::map<std::string, Formula> FRAME_FORMULAS{{"length", lengths}, {"bulge", bulges}};

void write_script(const std::filesystem::path& file, char end) {
  const std::string name = file.stem().string();
  Recording recording;
  const Recorded_shape shape = recorded_shape(recording);
  name_steps(recording, shape);
  std::vector<std::string> results;
  for (const Recorded& x : FRAME_FORMULAS.at(name)(shape)) results.push_back(x.name());
  recording.write(std::cout, results);
  std::string inputs;
  for (const std::string& x : recording.rounded_inputs())
    inputs += (inputs.empty() ? "|" : " /\\ |") + x + " -/ " + Recording::capitals(x) + "| <= " + INPUT_ERROR;
  std::cout << Hints(file.parent_path().string()).script(name, inputs, end);
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

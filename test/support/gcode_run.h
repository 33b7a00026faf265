// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// G-code as a controller runs it, with nothing of what wrote it: words by their letters, radii and turns by GRBL's
// rules.

#ifndef BOUNDING_ARCS_TEST_GCODE_RUN_H
#define BOUNDING_ARCS_TEST_GCODE_RUN_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace bounding_arcs_test {

/// A line or arc that was run. The center is that of an arc.
struct Gcode_step {
  int motion = 0;
  CGAL::Bounding_arcs::Xy<double> from{}, to{}, center{};
  double z0 = 0, z1 = 0, turn = 0;  // to the left above 0

  [[nodiscard]] bool is_arc() const { return motion > 1; }
  [[nodiscard]] double radius() const { return std::hypot(from.x - center.x, from.y - center.y); }
  [[nodiscard]] double length() const {
    return is_arc() ? radius() * std::fabs(turn) : std::hypot(to.x - from.x, to.y - from.y);
  }
  /// Where the tool is after a share of the step: radii of arcs go from the first to the last.
  [[nodiscard]] CGAL::Bounding_arcs::Xy<double> at(double share) const {
    if (!is_arc()) return from + share * (to - from);
    const double r = radius() + share * (std::hypot(to.x - center.x, to.y - center.y) - radius());
    const double angle = std::atan2(from.y - center.y, from.x - center.x) + share * turn;
    return {center.x + r * std::cos(angle), center.y + r * std::sin(angle)};
  }
};

/// What a program does: cuts from one way through the air to the next one.
struct Gcode_run {
  bool is_in_inches = false, has_ended = false;
  double feed = 0, top = -INFINITY;             // where the tool is in the air
  std::vector<std::vector<Gcode_step>> passes;  // of steps along the work
  std::vector<std::string> titles;              // the last comment before each
  std::string refused;                          // the first line that a controller would refuse
};

/// The turn of an arc as GRBL has it, in single precision: a whole turn more or less where that is too coarse.
inline double single_turn(const Gcode_step& step, double i, double j) {
  constexpr float NO_TURN = 5e-7F, TURN = 6.2831853F;
  const float r0 = -static_cast<float>(i), r1 = -static_cast<float>(j);
  const float center0 = static_cast<float>(step.from.x) - r0, center1 = static_cast<float>(step.from.y) - r1;
  const float rt0 = static_cast<float>(step.to.x) - center0, rt1 = static_cast<float>(step.to.y) - center1;
  float turn = std::atan2(r0 * rt1 - r1 * rt0, r0 * rt0 + r1 * rt1);
  if (step.motion == 2 && turn >= -NO_TURN) turn -= TURN;
  if (step.motion == 3 && turn <= NO_TURN) turn += TURN;
  return static_cast<double>(turn);
}

/// Runs a program.
inline Gcode_run run_gcode(const std::string& text) {
  constexpr double TURN = 6.283185307179586;
  Gcode_run run;
  double x = NAN, y = NAN, z = NAN;
  std::string comment;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const auto refuse = [&](bool wrong) {
      if (wrong && run.refused.empty()) run.refused = line;
    };
    std::map<char, double> words;
    std::vector<double> codes;
    for (std::size_t i = 0; i < line.size();) {
      if (line[i] == '(') {
        comment = line.substr(i + 1, line.find(')', i) - i - 1);
        i = line.find(')', i) + 1;
        refuse(i == 0);
      } else if (std::isupper(static_cast<unsigned char>(line[i])) != 0) {
        const std::size_t end = line.find_first_not_of("0123456789.-", i + 1);
        const double value = std::strtod(line.substr(i + 1, end - i - 1).c_str(), nullptr);
        if (line[i] == 'G' || line[i] == 'M') codes.push_back(line[i] == 'G' ? value : 1000 + value);
        else words[line[i]] = value;
        i = end == std::string::npos ? line.size() : end;
      } else {
        refuse(line[i++] != ' ');
      }
    }
    int motion = -1;
    for (const double code : codes) {
      if (code == 20) run.is_in_inches = true;
      if (code == 1002) run.has_ended = true;
      if (code >= 0 && code <= 3) motion = static_cast<int>(code);
    }
    if (words.count('F') != 0) run.feed = words['F'];
    if (motion < 0) continue;
    Gcode_step step;
    step.motion = motion;
    step.from = {x, y};
    step.z0 = z;
    for (const auto& [letter, target] : {std::pair{'X', &x}, {'Y', &y}, {'Z', &z}})
      if (words.count(letter) != 0) *target = words[letter];
    step.to = {x, y};
    step.z1 = z;
    if (motion == 0) {
      run.top = std::fmax(run.top, z);
      if (run.passes.empty() || !run.passes.back().empty()) {
        run.passes.emplace_back();
        run.titles.emplace_back();
      }
      continue;
    }
    refuse(run.passes.empty() || !(run.feed > 0) || std::isnan(x) || std::isnan(y) || std::isnan(z));
    if (run.passes.empty()) continue;
    if (step.is_arc()) {
      step.center = {step.from.x + words['I'], step.from.y + words['J']};
      const double mm = run.is_in_inches ? 25.4 : 1, last = std::hypot(x - step.center.x, y - step.center.y);
      const double apart = std::fabs(step.radius() - last) * mm;
      refuse(apart > 0.5 || (apart > 0.005 && apart > 0.001 * step.radius() * mm) || !(step.radius() > 0));
      const auto u = step.from - step.center, v = step.to - step.center;
      step.turn = std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
      constexpr double NO_TURN = 5e-7;
      if (motion == 3 && step.turn <= NO_TURN) step.turn += TURN;
      if (motion == 2 && step.turn >= -NO_TURN) step.turn -= TURN;
      refuse(std::fabs(step.turn - single_turn(step, words['I'], words['J'])) > 1);
    }
    run.titles.back() = comment;
    run.passes.back().push_back(step);
  }
  if (!run.passes.empty() && run.passes.back().empty()) {
    run.passes.pop_back();
    run.titles.pop_back();
  }
  return run;
}

}  // namespace bounding_arcs_test

#endif

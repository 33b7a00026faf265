// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inputs for which a figure whose error is proven errs much, and a climb to such inputs from any others.
// test/data/study/worst_roundings.txt keeps those that were found.

#ifndef BOUNDING_ARCS_TEST_ROUNDING_CASES_H
#define BOUNDING_ARCS_TEST_ROUNDING_CASES_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include "proven_figures.h"
#include "random_spirals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

/// A figure by its name in scripts, and numbers that it is made from:
///   of a chord frame   the chord, both tangents (x and y of each), both products of first and second derivative
///   of an arc          a point, both ends, the bulge
///   of a cubic         four coordinates, the parameter
struct Rounding_case {
  std::string figure;
  std::vector<long double> inputs;
};

inline long double longer(const Exact& x) {
  const CGAL::Bounding_arcs::Double_double d = CGAL::Bounding_arcs::to_double_double(x);
  return static_cast<long double>(d.hi) + d.lo;
}

/// The figures of a case in double, and with 11 bits more; none where their bounds are not proven for it.
inline std::optional<std::pair<Figures<double>, Figures<long double>>> figures(const Rounding_case& c) {
  using namespace CGAL::Bounding_arcs;
  using Long = Xy<long double>;
  const std::vector<long double>& x = c.inputs;
  const auto rounded = [](const Long& p) { return Xy<double>{static_cast<double>(p.x), static_cast<double>(p.y)}; };
  if (x.size() == 5) {
    if (!(x[4] >= 0 && x[4] <= 1)) return std::nullopt;
    Long exact[4];
    Xy<double> points[4];
    for (int i = 0; i < 4; ++i) {
      points[i] = {static_cast<double>(x[i]), 0};
      exact[i] = {points[i].x, 0};
      if (std::fabs(points[i].x) > 1) return std::nullopt;
    }
    const auto t = static_cast<double>(x[4]);
    return std::pair(cubic_figures(points, t), cubic_figures<long double>(exact, t));
  }
  if (x.size() == 7) {
    const Xy<double> p = rounded({x[0], x[1]}), from = rounded({x[2], x[3]}), to = rounded({x[4], x[5]});
    const auto bulge = static_cast<double>(x[6]);
    if (!(bulge > 0 && bulge <= 1) || view(p, from, to, bulge).nearest_end >= 0) return std::nullopt;
    const auto exact = [](const Xy<double>& q) { return Long{q.x, q.y}; };
    return std::pair(arc_figures(p, from, to, bulge),
                     arc_figures<long double>(exact(p), exact(from), exact(to), static_cast<long double>(bulge)));
  }
  const auto exact = [&](std::size_t i) -> Exact {
    const auto hi = static_cast<double>(x[i]);
    return Exact(hi) + Exact(static_cast<double>(x[i] - hi));
  };
  End_jet_2<Exact> jets[2] = {{{0, 0}, {exact(2), exact(3)}, {}}, {{exact(0), exact(1)}, {exact(4), exact(5)}, {}}};
  for (std::size_t i : {0, 1}) {
    const Xy<Exact>& first = jets[i].first;
    const Exact square = dot(first, first);
    if (square == 0) return std::nullopt;
    jets[i].second = Exact(exact(6 + i) / square) * Xy<Exact>{-first.y, first.x};
  }
  const Chord_shape_2<Exact> shape = chord_frame(jets[0], jets[1]).shape;
  if (!shape.proper || !shape.tight_first || !shape.turns_one_way || shape.turn < 0 || shape.curvature1 < 0 ||
      shape.sine_change <= 0)
    return std::nullopt;
  const auto f = shape.over<double>([](const Exact& y) { return static_cast<double>(longer(y)); });
  const auto g = shape.over<long double>([](const Exact& y) { return longer(y); });
  const auto angles = g.angles();
  const auto t = tight_frame(g);
  // right angles in all, as those of spirals; r_a r_b at most 1/4, as of short pieces
  if (!tight_frame(f).usable || !t.usable || angles.bulge0 * angles.bulge1 + angles.bulge0 + angles.bulge1 > 1 ||
      t.sin_delta / t.a * (t.sin_delta / t.b) > 0.25L)
    return std::nullopt;
  return std::pair(frame_figures(f), frame_figures(g));
}

/// The error of the figure in parts of 2^-53; none where its bound is not proven.
inline std::optional<double> rounding_error(const Rounding_case& c) {
  const auto both = figures(c);
  if (!both) return std::nullopt;
  const Figure<long double>& exact = both->second.at(c.figure);
  const long double error = both->first.at(c.figure).value - exact.value;
  return static_cast<double>(std::fabs(error / exact.size) / CGAL::Bounding_arcs::HALF_ULP);
}

/// Makes the error larger, if that is found in so many steps: inputs are moved by little or much, a frame is also
/// turned as a whole and stretched in one of its vectors, and at first a smaller error is taken, too.
inline void climb(Rounding_case& best, int steps, std::mt19937_64& random) {
  const auto number = [&](double from, double to) { return std::uniform_real_distribution<>(from, to)(random); };
  double most = rounding_error(best).value(), error = most;
  Rounding_case at = best;
  for (int step = 0; step < steps; ++step) {
    Rounding_case next = at;
    std::vector<long double>& x = next.inputs;
    const long double change = std::pow(10.0, -number(0.5, 17.5)) * number(-1, 1);
    const bool is_frame = x.size() == 8;
    const auto kind = is_frame ? random() % 6 : 6;
    if (kind == 0) {
      const long double cosine = std::cos(change), sine = std::sin(change);
      for (std::size_t i : {0, 2, 4}) {
        const long double along = x[i];
        x[i] = along * cosine - x[i + 1] * sine;
        x[i + 1] = along * sine + x[i + 1] * cosine;
      }
    } else if (kind == 1) {
      const std::size_t i = random() % 3;
      for (std::size_t k : {2 * i, 2 * i + 1}) x[k] *= 1 + change;
      if (i == 0)
        for (std::size_t k : {6, 7}) x[k] /= 1 + change;
      else x[5 + i] *= (1 + change) * (1 + change) * (1 + change);
    } else {
      for (auto count = 1 + random() % 3; count > 0; --count) x[random() % x.size()] *= 1 + change * number(-1, 1);
    }
    const std::optional<double> reached = rounding_error(next);
    if (!reached) continue;
    const double left = 1 - static_cast<double>(step) / steps;
    if (*reached > error * (1 - 0.15 * left * left * number(0, 1))) {
      at = next;
      error = *reached;
    }
    if (error > most) {
      best = at;
      most = error;
    }
  }
}

inline std::vector<Rounding_case> read_rounding_cases(const std::string& file) {
  std::ifstream in(file);
  std::vector<Rounding_case> cases;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream words(line.substr(0, line.find('#')));
    Rounding_case c;
    if (!(words >> c.figure)) continue;
    bool is_read = true;
    for (std::string word; words >> word;) {
      char* end = nullptr;
      c.inputs.push_back(std::strtold(word.c_str(), &end));
      is_read = is_read && *end == '\0';
    }
    if (!is_read || c.inputs.empty())
      throw std::runtime_error(file + ":" + std::to_string(number) + ": not a figure and its numbers");
    cases.push_back(c);
  }
  if (cases.empty()) throw std::runtime_error(file + ": there is no case");
  return cases;
}

}  // namespace bounding_arcs_test

#endif

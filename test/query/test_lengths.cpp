// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths, beside sums over fine parts in long double and exact ones of folded lines.

#include "cases.h"
#include "closed_drawings.h"
#include "measure_checks.h"

#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace test_lengths {
namespace {

using namespace bounding_arcs_test;
namespace ba = CGAL::Bounding_arcs;
using ba::Bounding_arc_tree_2;
using ba::Measure_bounds;
using Real = long double;

// |C'| by differences of homogeneous coordinates.
class Speed_of_piece {
 public:
  explicit Speed_of_piece(const Lattice_curve& c) {
    for (int i = 0; i <= c.degree(); ++i) {
      const auto& p = c.control_points()[static_cast<std::size_t>(i)];
      const Real w = c.weight(i);
      coefficients_.push_back({w * p.x, w * p.y, w});
    }
  }
  Real operator()(Real t) const {
    std::vector<std::array<Real, 3>> b = coefficients_;
    for (; b.size() > 2; b.pop_back()) halfway(b, t);
    const Real n = static_cast<Real>(coefficients_.size() - 1);
    std::array<Real, 3> p{}, d{};
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = (1 - t) * b[0][k] + t * b[1][k];
      d[k] = n * (b[1][k] - b[0][k]);
    }
    return std::hypot(d[0] * p[2] - p[0] * d[2], d[1] * p[2] - p[1] * d[2]) / (p[2] * p[2]);
  }
  /// Where it is less than about, and 1.
  [[nodiscard]] std::vector<Real> slow_parameters() const {
    constexpr int SAMPLES = 64;
    std::vector<Real> result;
    for (int k = 1; k < SAMPLES; ++k) {
      Real low = Real(k - 1) / SAMPLES, high = Real(k + 1) / SAMPLES;
      if ((*this)(Real(k) / SAMPLES) > (std::min)((*this)(low), (*this)(high))) continue;
      for (int step = 0; step < 120; ++step) {
        const Real a = low + (high - low) / 3, b = high - (high - low) / 3;
        ((*this)(a) < (*this)(b) ? high : low) = (*this)(a) < (*this)(b) ? b : a;
      }
      result.push_back(low);
    }
    result.push_back(1);
    return result;
  }

 private:
  static void halfway(std::vector<std::array<Real, 3>>& b, Real t) {
    for (std::size_t i = 0; i + 1 < b.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) b[i][k] = (1 - t) * b[i][k] + t * b[i + 1][k];
  }

  std::vector<std::array<Real, 3>> coefficients_;
};

// Simpson's rule in long double between parameters where curves are slowest, as in cusps, with what twice as many parts
// change for its error.
TEST(Measures, LengthIsThatOfFineParts) {
  std::mt19937 random(3);
  const Placing places[] = {{}, {1e-9, 0, 0}, {1e9, 0, 0}, {1, 1e8, -3e8}, {1.0 / 3, 0.1, 0.7}};
  int sharp = 0;
  const int count = cases(100);
  for (int i = 0; i < count; ++i) {
    const Placing& place = places[i % 5];
    const Bounding_arc_tree_2 index(random_lattice_drawing(random, 3, place));
    Real length = 0, error = 0;
    for (const auto& curve : index.drawing().curves())
      for (const auto& c : curve.beziers) {
        const Speed_of_piece speed(c);
        const auto simpson = [&](Real from, Real to, int parts) {
          Real sum = speed(from) + speed(to);
          for (int k = 1; k < parts; ++k) sum += (k % 2 == 0 ? 2 : 4) * speed(from + (to - from) * k / parts);
          return (to - from) * sum / (3 * parts);
        };
        Real fine = 0, rough = 0, from = 0;
        for (const Real to : speed.slow_parameters()) {
          fine += simpson(from, to, 512);
          rough += simpson(from, to, 256);
          from = to;
        }
        length += fine;
        error += std::fabs(fine - rough);
      }
    for (const double tolerance : {1e-3, 1e-6, 1e-12}) {
      const Measure_bounds b = ba::length(index, tolerance * place.scale);
      const Real far = std::fabs(place.y) * 0x1p-53L;
      expect_holds(b, length, 4 * error + 1e-16L * length + far / 64, "drawing " + std::to_string(i));
      EXPECT_LE(b.upper - b.lower, (tolerance + 1e-11) * place.scale + 1e4L * far);
    }
    sharp += error < 1e-9L * place.scale;
  }
  EXPECT_GT(sharp, count / 3);
}

// Lines that turn back where only rounded points are, so far away that roundings are much of their length.
TEST(Measures, LengthOfFoldedLinesFarAwayIsHeld) {
  std::mt19937 random(5);
  constexpr double FAR = 0x1p46, UNIT = 0x1p-4;  // eight times what coordinates resolve
  for (int i = 0; i < cases(2000); ++i) {
    const auto number = [&] { return static_cast<double>(random() % 400); };
    const double p[3] = {100 + number(), 100 + number(), number()};
    Lattice_points points;
    for (const double x : {0.0, p[0], p[1], p[2]}) points.push_back({FAR + UNIT * x, FAR});
    const auto at = [&](Real t) { return UNIT * t * (3 * (1 - t) * ((1 - t) * p[0] + t * p[1]) + t * t * Real(p[2])); };
    // x' = 3 (a + b t + c t^2)
    const Real a = p[0], b = 2 * (Real(p[1]) - 2 * p[0]), c = Real(p[2]) - 3 * p[1] + 3 * p[0];
    std::vector<Real> turns{0};
    if (c != 0 && b * b > 4 * a * c) {
      const Real q = -(b + std::copysign(std::sqrt(b * b - 4 * a * c), b)) / 2;
      for (const Real t : {q / c, a / q})
        if (t > 0 && t < 1) turns.push_back(t);
    } else if (c == 0 && b != 0 && -a / b > 0 && -a / b < 1) {
      turns.push_back(-a / b);
    }
    turns.push_back(1);
    std::sort(turns.begin(), turns.end());
    Real exact = 0;
    for (std::size_t k = 1; k < turns.size(); ++k) exact += std::fabs(at(turns[k]) - at(turns[k - 1]));
    ba::Drawing_2<double> line;
    line.add(Lattice_curve(points));
    expect_holds(ba::length(Bounding_arc_tree_2(line), 1e-3), exact, 1e-15L * exact, "line " + std::to_string(i));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace test_lengths

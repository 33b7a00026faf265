// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Breaks of an interval between which a measure is about as large as eps allows.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_EQUALIZE_BREAKS_H
#define BOUNDING_ARCS_LIBRARY_TREE_EQUALIZE_BREAKS_H

#include <CGAL/Bounding_arcs_2/tree/internal/Equalized_leaves.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

// The fewest pieces of an interval with a measure of each at most eps, for measures that fall with the cube of a
// piece's length (thickness of regions, distance from arcs): break points where the cumulative cube root of the measure
// takes equal steps.

namespace CGAL::Bounding_arcs {

/// The cube root of x, 0 <= x <= 2^700, within 1e-4 of itself, several times as fast as std::cbrt: a third of the
/// exponent and one step of Halley's method. For shares only; 0 gives a number near 0.
[[nodiscard]] inline double rough_cube_root(double x) {
  constexpr std::uint64_t BIAS = 0x2a9f7893782da1ceULL;  // two thirds of the bits of 1, less what evens the error out
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits = bits / 3 + BIAS;
  double r;
  std::memcpy(&r, &bits, sizeof r);
  const double cube = r * r * r;
  return r * (cube + 2 * x) / (2 * cube + x);
}

/// Moves the breaks to `count` pieces of equal share of the sum of `roots`, the cube roots of the measures of pieces.
/// Parameters are a monotone cubic function of the cumulative sum (Fritsch and Butland 1984).
inline void redistribute(Measured_breaks& result, std::size_t count) {
  const std::vector<double>&breaks = result.breaks, &roots = result.roots;
  const std::size_t n = roots.size();
  std::vector<double>&inverses = result.inverse_roots, &secants = result.secants, &slopes = result.slopes;
  inverses.resize(n);
  secants.resize(n);  // of the parameter over the sum
  slopes.resize(n + 1);
  for (std::size_t i = 0; i < n; ++i) inverses[i] = 1 / roots[i];
  for (std::size_t i = 0; i < n; ++i) secants[i] = (breaks[i + 1] - breaks[i]) * inverses[i];
  for (std::size_t i = 1; i < n; ++i) {  // the mean of both secants, weighed, of their inverses
    const double w0 = 2 * roots[i] + roots[i - 1], w1 = roots[i] + 2 * roots[i - 1], before = secants[i - 1],
                 after = secants[i];
    slopes[i] = before > 0 && after > 0 ? (w0 + w1) * before * after / (w0 * after + w1 * before) : 0;
  }
  const auto end_slope = [&](std::size_t outer, std::size_t inner) {
    const double all = roots[outer] + roots[inner];
    const double s = ((all + roots[outer]) * secants[outer] - roots[outer] * secants[inner]) / all;
    return std::clamp(s, 0.0, 3 * secants[outer]);
  };
  slopes.front() = n == 1 ? secants[0] : end_slope(0, 1);
  slopes.back() = n == 1 ? secants[0] : end_slope(n - 1, n - 2);
  double sum = 0;
  for (const double r : roots) sum += r;
  std::vector<double>& moved = result.other_breaks;
  moved.resize(count + 1);
  moved.front() = breaks.front();
  moved.back() = breaks.back();
  const double share = sum / static_cast<double>(count);
  double before = 0;  // the sum up to break i
  std::size_t i = 0;
  for (std::size_t j = 1; j < count; ++j) {
    const double target = share * static_cast<double>(j);
    while (i + 1 < n && before + roots[i] < target) {
      before += roots[i];
      ++i;
    }
    const double x = std::clamp((target - before) * inverses[i], 0.0, 1.0), y = 1 - x;
    moved[j] = breaks[i] * y * y * (1 + 2 * x) + breaks[i + 1] * x * x * (1 + 2 * y) +
               roots[i] * x * y * (slopes[i] * y - slopes[i + 1] * x);
  }
  result.breaks.swap(moved);
}

/// Places breaks in [result.breaks.front(), result.breaks.back()] so that no measure exceeds eps.
/// \param result on entry its breaks are a first guess, at least the two ends
/// \param evaluate void(const std::vector<double>& breaks, std::vector<double>& measures): sets measures, one a piece,
///   none negative; infinity where a piece is too long to be measured. The last call is for the breaks returned
/// \param limit the most pieces
/// \return whether every measure is at most eps: otherwise the limit or the spacing of doubles stands against it
/// \guarantee the measures are those of `evaluate`; that no fewer pieces would do is a heuristic: the count is within
///   one of the sum of (measure / eps)^(1/3) for near-equal measures, but for ROOM
/// \complexity two to three evaluations a piece of the result
template <class Evaluate>
bool equalize_breaks(Measured_breaks& result, double eps, std::size_t limit, const Evaluate& evaluate) {
  constexpr double ROOM = 1.004;    // share kept free for what measures differ after one correction; saves a correction
  constexpr double UNMEASURED = 4;  // pieces taken for one that could not be measured
  constexpr double MOST = 0x1p700;  // of eps: beyond, measures tell no shares, and powers of them are no doubles
  constexpr int ROUNDS = 8, TRIES = 3;  // in all, and for one count
  constexpr std::size_t GROWTH = 8;     // from one round to the next: more would place breaks from too few samples
  constexpr std::size_t MANY = 4096;    // pieces whose shares tell how many are needed to far less than FAR
  constexpr double FAR = 2;             // of the limit
  std::vector<double>&breaks = result.breaks, &measures = result.measures, &roots = result.roots;
  std::vector<double> best;
  std::size_t failed = 0;
  int tries = 0;
  result.is_limit_far = false;
  for (int round = 0;; ++round) {
    const std::size_t n = breaks.size() - 1;
    measures.resize(n);
    evaluate(breaks, measures);
    const bool within = *std::max_element(measures.begin(), measures.end()) <= eps;
    if (within && (n == 1 || n == failed + 1)) return true;
    if (n > limit) return within;
    roots.resize(n);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      roots[i] = std::isfinite(measures[i]) ? rough_cube_root((std::min)(measures[i] / eps, MOST)) : UNMEASURED;
      sum += roots[i];
    }
    if (!within && n >= MANY && sum > FAR * static_cast<double>(limit)) {
      result.is_limit_far = true;
      return false;
    }
    std::size_t count =
        static_cast<std::size_t>(std::clamp(std::ceil(sum * ROOM), 1.0, static_cast<double>(limit) + 1));
    if (within) {
      if (count >= n || round >= ROUNDS) return true;
      best = breaks;
    } else {
      tries = n == count ? tries + 1 : 0;
      if (tries >= TRIES) {
        failed = (std::max)(failed, n);
        tries = 0;
      }
      count = (std::max)(count, failed + 1);
    }
    if (round >= ROUNDS) break;
    if (!best.empty() && count >= best.size() - 1) break;
    const double least = 1e-3 * sum / static_cast<double>(n);  // keeps secants finite where the measure vanishes
    for (double& r : roots) r = (std::max)(r, least);
    redistribute(result, (std::min)(count, GROWTH * n));
  }
  if (!best.empty()) {
    breaks = best;
    measures.resize(breaks.size() - 1);
    evaluate(breaks, measures);
    return true;
  }
  // Where cube roots are no guide, halving is.
  for (;;) {
    std::vector<double> halved;
    bool is_stuck = false, within = true;
    for (std::size_t i = 0; i < measures.size(); ++i) {
      halved.push_back(breaks[i]);
      if (measures[i] <= eps) continue;
      within = false;
      const double middle = breaks[i] + (breaks[i + 1] - breaks[i]) / 2;
      if (breaks[i] < middle && middle < breaks[i + 1]) halved.push_back(middle);
      else is_stuck = true;
    }
    if (within || is_stuck || halved.size() > limit) return within;
    halved.push_back(breaks.back());
    breaks.swap(halved);
    measures.resize(breaks.size() - 1);
    evaluate(breaks, measures);
  }
}

}  // namespace CGAL::Bounding_arcs

#endif

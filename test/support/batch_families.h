// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Families of pieces of curves that are hard on bounds made ahead for all pieces of a segment.

#ifndef BOUNDING_ARCS_TEST_BATCH_FAMILIES_H
#define BOUNDING_ARCS_TEST_BATCH_FAMILIES_H

#include "random_spirals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace bounding_arcs_test {

enum class Family { PLAIN, NEAR_LINEAR, NEAR_CIRCULAR, NEAR_VERTEX, TINY, HUGE_UNITS, LARGEST, FAR_OFF, RATIONAL };
inline constexpr Family ALL_FAMILIES[] = {Family::PLAIN,       Family::NEAR_LINEAR, Family::NEAR_CIRCULAR,
                                          Family::NEAR_VERTEX, Family::TINY,        Family::HUGE_UNITS,
                                          Family::LARGEST,     Family::FAR_OFF,     Family::RATIONAL};
inline std::string name(Family family) {
  constexpr const char* NAMES[] = {"plain", "near-linear", "near-circular", "near-vertex", "tiny",
                                   "huge",  "largest",     "far off",       "rational"};
  return NAMES[static_cast<int>(family)];
}

/// Kinds of local curves that families have (spiral/Curve_kind.h).
inline std::vector<int> kinds(Family family) {
  using CGAL::Bounding_arcs::RATIONAL;
  if (family == Family::NEAR_CIRCULAR) return {3};
  if (family == Family::RATIONAL) return {RATIONAL + 2, RATIONAL + 3, RATIONAL + 5};
  return {3, 4, 5, 7, 9};
}

/// Curve i of a family: all degrees from 2 to 9 in turn; near-circular ones are cubic, rational ones of
/// degree 2 to 5.
inline Bezier family_curve(std::mt19937& random, Family family, int i) {
  std::uniform_real_distribution<double> unit(-1, 1);
  if (family == Family::NEAR_CIRCULAR) {  // Hermite's cubic on an arc of a circle, disturbed
    const double angle = std::exp2(-3 + 2 * unit(random)), handle = std::tan(angle / 4) * 4 / 3,
                 size = std::exp2(-20 + 16 * unit(random));
    const double c = std::cos(angle), s = std::sin(angle);
    std::vector<Point> points{{1, 0}, {1, handle}, {c + handle * s, s - handle * c}, {c, s}};
    for (Point& p : points) p = {p.x + size * unit(random), p.y + size * unit(random)};
    return Bezier(std::move(points));
  }
  if (family == Family::RATIONAL) {
    const Bezier curve = random_curve(random, 2 + i % 4, false);
    std::vector<double> weights;
    for (std::size_t k = 0; k < curve.control_points().size(); ++k) weights.push_back(std::exp2(unit(random)));
    return Bezier(curve.control_points(), weights);
  }
  const Bezier plain = random_curve(random, 2 + i % 8, false);
  std::vector<Point> points = plain.control_points();
  const double flatness = std::exp2(-50 + 49 * unit(random));
  const double largest = std::exp2(985 + 14 * unit(random));  // up to the largest that is served
  for (Point& p : points) {
    if (family == Family::NEAR_LINEAR) p.y *= flatness;
    if (family == Family::TINY) p = {p.x * 0x1p-400, p.y * 0x1p-400};
    if (family == Family::HUGE_UNITS) p = {p.x * 0x1p400, p.y * 0x1p400};
    if (family == Family::LARGEST) p = {p.x * largest, p.y * largest};
    if (family == Family::FAR_OFF) p = {p.x + 0x1p20, p.y - 0x1p20};
  }
  return Bezier(std::move(points));
}

/// Pieces of the family's curves with a batch form, down to 2^-40 of a segment; near-vertex ones lie at an end of one.
inline std::vector<Piece> batch_pieces(Family family, unsigned seed, std::size_t count = 300) {
  constexpr int MAX_DEPTH = 40, PIECES_PER_SEGMENT = 4, PIECES_PER_CURVE = 20;
  std::mt19937 random(seed);
  std::vector<Piece> pieces;
  for (int i = 0; pieces.size() < count; ++i) {
    const std::size_t most = std::min(count, pieces.size() + PIECES_PER_CURVE);
    for (const Spiral& spiral : CGAL::Bounding_arcs::spiral_segments(family_curve(random, family, i))) {
      if (spiral.local_curve().kind() == 0) continue;
      for (int k = 0; k < PIECES_PER_SEGMENT && pieces.size() < most; ++k) {
        const int depth = static_cast<int>(random() % (random() % 2 == 0 ? 10u : MAX_DEPTH + 1u));
        if (family != Family::NEAR_VERTEX) {
          pieces.push_back(random_piece(random, spiral, depth));
        } else if (const double length = std::ldexp(spiral.last() - spiral.first(), -depth); random() % 2 == 0) {
          pieces.push_back({spiral, spiral.first(), spiral.first() + length});
        } else {
          pieces.push_back({spiral, spiral.last() - length, spiral.last()});
        }
      }
    }
  }
  return pieces;
}

}  // namespace bounding_arcs_test

#endif

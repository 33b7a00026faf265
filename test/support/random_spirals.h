// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random Bezier curves, their spiral segments, and pieces of those as a tree would make them.

#ifndef BOUNDING_ARCS_TEST_RANDOM_SPIRALS_H
#define BOUNDING_ARCS_TEST_RANDOM_SPIRALS_H

#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/study/stability_families.h>

#include <CGAL/Exact_rational.h>

#include <ostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace bounding_arcs_test {

using Exact = CGAL::Exact_rational;
using Bezier = CGAL::Bounding_arcs::Bezier_curve_2<double>;
using Spiral = CGAL::Bounding_arcs::Bezier_spiral_2<double>;
using Point = CGAL::Bounding_arcs::Xy<double>;

inline Bezier random_curve(std::mt19937& random, int degree, bool is_rational) {
  return CGAL::Bounding_arcs::random_bezier_curve(random, degree, is_rational);
}
inline Bezier random_curve(std::mt19937& random) { return CGAL::Bounding_arcs::random_bezier_curve(random); }

/// A piece of a spiral segment.
struct Piece {
  Spiral spiral;
  double t0, t1;
};

inline std::ostream& operator<<(std::ostream& out, const Piece& piece) {
  out.precision(17);
  for (const Point& p : piece.spiral.curve().control_points()) out << '(' << p.x << ", " << p.y << ") ";
  for (const double w : piece.spiral.curve().weights()) out << "w " << w << ' ';
  return out << "on [" << piece.t0 << ", " << piece.t1 << ']';
}
inline std::string text(const Piece& piece) {
  std::ostringstream out;
  out << piece;
  return out.str();
}

/// Halves a spiral segment `depth` times, each time keeping one half.
inline Piece random_piece(std::mt19937& random, const Spiral& spiral, int depth) {
  double t0 = spiral.first(), t1 = spiral.last();
  for (; depth > 0; --depth) {
    const double middle = t0 + (t1 - t0) / 2;
    if (!(t0 < middle && middle < t1)) break;
    (random() % 2 == 0 ? t0 : t1) = middle;
  }
  return {spiral, t0, t1};
}

/// Pieces of random curves, halved up to `max_depth` times.
inline std::vector<Piece> random_pieces(unsigned seed, std::size_t count, int max_depth) {
  std::mt19937 random(seed);
  std::vector<Piece> pieces;
  while (pieces.size() < count)
    for (const Spiral& spiral : CGAL::Bounding_arcs::spiral_segments(random_curve(random)))
      for (int k = 0; k < 4 && pieces.size() < count; ++k)
        pieces.push_back(random_piece(random, spiral, static_cast<int>(random() % (max_depth + 1u))));
  return pieces;
}

}  // namespace bounding_arcs_test

#endif

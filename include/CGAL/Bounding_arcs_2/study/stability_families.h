// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Families of spirals on which constructions of bounding regions lose digits: nearly straight, nearly circular, short,
// random.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_STABILITY_FAMILIES_H
#define CGAL_BOUNDING_ARCS_2_STUDY_STABILITY_FAMILIES_H

#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A piece of a spiral segment as a member of a family, whose parameter is delta.
struct Study_piece {
  std::string family;
  double delta;
  Bezier_spiral_2<double> spiral;
  double t0, t1;
  std::size_t number = 0;  ///< its place in the family, from 0
};

/// A Bezier curve with control points in the square [-1, 1]^2, and for rational ones weights between 1/4 and 4.
[[nodiscard]] inline Bezier_curve_2<double> random_bezier_curve(std::mt19937& random, int degree, bool is_rational) {
  std::uniform_real_distribution<double> coordinate(-1, 1), exponent(-2, 2);
  std::vector<Xy<double>> points;
  std::vector<double> weights;
  for (int i = 0; i <= degree; ++i) {
    const double x = coordinate(random);
    points.push_back({x, coordinate(random)});
    if (is_rational) weights.push_back(std::exp2(exponent(random)));
  }
  return Bezier_curve_2<double>(std::move(points), std::move(weights));
}

/// A curve of degree 2 to 9, every other one rational.
[[nodiscard]] inline Bezier_curve_2<double> random_bezier_curve(std::mt19937& random) {
  const int degree = 2 + static_cast<int>(random() % 8);
  return random_bezier_curve(random, degree, random() % 2 == 0);
}

namespace study {

/// p -> size (cosine + i sine) p + move, as if points were complex numbers.
struct Placement {
  Xy<double> turn, move;
  bool reversed;
};

// As it is, reversed, turned, moved, and all of these.  Moving and turning round the control points, which are then
// exact again: the curve is a neighbour in the family, or at tiny delta a line.  None of the numbers is exact in
// binary, for else some differences would come out without rounding.
inline const Placement PLACEMENTS[] = {{{1, 0}, {0, 0}, false},
                                       {{1, 0}, {0, 0}, true},
                                       {{0.96, 0.28}, {0, 0}, false},
                                       {{1, 0}, {0.3, 0.7}, false},
                                       {{0.96, 0.28}, {0.3, 0.7}, true}};

[[nodiscard]] inline Bezier_curve_2<double> placed(const Bezier_curve_2<double>& curve, const Placement& place) {
  std::vector<Xy<double>> points;
  for (const Xy<double>& p : curve.control_points())
    points.push_back(p.x * place.turn + p.y * perp(place.turn) + place.move);
  std::vector<double> weights = curve.weights();
  if (place.reversed) {
    std::reverse(points.begin(), points.end());
    std::reverse(weights.begin(), weights.end());
  }
  return Bezier_curve_2<double>(std::move(points), std::move(weights));
}

// The longest spiral of a curve in each placement; others may be slivers beside a vertex, which are no matter of delta.
inline void add_placed(std::vector<Study_piece>& pieces, const char* family, double delta,
                       const Bezier_curve_2<double>& curve) {
  for (const Placement& place : PLACEMENTS) {
    const auto spirals = spiral_segments(placed(curve, place));
    const auto longest = std::max_element(spirals.begin(), spirals.end(), [](const auto& a, const auto& b) {
      return a.last() - a.first() < b.last() - b.first();
    });
    pieces.push_back({family, delta, *longest, longest->first(), longest->last()});
  }
}

[[nodiscard]] inline std::vector<Study_piece> numbered(std::vector<Study_piece> pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].number = i;
  return pieces;
}

// `share` of what follows a third, or another part, of the piece.
[[nodiscard]] inline Study_piece shortened(Study_piece piece, double share, double start = 1.0 / 3) {
  piece.t0 += (piece.t1 - piece.t0) * start;
  piece.t1 = (std::min)(piece.t1, piece.t0 + share * (piece.t1 - piece.t0));
  return piece;
}

}  // namespace study

/// The longest spiral of (t, delta t^2) and of (3t, delta (3t^2 + t^3)) on [0, 1] for delta = 1, 1e-1, ... 1e-30,
/// 1e-35, ... 1e-300, and of both reversed, turned and moved.
[[nodiscard]] inline std::vector<Study_piece> near_linear_family() {
  std::vector<Study_piece> pieces;
  for (int exponent = 0; exponent <= 300; exponent += exponent < 30 ? 1 : 5) {
    const double delta = std::pow(10.0, -exponent);
    study::add_placed(pieces, "near-linear", delta, Bezier_curve_2<double>({{0, 0}, {0.5, 0}, {1, delta}}));
    study::add_placed(pieces, "near-linear", delta,
                      Bezier_curve_2<double>({{0, 0}, {1, 0}, {2, delta}, {3, 4 * delta}}));
  }
  return study::numbered(std::move(pieces));
}

/// The longest spiral of the quarter of an ellipse with axes 1 and 1 + delta, and of the quarter of the unit circle
/// with its middle control point moved by delta, for delta = 1, 1/2, ... 2^-52, and of both reversed, turned and moved;
/// each whole, and the share delta of it (at least 2^-40) from six places on: in a tree pieces get shorter as they get
/// rounder.
[[nodiscard]] inline std::vector<Study_piece> near_circular_family() {
  std::vector<Study_piece> pieces;
  for (int bits = 0; bits <= 52; ++bits) {
    const double delta = std::ldexp(1.0, -bits), axis = 1 + delta;
    study::add_placed(pieces, "near-circular", delta,
                      Bezier_curve_2<double>({{1, 0}, {1, axis}, {0, axis}}, {1, 1, 2}));
    study::add_placed(pieces, "near-circular", delta, Bezier_curve_2<double>({{1, 0}, {axis, 1}, {0, 1}}, {1, 1, 2}));
  }
  const std::size_t whole = pieces.size();
  constexpr double LEAST_SHARE = 0x1p-40;  // leaves parameters of a piece apart
  // Textbook centers of bilens are right or wrong by luck: at several places, so that some is wrong for every delta.
  for (const double start : {1.0 / 3, 0.11, 0.23, 0.47, 0.58, 0.71})
    for (std::size_t i = 0; i < whole; ++i)
      pieces.push_back(study::shortened(pieces[i], (std::max)(pieces[i].delta, LEAST_SHARE), start));
  return study::numbered(std::move(pieces));
}

/// The longest spiral of a polynomial and of a rational cubic, and of both reversed, turned and moved, from a third of
/// its parameter interval on, halved up to forty times: delta is the share that is left.
[[nodiscard]] inline std::vector<Study_piece> subdivision_family() {
  const std::vector<Xy<double>> points{{0, 0}, {0.5, 0.1}, {1, 0.4}, {1.2, 0.9}};
  std::vector<Study_piece> whole, pieces;
  study::add_placed(whole, "subdivision", 1, Bezier_curve_2<double>(points));
  study::add_placed(whole, "subdivision", 1, Bezier_curve_2<double>(points, {1, 2, 1.5, 1}));
  for (int bits = 0; bits <= 40; ++bits)
    for (const Study_piece& p : whole) {
      pieces.push_back(study::shortened(p, std::ldexp(1.0, -bits)));
      pieces.back().delta = std::ldexp(1.0, -bits);
    }
  return study::numbered(std::move(pieces));
}

/// Pieces of random curves, one after the other: of log-uniform size 1e-12 to 1e12, moved by 1e-8 to 1e8 times their
/// size and shortened up to 2^20 times. Delta counts them from 0.
/// \code
/// Random_spirals spirals(7);
/// const Study_piece piece = spirals.next();
/// \endcode
class Random_spirals {
 public:
  explicit Random_spirals(unsigned seed) : random_(seed) {}

  [[nodiscard]] Study_piece next() {
    while (next_ == spirals_.size()) cut_another();
    const Bezier_spiral_2<double>& spiral = spirals_[next_++];
    const double length = std::ldexp(spiral.last() - spiral.first(), -static_cast<int>(random_() % 21));
    const std::size_t number = count_++;
    const double end = (std::min)(spiral.last(), spiral.first() + length);
    return {"random", static_cast<double>(number), spiral, spiral.first(), end, number};
  }

 private:
  void cut_another() {
    std::uniform_real_distribution<double> scale(-12, 12), size_of_move(-8, 8);
    const Bezier_curve_2<double> base = random_bezier_curve(random_);
    const double size = std::pow(10.0, scale(random_)), move = size * std::pow(10.0, size_of_move(random_));
    spirals_ = spiral_segments(study::placed(base, {{size, 0}, {move, -move}, false}));
    next_ = 0;
  }

  std::mt19937 random_;
  std::vector<Bezier_spiral_2<double>> spirals_;  // of one curve
  std::size_t next_ = 0, count_ = 0;
};

/// The first `count` of the Random_spirals with that seed.
[[nodiscard]] inline std::vector<Study_piece> random_family(std::size_t count, unsigned seed) {
  Random_spirals spirals(seed);
  std::vector<Study_piece> pieces;
  while (pieces.size() < count) pieces.push_back(spirals.next());
  return pieces;
}

}  // namespace CGAL::Bounding_arcs

#endif

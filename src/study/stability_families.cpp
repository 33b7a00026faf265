// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of study/stability_families.h.

#include <CGAL/Bounding_arcs_2/study/stability_families.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Bounding_arcs {
namespace {

// p -> size (cosine + i sine) p + move, as if points were complex numbers.
struct Placement {
  Xy<double> turn, move;
  bool reversed;
  const char* name;
};

// Moving and turning round the control points: the curve is a neighbour in the family, or at tiny delta a line.  None
// of the numbers is exact in binary, for else some differences would come out without rounding.
const Placement PLACEMENTS[] = {{{1, 0}, {0, 0}, false, "as given"},
                                {{1, 0}, {0, 0}, true, "reversed"},
                                {{0.96, 0.28}, {0, 0}, false, "turned"},
                                {{1, 0}, {0.3, 0.7}, false, "moved"},
                                {{0.96, 0.28}, {0.3, 0.7}, true, "turned, moved, reversed"}};

[[nodiscard]] Bezier_curve_2<double> placed(const Bezier_curve_2<double>& curve, const Placement& place) {
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

// Pieces whose places in the family have changed.
[[nodiscard]] std::vector<Study_piece> numbered(std::vector<Study_piece> pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].number = i;
  return pieces;
}

}  // namespace

// Other spirals of a curve may be slivers beside a vertex, which are no matter of delta.
void add_placed(std::vector<Study_piece>& pieces, const std::string& family, double delta,
                const Bezier_curve_2<double>& curve) {
  for (const Placement& place : PLACEMENTS) {
    const auto spirals = spiral_segments(placed(curve, place));
    const auto longest = std::max_element(spirals.begin(), spirals.end(), [](const auto& a, const auto& b) {
      return a.last() - a.first() < b.last() - b.first();
    });
    if (longest == spirals.end()) continue;
    pieces.push_back({family, delta, *longest, longest->first(), longest->last(), pieces.size(), place.name});
  }
}

Study_piece shortened(Study_piece piece, double share, double start) {
  piece.t0 += (piece.t1 - piece.t0) * start;
  piece.t1 = (std::min)(piece.t1, piece.t0 + share * (piece.t1 - piece.t0));
  return piece;
}

std::optional<Bezier_spiral_2<double>> spiral_holding(const Bezier_curve_2<double>& curve, double t0, double t1) {
  for (const Bezier_spiral_2<double>& spiral : spiral_segments(curve))
    if (spiral.first() <= t0 && t1 <= spiral.last()) return spiral;
  return std::nullopt;
}

std::vector<Study_piece> near_linear_family() {
  std::vector<Study_piece> pieces;
  for (int exponent = 0; exponent <= 300; exponent += exponent < 30 ? 1 : 5) {
    const double delta = std::pow(10.0, -exponent);
    add_placed(pieces, "near-linear", delta, Bezier_curve_2<double>({{0, 0}, {0.5, 0}, {1, delta}}));
    add_placed(pieces, "near-linear", delta, Bezier_curve_2<double>({{0, 0}, {1, 0}, {2, delta}, {3, 4 * delta}}));
  }
  return pieces;
}

std::vector<Study_piece> near_circular_family() {
  std::vector<Study_piece> pieces;
  for (int bits = 0; bits <= 52; ++bits) {
    const double delta = std::ldexp(1.0, -bits), axis = 1 + delta;
    add_placed(pieces, "near-circular", delta, Bezier_curve_2<double>({{1, 0}, {1, axis}, {0, axis}}, {1, 1, 2}));
    add_placed(pieces, "near-circular", delta, Bezier_curve_2<double>({{1, 0}, {axis, 1}, {0, 1}}, {1, 1, 2}));
  }
  const std::size_t whole = pieces.size();
  constexpr double LEAST_SHARE = 0x1p-40;  // leaves parameters of a piece apart
  // Textbook centers of bilens are right or wrong by luck: at several places, so that some is wrong for every delta.
  for (const double start : {1.0 / 3, 0.11, 0.23, 0.47, 0.58, 0.71})
    for (std::size_t i = 0; i < whole; ++i)
      pieces.push_back(shortened(pieces[i], (std::max)(pieces[i].delta, LEAST_SHARE), start));
  return numbered(std::move(pieces));
}

std::vector<Study_piece> subdivision_family() {
  const std::vector<Xy<double>> points{{0, 0}, {0.5, 0.1}, {1, 0.4}, {1.2, 0.9}};
  std::vector<Study_piece> whole, pieces;
  add_placed(whole, "subdivision", 1, Bezier_curve_2<double>(points));
  add_placed(whole, "subdivision", 1, Bezier_curve_2<double>(points, {1, 2, 1.5, 1}));
  for (int bits = 0; bits <= 40; ++bits)
    for (const Study_piece& p : whole) {
      pieces.push_back(shortened(p, std::ldexp(1.0, -bits)));
      pieces.back().delta = std::ldexp(1.0, -bits);
    }
  return numbered(std::move(pieces));
}

Bezier_curve_2<double> random_bezier_curve(std::mt19937& random, int degree, bool is_rational) {
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

Bezier_curve_2<double> random_bezier_curve(std::mt19937& random) {
  const int degree = 2 + static_cast<int>(random() % 8);
  return random_bezier_curve(random, degree, random() % 2 == 0);
}

Study_piece Random_spirals::next() {
  while (next_ == spirals_.size()) cut_another();
  const Bezier_spiral_2<double>& spiral = spirals_[next_++];
  const double length = std::ldexp(spiral.last() - spiral.first(), -static_cast<int>(random_() % 21));
  const std::size_t number = count_++;
  const double end = (std::min)(spiral.last(), spiral.first() + length);
  return {"random", static_cast<double>(number), spiral, spiral.first(), end, number, "random"};
}

void Random_spirals::cut_another() {
  std::uniform_real_distribution<double> scale(-12, 12), size_of_move(-8, 8);
  const Bezier_curve_2<double> base = random_bezier_curve(random_);
  const double size = std::pow(10.0, scale(random_)), move = size * std::pow(10.0, size_of_move(random_));
  spirals_ = spiral_segments(placed(base, {{size, 0}, {move, -move}, false, "random"}));
  next_ = 0;
}

std::vector<Study_piece> random_family(std::size_t count, unsigned seed) {
  Random_spirals spirals(seed);
  std::vector<Study_piece> pieces;
  while (pieces.size() < count) pieces.push_back(spirals.next());
  return pieces;
}

}  // namespace CGAL::Bounding_arcs

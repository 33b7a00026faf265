// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a curve piece gets beyond a chain of one or two oriented circles, by branch and bound on Bernstein
// coefficients.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_INTERNAL_FARTHEST_BEYOND_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_INTERNAL_FARTHEST_BEYOND_H

#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>
#include <CGAL/Bounding_arcs_2/verify/internal/Weighted_piece.h>
#include <CGAL/Bounding_arcs_2/verify/internal/sign_on_interval.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

/// A circle or line seen from the origin of a Weighted_piece.  With v = q - point, beyond it is where the excess
/// k |v|^2 - 2 n v is positive: outside for k > 0, inside for k < 0.
template <class NT> struct Seen_circle : Contact_circle_2<NT> {
  Bracket length;  ///< of the normal

  /// A double that is at least the distance from the circle of a point of at most this excess: with r = length / |k|
  /// that distance d solves 2 length d + k d^2 = excess.
  [[nodiscard]] double distance(double excess) const {
    if (excess <= 0) return 0;
    if (!(length.lower > 0)) return INFINITE;
    const double bend = range_of(this->curvature).lower * excess, square = length.lower * length.lower;
    const double root = bend < 0 ? square * ROUND_DOWN + bend * ROUND_UP : square + bend;
    return excess / (length.lower + std::sqrt((std::max)(root * ROUND_DOWN, 0.0))) * ROUND_UP;
  }
};

/// Products of a piece's coordinates: what excesses are linear combinations of.
template <class NT> struct Piece_squares {
  Bernstein_polynomial<NT> norm, x, y, weight;  ///< x^2 + y^2, x weight, y weight, weight^2

  explicit Piece_squares(const Weighted_piece<NT>& p)
      : norm(p.x * p.x + p.y * p.y), x(p.x * p.weight), y(p.y * p.weight), weight(p.weight * p.weight) {}

  /// The excess of the piece's points, times weight^2.
  [[nodiscard]] Bernstein_polynomial<NT> excess(const Seen_circle<NT>& c) const {
    const NT two(2);
    const NT constant = c.curvature * dot(c.point, c.point) + two * dot(c.normal, c.point);
    const Xy<NT> linear = NT(-two) * (c.curvature * c.point + c.normal);
    return c.curvature * norm + (linear.x * x + linear.y * y) + constant * weight;
  }
};

/// One chain's excesses over a parameter interval: of both pieces everywhere or, where there is a joint, of the first
/// where `past` <= 0 and of the second where `past` >= 0.
template <class NT> struct Chain_excess {
  using Polynomial = Bernstein_polynomial<NT>;
  std::vector<Polynomial> pieces;
  std::optional<Polynomial> past;
  Polynomial square;  ///< what the excesses are multiplied by

  [[nodiscard]] std::pair<Chain_excess, Chain_excess> halves() const {
    std::pair<Chain_excess, Chain_excess> r;
    const auto split = [](const Polynomial& p, Polynomial& left, Polynomial& right) {
      std::tie(left, right) = p.halves();
    };
    r.first.pieces.resize(pieces.size());
    r.second.pieces.resize(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) split(pieces[i], r.first.pieces[i], r.second.pieces[i]);
    if (past) split(*past, r.first.past.emplace(), r.second.past.emplace());
    split(square, r.first.square, r.second.square);
    return r;
  }
  [[nodiscard]] bool applies(std::size_t piece) const {
    return !past || prove_nonnegative(piece == 0 ? *past : NT(-1) * *past, 0) != Proof::PROVEN;
  }
};

/// Bounds the largest distance beyond a chain from above.
/// \guarantee operator() is at least that distance; at most 5 % above it or at most the goal unless LAST_DEPTH or
///   MOST_PARTS end the search, which they always do
template <class NT> class Farthest_beyond {
 public:
  Farthest_beyond(const std::vector<Seen_circle<NT>>& circles, double goal) : circles_(circles), goal_(goal) {}

  [[nodiscard]] double operator()(const Chain_excess<NT>& chain) {
    visit(chain, 0);
    return found_;
  }
  /// About the largest distance that a point was seen to have; no bound rests on it.
  [[nodiscard]] double known_distance() const { return lower_; }

 private:
  static constexpr int LAST_DEPTH = 50;    // beyond it parts are shorter than the rounding of parameters
  static constexpr int MOST_PARTS = 2000;  // some milliseconds; ordinary chains need less than ten
  static constexpr double CLOSE = 1.05;    // upper over lower bound at which a search ends

  void visit(const Chain_excess<NT>& chain, int depth) {
    const double here = most(chain);
    lower_ = (std::max)({lower_, at_end(chain, true), at_end(chain, false)});
    const bool is_last = depth == LAST_DEPTH || ++parts_ > MOST_PARTS;
    if (is_last || here <= (std::max)({goal_, CLOSE * lower_, found_})) {
      found_ = (std::max)(found_, here);
      return;
    }
    const auto halves = chain.halves();
    visit(halves.first, depth + 1);
    visit(halves.second, depth + 1);
  }

  // As the weight's coefficients are positive, a quotient of polynomials is at most the largest quotient of
  // coefficients.
  [[nodiscard]] double most(const Chain_excess<NT>& chain) const {
    double r = 0;
    for (std::size_t k = 0; k < chain.pieces.size(); ++k)
      if (chain.applies(k))
        for (std::size_t i = 0; i < chain.square.scaled_coefficients().size(); ++i)
          r = (std::max)(r, quotient(chain, k, i));
    return r;
  }
  [[nodiscard]] double quotient(const Chain_excess<NT>& chain, std::size_t piece, std::size_t i) const {
    const double excess = range_of(chain.pieces[piece].scaled_coefficients()[i]).upper;
    if (excess <= 0) return 0;
    const double square = range_of(chain.square.scaled_coefficients()[i]).lower;
    if (!(square > 0)) return INFINITE;
    return circles_[piece].distance(excess / square * ROUND_UP);
  }
  // About the distance at an end of the interval; it ends searches, and no bound rests on it.
  [[nodiscard]] double at_end(const Chain_excess<NT>& chain, bool first) const {
    const auto end = [&](const auto& p) {
      return range_of(first ? p.scaled_coefficients().front() : p.scaled_coefficients().back());
    };
    const Bracket past = chain.past ? end(*chain.past) : Bracket{0, 0};
    double r = 0;
    for (std::size_t k = 0; k < chain.pieces.size(); ++k)
      if (k == 0 ? past.upper <= 0 : past.lower >= 0)
        r = (std::max)(r, circles_[k].distance((std::max)(end(chain.pieces[k]).lower, 0.0) / end(chain.square).upper));
    return std::isfinite(r) ? r : 0;
  }

  const std::vector<Seen_circle<NT>>& circles_;
  double goal_, lower_ = 0, found_ = 0;
  int parts_ = 0;
};

}  // namespace CGAL::Bounding_arcs::verify

#endif

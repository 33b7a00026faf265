// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A region's boundary of floating numbers over another number type, seen from its start: what proofs about rounded
// regions compare curve pieces with.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_SEEN_BOUNDARY_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_SEEN_BOUNDARY_H

#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>
#include "Weighted_piece.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

// How far a curve piece gets beyond a chain of one or two oriented circles, by branch and bound on Bernstein
// coefficients.

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

/// One side of a region, as its circles are seen from the piece's start.
template <class NT> struct Seen_chain {
  std::vector<Seen_circle<NT>> circles;  ///< with normals to the inside of the region, of length about 1
  Xy<NT> joint;                          ///< where there are two
  int side = 1;                          ///< +1 where these are left normals

  /// The way of the piece's points from p along the i-th circle's tangent there, past the normal at p; times weight.
  /// \param allowance a length to be added to the way
  [[nodiscard]] Bernstein_polynomial<NT> past_normal(const Weighted_piece<NT>& piece, std::size_t i, const Xy<NT>& p,
                                                     double allowance = 0) const {
    const Xy<NT> n = circles[i].normal_at(p), along = NT(-side) * perp(n);
    return piece.linear(along, NT(NT(allowance * length_range(n).lower) - dot(along, p)));
  }
};

/// The circles of a boundary, taken as they stand: they need not pass through joints and ends, nor touch each other.
template <class NT> struct Seen_boundary {
  double unit;    ///< of lengths, a power of two
  Xy<NT> origin;  ///< the boundary's start in the plane
  Xy<NT> end;     ///< the boundary's end
  Seen_chain<NT> outer, inner;
  bool has_corner;  ///< the outer joint is a corner and not smooth
  bool is_disc;     ///< both chains are arcs of one circle, which they run along in opposite senses

  template <class FT>
  Seen_boundary(const Region_boundary_2<FT>& boundary, double length_unit)
      : unit(length_unit), origin(number_from<NT>(boundary.inner[0].from)),
        end(seen(boundary.inner[boundary.inner.size() - 1].to)),
        has_corner(boundary.form == Region_form::SPIRAL_FAT_ARC), is_disc(encloses_disc(boundary)) {
    const int turn = turn_of(boundary);
    outer = seen(boundary.outer, turn);
    inner = seen(boundary.inner, -turn);
  }

  /// Some circle has no normal: the region is a point.
  [[nodiscard]] bool is_point() const {
    for (const Seen_chain<NT>* chain : {&outer, &inner})
      for (const Seen_circle<NT>& c : chain->circles)
        if (!(c.length.lower > 0)) return true;
    return false;
  }

 private:
  template <class FT> [[nodiscard]] Xy<NT> seen(const Xy<FT>& p) const {
    return NT(1 / unit) * (number_from<NT>(p) - origin);
  }

  template <class FT> [[nodiscard]] Seen_chain<NT> seen(const Boundary_chain_2<FT>& chain, int side) const {
    Seen_chain<NT> r;
    r.side = side;
    for (const Boundary_piece_2<FT>& p : chain) {
      const auto size = static_cast<double>((std::max)(std::fabs(p.support.normal.x), std::fabs(p.support.normal.y)));
      const double factor = size > 0 ? std::ldexp(side, -std::clamp(std::ilogb(size), -1000, 1000)) : side;
      const Xy<NT> normal = NT(factor) * number_from<NT>(p.support.normal);
      const NT k = p.is_segment()
                       ? NT(0)
                       : NT(NT(unit * factor) * number_from<NT>(p.support.curvature));  // no tiny number on the way
      r.circles.push_back({{seen(p.support.point), normal, k}, length_range(normal)});
    }
    if (chain.size() == 2) r.joint = seen(chain[0].to);
    return r;
  }

  template <class FT> [[nodiscard]] static bool encloses_disc(const Region_boundary_2<FT>& boundary) {
    const Contact_circle_2<FT>&a = boundary.inner[0].support, &b = boundary.outer[0].support;
    return boundary.inner.size() == 1 && boundary.outer.size() == 1 && !a.is_line() && a.point == b.point &&
           a.normal == -b.normal && a.curvature == -b.curvature;
  }

  // +1 for a left turn: the sign of the largest curvature, which is the tight end's.
  template <class FT> [[nodiscard]] static int turn_of(const Region_boundary_2<FT>& boundary) {
    FT largest(0);
    for (const auto* chain : {&boundary.outer, &boundary.inner})
      for (const auto& p : *chain) {
        const FT k = p.support.curvature / stable_norm(p.support.normal);
        if (std::fabs(k) > std::fabs(largest)) largest = k;
      }
    return largest < 0 ? -1 : +1;
  }
};

}  // namespace CGAL::Bounding_arcs::verify

#endif

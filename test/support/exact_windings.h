// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact winding numbers of curves, and of the chains of an outline, whose ends are known to be in brackets only. The
// points may be as near as one likes. Whole numbers and subdivision: nothing is shared with what is tested.
//
//   a ray from q, to the right here:                          .--,
//   what is along it, in front of q: its ends tell        q--+---\--->
//   behind q, or on one side of the ray: nothing             |    '--
//   else it is halved

#ifndef BOUNDING_ARCS_TEST_EXACT_WINDINGS_H
#define BOUNDING_ARCS_TEST_EXACT_WINDINGS_H

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

#include <CGAL/mpz_class.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

using Whole = mpz_class;
using Wholes = std::vector<Whole>;

/// The least exponent from 0 for which x 2^exponent is whole.
inline int exponent_of(double x) {
  if (x == 0) return 0;
  int own = 0;
  auto digits = static_cast<long>(std::ldexp(std::frexp(x, &own), 53));
  own -= 53;
  for (; digits % 2 == 0; digits /= 2) ++own;
  return (std::max)(0, -own);
}
/// x 2^exponent, which is whole.
inline Whole times_power(double x, int exponent) {
  int own = 0;
  auto digits = static_cast<long>(std::ldexp(std::frexp(x, &own), 53));
  if (digits == 0) return 0;
  own += exponent - 53;
  for (; own < 0; ++own) digits /= 2;
  return Whole(Whole(digits) << static_cast<unsigned>(own));
}

/// A point X/W, Y/W of whole numbers, W above 0.
struct Projective_point {
  Whole x, y, w;
};

/// Bernstein coefficients, but for a factor above 0, before and after the parameter that divides in the ratio t : s.
inline std::pair<Wholes, Wholes> halves(Wholes b, const Whole& t, const Whole& s) {
  const std::size_t n = b.size() - 1;
  const Whole both(s + t);
  Wholes left(n + 1), right(n + 1), factor{1};
  while (factor.size() <= n) factor.emplace_back(factor.back() * both);
  for (std::size_t k = 0; k <= n; ++k) {
    left[k] = Whole(b.front() * factor[n - k]);
    right[n - k] = Whole(b[n - k] * factor[n - k]);
    for (std::size_t i = 0; i + k < n; ++i) {
      b[i] *= s;
      b[i] += t * b[i + 1];
    }
  }
  return {std::move(left), std::move(right)};
}

/// Bernstein coefficients that change their sign once: about where, in doubles. Nothing of others.
inline std::optional<double> only_root(const Wholes& b) {
  std::vector<double> values;
  std::vector<long> exponents;
  int changes = 0, last = 0;
  for (const Whole& v : b) {
    long exponent = 0;
    values.push_back(mpz_get_d_2exp(&exponent, v.get_mpz_t()));
    exponents.push_back(exponent);
    if (sgn(v) == 0) continue;
    if (last != 0 && sgn(v) != last) ++changes;
    last = sgn(v);
  }
  if (changes != 1) return std::nullopt;
  const long most = *std::max_element(exponents.begin(), exponents.end());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = std::ldexp(values[i], static_cast<int>((std::max)(exponents[i] - most, -2000L)));
  double low = 0, high = 1;
  for (int i = 0; i < 50; ++i) {
    const double t = 0.5 * (low + high);
    std::vector<double> row = values;
    for (std::size_t n = row.size() - 1; n > 0; --n)
      for (std::size_t k = 0; k < n; ++k) row[k] += t * (row[k + 1] - row[k]);
    (row[0] * last > 0 ? high : low) = t;
  }
  return low;
}

/// A part of a piece as it is seen from a point: along a ray, and across it to the left.
struct Seen_piece {
  Wholes along, across;

  [[nodiscard]] std::pair<Seen_piece, Seen_piece> split(const Whole& t, const Whole& s) const {
    auto a = halves(along, t, s), c = halves(across, t, s);
    return {{std::move(a.first), std::move(c.first)}, {std::move(a.second), std::move(c.second)}};
  }
  /// Over [t0, t1], 0 <= t0 < t1 <= 1.
  [[nodiscard]] Seen_piece part(double t0, double t1) const {
    const int exponent = (std::max)(exponent_of(t0), exponent_of(t1));
    const Whole one(Whole(1) << static_cast<unsigned>(exponent)), a = times_power(t0, exponent),
                                                                  b = times_power(t1, exponent);
    const Seen_piece from = t0 == 0 ? *this : split(a, Whole(one - a)).second;
    return t1 == 1 ? from : from.split(Whole(b - a), Whole(one - b)).first;
  }
  [[nodiscard]] bool is_behind() const { return are_all(CGAL::NEGATIVE, along); }
  [[nodiscard]] bool is_in_front() const { return are_all(CGAL::POSITIVE, along); }
  [[nodiscard]] bool is_on_one_side() const {
    return are_all(CGAL::NEGATIVE, across) || are_all(CGAL::POSITIVE, across);
  }
  /// How often it crosses the ray to the left, less to the right.
  /// \param depth how often it was halved, or as good as that
  /// \return nothing of a curve through the point
  [[nodiscard]] std::optional<int> crossings(int depth = 0) const {
    if (is_on_one_side() || is_behind()) return 0;
    if (is_in_front()) return static_cast<int>(sgn(across.front()) < 0) - static_cast<int>(sgn(across.back()) < 0);
    constexpr int DEEPEST = 1000;  // some times the digits after the point of what is tested
    if (depth >= DEEPEST || (are_all(CGAL::ZERO, along) && are_all(CGAL::ZERO, across))) return std::nullopt;
    const double t = cut();
    const int exponent = exponent_of(t);
    const auto [first, second] = split(times_power(t, exponent), times_power(1 - t, exponent));
    const auto halvings = [](double width) { return (std::max)(1, -std::ilogb(width)); };
    const auto of_first = first.crossings(depth + halvings(t));
    if (!of_first) return std::nullopt;
    const auto of_second = second.crossings(depth + halvings(1 - t));
    if (!of_second) return std::nullopt;
    return *of_first + *of_second;
  }
  /// Those of the part between two places in brackets.
  /// \return nothing where it matters where in its bracket a place is
  [[nodiscard]] std::optional<int> crossings(const CGAL::Bounding_arcs::Bracket& from,
                                             const CGAL::Bounding_arcs::Bracket& to) const {
    const auto is_beside = [this](double t0, double t1) {
      if (t0 == t1) return true;
      const Seen_piece p = part(t0, t1);
      return p.is_on_one_side() || p.is_behind();
    };
    if (is_on_one_side() || is_behind()) return 0;  // and so is every part
    if (to.lower <= from.upper) return is_beside(from.lower, to.upper) ? std::optional<int>(0) : std::nullopt;
    if (!is_beside(from.lower, from.upper) || !is_beside(to.lower, to.upper)) return std::nullopt;
    return part(from.upper, to.lower).crossings();
  }

 private:
  // Where to cut: in the middle, or where doubles tell where it passes the start of the ray, beside that place, and
  // then behind it, so that what is left is as narrow as they tell. Where that is makes no difference to the answer.
  [[nodiscard]] double cut() const {
    constexpr double NARROW = 0x1p-40, BESIDE = 0x1p-20, LEAST = 0x1p-44;
    const auto root = only_root(along);
    if (!root) return 0.5;
    const double t = *root < BESIDE       ? (std::max)(2 * *root, LEAST)
                     : 1 - *root < BESIDE ? 1 - (std::max)(2 * (1 - *root), LEAST)
                                          : *root - NARROW;
    return std::floor(t / LEAST) * LEAST;
  }
  [[nodiscard]] static bool are_all(CGAL::Sign sign, const Wholes& list) {
    return std::all_of(list.begin(), list.end(), [sign](const Whole& v) { return CGAL::sign(v) == sign; });
  }
};

/// A Bezier piece in whole numbers: control points times their weights, times a power of two.
struct Whole_piece {
  Wholes x, y, w;

  Whole_piece(const CGAL::Bounding_arcs::Bezier_curve_2<double>& b, int exponent) {
    int of_weights = 0;
    for (int i = 0; i <= b.degree(); ++i) of_weights = (std::max)(of_weights, exponent_of(b.weight(i)));
    for (int i = 0; i <= b.degree(); ++i) {
      const auto& p = b.control_points()[static_cast<std::size_t>(i)];
      const Whole weight = times_power(b.weight(i), of_weights);
      x.emplace_back(weight * times_power(p.x, exponent));
      y.emplace_back(weight * times_power(p.y, exponent));
      w.push_back(weight);
    }
  }

  [[nodiscard]] Seen_piece seen(const Projective_point& q, int dx, int dy) const {
    Seen_piece result;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Whole vx(x[i] * q.w - q.x * w[i]), vy(y[i] * q.w - q.y * w[i]);
      result.along.emplace_back(dx * vx + dy * vy);
      result.across.emplace_back(dx * vy - dy * vx);
    }
    return result;
  }
  /// The point at t, and the direction there, of which the larger coordinate is about 2^20; (0, 0) at a cusp.
  struct Place {
    Projective_point point;
    long dx, dy;
  };
  [[nodiscard]] Place at(double t) const {
    const int exponent = exponent_of(t);
    const Whole b = times_power(t, exponent), a(Whole(Whole(1) << static_cast<unsigned>(exponent)) - b);
    std::vector<Projective_point> p;
    for (std::size_t i = 0; i < x.size(); ++i) p.push_back({x[i], y[i], w[i]});
    const auto blended = [&](const Projective_point& q, const Projective_point& r) -> Projective_point {
      return {Whole(a * q.x + b * r.x), Whole(a * q.y + b * r.y), Whole(a * q.w + b * r.w)};
    };
    for (std::size_t n = p.size() - 1; n > 1; --n)
      for (std::size_t i = 0; i < n; ++i) p[i] = blended(p[i], p[i + 1]);
    const Whole x_way(p[1].x * p[0].w - p[0].x * p[1].w), y_way(p[1].y * p[0].w - p[0].y * p[1].w),
        size(CGAL::abs(x_way) + CGAL::abs(y_way));
    const auto share = [&](const Whole& way) {
      if (size == 0) return 0L;
      return std::lround(0x1p20 * mpq_class(mpq_class(way) / mpq_class(size)).get_d());
    };
    return {blended(p[0], p[1]), share(x_way), share(y_way)};
  }
};

/// The curves of some drawings.
class Whole_curves {
 public:
  using Drawing = CGAL::Bounding_arcs::Drawing_2<double>;

  explicit Whole_curves(const std::vector<const Drawing*>& drawings) {
    for (const Drawing* d : drawings)
      for (const auto& c : d->curves())
        for (const auto& b : c.beziers)
          for (const auto& p : b.control_points()) {
            exponent_ = (std::max)({exponent_, exponent_of(p.x), exponent_of(p.y)});
            size_ = (std::max)({size_, std::fabs(p.x), std::fabs(p.y)});
          }
    for (const Drawing* d : drawings) {
      first_curve_.push_back(first_piece_.size());
      first_of_drawing_.push_back(pieces_.size());
      for (const auto& c : d->curves()) {
        first_piece_.push_back(pieces_.size());
        for (const auto& b : c.beziers) pieces_.emplace_back(b, exponent_);
      }
    }
    first_of_drawing_.push_back(pieces_.size());
  }

  [[nodiscard]] std::size_t number_of(std::size_t drawing, std::size_t curve, std::size_t bezier) const {
    return first_piece_[first_curve_[drawing] + curve] + bezier;
  }
  [[nodiscard]] std::size_t size() const { return pieces_.size(); }

  /// A point beside a piece, to the left at an angle that is a quarter of a turn and some more, 2^-exponent of the
  /// largest coordinate away, half of that or twice; nothing at a cusp.
  [[nodiscard]] std::optional<Projective_point> beside(std::size_t piece, double t, bool is_left, int exponent,
                                                       std::mt19937& random) const {
    const Whole_piece::Place at = pieces_[piece].at(t);
    if (at.dx == 0 && at.dy == 0) return std::nullopt;
    const double sign = is_left ? 1 : -1, skew = std::uniform_real_distribution<double>(-0.5, 0.5)(random);
    const auto dx = std::lround(sign * (skew * static_cast<double>(at.dx) - static_cast<double>(at.dy))),
               dy = std::lround(sign * (skew * static_cast<double>(at.dy) + static_cast<double>(at.dx)));
    const Whole away(times_power(std::exp2(std::floor(std::log2(size_))), exponent_) * at.point.w);
    const auto scale = static_cast<unsigned>(exponent + 20);
    return Projective_point{Whole(Whole(at.point.x << scale) + dx * away),
                            Whole(Whole(at.point.y << scale) + dy * away), Whole(at.point.w << scale)};
  }
  [[nodiscard]] Projective_point point(std::size_t piece, double t) const { return pieces_[piece].at(t).point; }
  [[nodiscard]] Projective_point point(const CGAL::Bounding_arcs::Xy<double>& p) const {
    const int exponent = (std::max)({exponent_of(p.x), exponent_of(p.y), exponent_});
    return {times_power(p.x, exponent), times_power(p.y, exponent),
            Whole(Whole(1) << static_cast<unsigned>(exponent - exponent_))};
  }

  [[nodiscard]] CGAL::Bounding_arcs::Xy<double> rounded(const Projective_point& q) const {
    const Whole unit(q.w << static_cast<unsigned>(exponent_));
    const auto share = [&](const Whole& v) { return mpq_class(mpq_class(v) / mpq_class(unit)).get_d(); };
    return {share(q.x), share(q.y)};
  }

  /// All pieces as they are seen from a point, along some ray.
  [[nodiscard]] std::vector<Seen_piece> seen(const Projective_point& q, std::mt19937& random) const {
    std::uniform_int_distribution<int> coordinate(-9, 9);
    int dx = 0, dy = 0;
    while (dx == 0 && dy == 0) {
      dx = coordinate(random);
      dy = coordinate(random);
    }
    std::vector<Seen_piece> result;
    result.reserve(pieces_.size());
    for (const Whole_piece& p : pieces_) result.push_back(p.seen(q, dx, dy));
    return result;
  }
  /// \return nothing on a curve
  [[nodiscard]] std::optional<int> winding(std::size_t drawing, const std::vector<Seen_piece>& seen) const {
    int number = 0;
    for (std::size_t i = first_of_drawing_[drawing]; i < first_of_drawing_[drawing + 1]; ++i) {
      const auto crossings = seen[i].crossings();
      if (!crossings) return std::nullopt;
      number += *crossings;
    }
    return number;
  }

 private:
  int exponent_ = 0;  // coordinates times that power of two are whole
  double size_ = 0;
  std::vector<Whole_piece> pieces_;
  std::vector<std::size_t> first_curve_, first_piece_, first_of_drawing_;  // of drawings, of curves, of drawings
};

}  // namespace bounding_arcs_test

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawings that queries are tried on, and what naive scans in long double tell of them: at least the true distances,
// and nearly those, which is enough to refuse a lower bound that is too high; upper bounds are refused by the points
// that come with them.

#ifndef BOUNDING_ARCS_TEST_QUERY_DRAWINGS_H
#define BOUNDING_ARCS_TEST_QUERY_DRAWINGS_H

#include "../../src/library/tree/Segment_hierarchy.h"
#include "degenerate_curves.h"
#include "region_samples.h"

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

namespace ba = CGAL::Bounding_arcs;
using Drawing = ba::Drawing_2<double>;

/// A circle of four rational quadratics.
inline std::vector<Bezier> circle(const Point& center, double radius) {
  std::vector<Bezier> chain;
  const Point axes[5] = {{radius, 0}, {0, radius}, {-radius, 0}, {0, -radius}, {radius, 0}};
  for (int i = 0; i < 4; ++i)
    chain.push_back(Bezier({center + axes[i], center + (axes[i] + axes[i + 1]), center + axes[i + 1]}, {1, 1, 2}));
  // weights 1, 1, 2 and 2, 2, 4 and so on would do; those of each piece stand by themselves
  return chain;
}
inline Bezier segment(const Point& p, const Point& q) { return Bezier({p, q}); }
inline Drawing drawing_of(const std::vector<Bezier>& chain) {
  Drawing d;
  d.add(chain);
  return d;
}
inline Drawing drawing_of(const Bezier& curve) { return drawing_of(std::vector<Bezier>{curve}); }

/// A smooth closed curve of so many cubics about a point.
inline std::vector<Bezier> closed_curve(std::mt19937& random, const Point& center, std::size_t count) {
  std::uniform_real_distribution<double> radius(0.4, 1);
  std::vector<Point> knots;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count), r = radius(random);
    knots.push_back({center.x + r * std::cos(angle), center.y + r * std::sin(angle)});
  }
  std::vector<Bezier> chain;
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = [&](std::size_t k) { return knots[(i + k + count) % count]; };
    const Point p = at(0), q = at(1), before = at(count - 1), after = at(2);
    chain.push_back(Bezier({p, p + (1.0 / 6) * (q - before), q - (1.0 / 6) * (after - p), q}));
  }
  return chain;
}

/// Scaled, then moved; what is the same point stays that.
inline Drawing moved(const Drawing& drawing, double scale, const Point& by) {
  Drawing result;
  for (const auto& curve : drawing.curves()) {
    std::vector<Bezier> chain;
    for (const Bezier& piece : curve.beziers) {
      std::vector<Point> p;
      for (const Point& q : piece.control_points()) p.push_back(scale * q + by);
      chain.emplace_back(std::move(p), piece.weights());
    }
    result.add(std::move(chain));
  }
  return result;
}

/// One to three curves: random ones of several degrees, closed ones, points and those that formulas met their ends on.
inline Drawing random_drawing(std::mt19937& random) {
  Drawing drawing;
  std::uniform_real_distribution<double> unit(-1, 1);
  const std::size_t count = 1 + random() % 3;
  while (drawing.curves().size() < count) {
    const Point p{unit(random), unit(random)};
    switch (random() % 8) {
      case 0:
        drawing.add(closed_curve(random, p, 3 + random() % 5));
        break;
      case 1:
        drawing.add(circle(p, std::exp2(4 * unit(random) - 2)));
        break;
      case 2:
        drawing.add(Bezier({p, p, p}));
        break;
      case 3:
        drawing.add(segment(p, {unit(random), unit(random)}));
        break;
      case 4:  // a cusp, or nearly one
        drawing.add(
            Bezier({p, p + Point{1, 1}, p + Point{random() % 2 == 0 ? 0 : 1e-6 * unit(random), 1}, p + Point{1, 0}}));
        break;
      default:
        drawing.add(random_curve(random));
    }
  }
  return drawing;
}

/// The curves of a drawing in long double.
class Scanned_drawing {
 public:
  explicit Scanned_drawing(const Drawing& drawing) {
    for (const auto& curve : drawing.curves()) {
      first_.push_back(pieces_.size());
      for (const Bezier& piece : curve.beziers) {
        std::vector<Vector> p;
        std::vector<Real> w(piece.weights().begin(), piece.weights().end());
        for (const Point& q : piece.control_points()) p.push_back(widened(q));
        pieces_.emplace_back(std::move(p), std::move(w));
      }
    }
  }

  [[nodiscard]] std::size_t size() const { return pieces_.size(); }
  [[nodiscard]] Vector at(std::size_t piece, Real t) const { return pieces_[piece].point(t); }
  [[nodiscard]] Vector at(const ba::Curve_place& p) const { return at(first_[p.curve] + p.bezier, p.t); }
  /// At another parameter of the same piece.
  [[nodiscard]] Vector at_place(const ba::Curve_place& p, Real t) const { return at(first_[p.curve] + p.bezier, t); }

  [[nodiscard]] Real distance(const Vector& q) const {
    return least([&](const Vector& p) { return length(q - p); });
  }

  /// The least value of f on the curves: of samples, and of more about all those that are less than their neighbours
  /// and not too large.
  /// \param f of points that are as far from each other it differs by no more
  template <class F> [[nodiscard]] Real least(const F& f) const {
    struct Start {
      Real value, bound;
      std::size_t piece;
      Real t;
    };
    std::vector<Start> starts;
    std::array<Vector, SAMPLES + 1> p;
    std::array<Real, SAMPLES + 1> v;
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t k = 0; k <= SAMPLES; ++k) {
        p[k] = at(i, Real(k) / SAMPLES);
        v[k] = f(p[k]);
      }
      for (std::size_t k = 0; k <= SAMPLES; ++k) {
        const std::size_t before = k == 0 ? 0 : k - 1, next = (std::min)(k + 1, SAMPLES);
        const Real beside = 2 * (std::max)(length(p[k] - p[before]), length(p[next] - p[k]));
        const Real slack = beside / 64;  // where it hardly changes, a sample may be less than one beside the least
        if (v[before] < v[k] - slack || v[next] < v[k] - slack) continue;
        starts.push_back({v[k], v[k] - beside, i, Real(k) / SAMPLES});
      }
    }
    std::sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.value < b.value; });
    Real least = HUGE_VALL;
    for (const Start& s : starts)
      if (s.bound < least) least = (std::min)(least, refined(f, s.piece, s.t));
    return least;
  }

 private:
  static constexpr std::size_t SAMPLES = 160;
  template <class F> [[nodiscard]] Real refined(const F& f, std::size_t piece, Real middle) const {
    Real least = HUGE_VALL, half = Real(1) / SAMPLES;
    for (int round = 0; round < 36; ++round, half /= 2.5L) {
      Real best = middle;
      for (int i = -3; i <= 3; ++i) {
        const Real t = (std::min)((std::max)(middle + half * i / 3, Real(0)), Real(1)), value = f(at(piece, t));
        if (value < least) best = t;
        least = (std::min)(least, value);
      }
      middle = best;
    }
    return least;
  }

  std::vector<ba::Bezier_curve_2<Real>> pieces_;
  std::vector<std::size_t> first_;
};

/// The largest |coordinate|.
inline double size_of(const Drawing& drawing) {
  double size = 0;
  for (const auto& curve : drawing.curves())
    for (const Bezier& piece : curve.beziers)
      for (const Point& p : piece.control_points()) size = (std::max)({size, std::fabs(p.x), std::fabs(p.y)});
  return size;
}

/// The largest error of a segment.
inline double error_of(const ba::Bounding_arc_tree_2& curves) {
  const ba::Segment_hierarchy& index = curves.in_unit();
  double error = 0;
  for (std::uint32_t s = 0; s < index.number_of_segments(); ++s) error = (std::max)(error, index.error(s));
  return error;
}

/// All curves at parameters that divide each Bezier piece in so many parts.
inline std::vector<Point> sampled_points(const CGAL::Bounding_arcs::Bounding_arc_tree_2& index, int parts) {
  std::vector<Point> points;
  for (std::uint32_t b = 0; b < index.in_unit().number_of_beziers(); ++b)
    for (int i = 0; i <= parts; ++i)
      points.push_back(index.in_unit().evaluator(b)(static_cast<double>(i) / parts).point);
  return points;
}

}  // namespace bounding_arcs_test

#endif

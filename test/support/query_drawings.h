// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawings that queries are tried on, and what naive scans in long double tell of them: at least the true distances,
// and nearly those, which is enough to refuse a lower bound that is too high; upper bounds are refused by the points
// that come with them.

#ifndef BOUNDING_ARCS_TEST_QUERY_DRAWINGS_H
#define BOUNDING_ARCS_TEST_QUERY_DRAWINGS_H

#include "degenerate_curves.h"
#include "region_samples.h"

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

namespace ba = CGAL::Bounding_arcs;
using Drawing = ba::Drawing_2<double>;

/// A circle of four rational quadratics.
inline std::vector<Bezier> circle(const Point& centre, double radius) {
  std::vector<Bezier> chain;
  const Point axes[5] = {{radius, 0}, {0, radius}, {-radius, 0}, {0, -radius}, {radius, 0}};
  for (int i = 0; i < 4; ++i)
    chain.push_back(Bezier({centre + axes[i], centre + (axes[i] + axes[i + 1]), centre + axes[i + 1]}, {1, 1, 2}));
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
inline std::vector<Bezier> closed_curve(std::mt19937& random, const Point& centre, std::size_t count) {
  std::uniform_real_distribution<double> radius(0.4, 1);
  std::vector<Point> knots;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count), r = radius(random);
    knots.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
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

  /// From samples, and from nearer ones about the nearest of each piece that may matter.
  [[nodiscard]] Real distance(const Vector& q) const {
    constexpr int SAMPLES = 40;
    Real least = HUGE_VALL;
    std::vector<std::pair<Real, Real>> best;  // of each piece
    for (std::size_t i = 0; i < size(); ++i) {
      best.emplace_back(HUGE_VALL, 0);
      for (int k = 0; k <= SAMPLES; ++k) {
        const Real t = Real(k) / SAMPLES;
        best.back() = (std::min)(best.back(), {length(q - at(i, t)), t});
      }
    }
    std::vector<std::size_t> order(size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return best[i] < best[j]; });
    constexpr std::size_t REFINED = 3;
    for (std::size_t k = 0; k < (std::min)(REFINED, size()); ++k)
      least = (std::min)(least, refined(q, order[k], best[order[k]].second, Real(1) / SAMPLES));
    return least;
  }

 private:
  [[nodiscard]] Real refined(const Vector& q, std::size_t piece, Real middle, Real half) const {
    Real least = HUGE_VALL;
    for (int round = 0; round < 30; ++round, half /= 3) {
      Real best = middle;
      for (int i = -5; i <= 5; ++i) {
        const Real t = (std::min)((std::max)(middle + half * i / 5, Real(0)), Real(1)), d = length(q - at(piece, t));
        if (d < least) best = t;
        least = (std::min)(least, d);
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

}  // namespace bounding_arcs_test

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawings of closed curves with small integer coordinates, so that lattice points are in every special position to
// them, and such shapes as have a name.

#ifndef BOUNDING_ARCS_TEST_CLOSED_DRAWINGS_H
#define BOUNDING_ARCS_TEST_CLOSED_DRAWINGS_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

using Lattice_curve = CGAL::Bounding_arcs::Bezier_curve_2<double>;
using Lattice_points = std::vector<CGAL::Bounding_arcs::Xy<double>>;
using Lattice_drawing = CGAL::Bounding_arcs::Drawing_2<double>;

/// p, times a scale, moved.
struct Placing {
  double scale = 1, x = 0, y = 0;
  CGAL::Bounding_arcs::Xy<double> operator()(double px, double py) const { return {scale * px + x, scale * py + y}; }
};

/// A full circle about the origin as four rational quadratics, counterclockwise; the radius is 1.
/// Its weights are rounded, so it is a circle but for some ulp; of weights (1, 1, 2) it would be one.
inline std::vector<Lattice_curve> circle_of_quarters(const Placing& at = {}) {
  // quarter over weights (1, 1, 2): x = (1 - t^2) / (1 + t^2), y = 2 t / (1 + t^2), exactly on the circle
  std::vector<Lattice_curve> chain;
  const double corner[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (std::size_t i = 0; i < 4; ++i) {
    const double *a = corner[i], *b = corner[(i + 1) % 4];
    chain.emplace_back(Lattice_points{at(a[0], a[1]), at(a[0] + b[0], a[1] + b[1]), at(b[0], b[1])},
                       std::vector<double>{1, 1, 2});
  }
  return chain;
}

/// A closed chain of straight edges.
inline std::vector<Lattice_curve> polygon(const Lattice_points& corners) {
  std::vector<Lattice_curve> chain;
  for (std::size_t i = 0; i < corners.size(); ++i)
    chain.emplace_back(Lattice_points{corners[i], corners[(i + 1) % corners.size()]});
  return chain;
}

/// A closed chain of pieces of degree 1 to 3 in [-size, size]^2, some of them rational.
inline std::vector<Lattice_curve> random_lattice_chain(std::mt19937& random, int size, const Placing& at = {}) {
  std::uniform_int_distribution<int> coordinate(-size, size), pieces(1, 3), degree(1, 3), weight(1, 3);
  const auto point = [&] {
    const int x = coordinate(random), y = coordinate(random);
    return at(x, y);
  };
  const int count = pieces(random);
  const auto start = point();
  auto last = start;
  std::vector<Lattice_curve> chain;
  for (int i = 0; i < count; ++i) {
    const int n = count == 1 ? 3 : degree(random);
    Lattice_points points{last};
    for (int k = 1; k < n; ++k) points.push_back(point());
    points.push_back(i + 1 == count ? start : point());
    last = points.back();
    std::vector<double> weights;
    if (random() % 4 == 0)
      for (int k = 0; k <= n; ++k) weights.push_back(weight(random));
    chain.emplace_back(std::move(points), std::move(weights));
  }
  return chain;
}

inline Lattice_drawing random_lattice_drawing(std::mt19937& random, int size, const Placing& at = {}) {
  Lattice_drawing drawing;
  for (std::size_t i = 0, n = 1 + random() % 2; i < n; ++i) drawing.add(random_lattice_chain(random, size, at));
  return drawing;
}

/// A drawing of the pieces of another one: the same, cut in halves, half of one and something new, or its chord; from
/// another start, in either direction.
/// \param are_rational_cut whether rational pieces are cut, too, which rounds their control points
inline Lattice_drawing related_drawing(const Lattice_drawing& drawing, std::mt19937& random, int size,
                                       bool are_rational_cut) {
  enum Kind { SAME, HALVES, HALF, CHORD, MIXED };
  std::uniform_int_distribution<int> coordinate(-size, size);
  Lattice_drawing result;
  for (const auto& curve : drawing.curves()) {
    const auto kind = static_cast<Kind>(random() % 5);
    std::vector<Lattice_curve> chain;
    for (const Lattice_curve& b : curve.beziers) {
      const Kind own = kind == MIXED ? static_cast<Kind>(random() % 4) : kind;
      const Lattice_curve first = b.subcurve(0, 0.5), second = b.subcurve(0.5, 1);
      const auto &middle = first.control_points().back(), &end = b.control_points().back();
      const bool is_cut = (are_rational_cut || b.weights().empty()) && middle == second.control_points().front();
      if (own == CHORD) {
        chain.push_back(Lattice_curve({b.control_points().front(), end}));
      } else if (own == SAME || !is_cut) {
        chain.push_back(b);
      } else {
        chain.push_back(first);
        Lattice_points back{middle};
        for (std::size_t k = random() % 3; k > 0; --k) {
          const double x = coordinate(random), y = coordinate(random);
          back.push_back({x, y});
        }
        back.push_back(end);
        chain.push_back(own == HALVES ? second : Lattice_curve(back));
      }
    }
    if (random() % 2 == 0) {
      std::reverse(chain.begin(), chain.end());
      for (Lattice_curve& b : chain) b = b.reversed();
    }
    std::rotate(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(random() % chain.size()), chain.end());
    result.add(chain);
  }
  return result;
}

}  // namespace bounding_arcs_test

#endif

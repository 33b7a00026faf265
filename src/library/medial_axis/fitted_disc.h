// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The disc that touches many points at once, as far as one does.
//
// Where discs differ by rounding only, any three of their touches make another disc. Where touches are close to each
// other, the center errs by the rounding over the square of their angle.  All touches together tell the disc better:
// least squares of |center - point| - radius, by Gauss and Newton.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_FITTED_DISC_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_FITTED_DISC_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

struct Fitted_disc {
  Xy<double> center;
  double radius;
};

/// The length by which a disc misses the worst of some points.
[[nodiscard]] inline double most_gap(const Fitted_disc& disc, const std::vector<Xy<double>>& points) {
  double most = 0;
  for (const Xy<double>& p : points) most = (std::max)(most, std::fabs(euclidean_norm(disc.center - p) - disc.radius));
  return most;
}

/// \param good a disc that misses no point by more is kept as it is
/// \return the disc that was given where none is better
[[nodiscard]] inline Fitted_disc fitted(const Fitted_disc& disc, const std::vector<Xy<double>>& points, double good) {
  constexpr int MOST_STEPS = 4;
  Fitted_disc best = disc;
  double gap = most_gap(disc, points);
  const double count = static_cast<double>(points.size());
  for (int step = 0; step < MOST_STEPS && gap > good; ++step) {
    std::vector<Xy<double>> direction;
    std::vector<double> distance;
    Xy<double> mean{0, 0};
    double mean_distance = 0;
    for (const Xy<double>& p : points) {
      const Xy<double> way = best.center - p;
      distance.push_back(euclidean_norm(way));
      if (!(distance.back() > 0)) return best;
      direction.push_back((1 / distance.back()) * way);
      mean = mean + (1 / count) * direction.back();
      mean_distance += (distance.back() - best.radius) / count;
    }
    // without the radius, which is the mean distance: direction.change = -distance, both less their means
    double xx = 0, xy = 0, yy = 0;
    Xy<double> right{0, 0};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Xy<double> d = direction[i] - mean;
      const double f = distance[i] - best.radius - mean_distance;
      xx += d.x * d.x, xy += d.x * d.y, yy += d.y * d.y;
      right = right - f * d;
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0)) return best;
    const Xy<double> change{(right.x * yy - right.y * xy) / determinant, (right.y * xx - right.x * xy) / determinant};
    const Fitted_disc next{best.center + change, best.radius + mean_distance + dot(mean, change)};
    const double next_gap = most_gap(next, points);
    if (!(next_gap < gap)) return best;
    best = next, gap = next_gap;
  }
  return best;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of any kernel on their way into searches, which are in doubles, and back.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_KERNEL_POINTS_H
#define CGAL_BOUNDING_ARCS_2_QUERY_KERNEL_POINTS_H

#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/convert.h>
#include <CGAL/Bounding_arcs_2/number/points_of_kernel.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs {

// The kernel of points where no other is named. It takes a second to read, so that only what needs it includes it.

/// The kernel of points that are asked about or answered where no other is named.
using Default_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

namespace internal {
/// The kernel of a point or a vector.
template <class Point> using Kernel_of = typename CGAL::Kernel_traits<Point>::Kernel;
}  // namespace internal

/// A point that is asked about: of any kernel, rounded to doubles where it has other numbers.
/// \code
/// const bool is_inside = locate(closed, {1, 1}) == CGAL::ON_BOUNDED_SIDE;
/// const bool is_too = locate(closed, Epeck::Point_2(1, 1)) == CGAL::ON_BOUNDED_SIDE;
/// \endcode
struct Asked_point {
  Asked_point(double x, double y) : point{x, y} {}
  Asked_point(const Xy<double>& p) : point(p) {}  // NOLINT: a point of doubles is one
  explicit Asked_point(const Xy<Exact_rational>& p);
  /// Takes a point, or a vector, of a kernel.
  template <class Point, class = typename Point::R>
  Asked_point(const Point& p) : Asked_point(taken(p.x(), p.y())) {}  // NOLINT: a kernel's point is one

  /// The point as it is.
  [[nodiscard]] Xy<Exact_rational> exactly() const { return exact ? *exact : convert<Exact_rational>(point); }

  Xy<double> point;
  std::optional<Xy<Exact_rational>> exact;  ///< where that is another point
  double error = 0;                         ///< bounds the distance of both

 private:
  template <class FT> [[nodiscard]] static Asked_point taken(const FT& x, const FT& y) {
    if constexpr (std::is_floating_point_v<FT> &&
                  std::numeric_limits<FT>::digits <= std::numeric_limits<double>::digits) {
      return {static_cast<double>(x), static_cast<double>(y)};
    } else if constexpr (std::is_floating_point_v<FT>) {
      return Asked_point(Xy<Exact_rational>{Exact_number<FT>::make(x), Exact_number<FT>::make(y)});
    } else {
      const auto in_x = CGAL::to_interval(x), in_y = CGAL::to_interval(y);
      if (in_x.first == in_x.second && in_y.first == in_y.second) return {in_x.first, in_y.first};
      return Asked_point(Xy<Exact_rational>{convert<Exact_rational>(x), convert<Exact_rational>(y)});
    }
  }
};

inline Asked_point::Asked_point(const Xy<Exact_rational>& p) : point{CGAL::to_double(p.x), CGAL::to_double(p.y)} {
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) return;  // will be refused
  if (Exact_rational(point.x) == p.x && Exact_rational(point.y) == p.y) return;
  exact = p;
  // the interval that holds a number has its nearest double at an end or within
  const auto miss = [](const Exact_rational& x, double rounded) {
    return CGAL::to_interval(Exact_rational(CGAL::abs(Exact_rational(x - Exact_rational(rounded))))).second;
  };
  error = miss(p.x, point.x) + miss(p.y, point.y);
  error = std::nextafter(error, std::numeric_limits<double>::infinity());
}

namespace internal {
/// Returns points of a range as ones that are asked about.
template <class Points> [[nodiscard]] std::vector<Asked_point> asked(const Points& points) {
  return std::vector<Asked_point>(std::begin(points), std::end(points));
}

/// Returns a point, or a vector, of an answer as one of a kernel, or in plain doubles.
template <class Point, class Given> [[nodiscard]] Point answered(const Given& p) {
  if constexpr (std::is_same_v<Point, Given>) {
    return p;
  } else if constexpr (std::is_same_v<Given, Xy<double>>) {
    using FT = typename Kernel_of<Point>::FT;
    return Point(FT(p.x), FT(p.y));
  } else {
    return answered<Point>(Xy<double>{CGAL::to_double(p.x()), CGAL::to_double(p.y())});
  }
}
/// Returns several answers with other points.
template <class Answer, class Other> [[nodiscard]] std::vector<Answer> answered(const std::vector<Other>& answers) {
  return std::vector<Answer>(answers.begin(), answers.end());
}
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif

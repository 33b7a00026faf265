// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of a user's kernel on their way into searches, which are in doubles, and back.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_KERNEL_POINTS_H
#define CGAL_BOUNDING_ARCS_2_QUERY_KERNEL_POINTS_H

#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/convert.h>
#include <CGAL/Bounding_arcs_2/tree/tree_declaration.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A point that is asked about, rounded to doubles where it has other numbers.
struct Asked_point {
  Asked_point(double x, double y) : point{x, y} {}
  Asked_point(const Xy<double>& p) : point(p) {}  // NOLINT: a point of doubles is one
  explicit Asked_point(const Xy<Exact_rational>& p);

  Xy<double> point;
  std::optional<Xy<Exact_rational>> exact;  ///< where that is another point
  double error = 0;                         ///< bounds the distance of both
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

/// Returns a point of a kernel as one that is asked about.
template <class Kernel> [[nodiscard]] Asked_point asked_point(const typename Kernel::Point_2& p) {
  using FT = typename Kernel::FT;
  if constexpr (std::is_floating_point_v<FT>) return {static_cast<double>(p.x()), static_cast<double>(p.y())};
  else return Asked_point(Xy<Exact_rational>{convert<Exact_rational>(p.x()), convert<Exact_rational>(p.y())});
}
/// Returns points of a kernel as ones that are asked about.
template <class Kernel, class Points> [[nodiscard]] std::vector<Asked_point> asked_points(const Points& points) {
  std::vector<Asked_point> asked;
  for (const auto& p : points) asked.push_back(asked_point<Kernel>(p));
  return asked;
}

/// The point of a kernel.
template <class Kernel> [[nodiscard]] typename Kernel::Point_2 kernel_point(const Xy<double>& p) {
  return typename Kernel::Point_2(typename Kernel::FT(p.x), typename Kernel::FT(p.y));
}
/// Returns a vector of a kernel.
template <class Kernel> [[nodiscard]] typename Kernel::Vector_2 kernel_vector(const Xy<double>& v) {
  return typename Kernel::Vector_2(typename Kernel::FT(v.x), typename Kernel::FT(v.y));
}

/// An answer, or a list of them, over a kernel.
template <class Kernel, class Answer> [[nodiscard]] auto in_kernel(const Answer& answer) {
  return answer.template in_kernel<Kernel>();
}
/// Returns an answer over a kernel, if there is one.
template <class Kernel, class Answer> [[nodiscard]] auto in_kernel(const std::optional<Answer>& answer) {
  using Result = std::optional<decltype(answer->template in_kernel<Kernel>())>;
  return answer ? Result(answer->template in_kernel<Kernel>()) : Result();
}
/// Returns several answers over a kernel.
template <class Kernel, class Answer> [[nodiscard]] auto in_kernel(const std::vector<Answer>& answers) {
  std::vector<decltype(answers.front().template in_kernel<Kernel>())> results;
  results.reserve(answers.size());
  for (const Answer& a : answers) results.push_back(a.template in_kernel<Kernel>());
  return results;
}

}  // namespace CGAL::Bounding_arcs

#endif

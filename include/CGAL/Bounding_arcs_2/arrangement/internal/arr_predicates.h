// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decisions about points and curves of arrangements, compiled in the library: doubles with bounds first, exact numbers
// where these leave anything open.

#ifndef CGAL_BOUNDING_ARCS_2_ARRANGEMENT_INTERNAL_ARR_PREDICATES_H
#define CGAL_BOUNDING_ARCS_2_ARRANGEMENT_INTERNAL_ARR_PREDICATES_H

#include <CGAL/Bounding_arcs_2/arrangement/Arr_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <CGAL/enum.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// The common points of pairs of curves, each pair's made once.
class Meetings_of_pairs {
 public:
  /// Returns what two curves have in common; the curve that was made first is the first one.
  [[nodiscard]] const Arranged_meetings& of(const Arranged_curve_handle& a, const Arranged_curve_handle& b);

 private:
  struct Hash {
    std::size_t operator()(const std::pair<std::uint64_t, std::uint64_t>& k) const {
      return static_cast<std::size_t>(k.first * 0x9e3779b97f4a7c15U + k.second);
    }
  };
  std::unordered_map<std::pair<std::uint64_t, std::uint64_t>, Arranged_meetings, Hash> known_;
};

/// A common point of two parts of curves, or a part that they share.
struct Arr_common_part {
  std::optional<Arr_curve_2::Part> part;
  Arr_point_2 point;          ///< if there is none
  unsigned multiplicity = 0;  ///< 0 where it is not known
};

[[nodiscard]] Comparison_result compare_x(const Arr_point_2& p, const Arr_point_2& q);
[[nodiscard]] Comparison_result compare_xy(const Arr_point_2& p, const Arr_point_2& q);

/// \pre x of p is in the range of the curve
[[nodiscard]] Comparison_result compare_y_at_x(const Arr_point_2& p, const Arr_curve_2::Part& c);
/// \pre both curves run through p, and to its right or left
[[nodiscard]] Comparison_result compare_y_beside(const Arr_curve_2::Part& c, const Arr_curve_2::Part& d,
                                                 const Arr_point_2& p, bool is_right, Meetings_of_pairs& meetings);
/// \return in lexicographic order
[[nodiscard]] std::vector<Arr_common_part> common_parts(const Arr_curve_2::Part& c, const Arr_curve_2::Part& d,
                                                        Meetings_of_pairs& meetings);
/// \pre the branch of the curve runs through p
[[nodiscard]] Bracket parameter_at(const Arr_curve_2::Part& c, const Arr_point_2& p);

/// The parts that are monotone in x, or upright and monotone in y; none of a single point.
[[nodiscard]] std::vector<Arr_curve_2::Part> x_monotone_parts(const Arr_curve_2& curve);

/// A part of a curve as a face has it to its left.
struct Boundary_part {
  const Bezier_curve_2<double>* bezier;
  Bracket from, to;  ///< hold the parameters where it starts and ends
};
/// The area that closed boundaries of a face run round.
[[nodiscard]] Measure_bounds boundary_area(const std::vector<std::vector<Boundary_part>>& boundaries, double eps);

/// A polyline along a curve, from left to right.
[[nodiscard]] std::vector<Xy<double>> approximate_polyline(const Arr_curve_2::Part& c, double error);

}  // namespace CGAL::Bounding_arcs::internal

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many digits each method, formula and number type keeps: figures of one region against enclosures of the exact
// ones.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_STABILITY_STUDY_H
#define CGAL_BOUNDING_ARCS_2_STUDY_STABILITY_STUDY_H

#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL::Bounding_arcs {

/// One measurement. The errors are of the worse of a region's circles or joints.
struct Stability_row {
  std::string family;    ///< what the piece is a member of, for those who study more than one piece
  double delta = 0;      ///< its parameter there
  std::string method;    ///< bca, sfa, bilens
  std::string formula;   ///< textbook, stable
  std::string kernel;    ///< float, double, long-double, filtered
  std::string quantity;  ///< center, radius, joint, thickness
  double rel_error = 0;  ///< |value - exact| / |exact|; 1 where nothing finite came out
  double abs_error = 0;  ///< |value - exact|, positions measured from the piece's start
  double outside = 0;    ///< at most so far the exact curve leaves the region in its place; see outside_bound
};

/// Measures all methods, formulas and floating kernels on the piece [t0, t1] of a spiral segment, the control points
/// and parameters taken as exact. A method whose region steps back to BCA here gives no rows, be it in exact arithmetic
/// or because the differences of curvature are below the least normal double; nor does a single point. Lines have
/// infinite radius and center: the errors are 0 where that came out, else 1 and the largest double. `outside` is the
/// largest double where a boundary is not finite or nothing is proven.
/// \guarantee the errors are against MPFR enclosures of the exact figures, narrower than 2^-80 of themselves
/// \source the paper's section 4.3 asks the question
[[nodiscard]] std::vector<Stability_row> stability_rows(const Bezier_spiral_2<double>& spiral, double t0, double t1);

/// Collects rows and keeps the worst of those that agree in family, delta, method, formula, kernel and quantity.
class Worst_rows {
 public:
  /// \param by_delta false: one row for all delta of a family, with the delta of its largest relative error
  explicit Worst_rows(bool by_delta = true) : by_delta_(by_delta) {}

  /// Adds the rows of one member of a family.
  void add(const std::string& family, double delta, const std::vector<Stability_row>& rows) {
    for (Stability_row row : rows) {
      row.family = family;
      row.delta = delta;
      const auto place = places_.emplace(
          Key(family, by_delta_ ? delta : 0, row.method, row.formula, row.kernel, row.quantity), rows_.size());
      if (place.second) {
        rows_.push_back(row);
        continue;
      }
      Stability_row& worst = rows_[place.first->second];
      if (worst.rel_error < row.rel_error) worst.delta = delta;
      worst.rel_error = (std::max)(worst.rel_error, row.rel_error);
      worst.abs_error = (std::max)(worst.abs_error, row.abs_error);
      worst.outside = (std::max)(worst.outside, row.outside);
    }
  }
  /// Returns the rows in the order in which their first came.
  [[nodiscard]] const std::vector<Stability_row>& rows() const { return rows_; }

 private:
  using Key = std::tuple<std::string, double, std::string, std::string, std::string, std::string>;
  bool by_delta_;
  std::map<Key, std::size_t> places_;
  std::vector<Stability_row> rows_;
};

}  // namespace CGAL::Bounding_arcs

#endif

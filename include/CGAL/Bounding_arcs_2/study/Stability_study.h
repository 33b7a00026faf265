// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many digits each method, formula and number type keeps: figures of one region against enclosures of the exact
// ones.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_STABILITY_STUDY_H
#define CGAL_BOUNDING_ARCS_2_STUDY_STABILITY_STUDY_H

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/study/stability_families.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A figure to some 32 digits. Where it is a number, y is 0.
struct Figure_value {
  Xy<Double_double> value;
  bool is_point = false;
};

/// One measurement, of one piece of a curve. Errors are of the worse of a region's circles or joints. Quantity
/// "outside" has in abs_error a proven bound of how far the exact curve leaves the region in its place, see
/// outside_bound, and in rel_error that over the length of the chord. A normal's error is the sine of its angle to the
/// exact one; a bisector's is that of its point next to the piece's start. Only textbook steps have bisectors.
struct Stability_row {
  std::string family;      ///< what the piece is a member of, for those who study more than one piece
  double delta = 0;        ///< its parameter there
  std::string method;      ///< bca, sfa, bilens; fat-arc, fat-biarc, box, oriented-box, hull
  std::string formula;     ///< textbook, stable
  std::string kernel;      ///< float, double, long-double, filtered
  std::string quantity;    ///< normal, bisector, center, radius, joint, thickness, outside
  double rel_error = 0;    ///< |value - exact| / |exact|; 1 where nothing finite came out
  double abs_error = 0;    ///< |value - exact|, positions measured from the piece's start
  std::size_t number = 0;  ///< the piece's number in its family, from 0
  std::vector<Xy<double>> control_points = {};  ///< of the piece's curve; Worst_rows fills in what follows
  std::vector<double> weights = {};             ///< empty for a polynomial curve
  std::optional<double> condition = {};  ///< of the figure, where it was asked for and is known; see figure_conditions
  double t0 = 0, t1 = 1;                 ///< the piece's parameters
  std::string placement = {};            ///< how the family placed the curve, as Study_piece tells it
  std::string frame = {};                ///< where positions are measured: in place, or from the piece's start
  std::optional<Figure_value> computed = {}, exact = {};  ///< of the circle or joint with rel_error; where finite
};

/// Which rows are measured: those with the named words. An empty list names all; of methods it names bca, sfa and
/// bilens. The methods that these are compared with have rows of a textbook thickness, and none of filtered.
struct Stability_choice {
  std::vector<std::string> methods, formulas, kernels, quantities;
  /// The relative error up to which a row is of no interest, if any: those where a cheap bound proves that are left
  /// out. It is asked with the words of a row alone. Several threads may call it.
  std::function<double(const Stability_row&)> floor = {};

  [[nodiscard]] static bool names(const std::vector<std::string>& words, const std::string& word) {
    return words.empty() || std::find(words.begin(), words.end(), word) != words.end();
  }
};

/// Measures methods, formulas and floating kernels on the piece [t0, t1] of a spiral segment, the control points and
/// parameters taken as exact. A method whose region steps back to BCA here gives no rows, be it in exact arithmetic or
/// because the differences of curvature are below the least normal double; nor does a single point. Lines have infinite
/// radius and center: the errors are 0 where that came out, else 1 and the largest double. The errors of `outside` are
/// the largest double where a boundary is not finite or nothing is proven.
/// \param choice the rows that are wanted; others cost little or no time
/// \guarantee the errors are against MPFR enclosures of the exact figures, narrower than 2^-80 of themselves
/// \source the paper's section 4.3 asks the question
[[nodiscard]] std::vector<Stability_row> stability_rows(const Bezier_spiral_2<double>& spiral, double t0, double t1,
                                                        const Stability_choice& choice = {});

/// The condition numbers of a region's figures: the relative change of a figure over that of the numbers that make the
/// curve, its control points' coordinates and weights, when each changes by the same share of itself, in the worst
/// directions. About so many units roundoff a figure is uncertain by the rounding of the input alone, whatever the
/// formula. Coordinates that are 0 stay 0.
struct Figure_conditions {
  double center = 0, radius = 0, joint = 0, thickness = 0;  ///< of circles and joints the largest
  double normal = 0;                                        ///< of its direction
  double bisector = 0;  ///< of the point next to the piece's start; 0 where it is not known
};

/// Computes them for the exact region of a method on the piece [t0, t1], whose parameters do not change.
/// \param method bca, sfa or bilens; others have none
/// \return nothing for lines, for pieces whose ends have no tangents or infinite curvatures, and where the region steps
///   back to BCA or there are other figures when a number changes; nor where one is 2^160 or more
/// \guarantee heuristic: sums of difference quotients over 2^-200 of each number, in enclosures whose widths do not
///   show
[[nodiscard]] std::optional<Figure_conditions> figure_conditions(const Bezier_spiral_2<double>& spiral, double t0,
                                                                 double t1, const std::string& method);

/// Writes rows as CSV, a line of names first. The curve stands in a row as `bounding_arcs stability --curve` reads it;
/// figures have 32 digits, and points two numbers with a blank between.
void write_csv(std::ostream& out, const std::vector<Stability_row>& rows);

/// Collects rows. Where several agree in family, delta, method, formula, kernel and quantity it keeps the one with the
/// largest relative error, the first of equal ones: all that a row tells is of one piece.
class Worst_rows {
 public:
  /// \param by_delta false: one row for all delta of a family
  explicit Worst_rows(bool by_delta = true) : by_delta_(by_delta) {}

  /// Adds the rows of one member of a family.
  void add(const Study_piece& piece, const std::vector<Stability_row>& rows) {
    for (const Stability_row& row : rows) {
      const auto place = places_.emplace(key(piece, row), rows_.size());
      if (place.second) rows_.emplace_back();
      else if (!(rows_[place.first->second].rel_error < row.rel_error)) continue;
      rows_[place.first->second] = row_of(piece, row);
    }
  }
  /// Returns the relative error that a row must exceed to be kept for this piece; below 0 where any is.
  [[nodiscard]] double floor(const Study_piece& piece, const Stability_row& row) const {
    const auto place = places_.find(key(piece, row));
    return place == places_.end() ? -1 : rows_[place->second].rel_error;
  }
  /// Returns the rows in the order in which their first came.
  [[nodiscard]] const std::vector<Stability_row>& rows() const { return rows_; }

 private:
  using Key = std::tuple<std::string, double, std::string, std::string, std::string, std::string>;

  [[nodiscard]] Key key(const Study_piece& piece, const Stability_row& row) const {
    return {piece.family, by_delta_ ? piece.delta : 0, row.method, row.formula, row.kernel, row.quantity};
  }
  [[nodiscard]] static Stability_row row_of(const Study_piece& piece, Stability_row row) {
    row.family = piece.family;
    row.delta = piece.delta;
    row.number = piece.number;
    row.control_points = piece.spiral.curve().control_points();
    row.weights = piece.spiral.curve().weights();
    row.t0 = piece.t0;
    row.t1 = piece.t1;
    row.placement = piece.placement;
    return row;
  }

  bool by_delta_;
  std::map<Key, std::size_t> places_;
  std::vector<Stability_row> rows_;
};

}  // namespace CGAL::Bounding_arcs

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many digits a formula of one's own keeps, in any number types: it is a template on the number type, and runs once
// more in enclosures, whose precision grows until they are narrow.  Nothing exact has to be written.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_FORMULA_STUDY_H
#define CGAL_BOUNDING_ARCS_2_STUDY_FORMULA_STUDY_H

#include <CGAL/Bounding_arcs_2/study/Stability_study.h>
#include <CGAL/Bounding_arcs_2/study/internal/Enclosed_piece.h>
#include <CGAL/Bounding_arcs_2/study/internal/studied_value.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A piece [t0, t1] of a Bezier curve in a number type, as a formula under study gets it.
/// \code
/// const Xy<NT> chord = piece.curve.point(piece.t1) - piece.curve.point(piece.t0);
/// \endcode
template <class NT> struct Formula_piece {
  using Number_type = NT;
  Bezier_curve_2<NT> curve;
  NT t0, t1;
  Chord_shape_2<NT> shape;  ///< as constructions of regions take it, with curvatures, without control points

  /// The shape in its place.
  [[nodiscard]] Chord_frame_2<NT> frame() const { return {curve.point(t0), curve.point(t1), shape}; }
};

/// What a predicate says: -1, 0 or 1, or any other number.
struct Verdict {
  int value;
};

/// A figure that a formula gives: a number, a point or vector, or a verdict. Points are compared by their distance,
/// relative to that of the exact point from the origin.
template <class NT> struct Named_figure {
  Named_figure(std::string n, const NT& x) : name(std::move(n)), value{x, NT(0)} {}
  Named_figure(std::string n, const Xy<NT>& p) : name(std::move(n)), value(p) {}
  Named_figure(std::string n, Verdict v) : name(std::move(n)), value{NT(v.value), NT(0)}, is_verdict(true) {}

  std::string name;
  Xy<NT> value;
  bool is_verdict = false;
};
template <class NT> using Named_figures = std::vector<Named_figure<NT>>;

/// A study of one formula on the pieces of families, in as many number types as are added.
/// \code
/// struct Chord_length {
///   template <class NT> Named_figures<NT> operator()(const Formula_piece<NT>& piece) const {
///     const Xy<NT> chord = piece.curve.point(piece.t1) - piece.curve.point(piece.t0);
///     return {{"length", square_root(dot(chord, chord))}};
///   }
/// };
/// Formula_study<Chord_length> study("chord", Chord_length(), near_linear_family());
/// study.add<float>("float");
/// for (const Stability_row& row : study.rows()) std::cout << row.delta << ' ' << row.rel_error << '\n';
/// \endcode
/// A number type has +, -, *, /, a negative, comparisons, a square root where the formula takes one, and conversions
/// from int and from double, and to double by static_cast. It may have more digits than double. Enclosures, with
/// inf() and sup() or lower() and upper(), have the error of their farther end.
/// \guarantee errors are against enclosures narrower than 2^-80 of themselves. The formula must be made of operations
///   that Mpfr_interval has, and may compare: where a comparison is open, more bits decide it
template <class Formula> class Formula_study {
 public:
  /// \param name stands in the rows as the method
  Formula_study(std::string name, Formula formula, std::vector<Study_piece> pieces)
      : name_(std::move(name)), formula_(std::move(formula)), pieces_(std::move(pieces)) {
    for (const Study_piece& piece : pieces_) exact_.push_back(exact_figures(piece));
  }

  /// Measures the formula in a number type.
  /// \param kernel stands in the rows for the type
  template <class NT> void add(const std::string& kernel) {
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (exact_[i]) worst_.add(pieces_[i], rows<NT>(pieces_[i], *exact_[i], kernel));
  }
  /// The worst row of each family, delta, figure and number type so far; the formula is called "own". A wrong verdict
  /// has a relative error of 1, and so has a figure that is not finite or not decided. A type that estimates its
  /// errors, such as Randomly_rounded, has a row with the largest estimate beside each, the quantity followed by ",
  /// estimated".
  [[nodiscard]] const std::vector<Stability_row>& rows() const { return worst_.rows(); }
  /// The number of pieces without rows: a comparison stays open, as of exact numbers that are equal, or a figure is
  /// not finite.
  [[nodiscard]] std::size_t undecided() const {
    std::size_t count = 0;
    for (const auto& figures : exact_) count += figures ? 0u : 1u;
    return count;
  }

 private:
  using Exact_figures = Named_figures<Mpfr_interval>;

  [[nodiscard]] std::optional<Exact_figures> exact_figures(const Study_piece& piece) const {
    study::Enclosed_piece enclosed(piece.spiral, piece.t0, piece.t1);
    for (mpfr_prec_t bits = study::FIRST_PRECISION; bits <= study::LAST_PRECISION; bits *= 2) {
      try {
        const Exact_figures figures = formula_(Formula_piece<Mpfr_interval>{enclosed.curve(bits), enclosed.t0(bits),
                                                                            enclosed.t1(bits), enclosed.shape(bits)});
        bool is_narrow = true;
        for (const auto& f : figures) is_narrow = is_narrow && study::is_narrow_value(f.value);
        if (is_narrow) return figures;
      } catch (const CGAL::Uncertain_conversion_exception&) {  // a comparison is open at this precision
      }
    }
    return std::nullopt;
  }

  template <class NT>
  [[nodiscard]] std::vector<Stability_row> rows(const Study_piece& piece, const Exact_figures& exact,
                                                const std::string& kernel) const {
    const Named_figures<NT> figures = figures_in<NT>(piece);
    std::vector<Stability_row> rows;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      Stability_row row{{}, 0, name_, "own", kernel, exact[i].name};
      const bool is_there = i < figures.size() && figures[i].name == exact[i].name;
      const study::Deviation d = !is_there             ? study::lost_value(exact[i].value)
                                 : exact[i].is_verdict ? study::wrong_verdict(figures[i].value.x, exact[i].value.x)
                                                       : study::deviation_of_value(figures[i].value, exact[i].value);
      row.rel_error = d.relative;
      row.abs_error = d.absolute;
      rows.push_back(row);
      if constexpr (study::estimates_errors_v<NT>) {
        if (!is_there) continue;
        const study::Deviation estimate = study::estimated_deviation(figures[i].value);
        row.quantity += ", estimated";
        row.rel_error = estimate.relative;
        row.abs_error = estimate.absolute;
        rows.push_back(row);
      }
    }
    return rows;
  }

  // None where enclosures of the type leave a comparison open.
  template <class NT> [[nodiscard]] Named_figures<NT> figures_in(const Study_piece& piece) const {
    try {
      return formula_(piece_in<NT>(piece));
    } catch (const CGAL::Uncertain_conversion_exception&) {
      return {};
    }
  }
  // Control points and parameters rounded to NT, and their differences taken there.
  template <class NT> [[nodiscard]] static Formula_piece<NT> piece_in(const Study_piece& piece) {
    const Bezier_curve_2<double>& curve = piece.spiral.curve();
    std::vector<Xy<NT>> points;
    std::vector<NT> weights;
    for (const Xy<double>& p : curve.control_points()) points.push_back({NT(p.x), NT(p.y)});
    for (const double w : curve.weights()) weights.push_back(NT(w));
    const NT t0 = NT(piece.t0), t1 = NT(piece.t1);
    return {Bezier_curve_2<NT>(std::move(points), std::move(weights)), t0, t1,
            bezier_chord_shape(Taylor_table<NT>(curve, length_unit(curve)), t0, t1, {},
                               piece.spiral.orders(piece.t0, piece.t1))};
  }

  std::string name_;
  Formula formula_;
  std::vector<Study_piece> pieces_;
  std::vector<std::optional<Exact_figures>> exact_;
  Worst_rows worst_;
};

}  // namespace CGAL::Bounding_arcs

#endif

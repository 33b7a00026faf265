// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many digits a formula of one's own keeps, in any number types: it is a template on the number type, and runs once
// more in enclosures, whose precision grows until they are narrow.  Nothing exact has to be written.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_FORMULA_STUDY_H
#define CGAL_BOUNDING_ARCS_2_STUDY_FORMULA_STUDY_H

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/study/Quad.h>
#include <CGAL/Bounding_arcs_2/study/Stability_study.h>
#include <CGAL/Bounding_arcs_2/study/Worst_case_hunt.h>

#include <CGAL/Uncertain.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
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

  /// Returns the shape in its place.
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

namespace study {

using Enclosed_figures = Named_figures<Mpfr_interval>;
using Enclosed_formula = std::function<Enclosed_figures(const Formula_piece<Mpfr_interval>&)>;

/// A figure as a number type gave it, if it is finite.
struct Computed_figure {
  std::string name;
  std::optional<Xy<Mpfr_interval>> value;
  std::optional<double> estimated_error = {};
};

/// Computes figures narrower than 2^-80 of themselves; nothing where no precision makes them so.
[[nodiscard]] std::optional<Enclosed_figures> enclosed_figures(const Enclosed_formula& formula,
                                                               const Study_piece& piece);
/// Makes a row of each figure, and of each estimated error. \param words what all rows share
[[nodiscard]] std::vector<Stability_row> formula_rows(const std::vector<Computed_figure>& computed,
                                                      const Enclosed_figures& exact, const Stability_row& words);
/// Fills in the condition numbers of rows of a formula.
void add_formula_conditions(const Enclosed_formula& formula, std::vector<Stability_row>& rows);

template <class NT, class = void> inline constexpr bool has_inf_and_sup_v = false;
template <class NT>
inline constexpr bool
    has_inf_and_sup_v<NT, std::void_t<decltype(std::declval<NT>().inf()), decltype(std::declval<NT>().sup())>> = true;
template <class NT, class = void> inline constexpr bool has_bounds_v = false;
template <class NT>
inline constexpr bool
    has_bounds_v<NT, std::void_t<decltype(std::declval<NT>().lower()), decltype(std::declval<NT>().upper())>> = true;
template <class NT, class = void> inline constexpr bool estimates_errors_v = false;
template <class NT>
inline constexpr bool estimates_errors_v<NT, std::void_t<decltype(std::declval<NT>().estimated_error())>> = true;

inline constexpr mpfr_prec_t VALUE_BITS = 1024;  // holds the sum of PARTS doubles of neighbouring sizes

[[nodiscard]] inline Mpfr_interval long_number(double x) { return Mpfr_interval(CGAL::Exact_rational(x), VALUE_BITS); }

/// The value of a number, as the sum of doubles that are taken off it, or what its bounds enclose; nothing where it is
/// not finite.
template <class NT> [[nodiscard]] std::optional<Mpfr_interval> value_of(NT x) {
  const auto bounded = [](double low, double high) -> std::optional<Mpfr_interval> {
    if (!std::isfinite(low) || !std::isfinite(high)) return std::nullopt;
    return joined(long_number(low), long_number(high));
  };
  if constexpr (has_inf_and_sup_v<NT>) {
    return bounded(x.inf(), x.sup());
  } else if constexpr (has_bounds_v<NT>) {
    return bounded(x.lower(), x.upper());
  } else if constexpr (std::is_same_v<NT, Double_double>) {
    if (!std::isfinite(x.hi) || !std::isfinite(x.lo)) return std::nullopt;
    return long_number(x.hi) + long_number(x.lo);
  } else {
    constexpr int PARTS = 8;
    Mpfr_interval sum = long_number(0);
    for (int i = 0; i < PARTS; ++i) {
      const auto part = static_cast<double>(x);
      if (!std::isfinite(part)) return std::nullopt;
      sum = sum + long_number(part);
      if (estimates_errors_v<NT> || part == 0) break;
      x = NT(x - NT(part));
    }
    return sum;
  }
}
template <class NT> [[nodiscard]] std::optional<Xy<Mpfr_interval>> value_of(const Xy<NT>& p) {
  const auto x = value_of(p.x), y = value_of(p.y);
  if (!x || !y) return std::nullopt;
  return Xy<Mpfr_interval>{*x, *y};
}

/// Estimated errors of a point's coordinates; 0 of types that estimate none.
template <class NT> [[nodiscard]] Xy<double> estimated_errors(const Xy<NT>& p) {
  if constexpr (estimates_errors_v<NT>) return {p.x.estimated_error(), p.y.estimated_error()};
  else return {0, 0};
}

}  // namespace study

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
/// study.add<__float128>("quad");
/// write_csv(std::cout, study.rows());
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
    for (const Study_piece& piece : pieces_) exact_.push_back(study::enclosed_figures(formula_, piece));
  }

  /// Measures the formula in a number type.
  /// \param kernel stands in the rows for the type
  template <class NT> void add(const std::string& kernel) {
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (exact_[i]) worst_.add(pieces_[i], rows_of<NT>(pieces_[i], *exact_[i], kernel));
  }
  /// Returns the worst row of each family, delta, figure and number type so far; the formula is called "own". A wrong
  /// verdict has a relative error of 1, and so has a figure that is not finite or not decided. A type that estimates
  /// its errors, such as Randomly_rounded, has a row with the largest estimate beside each, the quantity followed by
  /// ", estimated".
  [[nodiscard]] const std::vector<Stability_row>& rows() const { return worst_.rows(); }
  /// Returns rows of this study, or of a hunt, with the condition numbers of their figures, which Figure_conditions
  /// defines: they tell whether the formula lost the digits or the problem. Verdicts have none.
  [[nodiscard]] std::vector<Stability_row> with_conditions(std::vector<Stability_row> rows) const {
    study::add_formula_conditions(formula_, rows);
    return rows;
  }
  /// Starts a search for the piece on which the formula is worst in a number type. It climbs from the worst of some of
  /// the study's pieces, taken by chance, or of random spirals where the study has none.
  template <class NT> [[nodiscard]] Worst_case_hunt hunt(const std::string& kernel, unsigned seed) const {
    const auto measure = [self = Formula_study(name_, formula_, {}), kernel](const Study_piece& piece) {
      const auto exact = study::enclosed_figures(self.formula_, piece);
      return exact ? self.template rows_of<NT>(piece, *exact, kernel) : std::vector<Stability_row>();
    };
    return Worst_case_hunt(measure, pieces_, seed);
  }
  /// Counts the pieces without rows: a comparison stays open, as of exact numbers that are equal, or a figure is not
  /// finite.
  [[nodiscard]] std::size_t undecided() const {
    std::size_t count = 0;
    for (const auto& figures : exact_) count += figures ? 0u : 1u;
    return count;
  }

 private:
  template <class Studied>
  [[nodiscard]] std::vector<Stability_row> rows_of(const Study_piece& piece, const study::Enclosed_figures& exact,
                                                   const std::string& kernel) const {
    using NT = typename study::Studied_type<Studied>::Type;
    std::vector<study::Computed_figure> computed;
    try {
      for (const Named_figure<NT>& figure : formula_(piece_in<NT>(piece))) {
        computed.push_back({figure.name, study::value_of(figure.value)});
        if constexpr (study::estimates_errors_v<NT>) {
          const Xy<double> errors = study::estimated_errors(figure.value);
          computed.back().estimated_error = std::hypot(errors.x, errors.y);
        }
      }
    } catch (const CGAL::Uncertain_conversion_exception&) {  // enclosures of the type leave a comparison open
    }
    return study::formula_rows(computed, exact, {{}, 0, name_, "own", kernel, {}});
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
  std::vector<std::optional<study::Enclosed_figures>> exact_;
  Worst_rows worst_;
};

}  // namespace CGAL::Bounding_arcs

#endif

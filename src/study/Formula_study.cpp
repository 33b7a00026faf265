// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of study/Formula_study.h: figures in enclosures, and how far computed ones are from them.

#include <CGAL/Bounding_arcs_2/study/Formula_study.h>
#include "figure_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Bounding_arcs::study {
namespace {

[[nodiscard]] double at_most_largest(double x) { return (std::min)(x, (std::numeric_limits<double>::max)()); }

[[nodiscard]] bool is_narrow_value(const Xy<Mpfr_interval>& v) {
  return (is_narrow(v.x) && is_narrow(v.y)) || is_narrow(v);
}
[[nodiscard]] bool is_number(const Named_figure<Mpfr_interval>& f) {
  return CGAL::certainly(f.value.y == Mpfr_interval(0));
}

// |x - exact| at most, and that over |exact| or over the least normal double where that is larger.
[[nodiscard]] Deviation deviation_of_value(const std::optional<Xy<Mpfr_interval>>& x,
                                           const Named_figure<Mpfr_interval>& exact) {
  const Mpfr_interval length = length_about_zero(exact.value), least((std::numeric_limits<double>::min)());
  const auto figure = [&](const Xy<Mpfr_interval>& p) {
    return is_number(exact) ? figure_value(p.x) : figure_value(p);
  };
  if (!x) return {at_most_largest(length.upper()), 1, std::nullopt, figure(exact.value)};
  if (exact.is_verdict) {
    const double error = CGAL::certainly(x->x == exact.value.x) ? 0 : 1;
    return {error, error, figure(*x), figure(exact.value)};
  }
  const Mpfr_interval difference = length_about_zero(*x - exact.value);
  return {at_most_largest(difference.upper()), at_most_largest((difference / larger(length, least)).upper()),
          figure(*x), figure(exact.value)};
}

// What a number type says of its own error.
[[nodiscard]] Deviation estimated_deviation(double error, const Xy<Mpfr_interval>& value) {
  const double size = length_about_zero(value).middle();
  if (!std::isfinite(error)) return {(std::numeric_limits<double>::max)(), 1};
  return {error, at_most_largest(error / (std::max)(size, (std::numeric_limits<double>::min)()))};
}

}  // namespace

std::optional<Enclosed_figures> enclosed_figures(const Enclosed_formula& formula, const Study_piece& piece) {
  Enclosed_piece enclosed(piece.spiral, piece.t0, piece.t1);
  for (mpfr_prec_t bits = FIRST_PRECISION; bits <= LAST_PRECISION; bits *= 2) {
    try {
      Enclosed_figures figures =
          formula({enclosed.curve(bits), enclosed.t0(bits), enclosed.t1(bits), enclosed.shape(bits)});
      if (std::all_of(figures.begin(), figures.end(), [](const auto& f) { return is_narrow_value(f.value); }))
        return figures;
    } catch (const CGAL::Uncertain_conversion_exception&) {  // a comparison is open at this precision
    }
  }
  return std::nullopt;
}

std::vector<Stability_row> formula_rows(const std::vector<Computed_figure>& computed, const Enclosed_figures& exact,
                                        const Stability_row& words) {
  std::vector<Stability_row> rows;
  const auto add = [&](const std::string& quantity, const Deviation& d) {
    rows.push_back(words);
    Stability_row& row = rows.back();
    row.quantity = quantity;
    row.frame = "in place";
    row.rel_error = d.relative;
    row.abs_error = d.absolute;
    row.computed = d.computed;
    row.exact = d.exact;
  };
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const bool is_there = i < computed.size() && computed[i].name == exact[i].name;
    add(exact[i].name, deviation_of_value(is_there ? computed[i].value : std::nullopt, exact[i]));
    if (is_there && computed[i].value && computed[i].estimated_error)
      add(exact[i].name + ", estimated", estimated_deviation(*computed[i].estimated_error, *computed[i].value));
  }
  return rows;
}

}  // namespace CGAL::Bounding_arcs::study

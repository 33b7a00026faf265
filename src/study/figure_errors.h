// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figures of a region in MPFR enclosures, as narrow as asked, and how far floating figures are from them.

#ifndef BOUNDING_ARCS_STUDY_FIGURE_ERRORS_H
#define BOUNDING_ARCS_STUDY_FIGURE_ERRORS_H

#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/study/Stability_study.h>
#include <CGAL/Bounding_arcs_2/study/Textbook.h>
#include "Enclosed_piece.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs::study {

using Exact_figures = Region_figures<Mpfr_interval>;

// Far below the unit roundoff of long double, so that an enclosure's width does not show in an error.
inline constexpr double NARROW = 0x1p-80;

[[nodiscard]] inline bool is_narrow(const Mpfr_interval& x) { return x.relative_width() <= NARROW; }
// As a share of the length: its square is as narrow as the square of that.
[[nodiscard]] inline bool is_narrow(const Xy<Mpfr_interval>& v) {
  return dot(v, v).relative_width() <= NARROW * NARROW;
}
[[nodiscard]] inline bool is_narrow(const Exact_figures& f) {
  return is_narrow(f.thickness) &&
         std::all_of(f.circles.begin(), f.circles.end(),
                     [](const auto& c) {
                       return is_narrow(c.normal) && (c.is_line || (is_narrow(c.center) && is_narrow(c.radius)));
                     }) &&
         std::all_of(f.joints.begin(), f.joints.end(), [](const auto& j) { return is_narrow(j); });
}

/// The figures of a piece placed in the origin; nothing where LAST_PRECISION does not make them narrow.
template <class Construction> [[nodiscard]] std::optional<Exact_figures> exact_figures(Enclosed_piece& piece) {
  for (mpfr_prec_t bits = FIRST_PRECISION; bits <= LAST_PRECISION; bits *= 2) {
    try {
      const Exact_figures figures = region_figures(Construction(), piece.shape(bits).at_origin());
      if (is_narrow(figures)) return figures;
    } catch (const CGAL::Uncertain_conversion_exception&) {  // a comparison is open at this precision
    }
  }
  return std::nullopt;
}

/// |x - exact|, and that over |exact| or over the least normal number of x's type where exact is less: what is below
/// has fewer digits by the type's design.  Both are at most the largest double.
struct Deviation {
  double absolute = 0, relative = 0;
  std::optional<Figure_value> computed = {}, exact = {};  // of the figure with the largest relative error

  void include(const Deviation& other) {
    if (!exact || relative < other.relative) {
      computed = other.computed;
      exact = other.exact;
    }
    absolute = (std::max)(absolute, other.absolute);
    relative = (std::max)(relative, other.relative);
  }
};

/// A number of enclosures in the digits of two doubles; nothing where it is out of their range.
[[nodiscard]] inline std::optional<Double_double> in_two_doubles(const Mpfr_interval& x) {
  const double high = x.middle();
  if (!std::isfinite(high)) return std::nullopt;
  return Double_double(high, (x - Mpfr_interval(high)).middle(), 0);
}
[[nodiscard]] inline std::optional<Figure_value> figure_value(const Mpfr_interval& x) {
  const auto value = in_two_doubles(x);
  return value ? std::optional<Figure_value>({{*value, 0}, false}) : std::nullopt;
}
[[nodiscard]] inline std::optional<Figure_value> figure_value(const Xy<Mpfr_interval>& p) {
  const auto x = in_two_doubles(p.x), y = in_two_doubles(p.y);
  return x && y ? std::optional<Figure_value>({{*x, *y}, true}) : std::nullopt;
}

[[nodiscard]] inline double finite(const Mpfr_interval& x) {
  return (std::min)(x.middle(), (std::numeric_limits<double>::max)());
}

/// Computes a deviation from the length of a difference and of what it is a difference to.
template <class T> [[nodiscard]] Deviation deviation(const Mpfr_interval& difference, const Mpfr_interval& exact) {
  const Mpfr_interval least = Mpfr_interval((std::numeric_limits<T>::min)());
  return {finite(difference), finite(difference / (max)(exact, least))};
}
/// Where no finite number came out: right if there is none of type T.
template <class T> [[nodiscard]] Deviation deviation_of_infinity(const Mpfr_interval& exact) {
  if (CGAL::certainly(Mpfr_interval((std::numeric_limits<T>::max)()) < exact)) return {};
  return {finite(exact), 1};
}

template <class T> [[nodiscard]] Deviation deviation(const T& x, const Mpfr_interval& exact) {
  const bool is_there = std::isfinite(x);
  Deviation d =
      is_there ? deviation<T>(abs(Mpfr_interval(x) - exact), abs(exact)) : deviation_of_infinity<T>(abs(exact));
  if (is_there) d.computed = figure_value(Mpfr_interval(x));
  d.exact = figure_value(exact);
  return d;
}

/// The length of a vector whose coordinates may be about 0: squares of such intervals reach below it.
[[nodiscard]] inline Mpfr_interval length_about_zero(const Xy<Mpfr_interval>& v) {
  const Mpfr_interval zero(0), x = larger(zero, abs(v.x)), y = larger(zero, abs(v.y));
  return sqrt(x * x + y * y);
}

/// Errors of positions, both measured from a start.
template <class T>
[[nodiscard]] Deviation deviation(const Xy<T>& p, const Xy<T>& start, const Xy<Mpfr_interval>& exact) {
  const Mpfr_interval length = sqrt(dot(exact, exact));
  // the sums take the precision of the exact coordinates, so that they come first
  const Xy<Mpfr_interval> place{exact.x + Mpfr_interval(start.x), exact.y + Mpfr_interval(start.y)};
  Deviation d = deviation_of_infinity<T>(length);
  if (std::isfinite(p.x) && std::isfinite(p.y)) {
    const Xy<Mpfr_interval> computed{Mpfr_interval(p.x), Mpfr_interval(p.y)};
    d = deviation<T>(length_about_zero(computed - place), length);
    d.computed = figure_value(computed);
  }
  d.exact = figure_value(place);
  return d;
}

/// The sine of the angle between two vectors; 1 where they point to opposite sides, or one is none.
template <class T> [[nodiscard]] Deviation deviation_of_direction(const Xy<T>& v, const Xy<Mpfr_interval>& exact) {
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || (v.x == 0 && v.y == 0)) return {1, 1};
  const Xy<Mpfr_interval> w{Mpfr_interval(v.x), Mpfr_interval(v.y)};
  if (dot(exact, w).certain_sign() <= 0) return {1, 1};
  const Mpfr_interval length = sqrt(dot(w, w)), exact_length = sqrt(dot(exact, exact)), one(1);
  const double sine = finite(abs(cross(exact, w)) / (exact_length * length));
  return {sine, sine, figure_value((one / length) * w), figure_value((one / exact_length) * exact)};
}

/// The point of a line next to a start, seen from there. A line of floating numbers is taken as exact: evaluated with
/// them the point would have more of their errors.
template <class T> [[nodiscard]] Xy<Mpfr_interval> foot(const Line_figure<T>& line, const Xy<T>& start) {
  constexpr mpfr_prec_t BITS = 1024;
  const auto number = [](const T& x) {
    if constexpr (std::is_floating_point_v<T>) return Mpfr_interval(CGAL::Exact_rational(1), BITS) * Mpfr_interval(x);
    else return x;
  };
  const Xy<Mpfr_interval> normal{number(line.a), number(line.b)}, s{number(start.x), number(start.y)};
  const Mpfr_interval value = dot(normal, s) + number(line.c);
  return (-value / dot(normal, normal)) * normal;
}
/// The feet of the bisectors that a textbook has; nothing where one is not narrow or a comparison is open.
template <class Textbook>
[[nodiscard]] std::vector<Xy<Mpfr_interval>> narrow_feet(const Chord_frame_2<Mpfr_interval>& frame) {
  std::vector<Xy<Mpfr_interval>> feet;
  try {
    for (const auto& line : Textbook::figures(frame).bisectors) feet.push_back(foot(line, frame.p0));
  } catch (const CGAL::Uncertain_conversion_exception&) {
    return {};
  }
  const bool are_narrow = std::all_of(feet.begin(), feet.end(), [](const auto& p) { return is_narrow(p); });
  return are_narrow ? feet : std::vector<Xy<Mpfr_interval>>();
}
/// The narrow feet of a piece placed in the origin.
template <class Textbook> [[nodiscard]] std::vector<Xy<Mpfr_interval>> exact_feet(Enclosed_piece& piece) {
  for (mpfr_prec_t bits = FIRST_PRECISION; bits <= LAST_PRECISION; bits *= 2) {
    auto feet = narrow_feet<Textbook>(piece.shape(bits).at_origin());
    if (!feet.empty()) return feet;
  }
  return {};
}

/// Errors of a line, told by its foot. \param exact the foot
template <class T>
[[nodiscard]] Deviation deviation_of_line(const Line_figure<T>& line, const Xy<T>& start,
                                          const Xy<Mpfr_interval>& exact) {
  const Mpfr_interval length = sqrt(dot(exact, exact));
  if (!std::isfinite(line.a) || !std::isfinite(line.b) || !std::isfinite(line.c) || (line.a == 0 && line.b == 0))
    return {finite(length), 1};
  const Xy<Mpfr_interval> computed = foot(line, start), place{Mpfr_interval(start.x), Mpfr_interval(start.y)};
  Deviation d = deviation<T>(length_about_zero(computed - exact), length);
  d.computed = figure_value(computed + place);
  d.exact = figure_value(exact + place);
  return d;
}

/// The worst of a region's circles and joints, and its thickness.
struct Figure_errors {
  Deviation normal, center, radius, joint, thickness;
};

template <class T>
[[nodiscard]] Figure_errors figure_errors(const Region_figures<T>& figures, const Xy<T>& start,
                                          const Exact_figures& exact) {
  // another form came out: nothing of this one is there
  const bool is_lost = figures.form != exact.form || figures.circles.size() != exact.circles.size() ||
                       figures.joints.size() != exact.joints.size();
  const Deviation infinite{(std::numeric_limits<double>::max)(), 1};
  Figure_errors errors;
  for (std::size_t i = 0; i < exact.circles.size(); ++i) {
    const Circle_figure<Mpfr_interval>& e = exact.circles[i];
    errors.normal.include(is_lost ? Deviation{1, 1} : deviation_of_direction(figures.circles[i].normal, e.normal));
    if (e.is_line) {
      const Deviation d = !is_lost && figures.circles[i].is_line ? Deviation{} : infinite;
      errors.center.include(d);
      errors.radius.include(d);
      continue;
    }
    const bool is_infinite = is_lost || figures.circles[i].is_line;
    const Mpfr_interval distance = sqrt(dot(e.center, e.center));
    errors.center.include(is_infinite ? deviation_of_infinity<T>(distance)
                                      : deviation(figures.circles[i].center, start, e.center));
    errors.radius.include(is_infinite ? deviation_of_infinity<T>(e.radius)
                                      : deviation(figures.circles[i].radius, e.radius));
  }
  for (std::size_t i = 0; i < exact.joints.size(); ++i) {
    const Xy<Mpfr_interval>& e = exact.joints[i];
    errors.joint.include(is_lost ? Deviation{finite(sqrt(dot(e, e))), 1} : deviation(figures.joints[i], start, e));
  }
  errors.thickness = is_lost ? Deviation{finite(exact.thickness), 1} : deviation(figures.thickness, exact.thickness);
  return errors;
}

}  // namespace CGAL::Bounding_arcs::study

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many digits each method, formula and number type keeps: figures of one region against enclosures of the exact ones.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_STABILITY_STUDY_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_STABILITY_STUDY_H

#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/region/Textbook.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/verify/Mpfr_interval.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs {

/// One measurement. The errors are of the worse of a region's two circles or joints.
struct Stability_row {
  std::string method;    ///< bca, sfa, bilens
  std::string formula;   ///< textbook, stable
  std::string kernel;    ///< float, double, long-double
  std::string quantity;  ///< center, radius, joint, thickness
  double rel_error = 0;  ///< |value - exact| / |exact|; 1 where nothing finite came out
  double abs_error = 0;  ///< |value - exact|, positions measured from the piece's start
};

namespace internal {

using Exact_figures = Region_figures<Mpfr_interval>;

[[nodiscard]] inline Mpfr_interval exactly(long double x, mpfr_prec_t precision) {
  const double hi = static_cast<double>(x);
  return Mpfr_interval(CGAL::Exact_rational(hi), precision) +
         Mpfr_interval(CGAL::Exact_rational(static_cast<double>(x - hi)), precision);
}

/// |x - exact| and that over |exact|; the latter 1 where x is not finite.
struct Deviation {
  double absolute = 0, relative = 0;
  void include(const Deviation& other) {
    absolute = (std::max)(absolute, other.absolute);
    relative = (std::max)(relative, other.relative);
  }
};

inline constexpr mpfr_prec_t STUDY_PRECISION = 2560;  // 1e-300 in the third power and as many digits again

template <class T>
[[nodiscard]] Deviation deviation(const T& x, const Mpfr_interval& exact) {
  const double size = std::fabs(exact.middle());
  if (!std::isfinite(x)) return {size, 1};
  const Mpfr_interval difference = exactly(x, STUDY_PRECISION) - exact;
  return {std::fabs(difference.middle()), std::fabs((difference / exact).middle())};
}

/// The same for positions, both measured from a start.
template <class T>
[[nodiscard]] Deviation deviation(const Xy<T>& p, const Xy<T>& start, const Xy<Mpfr_interval>& exact) {
  const Mpfr_interval length = sqrt(dot(exact, exact));
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) return {length.middle(), 1};
  const auto coordinate = [](const T& x, const T& x0) { return exactly(x, STUDY_PRECISION) - exactly(x0, STUDY_PRECISION); };
  const Xy<Mpfr_interval> difference = Xy<Mpfr_interval>{coordinate(p.x, start.x), coordinate(p.y, start.y)} - exact;
  const Mpfr_interval error = sqrt(dot(difference, difference));
  return {error.middle(), (error / length).middle()};
}

/// Appends the rows of one region's figures.
template <class T>
void append_rows(std::vector<Stability_row>& rows, const Stability_row& head, const Region_figures<T>& figures,
                 const Xy<T>& start, const Exact_figures& exact) {
  const auto append = [&](const char* quantity, const Deviation& d) {
    Stability_row row = head;
    row.quantity = quantity;
    row.rel_error = d.relative;
    row.abs_error = d.absolute;
    rows.push_back(row);
  };
  const bool lost = figures.form != exact.form;  // another form came out: nothing of this one is there
  Deviation center, radius, joint;
  for (std::size_t i = 0; i < exact.centers.size(); ++i) {
    center.include(lost ? Deviation{0, 1} : deviation(figures.centers[i], start, exact.centers[i]));
    radius.include(lost ? Deviation{0, 1} : deviation(figures.radii[i], exact.radii[i]));
  }
  for (std::size_t i = 0; i < exact.joints.size(); ++i)
    joint.include(lost ? Deviation{0, 1} : deviation(figures.joints[i], start, exact.joints[i]));
  append("center", center);
  append("radius", radius);
  if (!exact.joints.empty()) append("joint", joint);
  append("thickness", lost ? Deviation{0, 1} : deviation(figures.thickness, exact.thickness));
}

template <class T>
[[nodiscard]] Chord_frame_2<T> at_origin(const Chord_shape_2<T>& shape) {
  return {{}, shape.unit * shape.chord, shape};
}

// Frames of one piece over T: absolute for the textbook, from the start for the stable formulas.
template <class T>
struct Study_frames {
  Study_frames(const Bezier_spiral_2<double>& spiral, double t0, double t1) {
    std::vector<Xy<T>> points;
    std::vector<T> weights;
    for (const Xy<double>& p : spiral.curve().control_points()) points.push_back({T(p.x), T(p.y)});
    for (const double w : spiral.curve().weights()) weights.push_back(T(w));
    const Bezier_curve_2<T> curve(points, weights);
    const auto shape = bezier_chord_shape(Taylor_table<T>(curve, length_unit(spiral.curve())), T(t0), T(t1), {}, spiral.orders(t0, t1));
    absolute = {curve.point(T(t0)), curve.point(T(t1)), shape};
    if constexpr (std::is_same_v<T, double>) relative = at_origin(spiral.accurate_shape(t0, t1));
    else relative = at_origin(shape);
  }
  Chord_frame_2<T> absolute, relative;
};

template <class Construction, class Textbook, class T>
void append_formulas(std::vector<Stability_row>& rows, const char* kernel, const Study_frames<T>& frames,
                     const Exact_figures& exact) {
  append_rows(rows, {Construction::NAME, "textbook", kernel, {}}, Textbook::figures(frames.absolute), frames.absolute.p0, exact);
  append_rows(rows, {Construction::NAME, "stable", kernel, {}}, region_figures(Construction(), frames.relative), Xy<T>{}, exact);
}

template <class Construction, class Textbook>
void append_method(std::vector<Stability_row>& rows, Region_form form, const Chord_frame_2<Mpfr_interval>& exact_frame,
                   const Bezier_spiral_2<double>& spiral, double t0, double t1) {
  const Exact_figures exact = region_figures(Construction(), exact_frame);
  if (exact.form != form) return;
  append_formulas<Construction, Textbook>(rows, "float", Study_frames<float>(spiral, t0, t1), exact);
  append_formulas<Construction, Textbook>(rows, "double", Study_frames<double>(spiral, t0, t1), exact);
  append_formulas<Construction, Textbook>(rows, "long-double", Study_frames<long double>(spiral, t0, t1), exact);
}

}  // namespace internal

/// Measures all methods, formulas and floating kernels on the piece [t0, t1] of a spiral segment, the control points
/// and parameters taken as exact. A method whose region steps back to BCA here gives no rows, nor does a straight piece.
/// \pre the curvature is not 0 and not infinite at either end
/// \guarantee the errors are against MPFR enclosures of the exact figures, of 2560 bits
/// \source the paper's section 4.3 asks the question
[[nodiscard]] inline std::vector<Stability_row> stability_rows(const Bezier_spiral_2<double>& spiral, double t0, double t1) {
  using Rational = CGAL::Exact_rational;
  const auto shape = spiral.shape<Rational>(t0, t1);
  std::vector<Stability_row> rows;
  if (shape.turn == 0) return rows;
  const auto interval = [](const Rational& x) { return Mpfr_interval(x, internal::STUDY_PRECISION); };
  const auto frame = internal::at_origin(convert_shape<Mpfr_interval>(shape, interval));
  internal::append_method<Bca, Textbook_bca>(rows, Region_form::BCA, frame, spiral, t0, t1);
  if (!shape.proper) return rows;
  internal::append_method<Spiral_fat_arc, Textbook_spiral_fat_arc>(rows, Region_form::SPIRAL_FAT_ARC, frame, spiral, t0, t1);
  internal::append_method<Bilens, Textbook_bilens>(rows, Region_form::BILENS, frame, spiral, t0, t1);
  return rows;
}

}  // namespace CGAL::Bounding_arcs

#endif

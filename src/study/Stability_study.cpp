// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of study/Stability_study.h.

// Before Circular_kernel_2: it makes the kernel compile over fundamental number types.
#include <CGAL/Root_of_traits.h>

#include <CGAL/Algebraic_kernel_for_circles_2_2.h>
#include <CGAL/Circular_kernel_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Bounding_arcs_2/region/Bca_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/Bilens_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/study/Stability_study.h>
#include <CGAL/Bounding_arcs_2/study/Textbook.h>
#include <CGAL/Bounding_arcs_2/study/boxes_and_hulls.h>
#include <CGAL/Bounding_arcs_2/study/fat_arcs.h>
#include <CGAL/Bounding_arcs_2/verify/outside_bound.h>
#include "figure_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace study {

using Filtered_circular_kernel = CGAL::Circular_kernel_2<CGAL::Exact_predicates_inexact_constructions_kernel,
                                                         CGAL::Algebraic_kernel_for_circles_2_2<double>>;

// Frames of one piece over T in its place: of the plain shape for the textbook, of the best for the stable formulas.
template <class T> struct Study_frames { Chord_frame_2<T> textbook, stable; };

// Nothing where T has no number for a coordinate or weight.
template <class T>
[[nodiscard]] std::optional<Study_frames<T>> study_frames(const Bezier_spiral_2<double>& spiral, double t0, double t1,
                                                          const Shape_parts& parts = {}) {
  std::vector<Xy<T>> points;
  std::vector<T> weights;
  const double unit = length_unit(spiral.curve());
  if (!(T(unit) > 0) || !std::isfinite(T(unit))) return std::nullopt;
  for (const Xy<double>& p : spiral.curve().control_points()) {
    points.push_back({T(p.x), T(p.y)});
    if (!std::isfinite(points.back().x) || !std::isfinite(points.back().y)) return std::nullopt;
  }
  for (const double w : spiral.curve().weights()) {
    weights.push_back(T(w));
    if (!(weights.back() > 0) || !std::isfinite(weights.back())) return std::nullopt;
  }
  const Bezier_curve_2<T> curve(points, weights);
  const Chord_frame_2<T> frame = plain_frame(curve, spiral, t0, t1, parts);
  if constexpr (std::is_same_v<T, double>) return Study_frames<T>{frame, spiral.template frame<double>(t0, t1, parts)};
  else return Study_frames<T>{frame, frame};
}

// The largest double for infinity.
[[nodiscard]] static double finite(double x) { return (std::min)(x, (std::numeric_limits<double>::max)()); }

/// One piece under study, and the rows that it gives.
class Stability_measurement {
 public:
  Stability_measurement(const Bezier_spiral_2<double>& spiral, double t0, double t1, const Stability_choice& choice)
      : spiral_(spiral), t0_(t0), t1_(t1), choice_(choice), piece_(spiral, t0, t1) {}

  [[nodiscard]] std::vector<Stability_row> rows() {
    const Chord_shape_2<Mpfr_interval>& shape = piece_.shape(FIRST_PRECISION);
    if (CGAL::certainly(dot(shape.chord, shape.chord) == Mpfr_interval(0))) return {};
    chord_ = sqrt(dot(shape.unit * shape.chord, shape.unit * shape.chord)).middle();
    measure_yardstick<Three_point_fat_arc>();
    measure_yardstick<Fat_biarc>();
    measure_yardstick<Axis_box>();
    measure_yardstick<Oriented_box>();
    measure_yardstick<Control_hull>();
    const bool is_osculating_usable = shape.proper && has_normal_differences(shape);
    make_frames<float>("float");
    make_frames<double>("double");
    make_frames<long double>("long-double");
    if (Stability_choice::names(choice_.kernels, "filtered")) filtered_ = spiral_.frame<double>(t0_, t1_);
    measure_method<Bca_traits_2, Bca, Textbook_bca>(Region_form::BCA);
    if (!is_osculating_usable) return std::move(rows_);
    measure_method<Spiral_fat_arc_traits_2, Spiral_fat_arc, Textbook_spiral_fat_arc>(Region_form::SPIRAL_FAT_ARC);
    measure_method<Bilens_traits_2, Bilens, Textbook_bilens>(Region_form::BILENS);
    return std::move(rows_);
  }

 private:
  // The methods that ours are compared with have one formula each, with the textbook's kind of differences, and of
  // figures a thickness.
  template <class Yardstick> void measure_yardstick() {
    if (choice_.methods.empty() || !Stability_choice::names(choice_.methods, Yardstick::NAME) ||
        !Stability_choice::names(choice_.formulas, "textbook") ||
        !Stability_choice::names(choice_.quantities, "thickness"))
      return;
    const auto parts = shape_parts<Yardstick>();
    const auto shape = spiral_.template shape<CGAL::Exact_rational>(t0_, t1_, parts);
    for (mpfr_prec_t bits = FIRST_PRECISION; bits <= LAST_PRECISION; bits *= 2) {
      const auto exact = thickness_enclosure(Yardstick(), shape, bits);
      if (!exact || !is_narrow(*exact)) continue;
      measure_thickness<Yardstick, float>("float", parts, *exact);
      measure_thickness<Yardstick, double>("double", parts, *exact);
      measure_thickness<Yardstick, long double>("long-double", parts, *exact);
      return;
    }
  }
  template <class Yardstick, class T>
  void measure_thickness(const char* kernel, const Shape_parts& parts, const Mpfr_interval& exact) {
    if (!Stability_choice::names(choice_.kernels, kernel)) return;
    const auto frames = study_frames<T>(spiral_, t0_, t1_, parts);
    const Deviation d =
        frames ? deviation(T(Yardstick::thickness(frames->textbook.shape)), exact) : Deviation{finite(exact), 1};
    Stability_row row{{}, 0, Yardstick::NAME, "textbook", kernel, "thickness"};
    fill(row, d);
    row.frame = FROM_START;
    rows_.push_back(std::move(row));
  }

  template <class T> void make_frames(const char* kernel) {
    if (Stability_choice::names(choice_.kernels, kernel))
      std::get<std::optional<Study_frames<T>>>(frames_) = study_frames<T>(spiral_, t0_, t1_);
  }

  template <template <class, class> class Traits, class Stable, class Textbook> void measure_method(Region_form form) {
    if (!Stability_choice::names(choice_.methods, Stable::NAME)) return;
    const std::optional<Exact_figures> exact = exact_figures<Stable>(piece_);
    if (!exact || exact->form != form) return;
    feet_.clear();
    if (Textbook::HAS_BISECTORS && Stability_choice::names(choice_.quantities, "bisector") &&
        Stability_choice::names(choice_.formulas, "textbook"))
      feet_ = exact_feet<Textbook>(piece_);
    measure_formulas<Stable, Textbook, float>("float", *exact);
    measure_formulas<Stable, Textbook, double>("double", *exact);
    measure_formulas<Stable, Textbook, long double>("long-double", *exact);
    measure_traits<Traits<Filtered_circular_kernel, Stable>, Traits<Filtered_circular_kernel, Textbook>>(*exact);
  }

  // Positions of the stable formulas are from the piece's start, but outside is of the region in its place.
  template <class Stable, class Textbook, class T>
  void measure_formulas(const char* kernel, const Exact_figures& exact) {
    if (!Stability_choice::names(choice_.kernels, kernel)) return;
    const std::optional<Study_frames<T>>& frames = std::get<std::optional<Study_frames<T>>>(frames_);
    for (const char* formula : {"textbook", "stable"}) {
      if (!Stability_choice::names(choice_.formulas, formula)) continue;
      const bool is_stable = formula[0] == 's';
      Stability_row row{{}, 0, Stable::NAME, formula, kernel, {}};
      row.frame = is_stable ? FROM_START : IN_PLACE;
      if (!frames && !is_stable) append_bisector(row, Region_figures<T>(), Xy<T>{});
      if (!frames) append(row, figure_errors(Region_figures<T>(), {}, exact), exact, INFINITE);
      else if (is_stable)
        append(row, figure_errors(region_figures(Stable(), frames->stable.shape.at_origin()), Xy<T>{}, exact), exact,
               [&] { return Stable::boundary(frames->stable); });
      else {
        const Region_figures<T> figures = Textbook::figures(frames->textbook);
        append_bisector(row, figures, frames->textbook.p0);
        append(row, figure_errors(figures, frames->textbook.p0, exact), exact,
               [&] { return Textbook::boundary(frames->textbook); });
      }
    }
  }

  // The filtered kernel's regions, by its traits.
  template <class Stable_traits, class Textbook_traits> void measure_traits(const Exact_figures& exact) {
    if (!Stability_choice::names(choice_.kernels, "filtered")) return;
    const Chord_frame_2<double>&frame = filtered_, at_origin = frame.shape.at_origin();
    Stability_row row{{}, 0, Stable_traits::Construction::NAME, "textbook", "filtered", {}};
    row.frame = IN_PLACE;
    if (Stability_choice::names(choice_.formulas, row.formula))
      append(row, figure_errors(region_figures_of_traits(Textbook_traits(), frame), frame.p0, exact), exact,
             [&] { return boundary_of_traits(Textbook_traits(), frame); });
    row.formula = "stable";
    row.frame = FROM_START;
    if (Stability_choice::names(choice_.formulas, row.formula))
      append(row, figure_errors(region_figures_of_traits(Stable_traits(), at_origin), Xy<double>{}, exact), exact,
             [&] { return boundary_of_traits(Stable_traits(), frame); });
  }

  template <class Traits>
  [[nodiscard]] static Region_boundary_2<double> boundary_of_traits(const Traits& traits,
                                                                    const Chord_frame_2<double>& frame) {
    return traits.construct_region_boundary_2_object()(traits.construct_bounding_region_2_object()(frame));
  }

  // The filtered traits do not tell bisectors, nor have stable formulas any.
  template <class T> void append_bisector(Stability_row row, const Region_figures<T>& figures, const Xy<T>& start) {
    Deviation worst;
    for (std::size_t i = 0; i < feet_.size(); ++i)
      worst.include(i < figures.bisectors.size() ? deviation_of_line(figures.bisectors[i], start, feet_[i])
                                                 : Deviation{finite(sqrt(dot(feet_[i], feet_[i]))), 1});
    row.quantity = "bisector";
    fill(row, worst);
    if (!feet_.empty()) rows_.push_back(std::move(row));
  }

  static constexpr const char *IN_PLACE = "in place", *FROM_START = "from the start";

  static void fill(Stability_row& row, const Deviation& d) {
    row.rel_error = d.relative;
    row.abs_error = d.absolute;
    row.computed = d.computed;
    row.exact = d.exact;
  }

  // In place of a boundary where a number type has no number for a coordinate.
  static constexpr std::nullptr_t INFINITE = nullptr;

  // Appends the rows of one region's figures; `row` has what they share.
  template <class Boundary>
  void append(Stability_row row, const Figure_errors& errors, const Exact_figures& exact, const Boundary& boundary) {
    const auto add = [&](const char* quantity, const Deviation& d) {
      if (!Stability_choice::names(choice_.quantities, quantity)) return;
      row.quantity = quantity;
      fill(row, d);
      rows_.push_back(row);
    };
    add("normal", errors.normal);
    add("center", errors.center);
    add("radius", errors.radius);
    if (!exact.joints.empty()) add("joint", errors.joint);
    add("thickness", errors.thickness);
    row.quantity = "outside";
    row.frame = IN_PLACE;
    row.computed = row.exact = std::nullopt;
    if (Stability_choice::names(choice_.quantities, row.quantity)) append_outside(std::move(row), boundary);
  }

  template <class Boundary> void append_outside(Stability_row row, const Boundary& boundary) {
    const double floor = choice_.floor ? choice_.floor(row) : -1;
    row.rel_error = row.abs_error = (std::numeric_limits<double>::max)();
    if (row.rel_error <= floor) return;
    if constexpr (!std::is_same_v<Boundary, std::nullptr_t>) {
      const auto region = boundary();
      const double enough = floor * chord_;
      if (floor > 0 && finite(outside_bound(spiral_, t0_, t1_, region, enough) / chord_) <= floor) return;
      row.abs_error = finite(outside_bound(spiral_, t0_, t1_, region));
      row.rel_error = finite(row.abs_error / chord_);
    }
    rows_.push_back(std::move(row));
  }

  // Whether double has normal numbers for the small differences behind bilens and spiral fat arcs.
  [[nodiscard]] bool has_normal_differences(const Chord_shape_2<Mpfr_interval>& f) {
    const Mpfr_interval least((std::numeric_limits<double>::min)());
    for (const Mpfr_interval* x : {&f.square_change, &f.sine_change, &f.kneser0, &f.kneser1})
      if (!CGAL::certainly(*x == Mpfr_interval(0)) && !certainly_less(least, abs(*x))) return has_normal_differences();
    return true;
  }
  [[nodiscard]] bool has_normal_differences() {
    const Chord_shape_2<CGAL::Exact_rational>& f = piece_.exact_shape();
    const CGAL::Exact_rational least((std::numeric_limits<double>::min)());
    for (const CGAL::Exact_rational* x : {&f.square_change, &f.sine_change, &f.kneser0, &f.kneser1})
      if (*x != 0 && absolute(*x) < least) return false;
    return true;
  }

  const Bezier_spiral_2<double>& spiral_;
  double t0_, t1_;
  const Stability_choice& choice_;
  Enclosed_piece piece_;
  double chord_ = 0;                     // its length
  std::vector<Xy<Mpfr_interval>> feet_;  // of the current textbook's bisectors, where they are wanted
  std::tuple<std::optional<Study_frames<float>>, std::optional<Study_frames<double>>,
             std::optional<Study_frames<long double>>>
      frames_;
  Chord_frame_2<double> filtered_;
  std::vector<Stability_row> rows_;
};

}  // namespace study

std::vector<Stability_row> stability_rows(const Bezier_spiral_2<double>& spiral, double t0, double t1,
                                          const Stability_choice& choice) {
  return study::Stability_measurement(spiral, t0, t1, choice).rows();
}

}  // namespace CGAL::Bounding_arcs

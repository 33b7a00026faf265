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
#include <CGAL/Bounding_arcs_2/study/Stability_study.h>
#include <CGAL/Bounding_arcs_2/study/Textbook.h>
#include <CGAL/Bounding_arcs_2/study/internal/figure_errors.h>
#include <CGAL/Bounding_arcs_2/verify/outside_bound.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace study {

using Filtered_circular_kernel = CGAL::Circular_kernel_2<CGAL::Exact_predicates_inexact_constructions_kernel,
                                                         CGAL::Algebraic_kernel_for_circles_2_2<double>>;

/// Appends the rows of one region's figures; `row` has what they share.
template <class T>
void append_rows(std::vector<Stability_row>& rows, Stability_row row, const Region_figures<T>& figures,
                 const Xy<T>& start, const Exact_figures& exact) {
  const auto append = [&](const char* quantity, const Deviation& d) {
    row.quantity = quantity;
    row.rel_error = d.relative;
    row.abs_error = d.absolute;
    rows.push_back(row);
  };
  const Figure_errors errors = figure_errors(figures, start, exact);
  append("center", errors.center);
  append("radius", errors.radius);
  if (!exact.joints.empty()) append("joint", errors.joint);
  append("thickness", errors.thickness);
}

// Frames of one piece over T in its place: of the plain shape for the textbook, of the best for the stable formulas.
template <class T> struct Study_frames { Chord_frame_2<T> textbook, stable; };

// Nothing where T has no number for a coordinate or weight.
template <class T>
[[nodiscard]] std::optional<Study_frames<T>> study_frames(const Bezier_spiral_2<double>& spiral, double t0, double t1) {
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
  const auto shape = bezier_chord_shape(Taylor_table<T>(curve, unit), T(t0), T(t1), {}, spiral.orders(t0, t1));
  const Chord_frame_2<T> frame{curve.point(T(t0)), curve.point(T(t1)), shape};
  if constexpr (std::is_same_v<T, double>) return Study_frames<T>{frame, spiral.template frame<double>(t0, t1)};
  else return Study_frames<T>{frame, frame};
}

/// One piece under study, and the rows that it gives.
struct Stability_measurement {
  const Bezier_spiral_2<double>& spiral;
  double t0, t1;
  Chord_shape_2<CGAL::Exact_rational> shape;
  std::vector<Stability_row> rows;

  // Positions of the stable formulas are from the piece's start, but outside is of the region in its place.
  template <class Stable, class Textbook, class T>
  void measure_formulas(const char* kernel, const Exact_figures& exact) {
    const std::optional<Study_frames<T>> frames = study_frames<T>(spiral, t0, t1);
    if (!frames) {
      for (const char* formula : {"textbook", "stable"}) {
        Stability_row row{{}, 0, Stable::NAME, formula, kernel, {}};
        row.outside = (std::numeric_limits<double>::max)();
        append_rows(rows, row, Region_figures<T>(), {}, exact);
      }
      return;
    }
    Stability_row row{{}, 0, Stable::NAME, "textbook", kernel, {}};
    row.outside = outside(Textbook::boundary(frames->textbook));
    append_rows(rows, row, Textbook::figures(frames->textbook), frames->textbook.p0, exact);
    row.formula = "stable";
    row.outside = outside(Stable::boundary(frames->stable));
    append_rows(rows, row, region_figures(Stable(), frame_at_origin(frames->stable.shape)), Xy<T>{}, exact);
  }

  // The filtered kernel's regions, by its traits.
  template <class Stable_traits, class Textbook_traits> void measure_traits(const Exact_figures& exact) {
    const Chord_frame_2<double> frame = spiral.frame<double>(t0, t1);
    Stability_row row{{}, 0, Stable_traits::Construction::NAME, "textbook", "filtered", {}};
    row.outside = outside(boundary_of_traits(Textbook_traits(), frame));
    append_rows(rows, row, region_figures_of_traits(Textbook_traits(), frame), frame.p0, exact);
    row.formula = "stable";
    row.outside = outside(boundary_of_traits(Stable_traits(), frame));
    append_rows(rows, row, region_figures_of_traits(Stable_traits(), frame_at_origin(frame.shape)), Xy<double>{},
                exact);
  }

  template <class Traits>
  [[nodiscard]] static Region_boundary_2<double> boundary_of_traits(const Traits& traits,
                                                                    const Chord_frame_2<double>& frame) {
    return traits.construct_region_boundary_2_object()(traits.construct_bounding_region_2_object()(frame));
  }
  template <class T> [[nodiscard]] double outside(const Region_boundary_2<T>& boundary) const {
    return (std::min)(outside_bound(spiral, t0, t1, boundary), (std::numeric_limits<double>::max)());
  }

  template <template <class, class> class Traits, class Stable, class Textbook> void measure_method(Region_form form) {
    const std::optional<Exact_figures> exact = exact_figures<Stable>(shape);
    if (!exact || exact->form != form) return;
    measure_formulas<Stable, Textbook, float>("float", *exact);
    measure_formulas<Stable, Textbook, double>("double", *exact);
    measure_formulas<Stable, Textbook, long double>("long-double", *exact);
    measure_traits<Traits<Filtered_circular_kernel, Stable>, Traits<Filtered_circular_kernel, Textbook>>(*exact);
  }
};

/// Whether double has normal numbers for the small differences behind bilens and spiral fat arcs.
[[nodiscard]] static bool has_normal_differences(const Chord_shape_2<CGAL::Exact_rational>& f) {
  const CGAL::Exact_rational least((std::numeric_limits<double>::min)());
  for (const CGAL::Exact_rational* x : {&f.square_change, &f.sine_change, &f.kneser0, &f.kneser1})
    if (*x != 0 && absolute(*x) < least) return false;
  return true;
}

}  // namespace study

std::vector<Stability_row> stability_rows(const Bezier_spiral_2<double>& spiral, double t0, double t1) {
  study::Stability_measurement study{spiral, t0, t1, spiral.shape<CGAL::Exact_rational>(t0, t1), {}};
  if (dot(study.shape.chord, study.shape.chord) == 0) return {};
  study.measure_method<Bca_traits_2, Bca, Textbook_bca>(Region_form::BCA);
  if (!study.shape.proper || !study::has_normal_differences(study.shape)) return study.rows;
  study.measure_method<Spiral_fat_arc_traits_2, Spiral_fat_arc, Textbook_spiral_fat_arc>(Region_form::SPIRAL_FAT_ARC);
  study.measure_method<Bilens_traits_2, Bilens, Textbook_bilens>(Region_form::BILENS);
  return study.rows;
}

}  // namespace CGAL::Bounding_arcs

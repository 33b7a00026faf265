// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spiral segments side by side, a lane of a register each: where segments have few pieces, one piece of each of eight
// segments fills the registers that eight pieces of one segment would leave empty.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_CURVE_LANES_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_CURVE_LANES_H

#include <CGAL/Bounding_arcs_2/number/always_inline.h>
#include <CGAL/Bounding_arcs_2/spiral/Local_curve.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Batch_bounds.h>

#include <cstddef>

namespace CGAL::Bounding_arcs::filter {

/// Segments side by side: doubles that fill a register of the widest set.
inline constexpr std::size_t LANES = BATCH_ALIGNMENT / sizeof(double);

/// One double of each segment.
struct alignas(BATCH_ALIGNMENT) Lane_column {
  double of[LANES];
};

/// The local curves of eight segments of one kind. All lanes are to be set: calculations run in all of them.
struct Curve_lanes {
  Lane_column x[MAX_LOCAL_DEGREE + 1], y[MAX_LOCAL_DEGREE + 1], w[MAX_RATIONAL_DEGREE + 1], across[4], change[2];
  Lane_column unit, numerator_error, least_dot, least_square, kneser_error, turn_rate_error, least_turn_rate,
      least_tangent;
  Lane_column middle, half, direction, mirror;

  /// \pre curve.kind == KIND
  template <int KIND> void set(std::size_t lane, const Local_curve& curve) {
    const Local_form<double>& form = curve.form;
    exchange<KIND>(lane, form, *this, [](const double& number, double& stored) { stored = number; });
    middle.of[lane] = curve.middle;
    half.of[lane] = curve.half;
    direction.of[lane] = curve.direction;
    mirror.of[lane] = curve.mirror;
  }
  /// The form of a lane; in loops over lanes it stays in registers.
  template <int KIND> [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Local_form<double> form(std::size_t lane) const {
    Local_form<double> f;
    exchange<KIND>(lane, f, *this, [](double& number, const double& stored) { number = stored; });
    if constexpr (is_rational_kind(KIND)) {
      f.coefficients.x[0] = f.coefficients.y[0] = 0;
      f.coefficients.w[0] = 1;
    }
    return f;
  }

 private:
  // Calls copy with every number that a kind has and its place in a lane.
  template <int KIND, class Form, class Lanes, class Copy>
  CGAL_BOUNDING_ARCS_INLINE static void exchange(std::size_t lane, Form& form, Lanes& lanes, const Copy& copy) {
    auto& c = form.coefficients;
    for (int k = 1; k <= degree_of_kind(KIND); ++k) {
      copy(c.x[k], lanes.x[k].of[lane]);
      copy(c.y[k], lanes.y[k].of[lane]);
      if constexpr (is_rational_kind(KIND)) copy(c.w[k], lanes.w[k].of[lane]);
    }
    if constexpr (KIND == 3) {
      for (int k = 0; k < 4; ++k) copy(c.across[k], lanes.across[k].of[lane]);
      for (int k = 0; k < 2; ++k) copy(c.change[k], lanes.change[k].of[lane]);
    }
    copy(form.unit, lanes.unit.of[lane]);
    copy(form.numerator_error, lanes.numerator_error.of[lane]);
    copy(form.least_dot, lanes.least_dot.of[lane]);
    copy(form.least_square, lanes.least_square.of[lane]);
    copy(form.kneser_error, lanes.kneser_error.of[lane]);
    copy(form.turn_rate_error, lanes.turn_rate_error.of[lane]);
    copy(form.least_turn_rate, lanes.least_turn_rate.of[lane]);
    copy(form.least_tangent, lanes.least_tangent.of[lane]);
  }
};

/// Puts segments side by side, those of one kind that follow each other.
/// \param serves serves(i) tells whether segment i is asked for
/// \param set set(lane, i) sets what is asked of it beside its curve
/// \param ask ask(kind, places, size) is called for segments places[0], ..., places[size - 1] in the first lanes; the
///   others repeat the first one
template <class Spiral, class Serves, class Set, class Ask>
void for_lanes(const Spiral* first, std::size_t count, Curve_lanes& curves, const Serves& serves, const Set& set,
               const Ask& ask) {
  std::size_t places[LANES], size = 0;
  int kind = 0;
  const auto put = [&](std::size_t lane, std::size_t i, const Local_curve& curve) {
    for_kind(curve.kind, [&](auto of_kind) { curves.template set<of_kind()>(lane, curve); });
    set(lane, i);
  };
  const auto ask_all = [&] {
    for (std::size_t lane = size; lane < LANES; ++lane) put(lane, places[0], first[places[0]].local_curve());
    ask(kind, places, size);
    size = 0;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Local_curve curve = first[i].local_curve();
    if (curve.kind == 0 || !serves(i)) continue;
    if (size > 0 && (size == LANES || curve.kind != kind)) ask_all();
    kind = curve.kind;
    places[size] = i;
    put(size++, i, curve);
  }
  if (size > 0) ask_all();
}

}  // namespace CGAL::Bounding_arcs::filter

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Formulas of the chord frame, recorded. Their steps have the names of doc/error_bounds.md.

#ifndef BOUNDING_ARCS_TEST_FRAME_FORMULAS_H
#define BOUNDING_ARCS_TEST_FRAME_FORMULAS_H

#include "Recorded.h"

#include <CGAL/Bounding_arcs_2/frame/accurate_shape.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/Bounding_arcs_2/region/Bilens.h>

#include <map>
#include <string>
#include <vector>

namespace bounding_arcs_test {

using namespace CGAL::Bounding_arcs;
using Recorded_shape = Chord_shape_2<Recorded>;

/// The shape of the parabola (t, t^2 / 2) on [1/8, 1/2]: a spiral that turns left and has its tight end first.
inline Recorded_shape recorded_shape(Recording& recording) {
  const auto jet = [](double t) { return End_jet_2<double>{{t, t * t / 2}, {1, t}, {0, 1}}; };
  const Chord_shape_2<double> f = chord_frame(jet(0.125), jet(0.5)).shape;
  const auto number = [&](const std::string& name, double x) { return Recorded(recording, name, x, false); };
  const auto vector = [&](const std::string& name, const Xy<double>& v) {
    return Xy<Recorded>{number(name + "_x", v.x), number(name + "_y", v.y)};
  };
  Recorded_shape g;
  g.chord = vector("chord", f.chord);
  g.tangent0 = vector("tangent0", f.tangent0);
  g.tangent1 = vector("tangent1", f.tangent1);
  g.cross0 = number("cross0", f.cross0);
  g.cross1 = number("cross1", f.cross1);
  g.square_change = number("square_change", f.square_change);
  g.sine_change = number("sine_change", f.sine_change);
  g.curvature0 = number("curvature0", f.curvature0);
  g.curvature1 = number("curvature1", f.curvature1);
  g.kneser0 = number("kneser0", f.kneser0);
  g.kneser1 = number("kneser1", f.kneser1);
  g.unit = number("unit", f.unit);
  g.turn = f.turn;
  g.turns_one_way = f.turns_one_way;
  g.runs_ahead = f.runs_ahead;
  g.tight_first = f.tight_first;
  g.proper = f.proper;
  return g;
}

/// What a member of a chord shape is off by, in parts of itself: half an ulp, and what is_accurate() leaves beside it.
inline const std::string INPUT_ERROR = std::to_string(1 + ENOUGH / HALF_ULP) + "u";

/// Names the steps of lengths and half-angle tangents.
inline Recorded_shape named_shape(Recording& recording) {
  const Recorded_shape f = recorded_shape(recording);
  const auto length = [&](const std::string& end, const Xy<Recorded>& v) {
    recording.call((v.x * v.x).name(), "square_x" + end);
    recording.call(dot(v, v).name(), "square" + end);
    return square_root(dot(v, v));
  };
  const Recorded c = length("_c", f.chord);
  recording.call(c.name(), "c");
  for (const std::string end : {"0", "1"}) {
    const Xy<Recorded>& t = end == "0" ? f.tangent0 : f.tangent1;
    const Recorded n = length(end, t), ahead = dot(t, f.chord), d = n * c + ahead;
    recording.call(n.name(), "n" + end);
    recording.call((t.x * f.chord.x).name(), "ahead_x" + end);
    recording.call((t.y * f.chord.y).name(), "ahead_y" + end);
    recording.call(ahead.name(), "ahead" + end);
    recording.call((n * c).name(), "nc" + end);
    recording.call(d.name(), "d" + end);
    recording.call(((end == "0" ? f.cross0 : f.cross1) / d).name(), "bulge" + end);
  }
  return f;
}

inline Recorded_results lengths(Recording& recording) {
  const auto g = named_shape(recording).angles();
  return {g.length0, g.length1, g.chord};
}
inline Recorded_results bulges(Recording& recording) {
  const auto g = named_shape(recording).angles();
  return {g.bulge0, g.bulge1};
}
/// A d1 - B d0, with names for the terms of its sums.
inline Recorded_results change(Recording& recording) {
  const Recorded_shape f = named_shape(recording);
  const auto g = f.angles();
  const Recorded first = f.cross0 * g.length1, second = f.cross1 * g.length0;
  recording.call(first.name(), "first");
  recording.call((first + second).name(), "both");
  recording.call((f.cross0 + f.cross1).name(), "crosses");
  recording.call((g.chord * f.square_change * ((f.cross0 + f.cross1) / (first + second))).name(), "of_squares");
  const Recorded result = f.bulge_change(g.length0, g.length1, g.chord);
  recording.call(result.name(), "change");
  return {result};
}
inline Recorded_results bca_thickness(Recording& recording) {
  change(recording);
  const Recorded result = Bca::thickness(recorded_shape(recording));
  recording.call(result.name(), "thickness");
  return {result};
}
/// The center of the arc that touches at the start, from there, and the square of its radius.
inline Recorded_results bca_circle(Recording& recording) {
  Chord_frame_2<Recorded> frame;
  frame.shape = named_shape(recording);
  const Contact_circle_2<Recorded> circle = Bca::boundary(frame).outer[0].support;
  const Xy<Recorded> center = circle.center();
  recording.call(center.x.name(), "center_x");
  recording.call(center.y.name(), "center_y");
  recording.call(circle.squared_radius().name(), "squared_radius");
  return {center.x, center.y, circle.squared_radius()};
}
/// Names the scalars of the tight frame.
inline Tight_frame_2<Recorded> named_tight_frame(Recording& recording) {
  change(recording);
  const Tight_frame_2<Recorded> t = tight_frame(recorded_shape(recording));
  const std::map<std::string, Recorded> members{{"sin_tight", t.sin_tight},
                                                {"cos_tight", t.cos_tight},
                                                {"sin_delta", t.sin_delta},
                                                {"cos_delta", t.cos_delta},
                                                {"cos_mean", t.cos_mean},
                                                {"k_tight", t.k_tight},
                                                {"k_flat", t.k_flat},
                                                {"a", t.a},
                                                {"b", t.b},
                                                {"width", t.chord},
                                                {"sin_difference", t.sin_difference}};
  for (const auto& [name, step] : members) recording.call(step.name(), name);
  return t;
}
inline Recorded_results half_angles(Recording& recording) {
  const auto t = named_tight_frame(recording);
  const Recorded b = recorded_shape(recording).angles().bulge0;
  recording.call((b * b).name(), "square_b");
  recording.call((1 + b * b).name(), "below");
  recording.call((1 - b * b).name(), "above");
  return {t.sin_tight, t.cos_tight};
}
/// The sine of half the difference of the angles.
inline Recorded_results sin_delta(Recording& recording) { return {named_tight_frame(recording).sin_delta}; }
inline Recorded_results tight_bends(Recording& recording) {
  const auto t = named_tight_frame(recording);
  return {t.k_tight, t.k_flat, t.a, t.b, t.sin_difference};
}
/// Names the parameters of a bilens.
inline Tight_frame_2<Recorded> named_bilens(Recording& recording) {
  const auto t = named_tight_frame(recording);
  const Recorded ratio_a = t.sin_delta / t.a, ratio_b = t.sin_delta / t.b;
  recording.call(ratio_a.name(), "ratio_a");
  recording.call(ratio_b.name(), "ratio_b");
  recording.call((ratio_a * ratio_b).name(), "ratios");
  recording.call((t.sin_tight + t.sin_delta * ratio_b).name(), "contact_tight");
  recording.call(t.contact_flat().name(), "contact_flat");
  return t;
}
/// The contact circle at a bilens' tight end: center as seen from there, and curvature; K of the one at its flat end.
inline Recorded_results bilens_circle(Recording& recording) {
  const auto t = named_bilens(recording);
  Chord_frame_2<Recorded> frame;
  frame.shape = recorded_shape(recording);
  const Contact_circle_2<Recorded> circle = Bilens::boundary(frame).outer[0].support;
  recording.call(circle.center().x.name(), "lens_center_x");
  recording.call(circle.center().y.name(), "lens_center_y");
  recording.call(circle.curvature.name(), "lens_curvature");
  return {circle.center().x, circle.center().y, circle.curvature, t.contact_flat()};
}
inline Recorded_results bilens_thickness(Recording& recording) {
  const auto t = named_bilens(recording);
  const Recorded ratio_a = t.sin_delta / t.a, ratio_b = t.sin_delta / t.b;
  const Recorded slope = 2 * t.cos_mean + ratio_a, change = slope + ratio_b, square = change * change;
  const Recorded contact = t.sin_tight + t.sin_delta * ratio_b, room = 4 * (1 - ratio_a * ratio_b);
  const Recorded radicand = square + contact * t.contact_flat() * room, root = sqrt(radicand);
  const Recorded result = Bilens::thickness(recorded_shape(recording));
  recording.call((1 - ratio_a * ratio_b).name(), "part");
  recording.call(radicand.name(), "radicand");
  recording.call(root.name(), "root");
  recording.call((change + root).name(), "divisor");
  recording.call((2 * t.cos_mean).name(), "cosines");
  recording.call(slope.name(), "slope");
  recording.call(change.name(), "lens_change");
  recording.call(square.name(), "lens_square");
  recording.call(result.name(), "bilens_thickness");
  return {result};
}

}  // namespace bounding_arcs_test

#endif

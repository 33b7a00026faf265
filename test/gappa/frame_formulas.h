// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Formulas of the chord frame, recorded. Their steps have the names of doc/error_bounds.md.

#ifndef BOUNDING_ARCS_TEST_FRAME_FORMULAS_H
#define BOUNDING_ARCS_TEST_FRAME_FORMULAS_H

#include "Recorded.h"

#include <CGAL/Bounding_arcs_2/region/Bca.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace bounding_arcs_test {

using namespace CGAL::Bounding_arcs;
using Recorded_shape = Chord_shape_2<Recorded>;
using Recorded_results = std::vector<Recorded>;

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

/// Names the steps of lengths and half-angle tangents.
inline void name_steps(Recording& recording, const Recorded_shape& f) {
  const auto square = [&](const std::string& end, const Xy<Recorded>& v) {
    recording.call((v.x * v.x).name(), "square_x" + end);
    recording.call((v.y * v.y).name(), "square_y" + end);
    recording.call(dot(v, v).name(), "square" + end);
    return square_root(dot(v, v));
  };
  const Recorded c = square("_c", f.chord);
  recording.call(c.name(), "c");
  for (const std::string end : {"0", "1"}) {
    const Xy<Recorded>& t = end == "0" ? f.tangent0 : f.tangent1;
    const Recorded n = square(end, t), ahead = dot(t, f.chord);
    recording.call(n.name(), "n" + end);
    recording.call((t.x * f.chord.x).name(), "ahead_x" + end);
    recording.call((t.y * f.chord.y).name(), "ahead_y" + end);
    recording.call(ahead.name(), "ahead" + end);
    recording.call((n * c).name(), "nc" + end);
    recording.call((n * c + ahead).name(), "d" + end);
    recording.call(((end == "0" ? f.cross0 : f.cross1) / (n * c + ahead)).name(), "bulge" + end);
  }
}

inline Recorded_results lengths(const Recorded_shape& f) {
  const auto g = chord_angles(f);
  return {g.length0, g.length1, g.chord};
}
inline Recorded_results bulges(const Recorded_shape& f) {
  const auto g = chord_angles(f);
  return {g.bulge0, g.bulge1};
}

}  // namespace bounding_arcs_test

#endif

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Formulas of arcs and of cubic samples, recorded. Their inputs are doubles as they are.

#ifndef BOUNDING_ARCS_TEST_ARC_FORMULAS_H
#define BOUNDING_ARCS_TEST_ARC_FORMULAS_H

#include "Recorded.h"

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bezier_evaluator.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

inline CGAL::Bounding_arcs::Xy<Recorded> exact_input(Recording& recording, const std::string& name, double x,
                                                     double y) {
  return {Recorded(recording, name + "_x", x, true), Recorded(recording, name + "_y", y, true)};
}

/// The curvature of an arc with the bulge 1/4.
inline Recorded_results arc_curvature(Recording& recording) {
  const auto chord = exact_input(recording, "to", 2, 1) - exact_input(recording, "from", 0.5, 0.25);
  const Recorded bulge(recording, "bulge", 0.25, true);
  recording.call((chord.x * chord.x).name(), "square_x");
  recording.call(dot(chord, chord).name(), "square");
  recording.call((bulge * bulge).name(), "square_b");
  recording.call((1 + bulge * bulge).name(), "below");
  const Recorded result = CGAL::Bounding_arcs::curvature(chord, bulge);
  recording.call(result.name(), "curvature");
  return {result};
}

/// The distance of a point from an arc with the bulge 1/4 that has its foot on the arc; names are those of Arc_2.h.
inline Recorded_results arc_distance(Recording& recording) {
  const auto from = exact_input(recording, "from", 0, 0), to = exact_input(recording, "to", 2, 1),
             q = exact_input(recording, "q", 1, 0.75);
  const Recorded b(recording, "b", 0.25, true), m = 1 - b * b, twice = 2 * b;
  const auto v = CGAL::Bounding_arcs::view(q, from, to, b);
  const auto chord = to - from, sum = v.u0 + v.u1;
  const Recorded across = cross(chord, v.u0), product = dot(v.u0, v.u1), longer = (1 + b * b) * v.chord;
  const Recorded distance = CGAL::Bounding_arcs::distance_to_circle(v, v.apart, b);
  const std::vector<std::pair<std::string, Recorded>> steps{{"m", m},
                                                            {"perp0", -chord.y},
                                                            {"perp1", chord.x},
                                                            {"from0", v.u0.x},
                                                            {"from1", v.u0.y},
                                                            {"to0", v.u1.x},
                                                            {"to1", v.u1.y},
                                                            {"sum0", sum.x},
                                                            {"sum1", sum.y},
                                                            {"turn0", twice * sum.x},
                                                            {"turn1", twice * sum.y},
                                                            {"lean0", m * -chord.y},
                                                            {"lean1", m * chord.x},
                                                            {"w0", v.w.x},
                                                            {"w1", v.w.y},
                                                            {"w_square0", v.w.x * v.w.x},
                                                            {"w_square", dot(v.w, v.w)},
                                                            {"apart", v.apart},
                                                            {"across_1", chord.x * v.u0.y},
                                                            {"across_2", chord.y * v.u0.x},
                                                            {"across", across},
                                                            {"product_x", v.u0.x * v.u1.x},
                                                            {"product_y", v.u0.y * v.u1.y},
                                                            {"product", product},
                                                            {"side_1", m * across},
                                                            {"side_2", twice * product},
                                                            {"side", v.side},
                                                            {"length_square0", chord.x * chord.x},
                                                            {"length_square", dot(chord, chord)},
                                                            {"length", v.chord},
                                                            {"longer", longer},
                                                            {"below", longer + v.apart},
                                                            {"distance", distance}};
  for (const auto& [name, step] : steps) recording.call(step.name(), name);
  if (v.nearest_end >= 0) throw std::logic_error("the foot is to be on the arc");
  return {distance};
}

/// A coordinate of a cubic's point and of its derivatives.
inline Recorded_results cubic_sample(Recording& recording) {
  const CGAL::Bounding_arcs::Xy<Recorded> points[4] = {
      exact_input(recording, "p0", 0, 1), exact_input(recording, "p1", 0.5, 1.5), exact_input(recording, "p2", 1, 1.25),
      exact_input(recording, "p3", 1.75, 0.5)};
  const Recorded t(recording, "t", 0.375, true), s = 1 - t;
  recording.call(s.name(), "s");
  CGAL::Bounding_arcs::Xy<Recorded> b[3];
  for (int i = 0; i < 3; ++i) {
    b[i] = CGAL::Bounding_arcs::Bezier_evaluator::blend(s, points[i], t, points[i + 1]);
    recording.call(b[i].x.name(), "b" + std::to_string(i));
    if (i > 0)
      recording.call(CGAL::Bounding_arcs::Bezier_evaluator::blend(s, b[i - 1], t, b[i]).x.name(),
                     "c" + std::to_string(i));
  }
  const auto jet = CGAL::Bounding_arcs::Bezier_evaluator::cubic_jet(points, t);
  recording.call(jet.point.x.name(), "point");
  recording.call(jet.first.x.name(), "first");
  recording.call(jet.second.x.name(), "second");
  return {jet.point.x, jet.first.x, jet.second.x};
}

}  // namespace bounding_arcs_test

#endif

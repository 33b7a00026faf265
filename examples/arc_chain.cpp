// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve as few circular arcs, for CAD and machines: with common tangents, or only meeting, or all on one side.

#include <CGAL/Bounding_arcs_2.h>

#include <cstdio>

using namespace CGAL::Bounding_arcs;

int main() {
  const Bezier_curve_2<double> curve({{0, 0.6}, {6.4, 3}, {-2.4, 3.4}, {3, 0}});
  const Bounding_arc_tree_2 tree(curve);
  const auto report = [&](const char* what, const Arc_chain::Options& options) {
    const double eps = 1e-3;
    const Arc_chain chain = arc_chain(tree, eps, options);
    std::printf("%s: %zu arcs, %s\n", what, chain.arcs.size(),
                chain.error <= eps ? "none farther off than 0.001" : "eps was not reached");
    return chain;
  };
  report("common tangents", {Arc_chain::Continuity::TANGENT, Arc_chain::Side::BOTH});
  report("left of the curve", {Arc_chain::Continuity::TANGENT, Arc_chain::Side::LEFT});
  const Arc_chain chain = report("only meeting", {Arc_chain::Continuity::POSITION, Arc_chain::Side::BOTH});
  const Arc_chain::Arc& first = chain.arcs.front();
  std::printf("the first from (%.3f, %.3f) to (%.3f, %.3f), radius %.3f, %s\n", first.from.x, first.from.y, first.to.x,
              first.to.y, radius(first), first.bulge > 0 ? "counterclockwise" : "clockwise");
}

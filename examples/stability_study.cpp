// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A stability study of one's own family of curves: quarters of ellipses that get flatter and flatter.
// How many decimal digits of the thickness are right, by the paper's steps and by this library's formulas?

#include <CGAL/Bounding_arcs_2/study/Stability_study.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace CGAL::Bounding_arcs;

// The digits that a relative error leaves. Those beyond the 14th depend on rounding by chance.
int digits(double relative_error) { return std::clamp(static_cast<int>(-std::log10(relative_error + 1e-300)), 0, 14); }

int main() {
  std::printf("%-6s %-9s %8s %8s\n", "height", "method", "textbook", "stable");
  for (const double height : {1e-1, 1e-3, 1e-6, 1e-9}) {
    // a part of the quarter that ends in no vertex
    const Bezier_curve_2<double> ellipse({{1, 0}, {1, height}, {0, height}}, {1, 1, 2});
    const Bezier_spiral_2<double> spiral = spiral_segments(ellipse).front();
    const auto rows = stability_rows(spiral, 0.25 * spiral.last(), 0.5 * spiral.last());
    for (const char* method : {"bca", "sfa", "bilens"}) {
      int textbook = 0, stable = 0;
      for (const Stability_row& row : rows) {
        if (row.kernel != "double" || row.quantity != "thickness" || row.method != method) continue;
        (row.formula == "stable" ? stable : textbook) = digits(row.rel_error);
      }
      std::printf("%-6g %-9s %8d %8d\n", height, method, textbook, stable);
    }
  }
}

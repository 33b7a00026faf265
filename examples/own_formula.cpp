// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A stability study of one's own formulas, on a family of one's own: how many digits of the height of an arc over its
// chord are right, as schoolbooks have it from the radius, and without their difference of two lengths? The study runs
// the same formulas in enclosures to know. With an argument it writes its rows to that file, for plot_study.py.

#include <CGAL/Bounding_arcs_2/study/Formula_study.h>
#include <CGAL/Bounding_arcs_2/study/Randomly_rounded.h>

#include <cmath>
#include <cstdio>
#include <fstream>

using namespace CGAL::Bounding_arcs;

// Of the circle that touches the curve at its start, with half the chord c and the radius r.
template <bool IS_STABLE> struct Height {
  template <class NT> Named_figures<NT> operator()(const Formula_piece<NT>& piece) const {
    const Chord_shape_2<NT>& f = piece.shape;
    const NT c = square_root(dot(f.chord, f.chord)) / NT(2), sine = absolute(f.cross0) / NT(2) / c;
    const NT r = c / sine * square_root(dot(f.tangent0, f.tangent0)), root = square_root(NT(r * r - c * c));
    const NT height = IS_STABLE ? NT(c * c / (r + root)) : NT(r - root);
    return {{"height", NT(f.unit * height)}};
  }
};

std::vector<Study_piece> flat_parabolas() {
  std::vector<Study_piece> pieces;
  for (int exponent = 0; exponent <= 12; ++exponent) {
    const double delta = std::pow(10.0, -exponent);
    add_placed(pieces, "flat parabolas", delta, Bezier_curve_2<double>({{0, 0}, {1, delta}, {2, 3 * delta}}));
  }
  return pieces;
}

template <class Formula> std::vector<Stability_row> studied(const char* name, const Formula& formula) {
  Formula_study<Formula> study(name, formula, flat_parabolas());
  study.template add<double>("double");
  study.template add<__float128>("quad");
  study.template add<Randomly_rounded>("random");
  Worst_case_hunt hunt = study.template hunt<double>("double", 1);
  while (hunt.steps() < 500) hunt.step();
  const Stability_row worst = study.with_conditions(hunt.worst().rows()).front();
  std::printf("%-7s worst found: %.0e units roundoff times the condition number\n", name,
              worst.rel_error / (0x1p-53 * worst.condition.value_or(1)));
  return study.with_conditions(study.rows());
}

int main(int argc, char** argv) {
  std::vector<Stability_row> rows = studied("school", Height<false>());
  for (const Stability_row& row : studied("stable", Height<true>())) rows.push_back(row);
  for (const Stability_row& row : rows)
    if (row.kernel == "double" && (row.delta == 1 || row.delta == 1e-4))
      std::printf("%-7s delta %-6g %2.0f digits, condition %.0f\n", row.method.c_str(), row.delta,
                  -std::log10(row.rel_error), row.condition.value_or(0));
  if (argc > 1) {
    std::ofstream file(argv[1]);
    write_csv(file, rows);
  }
}

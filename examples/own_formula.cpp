// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A stability study of one's own formula and of one's own number type: how many digits of the height of an arc are
// right, as schoolbooks have it from radius and chord?  The study runs the same formula in enclosures to know.

#include <CGAL/Bounding_arcs_2/study/Formula_study.h>
#include <CGAL/Bounding_arcs_2/study/Randomly_rounded.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <cstdio>

using namespace CGAL::Bounding_arcs;

struct Height {
  template <class NT> Named_figures<NT> operator()(const Formula_piece<NT>& piece) const {
    const Chord_shape_2<NT>& f = piece.shape;
    const NT c = square_root(dot(f.chord, f.chord)) / NT(2), sine = absolute(f.cross0) / NT(2) / c;
    const NT r = c / sine * square_root(dot(f.tangent0, f.tangent0));  // of the circle that touches at the start
    return {{"height", NT(f.unit * (r - square_root(NT(r * r - c * c))))}};
  }
};

// Numbers of five decimal digits.
using Short = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<5>, boost::multiprecision::et_off>;

int main() {
  Formula_study<Height> study("school", Height(), subdivision_family());
  study.add<Short>("short");
  study.add<double>("double");
  study.add<Randomly_rounded>("random");
  for (const Stability_row& row : study.rows())
    if (row.delta == 1.0 / 16)
      std::printf("%-7s %-18s %2d digits\n", row.kernel.c_str(), row.quantity.c_str(),
                  static_cast<int>(-std::log10(row.rel_error)));
}

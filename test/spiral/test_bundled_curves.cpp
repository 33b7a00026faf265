// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of spiral segments of the bundled curves, counted exactly elsewhere, from Bezier pieces made in double
// and in rational arithmetic.

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

namespace test_bundled_curves {
namespace {

using namespace CGAL::Bounding_arcs;
using Counts = std::map<std::string, std::size_t>;

template <class NT> std::size_t number_of_spirals(const Curve_record& record) {
  std::size_t count = 0;
  for (const Bezier_curve_2<NT>& piece : record.bezier_pieces<NT>())
    count += spiral_parameters(piece).breaks.size() + 1;
  return count;
}

template <class NT> Counts counts_in(const std::string& directory) {
  Counts counts;
  for (const auto& file : std::filesystem::directory_iterator(directory))
    if (file.path().extension() == ".json")
      for (const Curve_record& record : read_curve_file(file.path().string()).curves)
        counts[record.name] = number_of_spirals<NT>(record);
  return counts;
}

template <class NT> class BundledCurves : public testing::Test {};
using Number_types = testing::Types<double, CGAL::Exact_rational>;
TYPED_TEST_SUITE(BundledCurves, Number_types);

TYPED_TEST(BundledCurves, HaveTheKnownNumbersOfSpirals) {
  const Counts known{{"a_wrench", 75}, {"b_angelfish", 85}, {"c_letter_K", 105}, {"d_rabbit", 116},
                     {"e_cat", 120},   {"f_crow", 132},     {"g_chipmunk", 170}, {"h_maple_leaf", 182}};
  EXPECT_EQ(counts_in<TypeParam>(BOUNDING_ARCS_EXAMPLE_DATA), known);
}

// Three control points of the hook lie on a line, so that curvature touches zero on a knot; rounding of the Bezier
// control points makes it change sign beside the knot.
TYPED_TEST(BundledCurves, OfNurbsHaveTheKnownNumbersOfSpirals) {
  const Counts known{{"circle", 4},
                     {"circle_rounded_weights", 8},
                     {"cubic_hook_double_knot", 21},
                     {"cubic_teardrop", 20},
                     {"cubic_wave", 20},
                     {"ellipse", 8},
                     {"hyperbola_arc", 2}};
  EXPECT_EQ(counts_in<TypeParam>(std::string(BOUNDING_ARCS_TEST_DATA) + "/nurbs"), known);
}

}  // namespace
}  // namespace test_bundled_curves

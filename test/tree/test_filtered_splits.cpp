// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// On the bundled curves and on random spirals of all sizes and places, hierarchies whose decisions are filtered are
// split where those in exact arithmetic are, and hardly a decision needs more than doubles.

#include "cases.h"
#include "trees.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/study/stability_families.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test_filtered_splits {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
using Rational = Circular<CGAL::Simple_cartesian<CGAL::Exact_rational>>;
using Roots = Circular<CGAL::Simple_cartesian<CORE::Expr>>;

// Whether a tree is split at each node, in the order of traversal.
template <class Tree> std::vector<bool> splits(const Tree& tree) {
  EXPECT_EQ(tree.status(), Build_status::COMPLETE);
  std::vector<bool> split;
  tree.traverse([&](const auto& h) {
    if (h.is_region) split.push_back(!tree.is_leaf(h));
    return true;
  });
  return split;
}

std::vector<Bezier_curve_2<double>> bundled_curves() {
  std::vector<Bezier_curve_2<double>> curves;
  for (const auto& entry : std::filesystem::directory_iterator(BOUNDING_ARCS_EXAMPLE_DATA))
    if (entry.path().extension() == ".json")
      for (const auto& record : read_curve_file(entry.path().string()).curves)
        for (const auto& piece : record.bezier_pieces<double>()) curves.push_back(piece);
  return curves;
}

template <class NT> std::vector<Bezier_spiral_2<NT>> all_spirals(const std::vector<Bezier_curve_2<double>>& curves) {
  std::vector<Bezier_spiral_2<NT>> spirals;
  for (const auto& curve : curves)
    for (auto& s : spiral_segments(curve.over<NT>())) spirals.push_back(std::move(s));
  return spirals;
}

// Found once for all methods and tolerances.
struct Spirals {
  explicit Spirals(const std::vector<Bezier_curve_2<double>>& curves)
      : rounded(all_spirals<double>(curves)), exact(all_spirals<CGAL::Exact_rational>(curves)) {}

  std::vector<Spiral> rounded;
  std::vector<Bezier_spiral_2<CGAL::Exact_rational>> exact;
};

struct Method {
  std::size_t decisions = 0, failures = 0;

  template <class FilteredTraits, class ExactTraits> void expect_same_splits(const Spirals& spirals, double eps) {
    const Region_hierarchy_2<FilteredTraits, Spiral> filtered(spirals.rounded, eps);
    const Region_hierarchy_2<ExactTraits, Bezier_spiral_2<CGAL::Exact_rational>> exact(spirals.exact, eps);
    EXPECT_EQ(splits(filtered), splits(exact)) << "eps " << eps;
    decisions += filtered.decisions().all();
    failures += filtered.decisions().exact;
  }
};

template <class Compare> void expect_same_splits_of_all(const Compare& compare) {
  Method bca, sfa, bilens;
  compare([&](const Spirals& spirals, double eps) {
    bca.expect_same_splits<Bca_traits_2<Filtered>, Bca_traits_2<Rational>>(spirals, eps);
    sfa.expect_same_splits<Spiral_fat_arc_traits_2<Filtered>, Spiral_fat_arc_traits_2<Rational>>(spirals, eps);
    bilens.expect_same_splits<Bilens_traits_2<Filtered>, Bilens_traits_2<Roots>>(spirals, eps);
  });
  for (const auto& [name, method] : {std::pair("bca", bca), std::pair("sfa", sfa), std::pair("bilens", bilens)}) {
    EXPECT_GT(method.decisions, 0u);
    EXPECT_LT(1000 * method.failures, method.decisions) << name;
    ::testing::Test::RecordProperty(name, std::to_string(method.failures) + " of " + std::to_string(method.decisions));
    std::printf("%s: %zu of %zu decisions took exact arithmetic\n", name, method.failures, method.decisions);
  }
}

TEST(FilteredSplits, AreTheExactOnesOnBundledCurves) {
  const std::vector<Bezier_curve_2<double>> curves = bundled_curves();
  ASSERT_EQ(curves.size(), 378u);
  const Spirals spirals(curves);
  expect_same_splits_of_all([&](const auto& compare) {
    for (const double eps : {1e-3, 1e-6, 1e-8})
      if (eps > 1e-8 || cases(1) > 1) compare(spirals, eps);
  });
}

TEST(FilteredSplits, AreTheExactOnesOnRandomSpirals) {
  constexpr unsigned SEED = 502;
  std::mt19937 random(SEED);
  std::uniform_real_distribution<double> scale(-12, 12), size_of_move(-8, 8);
  expect_same_splits_of_all([&](const auto& compare) {
    for (int i = 0; i < 15; ++i) {
      const Bezier_curve_2<double> base = random_curve(random);
      const double s = std::pow(10.0, scale(random)), move = s * std::pow(10.0, size_of_move(random));
      std::vector<Xy<double>> points;
      for (const Xy<double>& p : base.control_points()) points.push_back({s * p.x + move, s * p.y - move});
      SCOPED_TRACE("seed 502, curve " + std::to_string(i));
      compare(Spirals({Bezier_curve_2<double>(points, base.weights())}), s * 1e-4);
    }
  });
}

}  // namespace
}  // namespace test_filtered_splits

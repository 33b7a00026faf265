// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains of offsets do not cross, exactly: with rational circles through their ends, by a sweep over them.
// Usage: test_simple_offsets [FILE...]; files are asked for at d = +-0.01, +-0.05, +-0.2 of their size, instead of the
// tests' own, and the number of failures is what is returned.

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>

#include <CGAL/Arr_circle_segment_traits_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_sweep_2_algorithms.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace {

namespace ba = CGAL::Bounding_arcs;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Arr_circle_segment_traits_2<Exact>;

// The circle of an arc: its centre is the middle of the chord and (1 - b^2) / (4 b) chords to the left.
Traits::Curve_2 exact_curve(const ba::Arc_2& arc) {
  const Exact::Point_2 from(arc.from.x, arc.from.y), to(arc.to.x, arc.to.y);
  if (arc.bulge == 0) return Traits::Curve_2(Exact::Segment_2(from, to));
  const Exact::FT b(arc.bulge);
  const Exact::Vector_2 chord = to - from, left(-chord.y(), chord.x());
  const Exact::Point_2 centre = CGAL::midpoint(from, to) + ((1 - b * b) / (4 * b)) * left;
  const auto turn = arc.bulge > 0 ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE;
  return Traits::Curve_2(Exact::Circle_2(centre, CGAL::squared_distance(centre, from), turn),
                         Traits::Point_2(from.x(), from.y()), Traits::Point_2(to.x(), to.y()));
}

template <class Takes> bool is_simple(const ba::Offset& offset, const Takes& takes) {
  std::vector<Traits::Curve_2> curves;
  for (const auto& chain : offset.chains)
    for (const auto& piece : chain.pieces)
      if (takes(piece)) curves.push_back(exact_curve(piece.arc));
  Traits traits;
  return !CGAL::do_curves_intersect(curves.begin(), curves.end(), traits);
}

bool is_simple(const ba::Offset& offset) {
  return is_simple(offset, [](const ba::Offset_piece&) { return true; });
}

ba::Drawing_2<double> read(const std::string& file) { return ba::drawing<double>(ba::read_curves(file)); }
ba::Offset_options within(double eps) {
  ba::Offset_options options;
  options.eps = eps;
  return options;
}

TEST(SimpleOffsets, SeesCrossings) {
  ba::Offset_chain chain;
  for (const ba::Arc_2& arc : {ba::Arc_2{{0, 0}, {2, 0}, 0.5}, {{2, 0}, {1, -2}, 0}, {{1, -2}, {0, 0}, 0}})
    chain.pieces.push_back({arc, {}, 1, ba::Offset_kind::CURVE, true});
  ba::Offset offset;
  offset.chains.push_back(chain);
  EXPECT_TRUE(is_simple(offset));
  offset.chains.back().pieces[0].arc.bulge = 1;  // half a circle, which leaves the triangle
  EXPECT_FALSE(is_simple(offset));
}

TEST(SimpleOffsets, OfBundledCurves) {
  for (const char* name : {"a_wrench", "f_crow", "h_maple_leaf"})
    for (const double eps : {2e-4, 2e-6}) {
      const ba::Offset_source_2 source(read(std::string(BOUNDING_ARCS_EXAMPLE_DATA) + "/" + name + ".json"),
                                       within(eps));
      for (const double d : {0.02, -0.02, 0.1, -0.1, 0.4, -0.4})
        EXPECT_TRUE(is_simple(source.at(d))) << name << ' ' << d << " eps " << eps;
    }
}

int failures_of(const std::string& file) {
  const ba::Drawing_2<double> drawing = read(file);
  CGAL::Bbox_2 box;
  for (const auto& c : drawing.curves())
    for (const auto& b : c.beziers)
      for (const auto& p : b.control_points()) box += CGAL::Bbox_2(p.x, p.y, p.x, p.y);
  const double size = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  int failures = 0;
  for (const double eps : {1e-4, 1e-6}) {
    const ba::Offset_source_2 source(drawing, within(eps * size));
    for (const double d : {0.01, -0.01, 0.05, -0.05, 0.2, -0.2}) {
      const ba::Offset offset = source.at(d * size);
      // inwards, closed curves and bands do not see each other
      const auto is_of = [&](bool closed) {
        return [&drawing, closed](const ba::Offset_piece& p) {
          return drawing.curves()[p.source.curve].is_closed == closed;
        };
      };
      const bool is_good =
          d > 0 ? is_simple(offset) : is_simple(offset, is_of(true)) && is_simple(offset, is_of(false));
      if (!is_good) std::printf("%s: eps %g, distance %g: chains cross\n", file.c_str(), eps, d);
      failures += is_good ? 0 : 1;
    }
  }
  return failures;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (argc == 1) return RUN_ALL_TESTS();
  int failures = 0;
  for (int i = 1; i < argc; ++i) failures += failures_of(argv[i]);
  return failures;
}

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Insets and axes agree: what an inset at depth d encloses are the parts of the axis with larger discs, hole for hole,
// and where an edge of the axis has a disc of radius d, the inset has a corner.

#include "axis_checks.h"
#include "cases.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>

#include <boost/pending/disjoint_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace test_insets_and_axes {
namespace {

using namespace bounding_arcs_test;

struct Parts {
  std::size_t regions = 0, holes = 0;
  friend bool operator==(const Parts& a, const Parts& b) { return a.regions == b.regions && a.holes == b.holes; }
};
// What of an axis has discs larger than d.
Parts parts_above(const Medial_axis_2& axis, double d) {
  boost::disjoint_sets_with_storage<> sets(axis.vertices.size());
  Parts parts;
  for (const auto& v : axis.vertices) parts.regions += v.radius > d ? 1 : 0;
  for (const auto& e : axis.edges) {
    std::size_t ends = (e.samples.front().radius > d ? 1 : 0) + (e.samples.back().radius > d ? 1 : 0), crossings = 0;
    for (std::size_t i = 1; i < e.samples.size(); ++i)
      crossings += (e.samples[i - 1].radius > d) != (e.samples[i].radius > d) ? 1 : 0;
    if (crossings > 0) {
      parts.regions += (crossings + ends) / 2 - ends;  // runs that no vertex belongs to
    } else if (ends > 0) {
      if (sets.find_set(e.from) == sets.find_set(e.to)) ++parts.holes;
      else sets.union_set(e.from, e.to), --parts.regions;
    }
  }
  return parts;
}
Parts parts_of(const ba::Offset& inset) {
  Parts parts;
  for (const auto& chain : inset.chains) ++(chain.is_ccw ? parts.regions : parts.holes);
  return parts;
}

// Each place of the axis with a disc of radius d is at an end of a piece.
void expect_corners(const Medial_axis_2& axis, const ba::Offset& inset, double d) {
  for (const auto& e : axis.edges)
    for (std::size_t i = 1; i < e.samples.size(); ++i) {
      const auto &a = e.samples[i - 1], &b = e.samples[i];
      if ((a.radius > d) == (b.radius > d)) continue;
      const double step = euclidean_norm(b.center - a.center), slope = std::fabs(b.radius - a.radius) / step;
      if (slope < 0.1 || slope > 0.9) continue;  // small errors move the place far along the axis or across it
      const Point place = a.center + (d - a.radius) / (b.radius - a.radius) * (b.center - a.center);
      double nearest = step;
      for (const auto& chain : inset.chains)
        for (const auto& piece : chain.pieces) nearest = (std::min)(nearest, euclidean_norm(piece.arc.from - place));
      EXPECT_LE(nearest, 4 * (axis.eps + inset.error) / slope) << "at " << place.x << ' ' << place.y;
    }
}

std::size_t expect_agreement(const Drawing& drawing, const Medial_axis_2& axis) {
  double most = 0;
  for (const auto& v : axis.vertices) most = (std::max)(most, v.radius);
  std::size_t told = 0;
  for (int tenth = 1; tenth <= 10; ++tenth) {
    const double d = (tenth - 0.5) / 10 * most, room = 1e-3 * most;
    const Parts parts = parts_above(axis, d);
    if (!(parts == parts_above(axis, d - room) && parts == parts_above(axis, d + room))) continue;
    SCOPED_TRACE("depth " + std::to_string(d));
    const ba::Offset inset = ba::offset(ba::Bounding_arc_tree_2(drawing), -d, 1e-6 * most);
    EXPECT_EQ(inset.status, ba::Offset::Status::COMPLETE);
    EXPECT_EQ(parts_of(inset).regions, parts.regions);
    EXPECT_EQ(parts_of(inset).holes, parts.holes);
    expect_corners(axis, inset, d);
    ++told;
  }
  return told;
}

TEST(InsetsAndAxes, AgreeOnBundledCurves) {
  for (const auto& file : std::filesystem::directory_iterator(BOUNDING_ARCS_EXAMPLE_DATA)) {
    if (file.path().extension() != ".json") continue;
    Drawing drawing;
    for (const auto& record : ba::read_curve_file(file.path().string()).curves)
      drawing.add(record.bezier_pieces<double>());
    const Medial_axis_2 axis = axis_of(drawing, 1e-5);
    if (axis.status != Status::COMPLETE) continue;
    SCOPED_TRACE(file.path().filename().string());
    EXPECT_GE(expect_agreement(drawing, axis), 5u);
  }
}

TEST(InsetsAndAxes, AgreeOnSplinesWithHoles) {
  std::mt19937 random(26);
  for (int round = 0; round < cases(60); ++round) {
    SCOPED_TRACE(round);
    Drawing drawing;
    drawing.add(moved(drawing_of(closed_curve(random, {0, 0}, 5 + random() % 9)), 4, {0, 0}).curves()[0].beziers);
    for (const double x : {-0.6, 0.6})
      drawing.add(reversed(moved(drawing_of(closed_curve(random, {0, 0}, 4)), 0.3, {x, 0})).curves()[0].beziers);
    const Medial_axis_2 axis = axis_of(drawing, 1e-5);
    if (axis.status == Status::COMPLETE) expect_agreement(drawing, axis);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace test_insets_and_axes

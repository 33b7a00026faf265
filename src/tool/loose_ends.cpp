// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "loose_ends.h"

#include "number_text.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/curve/join_curves.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

std::string places_text(std::size_t count) { return std::to_string(count) + (count == 1 ? " place" : " places"); }

// The least number of two digits that is no less, so that --join-ends with it reaches as far.
double rounded_up(double x) {
  if (x == 0) return 0;
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  const auto two_digits = [](double y) {
    char text[40];
    std::snprintf(text, sizeof text, "%.1e", y);
    return std::strtod(text, nullptr);
  };
  const double nearest = two_digits(x);
  return nearest >= x ? nearest : two_digits(x + unit / 2);
}

double extent(const ba::Drawing_2<double>& drawing) {
  CGAL::Bbox_2 box;
  for (const auto& curve : drawing.curves())
    for (const auto& piece : curve.beziers)
      for (const auto& p : piece.control_points()) box += CGAL::Bbox_2(p.x, p.y, p.x, p.y);
  return (std::max)(box.x_span(), box.y_span());
}

}  // namespace

ba::Curve_file::Note Loose_ends::note() const {
  std::string what = open == 1 ? "open curve" : "open curves";
  if (gaps > 0)
    what += ", whose ends " +
            (widest > 0 ? "are up to " + short_number(widest) + " apart at " : std::string("meet at ")) +
            places_text(gaps);
  what += (open == 1 ? ", from " : ", the first from ") + place_text(start) + " to " + place_text(end);
  return {open, what, gaps > 0 ? "--join-ends " + short_number(widest) + " joins them" : "no inside"};
}

std::string Loose_ends::text() const { return ba::Curve_file::text_of(note()); }

Loose_ends loose_ends(const ba::Drawing_2<double>& drawing) {
  Loose_ends ends;
  ba::Drawing_2<double> open;
  for (const auto& curve : drawing.curves()) {
    if (curve.is_closed) continue;
    if (ends.open++ == 0) {
      ends.start = curve.beziers.front().control_points().front();
      ends.end = curve.beziers.back().control_points().back();
    }
    open.add(curve.beziers);
  }
  if (ends.open == 0) return ends;
  const double size = extent(drawing);
  // Order tells what the curves of a file are, not what these have become: each is on a layer of its own.
  std::vector<std::size_t> layers(ends.open);
  std::iota(layers.begin(), layers.end(), std::size_t(0));
  ba::Joined_curves joined =
      ba::join_curves(open, ba::Joined_curves::rounding_of_ends(drawing.coordinate_size()), layers);
  // Details that are smaller than the gaps between others hide these: what is nearest goes first.
  for (const double share : {0x1p-30, 0x1p-20, 0x1p-10}) {
    if (joined.joints > 0) break;
    joined = ba::join_curves(open, share * size, layers);
  }
  ends.gaps = joined.joints;
  ends.widest = rounded_up(joined.moved);
  return ends;
}

}  // namespace bounding_arcs_tool

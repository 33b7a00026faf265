// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Drawing_facts.h"

#include "../Commands.h"

#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

using Place = Loose_end::Place;

bool holds(const CGAL::Bbox_2& a, const CGAL::Bbox_2& b) {
  return a.xmin() <= b.xmin() && a.ymin() <= b.ymin() && b.xmax() <= a.xmax() && b.ymax() <= a.ymax();
}

// Whether a closed curve is around the start of another one; where they touch there, around a point farther along it.
bool is_around(const ba::Point_location_2& closed, const ba::Drawing_2<double>::Curve& curve) {
  for (const auto& piece : curve.beziers)
    for (const double t : {0.0, 0.5}) {
      const ba::Winding_number winding = closed.winding_number(ba::Asked_point(piece.point(t)));
      if (winding.state == ba::Winding_number::State::DECIDED) return winding.number != 0;
    }
  return false;
}

// The end that is nearest to each, by a walk along x to both sides.
std::vector<Loose_end> with_nearest(const std::vector<Place>& places) {
  std::vector<std::size_t> order(places.size()), rank(places.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return places[a].point.x < places[b].point.x || (places[a].point.x == places[b].point.x && a < b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
  std::vector<Loose_end> ends;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const ba::Xy<double>& p = places[i].point;
    std::size_t best = i;
    double least = std::numeric_limits<double>::infinity();
    const auto is_nearer = [&](std::size_t k) {  // false where none behind it is, either
      const ba::Xy<double>& q = places[k].point;
      if (std::fabs(q.x - p.x) > least) return false;
      const double d = std::hypot(q.x - p.x, q.y - p.y);
      if (d < least || (d == least && k < best)) {
        least = d;
        best = k;
      }
      return true;
    };
    for (std::size_t k = rank[i] + 1; k < order.size() && is_nearer(order[k]); ++k) {
    }
    for (std::size_t k = rank[i]; k > 0 && is_nearer(order[k - 1]); --k) {
    }
    if (best == i) ends.push_back({places[i], std::nullopt, 0});
    else ends.push_back({places[i], places[best], least});
  }
  return ends;
}

}  // namespace

Drawing_facts drawing_facts(const std::string& file, const ba::Drawing_2<double>& drawing) {
  constexpr double SHARE = 1e-9;  // of the extent: more than what is shown of a length
  Drawing_facts facts;
  std::vector<std::unique_ptr<ba::Bounding_arc_tree_2>> closed;  // a drawing a closed curve
  std::vector<Place> places;
  Progress_line progress("curves");
  for (const auto& curve : drawing.curves()) {
    const std::size_t number = facts.curves.size();
    progress(number, drawing.curves().size());
    ba::Drawing_2<double> one;
    one.add(curve.beziers, curve.name);
    auto hierarchy =
        served(file, curve.name, [&] { return std::make_unique<ba::Bounding_arc_tree_2>(std::move(one)); });
    Curve_facts of;
    of.box = hierarchy->box();
    const double extent = (std::max)(of.box.x_span(), of.box.y_span());
    of.length = ba::length(*hierarchy, SHARE * extent).upper;
    of.is_closed = curve.is_closed;
    if (of.is_closed) {
      const ba::Measure_bounds area = ba::area(*hierarchy, SHARE * extent * extent);
      of.area = area.lower > 0 || area.upper < 0 ? area.lower + (area.upper - area.lower) / 2 : 0;
      ++facts.closed;
    } else {
      hierarchy.reset();
      places.push_back({number, true, curve.beziers.front().control_points().front()});
      places.push_back({number, false, curve.beziers.back().control_points().back()});
    }
    closed.push_back(std::move(hierarchy));
    facts.curves.push_back(of);
  }
  for (std::size_t j = 0; j < closed.size(); ++j) {
    if (closed[j] == nullptr) continue;
    const ba::Point_location_2 location(*closed[j]);
    const auto size = [&](std::size_t k) { return std::fabs(facts.curves[k].area); };
    for (std::size_t i = 0; i < facts.curves.size(); ++i) {
      Curve_facts& of = facts.curves[i];
      if (i == j || !holds(facts.curves[j].box, of.box) || !is_around(location, drawing.curves()[i])) continue;
      ++of.depth;
      if (!of.inside || size(j) < size(*of.inside)) of.inside = j;
    }
  }
  for (std::size_t i = 0; i < facts.curves.size(); ++i) {
    const Curve_facts& of = facts.curves[i];
    if (of.inside && of.area != 0 && (of.area > 0) == (facts.curves[*of.inside].area > 0)) facts.alike.push_back(i);
  }
  facts.loose_ends = with_nearest(places);
  return facts;
}

}  // namespace bounding_arcs_tool

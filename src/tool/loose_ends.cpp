// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "loose_ends.h"

#include <CGAL/Bounding_arcs_2/medial_axis/framed.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

using End = ba::Xy<double>;

// Finds the place of an end among those before it. Cells of a grid are as wide as ends may be apart, so that a cell has
// at most one first end, and near ones are in the cells around.
class Meeting_places {
 public:
  explicit Meeting_places(const CGAL::Bbox_2& box)
      : corner_{box.xmin(), box.ymin()},
        extent_((std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), LEAST})) {}

  void add(const End& end) {
    const End p{in_cells(end.x - corner_.x), in_cells(end.y - corner_.y)};
    const Cell cell{std::floor(p.x), std::floor(p.y)};
    for (const double dx : {0, -1, 1})
      for (const double dy : {0, -1, 1}) {
        const auto found = places_.find({cell.first + dx, cell.second + dy});
        if (found == places_.end() || !is_near(found->second.in_cells, p)) continue;
        found->second.is_met = true;
        found->second.is_same = found->second.is_same && found->second.first == end;
        return;
      }
    places_.insert({cell, {end, p}});
  }
  void count(Loose_ends& ends) const {
    for (const auto& [cell, place] : places_) {
      ends.places += place.is_met ? 1 : 0;
      ends.rounded += place.is_met && !place.is_same ? 1 : 0;
    }
  }

 private:
  static constexpr double LEAST = std::numeric_limits<double>::min();  // pieces of splines may be rounded to a point
  using Cell = std::pair<double, double>;
  struct Place {
    End first, in_cells;
    bool is_met = false, is_same = true;
  };
  static bool is_near(const End& p, const End& q) { return std::fabs(p.x - q.x) <= 1 && std::fabs(p.y - q.y) <= 1; }
  // Up to 2^40, so that numbers of cells are exact.
  [[nodiscard]] double in_cells(double length) const { return length / extent_ * 0x1p40; }

  End corner_;
  double extent_;
  std::map<Cell, Place> places_;
};

std::string places_text(std::size_t count) { return std::to_string(count) + (count == 1 ? " place" : " places"); }

}  // namespace

std::string Loose_ends::noun() const {
  const std::string curves = open == 1 ? "open curve" : "open curves";
  if (places == 0) return curves;
  const std::string up_to = rounded == 0        ? ""
                            : rounded == places ? " up to rounding"
                                                : ", at " + std::to_string(rounded) + " of them up to rounding";
  return curves + ", whose ends meet at " + places_text(places) + up_to;
}

std::string Loose_ends::text() const { return std::to_string(open) + " " + noun() + ": they are not joined"; }

Loose_ends loose_ends(const ba::Drawing_2<double>& drawing) {
  Loose_ends ends;
  const auto is_open = [](const auto& curve) { return !curve.is_closed; };
  ends.open = static_cast<std::size_t>(std::count_if(drawing.curves().begin(), drawing.curves().end(), is_open));
  if (ends.open == 0) return ends;
  Meeting_places places(ba::control_box(drawing));
  for (const auto& curve : drawing.curves()) {
    if (curve.is_closed) continue;
    places.add(curve.beziers.front().control_points().front());
    places.add(curve.beziers.back().control_points().back());
  }
  places.count(ends);
  return ends;
}

}  // namespace bounding_arcs_tool

// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of write_thickness.h.

#include "write_thickness.h"

#include "../number_text.h"
#include "../query/Query_answer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace bounding_arcs_tool {
namespace {

// The number in the file of the curve of a place.
std::size_t number_of(const Found_thickness& found, const Curve_place& of_axis) {
  return found.loaded.number_of(of_axis.curve);
}

Json json_of_disc(const Found_thickness& found, const ba::Medial_axis_2::Sample& disc) {
  Json record{{"point", json_of(disc.center)}, {"thickness", 2 * disc.radius}};
  for (const Curve_place& p : {disc.left, disc.right}) {
    record["between"].push_back(json_of(found.loaded, p));
    record["between"].back()["point"] = json_of(point_of(found, p));
  }
  return record;
}
Json json_of_stretch(const Found_thickness& found, const ba::Medial_axis_2::Thin_stretch& stretch) {
  Json record = json_of_disc(found, stretch.disc());
  record["length"] = stretch.length;
  record["from"] = json_of(stretch.samples.front().center);
  record["to"] = json_of(stretch.samples.back().center);
  std::set<std::size_t> curves;
  record["polyline"] = Json::array();
  for (const ba::Medial_axis_2::Sample& s : stretch.samples) {
    for (const Curve_place& p : {s.left, s.right}) curves.insert(number_of(found, p));
    record["polyline"].push_back({s.center.x, s.center.y, s.radius});
  }
  record["curves"] = curves;
  record["necks"] = Json::array();
  for (std::size_t i = 0; i < found.necks.size(); ++i)
    if (is_on(found.necks[i], stretch)) record["necks"].push_back(i);
  return record;
}

}  // namespace

Xy<double> point_of(const Found_thickness& found, const Curve_place& of_axis) {
  const Curve_place p = of_axis;
  return found.loaded.curves->drawing().curves()[p.curve].beziers[p.bezier].point(p.t);
}

bool is_on(const ba::Medial_axis_2::Neck& neck, const ba::Medial_axis_2::Thin_stretch& stretch) {
  return std::any_of(stretch.samples.begin(), stretch.samples.end(),
                     [&](const ba::Medial_axis_2::Sample& s) { return s.center == neck.disc.center; });
}

void write_thickness_json(std::ostream& out, const Found_thickness& found) {
  const ba::Medial_axis_2& axis = found.axis.axis;
  const bool is_complete = axis.status == ba::Medial_axis_2::Status::COMPLETE;
  Json document{{"eps", axis.eps}, {"moved", axis.moved}, {"status", is_complete ? "complete" : "unresolved"}};
  if (!is_complete) document["unresolved"] = Json::array();
  for (const Xy<double>& p : axis.unresolved) document["unresolved"].push_back(json_of(p));
  for (const std::uint32_t curve : axis.left_out) document["left_out"].push_back(found.loaded.number_of(curve));
  const auto place = [](const Xy<double>& center, double radius) {
    return Json{{"point", json_of(center)}, {"thickness", 2 * radius}};
  };
  if (found.thickest) document["thickest"] = place(found.thickest->center, found.thickest->radius);
  if (found.thinnest) document["thinnest"] = place(found.thinnest->center, found.thinnest->radius);
  if (found.has_limit()) {
    document["below"] = found.below;
    document["stretches"] = Json::array();
    for (const ba::Medial_axis_2::Thin_stretch& stretch : found.stretches)
      document["stretches"].push_back(json_of_stretch(found, stretch));
  }
  document["necks"] = Json::array();
  for (const ba::Medial_axis_2::Neck& neck : found.necks) {
    Json record = json_of_disc(found, neck.disc);
    if (std::isfinite(neck.prominence)) record["prominence"] = 2 * neck.prominence;
    document["necks"].push_back(record);
  }
  out << document.dump(1) << "\n";
}

void write_thickness_csv(std::ostream& out, const Found_thickness& found) {
  Query_answer table;
  table.columns = {"x", "y", "thickness", "x1", "y1", "x2", "y2"};
  const auto row = [&](const ba::Medial_axis_2::Sample& disc) {
    const Xy<double> a = point_of(found, disc.left), b = point_of(found, disc.right);
    std::vector<std::string> fields;
    for (const double x : {disc.center.x, disc.center.y, 2 * disc.radius, a.x, a.y, b.x, b.y})
      fields.push_back(digits(x));
    return fields;
  };
  if (!found.has_limit()) {
    for (const ba::Medial_axis_2::Neck& n : found.necks) table.rows.push_back(row(n.disc));
    return write_csv(out, table);
  }
  for (const char* column : {"length", "x_from", "y_from", "x_to", "y_to", "curve1", "curve2", "necks"})
    table.columns.push_back(column);
  for (const ba::Medial_axis_2::Thin_stretch& s : found.stretches) {
    table.rows.push_back(row(s.disc()));
    const Xy<double> from = s.samples.front().center, to = s.samples.back().center;
    for (const double x : {s.length, from.x, from.y, to.x, to.y}) table.rows.back().push_back(digits(x));
    for (const Curve_place& p : {s.disc().left, s.disc().right})
      table.rows.back().push_back(std::to_string(number_of(found, p)));
    table.rows.back().push_back(std::to_string(std::count_if(
        found.necks.begin(), found.necks.end(), [&](const ba::Medial_axis_2::Neck& neck) { return is_on(neck, s); })));
  }
  write_csv(out, table);
}

Written_drawing written_thickness(const Found_thickness& found) {
  constexpr CGAL::Bounding_arcs::Curve_record::Colour RED{1, -1}, ORANGE{30, -1};
  Written_drawing drawing{!found.loaded.flips, found.loaded.unit_in_mm, found.loaded.page};
  const auto across = [&](const ba::Medial_axis_2::Sample& disc) -> std::vector<Written_piece> {
    return {Arc_2{point_of(found, disc.left), disc.center, 0}, Arc_2{disc.center, point_of(found, disc.right), 0}};
  };
  for (std::size_t k = 0; k < found.stretches.size(); ++k) {
    const std::vector<ba::Medial_axis_2::Sample>& samples = found.stretches[k].samples;
    std::vector<Written_piece> pieces;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i)
      pieces.emplace_back(Arc_2{samples[i].center, samples[i + 1].center, 0});
    if (pieces.empty()) pieces = across(samples.front());
    drawing.curves.push_back({"thin_" + std::to_string(k), {"thin", RED}, std::move(pieces)});
  }
  for (std::size_t i = 0; i < found.necks.size(); ++i)
    drawing.curves.push_back({"neck_" + std::to_string(i), {"necks", ORANGE}, across(found.necks[i].disc)});
  return drawing;
}

}  // namespace bounding_arcs_tool

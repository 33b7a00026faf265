// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joins records of curves, which have layers and more than a drawing has.

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace CGAL::Bounding_arcs {
namespace {

// The drawing of those that take part, and which ones these are.
struct Taking_part {
  Drawing_2<double> drawing;
  std::vector<std::size_t> numbers, layers;
  std::vector<double> errors;
};
Taking_part taking_part(const std::vector<Curve_record>& records, const Drawing_2<double>& all, bool with_filled) {
  Taking_part part;
  std::map<std::string, std::size_t> layers;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto& curve = all.curves()[i];
    if (curve.is_closed || (!with_filled && records[i].filling != Curve_record::NO_INSIDE)) continue;
    part.drawing.add(curve.beziers);
    part.numbers.push_back(i);
    part.errors.push_back(records[i].end_error);
    part.layers.push_back(layers.try_emplace(records[i].layer, layers.size()).first->second);
  }
  return part;
}

Curve_record joined_record(Curve_record first, std::vector<Bezier_curve_2<double>> pieces, bool is_closed) {
  Curve_record record;
  record.name = std::move(first.name);
  record.layer = std::move(first.layer);
  record.colour = first.colour;
  record.type = Curve_record::PATH;
  record.y_is_down = first.y_is_down;
  record.filling = is_closed ? Curve_record::NO_INSIDE : first.filling;
  record.closed = is_closed;
  for (const auto& piece : pieces) record.degree = (std::max)(record.degree, piece.degree());
  record.beziers = std::move(pieces);
  return record;
}

}  // namespace

Joined_curves join_curves(std::vector<Curve_record>& records, double eps, bool with_filled) {
  const Drawing_2<double> all = drawing<double>(records);
  const Taking_part part = taking_part(records, all, with_filled);
  Joined_curves joined = join_curves(part.drawing, eps, part.layers, part.errors);
  // Curves that took no part stay where they are, among the joined ones.
  std::vector<std::size_t> joined_at(records.size(), records.size());  // of the first part of a joined curve
  std::vector<bool> is_first(records.size(), true);
  for (std::size_t k = 0; k < joined.parts.size(); ++k) {
    std::size_t first = records.size();
    for (Joined_curves::Part& p : joined.parts[k]) {
      p.curve = part.numbers[p.curve];
      is_first[p.curve] = false;
      first = (std::min)(first, p.curve);
    }
    is_first[first] = true;
    joined_at[first] = k;
  }
  std::vector<Curve_record> result;
  std::vector<std::vector<Joined_curves::Part>> parts;
  std::vector<bool> is_joined(joined.parts.size());
  for (const std::size_t k : joined.joined) is_joined[k] = true;
  std::vector<std::size_t> numbers_of_joined;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (!is_first[i]) continue;
    const std::size_t k = joined_at[i];
    if (k == records.size()) parts.push_back({{i, false}});
    else parts.push_back(joined.parts[k]);
    if (k == records.size() || !is_joined[k]) {
      result.push_back(std::move(records[i]));
      continue;
    }
    const auto& curve = joined.drawing.curves()[k];
    numbers_of_joined.push_back(result.size());
    result.push_back(joined_record(std::move(records[i]), curve.beziers, curve.is_closed));
  }
  records = std::move(result);
  joined.drawing = drawing<double>(records);
  joined.parts = std::move(parts);
  joined.joined = std::move(numbers_of_joined);
  return joined;
}

}  // namespace CGAL::Bounding_arcs

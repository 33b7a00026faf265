// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Dxf_digits.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace bounding_arcs_tool {
namespace {

// Numbers written with fewer digits may be whole ones, halves or thousandths by chance.
constexpr int FEWEST_DIGITS = 4;

double last_place(int digits) { return digits < FEWEST_DIGITS ? 0 : std::pow(10, -digits); }

double size_of(const Dxf_item& item, int code) {
  try {
    return std::fabs(item.real(code, 0));
  } catch (const Dxf_left_out&) {
    return 0;  // the entity is left out, too
  }
}

}  // namespace

int digits_behind_point(std::string_view number) {
  constexpr int MOST = 300;  // of what is no number, too
  const std::size_t power = std::min(number.find_first_of("eE"), number.size());
  const std::size_t point = std::min(number.find('.'), power);
  const int digits = point == power ? 0 : static_cast<int>(std::min(power - point - 1, std::size_t(MOST)));
  int exponent = 0;
  if (power < number.size()) {
    const std::size_t sign = power + (number.substr(power + 1, 1) == "+" ? 2 : 1);
    std::from_chars(number.data() + std::min(sign, number.size()), number.data() + number.size(), exponent);
  }
  return std::clamp(digits - std::clamp(exponent, -MOST, MOST), 0, MOST);
}

double arc_size(const Dxf_item& entity) {
  constexpr double DIAGONAL = 1.5;  // above sqrt(2)
  if (entity.kind == "ARC") return size_of(entity, 40);
  if (entity.kind == "ELLIPSE") return DIAGONAL * std::max(size_of(entity, 11), size_of(entity, 21));
  return 0;
}

double last_place_of_angles(const Dxf_item& item, int from, int to) {
  constexpr int FEWEST = 3;  // 359.9 degrees leave a slit on purpose
  int digits = 0;
  for (const int code : {from, to})
    if (const Dxf_group* group = item.find(code)) digits = std::max(digits, digits_behind_point(group->value));
  return digits < FEWEST ? 0 : std::pow(10, -digits);
}

void Dxf_digits::take(const Dxf_item& entity) {
  const bool is_arc = entity.kind == "ARC", is_ellipse = entity.kind == "ELLIPSE";
  for (const Dxf_group& group : entity.groups) {
    const bool is_coordinate = group.code >= 10 && group.code < 30;
    const bool is_radius = is_arc && group.code == 40;
    const bool is_degrees = is_arc && (group.code == 50 || group.code == 51);
    const bool is_radians = is_ellipse && (group.code == 41 || group.code == 42);
    if (!is_coordinate && !is_radius && !is_degrees && !is_radians) continue;
    int& most = is_degrees ? of_degrees_ : is_radians ? of_radians_ : of_lengths_;
    most = std::max(most, digits_behind_point(group.value));
  }
}

double Dxf_digits::rounding() const {
  // Each number is off by half of its last place h. An end has two coordinates; that of an arc adds its radius:
  // (sqrt(2) + 1) h / 2. Two such ends are apart by less than 3 h.
  constexpr double LENGTHS = 3;
  return LENGTHS * last_place(of_lengths_);
}

double Dxf_digits::end_error(std::string_view kind, double size) const {
  constexpr double DEGREE = 0.017453292519943295;
  const double last = kind == "ARC" ? DEGREE * last_place(of_degrees_) : last_place(of_radians_);
  return size * last / 2;  // along the arc
}

}  // namespace bounding_arcs_tool
